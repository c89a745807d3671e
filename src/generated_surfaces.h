// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of the CGAL-style package Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_SRC_GENERATED_SURFACES_H
#define CGAL_REEB_GRAPH_SRC_GENERATED_SURFACES_H

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

// Surfaces made from nothing, for the demo, the tests and the benchmarks. The same call gives the same surface.
namespace generated_surfaces {
struct Triangle_soup
{
  std::vector<std::array<double, 3>> points;
  std::vector<std::array<std::size_t, 3>> triangles;
};

namespace internal {
constexpr double pi = 3.14159265358979323846;

// A plate with round holes, and the same plate with its rounded rim rolled out into the plane. A point of the rolled
// out plate that is `distance` away from the border lies at the angle distance / thickness on the rim.
class Rolled_out_plate
{
public:
  struct Location
  {
    double distance;             // to the nearest border, negative outside of the plate
    double inwards_x, inwards_y; // the unit vector away from that border
  };
  static constexpr double thickness = 0.17; // the half of it; the centres of the holes are one unit apart
  static constexpr double rim = pi / 2 * thickness;
  static constexpr double hole_radius = 0.5 - rim;

  explicit Rolled_out_plate(unsigned genus)
    : genus_(genus),
      rows_((genus + 7) / 8),
      columns_(genus == 0 ? 0 : (genus + rows_ - 1) / rows_),
      corner_radius_(genus == 0 ? rim : hole_radius + 2 * rim),
      half_core_x_(genus == 0 ? 0 : (columns_ - 1) / 2.),
      half_core_y_(genus == 0 ? 0 : (rows_ - 1) / 2.)
  {}

  double half_width() const { return half_core_x_ + corner_radius_; }
  double half_height() const { return half_core_y_ + corner_radius_; }
  double area() const
  {
    return 4 * (half_core_x_ * half_core_y_ + (half_core_x_ + half_core_y_) * corner_radius_)
         + pi * (corner_radius_ * corner_radius_ - genus_ * hole_radius * hole_radius);
  }

  Location locate(double x, double y) const
  {
    const Location outer = locate_outer_border(x, y);
    const Location hole = locate_hole(x, y);
    return hole.distance < outer.distance ? hole : outer;
  }

  // rolls the rim up again, on the upper side
  std::array<double, 3> roll_up(double x, double y) const
  {
    const Location location = locate(x, y);
    const double distance = std::max(location.distance, 0.);
    if(distance >= rim)
      return {x, y, thickness};
    const double angle = distance / thickness;
    const double shift = rim - thickness * std::cos(angle) - distance;
    return {x + shift * location.inwards_x, y + shift * location.inwards_y, thickness * std::sin(angle)};
  }

private:
  Location locate_outer_border(double x, double y) const
  {
    const double dx = x - std::clamp(x, -half_core_x_, half_core_x_);
    const double dy = y - std::clamp(y, -half_core_y_, half_core_y_);
    const double length = std::hypot(dx, dy);
    if(length > 0)
      return {corner_radius_ - length, -dx / length, -dy / length};
    const double distance = std::min(half_core_x_ - std::abs(x), half_core_y_ - std::abs(y)) + corner_radius_;
    return {distance, 0, 0};
  }

  Location locate_hole(double x, double y) const
  {
    if(genus_ == 0)
      return {2 * rim, 0, 0};
    const double column = std::clamp(std::round(x + half_core_x_), 0., columns_ - 1.);
    const double row = std::clamp(std::round(y + half_core_y_), 0., rows_ - 1.);
    const double dx = x + half_core_x_ - column;
    const double dy = y + half_core_y_ - row;
    const double length = std::hypot(dx, dy);
    if(row * columns_ + column >= genus_ || length == 0)
      return {length == 0 ? -hole_radius : 2 * rim, 1, 0};
    return {length - hole_radius, dx / length, dy / length};
  }

