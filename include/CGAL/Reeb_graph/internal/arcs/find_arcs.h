// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of the CGAL-style package Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_INTERNAL_ARCS_FIND_ARCS_H
#define CGAL_REEB_GRAPH_INTERNAL_ARCS_FIND_ARCS_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/internal/arcs/Critical_sets_engine.h>
#include <CGAL/Reeb_graph/internal/base/Index.h>
#include <CGAL/Reeb_graph/internal/base/Indexed_vector.h>
#include <CGAL/Reeb_graph/internal/base/Progress.h>
#include <CGAL/Reeb_graph/internal/base/parallel.h>
#include <CGAL/Reeb_graph/internal/contour_trees/Contour_trees_engine.h>
#include <CGAL/Reeb_graph/internal/critical_vertices/Swept_vertices.h>
#include <CGAL/Reeb_graph/internal/slabs/Gluing.h>
#include <CGAL/Reeb_graph/internal/slabs/Slab.h>
#include <CGAL/Reeb_graph/internal/slabs/Slab_arc.h>
#include <CGAL/Reeb_graph/internal/slabs/Slicing.h>
#include <CGAL/Reeb_graph/options.h>

#include <algorithm>
#include <cstddef>

namespace CGAL {
namespace Reeb_graph {
namespace internal {

// Throws if an arc lacks a node of the slab at an end, or has no step to begin with at a vertex: the order of the vertices
// has contradicted itself.
template <class Complex>
void check_arcs(const Slab<Complex>& slab, const Slab_arcs& arcs)
{
  const Slab_node end_of_nodes(slab.number_of_nodes());
  for(const Slab_arc& arc : arcs)
  {
    const bool has_first_step = arc.first_step.edge != no_index || slab.is_contour(arc.lower);
    if(arc.lower >= end_of_nodes || arc.upper >= end_of_nodes || !has_first_step)
      slab.throw_contradiction_near(arc);
  }
}

// Finds the arcs between the nodes of a slab by one of the two engines. They return the same arcs, in any order. First
// steps are those of arcs that begin at a critical vertex.
template <class ConcurrencyTag, class Complex, class Order, class Report>
Slab_arcs find_arcs_of_slab(const Slab<Complex>& slab, const Order& order, Method method, const Report& report)
{
  Slab_arcs arcs = method == Method::CRITICAL_SETS
                   ? Critical_sets_engine<Complex, Order>(slab, order).find_arcs(report)
                   : Contour_trees_engine<Complex, Order>(slab, order).template find_arcs<ConcurrencyTag>(report);
  check_arcs(slab, arcs);
  return arcs;
}

// The slab stage between partition and gluing: finds the arcs between critical vertices, slab by slab. With one slab,
// which needs neither, the engine itself runs in parallel where it can.
template <class ConcurrencyTag, class Complex, class Order, class Report>
Slab_arcs find_arcs(const Complex& complex,
                    const Order& order,
                    const Swept_vertices& critical_vertices,
                    Method method,
                    std::size_t number_of_slabs,
                    const Report& report)
{
  number_of_slabs = (std::min)(number_of_slabs, static_cast<std::size_t>(critical_vertices.size()));
  if(number_of_slabs <= 1)
    return find_arcs_of_slab<ConcurrencyTag>(Slab(complex, critical_vertices), order, method, report);

  const auto slicing = Slicing<Complex>::template make<ConcurrencyTag>(complex, order, critical_vertices,
                                                                       static_cast<Number>(number_of_slabs));
  report(0.2);
  Indexed_vector<Slab_index, Slab_arcs> arcs_of_slabs(slicing.number_of_slabs());
  for_each_index<ConcurrencyTag>(arcs_of_slabs.size(), [&](std::size_t i) {
    arcs_of_slabs[Slab_index(i)] =
      find_arcs_of_slab<ConcurrencyTag>(slicing.slab(Slab_index(i)), order, method, No_progress());
  });
  return Gluing(slicing, critical_vertices.size())(arcs_of_slabs);
}

} // namespace internal
} // namespace Reeb_graph
} // namespace CGAL

#endif // CGAL_REEB_GRAPH_INTERNAL_ARCS_FIND_ARCS_H
