// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
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
#include <CGAL/Reeb_graph/internal/graph/Leaf_pruning.h>
#include <CGAL/Reeb_graph/internal/graph/elder_rule.h>
#include <CGAL/Reeb_graph/internal/graph/graph_loops.h>
#include <CGAL/Reeb_graph/internal/graph/read_graph.h>

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
class Arc_removal : private Leaf_pruning
{
public:
  // By node, the values.
  Arc_removal(const std::vector<Ascending_arc>& arcs, const std::vector<double>& values)
    : Leaf_pruning(static_cast<Index>(values.size()), arcs, std::vector<double>(values.size() + arcs.size(), 0)),
      values_(values),
      persistences_(arcs.size(), not_removed)
  {
    pair_loops(arcs, number_of_nodes(), [&](Index split, Index join) { ++numbers_of_loops_[{split, join}]; });
    for(Index arc = 0; arc != number_of_arcs(); ++arc)
      Arc_removal::see_joined_arc(arc);
  }

  // By arc, the persistence that was reached when it was removed; negative if it never was.
  std::vector<double> operator()()
  {
    const auto measure = [&](const Leaf_arc& arc) {
      return persistence_of_leaf_arc(arc, [&](Index lower, Index upper) { return difference(lower, upper); });
    };
    Leaf_pruning::operator()(measure, [&](Index leaf, double size) {
      mark_pieces(arc_of_leaf(leaf), size);
      return true;
    });
    return std::move(persistences_);
  }

private:
  typedef std::tuple<double, Index, Index> Side_of_loop; // persistence, arc, join saddle

  static constexpr double not_removed = -1;

  // Removes a side of the least persistent loop, if it is less persistent than the next branch. It is taken up by the
  // other side, or where more than two arcs leave the split saddle, by that node.
  Index remove_other_arc(double persistence_of_branch) override
  {
    for(; !sides_.empty(); sides_.pop())
    {
      const auto [size, side, join] = sides_.top();
      const Index split = arc(side).lower;
      const auto loops = numbers_of_loops_.find({split, join});
      if(!is_left(place_of_arc(side)) || arc(side).upper != join || loops->second == 0)
        continue;
      if(persistence_of_branch <= size)
        return no_index;
      --loops->second;
      mark_pieces(side, size);
      const bool has_other_side = out_degree(split) == 2;
      remove_arc(side, has_other_side ? place_of_arc(other_arc_above(split, side)) : split);
      return side;
    }
    return no_index;
  }

  // An arc may be a side of a loop as soon as it comes to be.
  void see_joined_arc(Index number) override
  {
    const auto [lower, upper] = arc(number);
    if(numbers_of_loops_.count({lower, upper}) != 0)
      sides_.emplace(difference(lower, upper), number, upper);
  }

  double difference(Index lower, Index upper) const { return persistence(values_[lower], values_[upper]); }

  void mark_pieces(Index arc, double size)
  {
    reached_ = (std::max)(reached_, size);
    for_each_piece(arc, [&](Index piece) { persistences_[piece] = reached_; });
  }

  const std::vector<double>& values_;
  std::vector<double> persistences_;                          // by arc
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
/// \pre Arcs lead to nodes of higher number.
///
/// \reebGraphComplexity
///
/// \returns a number for each arc, in the order of `edges(graph)` and in units of the field. Arcs that stay for any
/// threshold have the difference between the highest and the lowest value of their connected component.
///
/// \exception Reeb_graph::Parameter_error if the number of a value is NaN
/// \exception Reeb_graph::Graph_mismatch_error if an arc does not lead to a node of higher number
template <class ReebGraph, class NamedParameters = parameters::Default_named_parameters>
std::vector<double> arc_persistences(const ReebGraph& graph, const NamedParameters& np = parameters::default_values())
{
  std::vector<double> persistences;
  if constexpr(internal::Plain_graph_of_numbers<ReebGraph, NamedParameters>::value)
  {
    const std::vector<internal::Ascending_arc> arcs = internal::read_arcs(graph);
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
