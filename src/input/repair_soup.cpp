// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#include "input/repair_soup.h"

#include "input/assemble_surface.h"
#include "input/merge_points.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <iterator>
#include <map>
#include <numeric>
#include <set>
#include <stdexcept>
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
  for(const Corner v : polygons.corners())
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

namespace {
// Leaves polygons out, in ascending order of their numbers, and gives vertices other numbers.
template <class NewVertex>
Polygons copy_polygons(const Polygons& polygons, const std::vector<std::size_t>& left_out, const NewVertex& new_vertex)
{
  Polygons result;
  result.reserve(polygons.size());
  auto next = left_out.begin();
  for(std::size_t i = 0; i < polygons.size(); ++i)
  {
    if(next != left_out.end() && *next == i)
    {
      ++next;
      continue;
    }
    for(const Corner v : polygons[i])
      result.add_corner(new_vertex(v));
    result.end_polygon();
  }
  return result;
}

std::size_t same_vertex(Corner v) { return v; }

std::vector<std::size_t> degenerate_polygons(const Polygons& polygons)
{
  std::vector<std::size_t> numbers;
  std::vector<Corner> sorted;
  for(std::size_t i = 0; i < polygons.size(); ++i)
    if(polygons[i].size() < 3 || find_repeated_vertex(polygons[i], sorted))
      numbers.push_back(i);
  return numbers;
}

// The numbers in the file of faces that are numbered without those that are left out; both ascend.
std::vector<std::size_t> numbers_in_file(std::vector<std::size_t> numbers, const std::vector<std::size_t>& left_out)
{
  std::size_t before = 0;
  for(std::size_t& number : numbers)
  {
    while(before < left_out.size() && left_out[before] <= number + before)
      ++before;
    number += before;
  }
  return numbers;
}

class Soup_repair
{
public:
  Soup_repair(Polygon_soup& soup, const Repair_options& options) : soup_(soup), options_(options)
  {
    result_.new_vertices.resize(soup.points.size());
    std::iota(result_.new_vertices.begin(), result_.new_vertices.end(), std::size_t(0));
    result_.old_vertices = result_.other_ends = result_.new_vertices;
  }

  Repair_result repair()
  {
    Repair_counts& counts = result_.counts;
    counts.given = counts.merged = count_soup(soup_.polygons, soup_.points.size());
    const bool is_best_searched = !options_.distance && options_.are_coinciding_points_merged
                               && options_.are_opposite_faces_cancelled && options_.is_split;
    for(int turn = 0; turn < most_turns; ++turn)
    {
      if(is_best_searched)
        mend_in_the_best_way();
      else
        mend();
      if(options_.least_share > 0)
        leave_out_pieces(faces_of_lesser_pieces(soup_, options_.least_share, counts), counts.faces_of_pieces);
      if(!(options_.most_filled_edges > 0 && fill()))
        break; // else points may be merged now, as faces lie between them
    }
    if(options_.are_coinciding_points_merged || options_.distance)
      count_unmerged_points();
    if(options_.is_largest_kept)
      keep_largest();
    counts.result = count_soup(soup_.polygons, soup_.points.size());
    return std::move(result_);
  }

private:
  void mend()
  {
    const bool is_merged = options_.are_coinciding_points_merged || options_.distance;
    for(int turn = 0; turn < most_turns; ++turn)
    {
      if(!(is_merged && merge()) && turn > 0)
        break;
      // What is cancelled can be in the way of merging.
      while(options_.are_opposite_faces_cancelled && cancel_opposite_faces() && is_merged && merge())
      {}
      if(options_.are_faces_triangulated && triangulate_faces(soup_))
        throw std::runtime_error("a face cannot be cut into triangles");
      if(options_.is_split)
        add_points(split_at_pairs(soup_, pair_faces(soup_), result_.counts));
      if(options_.are_faces_oriented)
        orient();
      soup_.copies.clear();
      if(!options_.is_split || options_.distance || !is_merged)
        break; // else points may be merged now, as faces are parted, and agree
    }
  }

  // Where coinciding points of borders are all joined first, as in a file whose faces have corners of their own, fewer
  // edges may be of one face in the end. A second repair finds no better way.
  void mend_in_the_best_way()
  {
    const Polygon_soup soup = soup_;
    const Repair_result result = result_;
    mend();
    is_better_joined(soup, result);
    while(is_better_joined(soup_, result_))
    {}
  }

  // Takes the way that joins first, if it is better.
  bool is_better_joined(Polygon_soup soup, const Repair_result& result)
  {
    Soup_repair other(soup, options_);
    other.result_ = result;
    const std::vector<Corner> border = border_points(soup.polygons);
    if(!other.join(join_close_points(soup.points, border, 0)))
      return false;
    other.mend();
    if(count_soup(soup.polygons, soup.points.size()).border_edges
       >= count_soup(soup_.polygons, soup_.points.size()).border_edges)
      return false;
    soup_ = std::move(soup);
    result_ = std::move(other.result_);
    return true;
  }

