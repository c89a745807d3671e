// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of the CGAL-style package Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_INTERNAL_MESH_REGULAR_VERTICES_H
#define CGAL_REEB_GRAPH_INTERNAL_MESH_REGULAR_VERTICES_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/internal/base/Index.h>
#include <CGAL/Reeb_graph/internal/base/Indexed_vector.h>
#include <CGAL/Reeb_graph/internal/base/parallel.h>
#include <CGAL/Reeb_graph/internal/base/prefetch.h>
#include <CGAL/Reeb_graph/internal/base/tuning.h>
#include <CGAL/Reeb_graph/internal/mesh/Edge_directions.h>
#include <CGAL/Reeb_graph/internal/mesh/mesh_indices.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>

namespace CGAL {
namespace Reeb_graph {
namespace internal {

// What a sample of the edges tells.
struct Sampled_edges
{
  std::size_t number = 0;
  std::size_t far_ones = 0;    // whose ends or next edges are far away in memory
  std::size_t link_maxima = 0; // as many as a third of the edges if the field is smooth, two thirds on noise
};

template <class Complex, class Order>
Sampled_edges sample_edges(const Complex& complex, const Order& order)
{
  constexpr std::size_t number_of_samples = 500;
  const std::size_t number_of_edges = complex.number_of_edges();
  const auto are_far = [](Index a, Index b, std::size_t size) {
    return (std::max)(a, b) - (std::min)(a, b) > size / 16;
  };
  Sampled_edges sample;
  for(std::size_t i = 0; i != number_of_samples; ++i)
  {
    const Halfedge_index h = even_halfedge(Edge_index(i * number_of_edges / number_of_samples));
    if(!complex.has_edge(edge_of(h)) || complex.is_on_border_edge(h))
      continue;
    const Halfedge_index left = complex.next(h), right = complex.next(opposite_of(h));
    if((std::max)(left, right).number() >= complex.number_of_halfedges())
      continue; // Nothing has been checked yet.
    const Vertex_index u = complex.source(h), v = complex.target(h), x = complex.target(left),
                       y = complex.target(right);
    if((std::max)({u, v, x, y}).number() >= complex.number_of_vertices())
      continue;
    ++sample.number;
    sample.far_ones += are_far(h.number(), left.number(), complex.number_of_halfedges())
                    || are_far(u.number(), v.number(), complex.number_of_vertices());
    for(const Vertex_index end : {u, v})
      sample.link_maxima += order(x, end) && order(y, end) ? 1 : 0;
  }
  return sample;
}

// Whether a sweep finds vertices to be regular faster than turns around them. It does if neighbors are often far from
// each other in memory: each step of a turn then waits, as it is known only when the last one has come.
template <class Complex, class Order>
bool is_sweep_faster(const Complex& complex, const Order& order)
{
  constexpr std::size_t smallest_number_of_edges = 100000; // Fewer ones are in the caches.
  if(complex.number_of_edges() < smallest_number_of_edges)
    return false;
  const Sampled_edges sample = sample_edges(complex, order);
  return sample.far_ones > sample.number / 4 && sample.link_maxima < sample.number / 2;
}

// The vertices that are seen to be regular, and to have one fan, with no turn around them: by sweeps over the faces and
// the edges, which read memory in its order, but for a few bytes per vertex.
//
// They are the vertices inside of the surface whose links have one maximum, which is higher than the vertex, which has
// a lower neighbor, too. The link of each fan has a maximum, so there is no other fan; and such a link ascends once and
// descends once, so that it has one upper and one lower part. These are nearly all vertices of a smooth field. There
// are none here where something is wrong with a face or an edge.
template <class ConcurrencyTag>
class Regular_vertices
{
public:
  // No vertices.
  Regular_vertices() = default;

  template <class Complex, class Order>
  Regular_vertices(const Complex& complex, const Order& order)
    : directions_(Edge_directions::make<ConcurrencyTag>(complex, order))
  {
    if(directions_.has_bad_edge()
       || !complex.template has_only_triangles<ConcurrencyTag>(directions_.number_of_halfedges_of_faces()))
      return;
    ends_ = Ends(complex.number_of_vertices());
    have_lower_neighbor_ = Flags(complex.number_of_vertices());
    for_each_block<ConcurrencyTag>(complex.number_of_edges(), [&](std::size_t begin, std::size_t end) {
      for(const Edge_index e : Index_range(Edge_index(begin), Edge_index(end)))
        if(complex.has_edge(e))
          sweep_edge(complex, e);
    });
    number_of_corners_ = sum_of_parts<ConcurrencyTag, std::size_t>(
      complex.number_of_edges(), [&](std::size_t begin, std::size_t end, std::size_t& number) {
        for(const Edge_index e : Index_range(Edge_index(begin), Edge_index(end)))
          if(complex.has_edge(e))
            number += number_of_corners_at(complex, e);
      });
  }

