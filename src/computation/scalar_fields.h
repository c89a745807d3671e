// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_SRC_SCALAR_FIELDS_H
#define CGAL_REEB_GRAPH_SRC_SCALAR_FIELDS_H

#include "base/options.h"
#include "base/report.h"
#include "base/surface.h"

#include <cstddef>
#include <string>
#include <vector>

namespace reeb_graph_program {
// Whether the field is one of those that compute_scalar_field() computes.
bool is_computed(const std::string& field);

// Throws std::runtime_error if an option does not go with the field.
void check_field_options(const Input_options& options);

// Computes the field options.field: harmonic, harmonic-between-borders, poisson, unit-gradient, geodesic, or height. For
// unit-gradient, `scalar_map` holds the field to start from if there is a file of it. Reports how it went if the field
// depends on the geometry of the faces, which values it was given, and which components no source is in. Throws std::runtime_error, and the exceptions of
// the library.
void compute_scalar_field(const Input_options& options,
                          const Surface& surface,
                          Scalar_map scalar_map,
                          Work_report& report);

// Computes the value at each vertex of a field with about the level sets of another one, and a gradient of length 1.
// Reports how it went. Throws the exceptions of the library.
std::vector<double> compute_unit_gradient(const Surface& surface, Scalar_map scalar_map, Work_report& report);

// Sets the map to the lengths of the shortest paths along edges of the complex from the sources or, if there are none,
// from a vertex of each component that is farthest away from its first vertex. Returns the sources. Throws
// std::runtime_error if there is no such source, or no path from a source to a vertex, unless such vertices may be left.
std::vector<std::size_t> compute_distances_along_edges(const Mesh& mesh,
                                                       const Input_options& options,
                                                       Scalar_map scalar_map,
                                                       Work_report& report);

} // namespace reeb_graph_program

#endif // CGAL_REEB_GRAPH_SRC_SCALAR_FIELDS_H
