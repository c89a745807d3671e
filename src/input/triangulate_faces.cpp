// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#include "input/assemble_surface.h"

#include "input/repair_soup.h"

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Constrained_triangulation_face_base_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Reeb_graph/handles/internal/triangulate_disc.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <set>
#include <unordered_set>
#include <utility>
#include <vector>

namespace reeb_graph_program {
namespace {
typedef CGAL::Exact_predicates_inexact_constructions_kernel Kernel;
typedef Kernel::Vector_3 Vector;
typedef std::array<std::size_t, 3> Corners; // of a triangle, ascending numbers of corners of the polygon

// The ends of edges that are there.
class Taken_edges
{
public:
  explicit Taken_edges(const Polygon_soup& soup)
  {
    sides_.reserve(soup.polygons.number_of_corners() + soup.edges.size());
    for_each_side(soup.polygons, [&](Corner u, Corner v) { sides_.push_back(key(u, v)); });
    for(const auto& [u, v] : soup.edges)
      sides_.push_back(key(u, v));
    std::sort(sides_.begin(), sides_.end());
  }

  void insert(Corner u, Corner v) { diagonals_.insert(key(u, v)); }
  bool has(Corner u, Corner v) const
  {
    return diagonals_.count(key(u, v)) != 0 || std::binary_search(sides_.begin(), sides_.end(), key(u, v));
  }

private:
  static std::uint64_t key(Corner u, Corner v) { return std::uint64_t{std::min(u, v)} << 32U | std::max(u, v); }

  std::vector<std::uint64_t> sides_;
  std::unordered_set<std::uint64_t> diagonals_;
};

// One polygon, in units in which nothing overflows.
class Polygon_cut
{
public:
  // The third vertices are those of the faces beside a border.
  Polygon_cut(const std::vector<Point>& points,
              Polygons::Polygon polygon,
              const Taken_edges& taken,
              const std::vector<Corner>& third_vertices = {})
    : polygon_(polygon),
      taken_(taken),
      size_(polygon.size())
  {
    double largest = 0;
    const Polygons::Polygon others(third_vertices.data(), third_vertices.data() + third_vertices.size());
    for(const Polygons::Polygon& of : {polygon, others})
      for(const Corner v : of)
        for(int i = 0; i < 3; ++i)
          largest = std::max(largest, std::abs(points[v][i]));
    const int exponent = largest > 0 ? -std::ilogb(largest) : 0;
    const auto scaled = [&](Corner v) {
      return Vector(std::ldexp(points[v].x(), exponent), std::ldexp(points[v].y(), exponent),
                    std::ldexp(points[v].z(), exponent));
    };
    for(const Corner v : polygon)
      corners_.push_back(scaled(v));
    for(const Corner v : third_vertices)
      third_points_.push_back(CGAL::ORIGIN + (scaled(v) - corners_[0]));
  }

  // Returns none if the polygon cannot be cut.
  std::vector<Corners> triangles() const
  {
    bool has_area = false;
    for(std::size_t i = 2; i < size_; ++i)
      has_area = has_area || normal(0, i - 1, i) != CGAL::NULL_VECTOR;
    if(!has_area)
      return {};
    if(size_ == 4)
      return triangles_of_quadrilateral();
    std::vector<Corners> result = triangles_in_plane();
    return result.empty() || is_any_taken(result) ? triangles_in_space() : result;
  }

  // A disc of little area, if there is one without diagonals that are there, else with such.
  std::vector<Corners> triangles_in_space() const
  {
    std::vector<CGAL::Reeb_graph::internal::Disc_point> points;
    for(const Vector& corner : corners_)
      points.push_back(CGAL::ORIGIN + (corner - corners_[0]));
    std::vector<Corners> result;
    for(const bool is_free : {true, false})
      if(result.empty())
        result = CGAL::Reeb_graph::internal::triangulate_disc(
          points, third_points_, [&](std::size_t i, std::size_t j) { return is_free && is_taken(i, j); });
    for(Corners& triangle : result)
      std::sort(triangle.begin(), triangle.end());
    return result;
  }

  // Whether a diagonal is an edge that is there.
  bool is_any_taken(const std::vector<Corners>& triangles) const
  {
    return std::any_of(triangles.begin(), triangles.end(), [&](const Corners& t) {
      return is_taken(t[0], t[1]) || is_taken(t[1], t[2]) || is_taken(t[0], t[2]);
    });
  }

  // Calls visit(u, v) for the diagonals of triangles, some of them twice.
  template <class Visit>
  void visit_diagonals(const Corners& triangle, const Visit& visit) const
  {
    for(const auto& [i, j] : {std::pair(0, 1), std::pair(1, 2), std::pair(0, 2)})
      if(!is_side(triangle[i], triangle[j]))
        visit(vertex(triangle[i]), vertex(triangle[j]));
  }

  Corner vertex(std::size_t i) const { return polygon_.begin()[i]; }

private:
  bool is_side(std::size_t i, std::size_t j) const { return j == i + 1 || (i == 0 && j + 1 == size_); }
  bool is_taken(std::size_t i, std::size_t j) const
  {
    const auto [least, most] = std::minmax(i, j);
    return !is_side(least, most) && taken_.has(vertex(i), vertex(j));
  }

