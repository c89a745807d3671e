// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_SIMPLIFICATION_PERSISTENCE_PAIRS_H
#define CGAL_REEB_GRAPH_SIMPLIFICATION_PERSISTENCE_PAIRS_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/internal/base/Buckets.h>
#include <CGAL/Reeb_graph/internal/base/Index.h>
#include <CGAL/Reeb_graph/internal/base/Scalar_conversion.h>
#include <CGAL/Reeb_graph/internal/graph/graph_loops.h>
#include <CGAL/Reeb_graph/named_parameters.h>

#include <boost/graph/graph_traits.hpp>

#include <algorithm>
#include <cstddef>
#include <string>
#include <tuple>
#include <vector>

namespace CGAL::Reeb_graph::internal {

// Sweeps over the nodes, from below or from above. Calls visit_pair(lower node, upper node) where two components meet,
// for the extremum of the younger one, which the sweep has met later, and the saddle: the elder rule. The root of a
// component is its eldest node. What is left are the components of the graph.
template <class VisitPair>
Disjoint_sets<Index> sweep_over_nodes(Side begin,
                                      const std::vector<Ascending_arc>& arcs,
                                      Index number_of_nodes,
                                      const VisitPair& visit_pair)
{
  const bool is_upwards = begin == Side::LOWER;
  const Buckets<Node_index, Index> earlier_ends(number_of_nodes, [&](const auto& visit) {
    for(const Ascending_arc& arc : arcs)
      visit(Node_index(is_upwards ? arc.upper : arc.lower), is_upwards ? arc.lower : arc.upper);
  });
  Disjoint_sets<Index> components(number_of_nodes);
  for(Index i = 0; i != number_of_nodes; ++i)
  {
    const Index node = is_upwards ? i : number_of_nodes - 1 - i;
    Index root = node;
    for(const Index end : earlier_ends[Node_index(node)])
    {
      const Index other_root = components.find(end);
      if(other_root == root)
        continue;
      const auto [lower, upper] = std::minmax(root, other_root);
      const Index younger = is_upwards ? upper : lower, elder = is_upwards ? lower : upper;
      components.link(younger, elder);
      if(younger != node)
        visit_pair((std::min)(younger, node), (std::max)(younger, node));
      root = elder;
    }
  }
  return components;
}

// By root, the highest node of each component.
inline std::vector<Index> highest_nodes(Disjoint_sets<Index>& components, Index number_of_nodes)
{
  std::vector<Index> highest(number_of_nodes);
  for(Index node = 0; node != number_of_nodes; ++node)
    highest[components.find(node)] = node;
  return highest;
}

// By node, the difference between the highest and the lowest value of its connected component.
inline std::vector<double> component_ranges(const std::vector<Ascending_arc>& arcs, const std::vector<double>& values)
{
  const Index number_of_nodes = static_cast<Index>(values.size());
  Disjoint_sets<Index> components = sweep_over_nodes(Side::LOWER, arcs, number_of_nodes, [](Index, Index) {});
  const std::vector<Index> highest = highest_nodes(components, number_of_nodes);
  std::vector<double> ranges;
  for(Index node = 0; node != number_of_nodes; ++node)
  {
    const Index lowest = components.find(node);
    ranges.push_back(persistence(values[lowest], values[highest[lowest]]));
  }
  return ranges;
}

} // namespace CGAL::Reeb_graph::internal

namespace CGAL::Reeb_graph {

/// \ingroup PkgReebGraphEnums
///
/// \brief what is born at the one node of a persistence pair, and dies at the other.
enum class Persistence_pair_kind
{
  MINIMUM_SADDLE, ///< a component of the sublevel sets: from its lowest minimum to where it joins one of a lower minimum
  SADDLE_MAXIMUM,  ///< a component of the superlevel sets: from where it joins a higher one to its own maximum
  MINIMUM_MAXIMUM, ///< a connected component of the graph: its lowest minimum and its highest maximum
  LOOP             ///< a loop of the graph: from where it splits to where it joins
};

/// \ingroup PkgReebGraphSimplification
///
/// \brief two nodes of a Reeb graph that extended persistence pairs. Their values are the birth and the death.
///
/// \tparam NodeDescriptor the type of the nodes of the graph
template <class NodeDescriptor>
struct Persistence_pair
{
  NodeDescriptor lower_node;  ///< the lower node
  NodeDescriptor upper_node;  ///< the upper node, the same as the lower one for a node without arcs
  Persistence_pair_kind kind; ///< what the pair stands for

  /// returns `true` if nodes and kinds are the same.
  friend bool operator==(const Persistence_pair& a, const Persistence_pair& b)
  {
    return a.lower_node == b.lower_node && a.upper_node == b.upper_node && a.kind == b.kind;
  }

  /// returns `true` if a node or the kind is another one.
  friend bool operator!=(const Persistence_pair& a, const Persistence_pair& b) { return !(a == b); }

