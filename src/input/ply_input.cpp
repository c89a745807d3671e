// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#include "base/threads.h"
#include "input/File_contents.h"
#include "input/mesh_formats.h"
#include "input/ply_header.h"
#include "input/text_blocks.h"
#include "input/text_input.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace reeb_graph_program {
namespace {
using ply::Data;
using ply::Element;
using ply::Format;
using ply::Property;

// Calls visit(number, record) for all of the records, on all threads.
template <class Visit>
void for_each_record(std::string_view records, std::size_t number, const Visit& visit)
{
  constexpr std::size_t block = 1 << 16;
  const std::size_t size = records.size() / number;
  run_tasks((number + block - 1) / block, [&](std::size_t task) {
    const std::size_t end = std::min(number, (task + 1) * block);
    for(std::size_t i = task * block; i < end; ++i)
      visit(i, records.data() + i * size);
  });
}

// Reads points without lists in a binary file, and what the property at one more place says of them, if it is one of
// theirs. Returns false if they are others, or there are points before.
bool read_point_records(const Element& element,
                        const std::array<std::size_t, 3>& places,
                        std::optional<std::size_t> scalar_place,
                        Data& data,
                        Polygon_soup& soup)
{
  const std::string_view records = data.records(element);
  const bool has_list = std::any_of(element.properties.begin(), element.properties.end(),
                                    [](const Property& property) { return property.is_list(); });
  if(records.empty() || has_list || !soup.points.empty())
    return false;
  soup.points.resize(element.number);
  soup.scalars.resize(scalar_place ? element.number : 0);
  const ply::Column x = data.column(element, places[0]), y = data.column(element, places[1]),
                    z = data.column(element, places[2]), scalar = data.column(element, scalar_place.value_or(0));
  for_each_record(records, element.number, [&](std::size_t i, const char* record) {
    soup.points[i] = Point(x(record), y(record), z(record));
    if(scalar_place)
      soup.scalars[i] = scalar(record);
  });
  data.skip(records);
  return true;
}

// Reads the faces of a binary file if all of them are triangles of vertices that may exist. Returns false otherwise.
bool read_triangle_records(const Element& element, std::size_t place, Data& data, Polygons& polygons)
{
  const std::string_view records = data.records(element);
  const auto number_of_lists = std::count_if(element.properties.begin(), element.properties.end(),
                                             [](const Property& property) { return property.is_list(); });
  if(records.empty() || number_of_lists != 1 || polygons.size() != 0)
    return false;
  const Property& list = element.properties[place];
  const std::size_t offset = ply::offset_in_record(element, place),
                    size_of_size = ply::size_in_bytes(list.list_size_type);
  Corner* const corners = polygons.make_triangles(element.number);
  std::atomic<bool> are_triangles(true);
  const auto read_all = [&](auto type_of_vertex) {
    for_each_record(records, element.number, [&](std::size_t i, const char* record) {
      typedef decltype(type_of_vertex) Number;
      const char* const begin = record + offset;
      bool is_triangle = ply::decode_number(list.list_size_type, begin, data.is_reversed()) == 3;
      for(std::size_t j = 0; j < 3; ++j)
      {
        const auto v = decode<Number>(begin + size_of_size + j * sizeof(Number), data.is_reversed());
        is_triangle = is_triangle && v >= Number();
        corners[3 * i + j] = corner(static_cast<std::size_t>(v));
      }
      if(!is_triangle)
        are_triangles = false;
    });
  };
  ply::call_with_number(list.type, read_all);
  if(are_triangles)
    data.skip(records);
  else
    polygons = Polygons();
  return are_triangles;
}

void read_points(Text_input& input,
                 const ply::Header& header,
                 const Element& element,
                 const std::string& scalar_name,
                 Data& data,
                 Polygon_soup& soup)
{
  const std::array<std::size_t, 3> places = {element.find({"x"}), element.find({"y"}), element.find({"z"})};
  for(const std::size_t place : places)
    if(place == element.properties.size() || element.properties[place].is_list())
      input.fail("the vertices have no x, y and z");
  const std::size_t scalar_place = scalar_name.empty() ? 0 : ply::find_scalars(input, header, element, scalar_name);
  if(read_point_records(element, places, scalar_name.empty() ? std::nullopt : std::make_optional(scalar_place), data,
                        soup))
    return;
  std::vector<double> numbers(element.properties.size()), list;
  for(std::size_t i = 0; i < element.number; ++i)
  {
    for(std::size_t j = 0; j < numbers.size(); ++j)
      if(element.properties[j].is_list())
        data.read(element.properties[j], list);
      else
        numbers[j] = data.read(element.properties[j].type);
    soup.points.emplace_back(numbers[places[0]], numbers[places[1]], numbers[places[2]]);
    if(!scalar_name.empty())
      soup.scalars.push_back(numbers[scalar_place]);
  }
}

void read_polygon(Text_input& input, const Property& property, Data& data, Polygons& polygons)
{
  const std::size_t size = data.read_list_size(property);
  bool is_any_negative = false;
  for(std::size_t i = 0; i != size; ++i)
  {
    const double v = data.read(property.type);
    is_any_negative = is_any_negative || v < 0;
    polygons.add_corner(v < 0 ? too_large_corner : static_cast<std::size_t>(v));
  }
  if(is_any_negative)
    input.fail("face " + std::to_string(polygons.size()) + " has a vertex that does not exist");
  polygons.end_polygon();
}

// The place of the list of vertices.
std::size_t find_vertices(Text_input& input, const Element& element, const std::string& plural)
{
  const std::size_t place = element.find({"vertex_indices", "vertex_index"});
  if(place == element.properties.size() || !element.properties[place].is_list()
     || !is_integer(element.properties[place].type))
    input.fail("the " + plural + " have no list of vertices");
  return place;
}

void read_polygons(Text_input& input, const Element& element, Data& data, Polygons& polygons)
{
  const std::size_t place = find_vertices(input, element, "faces");
  if(read_triangle_records(element, place, data, polygons))
    return;
  std::vector<double> ignored;
  for(std::size_t i = 0; i < element.number; ++i)
    for(std::size_t j = 0; j < element.properties.size(); ++j)
      if(j == place)
        read_polygon(input, element.properties[j], data, polygons);
      else
        data.read(element.properties[j], ignored);
}

// Strips of triangles one behind the other in lists: -1 ends one, which is the greatest number of an unsigned type.
void read_strips(Text_input& input, const Element& element, Data& data, Polygons& polygons)
{
  const std::size_t place = find_vertices(input, element, "strips of triangles");
  const double end_of_strip = element.properties[place].type == ply::Type::UINT32 ? 4294967295. : -1;
  std::vector<double> numbers;
  std::vector<Corner> strip;
  for(std::size_t i = 0; i < element.number; ++i)
    for(std::size_t j = 0; j < element.properties.size(); ++j)
    {
      data.read(element.properties[j], numbers);
      if(j != place)
        continue;
      numbers.push_back(end_of_strip);
      for(const double v : numbers)
        if(v == end_of_strip)
        {
          add_strip(strip, polygons);
          strip.clear();
        }
        else if(v < 0)
          input.fail("a strip of triangles has a vertex that does not exist");
        else
          strip.push_back(corner(static_cast<std::size_t>(v)));
    }
}

void read_edges(Text_input& input, const Element& element, Data& data, std::vector<std::array<Corner, 2>>& edges)
{
  const std::array<std::size_t, 2> places = {element.find({"vertex1", "v0", "vertex_1", "source"}),
                                             element.find({"vertex2", "v1", "vertex_2", "target"})};
  for(const std::size_t place : places)
    if(element.number > 0 && (place == element.properties.size() || element.properties[place].is_list()))
      input.fail("the edges have no vertex1 and vertex2");
  std::vector<double> numbers;
  std::array<double, 2> ends = {};
  for(std::size_t i = 0; i < element.number; ++i)
  {
    for(std::size_t j = 0; j < element.properties.size(); ++j)
    {
      data.read(element.properties[j], numbers);
      for(std::size_t k = 0; k < 2; ++k)
        if(j == places[k])
          ends[k] = numbers.front();
    }
    const auto end = [&](std::size_t k) {
      return ends[k] < 0 ? too_large_corner : corner(static_cast<std::size_t>(ends[k]));
    };
    edges.push_back({end(0), end(1)});
  }
}

Polygon_soup read_elements(Text_input& input, const ply::Header& header, const std::string& vertex_property)
{
  Data data(input, header.format);
  Polygon_soup soup;
  for(const Element& element : header.elements)
  {
    if(element.is_vertex())
      read_points(input, header, element, vertex_property, data, soup);
    else if(element.is_face())
      read_polygons(input, element, data, soup.polygons);
    else if(element.name == "tristrips" || element.name == "tristrip")
      read_strips(input, element, data, soup.polygons);
    else if(element.name == "edge" || element.name == "edges")
      read_edges(input, element, data, soup.edges);
    else
    {
      ply::refuse_geometry(input, element);
      data.skip(element);
    }
  }
  data.check_end();
  return soup;
}

std::size_t count_filled_lines(Text_input& input)
{
  std::size_t number = 0;
  while(input.next_line())
    number += input.next_word_of_line().empty() ? 0 : 1;
  return number;
}

// The header of a file that has only the elements from one number to another one, where those of all kinds are
// numbered.
ply::Header part_of(ply::Header header, std::size_t begin, std::size_t end)
{
  std::size_t first = 0;
  for(Element& element : header.elements)
  {
    const std::size_t last = first + std::min(element.number, static_cast<std::size_t>(-1) - first);
    element.number = std::min(last, std::max(first, end)) - std::min(last, std::max(first, begin));
    first = last;
  }
  return header;
}

// Reads blocks of a text, each as a file of its own, if there is an element on each line. Returns nothing if there are
// fewer or more words in a block, or anything else is wrong, or there is one block only.
std::optional<Polygon_soup> read_blocks(const Text_blocks& blocks,
                                        const ply::Header& header,
                                        const std::string& vertex_property)
{
  if(blocks.size() < 2)
    return std::nullopt;
  std::vector<std::size_t> begins = blocks.count_before(count_filled_lines);
  begins.push_back(static_cast<std::size_t>(-1));
  std::vector<Polygon_soup> parts(blocks.size());
  try
  {
    run_tasks(blocks.size(), [&](std::size_t i) {
      Text_input block = blocks.input(i);
      parts[i] = read_elements(block, part_of(header, begins[i], begins[i + 1]), vertex_property);
    });
  }
  catch(const Input_error&)
  {
    return std::nullopt; // Where the error is in the file is found by reading all of it.
  }
  return join(std::move(parts));
}

} // namespace

Polygon_soup read_ply(const std::string& path, const std::string& vertex_property)
{
  const File_contents file(path);
  Text_input input(path, file.text());
  const ply::Header header = ply::read_header(input);
  if(header.format == Format::ASCII)
    if(auto soup = read_blocks(Text_blocks(input), header, vertex_property))
      return std::move(*soup);
  return read_elements(input, header, vertex_property);
}

} // namespace reeb_graph_program
