// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of the CGAL-style package Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_INTERNAL_COMPLEX_REGULAR_VERTICES_H
#define CGAL_REEB_GRAPH_INTERNAL_COMPLEX_REGULAR_VERTICES_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/internal/base/Index.h>
#include <CGAL/Reeb_graph/internal/base/arrays.h>
#include <CGAL/Reeb_graph/internal/base/parallel.h>
#include <CGAL/Reeb_graph/internal/base/tuning.h>

#include <algorithm>
#include <array>
#include <cstddef>

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

// How many pages of memory the halfedges are on with which turns around some vertices begin, for each of these. They
// are few if the mesh was made vertex by vertex, and nearly one for each if its faces are in another order.
template <class Complex>
double pages_per_vertex(const Complex& complex)
{
  constexpr std::size_t number_of_runs = 32, length = 64, halfedges_per_page = 256;
  if(complex.number_of_vertices() < length)
    return 0;
  std::size_t number_of_pages = 0;
  for(std::size_t run = 0; run != number_of_runs; ++run)
  {
    const std::size_t first = run * (complex.number_of_vertices() - length) / number_of_runs;
    std::array<std::size_t, length> pages;
    for(std::size_t i = 0; i != length; ++i)
      pages[i] = complex.halfedge_of_face_at(Vertex_index(first + i)).number() / halfedges_per_page;
    std::sort(pages.begin(), pages.end());
    number_of_pages += static_cast<std::size_t>(std::unique(pages.begin(), pages.end()) - pages.begin());
  }
  return static_cast<double>(number_of_pages) / (number_of_runs * length);
}

// Whether a sweep finds vertices to be regular faster than turns around them. It does if neighbors are often far from
// each other in memory, or vertices in a row are: each step of a turn then waits, as it is known only when the last one
// has come.
template <class Complex, class Order>
bool is_sweep_faster(const Complex& complex, const Order& order)
{
  constexpr std::size_t smallest_number_of_edges = 100000; // Fewer ones are in the caches.
  if(complex.number_of_edges() < smallest_number_of_edges)
    return false;
  const Sampled_edges sample = sample_edges(complex, order);
  return sample.link_maxima < sample.number / 2
      && (sample.far_ones > sample.number / 4 || pages_per_vertex(complex) > 0.3);
}

// The vertices that are seen to be regular, and to have one fan, with no turn around them: by a sweep over the edges,
// in the order in which they are in memory.
//
// They are the vertices inside of the surface whose links have one maximum, which is higher than the vertex, and no
// minimum that is. The link of each fan has a maximum, so there is no other fan; such a link ascends once and descends
// once, and its minimum is lower than the vertex, so that it has one upper and one lower part. These are nearly all
// vertices of a smooth field. There are none here where something is wrong with a face or an edge.
template <class ConcurrencyTag>
class Regular_vertices
{
public:
  // No vertices.
  Regular_vertices() = default;

  template <class Complex, class Order>
  Regular_vertices(const Complex& complex, const Order& order) : found_(complex.number_of_vertices())
  {
    const auto sweep = [&](std::size_t begin, std::size_t end, std::size_t& number_of_bad_edges) {
      for(std::size_t block = begin; block < end; block += block_size)
        number_of_bad_edges +=
          sweep_block(complex, order, Edge_index(block), Edge_index((std::min)(block + block_size, end)));
    };
    if(sum_of_parts<ConcurrencyTag, std::size_t>(complex.number_of_edges(), sweep) != 0)
    {
      found_.clear();
      return;
    }
    number_of_corners_ = sum_of_parts<ConcurrencyTag, std::size_t>(
      found_.size(), [&](std::size_t begin, std::size_t end, std::size_t& number) {
        for(const Vertex_index v : Index_range(Vertex_index(begin), Vertex_index(end)))
          number += complex.has_vertex(v) && halfedge(v) != no_index ? found_[v].number_of_edges.get() : 0;
      });
  }

  // A halfedge that ends at a vertex, no_index if it is not one of these.
  Halfedge_index halfedge(Vertex_index vertex) const
  {
    if(found_.empty())
      return no_index;
    const Number end = found_[vertex].end.get();
    return end == none || end == several ? Halfedge_index(no_index) : Halfedge_index(end - 1);
  }

  // The corners of triangles at these vertices, which have as many edges.
  std::size_t number_of_corners() const { return number_of_corners_; }

private:
  static constexpr Number none = 0, several = No_index(); // or other reasons not to say

  struct Found
  {
    Relaxed_value<Number> end;             // the number behind that of a halfedge from the maximum of the link
    Relaxed_value<Number> number_of_edges; // without those on the border
  };

  // The vertices opposite of an edge, if it has two triangles.
  struct Apexes
  {
    Vertex_index left, right;
  };

