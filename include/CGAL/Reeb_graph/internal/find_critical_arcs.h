// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of the CGAL-style package Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_INTERNAL_FIND_CRITICAL_ARCS_H
#define CGAL_REEB_GRAPH_INTERNAL_FIND_CRITICAL_ARCS_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/internal/Large_vector.h>
#include <CGAL/Reeb_graph/internal/contour_trees_engine.h>
#include <CGAL/Reeb_graph/internal/critical_sets_engine.h>
#include <CGAL/Reeb_graph/named_parameters.h>

namespace CGAL {
namespace Reeb_graph {
namespace internal {

// Finds the arcs between critical vertices by one of the two engines. They return the same arcs, in any order.
template <class ConcurrencyTag, class Order>
Large_vector<Critical_arc> find_critical_arcs(const Triangle_complex& complex,
                                             const Order& order,
                                             const Critical_vertices& critical_vertices,
                                             Method method)
{
  if(method == Method::CRITICAL_SETS)
    return find_arcs_by_critical_sets(complex, order, critical_vertices);
  return find_arcs_by_contour_trees<ConcurrencyTag>(complex, order, critical_vertices);
}

} // namespace internal
} // namespace Reeb_graph
} // namespace CGAL

#endif // CGAL_REEB_GRAPH_INTERNAL_FIND_CRITICAL_ARCS_H
