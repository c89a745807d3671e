// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_INTERNAL_DRAWING_BRANCH_ORDER_H
#define CGAL_REEB_GRAPH_INTERNAL_DRAWING_BRANCH_ORDER_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/internal/base/Index.h>
#include <CGAL/Reeb_graph/internal/base/arrays.h>
#include <CGAL/Reeb_graph/internal/graph/Leaf_pruning.h>
#include <CGAL/Reeb_graph/internal/graph/graph_loops.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <iterator>
#include <map>
#include <numeric>
#include <utility>
#include <vector>

namespace CGAL::Reeb_graph::internal {

// An ascending path of arcs that is drawn in one column.
struct Drawn_branch
{
  std::size_t first_arc, end_of_arcs;        // in Branch_tree::arcs
  Index lower, upper;                        // its nodes
  bool is_lower_attached, is_upper_attached; // whether it ends there at a node of its parent
  bool is_closing = false;                   // whether it closes a loop at its upper node, which is no leaf then
  Index parent = no_index;                   // the branch at which it is attached, none for a trunk
};

// A Reeb graph as branches at branches: the graph is cut open below each node at which loops close, so that it is a
// forest, and the leaf arcs of that are removed, the less persistent first. What is left of each component is its
// trunk. With n nodes and arcs it takes O(n log n) time.
class Branch_tree
{
public:
  typedef Leaf_pruning::Arc Arc;

  std::vector<Drawn_branch> branches; // each before its parent
  std::vector<Index> arcs;            // of the branches, each from below to above
  std::vector<Index> branch_of_node;

  // By node, the heights, which ascend.
  Branch_tree(const std::vector<Arc>& graph_arcs, const std::vector<double>& heights)
    : branch_of_node(heights.size(), no_index)
  {
    const auto number_of_nodes = static_cast<Index>(heights.size());
    std::vector<bool> is_cut = find_closing_arcs(graph_arcs, heights);

    // the new nodes, where arcs have been cut, lie just below the old ones
    std::vector<Index> new_numbers(number_of_nodes, 0), old_numbers;
    for(Index arc = 0; arc != graph_arcs.size(); ++arc)
      new_numbers[graph_arcs[arc].upper] += is_cut[arc] ? 1 : 0;
    for(Index node = 0; node != number_of_nodes; ++node)
    {
      old_numbers.insert(old_numbers.end(), new_numbers[node] + std::size_t(1), node);
      new_numbers[node] = static_cast<Index>(old_numbers.size() - 1);
    }
    std::vector<Index> next_new(number_of_nodes, 1);
    std::vector<Arc> forest;
    for(Index arc = 0; arc != graph_arcs.size(); ++arc)
    {
      const auto [lower, upper] = graph_arcs[arc];
      forest.push_back({new_numbers[lower], is_cut[arc] ? new_numbers[upper] - next_new[upper]++ : new_numbers[upper]});
    }
    find_branches(forest, old_numbers, heights);
    for(Drawn_branch& branch : branches)
    {
      branch.is_closing = branch.first_arc != branch.end_of_arcs && is_cut[arcs[branch.end_of_arcs - 1]];
      for(std::size_t i = branch.first_arc; i != branch.end_of_arcs; ++i)
      {
        if(i != branch.first_arc || !branch.is_lower_attached)
          branch_of_node[graph_arcs[arcs[i]].lower] = number_of(branch);
      }
      if(!branch.is_upper_attached && !branch.is_closing)
        branch_of_node[branch.upper] = number_of(branch);
    }
    for(Drawn_branch& branch : branches)
    {
      if(branch.is_lower_attached || branch.is_upper_attached)
        branch.parent = branch_of_node[branch.is_lower_attached ? branch.lower : branch.upper];
    }
  }

private:
  Index number_of(const Drawn_branch& branch) const { return static_cast<Index>(&branch - branches.data()); }

