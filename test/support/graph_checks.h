// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_TEST_GRAPH_CHECKS_H
#define CGAL_REEB_GRAPH_TEST_GRAPH_CHECKS_H

#include "brute_force_oracle.h"
#include "mesh_builders.h"

#include <CGAL/Reeb_graph/scalar_maps.h>
#include <CGAL/Reeb_graph_traits.h>
#include <CGAL/compute_reeb_graph.h>

#include <boost/graph/iteration_macros.hpp>

#include <algorithm>
#include <cstddef>
#include <set>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

// What the tests ask of a Reeb graph. The checks return the first fault that they find, the empty string if none.
namespace graph_checks {
using brute_force_oracle::Oracle;
using CGAL::Reeb_graph::Method;
using CGAL::Reeb_graph::Node_kind;
using mesh_builders::Mesh_numbers;

template <class Mesh, class Scalar = double>
using Scalar_map_of =
  decltype(CGAL::Reeb_graph::make_scalar_map(std::declval<const Mesh&>(), std::declval<const std::vector<Scalar>&>()));

template <class Mesh, class Scalar = double>
using Graph_of = typename CGAL::Reeb_graph_traits<Mesh, Scalar_map_of<Mesh, Scalar>>::Graph;

template <class Mesh, class Scalar>
Graph_of<Mesh, Scalar> compute(const Mesh& mesh,
                               const std::vector<Scalar>& values,
                               bool keeps_degree_two_nodes = false,
                               Method method = Method::AUTOMATIC)
{
  namespace parameters = CGAL::parameters;
  Graph_of<Mesh, Scalar> graph;
  CGAL::compute_reeb_graph(mesh, CGAL::Reeb_graph::make_scalar_map(mesh, values), graph,
                           parameters::method(method).keep_degree_two_nodes(keeps_degree_two_nodes));
  return graph;
}

// Are they the same, chains included, and in the same order? Both have to be of the same mesh.
template <class Graph>
bool are_identical(const Graph& a, const Graph& b)
{
  if(num_vertices(a) != num_vertices(b) || num_edges(a) != num_edges(b))
    return false;
  for(std::size_t node = 0; node < num_vertices(a); ++node)
    if(a[node].vertex != b[node].vertex || a[node].value != b[node].value || a[node].kind != b[node].kind)
      return false;
  const auto range = edges(a);
  return std::equal(range.first, range.second, edges(b).first, [&](const auto& arc, const auto& other) {
    return source(arc, a) == source(other, b) && target(arc, a) == target(other, b) && a[arc].chain == b[other].chain;
  });
}

template <class Mesh, class Scalar>
Oracle make_oracle(const Mesh_numbers<Mesh>& numbers, const std::vector<Scalar>& values, bool keeps_degree_two_nodes)
{
  return Oracle(numbers.number_of_vertices(), numbers.template triangles<brute_force_oracle::Triangle>(), values,
                keeps_degree_two_nodes);
}

// Are the arcs numbered from 0 in their order?
template <class Graph>
bool are_arcs_numbered(const Graph& graph)
{
  std::size_t number = 0;
  for(const auto arc : CGAL::make_range(edges(graph)))
    if(get(boost::edge_index, graph, arc) != number++)
      return false;
  return number == num_edges(graph);
}

// A graph without handles, to compare those of different meshes.
struct Plain_arc
{
  std::size_t lower, upper;                // vertices
  std::vector<std::size_t> chain_vertices; // one more than halfedges

  friend bool operator==(const Plain_arc& a, const Plain_arc& b)
  {
    return a.lower == b.lower && a.upper == b.upper && a.chain_vertices == b.chain_vertices;
  }
};

struct Plain_graph
{
  std::vector<std::pair<std::size_t, Node_kind>> nodes;
  std::vector<Plain_arc> arcs;

