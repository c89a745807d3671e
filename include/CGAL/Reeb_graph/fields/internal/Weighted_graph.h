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

#include <CGAL/Reeb_graph/fields/exceptions.h>
#include <CGAL/Reeb_graph/fields/internal/Indexed_surface.h>
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

// The weights of the Laplacian.
inline Weighted_graph laplacian_graph(const Indexed_surface& surface, Laplacian_weights weights)
{
  return Weighted_graph(surface.number_of_vertices(), [&](const auto& visit) {
    const auto visit_both = [&](Position u, Position v, double weight) {
      visit(Weighted_graph::Contribution{u, v, weight});
      visit(Weighted_graph::Contribution{v, u, weight});
    };
    for(std::size_t t = 0; t != surface.triangles().size(); ++t)
    {
      const auto& [v, is_on_border] = surface.triangles()[t];
      const bool has_geometry = weights != Laplacian_weights::UNIFORM;
      const Triangle_geometry geometry = has_geometry ? triangle_geometry(surface, t) : Triangle_geometry();
      for(int i = 0; i != 3; ++i)
      {
        const int next = (i + 1) % 3, previous = (i + 2) % 3;
        if(weights == Laplacian_weights::UNIFORM) // w_ij = 1
          visit_both(v[i], v[next], is_on_border[i] ? 1 : 0.5);
        else if(weights == Laplacian_weights::COTANGENT) // the mean of the cotangents of the angles that face the edge
          visit_both(v[next], v[previous], geometry.cotangent(i) / 2);
        else // the tangents of half the angles at v_i on both sides of the edge, divided by its length
        {
          const double half_tangent = geometry.half_tangent(i);
          visit(Weighted_graph::Contribution{v[i], v[next], half_tangent / length(geometry.edges[i])});
          visit(Weighted_graph::Contribution{v[i], v[previous], half_tangent / length(geometry.edges[previous])});
        }
      }
    }
  });
}

// Calls solve(graph, fraction), with the fraction of the work that is done when its equations have been set up. If they
// have no finite solution, and the edges have their own lengths, it makes them longer, and calls it once more.
template <class Solve>
auto solve_or_lengthen_edges(Indexed_surface& surface,
                             const Weighted_graph& graph,
                             Laplacian_weights weights,
                             Field_report& report,
                             const Solve& solve)
{
  if(weights == Laplacian_weights::UNIFORM || surface.added_length() > 0)
    return solve(graph, 0.2);
  try
  {
    return solve(graph, 0.2);
  }
  catch(const Linear_solver_error&)
  {}
  catch(const Non_finite_scalar_error&)
  {}
  lengthen_edges(surface, report);
  return solve(laplacian_graph(surface, weights), 0.6);
}

// The vertices in the order of a breadth-first search, which keeps neighbors close to each other in memory, and by
// vertex the number of its connected component, in the order of their first vertices.
struct Breadth_first_search
{
  std::vector<Position> order, components;

  explicit Breadth_first_search(const Weighted_graph& graph) : components(graph.number_of_vertices(), no_position)
  {
    order.reserve(graph.number_of_vertices());
    Position component = 0, next = 0;
    const auto reach = [&](Position v) {
      if(components[v] != no_position)
        return;
      order.push_back(v);
      components[v] = component;
    };
    for(Position first = 0; first != graph.number_of_vertices(); ++first)
    {
      for(reach(first); next != order.size(); ++next)
        for(const auto& n : graph.neighbors(order[next]))
          reach(n.vertex);
      component = components[order.back()] + 1;
    }
  }
};

