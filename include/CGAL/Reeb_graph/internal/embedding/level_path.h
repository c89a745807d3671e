// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of the CGAL-style package Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_INTERNAL_EMBEDDING_LEVEL_PATH_H
#define CGAL_REEB_GRAPH_INTERNAL_EMBEDDING_LEVEL_PATH_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/boost/graph/iterator.h>

#include <boost/graph/graph_traits.hpp>
#include <boost/unordered_map.hpp>

#include <algorithm>
#include <deque>
#include <vector>

namespace CGAL {
namespace Reeb_graph {
namespace internal {

// The edges that lead inside of a level set from halfedge h to a face at the vertex `end`, whose value the level is:
// the fewest that there are; none if there is no way. `value` is called with a vertex. In each triangle, a level set is
// convex, so that it leads from triangle to triangle over the edges that it touches.
template <class FaceListGraph, class Value>
std::vector<typename boost::graph_traits<FaceListGraph>::halfedge_descriptor> level_path(
  const FaceListGraph& mesh,
  const Value& value,
  typename boost::graph_traits<FaceListGraph>::halfedge_descriptor h,
  typename boost::graph_traits<FaceListGraph>::vertex_descriptor end)
{
  typedef typename boost::graph_traits<FaceListGraph>::halfedge_descriptor halfedge_descriptor;
  typedef typename boost::graph_traits<FaceListGraph>::face_descriptor face_descriptor;
  const double level = value(end);
  const auto is_touched = [&](halfedge_descriptor edge) {
    const auto [low, high] = std::minmax({value(source(edge, mesh)), value(target(edge, mesh))});
    return low <= level && level <= high;
  };
  boost::unordered_map<face_descriptor, halfedge_descriptor> entries; // of the faces that have been found
  std::deque<halfedge_descriptor> queue;
  const auto enter = [&](halfedge_descriptor edge) {
    if(!is_border(edge, mesh) && entries.emplace(face(edge, mesh), edge).second)
      queue.push_back(edge);
  };
  enter(h);
  enter(opposite(h, mesh));
  std::vector<halfedge_descriptor> path;
  for(; !queue.empty(); queue.pop_front())
  {
    const halfedge_descriptor entry = queue.front();
    const auto around = CGAL::halfedges_around_face(entry, mesh);
    if(std::any_of(around.begin(), around.end(), [&](halfedge_descriptor edge) { return target(edge, mesh) == end; }))
    {
      halfedge_descriptor edge = entry;
      for(; edge != h && edge != opposite(h, mesh); edge = entries.at(face(opposite(edge, mesh), mesh)))
        path.push_back(edge);
      std::reverse(path.begin(), path.end());
      return path;
    }
    for(const halfedge_descriptor edge : around)
    {
      if(is_touched(edge))
        enter(opposite(edge, mesh));
    }
  }
  return path;
}

} // namespace internal
} // namespace Reeb_graph
} // namespace CGAL

#endif // CGAL_REEB_GRAPH_INTERNAL_EMBEDDING_LEVEL_PATH_H
