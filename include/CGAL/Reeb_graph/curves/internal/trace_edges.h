// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_CURVES_INTERNAL_TRACE_EDGES_H
#define CGAL_REEB_GRAPH_CURVES_INTERNAL_TRACE_EDGES_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/curves/Curve.h>

#include <CGAL/Dynamic_property_map.h>
#include <CGAL/boost/graph/helpers.h>
#include <CGAL/boost/graph/iterator.h>
#include <CGAL/boost/graph/properties.h>
#include <CGAL/number_utils.h>

#include <boost/graph/graph_traits.hpp>

#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::Reeb_graph::internal {

// Joins edges to curves: the longest paths through vertices with two of the edges, in the order of their first edges,
// those that end before those that do not.
template <class Mesh>
class Edge_tracing
{
  typedef typename boost::graph_traits<Mesh>::vertex_descriptor vertex_descriptor;
  typedef typename boost::graph_traits<Mesh>::halfedge_descriptor halfedge_descriptor;
  typedef typename boost::graph_traits<Mesh>::edge_descriptor edge_descriptor;

public:
  explicit Edge_tracing(Mesh& mesh)
    : mesh_(mesh),
      is_left_(get(dynamic_edge_property_t<bool>(), mesh)),
      number_of_edges_(get(dynamic_vertex_property_t<std::size_t>(), mesh))
  {
    for(const edge_descriptor e : edges(mesh))
      put(is_left_, e, false);
  }

  std::vector<std::vector<halfedge_descriptor>> operator()(const std::vector<edge_descriptor>& given)
  {
    for(const int step : {0, 1})
      for(const edge_descriptor e : given)
        for(const vertex_descriptor v : {source(e, mesh_), target(e, mesh_)})
          put(number_of_edges_, v, step == 0 ? 0 : get(number_of_edges_, v) + 1);
    for(const edge_descriptor e : given)
      put(is_left_, e, true);
    std::vector<std::vector<halfedge_descriptor>> paths;
    for(const bool is_closed : {false, true})
      for(const edge_descriptor e : given)
        for(const halfedge_descriptor h : {halfedge(e, mesh_), opposite(halfedge(e, mesh_), mesh_)})
          if(get(is_left_, e) && (is_closed || get(number_of_edges_, source(h, mesh_)) != 2))
            paths.push_back(path_from(h));
    return paths;
  }

private:
  // The path that begins with a halfedge.
  std::vector<halfedge_descriptor> path_from(halfedge_descriptor first)
  {
    std::vector<halfedge_descriptor> path = {first};
    put(is_left_, edge(first, mesh_), false);
    for(bool is_longer = true; is_longer;)
    {
      is_longer = false;
      const vertex_descriptor v = target(path.back(), mesh_);
      if(get(number_of_edges_, v) != 2)
        break;
      for(const halfedge_descriptor h : halfedges_around_source(v, mesh_))
        if(get(is_left_, edge(h, mesh_)))
        {
          put(is_left_, edge(h, mesh_), false);
          path.push_back(h);
          is_longer = true;
          break;
        }
    }
    return path;
  }

  Mesh& mesh_;
  typename boost::property_map<Mesh, dynamic_edge_property_t<bool>>::type is_left_; // on no path yet
  typename boost::property_map<Mesh, dynamic_vertex_property_t<std::size_t>>::type number_of_edges_;
};

// The curve of halfedges of a mesh that has not been cut open.
template <class Mesh, class VertexPointMap, class HalfedgeDescriptor>
Curve<HalfedgeDescriptor> make_curve(const Mesh& mesh,
                                     const VertexPointMap& vertex_point_map,
                                     std::vector<HalfedgeDescriptor> halfedges,
                                     double value)
{
  Curve<HalfedgeDescriptor> curve;
  curve.value = value;
  curve.is_closed = source(halfedges.front(), mesh) == target(halfedges.back(), mesh);
  for(const HalfedgeDescriptor h : halfedges)
  {
    curve.lower_halfedges.push_back(opposite(h, mesh));
    const auto edge = get(vertex_point_map, target(h, mesh)) - get(vertex_point_map, source(h, mesh));
    curve.length += std::sqrt(CGAL::to_double(edge.squared_length()));
  }
  curve.halfedges = std::move(halfedges);
  return curve;
}

} // namespace CGAL::Reeb_graph::internal

#endif // CGAL_REEB_GRAPH_CURVES_INTERNAL_TRACE_EDGES_H