  unsigned genus_, rows_, columns_;
  double corner_radius_, half_core_x_, half_core_y_;
};

// The plate meshed by a lattice of equilateral triangles. Lattice vertices near to the border are moved onto it, and
// lattice triangles that still cross it are cut.
class Plate_mesher
{
public:
  Plate_mesher(const Rolled_out_plate& plate, double edge_length)
    : plate_(plate),
      edge_length_(edge_length),
      row_height_(edge_length * std::sqrt(0.75)),
      columns_(static_cast<std::size_t>(2 * plate.half_width() / edge_length_) + 4),
      rows_(static_cast<std::size_t>(2 * plate.half_height() / row_height_) + 4)
  {
    place_lattice();
    cut_edge_points_.assign(3 * points_.size(), none);
    for(std::size_t row = 0; row + 1 < rows_; ++row)
      for(std::size_t column = 0; column + 1 < columns_; ++column)
      {
        const std::size_t a = row * columns_ + column, b = a + 1, c = a + columns_, d = c + 1;
        if(row % 2 == 0)
        {
          add_cut_triangle({a, b, c});
          add_cut_triangle({b, d, c});
        }
        else
        {
          add_cut_triangle({a, b, d});
          add_cut_triangle({a, d, c});
        }
      }
  }

  // the upper side, and its mirror image, which share the vertices on the border
  Triangle_soup double_of_plate() const
  {
    Triangle_soup soup;
    std::vector<std::array<std::size_t, 2>> copies(points_.size(), {none, none});
    for(const auto& t : triangles_)
      copies[t[0]][0] = copies[t[1]][0] = copies[t[2]][0] = 0;
    for(std::size_t v = 0; v < points_.size(); ++v)
    {
      if(copies[v][0] == none)
        continue;
      const std::array<double, 3> p = plate_.roll_up(points_[v][0], points_[v][1]);
      const bool is_on_border = signs_[v] == 0;
      copies[v] = {soup.points.size(), soup.points.size() + (is_on_border ? 0 : 1)};
      soup.points.push_back({p[0], p[1], is_on_border ? 0 : p[2]});
      if(!is_on_border)
        soup.points.push_back({p[0], p[1], -p[2]});
    }
    for(const std::array<std::size_t, 3>& t : triangles_)
    {
      soup.triangles.push_back({copies[t[0]][0], copies[t[1]][0], copies[t[2]][0]});
      soup.triangles.push_back({copies[t[0]][1], copies[t[2]][1], copies[t[1]][1]});
    }
    return soup;
  }

private:
  static constexpr std::size_t none = static_cast<std::size_t>(-1);

  void place_lattice()
  {
    for(std::size_t row = 0; row < rows_; ++row)
      for(std::size_t column = 0; column < columns_; ++column)
      {
        double x = (column + (row % 2) / 2. - columns_ / 2.) * edge_length_;
        double y = (row - rows_ / 2.) * row_height_;
        const double distance = plate_.locate(x, y).distance;
        const bool is_near = std::abs(distance) < 0.3 * edge_length_;
        add_point(x, y, is_near ? 0 : (distance > 0 ? 1 : -1));
      }
  }

  // sign: 1 inside, 0 on the border, -1 outside
  std::size_t add_point(double x, double y, int sign)
  {
    if(sign == 0)
    {
      const Rolled_out_plate::Location location = plate_.locate(x, y);
      x -= location.distance * location.inwards_x;
      y -= location.distance * location.inwards_y;
    }
    points_.push_back({x, y});
    signs_.push_back(static_cast<signed char>(sign));
    return points_.size() - 1;
  }

  std::size_t cut_point(std::size_t u, std::size_t v)
  {
    const std::size_t low = std::min(u, v), difference = std::max(u, v) - low;
    std::size_t& cut = cut_edge_points_[3 * low + (difference == 1 ? 0 : difference == columns_ ? 1 : 2)];
    if(cut == none)
    {
      const double du = std::abs(plate_.locate(points_[u][0], points_[u][1]).distance);
      const double dv = std::abs(plate_.locate(points_[v][0], points_[v][1]).distance);
      const double t = du / (du + dv);
      cut = add_point(points_[u][0] + t * (points_[v][0] - points_[u][0]),
                      points_[u][1] + t * (points_[v][1] - points_[u][1]), 0);
    }
    return cut;
  }

