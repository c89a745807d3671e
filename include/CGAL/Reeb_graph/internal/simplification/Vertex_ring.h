// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of the CGAL-style package Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_INTERNAL_SIMPLIFICATION_VERTEX_RING_H
#define CGAL_REEB_GRAPH_INTERNAL_SIMPLIFICATION_VERTEX_RING_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/internal/base/Index.h>
#include <CGAL/Reeb_graph/internal/scalar_fields/Weighted_graph.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Reeb_graph {
namespace internal {

struct Member_tag;
typedef Index_of<Member_tag> Member_index; // one of the vertices that are swept

// The contours just below or above a vertex, or only the sectors of its link, of which a contour joins some.
struct Vertex_contours
{
  std::size_t number = 0;
  std::vector<Member_index> labels; // a swept member below each contour, no_index if it has none
};

// The vertices around a vertex on one side of a level, in disjoint sets: the sectors of its link, and later the
// contours.
struct Vertex_ring
{
  std::vector<scalar_fields::Position> vertices;
  std::vector<std::size_t> parents;
  std::vector<Member_index> labels;

  std::size_t find(std::size_t i) const
  {
    while(parents[i] != i)
      i = parents[i];
    return i;
  }
  std::size_t index(scalar_fields::Position v) const
  {
    return static_cast<std::size_t>(std::find(vertices.begin(), vertices.end(), v) - vertices.begin());
  }
  void unite(scalar_fields::Position u, scalar_fields::Position v)
  {
    const std::size_t a = find(index(u)), b = find(index(v));
    parents[a] = b;
    label(b, labels[a]);
  }
  void label(std::size_t root, Member_index m)
  {
    if(labels[root] == no_index)
      labels[root] = m;
  }
  Vertex_contours contours() const
  {
    Vertex_contours result;
    for(std::size_t i = 0; i != parents.size(); ++i)
    {
      if(parents[i] != i)
        continue;
      ++result.number;
      result.labels.push_back(labels[i]);
    }
    return result;
  }
};

} // namespace internal
} // namespace Reeb_graph
} // namespace CGAL

#endif // CGAL_REEB_GRAPH_INTERNAL_SIMPLIFICATION_VERTEX_RING_H