  // Keeps those of the points, in their order, and of the polygons what is left.
  void keep(const std::vector<char>& is_kept)
  {
    std::vector<std::size_t> numbers(soup_.points.size(), no_vertex);
    std::size_t number = 0;
    for(std::size_t v = 0; v < soup_.points.size(); ++v)
      if(is_kept[v] != 0)
      {
        numbers[v] = number;
        soup_.points[number] = soup_.points[v];
        result_.old_vertices[number] = result_.old_vertices[v];
        result_.other_ends[number++] = result_.other_ends[v];
      }
    for(std::size_t& v : result_.new_vertices)
      v = v == no_vertex ? no_vertex : numbers[v];
    soup_.polygons = copy_polygons(soup_.polygons, {}, [&](Corner v) { return numbers[v]; });
    soup_.points.resize(number);
    result_.old_vertices.resize(number);
    result_.other_ends.resize(number);
  }

  std::vector<char> are_on_faces() const
  {
    std::vector<char> result(soup_.points.size(), 0);
    for(const Corner v : soup_.polygons.corners())
      result[v] = 1;
    return result;
  }

  // Each added point is a copy of a vertex, or between two.
  void add_points(const std::vector<std::array<Corner, 2>>& origins)
  {
    for(const auto& [u, v] : origins)
    {
      result_.old_vertices.push_back(result_.old_vertices[u]);
      result_.other_ends.push_back(result_.old_vertices[v]);
    }
  }

  void leave_out(const std::vector<std::size_t>& polygons)
  {
    if(polygons.empty())
      return;
    soup_.polygons = copy_polygons(soup_.polygons, polygons, same_vertex);
    for(auto i = polygons.rbegin(); i != polygons.rend() && !soup_.copies.empty(); ++i)
      soup_.copies[*i] = 0;
    soup_.copies.erase(std::remove(soup_.copies.begin(), soup_.copies.end(), 0), soup_.copies.end());
  }

  // With the points that are on no face.
  void leave_out_pieces(const std::vector<std::size_t>& polygons, std::size_t& number)
  {
    number = polygons.size();
    leave_out(polygons);
    if(number > 0)
      keep(are_on_faces());
  }

  // Returns whether any are.
  bool merge()
  {
    const std::vector<Corner> joined =
      options_.distance ? join_close_points(soup_.points, border_points(soup_.polygons), *options_.distance)
                        : merge_coinciding_points(soup_, options_.is_split);
    return join(joined);
  }

  bool join(const std::vector<Corner>& joined)
  {
    soup_.polygons = copy_polygons(soup_.polygons, {}, [&](Corner v) { return joined[v]; });
    std::vector<char> is_kept(joined.size());
    for(std::size_t v = 0; v < joined.size(); ++v)
      is_kept[v] = static_cast<char>(joined[v] == v);
    for(std::size_t& v : result_.new_vertices)
      v = v == no_vertex ? no_vertex : joined[v];
    const auto number = static_cast<std::size_t>(std::count(is_kept.begin(), is_kept.end(), 0));
    result_.counts.merged_points += number;
    const std::vector<std::size_t> collapsed = degenerate_polygons(soup_.polygons);
    result_.counts.collapsed_faces += collapsed.size();
    leave_out(collapsed);
    const Duplicates duplicates = find_duplicates(soup_.polygons, true);
    result_.counts.faces_repeated_by_merging += duplicates.number;
    for(std::size_t i = 0; i < duplicates.firsts.size() && !soup_.copies.empty(); ++i)
      soup_.copies[duplicates.firsts[i]] += duplicates.firsts[i] == i ? 0 : soup_.copies[i];
    leave_out(duplicates.numbers);
    keep(is_kept);
    result_.counts.merged = count_soup(soup_.polygons, soup_.points.size());
    return number > 0;
  }

  void count_unmerged_points()
  {
    std::set<std::array<double, 3>> places; // zeros of either sign are the same
    for(const Point& p : soup_.points)
      places.insert({p.x() + 0., p.y() + 0., p.z() + 0.});
    result_.counts.unmerged_points = soup_.points.size() - places.size();
  }

