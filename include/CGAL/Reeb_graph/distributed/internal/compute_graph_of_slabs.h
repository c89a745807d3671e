// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_DISTRIBUTED_INTERNAL_COMPUTE_GRAPH_OF_SLABS_H
#define CGAL_REEB_GRAPH_DISTRIBUTED_INTERNAL_COMPUTE_GRAPH_OF_SLABS_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/distributed/internal/exchange.h>
#include <CGAL/Reeb_graph/distributed/internal/solve_slab.h>
#include <CGAL/Reeb_graph/exceptions.h>
#include <CGAL/Reeb_graph/internal/base/Index.h>
#include <CGAL/Reeb_graph/internal/base/arrays.h>
#include <CGAL/Reeb_graph/internal/complex/Flat_mesh.h>
#include <CGAL/Reeb_graph/internal/engine/Between_stages.h>
#include <CGAL/Reeb_graph/internal/engine/walks.h>
#include <CGAL/Reeb_graph/internal/engine/write_graph.h>
#include <CGAL/Reeb_graph/options.h>

#include <boost/mpi/collectives.hpp>

#include <algorithm>
#include <cstddef>
#include <functional>
#include <memory>
#include <numeric>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL::Reeb_graph::internal {

// An arc that begins at a critical vertex, as all ranks know it, and the first step of its chain. Critical vertices are
// numbered in ascending order.
struct Critical_arc
{
  Index lower;
  Index upper; // a critical vertex; of an open arc, a contour of the highest level of its block
  Order_key first_target;
};

// Where a contour of the lowest level of a block leads to: a critical vertex, or a contour of its highest level.
struct Upper_end
{
  Index number;
  Index is_contour;
};

// Adjacent slabs with the arcs between their critical vertices, and what crosses their lowest and their highest level.
class Slab_block
{
public:
  Slab_block() = default;

  // One slab. `names` has the numbers of its critical vertices among those of all slabs.
  Slab_block(const Arcs_of_slab& found, const Slab_surface& surface, const Indexed_vector<Swept_index, Index>& names)
    : ends_of_contours_(found.numbers_of_contours[Side::LOWER])
  {
    const Tree_node first_contour(names.size());
    const Tree_node first_upper_contour(first_contour.number() + found.numbers_of_contours[Side::LOWER]);
    for(const Swept_arc& arc : found.arcs)
    {
      const bool is_open = arc.upper >= first_contour;
      const Index upper = is_open ? arc.upper.number() - first_upper_contour.number() : names[arc.upper_vertex()];
      if(arc.lower >= first_contour)
      {
        ends_of_contours_[arc.lower.number() - first_contour.number()] = {upper, is_open ? Index(1) : Index(0)};
        continue;
      }
      const Vertex_index target = arc.first_step.target;
      add({names[arc.lower_vertex()], upper, {surface.keys[target], surface.global_vertices[target]}}, is_open);
    }
  }

  // The parts of a block that are needed to put it on top of another one.
  const std::vector<Upper_end>& ends_of_contours() const { return ends_of_contours_; }
  const std::vector<Critical_arc>& open_arcs() const { return open_arcs_; }

  // Glues these parts of another block on top of this one. (The paper, Section 5.3.)
  void put_on_top(const std::vector<Upper_end>& ends_of_contours, std::vector<Critical_arc> open_arcs)
  {
    for(Upper_end& end : ends_of_contours_)
    {
      if(end.is_contour != 0)
        end = ends_of_contours[end.number];
    }
    open_arcs_.swap(open_arcs);
    for(Critical_arc& arc : open_arcs)
    {
      const Upper_end end = ends_of_contours[arc.upper];
      arc.upper = end.number;
      add(arc, end.is_contour != 0);
    }
  }

  // The arcs of which both ends are critical vertices.
  const std::vector<Critical_arc>& arcs() const { return arcs_; }

private:
  void add(const Critical_arc& arc, bool is_open) { (is_open ? open_arcs_ : arcs_).push_back(arc); }

