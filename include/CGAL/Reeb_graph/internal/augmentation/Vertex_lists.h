// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of the CGAL-style package Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_INTERNAL_AUGMENTATION_VERTEX_LISTS_H
#define CGAL_REEB_GRAPH_INTERNAL_AUGMENTATION_VERTEX_LISTS_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/internal/base/Index.h>
#include <CGAL/Reeb_graph/internal/base/Indexed_vector.h>
#include <CGAL/Reeb_graph/internal/base/parallel.h>
#include <CGAL/Reeb_graph/internal/mesh/mesh_indices.h>

#include <CGAL/Iterator_range.h>
#include <CGAL/tags.h>

#include <cstddef>
#include <functional>
#include <mutex>
#include <numeric>
#include <utility>
#include <vector>

namespace CGAL {
namespace Reeb_graph {
namespace internal {

typedef Indexed_vector<Vertex_index, Index> Vertex_places; // no_index where there is no vertex

// The vertices of each place in ascending order. They are sorted when they are asked for, which takes longer than to
// find the places.
template <class VertexDescriptor>
class Vertex_lists
{
public:
  typedef Iterator_range<const VertexDescriptor*> Range;

  // Writes the vertices by place, and where those of each place begin; and the end.
  typedef std::function<void(std::vector<VertexDescriptor>& vertices, std::vector<std::size_t>& begins)> Make;

  explicit Vertex_lists(Make make) : make_(std::move(make)) {}

  Range operator()(std::size_t place) const
  {
    std::call_once(is_made_, [&] {
      make_(vertices_, begins_);
      make_ = nullptr;
    });
    return Range(vertices_.data() + begins_[place], vertices_.data() + begins_[place + 1]);
  }

private:
  mutable std::once_flag is_made_;
  mutable Make make_;
  mutable std::vector<VertexDescriptor> vertices_;
  mutable std::vector<std::size_t> begins_;
};

// Does what Vertex_lists needs: counts the vertices of each place, and sorts those of one place by the order.
template <class VertexList, class Order, class VertexDescriptor>
void sort_vertices_by_place(const VertexList& vertex_list,
                            const Order& order,
                            const Vertex_places& places,
                            std::size_t number_of_places,
                            std::vector<VertexDescriptor>& vertices,
                            std::vector<std::size_t>& begins)
{
  begins.assign(number_of_places + 1, 0);
  for(const Index place : places)
  {
    if(place != no_index)
      ++begins[place + 1];
  }
  std::partial_sum(begins.begin(), begins.end(), begins.begin());
  std::vector<typename Order::template Key<Vertex_index>> keys;
  keys.resize(begins.back());
  std::vector<std::size_t> next(begins);
  for(const Vertex_index v : places.keys())
  {
    if(places[v] != no_index)
      keys[next[places[v]]++] = order.key(v, v);
  }
  for(std::size_t place = 0; place != number_of_places; ++place)
    internal::sort<Sequential_tag>(keys.begin() + begins[place], keys.begin() + begins[place + 1], order);
  vertices.reserve(keys.size());
  for(const auto& key : keys)
    vertices.push_back(vertex_list[key.name]);
}

} // namespace internal
} // namespace Reeb_graph
} // namespace CGAL

#endif // CGAL_REEB_GRAPH_INTERNAL_AUGMENTATION_VERTEX_LISTS_H
