// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#include "input/ply_header.h"

#include "input/mesh_formats.h"

#include <array>
#include <utility>

namespace reeb_graph_program::ply {
namespace {
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
    input.fail(quote(word) + " is not a type of a property");
  return type->second;
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

} // namespace reeb_graph_program::ply
