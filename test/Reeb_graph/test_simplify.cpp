// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#include <boost/test/unit_test.hpp>

#include "computed_graphs.h"
#include "persistence_oracle.h"
#include "random_graphs.h"
#include "simplification_oracle.h"

#include <CGAL/Reeb_graph/simplification/persistence_pairs.h>
#include <CGAL/Reeb_graph/simplification/simplification_thresholds.h>
#include <CGAL/Reeb_graph/simplification/simplify.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <string>
#include <utility>
#include <vector>

// Simplified graphs against one made word by word, and their properties.

BOOST_AUTO_TEST_SUITE(test_simplify)

using namespace computed_graphs;
using persistence_oracle::Persistence_pair_kind;
using random_graphs::Graph;
using simplification_oracle::Simplification_oracle;
namespace parameters = CGAL::parameters;

namespace {
const double infinity = std::numeric_limits<double>::infinity();

template <class G>
G simplified(const G& graph, double threshold)
{
  G result;
  CGAL::Reeb_graph::simplify(graph, threshold, result);
  return result;
}

// By the difference between the ends of arcs.
template <class G>
G simplified_by_ends(const G& graph, double threshold)
{
  G result;
  CGAL::Reeb_graph::simplify(graph, threshold, result, CGAL::parameters::branch_measure([&](const auto& branch) {
                               return std::abs(graph[branch.leaf].value - graph[branch.saddle].value);
                             }));
  return result;
}

template <class G>
std::size_t count_loops(const G& graph)
{
  const auto pairs = persistence_oracle::found_pairs(graph);
  return std::count_if(pairs.begin(), pairs.end(),
                       [](const auto& pair) { return pair.kind == Persistence_pair_kind::LOOP; });
}

template <class G>
std::size_t number_of_leaves(const G& graph)
{
  std::size_t leaves = 0;
  for(std::size_t node = 0; node < num_vertices(graph); ++node)
    leaves += degree(node, graph) == 1 ? 1 : 0;
  return leaves;
}

template <class G>
bool has_degree_two_node(const G& graph)
{
  for(std::size_t node = 0; node < num_vertices(graph); ++node)
    if(in_degree(node, graph) == 1 && out_degree(node, graph) == 1)
      return true;
  return false;
}

// random values that ascend, some of them tied
void set_random_values(Graph& graph, Random& random)
{
  double value = 0;
  for(std::size_t node = 0; node < num_vertices(graph); ++node)
    graph[node].value = value += static_cast<double>(random.below(5));
}

Graph random_graph_with_values(std::size_t seed, Random& random)
{
  Graph graph;
  if(seed % 3 == 0)
    graph = random_graphs::random_graph(random);
  else
  {
    const std::size_t number_of_loops = random.below(4);
    graph = random_graphs::random_sparse_graph(5 + random.below(40), number_of_loops, random);
  }
  set_random_values(graph, random);
  return graph;
}

void test_against_oracle(const Graph& graph,
                         const Graph& result,
                         const CGAL::Reeb_graph::Simplification<Graph>& map,
                         const Simplification_oracle& oracle)
{
  BOOST_REQUIRE(num_vertices(result) == oracle.nodes.size());
  BOOST_REQUIRE(num_edges(result) == oracle.arcs.size());
  std::vector<std::size_t> old_nodes, expected_places(num_vertices(graph) + num_edges(graph));
  for(const auto& node : oracle.nodes)
  {
    BOOST_TEST(result[old_nodes.size()].vertex == graph[node.first].vertex);
    BOOST_TEST((result[old_nodes.size()].kind == graph[node.first].kind));
    for(const std::size_t place : node.second)
      expected_places[place] = old_nodes.size();
    old_nodes.push_back(node.first);
  }
  std::size_t number = 0;
  for(auto range = edges(result); range.first != range.second; ++range.first, ++number)
  {
    const auto& expected = oracle.arcs[number];
    BOOST_TEST(old_nodes[source(*range.first, result)] == expected.lower);
    BOOST_TEST(old_nodes[target(*range.first, result)] == expected.upper);
    const auto& chain = result[*range.first].chain; // the numbers of arcs
    BOOST_TEST(std::vector<std::size_t>(chain.begin(), chain.end()) == expected.pieces,
               boost::test_tools::per_element());
    for(const std::size_t place : expected.places)
      expected_places[place] = num_vertices(result) + number;
  }
  for(std::size_t node = 0; node < num_vertices(graph); ++node)
  {
    BOOST_TEST(map.index_of_node(node) == expected_places[node]);
    BOOST_TEST((get(map, node).index() == 0) == (expected_places[node] < num_vertices(result)));
  }
  for(std::size_t arc = 0; arc < num_edges(graph); ++arc)
    BOOST_TEST(map.index_of_arc(arc) == expected_places[num_vertices(graph) + arc]);
}
} // namespace

