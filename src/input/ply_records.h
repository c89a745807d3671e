// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_SRC_PLY_RECORDS_H
#define CGAL_REEB_GRAPH_SRC_PLY_RECORDS_H

#include "input/binary_numbers.h"
#include "input/ply_header.h"

#include <cstddef>

namespace reeb_graph_program {
// The elements of a binary PLY file whose faces are triangles, as records of one size.
namespace ply {
// All lists have three numbers in a file of triangles.
inline std::size_t size_in_record(const Property& property)
{
  const std::size_t size = size_in_bytes(property.type);
  return property.is_list() ? size_in_bytes(property.list_size_type) + 3 * size : size;
}

inline std::size_t offset_in_record(const Element& element, std::size_t place)
{
  std::size_t offset = 0;
  for(std::size_t i = 0; i < place; ++i)
    offset += size_in_record(element.properties[i]);
  return offset;
}

inline double decode_number(Type type, const char* bytes, bool is_reversed)
{
  return call_with_number(type, [&](auto n) -> double { return decode<decltype(n)>(bytes, is_reversed); });
}

// Reads numbers of one property out of records.
class Column
{
public:
  Column(const Element& element, std::size_t place, bool is_reversed)
    : offset_(offset_in_record(element, place)),
      type_(element.properties[place].type),
      is_reversed_(is_reversed)
  {}

  double operator()(const char* record) const { return decode_number(type_, record + offset_, is_reversed_); }

private:
  std::size_t offset_;
  Type type_;
  bool is_reversed_;
};

} // namespace ply

} // namespace reeb_graph_program

#endif // CGAL_REEB_GRAPH_SRC_PLY_RECORDS_H
