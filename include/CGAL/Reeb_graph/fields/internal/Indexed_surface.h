// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_FIELDS_INTERNAL_INDEXED_SURFACE_H
#define CGAL_REEB_GRAPH_FIELDS_INTERNAL_INDEXED_SURFACE_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/exceptions.h>
#include <CGAL/Reeb_graph/internal/base/Index.h>
#include <CGAL/Reeb_graph/internal/base/arrays.h>
#include <CGAL/Reeb_graph/internal/base/requirements.h>
#include <CGAL/Reeb_graph/internal/complex/Flat_mesh.h>
#include <CGAL/Reeb_graph/internal/complex/Weighted_graph.h>
#include <CGAL/Reeb_graph/named_parameters.h>

#include <CGAL/Origin.h>
#include <CGAL/Simple_cartesian.h>

#include <boost/graph/graph_traits.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <memory>
#include <utility>
#include <vector>

namespace CGAL::Reeb_graph::internal::scalar_fields {

typedef Simple_cartesian<double>::Vector_3 Vector;

inline double length(const Vector& a) { return std::sqrt(a.squared_length()); }

// The vector of unit length, or zero. Not even gradients whose squares are beyond the range of numbers are lost.
inline Vector normalized(const Vector& vector)
{
  const double largest = (std::max)({std::abs(vector.x()), std::abs(vector.y()), std::abs(vector.z())});
  if(!(largest > 0))
    return NULL_VECTOR;
  const Vector scaled = vector / largest;
  return (1 / length(scaled)) * scaled;
}

// The vertices of a triangle, and for each i whether the edge from corner i to corner i + 1 is on the border.
struct Indexed_triangle
{
  std::array<Index, 3> vertices;
  std::array<bool, 3> is_on_border;
};

// A surface as the solvers of fields see it: the triangles, and the points. These are divided by `scale`, a power of two,
// so that products of a few coordinates neither overflow nor vanish.
class Indexed_surface
{
public:
  Index number_of_vertices() const { return static_cast<Index>(points_.size()); }
  const std::vector<Indexed_triangle>& triangles() const { return triangles_; }

  const Vector& point(Index v) const { return points_[v]; }
  double scale() const { return scale_; }

  // The length of an edge between two vertices, for the points divided by scale(). All edges can be made longer, by the
  // same length; the points stay.
  double edge_length(Index u, Index v) const { return length(point(v) - point(u)) + added_length_; }
  double added_length() const { return added_length_; }
  void set_added_length(double added_length) { added_length_ = added_length; }

protected:
  Indexed_surface() = default;

  // They are finite.
  void set_points(std::vector<Vector> points)
  {
    points_ = std::move(points);
    double largest = 0;
    for(const Vector& p : points_)
      for(int i = 0; i != 3; ++i)
        largest = (std::max)(largest, std::abs(p[i]));
    if(largest > 0)
      scale_ = std::ldexp(1., (std::max)(std::ilogb(largest), -1000));
    for(Vector& p : points_)
      p = p / scale_;
  }

  void add_triangle(const std::array<Index, 3>& vertices, const std::array<bool, 3>& is_on_border)
  {
    triangles_.push_back({vertices, is_on_border});
  }

private:
  std::vector<Vector> points_;
  std::vector<Indexed_triangle> triangles_;
  double scale_ = 1, added_length_ = 0;
};

// The surface of a mesh, checked as that of a Reeb graph is, and the way from its vertices to dense ones and back.
template <class FaceListGraph>
class Indexed_mesh : public Indexed_surface
{
public:
  typedef FaceListGraph Mesh;
  typedef typename Descriptors<Mesh>::vertex_descriptor vertex_descriptor;
  typedef Indexed_vector<Vertex_index, vertex_descriptor> Vertex_handles;

  template <class NamedParameters>
  Indexed_mesh(const FaceListGraph& mesh, const NamedParameters& np)
    : vertices_(vertices(mesh).first, vertices(mesh).second)
  {
    set_points(read_points<Vector>(mesh, choose_point_map(mesh, np)));
    flat_mesh_ = make_flat_mesh(mesh);
    dense_vertices_ = list_positions(*flat_mesh_);
    const auto& complex = flat_mesh_->complex;
    for_each_face(mesh, *flat_mesh_, [&](Halfedge_index a) {
      const Halfedge_index b = complex.next(a), c = complex.previous(a);
      add_triangle(
        {dense_vertices_[complex.source(a)], dense_vertices_[complex.source(b)], dense_vertices_[complex.source(c)]},
        {complex.is_on_border_edge(a), complex.is_on_border_edge(b), complex.is_on_border_edge(c)});
    });
  }

  vertex_descriptor vertex_handle(std::size_t v) const { return vertices_[Vertex_index(v)]; }
  const Vertex_handles& vertex_handles() const { return vertices_; }
  const Flat_mesh<FaceListGraph>& flat_mesh() const { return *flat_mesh_; }

  // The number of a vertex, no_index if it is not one of the mesh.
  Index dense_vertex(vertex_descriptor v) const
  {
    if(v == boost::graph_traits<Mesh>::null_vertex())
      return no_index;
    const Vertex_index number = flat_mesh_->numbers.number_of(v);
    const Index vertex = dense_vertices_.contains(number) ? dense_vertices_[number] : no_index;
    return vertex != no_index && vertex_handle(vertex) == v ? vertex : no_index;
  }

private:
  Vertex_handles vertices_;
  std::shared_ptr<const Flat_mesh<FaceListGraph>> flat_mesh_;
  Indexed_vector<Vertex_index, Index> dense_vertices_; // by number
};

} // namespace CGAL::Reeb_graph::internal::scalar_fields

#endif // CGAL_REEB_GRAPH_FIELDS_INTERNAL_INDEXED_SURFACE_H
