// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_TEST_CUT_MESH_CHECKS_H
#define CGAL_REEB_GRAPH_TEST_CUT_MESH_CHECKS_H

#include "mesh_builders.h"

#include <CGAL/Reeb_graph/curves/Curve.h>
#include <CGAL/Reeb_graph/curves/Refinement_visitor.h>
#include <CGAL/boost/graph/helpers.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <map>
#include <numeric>
#include <set>
#include <string>
#include <utility>
#include <vector>

// What a mesh that has been cut along curves must be like, found without any of the code that has cut it.
namespace cut_mesh_checks {
using mesh_builders::Point;

// A piece of a surface that has been cut along edges.
struct Piece
{
  long euler_characteristic = 0;
  std::size_t border_loops = 0;
  std::size_t faces = 0;

  friend bool operator<(const Piece& a, const Piece& b)
  {
    return std::make_pair(a.euler_characteristic, a.border_loops)
         < std::make_pair(b.euler_characteristic, b.border_loops);
  }
};

// Triangles in arrays: corner i % 3 of the triangle i / 3 has the edge to the next corner.
class Flat_mesh
{
public:
  static constexpr std::size_t none = static_cast<std::size_t>(-1);

  // `is_cut` tells for each halfedge whether its edge is cut.
  template <class Mesh, class IsCut>
  Flat_mesh(const Mesh& mesh, const IsCut& is_cut)
  {
    std::map<typename boost::graph_traits<Mesh>::halfedge_descriptor, std::size_t> corner_of_halfedge;
    for(const auto f : faces(mesh))
      for(const auto h : halfedges_around_face(halfedge(f, mesh), mesh))
        corner_of_halfedge.emplace(h, corner_of_halfedge.size());
    opposite_.assign(corner_of_halfedge.size(), none);
    for(const auto& item : corner_of_halfedge)
    {
      const auto found = corner_of_halfedge.find(opposite(item.first, mesh));
      if(found != corner_of_halfedge.end() && !is_cut(item.first))
        opposite_[item.second] = found->second;
    }
  }

  std::size_t number_of_corners() const { return opposite_.size(); }

  // The pieces in the order of their first triangles, and the piece of each triangle.
  std::pair<std::vector<Piece>, std::vector<std::size_t>> pieces() const
  {
    std::vector<std::size_t> triangle_sets = singletons(number_of_corners() / 3),
                             corner_sets = singletons(number_of_corners());
    for(std::size_t c = 0; c < number_of_corners(); ++c)
      if(opposite_[c] != none)
      {
        unite(triangle_sets, c / 3, opposite_[c] / 3);
        unite(corner_sets, c, next(opposite_[c]));
      }
    std::vector<Piece> result;
    std::map<std::size_t, std::size_t> piece_of_set;
    std::vector<std::size_t> piece_of_triangle;
    for(std::size_t t = 0; t < number_of_corners() / 3; ++t)
    {
      const auto found = piece_of_set.emplace(find(triangle_sets, t), result.size());
      if(found.second)
        result.emplace_back();
      piece_of_triangle.push_back(found.first->second);
      ++result[found.first->second].faces;
      ++result[found.first->second].euler_characteristic;
    }
    for(std::size_t c = 0; c < number_of_corners(); ++c)
    {
      Piece& piece = result[piece_of_triangle[c / 3]];
      if(find(corner_sets, c) == c)
        ++piece.euler_characteristic;
      if(opposite_[c] == none || opposite_[c] < c)
        --piece.euler_characteristic;
    }
    count_border_loops(result, piece_of_triangle);
    return {result, piece_of_triangle};
  }

private:
  static std::size_t next(std::size_t c) { return c % 3 == 2 ? c - 2 : c + 1; }

