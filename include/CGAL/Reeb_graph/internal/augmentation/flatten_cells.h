// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of the CGAL-style package Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_INTERNAL_AUGMENTATION_FLATTEN_CELLS_H
#define CGAL_REEB_GRAPH_INTERNAL_AUGMENTATION_FLATTEN_CELLS_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/internal/augmentation/Graph_on_soup.h>
#include <CGAL/Reeb_graph/internal/base/named_parameter.h>
#include <CGAL/Reeb_graph/internal/mesh/flatten_soup.h>
#include <CGAL/Reeb_graph/internal/mesh/read_simplices.h>

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

// The complex that `read_complex` makes of the edges of a named parameter, with its field by numbers, after both have
// been checked.
template <class Scalars, class Traits, class NamedParameters, class ReadComplex>
Flat_soup<typename Traits::Scalar> flatten_complex(std::size_t number_of_vertices,
                                                   const Scalars& scalars,
                                                   const Traits& traits,
                                                   const NamedParameters& np,
                                                   const ReadComplex& read_complex)
{
  auto edges = parameters::choose_parameter<std::array<std::array<std::size_t, 2>, 0>>(
    parameters::get_parameter(np, edges_of_soup));
  auto field = flatten_scalars<Sequential_tag>(number_of_vertices, scalars, traits);
  return {std::move(field), read_complex(unwrap_reference(edges))};
}

template <class PointsOrNumber, class Triangles, class Scalars, class Traits, class NamedParameters>
Flat_soup<typename Traits::Scalar> flatten_triangles(const PointsOrNumber& points,
                                                     const Triangles& triangles,
                                                     const Scalars& scalars,
                                                     const Traits& traits,
                                                     const NamedParameters& np)
{
  const std::size_t size = count_vertices(points);
  return flatten_complex(size, scalars, traits, np,
                         [&](const auto& edges) { return read_triangles(size, triangles, edges); });
}

template <class PointsOrNumber, class Tetrahedra, class Scalars, class Traits, class NamedParameters>
Flat_soup<typename Traits::Scalar> flatten_tetrahedra(const PointsOrNumber& points,
                                                      const Tetrahedra& tetrahedra,
                                                      const Scalars& scalars,
                                                      const Traits& traits,
                                                      const NamedParameters& np)
{
  const std::size_t size = count_vertices(points);
  return flatten_complex(size, scalars, traits, np,
                         [&](const auto& edges) { return read_tetrahedra(size, tetrahedra, edges); });
}

} // namespace internal
} // namespace Reeb_graph
} // namespace CGAL

#endif // CGAL_REEB_GRAPH_INTERNAL_AUGMENTATION_FLATTEN_CELLS_H