  static constexpr std::size_t block_size = 128; // What is read of the edges of a block stays in the first caches.
  typedef std::array<Apexes, block_size> Apexes_of_block;

  // Returns the number of edges with which something is wrong. If there are any, nothing has been found.
  template <class Complex, class Order>
  std::size_t sweep_block(const Complex& complex, const Order& order, Edge_index begin, Edge_index end)
  {
    const Apexes_of_block apexes = find_apexes(complex, begin, end);
    std::size_t number_of_bad_edges = 0;
    for(const Edge_index e : Index_range(begin, end))
    {
      if(!complex.has_edge(e))
        continue;
      number_of_bad_edges += is_bad_edge(complex, e) ? 1 : 0;
      const Apexes& beside = apexes[e.number() - begin.number()];
      for(const Vertex_index v : {complex.source(even_halfedge(e)), complex.target(even_halfedge(e))})
      {
        order.prefetch(v);
        prefetch_element(found_, v);
      }
      order.prefetch(beside.left);
      order.prefetch(beside.right);
    }
    if(number_of_bad_edges != 0)
      return number_of_bad_edges;
    for(const Edge_index e : Index_range(begin, end))
      if(complex.has_edge(e))
        add_edge(complex, order, e, apexes[e.number() - begin.number()]);
    return 0;
  }

  // The next halfedges may be anywhere in memory, and a mesh does not tell where to prefetch them. This loop does
  // nothing else, so that the processor has the reads of many rounds before it, and waits for them at once.
  template <class Complex>
  static Apexes_of_block find_apexes(const Complex& complex, Edge_index begin, Edge_index end)
  {
    const Number number_of_halfedges = complex.number_of_halfedges();
    const auto target_of_next = [&](Halfedge_index h) {
      const Halfedge_index next = complex.next(h);
      return complex.target(next.number() < number_of_halfedges ? next : h); // Nothing has been checked yet.
    };
    Apexes_of_block apexes;
    std::size_t i = 0;
    for(const Edge_index e : Index_range(begin, end))
      apexes[i++] = {target_of_next(even_halfedge(e)), target_of_next(opposite_of(even_halfedge(e)))};
    return apexes;
  }

  // Whether an edge has one vertex at both ends, or no face, or one that is no triangle.
  template <class Complex>
  static bool is_bad_edge(const Complex& complex, Edge_index edge)
  {
    const Halfedge_index even = even_halfedge(edge), odd = opposite_of(even);
    const bool has_left = complex.has_triangle(even), has_right = complex.has_triangle(odd);
    return complex.source(even) == complex.target(even) || !(has_left || has_right)
        || (has_left && !complex.is_next_in_triangle(even)) || (has_right && !complex.is_next_in_triangle(odd));
  }

  // Without branches on what is compared, as none could be foreseen where the surface is not in order in memory.
  template <class Complex, class Order>
  void add_edge(const Complex& complex, const Order& order, Edge_index edge, const Apexes& apexes)
  {
    const Halfedge_index even = even_halfedge(edge);
    const Vertex_index ends[] = {complex.source(even), complex.target(even)};
    if(complex.is_on_border_edge(even))
    {
      for(const Vertex_index v : ends)
        found_[v].end.set(several);
      return;
    }
    const std::size_t higher = order.is_lower(ends[0], ends[1]) ? 1 : 0, lower = 1 - higher;
    std::size_t numbers_of_lower_apexes[2]; // than each end
    for(const std::size_t i : {0, 1})
      numbers_of_lower_apexes[i] =
        std::size_t(order.is_lower(apexes.left, ends[i])) + std::size_t(order.is_lower(apexes.right, ends[i]));
    Found &at_lower = found_[ends[lower]], &at_higher = found_[ends[higher]];
    at_lower.number_of_edges.template add<ConcurrencyTag>(1);
    at_higher.number_of_edges.template add<ConcurrencyTag>(1);
    if(numbers_of_lower_apexes[higher] == 2)
      add_maximum(at_lower, Halfedge_index(even.number() + higher)); // the one that descends
    if(numbers_of_lower_apexes[higher] == 0)
      at_lower.end.set(several); // A minimum of its link is higher.
    if(numbers_of_lower_apexes[lower] == 2)
      at_higher.end.set(several); // A maximum of its link is lower.
  }

  // Of threads that meet at a vertex, one sees that there has been no maximum. The other ones write last.
  static void add_maximum(Found& found, Halfedge_index halfedge)
  {
    if(found.end.get() != none || found.end.template exchange<ConcurrencyTag>(halfedge.number() + 1) != none)
      found.end.set(several);
  }

  Indexed_vector<Vertex_index, Found> found_;
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

#endif // CGAL_REEB_GRAPH_INTERNAL_COMPLEX_REGULAR_VERTICES_H
