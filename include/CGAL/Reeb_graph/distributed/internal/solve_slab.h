// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_DISTRIBUTED_INTERNAL_SOLVE_SLAB_H
#define CGAL_REEB_GRAPH_DISTRIBUTED_INTERNAL_SOLVE_SLAB_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/distributed/exceptions.h>
#include <CGAL/Reeb_graph/internal/base/Buckets.h>
#include <CGAL/Reeb_graph/internal/base/Index.h>
#include <CGAL/Reeb_graph/internal/complex/Simplicial_complex.h>
#include <CGAL/Reeb_graph/internal/complex/Vertex_order.h>
#include <CGAL/Reeb_graph/internal/complex/surface_complexes.h>
#include <CGAL/Reeb_graph/internal/engine/Between_stages.h>
#include <CGAL/Reeb_graph/internal/engine/classify_vertices.h>
#include <CGAL/Reeb_graph/internal/engine/find_arcs.h>
#include <CGAL/Reeb_graph/internal/engine/slabs.h>
#include <CGAL/Reeb_graph/internal/engine/stages_of_complexes.h>
#include <CGAL/Reeb_graph/internal/engine/walks.h>

#include <algorithm>
#include <array>
#include <cstddef>
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
struct Slab_surface : Slabs_of_rank
{
  bool has_slab() const { return slab < number_of_slabs; }
  bool is_lowest() const { return slab == 0; }
  bool is_highest() const { return slab + 1 == number_of_slabs; }

  Indexed_vector<Vertex_index, Long_index> global_vertices;   // ascending, so local indices break ties as global ones
  Vertex_keys keys;                                           // the values, which doubles hold
  Indexed_vector<Vertex_index, Slab_index> slabs_of_vertices; // below(), inside() or above()
  std::vector<std::array<Vertex_index, 3>> triangles;         // in no order
  std::size_t slab = 0;
  std::size_t number_of_slabs = 1;
  // the keys of the levels between the slab and its neighbors, as far as it has any
  std::optional<double> lower_bound, upper_bound;
};

// A vertex with its key: its place in the total order of the vertices of all ranks.
typedef Vertex_order::Key<Long_index> Order_key;

// The highest place of each slab but the last one, ascending.
typedef std::vector<Order_key> Splitters;

// The slab in which a place is.
inline std::size_t slab_of(const Splitters& splitters, const Order_key& place)
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
template <class Complex = Triangle_complex>
struct Linked_slab
{
  Linked_slab() = default;
  Linked_slab(const Linked_slab&) = delete;
  Linked_slab& operator=(const Linked_slab&) = delete;

  Slab_surface surface;
  std::optional<Classified_complex<Complex>> classified;
};

