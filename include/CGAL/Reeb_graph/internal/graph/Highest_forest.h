// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_INTERNAL_GRAPH_HIGHEST_FOREST_H
#define CGAL_REEB_GRAPH_INTERNAL_GRAPH_HIGHEST_FOREST_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/internal/base/Index.h>
#include <CGAL/Reeb_graph/internal/base/union_find.h>
#include <CGAL/Reeb_graph/internal/graph/Link_cut_forest.h>

#include <algorithm>
#include <vector>

namespace CGAL::Reeb_graph::internal {

// A spanning forest that is maximal by the keys of its arcs, while arcs are added.
class Highest_forest
{
public:
  struct Arc
  {
    Index lower, upper;
    Index key;
    Index label;
  };

  // The labels of the arc that leaves, and of the lowest one of the cycle besides the added one; no_index if the added
  // arc closes no cycle.
  struct Cycle
  {
    Index leaving, lowest_other;
  };

  explicit Highest_forest(Index number_of_nodes)
    : number_of_nodes_(number_of_nodes),
      components_(number_of_nodes),
      forest_(2 * number_of_nodes)
  {
    arcs_.reserve(number_of_nodes);
  }

  // Adds an arc. If it closes a cycle, the arc of lowest key leaves; of equal ones the new one.
  Cycle add(const Arc& arc)
  {
    const Index lower_root = components_.find(arc.lower), upper_root = components_.find(arc.upper);
    if(lower_root != upper_root)
    {
      components_.link((std::max)(lower_root, upper_root), (std::min)(lower_root, upper_root));
      arcs_.push_back(arc);
      insert(static_cast<Index>(number_of_nodes_ + arcs_.size() - 1));
      return {no_index, no_index};
    }
    const Index lowest = forest_.lowest_on_path(arc.lower, arc.upper);
    Arc& lowest_arc = arcs_[lowest - number_of_nodes_];
    const Index lowest_label = lowest_arc.label;
    if(arc.key <= lowest_arc.key)
      return {arc.label, lowest_label};
    forest_.cut(lowest_arc.lower, lowest);
    forest_.cut(lowest_arc.upper, lowest);
    lowest_arc = arc;
    insert(lowest);
    return {lowest_label, lowest_label};
  }

private:
  // Arcs are nodes of the forest, too.
  void insert(Index place)
  {
    const Arc& arc = arcs_[place - number_of_nodes_];
    forest_.set_key(place, arc.key);
    forest_.link(place, arc.lower);
    forest_.link(place, arc.upper);
  }

  Index number_of_nodes_;
  Disjoint_sets<Index> components_;
  Link_cut_forest forest_;
  std::vector<Arc> arcs_; // those that are in the forest
};

} // namespace CGAL::Reeb_graph::internal

#endif // CGAL_REEB_GRAPH_INTERNAL_GRAPH_HIGHEST_FOREST_H
