// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of the CGAL-style package Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_FIELDS_INTERNAL_INDEXED_SURFACE_H
#define CGAL_REEB_GRAPH_FIELDS_INTERNAL_INDEXED_SURFACE_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/fields/exceptions.h>
#include <CGAL/Reeb_graph/internal/base/Index.h>
#include <CGAL/Reeb_graph/internal/base/arrays.h>
#include <CGAL/Reeb_graph/internal/base/named_parameter.h>
#include <CGAL/Reeb_graph/internal/base/requirements.h>
#include <CGAL/Reeb_graph/internal/complex/descriptor_lists.h>
#include <CGAL/Reeb_graph/internal/complex/flatten.h>
#include <CGAL/Reeb_graph/internal/complex/surface_complexes.h>
#include <CGAL/Reeb_graph_traits.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/boost/graph/helpers.h>
#include <CGAL/boost/graph/named_params_helper.h>
#include <CGAL/boost/graph/properties.h>
#include <CGAL/number_utils.h>
#include <CGAL/tags.h>

#include <boost/graph/graph_traits.hpp>
#include <boost/property_map/function_property_map.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL::Reeb_graph::internal::scalar_fields {

// The position of a vertex in vertices(mesh).
typedef Number Position;
inline constexpr Position no_position = no_index;

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

// The vector of unit length, or zero. Not even gradients whose squares are beyond the range of numbers are lost.
inline Vector normalized(const Vector& vector)
{
  const double largest = (std::max)({std::abs(vector[0]), std::abs(vector[1]), std::abs(vector[2])});
  if(!(largest > 0))
    return {0, 0, 0};
  const Vector scaled = {vector[0] / largest, vector[1] / largest, vector[2] / largest};
  return (1 / length(scaled)) * scaled;
}

// The vertices of a triangle, and for each i whether the edge from corner i to corner i + 1 is on the border.
struct Indexed_triangle
{
  std::array<Position, 3> vertices;
  std::array<bool, 3> is_on_border;
};

// A surface as the solvers of fields see it: the triangles, and the points. These are divided by `scale`, a power of two,
// so that products of a few coordinates neither overflow nor vanish.
class Indexed_surface
{
public:
  Position number_of_vertices() const { return static_cast<Position>(points_.size()); }
  const std::vector<Indexed_triangle>& triangles() const { return triangles_; }

  const Vector& point(Position v) const { return points_[v]; }
  double scale() const { return scale_; }

  // The length of an edge between two vertices, for the points divided by scale(). All edges can be made longer, by the
  // same length; the points stay.
  double edge_length(Position u, Position v) const { return length(point(v) - point(u)) + added_length_; }
  double added_length() const { return added_length_; }
  void set_added_length(double added_length) { added_length_ = added_length; }

protected:
  Indexed_surface() = default;

  void set_points(std::vector<Vector> points)
  {
    points_ = std::move(points);
    double largest = 0;
    for(std::size_t v = 0; v != points_.size(); ++v)
      for(const double coordinate : points_[v])
      {
        if(!std::isfinite(coordinate))
          throw Non_finite_point_error(v);
        largest = (std::max)(largest, std::abs(coordinate));
      }
    if(largest > 0)
      scale_ = std::ldexp(1., (std::max)(std::ilogb(largest), -1000));
    for(Vector& p : points_)
      p = {p[0] / scale_, p[1] / scale_, p[2] / scale_};
  }

  void add_triangle(const std::array<Position, 3>& vertices, const std::array<bool, 3>& is_on_border)
  {
    triangles_.push_back({vertices, is_on_border});
  }

private:
  std::vector<Vector> points_;
  std::vector<Indexed_triangle> triangles_;
  double scale_ = 1, added_length_ = 0;
};

// The surface of a mesh, checked as that of a Reeb graph is, and the way from positions to descriptors and back.
template <class FaceListGraph>
class Indexed_mesh : public Indexed_surface
{
public:
  typedef FaceListGraph Mesh;
  typedef typename Descriptors<Mesh>::vertex_descriptor vertex_descriptor;
  typedef typename Descriptors<Mesh>::halfedge_descriptor halfedge_descriptor;
  typedef typename Descriptors<Mesh>::face_descriptor face_descriptor;
  typedef Indexed_vector<Vertex_index, vertex_descriptor> Vertex_handles;
  typedef Indexed_vector<Face_index, face_descriptor> Face_handles;

  template <class NamedParameters>
  Indexed_mesh(const FaceListGraph& mesh, const NamedParameters& np)
    : vertices_(vertices(mesh).first, vertices(mesh).second),
      faces_(faces(mesh).first, faces(mesh).second),
      positions_(make_vertex_positions(mesh, vertices_, parameters::default_values()))
  {
    checked_index(vertices_.size());
    const auto point_map = choose_point_map(mesh, np);
    std::vector<Vector> points;
    points.reserve(vertices_.size());
    for(const vertex_descriptor v : vertices_)
    {
      const auto& p = get(point_map, v);
      points.push_back({CGAL::to_double(p.x()), CGAL::to_double(p.y()), CGAL::to_double(p.z())});
    }
    set_points(std::move(points));
    check(mesh);
    for(const face_descriptor f : faces_)
      read_triangle(mesh, f, halfedge(f, mesh));
  }

  vertex_descriptor vertex_handle(std::size_t v) const { return vertices_[Vertex_index(v)]; }
  const Vertex_handles& vertex_handles() const { return vertices_; }
  face_descriptor face_handle(std::size_t triangle) const { return faces_[Face_index(triangle)]; }
  const Face_handles& face_handles() const { return faces_; }

  // The position of a vertex, no_position if it is not one of the mesh.
  Position position(vertex_descriptor v) const
  {
    if(v == boost::graph_traits<Mesh>::null_vertex())
      return no_position;
    const Vertex_index position = positions_(v);
    return vertices_.contains(position) && vertices_[position] == v ? position.number() : no_position;
  }

private:
  // Any field will do.
  void check(const FaceListGraph& mesh) const
  {
    const auto heights = boost::make_function_property_map<vertex_descriptor>(
      [&](vertex_descriptor v) { return point(positions_(v).number())[2]; });
    const Reeb_graph_traits<FaceListGraph, std::decay_t<decltype(heights)>> traits;
    flatten<Sequential_tag>(mesh, heights, traits, parameters::default_values());
  }

  // A Surface_mesh is checked by its halfedges. They need not be those that its faces have.
  void read_triangle(const FaceListGraph& mesh, face_descriptor f, halfedge_descriptor a)
  {
    const halfedge_descriptor b = next(a, mesh), c = prev(a, mesh);
    const auto position_of = [&](halfedge_descriptor h) { return positions_(source(h, mesh)).number(); };
    const auto is_on_border_edge = [&](halfedge_descriptor h) { return is_border(opposite(h, mesh), mesh); };
    if(face(a, mesh) != f)
    {
      check_faces(mesh);
      throw Non_manifold_vertex_error(position_of(a));
    }
    add_triangle({position_of(a), position_of(b), position_of(c)},
                 {is_on_border_edge(a), is_on_border_edge(b), is_on_border_edge(c)});
  }

  Vertex_handles vertices_;
  Face_handles faces_;
  decltype(make_vertex_positions(std::declval<const FaceListGraph&>(),
                                 std::declval<const Vertex_handles&>(),
                                 parameters::default_values())) positions_;
};

} // namespace CGAL::Reeb_graph::internal::scalar_fields

#endif // CGAL_REEB_GRAPH_FIELDS_INTERNAL_INDEXED_SURFACE_H
