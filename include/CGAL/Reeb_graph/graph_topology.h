// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_GRAPH_TOPOLOGY_H
#define CGAL_REEB_GRAPH_GRAPH_TOPOLOGY_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/internal/base/arrays.h>

#include <CGAL/boost/graph/iterator.h>

#include <boost/graph/graph_traits.hpp>
#include <boost/property_map/property_map.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <numeric>
#include <vector>

namespace CGAL::Reeb_graph {
namespace internal {

// A spanning forest of shortest paths in a graph without the directions of its arcs, which are numbered in the order of
// edges(graph).
class Spanning_forest
{
public:
  template <class ReebGraph>
  explicit Spanning_forest(const ReebGraph& graph)
    : arcs_to_nodes_(num_vertices(graph), none),
      depths_(num_vertices(graph), none),
      is_in_forest_(num_edges(graph), false)
  {
    std::vector<std::vector<std::size_t>> arcs_of_nodes(num_vertices(graph));
    for(const auto arc : CGAL::make_range(edges(graph)))
    {
      for(const std::size_t node : {source(arc, graph), target(arc, graph)})
        arcs_of_nodes[node].push_back(ends_.size());
      ends_.push_back({source(arc, graph), target(arc, graph)});
    }
    std::vector<std::size_t> queue;
    for(std::size_t root = 0; root != depths_.size(); ++root)
    {
      if(depths_[root] != none)
        continue;
      depths_[root] = 0;
      queue = {root};
      for(std::size_t i = 0; i != queue.size(); ++i)
        for(const std::size_t arc : arcs_of_nodes[queue[i]])
        {
          const std::size_t node = other_end(arc, queue[i]);
          if(depths_[node] != none)
            continue;
          depths_[node] = depths_[queue[i]] + 1;
          arcs_to_nodes_[node] = arc;
          is_in_forest_[arc] = true;
          queue.push_back(node);
        }
    }
  }

  bool contains(std::size_t arc) const { return is_in_forest_[arc]; }

  // The numbers of the arcs on the path between two nodes of one tree.
  std::vector<std::size_t> path(std::size_t from, std::size_t to) const
  {
    std::vector<std::size_t> begin, end;
    while(from != to)
    {
      const bool is_from_lower = depths_[from] >= depths_[to];
      std::size_t& node = is_from_lower ? from : to;
      (is_from_lower ? begin : end).push_back(arcs_to_nodes_[node]);
      node = other_end(arcs_to_nodes_[node], node);
    }
    begin.insert(begin.end(), end.rbegin(), end.rend());
    return begin;
  }

private:
  static constexpr std::size_t none = (std::numeric_limits<std::size_t>::max)();

  std::size_t other_end(std::size_t arc, std::size_t node) const { return ends_[arc][ends_[arc][0] == node ? 1 : 0]; }

