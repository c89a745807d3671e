// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of the CGAL-style package Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_INTERNAL_BASE_UNION_FIND_H
#define CGAL_REEB_GRAPH_INTERNAL_BASE_UNION_FIND_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/internal/base/Index.h>
#include <CGAL/Reeb_graph/internal/base/arrays.h>
#include <CGAL/Reeb_graph/internal/base/tuning.h>

#include <CGAL/boost/graph/iterator.h>

#include <boost/graph/adjacency_list.hpp>
#include <boost/graph/breadth_first_search.hpp>
#include <boost/graph/visitors.hpp>
#include <boost/pending/queue.hpp>
#include <boost/property_map/property_map.hpp>

#include <cstddef>
#include <numeric>
#include <utility>
#include <vector>

namespace CGAL::Reeb_graph::internal {

// The root of the set of an element, where parent(element) is a reference to the element that it has been linked to:
// itself at the root. Paths are halved on the way.
template <class Element, class Parent>
Element find_root(Element element, const Parent& parent)
{
  while(parent(element) != element)
    element = parent(element) = parent(parent(element));
  return element;
}

// Disjoint sets of indices. The root of a set stands for all of it.
template <class Element>
class Disjoint_sets
{
public:
  explicit Disjoint_sets(Number size) : parents_(size) { std::iota(parents_.begin(), parents_.end(), Element(0)); }

  Element find(Element element)
  {
    return find_root(element, [&](Element i) -> Element& { return parents_[i]; });
  }

  // Joins two sets, given by their roots; `root` is the root of both then.
  void link(Element old_root, Element root) { parents_[old_root] = root; }

  void unite(Element a, Element b) { link(find(a), find(b)); }

  // The roots of the sets, by element. The sets are gone then.
  Indexed_vector<Element, Element> take_roots()
  {
    for(Element& parent : parents_)
      parent = find(parent);
    return std::move(parents_);
  }

private:
  Indexed_vector<Element, Element> parents_;
};

struct Component_tag;
typedef Index_of<Component_tag> Component_index;

// The components of sublevel or superlevel sets that merge in a sweep: disjoint sets, each with a top, the node at
// which the sweep has met it last. Both in one place, as a sweep jumps about in memory.
template <class Node>
class Merging_components
{
public:
  Number size() const { return static_cast<Number>(components_.size()); }

  // Adds a component of which `node` is all.
  Component_index add(Node node)
  {
    components_.push_back({components_.end_key(), node});
    return components_.last_key();
  }

  Component_index find(Component_index component)
  {
    return find_root(component, [&](Component_index i) -> Component_index& { return components_[i].parent; });
  }

  // Joins two components, given by their roots; `root` is the root of both then, and its top is that of both.
  void link(Component_index old_root, Component_index root) { components_[old_root].parent = root; }

  Node top(Component_index root) const { return components_[root].top; }
  void set_top(Component_index root, Node node) { components_[root].top = node; }

  // Fetches a component ahead of find(). Any index is allowed.
  void prefetch(Component_index component) const { prefetch_element(components_, component); }

private:
  struct Component
  {
    Component_index parent;
    Node top;
  };

  Indexed_vector<Component_index, Component> components_;
};

// The arcs without their directions, numbered in the order of edges(graph): many algorithms of Boost.Graph need that.
typedef boost::adjacency_list<boost::vecS,
                              boost::vecS,
                              boost::undirectedS,
                              boost::no_property,
                              boost::property<boost::edge_index_t, std::size_t>>
  Undirected_graph;

template <class ReebGraph>
Undirected_graph make_undirected(const ReebGraph& graph)
{
  Undirected_graph result(num_vertices(graph));
  std::size_t number = 0;
  for(const auto arc : CGAL::make_range(edges(graph)))
    add_edge(source(arc, graph), target(arc, graph), number++, result);
  return result;
}

// A spanning forest of shortest paths: for each node the edge that leads to it and the number of edges from the root.
class Spanning_forest
{
  typedef boost::graph_traits<Undirected_graph>::edge_descriptor edge_descriptor;
  typedef boost::graph_traits<Undirected_graph>::vertex_descriptor vertex_descriptor;

public:
  explicit Spanning_forest(const Undirected_graph& graph)
    : graph_(graph),
      to_node_(num_vertices(graph)),
      depths_(num_vertices(graph), 0),
      is_in_forest_(num_edges(graph), false)
  {
    std::vector<boost::default_color_type> colors(num_vertices(graph), boost::white_color);
    const auto map_of = [&](auto& values) {
      return boost::make_iterator_property_map(values.begin(), get(boost::vertex_index, graph));
    };
    boost::queue<vertex_descriptor> queue;
    const auto visitor =
      boost::make_bfs_visitor(std::make_pair(boost::record_edge_predecessors(map_of(to_node_), boost::on_tree_edge()),
                                             boost::record_distances(map_of(depths_), boost::on_tree_edge())));
    for(const vertex_descriptor root : CGAL::make_range(vertices(graph)))
    {
      if(colors[root] == boost::white_color)
        boost::breadth_first_visit(graph, root, queue, visitor, map_of(colors));
    }
    for(const vertex_descriptor v : CGAL::make_range(vertices(graph)))
    {
      if(depths_[v] != 0)
        is_in_forest_[get(boost::edge_index, graph, to_node_[v])] = true;
    }
  }

  bool contains(std::size_t arc) const { return is_in_forest_[arc]; }

  // The numbers of the arcs on the path between two nodes of one tree.
  std::vector<std::size_t> path(vertex_descriptor from, vertex_descriptor to) const
  {
    std::vector<std::size_t> begin, end;
    while(from != to)
    {
      const bool is_from_lower = depths_[from] >= depths_[to];
      vertex_descriptor& v = is_from_lower ? from : to;
      (is_from_lower ? begin : end).push_back(get(boost::edge_index, graph_, to_node_[v]));
      v = source(to_node_[v], graph_) == v ? target(to_node_[v], graph_) : source(to_node_[v], graph_);
    }
    begin.insert(begin.end(), end.rbegin(), end.rend());
    return begin;
  }

private:
  const Undirected_graph& graph_;
  std::vector<edge_descriptor> to_node_;
  std::vector<std::size_t> depths_;
  std::vector<bool> is_in_forest_;
};

} // namespace CGAL::Reeb_graph::internal

#endif // CGAL_REEB_GRAPH_INTERNAL_BASE_UNION_FIND_H
