// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#include "input/vtk_input.h"

#include "input/File_contents.h"
#include "input/input_error.h"
#include "input/mesh_formats.h"
#include "input/number_types.h"
#include "input/text_input.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <limits>
#include <map>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace reeb_graph_program {
namespace {
// The types by their numbers in VTK's vtkCellType.h.
enum Cell_type : std::size_t
{
  VERTEX = 1,
  POLY_VERTEX = 2,
  LINE = 3,
  POLY_LINE = 4,
  TRIANGLE = 5,
  TRIANGLE_STRIP = 6,
  POLYGON = 7,
  PIXEL = 8,
  QUAD = 9,
  TETRA = 10
};

// The least and the largest number of corners of each type.
constexpr std::size_t any_number = std::numeric_limits<std::size_t>::max();
constexpr std::array<std::size_t, TETRA + 1> least_corners = {0, 1, 0, 2, 0, 3, 0, 0, 4, 4, 4};
constexpr std::array<std::size_t, TETRA + 1> most_corners = {0,          1,          any_number, 2, any_number, 3,
                                                             any_number, any_number, 4,          4, 4};

// Types that files often have.
std::string name_of_type(std::size_t type)
{
  static const std::map<std::size_t, std::string> names = {{0, "empty"},
                                                           {11, "voxel"},
                                                           {12, "hexahedron"},
                                                           {13, "wedge"},
                                                           {14, "pyramid"},
                                                           {15, "prism"},
                                                           {16, "prism"},
                                                           {21, "quadratic edge"},
                                                           {22, "quadratic triangle"},
                                                           {23, "quadratic quadrilateral"},
                                                           {24, "quadratic tetrahedron"},
                                                           {25, "quadratic hexahedron"},
                                                           {42, "polyhedron"}};
  const auto found = names.find(type);
  return std::to_string(type) + (found == names.end() ? "" : " (" + found->second + ")");
}

void add_cell(const std::string& path,
              std::size_t type,
              Polygons::Polygon vertices,
              std::size_t first_vertex,
              Polygon_soup& soup)
{
  const auto size = static_cast<std::size_t>(vertices.end() - vertices.begin());
  if(size < least_corners.at(type) || size > most_corners.at(type)) // types have been checked
    throw Input_error(path, "a cell of type " + std::to_string(type) + " of VTK cannot have " + std::to_string(size)
                              + " vertices");
  const auto v = [&](std::size_t i) { return corner(first_vertex + vertices.begin()[i]); };
  switch(type)
  {
  case LINE:
  case POLY_LINE:
    for(std::size_t i = 1; i < size; ++i)
      if(v(i - 1) != v(i))
        soup.edges.push_back({v(i - 1), v(i)});
    break;
  case TRIANGLE_STRIP:
    for(std::size_t i = 2; i < size; ++i)
      soup.polygons.add(std::array<Corner, 3>{v(i - 2 + i % 2), v(i - 1 - i % 2), v(i)});
    if(size > 2)
      break;
    [[fallthrough]]; // fewer corners are a face that is left out
  case TRIANGLE:
  case POLYGON:
  case QUAD:
    for(std::size_t i = 0; i < size; ++i)
      soup.polygons.add_corner(v(i));
    soup.polygons.end_polygon();
    break;
  case PIXEL: soup.polygons.add(std::array<Corner, 4>{v(0), v(1), v(3), v(2)}); break;
  case TETRA: soup.tetrahedra.push_back({v(0), v(1), v(2), v(3)}); break;
  default: break;
  }
}

} // namespace

const char* const vtk_way_out = "VTK's vtkDataSetTriangleFilter, ParaView's filter Tetrahedralize, cuts all cells into "
                                "triangles and tetrahedra";

void add_vtk_vertices(const std::string& path,
                      const std::vector<std::size_t>& ends,
                      const std::vector<std::size_t>& vertices,
                      Polygons& cells)
{
  std::size_t begin = 0;
  for(const std::size_t end : ends)
  {
    if(end < begin || end > vertices.size())
      throw Input_error(path, "the offsets of the cells do not ascend, or are too large");
    for(; begin != end; ++begin)
      cells.add_corner(vertices[begin]);
    cells.end_polygon();
  }
}

void check_vtk_types(const std::string& path, const std::vector<std::size_t>& types)
{
  std::set<std::size_t> others;
  for(const std::size_t type : types)
    if(type < VERTEX || type > TETRA)
      others.insert(type);
  if(others.empty())
    return;
  std::string names;
  std::size_t number = 0;
  for(const std::size_t type : others)
    if(++number <= 8)
      names += (names.empty() ? "" : ", ") + name_of_type(type);
  names += number > 8 ? ", ..." : "";
  throw Input_error(path, "cells of type " + names + " of VTK are not read: the types are 1 to 10; " + vtk_way_out);
}

