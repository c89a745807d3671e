// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_SIMPLIFICATION_SIMPLIFY_H
#define CGAL_REEB_GRAPH_SIMPLIFICATION_SIMPLIFY_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/exceptions.h>
#include <CGAL/Reeb_graph/internal/base/Index.h>
#include <CGAL/Reeb_graph/internal/base/Scalar_conversion.h>
#include <CGAL/Reeb_graph/internal/graph/Leaf_pruning.h>
#include <CGAL/Reeb_graph/internal/graph/graph_loops.h>
#include <CGAL/Reeb_graph/named_parameters.h>

#include <boost/graph/graph_traits.hpp>
#include <boost/property_map/property_map.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <memory>
#include <tuple>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

namespace CGAL::Reeb_graph {

/// \ingroup PkgReebGraphSimplification
///
/// \brief the way from a Reeb graph to its simplified graph: for each node and each arc the node or arc of the
/// simplified graph that has taken it up.
///
/// It is made by `simplify()`. As a property map, it has the nodes of the graph that has been simplified as keys:
/// `get(simplification, node)`. Copies share their memory. It holds copies of the arc descriptors of the simplified
/// graph, which must not lose arcs as long as it is used. Given to `Augmentation` as named parameter `simplification`,
/// it leads from the vertices of the mesh to the simplified graph.
///
/// \tparam ReebGraph the type of both graphs
///
/// \cgalModels{ReadablePropertyMap}
template <class ReebGraph>
class Simplification
{
public:
  typedef typename boost::graph_traits<ReebGraph>::vertex_descriptor node_descriptor; ///< a node
  typedef typename boost::graph_traits<ReebGraph>::edge_descriptor arc_descriptor; ///< an arc of the simplified graph

  /// a node or an arc: `std::holds_alternative<arc_descriptor>(place)`, `std::get<arc_descriptor>(place)`
  typedef std::variant<node_descriptor, arc_descriptor> Place;

  typedef node_descriptor key_type;                  ///< the key type
  typedef Place value_type;                          ///< the value type
  typedef Place reference;                           ///< the same
  typedef boost::readable_property_map_tag category; ///< the category

  /// returns what has taken up the node `node` of the graph that has been simplified: itself, if it is still there.
  ///
  /// \exception Graph_mismatch_error if there was no such node
  Place operator[](node_descriptor node) const { return place(index_of_node(node)); }

  /// returns what has taken up the arc number `i` of the graph that has been simplified, in the order of its `edges()`.
  ///
  /// \exception Graph_mismatch_error if there was no such arc
  Place place_of_arc(std::size_t i) const { return place(index_of_arc(i)); }

  /// returns the number of what has taken up a node: nodes of the simplified graph are numbered from 0 by their
  /// descriptors, arcs behind the last node, in the order of `edges()`. These are the numbers of `Vertex_places`.
  ///
  /// \exception Graph_mismatch_error if there was no such node
  std::size_t index_of_node(node_descriptor node) const
  {
    if(!(node < places_->number_of_old_nodes))
      throw Graph_mismatch_error("the node is not one of the graph");
    return places_->new_places[node];
  }

  /// returns the number of what has taken up the arc number `i`, in the order of `edges()`.
  ///
  /// \exception Graph_mismatch_error if there was no such arc
  std::size_t index_of_arc(std::size_t i) const
  {
    if(i >= places_->new_places.size() - places_->number_of_old_nodes)
      throw Graph_mismatch_error("the arc is not one of the graph");
    return places_->new_places[places_->number_of_old_nodes + i];
  }

  /// returns the number of nodes of the graph that has been simplified.
  std::size_t number_of_old_nodes() const { return places_->number_of_old_nodes; }

  /// returns the number of arcs of the graph that has been simplified.
  std::size_t number_of_old_arcs() const { return places_->new_places.size() - places_->number_of_old_nodes; }

  /// returns what has taken up a node.
  friend Place get(const Simplification& simplification, node_descriptor node) { return simplification[node]; }

#ifndef DOXYGEN_RUNNING
  // By place in the old graph, the place in the new one.
  Simplification(std::size_t number_of_old_nodes,
                 std::size_t number_of_new_nodes,
                 std::vector<internal::Index> new_places,
                 std::vector<arc_descriptor> new_arcs)
    : places_(std::make_shared<const Places>(
      Places{number_of_old_nodes, number_of_new_nodes, std::move(new_places), std::move(new_arcs)}))
  {}
#endif

private:
  struct Places
  {
    std::size_t number_of_old_nodes, number_of_new_nodes;
    std::vector<internal::Index> new_places;
    std::vector<arc_descriptor> new_arcs;
  };

