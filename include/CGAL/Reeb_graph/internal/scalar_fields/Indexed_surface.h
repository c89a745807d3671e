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

#include <CGAL/Reeb_graph/fields/exceptions.h>
#include <CGAL/Reeb_graph/internal/base/Index.h>
#include <CGAL/Reeb_graph/internal/base/Indexed_vector.h>
#include <CGAL/Reeb_graph/internal/base/point_map.h>
#include <CGAL/Reeb_graph/internal/base/requirements.h>
#include <CGAL/Reeb_graph/internal/mesh/Descriptor_positions.h>
#include <CGAL/Reeb_graph/internal/mesh/Surface_mesh_complex.h>
#include <CGAL/Reeb_graph/internal/mesh/Triangle_complex.h>
#include <CGAL/Reeb_graph/internal/mesh/Unchecked_complex.h>
#include <CGAL/Reeb_graph/internal/mesh/Vertex_order.h>
#include <CGAL/Reeb_graph/internal/mesh/flatten.h>
#include <CGAL/Reeb_graph/internal/mesh/mesh_indices.h>
#include <CGAL/Reeb_graph/internal/mesh/read_halfedges.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/boost/graph/named_params_helper.h>
#include <CGAL/boost/graph/properties.h>
#include <CGAL/number_utils.h>
#include <CGAL/tags.h>

#include <boost/graph/graph_traits.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Reeb_graph {
namespace internal {
namespace scalar_fields {

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

// A mesh as the fields see it: a triangle complex, checked as that of a Reeb graph is, as a list of its triangles, and
// the points. These are divided by `scale`, a power of two, so that products of a few coordinates neither overflow nor
// vanish.
template <class FaceListGraph>
class Indexed_surface
{
public:
  typedef FaceListGraph Mesh;
  typedef typename Descriptors<Mesh>::vertex_descriptor vertex_descriptor;
  typedef typename Descriptors<Mesh>::face_descriptor face_descriptor;
  typedef Indexed_vector<Vertex_index, vertex_descriptor> Vertex_handles;
  typedef Indexed_vector<Face_index, face_descriptor> Face_handles;

  template <class NamedParameters>
  Indexed_surface(const FaceListGraph& mesh, const NamedParameters& np)
    : vertices_(vertices(mesh).first, vertices(mesh).second),
      faces_(faces(mesh).first, faces(mesh).second),
      positions_(make_vertex_positions(mesh, vertices_, parameters::default_values()))
  {
    checked_index(vertices_.size());
    read_points(choose_point_map(mesh, np));
    read_triangles(mesh);
  }

  Position number_of_vertices() const { return static_cast<Position>(vertices_.size()); }
  vertex_descriptor vertex_handle(std::size_t v) const { return vertices_[Vertex_index(v)]; }
  const Vertex_handles& vertex_handles() const { return vertices_; }
  face_descriptor face_handle(std::size_t triangle) const { return faces_[Face_index(triangle)]; }
  const Face_handles& face_handles() const { return faces_; }
  const std::vector<Indexed_triangle>& triangles() const { return triangles_; }

  const Vector& point(Position v) const { return points_[v]; }
  double scale() const { return scale_; }

  // The length of an edge between two vertices, for the points divided by scale(). All edges can be made longer, by the
  // same length; the points stay.
  double edge_length(Position u, Position v) const { return length(point(v) - point(u)) + added_length_; }
  double added_length() const { return added_length_; }
  void set_added_length(double added_length) { added_length_ = added_length; }

  // The position of a vertex, no_position if it is not one of the mesh.
  Position position(vertex_descriptor v) const
  {
    if(v == boost::graph_traits<Mesh>::null_vertex())
      return no_position;
    const Vertex_index position = positions_(v);
    return vertices_.contains(position) && vertices_[position] == v ? position.number() : no_position;
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

  // The third coordinates of the vertices by the numbers that they have in a complex.
  template <class NumberOfPosition>
  Indexed_vector<Vertex_index, double> find_heights(std::size_t size, const NumberOfPosition& number) const
  {
    Indexed_vector<Vertex_index, double> heights(size, 0.);
    for(const Vertex_index v : vertices_.keys())
      heights[number(v)] = points_[v.number()][2];
    return heights;
  }

  template <class Graph>
  void read_triangles(const Graph& mesh)
  {
    read_triangles_of_copy(mesh);
  }

  template <class Graph>
  void read_triangles_of_copy(const Graph& mesh)
  {
    auto read = read_halfedges(mesh, faces_, vertices_.size(), positions_,
                               make_face_positions(mesh, faces_, parameters::default_values()));
    const auto heights = find_heights(vertices_.size(), [](Vertex_index v) { return v; });
    const Triangle_complex complex = check_complex<Sequential_tag>(
      Unchecked_complex<Triangle_complex>(Triangle_complex(std::move(read.arrays), faces_.size())),
      Vertex_order(heights, std::less<double>()));
    triangles_.reserve(faces_.size());
    for(const auto& [a, b, c] : read.halfedges_of_faces)
      triangles_.push_back(
        {{complex.source(a).number(), complex.source(b).number(), complex.source(c).number()},
         {complex.is_on_border_edge(a), complex.is_on_border_edge(b), complex.is_on_border_edge(c)}});
  }

  // A Surface_mesh is checked as it is, without a copy of its halfedges, unless a face contradicts itself.
  template <class Point>
  void read_triangles(const Surface_mesh<Point>& mesh)
  {
    const auto heights = find_heights(mesh.num_vertices(), [&](Vertex_index v) { return Vertex_index(vertices_[v]); });
    check_complex<Sequential_tag>(Unchecked_complex(Surface_mesh_complex<Point>(mesh)),
                                  Vertex_order(heights, std::less<double>()));
    const auto is_misled = [&](face_descriptor f) {
      const auto a = mesh.halfedge(f), b = mesh.next(a), c = mesh.prev(a);
      const auto u = mesh.source(a), v = mesh.source(b), w = mesh.source(c);
      return mesh.face(a) != f || mesh.target(a) != v || mesh.target(b) != w || mesh.target(c) != u || u == v || v == w
          || w == u;
    };
    if(std::any_of(faces_.begin(), faces_.end(), is_misled))
      return read_triangles_of_copy(mesh);
    triangles_.reserve(faces_.size());
    for(const face_descriptor f : faces_)
    {
      const auto a = mesh.halfedge(f), b = mesh.next(a), c = mesh.prev(a);
      const auto source = [&](auto h) { return positions_(mesh.source(h)).number(); };
      const auto is_on_border_edge = [&](auto h) { return mesh.is_border(mesh.opposite(h)); };
      triangles_.push_back(
        {{source(a), source(b), source(c)}, {is_on_border_edge(a), is_on_border_edge(b), is_on_border_edge(c)}});
    }
  }

  Vertex_handles vertices_;
  Face_handles faces_;
  decltype(make_vertex_positions(std::declval<const FaceListGraph&>(),
                                 std::declval<const Vertex_handles&>(),
                                 parameters::default_values())) positions_;
  std::vector<Vector> points_;
  std::vector<Indexed_triangle> triangles_;
  double scale_ = 1, added_length_ = 0;
};

} // namespace scalar_fields
} // namespace internal
} // namespace Reeb_graph
} // namespace CGAL

#endif // CGAL_REEB_GRAPH_INTERNAL_SCALAR_FIELDS_INDEXED_SURFACE_H
