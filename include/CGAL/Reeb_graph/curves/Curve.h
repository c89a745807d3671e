// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of the CGAL-style package Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_CURVES_CURVE_H
#define CGAL_REEB_GRAPH_CURVES_CURVE_H

#include <CGAL/license/Reeb_graph.h>

#include <vector>

namespace CGAL::Reeb_graph {

/// \ingroup PkgReebGraphCurves
///
/// \brief a contour that has become a path of mesh edges: what `cut_along_contours()` and the functions that use it
/// write.
///
/// \tparam HalfedgeDescriptor a halfedge descriptor of the mesh
template <class HalfedgeDescriptor>
struct Curve
{
  /// consecutive halfedges of the refined mesh: each starts where the one before ends. The higher side is on the left.
  std::vector<HalfedgeDescriptor> halfedges;

  /// if the mesh has been cut open: for each halfedge the one that it has been parted from, with the lower side on its
  /// left, so that it leads the opposite way. Else the opposite halfedges.
  std::vector<HalfedgeDescriptor> lower_halfedges;

  /// `true` if the curve is closed, `false` if it leads from border to border
  bool is_closed = false;

  /// the value of the scalar field along the curve
  double value = 0;

  /// the length of the curve
  double length = 0;
};

/// \ingroup PkgReebGraphCurves
///
/// \brief a place where a curve can be: what the function object `parameters::curve_cost()` is called with.
struct Candidate_curve
{
  /// the length of the contour
  double length = 0;

  /// the value of the scalar field along the contour
  double value = 0;

  /// the place of the contour between the ends of what it can be moved along, 0 at the one end and 1 at the other,
  /// measured by the number of edges of the chains. For a branch, 0 is where it is attached and 1 is its tip. Else the
  /// direction is not specified.
  double position = 0;
};

} // namespace CGAL::Reeb_graph

#endif // CGAL_REEB_GRAPH_CURVES_CURVE_H
