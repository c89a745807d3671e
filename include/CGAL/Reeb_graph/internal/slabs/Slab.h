// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of the CGAL-style package Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_INTERNAL_SLABS_SLAB_H
#define CGAL_REEB_GRAPH_INTERNAL_SLABS_SLAB_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/internal/base/Index.h>
#include <CGAL/Reeb_graph/internal/base/Large_vector.h>
#include <CGAL/Reeb_graph/internal/critical_vertices/Swept_vertices.h>
#include <CGAL/Reeb_graph/internal/slabs/Bounding_level.h>
#include <CGAL/Reeb_graph/internal/slabs/Slab_arc.h>
#include <CGAL/Reeb_graph/internal/walks/ascending_path.h>

#include <cstddef>

namespace CGAL {
namespace Reeb_graph {
namespace internal {

// The part of the surface between two bounding levels, or all of it. It is no copy: it has the numbers of the slabs in which
// all vertices are, and its own critical vertices. Its nodes are these, followed by the contours of its lower level and
// those of its upper level.
template <class Complex>
class Slab
{
public:
  // All of the surface.
  Slab(const Complex& complex, const Swept_vertices& critical_vertices)
    : complex_(&complex),
      critical_vertices_(&critical_vertices)
  {}

  // Slab `number`, between two levels, each of which can be missing.
  Slab(const Complex& complex,
       const Swept_vertices& critical_vertices,
       const Large_vector<Index>& slabs_of_vertices,
       Index number,
       const Bounding_level* lower_level,
       const Bounding_level* upper_level)
    : complex_(&complex),
      critical_vertices_(&critical_vertices),
      slabs_of_vertices_(&slabs_of_vertices),
      number_(number),
      lower_level_(lower_level),
      upper_level_(upper_level)
  {}

  bool is_whole_surface() const { return slabs_of_vertices_ == nullptr; }

  const Complex& complex() const { return *complex_; }
  const Swept_vertices& critical_vertices() const { return *critical_vertices_; }

  // Throws the error of an order of the vertices that contradicts itself, which has shown at an end of the arc, as far as
  // it has any.
  [[noreturn]] void throw_contradiction_near(const Slab_arc& arc) const
  {
    const Index size = critical_vertices_->size();
    complex_->throw_contradiction_near(
      critical_vertices_->vertex(arc.lower < size ? arc.lower : (arc.upper < size ? arc.upper : 0)));
  }

  Index number_of_contours(bool is_upper) const
  {
    const Bounding_level* level = is_upper ? upper_level_ : lower_level_;
    return level == nullptr ? 0 : level->number_of_contours();
  }

  Index number_of_nodes() const { return contour_node(true, number_of_contours(true)); }
  Index contour_node(bool is_upper, Index contour) const
  {
    return critical_vertices_->size() + (is_upper ? number_of_contours(false) : 0) + contour;
  }
  bool is_contour_node(bool is_upper, Index node) const
  {
    return node >= contour_node(is_upper, 0) && node < contour_node(is_upper, number_of_contours(is_upper));
  }

  bool is_border_reached(bool is_upper, Index contour) const
  {
    return (is_upper ? upper_level_ : lower_level_)->is_border_reached(contour);
  }

  // The contour at which a monotone path leaves the slab with a step to `target` over the edge find_edge(), no_index if
  // it does not.
  template <class FindEdge>
  Index contour_at_step(bool is_upper, Index target, const FindEdge& find_edge) const
  {
    const Bounding_level* level = is_upper ? upper_level_ : lower_level_;
    if(level == nullptr || !is_outside(is_upper, target))
      return no_index;
    return level->contour_at_edge(find_edge());
  }

  // A step from a contour of the upper or the lower level into the slab, or across all of it.
  Ascending_step step_from_contour(bool is_upper, Index contour) const
  {
    const Index edge = complex_->halfedge_of_triangle((is_upper ? upper_level_ : lower_level_)->first_edge(contour));
    const Index source = complex_->source(edge), target = complex_->target(edge);
    const bool is_source_lower = (*slabs_of_vertices_)[source] < (*slabs_of_vertices_)[target];
    return {edge, is_source_lower == is_upper ? source : target};
  }

private:
  bool is_outside(bool is_upper, Index vertex) const
  {
    const Index slab = (*slabs_of_vertices_)[vertex];
    return is_upper ? slab > number_ : slab < number_;
  }

  const Complex* complex_;
  const Swept_vertices* critical_vertices_;
  const Large_vector<Index>* slabs_of_vertices_ = nullptr;
  Index number_ = 0;
  const Bounding_level* lower_level_ = nullptr;
  const Bounding_level* upper_level_ = nullptr;
};

} // namespace internal
} // namespace Reeb_graph
} // namespace CGAL

#endif // CGAL_REEB_GRAPH_INTERNAL_SLABS_SLAB_H
