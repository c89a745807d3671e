// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_SRC_GENERATED_SURFACES_IMPLICIT_SURFACE_H
#define CGAL_REEB_GRAPH_SRC_GENERATED_SURFACES_IMPLICIT_SURFACE_H

#include "generated_surfaces/Triangle_soup.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <utility>
#include <vector>

namespace generated_surfaces::internal {
typedef std::array<double, 3> Vector;

inline Vector moved(const Vector& p, double t, const Vector& direction)
{
  return {p[0] + t * direction[0], p[1] + t * direction[1], p[2] + t * direction[2]};
}

inline Vector difference(const Vector& p, const Vector& q) { return moved(p, -1, q); }

inline double dot(const Vector& p, const Vector& q) { return p[0] * q[0] + p[1] * q[1] + p[2] * q[2]; }

inline Vector cross(const Vector& p, const Vector& q)
{
  return {p[1] * q[2] - p[2] * q[1], p[2] * q[0] - p[0] * q[2], p[0] * q[1] - p[1] * q[0]};
}

// Cuts the tetrahedra of a grid of cubes, six in each, with the surface on which a function is 0: a closed manifold,
// as long as the function is positive at the border of the box. It is negative inside of the surface.
template <class Function>
class Marching_tetrahedra
{
public:
  Marching_tetrahedra(const Function& function, const Vector& lowest, const Vector& highest, double cell_size)
    : lowest_(lowest),
      cell_size_(cell_size)
  {
    for(int i = 0; i < 3; ++i)
      size_[i] = static_cast<std::size_t>((highest[i] - lowest[i]) / cell_size) + 2;
    values_.resize(size_[0] * size_[1] * size_[2]);
    for(std::size_t corner = 0; corner < values_.size(); ++corner)
      values_[corner] = function(point(corner));
    for(std::size_t z = 0; z + 1 < size_[2]; ++z)
      for(std::size_t y = 0; y + 1 < size_[1]; ++y)
        for(std::size_t x = 0; x + 1 < size_[0]; ++x)
          cut_cube(x + size_[0] * (y + size_[1] * z));
  }

  Triangle_soup take_surface() { return std::move(surface_); }

private:
  Vector point(std::size_t corner) const
  {
    const std::size_t x = corner % size_[0], y = corner / size_[0] % size_[1], z = corner / size_[0] / size_[1];
    return {lowest_[0] + cell_size_ * x, lowest_[1] + cell_size_ * y, lowest_[2] + cell_size_ * z};
  }

  // The tetrahedra are the monotone paths along edges from the lowest corner to the highest one.
  void cut_cube(std::size_t corner)
  {
    std::array<std::size_t, 3> steps = {1, size_[0], size_[0] * size_[1]};
    std::sort(steps.begin(), steps.end());
    do
    {
      std::array<std::size_t, 4> corners = {corner, 0, 0, 0};
      for(int i = 0; i < 3; ++i)
        corners[i + 1] = corners[i] + steps[i];
      cut_tetrahedron(corners);
    } while(std::next_permutation(steps.begin(), steps.end()));
  }

  void cut_tetrahedron(std::array<std::size_t, 4> corners)
  {
    const auto is_inside = [&](std::size_t corner) { return values_[corner] < 0; };
    const auto outside = std::stable_partition(corners.begin(), corners.end(), is_inside);
    const auto [a, b, c, d] = corners;
    switch(outside - corners.begin())
    {
    case 1: add_triangle({vertex(a, b), vertex(a, c), vertex(a, d)}, a, b); break;
    case 2:
      add_triangle({vertex(a, c), vertex(a, d), vertex(b, d)}, a, d);
      add_triangle({vertex(a, c), vertex(b, d), vertex(b, c)}, b, c);
      break;
    case 3: add_triangle({vertex(a, d), vertex(b, d), vertex(c, d)}, a, d); break;
    default: break;
    }
  }

  std::size_t vertex(std::size_t a, std::size_t b)
  {
    const auto [place, is_new] = vertices_.emplace(std::minmax(a, b), surface_.points.size());
    if(is_new)
    {
      // not too near to the corners, so that no triangle degenerates
      const double t = std::clamp(values_[a] / (values_[a] - values_[b]), 0.1, 0.9);
      surface_.points.push_back(moved(point(a), t, difference(point(b), point(a))));
    }
    return place->second;
  }

  // The triangle is turned so that its normal points from a corner inside to one outside.
  void add_triangle(std::array<std::size_t, 3> triangle, std::size_t inside, std::size_t outside)
  {
    const auto& points = surface_.points;
    const Vector normal =
      cross(difference(points[triangle[1]], points[triangle[0]]), difference(points[triangle[2]], points[triangle[0]]));
    if(dot(normal, difference(point(outside), point(inside))) < 0)
      std::swap(triangle[1], triangle[2]);
    surface_.triangles.push_back(triangle);
  }

  Vector lowest_;
  double cell_size_;
  std::array<std::size_t, 3> size_; // corners along each axis
  std::vector<double> values_;
  std::map<std::pair<std::size_t, std::size_t>, std::size_t> vertices_; // by edges of the grid
  Triangle_soup surface_;
};

// Moves each vertex to the middle of its neighbors, and back to the surface along the gradient, several times.
template <class Function>
void smooth(Triangle_soup& surface, const Function& function, int number_of_steps)
{
  for(int step = 0; step < number_of_steps; ++step)
  {
    std::vector<Vector> sums(surface.points.size(), Vector{0, 0, 0});
    std::vector<double> weights(surface.points.size(), 0);
    for(const auto& triangle : surface.triangles)
      for(int i = 0; i < 3; ++i)
      {
        // each neighbor is seen in one triangle as the next vertex
        sums[triangle[i]] = moved(sums[triangle[i]], 1, surface.points[triangle[(i + 1) % 3]]);
        ++weights[triangle[i]];
      }
    for(std::size_t v = 0; v < surface.points.size(); ++v)
    {
      Vector& p = surface.points[v];
      p = moved({0, 0, 0}, 1 / weights[v], sums[v]);
      constexpr double h = 1e-5;
      const Vector gradient = {(function(moved(p, h, {1, 0, 0})) - function(moved(p, -h, {1, 0, 0}))) / (2 * h),
                               (function(moved(p, h, {0, 1, 0})) - function(moved(p, -h, {0, 1, 0}))) / (2 * h),
                               (function(moved(p, h, {0, 0, 1})) - function(moved(p, -h, {0, 0, 1}))) / (2 * h)};
      p = moved(p, -function(p) / std::max(dot(gradient, gradient), 0.1), gradient);
    }
  }
}

} // namespace generated_surfaces::internal

#endif // CGAL_REEB_GRAPH_SRC_GENERATED_SURFACES_IMPLICIT_SURFACE_H
