// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_CONTOUR_H
#define CGAL_REEB_GRAPH_CONTOUR_H

#include <CGAL/license/Reeb_graph.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::Reeb_graph {

/// \addtogroup PkgReebGraphAugmentation
/// @{

/// \brief what all contours of arcs have: the edges that one connected component of a level set crosses, with one point
/// on each.
///
/// `Contour`, `Soup_contour` and `Isosurface_patch` derive from it. They differ in what is between the points, but all
/// are read by the same functions. Besides those below, each has `is_closed()`, which tells whether it is one closed
/// curve, or a surface without border.
///
/// A contour has either lines or triangles, or is a single point: a polyline without a line. Where its points are,
/// `fraction()` and `points_of_contour()` of the augmentation know.
///
/// \tparam ArcDescriptor an edge descriptor of the Reeb graph
/// \tparam Edge_ a halfedge descriptor of the mesh; for a complex, the pair of the numbers of two vertices
template <class ArcDescriptor, class Edge_>
struct Crossed_edges
{
  /// an edge, which leads from its lower to its higher vertex
  typedef Edge_ Edge;

  /// the arc that the contour belongs to
  ArcDescriptor arc;

  /// the value of the level. For a level that only the order of equal values tells apart, it is their value; for one
  /// just below a node, that of the node. It is NaN if the values of the field are not numbers.
  double value = 0;

  /// the crossed edges: point number `i` of the contour is on edge number `i`
  std::vector<Edge> edges;

  /// returns the number of crossed edges, and of points.
  std::size_t number_of_crossings() const { return edges.size(); }

  /// returns the edge that point number `i` is on.
  const Edge& edge(std::size_t i) const { return edges[i]; }

  /// calls `visit(i, j)` for each line, from point number `i` to point number `j`.
  template <class Visit>
  void for_each_line(const Visit&) const
  {}

  /// calls `visit(numbers)` for each polyline, with a vector of the numbers of its points: all lines in few pieces. The
  /// last point of a closed one is the first one again.
  template <class Visit>
  void for_each_polyline(const Visit&) const
  {}

  /// calls `visit(i, j, k)` for each triangle, with the numbers of its points.
  template <class Visit>
  void for_each_triangle(const Visit&) const
  {}
};

/// \brief a contour of an arc on a mesh: a curve, closed or from border to border.
///
/// It has one ascending halfedge for each crossed edge, in the order in which the edges follow each other. The higher
/// side is on the left, the side to which the halfedges point.
///
/// \tparam ArcDescriptor an edge descriptor of the Reeb graph
/// \tparam HalfedgeDescriptor a halfedge descriptor of the mesh
template <class ArcDescriptor, class HalfedgeDescriptor>
struct Contour : Crossed_edges<ArcDescriptor, HalfedgeDescriptor>
{
  /// `true` if the last edge is followed by the first one, `false` if the contour leads from border to border
  bool is_cyclic = false;

#ifndef DOXYGEN_RUNNING
  bool is_closed() const { return is_cyclic; }

  template <class Visit>
  void for_each_line(const Visit& visit) const
  {
    const std::size_t size = this->edges.size();
    for(std::size_t i = 0; i + (is_cyclic ? 0 : 1) < size; ++i)
      visit(i, i + 1 == size ? 0 : i + 1);
  }

  template <class Visit>
  void for_each_polyline(const Visit& visit) const
  {
    std::vector<std::size_t> numbers = {0};
    for_each_line([&](std::size_t, std::size_t i) { numbers.push_back(i); });
    visit(numbers);
  }
#endif
};

/// \brief a contour of an arc in a triangle soup: a graph whose points are on edges of the soup, and whose lines are in
/// its triangles.
///
/// A point on an edge with two triangles has two neighbors, one on a border edge has one, and one on an edge with more
/// triangles is a branch point. A point on an edge without triangles is a contour of its own. The first point is on the
/// chain of the arc.
///
/// \tparam ArcDescriptor an edge descriptor of the Reeb graph
template <class ArcDescriptor>
struct Soup_contour : Crossed_edges<ArcDescriptor, std::pair<std::size_t, std::size_t>>
{
  /// the lines as numbers of points. A polyline ends at branch points and at points of the border; if there are none,
  /// the contour is one closed curve. If the last number is the first one again, the polyline is closed. Each line
  /// between neighbors, thus each crossed triangle, is in one polyline. A single point is a polyline, too.
  std::vector<std::vector<std::size_t>> polylines;

