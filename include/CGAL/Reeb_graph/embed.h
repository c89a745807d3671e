// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_EMBED_H
#define CGAL_REEB_GRAPH_EMBED_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/Augmentation.h>
#include <CGAL/Reeb_graph/internal/base/named_parameter.h>
#include <CGAL/Reeb_graph/internal/way_back/embed_arcs.h>
#include <CGAL/Reeb_graph/named_parameters.h>

namespace CGAL::Reeb_graph {

/// \ingroup PkgReebGraphEmbedding
///
/// \brief puts a Reeb graph into space: finds a point for each node, and for each arc a polyline from node to node.
///
/// The polylines begin and end exactly at the points of the nodes. In the manner `CENTROIDS`, a node with arcs above
/// and below is at the centroid of the contours just below it. A leaf is at its vertex, or, on a mesh, in the middle of
/// the border loop or of the tied vertices around it. In the other manners each node is at its vertex.
///
/// - `CENTROIDS`: the polyline of an arc leads through the centroids, by length or, in tetrahedra, by area, of `number_of_contours` contours, at
///   equal steps of the field. Two arcs of the same nodes can have lines that coincide, as a tube inside of a round
///   tube. If they are nowhere further apart than 1.5 percent of the extent of all contours, about the width of a line
///   in a picture, they are moved halfway to the surface. It takes time proportional to the lengths of these contours
///   and of those just below the nodes, and to the square of the number of arcs that join the same two nodes.
/// - `ON_SURFACE`: the polyline follows the chain of the arc. Where that passes by the upper node, or by a node that
///   has been removed, it goes on along the contour just below that, the shortest way along its lines, or along the sides of
///   its triangles. It stays on the surface, and its values ascend, and stay the same on this part of a contour. Where
///   it passes a plateau of a complex, as ties are contracted, it goes straight, and can leave the complex. It takes
///   time near-linear in the lengths of the chains and of these contours.
/// - `STRAIGHT`: the polyline has two points; parallel arcs have the same ones.
/// - `BY_COST`: `STRAIGHT` if the contours of `CENTROIDS` cross more than 64 edges for each vertex of the mesh, and
///   \f$ 2^{20} \f$ besides; otherwise `CENTROIDS`. Finding out crosses no more edges than that. The result says which
///   manner it is, which does not depend on threads.
///
/// \tparam ConcurrencyTag `Sequential_tag`, `Parallel_tag`, or `Parallel_if_available_tag`: whether arcs are embedded
///         in parallel; the point map and `parametrization_map` are then read by several threads
///
/// \param augmentation an `Augmentation`, `Soup_augmentation`, or `Tetrahedra_augmentation`: the way from the graph
/// \param points the points of the vertices, which are those of a three-dimensional kernel, as
///        `Basic_augmentation::points_of_contour()` takes them. For a mesh, the named parameters can stand in this place
/// \param np an optional sequence of \ref bgl_namedparameters "Named Parameters" among the ones listed below
///
/// \cgalNamedParamsBegin
///   \cgalParamNBegin{embedding_manner}
///     \cgalParamDescription{the way of the arcs}
///     \cgalParamType{`Reeb_graph::Embedding_manner`}
///     \cgalParamDefault{`Embedding_manner::BY_COST`}
///   \cgalParamNEnd
///   \cgalParamNBegin{number_of_contours}
///     \cgalParamDescription{for `CENTROIDS`: the number of contours that the polyline of an arc leads through; 0 gives
///                           straight lines}
///     \cgalParamType{`std::size_t`}
///     \cgalParamDefault{12}
///   \cgalParamNEnd
///   \cgalParamNBegin{number_of_contours_at_nodes}
///     \cgalParamDescription{for `CENTROIDS`: the number of further contours between each node and the next one of
///                           these contours, each a quarter as far from the node as the one before. The contours of a
///                           saddle have another centroid than those just beyond it. With further contours, a line goes
///                           from the saddle to the middle of its own contours first, and does not leave the surface.}
///     \cgalParamType{`std::size_t`}
///     \cgalParamDefault{0}
///   \cgalParamNEnd
///   \cgalParamNBegin{number_of_smoothing_steps}
///     \cgalParamDescription{for `CENTROIDS`: the number of times that each inner point of a polyline is replaced by
///                           the mean of itself and of the middle of its neighbors}
///     \cgalParamType{`std::size_t`}
///     \cgalParamDefault{0}
///   \cgalParamNEnd
///   \cgalParamNBegin{parametrization_map}
///     \cgalParamDescription{for `CENTROIDS`: another field, whose differences along the chain of the arc are the steps
///                           between contours, as for `Augmentation::contour()`; that takes time proportional to the
///                           length of the chain for each contour}
///     \cgalParamType{a model of `ReadablePropertyMap` with the vertices as key type, and a value type that can be converted to `double`}
///     \cgalParamDefault{equal steps of the field itself}
///   \cgalParamNEnd
///   \reebGraphPoints{ReadablePropertyMap}
///   \reebGraphCallback
/// \cgalNamedParamsEnd
///
/// \pre The graph is that of the mesh and the field.
///
/// \reebGraphComplexity
///
/// \returns an `Embedding` with the type of the points.
///
/// \exception Attribute_count_error if points are a range, and not one for each vertex
/// \exception Graph_mismatch_error if the chain of an arc does not lead to its contours
/// \exception Non_finite_scalar_error if a value of `parametrization_map` along a chain is infinite or NaN
/// \exception Cancelled_error if `callback` returns `false`
template <class ConcurrencyTag = Sequential_tag,
          class GraphOnMesh,
          class Points = parameters::Default_named_parameters,
          class NamedParameters = parameters::Default_named_parameters>
auto embed(const Basic_augmentation<GraphOnMesh>& augmentation,
           const Points& points = parameters::default_values(),
           const NamedParameters& np = parameters::default_values())
{
  const auto point_map = augmentation.on_mesh().point_map(points);
  if constexpr(internal::are_named_parameters<Points>)
    return internal::embed_in_manner<ConcurrencyTag>(augmentation, point_map, points);
  else
    return internal::embed_in_manner<ConcurrencyTag>(augmentation, point_map, np);
}

} // namespace CGAL::Reeb_graph

#endif // CGAL_REEB_GRAPH_EMBED_H
