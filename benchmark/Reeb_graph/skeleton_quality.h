// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_BENCHMARK_SKELETON_QUALITY_H
#define CGAL_REEB_GRAPH_BENCHMARK_SKELETON_QUALITY_H

#include <CGAL/AABB_face_graph_triangle_primitive.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/Side_of_triangle_mesh.h>
#include <CGAL/version.h>
#if CGAL_VERSION_NR >= 1060000000
#include <CGAL/AABB_traits_3.h>
#else
#include <CGAL/AABB_traits.h>
#endif

#include <cmath>
#include <cstddef>
#include <map>
#include <vector>

// How good lines are as a skeleton of a closed surface, whoever has drawn them.
namespace benchmark {
// Means over samples that are as far apart from each other along the lines.
struct Skeleton_quality
{
  double centered = 0; // the distance from the surface by the greatest one near it across the line, of samples inside
  double inside = 0;   // the share of samples
  double turning = 0;  // the sum of the angles between segments, apart from nodes
  double length = 0;
  std::size_t ends = 0, junctions = 0;
};

template <class Kernel, class Mesh>
class Skeleton_judge
{
public:
  typedef typename Kernel::Point_3 Point;
  typedef typename Kernel::Vector_3 Vector;
  typedef std::vector<std::vector<Point>> Lines; // from node to node

  explicit Skeleton_judge(const Mesh& mesh) : tree_(faces(mesh).begin(), faces(mesh).end(), mesh), side_(tree_) {}

  Skeleton_quality operator()(const Lines& lines, std::size_t number_of_samples) const
  {
    Skeleton_quality result;
    std::map<Point, std::size_t> degrees;
    for(const auto& line : lines)
    {
      ++degrees[line.front()];
      ++degrees[line.back()];
      for(std::size_t i = 1; i != line.size(); ++i)
      {
        result.length += length(line[i] - line[i - 1]);
        if(i + 1 != line.size())
          result.turning += angle(line[i] - line[i - 1], line[i + 1] - line[i]);
      }
    }
    for(const auto& [point, degree] : degrees)
    {
      result.ends += degree == 1 ? 1 : 0;
      result.junctions += degree > 2 ? 1 : 0;
    }
    const double step = result.length / static_cast<double>(number_of_samples);
    double next = step / 2; // how far the next sample is, along all lines
    for(const auto& line : lines)
      for(std::size_t i = 1; i != line.size(); ++i)
      {
        const Vector along = line[i] - line[i - 1];
        for(; next < length(along); next += step)
          add_sample(line[i - 1] + next / length(along) * along, along / length(along), result);
        next -= length(along);
      }
    if(result.inside > 0)
      result.centered /= result.inside;
    result.inside /= static_cast<double>(number_of_samples);
    return result;
  }

private:
  static double length(const Vector& v) { return std::sqrt(v.squared_length()); }

  static double angle(const Vector& a, const Vector& b) { return std::atan2(length(cross_product(a, b)), a * b); }

  double distance(const Point& p) const { return std::sqrt(tree_.squared_distance(p)); }

  void add_sample(const Point& p, const Vector& along, Skeleton_quality& result) const
  {
    if(side_(p) != CGAL::ON_BOUNDED_SIDE)
      return;
    result.inside += 1;
    const double here = distance(p);
    result.centered += here / greatest_across(p, here, along);
  }

  // Climbs to where the distance is greatest, in the plane across the line, by steps that stay inside.
  double greatest_across(Point p, double greatest, const Vector& along) const
  {
    const Vector other = std::abs(along.x()) < 0.6 ? Vector(1, 0, 0) : Vector(0, 1, 0);
    const Vector u = cross_product(along, other) / length(cross_product(along, other)), v = cross_product(along, u);
    for(double share = 0.5; share > 0.01;)
    {
      Point best = p;
      double found = greatest * (1 + share / 100);
      for(int i = 0; i != 12; ++i)
      {
        const double turn = i * 3.14159265358979323846 / 6;
        const Point q = p + share * greatest * (std::cos(turn) * u + std::sin(turn) * v);
        if(const double there = distance(q); there > found)
        {
          found = there;
          best = q;
        }
      }
      if(best == p)
        share /= 2;
      else
      {
        p = best;
        greatest = found;
      }
    }
    return greatest;
  }

  typedef CGAL::AABB_face_graph_triangle_primitive<Mesh> Primitive;
#if CGAL_VERSION_NR >= 1060000000
  typedef CGAL::AABB_traits_3<Kernel, Primitive> Traits;
#else
  typedef CGAL::AABB_traits<Kernel, Primitive> Traits;
#endif
  typedef CGAL::AABB_tree<Traits> Tree;

  Tree tree_;
  CGAL::Side_of_triangle_mesh<Mesh, Kernel, CGAL::Default, Tree> side_;
};

} // namespace benchmark

#endif // CGAL_REEB_GRAPH_BENCHMARK_SKELETON_QUALITY_H
