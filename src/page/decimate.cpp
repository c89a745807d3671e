// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#include "page/decimate.h"

#include "base/progress_bar.h"

#include <CGAL/Bbox_3.h>
#include <CGAL/Polygon_mesh_processing/bbox.h>

#include <meshoptimizer.h>

#include <algorithm>
#include <limits>
#include <map>

namespace reeb_graph_program {
namespace {
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

} // namespace

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

} // namespace reeb_graph_program
