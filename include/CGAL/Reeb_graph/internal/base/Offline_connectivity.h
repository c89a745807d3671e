// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_INTERNAL_BASE_OFFLINE_CONNECTIVITY_H
#define CGAL_REEB_GRAPH_INTERNAL_BASE_OFFLINE_CONNECTIVITY_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/internal/base/arrays.h>

#include <cstddef>
#include <utility>

namespace CGAL::Reeb_graph::internal {

struct Graph_node_tag;
typedef Index_of<Graph_node_tag> Graph_node;

// Two nodes of a graph that changes are joined from the time `begin` on, and no more at the time `end`.
struct Timed_link
{
  Graph_node a, b;
  Index begin, end;
};

// Finds which of some nodes are connected in a graph that changes, at several times that are known beforehand, by
// divide and conquer over the times: in an interval of them, the links that last all through are contracted, and only
// nodes at other links, or at which there is a question, are looked at any further.
//
// Proof of the bound: a link is kept in an interval only if it begins or ends inside, so in at most two intervals of
// each depth, and an interval has at most two nodes per link that it keeps, and one per question. Either half of an
// interval has at most half of its beginnings and ends, so the depth is at most log(2 m), and the links of all
// intervals that are kept at once decrease geometrically. So m links and s nodes in question take O((m + s) log m)
// steps of a union-find, and O(m + s) memory.
class Offline_connectivity
{
public:
  // At time t, the nodes in question are those from first_questions[t] to first_questions[t + 1].
  Offline_connectivity(Plain_vector<Graph_node> questions, const Plain_vector<Index>& first_questions)
    : first_questions_(first_questions),
      nodes_(std::move(questions))
  {}

  // Names the components of the nodes in question: two of one time have the same name if they are connected then.
  Plain_vector<Graph_node> operator()(Index number_of_nodes, const Plain_vector<Timed_link>& links)
  {
    divide(0, static_cast<Index>(first_questions_.size()) - 1, links, number_of_nodes);
    return std::move(nodes_);
  }

  // How many links have been looked at, in all intervals.
  std::size_t number_of_steps() const { return number_of_steps_; }

private:
  // Answers the questions of the times from `begin` to `end`. Each link that is kept begins or ends in between; where
  // none is left, nothing changes, and connected nodes have become one.
  void divide(Index begin, Index end, const Plain_vector<Timed_link>& links, Index number_of_nodes)
  {
    Plain_vector<Timed_link> kept;
    const Index number_of_kept_nodes = contract(begin, end, links, number_of_nodes, kept);
    if(kept.empty())
      return;
    number_of_steps_ += kept.size();
    const Index middle = find_middle(begin, end, kept);
    divide(begin, middle, kept, number_of_kept_nodes);
    divide(middle, end, kept, number_of_kept_nodes);
  }

  // Contracts the links that last all through an interval of the times, and keeps the other ones that are there, with
  // new names of their nodes, which the nodes in question get, too. Returns the number of names.
  Index contract(Index begin,
                 Index end,
                 const Plain_vector<Timed_link>& links,
                 Index number_of_nodes,
                 Plain_vector<Timed_link>& kept)
  {
    Disjoint_sets<Graph_node> sets(number_of_nodes);
    kept.reserve(links.size());
    for(const Timed_link& link : links)
    {
      if(link.begin <= begin && link.end >= end)
        sets.unite(link.a, link.b);
      else if(link.begin < end && link.end > begin)
        kept.push_back(link);
    }
    Indexed_vector<Graph_node, Graph_node> names(number_of_nodes, no_index); // by root
    Index number_of_names = 0;
    const auto name = [&](Graph_node root) {
      if(names[root] == no_index)
        names[root] = Graph_node(number_of_names++);
      return names[root];
    };
    std::size_t number_of_kept = 0;
    for(const Timed_link& link : kept)
    {
      const Graph_node a = sets.find(link.a), b = sets.find(link.b);
      if(a != b)
        kept[number_of_kept++] = {name(a), name(b), link.begin, link.end};
    }
    kept.resize(number_of_kept);
    for(Index i = first_questions_[begin]; i != first_questions_[end]; ++i)
      nodes_[i] = name(sets.find(nodes_[i]));
    return number_of_names;
  }

  // The time up to which about half of the beginnings and ends are, neither the first nor the last one.
  static Index find_middle(Index begin, Index end, const Plain_vector<Timed_link>& links)
  {
    Plain_vector<Index> counts(end - begin, 0);
    std::size_t total = 0;
    const auto count = [&](Index time) {
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
    Index middle = begin;
    while(2 * (sum += counts[middle - begin]) < total)
      ++middle;
    return middle;
  }

  const Plain_vector<Index>& first_questions_;
  Plain_vector<Graph_node> nodes_; // in question, by the names of the interval that is looked at
  std::size_t number_of_steps_ = 0;
};

} // namespace CGAL::Reeb_graph::internal

#endif // CGAL_REEB_GRAPH_INTERNAL_BASE_OFFLINE_CONNECTIVITY_H
