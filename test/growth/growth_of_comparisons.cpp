// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#include "Table.h"
#include "generated_surfaces/build_mesh.h"
#include "generated_surfaces/posed_body.h"
#include "random_meshes.h"
#include "surfaces.h"

#include <CGAL/Reeb_graph/comparison/bottleneck_distance.h>
#include <CGAL/Reeb_graph/comparison/match_tips.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <memory>
#include <vector>

// Two shapes compared.
namespace growth {
namespace {
constexpr double most_per_doubling = 1.32; // 2.5 for twice as many

// Two bodies, each in a pose of its own.
struct Two_bodies
{
  explicit Two_bodies(std::size_t number_of_vertices) : a(body(1, number_of_vertices)), b(body(2, number_of_vertices))
  {}
  static Mesh body(unsigned seed, std::size_t number_of_vertices)
  {
    return generated_surfaces::make_mesh<Mesh>(generated_surfaces::posed_body(seed, seed, number_of_vertices).soup);
  }
  std::size_t size() const { return a.number_of_faces() + b.number_of_faces(); }

  Mesh a, b;
};

// Pairs as of white noise: of any persistence, so that for many of them most others are as near as the distance. Or all of
// one saddle, from which peaks of any height rise.
struct Two_sets_of_pairs
{
  typedef std::vector<CGAL::Reeb_graph::Persistence_values> Pairs;

  Two_sets_of_pairs(std::size_t number, bool is_of_one_saddle)
    : a(pairs(1, number, is_of_one_saddle)),
      b(pairs(2, number, is_of_one_saddle))
  {}
  static Pairs pairs(unsigned seed, std::size_t number, bool is_of_one_saddle)
  {
    random_meshes::Random random(seed);
    const auto uniform = [&] { return static_cast<double>(random.below(1000000)) / 1000000; };
    Pairs pairs(number);
    for(auto& pair : pairs)
    {
      pair.lower = is_of_one_saddle ? 0 : uniform();
      pair.upper = pair.lower + (is_of_one_saddle ? uniform() : std::pow(uniform(), 8));
      pair.kind = CGAL::Reeb_graph::Persistence_pair_kind::SADDLE_MAXIMUM;
    }
    return pairs;
  }
  std::size_t size() const { return a.size() + b.size(); }

  Pairs a, b;
};
} // namespace

void measure_comparisons(Table& table)
{
  const Function<Two_bodies> tips = {"match_tips",
                                     [](const Two_bodies& bodies) {
                                       typedef Mesh::Vertex_index Vertex;
                                       std::vector<CGAL::Reeb_graph::Tip_pair<Vertex, Vertex>> found;
                                       CGAL::Reeb_graph::match_tips(bodies.a, bodies.b, std::back_inserter(found));
                                       return found.size();
                                     },
                                     most_per_doubling};
  table.measure("two bodies", at_three_sizes<Two_bodies>(4000, [](std::size_t size) { return size; }), tips);
  Function<Two_sets_of_pairs> distance = {"bottleneck_distance", [](const Two_sets_of_pairs& sets) {
                                            CGAL::Reeb_graph::bottleneck_distance(sets.a, sets.b);
                                            return std::size_t(0);
                                          }};
  const auto sets = [](bool is_of_one_saddle) {
    std::array<std::unique_ptr<const Two_sets_of_pairs>, 3> result;
    for(std::size_t i = 0; i != 3; ++i)
      result[i] = std::make_unique<const Two_sets_of_pairs>(std::size_t(4000) << i, is_of_one_saddle);
    return result;
  };
  table.measure("pairs of one saddle", sets(true), distance);
  distance.largest_exponent = 2.2;
  table.measure("pairs of white noise", sets(false), distance);
}
} // namespace growth
