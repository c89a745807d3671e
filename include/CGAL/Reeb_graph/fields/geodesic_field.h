// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_FIELDS_GEODESIC_FIELD_H
#define CGAL_REEB_GRAPH_FIELDS_GEODESIC_FIELD_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/fields/internal/Geodesic_distances.h>
#include <CGAL/Reeb_graph/fields/internal/Indexed_surface.h>
#include <CGAL/Reeb_graph/fields/internal/Intrinsic_triangulation.h>
#include <CGAL/Reeb_graph/fields/internal/constraints.h>
#include <CGAL/Reeb_graph/fields/internal/laplacian_graph.h>
#include <CGAL/Reeb_graph/internal/base/Progress.h>
#include <CGAL/Reeb_graph/internal/base/requirements.h>
#include <CGAL/Reeb_graph/options.h>

#include <CGAL/Named_function_parameters.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL::Reeb_graph {

/// \ingroup PkgReebGraphFields
///
/// \brief computes the geodesic distance of each vertex from the nearest one of some source vertices.
///
/// A front marches from vertex to vertex, along the edges and straight through the triangles: \cgalCite{nk-cgdtm-02}.
/// Before, edges are flipped, on the surface, until the triangulation is Delaunay: \cgalCite{bs-dlboss-07}. So the
/// distances depend on the shape of the surface more than on that of its triangles, which may be long, or have no area.
/// They are estimates: Section \ref ReebGraph_other_fields of the manual has their errors. But no distance is less than
/// that in space from the nearest source, and along an edge they differ by no more than its length, both up to
/// rounding. Other than a harmonic field, the field can have extrema anywhere.
///
/// It takes \f$ O(n \log n) \f$ time for \f$ n \f$ vertices, for any number of sources, and \f$ O(n) \f$ memory.
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
/// \reebGraphComplexity
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
void compute_geodesic_field(const FaceListGraph& mesh,
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
      fixed.fix(surface.dense_vertex(v), 0);
    fields::Intrinsic_triangulation triangulation(surface, fields::find_opposites(mesh, surface));
    triangulation.make_delaunay({progress, 0.1, 0.5});
    std::vector<double> distances =
      fields::Geodesic_distances(surface, triangulation)(fixed.is_fixed, {progress, 0.5, 0.95});
    if(std::find(distances.begin(), distances.end(), std::numeric_limits<double>::infinity()) != distances.end())
      fields::check_components(fields::laplacian_graph(surface, Laplacian_weights::UNIFORM), fixed.is_fixed);
    for(double& distance : distances)
      distance *= surface.scale();
    fields::write_field(surface, distances, field_map, progress);
  }
}

} // namespace CGAL::Reeb_graph

#endif // CGAL_REEB_GRAPH_FIELDS_GEODESIC_FIELD_H
