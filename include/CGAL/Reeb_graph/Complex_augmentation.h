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
#include <CGAL/Reeb_graph/exceptions.h>
#include <CGAL/Reeb_graph/internal/augmentation/Arc_contours.h>
#include <CGAL/Reeb_graph/internal/augmentation/Graph_on_soup.h>
#include <CGAL/Reeb_graph/internal/augmentation/New_places.h>
#include <CGAL/Reeb_graph/internal/augmentation/check_graph.h>
#include <CGAL/Reeb_graph/internal/augmentation/complex_contour_tracers.h>
#include <CGAL/Reeb_graph/internal/augmentation/locate_vertices.h>
#include <CGAL/Reeb_graph/internal/base/Progress.h>
#include <CGAL/Reeb_graph/internal/base/named_parameter.h>
#include <CGAL/Reeb_graph/named_parameters.h>
#include <CGAL/Reeb_graph/options.h>

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
/// \tparam Contour_ `Soup_contour` or `Isosurface_patch` with the edge descriptor of the graph
/// \tparam ReebGraph the type `Graph` of the traits class
/// \tparam Traits the traits class, see `Reeb_graph_soup_traits`
template <class Contour_, class ReebGraph, class Traits>
class Complex_augmentation
{
#ifndef DOXYGEN_RUNNING
  typedef internal::Graph_on_soup<ReebGraph, Traits> Graph_on_soup;
  typedef typename internal::Tracer_of<Contour_>::template type<Graph_on_soup> Tracer;
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
  typedef Contour_ Contour;
  /// a critical set
  typedef Soup_critical_set<Contour> Critical_set;
  /// the places of all vertices
  typedef Reeb_graph::Vertex_locations<vertex_descriptor, ReebGraph> Vertex_locations;

  /// returns the graph.
  const Graph& graph() const { return on_soup_.graph(); }

  /// returns the number of vertices of the complex.
  std::size_t number_of_vertices() const { return on_soup_.end_of_vertices(); }

  /// returns the value of the vertex `v` as that of a contour: as a `double`, NaN if the values of the field are no
  /// numbers.
  ///
  /// \exception Unknown_vertex_error if there is no such vertex
  double value(vertex_descriptor v) const { return on_soup_.value(internal::checked_number(on_soup_, v)); }

  /// \brief returns the contour of an arc at a place between its ends.
  ///
  /// The values along the arc are parametrized linearly, `t` = 0 at the lower node and `t` = 1 at the upper one. The
  /// contour is one of the arc for any `t`; where no value lies between those of the ends, or values are no numbers,
  /// the vertices of the chain are counted instead. It takes time linear in the triangles at the crossed edges, or in
  /// the tetrahedra at their lower vertices, and in the degrees of the ends of the arc and of the edge it starts from.
  ///
  /// \exception Parameter_error if `t` is not greater than 0 and less than 1
  /// \exception Unknown_arc_error if `arc` is not an arc of the graph
  Contour contour(arc_descriptor arc, double t) const { return contours_.at_parameter(arc, t); }

  /// \brief returns the contour of an arc at a place between its ends, parametrized by the sum of the absolute
  /// differences of another field along the chain of the arc, as by `Augmentation::contour()`.
  ///
  /// \tparam ParametrizationMap a model of `ReadablePropertyMap` with the numbers of vertices as key type, and a value
  ///         type that can be converted to `double`. Its time is linear in the length of the chain.
  ///
  /// \exception Parameter_error if `t` is not greater than 0 and less than 1
  /// \exception Unknown_arc_error if `arc` is not an arc of the graph
  /// \exception Non_finite_scalar_error if a value along the chain is infinite or NaN
  template <class ParametrizationMap>
  Contour contour(arc_descriptor arc, double t, ParametrizationMap parametrization) const
  {
    return contours_.at_parameter(arc, t, parametrization);
  }

  /// \brief returns the contour of an arc at the level just above the last vertex of value at most `value`.
  ///
  /// \exception Level_error if the arc has no contour at that level: its lower node must not be higher, and its upper
  ///            node must be higher than `value`
  /// \exception Unknown_arc_error if `arc` is not an arc of the graph
  Contour contour_at_value(arc_descriptor arc, const Scalar& value) const { return contours_.at_value(arc, value); }

  /// \brief returns the contour of an arc at the level just below a vertex, which the contour need not be near. Just
  /// below the upper node of the arc, it is one of the critical set of that.
  ///
  /// \exception Level_error if the arc has no contour at that level: its lower node must be lower than `v`, and its
  ///            upper node must not be; if ties are contracted, in value
  /// \exception Unknown_arc_error if `arc` is not an arc of the graph
  /// \exception Unknown_vertex_error if there is no vertex `v`
  Contour contour_below(arc_descriptor arc, vertex_descriptor v) const { return contours_.below_vertex(arc, v); }