  // Of the arcs by which a node is reached from one component of what is below it, all but one close a loop: that on
  // the longest ascending path stays, so that long paths are not cut, and of several the shortest one.
  static std::vector<bool> find_closing_arcs(const std::vector<Arc>& graph_arcs, const std::vector<double>& heights)
  {
    std::vector<double> starts = heights; // by node, of the longest path that ends there
    std::vector<Index> order(graph_arcs.size());
    std::iota(order.begin(), order.end(), Index(0));
    std::stable_sort(order.begin(), order.end(),
                     [&](Index a, Index b) { return graph_arcs[a].upper < graph_arcs[b].upper; });
    std::vector<bool> is_closing(graph_arcs.size());
    Disjoint_sets<Index> components(static_cast<Index>(heights.size()));
    for(auto begin = order.begin(); begin != order.end();)
    {
      const Index node = graph_arcs[*begin].upper;
      const auto end = std::find_if(begin, order.end(), [&](Index arc) { return graph_arcs[arc].upper != node; });
      std::stable_sort(begin, end, [&](Index a, Index b) {
        const Index first = graph_arcs[a].lower, second = graph_arcs[b].lower;
        return starts[first] != starts[second] ? starts[first] < starts[second] : first > second;
      });
      starts[node] = starts[graph_arcs[*begin].lower];
      for(; begin != end; ++begin)
        is_closing[*begin] = !components.unite(node, graph_arcs[*begin].lower);
    }
    return is_closing;
  }

  void find_branches(const std::vector<Arc>& forest,
                     const std::vector<Index>& old_numbers,
                     const std::vector<double>& heights)
  {
    const auto size = static_cast<Index>(old_numbers.size());
    Leaf_pruning pruning(size, forest, std::vector<double>(size + forest.size(), 0));
    const auto add_branch = [&](Index arc, bool is_lower_attached, bool is_upper_attached) {
      const std::size_t first_arc = arcs.size();
      pruning.for_each_piece(arc, [&](Index piece) { arcs.push_back(piece); });
      branches.push_back({first_arc, arcs.size(), old_numbers[pruning.arc(arc).lower],
                          old_numbers[pruning.arc(arc).upper], is_lower_attached, is_upper_attached});
    };
    const auto difference = [&](Index lower, Index upper) {
      return persistence(heights[old_numbers[lower]], heights[old_numbers[upper]]);
    };
    pruning([&](const Leaf_arc& arc) { return persistence_of_leaf_arc(arc, difference); },
            [&](Index leaf, double) {
              const bool is_minimum = pruning.in_degree(leaf) == 0;
              add_branch(pruning.arc_of_leaf(leaf), !is_minimum, is_minimum);
              return true;
            });
    for(Index arc = 0; arc != pruning.number_of_arcs(); ++arc)
    {
      if(pruning.is_left(pruning.place_of_arc(arc)))
        add_branch(arc, false, false);
    }
    for(Index node = 0; node != size; ++node)
    {
      if(pruning.is_left(node) && pruning.in_degree(node) + pruning.out_degree(node) == 0)
        branches.push_back({arcs.size(), arcs.size(), old_numbers[node], old_numbers[node], false, false});
    }
  }
};

// A closed interval of heights.
struct Height_range
{
  double low, high;

  bool has_inside(double height) const { return low < height && height < high; }
  void extend(const Height_range& other)
  {
    low = (std::min)(low, other.low);
    high = (std::max)(high, other.high);
  }
};

// How far what has been placed reaches at each height, as steps. What raises a range raises all of it to one value, so
// that steps go that have been looked at: to ask for a maximum and then to raise the range takes logarithmic time on
// average.
class Skyline
{
public:
  // `heights` are all those that intervals are told apart by, in ascending order.
  Skyline(const std::vector<double>& heights, double start) : heights_(heights), start_(start), steps_({{0, start}}) {}

  double highest(const Height_range& range) const
  {
    const auto [begin, end] = positions(range);
    double result = start_;
    if(begin == end)
      return result;
    const auto last = steps_.lower_bound(end);
    for(auto step = std::prev(steps_.upper_bound(begin)); step != last; ++step)
      result = (std::max)(result, step->second);
    return result;
  }

  // Sets a range to a value, which is higher than all that are there, or below the start, which highest() puts right.
  void raise(const Height_range& range, double value)
  {
    const auto [begin, end] = positions(range);
    if(begin == end)
      return;
    const double behind = std::prev(steps_.upper_bound(end))->second;
    steps_.erase(steps_.lower_bound(begin), steps_.upper_bound(end));
    steps_[begin] = value;
    steps_[end] = behind;
  }

private:
  std::pair<std::size_t, std::size_t> positions(const Height_range& range) const
  {
    const auto begin = std::lower_bound(heights_.begin(), heights_.end(), range.low);
    const auto end = std::upper_bound(begin, heights_.end(), range.high);
    return {begin - heights_.begin(), end - heights_.begin()};
  }

