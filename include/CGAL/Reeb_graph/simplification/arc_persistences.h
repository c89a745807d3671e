// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of the CGAL-style package Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_SIMPLIFICATION_ARC_PERSISTENCES_H
#define CGAL_REEB_GRAPH_SIMPLIFICATION_ARC_PERSISTENCES_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/internal/base/Index.h>
#include <CGAL/Reeb_graph/internal/base/graph_requirements.h>
#include <CGAL/Reeb_graph/internal/base/named_parameter.h>
#include <CGAL/Reeb_graph/simplification/internal/Arc_removal.h>
#include <CGAL/Reeb_graph/simplification/internal/pairs.h>
#include <CGAL/Reeb_graph/simplification/internal/persistence.h>
#include <CGAL/Reeb_graph/simplification/internal/prune_graph.h>

#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::Reeb_graph {

/// \ingroup PkgReebGraphSimplification
///
/// \brief returns for each arc how long it stays while a Reeb graph is simplified: the persistence of the branch or of
/// the loop with which it is removed.
///
/// Branches and loops are removed by the rules of `simplify()` with `parameters::cancel_loops(true)`, but one by one,
/// the less persistent first, so that what has been removed only grows. If a graph has no loops, the graph that is
/// simplified with a threshold consists of the arcs of at least this persistence. If it has loops, this is nearly so:
/// `simplify()` looks at them only when all branches below the threshold have gone, and can keep another one of
/// branches that compete.
///
/// With \f$ n \f$ nodes and arcs, the time is \f$ O(n \log n) \f$.
///
/// \tparam ReebGraph the type `Graph` of the traits class, or another bidirectional graph with `std::size_t` as vertex
///         descriptor
///
/// \param graph a Reeb graph, computed with any named parameters
/// \param np an optional sequence of \ref bgl_namedparameters "Named Parameters": `geom_traits`, as for `simplify()`
///
/// \returns a number for each arc, in the order of `edges(graph)` and in units of the field. Arcs that stay for any
/// threshold have the difference between the highest and the lowest value of their connected component.
///
/// \exception Reeb_graph::Measure_error if the number of a value is NaN
/// \exception Reeb_graph::Arc_direction_error if an arc does not lead to a node of higher number
template <class ReebGraph, class NamedParameters = parameters::Default_named_parameters>
std::vector<double> arc_persistences(const ReebGraph& graph, const NamedParameters& np = parameters::default_values())
{
  std::vector<double> persistences;
  if constexpr(internal::Plain_graph_of_numbers<ReebGraph, NamedParameters>::value)
  {
    const std::vector<internal::Leaf_pruning::Arc> arcs = internal::read_arcs(graph);
    const std::vector<double> values = internal::numbers_of_nodes(graph, np);
    persistences = internal::Arc_removal(arcs, internal::read_arc_ends(graph), values)();

    const std::vector<double> ranges = internal::component_ranges(graph, values);
    for(std::size_t i = 0; i != arcs.size(); ++i)
      if(persistences[i] < 0)
        persistences[i] = ranges[arcs[i].lower];
  }
  return persistences;
}

} // namespace CGAL::Reeb_graph

#endif // CGAL_REEB_GRAPH_SIMPLIFICATION_ARC_PERSISTENCES_H
