// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of the CGAL-style package Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_INTERNAL_BASE_MERGING_COMPONENTS_H
#define CGAL_REEB_GRAPH_INTERNAL_BASE_MERGING_COMPONENTS_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/internal/base/Disjoint_sets.h>
#include <CGAL/Reeb_graph/internal/base/Index.h>
#include <CGAL/Reeb_graph/internal/base/Large_vector.h>
#include <CGAL/Reeb_graph/internal/base/prefetch.h>

namespace CGAL {
namespace Reeb_graph {
namespace internal {

// The components of sublevel or superlevel sets that a sweep merges: disjoint sets, each with a top, the node that has
// been put on it last. Both in one place, as a sweep jumps about in memory.
class Merging_components
{
public:
  Index size() const { return static_cast<Index>(components_.size()); }

  // Adds a component of which `node` is all. Returns its number.
  Index add(Index node)
  {
    components_.push_back({size(), node});
    return size() - 1;
  }

  // The component of which the given one has become part.
  Index find(Index component)
  {
    return find_top(component, [&](Index i) -> Index& { return components_[i].parent; });
  }

  // For components that are no part of another one.
  Index top(Index component) const { return components_[component].top; }
  void set_top(Index component, Index node) { components_[component].top = node; }
  void make_part_of(Index component, Index larger) { components_[component].parent = larger; }

  // To be called ahead of find(). For any number.
  void prefetch(Index component) const { prefetch_element(components_, component); }

private:
  struct Component
  {
    Index parent;
    Index top;
  };

  Large_vector<Component> components_;
};

} // namespace internal
} // namespace Reeb_graph
} // namespace CGAL

#endif // CGAL_REEB_GRAPH_INTERNAL_BASE_MERGING_COMPONENTS_H
