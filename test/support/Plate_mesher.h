// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_SRC_GENERATED_SURFACES_PLATE_MESHER_H
#define CGAL_REEB_GRAPH_SRC_GENERATED_SURFACES_PLATE_MESHER_H

#include "Rolled_out_plate.h"
#include "generated_surfaces/Triangle_soup.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace generated_surfaces::internal {
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

} // namespace generated_surfaces::internal

#endif // CGAL_REEB_GRAPH_SRC_GENERATED_SURFACES_PLATE_MESHER_H
