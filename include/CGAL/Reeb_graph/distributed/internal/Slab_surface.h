// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_DISTRIBUTED_INTERNAL_SLAB_SURFACE_H
#define CGAL_REEB_GRAPH_DISTRIBUTED_INTERNAL_SLAB_SURFACE_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/distributed/exceptions.h>
#include <CGAL/Reeb_graph/internal/base/Index.h>
#include <CGAL/Reeb_graph/internal/base/arrays.h>
#include <CGAL/Reeb_graph/internal/complex/surface_complexes.h>
#include <CGAL/Reeb_graph/internal/engine/classify_vertices.h>
#include <CGAL/Reeb_graph/internal/engine/slabs.h>
#include <CGAL/Reeb_graph/internal/engine/walks.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL::Reeb_graph::internal {

// The slabs as a rank sees them: all that is below its own one, its own one, and all that is above.
struct Slabs_of_rank
{
  static constexpr Slab_index below() { return Slab_index(0); }
  static constexpr Slab_index inside() { return Slab_index(1); }
  static constexpr Slab_index above() { return Slab_index(2); }
};

// The part of the surface that a rank holds: each triangle that meets its slab, also those that only pass it, and each
// vertex of the slab. A level between two slabs crosses only triangles with vertices on both sides of it, and these
// meet both slabs, so both ranks hold all of the level, and find and close its contours alike. A vertex of the slab has
// its whole star here, and any other one any part of it. Rank r has slab r; a rank beyond the slabs has empty arrays.
template <class Scalar>
struct Slab_surface : Slabs_of_rank
{
  bool has_slab() const { return slab < number_of_slabs; }
  bool is_lowest() const { return slab == 0; }
  bool is_highest() const { return slab + 1 == number_of_slabs; }

  Indexed_vector<Vertex_index, Long_index> global_vertices; // ascending, so local indices break ties as global ones
  Indexed_vector<Vertex_index, Scalar> values;
  Indexed_vector<Vertex_index, Slab_index> slabs_of_vertices; // below(), inside() or above()
  std::vector<std::array<Vertex_index, 3>> triangles;         // in no order
  std::size_t slab = 0;
  std::size_t number_of_slabs = 1;
  // the values of the levels between the slab and its neighbors, as far as it has any
  std::optional<Scalar> lower_bound, upper_bound;
};

// A vertex with its value: its place in the total order of the vertices of all ranks.
template <class Scalar>
struct Order_key
{
  static_assert(std::is_arithmetic_v<Scalar>, "On several ranks, scalar values are numbers.");

  Scalar value;
  Long_index vertex;

  friend bool operator<(const Order_key& a, const Order_key& b)
  {
    return a.value < b.value || (a.value == b.value && a.vertex < b.vertex);
  }
};

// The highest place of each slab but the last one, ascending.
template <class Scalar>
using Splitters = std::vector<Order_key<Scalar>>;

// The slab in which a place is.
template <class Scalar>
std::size_t slab_of(const Splitters<Scalar>& splitters, const Order_key<Scalar>& place)
{
  return static_cast<std::size_t>(std::lower_bound(splitters.begin(), splitters.end(), place) - splitters.begin());
}

// The vertices that one rank has brought, and knows the values of.
struct Vertex_range
{
  Long_index begin;
  Long_index end;
  std::size_t rank;
};

// The ranges of all ranks, which together are the indices from 0, each one once. Empty ones are left out.
class Vertex_ranges
{
public:
  explicit Vertex_ranges(std::vector<Vertex_range> ranges) : ranges_(std::move(ranges))
  {
    const auto is_empty = [](const Vertex_range& range) { return range.begin == range.end; };
    ranges_.erase(std::remove_if(ranges_.begin(), ranges_.end(), is_empty), ranges_.end());
    std::sort(ranges_.begin(), ranges_.end(),
              [](const Vertex_range& a, const Vertex_range& b) { return a.begin < b.begin; });
    Long_index end = 0;
    for(const Vertex_range& range : ranges_)
    {
      if(range.begin != end)
        throw Vertex_ranges_error(static_cast<std::size_t>((std::min)(range.begin, end)));
      end = range.end;
    }
    number_of_vertices_ = end;
  }

  Long_index number_of_vertices() const { return number_of_vertices_; }

  // In ascending order.
  const std::vector<Vertex_range>& ranges() const { return ranges_; }

private:
  std::vector<Vertex_range> ranges_;
  Long_index number_of_vertices_;
};

// The surface that a rank holds, after its triangles have been linked. The complex refers to the arrays of the surface.
template <class Scalar, class Complex = Triangle_complex>
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
  const Triangle_complex& complex = slab.classified->complex;
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

} // namespace CGAL::Reeb_graph::internal

#endif // CGAL_REEB_GRAPH_DISTRIBUTED_INTERNAL_SLAB_SURFACE_H