inline std::vector<Position> label_components(const Weighted_graph& graph)
{
  return Breadth_first_search(graph).components;
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

// Two vertices of each component: the one farthest from its first vertex along the edges, and the one farthest from
// that; of several the first one. They are the same only in a component of a single vertex.
inline std::vector<std::pair<Position, Position>> far_apart_vertices(const Indexed_surface& surface,
                                                                     const Weighted_graph& graph)
{
  typedef std::pair<double, Position> Entry;
  constexpr double infinity = std::numeric_limits<double>::infinity();
  std::vector<double> distances(graph.number_of_vertices(), infinity); // between two searches
  std::priority_queue<Entry, std::vector<Entry>, std::greater<Entry>> queue;
  const auto farthest_from = [&](Position source) {
    std::vector<Position> reached;
    const auto reach = [&](double distance, Position v) {
      if(!(distance < distances[v]))
        return;
      distances[v] = distance;
      reached.push_back(v);
      queue.emplace(distance, v);
    };
    Entry farthest(0, source);
    for(reach(0, source); !queue.empty();)
    {
      const Entry entry = queue.top();
      queue.pop();
      if(entry.first > distances[entry.second])
        continue;
      if(entry.first > farthest.first)
        farthest = entry;
      for(const auto& n : graph.neighbors(entry.second))
        reach(entry.first + length(surface.point(n.vertex) - surface.point(entry.second)), n.vertex);
    }
    for(const Position v : reached)
      distances[v] = infinity;
    return farthest.second;
  };
  const std::vector<Position> labels = label_components(graph);
  std::vector<std::pair<Position, Position>> pairs;
  for(Position v = 0; v != graph.number_of_vertices(); ++v)
    if(labels[v] == pairs.size())
    {
      const Position lowest = farthest_from(v), highest = farthest_from(lowest);
      const auto neighbors = graph.neighbors(lowest);
      const bool do_all_points_coincide = lowest == highest && !neighbors.empty();
      pairs.emplace_back(lowest, do_all_points_coincide ? neighbors.begin()->vertex : highest);
    }
  return pairs;
}

// Orders the vertices of a connected part of a graph so that each has a lower and a higher neighbor, where the
// neighbors outside of the part count as one vertex below it, the source, or as one above it, the sink. That is the
// st-numbering of R. E. Tarjan, Two Streamlined Depth-First Search Algorithms, 1986, for a graph that stays connected
// without any one vertex if source and sink are joined. The time is linear in the size of the part.
class St_numbering
{
public:
  explicit St_numbering(const Weighted_graph& graph) : graph_(graph), records_(graph.number_of_vertices()) {}

  // The order of `part`. `is_in_part` tells its vertices from the other ones, and `is_source` tells which of these
  // belong to the source.
  template <class IsInPart, class IsSource>
  std::vector<Position> operator()(const std::vector<Position>& part,
                                   const IsInPart& is_in_part,
                                   const IsSource& is_source)
  {
    const auto is_sink = [&](const auto& n) { return !is_in_part(n.vertex) && !is_source(n.vertex); };
    const Position root = *std::find_if(part.begin(), part.end(), [&](Position v) {
      const auto neighbors = graph_.neighbors(v);
      return std::any_of(neighbors.begin(), neighbors.end(), is_sink);
    });
    for(const Position v : part) // It may have been in another part before.
      records_[v].preorder = no_position;
    search(root, is_in_part, is_source);
    return list(root);
  }

private:
  // The number of a vertex in preorder; those of the source and the sink are 0 and 1.
  typedef Position Preorder;
  static constexpr Preorder source = 0, sink = 1;

  struct Record
  {
    Preorder preorder = no_position;
    Preorder low; // lowest number that is joined to a vertex of the subtree, or in it
    Preorder parent;
    Position next_edge;
  };

  template <class IsInPart, class IsSource>
  void search(Position root, const IsInPart& is_in_part, const IsSource& is_source)
  {
    preordered_ = {no_position, no_position};
    std::vector<Position> path;
    const auto enter = [&](Position v, Preorder parent) {
      const auto preorder = static_cast<Preorder>(preordered_.size());
      records_[v] = {preorder, preorder, parent, 0};
      preordered_.push_back(v);
      path.push_back(v);
    };
    enter(root, sink);
    while(!path.empty())
    {
      const Position v = path.back();
      Record& record = records_[v];
      const auto neighbors = graph_.neighbors(v);
      if(record.next_edge == neighbors.size())
      {
        path.pop_back();
        if(!path.empty())
          records_[path.back()].low = (std::min)(records_[path.back()].low, record.low);
        continue;
      }
      const Position u = (neighbors.begin() + record.next_edge++)->vertex;
      if(!is_in_part(u))
        record.low = (std::min)(record.low, is_source(u) ? source : sink);
      else if(records_[u].preorder == no_position)
        enter(u, record.preorder);
      else
        record.low = (std::min)(record.low, records_[u].preorder);
    }
  }

  // Inserts the vertices in preorder into a list from the source to the sink, before or behind their parents.
  std::vector<Position> list(Position root)
  {
    const std::size_t size = preordered_.size();
    std::vector<Preorder> next(size), previous(size);
    std::vector<bool> is_plus(size, false);
    next[source] = sink;
    previous[sink] = source;
    for(Preorder i = records_[root].preorder; i != size; ++i)
    {
      const Record& record = records_[preordered_[i]];
      const bool is_behind_parent = is_plus[record.low];
      const Preorder before = is_behind_parent ? record.parent : previous[record.parent];
      const Preorder behind = is_behind_parent ? next[record.parent] : record.parent;
      is_plus[record.parent] = !is_behind_parent;
      next[before] = i;
      previous[i] = before;
      next[i] = behind;
      previous[behind] = i;
    }
    std::vector<Position> result;
    result.reserve(size - 2);
    for(Preorder i = next[source]; i != sink; i = next[i])
      result.push_back(preordered_[i]);
    return result;
  }

  const Weighted_graph& graph_;
  std::vector<Record> records_;
  std::vector<Position> preordered_;
};

} // namespace CGAL::Reeb_graph::internal::scalar_fields

#endif // CGAL_REEB_GRAPH_FIELDS_INTERNAL_WEIGHTED_GRAPH_H
