// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of the CGAL-style package Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_INTERNAL_ARCS_TIE_GROUPS_H
#define CGAL_REEB_GRAPH_INTERNAL_ARCS_TIE_GROUPS_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/internal/base/Disjoint_sets.h>
#include <CGAL/Reeb_graph/internal/base/Index.h>
#include <CGAL/Reeb_graph/internal/base/Indexed_vector.h>
#include <CGAL/Reeb_graph/internal/critical_vertices/Swept_vertices.h>
#include <CGAL/Reeb_graph/internal/slabs/Slab_arc.h>
#include <CGAL/Reeb_graph/options.h>

namespace CGAL {
namespace Reeb_graph {
namespace internal {

// The groups that critical vertices form: each one alone, or if ties are contracted, those that arcs of length zero
// connect.
template <class Order>
class Tie_groups
{
public:
  Tie_groups(const Order& order, const Swept_vertices& critical_vertices, const Slab_arcs& arcs, Ties ties)
    : order_(order),
      critical_vertices_(critical_vertices),
      are_ties_contracted_(ties == Ties::CONTRACT)
  {
    if(!are_ties_contracted_)
      return;
    is_on_plateau_.renew(critical_vertices.size(), false);
    Disjoint_sets<Swept_index> groups(critical_vertices.size());
    for(const Slab_arc& arc : arcs)
    {
      if(!is_contracted(arc))
        continue;
      groups.unite(arc.lower_vertex(), arc.upper_vertex());
      is_on_plateau_[arc.lower_vertex()] = is_on_plateau_[arc.upper_vertex()] = true;
    }
    groups_ = groups.take_roots();
  }

  bool are_ties_contracted() const { return are_ties_contracted_; }

  bool is_contracted(const Slab_arc& arc) const
  {
    return are_ties_contracted_
        && order_.are_tied(critical_vertices_.vertex(arc.lower_vertex()),
                           critical_vertices_.vertex(arc.upper_vertex()));
  }

  // A group has the name of one of its critical vertices.
  Swept_index group_of(Swept_index critical) const { return are_ties_contracted_ ? groups_[critical] : critical; }

  // Whether there are others in the group.
  bool is_on_plateau(Swept_index critical) const { return are_ties_contracted_ && is_on_plateau_[critical]; }

private:
  const Order& order_;
  const Swept_vertices& critical_vertices_;
  const bool are_ties_contracted_;
  // Groups and plateaus are empty unless ties are contracted.
  Indexed_vector<Swept_index, Swept_index> groups_;
  Indexed_vector<Swept_index, bool> is_on_plateau_;
};

} // namespace internal
} // namespace Reeb_graph
} // namespace CGAL

#endif // CGAL_REEB_GRAPH_INTERNAL_ARCS_TIE_GROUPS_H
