// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of the CGAL-style package Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#include "input/File_contents.h"
#include "input/binary_numbers.h"
#include "input/mesh_formats.h"
#include "input/ply_header.h"
#include "input/text_input.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cstdint>
#include <cstring>
#include <optional>
#include <set>
#include <string>
#include <type_traits>
#include <variant>
#include <vector>

namespace reeb_graph_program {
namespace {
using ply::Element;
using ply::Format;
using ply::Property;
using ply::Type;

// The numbers behind the header.
class Data
{
public:
  Data(Text_input& input, Format format) : input_(input), bytes_(input.rest()), format_(format)
  {
    if(format == Format::ASCII)
      input.finish_line(); // that of end_header
  }

  // Each number of these types is a double as well.
  double read(Type type)
  {
    if(format_ == Format::ASCII)
      return read_word(type);
    const std::size_t size = ply::size_in_bytes(type);
    if(bytes_.size() < size)
      input_.fail("the file ends too early");
    const char* const first = bytes_.data();
    bytes_.remove_prefix(size);
    const bool is_order_reversed = is_reversed();
    return ply::call_with_number(type, [&](auto n) -> double { return decode<decltype(n)>(first, is_order_reversed); });
  }

  // Reads a property: one number, or those of a list.
  void read(const Property& property, std::vector<double>& numbers)
  {
    numbers.clear();
    const double size = property.is_list() ? read_list_size(property) : 1;
    while(static_cast<double>(numbers.size()) < size)
      numbers.push_back(read(property.type));
  }

  double read_list_size(const Property& property)
  {
    const double size = read(property.list_size_type);
    if(size < 0)
      input_.fail("the size of a list is negative");
    return size;
  }

  void check_end()
  {
    const bool is_at_end = format_ == Format::ASCII ? input_.word_of_file().empty()
                                                    : std::all_of(bytes_.begin(), bytes_.end(),
                                                                  [](unsigned char c) { return std::isspace(c) != 0; });
    if(!is_at_end)
      input_.fail("there is more in the file than its header says");
  }

private:
  double read_word(Type type)
  {
    const std::string_view word = input_.word_of_file();
    return ply::call_with_number(type, [&](auto n) -> double { return input_.number<decltype(n)>(word); });
  }

  bool is_reversed() const { return (format_ == Format::BINARY_BIG_ENDIAN) != is_machine_big_endian(); }

  Text_input& input_;
  std::string_view bytes_; // that have not been read, of a binary file
  Format format_;
};

void read_points(Text_input& input,
                 const Element& element,
                 const std::string& scalar_name,
                 Data& data,
                 Polygon_soup& soup)
{
  const std::array<std::size_t, 3> places = {element.find({"x"}), element.find({"y"}), element.find({"z"})};
  for(const std::size_t place : places)
    if(place == element.properties.size() || element.properties[place].is_list())
      input.fail("the vertices have no x, y and z");
  const std::size_t scalar_place = scalar_name.empty() ? 0 : ply::find_scalars(input, element, scalar_name);
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
  const double size = data.read_list_size(property);
  bool is_any_negative = false;
  for(double i = 0; i < size; ++i)
  {
    const double v = data.read(property.type);
    is_any_negative = is_any_negative || v < 0;
    polygons.add_corner(v < 0 ? too_large_corner : static_cast<std::size_t>(v));
  }
  if(is_any_negative)
    input.fail("face " + std::to_string(polygons.size()) + " has a vertex that does not exist");
  polygons.end_polygon();
}

void read_polygons(Text_input& input, const Element& element, Data& data, Polygons& polygons)
{
  const std::size_t place = element.find({"vertex_indices", "vertex_index"});
  if(place == element.properties.size() || !element.properties[place].is_list()
     || !is_integer(element.properties[place].type))
    input.fail("the faces have no list of vertices");
  std::vector<double> ignored;
  for(std::size_t i = 0; i < element.number; ++i)
    for(std::size_t j = 0; j < element.properties.size(); ++j)
      if(j == place)
        read_polygon(input, element.properties[j], data, polygons);
      else
        data.read(element.properties[j], ignored);
}

void skip(const Element& element, Data& data)
{
  std::vector<double> ignored;
  for(std::size_t i = 0; i < element.number && !element.properties.empty(); ++i)
    for(const Property& property : element.properties)
      data.read(property, ignored);
}

bool is_vertex_element(const Element& element) { return element.name == "vertex" || element.name == "vertices"; }

template <class Number>
Vertex_property<Number> add_property(Surface& surface, const std::string& name)
{
  return surface.add_property_map<Surface::Vertex_index, Number>("v:" + name).first;
}

Any_vertex_property add_property(Surface& surface, const Property& property)
{
  return ply::call_with_number(property.type, [&](auto number) -> Any_vertex_property {
    return add_property<decltype(number)>(surface, property.name);
  });
}

void read_vertex_properties(const Element& element,
                            Data& data,
                            Surface& surface,
                            std::vector<Any_vertex_property>& result)
{
  // those that are read otherwise, and names that the surface has for other types
  std::set<std::string> names = {"x", "y", "z", "scalar", "point", "connectivity", "removed", "normal", "color"};
  std::vector<std::optional<Any_vertex_property>> maps;
  for(const Property& property : element.properties)
  {
    const bool is_kept = !property.is_list() && names.insert(property.name).second;
    maps.push_back(is_kept ? std::make_optional(add_property(surface, property)) : std::nullopt);
  }
  std::vector<double> numbers;
  for(const Surface::Vertex_index v : surface.vertices())
    for(std::size_t j = 0; j < maps.size(); ++j)
    {
      data.read(element.properties[j], numbers);
      const auto store = [&](const auto& map) {
        map[v] = static_cast<typename std::decay_t<decltype(map)>::value_type>(numbers.front());
      };
      if(maps[j])
        std::visit(store, *maps[j]);
    }
  for(const auto& map : maps)
    if(map)
      result.push_back(*map);
}

} // namespace

std::vector<Any_vertex_property> read_ply_vertex_properties(const std::string& path, Surface& surface)
{
  const File_contents file(path);
  Text_input input(path, file.text());
  const ply::Header header = ply::read_header(input);
  Data data(input, header.format);
  std::vector<Any_vertex_property> properties;
  for(const Element& element : header.elements)
  {
    if(!is_vertex_element(element))
    {
      skip(element, data);
      continue;
    }
    read_vertex_properties(element, data, surface, properties);
    break;
  }
  return properties;
}

Polygon_soup read_ply(const std::string& path, const std::string& vertex_property)
{
  const File_contents file(path);
  Text_input input(path, file.text());
  const ply::Header header = ply::read_header(input);
  Data data(input, header.format);
  Polygon_soup soup;
  for(const Element& element : header.elements)
  {
    if(is_vertex_element(element))
      read_points(input, element, vertex_property, data, soup);
    else if(element.name == "face" || element.name == "faces")
      read_polygons(input, element, data, soup.polygons);
    else
      skip(element, data);
  }
  data.check_end();
  return soup;
}

} // namespace reeb_graph_program
