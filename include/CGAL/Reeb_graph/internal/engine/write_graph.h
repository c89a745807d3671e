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

#include <CGAL/Reeb_graph/internal/base/requirements.h>
#include <CGAL/Reeb_graph/internal/complex/flatten.h>
#include <CGAL/Reeb_graph/internal/engine/walks.h>

#include <CGAL/boost/graph/iterator.h>

#include <boost/graph/adjacency_list.hpp>

#include <algorithm>
#include <cstddef>
#include <memory>
#include <numeric>
#include <utility>
#include <vector>

namespace CGAL::Reeb_graph::internal {

inline Node_kind node_kind(Index in_degree, Index out_degree)
{
  if(in_degree == 0)
    return out_degree == 0 ? Node_kind::ISOLATED : Node_kind::MINIMUM;
  if(out_degree == 0)
    return Node_kind::MAXIMUM;
  return in_degree == 1 && out_degree == 1 ? Node_kind::DEGREE_TWO : Node_kind::SADDLE;
}

// The groups that critical vertices form: each one alone, or if ties are contracted, those that arcs of length zero
// connect.
class Tie_groups
{
public:
  Tie_groups(const Vertex_order& order, const Swept_vertices& critical_vertices, const Swept_arcs& arcs, Ties ties)
    : order_(order),
      critical_vertices_(critical_vertices),
      are_ties_contracted_(ties == Ties::CONTRACT)
  {
    if(!are_ties_contracted_)
      return;
    is_on_plateau_.reset(critical_vertices.size(), false);
    Disjoint_sets<Swept_index> groups(critical_vertices.size());
    for(const Swept_arc& arc : arcs)
    {
      if(!is_contracted(arc))
        continue;
      groups.unite(arc.lower_vertex(), arc.upper_vertex());
      is_on_plateau_[arc.lower_vertex()] = is_on_plateau_[arc.upper_vertex()] = true;
    }
    groups_ = groups.take_roots();
  }

  bool are_ties_contracted() const { return are_ties_contracted_; }

  bool is_contracted(const Swept_arc& arc) const
  {
    return are_ties_contracted_
        && order_.are_tied(critical_vertices_.vertex(arc.lower_vertex()),
                           critical_vertices_.vertex(arc.upper_vertex()));
  }

  // A group has the name of one of its critical vertices.
  Swept_index group_of(Swept_index critical) const { return are_ties_contracted_ ? groups_[critical] : critical; }

  // Whether there are others in the group.
  bool is_on_plateau(Swept_index critical) const { return are_ties_contracted_ && is_on_plateau_[critical]; }

private:
  const Vertex_order& order_;
  const Swept_vertices& critical_vertices_;
  const bool are_ties_contracted_;
  // Groups and plateaus are empty unless ties are contracted.
  Indexed_vector<Swept_index, Swept_index> groups_;
  Indexed_vector<Swept_index, bool> is_on_plateau_;
};

// Makes nodes and arcs of the critical vertices and the arcs between them. A group of critical vertices is a node,
// unless one arc enters it and one leaves it.
template <class Complex>
class Arc_reduction
{
public:
  Arc_reduction(const Threads& threads,
                const Complex& complex,
                const Vertex_order& order,
                const Swept_vertices& critical_vertices,
                const Swept_arcs& arcs,
                Ties ties,
                bool are_degree_two_nodes_kept)
    : threads_(threads),
      complex_(complex),
      order_(order),
      critical_vertices_(critical_vertices),
      arcs_(arcs),
      groups_(order, critical_vertices, arcs, ties),
      are_degree_two_nodes_kept_(are_degree_two_nodes_kept)
  {}

  Flat_graph operator()(bool are_passing_arcs_named)
  {
    count_degrees();
    make_nodes();
    if(are_passing_arcs_named)
    {
      first_segment_of_group_.reset(critical_vertices_.size(), no_index);
      first_segment_of_arc_.reset(arcs_.size(), no_index);
    }
    make_arcs();
    sort_arcs_of_nodes();
    if(are_passing_arcs_named)
      name_passing_arcs();
    return std::move(graph_);
  }

private:
  void count_degrees()
  {
    degrees_.reset(critical_vertices_.size(), Degrees{0, 0, no_index});
    ranks_.reset(arcs_.size());
    for(const Swept_arc_index i : arcs_.keys())
    {
      if(groups_.is_contracted(arcs_[i]))
        continue;
      Degrees& degrees = degrees_[groups_.group_of(arcs_[i].lower_vertex())];
      ranks_[i] = degrees.out++;
      degrees.last_out_arc = i;
      ++degrees_[groups_.group_of(arcs_[i].upper_vertex())].in;
    }
  }

