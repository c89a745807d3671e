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

#include <CGAL/Reeb_graph/internal/graph/graph_loops.h>
#include <CGAL/Reeb_graph/simplification/persistence_pairs.h>

#include <algorithm>
#include <cstddef>
#include <set>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

// Persistence pairs against the textbook, upside down, and by what they have to add up to.

BOOST_AUTO_TEST_SUITE(test_persistence_pairs)

using namespace computed_graphs;
using namespace persistence_oracle;
using random_graphs::random_graph;

namespace {
std::string written(const std::vector<Pair>& pairs)
{
  std::ostringstream text;
  for(const Pair& pair : pairs)
    text << '(' << pair.lower_node << ',' << pair.upper_node << ' ' << to_string(pair.kind) << ") ";
  return text.str();
}

template <class Graph>
void test_against_oracle(const Graph& graph)
{
  BOOST_TEST(written(found_pairs(graph)) == written(pairs(num_vertices(graph), arcs_of(graph))));
}

std::vector<Pair> pairs_upside_down(const std::vector<Pair>& pairs, std::size_t number_of_nodes)
{
  std::vector<Pair> result;
  for(const Pair& pair : pairs)
  {
    const Persistence_pair_kind kind =
      pair.kind == Persistence_pair_kind::MINIMUM_SADDLE   ? Persistence_pair_kind::SADDLE_MAXIMUM
      : pair.kind == Persistence_pair_kind::SADDLE_MAXIMUM ? Persistence_pair_kind::MINIMUM_SADDLE
                                                           : pair.kind;
    result.push_back({number_of_nodes - 1 - pair.upper_node, number_of_nodes - 1 - pair.lower_node, kind});
  }
  std::sort(result.begin(), result.end());
  return result;
}

std::size_t count(const std::vector<Pair>& pairs, Persistence_pair_kind kind)
{
  return std::count_if(pairs.begin(), pairs.end(), [&](const Pair& pair) { return pair.kind == kind; });
}

// A forest as nothing but its edges.
class Plain_forest
{
public:
  explicit Plain_forest(std::size_t size) : neighbors_(size) {}

  void link(std::size_t a, std::size_t b)
  {
    neighbors_[a].insert(b);
    neighbors_[b].insert(a);
  }

  void cut(std::size_t a, std::size_t b)
  {
    neighbors_[a].erase(b);
    neighbors_[b].erase(a);
  }

  // from one to the other, empty if there is none
  std::vector<std::size_t> path(std::size_t from, std::size_t to) const
  {
    std::vector<std::vector<std::size_t>> paths = {{from}};
    for(std::size_t i = 0; i < paths.size(); ++i)
    {
      if(paths[i].back() == to)
        return paths[i];
      for(const std::size_t next : neighbors_[paths[i].back()])
        if(paths[i].size() < 2 || paths[i][paths[i].size() - 2] != next)
        {
          std::vector<std::size_t> longer = paths[i];
          longer.push_back(next);
          paths.push_back(longer);
        }
    }
    return {};
  }

private:
  std::vector<std::set<std::size_t>> neighbors_;
};
} // namespace

// J. Tu, M. Hajij, P. Rosen, Propagate and Pair, 2019. Nodes are their values.
BOOST_AUTO_TEST_CASE(example_of_propagate_and_pair)
{
  const auto graph = random_graphs::make_graph(16, {{0, 2},
                                                    {1, 2},
                                                    {2, 3},
                                                    {3, 5},
                                                    {3, 6},
                                                    {4, 6},
                                                    {5, 9},
                                                    {5, 9},
                                                    {6, 11},
                                                    {7, 8},
                                                    {8, 11},
                                                    {8, 10},
                                                    {9, 10},
                                                    {10, 12},
                                                    {11, 12},
                                                    {12, 13},
                                                    {13, 14},
                                                    {13, 15}});
  const std::vector<Pair> expected = {{0, 15, Persistence_pair_kind::MINIMUM_MAXIMUM},
                                      {1, 2, Persistence_pair_kind::MINIMUM_SADDLE},
                                      {3, 11, Persistence_pair_kind::LOOP},
                                      {4, 6, Persistence_pair_kind::MINIMUM_SADDLE},
                                      {5, 9, Persistence_pair_kind::LOOP},
                                      {7, 10, Persistence_pair_kind::MINIMUM_SADDLE},
                                      {8, 12, Persistence_pair_kind::LOOP},
                                      {13, 14, Persistence_pair_kind::SADDLE_MAXIMUM}};
  BOOST_TEST(written(found_pairs(graph)) == written(expected));
  BOOST_TEST(CGAL::Reeb_graph::persistence(graph, expected[2]) == 8);
}

BOOST_AUTO_TEST_CASE(graphs_with_few_nodes)
{
  BOOST_TEST(found_pairs(random_graphs::make_graph(0, {})).empty());
  BOOST_TEST(written(found_pairs(random_graphs::make_graph(2, {}))) == "(0,0 minimum-maximum) (1,1 minimum-maximum) ");
  BOOST_TEST(written(found_pairs(random_graphs::make_graph(2, {{0, 1}, {0, 1}})))
             == "(0,1 minimum-maximum) (0,1 loop) ");
  BOOST_TEST(written(found_pairs(random_graphs::make_graph(3, {{0, 1}, {1, 2}}))) == "(0,2 minimum-maximum) ");
}

