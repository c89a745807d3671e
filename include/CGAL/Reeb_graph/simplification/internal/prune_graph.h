// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_SIMPLIFICATION_INTERNAL_PRUNE_GRAPH_H
#define CGAL_REEB_GRAPH_SIMPLIFICATION_INTERNAL_PRUNE_GRAPH_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/internal/base/Index.h>
#include <CGAL/Reeb_graph/internal/base/graph_requirements.h>
#include <CGAL/Reeb_graph/internal/base/named_parameter.h>
#include <CGAL/Reeb_graph/named_parameters.h>
#include <CGAL/Reeb_graph/simplification/Simplification.h>
#include <CGAL/Reeb_graph/simplification/exceptions.h>
#include <CGAL/Reeb_graph/simplification/internal/Leaf_pruning.h>
#include <CGAL/Reeb_graph/simplification/internal/persistence.h>

#include <boost/graph/graph_traits.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <limits>
#include <memory>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL::Reeb_graph::internal {

// By arc, its place in the order of lower nodes, from below, and then of upper nodes, from above.
inline std::vector<Index> rank_arcs(const Leaf_pruning& graph, std::vector<Index> arcs)
{
  std::sort(arcs.begin(), arcs.end(), [&](Index a, Index b) {
    return std::make_tuple(graph.arc(a).lower, graph.arc(b).upper, a)
         < std::make_tuple(graph.arc(b).lower, graph.arc(a).upper, b);
  });
  std::vector<Index> ranks(graph.number_of_arcs(), no_index);
  for(Index i = 0; i != arcs.size(); ++i)
    ranks[arcs[i]] = i;
  return ranks;
}

// Removes one side of each loop that `is_small(split saddle, join saddle)` names and that has a single arc on this
// side. The arc is taken up by the lowest one of the other side. Returns whether there has been such a loop. As for
// pairs, a forest is maximal by lower ends; as no other loop has passed the arc by then, the other loops keep their
// nodes.
template <class IsSmall>
bool remove_small_loops(Leaf_pruning& graph, const IsSmall& is_small)
{
  bool is_changed = false;
  std::vector<bool> is_left(graph.number_of_arcs());
  for(Index arc = 0; arc != graph.number_of_arcs(); ++arc)
    is_left[arc] = graph.is_left(graph.place_of_arc(arc));
  const std::vector<Index> arcs =
    core_arcs(graph.number_of_nodes(), std::move(is_left), [&](Index arc) { return graph.arc(arc); });
  const std::vector<Index> ranks = rank_arcs(graph, arcs);
  Highest_forest forest(checked_index(2 * std::size_t(graph.number_of_nodes())) / 2);
  for(const Index arc : arcs)
  {
    const auto [lower, upper] = graph.arc(arc);
    const auto cycle = forest.add({lower, upper, ranks[arc], arc});
    if(cycle.leaving == no_index)
      continue;
    const auto [split, join] = graph.arc(cycle.leaving);
    if(join != upper || !is_small(split, join))
      continue;
    const bool is_other_known = cycle.lowest_other != cycle.leaving;
    const Index owner = is_other_known               ? graph.place_of_arc(cycle.lowest_other)
                      : graph.out_degree(split) == 2 ? graph.place_of_arc(graph.other_arc_above(split, cycle.leaving))
                                                     : split;
    graph.remove_arc(cycle.leaving, owner);
    is_changed = true;
  }
  return is_changed;
}

template <class NamedParameters>
std::vector<double> read_piece_weights(std::size_t number_of_pieces, const NamedParameters& np)
{
  const auto parameter = parameters::get_parameter(np, piece_weights);
  std::vector<double> weights;
  if constexpr(is_given<decltype(parameter)>)
  {
    weights.assign(std::begin(parameter), std::end(parameter));
    if(weights.size() != number_of_pieces)
      throw Piece_count_error(weights.size(), number_of_pieces);
    if(std::any_of(weights.begin(), weights.end(), [](double weight) { return std::isnan(weight); }))
      throw Measure_error("weight of a piece");
  }
  else
    weights.assign(number_of_pieces, 0);
  return weights;
}

template <class Branch, class NamedParameters>
double measure_of_branch(const Branch& branch, const NamedParameters& np)
{
  const auto& measure = parameters::get_parameter(np, branch_measure);
  if constexpr(is_given<decltype(measure)>)
  {
    const double size = measure(branch);
    if(std::isnan(size))
      throw Measure_error("measure of a branch");
    return size;
  }
  else
    return is_given<decltype(parameters::get_parameter(np, piece_weights))> ? branch.weight : branch.persistence;
}

// The graph without its small branches and, if asked for, loops; see simplify().
template <class Branch, class ReebGraph, class NamedParameters>
Leaf_pruning prune_graph(const ReebGraph& graph, double threshold, const NamedParameters& np)
{
  using parameters::choose_parameter;
  using parameters::get_parameter;
  if(!(threshold >= 0))
    throw Threshold_error("threshold of simplification");
  const std::size_t leaves = choose_parameter(get_parameter(np, number_of_leaves), std::size_t(0));
  const bool are_loops_cancelled = choose_parameter(get_parameter(np, cancel_loops), false);

  Leaf_pruning pruned(static_cast<Index>(num_vertices(graph)), read_arcs(graph),
                      read_piece_weights(num_vertices(graph) + num_edges(graph), np));
  const std::vector<double> values = numbers_of_nodes(graph, np);
  const auto difference = [&](Index lower, Index upper) { return persistence(values[lower], values[upper]); };
  const auto measure = [&](const Leaf_arc& arc) {
    const double persistence = persistence_of_leaf_arc(arc, difference);
    const double size = measure_of_branch(Branch{arc.leaf, arc.saddle, arc.is_minimum, persistence, arc.weight}, np);
    return size < threshold || std::isinf(threshold) ? size : std::numeric_limits<double>::quiet_NaN();
  };
  const auto prune = [&] { pruned(measure, [&](Index, double) { return pruned.number_of_leaves() > leaves; }); };
  prune();
  const auto is_small = [&](Index split, Index join) { return difference(split, join) < threshold; };
  while(are_loops_cancelled && remove_small_loops(pruned, is_small))
    prune();
  return pruned;
}

