// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of the CGAL-style package Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_INTERNAL_SLABS_BOUNDING_LEVEL_H
#define CGAL_REEB_GRAPH_INTERNAL_SLABS_BOUNDING_LEVEL_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/internal/base/Index.h>
#include <CGAL/Reeb_graph/internal/base/Large_vector.h>
#include <CGAL/Reeb_graph/internal/base/Number_set.h>
#include <CGAL/Reeb_graph/internal/walks/contour_tracing.h>

#include <vector>

namespace CGAL {
namespace Reeb_graph {
namespace internal {

// A level between two slabs, and its contours, numbered in the order of their first edges. It
// holds the map from crossed edges to contours by which slabs are glued. (The paper, Section 5.3.)
class Bounding_level
{
public:
  explicit Bounding_level(Index number_of_edges) : crossed_edges_(number_of_edges) {}

  void add_crossed_edge(Index edge) { crossed_edges_.add(edge); }

  // To be called after the last edge has been added.
  template <class Complex, class IsBelow>
  void find_contours(const Complex& complex, const IsBelow& is_below)
  {
    crossed_edges_.count_ranks();
    contours_.assign(crossed_edges_.size(), no_index);
    crossed_edges_.for_each([&](Index edge) {
      if(contours_[crossed_edges_.rank(edge)] != no_index)
        return;
      const Index contour = number_of_contours();
      first_edges_.push_back(edge);
      is_border_reached_.push_back(false);
      trace_contour(complex, complex.halfedge_of_triangle(edge), is_below, [&](Index halfedge) {
        contours_[crossed_edges_.rank(edge_of(halfedge))] = contour;
        if(complex.is_on_border_edge(halfedge))
          is_border_reached_.back() = true;
      });
    });
  }

  Index number_of_contours() const { return static_cast<Index>(first_edges_.size()); }
  Index first_edge(Index contour) const { return first_edges_[contour]; }
  bool is_border_reached(Index contour) const { return is_border_reached_[contour]; }

  Index contour_at_edge(Index halfedge) const { return contours_[crossed_edges_.rank(edge_of(halfedge))]; }

private:
  Number_set crossed_edges_;
  Large_vector<Index> contours_;    // by rank of the edge
  Large_vector<Index> first_edges_; // by contour
  std::vector<bool> is_border_reached_;
};

} // namespace internal
} // namespace Reeb_graph
} // namespace CGAL

#endif // CGAL_REEB_GRAPH_INTERNAL_SLABS_BOUNDING_LEVEL_H
