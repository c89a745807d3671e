// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_FIELDS_FIELD_REPORT_H
#define CGAL_REEB_GRAPH_FIELDS_FIELD_REPORT_H

#include <CGAL/license/Reeb_graph.h>

#include <cstddef>

namespace CGAL::Reeb_graph {

/// \ingroup PkgReebGraphFields
///
/// \brief what a scalar field took, mainly on bad triangles: the functions that compute one return it.
///
/// A face is bad if it has no area, or so little that its angles are beyond the range of numbers. If there is one, the
/// geometry is that of edges which are all longer by the same length, the least one that makes every triangle proper.
/// Proper means that any two of its sides are together longer than the third one, by at least a millionth of the mean
/// length of the edges, and 10<sup>-12</sup> of the longest edge. See \cgalCite{sc-lntm-20}, Section 4.5: intrinsic
/// mollification. If there is none, nothing is added, and nothing changes.
struct Field_report
{
  /// the number of bad faces
  std::size_t number_of_bad_faces = 0;
  /// the length that each edge is longer by, in the unit of the points; zero if nothing is added. It is also added if
  /// there are no bad faces, but the equations have no finite solution in floating-point numbers without it.
  double added_length = 0;
  /// the mean length of the edges before, in the unit of the points; zero if nothing is added
  double mean_length = 0;
  /// for harmonic, Poisson and unit gradient fields: the number of steps of the iteration that solves large systems of
  /// equations; zero if the equations were solved directly
  std::size_t number_of_iterations = 0;
};

} // namespace CGAL::Reeb_graph

#endif // CGAL_REEB_GRAPH_FIELDS_FIELD_REPORT_H
