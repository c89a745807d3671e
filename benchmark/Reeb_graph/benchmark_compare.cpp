// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

// How many limbs of bodies match_arcs() finds again, in other poses of one body and on other bodies: with the source at
// the head, at tips that match_tips() finds, and at any tips; and where points of the one body are moved.
// Usage: benchmark_compare [SEED [BODIES [POSES]]]

#include "compared_bodies.h"

#include <CGAL/Reeb_graph/comparison/match_tips.h>
#include <CGAL/Reeb_graph/fields/field_constraints.h>

#include <array>
#include <cstddef>
#include <cstdlib>
#include <deque>
#include <iomanip>
#include <iostream>
#include <iterator>
#include <string>
#include <utility>
#include <vector>

namespace {
using compared_bodies::Compared_body;
typedef compared_bodies::Mesh::Vertex_index Vertex;

struct Score
{
  std::size_t limbs = 0, right_limbs = 0, pairs = 0, flips = 0;

  // Each leaf of `a` counts, also one that has no partner. The sources of a flip are of different parts.
  void add(const Compared_body& a, const Compared_body& b, Vertex source_a, Vertex source_b)
  {
    ++pairs;
    flips += a.parts[source_a] == b.parts[source_b] ? 0 : 1;
    for(const auto node : CGAL::make_range(vertices(a.graph)))
      limbs += degree(node, a.graph) == 1 ? 1 : 0;
    for(const auto& [leaf_a, leaf_b] : compared_bodies::matched_leaves(a, b))
      right_limbs += a.parts[leaf_a] == b.parts[leaf_b] ? 1 : 0;
  }
};

typedef std::array<Score, 2> Scores; // across bodies, and within one

void write(const std::string& name, const Scores& scores)
{
  std::cout << std::left << std::setw(20) << name << std::right;
  for(const std::size_t i : {1, 0})
    std::cout << std::setw(8)
              << 100. * static_cast<double>(scores[i].right_limbs) / static_cast<double>(scores[i].limbs) << " % of "
              << std::setw(5) << scores[i].limbs << std::setw(8)
              << 100. * static_cast<double>(scores[i].flips) / static_cast<double>(scores[i].pairs) << " % of "
              << std::setw(5) << scores[i].pairs;
  std::cout << std::endl;
}

Vertex any_tip(const Compared_body& body)
{
  std::vector<std::pair<Vertex, Vertex>> far_apart;
  CGAL::Reeb_graph::find_far_apart_vertices(body.mesh, std::back_inserter(far_apart));
  return far_apart.front().first;
}
} // namespace

int main(int argc, char* argv[])
{
  const auto argument = [&](int i, unsigned default_value) {
    return argc > i ? static_cast<unsigned>(std::strtoul(argv[i], nullptr, 10)) : default_value;
  };
  const unsigned seed = argument(1, 1), number_of_bodies = argument(2, 8), number_of_poses = argument(3, 4);
  typedef std::deque<Compared_body> Bodies; // where nothing is moved
  const auto add_bodies = [&](double noise, Bodies& bodies) {
    for(unsigned i = 0; i < number_of_bodies * number_of_poses; ++i)
    {
      const auto posed = compared_bodies::posed_body(1000 * seed + i / number_of_poses, 1000 * seed + i, noise);
      random_meshes::Random random(i);
      auto numbers = compared_bodies::own_numbers(posed.parts.size());
      random.shuffle(numbers); // on which the first tip depends
      bodies.emplace_back(posed, 1, numbers);
    }
  };
  Bodies bodies;
  add_bodies(0, bodies);
  const std::size_t size = bodies.size();
  const auto is_same_body = [&](std::size_t i, std::size_t j) {
    return i / number_of_poses == j / number_of_poses ? 1 : 0;
  };
  const auto score_all = [&](const std::string& name, const Bodies& others, const auto& source) {
    Scores scores;
    for(std::size_t i = 0; i < size; ++i)
      for(std::size_t j = 0; j < size; ++j)
        if(i != j)
          scores[is_same_body(i, j)].add(bodies[i], others[j], source(bodies[i]), source(others[j]));
    write(name, scores);
  };
  const auto head = [](const Compared_body& body) { return body.top_of_head; };
  std::cout << std::fixed << std::setprecision(1) << "                      limbs of one body   flips              "
            << "limbs of others     flips\n";
  score_all("head", bodies, head);
  for(const int percent : {1, 3, 5})
  {
    Bodies others;
    add_bodies(0.01 * percent, others);
    score_all("head, noise " + std::to_string(percent) + " %", others, head);
  }
  for(Compared_body& body : bodies)
    body.see_from(any_tip(body));
  score_all("any tips", bodies, any_tip);
  Scores scores; // of a body and its next poses, and of others in the same pose
  for(std::size_t i = 0; i < size; ++i)
    for(std::size_t j = i + 1; j < size; ++j)
      if(is_same_body(i, j) != 0 || (j - i) % number_of_poses == 0)
      {
        std::vector<CGAL::Reeb_graph::Tip_pair<Vertex, Vertex>> tips;
        CGAL::Reeb_graph::match_tips(bodies[i].mesh, bodies[j].mesh, std::back_inserter(tips));
        bodies[i].see_from(tips.front().tip_a);
        bodies[j].see_from(tips.front().tip_b);
        scores[is_same_body(i, j)].add(bodies[i], bodies[j], tips.front().tip_a, tips.front().tip_b);
      }
  write("most alike tips", scores);
  return EXIT_SUCCESS;
}
