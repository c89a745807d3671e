// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of the CGAL-style package Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_INTERNAL_CONTOUR_TREES_GLUE_CUTS_H
#define CGAL_REEB_GRAPH_INTERNAL_CONTOUR_TREES_GLUE_CUTS_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/internal/base/Index.h>
#include <CGAL/Reeb_graph/internal/base/Indexed_vector.h>
#include <CGAL/Reeb_graph/internal/base/Side.h>
#include <CGAL/Reeb_graph/internal/contour_trees/Loop_cuts.h>
#include <CGAL/Reeb_graph/internal/contour_trees/combine_trees.h>
#include <CGAL/Reeb_graph/internal/slabs/Slab_arc.h>

#include <algorithm>

namespace CGAL {
namespace Reeb_graph {
namespace internal {

// Arcs that end at a cut go on to the vertex just above, and the short arcs from the cut to there are dropped.
inline void glue_cuts(const Loop_cuts& cuts, Slab_arcs& arcs)
{
  if(cuts.size() == 0)
    return;
  const auto begins_at_cut = [&](const Slab_arc& arc) { return cuts.is_cut_node(arc.lower); };
  arcs.erase(std::remove_if(arcs.begin(), arcs.end(), begins_at_cut), arcs.end());
  for(Slab_arc& arc : arcs)
  {
    if(cuts.is_cut_node(arc.upper))
      arc.upper = node_of(cuts.critical_vertex(cuts.cut_of_node(arc.upper)));
  }
}

// Names the arcs, which have not been glued yet, as glue_cuts() leaves them. No vertex is on one that it drops.
inline void rename_glued_arcs(const Loop_cuts& cuts, const Slab_arcs& arcs, Arcs_of_classes& arcs_of_classes)
{
  if(cuts.size() == 0)
    return;
  Indexed_vector<Slab_arc_index, Slab_arc_index> new_names(arcs.size(), no_index);
  Slab_arc_index next(0);
  for(const Slab_arc_index i : arcs.keys())
  {
    if(cuts.is_cut_node(arcs[i].lower))
      continue;
    new_names[i] = next;
    ++next;
  }
  for(const Side side : both_sides)
  {
    for(Slab_arc_index& arc : arcs_of_classes[side])
      arc = arc == no_index ? arc : new_names[arc];
  }
}

} // namespace internal
} // namespace Reeb_graph
} // namespace CGAL

#endif // CGAL_REEB_GRAPH_INTERNAL_CONTOUR_TREES_GLUE_CUTS_H
