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
struct Off_header
{
  std::size_t coordinates = 3; // of a point
  std::size_t vertices = 0;
  std::size_t faces = 0;
};

// Goes to the next line that has a word.
bool next_line_of_words(Text_input& input)
{
  while(input.next_line())
  {
    input.remove_comment('#');
    if(!input.next_word_of_line().empty())
      return true;
  }
  return false;
}

std::string_view next_word_of_header(Text_input& input)
{
  std::string_view word = input.word_of_line();
  while(word.empty() && next_line_of_words(input))
    word = input.word_of_line();
  return word;
}

// The number of coordinates that the first word of the file says.
std::size_t read_keyword(Text_input& input)
{
  std::string_view keyword = next_word_of_header(input);
  const auto remove = [&](std::string_view prefix) {
    const bool is_there = keyword.substr(0, prefix.size()) == prefix;
    keyword.remove_prefix(is_there ? prefix.size() : 0);
    return is_there;
  };
  remove("ST");
  remove("C");
  remove("N");
  const bool is_homogeneous = remove("4");
  if(keyword != "OFF")
    input.fail("the file does not begin as an OFF file");
  return is_homogeneous ? 4 : 3;
}

Off_header read_header(Text_input& input)
{
  Off_header header;
  header.coordinates = read_keyword(input);
  const std::string_view word = next_word_of_header(input);
  if(word == "BINARY")
    input.fail("binary OFF files are not read");
  header.vertices = input.number<std::size_t>(word);
  header.faces = input.number<std::size_t>(next_word_of_header(input));
  input.number<std::size_t>(next_word_of_header(input)); // of edges
  if(!input.word_of_line().empty())
    input.fail("there is more than the numbers of vertices, faces and edges");
  return header;
}

// Colours, normals and textures are numbers as well.
void skip_numbers(Text_input& input)
{
  for(std::string_view word = input.word_of_line(); !word.empty(); word = input.word_of_line())
    input.number<double>(word);
}

Point read_point(Text_input& input, std::size_t number_of_coordinates)
{
  std::array<double, 4> coordinates = {0, 0, 0, 1};
  for(std::size_t i = 0; i < number_of_coordinates; ++i)
    coordinates[i] = input.number<double>(input.word_of_line());
  const auto [x, y, z, w] = coordinates;
  return Point(x / w, y / w, z / w);
}

Polygon read_polygon(Text_input& input)
{
  Polygon polygon;
  for(auto size = input.number<std::size_t>(input.word_of_line()); polygon.size() < size;)
    polygon.push_back(input.number<std::size_t>(input.word_of_line()));
  return polygon;
}

} // namespace

Polygon_soup read_off(const std::string& path)
{
  Text_input input(path);
  const Off_header header = read_header(input);
  Polygon_soup soup;
  while(soup.points.size() < header.vertices && next_line_of_words(input))
  {
    soup.points.push_back(read_point(input, header.coordinates));
    skip_numbers(input);
  }
  while(soup.polygons.size() < header.faces && next_line_of_words(input))
  {
    soup.polygons.push_back(read_polygon(input));
    skip_numbers(input);
  }
  if(soup.points.size() < header.vertices || soup.polygons.size() < header.faces)
    input.fail("the file ends after " + std::to_string(soup.points.size()) + " of " + std::to_string(header.vertices)
               + " vertices and " + std::to_string(soup.polygons.size()) + " of " + std::to_string(header.faces)
               + " faces");
  if(next_line_of_words(input))
    input.fail("there are more faces than the " + std::to_string(header.faces) + " that the header says");
  return soup;
}

} // namespace reeb_graph_program