BOOST_AUTO_TEST_CASE(the_least_leaf_arc_is_removed_first)
{
  for(std::size_t seed = 0; seed < 4000; ++seed)
    BOOST_TEST_CONTEXT("seed " << seed)
    {
      Random random(seed);
      const Graph graph = random_graph_with_values(seed, random);
      const double threshold = static_cast<double>(random.below(30));
      const std::size_t leaves = random.below(2) == 0 ? 0 : random.below(8);
      Graph result;
      const auto map = CGAL::Reeb_graph::simplify(graph, threshold, result, parameters::number_of_leaves(leaves));
      test_against_oracle(graph, result, map, Simplification_oracle(graph, threshold, leaves));
    }
}

BOOST_AUTO_TEST_CASE(simplified_graphs_keep_loops_and_have_no_node_that_is_passed)
{
  for(std::size_t seed = 0; seed < 3000; ++seed)
    BOOST_TEST_CONTEXT("seed " << seed)
    {
      Random random(seed);
      const Graph graph = random_graph_with_values(seed, random);
      const std::size_t loops = count_loops(graph);
      std::size_t last_number = num_vertices(graph) + 1;
      for(const double threshold : {0., 2., 5., 20., infinity})
      {
        const Graph result = simplified(graph, threshold);
        BOOST_TEST(count_loops(result) == loops);
        BOOST_TEST(!has_degree_two_node(result));
        BOOST_TEST(num_vertices(result) <= last_number);
        last_number = num_vertices(result);
      }
    }
}

// Each node of the graph of a larger threshold is one of that of a smaller threshold, and what stays together there
// stays together.
BOOST_AUTO_TEST_CASE(simplification_is_monotone)
{
  for(std::size_t seed = 0; seed < 2000; ++seed)
    BOOST_TEST_CONTEXT("seed " << seed)
    {
      Random random(seed);
      const Graph graph = random_graph_with_values(seed, random);
      const double threshold = static_cast<double>(random.below(10)), larger = threshold + random.below(10);
      Graph less, more;
      const auto less_map = CGAL::Reeb_graph::simplify(graph, threshold, less);
      const auto more_map = CGAL::Reeb_graph::simplify(graph, larger, more);
      for(std::size_t node = 0; node < num_vertices(graph); ++node)
        if(more_map.index_of_node(node) < num_vertices(more) && more[more_map.index_of_node(node)].vertex == node)
          BOOST_TEST(
            (less_map.index_of_node(node) < num_vertices(less) && less[less_map.index_of_node(node)].vertex == node));
      for(std::size_t a = 0; a < num_vertices(graph); ++a)
        for(std::size_t b = 0; b < a; ++b)
          if(less_map.index_of_node(a) == less_map.index_of_node(b))
            BOOST_TEST(more_map.index_of_node(a) == more_map.index_of_node(b));
    }
}

// The measure of a leaf arc by its ends alone forgets nothing when the graph is simplified.
BOOST_AUTO_TEST_CASE(simplification_of_meshes_by_ends_of_arcs_is_idempotent)
{
  for(std::size_t seed = 0; seed < 2000; ++seed)
    BOOST_TEST_CONTEXT("seed " << seed)
    {
      Random random(seed);
      const auto combinatorial_mesh = random_meshes::random_mesh(static_cast<Mesh_class>(seed % 6), random);
      const auto values =
        random_meshes::random_field(combinatorial_mesh, static_cast<Field_class>(seed / 6 % 7), random);
      const auto mesh = make_mesh<mesh_builders::Surface_mesh>(combinatorial_mesh);
      const auto graph = compute<CGAL::Sequential_tag>(mesh, CGAL::Reeb_graph::make_scalar_map(mesh, values),
                                                       settings_of_seed(seed / 42));
      const double threshold = static_cast<double>(random.below(combinatorial_mesh.number_of_vertices + 1));
      const auto once = simplified_by_ends(graph, threshold);
      BOOST_TEST(graph_checks::are_identical(simplified_by_ends(once, threshold), once));
      if(!has_degree_two_node(graph))
        BOOST_TEST(graph_checks::are_identical(simplified(graph, 0), graph));
    }
}

