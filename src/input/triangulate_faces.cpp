// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#include "input/triangulate_faces.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/triangulate_faces.h>
#include <CGAL/property_map.h>

#include <algorithm>
#include <cmath>

namespace reeb_graph_program {
namespace {
// Only this asks predicates of the points, so only this file is compiled with a kernel of exact ones.
typedef CGAL::Exact_predicates_inexact_constructions_kernel Kernel;

// The points times a power of two, without which normals of points that are extremely far from the origin, or close to
// it, would be infinite, or vanish. Then, the exact kernel ends the program.
struct Scaled_points
{
  typedef Surface::Vertex_index key_type;
  typedef Kernel::Point_3 value_type;
  typedef value_type reference;
  typedef boost::readable_property_map_tag category;

  friend reference get(const Scaled_points& map, key_type v)
  {
    const Point& p = map.surface->point(v);
    return {map.factor * p.x(), map.factor * p.y(), map.factor * p.z()};
  }

  const Surface* surface = nullptr;
  double factor = 1;
};

double factor_of(const Surface& surface)
{
  double largest = 0;
  for(const Point& p : surface.points())
    largest = std::max({largest, std::abs(p.x()), std::abs(p.y()), std::abs(p.z())});
  return largest == 0 || (largest > 1e-60 && largest < 1e60) ? 1 : std::ldexp(1, std::min(-std::ilogb(largest), 1000));
}

} // namespace

void triangulate_faces(Surface& surface)
{
  CGAL::Polygon_mesh_processing::triangulate_faces(
    surface, CGAL::parameters::vertex_point_map(Scaled_points{&surface, factor_of(surface)}).geom_traits(Kernel()));
}

} // namespace reeb_graph_program
