// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#include "computation/curves.h"

#include "base/progress_bar.h"
#include <CGAL/Reeb_graph/IO/polylines.h>

#include <CGAL/Reeb_graph/curves/Refinement_visitor.h>
#include <CGAL/Reeb_graph/curves/branch_curves.h>
#include <CGAL/Reeb_graph/curves/cutting_system.h>
#include <CGAL/Reeb_graph/curves/pants_decomposition.h>

#include <algorithm>
#include <functional>
#include <iterator>
#include <variant>

namespace reeb_graph_program {
namespace {
typedef CGAL::Reeb_graph::Curve<Surface::Halfedge_index> Curve;

std::vector<Curve> find_curves(Surface& surface,
                               Scalar_map scalar_map,
                               const std::vector<Any_vertex_property>& properties,
                               const Cut_options& options,
                               const std::function<bool(std::size_t)>& face_count_callback,
                               Patch_map patch_map)
{
  namespace parameters = CGAL::parameters;
  std::vector<Curve> curves;
  CGAL::Reeb_graph::Interpolating_visitor<Surface> visitor;
  for(const Any_vertex_property& property : properties)
    std::visit([&](const auto& map) { visitor.add_vertex_map(map); }, property);
  Progress_bar progress_bar("cut");
  const auto tell = [&](std::size_t number_of_faces) {
    progress_bar.clear();
    return face_count_callback(number_of_faces);
  };
  const auto own = parameters::face_count_callback(tell).cut_open(options.is_cut_open);
  const auto with_maps = [&](const auto& np) {
    return np.face_patch_map(patch_map).visitor(visitor).callback(std::ref(progress_bar));
  };
  switch(options.type)
  {
  case Curves_type::CUTTING_SYSTEM:
    CGAL::Reeb_graph::cutting_system(surface, scalar_map, std::back_inserter(curves), with_maps(own));
    break;
  case Curves_type::PANTS:
    CGAL::Reeb_graph::pants_decomposition(surface, scalar_map, std::back_inserter(curves), with_maps(own));
    break;
  case Curves_type::BRANCH:
    CGAL::Reeb_graph::branch_curves(
      surface, scalar_map, std::back_inserter(curves),
      with_maps(own.persistence_threshold(options.persistence.value_or(0))).area_threshold(options.area.value_or(0)));
    break;
  default: break; // They are no curves of the graph.
  }
  return curves;
}

} // namespace

Cut_result cut_along_curves(Surface& surface,
                            Scalar_map scalar_map,
                            const std::vector<Any_vertex_property>& properties,
                            const Cut_options& options,
                            const std::function<bool(std::size_t)>& face_count_callback)
{
  Cut_result result;
  if(options.borders.value_or(CGAL::Reeb_graph::Borders::MAKE_LEVEL) == CGAL::Reeb_graph::Borders::MAKE_LEVEL)
  {
    Progress_bar progress_bar("borders");
    result.border_changes =
      CGAL::Reeb_graph::make_borders_level(surface, scalar_map, CGAL::parameters::callback(std::ref(progress_bar)));
  }
  result.patch_map = surface.add_property_map<Surface::Face_index, int>("f:patch", 0).first;
  for(const Curve& curve : find_curves(surface, scalar_map, properties, options, face_count_callback, result.patch_map))
    result.polylines.push_back(CGAL::Reeb_graph::polyline_of_curve(surface, curve));
  for(const Surface::Face_index f : surface.faces())
    result.number_of_patches = (std::max)(result.number_of_patches, std::size_t(result.patch_map[f]) + 1);
  return result;
}

} // namespace reeb_graph_program
