// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of the CGAL-style package Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_INTERNAL_EMBEDDING_LEAF_BORDERS_H
#define CGAL_REEB_GRAPH_INTERNAL_EMBEDDING_LEAF_BORDERS_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/internal/embedding/contour_geometry.h>

#include <CGAL/boost/graph/helpers.h>
#include <CGAL/boost/graph/iterator.h>

#include <boost/graph/graph_traits.hpp>
#include <boost/property_map/property_map.hpp>
#include <boost/unordered_map.hpp>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Reeb_graph {
namespace internal {

// The middles of the border loops that leaves of a graph on a mesh stand for. Each loop is walked once, however many
// leaves it has. A soup has no border loops.
template <class Augmentation, class PointMap>
class Leaf_borders
{
  typedef typename Augmentation::Mesh Mesh;
  typedef typename Augmentation::vertex_descriptor vertex_descriptor;
  typedef typename Augmentation::halfedge_descriptor halfedge_descriptor;
  typedef typename boost::property_traits<PointMap>::value_type Point;

public:
  Leaf_borders(const Augmentation& augmentation, const PointMap& point_map)
    : augmentation_(augmentation),
      point_map_(point_map)
  {
    if constexpr(Is_contour_on_mesh<typename Augmentation::Contour>::value)
    {
      const auto& graph = augmentation.graph();
      for(const auto node : CGAL::make_range(vertices(graph)))
      {
        const bool is_leaf = (in_degree(node, graph) == 0) != (out_degree(node, graph) == 0);
        if(is_leaf && loop_of_vertex_.count(graph[node].vertex) == 0)
          add_loop(graph[node].vertex);
      }
    }
  }

  // Of length 0 if the vertex, which is that of a leaf, is not on a border of one value.
  Centroid centroid(vertex_descriptor v) const
  {
    const auto found = loop_of_vertex_.find(v);
    return found == loop_of_vertex_.end() ? Centroid() : centroids_[found->second];
  }

private:
  void add_loop(vertex_descriptor v)
  {
    const Mesh& mesh = augmentation_.mesh();
    const auto border = CGAL::is_border(v, mesh);
    if(!border)
      return;
    std::vector<Point> points;
    bool is_level = true;
    halfedge_descriptor h = *border;
    do
    {
      points.push_back(get(point_map_, target(h, mesh)));
      is_level = is_level && augmentation_.value(target(h, mesh)) == augmentation_.value(v);
      loop_of_vertex_[target(h, mesh)] = centroids_.size();
      h = next(h, mesh);
    } while(h != *border);
    centroids_.emplace_back();
    if(is_level)
      centroids_.back().add_curve(points, true);
  }

  const Augmentation& augmentation_;
  const PointMap& point_map_;
  boost::unordered_map<vertex_descriptor, std::size_t> loop_of_vertex_;
  std::vector<Centroid> centroids_;
};

} // namespace internal
} // namespace Reeb_graph
} // namespace CGAL

#endif // CGAL_REEB_GRAPH_INTERNAL_EMBEDDING_LEAF_BORDERS_H