  friend bool operator==(const Plain_graph& a, const Plain_graph& b) { return a.nodes == b.nodes && a.arcs == b.arcs; }
};

template <class Mesh, class Graph>
Plain_graph plain(const Mesh_numbers<Mesh>& numbers, const Graph& graph)
{
  Plain_graph result;
  for(std::size_t node = 0; node < num_vertices(graph); ++node)
    result.nodes.emplace_back(numbers.vertex(graph[node].vertex), graph[node].kind);
  BGL_FORALL_EDGES_T(arc, graph, Graph)
  {
    const std::size_t lower = numbers.vertex(graph[source(arc, graph)].vertex);
    Plain_arc plain_arc = {lower, numbers.vertex(graph[target(arc, graph)].vertex), {}};
    if(!graph[arc].chain.empty())
      plain_arc.chain_vertices.push_back(numbers.source_vertex(graph[arc].chain.front()));
    for(const auto h : graph[arc].chain)
      plain_arc.chain_vertices.push_back(numbers.target_vertex(h));
    result.arcs.push_back(plain_arc);
  }
  return result;
}

template <class Mesh, class Scalar>
Plain_graph compute_plain(const Mesh& mesh, const std::vector<Scalar>& values, bool keeps_degree_two_nodes = false)
{
  return plain(Mesh_numbers<Mesh>(mesh), compute(mesh, values, keeps_degree_two_nodes));
}

inline Node_kind expected_kind(std::size_t contours_below, std::size_t contours_above)
{
  if(contours_below == 0 && contours_above == 0)
    return Node_kind::ISOLATED;
  if(contours_below == 0)
    return Node_kind::MINIMUM;
  if(contours_above == 0)
    return Node_kind::MAXIMUM;
  return contours_below == 1 && contours_above == 1 ? Node_kind::DEGREE_TWO : Node_kind::SADDLE;
}

// The nodes are those of the oracle, in ascending order.
template <class Mesh, class Graph, class Scalar>
std::string fault_of_nodes(const Mesh_numbers<Mesh>& numbers,
                           const Graph& graph,
                           const Oracle& oracle,
                           const std::vector<Scalar>& values)
{
  std::size_t node = 0;
  for(const std::size_t v : oracle.order)
  {
    if(!oracle.is_node(v))
      continue;
    const std::string name = "node " + std::to_string(node) + " (vertex " + std::to_string(v) + ")";
    if(node == num_vertices(graph) || numbers.vertex(graph[node].vertex) != v)
      return name + " is missing, or another vertex";
    if(!(graph[node].value == values[v]))
      return name + " has another value";
    if(graph[node].kind != expected_kind(oracle.contours_below[v], oracle.contours_above[v]))
      return name + " is of another kind";
    if(in_degree(node, graph) != oracle.contours_below[v] || out_degree(node, graph) != oracle.contours_above[v])
      return name + " is of another degree";
    ++node;
  }
  return node == num_vertices(graph) ? "" : "more nodes than expected";
}

// The arcs are those of the oracle, sorted by lower node, upper node and second vertex of the chain.
template <class Mesh, class Graph>
std::string fault_of_arcs(const Mesh_numbers<Mesh>& numbers, const Graph& graph, const Oracle& oracle)
{
  std::vector<std::pair<std::size_t, std::size_t>> arcs, expected;
  std::vector<std::tuple<std::size_t, std::size_t, std::size_t>> keys;
  BGL_FORALL_EDGES_T(arc, graph, Graph)
  {
    const std::size_t lower = source(arc, graph), upper = target(arc, graph);
    arcs.emplace_back(numbers.vertex(graph[lower].vertex), numbers.vertex(graph[upper].vertex));
    if(graph[arc].chain.empty())
      return "an arc has an empty chain";
    keys.emplace_back(lower, upper, oracle.rank[numbers.target_vertex(graph[arc].chain.front())]);
  }
  for(const auto& arc : oracle.arcs)
    expected.emplace_back(arc.lower, arc.upper);
  std::sort(arcs.begin(), arcs.end());
  std::sort(expected.begin(), expected.end());
  if(arcs != expected)
    return "the arcs join other nodes: " + std::to_string(arcs.size()) + " arcs, expected "
         + std::to_string(expected.size());
  return std::is_sorted(keys.begin(), keys.end()) ? "" : "the arcs are not sorted";
}

// The chain ascends, is connected, leads from the lower node to the level just below the upper one, and all of that
// way crosses contours of one arc of the oracle only, whose number is returned too.
template <class Mesh, class Chain>
std::pair<std::string, std::size_t> fault_of_chain(const Mesh_numbers<Mesh>& numbers,
                                                   const Chain& chain,
                                                   std::size_t lower,
                                                   std::size_t upper,
                                                   const Oracle& oracle)
{
  std::size_t end = lower, oracle_arc = brute_force_oracle::none;
  for(std::size_t i = 0; i < chain.size(); ++i)
  {
    const std::string name = "halfedge " + std::to_string(i) + " of the chain ";
    const std::size_t source = numbers.source_vertex(chain[i]), target = numbers.target_vertex(chain[i]);
    if(source != end)
      return {name + "does not start where it should", oracle_arc};
    if(oracle.rank[source] >= oracle.rank[target])
      return {name + "does not ascend", oracle_arc};
    const bool reaches_upper_node = oracle.rank[target] >= oracle.rank[upper];
    if(reaches_upper_node != (i + 1 == chain.size()))
      return {name + "is the last one too early, or too late", oracle_arc};
    const std::size_t last_level = (std::min)(oracle.rank[target], oracle.rank[upper]);
    for(std::size_t level = oracle.rank[source]; level < last_level; ++level)
    {
      const std::size_t crossed_arc = oracle.arc_of_edge[level][numbers.edge(chain[i])];
      if(oracle_arc == brute_force_oracle::none)
        oracle_arc = crossed_arc;
      if(crossed_arc == brute_force_oracle::none || crossed_arc != oracle_arc)
        return {name + "leaves its arc", oracle_arc};
    }
    end = target;
  }
  return {"", oracle_arc};
}

// The chains are good, and each of them is in another arc of the oracle, with the same nodes.
template <class Mesh, class Graph>
std::string fault_of_chains(const Mesh_numbers<Mesh>& numbers, const Graph& graph, const Oracle& oracle)
{
  std::set<std::size_t> oracle_arcs;
  std::size_t number = 0;
  BGL_FORALL_EDGES_T(arc, graph, Graph)
  {
    const std::string name = "arc " + std::to_string(number++) + ": ";
    const std::size_t lower = numbers.vertex(graph[source(arc, graph)].vertex);
    const std::size_t upper = numbers.vertex(graph[target(arc, graph)].vertex);
    const auto fault = fault_of_chain(numbers, graph[arc].chain, lower, upper, oracle);
    if(!fault.first.empty())
      return name + fault.first;
    if(fault.second == brute_force_oracle::none)
      return name + "its chain crosses nothing";
    const auto& oracle_arc = oracle.arcs[fault.second];
    if(oracle_arc.lower != lower || oracle_arc.upper != upper)
      return name + "its chain is in an arc between other nodes";
    if(!oracle_arcs.insert(fault.second).second)
      return name + "its chain is in the same arc as another chain";
  }
  return "";
}

// All of the above, for both methods.
template <class Mesh, class Scalar>
std::string fault_of_reeb_graph(const Mesh& mesh, const std::vector<Scalar>& values, bool keeps_degree_two_nodes)
{
  const Mesh_numbers<Mesh> numbers(mesh);
  const Oracle oracle = make_oracle(numbers, values, keeps_degree_two_nodes);
  for(const Method method : {Method::CRITICAL_SETS, Method::CONTOUR_TREES})
  {
    const auto graph = compute(mesh, values, keeps_degree_two_nodes, method);
    std::string fault = fault_of_nodes(numbers, graph, oracle, values);
    if(fault.empty())
      fault = fault_of_arcs(numbers, graph, oracle);
    if(fault.empty())
      fault = fault_of_chains(numbers, graph, oracle);
    if(fault.empty() && !are_arcs_numbered(graph))
      fault = "arcs are not numbered in their order";
    if(!fault.empty())
      return (method == Method::CRITICAL_SETS ? "critical sets: " : "contour trees: ") + fault;
  }
  return "";
}

} // namespace graph_checks

#endif // CGAL_REEB_GRAPH_TEST_GRAPH_CHECKS_H
