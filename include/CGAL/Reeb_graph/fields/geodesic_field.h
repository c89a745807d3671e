// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_FIELDS_GEODESIC_FIELD_H
#define CGAL_REEB_GRAPH_FIELDS_GEODESIC_FIELD_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/fields/internal/Indexed_surface.h>
#include <CGAL/Reeb_graph/fields/internal/constraints.h>
#include <CGAL/Reeb_graph/fields/internal/laplacian_graph.h>
#include <CGAL/Reeb_graph/internal/base/Buckets.h>
#include <CGAL/Reeb_graph/internal/base/Index.h>
#include <CGAL/Reeb_graph/internal/base/Progress.h>
#include <CGAL/Reeb_graph/internal/base/lengths.h>
#include <CGAL/Reeb_graph/internal/base/requirements.h>
#include <CGAL/Reeb_graph/internal/complex/Flat_mesh.h>
#include <CGAL/Reeb_graph/internal/complex/Weighted_graph.h>
#include <CGAL/Reeb_graph/options.h>

#include <CGAL/Named_function_parameters.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <limits>
#include <queue>
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
    const double new_length = length_of(x - u, y + v, 0);
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

// Distances from the sources that grow from vertex to vertex, as those of Dijkstra's algorithm, along the edges and
// straight through the triangles (M. Novotni and R. Klein, Computing Geodesic Distances on Triangular Meshes, 2002).
// A way may bend at each vertex, and each vertex knows where that to it has last done so, its origin. Each vertex of a
// component with a source gets a finite distance. Vertices get theirs in ascending order, so that along an edge, of the
// surface or of the triangulation, they differ by no more than its length. None is less than that in space.
class Geodesic_distances
{
public:
  Geodesic_distances(const Indexed_surface& surface, const Intrinsic_triangulation& triangulation)
    : surface_(surface),
      triangulation_(triangulation),
      outgoing_(surface.number_of_vertices(), no_index),
      flipped_edges_(surface.number_of_vertices(),
                     [&](const auto& visit) {
                       for(const auto& e : triangulation.flipped_edges())
                       {
                         visit(Vertex_index(e.source), End{e.target, e.length});
                         visit(Vertex_index(e.target), End{e.source, e.length});
                       }
                     }),
      distances_(surface.number_of_vertices(), std::numeric_limits<double>::infinity()),
      origins_(surface.number_of_vertices(), no_index),
      is_final_(surface.number_of_vertices(), false)
  {
    for(Halfedge h = 0; h != triangulation.number_of_halfedges(); ++h)
    {
      Halfedge& outgoing = outgoing_[triangulation.source(h)];
      if(outgoing == no_index || triangulation.opposite(h) == no_index)
        outgoing = h;
    }
  }

  // The distances from the sources, for the points divided by surface.scale(): infinite where there is no source.
  std::vector<double> operator()(const std::vector<bool>& is_source, const Stage_progress& progress)
  {
    for(Index v = 0; v != surface_.number_of_vertices(); ++v)
      if(is_source[v])
        reach(v, 0, v);
    for(std::size_t step = 0; !queue_.empty();)
    {
      const Index v = queue_.top().second;
      queue_.pop();
      if(is_final_[v])
        continue;
      progress.report_step(step++, surface_.number_of_vertices());
      is_final_[v] = true;
      leave(v);
    }
    return std::move(distances_);
  }

private:
  typedef Intrinsic_triangulation::Halfedge Halfedge;
  typedef std::pair<double, Index> Entry;

  struct End
  {
    Index vertex;
    double length;
  };

  // Reaches the neighbors of a vertex that has just got its distance.
  void leave(Index v)
  {
    for(const End& end : flipped_edges_[Vertex_index(v)])
      reach(end.vertex, distances_[v] + end.length, v);
    // counterclockwise, at a border vertex from border to border
    const Halfedge first = outgoing_[v];
    for(Halfedge h = first; h != no_index;)
    {
      cross_triangle(h);
      h = triangulation_.opposite(triangulation_.previous(h));
      if(h == first)
        break;
    }
  }

  // Reaches the other corners of a triangle from the source of one of its halfedges.
  void cross_triangle(Halfedge h)
  {
    const Halfedge next = triangulation_.next(h), previous = triangulation_.previous(h);
    const Index v = triangulation_.source(h), a = triangulation_.source(next), b = triangulation_.source(previous);
    const double va = triangulation_.length(h), ab = triangulation_.length(next), bv = triangulation_.length(previous);
    reach(a, distances_[v] + va, v);
    reach(b, distances_[v] + bv, v);
    if(is_final_[a] && !is_final_[b])
      reach_through(v, a, va, b, bv, ab);
    if(is_final_[b] && !is_final_[a])
      reach_through(v, b, bv, a, va, ab);
  }

