// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of the CGAL-style package Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_TETRAHEDRA_AUGMENTATION_H
#define CGAL_REEB_GRAPH_TETRAHEDRA_AUGMENTATION_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/Complex_augmentation.h>
#include <CGAL/Reeb_graph/Soup_contour.h>
#include <CGAL/Reeb_graph/internal/augmentation/flatten_cells.h>
#include <CGAL/Reeb_graph/internal/base/named_parameter.h>
#include <CGAL/Reeb_graph/named_parameters.h>
#include <CGAL/Reeb_graph_soup_traits.h>

#include <boost/graph/graph_traits.hpp>

#include <iterator>

namespace CGAL {
namespace Reeb_graph {

/// \ingroup PkgReebGraphAugmentation
///
/// \brief the way from the Reeb graph of a tetrahedral mesh back to it.
///
/// A contour is a component of an isosurface, see `Isosurface_patch`. Which side of it is the higher one, the points
/// tell, if they are those of a three-dimensional kernel; tetrahedra of volume zero, and all if only the number of
/// vertices is given, are taken as positively oriented, as in \cgal: the last vertex is on the side from which the
/// others appear counterclockwise. Where tetrahedra contradict their neighbors, the triangles are oriented as most of
/// them are.
///
/// \tparam Scalar the type of the scalar values. It is deduced by
///         `Tetrahedra_augmentation augmentation(points, tetrahedra, scalars, graph, np)`, as the other types are.
/// \tparam ReebGraph the type `Graph` of the traits class
/// \tparam Traits the traits class: the type of the named parameter `geom_traits`, if that is given
template <class Scalar,
          class ReebGraph = typename Reeb_graph_soup_traits<Scalar>::Graph,
          class Traits = Reeb_graph_soup_traits<Scalar>>
class Tetrahedra_augmentation
#ifdef DOXYGEN_RUNNING
  : public Complex_augmentation<Isosurface_patch<arc_descriptor>, ReebGraph, Traits>
#else
  : public Complex_augmentation<Isosurface_patch<typename boost::graph_traits<ReebGraph>::edge_descriptor>,
                                ReebGraph,
                                Traits>
#endif
{
  typedef Complex_augmentation<Isosurface_patch<typename boost::graph_traits<ReebGraph>::edge_descriptor>,
                               ReebGraph,
                               Traits>
    Base;

public:
  /// \brief prepares the way back from `graph` to the tetrahedra, which may go away afterwards, as the scalars may.
  ///
  /// \param points a random access range of the points of the vertices, or their number
  /// \param tetrahedra the tetrahedra that the graph has been computed of
  /// \param scalars the values that it has been computed of
  /// \param graph the graph
  /// \param np the named parameters that the graph has been computed with: `ties`, `keep_degree_two_nodes`, `edges` and
  ///        `geom_traits` count; and for a graph made by `simplify()`, what that has returned, as named parameter
  ///        `simplification`, if vertices are to be located
  ///
  /// \exception Graph_mismatch_error if a node is not a vertex with its value, or an arc none that `ties` gives. That
  ///            all nodes and arcs are there is checked by `locate_vertices()` only.
  ///
  /// and the exceptions of `compute_reeb_graph_of_tetrahedra()`.
  template <class PointsOrNumber,
            class Tetrahedra,
            class Scalars,
            class NamedParameters = parameters::Default_named_parameters>
  Tetrahedra_augmentation(const PointsOrNumber& points,
                          const Tetrahedra& tetrahedra,
                          const Scalars& scalars,
                          const ReebGraph& graph,
                          const NamedParameters& np = parameters::default_values())
    : Base(internal::flatten_tetrahedra(points, tetrahedra, scalars, internal::choose_traits<Traits>(np), np),
           points,
           tetrahedra,
           graph,
           np)
  {}

#ifndef DOXYGEN_RUNNING
  // The graph is not copied.
  template <class PointsOrNumber,
            class Tetrahedra,
            class Scalars,
            class NamedParameters = parameters::Default_named_parameters>
  Tetrahedra_augmentation(const PointsOrNumber&,
                          const Tetrahedra&,
                          const Scalars&,
                          const ReebGraph&&,
                          const NamedParameters& = parameters::default_values()) = delete;
#endif
};

#ifndef DOXYGEN_RUNNING
template <class PointsOrNumber,
          class Tetrahedra,
          class Scalars,
          class ReebGraph,
          class NamedParameters = parameters::Default_named_parameters>
Tetrahedra_augmentation(const PointsOrNumber&,
                        const Tetrahedra&,
                        const Scalars&,
                        const ReebGraph&,
                        const NamedParameters& = parameters::default_values())
  -> Tetrahedra_augmentation<
    internal::Value_of_range<Scalars>,
    ReebGraph,
    internal::Chosen_traits<Reeb_graph_soup_traits<internal::Value_of_range<Scalars>>, NamedParameters>>;
#endif

} // namespace Reeb_graph
} // namespace CGAL

#endif // CGAL_REEB_GRAPH_TETRAHEDRA_AUGMENTATION_H
