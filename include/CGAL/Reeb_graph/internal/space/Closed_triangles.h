// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_INTERNAL_SPACE_CLOSED_TRIANGLES_H
#define CGAL_REEB_GRAPH_INTERNAL_SPACE_CLOSED_TRIANGLES_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/internal/base/Index.h>

#include <array>
#include <vector>

namespace CGAL::Reeb_graph::internal {

template <class FT>
std::array<FT, 3> cross(const std::array<FT, 3>& a, const std::array<FT, 3>& b)
{
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

template <class FT>
FT dot(const std::array<FT, 3>& a, const std::array<FT, 3>& b)
{
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

// A closed triangle mesh as arrays. The halfedges of an edge are 2e and 2e + 1.
struct Closed_triangles
{
  typedef std::array<double, 3> Point;

  std::vector<Point> points;       // by vertex
  std::vector<Index> target, next; // by halfedge
  std::vector<Index> face;         // by halfedge
  std::vector<Index> outgoing;     // a halfedge that leaves a vertex; no_index if there is none
  std::vector<Index> halfedge;     // one of each face

  static Index opposite(Index h) { return h ^ 1; }
  Index source(Index h) const { return target[h ^ 1]; }
  Index previous(Index h) const { return next[next[h]]; }
  // The next halfedge that leaves the same vertex, counterclockwise.
  Index turned(Index h) const { return opposite(previous(h)); }
  std::array<Index, 3> corners(Index f) const
  {
    const Index h = halfedge[f];
    return {source(h), target[h], target[next[h]]};
  }
  Point way(Index u, Index v) const
  {
    const Point &p = points[u], &q = points[v];
    return {q[0] - p[0], q[1] - p[1], q[2] - p[2]};
  }

  // Sets what is told of points, targets, and next halfedges.
  void number_faces()
  {
    halfedge.reserve(next.size() / 3);
    face.assign(next.size(), no_index);
    outgoing.assign(points.size(), no_index);
    for(Index h = 0; h != next.size(); ++h)
    {
      outgoing[source(h)] = h;
      if(face[h] != no_index)
        continue;
      face[h] = face[next[h]] = face[previous(h)] = static_cast<Index>(halfedge.size());
      halfedge.push_back(h);
    }
  }
};

// The triangles of a Surface_mesh that is closed and has no garbage.
template <class SurfaceMesh>
Closed_triangles closed_triangles(const SurfaceMesh& mesh)
{
  Closed_triangles result;
  for(const auto& p : mesh.points())
    result.points.push_back({p.x(), p.y(), p.z()});
  for(const auto h : mesh.halfedges())
  {
    result.target.push_back(mesh.target(h));
    result.next.push_back(mesh.next(h));
  }
  result.number_faces();
  return result;
}

} // namespace CGAL::Reeb_graph::internal

#endif // CGAL_REEB_GRAPH_INTERNAL_SPACE_CLOSED_TRIANGLES_H
