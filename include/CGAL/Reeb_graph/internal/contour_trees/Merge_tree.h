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

#include <CGAL/Reeb_graph/internal/base/Index.h>
#include <CGAL/Reeb_graph/internal/base/Large_vector.h>

#include <vector>

namespace CGAL {
namespace Reeb_graph {
namespace internal {

struct Merge_tree
{
  Large_vector<Index> parents;         // by node: where its component merges; no_index at a root
  std::vector<bool> is_border_reached; // by node: whether the component of which it is the top has border
  std::vector<bool> is_class_shared;   // by critical vertex: whether two of its sectors are in one component

  // By lower link sector in the join tree, by upper one in the split tree: the top of the component that it is in when
  // the sweep arrives at its vertex. Before that, the component in which a monotone path from there ends.
  Large_vector<Index> sector_classes;
};

} // namespace internal
} // namespace Reeb_graph
} // namespace CGAL

#endif // CGAL_REEB_GRAPH_INTERNAL_CONTOUR_TREES_MERGE_TREE_H
