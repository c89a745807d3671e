// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_FIELDS_INTERNAL_INTRINSIC_TRIANGULATION_H
#define CGAL_REEB_GRAPH_FIELDS_INTERNAL_INTRINSIC_TRIANGULATION_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/fields/internal/Indexed_surface.h>
#include <CGAL/Reeb_graph/internal/base/Index.h>
#include <CGAL/Reeb_graph/internal/base/Progress.h>
#include <CGAL/Reeb_graph/internal/complex/Flat_mesh.h>
#include <CGAL/Reeb_graph/internal/complex/Weighted_graph.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::Reeb_graph::internal::scalar_fields {

// The point, above the x-axis, at these distances from the origin and from the point (base, 0).
inline std::pair<double, double> place_above(double base, double from_origin, double from_end)
{
  const double x = (base + (from_origin - from_end) * ((from_origin + from_end) / base)) / 2;
  return {x, std::sqrt((std::max)((from_origin - x) * (from_origin + x), 0.))};
}

// Triangles on a surface that are known by the lengths of their sides only: at first those of the surface. Its edges are
// straight on the surface, not in space. A vertex can be twice in a triangle.
class Intrinsic_triangulation
{
public:
  // Halfedge 3 t + i is the one from corner i to corner i + 1 of triangle t.
  typedef Index Halfedge;

  struct Edge
  {
    Index source, target;
    double length;
  };

  // `opposites` has no_index on the border.
  Intrinsic_triangulation(const Indexed_surface& surface, const std::vector<Halfedge>& opposites)
    : number_of_vertices_(surface.number_of_vertices()),
      records_(checked_index(3 * surface.triangles().size())),
      is_new_(records_.size(), false)
  {
    for(Halfedge h = 0; h != records_.size(); ++h)
    {
      const auto& corners = surface.triangles()[h / 3].vertices;
      const Index v = corners[h % 3], w = corners[(h + 1) % 3];
      records_[h] = {v, opposites[h], surface.edge_length(v, w)};
    }
  }

  Index number_of_vertices() const { return number_of_vertices_; }
  Index number_of_halfedges() const { return static_cast<Index>(records_.size()); }

  static Halfedge next(Halfedge h) { return h % 3 == 2 ? h - 2 : h + 1; }
  static Halfedge previous(Halfedge h) { return h % 3 == 0 ? h + 2 : h - 1; }
  Halfedge opposite(Halfedge h) const { return records_[h].opposite; }
  Index source(Halfedge h) const { return records_[h].source; }
  double length(Halfedge h) const { return records_[h].length; }

  // Flips edges until none of them faces angles of more than 180 degrees together: A. I. Bobenko and B. A. Springborn,
  // A Discrete Laplace-Beltrami Operator for Simplicial Surfaces, 2007. Any triangulation will do for who calls this, so
  // it also ends where rounding would let it go on, or where the edges are very many times as long as wide triangles.
  void make_delaunay(const Stage_progress& progress)
  {
    constexpr std::size_t flips_per_halfedge = 16;
    std::size_t left = flips_per_halfedge * records_.size();
    std::vector<Halfedge> stack;
    for(Halfedge first = 0; first != number_of_halfedges(); ++first)
    {
      progress.report_step(first, number_of_halfedges());
      for(stack.push_back(first); !stack.empty();)
      {
        const Halfedge h = stack.back();
        stack.pop_back();
        if(left == 0 || !is_to_be_flipped(h) || !flip(h))
          continue;
        --left;
        const Halfedge g = opposite(h);
        stack.insert(stack.end(), {next(h), previous(h), next(g), previous(g)});
      }
    }
  }

  // The edges of the surface that have been flipped away.
  const std::vector<Edge>& flipped_edges() const { return flipped_edges_; }

private:
  struct Record
  {
    Index source;
    Halfedge opposite;
    double length;
  };

  // The angle that a triangle has opposite to a halfedge, by its sine and cosine times the product of its sides.
  struct Scaled_angle
  {
    double sine, cosine, product;
  };

  Scaled_angle opposite_angle(Halfedge h) const
  {
    const double side = length(h), a = length(next(h)), b = length(previous(h));
    // Heron's formula as W. Kahan has it, without cancellation
    std::array<double, 3> s = {side, a, b};
    std::sort(s.begin(), s.end());
    const double square =
      (s[2] + (s[1] + s[0])) * (s[0] - (s[2] - s[1])) * (s[0] + (s[2] - s[1])) * (s[2] + (s[1] - s[0]));
    return {std::sqrt((std::max)(square, 0.)) / 2, (a * a + (b - side) * (b + side)) / 2, a * b};
  }

