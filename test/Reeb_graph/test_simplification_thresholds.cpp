// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#include <boost/test/unit_test.hpp>

#include "computed_graphs.h"
#include "generated_surfaces/standing_figure.h"
#include "random_graphs.h"

#include <CGAL/Reeb_graph/simplification/simplification_thresholds.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <limits>
#include <random>
#include <string>
#include <utility>
#include <vector>

// The thresholds that tell noise from features.

BOOST_AUTO_TEST_SUITE(test_simplification_thresholds)

using namespace computed_graphs;
using CGAL::Reeb_graph::Simplification_threshold;
using random_graphs::Graph;

namespace {
template <class G>
std::vector<Simplification_threshold> thresholds(const G& graph, bool are_loops_cancelled = false)
{
  std::vector<Simplification_threshold> result;
  CGAL::Reeb_graph::simplification_thresholds(graph, std::back_inserter(result),
                                              CGAL::parameters::cancel_loops(are_loops_cancelled));
  return result;
}

template <class G>
G simplified(const G& graph, double threshold, bool are_loops_cancelled)
{
  G result;
  CGAL::Reeb_graph::simplify(graph, threshold, result, CGAL::parameters::cancel_loops(are_loops_cancelled));
  return result;
}

template <class G>
double suggested(const G& graph)
{
  for(const Simplification_threshold& threshold : thresholds(graph))
    if(threshold.is_suggested)
      return threshold.threshold;
  return 0;
}

// what is wrong with a threshold, or nothing
template <class G>
std::string fault(const G& graph, const Simplification_threshold& threshold, bool are_loops_cancelled)
{
  const G result = simplified(graph, threshold.threshold, are_loops_cancelled);
  std::size_t leaves = 0;
  for(std::size_t node = 0; node != num_vertices(result); ++node)
    leaves += degree(node, result) == 1 ? 1 : 0;
  if(num_vertices(result) != threshold.nodes || leaves != threshold.leaves
     || CGAL::Reeb_graph::number_of_loops(result) != threshold.loops)
    return "other counts";
  if(!(threshold.gap >= 1.25))
    return "narrow gap";
  const double half = std::sqrt(threshold.gap);
  for(const double other : {threshold.threshold / half * 1.001, threshold.threshold * half * 0.999})
    if(!are_loops_cancelled && num_vertices(simplified(graph, other, false)) != threshold.nodes)
      return "a persistence in the gap";
  return "";
}

// A trunk from 0 to 100 with a maximum of each persistence beside it.
Graph comb(const std::vector<double>& persistences)
{
  std::vector<std::pair<double, std::size_t>> tops; // value and tooth; the nodes are numbered in the order of values
  const std::size_t teeth = persistences.size();
  for(std::size_t i = 0; i != teeth; ++i)
  {
    const double saddle = 10 + static_cast<double>(i) * 20 / static_cast<double>(teeth);
    tops.emplace_back(saddle, i);
    tops.emplace_back(saddle + persistences[i], i);
  }
  std::sort(tops.begin(), tops.end());
  std::vector<random_graphs::Arc> arcs;
  std::vector<double> values = {0};
  std::vector<std::size_t> saddles(teeth, 0);
  std::size_t trunk = 0;
  for(const auto& [value, tooth] : tops)
  {
    const std::size_t node = values.size();
    values.push_back(value);
    if(saddles[tooth] == 0)
    {
      saddles[tooth] = node;
      arcs.push_back({trunk, node});
      trunk = node;
    }
    else
      arcs.push_back({saddles[tooth], node});
  }
  arcs.push_back({trunk, values.size()});
  values.push_back(100);
  Graph graph = random_graphs::make_graph(values.size(), arcs);
  for(std::size_t node = 0; node != values.size(); ++node)
    graph[node].value = values[node];
  return graph;
}
} // namespace

