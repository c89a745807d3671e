// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of the CGAL-style package Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_INTERNAL_BASE_DISJOINT_SETS_H
#define CGAL_REEB_GRAPH_INTERNAL_BASE_DISJOINT_SETS_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/internal/base/Index.h>
#include <CGAL/Reeb_graph/internal/base/Large_vector.h>
#include <CGAL/Reeb_graph/internal/base/prefetch.h>

#include <numeric>
#include <utility>

namespace CGAL {
namespace Reeb_graph {
namespace internal {

// The root of the set of an element, where parent(element) is a reference to the element that it has been linked to:
// itself at the root. Paths are halved on the way.
template <class Parent>
Index find_root(Index element, const Parent& parent)
{
  while(parent(element) != element)
    element = parent(element) = parent(parent(element));
  return element;
}

// Disjoint sets of numbers. The root of a set stands for all of it.
class Disjoint_sets
{
public:
  explicit Disjoint_sets(Index size) : parents_(size) { std::iota(parents_.begin(), parents_.end(), Index(0)); }

  Index find(Index element)
  {
    return find_root(element, [&](Index i) -> Index& { return parents_[i]; });
  }

  // Joins two sets, given by their roots; `root` is the root of both then.
  void link(Index old_root, Index root) { parents_[old_root] = root; }

  void unite(Index a, Index b) { link(find(a), find(b)); }

  // By element, the root of its set. To be called at last.
  Large_vector<Index> take_roots()
  {
    for(Index& parent : parents_)
      parent = find(parent);
    return std::move(parents_);
  }

private:
  Large_vector<Index> parents_;
};

// The components of sublevel or superlevel sets that merge in a sweep: disjoint sets, each with a top, the node at which
// the sweep has met it last. Both in one place, as a sweep jumps about in memory.
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

  Index find(Index component)
  {
    return find_root(component, [&](Index i) -> Index& { return components_[i].parent; });
  }

  // Joins two components, given by their roots; `root` is the root of both then, and its top is that of both.
  void link(Index old_root, Index root) { components_[old_root].parent = root; }

  Index top(Index root) const { return components_[root].top; }
  void set_top(Index root, Index node) { components_[root].top = node; }

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

#endif // CGAL_REEB_GRAPH_INTERNAL_BASE_DISJOINT_SETS_H