  // Reaches c through the edge from v, the last vertex with a distance, to a: straight from the one point in the plane
  // of the triangle, beyond the edge, that has the right distances from both, if there is one.
  void reach_through(Index v, Index a, double va, Index c, double vc, double ac)
  {
    const Index origin_of_v = origins_[a] == v ? v : origins_[v], origin_of_a = origins_[v] == a ? a : origins_[a];
    const Index origin = common_origin(origin_of_v, origin_of_a);
    const double offset = origin == no_index ? 0 : distances_[origin];
    const double from_v = distances_[v] - offset, from_a = distances_[a] - offset;
    if(from_v + from_a < va)
      return;
    const auto [x_of_source, y_of_source] = place_above(va, from_v, from_a);
    const auto [x, y] = place_above(va, vc, ac);
    const double crossing = x_of_source + (x - x_of_source) * (y_of_source / (y_of_source + y));
    if(!(crossing >= 0 && crossing <= va))
      return;
    // The point is too near where ways from both sides meet.
    const double bound_of_v = bound(origin_of_v, c), bound_of_a = bound(origin_of_a, c);
    const double distance = offset + length_of(x - x_of_source, y + y_of_source, 0);
    reach(c, (std::max)({distance, (std::min)(bound_of_v, bound_of_a), distances_[v]}),
          origin != no_index ? origin : (bound_of_v < bound_of_a ? origin_of_v : origin_of_a));
  }

  // The origin that two of them have in common, if one is the other one's, or no_index.
  Index common_origin(Index a, Index b) const
  {
    if(a == b || origins_[a] == b)
      return b;
    return origins_[b] == a ? a : no_index;
  }

  // The length of no way by an origin is less.
  double bound(Index origin, Index v) const
  {
    return distances_[origin] + length(surface_.point(v) - surface_.point(origin));
  }

  void reach(Index v, double distance, Index origin)
  {
    if(is_final_[v] || !(distance < distances_[v]))
      return;
    distances_[v] = distance;
    origins_[v] = origin;
    queue_.push({distance, v});
  }

  const Indexed_surface& surface_;
  const Intrinsic_triangulation& triangulation_;
  std::vector<Halfedge> outgoing_; // of each vertex, at a border vertex from which all others come counterclockwise
  const Buckets<Vertex_index, End> flipped_edges_;
  std::vector<double> distances_;
  std::vector<Index> origins_;
  std::vector<bool> is_final_;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<Entry>> queue_;
};

} // namespace CGAL::Reeb_graph::internal::scalar_fields

namespace CGAL::Reeb_graph {

/// \ingroup PkgReebGraphFields
///
/// \brief computes the geodesic distance of each vertex from the nearest one of some source vertices.
///
/// A front marches from vertex to vertex, along the edges and straight through the triangles: \cgalCite{nk-cgdtm-02}.
/// Before, edges are flipped, on the surface, until the triangulation is Delaunay: \cgalCite{bs-dlboss-07}. So the
/// distances depend on the shape of the surface more than on that of its triangles, which may be long, or have no area.
/// They are estimates: Section \ref ReebGraph_other_fields of the manual has their errors. But no distance is less than
/// that in space from the nearest source, and along an edge they differ by no more than its length, both up to
/// rounding. Other than a harmonic field, the field can have extrema anywhere.
///
/// It takes \f$ O(n \log n) \f$ time for \f$ n \f$ vertices, for any number of sources, and \f$ O(n) \f$ memory.
///
/// \tparam FaceListGraph a model of `FaceListGraph`, with triangles as faces
/// \tparam FieldMap a model of `WritablePropertyMap` with the vertex descriptors of the mesh as key type, and a value
///         type that can be constructed from `double`
/// \tparam VertexRange a range of vertex descriptors
/// \tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"
///
/// \param mesh the triangulated surface; it is only read
/// \param field_map the result
/// \param sources the vertices at distance zero, at least one in each connected component
/// \param np `callback` and `vertex_point_map` as for `compute_harmonic_field()`
///
/// \reebGraphComplexity
///
/// \exception Unknown_vertex_error if a source is not a vertex of the mesh
/// \exception Unconstrained_component_error if a component has no source
/// \exception Non_finite_scalar_error if a distance is beyond the range of numbers
/// \exception Cancelled_error if `callback` returns `false`
///
/// and those for meshes that are not triangulated surfaces, see `compute_harmonic_field()`. When one of these is
/// thrown, `field_map` is as it was before.
template <class FaceListGraph,
          class FieldMap,
          class VertexRange,
          class NamedParameters = parameters::Default_named_parameters>
void compute_geodesic_field(const FaceListGraph& mesh,
                            FieldMap field_map,
                            const VertexRange& sources,
                            const NamedParameters& np = parameters::default_values())
{
  namespace fields = internal::scalar_fields;
  static_assert(internal::are_met<internal::Mesh_with_vertex_map<FaceListGraph, FieldMap>>);
  const internal::Progress progress(np);
  progress.report(0);
  fields::Indexed_mesh<FaceListGraph> surface(mesh, np);
  fields::Constraints<double> fixed(surface.number_of_vertices());
  for(const auto v : sources)
    fixed.fix(surface.dense_vertex(v), 0);
  fields::Intrinsic_triangulation triangulation(surface, fields::find_opposites(mesh, surface));
  triangulation.make_delaunay({progress, 0.1, 0.5});
  std::vector<double> distances =
    fields::Geodesic_distances(surface, triangulation)(fixed.is_fixed, {progress, 0.5, 0.95});
  if(std::find(distances.begin(), distances.end(), std::numeric_limits<double>::infinity()) != distances.end())
    fields::check_components(fields::laplacian_graph(surface, Laplacian_weights::UNIFORM), fixed.is_fixed);
  for(double& distance : distances)
    distance *= surface.scale();
  fields::write_field(surface, distances, field_map, progress);
}

} // namespace CGAL::Reeb_graph

#endif // CGAL_REEB_GRAPH_FIELDS_GEODESIC_FIELD_H
