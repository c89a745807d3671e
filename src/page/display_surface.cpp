// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#include "page/display_surface.h"

#include "page/decimate.h"

#include <CGAL/Bbox_3.h>
#include <CGAL/Polygon_mesh_processing/bbox.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <utility>

namespace reeb_graph_program {
namespace {
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
