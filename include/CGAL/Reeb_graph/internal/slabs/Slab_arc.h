// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of the CGAL-style package Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_INTERNAL_SLABS_SLAB_ARC_H
#define CGAL_REEB_GRAPH_INTERNAL_SLABS_SLAB_ARC_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/internal/base/Index.h>
#include <CGAL/Reeb_graph/internal/base/Indexed_vector.h>
#include <CGAL/Reeb_graph/internal/critical_vertices/Swept_vertices.h>
#include <CGAL/Reeb_graph/internal/walks/ascending_path.h>

namespace CGAL {
namespace Reeb_graph {
namespace internal {

// The nodes of a slab: its critical vertices, then others.
struct Slab_node_tag;
typedef Index_of<Slab_node_tag> Slab_node;

constexpr Slab_node node_of(Swept_index critical) { return Slab_node(critical.number()); }
constexpr Swept_index critical_vertex_of(Slab_node node) { return Swept_index(node.number()); }

// What an engine returns: an arc from one node to the next one above. Its chain begins with the step from the lower
// vertex to its highest neighbor inside the arc.
struct Slab_arc
{
  Slab_node lower;
  Slab_node upper;
  Ascending_step first_step;

  // The ends of an arc between critical vertices.
  Swept_index lower_vertex() const { return critical_vertex_of(lower); }
  Swept_index upper_vertex() const { return critical_vertex_of(upper); }
};

struct Slab_arc_tag;
typedef Index_of<Slab_arc_tag> Slab_arc_index;
typedef Indexed_vector<Slab_arc_index, Slab_arc> Slab_arcs;

} // namespace internal
} // namespace Reeb_graph
} // namespace CGAL

#endif // CGAL_REEB_GRAPH_INTERNAL_SLABS_SLAB_ARC_H
