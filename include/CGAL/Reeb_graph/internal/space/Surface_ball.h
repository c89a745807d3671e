// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_INTERNAL_SPACE_SURFACE_BALL_H
#define CGAL_REEB_GRAPH_INTERNAL_SPACE_SURFACE_BALL_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/internal/base/Index.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL::Reeb_graph::internal {

template <class FT>
std::array<FT, 3> cross(const std::array<FT, 3>& a, const std::array<FT, 3>& b)
{
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

template <class FT>
FT dot(const std::array<FT, 3>& a, const std::array<FT, 3>& b)
{
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

// A closed triangle mesh as arrays. The halfedges of an edge are 2e and 2e + 1.
struct Closed_triangles
{
  typedef std::array<double, 3> Point;

  std::vector<Point> points;       // by vertex
  std::vector<Index> target, next; // by halfedge
  std::vector<Index> face;         // by halfedge
  std::vector<Index> outgoing;     // a halfedge that leaves a vertex; no_index if there is none
  std::vector<Index> halfedge;     // one of each face

  static Index opposite(Index h) { return h ^ 1; }
  Index source(Index h) const { return target[h ^ 1]; }
  Index previous(Index h) const { return next[next[h]]; }
  // The next halfedge that leaves the same vertex, counterclockwise.
  Index turned(Index h) const { return opposite(previous(h)); }
  std::array<Index, 3> corners(Index f) const
  {
    const Index h = halfedge[f];
    return {source(h), target[h], target[next[h]]};
  }
  Point way(Index u, Index v) const
  {
    const Point &p = points[u], &q = points[v];
    return {q[0] - p[0], q[1] - p[1], q[2] - p[2]};
  }

  // Sets what is told of points, targets, and next halfedges.
  void number_faces()
  {
    halfedge.reserve(next.size() / 3);
    face.assign(next.size(), no_index);
    outgoing.assign(points.size(), no_index);
    for(Index h = 0; h != next.size(); ++h)
    {
      outgoing[source(h)] = h;
      if(face[h] != no_index)
        continue;
      face[h] = face[next[h]] = face[previous(h)] = static_cast<Index>(halfedge.size());
      halfedge.push_back(h);
    }
  }
};

// The triangles of a Surface_mesh that is closed and has no garbage.
template <class SurfaceMesh>
Closed_triangles closed_triangles(const SurfaceMesh& mesh)
{
  Closed_triangles result;
  for(const auto& p : mesh.points())
    result.points.push_back({p.x(), p.y(), p.z()});
  for(const auto h : mesh.halfedges())
  {
    result.target.push_back(mesh.target(h));
    result.next.push_back(mesh.next(h));
  }
  result.number_faces();
  return result;
}

// The ball around a vertex: the faces around it, as the first layer, and in each further layer those around the vertices
// of the one before. There is one ball at a time.
class Surface_ball
{
public:
  explicit Surface_ball(const Closed_triangles& surface)
    : surface_(surface),
      ball_of_vertex_(surface.points.size(), 0),
      ball_of_face_(surface.halfedge.size(), 0)
  {}

  const std::vector<Index>& faces() const { return faces_; }                   // layer by layer
  std::size_t number_of_inner_faces() const { return number_of_inner_faces_; } // those not in the last layer
  bool contains(Index face) const { return ball_of_face_[face] == number_; }
  Index last_vertex() const { return reached_.back(); }

  // Takes only those faces that are to be passed. Returns whether it is complete: it ends after so many steps around
  // vertices, as around one with many neighbors each ball near by would take all of them.
  template <class IsPassed>
  bool grow(Index center, int number_of_layers, std::size_t most_steps, const IsPassed& is_passed)
  {
    ++number_;
    steps_left_ = most_steps;
    faces_.clear();
    reached_.assign(1, center);
    ball_of_vertex_[center] = number_;
    std::size_t next = 0;
    for(int layer = 0; layer != number_of_layers; ++layer)
    {
      number_of_inner_faces_ = faces_.size();
      for(const std::size_t end = reached_.size(); next != end && steps_left_ != 0; ++next)
        add_faces_around(reached_[next], is_passed);
    }
    return steps_left_ != 0;
  }

  // Takes faces of an earlier ball, of which it is only to be told what it contains.
  template <class Iterator>
  void mark(Iterator first, Iterator last)
  {
    ++number_;
    for(; first != last; ++first)
      ball_of_face_[*first] = number_;
  }

  // Whether the ball has a picture in the plane where all its faces are seen from their front, and its border turns once
  // around the center, to the left all the way. Then each point of the picture is in one face, or on an edge, or a corner,
  // so that faces have nothing else in common. The margins are large beside all errors of rounding.
  bool is_flat()
  {
    find_border();
    const Index center = reached_.front();
    Vector normal = {0, 0, 0};
    for(const Index h : border_)
    {
      const Vector product = cross(surface_.way(center, surface_.source(h)), surface_.way(center, surface_.target[h]));
      for(std::size_t k = 0; k != 3; ++k)
        normal[k] += product[k];
    }
    const bool is_steep = std::abs(normal[0]) < std::abs(normal[1]);
    const Vector x_axis = unit(is_steep ? Vector{0, -normal[2], normal[1]} : Vector{normal[2], 0, -normal[0]});
    const Vector y_axis = unit(cross(normal, x_axis));
    const auto is_left = [&](const Vector& a, const Vector& b) {
      const double area = dot(a, x_axis) * dot(b, y_axis) - dot(a, y_axis) * dot(b, x_axis);
      return area > 0 && area * area > 1e-12 * dot(a, a) * dot(b, b);
    };
    int number_of_turns = 0;
    for(const Index h : border_)
    {
      const Vector from = surface_.way(center, surface_.source(h)), to = surface_.way(center, surface_.target[h]);
      if(!is_left(from, to))
        return false;
      number_of_turns += dot(from, y_axis) < 0 && dot(to, y_axis) >= 0 ? 1 : 0;
    }
    return number_of_turns == 1 && std::all_of(faces_.begin(), faces_.end(), [&](Index face) {
             const auto [u, v, w] = surface_.corners(face);
             return is_left(surface_.way(u, v), surface_.way(u, w));
           });
  }

private:
  typedef Closed_triangles::Point Vector;

  static Vector unit(const Vector& a)
  {
    const double length = std::sqrt(dot(a, a));
    return {a[0] / length, a[1] / length, a[2] / length};
  }

  template <class IsPassed>
  void add_faces_around(Index v, const IsPassed& is_passed)
  {
    const Index first = surface_.outgoing[v];
    Index h = first;
    do
    {
      const Index face = surface_.face[h];
      if(!contains(face) && is_passed(face))
      {
        ball_of_face_[face] = number_;
        faces_.push_back(face);
        for(const Index w : {surface_.target[h], surface_.target[surface_.next[h]]})
        {
          if(ball_of_vertex_[w] != number_)
            reached_.push_back(w);
          ball_of_vertex_[w] = number_;
        }
      }
      h = surface_.turned(h);
    } while(h != first && --steps_left_ != 0);
  }

  void find_border()
  {
    border_.clear();
    for(std::size_t i = number_of_inner_faces_; i != faces_.size(); ++i)
    {
      Index h = surface_.halfedge[faces_[i]];
      for(int k = 0; k != 3; ++k, h = surface_.next[h])
        if(!contains(surface_.face[surface_.opposite(h)]))
          border_.push_back(h);
    }
  }

  const Closed_triangles& surface_;
  std::vector<Index> ball_of_vertex_, ball_of_face_; // the number of the last one
  Index number_ = 0;
  std::vector<Index> faces_, reached_, border_; // vertices that are reached, the center first, and halfedges
  std::size_t number_of_inner_faces_ = 0, steps_left_ = 0;
};

} // namespace CGAL::Reeb_graph::internal

#endif // CGAL_REEB_GRAPH_INTERNAL_SPACE_SURFACE_BALL_H
