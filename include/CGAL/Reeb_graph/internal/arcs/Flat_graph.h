// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of the CGAL-style package Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_INTERNAL_ARCS_FLAT_GRAPH_H
#define CGAL_REEB_GRAPH_INTERNAL_ARCS_FLAT_GRAPH_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/Node_kind.h>
#include <CGAL/Reeb_graph/internal/base/Index.h>
#include <CGAL/Reeb_graph/internal/base/Large_vector.h>
#include <CGAL/Reeb_graph/internal/walks/ascending_path.h>

namespace CGAL {
namespace Reeb_graph {
namespace internal {

struct Flat_node
{
  Index vertex;
  Node_kind kind;
};

inline Node_kind node_kind(Index in_degree, Index out_degree)
{
  if(in_degree == 0)
    return out_degree == 0 ? Node_kind::ISOLATED : Node_kind::MINIMUM;
  if(out_degree == 0)
    return Node_kind::MAXIMUM;
  return in_degree == 1 && out_degree == 1 ? Node_kind::DEGREE_TWO : Node_kind::SADDLE;
}

// A piece of a chain: steepest steps from the first one on, up to the level just below a vertex. An arc has one, and
// one more for each plateau of several critical vertices that it passes.
struct Chain_piece
{
  Ascending_step first_step;
  Index upper_vertex;
};

struct Flat_arc
{
  Index lower; // positions of nodes
  Index upper;
  Index first_piece;
  Index number_of_pieces;
};

// The Reeb graph by indices: nodes in ascending order, arcs sorted.
struct Flat_graph
{
  Large_vector<Flat_node> nodes;
  Large_vector<Flat_arc> arcs;
  Large_vector<Chain_piece> pieces;

  // By critical vertex: the node that it is part of, or else, on request, the arc that passes it.
  Large_vector<Index> node_of_critical;
  Large_vector<Index> arc_of_critical;

  // By arc between critical vertices, on request: the arc that it is part of, no_index if it has been contracted.
  Large_vector<Index> arc_of_critical_arc;
};

} // namespace internal
} // namespace Reeb_graph
} // namespace CGAL

#endif // CGAL_REEB_GRAPH_INTERNAL_ARCS_FLAT_GRAPH_H