void add_vtk_cells(const std::string& path, const Vtk_cells& cells, std::size_t first_vertex, Polygon_soup& soup)
{
  if(cells.vertices.size() != cells.types.size())
    throw Input_error(path, "there are " + std::to_string(cells.vertices.size()) + " cells, and types of "
                              + std::to_string(cells.types.size()));
  for(std::size_t i = 0; i < cells.types.size(); ++i)
    add_cell(path, cells.types[i], cells.vertices[i], first_vertex, soup);
}

namespace {
// What begins as XML is XML, whatever the file is called.
Polygon_soup read_any_vtk(const std::string& path, const Vtk_field_choice& choice)
{
  const File_contents file(path);
  const std::string_view text = file.text();
  const std::size_t begin = text.find_first_of("<#");
  return begin != std::string_view::npos && text[begin] == '<' ? read_vtk_xml(path, text, choice)
                                                               : read_vtk_legacy(path, text, choice);
}

} // namespace

void Vtk_field_choice::add(const Vertex_field& field, Polygon_soup& soup) const
{
  const auto is_first = [&](const std::vector<double>& numbers) { // of its name in the piece
    return numbers.size() + field.numbers.size() <= soup.points.size();
  };
  if(!name.empty() && field.name == name && is_first(soup.scalars))
    soup.scalars.insert(soup.scalars.end(), field.numbers.begin(), field.numbers.end());
  if(!are_all_wanted)
    return;
  const auto known = std::find_if(soup.fields.begin(), soup.fields.end(),
                                  [&](const Vertex_field& other) { return other.name == field.name; });
  if(known == soup.fields.end())
    soup.fields.push_back(field);
  else if(is_first(known->numbers))
    known->numbers.insert(known->numbers.end(), field.numbers.begin(), field.numbers.end());
}

Polygon_soup read_vtk(const std::string& path, const std::string& vertex_property)
{
  Field_names names;
  Polygon_soup soup = read_any_vtk(path, {false, vertex_property, &names});
  if(!vertex_property.empty() && soup.scalars.size() != soup.points.size())
    throw Input_error(path, names.message(vertex_property, "cells"));
  return soup;
}

std::vector<Vertex_field> read_vtk_fields(const std::string& path, Field_names& names)
{
  Polygon_soup soup = read_any_vtk(path, {true, "", &names});
  std::vector<Vertex_field> fields;
  for(Vertex_field& field : soup.fields)
    if(field.numbers.size() == soup.points.size() && call_with_vtk_type(field.type, [](auto) {}))
      fields.push_back(std::move(field));
  return fields;
}

namespace {
// Reads the sections of a file one after the other. In text, their numbers may be on any line. In a binary file, the
// highest byte of a number is the first one.
class Vtk_legacy_reader
{
public:
  Vtk_legacy_reader(const std::string& path, std::string_view text, const Vtk_field_choice& choice)
    : path_(path),
      choice_(choice),
      input_(path, text),
      most_numbers_(8 * text.size() + 8)
  {}

  Polygon_soup read()
  {
    read_header();
    for(std::string section = next_keyword(); !section.empty(); section = next_keyword())
      read_section(section);
    add_vtk_cells(path_, cells_, 0, soup_);
    return std::move(soup_);
  }

private:
  std::string next_word() { return std::string(input_.word_of_file()); }

  std::string next_keyword()
  {
    std::string word = next_word();
    std::transform(word.begin(), word.end(), word.begin(),
                   [](unsigned char c) { return static_cast<char>(std::toupper(c)); });
    return word;
  }

  template <class Number = std::size_t>
  Number next_number()
  {
    return input_.number<Number>(input_.word_of_file());
  }

  // The product of numbers that the file says, if so many numbers can be in it.
  std::size_t product(std::size_t a, std::size_t b) const
  {
    if(a != 0 && b > most_numbers_ / a)
      input_.fail("there are more numbers to be read than the file can have");
    return a * b;
  }

  // So many numbers of a type of the file.
  template <class Number>
  std::vector<Number> read_numbers(const std::string& type, std::size_t size)
  {
    product(1, size);
    std::vector<Number> numbers;
    if(type == "string" || type == "utf8_string")
      skip_strings(size);
    else if(!is_binary_)
      for(; size > 0; --size)
        numbers.push_back(next_number<Number>());
    else if(type == "bit")
      input_.take_bytes((size + 7) / 8);
    else if(!call_with_vtk_type(vtk_type_of_legacy_name(type), [&](auto number) {
              numbers = decode_vtk_numbers<Number, decltype(number)>(input_.take_bytes(size * sizeof number),
                                                                     !is_machine_big_endian());
            }))
      input_.fail(quote(type) + " is not a type of numbers that is read");
    return numbers;
  }

