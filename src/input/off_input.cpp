// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
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
#include <vector>

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

void read_polygon(Text_input& input, Polygons& polygons)
{
  for(auto size = input.number<std::size_t>(input.word_of_line()); size > 0; --size)
    polygons.add_corner(input.number<std::size_t>(input.word_of_line()));
  polygons.end_polygon();
}

std::size_t count_lines_of_words(Text_input& input)
{
  std::size_t number = 0;
  while(next_line_of_words(input))
    ++number;
  return number;
}

// Reads what is behind the header, or the part of it that has so many vertices and faces before it.
Polygon_soup read_lines(Text_input& input, const Off_header& header, std::size_t number_before)
{
  Polygon_soup soup;
  for(std::size_t number = number_before; next_line_of_words(input); ++number)
  {
    if(number < header.vertices)
      soup.points.push_back(read_point(input, header.coordinates));
    else if(number - header.vertices < header.faces)
      read_polygon(input, soup.polygons);
    else
      input.fail("there are more faces than the " + std::to_string(header.faces) + " that the header says");
    skip_numbers(input);
  }
  return soup;
}

} // namespace

Polygon_soup read_off(const std::string& path)
{
  const File_contents file(path);
  Text_input input(path, file.text());
  const Off_header header = read_header(input);
  const Text_blocks blocks(input);
  const std::vector<std::size_t> before = blocks.count_before(count_lines_of_words);
  std::vector<Polygon_soup> parts(blocks.size());
  run_tasks(blocks.size(), [&](std::size_t i) {
    Text_input block = blocks.input(i);
    parts[i] = read_lines(block, header, before[i]);
  });
  Polygon_soup soup = join(std::move(parts));
  if(soup.points.size() < header.vertices || soup.polygons.size() < header.faces)
    throw Input_error(path, blocks.number_of_lines(),
                      "the file ends after " + std::to_string(soup.points.size()) + " of "
                        + std::to_string(header.vertices) + " vertices and " + std::to_string(soup.polygons.size())
                        + " of " + std::to_string(header.faces) + " faces");
  return soup;
}

} // namespace reeb_graph_program
