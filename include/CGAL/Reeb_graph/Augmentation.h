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

#include <CGAL/Reeb_graph/Contour.h>
#include <CGAL/Reeb_graph/Vertex_locations.h>
#include <CGAL/Reeb_graph/exceptions.h>
#include <CGAL/Reeb_graph/internal/augmentation/Graph_on_mesh.h>
#include <CGAL/Reeb_graph/internal/augmentation/Surface_contour_tracer.h>
#include <CGAL/Reeb_graph/internal/augmentation/Way_back.h>
#include <CGAL/Reeb_graph/internal/base/Progress.h>
#include <CGAL/Reeb_graph/internal/base/crossing_fraction.h>
#include <CGAL/Reeb_graph/internal/base/graph_requirements.h>
#include <CGAL/Reeb_graph/internal/base/named_parameter.h>
#include <CGAL/Reeb_graph/internal/base/point_map.h>
#include <CGAL/Reeb_graph/named_parameters.h>
#include <CGAL/Reeb_graph_traits.h>

#include <boost/graph/graph_traits.hpp>

#include <type_traits>
#include <vector>

namespace CGAL {
namespace Reeb_graph {

/// \ingroup PkgReebGraphAugmentation
///
/// \brief the way from a Reeb graph back to the mesh: the contours of arcs, the critical sets of nodes, and the place
/// of each vertex of the mesh in the graph.
///
/// It implements the map \f$ F: R(M, f) \to M \f$ of M. Hajij and P. Rosen, *An Efficient Data Retrieval Parallel Reeb
/// Graph Algorithm*, 2020, Section 6. At construction it copies the field, and a mesh that is no `CGAL::Surface_mesh`,
/// in linear time and memory. The mesh and the graph have to outlive it and must not change, and neither must what a
/// `vertex_index_map` refers to. It can be neither copied nor moved. All member functions can be called from several
/// threads at a time; those that return contours throw `Graph_mismatch_error` if the chain of an arc does not lead to
/// them.
///
/// The contour of an arc takes time proportional to its length, to the lower one of the degrees of the ends of the arc,
/// and, unless the mesh is a `CGAL::Surface_mesh`, to that of the ends of the halfedge it starts from, and logarithmic in
/// the length of the chain; so contours of many arcs at one vertex take hardly longer than those elsewhere. To locate vertices takes linear time on a field
/// with few critical vertices, and hardly longer than computing the graph again; on noise, that of sorting all vertices
/// besides: near-linear for any field. The named parameter `vertex_place_map` of `compute_reeb_graph()` finds the
/// places without computing anything twice.
///
/// \tparam FaceListGraph a model of `FaceListGraph`
/// \tparam ScalarMap a model of `ReadablePropertyMap` with the vertex descriptors of the mesh as key type. Values that
///         are no numbers are those of contours only if the traits class converts them, see `ReebGraphTraits`
/// \tparam ReebGraph the type `Graph` of the traits class
/// \tparam Traits a model of `ReebGraphTraits`: the type of the named parameter `geom_traits`, if that is given. It is
///         deduced by `Augmentation augmentation(mesh, scalar_map, graph, np)`.
template <class FaceListGraph,
          class ScalarMap,
          class ReebGraph = typename Reeb_graph_traits<FaceListGraph, ScalarMap>::Graph,
          class Traits = Reeb_graph_traits<FaceListGraph, ScalarMap>>
class Augmentation
{
  // The instantiation says what does not fit.
  typedef typename internal::Field_and_graph<FaceListGraph, ScalarMap, ReebGraph, Traits>::type Requirements;
  typedef internal::Graph_on_mesh<FaceListGraph, ReebGraph, Traits> Graph_on_mesh;

public:
  /// the mesh
  typedef FaceListGraph Mesh;
  /// the graph
  typedef ReebGraph Graph;
  /// a scalar value
  typedef typename Traits::Scalar Scalar;
  /// a vertex of the mesh
  typedef typename boost::graph_traits<FaceListGraph>::vertex_descriptor vertex_descriptor;
  /// a halfedge of the mesh
  typedef typename boost::graph_traits<FaceListGraph>::halfedge_descriptor halfedge_descriptor;
  /// a face of the mesh
  typedef typename boost::graph_traits<FaceListGraph>::face_descriptor face_descriptor;
  /// a node of the graph
  typedef typename boost::graph_traits<ReebGraph>::vertex_descriptor node_descriptor;
  /// an arc of the graph
  typedef typename boost::graph_traits<ReebGraph>::edge_descriptor arc_descriptor;

