// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of the CGAL-style package Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_INTERNAL_ARCS_SLAB_ENGINE_H
#define CGAL_REEB_GRAPH_INTERNAL_ARCS_SLAB_ENGINE_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/internal/arcs/critical_sets_engine.h>
#include <CGAL/Reeb_graph/internal/contour_trees/contour_trees_engine.h>
#include <CGAL/Reeb_graph/internal/slabs/Slab.h>
#include <CGAL/Reeb_graph/internal/slabs/Slab_arc.h>
#include <CGAL/Reeb_graph/named_parameters.h>

namespace CGAL {
namespace Reeb_graph {
namespace internal {

// Finds the arcs between the nodes of a slab by one of the two engines. They return the same arcs, in any order. First
// steps are those of arcs that begin at a critical vertex.
template <class ConcurrencyTag, class Complex, class Order, class Report>
Large_vector<Slab_arc> find_arcs_of_slab(const Slab<Complex>& slab,
                                         const Order& order,
                                         Method method,
                                         const Report& report)
{
  if(method == Method::CRITICAL_SETS)
    return Critical_sets_engine<Complex, Order>(slab, order).find_arcs(report);
  return Contour_trees_engine<Complex, Order>(slab, order).template find_arcs<ConcurrencyTag>(report);
}

} // namespace internal
} // namespace Reeb_graph
} // namespace CGAL

#endif // CGAL_REEB_GRAPH_INTERNAL_ARCS_SLAB_ENGINE_H
