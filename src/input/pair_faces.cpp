// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#include "input/repair_soup.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <numeric>
#include <tuple>
#include <utility>
#include <vector>

namespace reeb_graph_program {
namespace {
typedef CGAL::Exact_predicates_inexact_constructions_kernel::Point_3 Exact_point;

Exact_point exact(const Point& p) { return {p.x(), p.y(), p.z()}; }

// Sets of faces that agree, each as it is and reversed.
class Orientations
{
public:
  explicit Orientations(std::size_t size) : size_(size), sets_(2 * size) {}

  // Returns false if the faces are in one set that says otherwise.
  bool unite(std::size_t one, std::size_t other, bool is_turned)
  {
    const std::size_t turn = is_turned ? 1 : 0;
    if(sets_.find(2 * one) == sets_.find(2 * other + 1 - turn))
      return false;
    for(const std::size_t side : {0, 1})
      sets_.unite(2 * one + side, 2 * other + (side ^ turn));
    return true;
  }

  // The fewest faces that are to be reversed; of two halves, not the one with the first face.
  std::vector<char> turned()
  {
    std::vector<std::size_t> numbers(2 * size_, 0), firsts(2 * size_, size_); // of faces as they are, by set
    std::vector<char> result(size_);
    for(std::size_t i = 0; i < size_; ++i)
    {
      ++numbers[sets_.find(2 * i)];
      firsts[sets_.find(2 * i)] = std::min(firsts[sets_.find(2 * i)], i);
    }
    for(std::size_t i = 0; i < size_; ++i)
    {
      const std::size_t here = sets_.find(2 * i), opposite = sets_.find(2 * i + 1);
      result[i] =
        numbers[here] < numbers[opposite] || (numbers[here] == numbers[opposite] && firsts[opposite] < firsts[here])
          ? 1
          : 0;
    }
    return result;
  }

private:
  std::size_t size_;
  Union_find_of_indices sets_;
};

// The faces of an edge, around it.
class Faces_of_edge
{
public:
  struct Face
  {
    std::size_t side;
    bool is_descending;
    Exact_point point; // off the line of the edge, if the face has area
    int part = 0;      // 0 where the first face is, 1 on the left of it, 2 opposite, 3 on the right
  };

  Faces_of_edge(const Polygon_soup& soup, const Polygon_side& edge)
    : soup_(soup),
      u_(exact(soup.points[edge.u])),
      v_(exact(soup.points[edge.v]))
  {}

  void add(const Polygon_side& side, std::size_t number, bool is_turned)
  {
    Face face = {number, side.is_descending != is_turned, u_};
    for(const Corner corner : soup_.polygons[side.face])
      if(const Exact_point p = exact(soup_.points[corner]); !CGAL::collinear(u_, v_, p))
      {
        face.point = p;
        break;
      }
    faces_.push_back(face);
  }

  // Counterclockwise, seen from v. Of those at one angle, the ascending ones come first: there is no solid between.
  // Where faces have no area, they are beside the first one that has some.
  const std::vector<Face>& in_order()
  {
    const auto first = std::find_if(faces_.begin(), faces_.end(), [&](const Face& f) { return f.point != u_; });
    for(Face& face : faces_)
      if(face.point != u_)
      {
        const CGAL::Orientation side = CGAL::orientation(u_, v_, first->point, face.point);
        face.part = side == CGAL::POSITIVE                                                         ? 1
                  : side == CGAL::NEGATIVE                                                         ? 3
                  : CGAL::coplanar_orientation(u_, v_, first->point, face.point) == CGAL::POSITIVE ? 0
                                                                                                   : 2;
      }
    std::sort(faces_.begin(), faces_.end(), [&](const Face& a, const Face& b) {
      if(a.part != b.part)
        return a.part < b.part;
      if(a.part % 2 == 1)
        if(const CGAL::Orientation turn = CGAL::orientation(u_, v_, a.point, b.point); turn != CGAL::COPLANAR)
          return turn == CGAL::POSITIVE;
      return std::tie(a.is_descending, a.side) < std::tie(b.is_descending, b.side);
    });
    return faces_;
  }

private:
  const Polygon_soup& soup_;
  Exact_point u_, v_;
  std::vector<Face> faces_;
};

// Pairs an ascending face with the descending one that comes next, as brackets on a circle.
void pair_brackets(const std::vector<Faces_of_edge::Face>& faces, std::vector<std::size_t>& mates)
{
  std::vector<std::size_t> open;
  for(std::size_t i = 0; i < 2 * faces.size(); ++i)
  {
    const Faces_of_edge::Face& face = faces[i % faces.size()];
    if(!face.is_descending && i < faces.size())
      open.push_back(face.side);
    else if(face.is_descending && mates[face.side] == face.side && !open.empty())
    {
      mates[face.side] = open.back();
      mates[open.back()] = face.side;
      open.pop_back();
    }
  }
}

// Gives corners of polygons their new vertices, and cuts edges that would be one.
class Pair_splitting
{
public:
  Pair_splitting(Polygon_soup& soup, const Face_pairs& pairs)
    : soup_(soup),
      pairs_(pairs),
      corners_(pairs.sides.size()),
      midpoints_(pairs.sides.size(), none),
      sides_at_corners_(pairs.sides.size()),
      begins_(soup.polygons.size())
  {}

