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

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <map>
#include <numeric>
#include <set>
#include <stdexcept>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

namespace reeb_graph_program {
std::vector<Polygon_side> sides_of(const Polygons& polygons)
{
  // Each vertex has a range of those sides of which it is the lesser end: what is left to sort is little.
  std::vector<std::size_t> begins;
  const auto for_each_side = [&](const auto& visit) {
    std::size_t first = 0;
    for(std::size_t i = 0; i < polygons.size(); ++i)
    {
      const Polygons::Polygon polygon = polygons[i];
      const auto size = static_cast<std::size_t>(polygon.end() - polygon.begin());
      for(std::size_t j = 0; j < size; ++j)
      {
        const std::size_t next = (j + 1) % size;
        const Corner a = polygon.begin()[j], b = polygon.begin()[next];
        visit(a < b ? Polygon_side{a, b, first + j, first + next, i, false}
                    : Polygon_side{b, a, first + next, first + j, i, true});
      }
      first += size;
    }
  };
  for_each_side([&](const Polygon_side& side) {
    begins.resize(std::max<std::size_t>(begins.size(), side.u + 2), 0);
    ++begins[side.u + 1];
  });
  std::partial_sum(begins.begin(), begins.end(), begins.begin());
  std::vector<Polygon_side> sides(polygons.number_of_corners());
  std::vector<std::size_t> ends = begins;
  for_each_side([&](const Polygon_side& side) { sides[ends[side.u]++] = side; });
  for(std::size_t u = 0; u + 1 < begins.size(); ++u)
    std::sort(
      sides.begin() + static_cast<std::ptrdiff_t>(begins[u]),
      sides.begin() + static_cast<std::ptrdiff_t>(begins[u + 1]),
      [](const Polygon_side& a, const Polygon_side& b) { return std::tie(a.v, a.face) < std::tie(b.v, b.face); });
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

Mesh_counts count_soup(const Polygons& polygons, std::size_t number_of_vertices)
{
  const std::vector<Polygon_side> sides = sides_of(polygons);
  Mesh_counts counts;
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
    // Where borders are filled, components go, or solids are turned, points may be merged that others were in the way of.
    bool is_changed = true;
    for(int turn = 0; is_changed && turn < most_turns; ++turn)
    {
      if(is_best_searched)
        mend_in_the_best_way();
      else
        mend();
      is_changed =
        options_.least_share > 0
        && leave_out_pieces(faces_of_lesser_pieces(soup_, options_.least_share, counts), counts.faces_of_pieces);
      is_changed = (options_.most_filled_edges > 0 && fill()) || is_changed;
      is_changed = is_changed || (options_.is_largest_kept && keep_largest());
      is_changed = is_changed || (options_.are_faces_oriented && turn_solids());
    }
    if(options_.is_largest_kept) // also where these turns did not suffice
      keep_largest();
    if(options_.are_coinciding_points_merged || options_.distance)
      count_unmerged_points();
    if(options_.are_unused_points_left_out)
    {
      const std::size_t before = soup_.points.size();
      keep(are_on_faces());
      counts.unused_points = before - soup_.points.size();
    }
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
      if(options_.stitching)
        stitch();
      if(options_.are_faces_triangulated && triangulate_faces(soup_))
        throw std::runtime_error("a face cannot be cut into triangles");
      if(options_.are_faces_oriented) // before faces are paired across gaps outside
      {
        orient();
        if(options_.most_filled_edges == 0) // What is filled later may be around what is closed.
          turn_solids();
      }
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

  // With the points that are on no face. Returns whether there are any.
  bool leave_out_pieces(const std::vector<std::size_t>& polygons, std::size_t& number)
  {
    number += polygons.size();
    leave_out(polygons);
    if(!polygons.empty())
      keep(are_on_faces());
    return !polygons.empty();
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

  // Points come first, so that those that are left are not close to the ends of the edges that they cut.
  void stitch()
  {
    const Threshold& given = *options_.stitching;
    const double distance =
      given.is_percentage ? static_cast<double>(given.number / 100 * diagonal_of(soup_.points)) : given.number;
    join(join_close_points(soup_.points, border_points(soup_.polygons), distance));
    result_.counts.stitched_points += cut_at_junctions(soup_, distance);
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

  // Of those that lie in each other, the outermost one decides. Returns whether any are turned.
  bool turn_solids()
  {
    const Inside_out found = find_inside_out(soup_);
    result_.counts.turned_solids += found.solids;
    if(found.solids > 0)
      reverse(found.is_inside_out);
    return found.solids > 0;
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

  // Returns whether there are other components.
  bool keep_largest()
  {
    const std::vector<std::size_t> components = components_of_polygons(soup_.polygons, soup_.points.size());
    if(components.empty())
      return false;
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
    return leave_out_pieces(others, result_.counts.other_faces);
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
  const auto check = [](double distance, const std::string& what) {
    if(!(distance > 0 && std::isfinite(distance)))
      throw std::runtime_error("the distance within which " + what + " must be a positive finite number");
  };
  check(options.distance.value_or(1), "points are merged");
  check(options.stitching ? options.stitching->number : 1, "borders are stitched");
  if(!(options.least_share >= 0 && options.least_share <= 1))
    throw std::runtime_error("the least share of the area must be from 0 to 1");
  return Soup_repair(soup, options).repair();
}

} // namespace reeb_graph_program
