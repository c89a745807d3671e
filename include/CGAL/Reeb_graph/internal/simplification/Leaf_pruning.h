// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of the CGAL-style package Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_INTERNAL_SIMPLIFICATION_LEAF_PRUNING_H
#define CGAL_REEB_GRAPH_INTERNAL_SIMPLIFICATION_LEAF_PRUNING_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/internal/base/Index.h>
#include <CGAL/Reeb_graph/internal/simplification/Leaf_arc.h>
#include <CGAL/Reeb_graph/internal/simplification/Leaf_queue.h>
#include <CGAL/Reeb_graph/internal/simplification/Places_taken_up.h>

#include <array>
#include <vector>

namespace CGAL {
namespace Reeb_graph {
namespace internal {

// Lets leaf arcs be all that is removed.
struct No_rival
{
  static Index remove_arc(double) { return no_index; }
  static void see_joined_arc(Index) {}
};

// Removes leaf arcs from a graph, the one of least measure first; of equal ones the one whose leaf has the lower
// number. What is removed is taken up by the saddle at which it was. A node that is left with one arc below and one
// above is taken up by these two, which become one arc. An arc is not removed if it is the only one on its side of the
// saddle, as what is left would end there. (H. Carr, J. Snoeyink, M. van de Panne, Simplifying Flexible Isosurfaces
// Using Local Geometric Measures, 2004.) The time is O(n log n).
//
// Nodes are numbered in ascending order. Places are the nodes, by their numbers, and behind them the arcs. A weight is
// a number, or several, which `+=` adds up.
template <class Weight>
class Weighted_leaf_pruning
{
public:
  typedef Pruned_arc Arc;
  typedef Weighted_leaf_arc<Weight> Leaf_arc;

  // By place, how much each weighs.
  Weighted_leaf_pruning(Index number_of_nodes, const std::vector<Arc>& arcs, const std::vector<Weight>& weights)
    : number_of_nodes_(number_of_nodes),
      nodes_(number_of_nodes),
      places_(number_of_nodes, number_of_nodes + arcs.size(), weights)
  {
    arcs_.reserve(arcs.size());
    for(const Arc& arc : arcs)
    {
      const Index number = number_of_arcs();
      arcs_.push_back({arc, no_index, number});
      nodes_[arc.lower].add(upper_side, number);
      nodes_[arc.upper].add(lower_side, number);
    }
    for(Index node = 0; node != number_of_nodes; ++node)
      number_of_leaves_ += is_leaf(node) ? 1 : 0;
  }

  // `measure(leaf arc)` is a number, `can_be_removed(leaf arc)` whether it may be, `is_small(measure)` whether an arc
  // of that measure is to be removed, and `goes_on(number of leaves)` whether there are still so many leaves. Before an
  // arc is removed, `visit(leaf)` is called; but before, `rival.remove_arc(measure)`, with NaN if no leaf arc is left, may
  // call remove_arc() for another arc, and returns it, or no_index. The rival sees each arc that two have become.
  template <class Measure, class CanBeRemoved, class IsSmall, class GoesOn, class Visit, class Rival = No_rival>
  void operator()(const Measure& measure,
                  const CanBeRemoved& can_be_removed,
                  const IsSmall& is_small,
                  const GoesOn& goes_on,
                  const Visit& visit,
                  Rival&& rival = Rival())
  {
    Leaf_queue queue(number_of_nodes_);
    const auto consider = [&](Index node) {
      if(!is_left(node) || !is_leaf(node) || !is_branch(node))
        return;
      const Leaf_arc leaf_arc = leaf_arc_of(node);
      if(!can_be_removed(leaf_arc))
        return;
      const double size = measure(leaf_arc);
      if(is_small(size))
        queue.push(size, node);
      else
        queue.drop(node);
    };
    for(Index node = 0; node != number_of_nodes_; ++node)
    {
      if(is_left(node) && is_passed(node))
        join_at(node, rival);
    }
    for(Index node = 0; node != number_of_nodes_; ++node)
      consider(node);
    queue.sort();
    for(;;)
    {
      const auto [size, leaf] = queue.top();
      const Index arc = rival.remove_arc(size);
      if(arc != no_index)
      {
        const Arc ends = arcs_[arc].ends;
        for(const Index node : {ends.lower, ends.upper})
          tidy(node, consider, rival);
        continue;
      }
      if(leaf == no_index || !goes_on(number_of_leaves_))
        return;
      queue.pop();
      if(is_left(leaf) && is_leaf(leaf) && is_branch(leaf))
      {
        visit(leaf);
        remove(leaf, consider, rival);
      }
    }
  }

  template <class Measure, class CanBeRemoved, class IsSmall, class GoesOn>
  void operator()(const Measure& measure,
                  const CanBeRemoved& can_be_removed,
                  const IsSmall& is_small,
                  const GoesOn& goes_on)
  {
    operator()(measure, can_be_removed, is_small, goes_on, [](Index) {});
  }

  // Removes an arc that is not the only one on its side of either end. It is taken up by another place. Nodes that are
  // left with one arc below and one above are joined the next time that leaf arcs are removed.
  void remove_arc(Index arc, Index owner)
  {
    nodes_[arcs_[arc].ends.lower].remove(upper_side, arc);
    nodes_[arcs_[arc].ends.upper].remove(lower_side, arc);
    places_.take_up(place_of_arc(arc), owner);
    for(const Index node : {arcs_[arc].ends.lower, arcs_[arc].ends.upper})
      number_of_leaves_ += is_leaf(node) ? 1 : 0;
  }

