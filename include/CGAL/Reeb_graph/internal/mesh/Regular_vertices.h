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
#include <CGAL/Reeb_graph/internal/base/Zeroed_array.h>
#include <CGAL/Reeb_graph/internal/base/parallel.h>
#include <CGAL/Reeb_graph/internal/base/tuning.h>
#include <CGAL/Reeb_graph/internal/mesh/Triangle_complex_base.h>
#include <CGAL/Reeb_graph/internal/mesh/mesh_indices.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>

namespace CGAL {
namespace Reeb_graph {
namespace internal {

// Whether the field is smooth, by a sample of the edges: the maxima of links at them are then as many as a third of
// these; on noise, two thirds.
template <class Complex, class Order>
bool is_smooth(const Complex& complex, const Order& order)
{
  constexpr std::size_t number_of_samples = 500;
  const std::size_t number_of_edges = complex.number_of_edges();
  std::size_t number = 0, number_of_maxima = 0;
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
    ++number;
    for(const Vertex_index end : {u, v})
      number_of_maxima += order(x, end) && order(y, end) ? 1 : 0;
  }
  return number_of_maxima < number / 2;
}

// The vertices that are seen to be regular, and to have one fan, with no turn around them: by a sweep over the
// triangles, in the order in which they are in memory.
//
// Each triangle has a lowest, a middle and a highest vertex. They are the vertices that are
// - the middle one of two triangles,
// - only on edges with two triangles,
// - on no edge up whose other vertices in both triangles are the highest ones, and
// - on no edge down whose other vertices in both triangles are the lowest ones.
// By the second condition, each of their fans is inside of the surface: its link is a closed curve, which changes
// between lower and higher vertices in those triangles in which its vertex is the middle one. So by the first condition
// one fan has one lower and one upper part, or there is none but such with a link that is all lower or all higher; as
// the changes of a closed curve are an even number, they are not of two fans. If the link of a fan is all higher, it has
// a lowest vertex, which is on an edge of the third kind; if it is all lower, its highest one is on one of the fourth.
// So there is no such fan, and the one that is left has one lower and one upper part.
//
// These are nearly all vertices of a smooth field. There are none here if something is wrong with a face.
class Regular_vertices
{
public:
  // No vertices.
  Regular_vertices() = default;

  // Calls set_halfedge(vertex, a halfedge of a triangle that ends there) for these vertices, and maybe for other ones.
  template <class Complex, class Order, class SetHalfedge>
  Regular_vertices(const Complex& complex, const Order& order, const SetHalfedge& set_halfedge)
    : corners_(complex.number_of_vertices(), 0)
  {
    Apexes apexes(complex.number_of_halfedges());
    const std::size_t end = complex.end_of_faces();
    for(std::size_t block = 0; block < end; block += block_size)
    {
      const Index_range faces(Face_index(block), Face_index((std::min)(block + block_size, end)));
      if(!add_triangles(complex, order, set_halfedge, faces, apexes))
      {
        corners_.clear();
        return;
      }
    }
    for(const Edge_index e : Index_range<Edge_index>(complex.number_of_edges()))
      add_edge(complex, order, even_halfedge(e), apexes);
  }

  // How many corners of triangles are at a vertex, 0 if it is none of these.
  Number number_of_corners(Vertex_index vertex) const
  {
    if(corners_.empty())
      return 0;
    const Number number = static_cast<Number>(corners_[vertex]),
                 number_of_no_middles = static_cast<Number>(corners_[vertex] >> 32);
    return number - number_of_no_middles == 2 ? number : 0;
  }

private:
  // For the triangle of a halfedge, whether the vertex opposite of the halfedge is the lowest one, the middle one, or
  // the highest one, as the numbers around `middle`; 0 if there is no triangle.
  typedef Zeroed_array<Halfedge_index, std::uint8_t> Apexes;
  static constexpr int middle = 4;

  static constexpr std::size_t block_size = 32;

