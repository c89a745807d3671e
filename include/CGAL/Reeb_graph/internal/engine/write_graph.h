// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_INTERNAL_ENGINE_WRITE_GRAPH_H
#define CGAL_REEB_GRAPH_INTERNAL_ENGINE_WRITE_GRAPH_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/internal/base/graph_requirements.h>
#include <CGAL/Reeb_graph/internal/complex/flatten.h>
#include <CGAL/Reeb_graph/internal/engine/reduce_arcs.h>
#include <CGAL/Reeb_graph/internal/engine/walks.h>

#include <CGAL/boost/graph/iterator.h>

#include <boost/graph/adjacency_list.hpp>

#include <algorithm>
#include <cstddef>
#include <memory>
#include <utility>
#include <vector>

namespace CGAL::Reeb_graph::internal {

// The chains of all arcs, one behind the other as their segments are.
struct Flat_chains
{
  std::vector<Plain_vector<Halfedge_index>> parts; // of the sequence of all halfedges, which are ascending
  Plain_vector<std::size_t> begins_of_parts;
  Indexed_vector<Chain_segment_index, std::size_t> begins_of_segments; // and the end of the last one

  std::size_t size() const { return begins_of_segments.back(); }
  std::size_t begin(const Flat_arc& arc) const { return begins_of_segments[arc.first_segment]; }
  std::size_t end(const Flat_arc& arc) const
  {
    return begins_of_segments[Chain_segment_index(arc.first_segment.number() + arc.number_of_segments)];
  }
};

// Walks the segments of chains from `begin` to `end`. A path that has entered an arc cannot leave it below the upper
// node, so comparisons tell the end, and the chain does not depend on how the arc was found. No vertex is passed twice,
// unless the order contradicts itself.
template <class Complex, class Order>
Plain_vector<Halfedge_index> walk_segments(const Complex& complex,
                                           const Order& order,
                                           const Chain_segment* begin,
                                           const Chain_segment* end,
                                           std::size_t* begins_of_segments)
{
  Plain_vector<Halfedge_index> halfedges;
  halfedges.reserve(3 * static_cast<std::size_t>(end - begin));
  const std::size_t most = complex.number_of_vertices() + static_cast<std::size_t>(end - begin);
  const auto add = [&](const Ascending_step& step) {
    const bool is_ascending = complex.target(step.edge) == step.target;
    halfedges.push_back(is_ascending ? step.edge : opposite_of(step.edge));
  };
  for(const Chain_segment* segment = begin; segment != end; ++segment)
  {
    *begins_of_segments++ = halfedges.size();
    add(segment->first_step);
    const auto is_below = [&](Vertex_index vertex) { return order(vertex, segment->upper_vertex); };
    climb(complex, order, segment->first_step.target, is_below, [&](Vertex_index vertex, const Ascending_step& step) {
      if(halfedges.size() == most)
        complex.throw_contradiction_near(vertex);
      add(step);
    });
  }
  return halfedges;
}

// Engines find arcs by and large in the order of where they begin on the mesh, and segments have kept that order.
template <class ConcurrencyTag, class Complex, class Order>
Flat_chains find_arc_chains(const Complex& complex, const Order& order, const Flat_graph& graph)
{
  const std::size_t size = graph.segments.size();
  Flat_chains chains;
  constexpr std::size_t smallest_part = 4; // On a smooth field there are few chains, but long ones.
  chains.parts.resize(number_of_parts<ConcurrencyTag>(size, smallest_part));
  chains.begins_of_segments.reset(size + 1);
  for_each_part<ConcurrencyTag>(chains.parts.size(), size, [&](std::size_t part, std::size_t begin, std::size_t end) {
    chains.parts[part] = walk_segments(complex, order, graph.segments.data() + begin, graph.segments.data() + end,
                                       chains.begins_of_segments.data() + begin);
  });
  std::size_t sum = 0;
  for(const Plain_vector<Halfedge_index>& part : chains.parts)
  {
    chains.begins_of_parts.push_back(sum);
    sum += part.size();
  }
  chains.begins_of_segments.back() = sum;
  for_each_part<ConcurrencyTag>(chains.parts.size(), size, [&](std::size_t part, std::size_t begin, std::size_t end) {
    for(std::size_t i = begin; part != 0 && i != end; ++i)
      chains.begins_of_segments[Chain_segment_index(i)] += chains.begins_of_parts[part];
  });
  return chains;
}

#define CGAL_REEB_GRAPH_FIND_ARC_CHAINS(PREFIX, TAG, COMPLEX, SCALAR)                                                  \
  PREFIX template Flat_chains find_arc_chains<TAG>(const COMPLEX&, const Natural_order<SCALAR>&, const Flat_graph&);
CGAL_REEB_GRAPH_FOR_COMPLEXES(CGAL_REEB_GRAPH_FIND_ARC_CHAINS)

// The halfedges of the mesh in the chains.
template <class ConcurrencyTag, class FaceListGraph>
auto chain_halfedges(const FaceListGraph& mesh,
                     const Halfedge_list<FaceListGraph>& halfedge_list,
                     const Flat_chains& chains)
{
  typedef typename boost::graph_traits<FaceListGraph>::halfedge_descriptor halfedge_descriptor;
  std::vector<halfedge_descriptor> halfedges(chains.size());
  for_each_index<ConcurrencyTag>(chains.parts.size(), [&](std::size_t part) {
    std::transform(chains.parts[part].begin(), chains.parts[part].end(),
                   halfedges.begin() + chains.begins_of_parts[part],
                   [&](Halfedge_index halfedge) { return halfedge_list(mesh, halfedge); });
  });
  return std::make_shared<const std::vector<halfedge_descriptor>>(std::move(halfedges));
}

template <class Graph>
using Node_array = decltype(std::declval<Graph&>().m_vertices.reserve(0));

// Makes room for the nodes of an empty graph if they are in an array. There is no documented way, but this one has
// always been there. Threads share what takes longest, longer than to write the nodes: to touch each new page of memory
// for the first time.
template <class ConcurrencyTag, class Graph>
void reserve_nodes(Graph& graph, std::size_t size)
{
  if constexpr(Has<Node_array, Graph>::value)
  {
    graph.m_vertices.reserve(size);
    if constexpr(is_parallel<ConcurrencyTag>())
    {
      constexpr std::size_t page = 4096; // or a part of one
      volatile char* const bytes = reinterpret_cast<volatile char*>(graph.m_vertices.data());
      const std::size_t number_of_pages = size * sizeof(graph.m_vertices[0]) / page;
      for_each_part<ConcurrencyTag>(number_of_parts<ConcurrencyTag>(number_of_pages, 64), number_of_pages,
                                    [&](std::size_t, std::size_t begin, std::size_t end) {
                                      for(std::size_t i = begin; i != end; ++i)
                                        bytes[i * page] = 0;
                                    });
    }
  }
}

// Fetches a node ahead of add_edge(): its lists of arcs take more than one line of the cache.
template <class Graph>
void prefetch_node(const Graph& graph, std::size_t node)
{
  if constexpr(Has<Node_array, Graph>::value)
  {
    constexpr std::size_t line = 64;
    const char* const bytes = reinterpret_cast<const char*>(&graph.m_vertices[node]);
    for(std::size_t i = 0; i < sizeof(graph.m_vertices[0]); i += line)
      prefetch(bytes + i);
  }
}

// Replaces the content of `graph` by the nodes, and by the arcs without their chains.
template <class ConcurrencyTag, class VertexList, class Scalar, class ReebGraph>
void write_nodes_and_arcs(const VertexList& vertex_list,
                          const Indexed_vector<Vertex_index, Scalar>& values,
                          const Flat_graph& flat_graph,
                          ReebGraph& graph)
{
  typedef typename boost::vertex_bundle_type<ReebGraph>::type Node;
  graph.clear();
  reserve_nodes<ConcurrencyTag>(graph, flat_graph.nodes.size());
  constexpr std::size_t ahead = 12;
  for(const Node_index i : flat_graph.nodes.keys())
  {
    const Node_index later(i.number() + ahead);
    if(flat_graph.nodes.contains(later))
      prefetch_element(values, flat_graph.nodes[later].vertex);
    const Flat_node& flat_node = flat_graph.nodes[i];
    Node node;
    node.vertex = vertex_list[flat_node.vertex];
    node.value = values[flat_node.vertex];
    node.kind = flat_node.kind;
    add_vertex(std::move(node), graph);
  }
  for(const Arc_index i : flat_graph.arcs.keys())
  {
    const Arc_index later(i.number() + ahead);
    if(flat_graph.arcs.contains(later))
      prefetch_node(graph, flat_graph.arcs[later].upper.number());
    add_edge(flat_graph.arcs[i].lower.number(), flat_graph.arcs[i].upper.number(), graph);
  }
}

// Gives the arcs their numbers and their chains, which are parts of `halfedges`.
template <class HalfedgeDescriptor, class ReebGraph>
void write_chains(const std::shared_ptr<const std::vector<HalfedgeDescriptor>>& halfedges,
                  const Flat_chains& chains,
                  const Flat_graph& flat_graph,
                  ReebGraph& graph)
{
  constexpr std::size_t ahead = 12;
  Arc_index i(0);
  for(const auto arc : CGAL::make_range(edges(graph)))
  {
    const Arc_index later(i.number() + ahead);
    if(flat_graph.arcs.contains(later))
      prefetch(&chains.begins_of_segments[flat_graph.arcs[later].first_segment]);
    const Flat_arc& flat_arc = flat_graph.arcs[i];
    set_arc_index(graph, arc, i.number());
    ++i;
    graph[arc].chain = {halfedges, chains.begin(flat_arc), chains.end(flat_arc) - chains.begin(flat_arc)};
  }
}

// Walks the chains of the arcs beside writing nodes and arcs, for which one thread is enough, into `graph`.
template <class ConcurrencyTag, class FaceListGraph, class Complex, class Scalar, class Order, class ReebGraph>
void write_graph(const FaceListGraph& mesh,
                 const Complex& complex,
                 const Mesh_numbers<FaceListGraph>& numbers,
                 const Indexed_vector<Vertex_index, Scalar>& values,
                 const Order& order,
                 const Flat_graph& flat_graph,
                 ReebGraph& graph)
{
  Flat_chains chains;
  decltype(chain_halfedges<ConcurrencyTag>(mesh, numbers.halfedges, chains)) halfedges;
  bool is_graph_changed = false;
  try
  {
    invoke_both<ConcurrencyTag>(
      [&] {
        chains = find_arc_chains<ConcurrencyTag>(complex, order, flat_graph);
        halfedges = chain_halfedges<ConcurrencyTag>(mesh, numbers.halfedges, chains);
        chains.parts.clear(); // The graph takes much memory.
      },
      [&] {
        is_graph_changed = true;
        write_nodes_and_arcs<ConcurrencyTag>(numbers.vertices, values, flat_graph, graph);
      });
  }
  catch(...) // Memory has run out, or the order of the user throws.
  {
    if(is_graph_changed)
      graph.clear();
    throw;
  }
  write_chains(halfedges, chains, flat_graph, graph);
}

} // namespace CGAL::Reeb_graph::internal

#endif // CGAL_REEB_GRAPH_INTERNAL_ENGINE_WRITE_GRAPH_H
