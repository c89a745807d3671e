// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_TEST_LEVEL_ORACLE_H
#define CGAL_REEB_GRAPH_TEST_LEVEL_ORACLE_H

#include "curve_samples.h"

#include <CGAL/Exact_rational.h>
#include <CGAL/number_utils.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <set>
#include <utility>
#include <vector>

// Level sets by marching from triangle to triangle, in exact fractions, without any of the code that cuts along them.
namespace level_oracle {
typedef CGAL::Exact_rational Fraction;

// A point of a level set: on the edge between two vertices, the lower one first, or twice a vertex.
typedef std::array<std::size_t, 2> Key;
typedef std::pair<Key, Key> Segment; // the lesser key first

inline Key make_edge(std::size_t u, std::size_t w) { return {std::min(u, w), std::max(u, w)}; }
inline Segment make_segment(const Key& a, const Key& b) { return std::minmax({a, b}); }

class Marching
{
public:
  // The levels ascend.
  Marching(const curve_samples::Sample& sample, const std::vector<double>& levels) : sample_(sample), levels_(levels) {}

  // The segments of a level, each once.
  std::set<Segment> segments(double level) const
  {
    std::set<Segment> result;
    for(const auto& t : sample_.soup.triangles)
    {
      std::vector<Key> keys;
      for(std::size_t i = 0; i < 3; ++i)
      {
        const std::size_t u = t[i], w = t[(i + 1) % 3];
        if(value(u) == level)
          keys.push_back({u, u});
        if(std::min(value(u), value(w)) < level && level < std::max(value(u), value(w)))
          keys.push_back(value(u) < value(w) ? Key{u, w} : Key{w, u});
      }
      for(std::size_t i = 0; i < keys.size(); ++i)
        for(std::size_t j = 0; j < i; ++j)
          result.insert(make_segment(keys[i], keys[j]));
    }
    return result;
  }

  Fraction fraction(const Key& key, double level) const
  {
    return (Fraction(level) - Fraction(value(key[0]))) / (Fraction(value(key[1])) - Fraction(value(key[0])));
  }

  // The areas of the pieces of all bands, each with the number of its band, sorted.
  std::vector<std::pair<std::size_t, double>> pieces() const
  {
    std::map<Part, double> areas;
    std::map<Part, Part> parents;
    std::map<Key, std::vector<std::size_t>> triangles_at;
    for(std::size_t t = 0; t < sample_.soup.triangles.size(); ++t)
    {
      const auto& triangle = sample_.soup.triangles[t];
      for(std::size_t band = 0; band <= levels_.size(); ++band)
        if(has_part(triangle, band))
        {
          areas[{t, band}] = area(triangle, band);
          parents[{t, band}] = {t, band};
        }
      for(std::size_t i = 0; i < 3; ++i)
        triangles_at[make_edge(triangle[i], triangle[(i + 1) % 3])].push_back(t);
    }
    const auto find = [&](Part part) {
      while(parents.at(part) != part)
        part = parents.at(part);
      return part;
    };
    for(const auto& [edge, triangles] : triangles_at)
      for(std::size_t band = 0; band <= levels_.size() && triangles.size() == 2; ++band)
        if(shares_band(edge, band))
          parents.at(find({triangles[0], band})) = find({triangles[1], band});
    std::map<Part, double> sums;
    for(const auto& [part, area] : areas)
      sums[find(part)] += area;
    std::vector<std::pair<std::size_t, double>> result;
    for(const auto& [part, sum] : sums)
      result.emplace_back(part.second, sum);
    std::sort(result.begin(), result.end());
    return result;
  }

private:
  typedef std::pair<std::size_t, std::size_t> Part; // a triangle and a band
  typedef random_meshes::Vertex_triple Triangle;

  double value(std::size_t v) const { return sample_.values[v]; }

  // Whether two triangles at an edge belong together in a band: where more than points of the edge are inside of it.
  bool shares_band(const Key& edge, std::size_t band) const
  {
    const auto [low, high] = std::minmax({value(edge[0]), value(edge[1])});
    return (band == 0 || levels_[band - 1] < high) && (band == levels_.size() || low < levels_[band]);
  }

  bool has_part(const Triangle& t, std::size_t band) const
  {
    const auto [low, high] = std::minmax({value(t[0]), value(t[1]), value(t[2])});
    if(low == high)
      return band == static_cast<std::size_t>(std::lower_bound(levels_.begin(), levels_.end(), low) - levels_.begin());
    return (band == 0 || levels_[band - 1] < high) && (band == levels_.size() || low < levels_[band]);
  }

  // The area of what is left of a triangle between two levels, by clipping, in coordinates in which the whole has
  // an area of one half.
  double area(const Triangle& t, std::size_t band) const
  {
    typedef std::array<Fraction, 3> Corner; // two coordinates in the triangle, and the value
    std::vector<Corner> polygon = {
      {0, 0, Fraction(value(t[0]))}, {1, 0, Fraction(value(t[1]))}, {0, 1, Fraction(value(t[2]))}};
    const auto clip = [&](const Fraction& level, int sign) {
      std::vector<Corner> clipped;
      for(std::size_t i = 0; i < polygon.size(); ++i)
      {
        const Corner &p = polygon[i], &q = polygon[(i + 1) % polygon.size()];
        const Fraction a = sign * (p[2] - level), b = sign * (q[2] - level);
        if(a >= 0)
          clipped.push_back(p);
        if((a < 0 && b > 0) || (a > 0 && b < 0))
        {
          const Fraction s = a / (a - b);
          clipped.push_back({p[0] + s * (q[0] - p[0]), p[1] + s * (q[1] - p[1]), level});
        }
      }
      polygon = clipped;
    };
    if(band > 0)
      clip(Fraction(levels_[band - 1]), 1);
    if(band < levels_.size())
      clip(Fraction(levels_[band]), -1);
    Fraction twice_area = 0;
    for(std::size_t i = 0; i < polygon.size(); ++i)
    {
      const Corner &p = polygon[i], &q = polygon[(i + 1) % polygon.size()];
      twice_area += p[0] * q[1] - p[1] * q[0];
    }
    return CGAL::to_double(twice_area) * area_of_triangle(t);
  }

  double area_of_triangle(const Triangle& t) const
  {
    std::array<double, 3> u, w;
    for(std::size_t i = 0; i < 3; ++i)
    {
      u[i] = sample_.soup.points[t[1]][i] - sample_.soup.points[t[0]][i];
      w[i] = sample_.soup.points[t[2]][i] - sample_.soup.points[t[0]][i];
    }
    return std::hypot(u[1] * w[2] - u[2] * w[1], u[2] * w[0] - u[0] * w[2], u[0] * w[1] - u[1] * w[0]) / 2;
  }

  const curve_samples::Sample& sample_;
  const std::vector<double>& levels_;
};

} // namespace level_oracle

#endif // CGAL_REEB_GRAPH_TEST_LEVEL_ORACLE_H
