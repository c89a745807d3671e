// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of the CGAL-style package Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_INTERNAL_AUGMENTATION_TRIANGLE_ORIENTATION_H
#define CGAL_REEB_GRAPH_INTERNAL_AUGMENTATION_TRIANGLE_ORIENTATION_H

#include <CGAL/license/Reeb_graph.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <tuple>
#include <utility>
#include <vector>

namespace CGAL {
namespace Reeb_graph {
namespace internal {

// Orients triangles alike that share an edge with no third one. In each part that is connected in this way, the way in
// which most triangles are oriented before wins. A part that cannot be oriented is as the search leaves it.
class Triangle_orientation
{
public:
  typedef std::array<std::size_t, 3> Triangle;

  static void orient(std::vector<Triangle>& triangles)
  {
    Triangle_orientation orientation(triangles);
    if(!orientation.are_all_alike_)
      orientation.turn(triangles);
  }

private:
  struct Neighbor
  {
    std::size_t triangle;
    bool is_alike; // whether the two triangles pass their edge in opposite directions
  };

  struct Side
  {
    std::size_t low, high, triangle;
    bool is_ascending;

    friend bool operator<(const Side& a, const Side& b)
    {
      return std::tie(a.low, a.high, a.triangle) < std::tie(b.low, b.high, b.triangle);
    }
    bool is_on_edge_of(const Side& other) const { return low == other.low && high == other.high; }
  };

  explicit Triangle_orientation(const std::vector<Triangle>& triangles) : neighbors_(triangles.size())
  {
    std::vector<Side> sides;
    sides.reserve(3 * triangles.size());
    for(std::size_t t = 0; t != triangles.size(); ++t)
    {
      for(std::size_t i = 0; i != 3; ++i)
      {
        const std::size_t from = triangles[t][i], to = triangles[t][(i + 1) % 3];
        sides.push_back({(std::min)(from, to), (std::max)(from, to), t, from < to});
      }
    }
    std::sort(sides.begin(), sides.end());
    for(auto side = sides.begin(); side != sides.end();)
    {
      const auto end = std::find_if(side, sides.end(), [&](const Side& other) { return !other.is_on_edge_of(*side); });
      if(end - side == 2)
        join(side[0], side[1]);
      side = end;
    }
  }

  void join(const Side& a, const Side& b)
  {
    const bool is_alike = a.is_ascending != b.is_ascending;
    neighbors_[a.triangle].push_back({b.triangle, is_alike});
    neighbors_[b.triangle].push_back({a.triangle, is_alike});
    are_all_alike_ &= is_alike;
  }

  void turn(std::vector<Triangle>& triangles)
  {
    std::vector<bool> is_reached(triangles.size(), false), is_turned(triangles.size(), false);
    for(std::size_t first = 0; first != triangles.size(); ++first)
    {
      if(is_reached[first])
        continue;
      is_reached[first] = true;
      std::vector<std::size_t> part = {first};
      for(std::size_t i = 0; i != part.size(); ++i)
      {
        for(const Neighbor& neighbor : neighbors_[part[i]])
        {
          if(is_reached[neighbor.triangle])
            continue;
          is_reached[neighbor.triangle] = true;
          is_turned[neighbor.triangle] = neighbor.is_alike ? is_turned[part[i]] : !is_turned[part[i]];
          part.push_back(neighbor.triangle);
        }
      }
      const auto number_of_turned =
        std::count_if(part.begin(), part.end(), [&](std::size_t t) { return is_turned[t]; });
      const bool are_most_turned = 2 * static_cast<std::size_t>(number_of_turned) > part.size();
      for(const std::size_t t : part)
      {
        if(is_turned[t] != are_most_turned)
          std::swap(triangles[t][1], triangles[t][2]);
      }
    }
  }

  std::vector<std::vector<Neighbor>> neighbors_;
  bool are_all_alike_ = true;
};

} // namespace internal
} // namespace Reeb_graph
} // namespace CGAL

#endif // CGAL_REEB_GRAPH_INTERNAL_AUGMENTATION_TRIANGLE_ORIENTATION_H