  Place place(std::size_t place) const
  {
    if(place < places_->number_of_new_nodes)
      return node_descriptor(place);
    return places_->new_arcs[place - places_->number_of_new_nodes];
  }

  std::shared_ptr<const Places> places_;
};

/// \ingroup PkgReebGraphSimplification
///
/// \brief a threshold of persistence that separates noise from features, and the graph that `simplify()` gives with it.
struct Simplification_threshold
{
  double threshold;   ///< the middle of a gap between two persistences, on a logarithmic scale
  double gap;         ///< the least persistence above the gap, divided by the greatest one below
  std::size_t nodes;  ///< of the simplified graph
  std::size_t leaves; ///< the nodes of the simplified graph with a single arc
  std::size_t loops;  ///< the independent loops of the simplified graph
  bool is_suggested;  ///< whether this is the best one
};

} // namespace CGAL::Reeb_graph

namespace CGAL::Reeb_graph::internal {

// Ranks of arcs in the order of lower nodes, from below, and then of upper nodes, from above.
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

// The graph without its small branches and, if asked for, loops; see simplify().
template <class Branch, class ReebGraph, class NamedParameters>
Leaf_pruning prune_graph(const ReebGraph& graph, double threshold, const NamedParameters& np)
{
  if(!(threshold >= 0))
    throw Parameter_error("the threshold of simplification is negative or not a number (NaN)");
  const std::size_t leaves = internal::parameter_or(np, number_of_leaves, std::size_t(0));
  const bool are_loops_cancelled = internal::parameter_or(np, cancel_loops, false);

  Leaf_pruning pruned(static_cast<Index>(num_vertices(graph)), read_arcs(graph),
                      read_place_weights(num_vertices(graph) + num_edges(graph), np));
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

} // namespace CGAL::Reeb_graph::internal

namespace CGAL::Reeb_graph {

/// \ingroup PkgReebGraphSimplification
///
/// \brief a leaf of a Reeb graph with its arc, as `simplify()` sees it: the arc that can be made of several ones, and
/// all that has been removed from it.
///
/// \tparam NodeDescriptor the type of the nodes of the graph
template <class NodeDescriptor>
struct Branch
{
  NodeDescriptor leaf;   ///< the extremum
  NodeDescriptor saddle; ///< the other end of the arc
  bool is_minimum;       ///< whether the leaf is the lower end
  double persistence;    ///< the largest absolute difference between the value at the saddle and one in the branch
  double weight;         ///< the sum of the `place_weights` of the branch, 0 if there are none
};

/// \ingroup PkgReebGraphSimplification
///
/// \brief removes what is small from a Reeb graph: arcs that end in a leaf, and on request loops.
///
/// The leaf arc of least measure is removed; of several, the one whose leaf has the lowest number. If one arc below its
/// saddle and one above are left, they become one, which can be a leaf arc of a larger measure. So it goes on until no
/// measure is below the threshold. A leaf arc that is the only one on its side of the saddle is not a branch, as what
/// is left would end there. So a branch with a loop stays as long as the loop does. See \cgalCite{csp-sfilgm-04}.
///
/// The measure of a leaf arc is its persistence by default: the largest difference between the value of the saddle and
/// one in what would be removed. `simplify_field()` has to move a value that far. It is the difference between
/// the ends of the arc, unless an extremum beyond the leaf has been removed from it before. What has been removed is
/// not in the simplified graph: where such an extremum has kept a leaf arc, simplifying that graph again removes the
/// arc. With the difference between the ends as `branch_measure`, simplifying again changes nothing, but values of the
/// simplified field can change by more than the threshold.
///
/// The simplified graph is one of the same type. Its nodes are nodes of `graph` in the same order, but those of degree
/// two are never among them. Its arcs are sorted by lower node, upper node, and the first arc of `graph` that they are
/// made of. The chain of an arc consists of the chains of these arcs, one after the other; so an `Augmentation` finds the
/// contours of the branch that has been kept. A larger threshold gives a graph with nodes of that of a smaller one, and
/// no more.
///
/// With \f$ n \f$ nodes and arcs, it takes \f$ O(n \log n) \f$ time, and the same again each time that cancelled loops
/// have made new leaf arcs.
///
/// \tparam ReebGraph the type `Graph` of the traits class
/// \tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"
///
/// \param graph a Reeb graph, computed with any named parameters
/// \param threshold what is smaller is removed, in units of the measure; infinity if only `number_of_leaves` counts
/// \param simplified the result; whatever it held before is cleared
/// \param np an optional sequence of \ref bgl_namedparameters "Named Parameters" among the ones listed below
///
/// \cgalNamedParamsBegin
///   \cgalParamNBegin{number_of_leaves}
///     \cgalParamDescription{no more arcs are removed when this many leaves are left, nodes with a single arc}
///     \cgalParamType{`std::size_t`}
///     \cgalParamDefault{0}
///     \cgalParamExtra{use the function `parameters::number_of_leaves()`}
///   \cgalParamNEnd
///   \cgalParamNBegin{cancel_loops}
///     \cgalParamDescription{whether loops of a persistence below the threshold are removed, too: of the two sides of a
///                           loop one takes up the other. A loop stays while arcs that stay leave both of its sides.
///                           The measure of a loop is always its persistence. A field on the mesh has those that the
///                           surface asks for, so that `simplify_field()` throws an exception if it is asked to.}
///     \cgalParamType{`bool`}
///     \cgalParamDefault{`false`}
///     \cgalParamExtra{use the function `parameters::cancel_loops()`}
///   \cgalParamNEnd
///   \cgalParamNBegin{place_weights}
///     \cgalParamDescription{a number for each node, and then for each arc in the order of `edges(graph)`; see
///                           `areas_of_places()` and `vertex_counts_of_places()`. They are added up over all that is
///                           removed.}
///     \cgalParamType{a range of numbers}
///     \cgalParamDefault{none}
///     \cgalParamExtra{use the function `parameters::place_weights()`}
///   \cgalParamNEnd
///   \cgalParamNBegin{branch_measure}
///     \cgalParamDescription{how large a branch is}
///     \cgalParamType{a function object that is called with a `Reeb_graph::Branch` and returns a `double`}
///     \cgalParamDefault{`Branch::weight` if there are `place_weights`, else `Branch::persistence`}
///     \cgalParamExtra{use the function `parameters::branch_measure()`}
///   \cgalParamNEnd
///   \cgalParamNBegin{geom_traits}
///     \cgalParamDescription{an instance of a traits class whose `scalar_to_double_object()` makes numbers of the
///                           values. Values that are numbers need none if the order sorts them up or down:
///                           persistence is an absolute difference.}
///     \cgalParamType{a model of `ReebGraphNumberTraits`}
///     \cgalParamDefault{none: `CGAL::to_double()` of the values}
///   \cgalParamNEnd
/// \cgalNamedParamsEnd
///
/// \pre The threshold is neither negative nor NaN, and arcs lead to nodes of higher number.
///
/// \reebGraphComplexity
///
/// \returns for each node and arc of `graph` the node or arc of `simplified` that has taken it up.
///
/// \exception Reeb_graph::Parameter_error if the threshold is negative or NaN, if a measure or the number of a value is
///            NaN, or if there is not one weight for each node and each arc
/// \exception Reeb_graph::Graph_mismatch_error if an arc does not lead to a node of higher number
///
/// When one of these is thrown, `simplified` is as it was before.
template <class ReebGraph, class NamedParameters = parameters::Default_named_parameters>
Simplification<ReebGraph> simplify(const ReebGraph& graph,
                                   double threshold,
                                   ReebGraph& simplified,
                                   const NamedParameters& np = parameters::default_values())
{
  static_assert(internal::are_met<internal::Augmented_reeb_graph<ReebGraph>,
                                  internal::Nodes_have_numbers<ReebGraph, NamedParameters>>);
  if(std::addressof(graph) == std::addressof(simplified))
  {
    // NOLINTNEXTLINE(performance-unnecessary-copy-initialization): `simplified` is the same graph
    const ReebGraph copy(graph);
    return simplify(copy, threshold, simplified, np);
  }
  typedef Branch<typename boost::graph_traits<ReebGraph>::vertex_descriptor> Branch;
  const internal::Leaf_pruning pruned = internal::prune_graph<Branch>(graph, threshold, np);
  return internal::write_simplified_graph(graph, pruned, simplified);
}

} // namespace CGAL::Reeb_graph

#endif // CGAL_REEB_GRAPH_SIMPLIFICATION_SIMPLIFY_H
