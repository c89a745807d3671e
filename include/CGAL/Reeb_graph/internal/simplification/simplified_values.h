// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of the CGAL-style package Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_INTERNAL_SIMPLIFICATION_SIMPLIFIED_VALUES_H
#define CGAL_REEB_GRAPH_INTERNAL_SIMPLIFICATION_SIMPLIFIED_VALUES_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/Augmentation.h>
#include <CGAL/Reeb_graph/internal/base/Disjoint_sets.h>
#include <CGAL/Reeb_graph/internal/base/Index.h>
#include <CGAL/Reeb_graph/internal/base/Progress.h>
#include <CGAL/Reeb_graph/internal/scalar_fields/vertex_graph.h>
#include <CGAL/Reeb_graph/internal/simplification/Moved_pieces.h>
#include <CGAL/Reeb_graph/internal/simplification/prune_graph.h>
#include <CGAL/Reeb_graph/internal/simplification/spread_ties.h>
#include <CGAL/Reeb_graph/internal/simplification/write_simplified_graph.h>
#include <CGAL/Reeb_graph/named_parameters.h>
#include <CGAL/Reeb_graph/scalar_maps.h>
#include <CGAL/Reeb_graph/simplification/exceptions.h>
#include <CGAL/compute_reeb_graph.h>

#include <boost/graph/graph_traits.hpp>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <numeric>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Reeb_graph {
namespace internal {

// By node, the position of its vertex.
template <class Mesh, class ReebGraph>
std::vector<Index> positions_of_nodes(const Mesh& mesh, const ReebGraph& graph)
{
  const auto nodes = get(dynamic_vertex_property_t<Index>(), mesh);
  for(const auto v : CGAL::make_range(vertices(mesh)))
    put(nodes, v, no_index);
  for(Index node = 0; node != num_vertices(graph); ++node)
    put(nodes, graph[node].vertex, node);
  std::vector<Index> positions(num_vertices(graph));
  Index position = 0;
  for(const auto v : CGAL::make_range(vertices(mesh)))
  {
    if(get(nodes, v) != no_index)
      positions[get(nodes, v)] = position;
    ++position;
  }
  return positions;
}

// By position of the vertex, the number of its place in the graph.
template <class Mesh, class ScalarMap, class ReebGraph, class NamedParameters>
std::vector<Index> find_places_of_vertices(const Mesh& mesh,
                                           const ScalarMap& scalar_map,
                                           const ReebGraph& graph,
                                           const NamedParameters& np,
                                           const Stage_progress& progress)
{
  const Augmentation<Mesh, ScalarMap, ReebGraph> augmentation(mesh, scalar_map, graph,
                                                              np.callback(progress.part(0, 0.2).callback()));
  const auto locations = augmentation.locate_vertices(parameters::callback(progress.part(0.2, 0.9).callback()));
  std::vector<Index> places;
  for(const auto v : CGAL::make_range(vertices(mesh)))
    places.push_back(static_cast<Index>(locations.index(v)));
  return places;
}

// By position of the vertex of a node, the distance to the next value of another node.
template <class Scalar>
std::vector<Scalar> rooms_of_nodes(const std::vector<Index>& positions, const std::vector<Scalar>& values)
{
  std::vector<Scalar> rooms(values.size(), std::numeric_limits<Scalar>::infinity());
  for(std::size_t node = 1; node < positions.size(); ++node)
  {
    const Scalar room = values[positions[node]] - values[positions[node - 1]];
    for(const Index position : {positions[node - 1], positions[node]})
    {
      if(room > 0)
        rooms[position] = (std::min)(rooms[position], room);
    }
  }
  return rooms;
}

// Whether a graph is the simplified one, if nodes are told by the place of their vertices, `place_of_node(node)`. A
// node at which several saddles are in one vertex may have come apart into a tree of nodes in the same place.
template <class ReebGraph, class SimplifiedGraph, class PlaceOfNode>
bool is_simplified_graph(const ReebGraph& graph, const SimplifiedGraph& simplified, const PlaceOfNode& place_of_node)
{
  std::vector<std::pair<std::size_t, std::size_t>> arcs, expected_arcs;
  std::vector<bool> is_found(num_vertices(simplified), false);
  for(std::size_t node = 0; node != num_vertices(graph); ++node)
  {
    const std::size_t place = place_of_node(node);
    if(place >= num_vertices(simplified))
      return false;
    const bool is_minimum = in_degree(node, graph) == 0, is_maximum = out_degree(node, graph) == 0;
    if((is_minimum && in_degree(place, simplified) != 0) || (is_maximum && out_degree(place, simplified) != 0))
      return false;
    is_found[place] = true;
  }
  std::size_t number_of_trees = num_vertices(graph);
  std::vector<Index> trees(num_vertices(graph)); // by node, another one of its tree or, at the root, itself
  std::iota(trees.begin(), trees.end(), Index(0));
  const auto tree_of = [&](std::size_t node) {
    return find_root(static_cast<Index>(node), [&](Index i) -> Index& { return trees[i]; });
  };
  for(const auto arc : CGAL::make_range(edges(graph)))
  {
    const std::size_t lower = place_of_node(source(arc, graph)), upper = place_of_node(target(arc, graph));
    if(lower != upper)
    {
      arcs.emplace_back(lower, upper);
      continue;
    }
    const Index a = tree_of(source(arc, graph)), b = tree_of(target(arc, graph));
    if(a == b)
      return false; // a loop
    trees[a] = b;
    --number_of_trees;
  }
  for(const auto arc : CGAL::make_range(edges(simplified)))
    expected_arcs.emplace_back(source(arc, simplified), target(arc, simplified));
  std::sort(arcs.begin(), arcs.end());
  std::sort(expected_arcs.begin(), expected_arcs.end());
  return number_of_trees == num_vertices(simplified) && arcs == expected_arcs
      && std::find(is_found.begin(), is_found.end(), false) == is_found.end();
}

// With contracted ties, a removed piece is part of the plateau of its saddle. Nothing can be in the way: the contour of
// the saddle and the piece are connected, and no other edge crosses another level than before.
template <class ReebGraph, class Scalar>
std::vector<Scalar> contracted_values(const ReebGraph& graph,
                                      const std::vector<Index>& nodes_of_saddles,
                                      std::vector<Scalar> values)
{
  for(std::size_t v = 0; v != values.size(); ++v)
  {
    if(nodes_of_saddles[v] != no_index)
      values[v] = graph[nodes_of_saddles[v]].value;
  }
  return values;
}

// With perturbed ties, it is moved next to its saddle.
template <class Mesh, class ReebGraph, class Scalar>
std::vector<Scalar> perturbed_values(const Mesh& mesh,
                                     const ReebGraph& graph,
                                     std::vector<Index> saddles, // at first, nodes
                                     const std::vector<Scalar>& values,
                                     double threshold)
{
  const std::vector<Index> positions = positions_of_nodes(mesh, graph);
  for(Index& saddle : saddles)
    saddle = saddle == no_index ? no_index : positions[saddle];
  const auto vertex_graph =
    scalar_fields::make_vertex_graph(mesh, scalar_fields::make_position_map(mesh), values.size());
  const std::vector<Scalar> spread =
    spread_ties(values, find_tied_saddles(vertex_graph, saddles, values, static_cast<Scalar>(threshold)));
  const std::vector<Scalar> rooms = rooms_of_nodes(positions, spread);
  return Moved_pieces<Scalar>(vertex_graph, saddles, rooms, spread, threshold).move();
}

// The values of the simplified field, by position of the vertex; see simplify_field().
template <class Branch, class Traits, class Mesh, class ScalarMap, class NamedParameters>
auto simplified_values(const Mesh& mesh,
                       const ScalarMap& scalar_map,
                       double threshold,
                       const NamedParameters& np,
                       const Stage_progress& progress)
{
  typedef typename Traits::Scalar Scalar;
  const Ties ties_of_graph = parameters::choose_parameter(parameters::get_parameter(np, ties), Ties::PERTURB);
  typename Traits::Graph graph;
  compute_reeb_graph(mesh, scalar_map, graph, np.callback(progress.part(0, 0.22).callback()));
  const Leaf_pruning pruned = prune_graph<Branch>(graph, threshold, np);
  const std::vector<Index> places = find_places_of_vertices(mesh, scalar_map, graph, np, progress.part(0.3, 0.75));
  const std::vector<Index> saddles_of_places = pruned.find_saddles();
  std::vector<Index> saddles;
  saddles.reserve(places.size());
  for(const Index place : places)
    saddles.push_back(saddles_of_places[place]);
  const std::vector<Scalar> values = scalar_fields::read_values_of_vertices(mesh, scalar_map);
  if(ties_of_graph == Ties::CONTRACT)
    return contracted_values(graph, saddles, values);
  if constexpr(std::is_floating_point_v<Scalar>)
  {
    typename Traits::Graph simplified;
    const auto simplification = write_simplified_graph(graph, pruned, simplified);
    std::vector<Scalar> moved = perturbed_values(mesh, graph, std::move(saddles), values, threshold);
    const auto map = make_scalar_map(mesh, moved);
    typename Reeb_graph_traits<Mesh, std::decay_t<decltype(map)>>::Graph graph_of_moved;
    compute_reeb_graph(mesh, map, graph_of_moved, parameters::callback(progress.part(0.85, 1).callback()));
    const std::vector<Index> positions = positions_of_nodes(mesh, graph_of_moved);
    const auto place_of_node = [&](std::size_t node) {
      const Index place = places[positions[node]];
      return place < num_vertices(graph) ? simplification.index_of_node(place)
                                         : simplification.index_of_arc(place - num_vertices(graph));
    };
    if(!is_simplified_graph(graph_of_moved, simplified, place_of_node))
      throw Perturbed_ties_error("a removed piece has a border or a handle that makes a loop of its own");
    return moved;
  }
  else
    throw Perturbed_ties_error("the values are no floating point numbers");
}

} // namespace internal
} // namespace Reeb_graph
} // namespace CGAL

#endif // CGAL_REEB_GRAPH_INTERNAL_SIMPLIFICATION_SIMPLIFIED_VALUES_H
