// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_CURVES_LEVEL_CUT_REPORT_H
#define CGAL_REEB_GRAPH_CURVES_LEVEL_CUT_REPORT_H

#include <CGAL/license/Reeb_graph.h>

#include <cstddef>

namespace CGAL::Reeb_graph {

/// \ingroup PkgReebGraphCurves
///
/// \brief what `cut_along_levels()` has done to a mesh.
struct Level_cut_report
{
  std::size_t number_of_levels = 0;         ///< the number of different levels
  std::size_t number_of_added_vertices = 0; ///< the number of points at which edges have been split
  std::size_t number_of_added_faces = 0;    ///< the number of faces that are there more than before
  /// the number of faces at added vertices that are slivers: the height on the longest edge is less than a hundredth of
  /// this edge. Some may have no area, where the point of a level is rounded to a vertex.
  std::size_t number_of_slivers = 0;
};

} // namespace CGAL::Reeb_graph

#endif // CGAL_REEB_GRAPH_CURVES_LEVEL_CUT_REPORT_H