BOOST_AUTO_TEST_CASE(random_graphs_have_the_pairs_of_the_textbook)
{
  for(std::size_t seed = 0; seed < 6000; ++seed)
    BOOST_TEST_CONTEXT("seed " << seed)
    {
      Random random(seed);
      test_against_oracle(random_graph(random));
    }
}

BOOST_AUTO_TEST_CASE(larger_graphs_have_the_pairs_of_the_textbook)
{
  for(std::size_t seed = 0; seed < 60; ++seed)
    BOOST_TEST_CONTEXT("seed " << seed)
    {
      Random random(seed);
      const std::size_t size = 20 + random.below(100);
      test_against_oracle(random_graphs::random_sparse_graph(size, random.below(size), random));
    }
}

BOOST_AUTO_TEST_CASE(meshes_have_the_pairs_of_the_textbook)
{
  for(std::size_t seed = 0; seed < 1500; ++seed)
    BOOST_TEST_CONTEXT("seed " << seed)
    {
      Random random(seed);
      const auto mesh_class = static_cast<Mesh_class>(seed % static_cast<std::size_t>(Mesh_class::NUMBER_OF_CLASSES));
      const auto combinatorial_mesh = random_meshes::random_mesh(mesh_class, random);
      const auto field_class =
        static_cast<Field_class>(random.below(static_cast<std::size_t>(Field_class::NUMBER_OF_CLASSES)));
      const auto values = random_meshes::random_field(combinatorial_mesh, field_class, random);
      const auto mesh = make_mesh<mesh_builders::Surface_mesh>(combinatorial_mesh);
      const auto scalar_map = CGAL::Reeb_graph::make_scalar_map(mesh, values);
      const auto graph = compute<CGAL::Sequential_tag>(mesh, scalar_map, settings_of_seed(seed / 6));
      test_against_oracle(graph);
      for(const Pair& pair : found_pairs(graph))
      {
        const double persistence = CGAL::Reeb_graph::persistence(graph, pair);
        BOOST_TEST((persistence == graph[pair.upper_node].value - graph[pair.lower_node].value || persistence == 0));
      }
    }
}

BOOST_AUTO_TEST_CASE(pairs_of_the_graph_upside_down)
{
  for(std::size_t seed = 0; seed < 500; ++seed)
    BOOST_TEST_CONTEXT("seed " << seed)
    {
      Random random(seed);
      const auto graph = seed % 2 == 0 ? random_graph(random) : random_graphs::random_sparse_graph(500, 100, random);
      const std::size_t size = num_vertices(graph);
      BOOST_TEST(written(found_pairs(random_graphs::upside_down(graph)))
                 == written(pairs_upside_down(found_pairs(graph), size)));
    }
}

// As many loop pairs as there are independent loops, also where there are many of both.
BOOST_AUTO_TEST_CASE(number_of_pairs_of_large_graphs)
{
  Random random(7);
  const std::size_t number_of_nodes = 100000, number_of_loops = 20000;
  const auto graph = random_graphs::random_sparse_graph(number_of_nodes, number_of_loops, random);
  const auto pairs = found_pairs(graph);
  BOOST_TEST(count(pairs, Persistence_pair_kind::LOOP) == number_of_loops);
  BOOST_TEST(count(pairs, Persistence_pair_kind::MINIMUM_MAXIMUM) == 1u);
  BOOST_TEST(std::is_sorted(pairs.begin(), pairs.end()));
}

BOOST_AUTO_TEST_CASE(arcs_that_do_not_ascend)
{
  BOOST_CHECK_THROW(found_pairs(random_graphs::make_graph(3, {{0, 1}, {2, 1}})),
                    CGAL::Reeb_graph::Graph_mismatch_error);
  BOOST_CHECK_THROW(found_pairs(random_graphs::make_graph(2, {{1, 1}})), CGAL::Reeb_graph::Graph_mismatch_error);
}

BOOST_AUTO_TEST_CASE(lowest_nodes_of_paths_in_a_forest)
{
  typedef CGAL::Reeb_graph::internal::Index Index;
  for(std::size_t seed = 0; seed < 200; ++seed)
    BOOST_TEST_CONTEXT("seed " << seed)
    {
      Random random(seed);
      const std::size_t size = 2 + random.below(30);
      CGAL::Reeb_graph::internal::Link_cut_forest forest(static_cast<Index>(size));
      Plain_forest plain_forest(size);
      for(Index node = 0; node < size; ++node)
        forest.set_key(node, static_cast<Index>(random.below(1000) * size + node));
      for(std::size_t step = 0; step < 300; ++step)
      {
        const auto a = static_cast<Index>(random.below(size)), b = static_cast<Index>(random.below(size));
        const auto path = plain_forest.path(a, b);
        if(path.empty())
        {
          forest.link(a, b);
          plain_forest.link(a, b);
          continue;
        }
        const auto lowest = *std::min_element(path.begin(), path.end(), [&](std::size_t u, std::size_t v) {
          return forest.key(static_cast<Index>(u)) < forest.key(static_cast<Index>(v));
        });
        BOOST_TEST(forest.lowest_on_path(a, b) == lowest);
        if(path.size() == 1 || random.below(3) != 0)
          continue;
        const std::size_t i = random.below(path.size() - 1);
        forest.cut(static_cast<Index>(path[i]), static_cast<Index>(path[i + 1]));
        plain_forest.cut(path[i], path[i + 1]);
      }
    }
}

BOOST_AUTO_TEST_SUITE_END()
