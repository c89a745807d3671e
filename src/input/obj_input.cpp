// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of the CGAL-style package Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#include "input/File_contents.h"
#include "input/mesh_formats.h"
#include "input/text_blocks.h"
#include "input/text_input.h"

#include <algorithm>
#include <array>
#include <string_view>
#include <utility>
#include <vector>

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

// Returns the highest vertex, 0 if there is none.
std::size_t read_polygon(Text_input& input, std::size_t number_of_earlier, Polygons& polygons)
{
  std::size_t highest = 0;
  for(std::string_view word = input.word_of_line(); !word.empty(); word = input.word_of_line())
  {
    const std::size_t vertex = read_corner(input, word, number_of_earlier);
    polygons.add_corner(vertex);
    highest = std::max(highest, vertex);
  }
  polygons.end_polygon();
  return highest;
}

// Goes to the next line, and returns whether there is one.
bool next_joined_line(Text_input& input)
{
  if(!input.next_line())
    return false;
  input.remove_comment('#');
  input.join_next_line();
  return true;
}

std::size_t count_points(Text_input& input)
{
  std::size_t number = 0;
  while(next_joined_line(input))
    number += input.next_word_of_line() == "v" ? 1 : 0;
  return number;
}

// The highest vertex of the faces, and the first line with it.
struct Highest_vertex
{
  std::size_t number = 0, line = 0;
};

// Reads the file, or the part of it that has so many vertices before it.
Polygon_soup read_lines(Text_input& input, std::size_t number_before, Highest_vertex& highest_vertex)
{
  Polygon_soup soup;
  while(next_joined_line(input))
  {
    const std::string_view keyword = input.word_of_line();
    if(keyword == "v")
      soup.points.push_back(read_point(input));
    else if(keyword == "f")
    {
      const std::size_t highest = read_polygon(input, number_before + soup.points.size(), soup.polygons);
      if(highest > highest_vertex.number)
        highest_vertex = {highest, input.line_number()};
    }
    else if(!keyword.empty() && !is_skipped_keyword(keyword))
      input.fail(quote(keyword) + " does not begin a line of an OBJ file");
  }
  return soup;
}

} // namespace

Polygon_soup read_obj(const std::string& path)
{
  const File_contents file(path);
  const Text_blocks blocks(Text_input(path, file.text()));
  const std::vector<std::size_t> before = blocks.count_before(count_points);
  std::vector<Polygon_soup> parts(blocks.size());
  std::vector<Highest_vertex> highest(blocks.size());
  run_tasks(blocks.size(), [&](std::size_t i) {
    Text_input block = blocks.input(i);
    parts[i] = read_lines(block, before[i], highest[i]);
  });
  Polygon_soup soup = join(std::move(parts));
  if(soup.points.empty() || soup.polygons.size() == 0)
    throw Input_error(path, blocks.number_of_lines(), "the file ends without a face");
  const auto first =
    std::max_element(highest.begin(), highest.end(),
                     [](const Highest_vertex& a, const Highest_vertex& b) { return a.number < b.number; });
  if(first->number >= soup.points.size())
    throw Input_error(path, first->line, "there is no vertex " + std::to_string(first->number + 1));
  return soup;
}

} // namespace reeb_graph_program
