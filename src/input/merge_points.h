// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_SRC_MERGE_POINTS_H
#define CGAL_REEB_GRAPH_SRC_MERGE_POINTS_H

#include "input/Polygon_soup.h"

#include <vector>

namespace reeb_graph_program {
// The vertex that each one becomes if coinciding points are merged wherever that makes neither a new edge with more than two
// faces nor a new point with several fans. Of those that become one, it is the first one. They are merged along whole
// edges: faces that touch in a point stay apart. So do faces that no orientation fits, if what is cut there is to stay so.
std::vector<Corner> merge_coinciding_points(const Polygon_soup& soup, bool is_cut_kept);

} // namespace reeb_graph_program

#endif // CGAL_REEB_GRAPH_SRC_MERGE_POINTS_H
