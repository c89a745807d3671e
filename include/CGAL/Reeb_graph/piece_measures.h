// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of the CGAL-style package Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_PIECE_MEASURES_H
#define CGAL_REEB_GRAPH_PIECE_MEASURES_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/internal/base/named_parameter.h>
#include <CGAL/Reeb_graph/internal/base/requirements.h>

#include <CGAL/boost/graph/iterator.h>
#include <CGAL/boost/graph/named_params_helper.h>
#include <CGAL/boost/graph/properties.h>
#include <CGAL/number_utils.h>

#include <boost/graph/graph_traits.hpp>

#include <array>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <vector>

namespace CGAL::Reeb_graph {
namespace internal {

// Adds equal parts of the measure of a face, or of a cell, to the pieces of its vertices.
template <class VertexLocations, class VertexRange>
void add_to_pieces(double measure,
                   const VertexRange& vertices,
                   const VertexLocations& locations,
                   std::vector<double>& pieces)
{
  for(const auto v : vertices)
    pieces.at(locations.index(v)) += measure / static_cast<double>(std::size(vertices));
}

} // namespace internal

/// \ingroup PkgReebGraphAugmentation
///
/// \brief counts the vertices of the mesh that belong to each node and to each arc of a Reeb graph: weights for
/// `simplify()`, as named parameter `piece_weights`.
///
/// \param mesh the mesh
/// \param graph the Reeb graph
/// \param locations what `Augmentation::locate_vertices()` has returned for the two
///
/// \returns the counts of the nodes, and behind them those of the arcs, in the order of `edges(graph)`.
///
/// \exception Reeb_graph::Unknown_vertex_error if the locations are not those of this mesh
template <class FaceListGraph, class ReebGraph, class VertexLocations>
std::vector<double> vertex_counts_of_pieces(const FaceListGraph& mesh,
                                            const ReebGraph& graph,
                                            const VertexLocations& locations)
{
  if constexpr(internal::Mesh_is_face_list_graph<FaceListGraph>::value)
  {
    std::vector<double> counts(num_vertices(graph) + num_edges(graph), 0);
    for(const auto v : CGAL::make_range(vertices(mesh)))
      counts.at(locations.index(v)) += 1;
    return counts;
  }
  else
    return {};
}

/// \ingroup PkgReebGraphAugmentation
///
/// \brief adds up the area that belongs to each node and to each arc of a Reeb graph: weights for `simplify()`, as
/// named parameter `piece_weights`.
///
/// A third of the area of each face belongs to each of its vertices.
///
/// \param mesh the mesh
/// \param graph the Reeb graph
/// \param locations what `Augmentation::locate_vertices()` has returned for the two
/// \param np an optional sequence of \ref bgl_namedparameters "Named Parameters" among the ones listed below
///
/// \cgalNamedParamsBegin
///   \cgalParamNBegin{vertex_point_map}
///     \cgalParamDescription{the points of the vertices}
///     \cgalParamType{a model of `ReadablePropertyMap` with the vertex descriptors as key type and points of a
///                    three-dimensional kernel as value type}
///     \cgalParamDefault{`boost::get(CGAL::vertex_point, mesh)`}
///   \cgalParamNEnd
/// \cgalNamedParamsEnd
///
/// \returns the areas of the nodes, and behind them those of the arcs, in the order of `edges(graph)`.
///
/// \exception Reeb_graph::Unknown_vertex_error if the locations are not those of this mesh
template <class FaceListGraph,
          class ReebGraph,
          class VertexLocations,
          class NamedParameters = parameters::Default_named_parameters>
std::vector<double> areas_of_pieces(const FaceListGraph& mesh,
                                    const ReebGraph& graph,
                                    const VertexLocations& locations,
                                    const NamedParameters& np = parameters::default_values())
{
  if constexpr(internal::Mesh_is_face_list_graph<FaceListGraph>::value)
  {
    const auto point_map = internal::choose_point_map(mesh, np);
    std::vector<double> areas(num_vertices(graph) + num_edges(graph), 0);
    for(const auto f : CGAL::make_range(faces(mesh)))
    {
      const auto h = halfedge(f, mesh);
      const auto a = source(h, mesh), b = target(h, mesh), c = target(next(h, mesh), mesh);
      const double area =
        std::sqrt(CGAL::to_double(squared_area(get(point_map, a), get(point_map, b), get(point_map, c))));
      internal::add_to_pieces(area, std::array{a, b, c}, locations, areas);
    }
    return areas;
  }
  else
    return {};
}

} // namespace CGAL::Reeb_graph

#endif // CGAL_REEB_GRAPH_PIECE_MEASURES_H