  static std::vector<std::size_t> singletons(std::size_t size)
  {
    std::vector<std::size_t> sets(size);
    std::iota(sets.begin(), sets.end(), std::size_t(0));
    return sets;
  }
  static std::size_t find(std::vector<std::size_t>& sets, std::size_t i)
  {
    while(sets[i] != i)
      i = sets[i] = sets[sets[i]];
    return i;
  }
  static void unite(std::vector<std::size_t>& sets, std::size_t i, std::size_t j)
  {
    sets[find(sets, i)] = find(sets, j);
  }

  void count_border_loops(std::vector<Piece>& pieces, const std::vector<std::size_t>& piece_of_triangle) const
  {
    std::vector<bool> is_visited(number_of_corners(), false);
    for(std::size_t first = 0; first < number_of_corners(); ++first)
    {
      if(opposite_[first] != none || is_visited[first])
        continue;
      ++pieces[piece_of_triangle[first / 3]].border_loops;
      for(std::size_t c = first; !is_visited[c];)
      {
        is_visited[c] = true;
        for(c = next(c); opposite_[c] != none;)
          c = next(opposite_[c]);
      }
    }
  }

  std::vector<std::size_t> opposite_;
};

template <class Mesh>
std::vector<Piece> pieces_of(const Mesh& mesh)
{
  typedef typename boost::graph_traits<Mesh>::halfedge_descriptor halfedge_descriptor;
  return Flat_mesh(mesh, [](halfedge_descriptor) { return false; }).pieces().first;
}

template <class Mesh, class Curves>
std::vector<Piece> pieces_between(const Mesh& mesh, const Curves& curves)
{
  typedef typename boost::graph_traits<Mesh>::halfedge_descriptor halfedge_descriptor;
  std::set<halfedge_descriptor> cut;
  for(const auto& curve : curves)
    for(const halfedge_descriptor h : curve.halfedges)
    {
      cut.insert(h);
      cut.insert(opposite(h, mesh));
    }
  return Flat_mesh(mesh, [&](halfedge_descriptor h) { return cut.count(h) != 0; }).pieces().first;
}

// Curves are paths of edges, closed if they say so, without common vertices or vertices that are passed twice.
template <class Mesh, class Curves>
std::string fault_of_curves(const Mesh& mesh, const Curves& curves)
{
  std::set<typename boost::graph_traits<Mesh>::vertex_descriptor> passed;
  for(const auto& curve : curves)
  {
    if(curve.halfedges.empty() || curve.halfedges.size() != curve.lower_halfedges.size())
      return "a curve has no halfedges";
    double length = 0;
    for(std::size_t i = 0; i < curve.halfedges.size(); ++i)
    {
      const auto h = curve.halfedges[i];
      if(!passed.insert(source(h, mesh)).second)
        return "curves are not simple and disjoint";
      if(i + 1 < curve.halfedges.size() && target(h, mesh) != source(curve.halfedges[i + 1], mesh))
        return "a curve is not connected";
      const auto vertex_point_map = get(CGAL::vertex_point, mesh);
      length += std::sqrt(
        CGAL::squared_distance(get(vertex_point_map, source(h, mesh)), get(vertex_point_map, target(h, mesh))));
    }
    const auto end = target(curve.halfedges.back(), mesh);
    if(curve.is_closed != (end == source(curve.halfedges.front(), mesh)))
      return "a curve is closed, or is not, unlike it says";
    if(!curve.is_closed && !passed.insert(end).second)
      return "curves are not simple and disjoint";
    if(std::abs(length - curve.length) > 1e-9 * length)
      return "a curve has another length";
  }
  return "";
}

// Remembers which face of the input each face is a part of.
template <class Mesh>
class Face_history
{
  typedef typename boost::graph_traits<Mesh>::face_descriptor face_descriptor;
  typedef typename boost::graph_traits<Mesh>::vertex_descriptor vertex_descriptor;
  typedef CGAL::Vector_3<mesh_builders::Kernel> Vector;

public:
  explicit Face_history(const Mesh& mesh) : mesh_(mesh)
  {
    for(const face_descriptor f : faces(mesh))
    {
      origins_[f] = normals_.size();
      normals_.push_back(normal(f));
    }
  }

