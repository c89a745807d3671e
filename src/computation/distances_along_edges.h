// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_SRC_DISTANCES_ALONG_EDGES_H
#define CGAL_REEB_GRAPH_SRC_DISTANCES_ALONG_EDGES_H

#include "base/complex.h"

#include <cstddef>
#include <vector>

namespace reeb_graph_program {
// Sets the map to the lengths of the shortest paths along edges of the complex from the sources or, if there are none,
// from a vertex of each component that is farthest away from its first vertex. Returns the sources. Throws
// std::runtime_error if there is no such source, or no path from a source to a vertex.
std::vector<std::size_t> compute_distances_along_edges(const Mesh& mesh,
                                                       std::vector<std::size_t> sources,
                                                       Scalar_map scalar_map);

} // namespace reeb_graph_program

#endif // CGAL_REEB_GRAPH_SRC_DISTANCES_ALONG_EDGES_H
