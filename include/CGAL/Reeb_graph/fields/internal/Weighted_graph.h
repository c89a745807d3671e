// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of the CGAL-style package Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_FIELDS_INTERNAL_WEIGHTED_GRAPH_H
#define CGAL_REEB_GRAPH_FIELDS_INTERNAL_WEIGHTED_GRAPH_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/fields/internal/Indexed_surface.h>
#include <CGAL/Reeb_graph/fields/internal/triangle_geometry.h>
#include <CGAL/Reeb_graph/internal/base/Index.h>
#include <CGAL/Reeb_graph/named_parameters.h>

#include <algorithm>
#include <cstddef>
#include <functional>
#include <limits>
#include <numeric>
#include <queue>
#include <utility>
#include <vector>

namespace CGAL::Reeb_graph::internal::scalar_fields {

// The vertices and edges of a surface, with a weight for each edge at each of its ends. The neighbors of a vertex are
// sorted.
class Weighted_graph
{
public:
  struct Neighbor
  {
    Position vertex;
    double weight;
  };
  struct Contribution
  {
    Position from, to;
    double weight;
  };

  // `visit_contributions(visit)` calls `visit(contribution)` for parts of the weights, in any order, the same each
  // time. They are added up.
  template <class VisitContributions>
  Weighted_graph(std::size_t number_of_vertices, const VisitContributions& visit_contributions)
    : first_(number_of_vertices + 1, 0)
  {
    visit_contributions([&](const Contribution& c) { ++first_[c.from + 1]; });
    std::partial_sum(first_.begin(), first_.end(), first_.begin());
    neighbors_.resize(first_.back());
    std::vector<std::size_t> next(first_.begin(), first_.end() - 1);
    visit_contributions([&](const Contribution& c) { neighbors_[next[c.from]++] = {c.to, c.weight}; });
    add_up();
  }

  Position number_of_vertices() const { return static_cast<Position>(first_.size() - 1); }

  Iterator_range<const Neighbor*> neighbors(Position v) const
  {
    return {neighbors_.data() + first_[v], neighbors_.data() + first_[v + 1]};
  }

  double weight(Position from, Position to) const
  {
    const auto range = neighbors(from);
    return std::lower_bound(range.begin(), range.end(), to, [](const Neighbor& n, Position v) { return n.vertex < v; })
      ->weight;
  }

  double sum_of_weights(Position v) const
  {
    double sum = 0;
    for(const Neighbor& n : neighbors(v))
      sum += n.weight;
    return sum;
  }

private:
  void add_up()
  {
    std::size_t end = 0, begin = 0;
    for(std::size_t v = 0; v + 1 != first_.size(); ++v)
    {
      const std::size_t old_begin = begin, old_end = first_[v + 1];
      std::sort(neighbors_.data() + old_begin, neighbors_.data() + old_end,
                [](const Neighbor& a, const Neighbor& b) { return a.vertex < b.vertex; });
      first_[v] = end;
      for(begin = old_begin; begin != old_end; ++begin)
        if(end != first_[v] && neighbors_[end - 1].vertex == neighbors_[begin].vertex)
          neighbors_[end - 1].weight += neighbors_[begin].weight;
        else
          neighbors_[end++] = neighbors_[begin];
    }
    first_.back() = end;
    neighbors_.resize(end);
    neighbors_.shrink_to_fit();
  }

