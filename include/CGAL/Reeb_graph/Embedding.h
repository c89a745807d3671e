// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_EMBEDDING_H
#define CGAL_REEB_GRAPH_EMBEDDING_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/options.h>

#include <vector>

namespace CGAL::Reeb_graph {

/// \ingroup PkgReebGraphEmbedding
///
/// \brief a Reeb graph in space: what `embed()` returns.
///
/// \tparam Point_ the type of the points
template <class Point_>
struct Embedding
{
  typedef Point_ Point; ///< a point

  /// the manner in which it has been made, not `BY_COST`
  Embedding_manner manner = Embedding_manner::STRAIGHT;

  /// the point of each node, by its descriptor
  std::vector<Point> node_points;

  /// the value of each node, by its descriptor
  std::vector<double> node_values;

  /// the polyline of each arc, in the order of `edges(graph)`: from the point of its lower node to that of its upper
  /// node, both included
  std::vector<std::vector<Point>> arc_polylines;

  /// the value of each point of `arc_polylines`: that of the contour or of the place on the surface that the point
  /// stands for. Values ascend weakly, if their order is that of numbers, and are NaN if they are not numbers
  std::vector<std::vector<double>> arc_values;
};

} // namespace CGAL::Reeb_graph

#endif // CGAL_REEB_GRAPH_EMBEDDING_H
