// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of the CGAL-style package Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_INTERNAL_SIMPLIFICATION_PERSISTENCE_H
#define CGAL_REEB_GRAPH_INTERNAL_SIMPLIFICATION_PERSISTENCE_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/number_utils.h>

#include <cmath>

namespace CGAL {
namespace Reeb_graph {
namespace internal {

template <class ReebGraph, class NodeDescriptor>
double node_value(const ReebGraph& graph, NodeDescriptor node)
{
  return CGAL::to_double(graph[node].value);
}

// With another order than that of numbers, values can fall along an arc. The difference of infinities is no number.
inline double persistence(double lower, double upper) { return lower == upper ? 0 : std::abs(upper - lower); }

} // namespace internal
} // namespace Reeb_graph
} // namespace CGAL

#endif // CGAL_REEB_GRAPH_INTERNAL_SIMPLIFICATION_PERSISTENCE_H
