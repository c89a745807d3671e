// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#include "input/pieces.h"

#include "input/soup_counts.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <utility>
#include <vector>

namespace reeb_graph_program {
namespace {
typedef CGAL::Exact_predicates_inexact_constructions_kernel Kernel;

class Pieces
{
public:
  explicit Pieces(const Polygon_soup& soup)
    : soup_(soup),
      pieces_of_faces_(components_of_polygons(soup.polygons, soup.points.size()))
  {
    double largest = 0;
    for(const Point& p : soup.points)
      for(int k = 0; k < 3; ++k)
        largest = std::max(largest, std::abs(p[k]));
    const int exponent = largest > 0 ? -std::ilogb(largest) : 0; // so that no volume overflows
    for(const Point& p : soup.points)
      points_.emplace_back(std::ldexp(p.x(), exponent), std::ldexp(p.y(), exponent), std::ldexp(p.z(), exponent));
    std::map<std::size_t, std::size_t> numbers;
    for(std::size_t& piece : pieces_of_faces_)
      piece = numbers.emplace(piece, numbers.size()).first->second;
    pieces_.resize(numbers.size());
    for(std::size_t i = 0; i < soup.polygons.size(); ++i)
      measure(i, pieces_[pieces_of_faces_[i]]);
    const std::vector<Polygon_side> sides = sides_of(soup.polygons);
    for(std::size_t begin = 0, end = 0; begin < sides.size(); begin = end)
    {
      end = end_of_edge(sides, begin);
      if(end - begin == 1)
        pieces_[pieces_of_faces_[sides[begin].face]].is_closed = false;
    }
  }

  std::vector<std::size_t> lesser_faces(double least_share, Repair_counts& counts)
  {
    double area = 0;
    const Piece* largest = nullptr;
    for(const Piece& piece : pieces_)
    {
      area += piece.area;
      largest = largest == nullptr || piece.area > largest->area ? &piece : largest;
    }
    std::vector<char> is_hollow(pieces_.size(), 0), is_flat = is_hollow, is_out = is_hollow;
    for(std::size_t i = 0; i < pieces_.size(); ++i)
    {
      const double volume = largest->volume < 0 ? -pieces_[i].volume : pieces_[i].volume;
      is_out[i] = pieces_[i].area < least_share * area ? 1 : 0;
      const double rounding = 1e-12 * pieces_[i].size;
      is_hollow[i] = pieces_[i].is_closed && volume < -rounding ? 1 : 0;
      is_flat[i] = pieces_[i].is_closed && std::abs(volume) <= rounding ? 1 : 0;
    }
    const std::vector<char> is_nested = find_nested(is_hollow);
    for(std::size_t i = 0; i < pieces_.size(); ++i)
    {
      const bool is_out_by_volume = is_out[i] == 0 && (is_flat[i] != 0 || (is_hollow[i] != 0 && is_nested[i] == 0));
      counts.small_pieces += is_out[i] != 0 ? 1 : 0;
      counts.pieces_without_volume += is_out_by_volume ? 1 : 0;
      is_out[i] |= is_out_by_volume ? 1 : 0;
    }
    std::vector<std::size_t> result;
    for(std::size_t i = 0; i < pieces_of_faces_.size(); ++i)
      if(is_out[pieces_of_faces_[i]] != 0)
        result.push_back(i);
    return result;
  }

private:
  struct Piece
  {
    double area = 0, volume = 0, size = 0; // size: what the volume would be without any sign
    bool is_closed = true;
    const Kernel::Point_3* first = nullptr;
    double largest_area = -1; // of a triangle
    Kernel::Point_3 place;    // its center
  };

  // Calls visit(a, b, c) for the triangles of a face.
  template <class Visit>
  void visit_triangles(std::size_t face, const Visit& visit) const
  {
    const Corner* const v = soup_.polygons[face].begin();
    for(std::size_t k = 2; k < soup_.polygons[face].size(); ++k)
      visit(points_[v[0]], points_[v[k - 1]], points_[v[k]]);
  }