  void add_cut_triangle(std::array<std::size_t, 3> t)
  {
    polygon_.clear();
    bool has_inner_vertex = false;
    for(int i = 0; i < 3; ++i)
    {
      const std::size_t u = t[i], v = t[(i + 1) % 3];
      has_inner_vertex = has_inner_vertex || signs_[u] > 0;
      if(signs_[u] >= 0)
        polygon_.push_back(u);
      if(signs_[u] * signs_[v] < 0)
        polygon_.push_back(cut_point(u, v));
    }
    if(!has_inner_vertex)
      return;
    // a polygon of four begins at an inner vertex whose diagonal ends on the border
    if(polygon_.size() == 4 && (signs_[polygon_[0]] == 0) == (signs_[polygon_[2]] == 0))
      std::rotate(polygon_.begin(), polygon_.begin() + 1, polygon_.end());
    for(std::size_t i = 1; i + 1 < polygon_.size(); ++i)
      triangles_.push_back({polygon_[0], polygon_[i], polygon_[i + 1]});
  }

  const Rolled_out_plate& plate_;
  double edge_length_, row_height_;
  std::size_t columns_, rows_;
  std::vector<std::array<double, 2>> points_;
  std::vector<signed char> signs_;
  std::vector<std::size_t> cut_edge_points_;
  std::vector<std::array<std::size_t, 3>> triangles_;
  std::vector<std::size_t> polygon_;
};

// A grid of `columns` times `rows` vertices, where the last column is joined to the first one if it is closed so.
template <class PointFunction>
Triangle_soup grid(std::size_t columns,
                   std::size_t rows,
                   bool are_columns_closed,
                   bool are_rows_closed,
                   const PointFunction& point)
{
  Triangle_soup soup;
  for(std::size_t row = 0; row < rows; ++row)
    for(std::size_t column = 0; column < columns; ++column)
      soup.points.push_back(point(column, row));
  for(std::size_t row = 0; row + (are_rows_closed ? 0 : 1) < rows; ++row)
    for(std::size_t column = 0; column + (are_columns_closed ? 0 : 1) < columns; ++column)
    {
      const std::size_t right = (column + 1) % columns, up = (row + 1) % rows;
      const std::size_t a = row * columns + column, b = row * columns + right;
      const std::size_t c = up * columns + column, d = up * columns + right;
      soup.triangles.push_back({a, b, d});
      soup.triangles.push_back({a, d, c});
    }
  return soup;
}

} // namespace internal

// A connected closed surface of exactly that genus with outward faces: a rounded plate in the xy-plane with `genus`
// round holes, in rows of at most eight. Genus 0 is a sphere, genus 1 a torus. The number of vertices is right up to a
// factor of 2, except that each hole takes at least about 100 of them.
inline Triangle_soup closed_surface(unsigned genus, std::size_t number_of_vertices)
{
  const internal::Rolled_out_plate plate(genus);
  const double area_per_vertex = 2 * plate.area() / std::max<std::size_t>(number_of_vertices, 1);
  const double edge_length = std::sqrt(area_per_vertex / std::sqrt(0.75));
  return internal::Plate_mesher(plate, std::min(edge_length, 0.8 * plate.hole_radius)).double_of_plate();
}

// Smooth hills over the unit square, a grid of `columns` times `rows` vertices, at least 2 each.
inline Triangle_soup terrain(std::size_t columns, std::size_t rows)
{
  return internal::grid(columns, rows, false, false, [&](std::size_t column, std::size_t row) {
    const double x = column / (columns - 1.), y = row / (rows - 1.);
    const double z = 0.10 * std::sin(7 * x + 1) * std::cos(6 * y) + 0.05 * std::sin(17 * x - 9 * y)
                   + 0.02 * std::cos(23 * x + 31 * y + 2);
    return std::array<double, 3>{x, y, z};
  });
}

// A torus around the z-axis, with `around` vertices around the tube and `along` vertices along it, at least 3 each.
inline Triangle_soup torus(std::size_t around, std::size_t along)
{
  return internal::grid(along, around, true, true, [&](std::size_t column, std::size_t row) {
    const double u = 2 * internal::pi * column / along, v = 2 * internal::pi * row / around;
    const double radius = 1 + 0.4 * std::cos(v);
    return std::array<double, 3>{radius * std::cos(u), radius * std::sin(u), 0.4 * std::sin(v)};
  });
}

} // namespace generated_surfaces

#endif // CGAL_REEB_GRAPH_SRC_GENERATED_SURFACES_H
