// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_SRC_MESH_INPUT_H
#define CGAL_REEB_GRAPH_SRC_MESH_INPUT_H

#include "base/complex.h"
#include "base/surface.h"
#include "input/Polygon_soup.h"
#include "input/repair_soup.h"

#include <string>

namespace reeb_graph_program {
// Reads an OFF, OBJ, PLY, STL, TS, MESH, VTK, VTU, or VTP file. Vertex i of the surface is vertex i of the file, isolated
// ones included. Faces with a repeated corner, and those that repeat an earlier one in the same orientation, are left out.
// Faces are oriented consistently if need be; what is no oriented manifold surface then becomes a complex. The property of the vertices that is asked for, if any, becomes the property map v:scalar. Throws
// Input_error.
// If a repair is given, a mesh of faces that is no surface is made one by it, and one that is a surface only loses
// components. The vertices keep their numbers, and what is added comes behind them, with a property map of origins.
Mesh read_mesh(const std::string& path,
               bool are_faces_triangulated,
               const std::string& vertex_property,
               const Repair_options* repair = nullptr);

// Whether the mesh of a soup is no surface, but one of faces that the repair can make one; or loses components by it.
bool is_to_be_repaired(const Polygon_soup& soup, const Mesh& mesh, const Repair_options& repair);

// Makes the mesh the surface of the repaired soup, in this way; only leaves out components if it is one.
void repair_mesh(Polygon_soup soup, Repair_options repair, Mesh& mesh);

// What is in the file, in its order, but for faces with a repeated corner or fewer than three; all numbers of vertices are those of points.
Polygon_soup read_checked_soup(const std::string& path,
                               bool are_faces_triangulated,
                               const std::string& vertex_property,
                               Input_findings& findings);

// Counts points of such a soup that are isolated, and those of its borders that are close to others.
void look_over_points(const Polygon_soup& soup, const std::vector<Corner>& border_points, Input_findings& findings);

// Cuts the faces of such a soup that are not triangles into triangles. Throws Input_error.
void triangulate_faces(Polygon_soup& soup, const std::string& path, const Input_findings& findings);

// The same of a soup of triangles that has been checked: a surface, or what is none. `faces` are those that the triangles
// were cut of, if they were: what repeats is one of them.
Mesh make_mesh(const Polygon_soup& soup, const Polygons* faces = nullptr);

bool is_ply_file(const std::string& path);

} // namespace reeb_graph_program

#endif // CGAL_REEB_GRAPH_SRC_MESH_INPUT_H