  void split(Repair_counts& counts)
  {
    copy_vertices();
    const std::size_t copies = origins_.size();
    add_midpoints();
    Polygons polygons;
    for(std::size_t i = 0; i < soup_.polygons.size(); ++i)
      add_polygon(i, polygons);
    soup_.polygons = std::move(polygons);
    counts.added_points += origins_.size();
    counts.added_midpoints += origins_.size() - copies;
  }

  std::vector<std::array<Corner, 2>> take_origins() { return std::move(origins_); }

private:
  static constexpr std::size_t none = static_cast<std::size_t>(-1);

  std::size_t add_point(const Point& p, Corner u, Corner v)
  {
    soup_.points.push_back(p);
    origins_.push_back({u, v});
    return soup_.points.size() - 1;
  }

  void copy_vertices()
  {
    Union_find_of_indices fans(corners_.size());
    for(std::size_t s = 0; s < pairs_.sides.size(); ++s)
    {
      const Polygon_side &side = pairs_.sides[s], &mate = pairs_.sides[pairs_.mates[s]];
      fans.unite(side.corner_of_u, mate.corner_of_u);
      fans.unite(side.corner_of_v, mate.corner_of_v);
      sides_at_corners_[side.is_descending ? side.corner_of_v : side.corner_of_u] = s;
    }
    std::vector<std::size_t> vertices_of_fans(corners_.size(), none);
    std::vector<char> is_there(soup_.points.size(), 0);
    for(std::size_t i = 0, corner = 0; i < soup_.polygons.size(); ++i)
    {
      begins_[i] = corner;
      for(const Corner v : soup_.polygons[i])
      {
        std::size_t& vertex = vertices_of_fans[fans.find(corner)];
        if(vertex == none)
          vertex = std::exchange(is_there[v], 1) == 0 ? v : add_point(Point(soup_.points[v]), v, v);
        corners_[corner++] = vertex;
      }
    }
  }

  void add_midpoints()
  {
    struct Copy
    {
      std::size_t u, v, side;
    };
    const auto ends = [](const Copy& copy) { return std::tie(copy.u, copy.v); };
    std::vector<Copy> copies;
    for(std::size_t s = 0; s < pairs_.sides.size(); ++s)
      if(const Polygon_side& side = pairs_.sides[s]; pairs_.mates[s] >= s)
        copies.push_back({corners_[side.corner_of_u], corners_[side.corner_of_v], s});
    std::sort(copies.begin(), copies.end(),
              [](const Copy& a, const Copy& b) { return std::tie(a.u, a.v, a.side) < std::tie(b.u, b.v, b.side); });
    for(std::size_t i = 0; i < copies.size(); ++i)
    {
      if((i == 0 || ends(copies[i - 1]) != ends(copies[i]))
         && (i + 1 == copies.size() || ends(copies[i]) != ends(copies[i + 1])))
        continue;
      const Polygon_side& side = pairs_.sides[copies[i].side];
      const Point &p = soup_.points[side.u], &q = soup_.points[side.v];
      const Point middle(p.x() / 2 + q.x() / 2, p.y() / 2 + q.y() / 2, p.z() / 2 + q.z() / 2);
      midpoints_[copies[i].side] = midpoints_[pairs_.mates[copies[i].side]] = add_point(middle, side.u, side.v);
    }
  }

