// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

// GUDHI finds the property maps that are pointers only if nothing else has included Boost's disjoint sets before.
#include <boost/property_map/property_map.hpp>

#include <gudhi/Bottleneck.h>
#include <gudhi/Persistent_cohomology.h>
#include <gudhi/Simplex_tree.h>

#include <boost/test/unit_test.hpp>

#include "computed_graphs.h"
#include "persistence_oracle.h"

#include <CGAL/Reeb_graph/comparison/bottleneck_distance.h>
#include <CGAL/Reeb_graph/simplification/persistence_pairs.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <tuple>
#include <utility>
#include <vector>

// Persistence pairs are those that GUDHI finds on the surface.
//
// Persistence diagrams are stable: noise moves their points by no more than its largest value (D. Cohen-Steiner, H.
// Edelsbrunner, J. Harer, Stability of Persistence Diagrams, 2007). The distance of two diagrams is that of GUDHI.

BOOST_AUTO_TEST_SUITE(test_persistence_stability)

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
typedef std::tuple<int, double, double> Interval; // dimension, birth, death

// The extended persistence of the surface itself, of all its triangles, that tells about its Reeb graph: the ordinary
// classes of dimension 0, the relative ones of dimension 1, the components, and of the loops those that are born above,
// as M. Carrière, S. Oudot, Structure and Stability of the One-Dimensional Mapper, 2018, say. The values are whole
// numbers.
std::vector<Interval> intervals_of_gudhi(const Combinatorial_mesh& mesh, const std::vector<double>& values)
{
  typedef Gudhi::Simplex_tree<> Simplex_tree;
  typedef Gudhi::Extended_simplex_type Type;
  Simplex_tree complex;
  for(std::size_t v = 0; v < values.size(); ++v)
    complex.insert_simplex(std::vector<int>{static_cast<int>(v)}, values[v]);
  for(const auto& triangle : mesh.triangles)
    complex.insert_simplex_and_subfaces(std::vector<int>(triangle.begin(), triangle.end()));
  for(const auto& simplex : complex.complex_simplex_range()) // inserting a triangle lowers the values of its vertices
    if(complex.dimension(simplex) == 0)
      complex.assign_filtration(simplex,
                                values[static_cast<std::size_t>(*complex.simplex_vertex_range(simplex).begin())]);
  const auto range = complex.extend_filtration();
  Gudhi::persistent_cohomology::Persistent_cohomology<Simplex_tree, Gudhi::persistent_cohomology::Field_Zp> persistence(
    complex, true);
  persistence.init_coefficients(2);
  persistence.compute_persistent_cohomology();

  std::vector<Interval> intervals;
  for(const auto& pair : persistence.get_persistent_pairs())
  {
    const auto [birth, birth_type] = complex.decode_extended_filtration(complex.filtration(std::get<0>(pair)), range);
    const auto [death, death_type] = complex.decode_extended_filtration(complex.filtration(std::get<1>(pair)), range);
    if(birth_type == Type::EXTRA || death_type == Type::EXTRA)
      continue; // the apex of the cone
    const Interval interval(complex.dimension(std::get<0>(pair)), std::round(birth), std::round(death));
    const bool is_essential = birth_type != death_type, is_born_above = std::get<1>(interval) > std::get<2>(interval);
    if(std::get<0>(interval) == 0 || (std::get<0>(interval) == 1 && birth_type == Type::DOWN && !is_essential)
       || (std::get<0>(interval) == 1 && is_essential && is_born_above))
      intervals.push_back(interval);
  }
  std::sort(intervals.begin(), intervals.end());
  return intervals;
}

// The same of the pairs, as the program writes them to .pers files.
template <class Graph>
std::vector<Interval> intervals_of_pairs(const Graph& graph)
{
  std::vector<Interval> intervals;
  for(const Pair& pair : persistence_oracle::found_pairs(graph))
  {
    const double lower = graph[pair.lower_node].value, upper = graph[pair.upper_node].value;
    if(pair.kind == Persistence_pair_kind::MINIMUM_SADDLE || pair.kind == Persistence_pair_kind::MINIMUM_MAXIMUM)
      intervals.emplace_back(0, lower, upper);
    else
      intervals.emplace_back(1, upper, lower);
  }
  std::sort(intervals.begin(), intervals.end());
  return intervals;
}
} // namespace

BOOST_AUTO_TEST_CASE(pairs_are_those_of_the_surface)
{
  std::size_t number_of_loops = 0;
  for(std::size_t seed = 0; seed < 600; ++seed)
    BOOST_TEST_CONTEXT("seed " << seed)
    {
      Random random(seed);
      const auto mesh = random_meshes::random_mesh(static_cast<Mesh_class>(seed % 6), random);
      const auto values = random_meshes::random_field(mesh, Field_class::PERMUTATION, random);
      if(values.size() < 2)
        continue; // GUDHI divides by the range of the values.
      const auto graph = graph_checks::compute(make_mesh<mesh_builders::Surface_mesh>(mesh), values);
      const auto intervals = intervals_of_pairs(graph), expected = intervals_of_gudhi(mesh, values);
      BOOST_TEST((intervals == expected), intervals.size() << " and " << expected.size() << " intervals");
      number_of_loops += num_edges(graph) + 1 > num_vertices(graph) ? 1 : 0;
    }
  BOOST_TEST(number_of_loops > 100u);
}

// Random numbers, and whole ones, of which many are equal.
BOOST_AUTO_TEST_CASE(the_bottleneck_distance_is_that_of_gudhi)
{
  for(std::size_t seed = 0; seed < 300; ++seed)
    BOOST_TEST_CONTEXT("seed " << seed)
    {
      Random random(seed);
      std::array<Diagram, 2> diagrams;
      std::array<std::vector<CGAL::Reeb_graph::Persistence_values>, 2> pairs;
      const double unit = seed % 2 == 0 ? 1 : 0.0009765625;
      for(std::size_t i = 0; i < 2; ++i)
        for(std::size_t k = random.below(60); k > 0; --k)
        {
          const double lower = unit * static_cast<double>(random.below(seed % 2 == 0 ? 12 : 9999)),
                       upper = lower + unit * static_cast<double>(1 + random.below(seed % 2 == 0 ? 9 : 4999));
          diagrams[i].emplace_back(lower, upper);
          pairs[i].push_back({lower, upper, Persistence_pair_kind::LOOP});
        }
      BOOST_TEST(CGAL::Reeb_graph::bottleneck_distance(pairs[0], pairs[1])
                 == Gudhi::persistence_diagram::bottleneck_distance(diagrams[0], diagrams[1], 0.));
    }
}

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

BOOST_AUTO_TEST_SUITE_END()
