// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of the CGAL-style package Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#include "input/mesh_formats.h"
#include "input/ply_header.h"
#include "input/text_input.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cstdint>
#include <cstring>
#include <iterator>
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
  Data(Text_input& input, Format format) : input_(input), format_(format) {}

  // Each number of these types is a double as well.
  double read(Type type)
  {
    switch(type)
    {
    case Type::INT8: return read_integer<std::int8_t>();
    case Type::UINT8: return read_integer<std::uint8_t>();
    case Type::INT16: return read_integer<std::int16_t>();
    case Type::UINT16: return read_integer<std::uint16_t>();
    case Type::INT32: return read_integer<std::int32_t>();
    case Type::UINT32: return read_integer<std::uint32_t>();
    case Type::FLOAT32: return read_number<float>();
    default: return read_number<double>();
    }
  }

  // Reads a property: one number, or those of a list.
  void read(const Property& property, std::vector<double>& numbers)
  {
    numbers.clear();
    const double size = property.is_list() ? read(property.list_size_type) : 1;
    if(size < 0)
      input_.fail("the size of a list is negative");
    while(static_cast<double>(numbers.size()) < size)
      numbers.push_back(read(property.type));
  }

  void check_end()
  {
    bool is_at_end = true;
    if(format_ == Format::ASCII)
      is_at_end = input_.word_of_file().empty();
    else
      for(char c = ' '; is_at_end && input_.file().get(c);)
        is_at_end = std::isspace(static_cast<unsigned char>(c)) != 0;
    if(!is_at_end)
      input_.fail("there is more in the file than its header says");
  }

private:
  template <class Number>
  double read_integer()
  {
    return static_cast<double>(read_number<Number>());
  }

  template <class Number>
  Number read_number()
  {
    if(format_ == Format::ASCII)
      return input_.number<Number>(input_.word_of_file());
    std::array<char, sizeof(Number)> bytes;
    if(!input_.file().read(bytes.data(), bytes.size()))
      input_.fail("the file ends too early");
    if((format_ == Format::BINARY_BIG_ENDIAN) != is_machine_big_endian())
      std::reverse(bytes.begin(), bytes.end());
    Number number;
    std::memcpy(&number, bytes.data(), bytes.size());
    return number;
  }

  static bool is_machine_big_endian()
  {
    const std::uint16_t number = 1;
    char first = 0;
    std::memcpy(&first, &number, 1);
    return first == 0;
  }

  Text_input& input_;
  Format format_;
};

std::string names_of_numbers(const Element& element)
{
  std::string names;
  for(const Property& property : element.properties)
    if(!property.is_list())
      names += (names.empty() ? "" : ", ") + property.name;
  return names;
}

// The place of the property of the vertices that was asked for.
std::size_t find_scalars(Text_input& input, const Element& element, const std::string& name)
{
  const std::size_t place = element.find({name});
  if(place == element.properties.size())
    input.fail("the vertices have no property " + quote(name) + ", but " + names_of_numbers(element));
  if(element.properties[place].is_list())
    input.fail("the property " + quote(name) + " of the vertices is a list, and no field");
  return place;
}

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
  const std::size_t scalar_place = scalar_name.empty() ? 0 : find_scalars(input, element, scalar_name);
  std::vector<std::vector<double>> numbers(element.properties.size());
  for(std::size_t i = 0; i < element.number; ++i)
  {
    for(std::size_t j = 0; j < numbers.size(); ++j)
      data.read(element.properties[j], numbers[j]);
    soup.points.emplace_back(numbers[places[0]][0], numbers[places[1]][0], numbers[places[2]][0]);
    if(!scalar_name.empty())
      soup.scalars.push_back(numbers[scalar_place][0]);
  }
}

void read_polygons(Text_input& input, const Element& element, Data& data, std::vector<Polygon>& polygons)
{
  const std::size_t place = element.find({"vertex_indices", "vertex_index"});
  if(place == element.properties.size() || !element.properties[place].is_list()
     || !is_integer(element.properties[place].type))
    input.fail("the faces have no list of vertices");
  std::vector<double> numbers;
  for(std::size_t i = 0; i < element.number; ++i)
    for(std::size_t j = 0; j < element.properties.size(); ++j)
    {
      data.read(element.properties[j], numbers);
      if(j != place)
        continue;
      if(std::any_of(numbers.begin(), numbers.end(), [](double v) { return v < 0; }))
        input.fail("face " + std::to_string(polygons.size()) + " has a vertex that does not exist");
      Polygon& polygon = polygons.emplace_back();
      std::transform(numbers.begin(), numbers.end(), std::back_inserter(polygon),
                     [](double v) { return static_cast<std::size_t>(v); });
    }
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
  switch(property.type)
  {
  case Type::INT8: return add_property<std::int8_t>(surface, property.name);
  case Type::UINT8: return add_property<std::uint8_t>(surface, property.name);
  case Type::INT16: return add_property<std::int16_t>(surface, property.name);
  case Type::UINT16: return add_property<std::uint16_t>(surface, property.name);
  case Type::INT32: return add_property<std::int32_t>(surface, property.name);
  case Type::UINT32: return add_property<std::uint32_t>(surface, property.name);
  case Type::FLOAT32: return add_property<float>(surface, property.name);
  default: return add_property<double>(surface, property.name);
  }
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
  Text_input input(path);
  const ply::Header header = ply::read_header(input);
  Data data(input, header.format);
  if(header.format == Format::ASCII)
    input.finish_line(); // that of end_header
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
  Text_input input(path);
  const ply::Header header = ply::read_header(input);
  Data data(input, header.format);
  if(header.format == Format::ASCII)
    input.finish_line(); // that of end_header
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
