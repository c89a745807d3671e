// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of the CGAL-style package Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_HANDLES_INTERNAL_MAKE_LOOPS_H
#define CGAL_REEB_GRAPH_HANDLES_INTERNAL_MAKE_LOOPS_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/Augmentation.h>
#include <CGAL/Reeb_graph/handles/internal/Closed_surface.h>
#include <CGAL/Reeb_graph/internal/base/Index.h>
#include <CGAL/Reeb_graph/internal/base/Progress.h>
#include <CGAL/Reeb_graph/internal/base/compiled.h>
#include <CGAL/Reeb_graph/simplification/internal/persistence.h>
#include <CGAL/Reeb_graph/simplification/persistence_pairs.h>
#include <CGAL/compute_reeb_graph.h>

// Who links the library need not read how loops are found.
#ifndef CGAL_REEB_GRAPH_ARE_LOOPS_COMPILED
#include <CGAL/Reeb_graph/handles/internal/Found_loops.h>
#endif

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <unordered_map>
#include <utility>
#include <vector>

namespace CGAL::Reeb_graph::internal {

// A loop of a Reeb graph: its persistence, and a contour of an arc that is on no other loop of its basis.
template <class HalfedgeDescriptor>
struct Reeb_loop
{
  double persistence;
  std::vector<HalfedgeDescriptor> contour; // the halfedges that ascend across it
};

// The loops of the Reeb graph of a field, the least persistent one first. The arcs that leave the forest when loops are
// paired are as many as these loops, and what is left is a spanning forest.
template <class Mesh, class ScalarMap, class Traits>
auto find_reeb_loops(const Mesh& mesh,
                     const ScalarMap& scalar_map,
                     const Traits& traits,
                     const Stage_progress& progress)
{
  typedef typename Reeb_graph_traits<Mesh, ScalarMap>::Graph Graph;
  typedef typename boost::graph_traits<Graph>::vertex_descriptor node_descriptor;
  typedef Reeb_loop<typename boost::graph_traits<Mesh>::halfedge_descriptor> Loop;
  Graph graph;
  compute_reeb_graph(mesh, scalar_map, graph,
                     parameters::geom_traits(traits).callback(progress.part(0, 0.5).callback()));
  const std::vector<typename boost::graph_traits<Graph>::edge_descriptor> graph_arcs(edges(graph).first,
                                                                                     edges(graph).second);
  const std::vector<Pruned_arc> arcs = read_arcs(graph);
  const auto number_of_nodes = static_cast<Index>(num_vertices(graph));
  Highest_forest forest(checked_index(2 * num_vertices(graph)) / 2);
  std::vector<std::pair<Index, node_descriptor>> leaving; // arcs, and the upper nodes of their loops
  for(const Index arc : core_arcs(number_of_nodes, arcs))
  {
    const auto [lower, upper] = arcs[arc];
    const Index leaves = forest.add({lower, upper, lower, arc}).leaving;
    if(leaves != no_index)
      leaving.emplace_back(leaves, upper);
  }
  std::vector<Loop> loops;
  const Augmentation<Mesh, ScalarMap, Graph, Traits> augmentation(
    mesh, scalar_map, graph, parameters::geom_traits(traits).callback(progress.part(0.5, 0.8).callback()));
  for(const auto& [arc, upper] : leaving)
  {
    progress.part(0.8, 1).report_step(loops.size(), leaving.size());
    const Persistence_pair<node_descriptor> pair = {arcs[arc].lower, upper, Persistence_pair_kind::LOOP};
    loops.push_back({Reeb_graph::persistence(graph, pair, parameters::geom_traits(traits)),
                     augmentation.contour(graph_arcs[arc], 0.5).halfedges});
  }
  std::stable_sort(loops.begin(), loops.end(),
                   [](const Loop& a, const Loop& b) { return a.persistence < b.persistence; });
  return loops;
}

// Gives each pair of loops of a surface the persistence of one loop of the Reeb graph. The contour of that is a sum of
// loops of the surface, as many of each as their partners cross it. The least persistent loops of the Reeb graph come
// first: each belongs to the first pair that has a part in its contour once those before are subtracted. A pair that is
// left is hidden in a vertex and has the persistence 0.
class Pairs_of_reeb_loops
{
  static constexpr std::int64_t prime = 2147483647; // ranks are those modulo this number

public:
  explicit Pairs_of_reeb_loops(std::size_t number_of_pairs) : is_assigned_(number_of_pairs) {}

