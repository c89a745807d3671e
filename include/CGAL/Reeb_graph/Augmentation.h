// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of the CGAL-style package Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_AUGMENTATION_H
#define CGAL_REEB_GRAPH_AUGMENTATION_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/Basic_augmentation.h>
#include <CGAL/Reeb_graph/Contour.h>
#include <CGAL/Reeb_graph/exceptions.h>
#include <CGAL/Reeb_graph/internal/base/Progress.h>
#include <CGAL/Reeb_graph/internal/base/graph_requirements.h>
#include <CGAL/Reeb_graph/internal/base/named_parameter.h>
#include <CGAL/Reeb_graph/internal/base/scalars.h>
#include <CGAL/Reeb_graph/internal/way_back/Graph_on_mesh.h>
#include <CGAL/Reeb_graph/named_parameters.h>
#include <CGAL/Reeb_graph_traits.h>

#include <boost/graph/graph_traits.hpp>

namespace CGAL::Reeb_graph {

/// \ingroup PkgReebGraphAugmentation
///
/// \brief the way from a Reeb graph back to a surface mesh.
///
/// At construction it copies the field, and a mesh that is no `CGAL::Surface_mesh`, in linear time and memory. The mesh
/// has to outlive it as the graph has, and must not change, and neither must what a `vertex_index_map` refers to.
///
/// The contour of an arc takes time linear in its length and in the lower one of the degrees of the ends of the arc,
/// and logarithmic in the length of the chain. Unless the mesh is a `CGAL::Surface_mesh`, the degrees at the halfedge
/// that it starts from count as well. So contours of many arcs at one vertex take hardly longer than those elsewhere.
///
/// Locating vertices takes linear time on a field with few critical vertices, hardly longer than the graph. On noise,
/// sorting all vertices comes on top: near-linear for any field. The named parameter `vertex_place_map` of
/// `compute_reeb_graph()` finds the places without computing anything twice.
///
/// \tparam FaceListGraph a model of `FaceListGraph`
/// \tparam ScalarMap a model of `ReadablePropertyMap` with the vertex descriptors of the mesh as key type. Values that
///         are not numbers are those of contours only if the traits class converts them, see `ReebGraphTraits`
/// \tparam ReebGraph the type `Graph` of the traits class
/// \tparam Traits a model of `ReebGraphTraits`: the type of the named parameter `geom_traits`, if that is given. It is
///         deduced by `Augmentation augmentation(mesh, scalar_map, graph, np)`.
template <class FaceListGraph,
          class ScalarMap,
          class ReebGraph = typename Reeb_graph_traits<FaceListGraph, ScalarMap>::Graph,
          class Traits = Reeb_graph_traits<FaceListGraph, ScalarMap>>
class Augmentation
#ifdef DOXYGEN_RUNNING
  : public Basic_augmentation<unspecified_type>
#else
  : public Basic_augmentation<internal::After<internal::Field_and_graph<FaceListGraph, ScalarMap, ReebGraph, Traits>,
                                              internal::Graph_on_mesh<FaceListGraph, ReebGraph, Traits>>>
#endif
{
  typedef Basic_augmentation<internal::Graph_on_mesh<FaceListGraph, ReebGraph, Traits>> Base;

public:
  using typename Base::Contour;
  using typename Base::halfedge_descriptor;
  /// a face of the mesh
  typedef typename boost::graph_traits<FaceListGraph>::face_descriptor face_descriptor;

  /// \brief prepares the way back from `graph` to `mesh`.
  ///
  /// \param mesh the mesh that the graph has been computed of
  /// \param scalar_map the field that it has been computed of
  /// \param graph the graph
  /// \param np the named parameters that the graph has been computed with: `ties`, `keep_degree_two_nodes`,
  ///        `vertex_index_map`, `face_index_map` and `geom_traits` count. `callback` is as for `compute_reeb_graph()`.
  ///        To locate vertices in a graph made by `simplify()`, pass what that has returned as `simplification`
  ///
  /// \exception Graph_mismatch_error if a node is not one of this mesh and field, or an arc none that `ties` gives.
  ///            That all nodes and arcs are there is checked by `locate_vertices()` only.
  ///
  /// and the exceptions of `compute_reeb_graph()`.
  template <class NamedParameters = parameters::Default_named_parameters>
  Augmentation(const FaceListGraph& mesh,
               ScalarMap scalar_map,
               const ReebGraph& graph,
               const NamedParameters& np = parameters::default_values())
    : Base(internal::Progress(np), np, mesh, scalar_map, graph)
  {}

#ifndef DOXYGEN_RUNNING
  // Neither the mesh nor the graph is copied.
  template <class NamedParameters = parameters::Default_named_parameters>
  Augmentation(const FaceListGraph&&,
               ScalarMap,
               const ReebGraph&,
               const NamedParameters& = parameters::default_values()) = delete;
  template <class NamedParameters = parameters::Default_named_parameters>
  Augmentation(const FaceListGraph&,
               ScalarMap,
               const ReebGraph&&,
               const NamedParameters& = parameters::default_values()) = delete;
#endif

  /// \brief writes the point at which a contour crosses each of its halfedges, by linear interpolation.
  ///
  /// \tparam OutputIterator a model of `OutputIterator` for the points of the mesh
  ///
  /// \param contour a contour of this object
  /// \param points the output; the first point is not repeated at the end
  /// \param np an optional sequence of \ref bgl_namedparameters "Named Parameters" among the ones listed below
  ///
  /// \cgalNamedParamsBegin
  ///   \cgalParamNBegin{vertex_point_map}
  ///     \cgalParamDescription{the points of the vertices}
  ///     \cgalParamType{a model of `ReadablePropertyMap` with the vertex descriptors as key type}
  ///     \cgalParamDefault{`boost::get(CGAL::vertex_point, mesh)`}
  ///   \cgalParamNEnd
  /// \cgalNamedParamsEnd
  ///
  /// \returns the output iterator behind the last point.
  template <class OutputIterator, class NamedParameters = parameters::Default_named_parameters>
  OutputIterator points_of_contour(const Contour& contour,
                                   OutputIterator points,
                                   const NamedParameters& np = parameters::default_values()) const
  {
    // Maps may return points that do not outlive the descriptor.
    const auto& mesh = this->mesh();
    const auto point_map = internal::choose_point_map(mesh, np);
    for(const halfedge_descriptor h : contour.halfedges)
      *points++ = internal::point_between(get(point_map, source(h, mesh)), get(point_map, target(h, mesh)),
                                          internal::crossing_fraction(this->on_mesh(), h, contour.value));
    return points;
  }
};

#ifndef DOXYGEN_RUNNING
template <class FaceListGraph, class ScalarMap, class ReebGraph, class NamedParameters>
Augmentation(const FaceListGraph&, ScalarMap, const ReebGraph&, const NamedParameters&)
  -> Augmentation<FaceListGraph,
                  ScalarMap,
                  ReebGraph,
                  internal::Chosen_traits<Reeb_graph_traits<FaceListGraph, ScalarMap>, NamedParameters>>;
#endif

} // namespace CGAL::Reeb_graph

#endif // CGAL_REEB_GRAPH_AUGMENTATION_H