  std::vector<std::size_t> first_;
  std::vector<Neighbor> neighbors_;
};

// The weights w_ij = (tan(theta / 2) + tan(phi / 2)) / |v_j - v_i|, with the angles at v_i on both sides of the edge.
inline Weighted_graph mean_value_graph(const Indexed_surface& surface)
{
  return Weighted_graph(surface.number_of_vertices(), [&](const auto& visit) {
    for(std::size_t t = 0; t != surface.triangles().size(); ++t)
    {
      const Triangle_geometry geometry = triangle_geometry(surface, t);
      const auto& v = surface.triangles()[t].vertices;
      for(int i = 0; i != 3; ++i)
      {
        const double half_tangent = geometry.half_tangent(i);
        const int next = (i + 1) % 3, previous = (i + 2) % 3;
        visit(Weighted_graph::Contribution{v[i], v[next], half_tangent / length(geometry.edges[i])});
        visit(Weighted_graph::Contribution{v[i], v[previous], half_tangent / length(geometry.edges[previous])});
      }
    }
  });
}

// The weights w_ij = (cot(alpha) + cot(beta)) / 2, with the angles that face the edge.
inline Weighted_graph cotangent_graph(const Indexed_surface& surface)
{
  return Weighted_graph(surface.number_of_vertices(), [&](const auto& visit) {
    for(std::size_t t = 0; t != surface.triangles().size(); ++t)
    {
      const Triangle_geometry geometry = triangle_geometry(surface, t);
      const auto& v = surface.triangles()[t].vertices;
      for(int i = 0; i != 3; ++i)
      {
        const double weight = geometry.cotangent(i) / 2;
        const int next = (i + 1) % 3, previous = (i + 2) % 3;
        visit(Weighted_graph::Contribution{v[next], v[previous], weight});
        visit(Weighted_graph::Contribution{v[previous], v[next], weight});
      }
    }
  });
}

// The edges of a complex, with the weight 1, for what needs neither faces nor points.
template <class Complex>
Weighted_graph edge_graph(const Complex& complex)
{
  return Weighted_graph(complex.number_of_vertices(), [&](const auto& visit) {
    for(const Edge_index e : Index_range<Edge_index>(complex.number_of_edges()))
    {
      if(!complex.is_on_triangle(e))
        continue;
      const Position u = complex.source(even_halfedge(e)).number(), v = complex.target(even_halfedge(e)).number();
      visit(Weighted_graph::Contribution{u, v, 1});
      visit(Weighted_graph::Contribution{v, u, 1});
    }
  });
}

// The weights w_ij = 1.
inline Weighted_graph uniform_graph(const Indexed_surface& surface)
{
  return Weighted_graph(surface.number_of_vertices(), [&](const auto& visit) {
    for(const Indexed_triangle& t : surface.triangles())
      for(int i = 0; i != 3; ++i)
      {
        const double weight = t.is_on_border[i] ? 1 : 0.5;
        const Position u = t.vertices[i], v = t.vertices[(i + 1) % 3];
        visit(Weighted_graph::Contribution{u, v, weight});
        visit(Weighted_graph::Contribution{v, u, weight});
      }
  });
}

inline Weighted_graph laplacian_graph(const Indexed_surface& surface, Laplacian_weights weights)
{
  switch(weights)
  {
  case Laplacian_weights::COTANGENT: return cotangent_graph(surface);
  case Laplacian_weights::UNIFORM: return uniform_graph(surface);
  default: return mean_value_graph(surface);
  }
}

// The vertices in the order of a breadth-first search, which keeps neighbors close to each other in memory.
inline std::vector<Position> breadth_first_order(const Weighted_graph& graph)
{
  std::vector<Position> order;
  order.reserve(graph.number_of_vertices());
  std::vector<bool> is_reached(graph.number_of_vertices(), false);
  const auto reach = [&](Position v) {
    if(!is_reached[v])
      order.push_back(v);
    is_reached[v] = true;
  };
  Position next = 0;
  for(Position first = 0; first != graph.number_of_vertices(); ++first)
    for(reach(first); next != order.size(); ++next)
      for(const auto& n : graph.neighbors(order[next]))
        reach(n.vertex);
  return order;
}

// Numbers the connected components, in the order of their first vertices.
inline std::vector<Position> label_components(const Weighted_graph& graph)
{
  std::vector<Position> labels(graph.number_of_vertices(), no_position), stack;
  Position number_of_components = 0;
  for(Position first = 0; first != graph.number_of_vertices(); ++first)
  {
    if(labels[first] != no_position)
      continue;
    labels[first] = number_of_components;
    for(stack.push_back(first); !stack.empty();)
    {
      const Position v = stack.back();
      stack.pop_back();
      for(const auto& n : graph.neighbors(v))
        if(labels[n.vertex] == no_position)
        {
          labels[n.vertex] = number_of_components;
          stack.push_back(n.vertex);
        }
    }
    ++number_of_components;
  }
  return labels;
}

// The vertex of least value of each component, the first one if there are several.
inline std::vector<Position> lowest_vertices_of_components(const Weighted_graph& graph,
                                                           const std::vector<double>& values)
{
  const std::vector<Position> labels = label_components(graph);
  std::vector<Position> lowest_vertices;
  for(Position v = 0; v != graph.number_of_vertices(); ++v)
    if(labels[v] == lowest_vertices.size())
      lowest_vertices.push_back(v);
    else if(values[v] < values[lowest_vertices[labels[v]]])
      lowest_vertices[labels[v]] = v;
  return lowest_vertices;
}

// Finds the vertex of a component that is farthest from another one along the edges, the first one if there are
// several.
class Farthest_vertex_search
{
public:
  Farthest_vertex_search(const Indexed_surface& surface, const Weighted_graph& graph)
    : surface_(surface),
      graph_(graph),
      distances_(graph.number_of_vertices(), std::numeric_limits<double>::infinity())
  {}

  Position operator()(Position source)
  {
    Entry farthest(0, source);
    reach(farthest);
    while(!queue_.empty())
    {
      const Entry entry = queue_.top();
      queue_.pop();
      if(entry.first > distances_[entry.second])
        continue;
      if(entry.first > farthest.first)
        farthest = entry;
      for(const auto& n : graph_.neighbors(entry.second))
        reach({entry.first + length(surface_.point(n.vertex) - surface_.point(entry.second)), n.vertex});
    }
    for(const Position v : reached_)
      distances_[v] = std::numeric_limits<double>::infinity();
    reached_.clear();
    return farthest.second;
  }

private:
  typedef std::pair<double, Position> Entry;

  void reach(const Entry& entry)
  {
    if(!(entry.first < distances_[entry.second]))
      return;
    distances_[entry.second] = entry.first;
    reached_.push_back(entry.second);
    queue_.push(entry);
  }

  const Indexed_surface& surface_;
  const Weighted_graph& graph_;
  std::vector<double> distances_;
  std::vector<Position> reached_;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<Entry>> queue_;
};

// Two vertices of each component: the one farthest from its first vertex, and the one farthest from that. They are the
// same only in a component of a single vertex.
inline std::vector<std::pair<Position, Position>> far_apart_vertices(const Indexed_surface& surface,
                                                                     const Weighted_graph& graph)
{
  const std::vector<Position> labels = label_components(graph);
  Farthest_vertex_search farthest_vertex(surface, graph);
  std::vector<std::pair<Position, Position>> pairs;
  for(Position v = 0; v != graph.number_of_vertices(); ++v)
    if(labels[v] == pairs.size())
    {
      const Position lowest = farthest_vertex(v);
      const Position highest = farthest_vertex(lowest);
      const auto neighbors = graph.neighbors(lowest);
      const bool do_all_points_coincide = lowest == highest && !neighbors.empty();
      pairs.emplace_back(lowest, do_all_points_coincide ? neighbors.begin()->vertex : highest);
    }
  return pairs;
}

} // namespace CGAL::Reeb_graph::internal::scalar_fields

#endif // CGAL_REEB_GRAPH_FIELDS_INTERNAL_WEIGHTED_GRAPH_H
