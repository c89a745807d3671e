// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_SIMPLIFICATION_INTERNAL_WRITE_SIMPLIFIED_GRAPH_H
#define CGAL_REEB_GRAPH_SIMPLIFICATION_INTERNAL_WRITE_SIMPLIFIED_GRAPH_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/internal/base/Index.h>
#include <CGAL/Reeb_graph/internal/graph/Leaf_pruning.h>
#include <CGAL/Reeb_graph/simplification/Simplification.h>

#include <boost/graph/graph_traits.hpp>

#include <algorithm>
#include <cstddef>
#include <memory>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL::Reeb_graph::internal {

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

#endif // CGAL_REEB_GRAPH_SIMPLIFICATION_INTERNAL_WRITE_SIMPLIFIED_GRAPH_H
