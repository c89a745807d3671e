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
#include <cmath>
#include <cstddef>
#include <map>
#include <tuple>
#include <utility>
#include <vector>

namespace reeb_graph_program {
std::vector<Polygon_side> sides_of(const Polygons& polygons)
{
  std::vector<Polygon_side> sides;
  sides.reserve(polygons.number_of_corners());
  std::size_t first = 0;
  for(std::size_t i = 0; i < polygons.size(); ++i)
  {
    const Polygons::Polygon polygon = polygons[i];
    const auto size = static_cast<std::size_t>(polygon.end() - polygon.begin());
    for(std::size_t j = 0; j < size; ++j)
    {
      const std::size_t next = (j + 1) % size;
      const Corner a = polygon.begin()[j], b = polygon.begin()[next];
      if(a < b)
        sides.push_back({a, b, first + j, first + next, i, false});
      else
        sides.push_back({b, a, first + next, first + j, i, true});
    }
    first += size;
  }
  std::sort(sides.begin(), sides.end(), [](const Polygon_side& a, const Polygon_side& b) {
    return std::tie(a.u, a.v, a.face) < std::tie(b.u, b.v, b.face);
  });
  return sides;
}

std::vector<std::size_t> count_fans(const Polygons& polygons,
                                    const std::vector<Polygon_side>& sides,
                                    std::size_t number_of_vertices)
{
  Union_find_of_indices fans(sides.size());
  for(std::size_t i = 1; i < sides.size(); ++i)
    if(!(sides[i - 1] < sides[i]))
    {
      fans.unite(sides[i - 1].corner_of_u, sides[i].corner_of_u);
      fans.unite(sides[i - 1].corner_of_v, sides[i].corner_of_v);
    }
  std::vector<std::size_t> numbers(number_of_vertices, 0);
  std::size_t corner = 0;
  for(std::size_t i = 0; i < polygons.size(); ++i)
    for(const Corner v : polygons[i])
      numbers[v] += fans.is_root(corner++) ? 1 : 0;
  return numbers;
}

Soup_counts count_soup(const Polygons& polygons, std::size_t number_of_vertices)
{
  const std::vector<Polygon_side> sides = sides_of(polygons);
  Soup_counts counts;
  counts.vertices = number_of_vertices;
  counts.faces = polygons.size();
  Union_find_of_indices vertices(number_of_vertices), borders(number_of_vertices);
  std::vector<char> is_on_border(number_of_vertices, 0);
  for_each_edge(sides, [&](std::size_t begin, std::size_t end) {
    const Polygon_side& first = sides[begin];
    ++counts.edges;
    vertices.unite(first.u, first.v);
    counts.edges_of_many_faces += end - begin > 2 ? 1 : 0;
    counts.edges_without_orientation +=
      end - begin == 2 && first.is_descending == sides[begin + 1].is_descending ? 1 : 0;
    if(end - begin > 1)
      return;
    ++counts.border_edges;
    borders.unite(first.u, first.v);
    is_on_border[first.u] = is_on_border[first.v] = 1;
  });
  for(const std::size_t fans : count_fans(polygons, sides, number_of_vertices))
    counts.vertices_of_several_fans += fans > 1 ? 1 : 0;
  for(std::size_t v = 0; v < number_of_vertices; ++v)
  {
    counts.components += vertices.is_root(v) ? 1 : 0;
    counts.border_loops += is_on_border[v] != 0 && borders.is_root(v) ? 1 : 0;
  }
  return counts;
}

std::vector<std::size_t> components_of_polygons(const Polygons& polygons, std::size_t number_of_vertices)
{
  Union_find_of_indices vertices(number_of_vertices);
  for(std::size_t i = 0; i < polygons.size(); ++i)
    for(const Corner v : polygons[i])
      vertices.unite(*polygons[i].begin(), v);
  std::vector<std::size_t> components;
  for(std::size_t i = 0; i < polygons.size(); ++i)
    components.push_back(vertices.find(*polygons[i].begin()));
  return components;
}

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
    for_each_edge(sides, [&](std::size_t begin, std::size_t end) {
      if(end - begin == 1)
        pieces_[pieces_of_faces_[sides[begin].face]].is_closed = false;
    });
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
