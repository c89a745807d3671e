// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_TEST_LINKING_ORACLE_H
#define CGAL_REEB_GRAPH_TEST_LINKING_ORACLE_H

#include "handle_samples.h"

#include <CGAL/boost/graph/iterator.h>

#include <cmath>
#include <cstddef>
#include <map>
#include <vector>

// Linking numbers by a way of their own: polygons are moved off the surface, and crossings are counted as they are seen
// in one direction, by floating-point numbers.
namespace linking_oracle {
using handle_samples::cross;
using handle_samples::dot;
using handle_samples::sum;
using handle_samples::unit;
using handle_samples::Vector;
typedef std::vector<Vector> Polygon; // closed

// Half the sum of the signs of all crossings.
inline double linking_number(const Polygon& a, const Polygon& b)
{
  const Vector direction = unit({0.3711, 0.2347, 0.8983});
  int twice = 0;
  for(std::size_t i = 0; i != a.size(); ++i)
  {
    const Vector &a0 = a[i], along_a = sum(a[(i + 1) % a.size()], -1, a0), across_a = cross(direction, along_a);
    for(std::size_t j = 0; j != b.size(); ++j)
    {
      const Vector &b0 = b[j], &b1 = b[(j + 1) % b.size()];
      const double s0 = dot(across_a, sum(b0, -1, a0)), s1 = dot(across_a, sum(b1, -1, a0));
      if((s0 < 0) == (s1 < 0))
        continue;
      const Vector along_b = sum(b1, -1, b0), across_b = cross(direction, along_b);
      const double t0 = dot(across_b, sum(a0, -1, b0)), t1 = dot(across_b, sum(sum(a0, 1, along_a), -1, b0));
      if((t0 < 0) == (t1 < 0))
        continue;
      const bool is_positive = dot(cross(along_a, along_b), direction) > 0;
      const bool is_a_above = (dot(cross(along_a, along_b), sum(a0, -1, b0)) > 0) == is_positive;
      twice += is_a_above == is_positive ? 1 : -1;
    }
  }
  return twice / 2.;
}

template <class Mesh>
class Offset
{
  typedef typename boost::graph_traits<Mesh>::vertex_descriptor vertex_descriptor;

public:
  // `distance` is less than half of the smallest width of the surface and of the space between its parts.
  Offset(const Mesh& mesh, double distance) : mesh_(mesh), distance_(distance)
  {
    std::map<vertex_descriptor, std::vector<Vector>> normals;
    for(const auto f : faces(mesh))
    {
      const auto h = halfedge(f, mesh);
      const Vector p = point(source(h, mesh)), q = point(target(h, mesh)), r = point(target(next(h, mesh), mesh));
      const Vector normal = unit(cross(sum(q, -1, p), sum(r, -1, p)));
      for(const auto v : CGAL::vertices_around_face(h, mesh))
        normals[v].push_back(normal);
    }
    for(const auto& [v, around] : normals)
      directions_[v] = direction_in_front(around);
  }

  // A direction that leads to the front of all faces with these normals, if there is one: that of a perceptron.
  static Vector direction_in_front(const std::vector<Vector>& normals)
  {
    Vector direction = {0, 0, 0};
    for(const Vector& normal : normals)
      direction = sum(direction, 1, normal);
    bool is_in_front = false;
    for(int step = 0; step != 1000 && !is_in_front; ++step)
    {
      is_in_front = true;
      for(const Vector& normal : normals)
      {
        if(dot(normal, direction) > 0.02 * std::sqrt(dot(direction, direction)))
          continue;
        direction = sum(direction, 1, normal);
        is_in_front = false;
      }
    }
    return unit(direction);
  }

  // The loop moved to the side of the normals by so many times the distance.
  template <class HalfedgeRange>
  Polygon polygon(const HalfedgeRange& loop, double times) const
  {
    Polygon result;
    for(const auto h : loop)
      result.push_back(sum(point(source(h, mesh_)), times * distance_, directions_.at(source(h, mesh_))));
    return result;
  }

private:
  Vector point(vertex_descriptor v) const
  {
    const auto& p = get(CGAL::vertex_point, mesh_, v);
    return {p.x(), p.y(), p.z()};
  }

  const Mesh& mesh_;
  double distance_;
  std::map<vertex_descriptor, Vector> directions_; // to the front
};

} // namespace linking_oracle

#endif // CGAL_REEB_GRAPH_TEST_LINKING_ORACLE_H