  Index number_of_nodes() const { return number_of_nodes_; }
  Index number_of_arcs() const { return static_cast<Index>(arcs_.size()); }

  // Whether a place is one of the graph that is left.
  bool is_left(Index place) const { return places_.is_left(place); }
  const Arc& arc(Index arc) const { return arcs_[arc].ends; }
  Index place_of_arc(Index arc) const { return number_of_nodes_ + arc; }
  Index in_degree(Index node) const { return nodes_[node].degrees[lower_side]; }
  Index out_degree(Index node) const { return nodes_[node].degrees[upper_side]; }

  // A node that is left with a single arc, and this arc.
  bool is_leaf(Index node) const { return nodes_[node].degrees[0] + nodes_[node].degrees[1] == 1; }
  Index arc_of_leaf(Index leaf) const { return nodes_[leaf].arcs[is_minimum(leaf) ? upper_side : lower_side]; }
  Leaf_arc leaf_arc_of(Index leaf) const
  {
    typename Places::Content content = places_.content(leaf);
    content.add(places_.content(place_of_arc(arc_of_leaf(leaf))));
    return {leaf, saddle_of_leaf(leaf), is_minimum(leaf), content.weight, content.lowest, content.highest};
  }

  // One of the two arcs above a node that has two, when the other one is given.
  Index other_arc_above(Index node, Index arc) const { return nodes_[node].arcs[upper_side] ^ arc; }

  // Calls visit(arc) for the arcs that have become this one, from below to above.
  template <class Visit>
  void for_each_piece(Index arc, const Visit& visit) const
  {
    for(Index piece = arc; piece != no_index; piece = arcs_[piece].next_piece)
      visit(piece);
  }

  // By place, the one that has taken it up in the end, and the node at which the last branch was that has been removed
  // with it, see Places_taken_up.
  std::vector<Index> find_owners() const { return places_.find_owners(); }
  std::vector<Index> find_saddles() const { return places_.find_saddles(); }

private:
  typedef Places_taken_up<Weight> Places;

  static constexpr int lower_side = 0, upper_side = 1;

  // The arcs at each side of a node: how many, and the exclusive or of all their numbers, which is the number of the
  // last one that is left.
  struct Node
  {
    std::array<Index, 2> degrees = {0, 0};
    std::array<Index, 2> arcs = {0, 0};

    void add(int side, Index arc)
    {
      ++degrees[side];
      arcs[side] ^= arc;
    }
    void remove(int side, Index arc)
    {
      --degrees[side];
      arcs[side] ^= arc;
    }
  };

  bool is_passed(Index node) const { return nodes_[node].degrees[0] == 1 && nodes_[node].degrees[1] == 1; }
  bool is_minimum(Index leaf) const { return nodes_[leaf].degrees[lower_side] == 0; }

  Index saddle_of_leaf(Index leaf) const
  {
    const Arc& arc = arcs_[arc_of_leaf(leaf)].ends;
    return is_minimum(leaf) ? arc.upper : arc.lower;
  }

  bool is_branch(Index leaf) const
  {
    return nodes_[saddle_of_leaf(leaf)].degrees[is_minimum(leaf) ? lower_side : upper_side] > 1;
  }

  template <class Consider, class Rival>
  void remove(Index leaf, const Consider& consider, Rival& rival)
  {
    const Index arc = arc_of_leaf(leaf), saddle = saddle_of_leaf(leaf);
    nodes_[saddle].remove(is_minimum(leaf) ? lower_side : upper_side, arc);
    nodes_[leaf] = Node();
    places_.take_up(place_of_arc(arc), saddle);
    places_.take_up(leaf, saddle);
    --number_of_leaves_;
    number_of_leaves_ += is_leaf(saddle) ? 1 : 0;
    tidy(saddle, consider, rival);
  }

  // Joins the arcs at a node that has lost one, and considers the leaf arcs that are new.
  template <class Consider, class Rival>
  void tidy(Index node, const Consider& consider, Rival& rival)
  {
    if(is_passed(node))
    {
      const Arc joined = join_at(node, rival);
      consider(joined.lower);
      consider(joined.upper);
    }
    else
      consider(node);
  }

  template <class Rival>
  Arc join_at(Index node, Rival& rival)
  {
    const Index below = nodes_[node].arcs[lower_side], above = nodes_[node].arcs[upper_side];
    places_.take_up(node, place_of_arc(below));
    places_.take_up(place_of_arc(above), place_of_arc(below));
    arcs_[arcs_[below].last_piece].next_piece = above;
    arcs_[below].last_piece = arcs_[above].last_piece;
    arcs_[below].ends.upper = arcs_[above].ends.upper;
    nodes_[node] = Node();
    nodes_[arcs_[below].ends.upper].arcs[lower_side] ^= above ^ below;
    rival.see_joined_arc(below);
    return arcs_[below].ends;
  }

  struct Arc_record
  {
    Arc ends;
    Index next_piece; // of the arc that this one has become part of
    Index last_piece; // of this arc
  };

  Index number_of_nodes_;
  Index number_of_leaves_ = 0;
  std::vector<Arc_record> arcs_; // those that have been joined are the lowest of them
  std::vector<Node> nodes_;
  Places places_;
};

typedef Weighted_leaf_pruning<double> Leaf_pruning;

} // namespace internal
} // namespace Reeb_graph
} // namespace CGAL

#endif // CGAL_REEB_GRAPH_INTERNAL_SIMPLIFICATION_LEAF_PRUNING_H
