// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_INTERNAL_COMPLEX_WEIGHTED_GRAPH_H
#define CGAL_REEB_GRAPH_INTERNAL_COMPLEX_WEIGHTED_GRAPH_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/internal/base/Index.h>

#include <CGAL/Iterator_range.h>

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <vector>

namespace CGAL::Reeb_graph::internal {

// The vertices and edges of a surface, numbered from 0 on (for fields by position in vertices(mesh)), with a weight for each
// edge at each of its ends, in compressed rows. The neighbors
// of a vertex are sorted.
class Weighted_graph
{
public:
  struct Neighbor
  {
    Index vertex;
    double weight;
  };
  struct Contribution
  {
    Index from, to;
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

  Index number_of_vertices() const { return static_cast<Index>(first_.size() - 1); }

  Iterator_range<const Neighbor*> neighbors(Index v) const
  {
    return {neighbors_.data() + first_[v], neighbors_.data() + first_[v + 1]};
  }

  double weight(Index from, Index to) const
  {
    const auto range = neighbors(from);
    return std::lower_bound(range.begin(), range.end(), to, [](const Neighbor& n, Index v) { return n.vertex < v; })
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
      const Index u = complex.source(even_halfedge(e)).number(), v = complex.target(even_halfedge(e)).number();
      visit(Weighted_graph::Contribution{u, v, 1});
      visit(Weighted_graph::Contribution{v, u, 1});
    }
  });
}

// The vertices in the order of a breadth-first search, which keeps neighbors close to each other in memory, and by
// vertex the number of its connected component, in the order of their first vertices.
struct Breadth_first_search
{
  std::vector<Index> order;
  std::vector<Index> components;

  explicit Breadth_first_search(const Weighted_graph& graph) : components(graph.number_of_vertices(), no_index)
  {
    order.reserve(graph.number_of_vertices());
    Index component = 0;
    std::size_t next = 0;
    const auto reach = [&](Index v) {
      if(components[v] != no_index)
        return;
      order.push_back(v);
      components[v] = component;
    };
    for(Index first = 0; first != graph.number_of_vertices(); ++first)
    {
      for(reach(first); next != order.size(); ++next)
        for(const auto& n : graph.neighbors(order[next]))
          reach(n.vertex);
      component = components[order.back()] + 1;
    }
  }
};

inline std::vector<Index> label_components(const Weighted_graph& graph)
{
  return Breadth_first_search(graph).components;
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
  std::vector<Index> operator()(const std::vector<Index>& part, const IsInPart& is_in_part, const IsSource& is_source)
  {
    const auto is_sink = [&](const auto& n) { return !is_in_part(n.vertex) && !is_source(n.vertex); };
    const Index root = *std::find_if(part.begin(), part.end(), [&](Index v) {
      const auto neighbors = graph_.neighbors(v);
      return std::any_of(neighbors.begin(), neighbors.end(), is_sink);
    });
    for(const Index v : part) // It may have been in another part before.
      records_[v].preorder = no_index;
    search(root, is_in_part, is_source);
    return list(root);
  }

private:
  // The number of a vertex in preorder; those of the source and the sink are 0 and 1.
  typedef Index Preorder;
  static constexpr Preorder source = 0, sink = 1;

  struct Record
  {
    Preorder preorder = no_index;
    Preorder low; // lowest number that is joined to a vertex of the subtree, or in it
    Preorder parent;
    Index next_edge;
  };

  template <class IsInPart, class IsSource>
  void search(Index root, const IsInPart& is_in_part, const IsSource& is_source)
  {
    preordered_ = {no_index, no_index};
    std::vector<Index> path;
    const auto enter = [&](Index v, Preorder parent) {
      const auto preorder = static_cast<Preorder>(preordered_.size());
      records_[v] = {preorder, preorder, parent, 0};
      preordered_.push_back(v);
      path.push_back(v);
    };
    enter(root, sink);
    while(!path.empty())
    {
      const Index v = path.back();
      Record& record = records_[v];
      const auto neighbors = graph_.neighbors(v);
      if(record.next_edge == neighbors.size())
      {
        path.pop_back();
        if(!path.empty())
          records_[path.back()].low = (std::min)(records_[path.back()].low, record.low);
        continue;
      }
      const Index u = (neighbors.begin() + record.next_edge++)->vertex;
      if(!is_in_part(u))
        record.low = (std::min)(record.low, is_source(u) ? source : sink);
      else if(records_[u].preorder == no_index)
        enter(u, record.preorder);
      else
        record.low = (std::min)(record.low, records_[u].preorder);
    }
  }

  // Inserts the vertices in preorder into a list from the source to the sink, before or behind their parents.
  std::vector<Index> list(Index root)
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
    std::vector<Index> result;
    result.reserve(size - 2);
    for(Preorder i = next[source]; i != sink; i = next[i])
      result.push_back(preordered_[i]);
    return result;
  }

  const Weighted_graph& graph_;
  std::vector<Record> records_;
  std::vector<Index> preordered_;
};

} // namespace CGAL::Reeb_graph::internal

#endif // CGAL_REEB_GRAPH_INTERNAL_COMPLEX_WEIGHTED_GRAPH_H