// Calls visit(halfedges, is_closed) for each contour at a level of the slab, in the order of their least edges, with
// which closed ones begin.
template <class IsBelow, class Visit>
void for_each_contour(const Triangle_complex& complex, const IsBelow& is_below, const Visit& visit)
{
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

struct Corner_tag;
typedef Index_of<Corner_tag> Corner_index; // corner i of triangle t is 3 t + i, as is the halfedge that leaves it

// Finds which halfedges of triangles belong to one edge, and numbers the edges in the order of their lower, then of
// their higher vertices: so ranks that hold the same edges have them in the same order. By counting, without a hash
// table.
class Triangle_linking
{
public:
  Triangle_linking(std::vector<std::array<Vertex_index, 3>> triangles,
                   const Indexed_vector<Vertex_index, Long_index>& global_vertices)
    : triangles_(std::move(triangles)),
      global_vertices_(global_vertices),
      halfedges_of_corners_(checked_index(3 * triangles_.size()))
  {}

  // Throws if an edge is on more than two triangles, or on two that are not oriented alike; of such edges, the error
  // names the first one.
  Halfedge_arrays operator()() &&
  {
    number_edges();
    return make_arrays();
  }

private:
  // A halfedge of a triangle at its lower vertex.
  struct Spoke
  {
    Vertex_index higher_end;
    Corner_index corner;

    friend bool operator<(const Spoke& a, const Spoke& b) { return a.higher_end < b.higher_end; }
  };

  Vertex_index source(Corner_index corner) const { return triangles_[corner.number() / 3][corner.number() % 3]; }
  Vertex_index target(Corner_index corner) const { return source(next(corner)); }
  static Corner_index next(Corner_index corner)
  {
    return Corner_index(corner.number() % 3 == 2 ? corner.number() - 2 : corner.number() + 1);
  }

  void number_edges()
  {
    const auto for_each_corner = [&](const auto& visit) {
      for(const Corner_index corner : halfedges_of_corners_.keys())
        visit((std::min)(source(corner), target(corner)), corner);
    };
    const Buckets<Vertex_index, Corner_index> corners(global_vertices_.size(), for_each_corner);
    std::vector<Spoke> spokes;
    for(const Vertex_index v : global_vertices_.keys())
    {
      spokes.clear();
      for(const Corner_index corner : corners[v])
        spokes.push_back({source(corner) == v ? target(corner) : source(corner), corner});
      std::sort(spokes.begin(), spokes.end());
      for(auto begin = spokes.begin(), end = begin; begin != spokes.end(); begin = end)
      {
        while(end != spokes.end() && end->higher_end == begin->higher_end)
          ++end;
        number_edge(v, begin, end);
      }
    }
    if(non_manifold_edge_)
      throw Non_manifold_edge_error(*non_manifold_edge_);
    if(inconsistent_edge_)
      throw Inconsistent_orientation_error(*inconsistent_edge_);
  }

  // The even halfedge of an edge leads to the higher vertex.
  template <class Iterator>
  void number_edge(Vertex_index v, Iterator begin, Iterator end)
  {
    const auto is_reversed = [&](const Spoke& spoke) { return source(spoke.corner) != v; };
    const std::pair<std::size_t, std::size_t> global_edge(global_vertices_[v], global_vertices_[begin->higher_end]);
    if(end - begin > 2 && !non_manifold_edge_)
      non_manifold_edge_ = global_edge;
    if(end - begin == 2 && is_reversed(begin[0]) == is_reversed(begin[1]) && !inconsistent_edge_)
      inconsistent_edge_ = global_edge;
    for(Iterator spoke = begin; spoke != end; ++spoke)
      halfedges_of_corners_[spoke->corner] =
        Halfedge_index(number_of_halfedges_ + (is_reversed(*spoke) ? std::size_t(1) : std::size_t(0)));
    number_of_halfedges_ += 2;
  }

  Halfedge_arrays make_arrays() const
  {
    Halfedge_arrays arrays;
    arrays.halfedges.resize(checked_index(number_of_halfedges_));
    arrays.halfedges_of_vertices.assign(global_vertices_.size(), no_index);
    for(const Corner_index corner : halfedges_of_corners_.keys())
      arrays.halfedges[opposite_of(halfedges_of_corners_[corner])] = {source(corner), no_index};
    for(const Corner_index corner : halfedges_of_corners_.keys())
    {
      const Halfedge_index halfedge = halfedges_of_corners_[corner];
      arrays.halfedges[halfedge] = {target(corner), halfedges_of_corners_[next(corner)]};
      arrays.halfedges_of_vertices[target(corner)] = halfedge;
    }
    return arrays;
  }

  const std::vector<std::array<Vertex_index, 3>> triangles_;
  const Indexed_vector<Vertex_index, Long_index>& global_vertices_;
  Indexed_vector<Corner_index, Halfedge_index> halfedges_of_corners_;
  std::size_t number_of_halfedges_ = 0;
  std::optional<std::pair<std::size_t, std::size_t>> non_manifold_edge_; // the first one
  std::optional<std::pair<std::size_t, std::size_t>> inconsistent_edge_;
};

// The levels between the slab of a rank and those of its neighbors, as far as there are any.
class Levels_of_rank
{
public:
  template <class Complex>
  Levels_of_rank(const Complex& complex, const Slab_surface& surface)
  {
    if(surface.has_slab() && !surface.is_lowest())
      levels_[Side::LOWER].emplace(complex.number_of_edges());
    if(surface.has_slab() && !surface.is_highest())
      levels_[Side::UPPER].emplace(complex.number_of_edges());
    const auto& slabs = surface.slabs_of_vertices;
    for(const Edge_index edge : Index_range<Edge_index>(complex.number_of_edges()))
    {
      const Slab_index a = slabs[complex.source(even_halfedge(edge))], b = slabs[complex.target(even_halfedge(edge))];
      if(a == b)
        continue;
      if(levels_[Side::LOWER] && (a == surface.below() || b == surface.below()))
        levels_[Side::LOWER]->add_crossed_edge(edge);
      if(levels_[Side::UPPER] && (a == surface.above() || b == surface.above()))
        levels_[Side::UPPER]->add_crossed_edge(edge);
    }
    if(levels_[Side::LOWER])
      levels_[Side::LOWER]->find_contours(complex, [&](Vertex_index u) { return slabs[u] == surface.below(); });
    if(levels_[Side::UPPER])
      levels_[Side::UPPER]->find_contours(complex, [&](Vertex_index u) { return slabs[u] != surface.above(); });
  }

  const Bounding_level* level(Side side) const { return levels_[side] ? &*levels_[side] : nullptr; }
  Index number_of_contours(Side side) const { return levels_[side] ? levels_[side]->number_of_contours() : 0; }

private:
  By_side<std::optional<Bounding_level>> levels_;
};

// Makes a complex of the triangles of the rank, and finds the critical vertices of its slab, at which a surface is
// checked. Takes the triangles, and leaves the other arrays of the surface, to which the result refers.
template <class Complex>
Classified_complex<Complex> make_and_classify(Slab_surface& surface, const Vertex_order& order)
{
  if constexpr(Complex::is_surface)
  {
    const std::size_t number_of_faces = surface.triangles.size();
    Halfedge_arrays arrays = Triangle_linking(std::move(surface.triangles), surface.global_vertices)();
    arrays.is_inside.reserve(surface.slabs_of_vertices.size());
    for(const Slab_index slab : surface.slabs_of_vertices)
      arrays.is_inside.push_back(slab == surface.inside());
    arrays.positions = &surface.global_vertices;
    return check_and_classify_vertices(Threads(),
                                       Unchecked_complex(Triangle_complex(std::move(arrays), number_of_faces)), order);
  }
  else
  {
    const auto for_each_triangle = [&](const auto& visit) {
      for(const std::array<Vertex_index, 3>& t : surface.triangles)
        visit(t[0], t[1], t[2]);
    };
    Simplicial_complex complex(surface.global_vertices.size(), for_each_triangle, [](const auto&) {});
    surface.triangles = {};
    Swept_vertices critical_vertices =
      find_vertices_of_complex(Threads(), complex, order, [&](Vertex_index v, const By_side<Index>& numbers) {
        return surface.slabs_of_vertices[v] == surface.inside() && Are_critical()(v, numbers);
      });
    return {std::move(complex), std::move(critical_vertices)};
  }
}

// The arcs between the nodes of a Slab. Contours of a level are numbered by their first edges, and edges by their
// vertices, so the two ranks at a level know each of its contours by the same number.
struct Arcs_of_slab
{
  Swept_arcs arcs;
  By_side<Index> numbers_of_contours = {0, 0};
};

// Finds the arcs between the critical vertices of the rank's slab and the contours of its bounding levels. Calls
// report(fraction) now and then.
template <class Complex, class ChosenMethod, class Report>
Arcs_of_slab solve_slab(const Slab_surface& surface,
                        const Classified_complex<Complex>& classified,
                        const Vertex_order& order,
                        ChosenMethod method,
                        const Report& report)
{
  const auto& [complex, critical_vertices] = classified;
  const Levels_of_rank levels(complex, surface);
  const Slab<Complex> slab = surface.number_of_slabs == 1
                             ? Slab<Complex>(complex, critical_vertices)
                             : Slab<Complex>(complex, critical_vertices, surface.slabs_of_vertices, surface.inside(),
                                             {levels.level(Side::LOWER), levels.level(Side::UPPER)});
  return {find_arcs_of_slab(Threads(), slab, order, method, report),
          {levels.number_of_contours(Side::LOWER), levels.number_of_contours(Side::UPPER)}};
}

} // namespace CGAL::Reeb_graph::internal

#endif // CGAL_REEB_GRAPH_DISTRIBUTED_INTERNAL_SOLVE_SLAB_H