BOOST_AUTO_TEST_CASE(simplification_by_ends_of_arcs_is_idempotent)
{
  std::size_t number_of_exceptions = 0;
  for(std::size_t seed = 0; seed < 3000; ++seed)
    BOOST_TEST_CONTEXT("seed " << seed)
    {
      Random random(seed);
      const Graph graph = random_graph_with_values(seed, random);
      const double threshold = static_cast<double>(1 + random.below(20));
      const Graph by_ends = simplified_by_ends(graph, threshold), once = simplified(graph, threshold);
      BOOST_TEST(graph_checks::are_identical(simplified_by_ends(by_ends, threshold), by_ends));
      number_of_exceptions += graph_checks::are_identical(simplified(once, threshold), once) ? 0 : 1;
    }
  BOOST_TEST(number_of_exceptions < 100u); // values farther away than the leaf are forgotten
}

// How far what has been taken up by a node is from it.
BOOST_AUTO_TEST_CASE(no_value_is_farther_away_than_the_threshold)
{
  for(std::size_t seed = 0; seed < 2000; ++seed)
    BOOST_TEST_CONTEXT("seed " << seed)
    {
      Random random(seed);
      const Graph graph = random_graph_with_values(seed, random);
      const double threshold = static_cast<double>(1 + random.below(20));
      Graph result;
      const auto map = CGAL::Reeb_graph::simplify(graph, threshold, result);
      for(std::size_t node = 0; node < num_vertices(graph); ++node)
        if(map.index_of_node(node) < num_vertices(result) && result[map.index_of_node(node)].vertex != node)
          BOOST_TEST(std::abs(result[map.index_of_node(node)].value - graph[node].value) < threshold);
    }
}

BOOST_AUTO_TEST_CASE(large_thresholds_leave_trees_of_one_arc)
{
  for(std::size_t seed = 0; seed < 200; ++seed)
    BOOST_TEST_CONTEXT("seed " << seed)
    {
      Random random(seed);
      const Graph graph = random_graphs::random_sparse_graph(2 + random.below(300), 0, random);
      BOOST_TEST(number_of_leaves(simplified(graph, infinity)) == 2u);
      Graph result;
      CGAL::Reeb_graph::simplify(graph, infinity, result, parameters::number_of_leaves(5));
      BOOST_TEST(number_of_leaves(result) <= (std::max)(std::size_t(5), std::size_t(2)));
      BOOST_TEST(number_of_leaves(result) == (std::min)(number_of_leaves(graph), std::size_t(5)));
    }
}

BOOST_AUTO_TEST_CASE(small_loops_are_removed_on_request)
{
  // 0-1, a loop 1-3 one side of which has a branch, 3-4, a loop 4-5, 5-6
  Graph graph = random_graphs::make_graph(8, {{0, 1}, {1, 2}, {1, 4}, {2, 3}, {2, 4}, {4, 5}, {5, 6}, {5, 6}, {6, 7}});
  Graph result;
  CGAL::Reeb_graph::simplify(graph, 2, result, parameters::cancel_loops(true));
  BOOST_TEST(count_loops(result) == 1u); // 1-4 is 3 long
  CGAL::Reeb_graph::simplify(graph, 4, result, parameters::cancel_loops(true));
  BOOST_TEST(count_loops(result) == 0u);
  BOOST_TEST(num_vertices(result) == 2u);
  CGAL::Reeb_graph::simplify(graph, 4, result);
  BOOST_TEST(count_loops(result) == 2u);
}

