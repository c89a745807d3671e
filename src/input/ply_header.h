// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_SRC_PLY_HEADER_H
#define CGAL_REEB_GRAPH_SRC_PLY_HEADER_H

#include "input/text_input.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <string>
#include <string_view>
#include <vector>

namespace reeb_graph_program {
// The header of a PLY file.
namespace ply {
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

  bool is_vertex() const { return name == "vertex" || name == "vertices"; }
  bool is_face() const { return name == "face" || name == "faces"; }

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

inline bool is_integer(Type type) { return type < Type::FLOAT32; }

// Calls the function with a number of the type.
template <class Function>
auto call_with_number(Type type, const Function& function)
{
  switch(type)
  {
  case Type::INT8: return function(std::int8_t(0));
  case Type::UINT8: return function(std::uint8_t(0));
  case Type::INT16: return function(std::int16_t(0));
  case Type::UINT16: return function(std::uint16_t(0));
  case Type::INT32: return function(std::int32_t(0));
  case Type::UINT32: return function(std::uint32_t(0));
  case Type::FLOAT32: return function(float(0));
  default: return function(double(0));
  }
}

inline std::size_t size_in_bytes(Type type)
{
  return call_with_number(type, [](auto number) { return sizeof(number); });
}

// Reads the header from its first line on, up to the line that ends it. Throws Input_error if it is none, as if a
// property belongs to no element.
Header read_header(Text_input& input);

// The place of the property of these vertices that is asked for as field. Throws Input_error if there is none.
std::size_t find_scalars(const Text_input& input,
                         const Header& header,
                         const Element& vertices,
                         const std::string& name);

// Throws Input_error for an element that may be a part of the mesh: it has lists of integers, or vertices.
void refuse_geometry(const Text_input& input, const Element& element);

} // namespace ply

} // namespace reeb_graph_program

#endif // CGAL_REEB_GRAPH_SRC_PLY_HEADER_H