  std::vector<Upper_end> ends_of_contours_; // of the lowest level
  std::vector<Critical_arc> open_arcs_;
  std::vector<Critical_arc> arcs_;
};

// Glues the slabs of the ranks, each rank's block to the one above it, in as many rounds as it takes to double one slab
// to all of them. Afterwards, each arc between critical vertices is in the block of the rank where its last two parts
// have met. Collective.
inline void glue_slabs(Exchange& exchange, std::size_t number_of_slabs, Slab_block& block)
{
  const std::size_t slab = exchange.rank();
  for(std::size_t size = 1; size < number_of_slabs; size *= 2)
  {
    const bool is_leader = slab % (2 * size) == 0 && slab + size < number_of_slabs;
    const bool is_on_top = slab % (2 * size) == size && slab < number_of_slabs;
    const int to = is_on_top ? static_cast<int>(slab - size) : no_rank;
    const int from = is_leader ? static_cast<int>(slab + size) : no_rank;
    const auto ends_of_contours = pass_array(exchange, block.ends_of_contours(), to, from);
    auto open_arcs = pass_array(exchange, block.open_arcs(), to, from);
    exchange.in_agreement([&] {
      if(is_leader)
        block.put_on_top(ends_of_contours, std::move(open_arcs));
    });
  }
}

// The critical vertices and the arcs between them, of all ranks, as rank 0 takes them where a whole surface has been
// before: a surface without triangles, of the critical vertices and the ends of the first steps from them, where each
// arc has one halfedge, its first step.
class Gathered_surface
{
public:
  // The critical vertices have to be in ascending order.
  Gathered_surface(const std::vector<Order_key>& critical_vertices, const std::vector<Critical_arc>& arcs)
  {
    const std::vector<Vertex_index> numbers = number_vertices(critical_vertices, arcs);
    const std::size_t size = critical_vertices.size();
    critical_vertices_.resize(size, {0, 0});
    for(const Swept_index i :
        critical_vertices_.indices()) // Their sectors stay on their ranks: they have made the arcs.
      critical_vertices_.set(i, numbers[i.number()], false, false, {0, 0});
    critical_vertices_.sort(Threads(), order());
    arcs_.reserve(arcs.size());
    for(const Critical_arc& arc : arcs)
    {
      const Swept_arc_index i = arcs_.end_key();
      arcs_.push_back(
        {Tree_node(arc.lower), Tree_node(arc.upper), {Halfedge_index(i.number()), numbers[size + i.number()]}});
    }
  }

  const Indexed_vector<Vertex_index, Long_index>& global_vertices() const { return global_vertices_; }
  const Vertex_keys& keys() const { return keys_; }
  Vertex_order order() const { return Vertex_order(keys_); }
  const Swept_vertices& critical_vertices() const { return critical_vertices_; }
  const Swept_arcs& arcs() const { return arcs_; }

  // The interface of a complex, as far as it is needed here.
  Vertex_index source(Halfedge_index first_step) const
  {
    return critical_vertices_.vertex(arc(first_step).lower_vertex());
  }
  Vertex_index target(Halfedge_index first_step) const { return arc(first_step).first_step.target; }

private:
  const Swept_arc& arc(Halfedge_index first_step) const { return arcs_[Swept_arc_index(first_step.number())]; }

  // Numbers the vertices in the order of their global indices, which break ties. Returns the numbers of the critical
  // vertices, and behind them those of the ends of first steps.
  std::vector<Vertex_index> number_vertices(const std::vector<Order_key>& critical_vertices,
                                            const std::vector<Critical_arc>& arcs)
  {
    std::vector<std::pair<Order_key, Index>> places;
    places.reserve(critical_vertices.size() + arcs.size());
    const auto add = [&](const Order_key& key) { places.emplace_back(key, static_cast<Index>(places.size())); };
    for(const Order_key& key : critical_vertices)
      add(key);
    for(const Critical_arc& arc : arcs)
      add(arc.first_target);
    checked_index(places.size());
    std::sort(places.begin(), places.end(), [](const auto& a, const auto& b) { return a.first.name < b.first.name; });
    std::vector<Vertex_index> numbers(places.size());
    for(const auto& [key, place] : places)
    {
      if(global_vertices_.empty() || global_vertices_.back() != key.name)
      {
        global_vertices_.push_back(key.name);
        keys_.push_back(key.key);
      }
      numbers[place] = global_vertices_.last_key();
    }
    return numbers;
  }

