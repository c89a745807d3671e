// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of the CGAL-style package Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#include "page/decimate.h"

#include "base/progress_bar.h"

#include <CGAL/Surface_mesh_simplification/Edge_collapse_visitor_base.h>
#include <CGAL/Surface_mesh_simplification/Policies/Edge_collapse/Bounded_normal_change_filter.h>
#include <CGAL/Surface_mesh_simplification/Policies/Edge_collapse/Edge_length_cost.h>
#include <CGAL/Surface_mesh_simplification/Policies/Edge_collapse/Midpoint_placement.h>
#include <CGAL/Surface_mesh_simplification/edge_collapse.h>

#include <cmath>
#include <functional>
#include <utility>

namespace SMS = CGAL::Surface_mesh_simplification;

namespace reeb_graph_program {
namespace {
typedef Surface::Property_map<Surface::Vertex_index, bool> Kept_map;

// How far a point is from the planes of the triangles at both ends of an edge: the sum of the squared distances, each
// multiplied by twice the area of the triangle.
template <class Profile>
double distance_from_planes(const Profile& profile, const Point& point)
{
  double sum = 0;
  const auto point_map = profile.vertex_point_map();
  for(const auto& triangle : profile.triangles())
  {
    const Point& corner = get(point_map, triangle.v0);
    const auto normal = CGAL::cross_product(get(point_map, triangle.v1) - corner, get(point_map, triangle.v2) - corner);
    const double area = std::sqrt(normal.squared_length()), height = normal * (point - corner);
    if(area > 0)
      sum += height * height / area;
  }
  return sum;
}

// Puts what an edge becomes at that one of its ends that has to stay, or that is nearer to the surface around, and
// keeps an edge if both have to stay.
struct End_placement
{
  // The type of the result is that of the policies of CGAL, which depends on its version.
  template <class Profile>
  auto operator()(const Profile& profile) const
  {
    const bool is_first_kept = is_kept[profile.v0()], is_second_kept = is_kept[profile.v1()];
    decltype(SMS::Midpoint_placement<Surface>()(profile)) result;
    if(is_first_kept && is_second_kept)
      return result;
    const bool is_first_better =
      is_first_kept
      || (!is_second_kept && distance_from_planes(profile, profile.p0()) < distance_from_planes(profile, profile.p1()));
    result = is_first_better ? profile.p0() : profile.p1();
    return result;
  }

  Kept_map is_kept;
};

// How much a collapse changes the shape; where nothing changes, short edges come first.
struct Shape_cost
{
  template <class Profile, class Placement>
  auto operator()(const Profile& profile, const Placement& placement) const
  {
    auto cost = SMS::Edge_length_cost<Surface>()(profile, placement);
    constexpr double share_of_length = 1e-3;
    if(placement && cost)
      cost = distance_from_planes(profile, *placement) + share_of_length * *cost * *cost;
    return cost;
  }
};

// Lets the vertex that an edge becomes stand for the end that it is put at.
class Origin_visitor : public SMS::Edge_collapse_visitor_base<Surface>
{
public:
  Origin_visitor(Kept_map is_kept, Origin_map origin_map, std::function<void(std::size_t)> report_removed_edges)
    : is_kept_(is_kept),
      origin_map_(origin_map),
      report_removed_edges_(std::move(report_removed_edges))
  {}

  template <class Profile, class Cost>
  void OnSelected(const Profile&, const Cost&, std::size_t initial_edge_count, std::size_t current_edge_count)
  {
    report_removed_edges_(initial_edge_count - current_edge_count);
  }

  template <class Profile, class Placement>
  void OnCollapsing(const Profile& profile, const Placement& placement)
  {
    if(!placement)
      return;
    const bool is_at_first = is_kept_[profile.v0()] || (!is_kept_[profile.v1()] && *placement == profile.p0());
    const Surface::Vertex_index end = is_at_first ? profile.v0() : profile.v1();
    is_end_kept_ = is_kept_[end];
    origin_ = origin_map_[end];
  }

  template <class Profile>
  void OnCollapsed(const Profile&, Surface::Vertex_index v)
  {
    is_kept_[v] = is_end_kept_;
    origin_map_[v] = origin_;
  }

private:
  Kept_map is_kept_;
  Origin_map origin_map_;
  std::function<void(std::size_t)> report_removed_edges_;
  bool is_end_kept_ = false;
  Surface::Vertex_index origin_;
};

// Stops when so many edges are gone.
struct Removal_stop
{
  template <class Cost, class Profile>
  bool operator()(const Cost&, const Profile&, std::size_t initial_edge_count, std::size_t current_edge_count) const
  {
    return initial_edge_count - current_edge_count >= number_of_edges_to_remove;
  }

  std::size_t number_of_edges_to_remove;
};

void collapse_edges(Surface& surface, std::size_t number_of_faces_to_remove, Kept_map is_kept, Origin_map origin_map)
{
  // A collapse that removes two faces removes three edges.
  const std::size_t number_of_edges_to_remove = (3 * number_of_faces_to_remove + 1) / 2;
  Progress_bar progress_bar("page");
  const Origin_visitor visitor(is_kept, origin_map, [&](std::size_t number_of_removed_edges) {
    if(number_of_removed_edges % 1024 == 0)
      progress_bar(double(number_of_removed_edges) / double(number_of_edges_to_remove));
  });
  SMS::edge_collapse(surface, Removal_stop{number_of_edges_to_remove},
                     CGAL::parameters::get_cost(Shape_cost())
                       .get_placement(End_placement{is_kept})
                       .filter(SMS::Bounded_normal_change_filter<>())
                       .visitor(visitor));
}

void keep_borders(const Surface& surface, const std::optional<Patch_map>& patch_map, Kept_map is_kept)
{
  for(const Surface::Edge_index e : surface.edges())
  {
    const Surface::Halfedge_index h = surface.halfedge(e);
    if(surface.is_border(e)
       || (patch_map && (*patch_map)[surface.face(h)] != (*patch_map)[surface.face(surface.opposite(h))]))
      is_kept[surface.source(h)] = is_kept[surface.target(h)] = true;
  }
}

} // namespace

Decimated_surface decimate(const Surface& surface,
                           std::size_t number_of_faces,
                           const std::vector<Surface::Vertex_index>& vertices_to_keep,
                           const std::optional<Patch_map>& patch_map)
{
  Decimated_surface result;
  Surface& copy = result.surface = surface;
  result.origin_map = copy.add_property_map<Surface::Vertex_index, Surface::Vertex_index>("v:origin").first;
  const Kept_map is_kept = copy.add_property_map<Surface::Vertex_index, bool>("v:is_kept", false).first;
  for(const Surface::Vertex_index v : copy.vertices())
    result.origin_map[v] = v;
  for(const Surface::Vertex_index v : vertices_to_keep)
    is_kept[v] = true;
  keep_borders(surface, patch_map, is_kept);
  if(patch_map)
  {
    result.patch_map = copy.add_property_map<Surface::Face_index, int>("f:shown_patch").first;
    for(const Surface::Face_index f : copy.faces())
      (*result.patch_map)[f] = (*patch_map)[f];
  }
  if(copy.number_of_faces() > number_of_faces)
    collapse_edges(copy, copy.number_of_faces() - number_of_faces, is_kept, result.origin_map);
  copy.collect_garbage();
  return result;
}

} // namespace reeb_graph_program
