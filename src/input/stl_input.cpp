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

#include <CGAL/Unique_hash_map.h>

#include <boost/functional/hash.hpp>

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

// Gathers the corners of facets. Those at the same place are one vertex.
class Corner_collector
{
public:
  // Makes room for as many facets as a closed surface has.
  explicit Corner_collector(std::size_t number_of_facets = 0) : vertices_(too_large_corner, number_of_facets)
  {
    soup_.points.reserve(number_of_facets / 2 + 2);
    soup_.polygons.reserve(number_of_facets);
  }

  void add_corner(const Point& point)
  {
    const Bits bits = bits_of(point);
    std::uint64_t key = 0;
    for(const std::uint64_t coordinate : bits)
    {
      key = (key ^ coordinate) * 0x9e3779b97f4a7c15U;
      key ^= key >> 32U;
    }
    key >>= 1U; // The greatest one would be none.
    Corner* vertex = &vertices_[key];
    while(*vertex != too_large_corner && bits_of(soup_.points[*vertex]) != bits)
      vertex = &vertices_[++key]; // as another place has the same key
    if(*vertex == too_large_corner)
    {
      *vertex = static_cast<Corner>(soup_.points.size());
      soup_.points.push_back(point);
    }
    soup_.polygons.add_corner(*vertex);
    ++number_of_corners_;
  }

  void end_facet()
  {
    soup_.polygons.end_polygon();
    number_of_corners_ = 0;
  }

  std::size_t number_of_corners() const { return number_of_corners_; }
  Polygon_soup& soup() { return soup_; }

private:
  typedef std::array<std::uint64_t, 3> Bits; // of coordinates: what is no number, too, is the same as itself

  static Bits bits_of(const Point& point)
  {
    const std::array<double, 3> coordinates = {point.x() + 0., point.y() + 0., point.z() + 0.}; // 0 and -0 are the same
    Bits bits;
    std::memcpy(bits.data(), coordinates.data(), sizeof(bits));
    return bits;
  }

  // By keys that few places have in common: a std::unordered_map takes two to four times as long.
  CGAL::Unique_hash_map<std::uint64_t, Corner, boost::hash<std::uint64_t>> vertices_;
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
  Corner_collector collector(number_of_facets);
  for(std::size_t facet = 0; facet < number_of_facets; ++facet)
  {
    const char* place = bytes.data() + header_size + facet_size * facet + 8; // before its corners, by a number
    const auto next = [&] { return decode_little_endian<float>(place += sizeof(float)); };
    for(std::size_t corner = 0; corner < 3; ++corner)
      collector.add_corner(point_of(next));
    collector.end_facet();
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
    collector.add_corner(point_of([&] { return input.number<double>(input.word_of_file()); }));
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
