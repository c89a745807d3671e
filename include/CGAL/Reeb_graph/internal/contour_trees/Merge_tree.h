// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of the CGAL-style package Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_INTERNAL_CONTOUR_TREES_MERGE_TREE_H
#define CGAL_REEB_GRAPH_INTERNAL_CONTOUR_TREES_MERGE_TREE_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/internal/base/Indexed_vector.h>
#include <CGAL/Reeb_graph/internal/critical_vertices/Swept_vertices.h>
#include <CGAL/Reeb_graph/internal/slabs/Slab_arc.h>

namespace CGAL {
namespace Reeb_graph {
namespace internal {

// A join tree or a split tree. Its nodes are those of a slab, and two of each loop cut.
struct Merge_tree
{
  Indexed_vector<Slab_node, Slab_node> parents;      // where the component of a node merges; no_index at a root
  Indexed_vector<Slab_node, bool> is_border_reached; // whether the component of which the node is the top has border
  Indexed_vector<Swept_index, bool> is_class_shared; // whether two sectors of the vertex are in one component

  // By lower link sector in the join tree, by upper one in the split tree: the class of the sector, which is the top of
  // the component that it is in when the sweep arrives at its vertex.
  Indexed_vector<Sector_index, Slab_node> classes;
};

} // namespace internal
} // namespace Reeb_graph
} // namespace CGAL

#endif // CGAL_REEB_GRAPH_INTERNAL_CONTOUR_TREES_MERGE_TREE_H
