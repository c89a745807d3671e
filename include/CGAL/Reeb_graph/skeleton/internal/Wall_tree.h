// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_SKELETON_INTERNAL_WALL_TREE_H
#define CGAL_REEB_GRAPH_SKELETON_INTERNAL_WALL_TREE_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/skeleton/internal/Component_filling.h>

#include <CGAL/Bbox_3.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL::Reeb_graph::internal::skeleton {

// A tree over the surface without its openings, which tells the closest point by rounded numbers, in a fraction of the time
// that exact ones take.
class Wall_tree
{
public:
  Wall_tree(const Filled_component& component, bool are_borders_openings)
  {
    const Mesh& mesh = component.mesh;
    for(const auto f : mesh.faces())
    {
      const auto h = mesh.halfedge(f);
      const std::array<Mesh::Vertex_index, 3> v = {mesh.source(h), mesh.target(h), mesh.target(mesh.next(h))};
      const Point &a = mesh.point(v[0]), &b = mesh.point(v[1]), &c = mesh.point(v[2]);
      const Vector normal = cross_product(b - a, c - a);
      const auto is_apex = [&](auto corner) { return are_borders_openings && component.is_apex(corner); };
      if(std::any_of(v.begin(), v.end(), is_apex))
        has_openings_ = true;
      else if(const double size = length(normal); size > 0) // Edges of others belong to triangles with area, too.
        triangles_.push_back({{a, b, c}, normal / size});
    }
    add_node(0, triangles_.size());
  }

  // The point of the surface that is closest to a point: the hint, one of its points, where none is closer.
  Point closest(const Point& p, const Point& hint) const
  {
    Found best = {hint, has_openings_ ? std::numeric_limits<double>::infinity() : CGAL::squared_distance(p, hint)};
    search(0, p, best);
    return best.point;
  }

private:
  struct Triangle
  {
    std::array<Point, 3> corners;
    Vector normal; // of length 1
  };
  struct Node
  {
    Bbox_3 box;
    std::size_t begin, end; // of its triangles
    std::size_t second = 0; // child, if it is no leaf; the first one is the next node
  };
  struct Found
  {
    Point point;
    double square; // of the distance
  };

  void add_node(std::size_t begin, std::size_t end)
  {
    Bbox_3 box;
    for(std::size_t i = begin; i != end; ++i)
      box += CGAL::bbox_3(triangles_[i].corners.begin(), triangles_[i].corners.end());
    const std::size_t number = nodes_.size(), middle = begin + (end - begin) / 2;
    nodes_.push_back({box, begin, end});
    if(end - begin <= most_in_leaf)
      return;
    int axis = 0;
    for(const int other : {1, 2})
      axis = box.max(other) - box.min(other) > box.max(axis) - box.min(axis) ? other : axis;
    const auto at = [&](std::size_t i) { return triangles_.begin() + static_cast<std::ptrdiff_t>(i); };
    std::nth_element(at(begin), at(middle), at(end), [&](const Triangle& s, const Triangle& t) {
      return CGAL::centroid(s.corners[0], s.corners[1], s.corners[2])[axis]
           < CGAL::centroid(t.corners[0], t.corners[1], t.corners[2])[axis];
    });
    add_node(begin, middle);
    nodes_[number].second = nodes_.size();
    add_node(middle, end);
  }

  double squared_distance_from(std::size_t node, const Point& p) const
  {
    const Bbox_3& box = nodes_[node].box;
    double sum = 0;
    for(int i = 0; i != 3; ++i)
    {
      const double outside = (std::max)({box.min(i) - p[i], p[i] - box.max(i), 0.});
      sum += outside * outside;
    }
    return sum;
  }

  // Looks into the nearer child first.
  void search(std::size_t number, const Point& p, Found& best) const
  {
    const auto& [box, begin, end, second] = nodes_[number];
    for(std::size_t i = begin; i != end && second == 0; ++i)
      search(triangles_[i], p, best);
    if(second == 0)
      return;
    typedef std::pair<double, std::size_t> Child;
    const Child children[] = {{squared_distance_from(number + 1, p), number + 1},
                              {squared_distance_from(second, p), second}};
    for(const auto& [square, child] : {(std::min)(children[0], children[1]), (std::max)(children[0], children[1])})
      if(square < best.square)
        search(child, p, best);
  }

  // The foot on the plane, or, where that is outside of the triangle, points of its sides.
  static void search(const Triangle& triangle, const Point& p, Found& best)
  {
    const auto& [corners, normal] = triangle;
    const double height = (p - corners[0]) * normal;
    if(!(height * height < best.square))
      return;
    const auto offer = [&](const Point& q) {
      if(const double square = CGAL::squared_distance(p, q); square < best.square)
        best = {q, square};
    };
    bool is_foot_inside = true;
    for(std::size_t i = 0; i != 3; ++i)
    {
      const Vector side = corners[(i + 1) % 3] - corners[i], way = p - corners[i];
      if(!(cross_product(side, way) * normal < 0))
        continue;
      is_foot_inside = false;
      offer(corners[i] + std::clamp(way * side / side.squared_length(), 0., 1.) * side);
    }
    if(is_foot_inside)
      offer(p - height * normal);
  }

  static constexpr std::size_t most_in_leaf = 4;

  bool has_openings_ = false; // near which a hint can be
  std::vector<Triangle> triangles_;
  std::vector<Node> nodes_;
};

} // namespace CGAL::Reeb_graph::internal::skeleton

#endif // CGAL_REEB_GRAPH_SKELETON_INTERNAL_WALL_TREE_H