  // Whether a face has the corners of another one.
  bool have_same_corners(std::size_t one, std::size_t other) const
  {
    const auto begin = [&](std::size_t i) { return corners_.begin() + static_cast<std::ptrdiff_t>(begins_[i]); };
    return one != other && soup_.polygons[one].size() == soup_.polygons[other].size()
        && std::is_permutation(begin(one), begin(one) + 3, begin(other));
  }

  // Triangles stay triangles. Their new edges end at a midpoint, or where another face could have the same, at a center.
  void add_polygon(std::size_t i, Polygons& polygons)
  {
    std::vector<std::size_t> corners;
    std::size_t apex = none;
    const std::size_t size = soup_.polygons[i].size();
    bool is_center_needed = false;
    for(std::size_t corner = begins_[i]; corner < begins_[i] + size; ++corner)
    {
      corners.push_back(corners_[corner]);
      const std::size_t side = sides_at_corners_[corner], middle = midpoints_[side];
      if(middle == none)
        continue;
      apex = apex == none ? corners.size() : apex;
      corners.push_back(middle);
      is_center_needed = is_center_needed || have_same_corners(i, pairs_.sides[pairs_.mates[side]].face);
    }
    if(apex == none || size > 3)
      return polygons.add(corners);
    std::rotate(corners.begin(), corners.begin() + static_cast<std::ptrdiff_t>(apex), corners.end());
    if(is_center_needed)
    {
      const Corner* const v = soup_.polygons[i].begin();
      corners.insert(corners.begin(), add_point(mean_of(soup_.points, soup_.polygons[i]), v[0], v[1]));
      corners.push_back(corners[1]);
    }
    for(std::size_t k = 2; k < corners.size(); ++k)
      polygons.add(std::array<std::size_t, 3>{corners[0], corners[k - 1], corners[k]});
  }

  Polygon_soup& soup_;
  const Face_pairs& pairs_;
  std::vector<std::size_t> corners_;          // the vertex of each
  std::vector<std::size_t> midpoints_;        // of sides
  std::vector<std::size_t> sides_at_corners_; // which begin there
  std::vector<std::size_t> begins_;           // the first corner of each polygon
  std::vector<std::array<Corner, 2>> origins_;
};

} // namespace

Face_pairs pair_two_faces(const Polygons& polygons)
{
  Face_pairs result;
  result.sides = sides_of(polygons);
  const std::vector<Polygon_side>& sides = result.sides;
  result.mates.resize(sides.size());
  std::iota(result.mates.begin(), result.mates.end(), std::size_t(0));
  Orientations orientations(polygons.size());
  // Those that agree come first: so the others are cut, if any.
  for(const bool is_turned : {false, true})
    for_each_edge(sides, [&](std::size_t begin, std::size_t end) {
      const Polygon_side &one = sides[begin], &other = sides[end - 1];
      if(end - begin == 2 && (one.is_descending == other.is_descending) == is_turned
         && orientations.unite(one.face, other.face, is_turned))
        std::swap(result.mates[begin], result.mates[begin + 1]);
    });
  result.is_turned = orientations.turned();
  return result;
}

Face_pairs pair_faces(const Polygon_soup& soup)
{
  Face_pairs result = pair_two_faces(soup.polygons);
  const std::vector<Polygon_side>& sides = result.sides;
  for_each_edge(sides, [&](std::size_t begin, std::size_t end) {
    if(end - begin < 3)
      return;
    Faces_of_edge faces(soup, sides[begin]);
    for(std::size_t s = begin; s < end; ++s)
      faces.add(sides[s], s, result.is_turned[sides[s].face] != 0);
    pair_brackets(faces.in_order(), result.mates);
  });
  return result;
}

std::vector<std::array<Corner, 2>> split_at_pairs(Polygon_soup& soup, const Face_pairs& pairs, Repair_counts& counts)
{
  for_each_edge(pairs.sides, [&](std::size_t begin, std::size_t end) {
    std::size_t alone = 0;
    for(std::size_t s = begin; s < end; ++s)
      alone += pairs.mates[s] == s ? 1 : 0;
    counts.paired_edges += end - begin > 2 && alone < end - begin ? 1 : 0;
    counts.unpaired_sides += end - begin > 1 ? alone : 0;
  });
  Pair_splitting splitting(soup, pairs);
  splitting.split(counts);
  return splitting.take_origins();
}

} // namespace reeb_graph_program
