// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_INTERNAL_GRAPH_LEAF_PRUNING_H
#define CGAL_REEB_GRAPH_INTERNAL_GRAPH_LEAF_PRUNING_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/exceptions.h>
#include <CGAL/Reeb_graph/internal/base/Index.h>
#include <CGAL/Reeb_graph/internal/graph/graph_loops.h>
#include <CGAL/Reeb_graph/named_parameters.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <iterator>
#include <limits>
#include <queue>
#include <string>
#include <utility>
#include <vector>

namespace CGAL::Reeb_graph::internal {

template <class NamedParameters>
std::vector<double> read_place_weights(std::size_t number_of_places, const NamedParameters& np)
{
  const auto parameter = parameters::get_parameter(np, place_weights);
  std::vector<double> weights;
  if constexpr(is_given<decltype(parameter)>)
  {
    weights.assign(std::begin(parameter), std::end(parameter));
    if(weights.size() != number_of_places)
      throw Parameter_error(std::to_string(weights.size()) + " weights given for " + std::to_string(number_of_places)
                            + " nodes and arcs");
    if(std::any_of(weights.begin(), weights.end(), [](double weight) { return std::isnan(weight); }))
      throw Parameter_error("the weight of a place is not a number (NaN)");
  }
  else
    weights.assign(number_of_places, 0);
  return weights;
}

template <class Branch, class NamedParameters>
double measure_of_branch(const Branch& branch, const NamedParameters& np)
{
  const auto& measure = parameters::get_parameter(np, branch_measure);
  if constexpr(is_given<decltype(measure)>)
  {
    const double size = measure(branch);
    if(std::isnan(size))
      throw Parameter_error("the measure of a branch is not a number (NaN)");
    return size;
  }
  else
    return is_given<decltype(parameters::get_parameter(np, place_weights))> ? branch.weight : branch.persistence;
}

// Leaves by their measures, from the least one. A leaf that is pushed again has a new measure. Those that are there at
// first are sorted, and only later ones are in a heap: a sweep over memory instead of jumps.
class Leaf_queue
{
public:
  typedef std::pair<double, Index> Sized_leaf;

  explicit Leaf_queue(Index number_of_nodes) : measures_(number_of_nodes) {}

  // A leaf whose measure is NaN is not there.
  void push(double measure, Index leaf)
  {
    measures_[leaf] = measure;
    if(std::isnan(measure))
      return;
    if(is_sorted_)
      later_.emplace(measure, leaf);
    else
      first_.emplace_back(measure, leaf);
  }

  // To be called once, before the first pop().
  void sort()
  {
    std::sort(first_.begin(), first_.end());
    is_sorted_ = true;
  }

  // The least measure and its leaf, which stays; NaN and no_index if there is none.
  Sized_leaf top()
  {
    while(next_ != first_.size() || !later_.empty())
    {
      const Sized_leaf& leaf = is_first() ? first_[next_] : later_.top();
      if(measures_[leaf.second] == leaf.first)
        return leaf;
      pop();
    }
    return {std::numeric_limits<double>::quiet_NaN(), no_index};
  }

  // Removes the leaf of least measure; there has to be one.
  void pop()
  {
    if(is_first())
      ++next_;
    else
      later_.pop();
  }

private:
  bool is_first() const { return later_.empty() || (next_ != first_.size() && first_[next_] < later_.top()); }

  std::vector<double> measures_; // the last ones
  std::vector<Sized_leaf> first_;
  std::size_t next_ = 0;
  bool is_sorted_ = false;
  std::priority_queue<Sized_leaf, std::vector<Sized_leaf>, std::greater<Sized_leaf>> later_;
};

// A leaf arc that could be removed.
template <class Weight>
struct Weighted_leaf_arc
{
  Index leaf, saddle;    // its nodes
  bool is_minimum;       // whether the leaf is the lower one of them
  Weight weight;         // of the leaf, of the arc, and of all that they have taken up
  Index lowest, highest; // of the leaf and the nodes that have been taken up
};

typedef Weighted_leaf_arc<double> Leaf_arc;

// The largest difference between the value at the saddle of a leaf arc and one in the branch that it stands for.
// `difference` gives the absolute difference between two nodes.
template <class Weight, class Difference>
double persistence_of_leaf_arc(const Weighted_leaf_arc<Weight>& arc, const Difference& difference)
{
  return (std::max)(difference(arc.lowest, arc.saddle), difference(arc.saddle, arc.highest));
}

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
  typedef Ascending_arc Arc;
  typedef Weighted_leaf_arc<Weight> Leaf_arc;