// The chains of arcs that have been joined, one behind the other; an arc that has stayed as it was keeps its chain.
template <class ReebGraph>
auto join_chains(const ReebGraph& graph,
                 const std::vector<typename boost::graph_traits<ReebGraph>::edge_descriptor>& graph_arcs,
                 const Leaf_pruning& pruned,
                 const std::vector<Index>& arcs)
{
  typedef std::decay_t<decltype(graph[graph_arcs.front()].chain)> Chain;
  const auto chain_of = [&](Index arc) -> const Chain& { return graph[graph_arcs[arc]].chain; };
  std::vector<typename Chain::value_type> halfedges;
  std::vector<std::pair<std::size_t, std::size_t>> parts; // by arc, of the halfedges; empty for one that has stayed
  for(const Index arc : arcs)
  {
    std::size_t number_of_pieces = 0;
    pruned.for_each_piece(arc, [&](Index) { ++number_of_pieces; });
    const std::size_t begin = halfedges.size();
    if(number_of_pieces > 1)
      pruned.for_each_piece(
        arc, [&](Index piece) { halfedges.insert(halfedges.end(), chain_of(piece).begin(), chain_of(piece).end()); });
    parts.emplace_back(begin, halfedges.size());
  }
  const auto storage = std::make_shared<const std::vector<typename Chain::value_type>>(std::move(halfedges));
  std::vector<Chain> chains;
  for(std::size_t i = 0; i != arcs.size(); ++i)
  {
    const auto [begin, end] = parts[i];
    chains.push_back(begin == end ? chain_of(arcs[i]) : Chain(storage, begin, end - begin));
  }
  return chains;
}

// Replaces the content of `simplified` by what is left of `graph`. Nodes keep their order; arcs are sorted by lower
// node, upper node, and the first arc that they have been made of.
template <class ReebGraph>
Simplification<ReebGraph> write_simplified_graph(const ReebGraph& graph,
                                                 const Leaf_pruning& pruned,
                                                 ReebGraph& simplified)
{
  typedef typename boost::graph_traits<ReebGraph>::edge_descriptor arc_descriptor;
  const std::vector<arc_descriptor> graph_arcs(edges(graph).first, edges(graph).second);
  std::vector<Index> arcs, new_places(pruned.number_of_nodes() + graph_arcs.size(), no_index);
  for(Index arc = 0; arc != graph_arcs.size(); ++arc)
  {
    if(pruned.is_left(pruned.place_of_arc(arc)))
      arcs.push_back(arc);
  }
  std::sort(arcs.begin(), arcs.end(), [&](Index a, Index b) {
    return std::tie(pruned.arc(a).lower, pruned.arc(a).upper, a)
         < std::tie(pruned.arc(b).lower, pruned.arc(b).upper, b);
  });
  auto chains = join_chains(graph, graph_arcs, pruned, arcs);

  simplified.clear();
  for(Index node = 0; node != pruned.number_of_nodes(); ++node)
  {
    if(pruned.is_left(node))
      new_places[node] = static_cast<Index>(add_vertex(graph[node], simplified));
  }
  for(const Index arc : arcs)
    add_edge(new_places[pruned.arc(arc).lower], new_places[pruned.arc(arc).upper], simplified);
  const std::vector<arc_descriptor> new_arcs(edges(simplified).first, edges(simplified).second);
  const auto number_of_new_nodes = static_cast<Index>(num_vertices(simplified));
  for(std::size_t i = 0; i != arcs.size(); ++i)
  {
    simplified[new_arcs[i]].chain = std::move(chains[i]);
    set_arc_index(simplified, new_arcs[i], i);
    new_places[pruned.place_of_arc(arcs[i])] = static_cast<Index>(number_of_new_nodes + i);
  }
  const std::vector<Index> owners = pruned.find_owners();
  for(Index place = 0; place != new_places.size(); ++place)
  {
    if(owners[place] != no_index)
      new_places[place] = new_places[owners[place]];
  }
  return Simplification<ReebGraph>(pruned.number_of_nodes(), number_of_new_nodes, std::move(new_places), new_arcs);
}

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

// The logarithm of the probability, but for a constant, that a person means what is above a gap: the wider the gap, and
// the nearer the number of leaves to that of a body with a head or a tail, two ears or arms, and some legs.
inline double plausibility(double width_of_gap, std::size_t number_of_leaves)
{
  constexpr double expected_number_of_leaves = 7, power = 1.5;
  const double leaves = static_cast<double>((std::max)(number_of_leaves, std::size_t(1)));
  return std::log(width_of_gap) - power * std::abs(std::log(leaves / expected_number_of_leaves));
}

} // namespace CGAL::Reeb_graph::internal

#endif // CGAL_REEB_GRAPH_SIMPLIFICATION_INTERNAL_PRUNE_GRAPH_H
