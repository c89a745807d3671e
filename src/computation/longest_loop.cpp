// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#include "computation/longest_loop.h"

#include "computation/simplification.h"

#include <CGAL/Reeb_graph/internal/base/arrays.h>
#include <CGAL/Reeb_graph/internal/base/interpolation.h>
#include <CGAL/Reeb_graph/internal/base/lengths.h>
#include <CGAL/Reeb_graph/simplification/persistence_pairs.h>
#include <CGAL/boost/graph/iterator.h>

#include <boost/graph/compressed_sparse_row_graph.hpp>
#include <boost/graph/dijkstra_shortest_paths.hpp>
#include <boost/property_map/property_map.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <map>
#include <set>
#include <stdexcept>
#include <utility>
#include <vector>

namespace reeb_graph_program {
namespace {
Persistence_pair most_persistent_loop(const Graph& graph)
{
  std::vector<Persistence_pair> pairs = find_persistence_pairs(graph);
  const auto is_no_loop = [](const Persistence_pair& pair) {
    return pair.kind != CGAL::Reeb_graph::Persistence_pair_kind::LOOP;
  };
  pairs.erase(std::remove_if(pairs.begin(), pairs.end(), is_no_loop), pairs.end());
  if(pairs.empty())
    throw std::runtime_error("the graph has no loop");
  return *std::max_element(pairs.begin(), pairs.end(), [&](const auto& a, const auto& b) {
    return CGAL::Reeb_graph::persistence(graph, a) < CGAL::Reeb_graph::persistence(graph, b);
  });
}

// The arcs by which one side of a loop comes to its upper node: a side is a component of what is strictly between both
// nodes, and reaches the lower one.
std::set<std::size_t> arcs_of_side(const Graph& graph, const Persistence_pair& pair)
{
  CGAL::Reeb_graph::internal::Disjoint_sets<std::size_t> sides(num_vertices(graph));
  std::set<std::size_t> ends_below; // nodes
  for(const auto arc : CGAL::make_range(edges(graph)))
  {
    const std::size_t lower = source(arc, graph), upper = target(arc, graph);
    if(lower == pair.lower_node && upper == pair.upper_node)
      return {get(boost::edge_index, graph, arc)};
    if(lower == pair.lower_node && upper < pair.upper_node)
      ends_below.insert(upper);
    else if(lower > pair.lower_node && upper < pair.upper_node)
      sides.unite(lower, upper);
  }
  std::set<std::size_t> sides_below, arcs;
  for(const std::size_t node : ends_below)
    sides_below.insert(sides.find(node));
  std::size_t side = num_vertices(graph);
  for(const auto arc : CGAL::make_range(in_edges(pair.upper_node, graph)))
  {
    const std::size_t found = sides.find(source(arc, graph));
    if(sides_below.count(found) == 0 || (!arcs.empty() && found != side))
      continue;
    side = found;
    arcs.insert(get(boost::edge_index, graph, arc));
  }
  return arcs;
}

// The edges that the levels of these arcs just below the node cross, each from its lower to its upper end.
std::set<std::array<std::size_t, 2>> edges_below(Mesh_graph& graph, std::size_t node, const std::set<std::size_t>& arcs)
{
  std::set<std::array<std::size_t, 2>> edges;
  for(const Contour& contour : graph.critical_set(node).lower_contours)
    if(arcs.count(contour.arc) != 0)
      edges.insert(contour.edges.begin(), contour.edges.end());
  return edges;
}

// The part of a mesh between the levels of two nodes, as a graph: vertices, points where edges cross these levels, and steps
// from one to the next along edges, and along the levels in triangles. Any closed curve can be moved onto such steps.
class Slab
{
public:
  Slab(Mesh_graph& graph, const Persistence_pair& pair, const std::set<std::array<std::size_t, 2>>& gates)
    : mesh_(graph.mesh()),
      values_(graph.scalar_map()),
      levels_({graph.given()[pair.lower_node].value, graph.given()[pair.upper_node].value}),
      heights_(find_heights(graph, pair))
  {
    visit_edges(mesh_, [&](std::size_t u, std::size_t v) { add_edge(u, v, gates); });
    const auto add_triangles_of = [&](const auto& cells) {
      for(const auto& cell : cells)
        for(std::size_t i = 2; i < cell.size(); ++i)
          for(std::size_t j = 1; j < i; ++j)
            for(std::size_t k = 0; k < j; ++k)
              add_levels({cell[i], cell[j], cell[k]});
    };
    for(const Surface::Face_index f : mesh_.surface.faces())
    {
      const Surface::Halfedge_index h = mesh_.surface.halfedge(f);
      add_levels({mesh_.surface.source(h), mesh_.surface.target(h), mesh_.surface.target(mesh_.surface.next(h))});
    }
    if(mesh_.complex)
    {
      add_triangles_of(mesh_.complex->triangles);
      add_triangles_of(mesh_.complex->tetrahedra);
    }
  }

  // A shortest closed walk from a vertex that goes through the gates downwards once more than upwards. It is a path
  // between two copies of the vertex: gates lead from one copy of the slab into another one.
  Polyline shortest_walk(std::size_t from) const
  {
    const std::size_t number = heights_.size() + points_.size();
    const Walks walks(boost::edges_are_unsorted_multi_pass, ends_.begin(), ends_.end(), steps_.begin(), 2 * number);
    std::vector<std::size_t> before(2 * number);
    boost::dijkstra_shortest_paths(
      walks, 2 * from,
      boost::weight_map(get(&Step::length, walks))
        .predecessor_map(boost::make_iterator_property_map(before.begin(), get(boost::vertex_index, walks))));
    Polyline walk;
    for(std::size_t i = 2 * from + 1; i != before[i]; i = before[i])
      walk.push_back(point(i / 2));
    walk.push_back(point(from));
    return walk;
  }

private:
  enum Height : signed char
  {
    BELOW,
    BETWEEN,
    ABOVE
  };
  struct Step
  {
    double length = 0;
  };
  typedef boost::compressed_sparse_row_graph<boost::directedS, boost::no_property, Step> Walks;

