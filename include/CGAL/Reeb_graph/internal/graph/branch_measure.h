// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_INTERNAL_GRAPH_BRANCH_MEASURE_H
#define CGAL_REEB_GRAPH_INTERNAL_GRAPH_BRANCH_MEASURE_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/exceptions.h>
#include <CGAL/Reeb_graph/internal/base/named_parameter.h>
#include <CGAL/Reeb_graph/named_parameters.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <string>
#include <vector>

namespace CGAL::Reeb_graph::internal {

template <class NamedParameters>
std::vector<double> read_place_weights(std::size_t number_of_places, const NamedParameters& np)
{
  const auto parameter = parameters::get_parameter(np, place_weights);
  std::vector<double> weights;
  if constexpr(is_given<decltype(parameter)>)
  {
    weights.assign(std::begin(parameter), std::end(parameter));
    if(weights.size() != number_of_places)
      throw Parameter_error(std::to_string(weights.size()) + " weights given for " + std::to_string(number_of_places)
                            + " nodes and arcs");
    if(std::any_of(weights.begin(), weights.end(), [](double weight) { return std::isnan(weight); }))
      throw Parameter_error("the weight of a place is not a number (NaN)");
  }
  else
    weights.assign(number_of_places, 0);
  return weights;
}

template <class Branch, class NamedParameters>
double measure_of_branch(const Branch& branch, const NamedParameters& np)
{
  const auto& measure = parameters::get_parameter(np, branch_measure);
  if constexpr(is_given<decltype(measure)>)
  {
    const double size = measure(branch);
    if(std::isnan(size))
      throw Parameter_error("the measure of a branch is not a number (NaN)");
    return size;
  }
  else
    return is_given<decltype(parameters::get_parameter(np, place_weights))> ? branch.weight : branch.persistence;
}

} // namespace CGAL::Reeb_graph::internal

#endif // CGAL_REEB_GRAPH_INTERNAL_GRAPH_BRANCH_MEASURE_H
