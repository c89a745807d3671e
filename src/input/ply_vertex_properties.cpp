// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#include "base/vertex_properties.h"
#include "input/File_contents.h"
#include "input/mesh_formats.h"
#include "input/ply_header.h"
#include "input/text_input.h"
#include "input/vtk_numbers.h"

#include <algorithm>
#include <cstdint>
#include <limits>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

namespace reeb_graph_program {
namespace {
using ply::Data;
using ply::Element;
using ply::Property;

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
    const auto map = add_property<decltype(number)>(surface, field.name);
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

void read_vertex_properties(const Element& element,
                            Data& data,
                            Surface& surface,
                            std::vector<Any_vertex_property>& result)
{
  std::set<std::string> names = other_names(surface);
  std::vector<std::optional<Any_vertex_property>> maps;
  for(const Property& property : element.properties)
  {
    const bool is_kept = !property.is_list() && names.insert(property.name).second;
    maps.push_back(is_kept ? std::make_optional(add_property(surface, property)) : std::nullopt);
  }
  std::vector<double> numbers;
  const std::size_t number_of_vertices = number_of_given_vertices(surface);
  for(std::size_t i = 0; i < number_of_vertices; ++i)
    for(std::size_t j = 0; j < maps.size(); ++j)
    {
      const Surface::Vertex_index v(static_cast<Surface::size_type>(i));
      data.read(element.properties[j], numbers);
      const auto store = [&](const auto& map) {
        map[v] = static_cast<typename std::decay_t<decltype(map)>::value_type>(numbers.front());
      };
      if(maps[j])
        std::visit(store, *maps[j]);
    }
  for(const auto& map : maps)
    if(map)
    {
      std::visit([&](const auto& numbers_of_map) { set_added_vertices(surface, numbers_of_map); }, *map);
      result.push_back(*map);
    }
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
    if(!element.is_vertex())
    {
      data.skip(element);
      continue;
    }
    read_vertex_properties(element, data, surface, properties);
    break;
  }
  return properties;
}

std::vector<Any_vertex_property> read_vertex_properties(const std::string& path, Surface& surface)
{
  const std::string extension = lower_case_extension(path);
  if(extension == ".ply")
    return read_ply_vertex_properties(path, surface);
  std::vector<Any_vertex_property> properties;
  if(extension != ".vtk" && extension != ".vtu" && extension != ".vtp")
    return properties;
  std::set<std::string> names = other_names(surface);
  Field_names unused;
  for(const Vertex_field& field : read_vtk_fields(path, unused))
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

} // namespace reeb_graph_program
