// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#include "input/input_error.h"
#include "input/refused_formats.h"
#include "input/text_input.h"
#include "input/vtk_cells.h"
#include "input/vtk_input.h"
#include "input/vtk_xml_arrays.h"
#include "input/vtk_xml_tags.h"

#include <cstddef>
#include <map>
#include <set>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>
#include <vector>

namespace reeb_graph_program {
namespace {
// The elements of a piece of the grid.
struct Vtk_xml_piece
{
  Xml_tag tag;
  std::map<std::string, Vtk_xml_array> arrays; // by the names of sections and arrays
};

// Reads files of unstructured grids, whose cells have types, and of polygonal data, whose sections do.
class Vtk_xml_reader
{
public:
  Vtk_xml_reader(const std::string& path, std::string_view text, const Vtk_field_choice& choice)
    : path_(path),
      text_(text),
      choice_(choice),
      arrays_(path, text)
  {}

  Polygon_soup read()
  {
    read_elements();
    Polygon_soup soup;
    for(const Vtk_xml_piece& piece : pieces_)
      add_piece(piece, soup);
    return soup;
  }

private:
  [[noreturn]] void fail(const std::string& message) const { throw Input_error(path_, message); }

  // A number of points or cells of a piece; those that there are none of may be left out.
  std::size_t size(const Vtk_xml_piece& piece, const std::string& attribute) const
  {
    const std::string text = piece.tag.attribute(attribute, "0");
    std::size_t number = 0;
    if(parse_number(text, number) != std::errc())
      fail(quote(text) + " is not a number that is possible here");
    return number;
  }

  void read_elements()
  {
    static const std::set<std::string> sections = {"PointData", "CellData", "Points", "Cells",
                                                   "Verts",     "Lines",    "Strips", "Polys"};
    std::string section, type;
    bool has_end = false;
    for(std::size_t place = 0; !has_end;)
    {
      const Xml_tag tag = next_tag(path_, text_, place);
      if(tag.name.empty())
        break;
      place = tag.end;
      if(tag.name == "VTKFile")
        type = read_file_tag(tag);
      else if(tag.name == "Piece")
        pieces_.push_back({tag, {}});
      else if(sections.count(tag.name) != 0)
        section = tag.name;
      else if(tag.name == "DataArray" && !pieces_.empty())
      {
        add_name(section, tag);
        pieces_.back().arrays[section + " " + tag.attribute("Name")] = {
          tag, text_.substr(tag.end, text_.find('<', tag.end) - tag.end)};
      }
      else if(tag.name == "AppendedData")
        arrays_.read_appended_tag(tag);
      has_end = tag.name == "AppendedData" || tag.name == "/VTKFile"; // raw data are no XML
    }
    if(type.empty())
      fail("the file does not begin as a VTK file");
    if(!has_end)
      fail("the file ends too early: </VTKFile> is missing");
  }

  // Of several pieces, the first one has the names.
  void add_name(const std::string& section, const Xml_tag& tag)
  {
    std::size_t components = 1;
    parse_number(tag.attribute("NumberOfComponents", "1"), components);
    if(pieces_.size() == 1 && (section == "PointData" || section == "CellData"))
      choice_.names->add(section == "CellData", tag.attribute("Name"), components);
  }

  std::string read_file_tag(const Xml_tag& tag)
  {
    const std::string type = tag.attribute("type");
    if(type != "UnstructuredGrid" && type != "PolyData")
      fail(refused_vtk_type(type));
    arrays_.read_file_tag(tag);
    return type;
  }

