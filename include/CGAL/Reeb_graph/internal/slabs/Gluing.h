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
#include <CGAL/Reeb_graph/internal/base/Large_vector.h>
#include <CGAL/Reeb_graph/internal/slabs/Slab.h>
#include <CGAL/Reeb_graph/internal/slabs/Slab_arc.h>
#include <CGAL/Reeb_graph/internal/slabs/Slicing.h>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Reeb_graph {
namespace internal {

// Joins the arcs of the slabs where they end and begin at the same contour of a bounding level. An arc of the surface can pass any
// number of slabs. (The paper, Section 5.3.)
template <class Complex>
class Gluing
{
public:
  explicit Gluing(const Slicing<Complex>& slicing, Index number_of_critical_vertices)
    : slicing_(slicing),
      first_contours_({number_of_critical_vertices})
  {
    for(Index level = 0; level != slicing.number_of_levels(); ++level)
      first_contours_.push_back(
        checked_index(std::size_t(first_contours_.back()) + slicing.level(level).number_of_contours()));
    upper_ends_.resize(first_contours_.back() - first_contours_.front(), no_index);
  }

  Large_vector<Slab_arc> operator()(const std::vector<Large_vector<Slab_arc>>& arcs_of_slabs)
  {
    Large_vector<Slab_arc> arcs;
    for(Index slab = 0; slab != arcs_of_slabs.size(); ++slab)
    {
      for(const Slab_arc& arc : arcs_of_slabs[slab])
      {
        const Index lower = name(slab, arc.lower), upper = name(slab, arc.upper);
        if(is_contour(lower))
          upper_ends_[lower - first_contours_.front()] = upper;
        else
          arcs.push_back({lower, upper, arc.first_step});
      }
    }
    for(Slab_arc& arc : arcs)
    {
      while(is_contour(arc.upper))
      {
        const Index upper_end = upper_ends_[arc.upper - first_contours_.front()];
        if(upper_end == no_index || (is_contour(upper_end) && upper_end <= arc.upper))
          slicing_.complex().throw_contradiction_near(arc.first_step.target);
        arc.upper = upper_end;
      }
    }
    return arcs;
  }

private:
  bool is_contour(Index node) const { return node >= first_contours_.front(); }

  // Of a node of a slab: contours are numbered behind the critical vertices, level by level.
  Index name(Index number, Index node) const
  {
    const Slab<Complex> slab = slicing_.slab(number);
    if(node < slab.critical_vertices().size())
      return slicing_.critical_vertex(number, node);
    const bool is_upper = slab.is_contour_node(true, node);
    return first_contours_[is_upper ? number : number - 1] + (node - slab.contour_node(is_upper, 0));
  }

  const Slicing<Complex>& slicing_;
  Large_vector<Index> first_contours_; // by level
  Large_vector<Index> upper_ends_;     // by contour
};

} // namespace internal
} // namespace Reeb_graph
} // namespace CGAL

#endif // CGAL_REEB_GRAPH_INTERNAL_SLABS_GLUING_H