  /// the numbers of the points at which three or more lines meet, ascending
  std::vector<std::size_t> branch_points;

#ifndef DOXYGEN_RUNNING
  bool is_closed() const
  {
    return polylines.size() == 1 && polylines[0].size() > 1 && polylines[0].front() == polylines[0].back();
  }

  template <class Visit>
  void for_each_line(const Visit& visit) const
  {
    for(const std::vector<std::size_t>& polyline : polylines)
      for(std::size_t i = 1; i < polyline.size(); ++i)
        visit(polyline[i - 1], polyline[i]);
  }

  template <class Visit>
  void for_each_polyline(const Visit& visit) const
  {
    std::for_each(polylines.begin(), polylines.end(), visit);
  }
#endif
};

/// \brief a contour of an arc in a tetrahedral mesh: a component of an isosurface, triangulated.
///
/// Each crossed tetrahedron holds one triangle, or two. Where the tetrahedra are a 3-manifold, the triangles are a
/// 2-manifold, whose border is on that of the tetrahedra; if it is orientable, the triangles are oriented alike. Higher
/// values are on the side from which their points appear counterclockwise. The first point is on the chain of the arc.
///
/// \tparam ArcDescriptor an edge descriptor of the Reeb graph
template <class ArcDescriptor>
struct Isosurface_patch : Crossed_edges<ArcDescriptor, std::pair<std::size_t, std::size_t>>
{
  /// the triangles, each of three numbers of points
  std::vector<std::array<std::size_t, 3>> triangles;

#ifndef DOXYGEN_RUNNING
  bool is_closed() const
  {
    std::vector<std::pair<std::size_t, std::size_t>> sides;
    for(const auto& [i, j, k] : triangles)
      sides.insert(sides.end(), {std::minmax({i, j}), std::minmax({j, k}), std::minmax({k, i})});
    std::sort(sides.begin(), sides.end());
    for(auto side = sides.begin(), next = side; side != sides.end(); side = next)
    {
      next = std::upper_bound(side, sides.end(), *side);
      if(next - side == 1)
        return false;
    }
    return !triangles.empty();
  }

  template <class Visit>
  void for_each_polyline(const Visit& visit) const
  {
    if(triangles.empty())
      visit(std::vector<std::size_t>{0});
  }

  template <class Visit>
  void for_each_triangle(const Visit& visit) const
  {
    for(const auto& [i, j, k] : triangles)
      visit(i, j, k);
  }
#endif
};

/// \brief what a node of the Reeb graph stands for.
///
/// \tparam Contour_ the type of the contours
/// \tparam HalfedgeDescriptor a halfedge descriptor of the mesh; for a complex, the pair of two vertices
/// \tparam Cell_ a face descriptor of the mesh; for a complex, the number of a triangle, or of a tetrahedron
template <class Contour_, class HalfedgeDescriptor, class Cell_>
struct Critical_set
{
  std::vector<Contour_> lower_contours; ///< for each arc below, its contour just below the node
  std::vector<Contour_> upper_contours; ///< for each arc above, its contour just above the node

  /// the faces at the vertex of the node, counterclockwise; in a complex, the triangles or tetrahedra there, ascending,
  /// and one that is listed several times as often
  std::vector<Cell_> star;

  /// on a mesh, the border halfedges of the border loop at the vertex of the node, if all vertices of the loop have the
  /// value of the node; else empty
  std::vector<HalfedgeDescriptor> border_loop;
};

/// @}

} // namespace CGAL::Reeb_graph

#endif // CGAL_REEB_GRAPH_CONTOUR_H
