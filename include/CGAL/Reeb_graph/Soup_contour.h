// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_SOUP_CONTOUR_H
#define CGAL_REEB_GRAPH_SOUP_CONTOUR_H

#include <CGAL/license/Reeb_graph.h>

#include <array>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::Reeb_graph {

/// \addtogroup PkgReebGraphAugmentation
/// @{

/// \brief the points of a contour of an arc in a complex: one on each edge that the contour crosses.
///
/// \tparam ArcDescriptor an edge descriptor of the Reeb graph
template <class ArcDescriptor>
struct Crossed_edges
{
  /// an edge of the complex, from its lower to its higher vertex
  typedef std::pair<std::size_t, std::size_t> Edge;

  /// the arc that the contour belongs to
  ArcDescriptor arc;

  /// the value of the level. For a level that only the order of equal values tells apart, it is their value; for one
  /// just below a node, that of the node. It is NaN if the values of the field are not numbers.
  double value = 0;

  /// the crossed edges: point number `i` of the contour is on `edges[i]`. The first one is on the chain of the arc.
  std::vector<Edge> edges;

  /// where on its edge each point is, by linear interpolation: 0 at the lower vertex, 1 at the higher one
  std::vector<double> fractions;
};

/// \brief a contour of an arc in a triangle soup: a graph whose points are on edges of the soup, and whose lines are in
/// its triangles.
///
/// A point on an edge with two triangles has two neighbors, one on a border edge has one, and one on an edge with more
/// triangles is a branch point. A point on an edge without triangles is a contour of its own, without polylines.
///
/// \tparam ArcDescriptor an edge descriptor of the Reeb graph
template <class ArcDescriptor>
struct Soup_contour : Crossed_edges<ArcDescriptor>
{
  /// the lines as numbers of points. A polyline ends at branch points and at points of the border; if there are none,
  /// the contour is one closed curve. If the last number is the first one again, the polyline is closed. Each line
  /// between neighbors, thus each crossed triangle, is in one polyline.
  std::vector<std::vector<std::size_t>> polylines;

  /// the numbers of the points at which three or more lines meet, ascending
  std::vector<std::size_t> branch_points;
};

/// \brief a contour of an arc in a tetrahedral mesh: a component of an isosurface, triangulated.
///
/// Each crossed tetrahedron holds one triangle, or two. Where the tetrahedra are a 3-manifold, the triangles are a
/// 2-manifold, whose border is on that of the tetrahedra; if it is orientable, the triangles are oriented alike. Higher
/// values are on the side from which their points appear counterclockwise.
///
/// \tparam ArcDescriptor an edge descriptor of the Reeb graph
template <class ArcDescriptor>
struct Isosurface_patch : Crossed_edges<ArcDescriptor>
{
  /// the triangles, each of three numbers of points
  std::vector<std::array<std::size_t, 3>> triangles;
};

/// \brief what a node of the Reeb graph of a complex stands for.
///
/// \tparam Contour_ a `Soup_contour` or an `Isosurface_patch`
template <class Contour_>
struct Soup_critical_set
{
  std::vector<Contour_> lower_contours; ///< for each arc below, its contour just below the node
  std::vector<Contour_> upper_contours; ///< for each arc above, its contour just above the node

  /// the numbers of the triangles, or tetrahedra, at the vertex of the node, ascending. One that is listed several
  /// times is there as often.
  std::vector<std::size_t> star;
};

/// @}

} // namespace CGAL::Reeb_graph

#endif // CGAL_REEB_GRAPH_SOUP_CONTOUR_H
