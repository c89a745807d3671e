// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of the CGAL-style package Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_FIELDS_GEODESIC_FIELD_H
#define CGAL_REEB_GRAPH_FIELDS_GEODESIC_FIELD_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/fields/Field_report.h>
#include <CGAL/Reeb_graph/fields/internal/Geodesic_distances.h>
#include <CGAL/Reeb_graph/fields/internal/Indexed_surface.h>
#include <CGAL/Reeb_graph/fields/internal/Weighted_graph.h>
#include <CGAL/Reeb_graph/fields/internal/constraints.h>
#include <CGAL/Reeb_graph/internal/base/Progress.h>
#include <CGAL/Reeb_graph/internal/base/requirements.h>
#include <CGAL/Reeb_graph/options.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/Reeb_graph/fields/internal/laplacian_graph.h>

#include <cstddef>
#include <vector>

namespace CGAL::Reeb_graph {

/// \ingroup PkgReebGraphFields
///
/// \brief computes the geodesic distance of each vertex from the nearest one of some source vertices.
///
/// The distances are those of the heat method with intrinsic Delaunay triangulations, \cgal's
/// `Heat_method_3::Surface_mesh_geodesic_distances_3`, for each connected component on its own: an estimate, which gets
/// better as the mesh gets finer. Other than a harmonic field, it can have extrema anywhere.
///
/// On a component where the heat method fails, the distances are those of a front that marches from vertex to vertex,
/// along the edges and straight through the triangles: M. Novotni and R. Klein, *Computing Geodesic Distances on
/// Triangular Meshes*, 2002. They need nothing but the lengths of the edges, which are longer if there are bad faces,
/// see `Field_report`. The heat method fails if its equations have no solution. It fails if a distance is not finite,
/// as some thousand edges away from the sources, or off by more than half of the largest one. It is not tried where the
/// intrinsic Delaunay triangulation may not end: if a side of a triangle is as long as the two others to 14 digits, or
/// edges differ in length by a factor of 10<sup>7</sup>.
///
/// It needs Eigen: the macro `CGAL_EIGEN3_ENABLED` has to be defined. Matrices are factorized, in about
/// \f$ O(n^{3/2}) \f$ time and \f$ O(n \log n) \f$ memory for \f$ n \f$ vertices, plus the time of the intrinsic
/// Delaunay triangulation, plus the number of vertices times that of the sources.
///
/// \tparam FaceListGraph a model of `FaceListGraph`, with triangles as faces
/// \tparam FieldMap a model of `WritablePropertyMap` with the vertex descriptors of the mesh as key type, and a value
///         type that can be constructed from `double`
/// \tparam VertexRange a range of vertex descriptors
/// \tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"
///
/// \param mesh the triangulated surface; it is only read
/// \param field_map the result
/// \param sources the vertices at distance zero, at least one in each connected component
/// \param np `callback` and `vertex_point_map` as for `compute_harmonic_field()`
///
/// \returns what was changed because of bad faces, and on how many components the heat method fails
///
/// \exception Unknown_vertex_error if a source is not a vertex of the mesh
/// \exception Unconstrained_component_error if a component has no source
/// \exception Non_finite_scalar_error if a distance is beyond the range of numbers
/// \exception Cancelled_error if `callback` returns `false`
///
/// and those for meshes that are not triangulated surfaces, see `compute_harmonic_field()`. When one of these is
/// thrown, `field_map` is as it was before.
template <class FaceListGraph,
          class FieldMap,
          class VertexRange,
          class NamedParameters = parameters::Default_named_parameters>
Field_report compute_geodesic_field(const FaceListGraph& mesh,
                                    FieldMap field_map,
                                    const VertexRange& sources,
                                    const NamedParameters& np = parameters::default_values())
{
  namespace fields = internal::scalar_fields;
  if constexpr(internal::Mesh_with_vertex_map<FaceListGraph, FieldMap>::value)
  {
    const internal::Progress progress(np);
    progress.report(0);
    fields::Indexed_mesh<FaceListGraph> surface(mesh, np);
    fields::Constraints<double> fixed(surface.number_of_vertices());
    for(const auto v : sources)
      fixed.fix(surface.position(v), 0);
    const fields::Weighted_graph graph = fields::laplacian_graph(surface, Laplacian_weights::UNIFORM);
    fields::check_components(graph, fixed.is_fixed);
    Field_report report = fields::make_triangles_proper(surface);
    fields::Geodesic_distances geodesic_distances(fixed.is_fixed,
                                                  fields::Marching(surface, fixed.is_fixed).distances());
    progress.report(0.1);

    geodesic_distances.run(mesh, surface, fields::label_components(graph), progress);
    report.number_of_marched_components = geodesic_distances.number_of_marched_components();
    std::vector<double> distances = geodesic_distances.distances();
    for(double& distance : distances)
      distance *= surface.scale();
    fields::write_field(surface, distances, field_map, progress);
    return report;
  }
  else
    return Field_report();
}

} // namespace CGAL::Reeb_graph

#endif // CGAL_REEB_GRAPH_FIELDS_GEODESIC_FIELD_H
