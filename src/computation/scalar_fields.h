// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of the CGAL-style package Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_SRC_SCALAR_FIELDS_H
#define CGAL_REEB_GRAPH_SRC_SCALAR_FIELDS_H

#include "base/options.h"
#include "base/surface.h"

namespace reeb_graph_program {
// Throws std::runtime_error if an option does not go with the field.
void check_field_options(const Input_options& options);

// Computes the field options.field: harmonic, poisson, unit-gradient, geodesic, or height. For unit-gradient,
// `scalar_map` holds the field to start from if there is a file of it. Throws std::runtime_error, and the exceptions of
// the library.
void compute_scalar_field(const Input_options& options, const Surface& surface, Scalar_map scalar_map);

} // namespace reeb_graph_program

#endif // CGAL_REEB_GRAPH_SRC_SCALAR_FIELDS_H
