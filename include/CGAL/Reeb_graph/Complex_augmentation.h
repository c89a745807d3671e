// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of the CGAL-style package Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_COMPLEX_AUGMENTATION_H
#define CGAL_REEB_GRAPH_COMPLEX_AUGMENTATION_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/Soup_contour.h>
#include <CGAL/Reeb_graph/Vertex_locations.h>
#include <CGAL/Reeb_graph/internal/augmentation/Graph_on_soup.h>
#include <CGAL/Reeb_graph/internal/augmentation/Way_back.h>
#include <CGAL/Reeb_graph/internal/augmentation/complex_contour_tracers.h>
#include <CGAL/Reeb_graph/internal/augmentation/flatten_cells.h>
#include <CGAL/Reeb_graph/internal/base/Progress.h>
#include <CGAL/Reeb_graph/internal/base/crossing_fraction.h>
#include <CGAL/Reeb_graph/internal/base/named_parameter.h>
#include <CGAL/Reeb_graph/named_parameters.h>

#include <boost/graph/graph_traits.hpp>

#include <cstddef>
#include <iterator>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Reeb_graph {

/// \ingroup PkgReebGraphAugmentation
///
/// \brief what `Soup_augmentation` and `Tetrahedra_augmentation` have in common: the way from a Reeb graph back to a
/// complex, in the manner of `Augmentation`.
///
/// It holds a copy of the field and of the complex, so that only the graph has to outlive it, and must not change. It
/// can be neither copied nor moved. All member functions can be called from several threads at a time; those that
/// return contours throw `Graph_mismatch_error` if the chain of an arc does not lead to them.
///
/// The contour of an arc takes time linear in the triangles at the crossed edges, or in the tetrahedra at their lower
/// vertices, and in the degrees of the ends of the arc and of the edge it starts from. To locate vertices takes hardly
/// longer than computing the graph again where arcs are long for the size of the cells; else the time of sorting all
/// vertices and computing the graph with all of them: near-linear for any field. Where many contours meet few vertices,
/// as in solids, the first is so for very smooth fields only.
///
/// \tparam ContourOfArc `Soup_contour` or `Isosurface_patch`
/// \tparam ReebGraph the type `Graph` of the traits class
/// \tparam Traits the traits class, see `Reeb_graph_soup_traits`
template <template <class> class ContourOfArc, class ReebGraph, class Traits>
class Complex_augmentation
{
#ifndef DOXYGEN_RUNNING
  typedef internal::Graph_on_soup<ReebGraph, Traits> Graph_on_soup;
  typedef typename internal::Tracer_of<ContourOfArc>::template type<Graph_on_soup> Tracer;
#endif

public:
  /// the graph
  typedef ReebGraph Graph;
  /// a scalar value
  typedef typename Traits::Scalar Scalar;
  /// a vertex of the complex, by its number
  typedef std::size_t vertex_descriptor;
  /// an edge of the complex, from its lower to its higher vertex
  typedef std::pair<std::size_t, std::size_t> halfedge_descriptor;
  /// a node of the graph
  typedef typename boost::graph_traits<ReebGraph>::vertex_descriptor node_descriptor;
  /// an arc of the graph
  typedef typename boost::graph_traits<ReebGraph>::edge_descriptor arc_descriptor;

  /// a contour
  typedef ContourOfArc<arc_descriptor> Contour;
  /// a critical set
  typedef Soup_critical_set<Contour> Critical_set;
  /// the places of all vertices
  typedef Reeb_graph::Vertex_locations<vertex_descriptor, ReebGraph> Vertex_locations;

  /// \brief prepares the way back from `graph` to the cells, which may go away afterwards, as the scalars may.
  ///
  /// \param points a random access range of the points of the vertices, or their number
  /// \param cells the triangles, or the tetrahedra, that the graph has been computed of
  /// \param scalars the values that it has been computed of
  /// \param graph the graph
  /// \param np the named parameters that the graph has been computed with: `ties`, `keep_degree_two_nodes`, `edges` and
  ///        `geom_traits` count; and for a graph made by `simplify()`, what that has returned, as named parameter
  ///        `simplification`, if vertices are to be located
  ///
  /// \exception Graph_mismatch_error if a node is not a vertex with its value, or an arc none that `ties` gives. That
  ///            all nodes and arcs are there is checked by `locate_vertices()` only.
  ///
  /// and the exceptions of `compute_reeb_graph_of_soup()`, or of `compute_reeb_graph_of_tetrahedra()`.
  template <class PointsOrNumber,
            class Cells,
            class Scalars,
            class NamedParameters = parameters::Default_named_parameters>
  Complex_augmentation(const PointsOrNumber& points,
                       const Cells& cells,
                       const Scalars& scalars,
                       const ReebGraph& graph,
                       const NamedParameters& np = parameters::default_values())
    : Complex_augmentation(points,
                           cells,
                           graph,
                           np,
                           internal::flatten_cells<Tracer::vertices_per_cell>(points,
                                                                              cells,
                                                                              scalars,
                                                                              internal::choose_traits<Traits>(np),
                                                                              np))
  {
    static_assert(std::is_same_v<internal::Chosen_traits<Traits, NamedParameters>, Traits>,
                  "The last template parameter must be the type of the named parameter geom_traits.");
  }

#ifndef DOXYGEN_RUNNING
  // The graph is not copied.
  template <class PointsOrNumber,
            class Cells,
            class Scalars,
            class NamedParameters = parameters::Default_named_parameters>
  Complex_augmentation(const PointsOrNumber&,
                       const Cells&,
                       const Scalars&,
                       const ReebGraph&&,
                       const NamedParameters& = parameters::default_values()) = delete;
#endif