  Vector normal(std::size_t i, std::size_t j, std::size_t k) const
  {
    return CGAL::cross_product(corners_[j] - corners_[i], corners_[k] - corners_[i]);
  }

  // By the diagonal where both triangles face the same way, and neither is thin.
  std::vector<Corners> triangles_of_quadrilateral() const
  {
    const double of_02 = normal(1, 2, 0) * normal(3, 0, 2), of_13 = normal(2, 3, 1) * normal(0, 1, 3);
    const bool is_02 = is_taken(0, 2) == is_taken(1, 3) ? of_02 > of_13 : is_taken(1, 3);
    return is_02 ? std::vector<Corners>{{0, 1, 2}, {0, 2, 3}} : std::vector<Corners>{{0, 1, 3}, {1, 2, 3}};
  }

  // The corners in the plane in which the polygon has the largest area; none if it has no area.
  std::vector<Kernel::Point_2> projection() const
  {
    Vector up = CGAL::NULL_VECTOR;
    for(std::size_t i = 2; i < size_; ++i)
      up += normal(0, i - 1, i);
    const double length = std::sqrt(up.squared_length());
    if(!(length > 0))
      return {};
    up = up / length;
    int least = 0;
    for(const int i : {1, 2})
      least = std::abs(up[i]) < std::abs(up[least]) ? i : least;
    const Vector axis(least == 0 ? 1 : 0, least == 1 ? 1 : 0, least == 2 ? 1 : 0);
    const Vector right = CGAL::cross_product(axis, up), ahead = CGAL::cross_product(up, right);
    std::vector<Kernel::Point_2> result;
    for(const Vector& corner : corners_)
      result.emplace_back((corner - corners_[0]) * right, (corner - corners_[0]) * ahead);
    return result;
  }

  // Constrained Delaunay triangles of the projection, none if that touches or crosses itself: if its sides are not all
  // edges of them.
  std::vector<Corners> triangles_in_plane() const
  {
    typedef CGAL::Triangulation_vertex_base_with_info_2<std::size_t, Kernel> Vertex_base;
    typedef CGAL::Constrained_triangulation_face_base_2<Kernel> Face_base;
    typedef CGAL::Constrained_Delaunay_triangulation_2<Kernel,
                                                       CGAL::Triangulation_data_structure_2<Vertex_base, Face_base>>
      Triangulation;
    Triangulation triangulation;
    std::vector<Triangulation::Vertex_handle> vertices;
    for(const Kernel::Point_2& point : projection())
    {
      vertices.push_back(triangulation.insert(point, vertices.empty() ? nullptr : vertices.back()->face()));
      vertices.back()->info() = vertices.size() - 1;
    }
    if(triangulation.dimension() != 2 || triangulation.number_of_vertices() != size_)
      return {};
    try
    {
      for(std::size_t i = 0; i < size_; ++i)
        triangulation.insert_constraint(vertices[i], vertices[(i + 1) % size_]);
    }
    catch(const Triangulation::Intersection_of_constraints_exception&)
    {
      return {};
    }
    std::size_t number_of_sides = 0;
    std::vector<Corners> result;
    for(std::size_t i = 0; i < size_; ++i)
      number_of_sides += triangulation.is_edge(vertices[i], vertices[(i + 1) % size_]) ? 1 : 0;
    if(number_of_sides == size_)
      add_inner_triangles(triangulation, result);
    return result;
  }

  // Those on the left of the sides, and what is joined to them by other edges.
  template <class Triangulation>
  void add_inner_triangles(const Triangulation& triangulation, std::vector<Corners>& result) const
  {
    std::vector<typename Triangulation::Face_handle> faces(1, triangulation.infinite_face());
    std::set<typename Triangulation::Face_handle> outer(faces.begin(), faces.end());
    while(!faces.empty())
    {
      const auto face = faces.back();
      faces.pop_back();
      for(int i = 0; i < 3; ++i)
        if(!face->is_constrained(i) && outer.insert(face->neighbor(i)).second)
          faces.push_back(face->neighbor(i));
    }
    for(const auto face : triangulation.finite_face_handles())
      if(outer.count(face) == 0)
      {
        result.push_back({face->vertex(0)->info(), face->vertex(1)->info(), face->vertex(2)->info()});
        std::sort(result.back().begin(), result.back().end());
      }
  }

