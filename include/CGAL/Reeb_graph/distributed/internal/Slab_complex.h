// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of the CGAL-style package Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_DISTRIBUTED_INTERNAL_SLAB_COMPLEX_H
#define CGAL_REEB_GRAPH_DISTRIBUTED_INTERNAL_SLAB_COMPLEX_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/distributed/internal/Slab_surface.h>
#include <CGAL/Reeb_graph/internal/base/Index.h>
#include <CGAL/Reeb_graph/internal/base/arrays.h>
#include <CGAL/Reeb_graph/internal/complex/surface_complexes.h>
#include <CGAL/Reeb_graph/internal/engine/Slab.h>
#include <CGAL/Reeb_graph/internal/engine/classify_vertices.h>
#include <CGAL/Reeb_graph/internal/engine/contour_tracing.h>

#include <algorithm>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Reeb_graph {
namespace internal {

// The surface that a rank holds, of which only the vertices of its slab count as vertices: each has its whole star
// here. What is beyond them is known as far as levels in the slab cross it. It refers to the arrays of a Slab_surface.
class Slab_complex : public Triangle_complex_base<Slab_complex>
{
public:
  Slab_complex(Halfedge_arrays arrays,
               const Indexed_vector<Vertex_index, Global_vertex>& global_vertices,
               const Indexed_vector<Vertex_index, Slab_index>& slabs_of_vertices)
    : Triangle_complex_base<Slab_complex>(std::move(arrays.halfedges_of_vertices)),
      halfedges_(std::move(arrays.halfedges)),
      global_vertices_(&global_vertices),
      slabs_of_vertices_(&slabs_of_vertices)
  {}

  Number number_of_halfedges() const { return static_cast<Number>(halfedges_.size()); }
  bool has_vertex(Vertex_index vertex) const { return (*slabs_of_vertices_)[vertex] == Slabs_of_rank::inside(); }
  bool has_star(Vertex_index vertex) const { return has_vertex(vertex); }
  bool has_edge(Edge_index) const { return true; }

  Vertex_index target(Halfedge_index halfedge) const { return halfedges_[halfedge].target; }
  Halfedge_index next(Halfedge_index halfedge) const { return halfedges_[halfedge].next; }
  bool has_triangle(Halfedge_index halfedge) const { return next(halfedge) != no_index; }

  Global_vertex global_vertex(Vertex_index vertex) const { return (*global_vertices_)[vertex]; }
  std::size_t position(Vertex_index vertex) const { return static_cast<std::size_t>(global_vertex(vertex)); }

  // For Unchecked_complex. The triangles have three vertices, and there are no edges without them.
  std::size_t number_of_faces() const
  {
    return static_cast<std::size_t>(
             std::count_if(halfedges_.begin(), halfedges_.end(), [](const Halfedge& h) { return h.next != no_index; }))
         / 3;
  }
  Halfedge_index halfedge_of_face_at(Vertex_index vertex) const { return first_halfedge(vertex); }
  bool has_no_others(std::size_t number_of_corners, std::size_t) const
  {
    return number_of_corners
        == static_cast<std::size_t>(std::count_if(halfedges_.begin(), halfedges_.end(), [&](const Halfedge& halfedge) {
             return halfedge.next != no_index && has_vertex(halfedge.target);
           }));
  }
  void check_faces() const {}
  void check_edges() const {}

private:
  Indexed_vector<Halfedge_index, Halfedge> halfedges_;
  const Indexed_vector<Vertex_index, Global_vertex>* global_vertices_;
  const Indexed_vector<Vertex_index, Slab_index>* slabs_of_vertices_;
};

// The surface that a rank holds, after its triangles have been linked. The complex refers to the arrays of the surface.
template <class Scalar, class Complex = Slab_complex>
struct Linked_slab
{
  Linked_slab() = default;
  Linked_slab(const Linked_slab&) = delete;
  Linked_slab& operator=(const Linked_slab&) = delete;

  Slab_surface<Scalar> surface;
  std::optional<Classified_complex<Complex>> classified;
};

// Calls visit(halfedges, is_closed) for each contour at the level just above the last vertex of value at most `value`,
// which must be a level of the slab: in the order of their least edges, with which closed ones begin.
template <class Scalar, class Visit>
void for_each_contour(const Linked_slab<Scalar>& slab, const Scalar& value, const Visit& visit)
{
  const Slab_complex& complex = slab.classified->complex;
  const auto is_below = [&](Vertex_index v) { return !(value < slab.surface.values[v]); };
  std::vector<bool> is_found(complex.number_of_edges(), false);
  Plain_vector<Halfedge_index> crossed;
  for(const Edge_index edge : Index_range<Edge_index>(complex.number_of_edges()))
  {
    const Halfedge_index start = complex.halfedge_of_triangle(edge);
    if(is_found[edge.number()] || is_below(complex.source(start)) == is_below(complex.target(start)))
      continue;
    const bool is_closed = trace_oriented_contour(complex, start, is_below, crossed);
    for(Halfedge_index& halfedge : crossed)
    {
      is_found[edge_of(halfedge).number()] = true;
      if(!is_below(complex.source(halfedge)))
        halfedge = opposite_of(halfedge);
    }
    visit(crossed, is_closed);
  }
}

} // namespace internal
} // namespace Reeb_graph
} // namespace CGAL

#endif // CGAL_REEB_GRAPH_DISTRIBUTED_INTERNAL_SLAB_COMPLEX_H