  // The row has twice as many entries as there are pairs. Returns the pair, or number_of_pairs if there is none.
  std::size_t pair_of(std::vector<std::int64_t> row)
  {
    for(std::int64_t& entry : row)
      entry = (entry % prime + prime) % prime;
    for(const auto& [pivot, reduced] : rows_)
      subtract(row, reduced, row[pivot]);
    for(std::size_t k = 0; k != row.size(); ++k)
    {
      if(row[k] == 0 || is_assigned_[k / 2])
        continue;
      is_assigned_[k / 2] = true;
      const std::int64_t factor = inverse(row[k]);
      for(std::int64_t& entry : row)
        entry = entry * factor % prime;
      rows_.emplace_back(k, std::move(row));
      return k / 2;
    }
    return is_assigned_.size();
  }

private:
  static void subtract(std::vector<std::int64_t>& row, const std::vector<std::int64_t>& other, std::int64_t factor)
  {
    if(factor == 0)
      return;
    for(std::size_t k = 0; k != row.size(); ++k)
      row[k] = (row[k] + (prime - factor) * other[k]) % prime;
  }

  static std::int64_t inverse(std::int64_t a)
  {
    std::int64_t result = 1;
    for(std::int64_t exponent = prime - 2; exponent != 0; exponent /= 2)
    {
      if(exponent % 2 != 0)
        result = result * a % prime;
      a = a * a % prime;
    }
    return result;
  }

  std::vector<bool> is_assigned_;
  std::vector<std::pair<std::size_t, std::vector<std::int64_t>>> rows_; // with the place of an entry 1
};

// The persistences of pairs of loops, which are sorted by size. `Numbers` are those of halfedges.
template <class ReebLoops, class Number>
std::vector<double> persistences_of_pairs(const ReebLoops& reeb_loops,
                                          const std::vector<std::array<const Halfedge_walk*, 2>>& pairs,
                                          const Number& number)
{
  struct Crossing
  {
    std::size_t place;
    std::int64_t sign;
  };
  std::unordered_map<Index, std::vector<Crossing>> crossings; // of walks, by edge
  for(std::size_t i = 0; i != pairs.size(); ++i)
    for(std::size_t k : {0, 1})
      for(const Index h : *pairs[i][k])
        crossings[h / 2].push_back({2 * i + k, h % 2 == 0 ? 1 : -1});
  std::vector<double> result(pairs.size(), 0);
  Pairs_of_reeb_loops assign(pairs.size());
  for(const auto& loop : reeb_loops)
  {
    std::vector<std::int64_t> row(2 * pairs.size(), 0);
    for(const auto h : loop.contour)
    {
      const Index n = number(h);
      const auto found = crossings.find(n / 2);
      if(found == crossings.end())
        continue;
      for(const Crossing& crossing : found->second)
        row[crossing.place] += n % 2 == 0 ? crossing.sign : -crossing.sign;
    }
    const std::size_t pair = assign.pair_of(std::move(row));
    if(pair != pairs.size())
      result[pair] = loop.persistence;
  }
  return result;
}

// Sets the persistences of the loops that have partners.
template <class ReebLoops, class Number>
void set_persistences(const ReebLoops& reeb_loops, const Number& number, std::vector<Surface_loop>& loops)
{
  std::vector<std::size_t> firsts; // of pairs, by size
  for(std::size_t i = 0; i != loops.size(); ++i)
  {
    if(loops[i].kind != Loop_kind::HOLE && loops[i].partner > i)
      firsts.push_back(i);
  }
  const auto size = [&](std::size_t i) { return (std::min)(loops[i].length, loops[i + 1].length); };
  std::stable_sort(firsts.begin(), firsts.end(), [&](std::size_t a, std::size_t b) { return size(a) < size(b); });
  std::vector<std::array<const Halfedge_walk*, 2>> pairs;
  for(const std::size_t i : firsts)
    pairs.push_back({&loops[i].walk, &loops[i + 1].walk});
  const std::vector<double> persistences = persistences_of_pairs(reeb_loops, pairs, number);
  for(std::size_t k = 0; k != firsts.size(); ++k)
    loops[firsts[k]].persistence = loops[firsts[k] + 1].persistence = persistences[k];
}

#define CGAL_REEB_GRAPH_MAKE_LOOP_FINDER(PREFIX)                                                                       \
  PREFIX template std::unique_ptr<Loop_finder> make_loop_finder<Closed_surface>(Closed_surface, const Stage_progress&);
CGAL_REEB_GRAPH_FOR_LOOPS(CGAL_REEB_GRAPH_MAKE_LOOP_FINDER)

} // namespace CGAL::Reeb_graph::internal

#endif // CGAL_REEB_GRAPH_HANDLES_INTERNAL_MAKE_LOOPS_H