  // Of faces with the same corners, one stays if it is there more often than the other way round. Of a component that would
  // go, one side stays, whose faces agree where they can. Returns whether any go.
  bool cancel_opposite_faces()
  {
    const std::vector<std::size_t> firsts = find_duplicates(soup_.polygons, false).firsts;
    const std::vector<std::size_t> components = components_of_polygons(soup_.polygons, soup_.points.size());
    const auto copies = [&](std::size_t i) { return soup_.copies.empty() ? 1 : soup_.copies[i]; };
    std::vector<char> is_out(firsts.size(), 0), is_component_kept(soup_.points.size(), 0);
    for(std::size_t i = 0; i < firsts.size(); ++i)
      if(firsts[i] != i)
      {
        is_out[i] = copies(i) <= copies(firsts[i]) ? 1 : 0;
        is_out[firsts[i]] = copies(i) >= copies(firsts[i]) ? 1 : 0;
      }
    for(std::size_t i = 0; i < firsts.size(); ++i)
      if(is_out[i] == 0)
        is_component_kept[components[i]] = 1;
    const std::vector<char> were_on_faces = are_on_faces();
    std::vector<std::size_t> left_out;
    std::vector<char> is_of_sheet;
    std::set<std::size_t> sheets;
    for(std::size_t i = 0; i < firsts.size(); ++i)
    {
      const bool is_sheet = is_component_kept[components[i]] == 0;
      if(is_sheet)
        sheets.insert(components[i]);
      if(is_sheet ? firsts[i] != i : is_out[i] != 0)
        left_out.push_back(i);
      else
        is_of_sheet.push_back(is_sheet ? 1 : 0);
    }
    result_.counts.sheets += sheets.size();
    result_.counts.cancelled_faces += left_out.size();
    leave_out(left_out);
    if(!sheets.empty())
    {
      const std::vector<char> is_turned = pair_faces(soup_).is_turned;
      std::transform(is_turned.begin(), is_turned.end(), is_of_sheet.begin(), is_of_sheet.begin(), std::bit_and<>());
      reverse(is_of_sheet);
    }
    std::vector<char> is_kept = are_on_faces();
    std::transform(is_kept.begin(), is_kept.end(), were_on_faces.begin(), is_kept.begin(),
                   [](char is, char was) { return static_cast<char>(is | (was ^ 1)); });
    keep(is_kept);
    return !left_out.empty();
  }

  void reverse(const std::vector<char>& is_turned)
  {
    Polygons result;
    std::vector<Corner> corners;
    for(std::size_t i = 0; i < soup_.polygons.size(); ++i)
    {
      corners.assign(soup_.polygons[i].begin(), soup_.polygons[i].end());
      if(is_turned[i] != 0)
        std::reverse(corners.begin(), corners.end());
      result.add(corners);
    }
    soup_.polygons = std::move(result);
  }

  void orient()
  {
    const std::vector<char> is_turned = pair_faces(soup_).is_turned;
    result_.counts.reversed_faces += static_cast<std::size_t>(std::count(is_turned.begin(), is_turned.end(), 1));
    reverse(is_turned);
  }

  // Returns whether any border is filled.
  bool fill()
  {
    std::vector<std::array<Corner, 2>> origins;
    const std::size_t before = soup_.polygons.size(), number = fill_borders(soup_, options_.most_filled_edges, origins);
    result_.counts.filled_borders += number;
    result_.counts.filling_faces += soup_.polygons.size() - before;
    add_points(origins);
    return number > 0;
  }

  void keep_largest()
  {
    const std::vector<std::size_t> components = components_of_polygons(soup_.polygons, soup_.points.size());
    if(components.empty())
      return;
    std::map<std::size_t, std::size_t> sizes;
    for(const std::size_t component : components)
      ++sizes[component];
    std::size_t largest = components.front();
    for(const std::size_t component : components) // in the order of faces
      if(sizes[component] > sizes[largest])
        largest = component;
    std::vector<std::size_t> others;
    for(std::size_t i = 0; i < components.size(); ++i)
      if(components[i] != largest)
        others.push_back(i);
    leave_out_pieces(others, result_.counts.other_faces);
  }

  static constexpr int most_turns = 8;

  Polygon_soup& soup_;
  Repair_options options_;
  Repair_result result_;
};

} // namespace

void leave_out_degenerate_faces(Polygons& polygons, Input_findings& findings)
{
  findings.faces = polygons.size();
  findings.degenerate_faces = degenerate_polygons(polygons);
  for(const std::size_t i : findings.degenerate_faces)
    findings.faces_of_few_corners += polygons[i].size() < 3 ? 1 : 0;
  if(!findings.degenerate_faces.empty())
    polygons = copy_polygons(polygons, findings.degenerate_faces, same_vertex);
}

void leave_out_repeated_faces(Polygon_soup& soup, Input_findings& findings)
{
  const Duplicates duplicates = find_duplicates(soup.polygons, true);
  if(duplicates.number == 0)
    return;
  findings.repeated_faces = numbers_in_file(duplicates.numbers, findings.degenerate_faces);
  std::vector<std::size_t> copies(soup.polygons.size(), 0);
  for(const std::size_t first : duplicates.firsts)
    ++copies[first];
  copies.erase(std::remove(copies.begin(), copies.end(), 0), copies.end());
  soup.copies = std::move(copies);
  soup.polygons = copy_polygons(soup.polygons, duplicates.numbers, same_vertex);
}

std::size_t number_in_file(std::size_t face, const Input_findings& findings)
{
  std::vector<std::size_t> left_out;
  std::merge(findings.degenerate_faces.begin(), findings.degenerate_faces.end(), findings.repeated_faces.begin(),
             findings.repeated_faces.end(), std::back_inserter(left_out));
  return numbers_in_file({face}, left_out).front();
}

Repair_result repair_soup(Polygon_soup& soup, const Repair_options& options)
{
  if(options.distance && !(*options.distance > 0 && std::isfinite(*options.distance)))
    throw std::runtime_error("the distance within which points are merged must be a positive finite number");
  if(!(options.least_share >= 0 && options.least_share <= 1))
    throw std::runtime_error("the least share of the area must be from 0 to 1");
  return Soup_repair(soup, options).repair();
}

} // namespace reeb_graph_program
