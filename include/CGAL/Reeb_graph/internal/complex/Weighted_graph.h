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

// A vertex of a graph, one of the numbers from 0 on: for fields, its position in vertices(mesh).
typedef Number Dense_vertex;
inline constexpr Dense_vertex no_vertex = no_index;

// The vertices and edges of a surface, with a weight for each edge at each of its ends, in compressed rows. The neighbors
// of a vertex are sorted.
class Weighted_graph
{
public:
  struct Neighbor
  {
    Dense_vertex vertex;
    double weight;
  };
  struct Contribution
  {
    Dense_vertex from, to;
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

  Dense_vertex number_of_vertices() const { return static_cast<Dense_vertex>(first_.size() - 1); }

  Iterator_range<const Neighbor*> neighbors(Dense_vertex v) const
  {
    return {neighbors_.data() + first_[v], neighbors_.data() + first_[v + 1]};
  }

  double weight(Dense_vertex from, Dense_vertex to) const
  {
    const auto range = neighbors(from);
    return std::lower_bound(range.begin(), range.end(), to,
                            [](const Neighbor& n, Dense_vertex v) { return n.vertex < v; })
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
      const Dense_vertex u = complex.source(even_halfedge(e)).number(), v = complex.target(even_halfedge(e)).number();
      visit(Weighted_graph::Contribution{u, v, 1});
      visit(Weighted_graph::Contribution{v, u, 1});
    }
  });
}

} // namespace CGAL::Reeb_graph::internal

#endif // CGAL_REEB_GRAPH_INTERNAL_COMPLEX_WEIGHTED_GRAPH_H
