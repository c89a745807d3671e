// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of the CGAL-style package Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_INTERNAL_SIMPLIFICATION_LEAF_ARC_H
#define CGAL_REEB_GRAPH_INTERNAL_SIMPLIFICATION_LEAF_ARC_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/internal/base/Index.h>

#include <algorithm>

namespace CGAL {
namespace Reeb_graph {
namespace internal {

// The nodes of an arc.
struct Pruned_arc
{
  Index lower, upper;
};

// A leaf arc that could be removed.
template <class Weight>
struct Weighted_leaf_arc
{
  Index leaf, saddle;    // its nodes
  bool is_minimum;       // whether the leaf is the lower one of them
  Weight weight;         // of the leaf, of the arc, and of all that they have taken up
  Index lowest, highest; // of the leaf and the nodes that have been taken up
};

typedef Weighted_leaf_arc<double> Leaf_arc;

// The largest difference between the value at the saddle of a leaf arc and one in the branch that it stands for.
// `difference` gives the absolute difference between two nodes.
template <class Weight, class Difference>
double persistence_of_leaf_arc(const Weighted_leaf_arc<Weight>& arc, const Difference& difference)
{
  return (std::max)(difference(arc.lowest, arc.saddle), difference(arc.saddle, arc.highest));
}

} // namespace internal
} // namespace Reeb_graph
} // namespace CGAL

#endif // CGAL_REEB_GRAPH_INTERNAL_SIMPLIFICATION_LEAF_ARC_H
