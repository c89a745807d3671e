// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of the CGAL-style package Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#include "input/mesh_formats.h"
#include "input/text_input.h"

#include <algorithm>
#include <array>
#include <string_view>

namespace reeb_graph_program {
namespace {
// What a mesh does without: parameters, normals, names, materials, curves.
bool is_skipped_keyword(std::string_view keyword)
{
  static constexpr std::array<std::string_view, 42> keywords = {
    "vt",       "vn",     "vp",     "g",      "o",     "s",     "l",    "p",          "bevel",     "lod",    "c_interp",
    "d_interp", "usemap", "usemtl", "mtllib", "ctech", "stech", "end",  "shadow_obj", "trace_obj", "cstype", "deg",
    "step",     "bmat",   "con",    "curv",   "curv2", "surf",  "parm", "trim",       "hole",      "scrv",   "sp",
    "mg",       "maplib", "bsp",    "bzp",    "cdc",   "cdp",   "res",  "call",       "csh"};
  return std::find(keywords.begin(), keywords.end(), keyword) != keywords.end();
}

// The vertex of a corner: its number, from 1, or counted backwards from -1, and possibly more behind slashes.
std::size_t read_corner(const Text_input& input, std::string_view word, std::size_t number_of_earlier)
{
  const std::string_view digits = word.substr(0, word.find('/'));
  long long vertex = 0;
  const auto earlier = static_cast<long long>(number_of_earlier);
  if(parse_number(digits, vertex) != std::errc() || vertex == 0 || vertex < -earlier)
    input.fail(quote(word) + " is no vertex of a face");
  return static_cast<std::size_t>(vertex > 0 ? vertex - 1 : earlier + vertex);
}

Point read_point(Text_input& input)
{
  std::array<double, 3> coordinates = {};
  for(double& coordinate : coordinates)
    coordinate = input.number<double>(input.word_of_line());
  return Point(coordinates[0], coordinates[1], coordinates[2]);
}

Polygon read_polygon(Text_input& input, std::size_t number_of_earlier)
{
  Polygon polygon;
  for(std::string_view word = input.word_of_line(); !word.empty(); word = input.word_of_line())
    polygon.push_back(read_corner(input, word, number_of_earlier));
  return polygon;
}

} // namespace

Polygon_soup read_obj(const std::string& path)
{
  Text_input input(path);
  Polygon_soup soup;
  std::size_t highest_vertex = 0, line_of_highest_vertex = 0;
  while(input.next_line())
  {
    input.remove_comment('#');
    input.join_next_line();
    const std::string_view keyword = input.word_of_line();
    if(keyword == "v")
      soup.points.push_back(read_point(input));
    else if(keyword == "f")
    {
      const Polygon& polygon = soup.polygons.emplace_back(read_polygon(input, soup.points.size()));
      const auto highest = std::max_element(polygon.begin(), polygon.end());
      if(highest != polygon.end() && *highest > highest_vertex)
      {
        highest_vertex = *highest;
        line_of_highest_vertex = input.line_number();
      }
    }
    else if(!keyword.empty() && !is_skipped_keyword(keyword))
      input.fail(quote(keyword) + " does not begin a line of an OBJ file");
  }
  if(soup.points.empty() || soup.polygons.empty())
    input.fail("the file ends, and has no face");
  if(highest_vertex >= soup.points.size())
    throw Input_error(path, line_of_highest_vertex, "there is no vertex " + std::to_string(highest_vertex + 1));
  return soup;
}

} // namespace reeb_graph_program
