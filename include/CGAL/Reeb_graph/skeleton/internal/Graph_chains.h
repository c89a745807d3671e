// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_SKELETON_INTERNAL_GRAPH_CHAINS_H
#define CGAL_REEB_GRAPH_SKELETON_INTERNAL_GRAPH_CHAINS_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/internal/base/Index.h>
#include <CGAL/Reeb_graph/skeleton/internal/Branch_pruning.h>
#include <CGAL/Reeb_graph/skeleton/internal/Sampled_graph.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

namespace CGAL::Reeb_graph::internal::skeleton {

// The arcs of a pruned graph, joined through nodes with two of them. Places on a chain are measured by the differences of
// values along it.
class Graph_chains
{
public:
  struct Piece
  {
    Index arc;
    bool is_upwards;
    double begin; // its place on the chain
  };
  struct Chain
  {
    std::array<Index, 2> ends; // nodes of the graph
    std::vector<Piece> pieces;
    double length = 0;
  };
  struct Place
  {
    Index chain = no_index; // none for an end of chains
    double place = 0;
  };

  // `pruning` makes the way back from what has gone.
  Graph_chains(const Sampled_graph& graph, Branch_pruning& pruning)
    : graph_(graph),
      pruning_(pruning),
      places_of_nodes_(graph.number_of_nodes()),
      chains_of_arcs_(graph.number_of_arcs(), no_index),
      pieces_of_arcs_(graph.number_of_arcs())
  {
    for(Index node = 0; node != graph.number_of_nodes(); ++node)
      if(pruning.degree(node) != 2 && pruning.degree(node) != 0)
        add_chains_from(node);
    for(Index node = 0; node != graph.number_of_nodes(); ++node)
      if(pruning.degree(node) == 2 && places_of_nodes_[node].chain == no_index && is_first_on_ring(node))
        add_chains_from(node);
  }

  const std::vector<Chain>& chains() const { return chains_; }

  // The contour at a place of a chain, not quite at its ends.
  Contour_sample sample(Index chain, double place) const
  {
    const auto [arc, t] = place_on_arc(chain, place);
    return graph_.sample(arc, t);
  }

  std::vector<Point> contour_points(Index chain, double place) const
  {
    const auto [arc, t] = place_on_arc(chain, place);
    return graph_.contour_points(arc, t);
  }

  // The place of a vertex on a chain, or the node that it belongs to, as one of the graph.
  Place place_of(Mesh::Vertex_index v, Index& node)
  {
    const Index place = graph_.place(v);
    if(place < graph_.number_of_nodes())
      return place_of_node(place, node);
    const Index arc = place - graph_.number_of_nodes();
    if(chains_of_arcs_[arc] == no_index)
      return place_of_node(graph_.ends(arc)[0] == pruning_.trunk_of(graph_.ends(arc)[0]) ? graph_.ends(arc)[0]
                                                                                         : graph_.ends(arc)[1],
                           node);
    const Piece& piece = chains_[chains_of_arcs_[arc]].pieces[pieces_of_arcs_[arc]];
    const Index begin = graph_.ends(arc)[piece.is_upwards ? 0 : 1];
    return {chains_of_arcs_[arc], piece.begin + std::abs(graph_.value(v) - graph_.value(begin))};
  }

private:
  // The arc at a place of a chain, and the place there, from 0 to 1.
  std::pair<Index, double> place_on_arc(Index chain, double place) const
  {
    const std::vector<Piece>& pieces = chains_[chain].pieces;
    auto piece = std::upper_bound(pieces.begin(), pieces.end(), place,
                                  [](double p, const Piece& other) { return p < other.begin; });
    if(piece != pieces.begin())
      --piece;
    const double size = size_of(piece->arc);
    const double t = size > 0 ? (place - piece->begin) / size : 0.5;
    return {piece->arc, piece->is_upwards ? t : 1 - t};
  }

  double size_of(Index arc) const { return graph_.value(graph_.ends(arc)[1]) - graph_.value(graph_.ends(arc)[0]); }

  Place place_of_node(Index any, Index& node)
  {
    node = pruning_.trunk_of(any);
    return places_of_nodes_[node];
  }

  // A ring has one end only, which is then the first node that is met.
  bool is_first_on_ring(Index node) const
  {
    for(const Index arc : graph_.arcs_of(node))
      if(pruning_.is_alive(arc) && chains_of_arcs_[arc] == no_index)
        return true;
    return false;
  }

  void add_chains_from(Index node)
  {
    for(const Index arc : graph_.arcs_of(node))
      if(pruning_.is_alive(arc) && chains_of_arcs_[arc] == no_index)
        add_chain(node, arc);
  }

  void add_chain(Index begin, Index first)
  {
    const Index number = static_cast<Index>(chains_.size());
    Chain chain;
    Index node = begin, arc = first;
    while(true)
    {
      chains_of_arcs_[arc] = number;
      pieces_of_arcs_[arc] = static_cast<Index>(chain.pieces.size());
      chain.pieces.push_back({arc, graph_.ends(arc)[0] == node, chain.length});
      chain.length += size_of(arc);
      node = graph_.other_end(arc, node);
      if(node == begin || pruning_.degree(node) != 2)
        break;
      places_of_nodes_[node] = {number, chain.length};
      for(const Index other : graph_.arcs_of(node))
        if(pruning_.is_alive(other) && chains_of_arcs_[other] == no_index)
          arc = other;
    }
    chain.ends = {begin, node};
    chains_.push_back(std::move(chain));
  }

  const Sampled_graph& graph_;
  Branch_pruning& pruning_;
  std::vector<Chain> chains_;
  std::vector<Place> places_of_nodes_;
  std::vector<Index> chains_of_arcs_, pieces_of_arcs_;
};

} // namespace CGAL::Reeb_graph::internal::skeleton

#endif // CGAL_REEB_GRAPH_SKELETON_INTERNAL_GRAPH_CHAINS_H
