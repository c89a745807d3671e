// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#include "input/File_contents.h"
#include "input/mesh_formats.h"
#include "input/text_input.h"

#include <array>
#include <string_view>
#include <unordered_map>

namespace reeb_graph_program {
namespace {
// Vertices have numbers of their own in a TS file.
class Numbered_vertices
{
public:
  explicit Numbered_vertices(Text_input& input) : input_(input) {}

  // Reads the number and the coordinates of a vertex.
  Point read_point()
  {
    const auto number = input_.number<long long>(input_.word_of_line());
    if(!positions_.emplace(number, positions_.size()).second)
      input_.fail("there is a vertex " + std::to_string(number) + " before");
    std::array<double, 3> coordinates = {};
    for(double& coordinate : coordinates)
      coordinate = input_.number<double>(input_.word_of_line());
    return Point(coordinates[0], coordinates[1], coordinates[2]);
  }

  // Reads the numbers of the vertices of a triangle.
  void read_triangle(Polygons& polygons)
  {
    for(int corner = 0; corner < 3; ++corner)
    {
      const auto number = input_.number<long long>(input_.word_of_line());
      const auto position = positions_.find(number);
      if(position == positions_.end())
        input_.fail("there is no vertex " + std::to_string(number) + " before");
      polygons.add_corner(position->second);
    }
    polygons.end_polygon();
  }

private:
  Text_input& input_;
  std::unordered_map<long long, std::size_t> positions_;
};

} // namespace

Polygon_soup read_ts(const std::string& path)
{
  const File_contents file(path);
  Text_input input(path, file.text());
  while(input.next_word_of_line() != "TFACE")
    if(!input.next_line())
      input.fail("the file ends, and has no line TFACE");
  Polygon_soup soup;
  Numbered_vertices vertices(input);
  bool has_end = false;
  while(input.next_line())
  {
    const std::string_view keyword = input.word_of_line();
    if(keyword == "VRTX" || keyword == "PVRTX")
      soup.points.push_back(vertices.read_point());
    else if(keyword == "TRGL")
      vertices.read_triangle(soup.polygons);
    else if(keyword == "ATOM" || keyword == "PATOM")
      input.fail("vertices that are others again are not read");
    else if(keyword == "SEG" || keyword == "TETRA")
      input.fail(quote(keyword) + " is not read: cells are triangles, TRGL");
    has_end = has_end || keyword == "END";
  }
  if(!has_end)
    input.fail("the file ends, and has no line END");
  return soup;
}

} // namespace reeb_graph_program