  // Strings are lines, or have their sizes in front: the first two bits say how many bytes the size has.
  void skip_strings(std::size_t number)
  {
    for(input_.finish_line(); number > 0; --number)
    {
      if(!is_binary_)
      {
        if(!input_.next_line())
          input_.fail("the file ends too early");
        input_.finish_line();
        continue;
      }
      const auto first = static_cast<unsigned char>(input_.take_bytes(1).front());
      std::size_t size = first & 63U;
      for(unsigned more = (1U << (3U - first / 64U)) - 1; more > 0; --more)
        size = size << 8U | static_cast<unsigned char>(input_.take_bytes(1).front());
      input_.take_bytes(size);
    }
  }

  void read_header()
  {
    constexpr std::string_view begin = "# vtk DataFile Version";
    if(!input_.next_line() || input_.line().substr(0, begin.size()) != begin)
      input_.fail("the file does not begin as a VTK file");
    input_.next_line(); // the title
    input_.finish_line();
    const std::string coding = next_keyword();
    is_binary_ = coding == "BINARY";
    if(!is_binary_ && coding != "ASCII")
      input_.fail("'ASCII' or 'BINARY' is missing");
    if(next_keyword() != "DATASET")
      input_.fail("'DATASET' is missing");
    const std::string type = next_keyword();
    if(type != "UNSTRUCTURED_GRID" && type != "POLYDATA")
      input_.fail(refused_vtk_type(type));
  }

  void read_section(const std::string& section)
  {
    if(section == "POINTS")
      read_points();
    else if(section == "CELLS")
      read_cells();
    else if(section == "CELL_TYPES")
    {
      const std::vector<std::size_t> types = read_numbers<std::size_t>("int", next_number());
      check_vtk_types(path_, types);
      cells_.types.insert(cells_.types.end(), types.begin(), types.end());
    }
    else if(section == "VERTICES" || section == "LINES" || section == "POLYGONS" || section == "TRIANGLE_STRIPS")
    {
      read_cells();
      cells_.types.resize(cells_.vertices.size(), section == "VERTICES"   ? vtk_vertices
                                                  : section == "LINES"    ? vtk_lines
                                                  : section == "POLYGONS" ? vtk_polygons
                                                                          : vtk_strips);
    }
    else if(section == "POINT_DATA" || section == "CELL_DATA")
    {
      is_point_data_ = section == "POINT_DATA";
      is_cell_data_ = !is_point_data_;
      number_of_entries_ = next_number();
    }
    else if(section == "METADATA")
      skip_to_blank_line();
    else
      read_attribute(section);
  }

  void read_points()
  {
    const std::size_t size = next_number();
    const std::string type = next_word();
    const std::vector<double> numbers = read_numbers<double>(type, product(3, size));
    soup_.points.reserve(size);
    for(std::size_t i = 0; i + 2 < numbers.size(); i += 3)
      soup_.points.emplace_back(numbers[i], numbers[i + 1], numbers[i + 2]);
  }

  // Cells with their sizes before them or, from version 5 on, where each begins and ends, and then all vertices.
  void read_cells()
  {
    const std::size_t size = next_number(), number = next_number();
    if(input_.is_next("OFFSETS"))
      return read_cells_with_offsets(size, number);
    const std::vector<std::size_t> numbers = read_numbers<std::size_t>("int", is_binary_ ? number : 0);
    std::size_t sum = 0;
    const auto next = [&] {
      if(is_binary_ && sum == numbers.size())
        input_.fail("the cells have more numbers than the " + std::to_string(number) + " it is said");
      return is_binary_ ? numbers[sum++] : (++sum, next_number());
    };
    for(std::size_t i = 0; i < size; ++i)
    {
      for(std::size_t corners = next(); corners > 0; --corners)
        cells_.vertices.add_corner(next());
      cells_.vertices.end_polygon();
    }
    if(sum != number)
      input_.fail("the cells have " + std::to_string(sum) + " numbers instead of " + std::to_string(number));
  }

  void read_cells_with_offsets(std::size_t size, std::size_t number)
  {
    next_word(); // OFFSETS
    const std::string type_of_offsets = next_word();
    std::vector<std::size_t> offsets = read_numbers<std::size_t>(type_of_offsets, size);
    if(next_keyword() != "CONNECTIVITY")
      input_.fail("'CONNECTIVITY' is missing");
    const std::string type_of_corners = next_word();
    const std::vector<std::size_t> corners = read_numbers<std::size_t>(type_of_corners, number);
    if((offsets.empty() ? 0 : offsets.back()) != corners.size() || (!offsets.empty() && offsets.front() != 0))
      input_.fail("the cells have another number of vertices than it is said");
    if(!offsets.empty())
      offsets.erase(offsets.begin());
    add_vtk_vertices(path_, offsets, corners, cells_.vertices);
  }

