// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of the CGAL-style package Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_INTERNAL_MONOTONE_PATHS_H
#define CGAL_REEB_GRAPH_INTERNAL_MONOTONE_PATHS_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/internal/Index.h>
#include <CGAL/Reeb_graph/internal/Large_vector.h>
#include <CGAL/Reeb_graph/internal/Zeroed_array.h>
#include <CGAL/Reeb_graph/internal/ascending_path.h>
#include <CGAL/Reeb_graph/internal/parallel.h>

namespace CGAL {
namespace Reeb_graph {
namespace internal {

// Finds the extremum in which a monotone path ends: a minimum for the join tree, a maximum for the split tree.
// A vertex is passed once: its end is kept. Several threads that pass it keep the same end.
template <class Complex, class Order, bool is_ascending>
class Monotone_path_ends
{
public:
  Monotone_path_ends(const Complex& complex, const Order& order)
    : complex_(&complex),
      order_(&order),
      ends_(complex.number_of_vertices())
  {}

  void set_end(Index vertex, Index end) { ends_[vertex].set(end + 1); }
  Index end(Index vertex) const { return ends_[vertex].get() - 1; }
  bool is_known(Index vertex) const { return end(vertex) != no_index; }

  // A path goes on to the first suitable neighbor.
  Ascending_step step(Index vertex) const
  {
    Ascending_step step = {no_index, no_index};
    complex_->visit_edges_around(vertex, [&](Index neighbor, Index halfedge) {
      if(is_ascending ? !(*order_)(vertex, neighbor) : !(*order_)(neighbor, vertex))
        return false;
      step = {halfedge, neighbor};
      return true;
    });
    return step;
  }

  // The end of the path that begins with `step`. A step of which end_of_step(step) is not no_index is the last one.
  // `passed` is storage for the vertices on the way.
  template <class EndOfStep>
  Index operator()(Ascending_step step, const EndOfStep& end_of_step, Large_vector<Index>& passed)
  {
    passed.clear();
    Index end = end_of_step(step);
    while(end == no_index && (end = this->end(step.target)) == no_index)
    {
      passed.push_back(step.target);
      step = this->step(step.target);
      end = end_of_step(step);
    }
    for(const Index vertex : passed)
      set_end(vertex, end);
    return end;
  }

private:
  const Complex* complex_;
  const Order* order_;
  Zeroed_array<Relaxed_value<Index>> ends_; // by vertex: the number behind the end, so that 0 is no_index
};

} // namespace internal
} // namespace Reeb_graph
} // namespace CGAL

#endif // CGAL_REEB_GRAPH_INTERNAL_MONOTONE_PATHS_H
