// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_FIELDS_FIELD_CONSTRAINTS_H
#define CGAL_REEB_GRAPH_FIELDS_FIELD_CONSTRAINTS_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/fields/exceptions.h>
#include <CGAL/Reeb_graph/fields/internal/Indexed_surface.h>
#include <CGAL/Reeb_graph/fields/internal/laplacian_graph.h>
#include <CGAL/Reeb_graph/internal/base/Progress.h>
#include <CGAL/Reeb_graph/internal/base/requirements.h>
#include <CGAL/Reeb_graph/options.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/boost/graph/helpers.h>
#include <CGAL/boost/graph/iterator.h>

#include <boost/graph/graph_traits.hpp>

#include <utility>

namespace CGAL::Reeb_graph {

/// \ingroup PkgReebGraphFields
///
/// \brief writes for each connected component of `mesh` a pair of vertices that are far apart along the edges.
///
/// The first one is the vertex farthest from the first vertex of the component, the second one the vertex farthest from
/// the first one. In a component of a single vertex they are the same. It takes \f$ O(n \log n) \f$ time.
///
/// \tparam FaceListGraph a model of `FaceListGraph`, with triangles as faces
/// \tparam OutputIterator a model of `OutputIterator` for `std::pair` of two vertex descriptors
/// \tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters": `callback` and `vertex_point_map`
///         as for `compute_harmonic_field()`
///
/// \param mesh the mesh
/// \param out where the pairs are written
/// \param np an optional sequence of named parameters
///
/// \reebGraphComplexity
///
/// \returns the past-the-end iterator of the output
///
/// The exceptions are those of `compute_harmonic_field()` with uniform weights.
template <class FaceListGraph, class OutputIterator, class NamedParameters = parameters::Default_named_parameters>
OutputIterator find_far_apart_vertices(const FaceListGraph& mesh,
                                       OutputIterator out,
                                       const NamedParameters& np = parameters::default_values())
{
  namespace fields = internal::scalar_fields;
  static_assert(internal::are_met<internal::Mesh_is_face_list_graph<FaceListGraph>>);
  const internal::Progress progress(np);
  progress.report(0);
  const fields::Indexed_mesh<FaceListGraph> surface(mesh, np);
  progress.report(0.3);
  const auto pairs = fields::far_apart_vertices(surface, fields::laplacian_graph(surface, Laplacian_weights::UNIFORM));
  progress.report(0.9);
  for(const auto& pair : pairs)
    *out++ = std::make_pair(surface.vertex_handle(pair.first), surface.vertex_handle(pair.second));
  progress.report_end();
  return out;
}

/// \ingroup PkgReebGraphFields
///
/// \brief writes, for each vertex of a border cycle, the vertex and the value, as constraints of
/// `compute_harmonic_field()` and `compute_poisson_field()`.
///
/// `Polygon_mesh_processing::extract_boundary_cycles()` of \cgal finds a halfedge of each border cycle.
///
/// \param border_halfedge a border halfedge of the cycle
/// \param mesh the mesh
/// \param value the value
/// \param out a model of `OutputIterator` for `std::pair` of a vertex descriptor and `double`
///
/// \pre The halfedge is on the border.
///
/// \reebGraphComplexity
///
/// \returns the past-the-end iterator of the output
///
/// \exception Not_on_border_error if `border_halfedge` is the halfedge of a face
template <class FaceListGraph, class OutputIterator>
OutputIterator fix_border_cycle(typename boost::graph_traits<FaceListGraph>::halfedge_descriptor border_halfedge,
                                const FaceListGraph& mesh,
                                double value,
                                OutputIterator out)
{
  if(!is_border(border_halfedge, mesh))
    throw Not_on_border_error();
  for(const auto v : vertices_around_face(border_halfedge, mesh))
    *out++ = std::make_pair(v, value);
  return out;
}

} // namespace CGAL::Reeb_graph

#endif // CGAL_REEB_GRAPH_FIELDS_FIELD_CONSTRAINTS_H
