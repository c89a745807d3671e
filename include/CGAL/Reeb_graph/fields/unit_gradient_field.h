// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of the CGAL-style package Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_FIELDS_UNIT_GRADIENT_FIELD_H
#define CGAL_REEB_GRAPH_FIELDS_UNIT_GRADIENT_FIELD_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/fields/Field_report.h>
#include <CGAL/Reeb_graph/fields/internal/Indexed_surface.h>
#include <CGAL/Reeb_graph/fields/internal/Weighted_graph.h>
#include <CGAL/Reeb_graph/fields/internal/constraints.h>
#include <CGAL/Reeb_graph/fields/internal/differential_operators.h>
#include <CGAL/Reeb_graph/fields/internal/poisson_values.h>

#include <CGAL/Named_function_parameters.h>

#include <vector>

namespace CGAL::Reeb_graph {

/// \ingroup PkgReebGraphFields
///
/// \brief computes a field whose level sets are about those of a given one, and whose gradient has about unit length.
///
/// The gradient of the given field is computed on each face and divided by its length, \f$ X = \nabla f / |\nabla f|
/// \f$. On a face where the field is constant, it has no direction, and \f$ X = 0 \f$. The result is the field
/// \f$ \hat f \f$ whose gradient is closest to \f$ X \f$ in the mean square, the solution of \f$ \Delta \hat f =
/// \mathrm{div} X \f$. See M. Hajij and P. Rosen, *An Efficient Data Retrieval Parallel Reeb Graph Algorithm*, 2020,
/// Section 6.3. In each component the lowest vertex of \f$ f \f$ gets the value 0.
///
/// The level sets are parallel to those of \f$ f \f$ only as far as \f$ X \f$ is a gradient. It is none near saddles,
/// and where level sets of \f$ f \f$ are not equally far apart everywhere. The gradient is shorter there. So \f$
/// \hat f \f$ measures arcs of the Reeb graph of \f$ f \f$, see `Augmentation::contour()`, and does not replace it.
/// Where \f$ f \f$ is flat to the last digits, the direction of its gradient is one of rounding errors. Time and memory
/// are those of `compute_harmonic_field()`.
///
/// \tparam FaceListGraph a model of `FaceListGraph`, with triangles as faces
/// \tparam ScalarMap a model of `ReadablePropertyMap` with the vertex descriptors of the mesh as key type, and a value
///         type that can be converted to `double`
/// \tparam FieldMap a model of `WritablePropertyMap` with the vertex descriptors of the mesh as key type, and a value
///         type that can be constructed from `double`
/// \tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"
///
/// \param mesh the triangulated surface, of any number of components; it is only read
/// \param scalar_map the field
/// \param field_map the result
/// \param np `sparse_linear_solver`, `solver_tolerance`, `callback` and `vertex_point_map` as for
///        `compute_harmonic_field()`
///
/// \returns what was changed because of bad faces, see `Field_report`
///
/// The exceptions are those of `compute_gradient()`, `Solver_tolerance_error`, `Linear_solver_error`, and
/// `Cancelled_error`. When one is thrown, `field_map` is as it was before.
template <class FaceListGraph,
          class ScalarMap,
          class FieldMap,
          class NamedParameters = parameters::Default_named_parameters>
Field_report compute_unit_gradient_field(const FaceListGraph& mesh,
                                         ScalarMap scalar_map,
                                         FieldMap field_map,
                                         const NamedParameters& np = parameters::default_values())
{
  namespace fields = internal::scalar_fields;
  std::vector<double> values;
  return fields::solve_poisson_equation(
    mesh, field_map, np,
    [&](const auto& surface, const auto& graph, auto& fixed) {
      values = fields::read_field(surface, scalar_map);
      for(const fields::Position v : fields::lowest_vertices_of_components(graph, values))
        fixed.fix(v, 0);
    },
    [&](const auto& surface, const auto&) {
      auto vectors = fields::scaled_gradients(surface, values);
      for(fields::Vector& vector : vectors)
        vector = fields::normalized(vector);
      auto divergences = fields::scaled_divergences(surface, vectors);
      for(double& divergence : divergences)
        divergence *= surface.scale();
      return divergences;
    });
}

} // namespace CGAL::Reeb_graph

#endif // CGAL_REEB_GRAPH_FIELDS_UNIT_GRADIENT_FIELD_H
