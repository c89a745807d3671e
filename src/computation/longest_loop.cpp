// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#include "computation/longest_loop.h"

#include "computation/simplification.h"

#include <CGAL/Reeb_graph/internal/base/arrays.h>
#include <CGAL/Reeb_graph/internal/base/lengths.h>
#include <CGAL/boost/graph/iterator.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <stdexcept>
#include <vector>

namespace reeb_graph_program {
namespace {
struct Arc
{
  std::size_t lower, upper, number;
};

// A spanning forest of arcs whose lower ends are as high as they can be.
class Highest_forest
{
public:
  // The arcs are in descending order of their lower ends.
  Highest_forest(std::size_t number_of_nodes, const std::vector<Arc>& arcs) : arcs_at_(number_of_nodes)
  {
    CGAL::Reeb_graph::internal::Disjoint_sets<std::size_t> components(number_of_nodes);
    for(const Arc& arc : arcs)
    {
      if(components.find(arc.lower) == components.find(arc.upper))
        continue;
      components.unite(arc.lower, arc.upper);
      arcs_at_[arc.lower].push_back(arc);
      arcs_at_[arc.upper].push_back(arc);
    }
  }

  // The arcs on the way from a node to another one, none if there is no way.
  std::vector<Arc> path(std::size_t from, std::size_t to) const
  {
    std::vector<const Arc*> entered(arcs_at_.size(), nullptr); // by node, the arc by which it was reached from `to`
    std::vector<std::size_t> reached = {to};
    for(std::size_t i = 0; i != reached.size(); ++i)
      for(const Arc& arc : arcs_at_[reached[i]])
      {
        const std::size_t next = arc.lower == reached[i] ? arc.upper : arc.lower;
        if(next == to || entered[next])
          continue;
        entered[next] = &arc;
        reached.push_back(next);
      }
    std::vector<Arc> path;
    for(std::size_t node = from; node != to && entered[node];)
    {
      path.push_back(*entered[node]);
      node = path.back().lower == node ? path.back().upper : path.back().lower;
    }
    return path;
  }

private:
  std::vector<std::vector<Arc>> arcs_at_;
};

// The arcs of a loop, one after the other, the first one downwards from the upper node of its pair.
std::vector<Arc> arcs_of_loop(const Graph& graph, const Persistence_pair& pair)
{
  std::vector<Arc> arcs, closing; // those below the upper node, and those that end there
  for(const auto arc : CGAL::make_range(edges(graph)))
  {
    const Arc found = {source(arc, graph), target(arc, graph), get(boost::edge_index, graph, arc)};
    if(found.lower >= pair.lower_node && found.upper <= pair.upper_node)
      (found.upper == pair.upper_node ? closing : arcs).push_back(found);
  }
  const auto is_higher = [](const Arc& a, const Arc& b) { return a.lower > b.lower; };
  std::stable_sort(arcs.begin(), arcs.end(), is_higher);
  for(const Arc& last : closing)
  {
    const std::vector<Arc> way = Highest_forest(num_vertices(graph), arcs).path(last.lower, last.upper);
    std::vector<Arc> loop = {last};
    loop.insert(loop.end(), way.begin(), way.end());
    if(!way.empty() && std::any_of(loop.begin(), loop.end(), [&](const Arc& a) { return a.lower == pair.lower_node; }))
      return loop;
    arcs.insert(std::upper_bound(arcs.begin(), arcs.end(), last, is_higher), last);
  }
  return {};
}

} // namespace

Loops_of_surface find_longest_loop(Mesh_graph& mesh_graph)
{
  const Graph& graph = mesh_graph.result();
  std::vector<Persistence_pair> pairs = find_persistence_pairs(graph);
  pairs.erase(std::remove_if(pairs.begin(), pairs.end(),
                             [](const Persistence_pair& pair) {
                               return pair.kind != CGAL::Reeb_graph::Persistence_pair_kind::LOOP;
                             }),
              pairs.end());
  if(pairs.empty())
    throw std::runtime_error("the graph has no loop");
  const auto pair = std::max_element(pairs.begin(), pairs.end(), [&](const auto& a, const auto& b) {
    return CGAL::Reeb_graph::persistence(graph, a) < CGAL::Reeb_graph::persistence(graph, b);
  });
  const Embedding embedding = mesh_graph.embed(CGAL::Reeb_graph::Embedding_manner::ON_SURFACE);
  Polyline curve;
  std::size_t node = pair->upper_node;
  for(const Arc& arc : arcs_of_loop(graph, *pair))
  {
    Polyline piece = embedding.arc_polylines[arc.number];
    if(arc.upper == node)
      std::reverse(piece.begin(), piece.end());
    node = arc.upper == node ? arc.lower : arc.upper;
    curve.insert(curve.end(), piece.begin() + (curve.empty() ? 0 : 1), piece.end());
  }
  Loop_row row;
  row.kind = "loop";
  for(std::size_t i = 1; i < curve.size(); ++i)
    row.length += CGAL::Reeb_graph::internal::distance_between(curve[i], curve[i - 1]);
  row.persistence = CGAL::Reeb_graph::persistence(graph, *pair);
  row.place = place_of(curve);
  return {{row}, {curve}};
}

} // namespace reeb_graph_program