  void read_attribute(const std::string& kind)
  {
    const std::string name = next_word();
    if(kind == "FIELD")
      return read_field_arrays(next_number());
    if(kind == "LOOKUP_TABLE")
      return read_array("", is_binary_ ? "unsigned_char" : "float", 4, next_number());
    if(kind == "COLOR_SCALARS")
      return read_color_scalars(name, next_number());
    if(kind == "SCALARS")
      return read_scalars(name);
    const std::size_t components = kind == "VECTORS" || kind == "NORMALS"                                 ? 3
                                 : kind == "TENSORS"                                                      ? 9
                                 : kind == "TENSORS6"                                                     ? 6
                                 : kind == "GLOBAL_IDS" || kind == "PEDIGREE_IDS" || kind == "EDGE_FLAGS" ? 1
                                 : kind == "TEXTURE_COORDINATES" ? next_number()
                                                                 : 0;
    if(components == 0)
      input_.fail(quote(kind) + " is not a section that is read");
    const std::string type = next_word();
    read_array(name, type, components, number_of_entries_);
  }

  // In text, colors are parts of 255, which VTK reads as bytes.
  void read_color_scalars(const std::string& name, std::size_t components)
  {
    if(is_binary_)
      return read_array(name, "unsigned_char", components, number_of_entries_);
    std::vector<double> numbers = read_numbers<double>("float", product(components, number_of_entries_));
    for(double& number : numbers)
    {
      const double byte = std::fmod(std::trunc(double(static_cast<float>(number)) * 255 + 0.5), 256);
      number = byte < 0 ? byte + 256 : byte; // as bytes wrap
    }
    add_array(name, "unsigned_char", components, number_of_entries_, std::move(numbers));
  }

  // The number of components may be left out, and a line for the lookup table as well.
  void read_scalars(const std::string& name)
  {
    const std::string type = next_word();
    const std::string_view components = input_.word_of_line();
    const std::size_t number = components.empty() ? 1 : input_.number<std::size_t>(components);
    if(input_.is_next("LOOKUP_TABLE"))
    {
      next_word();
      next_word();
    }
    read_array(name, type, number, number_of_entries_);
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
      const std::size_t components = next_number(), tuples = next_number();
      const std::string type = next_word();
      read_array(name, type, components, tuples);
    }
  }

  void read_array(const std::string& name, const std::string& type, std::size_t components, std::size_t tuples)
  {
    add_array(name, type, components, tuples, read_numbers<double>(type, product(components, tuples)));
  }

  void add_array(const std::string& name,
                 const std::string& type,
                 std::size_t components,
                 std::size_t tuples,
                 std::vector<double> numbers)
  {
    if(!name.empty() && (is_point_data_ || is_cell_data_))
      choice_.names->add(is_cell_data_, decode_name(name), components);
    if(is_point_data_ && components == 1 && numbers.size() == tuples)
      choice_.add({decode_name(name), vtk_type_of_legacy_name(type), std::move(numbers)}, soup_);
  }

  // What is no letter, digit, or the like stands in names as its code.
  static std::string decode_name(const std::string& name)
  {
    std::string decoded;
    for(std::size_t i = 0; i < name.size(); ++i)
    {
      unsigned code = 0;
      const bool is_code = name[i] == '%' && i + 2 < name.size()
                        && std::from_chars(&name[i + 1], &name[i + 1] + 2, code, 16).ptr == &name[i + 1] + 2;
      decoded += is_code ? static_cast<char>(code) : name[i];
      i += is_code ? 2 : 0;
    }
    return decoded;
  }

  void skip_to_blank_line()
  {
    while(input_.next_line() && !input_.next_word_of_line().empty())
      continue;
    input_.finish_line();
  }

  std::string path_;
  Vtk_field_choice choice_;
  Text_input input_;
  std::size_t most_numbers_; // that the file can have
  Polygon_soup soup_;
  Vtk_cells cells_;
  bool is_binary_ = false, is_point_data_ = false, is_cell_data_ = false;
  std::size_t number_of_entries_ = 0;
};

} // namespace

Polygon_soup read_vtk_legacy(const std::string& path, std::string_view text, const Vtk_field_choice& choice)
{
  return Vtk_legacy_reader(path, text, choice).read();
}

} // namespace reeb_graph_program
