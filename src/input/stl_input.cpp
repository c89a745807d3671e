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

#include <CGAL/Reeb_graph/internal/base/compiled.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>
#include <initializer_list>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace reeb_graph_program {
namespace {
constexpr std::size_t header_size = 84, facet_size = 50;

// Gives corners at the same point the same vertex.
class Corner_collector
{
public:
  void add_corner(const Point& point)
  {
    make_room(1);
    add_corner(point, first_place(point));
    ++number_of_corners_;
  }

  // Adds facets, each by its three corners. All are looked up in turns, each of which fetches what the next one reads.
  template <std::size_t size>
  void add_facets(const std::array<Point, size>& corners, std::size_t number_of_facets)
  {
    using CGAL::Reeb_graph::internal::prefetch;
    const std::size_t number = 3 * number_of_facets;
    std::array<std::size_t, size> places;
    make_room(number);
    for(std::size_t i = 0; i < number; ++i)
    {
      places[i] = first_place(corners[i]);
      prefetch(&table_[places[i]]);
    }
    for(std::size_t i = 0; i < number; ++i)
      if(table_[places[i]] != too_large_corner)
        prefetch(&soup_.points[table_[places[i]]]);
    for(std::size_t i = 0; i < number; ++i)
    {
      add_corner(corners[i], places[i]);
      if(i % 3 == 2)
        soup_.polygons.end_polygon();
    }
  }

  // Makes room for as many facets as a closed surface has.
  void reserve(std::size_t number_of_facets)
  {
    const std::size_t number_of_points = number_of_facets / 2 + 2;
    soup_.points.reserve(number_of_points);
    soup_.polygons.reserve(number_of_facets);
    std::size_t size = 1;
    while(size < places_per_point * number_of_points)
      size *= 2;
    grow(size);
  }

  void end_facet()
  {
    soup_.polygons.end_polygon();
    number_of_corners_ = 0;
  }

  std::size_t number_of_corners() const { return number_of_corners_; }
  Polygon_soup& soup() { return soup_; }

private:
  // At least. Few corners meet another point first, which is not the one that has been fetched.
  static constexpr std::size_t places_per_point = 4;

  void add_corner(const Point& point, std::size_t first_place)
  {
    Corner& vertex = table_[find(point, first_place)];
    if(vertex == too_large_corner)
    {
      vertex = static_cast<Corner>(soup_.points.size());
      soup_.points.push_back(point);
    }
    soup_.polygons.add_corner(vertex);
  }

  // The bits of a number, the same ones for 0 and -0.
  static std::uint64_t bits_of(double number)
  {
    number += 0.;
    std::uint64_t bits = 0;
    std::memcpy(&bits, &number, sizeof(bits));
    return bits;
  }

  static std::uint64_t mix(std::uint64_t seed, double number)
  {
    seed = (seed ^ bits_of(number)) * 0x9e3779b97f4a7c15U;
    return seed ^ (seed >> 32U);
  }

  // Coordinates that are no numbers, too, are the same as themselves.
  static bool is_same(const Point& a, const Point& b)
  {
    return bits_of(a.x()) == bits_of(b.x()) && bits_of(a.y()) == bits_of(b.y()) && bits_of(a.z()) == bits_of(b.z());
  }

  std::size_t first_place(const Point& point) const
  {
    return mix(mix(mix(0, point.x()), point.y()), point.z()) & (table_.size() - 1);
  }

  // The place of the vertex at the point, or a free one. Linear probing ends, as most places are free.
  std::size_t find(const Point& point, std::size_t place) const
  {
    while(table_[place] != too_large_corner && !is_same(soup_.points[table_[place]], point))
      place = (place + 1) & (table_.size() - 1);
    return place;
  }

  void make_room(std::size_t number_of_points)
  {
    if(places_per_point * (soup_.points.size() + number_of_points) > table_.size())
      grow(2 * table_.size());
  }

  void grow(std::size_t size)
  {
    table_.assign(std::max<std::size_t>(size, 1024), too_large_corner); // a power of two
    for(std::size_t v = 0; v < soup_.points.size(); ++v)
      table_[find(soup_.points[v], first_place(soup_.points[v]))] = static_cast<Corner>(v);
  }

