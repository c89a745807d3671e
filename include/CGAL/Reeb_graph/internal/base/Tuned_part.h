// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_INTERNAL_BASE_TUNED_PART_H
#define CGAL_REEB_GRAPH_INTERNAL_BASE_TUNED_PART_H

#include <CGAL/license/Reeb_graph.h>

namespace CGAL::Reeb_graph::internal {

// The parts that are there for speed alone. The benchmark leaves out one at a time, by the macro, to tell what it
// gains.
enum class Tuned_part
{
  NONE,
  PREFETCH,
  KEPT_NEIGHBORS,
  BRANCHLESS_ORDER,
  TRIANGLE_SWEEP,
  STARS_AHEAD
};

constexpr bool is_used(Tuned_part part)
{
#ifdef CGAL_REEB_GRAPH_LEFT_OUT
  return part != Tuned_part::CGAL_REEB_GRAPH_LEFT_OUT;
#else
  return part != Tuned_part::NONE;
#endif
}

} // namespace CGAL::Reeb_graph::internal

#endif // CGAL_REEB_GRAPH_INTERNAL_BASE_TUNED_PART_H
