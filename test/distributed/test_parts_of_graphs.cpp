// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

// What ranks keep of the graph, what they count, and the graphs of triangles that are no surface.

#include "ranks.h"

#include "graph_checks.h"
#include "level_border_fields.h"
#include "random_complexes.h"
#include "random_fields.h"

#include <boost/mpi/collectives.hpp>
#include <boost/serialization/utility.hpp>
#include <boost/serialization/vector.hpp>
#include <boost/test/unit_test.hpp>

#include <array>
#include <cstddef>
#include <functional>
#include <utility>
#include <vector>

BOOST_AUTO_TEST_SUITE(test_parts_of_graphs)

using random_meshes::Combinatorial_mesh;
using random_meshes::Random;
using namespace ranks;

namespace parameters = CGAL::parameters;
typedef CGAL::Reeb_graph::Distributed_slab<double> Slab;

namespace {
// A larger mesh than those of other tests, often with border, and a smooth field, whose chains pass several slabs.
Surface<double> smooth_surface(std::size_t seed, Random& random)
{
  Combinatorial_mesh mesh = random_meshes::random_closed_surface(seed % 3, 100 + random.below(200), random);
  random_meshes::remove_random_triangles(mesh, random.below(3) * 10, random);
  random_meshes::relabel(mesh, random);
  std::vector<double> values = random_meshes::smooth_field(mesh, random);
  for(int round = 0; round < 8; ++round)
  {
    std::vector<double> sums = values, weights(values.size(), 1);
    for(const auto& t : mesh.triangles)
      for(std::size_t i = 0; i < 3; ++i)
      {
        sums[t[i]] += values[t[(i + 1) % 3]];
        ++weights[t[i]];
      }
    for(std::size_t v = 0; v < values.size(); ++v)
      values[v] = sums[v] / weights[v];
  }
  return {mesh, values};
}

typedef std::vector<std::pair<std::size_t, std::size_t>> Vertex_pairs;

// The chains that all ranks keep, at rank 0.
std::vector<Vertex_pairs> gather_kept_chains(const Slab& slab, std::size_t number_of_arcs)
{
  std::vector<std::pair<std::size_t, Vertex_pairs>> parts;
  for(const auto& part : slab.chain_parts)
  {
    BOOST_TEST(part.size >= 2u);
    parts.push_back({part.arc, {}});
    for(std::size_t i = part.begin + 1; i < part.begin + part.size; ++i)
      parts.back().second.emplace_back(slab.chain_vertices[i - 1], slab.chain_vertices[i]);
  }
  std::vector<std::vector<std::pair<std::size_t, Vertex_pairs>>> parts_of_ranks;
  boost::mpi::gather(world(), parts, parts_of_ranks, 0);
  std::vector<Vertex_pairs> chains(number_of_arcs);
  for(const auto& parts_of_rank : parts_of_ranks)
    for(const auto& [arc, pairs] : parts_of_rank)
      chains.at(arc).insert(chains.at(arc).end(), pairs.begin(), pairs.end());
  return chains;
}

struct Counting_visitor : CGAL::Reeb_graph::Default_visitor
{
  void critical_vertices(const CGAL::Reeb_graph::Critical_vertex_counts& c) { counts = c; }
  CGAL::Reeb_graph::Critical_vertex_counts counts;
};

std::size_t number_of_border_edges(const Combinatorial_mesh& mesh)
{
  const auto edges = random_meshes::directed_edges(mesh);
  std::size_t number = 0;
  for(const auto& edge : edges)
    number += edges.count({edge.first.second, edge.first.first}) == 0 ? 1 : 0;
  return number;
}
} // namespace

