// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of the CGAL-style package Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_INTERNAL_SIMPLIFICATION_ARC_REMOVAL_H
#define CGAL_REEB_GRAPH_INTERNAL_SIMPLIFICATION_ARC_REMOVAL_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/internal/base/Index.h>
#include <CGAL/Reeb_graph/internal/simplification/Leaf_pruning.h>
#include <CGAL/Reeb_graph/internal/simplification/persistence.h>
#include <CGAL/Reeb_graph/internal/simplification/remove_small_loops.h>

#include <algorithm>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Reeb_graph {
namespace internal {

// Removes the arcs of a graph until nothing more can go, what is less persistent first, and of the same persistence
// branches before loops. It is told how far it has come when an arc goes.
class Arc_removal
{
public:
  // By node, the values.
  Arc_removal(const std::vector<Leaf_pruning::Arc>& arcs, std::vector<double> values)
    : values_(std::move(values)),
      pruning_(static_cast<Index>(values_.size()), arcs, std::vector<double>(values_.size() + arcs.size(), 0)),
      persistences_(arcs.size(), not_removed),
      measures_(values_.size())
  {}

  // By arc, the persistence that was reached when it was removed; negative if it never was.
  std::vector<double> operator()()
  {
    double threshold = 0;
    bool is_loop_left = true;
    while(is_loop_left)
    {
      prune(threshold);
      double next_threshold = std::numeric_limits<double>::infinity();
      is_loop_left = false;
      const auto is_small = [&](Index split, Index join) {
        const double size = difference(split, join);
        if(size <= threshold)
          return true;
        next_threshold = (std::min)(next_threshold, size);
        is_loop_left = true;
        return false;
      };
      if(remove_small_loops(pruning_, is_small))
      {
        mark_removed(threshold);
        is_loop_left = true;
      }
      else
        threshold = next_threshold;
    }
    prune(std::numeric_limits<double>::infinity());
    return std::move(persistences_);
  }

private:
  static constexpr double not_removed = -1;

  double difference(Index lower, Index upper) const { return persistence(values_[lower], values_[upper]); }

  void prune(double threshold)
  {
    const auto measure = [&](const Leaf_arc& arc) {
      return measures_[arc.leaf] =
               persistence_of_leaf_arc(arc, [&](Index lower, Index upper) { return difference(lower, upper); });
    };
    const auto mark = [&](Index leaf) {
      reached_ = (std::max)(reached_, measures_[leaf]);
      mark_pieces(pruning_.arc_of_leaf(leaf));
    };
    pruning_(
      measure, [](const Leaf_arc&) { return true; }, [&](double size) { return size <= threshold; },
      [](Index) { return true; }, mark);
  }

  // Marks the arcs that have gone with loops: those that no arc has taken up in one piece.
  void mark_removed(double threshold)
  {
    reached_ = (std::max)(reached_, threshold);
    std::vector<bool> is_part(persistences_.size(), false);
    for(Index arc = 0; arc != pruning_.number_of_arcs(); ++arc)
    {
      if(pruning_.is_left(pruning_.place_of_arc(arc)))
        pruning_.for_each_piece(arc, [&](Index piece) { is_part[piece] = true; });
    }
    for(Index arc = 0; arc != pruning_.number_of_arcs(); ++arc)
    {
      if(!is_part[arc] && persistences_[arc] == not_removed)
        persistences_[arc] = reached_;
    }
  }

  void mark_pieces(Index arc)
  {
    pruning_.for_each_piece(arc, [&](Index piece) { persistences_[piece] = reached_; });
  }

  std::vector<double> values_;
  Leaf_pruning pruning_;
  std::vector<double> persistences_, measures_; // by arc; by leaf, the last ones
  double reached_ = 0;
};

} // namespace internal
} // namespace Reeb_graph
} // namespace CGAL

#endif // CGAL_REEB_GRAPH_INTERNAL_SIMPLIFICATION_ARC_REMOVAL_H
