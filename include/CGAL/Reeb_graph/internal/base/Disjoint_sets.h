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

#include <numeric>
#include <utility>

namespace CGAL {
namespace Reeb_graph {
namespace internal {

// The top of the set of an element, where parent(element) is a reference to what it has been put on: itself at the top.
// Paths are halved on the way.
template <class Parent>
Index find_top(Index element, const Parent& parent)
{
  while(parent(element) != element)
    element = parent(element) = parent(parent(element));
  return element;
}

// Disjoint sets of numbers. The top of a set stands for all of it.
class Disjoint_sets
{
public:
  explicit Disjoint_sets(Index size) : parents_(size) { std::iota(parents_.begin(), parents_.end(), Index(0)); }

  Index top(Index element)
  {
    return find_top(element, [&](Index i) -> Index& { return parents_[i]; });
  }

  // Joins two sets, of which `old_top` and `top` are the tops; the latter is that of both then.
  void put_on(Index old_top, Index top) { parents_[old_top] = top; }

  void unite(Index a, Index b) { put_on(top(a), top(b)); }

  // By element, the top of its set. To be called at last.
  Large_vector<Index> take_tops()
  {
    for(Index& parent : parents_)
      parent = top(parent);
    return std::move(parents_);
  }

private:
  Large_vector<Index> parents_;
};

} // namespace internal
} // namespace Reeb_graph
} // namespace CGAL

#endif // CGAL_REEB_GRAPH_INTERNAL_BASE_DISJOINT_SETS_H