  const std::vector<double>& heights_;
  double start_;
  std::map<std::size_t, double> steps_; // by position in the heights, how far from there on
};

// About how many branches one side of a trunk has, in equal parts of the height, which is from 0 to 1.
class Side_load
{
public:
  void add(const Height_range& range, Index number_of_branches)
  {
    std::for_each(part(range.low), part(range.high) + 1, [&](Index& load) { load += number_of_branches; });
  }

  // The load that decides between two sides: that where a branch would be, and then that of all parts.
  std::pair<Index, std::size_t> load(const Height_range& range)
  {
    return {*std::max_element(part(range.low), part(range.high) + 1),
            std::accumulate(loads_.begin(), loads_.end(), std::size_t(0))};
  }

private:
  typedef std::array<Index, 32> Loads;

  Loads::iterator part(double height)
  {
    const auto size = static_cast<double>(loads_.size());
    return loads_.begin() + static_cast<std::ptrdiff_t>((std::clamp)(height * size, 0., size - 1));
  }

  Loads loads_ = {};
};

// Elements that go to two sides, and what is known of pairs of them: that they are on one side, or on opposite ones.
// Each has an opponent, which goes to the other side.
class Opposite_sides
{
public:
  explicit Opposite_sides(std::size_t size) : size_(static_cast<Index>(size)), sets_(2 * size_) {}

  // The name of what goes to one side together with an element, or with its opponent.
  Index find(std::size_t element, bool is_opponent = false)
  {
    return sets_.find(static_cast<Index>(element) + (is_opponent ? size_ : 0));
  }

  // Two elements that are already related stay as they are, also if that contradicts.
  void relate(std::size_t a, std::size_t b, bool are_opposite)
  {
    if(find(a) == find(b) || find(a) == find(b, true))
      return;
    sets_.link(find(a), find(b, are_opposite));
    sets_.link(find(a, true), find(b, !are_opposite));
  }

private:
  Index size_;
  Disjoint_sets<Index> sets_; // elements, and behind them their opponents
};

// On which side of its parent each branch lies, and the order of all branches of a component from the left to the
// right. A branch is led to its parent at the height of the node there. It crosses another one that lies between the
// two, and that itself or what is attached to it reaches over that height. So of two branches at one side, one has to
// be further out than the other, or they exclude each other and go to different sides.
class Branch_order
{
public:
  Branch_order(const Branch_tree& tree, const std::vector<double>& heights)
    : tree_(tree),
      extents_(tree.branches.size()),
      sizes_(tree.branches.size(), 1),
      sides_(tree.branches.size(), 0),
      children_(tree.branches.size())
  {
    for(Index branch = 0; branch != size(); ++branch)
      extents_[branch] = {heights[tree.branches[branch].lower], heights[tree.branches[branch].upper]};
    own_extents_ = extents_;
    for(Index branch = 0; branch != size(); ++branch)
    {
      const Index parent = tree.branches[branch].parent;
      if(parent == no_index)
        continue;
      extents_[parent].extend(extents_[branch]);
      sizes_[parent] += sizes_[branch];
      children_[parent].push_back(branch);
    }
    for(Index branch = size(); branch-- != 0;)
      place_children(branch);
  }

  // Of a branch, from node to node.
  const Height_range& own_extent(Index branch) const { return own_extents_[branch]; }
  // Of all that is attached to a branch as well.
  const Height_range& extent(Index branch) const { return extents_[branch]; }
  // -1 if it lies on the left of its parent, 1 on the right, 0 for a trunk.
  int side(Index branch) const { return sides_[branch]; }

  // A trunk with all that is attached to it, from the left to the right.
  std::vector<Index> branches_of_trunk(Index trunk) const
  {
    std::vector<Index> order;
    std::vector<std::pair<Index, bool>> stack = {{trunk, false}}; // whether its children have been looked at
    while(!stack.empty())
    {
      const auto [branch, is_open] = stack.back();
      stack.pop_back();
      if(is_open)
      {
        order.push_back(branch);
        continue;
      }
      // children are sorted from the left to the right
      const std::vector<Index>& children = children_[branch];
      std::size_t i = children.size();
      for(; i != 0 && sides_[children[i - 1]] > 0; --i)
        stack.emplace_back(children[i - 1], false);
      stack.emplace_back(branch, true);
      for(; i != 0; --i)
        stack.emplace_back(children[i - 1], false);
    }
    return order;
  }

private:
  // So many of the longest branches at one are compared with the other ones.
  static constexpr std::size_t most_compared = 100;
  // So many branches are passed at most on the way from one to the trunk.
  static constexpr int most_steps = 50;

