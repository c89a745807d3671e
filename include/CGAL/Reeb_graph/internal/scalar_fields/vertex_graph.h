// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of the CGAL-style package Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_INTERNAL_SCALAR_FIELDS_VERTEX_GRAPH_H
#define CGAL_REEB_GRAPH_INTERNAL_SCALAR_FIELDS_VERTEX_GRAPH_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/internal/scalar_fields/Weighted_graph.h>

#include <CGAL/boost/graph/iterator.h>
#include <CGAL/boost/graph/properties.h>

#include <cstddef>
#include <type_traits>
#include <vector>

// A field and the edges of its mesh by positions in vertices(mesh), for what needs neither faces nor points.

namespace CGAL {
namespace Reeb_graph {
namespace internal {
namespace scalar_fields {

template <class Mesh, class ScalarMap>
auto read_values_of_vertices(const Mesh& mesh, const ScalarMap& scalar_map)
{
  typedef std::decay_t<typename boost::property_traits<ScalarMap>::value_type> Scalar;
  std::vector<Scalar> values;
  for(const auto v : CGAL::make_range(vertices(mesh)))
    values.push_back(get(scalar_map, v));
  return values;
}

template <class Mesh>
auto make_position_map(const Mesh& mesh)
{
  auto positions = get(dynamic_vertex_property_t<Position>(), mesh);
  Position position = 0;
  for(const auto v : CGAL::make_range(vertices(mesh)))
    put(positions, v, position++);
  return positions;
}

// The edges have the weight 1.
template <class Mesh, class PositionMap>
Weighted_graph make_vertex_graph(const Mesh& mesh, const PositionMap& positions, std::size_t number_of_vertices)
{
  return Weighted_graph(number_of_vertices, [&](const auto& visit) {
    for(const auto e : CGAL::make_range(edges(mesh)))
    {
      const Position u = get(positions, source(e, mesh)), v = get(positions, target(e, mesh));
      visit(Weighted_graph::Contribution{u, v, 1});
      visit(Weighted_graph::Contribution{v, u, 1});
    }
  });
}

} // namespace scalar_fields
} // namespace internal
} // namespace Reeb_graph
} // namespace CGAL

#endif // CGAL_REEB_GRAPH_INTERNAL_SCALAR_FIELDS_VERTEX_GRAPH_H
