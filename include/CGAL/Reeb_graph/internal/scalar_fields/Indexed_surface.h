// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of the CGAL-style package Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_INTERNAL_SCALAR_FIELDS_INDEXED_SURFACE_H
#define CGAL_REEB_GRAPH_INTERNAL_SCALAR_FIELDS_INDEXED_SURFACE_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/exceptions.h>
#include <CGAL/Reeb_graph/fields/exceptions.h>
#include <CGAL/Reeb_graph/internal/mesh/Descriptor_positions.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/boost/graph/iterator.h>
#include <CGAL/boost/graph/named_params_helper.h>
#include <CGAL/boost/graph/properties.h>
#include <CGAL/number_utils.h>

#include <boost/graph/graph_traits.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Reeb_graph {
namespace internal {
namespace scalar_fields {

typedef std::uint32_t Position; // of a vertex in vertices(mesh)
inline constexpr Position no_position = (std::numeric_limits<Position>::max)();

typedef std::array<double, 3> Vector;

inline Vector operator-(const Vector& a, const Vector& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
inline Vector operator+(const Vector& a, const Vector& b) { return {a[0] + b[0], a[1] + b[1], a[2] + b[2]}; }
inline Vector operator*(double s, const Vector& a) { return {s * a[0], s * a[1], s * a[2]}; }
inline double dot(const Vector& a, const Vector& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
inline double length(const Vector& a) { return std::sqrt(dot(a, a)); }
inline Vector cross(const Vector& a, const Vector& b)
{
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

// The vertices of a triangle, and for each i whether the edge from corner i to corner i + 1 is on the border.
struct Indexed_triangle
{
  std::array<Position, 3> vertices;
  std::array<bool, 3> is_on_border;
};

// A mesh as flat arrays, checked once. The points are divided by `scale`, a power of two, so that products of a few
// coordinates neither overflow nor vanish.
template <class FaceListGraph>
class Indexed_surface
{
public:
  typedef boost::graph_traits<FaceListGraph> Graph_traits;
  typedef typename Graph_traits::vertex_descriptor vertex_descriptor;
  typedef typename Graph_traits::face_descriptor face_descriptor;

  template <class NamedParameters>
  Indexed_surface(const FaceListGraph& mesh, const NamedParameters& np)
    : vertices_(vertices(mesh).first, vertices(mesh).second),
      faces_(faces(mesh).first, faces(mesh).second),
      positions_(make_vertex_positions(mesh, vertices_, parameters::default_values()))
  {
    if(vertices_.size() >= no_position || faces_.size() >= no_position / 3)
      throw Mesh_size_error();
    read_points(parameters::choose_parameter(parameters::get_parameter(np, internal_np::vertex_point),
                                             get_const_property_map(CGAL::vertex_point, mesh)));
    read_triangles(mesh);
    check_fans(mesh);
  }

  Position number_of_vertices() const { return static_cast<Position>(vertices_.size()); }
  const std::vector<vertex_descriptor>& vertex_handles() const { return vertices_; }
  const std::vector<face_descriptor>& face_handles() const { return faces_; }
  const std::vector<Indexed_triangle>& triangles() const { return triangles_; }

  const Vector& point(Position v) const { return points_[v]; }
  double scale() const { return scale_; }

  // no_position if `v` is not a vertex of the mesh
  Position position(vertex_descriptor v) const
  {
    if(v == Graph_traits::null_vertex())
      return no_position;
    const Position position = positions_(v);
    return position < vertices_.size() && vertices_[position] == v ? position : no_position;
  }

private:
  template <class VertexPointMap>
  void read_points(const VertexPointMap& point_map)
  {
    points_.reserve(vertices_.size());
    double largest = 0;
    for(const vertex_descriptor v : vertices_)
    {
      const auto& p = get(point_map, v);
      points_.push_back({CGAL::to_double(p.x()), CGAL::to_double(p.y()), CGAL::to_double(p.z())});
      for(const double coordinate : points_.back())
      {
        if(!std::isfinite(coordinate))
          throw Non_finite_point_error(points_.size() - 1);
        largest = (std::max)(largest, std::abs(coordinate));
      }
    }
    if(largest > 0)
      scale_ = std::ldexp(1., (std::max)(std::ilogb(largest), -1000));
    for(Vector& p : points_)
      p = {p[0] / scale_, p[1] / scale_, p[2] / scale_};
  }

  void read_triangles(const FaceListGraph& mesh)
  {
    triangles_.reserve(faces_.size());
    for(const face_descriptor f : faces_)
    {
      const auto h = halfedge(f, mesh), h1 = next(h, mesh), h2 = next(h1, mesh);
      if(h1 == h || h2 == h || next(h2, mesh) != h)
        throw Non_triangular_face_error(triangles_.size());
      const Position a = positions_[source(h, mesh)], b = positions_[source(h1, mesh)];
      const Position c = positions_[source(h2, mesh)];
      if(a == b || b == c || c == a)
        throw Degenerate_face_error(triangles_.size());
      triangles_.push_back({{a, b, c},
                            {is_border(opposite(h, mesh), mesh), is_border(opposite(h1, mesh), mesh),
                             is_border(opposite(h2, mesh), mesh)}});
    }
  }

  // A vertex whose faces form several fans would be a cut vertex, beyond which a field has an extremum of necessity.
  void check_fans(const FaceListGraph& mesh) const
  {
    std::vector<Position> unseen(vertices_.size(), 0);
    for(const Indexed_triangle& t : triangles_)
      for(const Position v : t.vertices)
        ++unseen[v];
    for(std::size_t i = 0; i != vertices_.size(); ++i)
    {
      if(unseen[i] == 0)
        continue;
      int number_of_gaps = 0;
      for(const auto h : halfedges_around_target(halfedge(vertices_[i], mesh), mesh))
        if(is_border(h, mesh))
          ++number_of_gaps;
        else
          --unseen[i];
      if(unseen[i] != 0 || number_of_gaps > 1)
        throw Non_manifold_vertex_error(i);
    }
  }

  std::vector<vertex_descriptor> vertices_;
  std::vector<face_descriptor> faces_;
  decltype(make_vertex_positions(std::declval<const FaceListGraph&>(),
                                 std::declval<const std::vector<vertex_descriptor>&>(),
                                 parameters::default_values())) positions_;
  std::vector<Vector> points_;
  std::vector<Indexed_triangle> triangles_;
  double scale_ = 1;
};

} // namespace scalar_fields
} // namespace internal
} // namespace Reeb_graph
} // namespace CGAL

#endif // CGAL_REEB_GRAPH_INTERNAL_SCALAR_FIELDS_INDEXED_SURFACE_H