  /// a contour
  typedef Reeb_graph::Contour<arc_descriptor, halfedge_descriptor> Contour;
  /// a critical set
  typedef Reeb_graph::Critical_set<Contour, halfedge_descriptor, face_descriptor> Critical_set;
  /// the places of all vertices
  typedef Reeb_graph::Vertex_locations<vertex_descriptor, ReebGraph> Vertex_locations;

  /// \brief prepares the way back from `graph` to `mesh`.
  ///
  /// \param mesh the mesh that the graph has been computed of
  /// \param scalar_map the field that it has been computed of
  /// \param graph the graph
  /// \param np the named parameters that the graph has been computed with: `ties`, `keep_degree_two_nodes`,
  ///        `vertex_index_map`, `face_index_map` and `geom_traits` count; `callback`, as for `compute_reeb_graph()`;
  ///        and for a graph made by `simplify()`, what that has returned, as named parameter `simplification`, if
  ///        vertices are to be located
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
    : way_back_(np, internal::Progress(np), [&](const internal::Progress& progress) {
        return Graph_on_mesh(mesh, scalar_map, graph, internal::choose_traits<Traits>(np), np, progress);
      })
  {
    static_assert(std::is_same_v<internal::Chosen_traits<Traits, NamedParameters>, Traits>,
                  "The last template parameter of Augmentation must be the type of the named parameter geom_traits.");
  }

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

  /// returns the mesh.
  const Mesh& mesh() const { return on_mesh().mesh(); }
  /// returns the graph.
  const Graph& graph() const { return on_mesh().graph(); }

  /// \brief returns the value of the vertex `v` as that of a contour: as a `double`, NaN if the values of the field are
  /// no numbers.
  ///
  /// \exception Unknown_vertex_error if there is no such vertex
  double value(vertex_descriptor v) const { return way_back_.value(v); }

  /// \brief returns the contour of an arc at a place between its ends.
  ///
  /// The values along the arc are parametrized linearly, `t` = 0 at the lower node and `t` = 1 at the upper one. The
  /// contour is one of the arc for any `t`; where no value lies between those of the ends, or values are no numbers,
  /// the vertices of the chain are counted instead.
  ///
  /// \exception Parameter_error if `t` is not greater than 0 and less than 1
  /// \exception Unknown_arc_error if `arc` is not an arc of the graph
  Contour contour(arc_descriptor arc, double t) const { return contours().at_parameter(arc, t); }

  /// \brief returns the contour of an arc at a place between its ends, parametrized by another field.
  ///
  /// The absolute differences of the values of `parametrization` along the chain of the arc are added up: `t` is the
  /// fraction of the whole sum. With a field of unit gradient and the same level sets, equal steps of `t` are equal
  /// distances on the surface. If the sum is 0, the result is the same as without `parametrization`. It takes time
  /// linear in the length of the chain as well.
  ///
  /// \tparam ParametrizationMap a model of `ReadablePropertyMap` with the vertices as key type, and a value type that
  ///         can be converted to `double`
  ///
  /// \exception Parameter_error if `t` is not greater than 0 and less than 1
  /// \exception Unknown_arc_error if `arc` is not an arc of the graph
  /// \exception Non_finite_scalar_error if a value along the chain is infinite or NaN
  template <class ParametrizationMap>
  Contour contour(arc_descriptor arc, double t, ParametrizationMap parametrization) const
  {
    return contours().at_parameter(arc, t, parametrization);
  }

  /// \brief returns the contour of an arc at the level just above the last vertex of value at most `value`.
  ///
  /// \exception Level_error if the arc has no contour at that level: its lower node must not be higher, and its upper
  ///            node must be higher than `value`
  /// \exception Unknown_arc_error if `arc` is not an arc of the graph
  Contour contour_at_value(arc_descriptor arc, const Scalar& value) const { return contours().at_value(arc, value); }