  void measure(std::size_t face, Piece& piece) const
  {
    visit_triangles(face, [&](const Kernel::Point_3& a, const Kernel::Point_3& b, const Kernel::Point_3& c) {
      piece.first = piece.first == nullptr ? &a : piece.first;
      const double area = std::sqrt(CGAL::cross_product(b - a, c - a).squared_length()) / 2;
      const double volume = CGAL::determinant(a - *piece.first, b - *piece.first, c - *piece.first);
      piece.area += area;
      piece.volume += volume;
      piece.size += std::abs(volume);
      if(area > piece.largest_area)
      {
        piece.largest_area = area;
        piece.place = CGAL::centroid(a, b, c);
      }
    });
  }

  // Which pieces lie in another one, or have another one inside, if one of both is hollow: how often their surfaces wind
  // around a point of others, by rays upwards.
  std::vector<char> find_nested(const std::vector<char>& is_hollow) const
  {
    std::vector<std::size_t> order;
    for(std::size_t i = 0; i < pieces_.size(); ++i)
      order.push_back(i);
    if(std::find(is_hollow.begin(), is_hollow.end(), 1) == is_hollow.end())
      return std::vector<char>(pieces_.size(), 0);
    const auto x_of = [&](std::size_t i) { return pieces_[i].place.x(); };
    std::sort(order.begin(), order.end(), [&](std::size_t i, std::size_t j) { return x_of(i) < x_of(j); });
    std::map<std::pair<std::size_t, std::size_t>, int> windings; // of a piece around another one
    for(std::size_t face = 0; face < pieces_of_faces_.size(); ++face)
      visit_triangles(face, [&](const Kernel::Point_3& a, const Kernel::Point_3& b, const Kernel::Point_3& c) {
        const std::size_t around = pieces_of_faces_[face];
        const auto [least, most] = std::minmax({a.x(), b.x(), c.x()});
        auto i =
          std::lower_bound(order.begin(), order.end(), least, [&](std::size_t k, double x) { return x_of(k) < x; });
        for(; i != order.end() && x_of(*i) <= most; ++i)
          if(*i != around && (is_hollow[*i] != 0 || is_hollow[around] != 0))
            if(const int sign = crossing(pieces_[*i].place, {&a, &b, &c}); sign != 0)
              windings[{around, *i}] += sign;
      });
    std::vector<char> is_nested(pieces_.size(), 0);
    for(const auto& [pair, winding] : windings)
      if(winding != 0)
        is_nested[pair.first] = is_nested[pair.second] = 1;
    return is_nested;
  }

  // How a ray upwards passes a triangle: 1 from its front, -1 from its back. Of an edge that it meets, one side counts.
  static int crossing(const Kernel::Point_3& p, const std::array<const Kernel::Point_3*, 3>& t)
  {
    int winding = 0;
    for(std::size_t k = 0; k < 3; ++k)
    {
      const Kernel::Point_3 &a = *t[k], &b = *t[(k + 1) % 3];
      if((a.y() <= p.y()) == (b.y() <= p.y()))
        continue;
      const bool is_up = a.y() <= p.y();
      const Kernel::Point_3 &low = is_up ? a : b, &high = is_up ? b : a;
      if(CGAL::orientation(Kernel::Point_2(low.x(), low.y()), Kernel::Point_2(high.x(), high.y()),
                           Kernel::Point_2(p.x(), p.y()))
         == CGAL::POSITIVE)
        winding += is_up ? 1 : -1;
    }
    if(winding == 0)
      return 0;
    const CGAL::Orientation side = CGAL::orientation(*t[0], *t[1], *t[2], p);
    return side == CGAL::COPLANAR || (side == CGAL::POSITIVE) == (winding > 0) ? 0 : winding;
  }

  const Polygon_soup& soup_;
  std::vector<std::size_t> pieces_of_faces_;
  std::vector<Kernel::Point_3> points_; // in units in which nothing overflows
  std::vector<Piece> pieces_;
};

} // namespace

std::vector<std::size_t> faces_of_lesser_pieces(const Polygon_soup& soup, double least_share, Repair_counts& counts)
{
  return soup.polygons.size() == 0 ? std::vector<std::size_t>() : Pieces(soup).lesser_faces(least_share, counts);
}

} // namespace reeb_graph_program
