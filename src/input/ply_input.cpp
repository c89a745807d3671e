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
#include <cctype>
#include <cstdint>
#include <cstring>
#include <initializer_list>
#include <iterator>
#include <string_view>
#include <utility>
#include <vector>

namespace reeb_graph_program {
namespace {
enum class Format
{
  ASCII,
  BINARY_LITTLE_ENDIAN,
  BINARY_BIG_ENDIAN
};

enum class Type
{
  INT8,
  UINT8,
  INT16,
  UINT16,
  INT32,
  UINT32,
  FLOAT32,
  FLOAT64,
  NONE
};

struct Property
{
  Type list_size_type = Type::NONE; // NONE if the property is a single number
  Type type = Type::NONE;
  std::string name;

  bool is_list() const { return list_size_type != Type::NONE; }
};

struct Element
{
  std::string name;
  std::size_t number = 0;
  std::vector<Property> properties;

  // The place of the first property that has one of the names, the number of properties if there is none.
  std::size_t find(std::initializer_list<std::string_view> names) const
  {
    const auto is_named = [&](const Property& p) {
      return std::find(names.begin(), names.end(), p.name) != names.end();
    };
    return static_cast<std::size_t>(std::find_if(properties.begin(), properties.end(), is_named) - properties.begin());
  }
};

struct Header
{
  Format format = Format::ASCII;
  std::vector<Element> elements;
};

bool is_integer(Type type) { return type < Type::FLOAT32; }

Type read_type(Text_input& input)
{
  typedef std::pair<std::string_view, Type> Named_type;
  static constexpr std::array<Named_type, 16> types = {{{"char", Type::INT8},
                                                        {"int8", Type::INT8},
                                                        {"uchar", Type::UINT8},
                                                        {"uint8", Type::UINT8},
                                                        {"short", Type::INT16},
                                                        {"int16", Type::INT16},
                                                        {"ushort", Type::UINT16},
                                                        {"uint16", Type::UINT16},
                                                        {"int", Type::INT32},
                                                        {"int32", Type::INT32},
                                                        {"uint", Type::UINT32},
                                                        {"uint32", Type::UINT32},
                                                        {"float", Type::FLOAT32},
                                                        {"float32", Type::FLOAT32},
                                                        {"double", Type::FLOAT64},
                                                        {"float64", Type::FLOAT64}}};
  const std::string_view word = input.word_of_line();
  const auto type = std::find_if(types.begin(), types.end(), [&](const Named_type& t) { return t.first == word; });
  if(type == types.end())
    input.fail("'" + std::string(word) + "' is no type of a property");
  return type->second;
}

Format read_format(Text_input& input)
{
  const std::string format(input.word_of_line());
  if(format != "ascii" && format != "binary_little_endian" && format != "binary_big_endian")
    input.fail("'" + format + "' is no format of a PLY file");
  return format == "ascii"                ? Format::ASCII
       : format == "binary_little_endian" ? Format::BINARY_LITTLE_ENDIAN
                                          : Format::BINARY_BIG_ENDIAN;
}

Element read_element(Text_input& input)
{
  Element element;
  element.name = input.word_of_line();
  element.number = input.number<std::size_t>(input.word_of_line());
  return element;
}

Property read_property(Text_input& input)
{
  Property property;
  if(input.next_word_of_line() == "list")
  {
    input.word_of_line();
    property.list_size_type = read_type(input);
    if(!is_integer(property.list_size_type))
      input.fail("the size of a list is no integer");
  }
  property.type = read_type(input);
  property.name = input.word_of_line();
  if(property.name.empty())
    input.fail("a property has no name");
  return property;
}

Header read_header(Text_input& input)
{
  if(!input.next_line() || input.word_of_line() != "ply")
    input.fail("the file does not begin as a PLY file");
  Header header;
  bool has_format = false;
  while(input.next_line())
  {
    const std::string keyword(input.word_of_line());
    if(keyword == "end_header" && has_format)
      return header;
    if(keyword == "format" && !has_format)
    {
      header.format = read_format(input);
      has_format = true;
    }
    else if(keyword == "element")
      header.elements.push_back(read_element(input));
    else if(keyword == "property" && !header.elements.empty())
      header.elements.back().properties.push_back(read_property(input));
    else if(keyword != "comment" && keyword != "obj_info")
      input.fail("'" + keyword + "' has no place here in the header of a PLY file");
  }
  input.fail("the header does not end");
}

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

void read_points(Text_input& input, const Element& element, Data& data, std::vector<Point>& points)
{
  const std::array<std::size_t, 3> places = {element.find({"x"}), element.find({"y"}), element.find({"z"})};
  for(const std::size_t place : places)
    if(place == element.properties.size() || element.properties[place].is_list())
      input.fail("the vertices have no x, y and z");
  std::vector<std::vector<double>> numbers(element.properties.size());
  for(std::size_t i = 0; i < element.number; ++i)
  {
    for(std::size_t j = 0; j < numbers.size(); ++j)
      data.read(element.properties[j], numbers[j]);
    points.emplace_back(numbers[places[0]][0], numbers[places[1]][0], numbers[places[2]][0]);
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

} // namespace

Polygon_soup read_ply(const std::string& path)
{
  Text_input input(path);
  const Header header = read_header(input);
  Data data(input, header.format);
  if(header.format == Format::ASCII)
    input.finish_line(); // that of end_header
  Polygon_soup soup;
  for(const Element& element : header.elements)
  {
    if(element.name == "vertex" || element.name == "vertices")
      read_points(input, element, data, soup.points);
    else if(element.name == "face" || element.name == "faces")
      read_polygons(input, element, data, soup.polygons);
    else
      skip(element, data);
  }
  data.check_end();
  return soup;
}

} // namespace reeb_graph_program
