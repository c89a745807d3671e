// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_SRC_GENERATED_INPUT_H
#define CGAL_REEB_GRAPH_SRC_GENERATED_INPUT_H

#include "base/options.h"
#include "mpi/Formula_surface.h"
#include "mpi/Local_mesh.h"
#include "mpi/ranks.h"

#include <cstdint>
#include <functional>
#include <string>

namespace reeb_graph_program {
// A surface that the ranks make themselves.
struct Generation_options
{
  std::string surface; // genus-0, genus-1, ...; empty if there is none
  std::uint64_t number_of_triangles = 1000000;
};

// Throws std::runtime_error if there is no such surface.
Formula_surface make_surface(const Generation_options& options);

// The values of a field of a generated surface: x, y, z, height, smooth, or noise, which depends on the number of the
// vertex alone. Throws std::runtime_error for another one.
std::function<double(std::uint64_t, const Point&)> generated_field(const Input_options& options);

// Each rank makes its own part. All of them throw the same exception. Collective.
Local_mesh make_local_mesh(const Communicator& communicator,
                           const Generation_options& generation,
                           const Input_options& options);

} // namespace reeb_graph_program

#endif // CGAL_REEB_GRAPH_SRC_GENERATED_INPUT_H
