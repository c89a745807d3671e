// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_SRC_PIECES_H
#define CGAL_REEB_GRAPH_SRC_PIECES_H

#include "base/input_findings.h"
#include "input/Polygon_soup.h"

#include <cstddef>
#include <vector>

namespace reeb_graph_program {
// The faces of components with less than a share of the area, and of closed ones that have no inside, or are inside out and
// neither lie in another one nor have one inside: cavities stay. If the largest component is inside out, all are taken the
// other way round. In ascending order.
std::vector<std::size_t> faces_of_lesser_pieces(const Polygon_soup& soup, double least_share, Repair_counts& counts);

} // namespace reeb_graph_program

#endif // CGAL_REEB_GRAPH_SRC_PIECES_H