BOOST_AUTO_TEST_CASE(counts_are_those_of_simplify_and_gaps_are_empty)
{
  for(std::size_t seed = 0; seed != 600; ++seed)
    BOOST_TEST_CONTEXT("seed " << seed)
    {
      Random random(seed);
      Graph graph = seed % 3 == 0 ? random_graphs::random_graph(random)
                                  : random_graphs::random_sparse_graph(5 + random.below(60), random.below(4), random);
      double value = 0;
      for(std::size_t node = 0; node != num_vertices(graph); ++node)
        graph[node].value = value += static_cast<double>(random.below(100) * random.below(100));
      for(const bool are_loops_cancelled : {false, true})
      {
        const auto found = thresholds(graph, are_loops_cancelled);
        BOOST_TEST(found.size() <= 6u);
        for(const auto& threshold : found)
          BOOST_TEST(fault(graph, threshold, are_loops_cancelled) == "");
        BOOST_TEST(std::is_sorted(found.begin(), found.end(),
                                  [](const auto& a, const auto& b) { return a.threshold < b.threshold; }));
        const auto best = std::count_if(found.begin(), found.end(), [](const auto& t) { return t.is_suggested; });
        BOOST_TEST(best == (found.empty() ? 0 : 1));
      }
    }
}

BOOST_AUTO_TEST_CASE(features_stay_and_noise_goes)
{
  const auto nodes = [](const std::vector<double>& persistences) {
    const Graph graph = comb(persistences);
    return num_vertices(simplified(graph, suggested(graph), false));
  };
  const std::vector<double> noise = {1, 1.1, 1.2, 1.3, 1.4, 1.5, 1.6, 1.7, 1.8, 1.9};
  const auto with_noise = [&](std::vector<double> features) {
    features.insert(features.end(), noise.begin(), noise.end());
    return features;
  };
  BOOST_TEST(nodes(with_noise({30, 20, 14, 9, 8})) == 12u);
  BOOST_TEST(nodes(with_noise({30})) == 4u);
  BOOST_TEST(nodes(with_noise({})) == 2u);
  BOOST_TEST(nodes({30, 20, 14}) == 8u); // a few features, and no noise
  BOOST_TEST(nodes({30, 20, 14, 1e-9}) == 8u);
  BOOST_TEST(nodes({40, 1}) == 4u); // one small branch among large ones
}

BOOST_AUTO_TEST_CASE(graphs_without_branches_suggest_nothing)
{
  BOOST_TEST(thresholds(Graph()).empty());
  BOOST_TEST(thresholds(Graph(3)).empty());
  BOOST_TEST(thresholds(comb({})).empty());
  Graph infinite = comb({30, 20});
  infinite[num_vertices(infinite) - 1].value = std::numeric_limits<double>::infinity();
  BOOST_TEST(thresholds(infinite).empty());
  Graph unordered = comb({30});
  unordered[0].value = std::numeric_limits<double>::quiet_NaN();
  BOOST_CHECK_THROW(thresholds(unordered), CGAL::Reeb_graph::Parameter_error);
}

// Without loops, one threshold says how much is left when nothing goes, even if each branch is as long as the range.
BOOST_AUTO_TEST_CASE(branches_as_long_as_the_range_stay)
{
  Graph graph = random_graphs::make_graph(3, {{0, 2}, {1, 2}});
  graph[2].value = 10;
  graph[0].value = graph[1].value = 0;
  const auto found = thresholds(graph);
  BOOST_REQUIRE(found.size() == 1u);
  BOOST_TEST(found[0].nodes == 3u);
  BOOST_TEST(found[0].leaves == 2u);
  BOOST_TEST(fault(graph, found[0], false) == "");
}

BOOST_AUTO_TEST_CASE(the_figure_of_the_demo_is_found_under_noise)
{
  const auto mesh = make_mesh<mesh_builders::Surface_mesh>(generated_surfaces::standing_figure(6000));
  std::vector<double> heights;
  for(const auto v : mesh.vertices())
    heights.push_back(mesh.point(v).z());
  const auto [low, high] = std::minmax_element(heights.begin(), heights.end());
  const double range = *high - *low;
  for(const double percent : {0., 1., 3., 5.})
    for(unsigned seed = 1; seed != 4; ++seed)
      BOOST_TEST_CONTEXT("noise of " << percent << " percent, seed " << seed)
      {
        std::mt19937 random(seed);
        std::vector<double> values = heights;
        for(double& value : values)
          value += percent / 100 * range * (2. * static_cast<double>(random()) / std::mt19937::max() - 1);
        const auto graph = graph_checks::compute(mesh, values);
        const auto result = simplified(graph, suggested(graph), false);
        BOOST_TEST(num_vertices(result) == 10u);
        BOOST_TEST(CGAL::Reeb_graph::number_of_loops(result) == 1u);
      }
}

BOOST_AUTO_TEST_SUITE_END()
