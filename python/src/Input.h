// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of the CGAL-style package Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_PYTHON_INPUT_H
#define CGAL_REEB_GRAPH_PYTHON_INPUT_H

#include "base/complex.h"
#include "base/options.h"
#include "base/surface.h"
#include "input/Polygon_soup.h"

#include <optional>
#include <string>
#include <vector>

namespace reeb_graph_python {
using namespace reeb_graph_program; // NOLINT(google-build-using-namespace): it is the program with another door

// A mesh with its field. It does not change any more once it is made.
struct Input
{
  Mesh mesh;
  Scalar_map scalar_map;      // the field whose order counts: the values or, if those are no doubles, their ranks
  Scalar_map value_map;       // the values as doubles: the same map, but for ranks
  std::vector<double> levels; // the value of each rank; empty if the field is no ranks
  double base = 0;            // is to be added to values and levels: their differences are exact without it
  bool has_points = false;

  bool is_ranked() const { return !levels.empty(); }
  const Surface& surface() const { return mesh.surface; }
  std::size_t number_of_vertices() const { return mesh.surface.number_of_vertices(); }
};

// Adds a property map that holds the values.
Scalar_map add_scalar_map(Surface& surface, const std::string& name, const std::vector<double>& values);

// Makes the mesh of a soup that has been checked, and gives it the field. `values` are empty unless the field is ranks.
void make_input(Input& input, const Polygon_soup& soup, const std::vector<double>& scalars, std::vector<double> values);

// Throws std::invalid_argument if the mesh is no oriented manifold surface, and `what` needs one.
void check_is_surface(const Mesh& mesh, const std::string& what);

// The faces of the surface, or the triangles of the complex.
std::vector<std::array<std::uint32_t, 3>> triangles_of(const Mesh& mesh);

} // namespace reeb_graph_python

#endif // CGAL_REEB_GRAPH_PYTHON_INPUT_H