  void add_piece(const Vtk_xml_piece& piece, Polygon_soup& soup) const
  {
    const std::size_t first_vertex = soup.points.size(), number_of_points = size(piece, "NumberOfPoints");
    add_points(piece, number_of_points, soup);
    for(const auto& [name, array] : piece.arrays)
      if(name.substr(0, 10) == "PointData " && array.tag.attribute("NumberOfComponents", "1") == "1")
        add_field(array, number_of_points, soup);
    Vtk_cells cells;
    if(const std::size_t number_of_cells = size(piece, "NumberOfCells"))
    {
      const Vtk_xml_array& types = array(piece, "Cells types");
      cells.types = arrays_.indices("types", types);
      if(cells.types.size() != number_of_cells)
        fail("the array of types has " + std::to_string(cells.types.size()) + " numbers instead of "
             + std::to_string(number_of_cells));
      check_vtk_types(path_, cells.types);
      add_cells(piece, "Cells", number_of_cells, cells);
    }
    const std::pair<const char*, std::size_t> sections[] = {
      {"Verts", vtk_vertices}, {"Lines", vtk_lines}, {"Polys", vtk_polygons}, {"Strips", vtk_strips}};
    for(const auto& [section, type] : sections)
      if(const std::size_t number_of_cells = size(piece, std::string("NumberOf") + section))
      {
        add_cells(piece, section, number_of_cells, cells);
        cells.types.resize(cells.vertices.size(), type);
      }
    add_vtk_cells(path_, cells, first_vertex, soup);
  }

  void add_points(const Vtk_xml_piece& piece, std::size_t number, Polygon_soup& soup) const
  {
    for(const auto& [name, array] : piece.arrays)
      if(name.substr(0, 7) == "Points ")
      {
        const std::vector<double> coordinates = arrays_.numbers("points", array);
        const std::string components = array.tag.attribute("NumberOfComponents", "1");
        if(components != "3" || coordinates.size() / 3 != number || coordinates.size() % 3 != 0)
          fail("the array of points has " + std::to_string(coordinates.size()) + " numbers, " + components
               + " of each, instead of " + std::to_string(number) + " times 3");
        for(std::size_t i = 0; i < number; ++i)
          soup.points.emplace_back(coordinates[3 * i], coordinates[3 * i + 1], coordinates[3 * i + 2]);
        return;
      }
    if(number > 0)
      fail("there is no array of points");
  }

  void add_field(const Vtk_xml_array& array, std::size_t number_of_points, Polygon_soup& soup) const
  {
    Vertex_field field = {array.tag.attribute("Name"), array.tag.attribute("type"), {}};
    if(!choice_.is_wanted(field.name) || (choice_.are_all_wanted && field.type == "Bit"))
      return;
    field.numbers = arrays_.numbers(quote(field.name), array);
    if(field.numbers.size() != number_of_points)
      fail("the array of " + quote(field.name) + " has " + std::to_string(field.numbers.size()) + " numbers instead of "
           + std::to_string(number_of_points));
    choice_.add(field, soup);
  }

  const Vtk_xml_array& array(const Vtk_xml_piece& piece, const std::string& name) const
  {
    const auto found = piece.arrays.find(name);
    if(found == piece.arrays.end())
      fail("there is no array of " + name);
    return found->second;
  }

  void add_cells(const Vtk_xml_piece& piece, const std::string& section, std::size_t number, Vtk_cells& cells) const
  {
    const std::vector<std::size_t> ends = arrays_.indices("offsets", array(piece, section + " offsets"));
    if(ends.size() != number)
      fail("the array of offsets has " + std::to_string(ends.size()) + " numbers instead of " + std::to_string(number));
    add_vtk_vertices(path_, ends, arrays_.indices("connectivity", array(piece, section + " connectivity")),
                     cells.vertices);
  }

  std::string path_;
  std::string_view text_;
  Vtk_field_choice choice_;
  Vtk_xml_arrays arrays_;
  std::vector<Vtk_xml_piece> pieces_;
};

} // namespace

Polygon_soup read_vtk_xml(const std::string& path, std::string_view text, const Vtk_field_choice& choice)
{
  return Vtk_xml_reader(path, text, choice).read();
}

} // namespace reeb_graph_program
