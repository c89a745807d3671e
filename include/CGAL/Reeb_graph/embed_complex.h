// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of the CGAL-style package Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_EMBED_COMPLEX_H
#define CGAL_REEB_GRAPH_EMBED_COMPLEX_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/Complex_augmentation.h>
#include <CGAL/Reeb_graph/Embedding.h>
#include <CGAL/Reeb_graph/exceptions.h>
#include <CGAL/Reeb_graph/internal/embedding/Complex_polylines.h>
#include <CGAL/Reeb_graph/internal/embedding/embed_arcs.h>
#include <CGAL/Reeb_graph/named_parameters.h>

#include <boost/property_map/property_map.hpp>

#include <cstddef>
#include <iterator>

namespace CGAL {
namespace Reeb_graph {

/// \ingroup PkgReebGraphEmbedding
///
/// \brief puts the Reeb graph of a triangle soup or of tetrahedra into space, as `embed()` does for a mesh.
///
/// - `CENTROIDS`: a node with arcs above and below is at the centroid of the contours just below it, any other one at
///   its vertex. The centroid of a contour is that of its polylines, by length, or of its triangles, by area.
/// - `ON_SURFACE`: the polyline follows the chain of the arc, and where that passes by the upper node, or by a node
///   that has been removed, the contour just below that, on a way through few triangles. It stays in the complex,
///   unless ties are contracted: then it goes straight where a plateau is passed.
/// - `STRAIGHT`: two points; parallel arcs have the same ones.
/// - `BY_COST`: `CENTROIDS`, or `STRAIGHT` if the contours are long, as for a mesh.
///
/// \tparam ConcurrencyTag `Sequential_tag`, `Parallel_tag`, or `Parallel_if_available_tag`: whether arcs are embedded
///         in parallel; `parametrization_map` is then read by several threads
/// \tparam PointRange a random access range of points of a three-dimensional kernel
///
/// \param augmentation a `Soup_augmentation` or `Tetrahedra_augmentation` of the graph
/// \param points the points of the vertices
/// \param np an optional sequence of \ref bgl_namedparameters "Named Parameters": `embedding_manner`,
///        `number_of_contours`, `number_of_contours_at_nodes`, `number_of_smoothing_steps`, `parametrization_map` and `callback`, as for `embed()`
///
/// \returns an `Embedding` with the type of the points.
///
/// \exception Attribute_count_error if there is not one point for each vertex
/// \exception Graph_mismatch_error if the chain of an arc does not lead to its contours
/// \exception Non_finite_scalar_error if a value of `parametrization_map` along a chain is infinite or NaN
/// \exception Cancelled_error if `callback` returns `false`
template <class ConcurrencyTag = Sequential_tag,
          template <class>
          class ContourOfArc,
          class ReebGraph,
          class Traits,
          class PointRange,
          class NamedParameters = parameters::Default_named_parameters>
auto embed(const Complex_augmentation<ContourOfArc, ReebGraph, Traits>& augmentation,
           const PointRange& points,
           const NamedParameters& np = parameters::default_values())
{
  typedef typename std::iterator_traits<decltype(std::begin(points))>::value_type Point;
  const auto number_of_points = static_cast<std::size_t>(std::end(points) - std::begin(points));
  if(number_of_points != augmentation.number_of_vertices())
    throw Attribute_count_error("points", number_of_points, augmentation.number_of_vertices());
  const auto point_map =
    boost::make_iterator_property_map(std::begin(points), boost::typed_identity_property_map<std::size_t>());
  return internal::embed_in_manner<ConcurrencyTag, Point>(
    augmentation, number_of_points, point_map, np, [&] { return internal::Complex_centroids(augmentation, point_map); },
    [&] { return internal::Complex_polylines(augmentation, point_map); });
}

} // namespace Reeb_graph
} // namespace CGAL

#endif // CGAL_REEB_GRAPH_EMBED_COMPLEX_H
