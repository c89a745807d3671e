// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_SRC_VERTEX_NUMBERS_H
#define CGAL_REEB_GRAPH_SRC_VERTEX_NUMBERS_H

#include "base/surface.h"

#include <boost/property_map/property_map.hpp>

#include <cstdint>
#include <vector>

namespace reeb_graph_program {
// The numbers by which files know vertices: those of the surface, or others where the surface has the vertices of nodes
// only.
class Vertex_numbers
{
public:
  typedef Surface::Vertex_index key_type;
  typedef std::uint64_t value_type;
  typedef std::uint64_t reference;
  typedef boost::readable_property_map_tag category;

  Vertex_numbers() = default;
  // `numbers` has to outlive this object.
  explicit Vertex_numbers(const std::vector<std::uint64_t>& numbers) : numbers_(&numbers) {}
  explicit Vertex_numbers(const std::vector<std::uint64_t>&&) = delete;

  friend std::uint64_t get(const Vertex_numbers& map, Surface::Vertex_index v)
  {
    return map.numbers_ == nullptr ? v.idx() : (*map.numbers_)[v.idx()];
  }

private:
  const std::vector<std::uint64_t>* numbers_ = nullptr;
};

} // namespace reeb_graph_program

#endif // CGAL_REEB_GRAPH_SRC_VERTEX_NUMBERS_H