  // A node is at the lowest critical vertex of its group. As many arcs leave the node as leave the group, which is all
  // that there is to count.
  void make_nodes()
  {
    const Index size = critical_vertices_.size();
    graph_.node_of_critical.reset(size, no_index);
    Indexed_vector<Swept_index, Node_index>& node_of_group = graph_.node_of_critical;
    graph_.nodes.reserve(size);
    begins_of_arcs_.reserve(size + 1);
    Index number_of_arcs = 0;
    constexpr std::size_t ahead = 16;
    const Plain_vector<Swept_index>& ascending = critical_vertices_.ascending();
    for(std::size_t place = 0; place != size; ++place)
    {
      if(place + ahead < size)
      {
        critical_vertices_.prefetch(ascending[place + ahead]);
        prefetch(&degrees_[ascending[place + ahead]]);
        prefetch(&node_of_group[ascending[place + ahead]]);
      }
      const Swept_index i = ascending[place], group = groups_.group_of(i);
      const Node_kind kind = node_kind(degrees_[group].in, degrees_[group].out);
      const bool is_node = kind != Node_kind::DEGREE_TWO || are_degree_two_nodes_kept_;
      if(!is_node || node_of_group[group] != no_index)
        continue;
      node_of_group[group] = graph_.nodes.end_key();
      graph_.nodes.push_back({critical_vertices_.vertex(i), kind});
      begins_of_arcs_.push_back(Arc_index(number_of_arcs));
      number_of_arcs += degrees_[group].out;
    }
    begins_of_arcs_.push_back(Arc_index(number_of_arcs));
    graph_.arcs.reset(number_of_arcs);
    if(!groups_.are_ties_contracted())
      return;
    for(const Swept_index i : critical_vertices_.indices())
      graph_.node_of_critical[i] = node_of_group[groups_.group_of(i)];
  }

  // Puts the arcs in order by lower node, and their segments in the order of the critical arcs that they begin with.
  void make_arcs()
  {
    const std::size_t number_of_parts = threads_.number_of_parts(arcs_.size());
    const Plain_vector<std::size_t> begins_of_segments = find_begins_of_segments(number_of_parts);
    graph_.segments.reset(begins_of_segments.back());
    const auto make_arcs_of_part = [&](std::size_t part, std::size_t begin, std::size_t end) {
      Chain_segment_index segment(begins_of_segments[part]);
      for_each_first_arc(begin, end, [&](Swept_arc_index i, Node_index lower) {
        graph_.arcs[Arc_index(begins_of_arcs_[lower].number() + ranks_[i])] = make_arc(i, lower, segment);
      });
    };
    threads_.for_each_part(number_of_parts, arcs_.size(), make_arcs_of_part);
  }

  // The places where the segments of each part of the critical arcs begin in the sequence of all segments; and the end.
  Plain_vector<std::size_t> find_begins_of_segments(std::size_t number_of_parts) const
  {
    Plain_vector<std::size_t> begins_of_segments(number_of_parts + 1, 0);
    const auto count_segments = [&](std::size_t part, std::size_t begin, std::size_t end) {
      std::size_t count = 0;
      for_each_first_arc(begin, end, [&](Swept_arc_index i, Node_index) {
        follow_arc(
          i, [&](const Chain_segment&) { ++count; }, [](Swept_index, Swept_arc_index) {});
      });
      begins_of_segments[part + 1] = count;
    };
    threads_.for_each_part(number_of_parts, arcs_.size(), count_segments);
    std::partial_sum(begins_of_segments.begin(), begins_of_segments.end(), begins_of_segments.begin());
    return begins_of_segments;
  }

