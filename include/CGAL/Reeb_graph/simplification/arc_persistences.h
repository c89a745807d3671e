// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of the CGAL-style package Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_SIMPLIFICATION_ARC_PERSISTENCES_H
#define CGAL_REEB_GRAPH_SIMPLIFICATION_ARC_PERSISTENCES_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/internal/base/Index.h>
#include <CGAL/Reeb_graph/internal/base/graph_requirements.h>
#include <CGAL/Reeb_graph/internal/base/named_parameter.h>
#include <CGAL/Reeb_graph/simplification/internal/Leaf_pruning.h>
#include <CGAL/Reeb_graph/simplification/internal/persistence.h>

#include <algorithm>
#include <cstddef>
#include <functional>
#include <map>
#include <queue>
#include <tuple>
#include <utility>
#include <vector>

namespace CGAL::Reeb_graph {

namespace internal {

// Removes the arcs of a graph until nothing more can go, what is less persistent first, and of the same persistence
// branches before loops.
//
// A loop can go when a single arc is one of its sides: one between two nodes that are a pair. A forest that is maximal
// by lower ends never keeps this arc, so the other loops are pairs of the same nodes without it; nor do branches matter
// to these pairs. So they are found once, and each arc is looked up when it comes to be.
class Arc_removal
{
public:
  // By node, the values.
  Arc_removal(const std::vector<Pruned_arc>& arcs, std::vector<double> values)
    : values_(std::move(values)),
      pruning_(static_cast<Index>(values_.size()), arcs, std::vector<double>(values_.size() + arcs.size(), 0)),
      persistences_(arcs.size(), not_removed),
      measures_(values_.size())
  {
    pair_loops(arcs, static_cast<Index>(values_.size()), [&](Index split, Index join) {
      ++numbers_of_loops_[{split, join}];
    });
    for(Index arc = 0; arc != pruning_.number_of_arcs(); ++arc)
      see_joined_arc(arc);
  }

  // By arc, the persistence that was reached when it was removed; negative if it never was.
  std::vector<double> operator()()
  {
    const auto measure = [&](const Leaf_arc& arc) {
      return measures_[arc.leaf] =
               persistence_of_leaf_arc(arc, [&](Index lower, Index upper) { return difference(lower, upper); });
    };
    pruning_(
      measure, [](double) { return true; }, [](Index) { return true; },
      [&](Index leaf) { mark_pieces(pruning_.arc_of_leaf(leaf), measures_[leaf]); }, *this);
    return std::move(persistences_);
  }

  // Removes a side of the least persistent loop, if it is less persistent than the next branch. It is taken up by the
  // other side, or where more than two arcs leave the split saddle, by that node.
  Index remove_arc(double persistence_of_branch)
  {
    for(; !sides_.empty(); sides_.pop())
    {
      const auto [size, arc, join] = sides_.top();
      const auto loops = numbers_of_loops_.find({pruning_.arc(arc).lower, join});
      if(!pruning_.is_left(pruning_.place_of_arc(arc)) || pruning_.arc(arc).upper != join || loops->second == 0)
        continue;
      if(persistence_of_branch <= size)
        return no_index;
      --loops->second;
      mark_pieces(arc, size);
      const Index split = pruning_.arc(arc).lower;
      const bool has_other_side = pruning_.out_degree(split) == 2;
      pruning_.remove_arc(arc, has_other_side ? pruning_.place_of_arc(pruning_.other_arc_above(split, arc)) : split);
      return arc;
    }
    return no_index;
  }

  // An arc may be a side of a loop as soon as it comes to be.
  void see_joined_arc(Index arc)
  {
    const auto [lower, upper] = pruning_.arc(arc);
    if(numbers_of_loops_.count({lower, upper}) != 0)
      sides_.emplace(difference(lower, upper), arc, upper);
  }

private:
  typedef std::tuple<double, Index, Index> Side_of_loop; // persistence, arc, join saddle

  static constexpr double not_removed = -1;

  double difference(Index lower, Index upper) const { return persistence(values_[lower], values_[upper]); }

  void mark_pieces(Index arc, double size)
  {
    reached_ = (std::max)(reached_, size);
    pruning_.for_each_piece(arc, [&](Index piece) { persistences_[piece] = reached_; });
  }

  std::vector<double> values_;
  Leaf_pruning pruning_;
  std::vector<double> persistences_, measures_;               // by arc; by leaf, the last ones
  std::map<std::pair<Index, Index>, Index> numbers_of_loops_; // those that are left, by split and join saddle
  // The least persistent one first. An arc that has grown or gone since is no side any more.
  std::priority_queue<Side_of_loop, std::vector<Side_of_loop>, std::greater<Side_of_loop>> sides_;
  double reached_ = 0;
};

} // namespace internal

/// \ingroup PkgReebGraphSimplification
///
/// \brief returns for each arc how long it stays while a Reeb graph is simplified: the persistence of the branch or of
/// the loop with which it is removed.
///
/// Branches and loops are removed by the rules of `simplify()` with `parameters::cancel_loops(true)`, but one by one,
/// the less persistent first, so that what has been removed only grows. If a graph has no loops, the graph that is
/// simplified with a threshold consists of the arcs of at least this persistence. If it has loops, this is nearly so:
/// `simplify()` looks at them only when all branches below the threshold have gone, and can keep another one of
/// branches that compete.
///
/// With \f$ n \f$ nodes and arcs, the time is \f$ O(n \log n) \f$.
///
/// \tparam ReebGraph the type `Graph` of the traits class, or another bidirectional graph with `std::size_t` as vertex
///         descriptor
///
/// \param graph a Reeb graph, computed with any named parameters
/// \param np an optional sequence of \ref bgl_namedparameters "Named Parameters": `geom_traits`, as for `simplify()`
///
/// \returns a number for each arc, in the order of `edges(graph)` and in units of the field. Arcs that stay for any
/// threshold have the difference between the highest and the lowest value of their connected component.
///
/// \exception Reeb_graph::Measure_error if the number of a value is NaN
/// \exception Reeb_graph::Arc_direction_error if an arc does not lead to a node of higher number
template <class ReebGraph, class NamedParameters = parameters::Default_named_parameters>
std::vector<double> arc_persistences(const ReebGraph& graph, const NamedParameters& np = parameters::default_values())
{
  std::vector<double> persistences;
  if constexpr(internal::Plain_graph_of_numbers<ReebGraph, NamedParameters>::value)
  {
    const std::vector<internal::Pruned_arc> arcs = internal::read_arcs(graph);
    const std::vector<double> values = internal::numbers_of_nodes(graph, np);
    persistences = internal::Arc_removal(arcs, values)();

    const std::vector<double> ranges = internal::component_ranges(arcs, values);
    for(std::size_t i = 0; i != arcs.size(); ++i)
      if(persistences[i] < 0)
        persistences[i] = ranges[arcs[i].lower];
  }
  return persistences;
}

} // namespace CGAL::Reeb_graph

#endif // CGAL_REEB_GRAPH_SIMPLIFICATION_ARC_PERSISTENCES_H