  Index size() const { return static_cast<Index>(tree_.branches.size()); }
  // Calls visit(height) where a branch is led to others.
  template <class Visit>
  void for_each_port(Index branch, const Visit& visit) const
  {
    const Drawn_branch& drawn = tree_.branches[branch];
    if(drawn.is_lower_attached)
      visit(own_extents_[branch].low);
    if(drawn.is_upper_attached || drawn.is_closing)
      visit(own_extents_[branch].high);
  }

  // Whether a branch, and what is attached to it, would be crossed by the other one if it were nearer to the parent.
  bool blocks(Index branch, Index other) const
  {
    bool is_blocking = false;
    for_each_port(other, [&](double height) { is_blocking |= extents_[branch].has_inside(height); });
    return is_blocking;
  }

  void place_children(Index parent)
  {
    std::vector<Index>& children = children_[parent];
    const auto length = [&](Index branch) { return extents_[branch].high - extents_[branch].low; };
    std::sort(children.begin(), children.end(),
              [&](Index a, Index b) { return length(a) != length(b) ? length(a) > length(b) : a < b; });
    Opposite_sides related = relate_children(parent);
    std::vector<int> known_sides(2 * (children.size() + 1), 0); // 1 outward, -1 inward, 0 not yet known
    const auto set_side = [&](std::size_t element, int side) {
      known_sides[related.find(element)] = side;
      known_sides[related.find(element, true)] = -side;
    };
    set_side(children.size(), 1);

    const int outward = sides_[parent] == 0 ? 1 : sides_[parent];
    std::array<std::vector<Index>, 2> placed; // outward, inward
    std::array<Side_load, 2> loads;
    for(std::size_t i = 0; i != children.size(); ++i)
    {
      const Index child = children[i];
      if(known_sides[related.find(i)] == 0)
      {
        const bool is_inward_free =
          sides_[parent] == 0 && loads[1].load(extents_[child]) < loads[0].load(extents_[child]);
        set_side(i, is_inward_free ? -1 : 1);
      }
      const bool is_inward = known_sides[related.find(i)] < 0;
      placed[is_inward].push_back(child);
      loads[is_inward].add(extents_[child], sizes_[child]);
      sides_[child] = is_inward ? -outward : outward;
    }
    for(std::vector<Index>& side : placed)
      sort_from_inside(side);
    std::vector<Index>& left = placed[outward > 0 ? 1 : 0];
    std::reverse(left.begin(), left.end());
    children = left;
    const std::vector<Index>& right = placed[outward > 0 ? 0 : 1];
    children.insert(children.end(), right.begin(), right.end());
  }

  // Children that exclude each other go to opposite sides, those that the way of the parent would cross to its outside,
  // which is the element behind the last child. What concerns longer branches is seen to first.
  Opposite_sides relate_children(Index parent) const
  {
    const std::vector<Index>& children = children_[parent];
    Opposite_sides related(children.size() + 1);
    for(std::size_t i = 0; i != children.size(); ++i)
    {
      bool is_crossed = false;
      for_each_port(parent, [&](double height) { is_crossed |= extents_[children[i]].has_inside(height); });
      if(is_crossed)
        related.relate(i, children.size(), false);
      for(std::size_t j = 0; j != (std::min)(i, most_compared); ++j)
      {
        if(blocks(children[i], children[j]) && blocks(children[j], children[i]))
          related.relate(i, j, true);
      }
    }
    for(std::size_t i = 0; i != children.size(); ++i)
      relate_to_end_of_loop(parent, i, related);
    return related;
  }

