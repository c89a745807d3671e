// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_SRC_POLYGON_SOUP_H
#define CGAL_REEB_GRAPH_SRC_POLYGON_SOUP_H

#include "base/surface.h"
#include "base/threads.h"

#include <CGAL/Iterator_range.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
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

// Faces by the numbers of their vertices, one behind the other. Where they end is only listed if not all are triangles.
class Polygons
{
public:
  typedef CGAL::Iterator_range<const Corner*> Polygon;

  std::size_t size() const { return size_; }
  std::size_t number_of_corners() const { return corners_.size(); }
  Polygon operator[](std::size_t i) const
  {
    return Polygon(corners_.data() + begin(i), corners_.data() + begin(i + 1));
  }

  Polygon corners() const { return Polygon(corners_.data(), corners_.data() + corners_.size()); } // of all

  void add_corner(std::size_t vertex) { corners_.push_back(corner(vertex)); }
  // Ends the polygon of the corners that have been added since the last one.
  void end_polygon()
  {
    if(!are_triangles() || corners_.size() != 3 * size_ + 3)
    {
      while(ends_.size() < size_)
        ends_.push_back(3 * ends_.size() + 3);
      ends_.push_back(corners_.size());
    }
    ++size_;
  }

  template <class Vertices>
  void add(const Vertices& vertices)
  {
    for(const auto v : vertices)
      add_corner(v);
    end_polygon();
  }

  void append(const Polygons& others)
  {
    for(std::size_t i = 0; i < others.size(); ++i)
      add(others[i]);
  }

  void reserve(std::size_t number) { corners_.reserve(3 * number); }

  // Makes all triangles, and returns where the numbers of their vertices are to be written.
  Corner* make_triangles(std::size_t number)
  {
    ends_.clear();
    corners_.resize(3 * number);
    size_ = number;
    return corners_.data();
  }

  bool are_triangles() const { return ends_.empty(); }

private:
  std::size_t begin(std::size_t i) const { return are_triangles() ? 3 * i : i == 0 ? 0 : ends_[i - 1]; }

  std::vector<Corner> corners_;
  std::vector<std::size_t> ends_;
  std::size_t size_ = 0;
};

// The point whose coordinates next() gives, one after the other.
template <class Next>
Point point_of(const Next& next)
{
  const double x = next(), y = next(), z = next();
  return Point(x, y, z);
}

// Calls visit(u, v) for the ends of each side.
template <class Visit>
void for_each_side(const Polygons& polygons, const Visit& visit)
{
  for(std::size_t i = 0; i < polygons.size(); ++i)
  {
    Corner previous = *(polygons[i].end() - 1);
    for(const Corner v : polygons[i])
      visit(std::exchange(previous, v), v);
  }
}

// The mean of the corners of a polygon, which does not overflow.
template <class Vertices>
Point mean_of(const std::vector<Point>& points, const Vertices& vertices)
{
  std::array<double, 3> sum = {};
  for(const auto v : vertices)
    for(int k = 0; k < 3; ++k)
      sum[static_cast<std::size_t>(k)] += points[v][k] / static_cast<double>(vertices.size());
  return {sum[0], sum[1], sum[2]};
}

// Adds the triangles of a strip: of any three corners in a row, every other one the other way round. Those with a
// repeated vertex, by which strips turn or are joined, are no faces.
inline void add_strip(const std::vector<Corner>& strip, Polygons& polygons)
{
  for(std::size_t i = 2; i < strip.size(); ++i)
  {
    const Corner a = strip[i - 2 + i % 2], b = strip[i - 1 - i % 2], c = strip[i];
    if((a == b || b == c || a == c) && std::max({a, b, c}) != too_large_corner)
      continue;
    polygons.add(std::array<Corner, 3>{a, b, c});
  }
}

// Numbers of the vertices, of a type as VTK's XML files name it.
struct Vertex_field
{
  std::string name, type;
  std::vector<double> numbers;
};

struct Polygon_soup
{
  std::vector<Point> points;
  Polygons polygons;
  std::vector<std::size_t> copies;          // of each polygon in the file, if repeated ones have been left out
  std::vector<std::array<Corner, 2>> edges; // besides those of the polygons
  std::vector<std::array<Corner, 4>> tetrahedra;
  std::vector<double> scalars;      // the property of the points that was asked for; empty if none was
  std::vector<Vertex_field> fields; // all of them, if they were asked for
  std::vector<std::string> notes;   // on what was left out
};

// Makes the polygons of the parts those of the soup, one behind the other.
inline void join_polygons(const std::vector<Polygon_soup>& parts, Polygon_soup& soup)
{
  std::vector<std::size_t> begins(1, 0);
  bool are_triangles = true;
  for(const Polygon_soup& part : parts)
  {
    begins.push_back(begins.back() + part.polygons.size());
    are_triangles = are_triangles && part.polygons.are_triangles();
  }
  if(are_triangles)
  {
    Corner* const corners = soup.polygons.make_triangles(begins.back());
    run_tasks(parts.size(), [&](std::size_t i) {
      std::copy(parts[i].polygons.corners().begin(), parts[i].polygons.corners().end(), corners + 3 * begins[i]);
    });
    return;
  }
  soup.polygons.reserve(begins.back());
  for(const Polygon_soup& part : parts)
    soup.polygons.append(part.polygons);
}

// The parts of a soup, one behind the other, whose polygons and edges have the numbers of all vertices. They have no
// tetrahedra, and no notes.
inline Polygon_soup join(std::vector<Polygon_soup> parts)
{
  if(parts.size() == 1)
    return std::move(parts.front());
  Polygon_soup soup;
  std::vector<std::size_t> begins(1, 0);
  bool are_scalars_there = false;
  for(const Polygon_soup& part : parts)
  {
    begins.push_back(begins.back() + part.points.size());
    are_scalars_there = are_scalars_there || !part.scalars.empty();
  }
  soup.points.resize(begins.back());
  soup.scalars.resize(are_scalars_there ? begins.back() : 0);
  run_tasks(parts.size(), [&](std::size_t i) {
    std::copy(parts[i].points.begin(), parts[i].points.end(), soup.points.data() + begins[i]);
    if(are_scalars_there)
      std::copy(parts[i].scalars.begin(), parts[i].scalars.end(), soup.scalars.data() + begins[i]);
  });
  join_polygons(parts, soup);
  for(const Polygon_soup& part : parts)
    soup.edges.insert(soup.edges.end(), part.edges.begin(), part.edges.end());
  return soup;
}

} // namespace reeb_graph_program

#endif // CGAL_REEB_GRAPH_SRC_POLYGON_SOUP_H
