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
#include <CGAL/Reeb_graph/distributed/internal/Slab_surface.h>
#include <CGAL/Reeb_graph/internal/base/Index.h>
#include <CGAL/Reeb_graph/internal/base/arrays.h>
#include <CGAL/Reeb_graph/internal/complex/Simplicial_complex.h>
#include <CGAL/Reeb_graph/internal/complex/surface_complexes.h>
#include <CGAL/Reeb_graph/internal/engine/Between_stages.h>
#include <CGAL/Reeb_graph/internal/engine/classify_vertices.h>
#include <CGAL/Reeb_graph/internal/engine/find_arcs.h>
#include <CGAL/Reeb_graph/internal/engine/slabs.h>
#include <CGAL/Reeb_graph/internal/engine/stages_of_complexes.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL::Reeb_graph::internal {

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
  template <class Complex, class Scalar>
  Levels_of_rank(const Complex& complex, const Slab_surface<Scalar>& surface)
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
template <class Complex, class Scalar, class Order>
Classified_complex<Complex> make_and_classify(Slab_surface<Scalar>& surface, const Order& order)
{
  if constexpr(Complex::is_surface)
  {
    const std::size_t number_of_faces = surface.triangles.size();
    Halfedge_arrays arrays = Triangle_linking(std::move(surface.triangles), surface.global_vertices)();
    arrays.is_inside.reserve(surface.slabs_of_vertices.size());
    for(const Slab_index slab : surface.slabs_of_vertices)
      arrays.is_inside.push_back(slab == surface.inside());
    arrays.positions = &surface.global_vertices;
    return check_and_classify_vertices<Sequential_tag>(
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
      find_vertices_of_complex<Sequential_tag>(complex, order, [&](Vertex_index v, const By_side<Index>& numbers) {
        return surface.slabs_of_vertices[v] == surface.inside() && has_critical_numbers_of_sectors(numbers);
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
template <class Scalar, class Complex, class Order, class ChosenMethod, class Report>
Arcs_of_slab solve_slab(const Slab_surface<Scalar>& surface,
                        const Classified_complex<Complex>& classified,
                        const Order& order,
                        ChosenMethod method,
                        const Report& report)
{
  const auto& [complex, critical_vertices] = classified;
  const Levels_of_rank levels(complex, surface);
  const Slab<Complex> slab = surface.number_of_slabs == 1
                             ? Slab<Complex>(complex, critical_vertices)
                             : Slab<Complex>(complex, critical_vertices, surface.slabs_of_vertices, surface.inside(),
                                             {levels.level(Side::LOWER), levels.level(Side::UPPER)});
  return {find_arcs_of_slab<Sequential_tag>(slab, order, method, report),
          {levels.number_of_contours(Side::LOWER), levels.number_of_contours(Side::UPPER)}};
}

} // namespace CGAL::Reeb_graph::internal

#endif // CGAL_REEB_GRAPH_DISTRIBUTED_INTERNAL_SOLVE_SLAB_H
