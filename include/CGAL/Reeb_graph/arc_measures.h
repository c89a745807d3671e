// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of the CGAL-style package Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_ARC_MEASURES_H
#define CGAL_REEB_GRAPH_ARC_MEASURES_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/internal/base/Scalar_conversion.h>
#include <CGAL/Reeb_graph/internal/base/crossing_fraction.h>
#include <CGAL/Reeb_graph/internal/base/named_parameter.h>
#include <CGAL/Reeb_graph/internal/base/point_map.h>
#include <CGAL/Reeb_graph/internal/base/requirements.h>
#include <CGAL/Reeb_graph/piece_measures.h>
#include <CGAL/Reeb_graph_traits.h>

#include <CGAL/boost/graph/iterator.h>
#include <CGAL/boost/graph/named_params_helper.h>
#include <CGAL/number_utils.h>

#include <boost/graph/graph_traits.hpp>

#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Reeb_graph {

/// \ingroup PkgReebGraphAugmentation
///
/// \brief adds up the area of the surface that belongs to each arc of a Reeb graph.
///
/// A third of the area of each face belongs to each of its vertices, as in `areas_of_pieces()`; what belongs to a node
/// is shared out equally among its arcs. So the sum is the area of the mesh, but for components without an arc, which
/// contracted ties can leave.
///
/// \param mesh the mesh
/// \param graph the Reeb graph
/// \param locations what `Augmentation::locate_vertices()` has returned for the two
/// \param np named parameters: those of `areas_of_pieces()`
///
/// \returns the areas of the arcs, in the order of `edges(graph)`.
///
/// \exception Reeb_graph::Unknown_vertex_error if the locations are not those of this mesh
template <class FaceListGraph,
          class ReebGraph,
          class VertexLocations,
          class NamedParameters = parameters::Default_named_parameters>
std::vector<double> arc_areas(const FaceListGraph& mesh,
                              const ReebGraph& graph,
                              const VertexLocations& locations,
                              const NamedParameters& np = parameters::default_values())
{
  const std::vector<double> areas = areas_of_pieces(mesh, graph, locations, np);
  std::vector<double> result(areas.begin() + static_cast<std::ptrdiff_t>(num_vertices(graph)), areas.end());
  std::size_t arc_number = 0;
  for(const auto arc : CGAL::make_range(edges(graph)))
  {
    for(const auto node : {source(arc, graph), target(arc, graph)})
      result[arc_number] += areas[node] / static_cast<double>(degree(node, graph));
    ++arc_number;
  }
  return result;
}

/// \ingroup PkgReebGraphAugmentation
///
/// \brief measures the length of each arc of a Reeb graph on the surface.
///
/// That is the length of its chain as a polyline, from the vertex of the lower node up to the value of the upper node:
/// the last halfedge, whose target can be beyond, counts up to that value, and so does the last one of each piece of a
/// chain that passes a plateau up to where the arc enters it. It takes time linear in the length of the chains.
///
/// \param mesh the mesh that the graph has been computed of
/// \param scalar_map the field that it has been computed of
/// \param graph the Reeb graph
/// \param np named parameters: those of `areas_of_pieces()`, and `geom_traits`, as for `simplify()`
///
/// \returns the lengths, in the order of `edges(graph)`.
template <class FaceListGraph,
          class ScalarMap,
          class ReebGraph,
          class NamedParameters = parameters::Default_named_parameters>
std::vector<double> arc_lengths(const FaceListGraph& mesh,
                                ScalarMap scalar_map,
                                const ReebGraph& graph,
                                const NamedParameters& np = parameters::default_values())
{
  typedef internal::Chosen_traits<Reeb_graph_traits<FaceListGraph, ScalarMap>, NamedParameters> Traits;
  if constexpr(internal::Mesh_with_numbers<FaceListGraph, ScalarMap, Traits>::value)
  {
    const internal::Scalar_conversion<Traits> conversion(internal::choose_traits<Traits>(np));
    const auto point_map = internal::choose_point_map(mesh, np);
    const auto value = [&](const auto v) { return conversion.to_double(get(scalar_map, v)); };
    const auto used_length = [&](const auto h, const auto end) {
      const auto u = source(h, mesh), w = target(h, mesh);
      const double length = std::sqrt(CGAL::to_double((get(point_map, w) - get(point_map, u)).squared_length()));
      return end == w ? length : length * internal::crossing_fraction(value(u), value(w), value(end));
    };
    std::vector<double> lengths;
    for(const auto arc : CGAL::make_range(edges(graph)))
    {
      const auto& chain = graph[arc].chain;
      double length = 0;
      for(std::size_t i = 0; i != chain.size(); ++i)
        length +=
          used_length(chain[i], i + 1 == chain.size() ? graph[target(arc, graph)].vertex : source(chain[i + 1], mesh));
      lengths.push_back(length);
    }
    return lengths;
  }
  else
    return {};
}

} // namespace Reeb_graph
} // namespace CGAL

#endif // CGAL_REEB_GRAPH_ARC_MEASURES_H
