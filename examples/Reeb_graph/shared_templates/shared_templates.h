// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of the CGAL-style package Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_EXAMPLES_SHARED_TEMPLATES_H
#define CGAL_REEB_GRAPH_EXAMPLES_SHARED_TEMPLATES_H

// For those who build the project, not for those who read the examples: what nearly all of these begin with, to be
// precompiled, and the templates that most of them instantiate with the same arguments. They are declared to be
// instantiated elsewhere, shared_templates.cpp, so that it is done once. The compiled library has the stages.
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>
#include <CGAL/compute_reeb_graph.h>

#include <string>

namespace shared_templates {
typedef CGAL::Simple_cartesian<double>::Point_3 Point;
typedef CGAL::Surface_mesh<Point> Mesh;
typedef Mesh::Property_map<Mesh::Vertex_index, double> Scalar_map;
typedef CGAL::Reeb_graph_traits<Mesh, Scalar_map>::Graph Graph;
typedef CGAL::parameters::Default_named_parameters Default_parameters;
} // namespace shared_templates

#define CGAL_REEB_GRAPH_SHARED_TEMPLATES(EXTERN)                                                                       \
  namespace CGAL {                                                                                                     \
  EXTERN template bool IO::read_polygon_mesh(const std::string&,                                                       \
                                             shared_templates::Mesh&,                                                  \
                                             const shared_templates::Default_parameters&);                             \
  EXTERN template void compute_reeb_graph<Sequential_tag>(const shared_templates::Mesh&,                               \
                                                          shared_templates::Scalar_map,                                \
                                                          shared_templates::Graph&,                                    \
                                                          const shared_templates::Default_parameters&);                \
  }

CGAL_REEB_GRAPH_SHARED_TEMPLATES(extern)

#endif // CGAL_REEB_GRAPH_EXAMPLES_SHARED_TEMPLATES_H
