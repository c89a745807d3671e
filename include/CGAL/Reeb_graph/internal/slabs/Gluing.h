// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of the CGAL-style package Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_INTERNAL_SLABS_GLUING_H
#define CGAL_REEB_GRAPH_INTERNAL_SLABS_GLUING_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/internal/base/Index.h>
#include <CGAL/Reeb_graph/internal/base/Indexed_vector.h>
#include <CGAL/Reeb_graph/internal/base/Plain_vector.h>
#include <CGAL/Reeb_graph/internal/base/Side.h>
#include <CGAL/Reeb_graph/internal/slabs/Slab.h>
#include <CGAL/Reeb_graph/internal/slabs/Slab_arc.h>
#include <CGAL/Reeb_graph/internal/slabs/Slicing.h>

#include <cstddef>

namespace CGAL {
namespace Reeb_graph {
namespace internal {

// Joins the arcs of the slabs where they end and begin at the same contour of a bounding level. An arc of the surface
// can pass any number of slabs. (The paper, Section 5.3.)
template <class Complex>
class Gluing
{
public:
  explicit Gluing(const Slicing<Complex>& slicing, Number number_of_critical_vertices)
    : slicing_(slicing),
      first_contours_({number_of_critical_vertices})
  {
    for(const Bounding_level& level : slicing.levels())
      first_contours_.push_back(checked_index(std::size_t(first_contours_.back()) + level.number_of_contours()));
    upper_ends_.resize(first_contours_.back() - first_contours_.front(), no_index);
  }

  Slab_arcs operator()(const Indexed_vector<Slab_index, Slab_arcs>& arcs_of_slabs)
  {
    Slab_arcs arcs;
    for(const Slab_index slab : arcs_of_slabs.keys())
    {
      for(const Slab_arc& arc : arcs_of_slabs[slab])
      {
        const Slab_node lower = name(slab, arc.lower), upper = name(slab, arc.upper);
        if(is_contour(lower))
          upper_end(lower) = upper;
        else
          arcs.push_back({lower, upper, arc.first_step});
      }
    }
    for(Slab_arc& arc : arcs)
    {
      while(is_contour(arc.upper))
      {
        const Slab_node above = upper_end(arc.upper);
        if(above == no_index || (is_contour(above) && above <= arc.upper))
          slicing_.complex().throw_contradiction_near(arc.first_step.target);
        arc.upper = above;
      }
    }
    return arcs;
  }

private:
  // The surface has the contours of all levels as nodes, behind its critical vertices.
  bool is_contour(Slab_node node) const { return node.number() >= first_contours_.front(); }
  Slab_node& upper_end(Slab_node contour) { return upper_ends_[contour.number() - first_contours_.front()]; }

  // The node of the surface that a node of a slab is.
  Slab_node name(Slab_index index, Slab_node node) const
  {
    const Slab<Complex> slab = slicing_.slab(index);
    if(!slab.is_contour(node))
      return node_of(slicing_.critical_vertex(index, critical_vertex_of(node)));
    const std::size_t level = slab.side_of_contour(node) == Side::UPPER ? index.number() : index.number() - 1;
    return Slab_node(first_contours_[level] + slab.contour_of_node(node).number());
  }

  const Slicing<Complex>& slicing_;
  Plain_vector<Number> first_contours_; // by level: the number of its first contour among the nodes
  Plain_vector<Slab_node> upper_ends_;  // by contour of all levels
};

} // namespace internal
} // namespace Reeb_graph
} // namespace CGAL

#endif // CGAL_REEB_GRAPH_INTERNAL_SLABS_GLUING_H
