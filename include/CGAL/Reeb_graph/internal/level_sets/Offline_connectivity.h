// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of the CGAL-style package Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_INTERNAL_LEVEL_SETS_OFFLINE_CONNECTIVITY_H
#define CGAL_REEB_GRAPH_INTERNAL_LEVEL_SETS_OFFLINE_CONNECTIVITY_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/internal/base/Disjoint_sets.h>
#include <CGAL/Reeb_graph/internal/base/Index.h>
#include <CGAL/Reeb_graph/internal/base/Indexed_vector.h>

#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Reeb_graph {
namespace internal {

struct Graph_node_tag;
typedef Index_of<Graph_node_tag> Graph_node;

// Two nodes of a graph that changes are joined from the time `begin` on, and no more at the time `end`.
struct Timed_link
{
  Graph_node a, b;
  Number begin, end;
};

// Finds which of some nodes are connected in a graph that changes, at several times that are known beforehand, by
// divide and conquer over the times: in an interval of them, the links that last all through are contracted, and only
// nodes at other links, or at which there is a question, are looked at any further.
//
// Proof of the bound: a link is kept in an interval only if it begins or ends inside, so in at most two intervals of
// one size, and each interval has at most two nodes more per link that it keeps, and one per question. Intervals are
// divided such that either half has at most half of the beginnings and ends. So m links and s nodes in question, at q
// times, take O((m + s) log min(m, q)) steps of a union-find, and O(m + s + q) memory.
class Offline_connectivity
{
public:
  // At time t, the nodes in question are those from first_questions[t] to first_questions[t + 1].
  Offline_connectivity(const std::vector<Graph_node>& questions, const std::vector<Number>& first_questions)
    : first_questions_(first_questions),
      nodes_(questions),
      components_(questions.size())
  {}

  // Names the components of the nodes in question: two of one time have the same name if they are connected then.
  std::vector<Number> operator()(Number number_of_nodes, std::vector<Timed_link> links)
  {
    if(number_of_times() == 0)
      return {};
    std::vector<Timed_link> kept;
    const Number number_of_kept_nodes = contract(0, number_of_times(), links, number_of_nodes, kept);
    std::vector<Timed_link>().swap(links);
    divide(0, number_of_times(), std::move(kept), number_of_kept_nodes);
    return std::move(components_);
  }

  // How many links have been looked at, in all intervals.
  std::size_t number_of_steps() const { return number_of_steps_; }

private:
  Number number_of_times() const { return static_cast<Number>(first_questions_.size()) - 1; }

  // Answers the questions of the times from `begin` to `end`. Each link begins or ends in between.
  void divide(Number begin, Number end, std::vector<Timed_link> links, Number number_of_nodes)
  {
    if(links.empty() || end - begin == 1)
      return answer(begin, end, links, number_of_nodes);
    const Number middle = find_middle(begin, end, links);
    std::vector<Timed_link> lower, upper;
    const Number size_of_lower = contract(begin, middle, links, number_of_nodes, lower);
    const Number size_of_upper = contract(middle, end, links, number_of_nodes, upper);
    std::vector<Timed_link>().swap(links);
    divide(begin, middle, std::move(lower), size_of_lower);
    divide(middle, end, std::move(upper), size_of_upper);
  }

  // The time up to which about half of the beginnings and ends are, neither the first nor the last one.
  static Number find_middle(Number begin, Number end, const std::vector<Timed_link>& links)
  {
    std::vector<Number> counts(end - begin, 0);
    std::size_t total = 0;
    const auto count = [&](Number time) {
      if(time <= begin || time >= end)
        return;
      ++counts[time - begin];
      ++total;
    };
    for(const Timed_link& link : links)
    {
      count(link.begin);
      count(link.end);
    }
    std::size_t sum = 0;
    Number middle = begin;
    while(2 * (sum += counts[middle - begin]) < total)
      ++middle;
    return middle;
  }

  // Contracts the links that last from `begin` to `end`, and writes those that do not to `kept`, with new names of
  // nodes, which nodes in question get, too. Returns how many nodes there are then.
  Number contract(Number begin,
                  Number end,
                  const std::vector<Timed_link>& links,
                  Number number_of_nodes,
                  std::vector<Timed_link>& kept)
  {
    number_of_steps_ += links.size();
    Disjoint_sets<Graph_node> sets(number_of_nodes);
    for(const Timed_link& link : links)
    {
      if(link.begin <= begin && link.end >= end)
        sets.unite(link.a, link.b);
    }
    Indexed_vector<Graph_node, Graph_node> names(number_of_nodes, no_index);
    Number number_of_names = 0;
    const auto name = [&](Graph_node node) {
      Graph_node& result = names[sets.find(node)];
      if(result == no_index)
        result = Graph_node(number_of_names++);
      return result;
    };
    for(const Timed_link& link : links)
    {
      const bool is_dropped = link.begin >= end || link.end <= begin || (link.begin <= begin && link.end >= end);
      if(is_dropped || sets.find(link.a) == sets.find(link.b))
        continue;
      kept.push_back({name(link.a), name(link.b), link.begin, link.end});
    }
    for(Number i = first_questions_[begin]; i != first_questions_[end]; ++i)
      nodes_[i] = name(nodes_[i]);
    return number_of_names;
  }

  // Answers questions between which nothing changes: all links that are there last all through.
  void answer(Number begin, Number end, const std::vector<Timed_link>& links, Number number_of_nodes)
  {
    number_of_steps_ += links.size();
    Disjoint_sets<Graph_node> sets(number_of_nodes);
    for(const Timed_link& link : links)
    {
      if(link.begin < end && link.end > begin)
        sets.unite(link.a, link.b);
    }
    for(Number i = first_questions_[begin]; i != first_questions_[end]; ++i)
      components_[i] = sets.find(nodes_[i]).number();
  }

  const std::vector<Number>& first_questions_;
  std::vector<Graph_node> nodes_; // in question, by the names of the interval that is looked at
  std::vector<Number> components_;
  std::size_t number_of_steps_ = 0;
};

} // namespace internal
} // namespace Reeb_graph
} // namespace CGAL

#endif // CGAL_REEB_GRAPH_INTERNAL_LEVEL_SETS_OFFLINE_CONNECTIVITY_H
