// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_SKELETON_INTERNAL_COMPONENT_FILLING_H
#define CGAL_REEB_GRAPH_SKELETON_INTERNAL_COMPONENT_FILLING_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/internal/base/Index.h>
#include <CGAL/Reeb_graph/internal/base/arrays.h>

#include <CGAL/Bbox_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <map>
#include <set>
#include <tuple>
#include <utility>
#include <vector>

namespace CGAL::Reeb_graph::internal::skeleton {

typedef Exact_predicates_inexact_constructions_kernel Kernel;
typedef Kernel::Point_3 Point;
typedef Kernel::Vector_3 Vector;

inline constexpr double pi = 3.14159265358979323846;

inline double length(const Vector& v) { return std::sqrt(v.squared_length()); }
inline double distance(const Point& p, const Point& q) { return length(q - p); }

// Measures of a closed polygon in space.
struct Contour_shape
{
  Point centroid; // of the disc that the polygon spans, or of the polygon where that is flat
  Vector area;    // of that disc, seen from three sides
  double length = 0;

  // The radius of the circle of the same area.
  double radius() const { return std::sqrt(skeleton::length(area) / pi); }
};

// The radius of the circle with the area that is seen along a direction of length 1, or with half of the area, if that is more.
inline double radius_along(const Vector& area, const Vector& direction)
{
  return std::sqrt((std::max)(std::abs(area * direction), length(area) / 2) / pi);
}

// A polygon whose vector area is below this share of that of a circle as long is a fold: its disc has no centroid.
inline constexpr double least_share_of_circle = 0.15;

inline Contour_shape measure(const std::vector<Point>& polygon)
{
  const std::size_t size = polygon.size();
  const Point origin = polygon.front();
  Contour_shape shape = {origin, NULL_VECTOR, 0};
  Vector middle = NULL_VECTOR;
  for(std::size_t i = 0; i != size; ++i)
  {
    const Point &p = polygon[i], &q = polygon[(i + 1) % size];
    const double edge = distance(p, q);
    shape.length += edge;
    middle = middle + edge * ((p - origin) + (q - origin)) / 2;
    shape.area = shape.area + cross_product(p - origin, q - origin) / 2;
  }
  if(!(shape.length > 0))
    return shape;
  const Point center = origin + middle / shape.length;
  shape.centroid = center;
  const double area = length(shape.area);
  if(!(area > least_share_of_circle * shape.length * shape.length / (4 * pi)))
    return shape;
  const Vector normal = shape.area / area;
  Vector moment = NULL_VECTOR;
  for(std::size_t i = 0; i != size; ++i)
  {
    const Vector p = polygon[i] - center, q = polygon[(i + 1) % size] - center;
    moment = moment + (cross_product(p, q) * normal / 2) * (p + q) / 3;
  }
  shape.centroid = center + moment / area;
  return shape;
}

typedef CGAL::Surface_mesh<Point> Mesh;

// A closed polygon of a border that has been filled by a fan of triangles around its centroid, the apex.
struct Filled_border
{
  Mesh::Vertex_index apex;
  std::vector<Mesh::Vertex_index> rim;
  double radius;
};

// A connected component of a surface, without borders, whose size is about 1: the given vertices come first, in the order
// of their coordinates, then others.
struct Filled_component
{
  Mesh mesh;
  std::vector<Index> given;           // the numbers of its vertices in the surface
  int exponent = 0;                   // Its points have been multiplied by 2 to this power.
  std::vector<Filled_border> borders; // those that are openings
  std::vector<Filled_border> seams;   // the vertices that close what has no area, each after those of its rim
  std::vector<double> values;         // of the given vertices; empty if distances are to be used
  std::vector<double> given_lengths;  // of edges, before long ones were cut; empty if there was none