BOOST_AUTO_TEST_CASE(chains_stay_on_the_ranks)
{
  for(std::size_t seed = 0; seed < 20; ++seed)
    for(const auto ties : {CGAL::Reeb_graph::Ties::PERTURB, CGAL::Reeb_graph::Ties::CONTRACT})
      BOOST_TEST_CONTEXT("seed " << seed)
      {
        Random random(seed);
        Surface<double> surface = smooth_surface(seed, random);
        if(seed % 2 == 1)
          for(double& value : surface.values)
            value = static_cast<double>(static_cast<int>(value / 8));
        const auto input = random_part(surface, random);
        Slab slab;
        const auto np = parameters::ties(ties).slab(std::ref(slab));
        const auto graph = graph_on_ranks(input, np.gather_chains(false));
        const auto kept_chains = gather_kept_chains(slab, num_edges(graph));
        const auto gathered = graph_on_ranks(input, np);
        BOOST_TEST(slab.chain_parts.empty());
        if(rank() != 0)
          continue;
        auto expected = graph_of_whole(surface, parameters::ties(ties));
        BOOST_TEST(graph_checks::are_identical(gathered, expected));
        std::size_t number = 0;
        for(const auto arc : CGAL::make_range(edges(expected)))
        {
          const Vertex_pairs& kept = kept_chains[number++];
          BOOST_TEST((kept == Vertex_pairs(expected[arc].chain.begin(), expected[arc].chain.end())));
          expected[arc].chain = {};
        }
        BOOST_TEST(graph_checks::are_identical(graph, expected));
      }
}

BOOST_AUTO_TEST_CASE(ranks_count_the_whole_surface)
{
  for(std::size_t seed = 0; seed < 40; ++seed)
    BOOST_TEST_CONTEXT("seed " << seed)
    {
      Random random(1000 + seed);
      Surface<double> surface = smooth_surface(seed, random);
      if(seed % 2 == 1)
        surface.values = random_meshes::random_permutation(surface.values.size(), random);
      Slab slab;
      Counting_visitor visitor, visitor_of_whole;
      graph_on_ranks(random_part(surface, random), parameters::slab(std::ref(slab)).visitor(std::ref(visitor)));
      BOOST_TEST(slab.border_edges == number_of_border_edges(surface.mesh));
      BOOST_TEST(slab.border_loops == random_meshes::border_loops(surface.mesh).size());
      graph_of_whole(surface, parameters::visitor(std::ref(visitor_of_whole)));
      BOOST_TEST(visitor.counts.isolated == visitor_of_whole.counts.isolated);
      BOOST_TEST(visitor.counts.minima == visitor_of_whole.counts.minima);
      BOOST_TEST(visitor.counts.maxima == visitor_of_whole.counts.maxima);
      BOOST_TEST(visitor.counts.border_saddles == visitor_of_whole.counts.border_saddles);
      BOOST_TEST((visitor.counts.saddles == visitor_of_whole.counts.saddles));
    }
}

BOOST_AUTO_TEST_CASE(any_triangles)
{
  constexpr auto number_of_classes = static_cast<std::size_t>(random_complexes::Complex_class::NUMBER_OF_CLASSES);
  for(std::size_t seed = 0; seed < 90; ++seed)
    BOOST_TEST_CONTEXT("seed " << seed)
    {
      Random random(seed);
      const auto complex = random_complexes::skeleton(random_complexes::random_complex(
        static_cast<random_complexes::Complex_class>(seed % number_of_classes), random));
      const Surface<double> triangles = {{complex.number_of_vertices, complex.triangles},
                                         random_complexes::random_values(complex.number_of_vertices, random)};
      const auto ties = random.below(2) == 0 ? CGAL::Reeb_graph::Ties::PERTURB : CGAL::Reeb_graph::Ties::CONTRACT;
      const auto np = parameters::ties(ties).keep_degree_two_nodes(random.below(2) == 0);
      const auto input = random_part(triangles, random);
      Graph<double> graph;
      CGAL::compute_reeb_graph_of_soup_distributed(world(), input.vertices, input.triangles, input.scalars, graph, np);
      if(rank() == 0)
        BOOST_TEST(graph_checks::are_identical(graph, graph_of_whole(triangles, np)));
      else
        BOOST_TEST(num_vertices(graph) == 0u);
    }
}

BOOST_AUTO_TEST_SUITE_END()
