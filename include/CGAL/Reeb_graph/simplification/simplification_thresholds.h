// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_SIMPLIFICATION_SIMPLIFICATION_THRESHOLDS_H
#define CGAL_REEB_GRAPH_SIMPLIFICATION_SIMPLIFICATION_THRESHOLDS_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/graph_topology.h>
#include <CGAL/Reeb_graph/internal/base/Index.h>
#include <CGAL/Reeb_graph/internal/base/Scalar_conversion.h>
#include <CGAL/Reeb_graph/internal/graph/Leaf_pruning.h>
#include <CGAL/Reeb_graph/internal/graph/graph_loops.h>
#include <CGAL/Reeb_graph/named_parameters.h>
#include <CGAL/Reeb_graph/simplification/persistence_pairs.h>
#include <CGAL/Reeb_graph/simplification/simplify.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <map>
#include <queue>
#include <tuple>
#include <utility>
#include <vector>

namespace CGAL::Reeb_graph::internal {

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

// Between two persistences that follow each other.
struct Persistence_gap
{
  double lower, upper;
  std::size_t number_below; // of persistences

  double width() const { return upper / lower; } // on a logarithmic scale
  double middle() const { return std::sqrt(lower) * std::sqrt(upper); }
};

constexpr double least_width_of_gap = 1.25;
constexpr double least_visible_part = 0.001; // of the range: nobody sees what is smaller

// The gaps that are wide, ascending, up to the one below the range. What is not visible lies below all of them.
inline std::vector<Persistence_gap> find_wide_gaps(std::vector<double> persistences, double range)
{
  std::vector<Persistence_gap> gaps;
  double lower = least_visible_part * range;
  if(!(lower > 0) || !std::isfinite(range))
    return gaps;
  std::sort(persistences.begin(), persistences.end());
  persistences.push_back(range);
  for(std::size_t i = 0; i != persistences.size(); ++i)
  {
    const Persistence_gap gap = {lower, persistences[i], i};
    if(gap.width() >= least_width_of_gap && std::isfinite(gap.upper))
      gaps.push_back(gap);
    lower = (std::max)(lower, gap.upper);
  }
  return gaps;
}

// Of what is left of a graph.
struct Pruning_state
{
  std::size_t nodes, arcs, leaves;
};

inline Pruning_state size_of_rest(const Leaf_pruning& pruned)
{
  return {pruned.number_of_nodes_left(), pruned.number_of_arcs_left(), pruned.number_of_leaves()};
}

// By number of branches that simplify() has removed with ever larger thresholds, what is left then; and for each of them
// its persistence, which is at least that of the one before.
struct Pruning_history
{
  std::vector<Pruning_state> states;
  std::vector<double> persistences;
};

template <class ReebGraph>
Pruning_history prune_step_by_step(const ReebGraph& graph, const std::vector<double>& values)
{
  Leaf_pruning pruned(static_cast<Index>(num_vertices(graph)), read_arcs(graph),
                      std::vector<double>(num_vertices(graph) + num_edges(graph)));
  Pruning_history history;
  const auto measure = [&](const Leaf_arc& arc) {
    return persistence_of_leaf_arc(arc,
                                   [&](Index lower, Index upper) { return persistence(values[lower], values[upper]); });
  };
  pruned(measure, [&](Index, double size) {
    history.states.push_back(size_of_rest(pruned));
    history.persistences.push_back(history.persistences.empty() ? size : (std::max)(size, history.persistences.back()));
    return true;
  });
  history.states.push_back(size_of_rest(pruned));
  return history;
}

// The logarithm of the probability, but for a constant, that a person means what is above a gap. It grows with the width
// of the gap, and the nearer the number of leaves is to that of a body with a head or a tail, two arms, and some legs.
inline double plausibility(double width_of_gap, std::size_t number_of_leaves)
{
  constexpr double expected_number_of_leaves = 7, power = 1.5;
  const double leaves = static_cast<double>((std::max)(number_of_leaves, std::size_t(1)));
  return std::log(width_of_gap) - power * std::abs(std::log(leaves / expected_number_of_leaves));
}

// The thresholds in the wide gaps of the persistences of branches and, if these are cancelled, loops.
template <class ReebGraph, class NamedParameters>
std::vector<Simplification_threshold> find_thresholds(const ReebGraph& graph,
                                                      const std::vector<double>& values,
                                                      double range,
                                                      const NamedParameters& np)
{
  typedef Branch<typename boost::graph_traits<ReebGraph>::vertex_descriptor> Branch;
  const bool are_loops_cancelled = internal::parameter_or(np, internal::cancel_loops, false);
  const Pruning_history history =
    are_loops_cancelled ? Pruning_history{{}, arc_persistences(graph, np)} : prune_step_by_step(graph, values);
  const auto& persistences = history.persistences;
  std::vector<Simplification_threshold> thresholds;
  // With loops, the largest branches of components are among them, and nothing removes these.
  const auto is_removable = [&](double size) { return !are_loops_cancelled || size < range; };
  if(std::none_of(persistences.begin(), persistences.end(), is_removable))
    return thresholds;
  const std::size_t components = number_of_components(graph);
  for(const Persistence_gap& gap : find_wide_gaps(persistences, range))
  {
    const auto [nodes, arcs, leaves] = are_loops_cancelled ? size_of_rest(prune_graph<Branch>(graph, gap.middle(), np))
                                                           : history.states[gap.number_below];
    thresholds.push_back({gap.middle(), gap.width(), nodes, leaves, arcs + components - nodes, false});
  }
  return thresholds;
}

// The most plausible ones, ascending.
inline std::vector<Simplification_threshold> choose_thresholds(std::vector<Simplification_threshold> thresholds)
{
  constexpr std::size_t largest_number = 6;
  std::stable_sort(thresholds.begin(), thresholds.end(), [](const auto& a, const auto& b) {
    return plausibility(a.gap, a.leaves) > plausibility(b.gap, b.leaves);
  });
  if(thresholds.size() > largest_number)
    thresholds.resize(largest_number);
  if(!thresholds.empty())
    thresholds.front().is_suggested = true;
  std::sort(thresholds.begin(), thresholds.end(),
            [](const auto& a, const auto& b) { return a.threshold < b.threshold; });
  return thresholds;
}

} // namespace CGAL::Reeb_graph::internal