  /// \brief returns the contour of an arc at the level just below a vertex, which the contour need not be near. Just
  /// below the upper node of the arc, it is one of the critical set of that.
  ///
  /// \exception Level_error if the arc has no contour at that level: its lower node must be lower than `v`, and its
  ///            upper node must not be; if ties are contracted, in value
  /// \exception Unknown_arc_error if `arc` is not an arc of the graph
  /// \exception Unknown_vertex_error if there is no vertex `v`
  Contour contour_below(arc_descriptor arc, vertex_descriptor v) const { return contours().below_vertex(arc, v); }

  /// \brief returns the contour of an arc at the level just above a vertex, which the contour need not be near. Just
  /// above the lower node of the arc, it is one of the critical set of that.
  ///
  /// \exception Level_error if the arc has no contour at that level: its lower node must not be higher than `v`, and
  ///            its upper node must be; if ties are contracted, in value
  /// \exception Unknown_arc_error if `arc` is not an arc of the graph
  /// \exception Unknown_vertex_error if there is no vertex `v`
  Contour contour_above(arc_descriptor arc, vertex_descriptor v) const { return contours().above_vertex(arc, v); }

  /// \brief returns the contours of all arcs at the level just above the last vertex of value at most `value`: all
  /// connected components of a level set, in the order of the arcs. It takes time linear in the arcs of the graph, and
  /// for each contour that of `contour()`.
  ///
  /// \tparam ConcurrencyTag `Sequential_tag`, `Parallel_tag`, or `Parallel_if_available_tag`: whether the contours are
  ///         traced in parallel
  template <class ConcurrencyTag = Sequential_tag>
  std::vector<Contour> contours_at_value(const Scalar& value) const
  {
    return contours().template all_at_value<ConcurrencyTag>(value);
  }

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
    const auto point_map = internal::choose_point_map(mesh(), np);
    for(const halfedge_descriptor h : contour.halfedges)
      *points++ = internal::point_between(get(point_map, source(h, mesh())), get(point_map, target(h, mesh())),
                                          internal::crossing_fraction(on_mesh(), h, contour.value));
    return points;
  }

  /// \brief returns what a node stands for: the contours just below and just above it that touch it, each with its
  /// arc, its star, and the border loop that it collapses. It takes the time of `contour()` for each of its arcs.
  ///
  /// \exception Unknown_node_error if `node` is not a node of the graph
  Critical_set critical_set(node_descriptor node) const
  {
    internal::check_is_node(graph(), node);
    return {contours().all_below_node(node), contours().all_above_node(node), on_mesh().star(node),
            on_mesh().border_loop(node)};
  }

  /// \brief finds the place of each vertex in the graph: the segmentation by the arcs.
  ///
  /// \tparam ConcurrencyTag `Sequential_tag`, `Parallel_tag`, or `Parallel_if_available_tag`
  /// \tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"
  ///
  /// \param np an optional sequence of \ref bgl_namedparameters "Named Parameters": `callback`, as for
  ///        `compute_reeb_graph()`
  ///
  /// \exception Graph_mismatch_error if the graph is not the one that has been computed of this input
  /// \exception Cancelled_error if `callback` returns `false`
  template <class ConcurrencyTag = Sequential_tag, class NamedParameters = parameters::Default_named_parameters>
  Vertex_locations locate_vertices(const NamedParameters& np = parameters::default_values()) const
  {
    return way_back_.template locate_vertices<ConcurrencyTag>(np);
  }

private:
  const Graph_on_mesh& on_mesh() const { return way_back_.on_complex(); }
  const auto& contours() const { return way_back_.contours(); }

  const internal::Way_back<Graph_on_mesh, internal::Surface_contour_tracer<Graph_on_mesh>> way_back_;
};

#ifndef DOXYGEN_RUNNING
template <class FaceListGraph, class ScalarMap, class ReebGraph, class NamedParameters>
Augmentation(const FaceListGraph&, ScalarMap, const ReebGraph&, const NamedParameters&)
  -> Augmentation<FaceListGraph,
                  ScalarMap,
                  ReebGraph,
                  internal::Chosen_traits<Reeb_graph_traits<FaceListGraph, ScalarMap>, NamedParameters>>;
#endif

} // namespace Reeb_graph
} // namespace CGAL

#endif // CGAL_REEB_GRAPH_AUGMENTATION_H
