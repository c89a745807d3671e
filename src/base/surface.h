// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_SRC_SURFACE_H
#define CGAL_REEB_GRAPH_SRC_SURFACE_H

#include <CGAL/Reeb_graph_traits.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <cstdint>
#include <variant>
#include <vector>

namespace reeb_graph_program {
typedef CGAL::Simple_cartesian<double>::Point_3 Point;
typedef std::vector<Point> Polyline; // if it is closed, its first point is its last one as well
typedef CGAL::Surface_mesh<Point> Surface;
typedef Surface::Property_map<Surface::Vertex_index, double> Scalar_map;
typedef Surface::Property_map<Surface::Face_index, int> Patch_map;
typedef CGAL::Reeb_graph_traits<Surface, Scalar_map>::Graph Graph;

// A property of the vertices that a file has besides their points.
template <class Number>
using Vertex_property = Surface::Property_map<Surface::Vertex_index, Number>;
typedef std::variant<Vertex_property<std::int8_t>,
                     Vertex_property<std::uint8_t>,
                     Vertex_property<std::int16_t>,
                     Vertex_property<std::uint16_t>,
                     Vertex_property<std::int32_t>,
                     Vertex_property<std::uint32_t>,
                     Vertex_property<float>,
                     Vertex_property<double>>
  Any_vertex_property;

} // namespace reeb_graph_program

#endif // CGAL_REEB_GRAPH_SRC_SURFACE_H
