// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#include "computation/simplified_field.h"

#include "base/progress_bar.h"

#include <CGAL/Reeb_graph/simplification/simplify_field.h>

#include <CGAL/property_map.h>

#include <algorithm>
#include <functional>
#include <memory>
#include <vector>

namespace reeb_graph_program {
namespace {
bool has_ties(Scalar_map scalar_map)
{
  std::vector<double> values(scalar_map.begin(), scalar_map.end());
  std::sort(values.begin(), values.end());
  return std::adjacent_find(values.begin(), values.end()) != values.end();
}

std::unique_ptr<Mesh_graph> compute_without_degree_two_nodes(const Mesh& mesh,
                                                             Scalar_map scalar_map,
                                                             Graph_options options)
{
  options.are_degree_two_nodes_kept = false;
  options.are_places_wanted = true;
  Report unused;
  return compute_mesh_graph(mesh, scalar_map, options, {}, 0, unused);
}

} // namespace

Simplified_field compute_simplified_field(const Mesh& mesh,
                                          Scalar_map scalar_map,
                                          Mesh_graph& graph,
                                          const Graph_options& graph_options,
                                          const Simplification_options& simplification,
                                          Scalar_map simplified_map)
{
  namespace parameters = CGAL::parameters;
  typedef CGAL::Reeb_graph::Ties Ties;
  const std::unique_ptr<Mesh_graph> other = graph_options.are_degree_two_nodes_kept
                                            ? compute_without_degree_two_nodes(mesh, scalar_map, graph_options)
                                            : nullptr;
  Mesh_graph& given = other ? *other : graph;
  const auto leaves = parameters::number_of_leaves(simplification.number_of_leaves.value_or(0));
  const auto simplify_given = [&](Ties ties) {
    Progress_bar progress_bar("simplified field");
    const auto place_map = CGAL::make_property_map(given.given_places().data());
    return CGAL::Reeb_graph::simplify_field(
      mesh.surface, scalar_map, given.given(), graph.threshold(), simplified_map,
      leaves.ties(ties).vertex_place_map(place_map).callback(std::ref(progress_bar)));
  };
  try
  {
    return {simplify_given(graph_options.ties), false};
  }
  catch(const CGAL::Reeb_graph::Perturbed_ties_error&)
  {
    if(!has_ties(scalar_map)) // With contracted ties, the graph is the same one.
      return {simplify_given(Ties::CONTRACT), true};
  }
  Progress_bar progress_bar("simplified field");
  return {CGAL::Reeb_graph::simplify_field(mesh.surface, scalar_map, graph.threshold(), simplified_map,
                                           leaves.ties(Ties::CONTRACT).callback(std::ref(progress_bar))),
          true};
}

} // namespace reeb_graph_program