  /// \brief returns the contour of an arc at the level just above a vertex, which the contour need not be near. Just
  /// above the lower node of the arc, it is one of the critical set of that.
  ///
  /// \exception Level_error if the arc has no contour at that level: its lower node must not be higher than `v`, and
  ///            its upper node must be; if ties are contracted, in value
  /// \exception Unknown_arc_error if `arc` is not an arc of the graph
  /// \exception Unknown_vertex_error if there is no vertex `v`
  Contour contour_above(arc_descriptor arc, vertex_descriptor v) const { return contours_.above_vertex(arc, v); }

  /// \brief returns the contours of all arcs at the level just above the last vertex of value at most `value`: all
  /// connected components of a level set, in the order of the arcs. No two of them have a point in common. It takes
  /// time linear in the arcs of the graph, and for each contour that of `contour()`, with the degree of the
  /// lower-numbered end of the edge it starts from.
  ///
  /// \tparam ConcurrencyTag `Sequential_tag`, `Parallel_tag`, or `Parallel_if_available_tag`: whether the contours are
  ///         traced in parallel
  template <class ConcurrencyTag = Sequential_tag>
  std::vector<Contour> contours_at_value(const Scalar& value) const
  {
    return contours_.template all_at_value<ConcurrencyTag>(value);
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
    for(std::size_t i = 0; i != contour.edges.size(); ++i)
    {
      const auto& lower = *(std::begin(vertex_points) + contour.edges[i].first);
      const auto& upper = *(std::begin(vertex_points) + contour.edges[i].second);
      *points++ = lower + contour.fractions[i] * (upper - lower);
    }
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
    return {contours_.all_below_node(node), contours_.all_above_node(node),
            cells_.at_vertex(on_soup_.node_vertex(node))};
  }

  /// \brief finds the place of each vertex of the complex in the graph: the segmentation by the arcs.
  ///
  /// It takes hardly longer than computing the graph again where arcs are long for the size of the cells; else the time
  /// of sorting all vertices and computing the graph with all of them: near-linear for any field. Where many contours
  /// meet few vertices, as in solids, the first is so for very smooth fields only.
  ///
  /// \tparam ConcurrencyTag `Sequential_tag`, `Parallel_tag`, or `Parallel_if_available_tag`
  /// \tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"
  ///
  /// \param np an optional sequence of \ref bgl_namedparameters "Named Parameters": `callback`, as for
  ///        `compute_reeb_graph()`
  ///
  /// \exception Graph_mismatch_error if the graph is not the one that has been computed of this complex and field
  /// \exception Cancelled_error if `callback` returns `false`
  template <class ConcurrencyTag = Sequential_tag, class NamedParameters = parameters::Default_named_parameters>
  Vertex_locations locate_vertices(const NamedParameters& np = parameters::default_values()) const
  {
    return internal::locate_vertices<ConcurrencyTag>(on_soup_, ties_, are_degree_two_nodes_kept_, new_places_,
                                                     internal::Progress(np));
  }

protected:
#ifndef DOXYGEN_RUNNING
  template <class Points, class Cells, class NamedParameters>
  Complex_augmentation(internal::Flat_soup<Scalar> soup,
                       const Points& points,
                       const Cells& cells,
                       const ReebGraph& graph,
                       const NamedParameters& np)
    : ties_(parameters::choose_parameter(parameters::get_parameter(np, internal::ties), Ties::PERTURB)),
      are_degree_two_nodes_kept_(
        parameters::choose_parameter(parameters::get_parameter(np, internal::keep_degree_two_nodes), false)),
      on_soup_(std::move(soup), graph, internal::choose_traits<Traits>(np)),
      cells_(on_soup_.end_of_vertices(), points, cells),
      contours_(on_soup_, ties_, cells_),
      new_places_(parameters::get_parameter(np, internal::simplification))
  {
    static_assert(std::is_same_v<internal::Chosen_traits<Traits, NamedParameters>, Traits>,
                  "The last template parameter must be the type of the named parameter geom_traits.");
    internal::check_nodes(on_soup_);
    internal::check_arcs(on_soup_, ties_);
  }
#endif

private:
  const Ties ties_;
  const bool are_degree_two_nodes_kept_;
  const Graph_on_soup on_soup_;
  const typename Tracer::Cells cells_;
  const internal::Arc_contours<Graph_on_soup, Tracer> contours_;
  const internal::New_places new_places_;
};

} // namespace Reeb_graph
} // namespace CGAL

#endif // CGAL_REEB_GRAPH_COMPLEX_AUGMENTATION_H
