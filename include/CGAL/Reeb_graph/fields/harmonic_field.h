// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_FIELDS_HARMONIC_FIELD_H
#define CGAL_REEB_GRAPH_FIELDS_HARMONIC_FIELD_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/fields/Field_report.h>
#include <CGAL/Reeb_graph/fields/exceptions.h>
#include <CGAL/Reeb_graph/fields/field_constraints.h>
#include <CGAL/Reeb_graph/fields/internal/component_vertices.h>
#include <CGAL/Reeb_graph/fields/internal/constraints.h>
#include <CGAL/Reeb_graph/fields/internal/harmonic_values.h>
#include <CGAL/Reeb_graph/internal/base/requirements.h>
#include <CGAL/Reeb_graph/named_parameters.h>

#include <CGAL/Named_function_parameters.h>

#include <boost/graph/graph_traits.hpp>

#include <array>
#include <utility>

namespace CGAL::Reeb_graph {

/// \ingroup PkgReebGraphFields
///
/// \brief computes the harmonic field with given values at some vertices.
///
/// The field solves the Laplace equation \f$ \sum_j w_{ij} (f_j - f_i) = 0 \f$ at each vertex \f$ v_i \f$ whose value
/// is not given, with the sum over its neighbors. See \cgalCite{hr-edrprg-20}, Section 8.1.
///
/// <b>There is no local extremum but at the vertices whose values are given</b>, on any mesh and with any weights.
/// After rounding each other vertex has a neighbor of strictly lower and one of strictly higher value, even where the
/// solution is flat to all digits, and even if faces have no area. So with two given values a closed surface of genus
/// \f$ g \f$ has exactly one minimum, one maximum, and saddles of total multiplicity \f$ 2g \f$. The only exception are
/// parts of the surface around which all given values are the same, so that the solution is constant there. Where the
/// plain solution keeps the promise, it is the result; elsewhere values are moved as little as it takes.
///
/// From 5000 vertices on, the equations are solved by iteration: stabilized bi-conjugate gradients, with algebraic
/// multigrid as preconditioner. On most meshes that takes ten to twenty steps, whatever the number of vertices
/// \f$ n \f$, and time and memory in proportion to it, plus \f$ O(n \log n) \f$ time. Where it takes too many steps,
/// as on meshes of needles, and on small meshes, a matrix is factorized, in about \f$ O(n^{3/2}) \f$ time and
/// \f$ O(n \log n) \f$ memory. Computing it again gives the same field, to the byte.
///
/// \tparam FaceListGraph a model of `FaceListGraph`, with triangles as faces
/// \tparam FieldMap a model of `WritablePropertyMap` with the vertex descriptors of the mesh as key type, and a value
///         type that can be constructed from `double`. For `float`, the promise holds after rounding to `float`.
/// \tparam ConstraintRange a range of pairs of a vertex descriptor and a number
/// \tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"
///
/// \param mesh the triangulated surface, with or without border; it is only read
/// \param field_map the result
/// \param constraints vertices with their values, at least one in each connected component; for whole border cycles
///        see `fix_border_cycle()`
/// \param np an optional sequence of \ref bgl_namedparameters "Named Parameters" among the ones listed below
///
/// \cgalNamedParamsBegin
///   \cgalParamNBegin{laplacian_weights}
///     \cgalParamDescription{the weights \f$ w_{ij} \f$}
///     \cgalParamType{`Reeb_graph::Laplacian_weights`}
///     \cgalParamDefault{`Reeb_graph::Laplacian_weights::MEAN_VALUE`}
///     \cgalParamExtra{use the function `parameters::laplacian_weights()`}
///   \cgalParamNEnd
///   \cgalParamNBegin{sparse_linear_solver}
///     \cgalParamDescription{a solver that takes the place of multigrid and of the default factorization. All matrices
///                           that it gets are symmetric and, unless there are negative weights, diagonally dominant.}
///     \cgalParamType{a model of `SparseLinearAlgebraWithFactorTraits_d`}
///     \cgalParamDefault{multigrid on large meshes; else `Eigen_solver_traits` with `Eigen::SimplicialLDLT`. Both need
///                       the macro `CGAL_EIGEN3_ENABLED`.}
///   \cgalParamNEnd
///   \cgalParamNBegin{solver_tolerance}
///     \cgalParamDescription{the error at which iteration stops, as a part of the range of the field. It is estimated
///                           by the preconditioner; on bad meshes it can be a hundred times as large.}
///     \cgalParamType{a positive `double`}
///     \cgalParamDefault{10<sup>-12</sup>, so that 10<sup>-10</sup> is kept on bad meshes too. A digit takes about one
///                       step, so 10<sup>-6</sup> saves an eighth of the time only; and errors above the differences
///                       between neighbors make extrema that have to be removed.}
///     \cgalParamExtra{It is not used where the matrix itself is factorized: small meshes and solvers that are given,
///                     but for mean value weights.}
///     \cgalParamExtra{use the function `parameters::solver_tolerance()`}
///   \cgalParamNEnd
///   \cgalParamNBegin{callback}
///     \cgalParamDescription{is called between the steps with the fraction that is done; `false` stops, but for the
///                           last call, with 1}
///     \cgalParamType{a function object that takes a `double` and returns a `bool`}
///     \cgalParamDefault{a function that returns `true`}
///   \cgalParamNEnd
///   \cgalParamNBegin{vertex_point_map}
///     \cgalParamDescription{a property map from the vertices to their points}
///     \cgalParamType{a model of `ReadablePropertyMap` with points of a \cgal kernel as value type}
///     \cgalParamDefault{`get(CGAL::vertex_point, mesh)`}
///   \cgalParamNEnd
/// \cgalNamedParamsEnd
///
/// \pre The mesh is a triangulated surface, and each connected component has a vertex with a given value.
///
/// \reebGraphComplexity
///
/// \returns what was changed because of bad faces, see `Field_report`; uniform weights need no geometry
///
/// \exception Non_triangular_face_error if a face is not a triangle
/// \exception Degenerate_face_error if a face has one vertex at two corners
/// \exception Edge_without_face_error if an edge is on no face
/// \exception Non_manifold_vertex_error if the faces of a vertex form more than one fan
/// \exception Mesh_size_error if there are too many vertices or face corners for 32-bit indices
/// \exception Non_finite_point_error if a coordinate is infinite or NaN
/// \exception Unknown_vertex_error if a vertex of `constraints` is not one of the mesh
/// \exception Contradictory_constraints_error if a vertex gets two different values
/// \exception Unconstrained_component_error if a component has no vertex with a given value
/// \exception Non_finite_scalar_error if a given value, or one of the result, is infinite or NaN
/// \exception Scalar_resolution_error if there are fewer numbers between the given values than the promise needs
/// \exception Solver_tolerance_error if `solver_tolerance` is not a positive number
/// \exception Linear_solver_error if the solver fails
/// \exception Cancelled_error if `callback` returns `false`
///
/// When one of these is thrown, `field_map` is as it was before.
template <class FaceListGraph,
          class FieldMap,
          class ConstraintRange,
          class NamedParameters = parameters::Default_named_parameters>
Field_report compute_harmonic_field(const FaceListGraph& mesh,
                                    FieldMap field_map,
                                    const ConstraintRange& constraints,
                                    const NamedParameters& np = parameters::default_values())
{
  namespace fields = internal::scalar_fields;
  return fields::write_harmonic_field(mesh, field_map, np, [&](const auto& surface, const auto&, auto& fixed) {
    fields::fix_vertices(surface, constraints, fixed);
  });
}

/// \ingroup PkgReebGraphFields
///
/// \brief computes the harmonic field that is 0 at the vertex `lowest` and 1 at the vertex `highest` of a connected
/// mesh.
///
/// It is `compute_harmonic_field()` with these two constraints, and has its result and exceptions.
///
/// \pre The mesh is connected.
///
/// \param mesh the mesh; it is only read
/// \param field_map the result
/// \param lowest the vertex of value 0
/// \param highest the vertex of value 1
/// \param np the named parameters of `compute_harmonic_field()`
///
/// \reebGraphComplexity
template <class FaceListGraph, class FieldMap, class NamedParameters = parameters::Default_named_parameters>
Field_report compute_harmonic_field_between(const FaceListGraph& mesh,
                                            FieldMap field_map,
                                            typename boost::graph_traits<FaceListGraph>::vertex_descriptor lowest,
                                            typename boost::graph_traits<FaceListGraph>::vertex_descriptor highest,
                                            const NamedParameters& np = parameters::default_values())
{
  typedef typename boost::graph_traits<FaceListGraph>::vertex_descriptor vertex_descriptor;
  const std::array<std::pair<vertex_descriptor, double>, 2> constraints = {{{lowest, 0.}, {highest, 1.}}};
  return compute_harmonic_field(mesh, field_map, constraints, np);
}

/// \ingroup PkgReebGraphFields
///
/// \brief computes the harmonic field that is 0 and 1 at two vertices of each component that are far apart.
///
/// The two are those of `find_far_apart_vertices()`. An isolated vertex gets the value 0. The result and the exceptions
/// are those of `compute_harmonic_field()`.
///
/// \param mesh the mesh; it is only read
/// \param field_map the result
/// \param np the named parameters of `compute_harmonic_field()`
///
/// \reebGraphComplexity
template <class FaceListGraph, class FieldMap, class NamedParameters = parameters::Default_named_parameters>
Field_report compute_harmonic_field_between_far_apart_vertices(const FaceListGraph& mesh,
                                                               FieldMap field_map,
                                                               const NamedParameters& np = parameters::default_values())
{
  namespace fields = internal::scalar_fields;
  return fields::write_harmonic_field(mesh, field_map, np, [](const auto& surface, const auto& graph, auto& fixed) {
    for(const auto& [lowest, highest] : fields::far_apart_vertices(surface, graph))
    {
      fixed.fix(lowest, 0);
      if(highest != lowest)
        fixed.fix(highest, 1);
    }
  });
}

/// \ingroup PkgReebGraphFields
///
/// \brief computes the harmonic field whose extrema are the borders of the mesh, so that they are levels, as
/// `cutting_system()`, `pants_decomposition()` and `branch_curves()` need it.
///
/// In each connected component, the field is 0 on the first border component and 1 on the other ones, in the order of
/// their first vertices. If there is one border, the field is 1 at a vertex far from it, or 0 all over where all
/// vertices are on it. If there is none, it is 0 and 1 at the two vertices of `find_far_apart_vertices()`. An isolated
/// vertex gets the value 0. Borders at 1 that share edges are one plateau.
///
/// The template parameters, the result, and the exceptions are those of `compute_harmonic_field()`.
///
/// \param mesh the mesh; it is only read
/// \param field_map the result
/// \param np the named parameters of `compute_harmonic_field()`
///
/// \reebGraphComplexity
template <class FaceListGraph, class FieldMap, class NamedParameters = parameters::Default_named_parameters>
Field_report compute_harmonic_field_between_borders(const FaceListGraph& mesh,
                                                    FieldMap field_map,
                                                    const NamedParameters& np = parameters::default_values())
{
  if constexpr(internal::Mesh_with_vertex_map<FaceListGraph, FieldMap>::value)
    return compute_harmonic_field(mesh, field_map, internal::scalar_fields::fix_borders(mesh, np), np);
  else
    return Field_report();
}

} // namespace CGAL::Reeb_graph

#endif // CGAL_REEB_GRAPH_FIELDS_HARMONIC_FIELD_H
