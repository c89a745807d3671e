// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of the CGAL-style package Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_INTERNAL_WAY_BACK_FLATTEN_CELLS_H
#define CGAL_REEB_GRAPH_INTERNAL_WAY_BACK_FLATTEN_CELLS_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/internal/base/named_parameter.h>
#include <CGAL/Reeb_graph/internal/complex/flatten_soup.h>
#include <CGAL/Reeb_graph/named_parameters.h>
#include <CGAL/Reeb_graph_soup_traits.h>

#include <CGAL/tags.h>

#include <array>
#include <cstddef>
#include <iterator>
#include <type_traits>
#include <utility>

namespace CGAL {
namespace Reeb_graph {
namespace internal {

template <class Range>
using Value_of_range = std::decay_t<decltype(*std::begin(std::declval<const Range&>()))>;

// The traits class of a soup with these values: the type of the named parameter, if that is given.
template <class Scalars, class NamedParameters>
using Soup_traits_of = Chosen_traits<Reeb_graph_soup_traits<Value_of_range<Scalars>>, NamedParameters>;

// The complex of triangles or of tetrahedra, by their number of vertices, and of the edges of a named parameter, with
// its field by numbers, after both have been checked.
template <int vertices_per_cell, class PointsOrNumber, class Cells, class Scalars, class Traits, class NamedParameters>
Flat_soup<typename Traits::Scalar> flatten_cells(const PointsOrNumber& points,
                                                 const Cells& cells,
                                                 const Scalars& scalars,
                                                 const Traits& traits,
                                                 const NamedParameters& np)
{
  const std::size_t size = count_vertices(points);
  auto edges_parameter = parameters::choose_parameter<std::array<std::array<std::size_t, 2>, 0>>(
    parameters::get_parameter(np, edges_of_soup));
  const auto& edges = unwrap_reference(edges_parameter);
  return flatten_soup<Sequential_tag>(size, scalars, traits, [&] {
    if constexpr(vertices_per_cell == 3)
      return read_triangles(size, cells, edges);
    else
      return read_tetrahedra(size, cells, edges);
  });
}

} // namespace internal
} // namespace Reeb_graph
} // namespace CGAL

#endif // CGAL_REEB_GRAPH_INTERNAL_WAY_BACK_FLATTEN_CELLS_H
