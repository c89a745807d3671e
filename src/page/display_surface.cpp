// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#include "page/page_data.h"

#include "base/progress_bar.h"
#include "base/surface.h"

#include <CGAL/Bbox_3.h>
#include <CGAL/Polygon_mesh_processing/bbox.h>

#include <meshoptimizer.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <map>
#include <optional>
#include <stdexcept>
#include <utility>
#include <vector>

namespace reeb_graph_program {
namespace {
// The faces that a page shows.
struct Shown_faces
{
  std::vector<std::uint32_t> corners; // three indices of vertices of the surface for each face
  std::optional<std::vector<std::int32_t>> patches;
};
typedef std::vector<std::uint32_t> Corners; // three vertices for each face

void append_corners(const Surface& surface, Surface::Face_index f, Corners& corners)
{
  for(const Surface::Vertex_index v : surface.vertices_around_face(surface.halfedge(f)))
    corners.push_back(v.idx());
}

// Three coordinates for each vertex, around the centre and by the size of the box, as single precision is enough then.
std::vector<float> relative_positions(const Surface& surface)
{
  const CGAL::Bbox_3 box = CGAL::Polygon_mesh_processing::bbox(surface);
  double size = 0;
  for(int i = 0; i != 3; ++i)
    size = (std::max)(size, box.max(i) - box.min(i));
  std::vector<float> positions;
  positions.reserve(3 * (surface.number_of_vertices() + surface.number_of_removed_vertices()));
  for(const Point& point : surface.points())
    for(int i = 0; i != 3; ++i)
      positions.push_back(size > 0 ? static_cast<float>((point[i] - (box.min(i) + box.max(i)) / 2) / size) : 0.f);
  return positions;
}

// One face at each of the vertices that have any. Without it, the vertex is on the border of the other faces, and stays.
std::vector<bool> faces_to_keep(const Surface& surface, const std::vector<Surface::Vertex_index>& vertices_to_keep)
{
  std::vector<bool> is_kept(surface.number_of_faces() + surface.number_of_removed_faces());
  for(const Surface::Vertex_index v : vertices_to_keep)
    if(!surface.is_isolated(v) && !surface.is_border(v))
      is_kept[surface.face(surface.halfedge(v)).idx()] = true;
  return is_kept;
}

// The faces that are left of so many, the borders of which stay.
void collapse_edges(const std::vector<float>& positions, std::size_t number_of_faces, Corners& corners)
{
  constexpr float any_error = (std::numeric_limits<float>::max)();
  const std::size_t number_of_vertices = positions.size() / 3;
  corners.resize(meshopt_simplify(corners.data(), corners.data(), corners.size(), positions.data(), number_of_vertices,
                                  3 * sizeof(float), 3 * number_of_faces, any_error, meshopt_SimplifyLockBorder));
}

Shown_faces all_faces(const Surface& surface, const std::optional<Patch_map>& patch_map)
{
  Shown_faces result;
  result.corners.reserve(3 * surface.number_of_faces());
  for(const Surface::Face_index f : surface.faces())
    append_corners(surface, f, result.corners);
  if(patch_map)
  {
    result.patches.emplace();
    for(const Surface::Face_index f : surface.faces())
      result.patches->push_back((*patch_map)[f]);
  }
  return result;
}

// Collapses edges into one of their ends, those first that change the shape least, until few enough faces are left. The
// vertices that are named, and those on borders and between patches, stay. Patches come one after the other.
Shown_faces decimate(const Surface& surface,
                     std::size_t number_of_faces,
                     const std::vector<Surface::Vertex_index>& vertices_to_keep,
                     const std::optional<Patch_map>& patch_map)
{
  const std::vector<float> positions = relative_positions(surface);
  const std::vector<bool> is_kept = faces_to_keep(surface, vertices_to_keep);
  const double share = double(number_of_faces) / double(surface.number_of_faces());
  std::map<std::int32_t, Corners> kept, others; // by patch
  for(const Surface::Face_index f : surface.faces())
    append_corners(surface, f, (is_kept[f.idx()] ? kept : others)[patch_map ? (*patch_map)[f] : 0]);

  Shown_faces result;
  if(patch_map)
    result.patches.emplace();
  Progress_bar progress_bar("page");
  const auto append = [&](const std::pair<const std::int32_t, Corners>& patch) {
    result.corners.insert(result.corners.end(), patch.second.begin(), patch.second.end());
    if(result.patches)
      result.patches->resize(result.corners.size() / 3, patch.first);
  };
  for(auto& patch : others)
  {
    progress_bar(double(result.corners.size()) / double(3 * number_of_faces));
    const std::size_t size = (patch.second.size() + kept[patch.first].size()) / 3;
    const std::size_t number_left = static_cast<std::size_t>(share * double(size));
    const std::size_t number_kept = kept[patch.first].size() / 3;
    collapse_edges(positions, number_left - (std::min)(number_left, number_kept), patch.second);
    append(patch);
  }
  for(const auto& patch : kept)
    append(patch);
  return result;
}

double largest_extent(const CGAL::Bbox_3& box)
{
  return (std::max)({box.xmax() - box.xmin(), box.ymax() - box.ymin(), box.zmax() - box.zmin()});
}

// The place of a vertex in the graph as the page writes it.
std::int32_t page_place(std::size_t place, std::size_t number_of_nodes)
{
  return place < number_of_nodes ? -1 - static_cast<std::int32_t>(place)
                                 : static_cast<std::int32_t>(place - number_of_nodes);
}

// Shows these faces with their corners, and the isolated vertices.
Display_surface show(const Shown_surface& shown, const Page_frame& frame, Shown_faces faces)
{
  const Surface& surface = shown.surface;
  Display_surface result;
  constexpr std::uint32_t left_out = (std::numeric_limits<std::uint32_t>::max)();
  result.new_numbers.assign(surface.number_of_vertices() + surface.number_of_removed_vertices(), left_out);
  for(const std::uint32_t corner : faces.corners)
    result.new_numbers[corner] = 0;
  for(const Surface::Vertex_index v : surface.vertices())
  {
    if(result.new_numbers[v.idx()] == left_out && !surface.is_isolated(v))
      continue;
    result.new_numbers[v.idx()] = static_cast<std::uint32_t>(result.values.size());
    for(int i = 0; i != 3; ++i)
      result.positions.push_back(static_cast<float>(surface.point(v)[i] - frame.origin[i]));
    result.values.push_back(shown.scalar_map[v]);
    result.vertex_arcs.push_back(page_place(shown.places[v.idx()], shown.number_of_nodes));
  }
  for(std::uint32_t& corner : faces.corners)
    corner = result.new_numbers[corner];
  result.triangles = std::move(faces.corners);
  result.face_patches = std::move(faces.patches);
  return result;
}

} // namespace

Page_frame::Page_frame(const Surface& surface)
{
  constexpr double largest_coordinate = 1e30;
  for(const Surface::Vertex_index v : surface.vertices())
    for(int i = 0; i != 3; ++i)
      if(!(std::abs(surface.point(v)[i]) <= largest_coordinate))
        throw std::runtime_error("a page shows no coordinates beyond 1e30");
  if(surface.number_of_vertices() == 0)
    return;
  const CGAL::Bbox_3 box = CGAL::Polygon_mesh_processing::bbox(surface);
  const double size = largest_extent(box);
  constexpr double far_away = 10; // sizes
  for(int i = 0; i != 3; ++i)
    if((std::max)(std::abs(box.min(i)), std::abs(box.max(i))) > far_away * size)
    {
      origin = {(box.xmin() + box.xmax()) / 2, (box.ymin() + box.ymax()) / 2, (box.zmin() + box.zmax()) / 2};
      break;
    }
  if(size > 0)
    digits = std::pow(10., 7 - std::floor(std::log10(size)));
}

std::array<double, 3> Page_frame::coordinates(const Point& point) const
{
  std::array<double, 3> result;
  for(int i = 0; i != 3; ++i)
  {
    const double rounded = std::round((point[i] - origin[i]) * digits) / digits;
    result[i] = std::isfinite(rounded) ? rounded : point[i] - origin[i];
  }
  return result;
}

Display_surface display_surface(const Shown_surface& shown, const Page_frame& frame)
{
  constexpr std::size_t largest_number_of_faces = 200000;
  if(shown.surface.number_of_faces() <= largest_number_of_faces)
    return show(shown, frame, all_faces(shown.surface, shown.patch_map));
  Display_surface result =
    show(shown, frame, decimate(shown.surface, largest_number_of_faces, shown.vertices_to_keep, shown.patch_map));
  result.is_decimated = true;
  result.new_numbers.clear();
  return result;
}

} // namespace reeb_graph_program
