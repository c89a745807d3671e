// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_INTERNAL_ENGINE_CRITICAL_VERTICES_H
#define CGAL_REEB_GRAPH_INTERNAL_ENGINE_CRITICAL_VERTICES_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/internal/base/Index.h>
#include <CGAL/Reeb_graph/internal/engine/Swept_vertices.h>
#include <CGAL/Reeb_graph/visitor.h>

#include <cstddef>

namespace CGAL::Reeb_graph::internal {

inline Critical_vertex_counts count_critical_vertices(const Swept_vertices& critical_vertices)
{
  Critical_vertex_counts counts;
  for(const Swept_index i : critical_vertices.indices())
  {
    const Number number_of_lower_sectors = critical_vertices.number_of_lower_sectors(i);
    const Number number_of_upper_sectors = critical_vertices.number_of_upper_sectors(i);
    if(number_of_lower_sectors == 0 && number_of_upper_sectors == 0)
      ++counts.isolated;
    else if(number_of_lower_sectors == 0)
      ++counts.minima;
    else if(number_of_upper_sectors == 0)
      ++counts.maxima;
    else if(critical_vertices.is_on_border(i))
      ++counts.border_saddles;
    else
      ++counts.saddles[number_of_lower_sectors - 1];
  }
  return counts;
}

// The Euler characteristic of the surface, to which a vertex contributes 1 minus the Euler characteristic of its lower
// link. (T. Banchoff, Critical points and curvature for embedded polyhedra, 1967.)
inline std::ptrdiff_t euler_characteristic(const Swept_vertices& critical_vertices)
{
  std::ptrdiff_t result = 0;
  for(const Swept_index i : critical_vertices.indices())
  {
    const bool is_lower_link_closed =
      critical_vertices.number_of_upper_sectors(i) == 0 && !critical_vertices.is_on_border(i);
    result +=
      1 - (is_lower_link_closed ? 0 : static_cast<std::ptrdiff_t>(critical_vertices.number_of_lower_sectors(i)));
  }
  return result;
}

} // namespace CGAL::Reeb_graph::internal

#endif // CGAL_REEB_GRAPH_INTERNAL_ENGINE_CRITICAL_VERTICES_H
