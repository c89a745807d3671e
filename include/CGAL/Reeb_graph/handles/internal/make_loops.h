// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
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
#include <CGAL/Reeb_graph/simplification/persistence_pairs.h>

// Programs that link the library need not read how loops are found.
#ifndef CGAL_REEB_GRAPH_ARE_LOOPS_COMPILED
#include <CGAL/Reeb_graph/handles/internal/Found_loops.h>
#include <CGAL/Reeb_graph/internal/graph/graph_loops.h>
#endif

#include <algorithm>
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
template <class Mesh, class ScalarMap, class Graph, class Traits>
auto find_reeb_loops(const Mesh& mesh,
                     const ScalarMap& scalar_map,
                     const Graph& graph,
                     const Traits& traits,
                     const Stage_progress& progress)
{
  typedef typename boost::graph_traits<Graph>::vertex_descriptor node_descriptor;
  typedef Reeb_loop<typename boost::graph_traits<Mesh>::halfedge_descriptor> Loop;
  const std::vector<typename boost::graph_traits<Graph>::edge_descriptor> graph_arcs(edges(graph).first,
                                                                                     edges(graph).second);
  const std::vector<Ascending_arc> arcs = read_arcs(graph);
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
    mesh, scalar_map, graph, parameters::geom_traits(traits).callback(progress.part(0, 0.6).callback()));
  for(const auto& [arc, upper] : leaving)
  {
    progress.part(0.6, 1).report_step(loops.size(), leaving.size());
    const Persistence_pair<node_descriptor> pair = {arcs[arc].lower, upper, Persistence_pair_kind::LOOP};
    loops.push_back({Reeb_graph::persistence(graph, pair, parameters::geom_traits(traits)),
                     augmentation.contour(graph_arcs[arc], 0.5).edges});
  }
  std::stable_sort(loops.begin(), loops.end(),
                   [](const Loop& a, const Loop& b) { return a.persistence < b.persistence; });
  return loops;
}

// Finds the pairs of loops of a surface that loops of the Reeb graph belong to. The contour of one of these is a sum of
// loops of the surface, as many of each as their partners cross it. The least persistent loops of the Reeb graph come
// first: each belongs to the first pair that has a part in its contour once those before are subtracted.
class Pairs_of_reeb_loops
{
public:
  explicit Pairs_of_reeb_loops(std::size_t number_of_pairs) : is_assigned_(number_of_pairs) {}

  // The row has twice as many entries as there are pairs. Returns the pair, or number_of_pairs if there is none.
  std::size_t pair_of(std::vector<std::int64_t> row)
  {
    constexpr std::int64_t prime = 2147483647; // ranks are those modulo this number
    for(std::int64_t& entry : row)
      entry = (entry % prime + prime) % prime;
    for(const auto& [pivot, other] : rows_)
    {
      const std::int64_t factor = other[pivot], subtracted = prime - row[pivot];
      if(subtracted == prime)
        continue;
      for(std::size_t k = 0; k != row.size(); ++k)
        row[k] = (factor * row[k] + subtracted * other[k]) % prime;
    }
    for(std::size_t k = 0; k != row.size(); ++k)
    {
      if(row[k] == 0 || is_assigned_[k / 2])
        continue;
      is_assigned_[k / 2] = true;
      rows_.emplace_back(k, std::move(row));
      return k / 2;
    }
    return is_assigned_.size();
  }

private:
  std::vector<bool> is_assigned_;
  std::vector<std::pair<std::size_t, std::vector<std::int64_t>>> rows_; // with the place of an entry that is not 0
};

// Sets the persistences of the loops that have partners. A pair that no loop of the Reeb graph belongs to is hidden in a
// vertex and has the persistence 0. number(h) is that of a halfedge.
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
  std::unordered_map<Index, std::vector<std::pair<std::size_t, std::int64_t>>> crossings; // loops and signs, by edge
  for(std::size_t place = 0; place != 2 * firsts.size(); ++place)
    for(const Index h : loops[firsts[place / 2] + place % 2].halfedges)
      crossings[h / 2].emplace_back(place, h % 2 == 0 ? 1 : -1);
  Pairs_of_reeb_loops assign(firsts.size());
  for(const auto& reeb_loop : reeb_loops)
  {
    std::vector<std::int64_t> row(2 * firsts.size(), 0);
    for(const auto h : reeb_loop.contour)
    {
      const Index n = number(h);
      const auto found = crossings.find(n / 2);
      if(found == crossings.end())
        continue;
      for(const auto& [place, sign] : found->second)
        row[place] += n % 2 == 0 ? sign : -sign;
    }
    const std::size_t pair = assign.pair_of(std::move(row));
    if(pair != firsts.size())
      loops[firsts[pair]].persistence = loops[firsts[pair] + 1].persistence = reeb_loop.persistence;
  }
}

#define CGAL_REEB_GRAPH_MAKE_LOOP_FINDER(PREFIX)                                                                       \
  PREFIX template std::unique_ptr<Loop_finder> make_loop_finder<Closed_surface>(Closed_surface, const Stage_progress&);
CGAL_REEB_GRAPH_FOR_LOOPS(CGAL_REEB_GRAPH_MAKE_LOOP_FINDER)

} // namespace CGAL::Reeb_graph::internal

#endif // CGAL_REEB_GRAPH_HANDLES_INTERNAL_MAKE_LOOPS_H