  // Reads some faces, then counts: what is read need not wait for what is written. Returns whether all is right with
  // them.
  template <class Complex, class Order, class SetHalfedge>
  bool add_triangles(const Complex& complex,
                     const Order& order,
                     const SetHalfedge& set_halfedge,
                     const Index_range<Face_index>& faces,
                     Apexes& apexes)
  {
    std::array<Triangle_at_face, block_size> triangles;
    std::size_t size = 0;
    bool are_right = true;
    for(const Face_index f : faces)
      if(complex.has_face(f))
        are_right &= complex.read_triangle(f, triangles[size++]);
    if(are_right)
      for(std::size_t i = 0; i != size; ++i)
        add_triangle(triangles[i], order, set_halfedge, apexes);
    return are_right;
  }

  // Without branches on what is compared, as none could be foreseen.
  template <class Order, class SetHalfedge>
  void add_triangle(const Triangle_at_face& triangle,
                    const Order& order,
                    const SetHalfedge& set_halfedge,
                    Apexes& apexes)
  {
    const Vertex_index a = triangle.vertices[0], b = triangle.vertices[1], c = triangle.vertices[2];
    const unsigned ab = order.is_lower(a, b), bc = order.is_lower(b, c), ca = order.is_lower(c, a);
    add_corner(a, ca, ab);
    add_corner(b, ab, bc);
    add_corner(c, bc, ca);
    const Halfedge_index to_a = triangle.halfedges[0], to_b = triangle.halfedges[1], to_c = triangle.halfedges[2];
    set_halfedge(a, to_a);
    set_halfedge(b, to_b);
    set_halfedge(c, to_c);
    apexes[to_a] = static_cast<std::uint8_t>(middle + ab - bc); // is opposite of b
    apexes[to_b] = static_cast<std::uint8_t>(middle + bc - ca);
    apexes[to_c] = static_cast<std::uint8_t>(middle + ca - ab);
  }

  void add_corner(Vertex_index vertex, unsigned is_above_last, unsigned is_below_next)
  {
    const std::uint64_t is_no_middle = is_above_last ^ is_below_next;
    corners_[vertex] += 1 + (is_no_middle << 32);
  }

  // Excludes the ends of an edge that the conditions above exclude.
  template <class Complex, class Order>
  void add_edge(const Complex& complex, const Order& order, Halfedge_index even, const Apexes& apexes)
  {
    const int sum = apexes[even] + apexes[opposite_of(even)];
    if(sum >= 2 * middle - 1
       && sum <= 2 * middle + 1) // One opposite vertex is the middle one, or they are of both kinds.
      return;
    if(!complex.has_edge(edge_of(even)))
      return;
    const bool has_triangles = sum >= 2 * (middle - 1), are_higher = sum > 2 * middle;
    const Vertex_index ends[] = {complex.source(even), complex.target(even)};
    for(const std::size_t i : {0, 1})
      if(corners_.contains(ends[i]) && (!has_triangles || order(ends[i], ends[1 - i]) == are_higher))
        corners_[ends[i]] = excluded;
  }

  // The number of the corners of a vertex, and, in the higher half, of those where it is the lowest or the highest
  // vertex of the triangle: one number, so that it is written once for each corner.
  Indexed_vector<Vertex_index, std::uint64_t> corners_;
  static constexpr std::uint64_t excluded = (std::numeric_limits<std::uint64_t>::max)();
};

// The regular vertices if to find them pays.
template <class ConcurrencyTag, class Complex, class Order, class SetHalfedge>
Regular_vertices find_regular_vertices(const Complex& complex, const Order& order, const SetHalfedge& set_halfedge)
{
  constexpr std::size_t smallest_number_of_edges = 100000; // Fewer ones are in the caches.
  if(is_used(Tuned_part::FACE_SWEEP) && !is_parallel<ConcurrencyTag>()
     && complex.number_of_edges() >= smallest_number_of_edges && is_smooth(complex, order))
    return {complex, order, set_halfedge};
  return {};
}

} // namespace internal
} // namespace Reeb_graph
} // namespace CGAL

#endif // CGAL_REEB_GRAPH_INTERNAL_MESH_REGULAR_VERTICES_H
