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

#include <algorithm>
#include <array>
#include <cstddef>
#include <string>
#include <string_view>
#include <utility>

namespace reeb_graph_program {
namespace {
// The next word that is not in a comment; words may be on any line.
std::string_view next_word_of_file(Text_input& input)
{
  std::string_view word = input.word_of_line();
  while(word.empty() && input.next_line())
  {
    input.remove_comment('#');
    word = input.word_of_line();
  }
  return word;
}

template <class Number>
Number next_number(Text_input& input)
{
  return input.number<Number>(next_word_of_file(input));
}

// Vertices are numbered from 1.
Corner next_corner(Text_input& input)
{
  const auto number = next_number<std::size_t>(input);
  if(number == 0)
    input.fail("there is no vertex 0: the first one has number 1");
  return corner(number - 1);
}

// Each simplex ends with a label.
template <std::size_t n>
std::array<Corner, n> next_simplex(Text_input& input)
{
  std::array<Corner, n> simplex;
  for(Corner& v : simplex)
    v = next_corner(input);
  next_number<long long>(input);
  return simplex;
}

template <std::size_t n>
void add_polygon(Text_input& input, Polygons& polygons)
{
  for(const Corner v : next_simplex<n>(input))
    polygons.add_corner(v);
  polygons.end_polygon();
}

Point next_point(Text_input& input)
{
  std::array<double, 3> coordinates;
  for(double& coordinate : coordinates)
    coordinate = next_number<double>(input);
  next_number<long long>(input);
  return Point(coordinates[0], coordinates[1], coordinates[2]);
}

// How many numbers each entry has of a section that says nothing of the complex; 0 if there is no such section.
std::size_t numbers_per_entry(std::string_view section)
{
  constexpr std::array<std::pair<std::string_view, std::size_t>, 14> sections = {{{"Corners", 1},
                                                                                  {"Ridges", 1},
                                                                                  {"RequiredVertices", 1},
                                                                                  {"RequiredEdges", 1},
                                                                                  {"RequiredTriangles", 1},
                                                                                  {"RequiredQuadrilaterals", 1},
                                                                                  {"RequiredTetrahedra", 1},
                                                                                  {"Normals", 3},
                                                                                  {"NormalAtVertices", 2},
                                                                                  {"NormalAtTriangleVertices", 3},
                                                                                  {"NormalAtQuadrilateralVertices", 3},
                                                                                  {"Tangents", 3},
                                                                                  {"TangentAtVertices", 2},
                                                                                  {"TangentAtEdges", 3}}};
  const auto found =
    std::find_if(sections.begin(), sections.end(), [&](const auto& entry) { return entry.first == section; });
  return found == sections.end() ? 0 : found->second;
}

void read_section(Text_input& input, const std::string& section, Polygon_soup& soup)
{
  const std::size_t numbers = numbers_per_entry(section);
  const auto has_cells = [&] {
    return section == "Vertices" || section == "Edges" || section == "Triangles" || section == "Quadrilaterals"
        || section == "Tetrahedra";
  };
  if(numbers == 0 && !has_cells())
    input.fail(quote(section)
               + " is not a section that is read: cells are edges, triangles, quadrilaterals, or tetrahedra");
  for(auto size = next_number<std::size_t>(input); size > 0; --size)
  {
    if(section == "Vertices")
      soup.points.push_back(next_point(input));
    else if(section == "Edges")
      soup.edges.push_back(next_simplex<2>(input));
    else if(section == "Triangles")
      add_polygon<3>(input, soup.polygons);
    else if(section == "Quadrilaterals")
      add_polygon<4>(input, soup.polygons);
    else if(section == "Tetrahedra")
      soup.tetrahedra.push_back(next_simplex<4>(input));
    else
      for(std::size_t i = 0; i < numbers; ++i)
        next_number<double>(input);
  }
}

} // namespace

Polygon_soup read_medit(const std::string& path)
{
  const File_contents file(path);
  Text_input input(path, file.text());
  if(next_word_of_file(input) != "MeshVersionFormatted")
    input.fail("the file does not begin as a MESH file of Medit");
  next_number<int>(input);
  if(next_word_of_file(input) != "Dimension" || next_number<int>(input) != 3)
    input.fail("the mesh is not one of dimension 3");
  Polygon_soup soup;
  std::string section(next_word_of_file(input)); // none at the end of a file without End, which some programs leave out
  for(; !section.empty() && section != "End"; section = next_word_of_file(input))
    read_section(input, section, soup);
  return soup;
}

} // namespace reeb_graph_program
