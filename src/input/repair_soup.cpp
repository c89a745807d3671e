// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#include "input/repair_soup.h"

#include "input/close_points.h"
#include "input/find_duplicates.h"
#include "input/repeated_vertex.h"
#include "input/soup_counts.h"

#include <CGAL/Polygon_mesh_processing/orient_polygon_soup.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <map>
#include <numeric>
#include <stdexcept>
#include <vector>

namespace PMP = CGAL::Polygon_mesh_processing;

namespace reeb_graph_program {
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

// What orient_polygon_soup() does, by numbers.
struct Orientation_record
{
  std::vector<char> is_reversed;
  std::vector<std::size_t> originals; // of the vertices that it adds
};

struct Orientation_visitor : PMP::Default_orientation_visitor
{
  explicit Orientation_visitor(Orientation_record* given = nullptr) : record(given) {}
  void duplicated_vertex(std::size_t original, std::size_t) { record->originals.push_back(original); }
  void polygon_orientation_reversed(std::size_t i) { record->is_reversed[i] ^= 1; }

  Orientation_record* record;
};

class Soup_repair
{
public:
  Soup_repair(Polygon_soup& soup, const Repair_options& options) : soup_(soup), options_(options)
  {
    result_.new_vertices.resize(soup.points.size());
    std::iota(result_.new_vertices.begin(), result_.new_vertices.end(), std::size_t(0));
    result_.old_vertices = result_.new_vertices;
  }

  Repair_result repair()
  {
    Repair_counts& counts = result_.counts;
    counts.given = counts.merged = count_soup(soup_.polygons, soup_.points.size());
    if(options_.are_coinciding_points_merged || options_.distance)
    {
      merge();
      counts.merged = count_soup(soup_.polygons, soup_.points.size());
    }
    if(options_.are_faces_oriented || options_.is_split)
      orient_or_split();
    if(options_.is_largest_kept)
      keep_largest();
    counts.result = count_soup(soup_.polygons, soup_.points.size());
    return std::move(result_);
  }

private:
  // Keeps those of the points, in their order, and of the polygons what is left.
  void keep(const std::vector<char>& is_kept)
  {
    std::vector<std::size_t> numbers(soup_.points.size(), no_vertex), old_vertices;
    std::vector<Point> points;
    for(std::size_t v = 0; v < soup_.points.size(); ++v)
      if(is_kept[v] != 0)
      {
        numbers[v] = points.size();
        points.push_back(soup_.points[v]);
        old_vertices.push_back(result_.old_vertices[v]);
      }
    for(std::size_t& v : result_.new_vertices)
      v = v == no_vertex ? no_vertex : numbers[v];
    soup_.polygons = copy_polygons(soup_.polygons, {}, [&](Corner v) { return numbers[v]; });
    soup_.points = std::move(points);
    result_.old_vertices = std::move(old_vertices);
  }

  void leave_out(const std::vector<std::size_t>& polygons)
  {
    if(!polygons.empty())
      soup_.polygons = copy_polygons(soup_.polygons, polygons, same_vertex);
  }

  void merge()
  {
    const std::vector<Corner> joined =
      join_close_points(soup_.points, border_points(soup_.polygons), options_.distance.value_or(0));
    soup_.polygons = copy_polygons(soup_.polygons, {}, [&](Corner v) { return joined[v]; });
    std::vector<char> is_kept(joined.size());
    for(std::size_t v = 0; v < joined.size(); ++v)
    {
      is_kept[v] = static_cast<char>(joined[v] == v);
      result_.counts.merged_points += joined[v] == v ? 0 : 1;
      result_.new_vertices[v] = joined[v];
    }
    const std::vector<std::size_t> collapsed = degenerate_polygons(soup_.polygons);
    result_.counts.collapsed_faces = collapsed.size();
    leave_out(collapsed);
    const Duplicates duplicates = find_duplicates(soup_.polygons, true);
    result_.counts.faces_repeated_by_merging = duplicates.number;
    leave_out(duplicates.numbers);
    keep(is_kept);
  }

  // Vertices that are added get the highest numbers. Without splitting, they are taken back.
  void orient_or_split()
  {
    Orientation_record record;
    record.is_reversed.resize(soup_.polygons.size(), 0);
    std::vector<std::vector<std::size_t>> polygons;
    for(std::size_t i = 0; i < soup_.polygons.size(); ++i)
      polygons.emplace_back(soup_.polygons[i].begin(), soup_.polygons[i].end());
    std::vector<Point> points = soup_.points;
    PMP::orient_polygon_soup(points, polygons, CGAL::parameters::visitor(Orientation_visitor(&record)));
    const std::size_t given = soup_.points.size();
    Polygons result;
    for(std::size_t i = 0; i < polygons.size(); ++i)
    {
      if(record.is_reversed[i] != 0 && !options_.are_faces_oriented)
        std::reverse(polygons[i].begin(), polygons[i].end());
      for(const std::size_t v : polygons[i])
        result.add_corner(v < given || options_.is_split ? v : original(record, v));
      result.end_polygon();
    }
    soup_.polygons = std::move(result);
    if(options_.are_faces_oriented)
      result_.counts.reversed_faces =
        static_cast<std::size_t>(std::count(record.is_reversed.begin(), record.is_reversed.end(), 1));
    if(!options_.is_split)
      return;
    result_.counts.added_points = points.size() - given;
    for(std::size_t v = given; v < points.size(); ++v)
      result_.old_vertices.push_back(result_.old_vertices[original(record, v)]);
    soup_.points = std::move(points);
  }

  std::size_t original(const Orientation_record& record, std::size_t v) const
  {
    while(v >= soup_.points.size())
      v = record.originals[v - soup_.points.size()];
    return v;
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
    std::vector<char> is_kept(soup_.points.size(), 0);
    for(std::size_t i = 0; i < components.size(); ++i)
    {
      if(components[i] != largest)
        others.push_back(i);
      else
        for(const Corner v : soup_.polygons[i])
          is_kept[v] = 1;
    }
    result_.counts.other_faces = others.size();
    leave_out(others);
    keep(is_kept);
  }

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

void leave_out_repeated_faces(Polygons& polygons, Input_findings& findings)
{
  const Duplicates duplicates = find_duplicates(polygons, true);
  if(duplicates.number == 0)
    return;
  findings.repeated_faces = numbers_in_file(duplicates.numbers, findings.degenerate_faces);
  polygons = copy_polygons(polygons, duplicates.numbers, same_vertex);
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
  return Soup_repair(soup, options).repair();
}

} // namespace reeb_graph_program
