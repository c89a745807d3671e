// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_FIELDS_POISSON_FIELD_H
#define CGAL_REEB_GRAPH_FIELDS_POISSON_FIELD_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/fields/exceptions.h>
#include <CGAL/Reeb_graph/fields/internal/Indexed_surface.h>
#include <CGAL/Reeb_graph/fields/internal/constraints.h>
#include <CGAL/Reeb_graph/fields/internal/laplacian_graph.h>
#include <CGAL/Reeb_graph/fields/internal/solve.h>
#include <CGAL/Reeb_graph/internal/base/Progress.h>
#include <CGAL/Reeb_graph/internal/base/requirements.h>
#include <CGAL/Reeb_graph/internal/complex/Weighted_graph.h>
#include <CGAL/Reeb_graph/options.h>

#include <CGAL/Named_function_parameters.h>

#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::Reeb_graph {

namespace internal::scalar_fields {

// Solves the equations sum_j w_ij (f_j - f_i) = h_i at the free vertices, with the constraints that fix_vertices(surface,
// graph, constraints) gives, and h that integrated_right_side(surface, graph) gives, in the scale of the indexed surface.
template <class FaceListGraph, class FieldMap, class NamedParameters, class FixVertices, class RightSide>
Field_report solve_poisson_equation(const FaceListGraph& mesh,
                                    FieldMap field_map,
                                    const NamedParameters& np,
                                    const FixVertices& fix_vertices,
                                    const RightSide& integrated_right_side)
{
  const Laplacian_weights weights = Laplacian_weights::COTANGENT;
  const auto solve = [&](const auto& surface, const Weighted_graph& graph, const Constraints<double>& fixed,
                         const Stage_progress& progress, Field_report& report) {
    std::vector<double> right_side = integrated_right_side(surface, graph);
    for(Index v = 0; v != graph.number_of_vertices(); ++v)
      if(fixed.is_fixed[v])
        right_side[v] = fixed.values[v];
    progress(0);
    Dirichlet_solution solution =
      solve_dirichlet_problem({surface, graph, weights, fixed.is_fixed, right_side, progress}, 0, np);
    report.number_of_iterations = solution.number_of_steps;
    check_finite(solution.values);
    progress(1);
    return std::move(solution.values);
  };
  return write_solution<double>(mesh, field_map, weights, np, fix_vertices, solve);
}

} // namespace internal::scalar_fields

/// \ingroup PkgReebGraphFields
///
/// \brief computes the mean curvature at each vertex.
///
/// It is \f$ \frac{1}{4 A(v_i)} | \sum_j (\cot \alpha_{ij} + \cot \beta_{ij}) (v_i - v_j) | \f$ with the sum over the
/// neighbors, the two angles that face the edge, and the mixed Voronoi area \f$ A(v_i) \f$ of \cgal's package %Weights.
/// See \cgalCite{hr-edrprg-20}, Section 8.1, and \cgalCite{mdsb-ddgot2-03}. It is never negative. On the border the
/// formula means little; at isolated vertices it is zero. It takes linear time.
///
/// \param mesh the mesh; it is only read
/// \param field_map the result
/// \param np the named parameters `callback` and `vertex_point_map` of `compute_harmonic_field()`
///
/// \reebGraphComplexity
///
/// \returns what was changed because of bad faces, see `Field_report`.
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
  static_assert(internal::are_met<internal::Mesh_with_vertex_map<FaceListGraph, FieldMap>>);
  const internal::Progress progress(np);
  progress.report(0);
  fields::Indexed_mesh<FaceListGraph> surface(mesh, np);
  Field_report report = fields::make_triangles_proper(surface);
  const auto weights = Laplacian_weights::COTANGENT;
  const auto curvatures_of = [&](const internal::Weighted_graph& graph, double, double) {
    auto values = fields::scaled_integrated_mean_curvatures(surface, graph);
    const auto areas = fields::scaled_mixed_areas(surface);
    for(std::size_t v = 0; v != areas.size(); ++v)
      values[v] /= (areas[v] > 0 ? areas[v] : 1) * surface.scale();
    fields::check_finite(values);
    return values;
  };
  const internal::Weighted_graph cotangents = fields::laplacian_graph(surface, weights);
  progress.report(0.5);
  const auto curvatures = fields::solve_or_lengthen_edges(surface, cotangents, weights, report, curvatures_of);
  progress.report(0.9);
  fields::write_field(surface, curvatures, field_map, progress);
  return report;
}

/// \ingroup PkgReebGraphFields
///
/// \brief solves the Poisson equation \f$ \Delta f = h \f$ with given values at some vertices.
///
/// The Laplacian is the one with cotangent weights, divided by the mixed Voronoi area:
/// \f$ \frac{1}{2 A(v_i)} \sum_j (\cot \alpha_{ij} + \cot \beta_{ij}) (f_j - f_i) = h(v_i) \f$ at each vertex whose
/// value is not given. On a border where no values are given, the derivative across it is zero. See
/// \cgalCite{hr-edrprg-20}, Section 8.1. Time and memory are those of `compute_harmonic_field()`.
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
/// \pre The mesh is a triangulated surface, and each connected component has a vertex with a given value.
///
/// \reebGraphComplexity
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
/// follow the shape. The result and the exceptions are those of `compute_poisson_field()`.
///
/// \param mesh the mesh; it is only read
/// \param field_map the result
/// \param constraints vertices with their values
/// \param np the named parameters of `compute_poisson_field()`
///
/// \reebGraphComplexity
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

/// \ingroup PkgReebGraphFields
///
/// \brief computes a field whose level sets are about those of a given one, and whose gradient has about unit length.
///
/// The gradient of the given field is computed on each face and divided by its length,
/// \f$ X = \nabla f / |\nabla f| \f$. On a face where the field is constant, it has no direction, and \f$ X = 0 \f$.
/// The result is the field \f$ \hat f \f$ whose gradient is closest to \f$ X \f$ in the mean square, the solution of
/// \f$ \Delta \hat f = \mathrm{div} X \f$. See \cgalCite{hr-edrprg-20}, Section 6.2. In each component the lowest
/// vertex of \f$ f \f$ gets the value 0.
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
/// \reebGraphComplexity
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
      for(const internal::Index v : fields::lowest_vertices_of_components(graph, values))
        fixed.fix(v, 0);
    },
    [&](const auto& surface, const auto&) {
      return fields::integrated_divergences(surface, fields::unit_gradients(surface, values));
    });
}

} // namespace CGAL::Reeb_graph

#endif // CGAL_REEB_GRAPH_FIELDS_POISSON_FIELD_H
