// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_INTERNAL_GRAPH_LEAF_QUEUE_H
#define CGAL_REEB_GRAPH_INTERNAL_GRAPH_LEAF_QUEUE_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/internal/base/Index.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <limits>
#include <queue>
#include <utility>
#include <vector>

namespace CGAL::Reeb_graph::internal {

// Leaves by their measures, from the least one. A leaf that is pushed again has a new measure. Those that are there at
// first are sorted, and only later ones are in a heap: a sweep over memory instead of jumps.
class Leaf_queue
{
public:
  typedef std::pair<double, Index> Sized_leaf;

  explicit Leaf_queue(Index number_of_nodes) : measures_(number_of_nodes) {}

  // A leaf whose measure is NaN is not there.
  void push(double measure, Index leaf)
  {
    measures_[leaf] = measure;
    if(std::isnan(measure))
      return;
    if(is_sorted_)
      later_.emplace(measure, leaf);
    else
      first_.emplace_back(measure, leaf);
  }

  // To be called once, before the first pop().
  void sort()
  {
    std::sort(first_.begin(), first_.end());
    is_sorted_ = true;
  }

  // The least measure and its leaf, which stays; NaN and no_index if there is none.
  Sized_leaf top()
  {
    while(next_ != first_.size() || !later_.empty())
    {
      const Sized_leaf& leaf = is_first() ? first_[next_] : later_.top();
      if(measures_[leaf.second] == leaf.first)
        return leaf;
      pop();
    }
    return {std::numeric_limits<double>::quiet_NaN(), no_index};
  }

  // Removes the leaf of least measure; there has to be one.
  void pop()
  {
    if(is_first())
      ++next_;
    else
      later_.pop();
  }

private:
  bool is_first() const { return later_.empty() || (next_ != first_.size() && first_[next_] < later_.top()); }

  std::vector<double> measures_; // the last ones
  std::vector<Sized_leaf> first_;
  std::size_t next_ = 0;
  bool is_sorted_ = false;
  std::priority_queue<Sized_leaf, std::vector<Sized_leaf>, std::greater<Sized_leaf>> later_;
};

} // namespace CGAL::Reeb_graph::internal

#endif // CGAL_REEB_GRAPH_INTERNAL_GRAPH_LEAF_QUEUE_H