namespace CGAL::Reeb_graph {

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
  static_assert(
    internal::are_met<internal::Plain_reeb_graph<ReebGraph>, internal::Nodes_have_numbers<ReebGraph, NamedParameters>>);
  const std::vector<internal::Ascending_arc> arcs = internal::read_arcs(graph);
  const std::vector<double> values = internal::numbers_of_nodes(graph, np);
  std::vector<double> persistences = internal::Arc_removal(arcs, values)();
  const std::vector<double> ranges = internal::component_ranges(arcs, values);
  for(std::size_t i = 0; i != arcs.size(); ++i)
    if(persistences[i] < 0)
      persistences[i] = ranges[arcs[i].lower];
  return persistences;
}

/// \ingroup PkgReebGraphSimplification
///
/// \brief finds the few thresholds that matter for `simplify()`. They lie in wide gaps of the persistences, so branches
/// that are removed are clearly smaller than those that stay.
///
/// Noise gives many pairs whose persistences are close together, up to about twice its amplitude, and features are more
/// persistent; see \cgalCite{cgos-pbcrm-13}, which takes the widest gap. Here, a gap is the ratio of two persistences
/// that follow each other. So units do not matter, and a limb that is ten times as long as another one does not hide
/// the gap below that one. The persistences are those with which `simplify()` removes branches, and with `cancel_loops`
/// loops; the range of the largest connected component lies above all of them. Persistences below a thousandth of this
/// range count as that. So there is a wide gap below the few features of a smooth field, and they all stay. A gap is
/// wide if the ratio is 1.25 or more.
///
/// Let \f$ r \f$ be the ratio, and \f$ l \f$ the number of leaves that stay. The suggested threshold has the greatest
/// \f$ \ln r - 1.5\, |\ln (l / 7)| \f$: the widest gap, with a prior expectation of about seven leaves, as head, tail
/// and limbs of a body. The expectation decides where a shape has details of all sizes, and no gap is much wider than
/// the other ones; a gap of noise outweighs it.
///
/// With \f$ n \f$ nodes and arcs, it takes \f$ O(n \log n) \f$ time; with `cancel_loops` the time of `simplify()` for
/// each wide gap, of which there are at most 31.
///
/// \tparam ReebGraph the type `Graph` of the traits class
/// \tparam OutputIterator a model of `OutputIterator` for `Simplification_threshold`
/// \tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"
///
/// \param graph a Reeb graph, computed with any named parameters
/// \param thresholds the output, ascending: the suggested threshold, and the best of the others by the same measure, at
/// most six in all. There is none if nothing can be removed, or if no gap is wide
/// \param np an optional sequence of \ref bgl_namedparameters "Named Parameters": `cancel_loops` and `geom_traits`, as
/// for `simplify()`
///
/// \pre Arcs lead to nodes of higher number.
///
/// \reebGraphComplexity
///
/// \returns the output iterator behind the last threshold.
///
/// \exception Reeb_graph::Parameter_error if the number of a value is NaN
/// \exception Reeb_graph::Graph_mismatch_error if an arc does not lead to a node of higher number
template <class ReebGraph, class OutputIterator, class NamedParameters = parameters::Default_named_parameters>
OutputIterator simplification_thresholds(const ReebGraph& graph,
                                         OutputIterator thresholds,
                                         const NamedParameters& np = parameters::default_values())
{
  static_assert(internal::are_met<internal::Augmented_reeb_graph<ReebGraph>,
                                  internal::Nodes_have_numbers<ReebGraph, NamedParameters>>);
  const std::vector<double> values = internal::numbers_of_nodes(graph, np);
  const std::vector<double> ranges = internal::component_ranges(internal::read_arcs(graph), values);
  if(num_edges(graph) == 0)
    return thresholds;
  const double range = *std::max_element(ranges.begin(), ranges.end());
  for(const auto& threshold : internal::choose_thresholds(internal::find_thresholds(graph, values, range, np)))
    *thresholds++ = threshold;
  return thresholds;
}

} // namespace CGAL::Reeb_graph

#endif // CGAL_REEB_GRAPH_SIMPLIFICATION_SIMPLIFICATION_THRESHOLDS_H
