// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_INTERNAL_ENGINE_SWEPT_ARCS_H
#define CGAL_REEB_GRAPH_INTERNAL_ENGINE_SWEPT_ARCS_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/internal/base/Index.h>
#include <CGAL/Reeb_graph/internal/base/arrays.h>
#include <CGAL/Reeb_graph/internal/engine/Swept_vertices.h>
#include <CGAL/Reeb_graph/internal/engine/monotone_paths.h>

namespace CGAL::Reeb_graph::internal {

// The nodes of a slab: its critical vertices, then others.
struct Tree_node_tag;
typedef Index_of<Tree_node_tag> Tree_node;

constexpr Tree_node node_of(Swept_index critical) { return Tree_node(critical.number()); }
constexpr Swept_index critical_vertex_of(Tree_node node) { return Swept_index(node.number()); }

// An arc that an engine returns, from one node to the next one above. Its chain begins with the step from the lower
// vertex to its highest neighbor inside the arc.
struct Swept_arc
{
  Tree_node lower;
  Tree_node upper;
  Ascending_step first_step;

  // The ends of an arc between critical vertices.
  Swept_index lower_vertex() const { return critical_vertex_of(lower); }
  Swept_index upper_vertex() const { return critical_vertex_of(upper); }
};

struct Swept_arc_tag;
typedef Index_of<Swept_arc_tag> Swept_arc_index;
typedef Indexed_vector<Swept_arc_index, Swept_arc> Swept_arcs;

} // namespace CGAL::Reeb_graph::internal

#endif // CGAL_REEB_GRAPH_INTERNAL_ENGINE_SWEPT_ARCS_H
