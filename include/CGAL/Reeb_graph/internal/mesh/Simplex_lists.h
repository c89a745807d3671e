// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of the CGAL-style package Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_INTERNAL_MESH_SIMPLEX_LISTS_H
#define CGAL_REEB_GRAPH_INTERNAL_MESH_SIMPLEX_LISTS_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/internal/base/Buckets.h>
#include <CGAL/Reeb_graph/internal/base/Index.h>
#include <CGAL/Reeb_graph/internal/base/Indexed_vector.h>
#include <CGAL/Reeb_graph/internal/mesh/mesh_indices.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Reeb_graph {
namespace internal {

// The triangles of a complex, each once and with ascending vertices, in lexicographic order.
struct Triangle_list
{
  Indexed_vector<Triangle_index, std::array<Vertex_index, 3>> vertices;
  Indexed_vector<Vertex_index, Number> first_triangles; // by least vertex; and the end

  Index_range<Triangle_index> with_least_vertex(Vertex_index v) const
  {
    return {Triangle_index(first_triangles[v]), Triangle_index(first_triangles[Vertex_index(v.number() + 1)])};
  }
};

// Sorts triangles that may come more than once, with their vertices in any order: first into buckets by least vertex,
// then in these, which are small. for_each_triangle(visit) calls visit(a, b, c), and is called twice.
template <class ForEachTriangle>
Triangle_list list_triangles(std::size_t number_of_vertices, const ForEachTriangle& for_each_triangle)
{
  constexpr unsigned bits = 32;
  // The two larger vertices are one number, which is sorted in one comparison.
  const auto for_each_key = [&](const auto& visit) {
    for_each_triangle([&](Vertex_index a, Vertex_index b, Vertex_index c) {
      const Number low = (std::min)(a, b).number(), high = (std::max)(a, b).number();
      const Number middle = (std::max)(low, (std::min)(high, c.number()));
      visit(Vertex_index((std::min)(low, c.number())), (std::uint64_t(middle) << bits) | (std::max)(high, c.number()));
    });
  };
  Buckets<Vertex_index, std::uint64_t> keys(number_of_vertices, for_each_key);
  Triangle_list list;
  list.vertices.reserve(keys.size());
  list.first_triangles.renew(number_of_vertices + 1);
  for(const Vertex_index v : Index_range<Vertex_index>(number_of_vertices))
  {
    list.first_triangles[v] = static_cast<Number>(list.vertices.size());
    const auto bucket = keys[v];
    if(bucket.size() > 1)
      std::sort(bucket.begin(), bucket.end());
    const auto end = std::unique(bucket.begin(), bucket.end());
    for(auto key = bucket.begin(); key != end; ++key)
      list.vertices.push_back({v, Vertex_index(*key >> bits), Vertex_index(*key & ((std::uint64_t(1) << bits) - 1))});
  }
  list.first_triangles.back() = static_cast<Number>(list.vertices.size());
  return list;
}

// The higher end of an edge, and the triangle of which the edge is the last one, no_index if it is none.
struct Higher_end
{
  Vertex_index vertex;
  Triangle_index triangle;
};

// By vertex, the higher ends of edges that the triangles with this least vertex do not have: of edges between the two
// larger vertices of triangles, and of the given edges.
template <class ForEachEdge>
Buckets<Vertex_index, Higher_end> list_higher_ends(std::size_t number_of_vertices,
                                                   const Triangle_list& triangles,
                                                   const ForEachEdge& for_each_edge)
{
  return Buckets<Vertex_index, Higher_end>(number_of_vertices, [&](const auto& visit) {
    for(const Triangle_index t : triangles.vertices.keys())
      visit(triangles.vertices[t][1], Higher_end{triangles.vertices[t][2], t});
    for_each_edge([&](Vertex_index a, Vertex_index b) {
      visit((std::min)(a, b), Higher_end{(std::max)(a, b), no_index});
    });
  });
}

} // namespace internal
} // namespace Reeb_graph
} // namespace CGAL

#endif // CGAL_REEB_GRAPH_INTERNAL_MESH_SIMPLEX_LISTS_H
