// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of the CGAL-style package Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#include <boost/test/unit_test.hpp>

#include "computed_graphs.h"
#include "persistence_oracle.h"

#include <CGAL/Reeb_graph/simplification/persistence_pairs.h>

#include <gudhi/Bottleneck.h>

#include <cstddef>
#include <utility>
#include <vector>

// Persistence diagrams are stable: noise moves their points by no more than its largest value (D. Cohen-Steiner, H.
// Edelsbrunner, J. Harer, Stability of Persistence Diagrams, 2007). The distance of two diagrams is that of GUDHI.

using namespace computed_graphs;
using persistence_oracle::Pair;
using persistence_oracle::Persistence_pair_kind;

namespace {
typedef std::vector<std::pair<double, double>> Diagram;

template <class Graph>
Diagram diagram(const Graph& graph, Persistence_pair_kind kind)
{
  Diagram points;
  for(const Pair& pair : persistence_oracle::found_pairs(graph))
    if(pair.kind == kind)
      points.emplace_back(graph[pair.lower_node].value, graph[pair.upper_node].value);
  return points;
}

void test_stability(const mesh_builders::Surface_mesh& mesh, const std::vector<double>& values, Random& random)
{
  const double largest_noise = 1. + random.below(5);
  std::vector<double> noisy_values = values;
  for(double& value : noisy_values)
    value += largest_noise * (static_cast<double>(random.below(2001)) / 1000 - 1);
  const auto graph = graph_checks::compute(mesh, values), noisy_graph = graph_checks::compute(mesh, noisy_values);
  for(const auto kind : {Persistence_pair_kind::MINIMUM_SADDLE, Persistence_pair_kind::SADDLE_MAXIMUM,
                         Persistence_pair_kind::MINIMUM_MAXIMUM, Persistence_pair_kind::LOOP})
  {
    const double distance =
      Gudhi::persistence_diagram::bottleneck_distance(diagram(graph, kind), diagram(noisy_graph, kind));
    BOOST_TEST(distance <= largest_noise * (1 + 1e-9), to_string(kind) << ": " << distance << " > " << largest_noise);
  }
}
} // namespace

BOOST_AUTO_TEST_CASE(diagrams_of_small_surfaces_are_stable)
{
  for(std::size_t seed = 0; seed < 200; ++seed)
    BOOST_TEST_CONTEXT("seed " << seed)
    {
      Random random(seed);
      const auto combinatorial_mesh =
        random_meshes::random_mesh(static_cast<Mesh_class>(seed % 5), random); // all but the tiny ones
      const auto values = random_meshes::random_field(
        combinatorial_mesh, seed % 3 == 0 ? Field_class::SMOOTH : Field_class::PERMUTATION, random);
      test_stability(make_mesh<mesh_builders::Surface_mesh>(combinatorial_mesh), values, random);
    }
}

BOOST_AUTO_TEST_CASE(diagrams_of_smooth_surfaces_are_stable)
{
  for(unsigned genus = 0; genus < 6; ++genus)
    BOOST_TEST_CONTEXT("genus " << genus)
    {
      Random random(genus);
      const auto soup = generated_surfaces::closed_surface(genus, 2000);
      std::vector<double> values;
      for(const auto& p : soup.points)
        values.push_back(20 * (0.9 * p[0] + 0.4 * p[1]));
      test_stability(make_mesh<mesh_builders::Surface_mesh>(soup), values, random);
    }
}