  Indexed_vector<Vertex_index, Long_index> global_vertices_; // ascending
  Vertex_keys keys_;
  Swept_vertices critical_vertices_;
  Swept_arcs arcs_;
};

// A segment of a chain that has been walked as far as a vertex, up to the level just below another one.
struct Climbing_segment
{
  Long_index vertex;
  Long_index vertex_before; // from which the first step has led there
  Order_key upper_vertex;
  Index arc;
  Index segment;
  Index goes_on; // whether the upper vertex is above the one that has been reached
};

// How many vertices a part of a segment has.
struct Part_of_segment
{
  Index arc;
  Index segment;
  Index size;
};

// The parts of chains on a rank: the steps that begin in its slab, as sequences of vertices.
template <class Complex>
class Chain_parts
{
public:
  Chain_parts(const Slab_surface& surface, const Complex& complex, const Vertex_order& order)
    : surface_(surface),
      complex_(complex),
      order_(order)
  {}

  // Walks segments that begin in the slab with the step that is known.
  void begin(const std::vector<Climbing_segment>& segments)
  {
    for(const Climbing_segment& segment : segments)
    {
      vertices_.push_back(segment.vertex_before);
      walk(segment);
    }
  }

  // Walks segments that have come from below.
  void go_on(const std::vector<Climbing_segment>& segments)
  {
    for(const Climbing_segment& segment : segments)
      walk(segment);
  }

  // The segments that go on above the slab; they are none then.
  std::vector<Climbing_segment> take_leaving() { return std::exchange(leaving_, {}); }

  const std::vector<Part_of_segment>& parts() const { return parts_; }
  const std::vector<Long_index>& vertices() const { return vertices_; } // of all parts

private:
  // A path that has entered an arc cannot leave it below the upper node, so comparisons tell the end. A part of one
  // vertex, where the segment only passes the slab, is none.
  void walk(Climbing_segment segment)
  {
    vertices_.push_back(segment.vertex);
    if(segment.goes_on != 0)
    {
      // Whether a vertex is below the upper one of the segment, which may be on another rank.
      const auto is_below = [&](Vertex_index v) {
        return order_.key(v, surface_.global_vertices[v]) < segment.upper_vertex;
      };
      const auto goes_on = [&](Vertex_index v) {
        return surface_.slabs_of_vertices[v] == surface_.inside() && is_below(v);
      };
      const auto add = [&](const Ascending_step& step) { vertices_.push_back(surface_.global_vertices[step.target]); };
      const Vertex_index end = climb(complex_, order_, find_vertex(segment.vertex), goes_on, add);
      segment.vertex = surface_.global_vertices[end];
      if(is_below(end))
        leaving_.push_back(segment);
    }
    const std::size_t size = vertices_.size() - end_of_parts_;
    if(size == 1)
      return vertices_.pop_back();
    parts_.push_back({segment.arc, segment.segment, checked_index(size)});
    end_of_parts_ = vertices_.size();
  }

  Vertex_index find_vertex(Long_index global) const
  {
    const auto& vertices = surface_.global_vertices;
    const auto place = std::lower_bound(vertices.begin(), vertices.end(), global);
    return Vertex_index(static_cast<std::size_t>(place - vertices.begin()));
  }

  const Slab_surface& surface_;
  const Complex& complex_;
  const Vertex_order& order_;
  std::vector<Climbing_segment> leaving_;
  std::vector<Part_of_segment> parts_;
  std::vector<Long_index> vertices_;
  std::size_t end_of_parts_ = 0; // among the vertices
};