  /// \copydoc CGAL::Reeb_graph::Augmentation::graph()
  const Graph& graph() const { return way_back_.on_complex().graph(); }

  /// returns the number of vertices of the complex.
  std::size_t number_of_vertices() const { return way_back_.on_complex().end_of_vertices(); }

  /// \copydoc CGAL::Reeb_graph::Augmentation::value()
  double value(vertex_descriptor v) const { return way_back_.value(v); }

  /// \brief returns the contour of an arc at a place between its ends, as `Augmentation::contour()` does.
  ///
  /// \exception Parameter_error if `t` is not greater than 0 and less than 1
  /// \exception Unknown_arc_error if `arc` is not an arc of the graph
  Contour contour(arc_descriptor arc, double t) const { return contours().at_parameter(arc, t); }

  /// \brief returns the contour of an arc at a place between its ends, parametrized by another field, as
  /// `Augmentation::contour()` does.
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

  /// \copydoc CGAL::Reeb_graph::Augmentation::contour_at_value()
  Contour contour_at_value(arc_descriptor arc, const Scalar& value) const { return contours().at_value(arc, value); }

  /// \copydoc CGAL::Reeb_graph::Augmentation::contour_below()
  Contour contour_below(arc_descriptor arc, vertex_descriptor v) const { return contours().below_vertex(arc, v); }

  /// \copydoc CGAL::Reeb_graph::Augmentation::contour_above()
  Contour contour_above(arc_descriptor arc, vertex_descriptor v) const { return contours().above_vertex(arc, v); }

  /// \copydoc CGAL::Reeb_graph::Augmentation::contours_at_value()
  template <class ConcurrencyTag = Sequential_tag>
  std::vector<Contour> contours_at_value(const Scalar& value) const
  {
    return contours().template all_at_value<ConcurrencyTag>(value);
  }

  /// \brief writes the points of a contour, by linear interpolation, in the order of its `edges`.
  ///
  /// \tparam OutputIterator a model of `OutputIterator` for points
  /// \tparam PointRange a model of `RandomAccessContainer` of points
  ///
  /// \param contour a contour
  /// \param points the output
  /// \param vertex_points the points of the vertices
  ///
  /// \returns the output iterator behind the last point.
  template <class OutputIterator, class PointRange>
  static OutputIterator points_of_contour(const Contour& contour,
                                          OutputIterator points,
                                          const PointRange& vertex_points)
  {
    const auto point_of = [&](std::size_t v) -> decltype(auto) { return *(std::begin(vertex_points) + v); };
    for(std::size_t i = 0; i != contour.edges.size(); ++i)
      *points++ = internal::point_of_crossing(contour, i, point_of);
    return points;
  }

  /// \brief returns what a node stands for: the contours just below and just above it that touch it, each with its
  /// arc, and its star. It takes the time of `contour()` for each of its arcs, so the degree of the node can count once
  /// for each of them.
  ///
  /// \exception Unknown_node_error if `node` is not a node of the graph
  Critical_set critical_set(node_descriptor node) const
  {
    internal::check_is_node(graph(), node);
    return {contours().all_below_node(node), contours().all_above_node(node),
            cells_.at_vertex(way_back_.on_complex().node_vertex(node))};
  }

  /// \copydoc CGAL::Reeb_graph::Augmentation::locate_vertices()
  template <class ConcurrencyTag = Sequential_tag, class NamedParameters = parameters::Default_named_parameters>
  Vertex_locations locate_vertices(const NamedParameters& np = parameters::default_values()) const
  {
    return way_back_.template locate_vertices<ConcurrencyTag>(np);
  }

private:
  template <class Points, class Cells, class NamedParameters>
  Complex_augmentation(const Points& points,
                       const Cells& cells,
                       const ReebGraph& graph,
                       const NamedParameters& np,
                       internal::Flat_soup<Scalar> soup)
    : cells_(soup.field.vertices.size(), points, cells),
      way_back_(
        np,
        internal::Progress(parameters::default_values()),
        [&](const auto&) { return Graph_on_soup(std::move(soup), graph, internal::choose_traits<Traits>(np)); },
        cells_)
  {}

  const auto& contours() const { return way_back_.contours(); }

  const typename Tracer::Cells cells_;
  const internal::Way_back<Graph_on_soup, Tracer> way_back_;
};

} // namespace Reeb_graph
} // namespace CGAL

#endif // CGAL_REEB_GRAPH_COMPLEX_AUGMENTATION_H