  std::vector<Corner> table_;
  Polygon_soup soup_;
  std::size_t number_of_corners_ = 0; // of the facet that has not ended
};

template <class Number>
Number decode_little_endian(const char* bytes)
{
  return decode<Number>(bytes, is_machine_big_endian());
}

// The number of facets that the header says if the file is binary: if it has their size at least, which no text has, or
// a byte that no text has.
std::optional<std::size_t> number_of_binary_facets(std::string_view bytes)
{
  if(bytes.size() < header_size)
    return std::nullopt;
  const std::size_t number = decode_little_endian<std::uint32_t>(bytes.data() + 80);
  const bool is_binary = (bytes.size() - header_size) / facet_size >= number
                      || bytes.substr(0, header_size).find('\0') != std::string_view::npos;
  return is_binary ? std::make_optional(number) : std::nullopt;
}

// Bytes behind the facets, which some programs write, are left out.
void check_size(const std::string& path,
                std::size_t size,
                std::size_t number_of_facets,
                std::vector<std::string>& notes)
{
  const std::size_t needed = header_size + facet_size * number_of_facets;
  const std::string said = std::to_string(number_of_facets) + " triangles";
  if(size < needed)
    throw Input_error(path, "the file ends too early: its header says that there are " + said + ", and "
                              + std::to_string((size - header_size) / facet_size) + " are");
  if(size > needed && number_of_facets == 0)
    throw Input_error(path, "its header says that there are 0 triangles, but " + std::to_string(size - needed)
                              + " bytes follow");
  if(size > needed)
    notes.push_back(std::to_string(size - needed) + " bytes are left out behind the " + said
                    + " that the header of the file says");
}

Polygon_soup read_binary(std::string_view bytes, std::size_t number_of_facets)
{
  Corner_collector collector;
  collector.reserve(number_of_facets);
  const auto point = [&](std::size_t facet, std::size_t corner) {
    const char* const begin = bytes.data() + header_size + facet_size * facet + 12 * (corner + 1); // behind the normal
    return Point(decode_little_endian<float>(begin), decode_little_endian<float>(begin + 4),
                 decode_little_endian<float>(begin + 8));
  };
  constexpr std::size_t most_facets = 64; // whose corners are in the nearest cache until they are added
  std::array<Point, 3 * most_facets> corners;
  for(std::size_t begin = 0; begin < number_of_facets; begin += most_facets)
  {
    const std::size_t number = std::min(most_facets, number_of_facets - begin);
    for(std::size_t i = 0; i < 3 * number; ++i)
      corners[i] = point(begin + i / 3, i % 3);
    collector.add_facets(corners, number);
  }
  return std::move(collector.soup());
}

// The next keyword in small letters; some programs write `end loop` as two words.
std::string next_keyword(Text_input& input)
{
  std::string keyword(input.word_of_file());
  if(!std::all_of(keyword.begin(), keyword.end(), [](char c) { return c >= 'a' && c <= 'z'; })) // which is rare
    keyword = lower_case(keyword);
  if(keyword == "end")
    keyword += lower_case(std::string(input.word_of_line()));
  return keyword;
}

void expect(Text_input& input, std::initializer_list<std::string_view> words)
{
  for(const std::string_view expected : words)
  {
    const std::string word = next_keyword(input);
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
    std::string word = next_keyword(input);
    for(; word == "facet"; word = next_keyword(input))
      read_facet(input, collector);
    if(word != "endsolid")
      input.fail(quote(word) + " instead of 'facet' or 'endsolid'");
    input.finish_line();
    word = next_keyword(input);
    if(word.empty())
      return std::move(collector.soup());
    if(word != "solid")
      input.fail(quote(word) + " instead of 'solid'");
  }
}

} // namespace

Polygon_soup read_stl(const std::string& path)
{
  const File_contents file(path);
  if(const auto number_of_facets = number_of_binary_facets(file.text()))
  {
    std::vector<std::string> notes;
    check_size(path, file.text().size(), *number_of_facets, notes);
    Polygon_soup soup = read_binary(file.text(), *number_of_facets);
    soup.notes = std::move(notes);
    return soup;
  }
  Text_input input(path, file.text());
  return read_ascii(input);
}

} // namespace reeb_graph_program
