// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_INTERNAL_ENGINE_BOUNDING_LEVEL_H
#define CGAL_REEB_GRAPH_INTERNAL_ENGINE_BOUNDING_LEVEL_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/internal/base/Index.h>
#include <CGAL/Reeb_graph/internal/base/arrays.h>
#include <CGAL/Reeb_graph/internal/engine/contour_tracing.h>

namespace CGAL::Reeb_graph::internal {

struct Contour_tag;
typedef Index_of<Contour_tag> Contour_index;

// A level between two slabs, and its contours, numbered in the order of their first edges. It
// holds the map from crossed edges to contours by which slabs are glued. (The paper, Section 5.3.)
class Bounding_level
{
public:
  explicit Bounding_level(Number number_of_edges) : crossed_edges_(number_of_edges) {}

  void add_crossed_edge(Edge_index edge) { crossed_edges_.add(edge); }

  // Finds the contours when all crossed edges have been added.
  template <class Complex, class IsBelow>
  void find_contours(const Complex& complex, const IsBelow& is_below)
  {
    crossed_edges_.count_ranks();
    contours_.reset(crossed_edges_.size(), no_index);
    crossed_edges_.for_each([&](Edge_index edge) {
      if(contours_[crossed_edges_.rank(edge)] != no_index)
        return;
      first_edges_.push_back(edge);
      const Contour_index contour = first_edges_.last_key();
      is_border_reached_.push_back(false);
      trace_contour(complex, complex.halfedge_of_triangle(edge), is_below, [&](Halfedge_index halfedge) {
        contours_[crossed_edges_.rank(edge_of(halfedge))] = contour;
        if(complex.is_on_border_edge(halfedge))
          is_border_reached_.back() = true;
      });
    });
  }

  Number number_of_contours() const { return static_cast<Number>(first_edges_.size()); }
  Edge_index first_edge(Contour_index contour) const { return first_edges_[contour]; }
  bool is_border_reached(Contour_index contour) const { return is_border_reached_[contour]; }

  Contour_index contour_at_edge(Halfedge_index halfedge) const
  {
    return contours_[crossed_edges_.rank(edge_of(halfedge))];
  }

private:
  typedef Index_set<Edge_index> Edge_set;

  Edge_set crossed_edges_;
  Indexed_vector<Edge_set::Rank_index, Contour_index> contours_;
  Indexed_vector<Contour_index, Edge_index> first_edges_;
  Indexed_vector<Contour_index, bool> is_border_reached_;
};

} // namespace CGAL::Reeb_graph::internal

#endif // CGAL_REEB_GRAPH_INTERNAL_ENGINE_BOUNDING_LEVEL_H