  bool is_given(Mesh::Vertex_index v) const { return v.idx() < given.size(); }
  // The place of the border whose apex a vertex is, or the number of borders.
  std::size_t border_of(Mesh::Vertex_index v) const
  {
    const std::size_t place = borders.empty() ? 0 : v.idx() - borders.front().apex.idx();
    return (std::min)(place, borders.size()); // The apexes are consecutive.
  }
  bool is_apex(Mesh::Vertex_index v) const { return border_of(v) != borders.size(); }
};

// Fills the borders of a component. Where a border passes a point twice, as at both sides of a slit, it is one point: the border
// is closed there. What is left of it is an opening if it is not on one line. Where a border passes an edge twice in the same
// direction, a Moebius strip has been cut open: that is one opening.
class Border_filling
{
public:
  explicit Border_filling(Filled_component& component) : component_(component), mesh_(component.mesh) {}

  // Takes the halfedges of a border in their order.
  void add(const std::vector<Mesh::Halfedge_index>& cycle)
  {
    path_.clear();
    places_.clear();
    std::set<std::pair<Point, Point>> edges;
    std::set<Point> left_open;
    for(const auto h : cycle)
    {
      const Point &from = mesh_.point(mesh_.source(h)), &to = mesh_.point(mesh_.target(h));
      if(!edges.insert({from, to}).second)
        left_open.insert({from, to});
    }
    places_[mesh_.point(mesh_.source(cycle.front()))] = 0;
    for(const auto h : cycle)
    {
      path_.push_back(h);
      const auto [place, is_new] = places_.insert({mesh_.point(mesh_.target(h)), path_.size()});
      if(!is_new && h != cycle.back() && left_open.count(place->first) == 0)
        place->second = close(place->second);
    }
    polygons_.push_back(path_);
  }

  // Fills what has been added: openings first, so that their apexes are consecutive.
  void fill()
  {
    for(const bool are_openings : {true, false})
      for(const Polygon& polygon : polygons_)
        if(is_opening(polygon) == are_openings)
          (are_openings ? component_.borders : component_.seams).push_back(fan(polygon));
  }

private:
  typedef std::vector<Mesh::Halfedge_index> Polygon;

  // Joins the end of the path to an earlier vertex at the same point, by way of a new vertex there. Returns the new end.
  std::size_t close(std::size_t place)
  {
    if(path_.size() - place < 2)
      return path_.size();
    const auto last = mesh_.target(path_.back()), first = mesh_.source(path_[place]);
    const auto middle = mesh_.add_vertex(Point(mesh_.point(first)));
    component_.seams.push_back({middle, {first, last}, 0});
    Polygon polygon(path_.begin() + static_cast<std::ptrdiff_t>(place), path_.end());
    polygon.push_back(add_edge(last, middle));
    polygon.push_back(add_edge(middle, first));
    for(std::size_t i = place; i + 1 < path_.size(); ++i)
      if(const auto passed = places_.find(mesh_.point(mesh_.target(path_[i])));
         passed != places_.end() && passed->second == i + 1)
        places_.erase(passed);
    path_.resize(place);
    path_.push_back(mesh_.opposite(polygon.back()));
    path_.push_back(mesh_.opposite(polygon[polygon.size() - 2]));
    polygons_.push_back(std::move(polygon));
    return path_.size();
  }

  Mesh::Halfedge_index add_edge(Mesh::Vertex_index from, Mesh::Vertex_index to)
  {
    const auto h = mesh_.add_edge();
    mesh_.set_target(h, to);
    mesh_.set_target(mesh_.opposite(h), from);
    return h;
  }

  bool is_opening(const Polygon& polygon) const
  {
    const Point& first = mesh_.point(mesh_.source(polygon.front()));
    const Point* second = nullptr;
    for(const auto h : polygon)
    {
      const Point& p = mesh_.point(mesh_.target(h));
      if(second && !collinear(first, *second, p))
        return true;
      if(!second && p != first)
        second = &p;
    }
    return false;
  }

