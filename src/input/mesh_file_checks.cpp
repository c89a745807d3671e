// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of the CGAL-style package Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#include "input/mesh_file_checks.h"

#include "input/input_error.h"

#include <algorithm>
#include <charconv>
#include <fstream>
#include <sstream>
#include <string_view>
#include <system_error>
#include <vector>

namespace reeb_graph_program {
namespace {
std::string read_characters(std::ifstream& file, std::size_t first, std::size_t number)
{
  std::string characters(number, '\0');
  file.clear();
  file.seekg(static_cast<std::streamoff>(first));
  file.read(characters.data(), static_cast<std::streamsize>(number));
  characters.resize(static_cast<std::size_t>(file.gcount()));
  return characters;
}

// The numbers that a line begins with.
std::vector<long long> leading_numbers(const std::string& line)
{
  std::istringstream stream(line);
  std::vector<long long> numbers;
  for(long long number; stream >> number;)
    numbers.push_back(number);
  return numbers;
}

// Refuses a file whose last line that says anything is a face, but not the last one that has been read.
void check_last_face_of_off(const std::string& path, const Polygon_soup& soup)
{
  std::ifstream file(path);
  std::string line, header, last_line;
  while(std::getline(file, line))
  {
    line.resize((std::min)(line.find('#'), line.size()));
    if(line.find_first_not_of(" \t\r") == std::string::npos)
      continue;
    if(header.empty())
      header = line;
    last_line = line;
  }
  const std::vector<long long> numbers = leading_numbers(last_line);
  if(header.find("BINARY") != std::string::npos || soup.polygons.empty() || numbers.size() < 4 || numbers[0] < 3
     || numbers.size() <= static_cast<std::size_t>(numbers[0]))
    return;
  const auto begin = numbers.begin() + 1, end = begin + numbers[0];
  const bool is_face = std::all_of(
    begin, end, [&](long long v) { return v >= 0 && static_cast<unsigned long long>(v) < soup.points.size(); });
  const Polygon& last = soup.polygons.back();
  if(is_face && !std::equal(begin, end, last.begin(), last.end(), [](long long a, std::size_t b) {
       return static_cast<unsigned long long>(a) == b;
     }))
    throw Input_error(path, "there are more faces than the " + std::to_string(soup.polygons.size())
                              + " that the header says");
}

// The next word of a line, from `begin` on; empty at the end, or where a comment begins.
std::string_view next_word(std::string_view line, std::size_t begin)
{
  const char* const blanks = " \t\r";
  begin = line.find_first_not_of(blanks, begin);
  if(begin == std::string_view::npos || line[begin] == '#')
    return {};
  return line.substr(begin, line.find_first_of(blanks, begin) - begin);
}

// A corner of a face: the number of its vertex, from 1, or counted backwards from -1, and possibly more behind slashes.
bool is_corner(std::string_view word, long long number_of_earlier, long long number_of_vertices)
{
  long long vertex = 0;
  const auto parsed = std::from_chars(word.data(), word.data() + word.size(), vertex);
  const bool is_number = parsed.ec == std::errc() && (parsed.ptr == word.data() + word.size() || *parsed.ptr == '/');
  return is_number && vertex != 0 && vertex <= number_of_vertices && vertex >= -number_of_earlier;
}

// Lines that end in a backslash go on in the next one.
bool read_obj_line(std::ifstream& file, std::string& line, std::size_t& number)
{
  line.clear();
  for(std::string part; std::getline(file, part);)
  {
    ++number;
    const std::size_t end = part.find_last_not_of('\r');
    const bool goes_on = end != std::string::npos && part[end] == '\\';
    line += goes_on ? part.substr(0, end) + ' ' : part;
    if(!goes_on)
      return true;
  }
  return !line.empty();
}

void check_faces_of_obj(const std::string& path, const Polygon_soup& soup)
{
  std::ifstream file(path);
  std::string line;
  long long number_of_earlier = 0;
  std::size_t face = 0;
  for(std::size_t number = 0; read_obj_line(file, line, number);)
  {
    const auto end_of = [&](std::string_view w) { return static_cast<std::size_t>(w.data() + w.size() - line.data()); };
    std::string_view word = next_word(line, 0);
    if(word == "v")
      ++number_of_earlier;
    if(word != "f")
      continue;
    std::size_t number_of_corners = 0;
    for(word = next_word(line, end_of(word)); !word.empty(); word = next_word(line, end_of(word)))
    {
      if(!is_corner(word, number_of_earlier, static_cast<long long>(soup.points.size())))
        throw Input_error(path, number, "'" + std::string(word) + "' is no vertex of a face");
      ++number_of_corners;
    }
    if(face >= soup.polygons.size() || soup.polygons[face++].size() != number_of_corners)
      throw Input_error(path, number, "the face has been read with another number of vertices");
  }
}

} // namespace

bool is_stl_file_complete(const std::string& path)
{
  std::ifstream file(path, std::ios::binary | std::ios::ate);
  const auto file_size = static_cast<std::size_t>(file.tellg());
  const std::size_t header_size = 84, facet_size = 50;
  const std::string header = read_characters(file, 0, header_size);
  std::size_t number_of_facets = 0;
  for(std::size_t i = header.size(); i > 80; --i)
    number_of_facets = 256 * number_of_facets + static_cast<unsigned char>(header[i - 1]);
  if(header.size() == header_size && file_size >= header_size + facet_size * number_of_facets)
    return true;
  const std::size_t tail_size = std::min<std::size_t>(file_size, 256);
  return read_characters(file, file_size - tail_size, tail_size).find("endsolid") != std::string::npos;
}

void check_mesh_file(const std::string& path, const std::string& extension, const Polygon_soup& soup)
{
  if(extension == ".off")
    check_last_face_of_off(path, soup);
  if(extension == ".obj")
    check_faces_of_obj(path, soup);
}

} // namespace reeb_graph_program
