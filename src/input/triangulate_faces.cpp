// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of the CGAL-style package Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#include "input/triangulate_faces.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/triangulate_faces.h>
#include <CGAL/property_map.h>

namespace reeb_graph_program {
// Only this asks predicates of the points, so only this file is compiled with a kernel of exact ones.
void triangulate_faces(Surface& surface)
{
  typedef CGAL::Exact_predicates_inexact_constructions_kernel Kernel;
  const auto points = CGAL::make_cartesian_converter_property_map<Kernel::Point_3>(surface.points());
  CGAL::Polygon_mesh_processing::triangulate_faces(surface,
                                                   CGAL::parameters::vertex_point_map(points).geom_traits(Kernel()));
}

} // namespace reeb_graph_program