  Filled_border fan(const Polygon& cycle)
  {
    Filled_border border;
    std::vector<Point> points;
    for(const auto h : cycle)
    {
      border.rim.push_back(mesh_.source(h));
      points.push_back(mesh_.point(border.rim.back()));
    }
    const Contour_shape shape = measure(points);
    border.radius = shape.radius();
    border.apex = mesh_.add_vertex(shape.centroid);
    Polygon spokes; // to the apex
    for(const auto v : border.rim)
      spokes.push_back(add_edge(v, border.apex));
    for(std::size_t i = 0; i != cycle.size(); ++i)
      add_face(mesh_, cycle[i], spokes[(i + 1) % cycle.size()], mesh_.opposite(spokes[i]));
    return border;
  }

public:
  static void add_face(Mesh& mesh, Mesh::Halfedge_index a, Mesh::Halfedge_index b, Mesh::Halfedge_index c)
  {
    const auto face = mesh.add_face();
    mesh.set_halfedge(face, a);
    for(const auto& [h, next] : {std::make_pair(a, b), std::make_pair(b, c), std::make_pair(c, a)})
    {
      mesh.set_face(h, face);
      mesh.set_next(h, next);
      mesh.set_halfedge(mesh.target(h), h);
    }
  }

private:
  Filled_component& component_;
  Mesh& mesh_;
  Polygon path_;
  std::map<Point, std::size_t> places_; // how many halfedges of the path lead to a point
  std::vector<Polygon> polygons_;
};

// Makes the components of a checked surface, in the order of their least points. Vertices without faces are in none.
// Vertices, edges and faces are in an order that only the points decide, as long as no two are the same.
template <class Complex>
class Component_filling
{
public:
  Component_filling(const Complex& complex, const Indexed_vector<Vertex_index, Point>& points)
    : complex_(complex),
      points_(points)
  {
    local_vertices_.resize(complex.number_of_vertices());
    local_halfedges_.resize(complex.number_of_halfedges());
    component_of_.assign(complex.number_of_vertices(), no_index);
    label();
  }

  std::size_t number_of_components() const { return given_.size(); }

  Filled_component make(std::size_t number)
  {
    Filled_component component;
    component.given = std::move(given_[number]);
    add_vertices(component);
    const std::vector<Halfedge_index> halfedges = add_edges(component);
    for(const Halfedge_index h : halfedges)
    {
      if(complex_.has_triangle(h) && is_unset(component.mesh, h))
        add_triangle(component.mesh, h);
    }
    Border_filling borders(component);
    for(const Halfedge_index h : halfedges)
      if(!complex_.has_triangle(h) && is_unset(component.mesh, h))
        borders.add(border(component.mesh, h));
    borders.fill();
    return component;
  }

private:
  void label()
  {
    std::vector<Vertex_index> queue;
    Index number_of_components = 0;
    for(const Vertex_index root : complex_.vertices())
    {
      if(component_of_[root] != no_index || !complex_.has_vertex(root) || complex_.first_halfedge(root) == no_index)
        continue;
      component_of_[root] = number_of_components;
      queue.assign(1, root);
      for(std::size_t i = 0; i != queue.size(); ++i)
        complex_.for_each_edge_around(queue[i], [&](Vertex_index neighbor, Halfedge_index) {
          if(component_of_[neighbor] == no_index)
          {
            component_of_[neighbor] = number_of_components;
            queue.push_back(neighbor);
          }
        });
      ++number_of_components;
    }
    given_.resize(number_of_components);
    for(const Vertex_index v : complex_.vertices())
      if(component_of_[v] != no_index)
        given_[component_of_[v]].push_back(v.number());
    const auto is_less = [&](Index u, Index v) { return points_[Vertex_index(u)] < points_[Vertex_index(v)]; };
    for(std::vector<Index>& given : given_) // the least point first
      std::iter_swap(given.begin(), std::min_element(given.begin(), given.end(), is_less));
    std::stable_sort(given_.begin(), given_.end(),
                     [&](const auto& a, const auto& b) { return is_less(a.front(), b.front()); });
  }

