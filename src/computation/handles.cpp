// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#include "computation/handles.h"

#include "base/progress_bar.h"
#include "computation/simplification.h"

#include <CGAL/Reeb_graph/IO/polylines.h>
#include <CGAL/Reeb_graph/curves/Refinement_visitor.h>
#include <CGAL/Reeb_graph/handles/area_of_filling_disc.h>
#include <CGAL/Reeb_graph/handles/handle_and_tunnel_loops.h>
#include <CGAL/Reeb_graph/handles/remove_handles.h>
#include <CGAL/Reeb_graph/internal/base/lengths.h>
#include <CGAL/Reeb_graph/simplification/persistence_pairs.h>
#include <CGAL/compute_reeb_graph.h>

#include <algorithm>
#include <cstddef>
#include <functional>
#include <iterator>
#include <limits>
#include <set>
#include <stdexcept>
#include <variant>
#include <vector>

namespace reeb_graph_program {
namespace {
// That of all pairs of extrema with saddles.
double total_persistence(const Surface& surface, Scalar_map scalar_map)
{
  typedef CGAL::Reeb_graph::Persistence_pair_kind Kind;
  Graph graph;
  CGAL::compute_reeb_graph<CGAL::Parallel_if_available_tag>(surface, scalar_map, graph);
  std::vector<CGAL::Reeb_graph::Persistence_pair<boost::graph_traits<Graph>::vertex_descriptor>> pairs;
  CGAL::Reeb_graph::persistence_pairs(graph, std::back_inserter(pairs));
  double sum = 0;
  for(const auto& pair : pairs)
  {
    if(pair.kind == Kind::MINIMUM_SADDLE || pair.kind == Kind::SADDLE_MAXIMUM)
      sum += CGAL::Reeb_graph::persistence(graph, pair);
  }
  return sum;
}

double size_in_units(const std::optional<Threshold>& size, const Surface& surface)
{
  if(!size)
    return std::numeric_limits<double>::infinity();
  if(!size->is_percentage)
    return size->number;
  CGAL::Bbox_3 box;
  for(const Surface::Vertex_index v : surface.vertices())
    if(!surface.is_isolated(v))
      box += surface.point(v).bbox();
  const auto extent = [&](int axis) { return (std::max)(box.max(axis) - box.min(axis), 0.); };
  return size->number / 100 * CGAL::Reeb_graph::internal::length_of(extent(0), extent(1), extent(2));
}

void write_coordinate(const Surface& surface, Scalar_map scalar_map, int coordinate)
{
  for(const Surface::Vertex_index v : surface.vertices())
    scalar_map[v] = surface.point(v)[coordinate];
}

} // namespace

Loop_place place_of(const Polyline& polyline)
{
  Loop_place result;
  std::array<CGAL::Reeb_graph::internal::Weighted_mean, 3> means;
  for(std::size_t i = 0; i != polyline.size(); ++i)
  {
    const Point &p = polyline[i], &q = polyline[i == 0 ? 0 : i - 1];
    const double length = CGAL::Reeb_graph::internal::length_of(p.x() - q.x(), p.y() - q.y(), p.z() - q.z());
    for(int k = 0; k != 3; ++k)
    {
      const auto axis = static_cast<std::size_t>(k);
      means[axis].add(p[k] / 2 + q[k] / 2, length);
      result.box[0][axis] = i == 0 ? p[k] : (std::min)(result.box[0][axis], p[k]);
      result.box[1][axis] = i == 0 ? p[k] : (std::max)(result.box[1][axis], p[k]);
    }
  }
  // All points of a loop without length are one.
  for(std::size_t axis = 0; axis != 3; ++axis)
    result.center[axis] = means[axis].weight > 0 ? means[axis].mean : result.box[0][axis];
  return result;
}

std::vector<Removal_row> remove_handles(Surface& surface,
                                        Scalar_map scalar_map,
                                        const std::vector<Any_vertex_property>& properties,
                                        const std::optional<Threshold>& size,
                                        std::size_t number,
                                        bool are_self_intersections_ignored)
{
  CGAL::Reeb_graph::Interpolating_visitor<Surface> visitor;
  visitor.add_vertex_map(scalar_map);
  for(const Any_vertex_property& property : properties)
    std::visit([&](const auto& map) { visitor.add_vertex_map(map); }, property);
  Progress_bar progress_bar("removal");
  std::vector<Removal_row> result;
  for(const auto& handle : CGAL::Reeb_graph::remove_handles<CGAL::Parallel_if_available_tag>(
        surface, size_in_units(size, surface),
        CGAL::parameters::number_of_handles(number)
          .ignore_self_intersections(are_self_intersections_ignored)
          .visitor(visitor)
          .callback(std::ref(progress_bar))))
  {
    const bool is_removed = handle.result == CGAL::Reeb_graph::Removal_result::REMOVED;
    Polyline polyline;
    for(const auto& p : handle.points)
      polyline.emplace_back(p[0], p[1], p[2]);
    polyline.push_back(polyline.front());
    result.push_back({to_string(handle.kind), handle.length, handle.component, is_removed,
                      is_removed ? std::string() : to_string(handle.result), place_of(polyline)});
    result.back().place.vertices.assign(handle.vertices.begin(), handle.vertices.end());
  }
  return result;
}

Loops_of_surface find_loops(const Surface& surface,
                            Scalar_map scalar_map,
                            bool are_shortened,
                            bool are_self_intersections_ignored)
{
  Progress_bar progress_bar("handles");
  const auto found = CGAL::Reeb_graph::handle_and_tunnel_loops<CGAL::Parallel_if_available_tag>(
    surface, scalar_map,
    CGAL::parameters::shorten_loops(are_shortened)
      .ignore_self_intersections(are_self_intersections_ignored)
      .callback(std::ref(progress_bar)));
  std::vector<std::vector<Surface::Halfedge_index>> walks;
  for(const auto& loop : found.loops())
    walks.push_back(loop.is_simple ? loop.halfedges : std::vector<Surface::Halfedge_index>());
  const auto areas = CGAL::Reeb_graph::areas_of_filling_discs(surface, walks);
  Loops_of_surface result;
  std::set<std::size_t> components;
  for(std::size_t i = 0; i != found.loops().size(); ++i)
  {
    const auto& loop = found.loops()[i];
    Loop_row row;
    row.kind = to_string(loop.kind);
    row.length = loop.length;
    if(loop.partner != loop.no_partner)
    {
      row.partner = loop.partner;
      row.persistence = loop.persistence;
    }
    row.area = areas[i];
    row.component = loop.component;
    row.is_simple = loop.is_simple;
    const std::size_t self_intersections = found.number_of_self_intersections(loop.component);
    row.is_certain = self_intersections == 0 || loop.kind == CGAL::Reeb_graph::Loop_kind::LOOP;
    if(components.insert(loop.component).second)
      result.self_intersections += self_intersections;
    result.polylines.push_back(CGAL::Reeb_graph::polyline_of_curve(surface, loop));
    row.place = place_of(result.polylines.back());
    for(const Surface::Halfedge_index h : loop.halfedges)
      row.place.vertices.push_back(surface.source(h));
    result.rows.push_back(row);
  }
  return result;
}

std::string write_least_rough_height(const Surface& surface, Scalar_map scalar_map)
{
  int best = 2;
  double least = std::numeric_limits<double>::infinity();
  for(int coordinate : {2, 1, 0})
  {
    write_coordinate(surface, scalar_map, coordinate);
    const double sum = total_persistence(surface, scalar_map);
    if(sum < least)
    {
      least = sum;
      best = coordinate;
    }
  }
  write_coordinate(surface, scalar_map, best);
  return std::string(1, static_cast<char>('x' + best));
}

} // namespace reeb_graph_program
