// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_INTERNAL_COMPLEX_BREADTH_FIRST_SEARCH_H
#define CGAL_REEB_GRAPH_INTERNAL_COMPLEX_BREADTH_FIRST_SEARCH_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/internal/base/Index.h>
#include <CGAL/Reeb_graph/internal/complex/Weighted_graph.h>

#include <cstddef>
#include <vector>

namespace CGAL::Reeb_graph::internal {

// The vertices in the order of a breadth-first search, which keeps neighbors close to each other in memory, and by
// vertex the number of its connected component, in the order of their first vertices.
struct Breadth_first_search
{
  std::vector<Dense_vertex> order;
  std::vector<Index> components;

  explicit Breadth_first_search(const Weighted_graph& graph) : components(graph.number_of_vertices(), no_index)
  {
    order.reserve(graph.number_of_vertices());
    Index component = 0;
    std::size_t next = 0;
    const auto reach = [&](Dense_vertex v) {
      if(components[v] != no_index)
        return;
      order.push_back(v);
      components[v] = component;
    };
    for(Dense_vertex first = 0; first != graph.number_of_vertices(); ++first)
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

} // namespace CGAL::Reeb_graph::internal

#endif // CGAL_REEB_GRAPH_INTERNAL_COMPLEX_BREADTH_FIRST_SEARCH_H