  // Adds the given vertices, multiplied by a power of two: nothing is rounded, and no product of three coordinates overflows.
  // Their order follows a space-filling curve, so that neighbors are near in memory.
  void add_vertices(Filled_component& component)
  {
    Bbox_3 box;
    for(const Index v : component.given)
      box += points_[Vertex_index(v)].bbox();
    double size = 0;
    for(int i = 0; i != 3; ++i)
      size = (std::max)(size, (box.max)(i) / 2 - (box.min)(i) / 2);
    component.exponent = size > 0 ? -std::ilogb(size) : 0;
    const auto scaled = [&](double x) { return std::scalbn(x, component.exponent); };
    const Point low(scaled(box.xmin()), scaled(box.ymin()), scaled(box.zmin()));
    std::vector<std::tuple<std::uint64_t, double, double, double, Index>> sorted;
    for(const Index v : component.given)
    {
      const Point& p = points_[Vertex_index(v)];
      const Point q(scaled(p.x()), scaled(p.y()), scaled(p.z()));
      sorted.emplace_back(place_on_curve(q, low), q.x(), q.y(), q.z(), v);
    }
    std::sort(sorted.begin(), sorted.end());
    const auto n = static_cast<Mesh::size_type>(sorted.size());
    component.mesh.reserve(n, 3 * n, 2 * n);
    component.given.clear();
    for(const auto& [place, x, y, z, v] : sorted)
    {
      component.given.push_back(v);
      local_vertices_[Vertex_index(v)] = component.mesh.add_vertex(Point(x, y, z));
    }
  }

  // The place of a point on the curve of Morton through the cells of a box, whose sides are below four.
  static std::uint64_t place_on_curve(const Point& p, const Point& low)
  {
    std::uint64_t result = 0;
    for(int bit = 20; bit >= 0; --bit)
      for(int i = 0; i != 3; ++i)
        result = 2 * result + (static_cast<std::uint64_t>((p[i] - low[i]) * (1 << 19)) >> bit & 1);
    return result;
  }

  // Returns the halfedges of the surface, in the order of the new ones.
  std::vector<Halfedge_index> add_edges(Filled_component& component)
  {
    std::vector<Halfedge_index> halfedges;
    std::vector<std::pair<Mesh::Vertex_index, Halfedge_index>> around;
    for(const Index number : component.given)
    {
      const Vertex_index v(number);
      around.clear();
      complex_.for_each_edge_around(v, [&](Vertex_index neighbor, Halfedge_index h) {
        if(local_vertices_[v] < local_vertices_[neighbor])
          around.emplace_back(local_vertices_[neighbor], complex_.target(h) == v ? opposite_of(h) : h);
      });
      std::sort(around.begin(), around.end());
      for(const auto& [neighbor, h] : around)
      {
        const auto added = component.mesh.add_edge();
        component.mesh.set_target(added, neighbor);
        component.mesh.set_target(component.mesh.opposite(added), local_vertices_[v]);
        local_halfedges_[h] = added;
        local_halfedges_[opposite_of(h)] = component.mesh.opposite(added);
        halfedges.push_back(h);
        halfedges.push_back(opposite_of(h));
      }
    }
    return halfedges;
  }

  bool is_unset(const Mesh& mesh, Halfedge_index h) const { return !mesh.next(local_halfedges_[h]).is_valid(); }

  void add_triangle(Mesh& mesh, Halfedge_index h)
  {
    const Halfedge_index second = complex_.next(h), third = complex_.next(second);
    Border_filling::add_face(mesh, local_halfedges_[h], local_halfedges_[second], local_halfedges_[third]);
  }

  // The halfedges of a border, from one of them on, which are linked.
  std::vector<Mesh::Halfedge_index> border(Mesh& mesh, Halfedge_index first) const
  {
    std::vector<Mesh::Halfedge_index> cycle;
    Halfedge_index h = first;
    do
    {
      cycle.push_back(local_halfedges_[h]);
      h = opposite_of(h);
      while(complex_.has_triangle(h))
        h = opposite_of(complex_.previous(h));
      mesh.set_next(cycle.back(), local_halfedges_[h]);
    } while(h != first);
    return cycle;
  }

  const Complex& complex_;
  const Indexed_vector<Vertex_index, Point>& points_;
  Indexed_vector<Vertex_index, Mesh::Vertex_index> local_vertices_;
  Indexed_vector<Halfedge_index, Mesh::Halfedge_index> local_halfedges_;
  Indexed_vector<Vertex_index, Index> component_of_;
  std::vector<std::vector<Index>> given_; // by component
};

} // namespace CGAL::Reeb_graph::internal::skeleton

#endif // CGAL_REEB_GRAPH_SKELETON_INTERNAL_COMPONENT_FILLING_H
