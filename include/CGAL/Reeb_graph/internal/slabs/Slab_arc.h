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
#include <CGAL/Reeb_graph/internal/walks/ascending_path.h>

namespace CGAL {
namespace Reeb_graph {
namespace internal {

// What an engine returns: an arc from one critical vertex to the next one above, both as positions in the sequence
// of critical vertices. Its chain begins with the step from the lower vertex to its highest neighbor inside the arc.
struct Slab_arc
{
  Index lower;
  Index upper;
  Ascending_step first_step;
};

} // namespace internal
} // namespace Reeb_graph
} // namespace CGAL

#endif // CGAL_REEB_GRAPH_INTERNAL_SLABS_SLAB_ARC_H