// The segments of the chains, for the ranks where they begin. `begins_of_ranks` has the number of the first critical
// vertex of each rank, and the end. For rank 0.
inline Gathered_arrays<Climbing_segment> list_segments(const Gathered_surface& surface,
                                                       const Flat_graph& graph,
                                                       const std::vector<std::size_t>& begins_of_ranks)
{
  const auto order = surface.order();
  const auto& vertices = surface.global_vertices();
  const auto rank_of = [&](const Chain_segment& segment) {
    const Index lower = surface.arcs()[Swept_arc_index(segment.first_step.edge.number())].lower.number();
    const auto behind = std::upper_bound(begins_of_ranks.begin(), begins_of_ranks.end(), lower);
    return static_cast<std::size_t>(behind - begins_of_ranks.begin()) - 1;
  };
  Gathered_arrays<Climbing_segment> segments = {{}, std::vector<std::size_t>(begins_of_ranks.size(), 0)};
  for(const Chain_segment& segment : graph.segments)
    ++segments.begins[rank_of(segment) + 1];
  std::partial_sum(segments.begins.begin(), segments.begins.end(), segments.begins.begin());
  segments.elements.resize(segments.begins.back());
  std::vector<std::size_t> ends = segments.begins;
  for(const Arc_index arc : graph.arcs.keys())
    for(Index i = 0; i != graph.arcs[arc].number_of_segments; ++i)
    {
      const Chain_segment_index segment(graph.arcs[arc].first_segment.number() + i);
      const auto& [first_step, upper_vertex] = graph.segments[segment];
      const bool goes_on = order(first_step.target, upper_vertex);
      segments.elements[ends[rank_of(graph.segments[segment])]++] = {vertices[first_step.target],
                                                                     vertices[surface.source(first_step.edge)],
                                                                     order.key(upper_vertex, vertices[upper_vertex]),
                                                                     arc.number(),
                                                                     segment.number(),
                                                                     goes_on ? Index(1) : Index(0)};
    }
  return segments;
}

// The pairs of vertices of all chains, one behind the other as their segments are, from the parts that the ranks have
// walked, slab by slab. For rank 0.
inline std::vector<std::pair<std::size_t, std::size_t>> join_chain_parts(std::size_t number_of_segments,
                                                                         const std::vector<Part_of_segment>& parts,
                                                                         const std::vector<Long_index>& vertices,
                                                                         Flat_chains& chains)
{
  auto& begins = chains.begins_of_segments;
  begins.reset(number_of_segments + 1, 0);
  for(const Part_of_segment& part : parts)
    begins[Chain_segment_index(part.segment + 1)] += part.size - 1;
  std::partial_sum(begins.begin(), begins.end(), begins.begin());
  std::vector<std::pair<std::size_t, std::size_t>> halfedges(begins.back());
  Indexed_vector<Chain_segment_index, std::size_t> ends = begins;
  auto vertex = vertices.begin();
  for(const Part_of_segment& part : parts)
  {
    for(Index i = 1; i != part.size; ++i, ++vertex)
      halfedges[ends[Chain_segment_index(part.segment)]++] = {vertex[0], vertex[1]};
    ++vertex;
  }
  return halfedges;
}

// The graph by the vertices of rank 0, and those; on the other ranks, there is nothing in it.
struct Gathered_graph
{
  std::optional<Gathered_surface> surface;
  Flat_graph graph;
  std::vector<std::size_t> begins_of_ranks; // by rank: the number of its first critical vertex; and the end
};