  /// compares first the lower nodes, then the upper ones, then the kinds.
  friend bool operator<(const Persistence_pair& a, const Persistence_pair& b)
  {
    return std::tie(a.lower_node, a.upper_node, a.kind) < std::tie(b.lower_node, b.upper_node, b.kind);
  }
};

/// \ingroup PkgReebGraphSimplification
///
/// \brief returns the name of a kind: `minimum-saddle`, `saddle-maximum`, `minimum-maximum`, or `loop`.
///
/// \param kind the kind
inline std::string to_string(Persistence_pair_kind kind)
{
  switch(kind)
  {
  case Persistence_pair_kind::MINIMUM_SADDLE: return "minimum-saddle";
  case Persistence_pair_kind::SADDLE_MAXIMUM: return "saddle-maximum";
  case Persistence_pair_kind::MINIMUM_MAXIMUM: return "minimum-maximum";
  case Persistence_pair_kind::LOOP: return "loop";
  }
  return "unknown";
}

/// \ingroup PkgReebGraphSimplification
///
/// \brief returns the persistence of a pair: the absolute difference of the values of its two nodes, as a `double`.
/// That of equal values is 0, also if they are infinite.
///
/// \param graph the graph that the pair is one of
/// \param pair the pair
/// \param np an optional sequence of \ref bgl_namedparameters "Named Parameters": `geom_traits`, as for `simplify()`
///
/// \reebGraphComplexity
template <class ReebGraph, class NamedParameters = parameters::Default_named_parameters>
double persistence(const ReebGraph& graph,
                   const Persistence_pair<typename boost::graph_traits<ReebGraph>::vertex_descriptor>& pair,
                   const NamedParameters& np = parameters::default_values())
{
  static_assert(internal::are_met<internal::Nodes_have_numbers<ReebGraph, NamedParameters>>);
  const auto conversion = internal::choose_conversion_of_nodes<ReebGraph>(np);
  return internal::persistence(conversion.to_double(graph[pair.lower_node].value),
                               conversion.to_double(graph[pair.upper_node].value));
}

/// \ingroup PkgReebGraphSimplification
///
/// \brief finds the pairs of the extended persistence of a Reeb graph.
///
/// Sublevel sets are followed upwards, and then superlevel sets downwards. A component or loop that is born at one node
/// dies at another one. The difference of their values is its persistence.
///
/// - Where several components of a sublevel set meet, all die but the one of the lowest minimum (the elder rule): a
///   pair of a minimum and a saddle for each.
/// - Where several components of a superlevel set meet, all die but the one of the highest maximum: a pair of a saddle
///   and a maximum for each.
/// - The lowest minimum and the highest maximum of each connected component of the graph are a pair. A node without
///   arcs is one with itself.
/// - There are as many loop pairs as the graph has independent loops. The upper node of a pair is where arcs close a
///   loop from below, and the lower node is the highest one that can be the lowest node of such a loop.
///
/// A node at which more than three arcs end takes part in several pairs, a node with one arc below and one above in
/// none. Nodes are compared by their numbers, which is the total order of the vertices, so the pairs are unique, and
/// values can be of any type. Turned upside down, the graph has the same pairs upside down.
///
/// With \f$ n \f$ nodes and arcs, of which \f$ l \f$ are in loops, the time is \f$ O(n \log n) \f$ with a small
/// constant, plus \f$ O(l \log l) \f$. Loops are found by link-cut trees. See \cgalCite{aehw-ee2m-06}, and
/// \cgalCite{thr-ppspac-19}.
///
/// \tparam ReebGraph the type `Graph` of the traits class, or another bidirectional graph with `std::size_t` as vertex
///         descriptor
/// \tparam OutputIterator a model of `OutputIterator` for `Persistence_pair` with the vertex descriptors of the graph
///
/// \param graph a Reeb graph, computed with any named parameters
/// \param pairs the output: all pairs, sorted by lower node, upper node, and kind
///
/// \pre Arcs lead to nodes of higher number.
///
/// \reebGraphComplexity
///
/// \returns the output iterator behind the last pair.
///
/// \exception Reeb_graph::Graph_mismatch_error if an arc does not lead to a node of higher number
template <class ReebGraph, class OutputIterator>
OutputIterator persistence_pairs(const ReebGraph& graph, OutputIterator pairs)
{
  static_assert(internal::are_met<internal::Plain_reeb_graph<ReebGraph>>);
  typedef Persistence_pair<typename boost::graph_traits<ReebGraph>::vertex_descriptor> Pair;
  std::vector<Pair> found;
  const auto add = [&](Persistence_pair_kind kind) {
    return [&found, kind](internal::Index lower, internal::Index upper) { found.push_back({lower, upper, kind}); };
  };
  const std::vector<internal::Ascending_arc> arcs = internal::read_arcs(graph);
  const internal::Index size = static_cast<internal::Index>(num_vertices(graph));
  found.reserve(size);
  auto components =
    internal::sweep_over_nodes(internal::Side::LOWER, arcs, size, add(Persistence_pair_kind::MINIMUM_SADDLE));
  internal::sweep_over_nodes(internal::Side::UPPER, arcs, size, add(Persistence_pair_kind::SADDLE_MAXIMUM));
  const std::vector<internal::Index> highest = internal::highest_nodes(components, size);
  for(internal::Index node = 0; node != size; ++node)
    if(components.find(node) == node)
      found.push_back({node, highest[node], Persistence_pair_kind::MINIMUM_MAXIMUM});
  internal::pair_loops(arcs, size, add(Persistence_pair_kind::LOOP));
  std::sort(found.begin(), found.end());
  return std::copy(found.begin(), found.end(), pairs);
}

} // namespace CGAL::Reeb_graph

#endif // CGAL_REEB_GRAPH_SIMPLIFICATION_PERSISTENCE_PAIRS_H
