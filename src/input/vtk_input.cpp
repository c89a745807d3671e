// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of the CGAL-style package Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#include "input/File_contents.h"
#include "input/field_names.h"
#include "input/mesh_formats.h"
#include "input/text_input.h"
#include "input/vtk_cells.h"

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace reeb_graph_program {
namespace {
// Reads the sections of a file one after the other. Their numbers may be on any line.
class Vtk_reader
{
public:
  Vtk_reader(const std::string& path, std::string_view text, const std::string& vertex_property)
    : path_(path),
      vertex_property_(vertex_property),
      input_(path, text)
  {}

  Polygon_soup read()
  {
    read_header();
    for(std::string section = next_word(); !section.empty(); section = next_word())
      read_section(section);
    if(cells_.size() != types_.size())
      input_.fail("there are " + std::to_string(cells_.size()) + " cells, and types of "
                  + std::to_string(types_.size()));
    for(std::size_t i = 0; i < cells_.size(); ++i)
      add_vtk_cell(path_, types_[i], cells_[i], 0, soup_);
    if(!vertex_property_.empty() && soup_.scalars.size() != soup_.points.size())
      throw Input_error(path_, names_.message(vertex_property_, "cells"));
    return std::move(soup_);
  }

private:
  std::string next_word() { return std::string(input_.word_of_file()); }

  template <class Number>
  Number next_number()
  {
    return input_.number<Number>(input_.word_of_file());
  }

  void skip_numbers(std::size_t number)
  {
    for(; number > 0; --number)
      next_number<double>();
  }

  void read_header()
  {
    constexpr std::string_view begin = "# vtk DataFile Version";
    if(!input_.next_line() || input_.line().substr(0, begin.size()) != begin)
      input_.fail("the file does not begin as a VTK file");
    input_.next_line(); // the title
    input_.finish_line();
    const std::string coding = next_word();
    if(coding == "BINARY")
      input_.fail("binary VTK files are not read: write an ASCII file, or a VTU file");
    if(coding != "ASCII")
      input_.fail("'ASCII' is missing");
    if(next_word() != "DATASET")
      input_.fail("'DATASET' is missing");
    const std::string type = next_word();
    if(type != "UNSTRUCTURED_GRID" && type != "POLYDATA")
      input_.fail(quote(type) + " is not read: it is an UNSTRUCTURED_GRID, or POLYDATA");
  }

  void read_section(const std::string& section)
  {
    if(section == "POINTS")
      read_points();
    else if(section == "CELLS")
      read_cells(cells_);
    else if(section == "CELL_TYPES")
      for(auto size = next_number<std::size_t>(); size > 0; --size)
        types_.push_back(next_number<std::size_t>());
    else if(section == "VERTICES" || section == "LINES" || section == "POLYGONS" || section == "TRIANGLE_STRIPS")
      read_cells_of_type(section == "VERTICES" ? 2 : section == "LINES" ? 4 : section == "POLYGONS" ? 7 : 6);
    else if(section == "POINT_DATA" || section == "CELL_DATA")
    {
      is_point_data_ = section == "POINT_DATA";
      is_cell_data_ = !is_point_data_;
      number_of_entries_ = next_number<std::size_t>();
    }
    else if(section == "METADATA")
      skip_to_blank_line();
    else
      read_attribute(section);
  }

  void read_points()
  {
    auto size = next_number<std::size_t>();
    next_word(); // the type of the numbers
    for(; size > 0; --size)
    {
      const double x = next_number<double>(), y = next_number<double>(), z = next_number<double>();
      soup_.points.emplace_back(x, y, z);
    }
  }

  // Cells with their sizes before them or, from version 5 on, where each begins and ends, and then all vertices.
  void read_cells(Polygons& cells)
  {
    const auto size = next_number<std::size_t>(), number = next_number<std::size_t>();
    if(size == 0)
      return;
    const std::string word = next_word();
    if(word == "OFFSETS")
      return read_cells_with_offsets(size, number, cells);
    std::size_t sum = 0;
    for(std::size_t i = 0; i < size; ++i)
    {
      const auto corners = i == 0 ? input_.number<std::size_t>(word) : next_number<std::size_t>();
      for(std::size_t j = 0; j < corners; ++j)
        cells.add_corner(next_number<std::size_t>());
      cells.end_polygon();
      sum += corners + 1;
    }
    if(sum != number)
      input_.fail("the cells have " + std::to_string(sum) + " numbers instead of " + std::to_string(number));
  }

  void read_cells_with_offsets(std::size_t size, std::size_t number, Polygons& cells)
  {
    next_word(); // the type of the numbers
    std::vector<std::size_t> offsets;
    for(; size > 0; --size)
    {
      offsets.push_back(next_number<std::size_t>());
      if(offsets.back() < (offsets.size() == 1 ? 0 : offsets[offsets.size() - 2]) || offsets.back() > number)
        input_.fail("the offsets of the cells do not ascend");
    }
    if(next_word() != "CONNECTIVITY")
      input_.fail("'CONNECTIVITY' is missing");
    next_word();
    for(std::size_t i = 1; i < offsets.size(); ++i)
    {
      for(std::size_t j = offsets[i - 1]; j < offsets[i]; ++j)
        cells.add_corner(next_number<std::size_t>());
      cells.end_polygon();
    }
    if((offsets.empty() ? 0 : offsets.back()) != number)
      input_.fail("the cells have another number of vertices than it is said");
  }

  void read_cells_of_type(std::size_t type)
  {
    Polygons cells;
    read_cells(cells);
    cells_.append(cells);
    types_.resize(types_.size() + cells.size(), type);
  }

  void read_attribute(const std::string& kind)
  {
    const std::string name = next_word();
    if(kind == "FIELD")
      return read_field_arrays(next_number<std::size_t>());
    if(kind == "LOOKUP_TABLE")
      return skip_numbers(4 * next_number<std::size_t>());
    if(kind == "COLOR_SCALARS")
      return skip_numbers(next_number<std::size_t>() * number_of_entries_);
    if(kind == "SCALARS")
      return read_scalars(name);
    const std::size_t components = kind == "VECTORS" || kind == "NORMALS"         ? 3
                                 : kind == "TENSORS"                              ? 9
                                 : kind == "TENSORS6"                             ? 6
                                 : kind == "GLOBAL_IDS" || kind == "PEDIGREE_IDS" ? 1
                                 : kind == "TEXTURE_COORDINATES"                  ? next_number<std::size_t>()
                                                                                  : 0;
    if(components == 0)
      input_.fail(quote(kind) + " is no section that is read");
    next_word(); // the type of the numbers
    names_.add(is_cell_data_, name, components);
    skip_numbers(components * number_of_entries_);
  }

  // The number of components may be left out, and a line for the lookup table as well.
  void read_scalars(const std::string& name)
  {
    next_word(); // the type of the numbers
    const std::string_view components = input_.word_of_line();
    const std::size_t number = components.empty() ? 1 : input_.number<std::size_t>(components);
    std::string_view word = input_.word_of_file();
    if(word == "LOOKUP_TABLE")
    {
      next_word();
      word = input_.word_of_file();
    }
    if(number * number_of_entries_ == 0)
      input_.fail("scalars without numbers are not read");
    read_numbers(name, number, number_of_entries_, word);
  }

  void read_field_arrays(std::size_t number_of_arrays)
  {
    for(; number_of_arrays > 0; --number_of_arrays)
    {
      std::string name = next_word();
      if(name == "METADATA")
      {
        skip_to_blank_line();
        name = next_word();
      }
      const auto components = next_number<std::size_t>(), tuples = next_number<std::size_t>();
      if(next_word() == "string")
        input_.fail("arrays of strings are not read");
      if(components * tuples > 0)
        read_numbers(name, components, tuples, input_.word_of_file());
    }
  }

  // `first` is the first number, which has been read already.
  void read_numbers(const std::string& name, std::size_t components, std::size_t tuples, std::string_view first)
  {
    if(is_point_data_ || is_cell_data_)
      names_.add(is_cell_data_, name, components);
    const bool is_wanted = is_point_data_ && !vertex_property_.empty() && name == vertex_property_ && components == 1;
    if(is_wanted)
      soup_.scalars.clear();
    for(std::size_t i = 0; i < components * tuples; ++i)
    {
      const double number = i == 0 ? input_.number<double>(first) : next_number<double>();
      if(is_wanted)
        soup_.scalars.push_back(number);
    }
  }

  void skip_to_blank_line()
  {
    while(input_.next_line() && !input_.next_word_of_line().empty())
      continue;
    input_.finish_line();
  }

  std::string path_, vertex_property_;
  Text_input input_;
  Polygon_soup soup_;
  Polygons cells_;
  std::vector<std::size_t> types_;
  bool is_point_data_ = false, is_cell_data_ = false;
  Field_names names_;
  std::size_t number_of_entries_ = 0;
};

} // namespace

Polygon_soup read_vtk(const std::string& path, const std::string& vertex_property)
{
  const File_contents file(path);
  return Vtk_reader(path, file.text(), vertex_property).read();
}

} // namespace reeb_graph_program
