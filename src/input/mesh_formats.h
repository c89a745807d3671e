// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_SRC_MESH_FORMATS_H
#define CGAL_REEB_GRAPH_SRC_MESH_FORMATS_H

#include "input/Polygon_soup.h"
#include "input/field_names.h"

#include <string>
#include <vector>

namespace reeb_graph_program {
// Readers of our own: those of CGAL differ from version to version, and some files that are damaged end the program in
// them. Each throws Input_error, with the line where the file has lines, unless all of the file is a mesh of its
// format. Numbers of vertices may be out of range, and coordinates no finite numbers.

// OFF with or without vertex colours (COFF), normals (NOFF), textures (STOFF), and homogeneous coordinates (4OFF).
Polygon_soup read_off(const std::string& path);
// OBJ: vertices, and faces whose vertices are counted from the first one or from the last one before the face.
Polygon_soup read_obj(const std::string& path);
// PLY, ASCII or binary of any byte order. `vertex_property` is the name of a property of the vertices that becomes
// Polygon_soup::scalars, or empty.
Polygon_soup read_ply(const std::string& path, const std::string& vertex_property);
// The numbers that a PLY file has for each vertex besides its point, as properties of the surface that has been read
// from it. The field, which is named scalar, is none of them.
std::vector<Any_vertex_property> read_ply_vertex_properties(const std::string& path, Surface& surface);

// The same of a PLY or VTK file, none for others.
std::vector<Any_vertex_property> read_vertex_properties(const std::string& path, Surface& surface);

// The names of what a PLY or VTK file has for its vertices and faces that is not kept in another file: fields of vertices
// if there is no room for them, and what is not one number for each vertex.
std::vector<std::string> fields_not_kept(const std::string& path, bool has_room);

// The same of what OBJ and OFF files have: normals, textures, materials, colors.
std::vector<std::string> parts_not_kept(const std::string& path);
// STL, ASCII or binary. Corners at the same point are one vertex.
Polygon_soup read_stl(const std::string& path);
// TS of GOCAD: the triangles of its surfaces.
Polygon_soup read_ts(const std::string& path);

// MESH of Medit, ASCII, as CGAL::IO::write_MEDIT() writes it: vertices, edges, triangles, quadrilaterals, and
// tetrahedra.
Polygon_soup read_medit(const std::string& path);
// VTK's legacy format, ASCII or binary, or its XML format, with numbers as text, in base64 code, or appended, that may be
// compressed by zlib: unstructured grids of cells of the types 1 to 10, and polygonal data. `vertex_property` is the name
// of numbers of the points that become Polygon_soup::scalars, or empty.
Polygon_soup read_vtk(const std::string& path, const std::string& vertex_property);
// All arrays of one number for each point, and the names of all.
std::vector<Vertex_field> read_vtk_fields(const std::string& path, Field_names& names);

} // namespace reeb_graph_program

#endif // CGAL_REEB_GRAPH_SRC_MESH_FORMATS_H
