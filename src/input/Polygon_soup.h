// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of the CGAL-style package Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_SRC_POLYGON_SOUP_H
#define CGAL_REEB_GRAPH_SRC_POLYGON_SOUP_H

#include "base/surface.h"

#include <CGAL/Iterator_range.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace reeb_graph_program {
// The number of a vertex of a face.
typedef std::uint32_t Corner;
// Stands for all numbers that no vertex of a surface can have.
constexpr Corner too_large_corner = 0xffffffff;

// The number of a vertex, or the one that stands for all that are too large.
inline Corner corner(std::size_t vertex)
{
  return static_cast<Corner>(std::min<std::size_t>(vertex, too_large_corner));
}

// Faces by the numbers of their vertices, one behind the other.
class Polygons
{
public:
  typedef CGAL::Iterator_range<const Corner*> Polygon;

  std::size_t size() const { return ends_.size(); }
  std::size_t number_of_corners() const { return corners_.size(); }
  std::size_t begin(std::size_t i) const { return i == 0 ? 0 : ends_[i - 1]; }
  Polygon operator[](std::size_t i) const { return Polygon(corners_.data() + begin(i), corners_.data() + ends_[i]); }

  void add_corner(std::size_t vertex) { corners_.push_back(corner(vertex)); }
  // Ends the polygon of the corners that have been added since the last one.
  void end_polygon() { ends_.push_back(corners_.size()); }

  void reserve(std::size_t number)
  {
    ends_.reserve(number);
    corners_.reserve(3 * number);
  }

  void append(const Polygons& others)
  {
    const std::size_t shift = corners_.size();
    corners_.insert(corners_.end(), others.corners_.begin(), others.corners_.end());
    for(const std::size_t end : others.ends_)
      ends_.push_back(shift + end);
  }

private:
  std::vector<Corner> corners_;
  std::vector<std::size_t> ends_;
};

struct Polygon_soup
{
  std::vector<Point> points;
  Polygons polygons;
  std::vector<std::array<Corner, 2>> edges; // besides those of the polygons
  std::vector<std::array<Corner, 4>> tetrahedra;
  std::vector<double> scalars; // the property of the points that was asked for; empty if none was
};

// The parts of a soup, one behind the other, whose polygons have the numbers of all vertices.
inline Polygon_soup join(std::vector<Polygon_soup> parts)
{
  Polygon_soup soup;
  for(Polygon_soup& part : parts)
    if(soup.points.empty() && soup.polygons.size() == 0)
      soup = std::move(part);
    else
    {
      soup.points.insert(soup.points.end(), part.points.begin(), part.points.end());
      soup.polygons.append(part.polygons);
    }
  return soup;
}

} // namespace reeb_graph_program

#endif // CGAL_REEB_GRAPH_SRC_POLYGON_SOUP_H