  Polygons::Polygon polygon_;
  const Taken_edges& taken_;
  std::size_t size_;
  std::vector<Vector> corners_;
  std::vector<CGAL::Reeb_graph::internal::Disc_point> third_points_; // from the first corner on
};

struct Border
{
  std::vector<Corner> vertices, third_vertices; // the latter of the faces at the edges that begin at the former
};

// Those of at most so many edges, against the direction of their faces, so that a polygon that fills one agrees with them.
// They pass no vertex twice, and their faces agree.
std::vector<Border> small_borders(const Polygon_soup& soup, std::size_t most_edges)
{
  const std::vector<Polygon_side> sides = sides_of(soup.polygons);
  std::vector<Corner> next(soup.points.size(), too_large_corner), third = next;
  std::vector<std::array<char, 2>> numbers(soup.points.size(), {0, 0}); // of border edges that begin, and that end
  for_each_edge(sides, [&](std::size_t begin, std::size_t end) {
    if(end - begin != 1)
      return;
    const auto [low, high] = std::pair(sides[begin].u, sides[begin].v);
    const Corner from = sides[begin].is_descending ? low : high, to = sides[begin].is_descending ? high : low;
    next[from] = to;
    for(const Corner v : soup.polygons[sides[begin].face])
      third[from] = v != low && v != high ? v : third[from];
    numbers[from][0] = numbers[from][0] == 0 ? 1 : 2;
    numbers[to][1] = numbers[to][1] == 0 ? 1 : 2;
  });
  std::vector<Border> borders;
  std::vector<char> is_passed(soup.points.size(), 0);
  for(std::size_t first = 0; first < soup.points.size(); ++first)
  {
    Border border;
    Corner v = static_cast<Corner>(first);
    for(; numbers[v] == std::array<char, 2>{1, 1} && is_passed[v] == 0; v = next[v])
    {
      is_passed[v] = 1;
      border.vertices.push_back(v);
      border.third_vertices.push_back(third[v]);
    }
    if(!border.vertices.empty() && v == first && border.vertices.size() <= most_edges)
      borders.push_back(border);
  }
  return borders;
}

} // namespace

std::size_t fill_borders(Polygon_soup& soup, std::size_t most_edges, std::vector<std::array<Corner, 2>>& origins)
{
  const std::vector<Border> borders = small_borders(soup, most_edges);
  Taken_edges taken(soup);
  for(const auto& [v, third_vertices] : borders)
  {
    const Polygon_cut cut(soup.points, Polygons::Polygon(v.data(), v.data() + v.size()), taken, third_vertices);
    const std::vector<Corners> triangles = v.size() == 3 ? std::vector<Corners>{{0, 1, 2}} : cut.triangles_in_space();
    const bool is_lone = v.size() == 3 && third_vertices[0] == v[2]; // a triangle, which no other one may repeat
    const bool is_filled = !triangles.empty() && !is_lone && !cut.is_any_taken(triangles);
    for(const Corners& t : is_filled ? triangles : std::vector<Corners>())
    {
      soup.polygons.add(std::array<Corner, 3>{v[t[0]], v[t[1]], v[t[2]]});
      cut.visit_diagonals(t, [&](Corner from, Corner to) { taken.insert(from, to); });
    }
    if(is_filled)
      continue;
    const std::size_t center = soup.points.size();
    soup.points.push_back(mean_of(soup.points, v));
    origins.push_back({v[0], v[v.size() / 2]});
    for(std::size_t i = 0; i < v.size(); ++i)
      soup.polygons.add(std::array<std::size_t, 3>{v[i], v[(i + 1) % v.size()], center});
  }
  return borders.size();
}

namespace {
// Cuts the polygons for which is_meant(number) holds. Returns the number of the first one that cannot be cut.
template <class Is_meant, class Cut>
std::optional<std::size_t> cut_polygons(Polygon_soup& soup, const Is_meant& is_meant, const Cut& cut_polygon)
{
  Taken_edges taken(soup);
  Polygons polygons;
  std::vector<std::size_t> copies;
  for(std::size_t i = 0; i < soup.polygons.size(); ++i)
  {
    const std::size_t number = soup.copies.empty() ? 1 : soup.copies[i];
    if(soup.polygons[i].size() == 3 || !is_meant(i))
    {
      polygons.add(soup.polygons[i]);
      copies.push_back(number);
      continue;
    }
    const Polygon_cut cut(soup.points, soup.polygons[i], taken);
    const std::vector<Corners> pieces = cut_polygon(cut);
    if(pieces.empty())
      return i;
    for(const Corners& piece : pieces)
    {
      polygons.add(std::array<Corner, 3>{cut.vertex(piece[0]), cut.vertex(piece[1]), cut.vertex(piece[2])});
      copies.push_back(number);
      cut.visit_diagonals(piece, [&](Corner u, Corner v) { taken.insert(u, v); });
    }
  }
  soup.polygons = std::move(polygons);
  soup.copies = std::move(copies);
  return std::nullopt;
}

} // namespace

std::optional<std::size_t> triangulate_faces(Polygon_soup& soup)
{
  if(soup.polygons.are_triangles())
    return std::nullopt;
  return cut_polygons(
    soup, [](std::size_t) { return true; }, [](const Polygon_cut& cut) { return cut.triangles(); });
}

void cut_into_triangles(Polygon_soup& soup, const std::vector<char>& is_meant)
{
  cut_polygons(
    soup, [&](std::size_t i) { return is_meant[i] != 0; },
    [](const Polygon_cut& cut) {
      const std::vector<Corners> triangles = cut.triangles();
      return triangles.empty() ? cut.triangles_in_space() : triangles;
    });
}

} // namespace reeb_graph_program
