// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_SRC_LOCAL_FILES_H
#define CGAL_REEB_GRAPH_SRC_LOCAL_FILES_H

#include "mpi/Local_mesh.h"
#include "mpi/ranks.h"

#include <functional>
#include <string>
#include <vector>

namespace reeb_graph_program {
// What the field is at a vertex, of its point.
typedef std::function<double(const Point&)> Field_of_point;

// Where the field of a PLY file is: a function of the points or, if there is none, a property of the vertices.
struct Ply_field
{
  Field_of_point of_point;
  std::string property;
};

// Each rank reads its own part of a binary PLY file, whose faces are triangles. All of them throw the same exception if
// there is something wrong with the file, where the sequential program throws Input_error as well, or if its records
// differ in length. Collective.
Local_mesh read_local_ply(const Communicator& communicator, const std::string& path, const Ply_field& field);

// The same of a raw file, which has a value for each vertex and no points. All numbers are little-endian: eight
// characters, "ReebRaw1"; the number of vertices and that of triangles, 64-bit integers; the values of the vertices,
// double numbers; and three vertices for each triangle, 64-bit integers from 0.
Local_mesh read_local_raw(const Communicator& communicator, const std::string& path);

} // namespace reeb_graph_program

#endif // CGAL_REEB_GRAPH_SRC_LOCAL_FILES_H