  bool is_to_be_flipped(Halfedge h) const
  {
    constexpr double least_sine = 1e-10;
    const Halfedge g = opposite(h);
    if(g == no_index || g / 3 == h / 3 || (is_acute(h) && is_acute(g)))
      return false;
    const Scaled_angle a = opposite_angle(h), b = opposite_angle(g);
    return a.sine * b.cosine + a.cosine * b.sine < -least_sine * a.product * b.product;
  }

  bool is_acute(Halfedge h) const
  {
    const double side = length(h), a = length(next(h)), b = length(previous(h));
    return a * a + b * b >= side * side;
  }

  // Returns whether it has flipped the edge: not if its new length is no number, or makes triangles that are none.
  bool flip(Halfedge h)
  {
    const Halfedge g = opposite(h);
    const auto [x, y] = place_above(length(h), length(previous(h)), length(next(h)));
    const auto [u, v] = place_above(length(h), length(next(g)), length(previous(g)));
    const double new_length = std::hypot(x - u, y + v);
    if(!(new_length > 0) || !std::isfinite(new_length))
      return false;
    if(!is_new_[h])
      flipped_edges_.push_back({source(h), source(g), length(h)});
    // The new triangles are h, previous(h), next(g), and g, previous(g), next(h).
    const std::array<Halfedge, 4> old_places = {previous(h), next(g), previous(g), next(h)};
    const std::array<Halfedge, 4> new_places = {next(h), previous(h), next(g), previous(g)};
    const Index end_of_g = source(previous(g)), end_of_h = source(previous(h));
    std::array<Record, 4> moved;
    std::array<bool, 4> is_new;
    for(std::size_t i = 0; i != 4; ++i)
    {
      moved[i] = records_[old_places[i]];
      is_new[i] = is_new_[old_places[i]];
    }
    for(std::size_t i = 0; i != 4; ++i)
    {
      const auto among_old = std::find(old_places.begin(), old_places.end(), moved[i].opposite);
      if(among_old != old_places.end())
        moved[i].opposite = new_places[static_cast<std::size_t>(among_old - old_places.begin())];
      else if(moved[i].opposite != no_index)
        records_[moved[i].opposite].opposite = new_places[i];
      records_[new_places[i]] = moved[i];
      is_new_[new_places[i]] = is_new[i];
    }
    records_[h] = {end_of_g, g, new_length};
    records_[g] = {end_of_h, h, new_length};
    is_new_[h] = is_new_[g] = true;
    return true;
  }

  Index number_of_vertices_;
  std::vector<Record> records_; // of halfedges
  std::vector<bool> is_new_;    // for halfedges that have come by a flip
  std::vector<Edge> flipped_edges_;
};

// The opposite halfedges of an Intrinsic_triangulation of the surface of a mesh.
template <class FaceListGraph>
std::vector<Intrinsic_triangulation::Halfedge> find_opposites(const FaceListGraph& mesh,
                                                              const Indexed_mesh<FaceListGraph>& surface)
{
  typedef Intrinsic_triangulation::Halfedge Halfedge;
  const auto& complex = surface.flat_mesh().complex;
  const auto for_each_side = [&](const auto& visit) {
    for_each_face(mesh, surface.flat_mesh(), [&](Halfedge_index a) {
      for(const Halfedge_index side : {a, complex.next(a), complex.previous(a)})
        visit(side);
    });
  };
  Indexed_vector<Halfedge_index, Halfedge> numbers(complex.number_of_halfedges(), no_index);
  Halfedge number_of_sides = 0;
  for_each_side([&](Halfedge_index side) { numbers[side] = number_of_sides++; });
  std::vector<Halfedge> opposites;
  opposites.reserve(number_of_sides);
  for_each_side([&](Halfedge_index side) { opposites.push_back(numbers[opposite_of(side)]); });
  return opposites;
}

} // namespace CGAL::Reeb_graph::internal::scalar_fields

#endif // CGAL_REEB_GRAPH_FIELDS_INTERNAL_INTRINSIC_TRIANGULATION_H
