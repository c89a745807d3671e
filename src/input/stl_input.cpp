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
#include <cstdint>
#include <cstring>
#include <initializer_list>
#include <map>
#include <optional>
#include <string_view>
#include <utility>

namespace reeb_graph_program {
namespace {
constexpr std::size_t header_size = 84, facet_size = 50;

// Gives corners at the same point the same vertex.
class Corner_collector
{
public:
  void add_corner(const Point& point)
  {
    const auto [place, is_new] = vertices_.emplace(Coordinates{point.x(), point.y(), point.z()}, soup_.points.size());
    if(is_new)
      soup_.points.push_back(point);
    polygon_.push_back(place->second);
  }

  void end_facet()
  {
    soup_.polygons.push_back(polygon_);
    polygon_.clear();
  }

  std::size_t number_of_corners() const { return polygon_.size(); }
  Polygon_soup& soup() { return soup_; }

private:
  typedef std::array<double, 3> Coordinates;

  std::map<Coordinates, std::size_t> vertices_;
  Polygon_soup soup_;
  Polygon polygon_;
};

std::uint32_t little_endian_integer(const char* bytes)
{
  std::uint32_t result = 0;
  for(int i = 3; i >= 0; --i)
    result = 256 * result + static_cast<unsigned char>(bytes[i]);
  return result;
}

float little_endian_float(const char* bytes)
{
  const std::uint32_t integer = little_endian_integer(bytes);
  float result = 0;
  static_assert(sizeof(result) == sizeof(integer), "the floating point numbers of STL have 32 bits");
  std::memcpy(&result, &integer, sizeof(result));
  return result;
}

// The number of facets if the file is binary: if it has the size that its header says.
std::optional<std::size_t> number_of_binary_facets(std::ifstream& file)
{
  std::array<char, header_size> header{};
  file.seekg(0, std::ios::end);
  const auto file_size = static_cast<std::size_t>(file.tellg());
  file.seekg(0);
  if(file_size < header_size || !file.read(header.data(), header.size()))
    return std::nullopt;
  const std::size_t number = little_endian_integer(header.data() + 80);
  if(file_size != header_size + facet_size * number)
    return std::nullopt;
  return number;
}

Polygon_soup read_binary(Text_input& input, std::size_t number_of_facets)
{
  Corner_collector collector;
  std::array<char, facet_size> facet{};
  for(std::size_t i = 0; i < number_of_facets; ++i)
  {
    if(!input.file().read(facet.data(), facet.size()))
      input.fail("the file ends too early");
    for(std::size_t corner = 12; corner < 48; corner += 12) // behind the normal
      collector.add_corner(Point(little_endian_float(&facet[corner]), little_endian_float(&facet[corner + 4]),
                                 little_endian_float(&facet[corner + 8])));
    collector.end_facet();
  }
  return std::move(collector.soup());
}

void expect(Text_input& input, std::initializer_list<std::string_view> words)
{
  for(const std::string_view expected : words)
  {
    const std::string_view word = input.word_of_file();
    if(word != expected)
      input.fail(quote(word) + " instead of " + quote(expected));
  }
}

// The rest of a facet, from its normal on.
void read_facet(Text_input& input, Corner_collector& collector)
{
  expect(input, {"normal"});
  for(int i = 0; i < 3; ++i)
    input.word_of_file(); // whatever the normal is
  expect(input, {"outer", "loop"});
  while(collector.number_of_corners() < 3)
  {
    expect(input, {"vertex"});
    std::array<double, 3> coordinates = {};
    for(double& coordinate : coordinates)
      coordinate = input.number<double>(input.word_of_file());
    collector.add_corner(Point(coordinates[0], coordinates[1], coordinates[2]));
  }
  expect(input, {"endloop", "endfacet"});
  collector.end_facet();
}

Polygon_soup read_ascii(Text_input& input)
{
  Corner_collector collector;
  expect(input, {"solid"});
  while(true)
  {
    input.finish_line(); // the name of the solid
    std::string_view word = input.word_of_file();
    for(; word == "facet"; word = input.word_of_file())
      read_facet(input, collector);
    if(word != "endsolid")
      input.fail(quote(word) + " instead of 'facet' or 'endsolid'");
    input.finish_line();
    word = input.word_of_file();
    if(word.empty())
      return std::move(collector.soup());
    if(word != "solid")
      input.fail(quote(word) + " instead of 'solid'");
  }
}

} // namespace

Polygon_soup read_stl(const std::string& path)
{
  Text_input input(path);
  const auto number_of_facets = number_of_binary_facets(input.file());
  if(number_of_facets)
    return read_binary(input, *number_of_facets);
  input.restart();
  return read_ascii(input);
}

} // namespace reeb_graph_program