  // The visitor that keeps this history.
  struct Visitor : CGAL::Reeb_graph::Default_refinement_visitor<Mesh>
  {
    Face_history* history;
    void face_split(face_descriptor old, face_descriptor created) { history->face_split(old, created); }
  };
  Visitor visitor()
  {
    Visitor result;
    result.history = this;
    return result;
  }

  // The parts of each face have its area and its orientation, and none is degenerate unless the face is.
  std::string fault() const
  {
    std::vector<double> areas(normals_.size(), 0);
    for(const face_descriptor f : faces(mesh_))
    {
      const auto origin = origins_.find(f);
      if(origin == origins_.end())
        return "a face has no origin";
      const Vector old = normals_[origin->second], now = normal(f);
      areas[origin->second] += std::sqrt(now.squared_length());
      if(old.squared_length() > 0 && !(old * now > 0))
        return "a face is degenerate or turned over";
    }
    for(std::size_t i = 0; i < areas.size(); ++i)
    {
      const double area = std::sqrt(normals_[i].squared_length());
      if(std::abs(areas[i] - area) > 1e-6 * area)
        return "the area of a face has changed";
    }
    return "";
  }

private:
  void face_split(face_descriptor old, face_descriptor created) { origins_[created] = origins_.at(old); }

  Vector normal(face_descriptor f) const
  {
    const auto vertex_point_map = get(CGAL::vertex_point, mesh_);
    const auto h = halfedge(f, mesh_);
    const Point p = get(vertex_point_map, source(h, mesh_)), q = get(vertex_point_map, target(h, mesh_));
    return CGAL::cross_product(q - p, get(vertex_point_map, target(next(h, mesh_), mesh_)) - p);
  }

  const Mesh& mesh_;
  std::map<face_descriptor, std::size_t> origins_;
  std::vector<Vector> normals_; // by face of the input
};

// CGAL's test takes isolated vertices for errors, which they are not here.
template <class Mesh>
bool is_valid_mesh(Mesh mesh)
{
  typedef typename boost::graph_traits<Mesh>::vertex_descriptor vertex_descriptor;
  std::vector<vertex_descriptor> isolated;
  for(const vertex_descriptor v : vertices(mesh))
    if(halfedge(v, mesh) == boost::graph_traits<Mesh>::null_halfedge())
      isolated.push_back(v);
  for(const vertex_descriptor v : isolated)
    remove_vertex(v, mesh);
  return CGAL::is_valid_polygon_mesh(mesh) && CGAL::is_triangle_mesh(mesh);
}

// A valid triangle mesh, cut into these pieces.
template <class Mesh, class Curves>
std::string fault_of_cut_mesh(const Mesh& mesh, const Curves& curves, std::vector<Piece> expected)
{
  if(!is_valid_mesh(mesh))
    return "the mesh is not a valid triangle mesh";
  const std::string fault = fault_of_curves(mesh, curves);
  if(!fault.empty())
    return fault;
  std::vector<Piece> pieces = pieces_between(mesh, curves);
  std::sort(pieces.begin(), pieces.end());
  std::sort(expected.begin(), expected.end());
  if(pieces.size() != expected.size())
    return std::to_string(pieces.size()) + " pieces, expected " + std::to_string(expected.size());
  for(std::size_t i = 0; i < pieces.size(); ++i)
    if(pieces[i] < expected[i] || expected[i] < pieces[i])
      return "a piece has Euler characteristic " + std::to_string(pieces[i].euler_characteristic) + " and "
           + std::to_string(pieces[i].border_loops) + " border loops";
  return "";
}

} // namespace cut_mesh_checks

#endif // CGAL_REEB_GRAPH_TEST_CUT_MESH_CHECKS_H
