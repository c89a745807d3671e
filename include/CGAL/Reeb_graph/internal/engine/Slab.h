// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_INTERNAL_ENGINE_SLAB_H
#define CGAL_REEB_GRAPH_INTERNAL_ENGINE_SLAB_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/internal/base/Index.h>
#include <CGAL/Reeb_graph/internal/base/arrays.h>
#include <CGAL/Reeb_graph/internal/engine/Bounding_level.h>
#include <CGAL/Reeb_graph/internal/engine/Swept_arcs.h>
#include <CGAL/Reeb_graph/internal/engine/Swept_vertices.h>
#include <CGAL/Reeb_graph/internal/engine/monotone_paths.h>

namespace CGAL::Reeb_graph::internal {

struct Slab_tag;
typedef Index_of<Slab_tag> Slab_index;

// The part of the surface between two bounding levels, or all of it. It is no copy: it has the numbers of the slabs in
// which all vertices are, and its own critical vertices. Its nodes are these, followed by the contours of its lower
// level and those of its upper level.
template <class Complex>
class Slab
{
public:
  // The slab that is all of the surface.
  Slab(const Complex& complex, const Swept_vertices& critical_vertices)
    : complex_(&complex),
      critical_vertices_(&critical_vertices)
  {}

  // The slab of the given index, between two levels, each of which can be missing.
  Slab(const Complex& complex,
       const Swept_vertices& critical_vertices,
       const Indexed_vector<Vertex_index, Slab_index>& slabs_of_vertices,
       Slab_index index,
       const By_side<const Bounding_level*>& levels)
    : complex_(&complex),
      critical_vertices_(&critical_vertices),
      slabs_of_vertices_(&slabs_of_vertices),
      index_(index),
      levels_(levels)
  {}

  bool is_whole_surface() const { return slabs_of_vertices_ == nullptr; }

  const Complex& complex() const { return *complex_; }
  const Swept_vertices& critical_vertices() const { return *critical_vertices_; }

  // Throws the error of an order of the vertices that contradicts itself, which has shown at an end of the arc, as far
  // as it has any.
  [[noreturn]] void throw_contradiction_near(const Swept_arc& arc) const
  {
    const Tree_node node = !is_contour(arc.lower) ? arc.lower : (!is_contour(arc.upper) ? arc.upper : Tree_node(0));
    complex_->throw_contradiction_near(critical_vertices_->vertex(critical_vertex_of(node)));
  }

  // The contours of the lower or of the upper level.
  Number number_of_contours(Side side) const { return levels_[side] ? levels_[side]->number_of_contours() : 0; }
  Index_range<Contour_index> contours(Side side) const { return Index_range<Contour_index>(number_of_contours(side)); }

  Number number_of_nodes() const
  {
    return critical_vertices_->size() + number_of_contours(Side::LOWER) + number_of_contours(Side::UPPER);
  }
  bool is_contour(Tree_node node) const { return node.number() >= critical_vertices_->size(); }
  Tree_node contour_node(Side side, Contour_index contour) const
  {
    return Tree_node(first_contour_node(side) + contour.number());
  }

  // The contour that a node is: its side and its name there.
  Side side_of_contour(Tree_node node) const { return side_of(node.number() >= first_contour_node(Side::UPPER)); }
  Contour_index contour_of_node(Tree_node node) const
  {
    return Contour_index(node.number() - first_contour_node(side_of_contour(node)));
  }

  bool is_border_reached(Side side, Contour_index contour) const { return levels_[side]->is_border_reached(contour); }

  // The contour at which a monotone path leaves the slab with a step to `target` over the edge find_edge(), no_index if
  // it does not.
  template <class FindEdge>
  Contour_index contour_at_step(Side side, Vertex_index target, const FindEdge& find_edge) const
  {
    const Bounding_level* level = levels_[side];
    if(level == nullptr || !is_outside(side, target))
      return no_index;
    return level->contour_at_edge(find_edge());
  }

  // A step from a contour of the upper or the lower level into the slab, or across all of it.
  Ascending_step step_from_contour(Side side, Contour_index contour) const
  {
    const Halfedge_index edge = complex_->halfedge_of_triangle(levels_[side]->first_edge(contour));
    const Vertex_index source = complex_->source(edge), target = complex_->target(edge);
    const bool is_source_lower = (*slabs_of_vertices_)[source] < (*slabs_of_vertices_)[target];
    return {edge, is_source_lower == (side == Side::UPPER) ? source : target};
  }

private:
  Number first_contour_node(Side side) const
  {
    return critical_vertices_->size() + (side == Side::UPPER ? number_of_contours(Side::LOWER) : 0);
  }

  bool is_outside(Side side, Vertex_index vertex) const
  {
    const Slab_index slab = (*slabs_of_vertices_)[vertex];
    return side == Side::UPPER ? slab > index_ : slab < index_;
  }

  const Complex* complex_;
  const Swept_vertices* critical_vertices_;
  const Indexed_vector<Vertex_index, Slab_index>* slabs_of_vertices_ = nullptr;
  Slab_index index_ = Slab_index(0);
  By_side<const Bounding_level*> levels_ = {nullptr, nullptr};
};

} // namespace CGAL::Reeb_graph::internal

#endif // CGAL_REEB_GRAPH_INTERNAL_ENGINE_SLAB_H
