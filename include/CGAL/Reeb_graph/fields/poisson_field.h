// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of the CGAL-style package Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_FIELDS_POISSON_FIELD_H
#define CGAL_REEB_GRAPH_FIELDS_POISSON_FIELD_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/fields/Field_report.h>
#include <CGAL/Reeb_graph/fields/exceptions.h>
#include <CGAL/Reeb_graph/fields/internal/Indexed_surface.h>
#include <CGAL/Reeb_graph/fields/internal/Weighted_graph.h>
#include <CGAL/Reeb_graph/fields/internal/constraints.h>
#include <CGAL/Reeb_graph/fields/internal/differential_operators.h>
#include <CGAL/Reeb_graph/fields/internal/poisson_values.h>
#include <CGAL/Reeb_graph/fields/internal/triangle_geometry.h>
#include <CGAL/Reeb_graph/internal/base/Progress.h>
#include <CGAL/Reeb_graph/internal/base/requirements.h>

#include <CGAL/Named_function_parameters.h>

#include <cstddef>

namespace CGAL::Reeb_graph {

/// \ingroup PkgReebGraphFields
///
/// \brief computes the mean curvature at each vertex.
///
/// It is \f$ \frac{1}{4 A(v_i)} | \sum_j (\cot \alpha_{ij} + \cot \beta_{ij}) (v_i - v_j) | \f$ with the sum over the
/// neighbors, the two angles that face the edge, and the mixed Voronoi area \f$ A(v_i) \f$ of \cgal's package %Weights.
/// See M. Hajij and P. Rosen, *An Efficient Data Retrieval Parallel Reeb Graph Algorithm*, 2020, Section 8.1, and M.
/// Meyer, M. Desbrun, P. Schr&ouml;der, A. Barr, *Discrete Differential-Geometry Operators for Triangulated
/// 2-Manifolds*, 2003. It is never negative. On the border the formula means little; at isolated vertices it is zero.
/// It takes linear time.
///
/// \tparam FaceListGraph a model of `FaceListGraph`, with triangles as faces
/// \tparam FieldMap a model of `WritablePropertyMap` with the vertex descriptors of the mesh as key type, and a value
///         type that can be constructed from `double`
/// \tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters": `callback` and `vertex_point_map`
///         as for `compute_harmonic_field()`
///
/// \returns what was changed because of bad faces, see `Field_report`
///
/// \exception Non_finite_scalar_error if the result is infinite or NaN
/// \exception Cancelled_error if `callback` returns `false`
///
/// and those for meshes that are not triangulated surfaces, see `compute_harmonic_field()`. When one of these is
/// thrown, `field_map` is as it was before.
template <class FaceListGraph, class FieldMap, class NamedParameters = parameters::Default_named_parameters>
Field_report compute_mean_curvature(const FaceListGraph& mesh,
                                    FieldMap field_map,
                                    const NamedParameters& np = parameters::default_values())
{
  namespace fields = internal::scalar_fields;
  if constexpr(internal::Mesh_with_vertex_map<FaceListGraph, FieldMap>::value)
  {
    const internal::Progress progress(np);
    progress.report(0);
    fields::Indexed_mesh<FaceListGraph> surface(mesh, np);
    Field_report report = fields::make_triangles_proper(surface);
    const auto curvatures_of = [&](const fields::Weighted_graph& graph, double) {
      auto values = fields::scaled_integrated_mean_curvatures(surface, graph);
      const auto areas = fields::scaled_mixed_areas(surface);
      for(std::size_t v = 0; v != areas.size(); ++v)
        values[v] /= (areas[v] > 0 ? areas[v] : 1) * surface.scale();
      fields::check_finite(values);
      return values;
    };
    const fields::Weighted_graph cotangents = fields::cotangent_graph(surface);
    progress.report(0.5);
    const auto curvatures = fields::solve_or_lengthen_edges(surface, report, cotangents, curvatures_of,
                                                            [&] { return fields::cotangent_graph(surface); });
    progress.report(0.9);
    fields::write_field(surface, curvatures, field_map, progress);
    return report;
  }
  else
    return Field_report();
}

/// \ingroup PkgReebGraphFields
///
/// \brief solves the Poisson equation \f$ \Delta f = h \f$ with given values at some vertices.
///
/// The Laplacian is the one with cotangent weights, divided by the mixed Voronoi area: \f$ \frac{1}{2 A(v_i)} \sum_j
/// (\cot \alpha_{ij} + \cot \beta_{ij}) (f_j - f_i) = h(v_i) \f$ at each vertex whose value is not given. On a border
/// where no values are given, the derivative across it is zero. See M. Hajij and P. Rosen, *An Efficient Data Retrieval
/// Parallel Reeb Graph Algorithm*, 2020, Section 8.1. Time and memory are those of `compute_harmonic_field()`.
///
/// \tparam FaceListGraph a model of `FaceListGraph`, with triangles as faces
/// \tparam FieldMap a model of `WritablePropertyMap` with the vertex descriptors of the mesh as key type, and a value
///         type that can be constructed from `double`
/// \tparam RightSideMap a model of `ReadablePropertyMap` with the vertex descriptors of the mesh as key type, and a
///         value type that can be converted to `double`
/// \tparam ConstraintRange a range of pairs of a vertex descriptor and a number
/// \tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"
///
/// \param mesh the triangulated surface; it is only read
/// \param field_map the result
/// \param right_side_map the function \f$ h \f$
/// \param constraints vertices with their values, at least one in each connected component
/// \param np `sparse_linear_solver`, `solver_tolerance`, `callback` and `vertex_point_map` as for
///        `compute_harmonic_field()`
///
/// \returns what was changed because of bad faces, see `Field_report`
///
/// The exceptions are those of `compute_harmonic_field()`, but for `Scalar_resolution_error`; there is one if a value
/// of \f$ h \f$ is infinite or NaN. When one is thrown, `field_map` is as it was before.
template <class FaceListGraph,
          class FieldMap,
          class RightSideMap,
          class ConstraintRange,
          class NamedParameters = parameters::Default_named_parameters>
Field_report compute_poisson_field(const FaceListGraph& mesh,
                                   FieldMap field_map,
                                   RightSideMap right_side_map,
                                   const ConstraintRange& constraints,
                                   const NamedParameters& np = parameters::default_values())
{
  namespace fields = internal::scalar_fields;
  return fields::solve_poisson_equation(
    mesh, field_map, np,
    [&](const auto& surface, const auto&, auto& fixed) { fields::fix_vertices(surface, constraints, fixed); },
    [&](const auto& surface, const auto&) {
      auto right_side = fields::read_field(surface, right_side_map);
      const auto areas = fields::scaled_mixed_areas(surface);
      for(std::size_t v = 0; v != areas.size(); ++v)
        right_side[v] *= areas[v] * surface.scale() * surface.scale();
      return right_side;
    });
}

/// \ingroup PkgReebGraphFields
///
/// \brief solves the Poisson equation \f$ \Delta f = \kappa \f$ with the mean curvature of `compute_mean_curvature()`
/// and given values at some vertices.
///
/// With a single given value, at a vertex such as the tip of the head of a character, the level sets of the solution
/// follow the shape. The parameters, the result, and the exceptions are those of `compute_poisson_field()`.
template <class FaceListGraph,
          class FieldMap,
          class ConstraintRange,
          class NamedParameters = parameters::Default_named_parameters>
Field_report compute_curvature_poisson_field(const FaceListGraph& mesh,
                                             FieldMap field_map,
                                             const ConstraintRange& constraints,
                                             const NamedParameters& np = parameters::default_values())
{
  namespace fields = internal::scalar_fields;
  return fields::solve_poisson_equation(
    mesh, field_map, np,
    [&](const auto& surface, const auto&, auto& fixed) { fields::fix_vertices(surface, constraints, fixed); },
    [](const auto& surface, const auto& graph) {
      auto right_side = fields::scaled_integrated_mean_curvatures(surface, graph);
      for(double& value : right_side)
        value *= surface.scale();
      return right_side;
    });
}

} // namespace CGAL::Reeb_graph

#endif // CGAL_REEB_GRAPH_FIELDS_POISSON_FIELD_H
