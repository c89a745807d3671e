// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_SRC_MESH_FORMATS_H
#define CGAL_REEB_GRAPH_SRC_MESH_FORMATS_H

#include "base/surface.h"
#include "input/Polygon_soup.h"
#include "input/input_error.h"
#include "input/repair_soup.h"

#include <algorithm>
#include <cstddef>
#include <string>
#include <vector>

namespace reeb_graph_program {
// What a file has for its vertices and for its cells, in its order, for the message that a field is none of it.
struct Field_names
{
  std::vector<std::string> of_vertices, of_cells;
  std::vector<std::string> others_of_vertices; // those of them that are not one number for each vertex

  void add(bool is_of_cells, const std::string& name, std::size_t numbers_per_item)
  {
    std::string shown = quote(name);
    shown = shown.substr(1, shown.size() - 2); // no control characters
    if(numbers_per_item != 1)
      shown += " (" + std::to_string(numbers_per_item) + " numbers)";
    (is_of_cells ? of_cells : of_vertices).push_back(shown);
    if(!is_of_cells && numbers_per_item != 1)
      others_of_vertices.push_back(shown);
  }

  // `cells` is what they are called.
  std::string message(const std::string& field, const std::string& cells) const
  {
    const bool is_of_cells = std::find(of_cells.begin(), of_cells.end(), field) != of_cells.end();
    return (is_of_cells ? "the field " + quote(field) + " is one of the " + cells : "there is no field " + quote(field))
         + ": the vertices have " + list(of_vertices)
         + (of_cells.empty() ? "" : "; the " + cells + " have " + list(of_cells));
  }

private:
  static std::string list(const std::vector<std::string>& names)
  {
    std::string result;
    for(const std::string& name : names)
      result += (result.empty() ? "" : ", ") + name;
    return result.empty() ? "none" : result;
  }
};

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

// The numbers that a PLY or VTK file has for each vertex besides its point, as properties of the surface that has been
// read from it; none of other files. The field, which is named scalar, is none of them.
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

// What is said of a file whose extension is that of no format that is read: what it is, and what converts it, where that
// is known.
std::string refused_format(const std::string& path);

// The same of a VTK file by the type of data that is in it, such as ImageData.
std::string refused_vtk_type(const std::string& type);

// Reads an OFF, OBJ, PLY, STL, TS, MESH, VTK, VTU, or VTP file. Vertex i of the surface is vertex i of the file, isolated
// ones included. Faces with a repeated corner, and those that repeat an earlier one in the same orientation, are left out.
// Faces are oriented consistently if need be; what is no oriented manifold surface then becomes a complex. The property of the vertices that is asked for, if any, becomes the property map v:scalar. Throws
// Input_error.
// If a repair is given, a mesh of faces that is no surface is made one by it, and one that is a surface only loses
// components. The vertices keep their numbers, and what is added comes behind them, with a property map of origins.
// If it is asked for, tetrahedra are read as their border.
Mesh read_mesh(const std::string& path,
               bool are_faces_triangulated,
               const std::string& vertex_property,
               const Repair_options* repair = nullptr,
               bool is_border_taken = false);

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

#endif // CGAL_REEB_GRAPH_SRC_MESH_FORMATS_H