// A loop stays only if arcs that stay leave both of its sides; those of the loops that stay keep their pairs.
BOOST_AUTO_TEST_CASE(cancelled_loops_of_random_graphs)
{
  std::size_t number_of_cancelled = 0, number_of_left = 0;
  for(std::size_t seed = 0; seed < 3000; ++seed)
    BOOST_TEST_CONTEXT("seed " << seed)
    {
      Random random(seed);
      const Graph graph = random_graph_with_values(seed, random);
      const double threshold = static_cast<double>(random.below(40));
      Graph result, again;
      const auto map = CGAL::Reeb_graph::simplify(graph, threshold, result, parameters::cancel_loops(true));
      BOOST_TEST(!has_degree_two_node(result));
      std::vector<double> expected, found;
      for(const auto& pair : persistence_oracle::found_pairs(graph))
        if(pair.kind == Persistence_pair_kind::LOOP && CGAL::Reeb_graph::persistence(graph, pair) >= threshold)
          expected.push_back(CGAL::Reeb_graph::persistence(graph, pair));
      for(const auto& pair : persistence_oracle::found_pairs(result))
        if(pair.kind == Persistence_pair_kind::LOOP)
        {
          const double persistence = CGAL::Reeb_graph::persistence(result, pair);
          if(persistence >= threshold)
            found.push_back(persistence);
          else
            ++number_of_left;
        }
      number_of_cancelled += count_loops(graph) - count_loops(result);
      std::sort(expected.begin(), expected.end());
      std::sort(found.begin(), found.end());
      BOOST_TEST(found == expected, boost::test_tools::per_element());
      for(std::size_t node = 0; node < num_vertices(graph); ++node)
        BOOST_TEST(map.index_of_node(node) < num_vertices(result) + num_edges(result));
      for(std::size_t arc = 0; arc < num_edges(graph); ++arc)
        BOOST_TEST(map.index_of_arc(arc) < num_vertices(result) + num_edges(result));
    }
  BOOST_TEST(number_of_cancelled > 10 * number_of_left, number_of_cancelled << " cancelled, left " << number_of_left);
}

BOOST_AUTO_TEST_CASE(other_measures)
{
  //  0 and 1 below 2, 2 to 3, 4 and 5 above 3
  const Graph graph = random_graphs::make_graph(6, {{0, 2}, {1, 2}, {2, 3}, {3, 4}, {3, 5}});
  std::vector<double> weights(11, 1);
  weights[0] = 0;  // node 0
  weights[10] = 7; // arc 3-5
  Graph result;
  auto map = CGAL::Reeb_graph::simplify(graph, 1.5, result, parameters::place_weights(weights));
  BOOST_TEST(num_vertices(result) == 4u); // without node 0
  BOOST_TEST(result[0].vertex == 1u);
  BOOST_TEST(map.index_of_node(0) == 4u);
  map = CGAL::Reeb_graph::simplify(graph, 2.5, result, parameters::place_weights(weights));
  BOOST_TEST(num_vertices(result) == 2u);
  BOOST_TEST(result[1].vertex == 5u);

  const auto only_maxima = [](const auto& branch) { return branch.is_minimum ? 100. : branch.persistence; };
  CGAL::Reeb_graph::simplify(graph, 50, result, parameters::branch_measure(only_maxima));
  BOOST_TEST(num_vertices(result) == 4u);
  BOOST_TEST(num_edges(result) == 3u);
}

BOOST_AUTO_TEST_CASE(graph_that_is_its_own_result)
{
  Graph graph = random_graphs::make_graph(4, {{0, 2}, {1, 2}, {2, 3}});
  CGAL::Reeb_graph::simplify(graph, 2, graph);
  BOOST_TEST(num_vertices(graph) == 2u);
  BOOST_TEST(graph[0].vertex == 0u);
}

BOOST_AUTO_TEST_CASE(bad_input)
{
  using namespace CGAL::Reeb_graph;
  const Graph graph = random_graphs::make_graph(4, {{0, 2}, {1, 2}, {2, 3}});
  Graph result = graph;
  BOOST_CHECK_THROW(simplify(graph, -1, result), Parameter_error);
  BOOST_CHECK_THROW(simplify(graph, std::nan(""), result), Parameter_error);
  BOOST_CHECK_THROW(simplify(graph, 1, result, parameters::place_weights(std::vector<double>(6))), Parameter_error);
  BOOST_CHECK_THROW(simplify(graph, 1, result, parameters::place_weights(std::vector<double>(7, std::nan("")))),
                    Parameter_error);
  BOOST_CHECK_THROW(simplify(graph, 1, result, parameters::branch_measure([](const auto&) { return std::nan(""); })),
                    Parameter_error);
  BOOST_CHECK_THROW(simplify(random_graphs::make_graph(2, {{1, 0}}), 1, result), Graph_mismatch_error);
  BOOST_TEST(num_vertices(result) == 4u);
  const auto map = simplify(graph, 1, result);
  BOOST_CHECK_THROW(map[4], Graph_mismatch_error);
  BOOST_CHECK_THROW(map.place_of_arc(3), Graph_mismatch_error);
}

