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

#include <vector>

namespace CGAL::Reeb_graph {

/// \addtogroup PkgReebGraphAugmentation
/// @{

/// \brief a contour of an arc: the edges that one connected component of a level set crosses.
///
/// \tparam ArcDescriptor an edge descriptor of the Reeb graph
/// \tparam HalfedgeDescriptor a halfedge descriptor of the mesh
template <class ArcDescriptor, class HalfedgeDescriptor>
struct Contour
{
  /// the arc that the contour belongs to
  ArcDescriptor arc;

  /// the value of the level. For a level that only the order of equal values tells apart, it is their value; for one
  /// just below a node, that of the node. It is NaN if the values of the field are not numbers.
  double value = 0;

  /// `true` if the contour is a closed curve, `false` if it leads from border to border
  bool is_closed = false;

  /// one ascending halfedge for each crossed edge, in the order in which the edges follow each other; the higher side
  /// is on the left, the side to which the halfedges point
  std::vector<HalfedgeDescriptor> halfedges;
};

/// \brief what a node of the Reeb graph stands for.
///
/// \tparam Contour_ a `Contour`
/// \tparam HalfedgeDescriptor a halfedge descriptor of the mesh
/// \tparam FaceDescriptor a face descriptor of the mesh
template <class Contour_, class HalfedgeDescriptor, class FaceDescriptor>
struct Critical_set
{
  std::vector<Contour_> lower_contours; ///< for each arc below, its contour just below the node
  std::vector<Contour_> upper_contours; ///< for each arc above, its contour just above the node
  std::vector<FaceDescriptor> star;     ///< the faces at the vertex of the node, counterclockwise

  /// the border halfedges of the border loop at the vertex of the node, if all vertices of the loop have the value of
  /// the node; else empty
  std::vector<HalfedgeDescriptor> border_loop;
};

/// @}

} // namespace CGAL::Reeb_graph

#endif // CGAL_REEB_GRAPH_CONTOUR_H
