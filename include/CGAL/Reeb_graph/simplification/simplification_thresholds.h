// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_SIMPLIFICATION_SIMPLIFICATION_THRESHOLDS_H
#define CGAL_REEB_GRAPH_SIMPLIFICATION_SIMPLIFICATION_THRESHOLDS_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/graph_topology.h>
#include <CGAL/Reeb_graph/internal/base/graph_requirements.h>
#include <CGAL/Reeb_graph/internal/base/named_parameter.h>
#include <CGAL/Reeb_graph/internal/graph/elder_rule.h>
#include <CGAL/Reeb_graph/internal/graph/read_graph.h>
#include <CGAL/Reeb_graph/named_parameters.h>
#include <CGAL/Reeb_graph/simplification/Simplification_threshold.h>
#include <CGAL/Reeb_graph/simplification/arc_persistences.h>
#include <CGAL/Reeb_graph/simplification/internal/persistence_gaps.h>
#include <CGAL/Reeb_graph/simplification/internal/prune_graph.h>
#include <CGAL/Reeb_graph/simplification/simplify.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL::Reeb_graph {

namespace internal {

// The thresholds in the wide gaps of the persistences of branches and, if these are cancelled, loops.
template <class ReebGraph, class NamedParameters>
std::vector<Simplification_threshold> find_thresholds(const ReebGraph& graph,
                                                      const std::vector<double>& values,
                                                      double range,
                                                      const NamedParameters& np)
{
  typedef Branch<typename boost::graph_traits<ReebGraph>::vertex_descriptor> Branch;
  const bool are_loops_cancelled =
    parameters::choose_parameter(parameters::get_parameter(np, internal::cancel_loops), false);
  const Pruning_history history =
    are_loops_cancelled ? Pruning_history{{}, arc_persistences(graph, np)} : prune_step_by_step(graph, values);
  const auto& persistences = history.persistences;
  std::vector<Simplification_threshold> thresholds;
  // With loops, the largest branches of components are among them, and nothing removes these.
  const auto is_removable = [&](double size) { return !are_loops_cancelled || size < range; };
  if(std::none_of(persistences.begin(), persistences.end(), is_removable))
    return thresholds;
  const std::size_t components = number_of_components(graph);
  for(const Persistence_gap& gap : find_wide_gaps(persistences, range))
  {
    const auto [nodes, arcs, leaves] = are_loops_cancelled ? size_of_rest(prune_graph<Branch>(graph, gap.middle(), np))
                                                           : history.states[gap.number_below];
    thresholds.push_back({gap.middle(), gap.width(), nodes, leaves, arcs + components - nodes, false});
  }
  return thresholds;
}

// The most plausible ones, ascending.
inline std::vector<Simplification_threshold> choose_thresholds(std::vector<Simplification_threshold> thresholds)
{
  constexpr std::size_t largest_number = 6;
  std::stable_sort(thresholds.begin(), thresholds.end(), [](const auto& a, const auto& b) {
    return plausibility(a.gap, a.leaves) > plausibility(b.gap, b.leaves);
  });
  if(thresholds.size() > largest_number)
    thresholds.resize(largest_number);
  if(!thresholds.empty())
    thresholds.front().is_suggested = true;
  std::sort(thresholds.begin(), thresholds.end(),
            [](const auto& a, const auto& b) { return a.threshold < b.threshold; });
  return thresholds;
}

} // namespace internal

/// \ingroup PkgReebGraphSimplification
///
/// \brief finds the few thresholds that matter for `simplify()`. They lie in wide gaps of the persistences, so branches
/// that are removed are clearly smaller than those that stay.
///
/// Noise gives many pairs whose persistences are close together, up to about twice its amplitude, and features are more
/// persistent; see \cgalCite{cgos-pbcrm-13}, which takes the widest gap. Here, a gap is the ratio of two persistences
/// that follow each other. So units do not matter, and a limb that is ten times as long as another one does not hide
/// the gap below that one. The persistences are those with which `simplify()` removes branches, and with `cancel_loops`
/// loops; the range of the largest connected component lies above all of them. Persistences below a thousandth of this
/// range count as that. So there is a wide gap below the few features of a smooth field, and they all stay. A gap is
/// wide if the ratio is 1.25 or more.
///
/// Let \f$ r \f$ be the ratio, and \f$ l \f$ the number of leaves that stay. The suggested threshold has the greatest
/// \f$ \ln r - 1.5\, |\ln (l / 7)| \f$: the widest gap, with a prior expectation of about seven leaves, as head, tail
/// and limbs of a body. The expectation decides where a shape has details of all sizes, and no gap is much wider than
/// the other ones; a gap of noise outweighs it.
///
/// With \f$ n \f$ nodes and arcs, it takes \f$ O(n \log n) \f$ time; with `cancel_loops` the time of `simplify()` for
/// each wide gap, of which there are at most 31.
///
/// \tparam ReebGraph the type `Graph` of the traits class
/// \tparam OutputIterator a model of `OutputIterator` for `Simplification_threshold`
/// \tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"
///
/// \param graph a Reeb graph, computed with any named parameters
/// \param thresholds the output, ascending: the suggested threshold, and the best of the others by the same measure, at
/// most six in all. There is none if nothing can be removed, or if no gap is wide
/// \param np an optional sequence of \ref bgl_namedparameters "Named Parameters": `cancel_loops` and `geom_traits`, as
/// for `simplify()`
///
/// \pre Arcs lead to nodes of higher number.
///
/// \reebGraphComplexity
///
/// \returns the output iterator behind the last threshold.
///
/// \exception Reeb_graph::Parameter_error if the number of a value is NaN
/// \exception Reeb_graph::Graph_mismatch_error if an arc does not lead to a node of higher number
template <class ReebGraph, class OutputIterator, class NamedParameters = parameters::Default_named_parameters>
OutputIterator simplification_thresholds(const ReebGraph& graph,
                                         OutputIterator thresholds,
                                         const NamedParameters& np = parameters::default_values())
{
  if constexpr(internal::Graph_of_numbers<ReebGraph, NamedParameters>::value)
  {
    const std::vector<double> values = internal::numbers_of_nodes(graph, np);
    const std::vector<double> ranges = internal::component_ranges(internal::read_arcs(graph), values);
    if(num_edges(graph) == 0)
      return thresholds;
    const double range = *std::max_element(ranges.begin(), ranges.end());
    for(const auto& threshold : internal::choose_thresholds(internal::find_thresholds(graph, values, range, np)))
      *thresholds++ = threshold;
  }
  return thresholds;
}

} // namespace CGAL::Reeb_graph

#endif // CGAL_REEB_GRAPH_SIMPLIFICATION_SIMPLIFICATION_THRESHOLDS_H
