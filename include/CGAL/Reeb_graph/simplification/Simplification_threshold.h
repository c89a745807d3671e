// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_SIMPLIFICATION_SIMPLIFICATION_THRESHOLD_H
#define CGAL_REEB_GRAPH_SIMPLIFICATION_SIMPLIFICATION_THRESHOLD_H

#include <CGAL/license/Reeb_graph.h>

#include <cstddef>

namespace CGAL::Reeb_graph {

/// \ingroup PkgReebGraphSimplification
///
/// \brief a threshold of persistence that separates noise from features, and the graph that `simplify()` gives with it.
struct Simplification_threshold
{
  double threshold;   ///< the middle of a gap between two persistences, on a logarithmic scale
  double gap;         ///< the least persistence above the gap, divided by the greatest one below
  std::size_t nodes;  ///< of the simplified graph
  std::size_t leaves; ///< the nodes of the simplified graph with a single arc
  std::size_t loops;  ///< the independent loops of the simplified graph
  bool is_suggested;  ///< whether this is the best one
};

} // namespace CGAL::Reeb_graph

#endif // CGAL_REEB_GRAPH_SIMPLIFICATION_SIMPLIFICATION_THRESHOLD_H