  // Calls visit(critical arc, lower node) where an arc of the graph begins.
  template <class Visit>
  void for_each_first_arc(std::size_t begin, std::size_t end, const Visit& visit) const
  {
    constexpr std::size_t far_ahead = 32, ahead = 16;
    const auto lower_vertex = [&](std::size_t i) { return arcs_[Swept_arc_index(i)].lower_vertex(); };
    const auto upper_vertex = [&](std::size_t i) { return arcs_[Swept_arc_index(i)].upper_vertex(); };
    for(std::size_t i = begin; i != end; ++i)
    {
      if(i + far_ahead < end)
      {
        prefetch_element(graph_.node_of_critical, lower_vertex(i + far_ahead));
        prefetch_element(graph_.node_of_critical, upper_vertex(i + far_ahead)); // for visit(), as the next one
        critical_vertices_.prefetch(upper_vertex(i + far_ahead));
      }
      if(i + ahead < end)
        prefetch_element(begins_of_arcs_, graph_.node_of_critical[lower_vertex(i + ahead)]);
      const Node_index lower = graph_.node_of_critical[lower_vertex(i)];
      if(lower != no_index && !groups_.is_contracted(arcs_[Swept_arc_index(i)]))
        visit(Swept_arc_index(i), lower);
    }
  }

  Flat_arc make_arc(Swept_arc_index i, Node_index lower, Chain_segment_index& segment)
  {
    const Chain_segment_index first_segment = segment;
    name_segment(first_segment_of_arc_, i, first_segment);
    const auto add_segment = [&](const Chain_segment& added) {
      graph_.segments[segment] = added;
      ++segment;
    };
    const Node_index upper = follow_arc(i, add_segment, [&](Swept_index group, Swept_arc_index next_arc) {
      name_segment(first_segment_of_group_, group, first_segment);
      name_segment(first_segment_of_arc_, next_arc, first_segment);
    });
    return {lower, upper, first_segment, segment.number() - first_segment.number()};
  }

  // Follows an arc over the groups that are no nodes. Calls add_segment(segment of its chain), and pass(group, critical arc
  // that leaves it). At a single vertex every ascending path goes on inside the arc; on a plateau it can end, and a new
  // segment begins where the arc leaves. Returns the upper node.
  template <class AddSegment, class Pass>
  Node_index follow_arc(Swept_arc_index i, const AddSegment& add_segment, const Pass& pass) const
  {
    Ascending_step first_step = arcs_[i].first_step;
    while(true)
    {
      const Swept_index critical = arcs_[i].upper_vertex();
      const Node_index node = graph_.node_of_critical[critical];
      const bool is_segment_ended = node != no_index || groups_.is_on_plateau(critical);
      if(is_segment_ended)
        add_segment(Chain_segment{first_step, critical_vertices_.vertex(critical)});
      if(node != no_index)
        return node;
      const Swept_index group = groups_.group_of(critical);
      i = degrees_[group].last_out_arc;
      pass(group, i);
      if(is_segment_ended)
        first_step = arcs_[i].first_step;
    }
  }

  template <class Key>
  static void name_segment(Indexed_vector<Key, Chain_segment_index>& first_segments,
                           Key i,
                           Chain_segment_index first_segment)
  {
    if(!first_segments.empty())
      first_segments[i] = first_segment;
  }

  // The canonical order of the arcs that leave one node: by upper node, then by the second and the first vertex of their
  // chains. Nothing in it depends on how the arcs were found. Halfedges count only if there are several between two
  // vertices: meshes number them in different ways.
  void sort_arcs_of_nodes()
  {
    const auto first_vertex = [&](const Ascending_step& step) {
      const Vertex_index source = complex_.source(step.edge);
      return source == step.target ? complex_.target(step.edge) : source;
    };
    const auto is_before = [&](const Flat_arc& arc_a, const Flat_arc& arc_b) {
      if(arc_a.upper != arc_b.upper)
        return arc_a.upper < arc_b.upper;
      const Ascending_step& a = graph_.segments[arc_a.first_segment].first_step;
      const Ascending_step& b = graph_.segments[arc_b.first_segment].first_step;
      if(a.target != b.target)
        return order_(a.target, b.target);
      const Vertex_index first_of_a = first_vertex(a), first_of_b = first_vertex(b);
      return first_of_a != first_of_b ? order_(first_of_a, first_of_b) : a.edge < b.edge;
    };
    threads_.for_each<std::size_t>(graph_.nodes.size(), [&](std::size_t node) {
      const auto first = graph_.arcs.begin() + begins_of_arcs_[Node_index(node)].number();
      const auto last = graph_.arcs.begin() + begins_of_arcs_[Node_index(node + 1)].number();
      std::sort(first, last, is_before);
    });
  }