  // By place, how much each weighs.
  Weighted_leaf_pruning(Index number_of_nodes, const std::vector<Arc>& arcs, const std::vector<Weight>& weights)
    : number_of_nodes_(number_of_nodes),
      nodes_(number_of_nodes),
      number_of_nodes_left_(number_of_nodes),
      number_of_arcs_left_(arcs.size())
  {
    places_.reserve(number_of_nodes + arcs.size());
    for(Index place = 0; place != number_of_nodes + arcs.size(); ++place)
    {
      const bool is_node = place < number_of_nodes;
      places_.push_back({place, {weights[place], is_node ? place : Index(no_index), is_node ? place : 0}});
    }
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

  // `measure(leaf arc)` is a number, or NaN for an arc that is to stay. Before one is removed, `visit(leaf, measure)` is
  // called, and returns whether it is to be removed and the work goes on.
  template <class Measure, class Visit>
  void operator()(const Measure& measure, const Visit& visit)
  {
    Leaf_queue queue(number_of_nodes());
    const auto consider = [&](Index node) {
      if(is_left(node) && is_leaf(node) && is_branch(node))
        queue.push(measure(leaf_arc_of(node)), node);
    };
    for(Index node = 0; node != number_of_nodes(); ++node)
    {
      if(is_left(node) && is_passed(node))
        join_at(node);
    }
    for(Index node = 0; node != number_of_nodes(); ++node)
      consider(node);
    queue.sort();
    for(;;)
    {
      const auto [size, leaf] = queue.top();
      const Index arc = remove_other_arc(size);
      if(arc != no_index)
      {
        const Arc ends = arcs_[arc].ends;
        for(const Index node : {ends.lower, ends.upper})
          tidy(node, consider);
        continue;
      }
      if(leaf == no_index)
        return;
      queue.pop();
      if(!is_left(leaf) || !is_leaf(leaf) || !is_branch(leaf))
        continue;
      if(!visit(leaf, size))
        return;
      tidy(remove(leaf), consider);
    }
  }

  // Removes an arc that is not the only one on its side of either end. It is taken up by another place. Nodes that are
  // left with one arc below and one above are joined the next time that leaf arcs are removed.
  void remove_arc(Index arc, Index owner)
  {
    nodes_[arcs_[arc].ends.lower].remove(upper_side, arc);
    nodes_[arcs_[arc].ends.upper].remove(lower_side, arc);
    take_up(place_of_arc(arc), owner);
    --number_of_arcs_left_;
    for(const Index node : {arcs_[arc].ends.lower, arcs_[arc].ends.upper})
      number_of_leaves_ += is_leaf(node) ? 1 : 0;
  }

  Index number_of_nodes() const { return number_of_nodes_; }
  Index number_of_arcs() const { return static_cast<Index>(arcs_.size()); }

  // Of the graph that is left.
  std::size_t number_of_nodes_left() const { return number_of_nodes_left_; }
  std::size_t number_of_arcs_left() const { return number_of_arcs_left_; }
  std::size_t number_of_leaves() const { return number_of_leaves_; }

  // Whether a place is one of the graph that is left.
  bool is_left(Index place) const { return places_[place].owner == place; }
  const Arc& arc(Index arc) const { return arcs_[arc].ends; }
  Index place_of_arc(Index arc) const { return number_of_nodes() + arc; }
  Index in_degree(Index node) const { return nodes_[node].degrees[lower_side]; }
  Index out_degree(Index node) const { return nodes_[node].degrees[upper_side]; }

  // A node that is left with a single arc, and this arc.
  bool is_leaf(Index node) const { return nodes_[node].degrees[0] + nodes_[node].degrees[1] == 1; }
  Index arc_of_leaf(Index leaf) const { return nodes_[leaf].arcs[is_minimum(leaf) ? upper_side : lower_side]; }
  Leaf_arc leaf_arc_of(Index leaf) const
  {
    Content content = places_[leaf].content;
    content.add(places_[place_of_arc(arc_of_leaf(leaf))].content);
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

  // By place, the place that has taken it up in the end; no_index for one that is left.
  std::vector<Index> find_owners() const
  {
    return follow_owners(
      [](Index owner, Index result_of_owner) { return result_of_owner == no_index ? owner : result_of_owner; });
  }

  // By place, the node at which the last branch was that has been removed with it, no_index if none has: so each place
  // that has been removed together with a branch is told from those that arcs consist of.
  std::vector<Index> find_saddles() const
  {
    return follow_owners([&](Index owner, Index result_of_owner) {
      return result_of_owner == no_index && owner < number_of_nodes() ? owner : result_of_owner;
    });
  }

private:
  // A derived class can remove another arc before the leaf arc of least measure, which is NaN if there is none: it calls
  // remove_arc() and returns the arc, or no_index.
  virtual Index remove_other_arc(double) { return no_index; }

  // A derived class sees each arc that two have become.
  virtual void see_joined_arc(Index) {}

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

  struct Arc_record
  {
    Arc ends;
    Index next_piece; // of the arc that this one has become part of
    Index last_piece; // of this arc
  };

  // The content of a place: itself and all that it has taken up.
  struct Content
  {
    Weight weight;
    Index lowest, highest; // of the nodes

    void add(const Content& other)
    {
      weight += other.weight;
      lowest = (std::min)(lowest, other.lowest);
      highest = (std::max)(highest, other.highest);
    }
  };

  struct Place
  {
    Index owner; // itself, if it is left
    Content content;
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

  void take_up(Index place, Index owner)
  {
    places_[place].owner = owner;
    places_[owner].content.add(places_[place].content);
  }

  // Removes the arc of a leaf, and returns the saddle.
  Index remove(Index leaf)
  {
    const Index arc = arc_of_leaf(leaf), saddle = saddle_of_leaf(leaf);
    nodes_[saddle].remove(is_minimum(leaf) ? lower_side : upper_side, arc);
    nodes_[leaf] = Node();
    take_up(place_of_arc(arc), saddle);
    take_up(leaf, saddle);
    --number_of_nodes_left_;
    --number_of_arcs_left_;
    --number_of_leaves_;
    number_of_leaves_ += is_leaf(saddle) ? 1 : 0;
    return saddle;
  }

  // Joins the arcs at a node that has lost one, and considers the leaf arcs that are new.
  template <class Consider>
  void tidy(Index node, const Consider& consider)
  {
    if(is_passed(node))
    {
      const Arc joined = join_at(node);
      consider(joined.lower);
      consider(joined.upper);
    }
    else
      consider(node);
  }

  Arc join_at(Index node)
  {
    const Index below = nodes_[node].arcs[lower_side], above = nodes_[node].arcs[upper_side];
    take_up(node, place_of_arc(below));
    take_up(place_of_arc(above), place_of_arc(below));
    arcs_[arcs_[below].last_piece].next_piece = above;
    arcs_[below].last_piece = arcs_[above].last_piece;
    arcs_[below].ends.upper = arcs_[above].ends.upper;
    nodes_[node] = Node();
    nodes_[arcs_[below].ends.upper].arcs[lower_side] ^= above ^ below;
    --number_of_nodes_left_;
    --number_of_arcs_left_;
    see_joined_arc(below);
    return arcs_[below].ends;
  }

  // By place, what choose(owner, result of the owner) gives; no_index for a place that is left.
  template <class Choose>
  std::vector<Index> follow_owners(const Choose& choose) const
  {
    std::vector<Index> results(places_.size(), no_index), path;
    std::vector<bool> is_known(places_.size(), false);
    for(Index first = 0; first != places_.size(); ++first)
    {
      for(Index place = first; !is_known[place] && !is_left(place); place = places_[place].owner)
        path.push_back(place);
      for(; !path.empty(); path.pop_back())
      {
        const Index place = path.back();
        results[place] = choose(places_[place].owner, results[places_[place].owner]);
        is_known[place] = true;
      }
    }
    return results;
  }

  Index number_of_nodes_;
  std::vector<Node> nodes_;
  std::vector<Arc_record> arcs_; // those that have been joined are the lowest of them
  std::vector<Place> places_;
  std::size_t number_of_nodes_left_, number_of_arcs_left_, number_of_leaves_ = 0;
};

typedef Weighted_leaf_pruning<double> Leaf_pruning;

} // namespace CGAL::Reeb_graph::internal

#endif // CGAL_REEB_GRAPH_INTERNAL_GRAPH_LEAF_PRUNING_H
