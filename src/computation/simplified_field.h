// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_SRC_SIMPLIFIED_FIELD_H
#define CGAL_REEB_GRAPH_SRC_SIMPLIFIED_FIELD_H

#include "base/options.h"
#include "base/surface.h"
#include "computation/Mesh_graph.h"

namespace reeb_graph_program {
struct Simplified_field
{
  double largest_change;    // of a value
  bool are_ties_contracted; // though not asked for, as there is no such field otherwise
};

// Computes a field that has the simplified graph with the ties of these options or, if that fails, with contracted ones.
// The graph is that of the field with these options. `simplified_map` can be `scalar_map`. Throws the exceptions of the
// library.
Simplified_field compute_simplified_field(const Mesh& mesh,
                                          Scalar_map scalar_map,
                                          Mesh_graph& graph,
                                          const Graph_options& graph_options,
                                          const Simplification_options& simplification,
                                          Scalar_map simplified_map);

} // namespace reeb_graph_program

#endif // CGAL_REEB_GRAPH_SRC_SIMPLIFIED_FIELD_H