  // A child that closes a loop at another child goes to the side of that one, and one that closes it beyond the parent
  // to its inside.
  void relate_to_end_of_loop(Index parent, std::size_t child, Opposite_sides& related) const
  {
    const std::vector<Index>& children = children_[parent];
    const Drawn_branch& drawn = tree_.branches[children[child]];
    if(!drawn.is_closing)
      return;
    Index branch = tree_.branch_of_node[drawn.upper];
    if(branch == parent)
      return;
    for(int step = 0; step != most_steps && branch != no_index && tree_.branches[branch].parent != parent; ++step)
      branch = tree_.branches[branch].parent;
    if(branch == no_index)
      related.relate(child, children.size(), true);
    else if(tree_.branches[branch].parent == parent)
    {
      const auto begin = children.begin();
      const auto end = children.size() < most_compared ? children.end() : begin + most_compared;
      const auto place = std::find(begin, end, branch);
      if(place != end)
        related.relate(child, place - begin, false);
    }
  }

  // Of branches at one side that go up, the highest is the innermost one, of those that go down the lowest. The two
  // rows are merged so that none blocks what comes later, where that can be.
  void sort_from_inside(std::vector<Index>& branches) const
  {
    const auto goes_up = [&](Index branch) { return tree_.branches[branch].is_lower_attached; };
    const auto middle = std::stable_partition(branches.begin(), branches.end(), goes_up);
    std::sort(branches.begin(), middle, [&](Index a, Index b) {
      const Height_range &first = own_extents_[a], &second = own_extents_[b];
      return first.low != second.low              ? first.low > second.low
           : extents_[a].high != extents_[b].high ? extents_[a].high < extents_[b].high
                                                  : a < b;
    });
    std::sort(middle, branches.end(), [&](Index a, Index b) {
      const Height_range &first = own_extents_[a], &second = own_extents_[b];
      return first.high != second.high          ? first.high < second.high
           : extents_[a].low != extents_[b].low ? extents_[a].low > extents_[b].low
                                                : a < b;
    });
    std::vector<Index> merged;
    auto up = branches.begin(), down = middle;
    // whether a branch blocks one of the other row that has not been taken yet
    const auto blocks_down = [&](Index branch) {
      const auto next = std::upper_bound(down, branches.end(), extents_[branch].low,
                                         [&](double height, Index other) { return height < own_extents_[other].high; });
      return next != branches.end() && own_extents_[*next].high < extents_[branch].high;
    };
    const auto blocks_up = [&](Index branch) {
      const auto next = std::upper_bound(up, middle, extents_[branch].high,
                                         [&](double height, Index other) { return height > own_extents_[other].low; });
      return next != middle && own_extents_[*next].low > extents_[branch].low;
    };
    while(up != middle && down != branches.end())
      merged.push_back(blocks_down(*up) && (blocks(*up, *down) || !blocks_up(*down)) ? *down++ : *up++);
    merged.insert(merged.end(), up, middle);
    merged.insert(merged.end(), down, branches.end());
    branches = merged.size() > most_compared ? std::move(merged) : sort_by_pairs(std::move(merged));
  }

  // Takes one after the other a branch that blocks none of those that are left, or the fewest; of several the first.
  // One that reaches around its own way to the parent counts itself: it is better further out.
  std::vector<Index> sort_by_pairs(std::vector<Index> branches) const
  {
    std::vector<std::size_t> numbers_of_blocked;
    numbers_of_blocked.reserve(branches.size());
    for(const Index branch : branches)
      numbers_of_blocked.push_back(
        std::count_if(branches.begin(), branches.end(), [&](Index other) { return blocks(branch, other); }));
    std::vector<Index> sorted;
    sorted.reserve(branches.size());
    while(!branches.empty())
    {
      const auto next = std::min_element(numbers_of_blocked.begin(), numbers_of_blocked.end());
      const auto place = branches.begin() + (next - numbers_of_blocked.begin());
      const Index branch = *place;
      sorted.push_back(branch);
      numbers_of_blocked.erase(next);
      branches.erase(place);
      for(std::size_t i = 0; i != branches.size(); ++i)
        numbers_of_blocked[i] -= blocks(branches[i], branch) ? 1 : 0;
    }
    return sorted;
  }

  const Branch_tree& tree_;
  std::vector<Height_range> extents_, own_extents_;
  std::vector<Index> sizes_; // how many branches each and what is attached to it are
  std::vector<int> sides_;
  std::vector<std::vector<Index>> children_;
};

} // namespace CGAL::Reeb_graph::internal

#endif // CGAL_REEB_GRAPH_INTERNAL_DRAWING_BRANCH_ORDER_H