// Glues the slabs, and gathers the graph at rank 0. Collective.
inline Gathered_graph glue_and_gather(Exchange& exchange,
                                      const Slab_surface& surface,
                                      const Swept_vertices& critical_vertices,
                                      Arcs_of_slab found,
                                      Ties ties,
                                      bool are_degree_two_nodes_kept)
{
  const std::size_t size = critical_vertices.size();
  const std::size_t end = boost::mpi::scan(exchange.communicator(), size, std::plus<std::size_t>());
  Slab_block block;
  std::vector<Order_key> places;
  exchange.in_agreement([&] {
    Indexed_vector<Swept_index, Index> names(size);
    Index name = checked_index(end) - static_cast<Index>(size);
    places.reserve(size);
    for(const Swept_index i : critical_vertices.ascending())
    {
      names[i] = name++;
      const Vertex_index vertex = critical_vertices.vertex(i);
      places.push_back({surface.keys[vertex], surface.global_vertices[vertex]});
    }
    block = Slab_block(found, surface, names);
    found = Arcs_of_slab();
  });
  glue_slabs(exchange, surface.number_of_slabs, block);

  const auto all_places = gather_arrays(exchange, places);
  const auto all_arcs = gather_arrays(exchange, block.arcs());
  Gathered_graph gathered;
  exchange.in_agreement([&] {
    if(exchange.rank() != 0)
      return;
    gathered.begins_of_ranks = all_places.begins;
    const auto& whole = gathered.surface.emplace(all_places.elements, all_arcs.elements);
    gathered.graph = reduce_arcs(Threads(), whole, whole.order(), whole.critical_vertices(), whole.arcs(), ties,
                                 are_degree_two_nodes_kept, false);
  });
  return gathered;
}

// Walks the chains slab by slab: each rank those in its slab, and hands them on upwards, until no rank has any left.
// Collective.
template <class ChainParts>
void walk_chains(Exchange& exchange, const Gathered_graph& gathered, ChainParts& parts)
{
  Gathered_arrays<Climbing_segment> all_segments;
  exchange.in_agreement([&] {
    if(exchange.rank() == 0)
      all_segments = list_segments(*gathered.surface, gathered.graph, gathered.begins_of_ranks);
  });
  std::vector<Climbing_segment> segments = scatter_arrays(exchange, all_segments);
  const int rank = exchange.communicator().rank();
  const int above = rank + 1 < exchange.communicator().size() ? rank + 1 : no_rank;
  const int below = rank == 0 ? no_rank : rank - 1;
  exchange.in_agreement([&] { parts.begin(segments); });
  while(true)
  {
    segments = parts.take_leaving();
    if(!exchange.is_on_any_rank(!segments.empty()))
      return;
    segments = pass_array(exchange, segments, above, below);
    exchange.in_agreement([&] { parts.go_on(segments); });
  }
}

// Writes the graph at rank 0, with chains of the parts that all ranks have walked, and clears it on the other ranks.
// Collective.
template <class ReebGraph>
void write_gathered_graph(Exchange& exchange,
                          const Gathered_graph& gathered,
                          const std::vector<Part_of_segment>& parts,
                          const std::vector<Long_index>& vertices,
                          ReebGraph& graph)
{
  const auto all_parts = gather_arrays(exchange, parts);
  const auto all_vertices = gather_arrays(exchange, vertices);
  exchange.in_agreement([&] {
    if(exchange.rank() != 0)
      return graph.clear();
    typedef std::vector<std::pair<std::size_t, std::size_t>> Vertex_pairs;
    Flat_chains chains;
    const auto pairs = std::make_shared<const Vertex_pairs>(
      join_chain_parts(gathered.graph.segments.size(), all_parts.elements, all_vertices.elements, chains));
    const Keyed_field<Value_of_node<ReebGraph>> field(gathered.surface->keys(), false);
    write_nodes_and_arcs(Threads(), gathered.surface->global_vertices(), field, gathered.graph, graph);
    write_chains(pairs, chains, gathered.graph, graph);
  });
}

} // namespace CGAL::Reeb_graph::internal

#endif // CGAL_REEB_GRAPH_DISTRIBUTED_INTERNAL_COMPUTE_GRAPH_OF_SLABS_H
