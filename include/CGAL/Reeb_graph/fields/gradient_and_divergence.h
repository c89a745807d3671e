// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_FIELDS_GRADIENT_AND_DIVERGENCE_H
#define CGAL_REEB_GRAPH_FIELDS_GRADIENT_AND_DIVERGENCE_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/fields/exceptions.h>
#include <CGAL/Reeb_graph/fields/internal/Indexed_surface.h>
#include <CGAL/Reeb_graph/fields/internal/constraints.h>
#include <CGAL/Reeb_graph/fields/internal/laplacian_graph.h>
#include <CGAL/Reeb_graph/internal/base/Progress.h>
#include <CGAL/Reeb_graph/internal/base/requirements.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/number_utils.h>

#include <boost/property_map/property_map.hpp>

#include <cstddef>
#include <vector>

namespace CGAL::Reeb_graph {

/// \ingroup PkgReebGraphFields
///
/// \brief computes the gradient of a scalar field on each face.
///
/// The field is linear on a face with the corners \f$ v_1, v_2, v_3 \f$, and its gradient there
/// \f$ \sum_i f(v_i) \frac{|E_i|}{2 A} u_i \f$, where \f$ A \f$ is the area, \f$ E_i \f$ the edge that faces
/// \f$ v_i \f$, and \f$ u_i \f$ the unit vector in the face that is perpendicular to \f$ E_i \f$ and points to
/// \f$ v_i \f$. See \cgalCite{hr-edrprg-20}, Section 6.2. It is exact for the restriction of a linear function of
/// space, up to rounding, and takes linear time. If there are bad faces, it is the gradient on faces with longer edges,
/// see `Field_report`, each laid out in the plane of the given one as far as that has a plane.
///
/// \tparam FaceListGraph a model of `FaceListGraph`, with triangles as faces
/// \tparam ScalarMap a model of `ReadablePropertyMap` with the vertex descriptors of the mesh as key type, and a value
///         type that can be converted to `double`
/// \tparam FaceVectorMap a model of `WritablePropertyMap` with the face descriptors of the mesh as key type, and
///         `Vector_3` of a \cgal kernel as value type
/// \tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"
///
/// \param mesh the triangulated surface; it is only read
/// \param scalar_map the field
/// \param gradient_map the result
/// \param np `callback` and `vertex_point_map` as for `compute_harmonic_field()`
///
/// \reebGraphComplexity
///
/// \returns what was changed because of bad faces, see `Field_report`
///
/// \exception Non_finite_scalar_error if a value of the field is infinite or NaN
/// \exception Non_finite_vector_error if the gradient of a face is
/// \exception Non_finite_point_error if a coordinate is
/// \exception Cancelled_error if `callback` returns `false`
///
/// and those for meshes that are not triangulated surfaces, see `compute_harmonic_field()`. When one of these is
/// thrown, `gradient_map` is as it was before.
template <class FaceListGraph,
          class ScalarMap,
          class FaceVectorMap,
          class NamedParameters = parameters::Default_named_parameters>
Field_report compute_gradient(const FaceListGraph& mesh,
                              ScalarMap scalar_map,
                              FaceVectorMap gradient_map,
                              const NamedParameters& np = parameters::default_values())
{
  namespace fields = internal::scalar_fields;
  const internal::Progress progress(np);
  progress.report(0);
  static_assert(internal::are_met<internal::Mesh_is_face_list_graph<FaceListGraph>,
                                  internal::Writable_face_map<FaceVectorMap, FaceListGraph>>);
  typedef typename boost::property_traits<FaceVectorMap>::value_type Vector_3;
  fields::Indexed_mesh<FaceListGraph> surface(mesh, np);
  const Field_report report = fields::make_triangles_proper(surface);
  progress.report(0.5);
  auto gradients = fields::scaled_gradients(surface, fields::read_field(surface, scalar_map));
  for(std::size_t t = 0; t != gradients.size(); ++t)
  {
    gradients[t] = gradients[t] / surface.scale();
    if(!fields::is_finite(gradients[t]))
      throw Non_finite_vector_error(t);
  }
  progress.report(0.9);
  auto gradient = gradients.begin();
  for(const auto f : CGAL::make_range(faces(mesh)))
  {
    put(gradient_map, f, Vector_3(gradient->x(), gradient->y(), gradient->z()));
    ++gradient;
  }
  progress.report_end();
  return report;
}

/// \ingroup PkgReebGraphFields
///
/// \brief computes the divergence at each vertex of vectors that are given for each face.
///
/// It is \f$ \frac12 \sum_j \cot \theta_{j_1} \langle e_{j_1}, X_j \rangle + \cot \theta_{j_2} \langle e_{j_2}, X_j
/// \rangle \f$ with the sum over the faces at the vertex; \f$ e_{j_1}, e_{j_2} \f$ are the edges of a face that lead
/// away from the vertex, \f$ \theta_{j_1}, \theta_{j_2} \f$ the angles that face them, \f$ X_j \f$ the vector. See
/// \cgalCite{hr-edrprg-20}, Section 6.2. This is the divergence integrated over a cell around the vertex:
/// \f$ \sum_v f(v) \, \mathrm{div} X(v) = - \sum_j A_j \langle \nabla f_j, X_j \rangle \f$ for any field \f$ f \f$,
/// and the divergence of a gradient is the Laplacian with cotangent weights. It takes linear time.
///
/// \tparam FaceListGraph a model of `FaceListGraph`, with triangles as faces
/// \tparam FaceVectorMap a model of `ReadablePropertyMap` with the face descriptors of the mesh as key type, and
///         `Vector_3` of a \cgal kernel as value type
/// \tparam FieldMap a model of `WritablePropertyMap` with the vertex descriptors of the mesh as key type, and a value
///         type that can be constructed from `double`
/// \tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"
///
/// \param mesh the triangulated surface; it is only read
/// \param vector_map the vectors
/// \param divergence_map the result, zero for isolated vertices
/// \param np `callback` and `vertex_point_map` as for `compute_harmonic_field()`
///
/// \reebGraphComplexity
///
/// \returns what was changed because of bad faces, see `Field_report`
///
/// \exception Non_finite_vector_error if a vector is infinite or NaN
/// \exception Non_finite_scalar_error if the divergence at a vertex is
/// \exception Non_finite_point_error if a coordinate is
/// \exception Cancelled_error if `callback` returns `false`
///
/// and those for meshes that are not triangulated surfaces, see `compute_harmonic_field()`. When one of these is
/// thrown, `divergence_map` is as it was before.
template <class FaceListGraph,
          class FaceVectorMap,
          class FieldMap,
          class NamedParameters = parameters::Default_named_parameters>
Field_report compute_divergence(const FaceListGraph& mesh,
                                FaceVectorMap vector_map,
                                FieldMap divergence_map,
                                const NamedParameters& np = parameters::default_values())
{
  namespace fields = internal::scalar_fields;
  const internal::Progress progress(np);
  progress.report(0);
  static_assert(internal::are_met<internal::Mesh_with_vertex_map<FaceListGraph, FieldMap>>);
  fields::Indexed_mesh<FaceListGraph> surface(mesh, np);
  const Field_report report = fields::make_triangles_proper(surface);
  progress.report(0.5);
  std::vector<fields::Vector> vectors;
  vectors.reserve(surface.triangles().size());
  for(const auto f : CGAL::make_range(faces(mesh)))
  {
    const auto [x, y, z] = internal::coordinates_of(get(vector_map, f));
    vectors.emplace_back(x, y, z);
    if(!fields::is_finite(vectors.back()))
      throw Non_finite_vector_error(vectors.size() - 1);
  }
  const auto divergences = fields::integrated_divergences(surface, vectors);
  progress.report(0.9);
  fields::write_field(surface, divergences, divergence_map, progress);
  return report;
}

} // namespace CGAL::Reeb_graph

#endif // CGAL_REEB_GRAPH_FIELDS_GRADIENT_AND_DIVERGENCE_H
