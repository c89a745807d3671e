// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#include "base/surface.h"
#include "base/threads.h"
#include "input/File_contents.h"
#include "input/mesh_formats.h"
#include "input/number_types.h"
#include "input/ply_header.h"
#include "input/text_input.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cstdint>
#include <limits>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

namespace reeb_graph_program {
namespace ply {
namespace {
Number_type read_type(Text_input& input)
{
  const std::string_view word = input.word_of_line();
  const Number_type type = number_type(ply_spellings, word);
  if(type == Number_type::NONE)
    input.fail(quote(word) + " is not a type of a property");
  return type;
}

Format read_format(Text_input& input)
{
  const std::string format(input.word_of_line());
  if(format != "ascii" && format != "binary_little_endian" && format != "binary_big_endian")
    input.fail(quote(format) + " is not a format of a PLY file");
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
      input.fail("the size of a list is not an integer");
  }
  property.type = read_type(input);
  property.name = input.word_of_line();
  if(property.name.empty())
    input.fail("a property has no name");
  return property;
}

} // namespace

std::size_t find_scalars(const Text_input& input,
                         const Header& header,
                         const Element& vertices,
                         const std::string& name)
{
  const std::size_t place = vertices.find({name});
  if(place == vertices.properties.size())
  {
    Field_names names;
    for(const Element& element : header.elements)
      for(const Property& property : element.properties)
        if((element.is_vertex() || element.is_face()) && !property.is_list())
          names.add(element.is_face(), property.name, 1);
    input.fail(names.message(name, "faces"));
  }
  if(vertices.properties[place].is_list())
    input.fail("the property " + quote(name) + " of the vertices is a list, and not a field");
  return place;
}

void refuse_geometry(const Text_input& input, const Element& element)
{
  const bool has_vertices = element.find({"vertex_index", "vertex1", "v1"}) != element.properties.size();
  const bool has_list = std::any_of(element.properties.begin(), element.properties.end(), [](const Property& property) {
    return property.is_list() && is_integer(property.type);
  });
  if(element.number > 0 && (has_list || has_vertices))
    input.fail("the element " + quote(element.name) + (has_list ? " has lists" : " has vertices")
               + ", and is not read: a mesh is one of the elements vertex, face, tristrips, and edge");
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
      input.fail(quote(keyword) + " has no place here in the header of a PLY file");
  }
  input.fail("the header does not end");
}

} // namespace ply

namespace {
using ply::Data;
using ply::Element;
using ply::Property;

// Names of what is read otherwise, and those that the surface has for other types, or for its field.
std::set<std::string> other_names(const Surface& surface)
{
  std::set<std::string> names = {"x", "y", "z", "point", "connectivity", "removed", "normal", "color"};
  if(find_vertex_property<double>(surface, "v:scalar"))
    names.insert("scalar");
  return names;
}

// PLY has no whole numbers of 64 bits. They become those of 32 bits if they fit.
Any_vertex_property add_property(Surface& surface, const Vertex_field& field)
{
  const auto add = [&](auto number) -> Any_vertex_property {
    const auto map = surface.add_property_map<Surface::Vertex_index, decltype(number)>("v:" + field.name).first;
    for(std::size_t v = 0; v < field.numbers.size(); ++v)
      map[Surface::Vertex_index(static_cast<Surface::size_type>(v))] = static_cast<decltype(number)>(field.numbers[v]);
    set_added_vertices(surface, map);
    return map;
  };
  Any_vertex_property property;
  call_with_vtk_type(field.type, [&](auto number) {
    if constexpr(std::is_integral_v<decltype(number)> && sizeof number == 8)
    {
      const bool do_fit = std::all_of(field.numbers.begin(), field.numbers.end(), [](double n) {
        return n >= std::numeric_limits<std::int32_t>::min() && n <= std::numeric_limits<std::int32_t>::max();
      });
      property = do_fit ? add(std::int32_t()) : add(double());
    }
    else
      property = add(number);
  });
  return property;
}

// Those of the first vertices that the file has.
std::vector<Vertex_field> read_ply_fields(const std::string& path)
{
  const File_contents file(path);
  Text_input input(path, file.text());
  const ply::Header header = ply::read_header(input);
  Data data(input, header.format);
  std::vector<Vertex_field> fields;
  for(const Element& element : header.elements)
  {
    if(!element.is_vertex())
    {
      data.skip(element);
      continue;
    }
    std::vector<double> numbers;
    for(const Property& property : element.properties)
      if(!property.is_list())
        fields.push_back({property.name, std::string(xml_spellings[0][std::size_t(property.type)]), {}});
    for(std::size_t i = 0; i < element.number; ++i)
    {
      auto field = fields.begin();
      for(const Property& property : element.properties)
      {
        data.read(property, numbers);
        if(!property.is_list())
          (field++)->numbers.push_back(numbers.front());
      }
    }
    break;
  }
  return fields;
}

} // namespace

std::vector<Any_vertex_property> read_vertex_properties(const std::string& path, Surface& surface)
{
  const std::string extension = lower_case_extension(path);
  std::vector<Any_vertex_property> properties;
  if(extension != ".ply" && extension != ".vtk" && extension != ".vtu" && extension != ".vtp")
    return properties;
  std::set<std::string> names = other_names(surface);
  Field_names unused;
  for(const Vertex_field& field : extension == ".ply" ? read_ply_fields(path) : read_vtk_fields(path, unused))
    if(names.insert(field.name).second)
      properties.push_back(add_property(surface, field));
  return properties;
}

std::vector<std::string> parts_not_kept(const std::string& path)
{
  const std::string extension = lower_case_extension(path);
  std::vector<std::string> parts;
  if(extension != ".obj" && extension != ".off")
    return parts;
  const File_contents file(path);
  Text_input input(path, file.text());
  const std::string_view first = input.word_of_file();
  if(extension == ".off") // as in STCNOFF
    for(const auto& [letters, part] :
        {std::pair("ST", "textures"), std::pair("C", "colors"), std::pair("N", "normals")})
      if(first.substr(0, std::min(first.find("OFF"), first.size())).find(letters) != std::string_view::npos)
        parts.emplace_back(part);
  std::set<std::string_view> keywords = {first};
  while(extension == ".obj" && input.next_line())
    keywords.insert(input.word_of_line());
  for(const auto& [keyword, part] :
      {std::pair("vt", "textures"), std::pair("vn", "normals"), std::pair("usemtl", "materials")})
    if(keywords.count(keyword) != 0)
      parts.emplace_back(part);
  return parts;
}

std::vector<std::string> fields_not_kept(const std::string& path, bool has_room)
{
  Field_names names;
  const std::string extension = lower_case_extension(path);
  if(extension == ".ply")
  {
    const std::set<std::string> others = {"x", "y", "z", "vertex_indices", "vertex_index"};
    const File_contents file(path);
    Text_input input(path, file.text());
    for(const Element& element : ply::read_header(input).elements)
      for(const Property& property : element.properties)
        if((element.is_vertex() || element.is_face()) && others.count(property.name) == 0)
          names.add(element.is_face(), property.name, property.is_list() ? 0 : 1);
  }
  else if(extension == ".vtk" || extension == ".vtu" || extension == ".vtp")
    read_vtk_fields(path, names);
  std::vector<std::string> result = has_room ? names.others_of_vertices : names.of_vertices;
  for(const std::string& name : names.of_cells)
    result.push_back(name + " of faces");
  return result;
}

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
  call_with_number(list.type, read_all);
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
  const double end_of_strip = element.properties[place].type == Number_type::UINT32 ? 4294967295. : -1;
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
