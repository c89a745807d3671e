// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_TEST_KNOWN_MESHES_H
#define CGAL_REEB_GRAPH_TEST_KNOWN_MESHES_H

#include "random_meshes.h"

namespace known_meshes {
// A torus whose vertices are their own field values. Just below vertex 4 there are two contours that cross edges with
// the same lower vertex: components of lower vertices would count one. Its arcs are 0-3, 3-4 twice, and 4-8.
inline random_meshes::Combinatorial_mesh nine_vertex_torus()
{
  return {9,
          {{7, 1, 4},
           {8, 7, 4},
           {2, 8, 4},
           {2, 4, 5},
           {7, 2, 5},
           {1, 7, 5},
           {8, 1, 3},
           {4, 1, 0},
           {8, 2, 0},
           {5, 4, 3},
           {3, 4, 0},
           {1, 5, 3},
           {7, 8, 3},
           {6, 8, 0},
           {1, 8, 6},
           {1, 6, 0},
           {2, 7, 0},
           {7, 3, 0}}};
}

// An annulus in which vertex 2 closes a loop although the two components of the superlevel set beside it are not
// joined above it.
inline random_meshes::Combinatorial_mesh seven_vertex_annulus()
{
  return {7, {{0, 5, 1}, {6, 2, 1}, {5, 6, 1}, {0, 2, 6}, {2, 0, 4}, {3, 0, 1}, {0, 3, 4}, {2, 4, 1}}};
}

} // namespace known_meshes

#endif // CGAL_REEB_GRAPH_TEST_KNOWN_MESHES_H
