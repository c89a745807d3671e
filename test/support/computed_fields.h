// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_TEST_COMPUTED_FIELDS_H
#define CGAL_REEB_GRAPH_TEST_COMPUTED_FIELDS_H

#include "field_checks.h"
#include "mesh_builders.h"

#include <CGAL/Reeb_graph/fields/harmonic_field.h>

#include <array>
#include <cstddef>
#include <iterator>
#include <utility>
#include <vector>

// Harmonic fields of the meshes that field_checks.h sees as index triples.
namespace computed_fields {
using namespace field_checks;
using CGAL::parameters::laplacian_weights;
using CGAL::Reeb_graph::Laplacian_weights;
using mesh_builders::Surface_mesh;

inline const std::array<Laplacian_weights, 3> all_weights = {Laplacian_weights::MEAN_VALUE,
                                                             Laplacian_weights::COTANGENT, Laplacian_weights::UNIFORM};

template <class Scalar, class Mesh = Surface_mesh>
std::vector<Scalar> harmonic(const Triangle_soup& soup,
                             const Fixed_values& fixed,
                             Laplacian_weights weights = Laplacian_weights::MEAN_VALUE)
{
  Mesh mesh;
  mesh_builders::build(mesh, soup);
  auto field_map = get(CGAL::dynamic_vertex_property_t<Scalar>(), mesh);
  CGAL::Reeb_graph::compute_harmonic_field(mesh, field_map, constraints_of(mesh, fixed), laplacian_weights(weights));
  return values_of(mesh, field_map);
}

// Two vertices of each component.
inline std::vector<std::pair<std::size_t, std::size_t>> far_apart_vertices(const Triangle_soup& soup)
{
  Surface_mesh mesh;
  mesh_builders::build(mesh, soup);
  std::vector<std::pair<std::size_t, std::size_t>> pairs;
  CGAL::Reeb_graph::find_far_apart_vertices(mesh, std::back_inserter(pairs));
  return pairs;
}

} // namespace computed_fields

#endif // CGAL_REEB_GRAPH_TEST_COMPUTED_FIELDS_H