  // Sorting has moved the arcs, but each keeps its first segment.
  void name_passing_arcs()
  {
    Indexed_vector<Chain_segment_index, Arc_index> arc_of_first_segment(graph_.segments.size(), no_index);
    for(const Arc_index i : graph_.arcs.keys())
      arc_of_first_segment[graph_.arcs[i].first_segment] = i;
    const auto arc_of = [&](Chain_segment_index first_segment) -> Arc_index {
      return first_segment == no_index ? no_index : arc_of_first_segment[first_segment];
    };
    for(const Swept_index i : critical_vertices_.indices())
      graph_.arc_of_critical.push_back(arc_of(first_segment_of_group_[groups_.group_of(i)]));
    for(const Chain_segment_index first_segment : first_segment_of_arc_)
      graph_.arc_of_critical_arc.push_back(arc_of(first_segment));
  }

  struct Degrees
  {
    Index in;
    Index out;
    Swept_arc_index last_out_arc; // the only one of a group that is no node
  };

  const Threads threads_;
  const Complex& complex_;
  const Vertex_order& order_;
  const Swept_vertices& critical_vertices_;
  const Swept_arcs& arcs_;
  const Tie_groups groups_;
  const bool are_degree_two_nodes_kept_;
  Indexed_vector<Swept_index, Degrees> degrees_;         // by group
  Indexed_vector<Swept_arc_index, Index> ranks_;         // how many arcs before leave the same group
  Indexed_vector<Node_index, Arc_index> begins_of_arcs_; // that leave a node; and the end of the last ones
  Indexed_vector<Swept_index, Chain_segment_index> first_segment_of_group_;   // that of the arc that passes the group
  Indexed_vector<Swept_arc_index, Chain_segment_index> first_segment_of_arc_; // that of the arc that it becomes part of
  Flat_graph graph_;
};

template <class Complex>
Flat_graph reduce_arcs(const Threads& threads,
                       const Complex& complex,
                       const Vertex_order& order,
                       const Swept_vertices& critical_vertices,
                       const Swept_arcs& arcs,
                       Ties ties,
                       bool are_degree_two_nodes_kept,
                       bool are_passing_arcs_named)
{
  return Arc_reduction<Complex>(threads, complex, order, critical_vertices, arcs, ties,
                                are_degree_two_nodes_kept)(are_passing_arcs_named);
}

#define CGAL_REEB_GRAPH_REDUCE_ARCS(PREFIX, COMPLEX)                                                                   \
  PREFIX template Flat_graph reduce_arcs(const Threads&, const COMPLEX&, const Vertex_order&, const Swept_vertices&,   \
                                         const Swept_arcs&, Ties, bool, bool);
CGAL_REEB_GRAPH_FOR_COMPLEXES(CGAL_REEB_GRAPH_REDUCE_ARCS)

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
// node, so comparisons tell the end, and the chain does not depend on how the arc was found.
template <class Complex>
Plain_vector<Halfedge_index> walk_segments(const Complex& complex,
                                           const Vertex_order& order,
                                           const Chain_segment* begin,
                                           const Chain_segment* end,
                                           std::size_t* begins_of_segments)
{
  Plain_vector<Halfedge_index> halfedges;
  halfedges.reserve(3 * static_cast<std::size_t>(end - begin));
  const auto add = [&](const Ascending_step& step) {
    const bool is_ascending = complex.target(step.edge) == step.target;
    halfedges.push_back(is_ascending ? step.edge : opposite_of(step.edge));
  };
  for(const Chain_segment* segment = begin; segment != end; ++segment)
  {
    *begins_of_segments++ = halfedges.size();
    add(segment->first_step);
    const auto is_below = [&](Vertex_index vertex) { return order(vertex, segment->upper_vertex); };
    climb(complex, order, segment->first_step.target, is_below, add);
  }
  return halfedges;
}

// Engines find arcs by and large in the order of where they begin on the mesh, and segments have kept that order.
template <class Complex>
Flat_chains find_arc_chains(const Threads& threads,
                            const Complex& complex,
                            const Vertex_order& order,
                            const Flat_graph& graph)
{
  const std::size_t size = graph.segments.size();
  Flat_chains chains;
  constexpr std::size_t smallest_part = 4; // On a smooth field there are few chains, but long ones.
  chains.parts.resize(threads.number_of_parts(size, smallest_part));
  chains.begins_of_segments.reset(size + 1);
  threads.for_each_part(chains.parts.size(), size, [&](std::size_t part, std::size_t begin, std::size_t end) {
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
  threads.for_each_part(chains.parts.size(), size, [&](std::size_t part, std::size_t begin, std::size_t end) {
    for(std::size_t i = begin; part != 0 && i != end; ++i)
      chains.begins_of_segments[Chain_segment_index(i)] += chains.begins_of_parts[part];
  });
  return chains;
}

#define CGAL_REEB_GRAPH_FIND_ARC_CHAINS(PREFIX, COMPLEX)                                                               \
  PREFIX template Flat_chains find_arc_chains(const Threads&, const COMPLEX&, const Vertex_order&, const Flat_graph&);
CGAL_REEB_GRAPH_FOR_COMPLEXES(CGAL_REEB_GRAPH_FIND_ARC_CHAINS)

// The halfedges of the mesh in the chains.
template <class FaceListGraph>
auto chain_halfedges(const Threads& threads,
                     const FaceListGraph& mesh,
                     const Halfedge_list<FaceListGraph>& halfedge_list,
                     const Flat_chains& chains)
{
  typedef typename boost::graph_traits<FaceListGraph>::halfedge_descriptor halfedge_descriptor;
  std::vector<halfedge_descriptor> halfedges(chains.size());
  threads.for_each_index(chains.parts.size(), [&](std::size_t part) {
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
template <class Graph>
void reserve_nodes(const Threads& threads, Graph& graph, std::size_t size)
{
  if constexpr(Has<Node_array, Graph>::value)
  {
    graph.m_vertices.reserve(size);
    if(threads.are_parallel())
    {
      constexpr std::size_t page = 4096; // or a part of one
      volatile char* const bytes = reinterpret_cast<volatile char*>(graph.m_vertices.data());
      const std::size_t number_of_pages = size * sizeof(graph.m_vertices[0]) / page;
      threads.for_each_part(threads.number_of_parts(number_of_pages, 64), number_of_pages,
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
template <class VertexList, class Field, class ReebGraph>
void write_nodes_and_arcs(const Threads& threads,
                          const VertexList& vertex_list,
                          const Field& field,
                          const Flat_graph& flat_graph,
                          ReebGraph& graph)
{
  typedef typename boost::vertex_bundle_type<ReebGraph>::type Node;
  graph.clear();
  reserve_nodes(threads, graph, flat_graph.nodes.size());
  constexpr std::size_t ahead = 12;
  for(const Node_index i : flat_graph.nodes.keys())
  {
    const Node_index later(i.number() + ahead);
    if(flat_graph.nodes.contains(later))
      prefetch_element(field.keys(), flat_graph.nodes[later].vertex);
    const Flat_node& flat_node = flat_graph.nodes[i];
    Node node;
    node.vertex = vertex_list[flat_node.vertex];
    node.value = field.value(flat_node.vertex);
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
template <class FaceListGraph, class Complex, class Field, class ReebGraph>
void write_graph(const Threads& threads,
                 const FaceListGraph& mesh,
                 const Complex& complex,
                 const Mesh_numbers<FaceListGraph>& numbers,
                 const Field& field,
                 const Flat_graph& flat_graph,
                 ReebGraph& graph)
{
  const Vertex_order order(field.keys());
  Flat_chains chains;
  decltype(chain_halfedges(threads, mesh, numbers.halfedges, chains)) halfedges;
  bool is_graph_changed = false;
  try
  {
    threads.invoke_both(
      [&] {
        chains = find_arc_chains(threads, complex, order, flat_graph);
        halfedges = chain_halfedges(threads, mesh, numbers.halfedges, chains);
        chains.parts.clear(); // The graph takes much memory.
      },
      [&] {
        is_graph_changed = true;
        write_nodes_and_arcs(threads, numbers.vertices, field, flat_graph, graph);
      });
  }
  catch(...) // Memory has run out.
  {
    if(is_graph_changed)
      graph.clear();
    throw;
  }
  write_chains(halfedges, chains, flat_graph, graph);
}

} // namespace CGAL::Reeb_graph::internal

#endif // CGAL_REEB_GRAPH_INTERNAL_ENGINE_WRITE_GRAPH_H
