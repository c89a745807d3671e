// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

// How many limbs of bodies match_arcs() finds again: in other poses of one body, and on other bodies.
// Usage: benchmark_compare [SEED [BODIES [POSES]]]

#include "compared_bodies.h"

#include <cstddef>
#include <cstdlib>
#include <deque>
#include <iomanip>
#include <iostream>

namespace {
struct Score
{
  std::size_t number = 0, number_of_right_ones = 0;

  // Each leaf of `a` counts, also one that has no partner.
  void add(const compared_bodies::Compared_body& a, const compared_bodies::Compared_body& b)
  {
    for(const auto node : CGAL::make_range(vertices(a.graph)))
      number += degree(node, a.graph) == 1 ? 1 : 0;
    for(const auto& [leaf_a, leaf_b] : compared_bodies::matched_leaves(a, b))
      number_of_right_ones += a.parts[leaf_a] == b.parts[leaf_b] ? 1 : 0;
  }
};
} // namespace

int main(int argc, char* argv[])
{
  const auto argument = [&](int i, unsigned default_value) {
    return argc > i ? static_cast<unsigned>(std::strtoul(argv[i], nullptr, 10)) : default_value;
  };
  const unsigned seed = argument(1, 1), number_of_bodies = argument(2, 8), number_of_poses = argument(3, 4);
  std::deque<compared_bodies::Compared_body> bodies; // where nothing is moved
  for(unsigned i = 0; i < number_of_bodies * number_of_poses; ++i)
  {
    const auto posed = generated_surfaces::posed_body(1000 * seed + i / number_of_poses, 1000 * seed + i, 4500);
    bodies.emplace_back(posed, 1, compared_bodies::own_numbers(posed.parts.size()));
  }
  Score within, across;
  for(std::size_t i = 0; i < bodies.size(); ++i)
    for(std::size_t j = 0; j < bodies.size(); ++j)
      if(i != j)
        (i / number_of_poses == j / number_of_poses ? within : across).add(bodies[i], bodies[j]);
  std::cout << std::fixed << std::setprecision(1);
  for(const auto& [name, score] :
      {std::make_pair("one body, other poses", within), std::make_pair("other bodies", across)})
    std::cout << std::left << std::setw(24) << name
              << 100. * static_cast<double>(score.number_of_right_ones) / static_cast<double>(score.number) << " % of "
              << score.number << " limbs\n";
  return EXIT_SUCCESS;
}
