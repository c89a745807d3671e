// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_COMPLEX_AUGMENTATION_H
#define CGAL_REEB_GRAPH_COMPLEX_AUGMENTATION_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/Augmentation.h>
#include <CGAL/Reeb_graph/internal/base/Progress.h>
#include <CGAL/Reeb_graph/internal/base/named_parameter.h>
#include <CGAL/Reeb_graph/internal/way_back/Graph_on_cells.h>
#include <CGAL/Reeb_graph/named_parameters.h>
#include <CGAL/Reeb_graph_soup_traits.h>

#include <cstddef>

namespace CGAL::Reeb_graph {
namespace internal {

// The traits class of a soup with these values: the type of the named parameter, if that is given.
template <class Scalars, class NamedParameters>
using Soup_traits_of = Chosen_traits<Reeb_graph_soup_traits<Value_of_range<Scalars>>, NamedParameters>;

} // namespace internal

/// \ingroup PkgReebGraphAugmentation
///
/// \brief what `Soup_augmentation` and `Tetrahedra_augmentation` have in common.
///
/// It holds a copy of the field and of the complex, so that only the graph has to outlive it.
///
/// The contour of an arc takes time linear in the triangles at the crossed edges, or in the tetrahedra at their lower
/// vertices. It also takes time linear in the degrees of the ends of the arc and of the edge it starts from. Locating
/// vertices takes hardly longer than computing the graph again if arcs are long for the size of the cells. In solids,
/// where many contours meet few vertices, this is so for very smooth fields only. Otherwise it takes the time of
/// sorting all vertices and computing the graph with all of them: near-linear for any field.
///
/// \tparam GraphOnCells unspecified: a graph with the triangles, or the tetrahedra, that it is of
template <class GraphOnCells>
class Complex_augmentation : public Basic_augmentation<GraphOnCells>
{
  typedef Basic_augmentation<GraphOnCells> Base;

public:
  using typename Base::Graph;

  /// \brief prepares the way back from `graph` to the cells, which may go away afterwards, as the scalars may.
  ///
  /// \param points a random access range of the points of the vertices, or their number
  /// \param cells the triangles, or the tetrahedra, that the graph has been computed of
  /// \param scalars the values that it has been computed of
  /// \param graph the graph
  /// \param np the named parameters that the graph has been computed with, of which `ties`, `keep_degree_two_nodes`,
  ///        `edges` and `geom_traits` count; and `callback`, as for `compute_reeb_graph()`. To locate vertices in a
  ///        graph made by `simplify()`, the named parameter `simplification` takes the result of that
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
                       const Graph& graph,
                       const NamedParameters& np = parameters::default_values())
    : Base(internal::Progress(np), np, points, cells, scalars, graph)
  {}

#ifndef DOXYGEN_RUNNING
  // The graph is not copied.
  template <class Points, class Cells, class Scalars, class... NamedParameters>
  Complex_augmentation(const Points&, const Cells&, const Scalars&, const Graph&&, const NamedParameters&...) = delete;
#endif

  /// returns the number of vertices of the complex.
  std::size_t number_of_vertices() const { return this->on_mesh().end_of_vertices(); }
};

/// \ingroup PkgReebGraphAugmentation
///
/// \brief the way from the Reeb graph of a triangle soup back to it.
///
/// A contour is a graph in the triangles, see `Soup_contour`: on a surface a curve, elsewhere curves that meet where an
/// edge has more than two triangles.
///
/// It is constructed as `Complex_augmentation` is, from the points, the triangles, the scalars, the graph, and named
/// parameters.
///
/// \tparam Scalar the type of the scalar values. It is deduced by
///         `Soup_augmentation augmentation(points, triangles, scalars, graph, np)`, as the other types are.
/// \tparam ReebGraph the type `Graph` of the traits class
/// \tparam Traits the traits class: the type of the named parameter `geom_traits`, if that is given
template <class Scalar,
          class ReebGraph = typename Reeb_graph_soup_traits<Scalar>::Graph,
          class Traits = Reeb_graph_soup_traits<Scalar>>
class Soup_augmentation
  : public Complex_augmentation<internal::Graph_on_cells<ReebGraph, Traits, internal::Triangle_cells>>
{
public:
  using Soup_augmentation::Complex_augmentation::Complex_augmentation;
};

#ifndef DOXYGEN_RUNNING
template <class Points, class Cells, class Scalars, class Graph, class NP = parameters::Default_named_parameters>
Soup_augmentation(const Points&, const Cells&, const Scalars&, const Graph&, const NP& = parameters::default_values())
  -> Soup_augmentation<internal::Value_of_range<Scalars>, Graph, internal::Soup_traits_of<Scalars, NP>>;
#endif

/// \ingroup PkgReebGraphAugmentation
///
/// \brief the way from the Reeb graph of a tetrahedral mesh back to it.
///
/// A contour is a component of an isosurface, see `Isosurface_patch`. Points of a three-dimensional kernel tell which
/// side of it is the higher one. Tetrahedra of volume zero, and all if only the number of vertices is given, are taken
/// as positively oriented, as in \cgal: the last vertex is on the side from which the others appear counterclockwise.
/// Where tetrahedra contradict their neighbors, the triangles are oriented as most of them are.
///
/// It is constructed as `Complex_augmentation` is, from the points, the tetrahedra, the scalars, the graph, and named
/// parameters.
///
/// \tparam Scalar the type of the scalar values. It is deduced by
///         `Tetrahedra_augmentation augmentation(points, tetrahedra, scalars, graph, np)`, as the other types are.
/// \tparam ReebGraph the type `Graph` of the traits class
/// \tparam Traits the traits class: the type of the named parameter `geom_traits`, if that is given
template <class Scalar,
          class ReebGraph = typename Reeb_graph_soup_traits<Scalar>::Graph,
          class Traits = Reeb_graph_soup_traits<Scalar>>
class Tetrahedra_augmentation
  : public Complex_augmentation<internal::Graph_on_cells<ReebGraph, Traits, internal::Tetrahedron_cells>>
{
public:
  using Tetrahedra_augmentation::Complex_augmentation::Complex_augmentation;
};

#ifndef DOXYGEN_RUNNING
template <class Points, class Cells, class Scalars, class Graph, class NP = parameters::Default_named_parameters>
Tetrahedra_augmentation(const Points&,
                        const Cells&,
                        const Scalars&,
                        const Graph&,
                        const NP& = parameters::default_values())
  -> Tetrahedra_augmentation<internal::Value_of_range<Scalars>, Graph, internal::Soup_traits_of<Scalars, NP>>;
#endif

} // namespace CGAL::Reeb_graph

#endif // CGAL_REEB_GRAPH_COMPLEX_AUGMENTATION_H
