// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_SRC_LONGEST_LOOP_H
#define CGAL_REEB_GRAPH_SRC_LONGEST_LOOP_H

#include "computation/Mesh_graph.h"
#include "computation/handles.h"

namespace reeb_graph_program {
// The most persistent loop of the graph, of several the one with the lowest upper node, as a shortest closed curve along
// edges between the levels of its two nodes, and through both. Throws std::runtime_error if the graph has no loop.
Loops_of_surface find_longest_loop(Mesh_graph& graph);

} // namespace reeb_graph_program

#endif // CGAL_REEB_GRAPH_SRC_LONGEST_LOOP_H