BOOST_AUTO_TEST_CASE(the_arcs_of_a_simplified_tree_are_those_of_enough_persistence)
{
  for(std::size_t seed = 0; seed < 500; ++seed)
    BOOST_TEST_CONTEXT("seed " << seed)
    {
      Random random(seed);
      Graph tree = random_graphs::random_sparse_graph(2 + random.below(40), 0, random);
      set_random_values(tree, random);
      const std::vector<double> persistences = CGAL::Reeb_graph::arc_persistences(tree);
      BOOST_REQUIRE(persistences.size() == num_edges(tree));
      const double range = tree[num_vertices(tree) - 1].value - tree[0].value;
      for(double threshold = 0; threshold <= range; ++threshold)
      {
        const Graph result = simplified(tree, threshold);
        std::vector<bool> is_left(persistences.size(), false);
        for(auto arcs = edges(result); arcs.first != arcs.second; ++arcs.first)
          for(const std::size_t arc : result[*arcs.first].chain)
            is_left[arc] = true;
        for(std::size_t arc = 0; arc < persistences.size(); ++arc)
          BOOST_TEST(is_left[arc] == (persistences[arc] >= threshold));
      }
    }
}

BOOST_AUTO_TEST_CASE(one_side_of_a_loop_has_its_persistence)
{
  // a loop from 1 to 5, a leaf arc at one of its sides, and an isolated node
  const Graph graph = random_graphs::make_graph(8, {{0, 1}, {1, 2}, {1, 5}, {2, 3}, {2, 5}, {5, 6}});
  const std::vector<double> persistences = CGAL::Reeb_graph::arc_persistences(graph);
  BOOST_REQUIRE(persistences.size() == 6u);
  for(const std::size_t arc : {0, 5})
    BOOST_TEST(persistences[arc] == 6);
  BOOST_TEST(persistences[3] == 1);
  BOOST_TEST(persistences[1] == persistences[4]);
  BOOST_TEST((std::min)(persistences[1], persistences[2]) == 4);
  BOOST_TEST((std::max)(persistences[1], persistences[2]) == 6);
}

BOOST_AUTO_TEST_CASE(arcs_have_the_persistence_at_which_they_are_removed_one_by_one)
{
  for(std::size_t seed = 0; seed < 1000; ++seed)
    BOOST_TEST_CONTEXT("seed " << seed)
    {
      Random random(seed);
      const std::size_t number_of_nodes = 2 + random.below(25);
      Graph graph = random_graphs::random_sparse_graph(number_of_nodes, random.below(8), random);
      set_random_values(graph, random);
      BOOST_TEST(CGAL::Reeb_graph::arc_persistences(graph) == simplification_oracle::Removal_oracle(graph).persistences,
                 boost::test_tools::per_element());
    }
}

// Loops of different persistence, each between its leaf arcs: a way that looks at all that is left for each of them
// would take minutes.
BOOST_AUTO_TEST_CASE(arcs_of_a_graph_of_many_loops_have_their_persistence_in_near_linear_time)
{
  const std::size_t number_of_loops = 50000;
  std::vector<random_graphs::Arc> arcs;
  for(std::size_t i = 0; i < number_of_loops; ++i)
  {
    arcs.insert(arcs.end(), 2, {2 * i + 1, 2 * i + 2});
    arcs.emplace_back(2 * i, 2 * i + 1);
  }
  Graph graph = random_graphs::make_graph(2 * number_of_loops + 1, arcs);
  Random random(1);
  for(std::size_t node = 1; node < num_vertices(graph); ++node)
    graph[node].value = graph[node - 1].value + 1 + static_cast<double>(random.below(1000000));
  const std::vector<double> persistences = CGAL::Reeb_graph::arc_persistences(graph);
  const double range = graph[2 * number_of_loops].value - graph[0].value;
  BOOST_TEST(std::count(persistences.begin(), persistences.end(), range) == 2 * number_of_loops);
}

BOOST_AUTO_TEST_CASE(arcs_of_any_graph_have_a_persistence_within_its_range)
{
  for(std::size_t seed = 0; seed < 500; ++seed)
    BOOST_TEST_CONTEXT("seed " << seed)
    {
      Random random(seed);
      const Graph graph = random_graph_with_values(seed, random);
      std::size_t number = 0;
      const std::vector<double> persistences = CGAL::Reeb_graph::arc_persistences(graph);
      for(auto arcs = edges(graph); arcs.first != arcs.second; ++arcs.first, ++number)
      {
        BOOST_TEST(persistences[number] >= 0);
        BOOST_TEST(persistences[number] <= graph[num_vertices(graph) - 1].value - graph[0].value);
      }
      BOOST_TEST(number == persistences.size());
    }
}

BOOST_AUTO_TEST_SUITE_END()
