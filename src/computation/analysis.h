// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_SRC_ANALYSIS_H
#define CGAL_REEB_GRAPH_SRC_ANALYSIS_H

#include "base/report.h"
#include "base/surface.h"

#include <string>

namespace reeb_graph_program {
// Adds the counts of the graph behind those of the surface.
void count_graph_of_surface(const Graph& graph, Report& report);

// Counts what the report tells of the mesh and of the graph.
void count_all(const Mesh& mesh, const Graph& graph, Report& report);
void count_all(const Surface& surface, const Graph& graph, Report& report);

// Adds what the report tells of the simplified graph, behind count_all().
void count_simplified(const Graph& simplified, double threshold, Report& report);

// Counts the cells of the complex, none of whose edges is one of a triangle, and the places where it is no surface.
Complex_counts count_complex(const Complex& complex);

// Why the complex is no oriented manifold surface, and what helps.
std::string describe_obstacle(const Complex& complex);

// Takes out of the complex what is a face of its other cells, and what is there before.
void remove_faces_of_cells(Complex& complex);

} // namespace reeb_graph_program

#endif // CGAL_REEB_GRAPH_SRC_ANALYSIS_H
