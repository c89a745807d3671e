// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#include "computation/simplification.h"

#include "base/surface.h"

#include <CGAL/Reeb_graph/simplification/simplify.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <stdexcept>

namespace reeb_graph_program {
void check_simplification_options(const Simplification_options& options)
{
  if(options.are_loops_cancelled && !options.threshold)
    throw std::runtime_error("--cancel-loops goes with --simplify only");
}

void check_simplification_of_field(const Simplification_options& options)
{
  if(options.are_loops_cancelled)
    throw std::runtime_error("--cancel-loops does not go with a field: loops belong to the mesh");
}

double threshold_in_units(const Simplification_options& options,
                          const std::function<std::optional<Value_range>()>& find_range)
{
  if(!options.threshold)
    return std::numeric_limits<double>::infinity();
  if(options.threshold->is_suggested)
    return std::numeric_limits<double>::quiet_NaN();
  if(!options.threshold->is_percentage)
    return options.threshold->number;
  const std::optional<Value_range> range = find_range();
  if(!range)
    return 0;
  const double part = options.threshold->number / 100, length = range->second - range->first;
  const double threshold = std::isinf(length) ? part * range->second - part * range->first : length * part;
  if(!std::isfinite(threshold))
    throw std::runtime_error("a percentage needs a field of finite range");
  return threshold;
}

double threshold_in_units(const Simplification_options& options, const Surface& surface, Scalar_map scalar_map)
{
  return threshold_in_units(options, [&]() -> std::optional<Value_range> {
    if(surface.number_of_vertices() == 0)
      return std::nullopt;
    const auto [lowest, highest] = std::minmax_element(scalar_map.begin(), scalar_map.end());
    return Value_range(*lowest, *highest);
  });
}

template <class AnyGraph>
Simplified_graph_of<AnyGraph>::Simplified_graph_of(const AnyGraph& given,
                                                   const Simplification_options& options,
                                                   double threshold)
  : given_(given),
    threshold_(threshold)
{
  if(!options.is_anything_removed())
    return;
  if(std::isnan(threshold_))
    threshold_ = suggested_threshold(find_thresholds(given, options.are_loops_cancelled)).value_or(0);
  namespace parameters = CGAL::parameters;
  simplification_ = CGAL::Reeb_graph::simplify(
    given, threshold_, simplified_,
    parameters::number_of_leaves(options.number_of_leaves.value_or(0)).cancel_loops(options.are_loops_cancelled));
}

template class Simplified_graph_of<Graph>;
template class Simplified_graph_of<Complex_graph>;

std::vector<Persistence_pair> find_persistence_pairs(const Graph& graph)
{
  std::vector<Persistence_pair> pairs;
  CGAL::Reeb_graph::persistence_pairs(graph, std::back_inserter(pairs));
  return pairs;
}

template <class AnyGraph>
std::vector<Simplification_threshold> find_thresholds(const AnyGraph& graph, bool are_loops_cancelled)
{
  std::vector<Simplification_threshold> thresholds;
  CGAL::Reeb_graph::simplification_thresholds(graph, std::back_inserter(thresholds),
                                              CGAL::parameters::cancel_loops(are_loops_cancelled));
  return thresholds;
}

template std::vector<Simplification_threshold> find_thresholds(const Graph&, bool);

std::optional<double> suggested_threshold(const std::vector<Simplification_threshold>& thresholds)
{
  for(const Simplification_threshold& threshold : thresholds)
    if(threshold.is_suggested)
      return threshold.threshold;
  return std::nullopt;
}

} // namespace reeb_graph_program