  // Where vertices are. Ties are broken as the nodes are ordered and, within arcs, by the numbers of vertices.
  static std::vector<Height> find_heights(Mesh_graph& graph, const Persistence_pair& pair)
  {
    const Graph& nodes = graph.given();
    const Scalar_map values = graph.scalar_map();
    const std::size_t number_of_nodes = num_vertices(nodes);
    std::vector<std::array<std::size_t, 2>> ends; // of arcs
    for(const auto arc : CGAL::make_range(edges(nodes)))
      ends.push_back({source(arc, nodes), target(arc, nodes)});
    const auto is_above = [&](std::size_t v, std::size_t place, std::size_t node) {
      if(place < number_of_nodes)
        return place > node;
      const auto [lower, upper] = ends[place - number_of_nodes];
      const auto key = [&](Surface::Vertex_index w) { return std::pair(values[w], w); };
      return lower >= node || (upper > node && key(nodes[node].vertex) < key(vertex(v)));
    };
    std::vector<Height> heights;
    for(const std::size_t place : graph.given_places())
    {
      const std::size_t v = heights.size();
      heights.push_back(is_above(v, place, pair.upper_node)                               ? ABOVE
                        : place == pair.lower_node || is_above(v, place, pair.lower_node) ? BETWEEN
                                                                                          : BELOW);
    }
    return heights;
  }

  static Surface::Vertex_index vertex(std::size_t v)
  {
    return Surface::Vertex_index(static_cast<Surface::size_type>(v));
  }

  Point point(std::size_t i) const
  {
    return i < heights_.size() ? mesh_.surface.point(vertex(i)) : points_[i - heights_.size()];
  }

  // The number of the point of an edge on a level.
  std::size_t crossing(std::size_t lower, std::size_t upper, std::size_t level)
  {
    const auto [found, is_new] = crossings_.try_emplace({lower, upper, level}, heights_.size() + points_.size());
    if(is_new)
      points_.push_back(CGAL::Reeb_graph::internal::point_between(
        point(lower), point(upper),
        CGAL::Reeb_graph::internal::crossing_fraction(values_[vertex(lower)], values_[vertex(upper)], levels_[level])));
    return found->second;
  }

  // Adds what an edge has in the slab.
  void add_edge(std::size_t u, std::size_t v, const std::set<std::array<std::size_t, 2>>& gates)
  {
    if(heights_[u] == heights_[v] && heights_[u] != BETWEEN)
      return;
    if(heights_[u] > heights_[v] || gates.count({v, u}) != 0)
      std::swap(u, v);
    add_step(heights_[v] == ABOVE ? crossing(u, v, 1) : v, heights_[u] == BELOW ? crossing(u, v, 0) : u,
             gates.count({u, v}) != 0);
  }

  // Adds what a triangle has of both levels.
  void add_levels(const std::array<std::size_t, 3>& triangle)
  {
    for(const std::size_t level : {0, 1})
    {
      const auto is_upper = [&](std::size_t v) { return level == 0 ? heights_[v] != BELOW : heights_[v] == ABOVE; };
      std::vector<std::size_t> crossings;
      for(const std::size_t u : triangle)
        for(const std::size_t v : triangle)
          if(!is_upper(u) && is_upper(v))
            crossings.push_back(crossing(u, v, level));
      if(!crossings.empty())
        add_step(crossings.front(), crossings.back(), false);
    }
  }

  // Adds the step in both directions, a gate if it is one downwards.
  void add_step(std::size_t i, std::size_t j, bool is_gate)
  {
    const Step step = {CGAL::Reeb_graph::internal::distance_between(point(i), point(j))};
    for(std::size_t copy = 0; copy != (is_gate ? 1 : 2); ++copy)
    {
      const std::size_t from = 2 * i + copy, to = 2 * j + copy + (is_gate ? 1 : 0);
      ends_.insert(ends_.end(), {{from, to}, {to, from}});
      steps_.insert(steps_.end(), 2, step);
    }
  }

  const Mesh& mesh_;
  const Scalar_map values_;
  const std::array<double, 2> levels_;
  const std::vector<Height> heights_;
  std::map<std::array<std::size_t, 3>, std::size_t> crossings_; // their numbers, behind those of the vertices
  std::vector<Point> points_;                                   // by the numbers of crossings
  std::vector<std::pair<std::size_t, std::size_t>> ends_;       // of steps, each vertex and crossing in two copies
  std::vector<Step> steps_;
};

} // namespace

Loops_of_surface find_longest_loop(Mesh_graph& graph)
{
  most_persistent_loop(graph.result()); // It is that of all loops, as those that are left persist the longest.
  const auto whole = graph.simplify({}, 0);
  const Persistence_pair pair = most_persistent_loop(whole->given());
  const Slab slab(*whole, pair, edges_below(*whole, pair.upper_node, arcs_of_side(whole->given(), pair)));
  const Polyline curve = slab.shortest_walk(whole->given()[pair.upper_node].vertex);
  Loop_row row;
  row.kind = "loop";
  for(std::size_t i = 1; i < curve.size(); ++i)
    row.length += CGAL::Reeb_graph::internal::distance_between(curve[i], curve[i - 1]);
  row.persistence = CGAL::Reeb_graph::persistence(whole->given(), pair);
  row.place = place_of(curve);
  return {{row}, {curve}};
}

} // namespace reeb_graph_program
