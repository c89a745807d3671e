// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_SRC_LOCAL_INPUT_H
#define CGAL_REEB_GRAPH_SRC_LOCAL_INPUT_H

#include "base/options.h"
#include "base/surface.h"
#include "mpi/ranks.h"

#include <array>
#include <cstdint>
#include <functional>
#include <limits>
#include <variant>
#include <vector>

namespace reeb_graph_program {
// Triangles by the numbers of their vertices, which take half the memory if all of them fit in 32 bits.
typedef std::variant<std::vector<std::array<std::uint32_t, 3>>, std::vector<std::array<std::uint64_t, 3>>>
  Local_triangles;

inline Local_triangles make_triangles(std::uint64_t number_of_vertices)
{
  if(number_of_vertices <= std::numeric_limits<std::uint32_t>::max())
    return std::vector<std::array<std::uint32_t, 3>>();
  return std::vector<std::array<std::uint64_t, 3>>();
}

// What a rank has of a mesh with a field.
struct Local_mesh
{
  std::uint64_t number_of_vertices = 0, number_of_triangles = 0; // of all ranks
  std::uint64_t first_vertex = 0;                                // of this rank
  std::vector<double> scalars;                                   // of its vertices
  Local_triangles triangles;                                     // of this rank
  std::function<Point(std::uint64_t)> point;                     // of any vertex; empty if there are none
};

// What the field is at a vertex, of its point.
typedef std::function<double(const Point&)> Field_of_point;

// The field as a function of the points, if it is a coordinate or height. Throws Parameter_error.
Field_of_point field_of_point(const Input_options& options);

// Each rank reads its own part of the mesh and of the field: of a binary PLY file, or of a raw file. All of them throw
// the same exception if there is something wrong with the file or with the options. Collective.
Local_mesh read_local_mesh(const Communicator& communicator, const Input_options& options);

} // namespace reeb_graph_program

#endif // CGAL_REEB_GRAPH_SRC_LOCAL_INPUT_H
