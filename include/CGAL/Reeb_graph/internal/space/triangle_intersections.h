// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_INTERNAL_SPACE_TRIANGLE_INTERSECTIONS_H
#define CGAL_REEB_GRAPH_INTERNAL_SPACE_TRIANGLE_INTERSECTIONS_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Box_intersection_d/Box_with_info_d.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <array>
#include <cstddef>
#include <utility>

namespace CGAL::Reeb_graph::internal {

// Triangles in space, by whose predicates it is told what intersects.
typedef Exact_predicates_inexact_constructions_kernel Disc_kernel;
typedef Disc_kernel::Point_3 Disc_point;

typedef Box_intersection_d::Box_with_info_d<double, 3, std::size_t> Numbered_box;

// A triangle that is to be, or a face. A vertex of a loop that is cut has a copy on its left and one on its right.
template <class VertexDescriptor>
struct Placed_triangle
{
  struct Corner
  {
    VertexDescriptor vertex;
    int copy; // 0 if it is not cut, 1 on the left, 2 on the right
    Disc_point point;
  };
  std::array<Corner, 3> corners;

  Disc_kernel::Triangle_3 triangle() const { return {corners[0].point, corners[1].point, corners[2].point}; }
};

// Whether two triangles have more in common than the corners that they share, and the edge between two of these, if that
// is one edge and no double one. A triangle without area has nothing.
template <class VertexDescriptor>
bool do_intersect(Placed_triangle<VertexDescriptor> a, Placed_triangle<VertexDescriptor> b, bool is_edge_double = false)
{
  typedef typename Placed_triangle<VertexDescriptor>::Corner Corner;
  const auto is_same = [](const Corner& p, const Corner& q) { return p.vertex == q.vertex && p.copy == q.copy; };
  std::size_t shared = 0; // the shared ones are put first
  for(std::size_t i = 0; i != 3; ++i)
    for(std::size_t j = shared; j != 3; ++j)
    {
      if(!is_same(a.corners[i], b.corners[j]))
        continue;
      std::swap(a.corners[i], a.corners[shared]);
      std::swap(b.corners[j], b.corners[shared]);
      ++shared;
      break;
    }
  const Disc_kernel::Triangle_3 s = a.triangle(), t = b.triangle();
  if(s.is_degenerate() || t.is_degenerate())
    return false;
  if(shared == 3 || (shared == 2 && is_edge_double))
    return true;
  if(shared == 2)
    return CGAL::coplanar(s[0], s[1], s[2], t[2])
        && CGAL::coplanar_orientation(s[0], s[1], s[2], t[2]) == CGAL::POSITIVE;
  if(shared == 1)
    return CGAL::do_intersect(s, Disc_kernel::Segment_3(t[1], t[2]))
        || CGAL::do_intersect(t, Disc_kernel::Segment_3(s[1], s[2]));
  return CGAL::do_intersect(s, t);
}

} // namespace CGAL::Reeb_graph::internal

#endif // CGAL_REEB_GRAPH_INTERNAL_SPACE_TRIANGLE_INTERSECTIONS_H
