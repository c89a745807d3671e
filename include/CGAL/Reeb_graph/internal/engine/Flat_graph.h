// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of the CGAL-style package Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_INTERNAL_ENGINE_FLAT_GRAPH_H
#define CGAL_REEB_GRAPH_INTERNAL_ENGINE_FLAT_GRAPH_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/internal/base/Index.h>
#include <CGAL/Reeb_graph/internal/base/arrays.h>
#include <CGAL/Reeb_graph/internal/engine/Slab.h>
#include <CGAL/Reeb_graph/internal/engine/Swept_vertices.h>
#include <CGAL/Reeb_graph/internal/engine/monotone_paths.h>
#include <CGAL/Reeb_graph/options.h>

namespace CGAL::Reeb_graph::internal {

struct Node_tag;
struct Arc_tag;
struct Piece_tag;
typedef Index_of<Node_tag> Node_index;
typedef Index_of<Arc_tag> Arc_index;
typedef Index_of<Piece_tag> Piece_index;

struct Flat_node
{
  Vertex_index vertex;
  Node_kind kind;
};

inline Node_kind node_kind(Number in_degree, Number out_degree)
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
  Vertex_index upper_vertex;
};

struct Flat_arc
{
  Node_index lower;
  Node_index upper;
  Piece_index first_piece;
  Number number_of_pieces;
};

// The Reeb graph by indices: nodes in ascending order, arcs sorted.
struct Flat_graph
{
  Indexed_vector<Node_index, Flat_node> nodes;
  Indexed_vector<Arc_index, Flat_arc> arcs;
  Indexed_vector<Piece_index, Chain_piece> pieces;

  // By critical vertex: the node that it is part of, or else, on request, the arc that passes it.
  Indexed_vector<Swept_index, Node_index> node_of_critical;
  Indexed_vector<Swept_index, Arc_index> arc_of_critical;

  // By arc between critical vertices, on request: the arc that it is part of, no_index if it has been contracted.
  Indexed_vector<Slab_arc_index, Arc_index> arc_of_critical_arc;
};

} // namespace CGAL::Reeb_graph::internal

#endif // CGAL_REEB_GRAPH_INTERNAL_ENGINE_FLAT_GRAPH_H
