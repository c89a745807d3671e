// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of the CGAL-style package Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_SRC_SIMPLIFIED_FIELD_H
#define CGAL_REEB_GRAPH_SRC_SIMPLIFIED_FIELD_H

#include "base/options.h"
#include "base/surface.h"

namespace reeb_graph_program {
struct Simplified_field
{
  double largest_change;    // of a value
  bool are_ties_contracted; // though not asked for, as there is no such field otherwise
};

// Computes a field that has the simplified graph with these ties or, if that fails, with contracted ones. The threshold
// is that of threshold_in_units(). `simplified_map` can be `scalar_map`. Throws the exceptions of the library.
Simplified_field compute_simplified_field(const Surface& surface,
                                          Scalar_map scalar_map,
                                          const Simplification_options& options,
                                          double threshold,
                                          CGAL::Reeb_graph::Ties ties,
                                          Scalar_map simplified_map);

} // namespace reeb_graph_program

#endif // CGAL_REEB_GRAPH_SRC_SIMPLIFIED_FIELD_H