  // A halfedge that ends at a vertex, no_index if it is not one of these.
  Halfedge_index halfedge(Vertex_index vertex) const
  {
    if(ends_.empty())
      return no_index;
    const Number end = ends_[vertex].get();
    return end == none || end == several || have_lower_neighbor_[vertex].get() == 0 ? Halfedge_index(no_index)
                                                                                    : Halfedge_index(end - 1);
  }

  // The corners of triangles at these vertices.
  std::size_t number_of_corners() const { return number_of_corners_; }

private:
  static constexpr Number none = 0, several = No_index(); // or other reasons not to say

  template <class Complex>
  void sweep_edge(const Complex& complex, Edge_index edge)
  {
    prefetch_states(complex, edge);
    const Halfedge_index even = even_halfedge(edge);
    const Halfedge_index descending = directions_.is_ascending(even) ? opposite_of(even) : even;
    const Vertex_index lower = complex.target(descending), higher = complex.source(descending);
    if(complex.is_on_border_edge(even))
    {
      ends_[lower].set(several);
      ends_[higher].set(several);
      return;
    }
    have_lower_neighbor_[higher].set(1);
    if(is_source_maximum(complex, descending))
      add_maximum(lower, descending);
    if(is_source_maximum(complex, opposite_of(descending)))
      ends_[higher].set(several);
  }

  // Whether the source of a halfedge is higher than what is beside it in the link of the target.
  template <class Complex>
  bool is_source_maximum(const Complex& complex, Halfedge_index halfedge) const
  {
    const bool is_higher_than_left = directions_.is_ascending(complex.previous(halfedge));
    const bool is_higher_than_right = !directions_.is_ascending(complex.next(opposite_of(halfedge)));
    return is_higher_than_left & is_higher_than_right;
  }

  // Of threads that meet at a vertex, one sees that there has been no maximum. The other ones write last.
  void add_maximum(Vertex_index vertex, Halfedge_index halfedge)
  {
    Relaxed_value<Number>& end = ends_[vertex];
    if(end.get() != none || end.template exchange<ConcurrencyTag>(halfedge.number() + 1) != none)
      end.set(several);
  }

  template <class Complex>
  std::size_t number_of_corners_at(const Complex& complex, Edge_index edge) const
  {
    prefetch_states(complex, edge);
    std::size_t number = 0;
    for(const Halfedge_index h : {even_halfedge(edge), opposite_of(even_halfedge(edge))})
    {
      const Vertex_index v = complex.target(h);
      number += complex.has_triangle(h) && halfedge(v) != no_index && complex.has_vertex(v) ? 1 : 0;
    }
    return number;
  }

  template <class Complex>
  void prefetch_states(const Complex& complex, Edge_index edge) const
  {
    prefetch_ends(complex, edge, [&](Vertex_index v) {
      prefetch_element(ends_, v);
      prefetch_element(have_lower_neighbor_, v);
    });
  }

  typedef Indexed_vector<Vertex_index, Relaxed_value<Number>> Ends;
  typedef Indexed_vector<Vertex_index, Relaxed_value<std::uint8_t>> Flags;

  Edge_directions directions_;
  Ends ends_; // the number behind that of a halfedge from the maximum of the link
  Flags have_lower_neighbor_;
  std::size_t number_of_corners_ = 0;
};

// The regular vertices if to find them pays.
template <class ConcurrencyTag, class Complex, class Order>
Regular_vertices<ConcurrencyTag> find_regular_vertices(const Complex& complex, const Order& order)
{
  if(is_used(Tuned_part::EDGE_SWEEP) && is_sweep_faster(complex, order))
    return {complex, order};
  return {};
}

} // namespace internal
} // namespace Reeb_graph
} // namespace CGAL

#endif // CGAL_REEB_GRAPH_INTERNAL_MESH_REGULAR_VERTICES_H