  std::vector<std::array<std::size_t, 2>> ends_; // of arcs
  std::vector<std::size_t> arcs_to_nodes_;       // from their parents
  std::vector<std::size_t> depths_;
  std::vector<bool> is_in_forest_;
};

} // namespace internal

/// \addtogroup PkgReebGraphTopology
/// @{

/// \brief numbers the connected components of a Reeb graph: those of the surface.
///
/// \tparam ReebGraph the type `Graph` of a model of `ReebGraphTraits`
/// \tparam ComponentMap a model of `WritablePropertyMap` with the nodes as key type and an integer type as value type
///
/// \param graph the Reeb graph
/// \param component_map is set to the number of the component of each node, from 0 in the order of their lowest nodes
///
/// \reebGraphComplexity
///
/// \returns the number of components. It takes almost linear time.
template <class ReebGraph, class ComponentMap>
std::size_t connected_components(const ReebGraph& graph, ComponentMap component_map)
{
  std::vector<std::size_t> parents(num_vertices(graph));
  std::iota(parents.begin(), parents.end(), std::size_t(0));
  const auto root = [&](std::size_t node) {
    return internal::find_root(node, [&](std::size_t i) -> std::size_t& { return parents[i]; });
  };
  // the lowest node of a set is its root
  for(const auto arc : CGAL::make_range(edges(graph)))
  {
    const auto [lower, upper] = std::minmax({root(source(arc, graph)), root(target(arc, graph))});
    parents[upper] = lower;
  }
  std::vector<std::size_t> numbers(num_vertices(graph));
  std::size_t number_of_sets = 0;
  for(std::size_t node = 0; node < parents.size(); ++node)
  {
    numbers[node] = parents[node] == node ? number_of_sets++ : numbers[root(node)];
    put(component_map, node, numbers[node]);
  }
  return number_of_sets;
}

/// \brief counts the connected components of a Reeb graph: those of the surface. It takes almost
/// linear time.
///
/// \param graph the Reeb graph
///
/// \reebGraphComplexity
template <class ReebGraph>
std::size_t number_of_components(const ReebGraph& graph)
{
  std::vector<std::size_t> components(num_vertices(graph));
  return Reeb_graph::connected_components(
    graph, boost::make_iterator_property_map(components.begin(), boost::typed_identity_property_map<std::size_t>()));
}

/// \brief counts the independent loops of a Reeb graph, its first Betti number: arcs less nodes plus components. It
/// takes almost linear time.
///
/// \param graph the Reeb graph
///
/// \reebGraphComplexity
template <class ReebGraph>
std::size_t number_of_loops(const ReebGraph& graph)
{
  return num_edges(graph) + number_of_components(graph) - num_vertices(graph);
}

/// \brief writes the leaves of a Reeb graph, the nodes with one arc, in ascending order. It takes linear time.
///
/// \param graph the Reeb graph
/// \param nodes the output, an output iterator for nodes
///
/// \reebGraphComplexity
///
/// \returns the output iterator behind the last node.
template <class ReebGraph, class OutputIterator>
OutputIterator leaves(const ReebGraph& graph, OutputIterator nodes)
{
  for(const auto node : CGAL::make_range(vertices(graph)))
  {
    if(degree(node, graph) == 1)
      *nodes++ = node;
  }
  return nodes;
}

/// \brief writes a basis of the cycles of a Reeb graph: as many loops as `number_of_loops()`, from which all others are
/// combined.
///
/// Each loop is closed by its first arc, which is in no other loop of the basis: the rest is the path between the ends
/// of that arc in a spanning forest of shortest paths. It takes time linear in the graph and in the lengths of the
/// loops.
///
/// \param graph the Reeb graph
/// \param loops the output, an output iterator for `std::vector` of arcs: the first arc, passed upwards, and then those
///        that lead from its upper node back to its lower one. The loops are in the order of their first arcs.
///
/// \reebGraphComplexity
///
/// \returns the output iterator behind the last loop.
template <class ReebGraph, class OutputIterator>
OutputIterator cycle_basis(const ReebGraph& graph, OutputIterator loops)
{
  typedef typename boost::graph_traits<ReebGraph>::edge_descriptor arc_descriptor;
  const std::vector<arc_descriptor> arcs(edges(graph).first, edges(graph).second);
  const internal::Spanning_forest forest(graph);
  for(std::size_t i = 0; i != arcs.size(); ++i)
  {
    if(forest.contains(i))
      continue;
    std::vector<arc_descriptor> loop = {arcs[i]};
    for(const std::size_t j : forest.path(target(arcs[i], graph), source(arcs[i], graph)))
      loop.push_back(arcs[j]);
    *loops++ = loop;
  }
  return loops;
}

/// \brief writes one contour for each loop of `cycle_basis()`: curves around handles.
///
/// The contour is the one in the middle of the first arc of the loop. It meets that loop once and no other one of the
/// basis, so cutting the surface along all of them leaves each component connected. On a surface with border, a contour
/// can lead from border to border. `cutting_system()` chooses short ones, and refines the mesh.
///
/// \param graph the Reeb graph
/// \param augmentation an `Augmentation`, `Soup_augmentation` or `Tetrahedra_augmentation` of the graph
/// \param contours the output, an output iterator for its `Contour`
///
/// \reebGraphComplexity
///
/// \returns the output iterator behind the last contour.
template <class ReebGraph, class Augmentation, class OutputIterator>
OutputIterator loop_contours(const ReebGraph& graph, const Augmentation& augmentation, OutputIterator contours)
{
  const internal::Spanning_forest forest(graph);
  std::size_t number = 0;
  for(const auto arc : CGAL::make_range(edges(graph)))
  {
    if(!forest.contains(number++))
      *contours++ = augmentation.contour(arc, 0.5);
  }
  return contours;
}

/// @}

} // namespace CGAL::Reeb_graph

#endif // CGAL_REEB_GRAPH_GRAPH_TOPOLOGY_H
