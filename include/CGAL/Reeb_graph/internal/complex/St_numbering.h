// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_INTERNAL_COMPLEX_ST_NUMBERING_H
#define CGAL_REEB_GRAPH_INTERNAL_COMPLEX_ST_NUMBERING_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/internal/base/Index.h>
#include <CGAL/Reeb_graph/internal/complex/Weighted_graph.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL::Reeb_graph::internal {

// Orders the vertices of a connected part of a graph so that each has a lower and a higher neighbor, where the
// neighbors outside of the part count as one vertex below it, the source, or as one above it, the sink. That is the
// st-numbering of R. E. Tarjan, Two Streamlined Depth-First Search Algorithms, 1986, for a graph that stays connected
// without any one vertex if source and sink are joined. The time is linear in the size of the part.
class St_numbering
{
public:
  explicit St_numbering(const Weighted_graph& graph) : graph_(graph), records_(graph.number_of_vertices()) {}

  // The order of `part`. `is_in_part` tells its vertices from the other ones, and `is_source` tells which of these
  // belong to the source.
  template <class IsInPart, class IsSource>
  std::vector<Dense_vertex> operator()(const std::vector<Dense_vertex>& part,
                                       const IsInPart& is_in_part,
                                       const IsSource& is_source)
  {
    const auto is_sink = [&](const auto& n) { return !is_in_part(n.vertex) && !is_source(n.vertex); };
    const Dense_vertex root = *std::find_if(part.begin(), part.end(), [&](Dense_vertex v) {
      const auto neighbors = graph_.neighbors(v);
      return std::any_of(neighbors.begin(), neighbors.end(), is_sink);
    });
    for(const Dense_vertex v : part) // It may have been in another part before.
      records_[v].preorder = no_index;
    search(root, is_in_part, is_source);
    return list(root);
  }

private:
  // The number of a vertex in preorder; those of the source and the sink are 0 and 1.
  typedef Index Preorder;
  static constexpr Preorder source = 0, sink = 1;

  struct Record
  {
    Preorder preorder = no_index;
    Preorder low; // lowest number that is joined to a vertex of the subtree, or in it
    Preorder parent;
    Index next_edge;
  };

  template <class IsInPart, class IsSource>
  void search(Dense_vertex root, const IsInPart& is_in_part, const IsSource& is_source)
  {
    preordered_ = {no_vertex, no_vertex};
    std::vector<Dense_vertex> path;
    const auto enter = [&](Dense_vertex v, Preorder parent) {
      const auto preorder = static_cast<Preorder>(preordered_.size());
      records_[v] = {preorder, preorder, parent, 0};
      preordered_.push_back(v);
      path.push_back(v);
    };
    enter(root, sink);
    while(!path.empty())
    {
      const Dense_vertex v = path.back();
      Record& record = records_[v];
      const auto neighbors = graph_.neighbors(v);
      if(record.next_edge == neighbors.size())
      {
        path.pop_back();
        if(!path.empty())
          records_[path.back()].low = (std::min)(records_[path.back()].low, record.low);
        continue;
      }
      const Dense_vertex u = (neighbors.begin() + record.next_edge++)->vertex;
      if(!is_in_part(u))
        record.low = (std::min)(record.low, is_source(u) ? source : sink);
      else if(records_[u].preorder == no_index)
        enter(u, record.preorder);
      else
        record.low = (std::min)(record.low, records_[u].preorder);
    }
  }

  // Inserts the vertices in preorder into a list from the source to the sink, before or behind their parents.
  std::vector<Dense_vertex> list(Dense_vertex root)
  {
    const std::size_t size = preordered_.size();
    std::vector<Preorder> next(size), previous(size);
    std::vector<bool> is_plus(size, false);
    next[source] = sink;
    previous[sink] = source;
    for(Preorder i = records_[root].preorder; i != size; ++i)
    {
      const Record& record = records_[preordered_[i]];
      const bool is_behind_parent = is_plus[record.low];
      const Preorder before = is_behind_parent ? record.parent : previous[record.parent];
      const Preorder behind = is_behind_parent ? next[record.parent] : record.parent;
      is_plus[record.parent] = !is_behind_parent;
      next[before] = i;
      previous[i] = before;
      next[i] = behind;
      previous[behind] = i;
    }
    std::vector<Dense_vertex> result;
    result.reserve(size - 2);
    for(Preorder i = next[source]; i != sink; i = next[i])
      result.push_back(preordered_[i]);
    return result;
  }

  const Weighted_graph& graph_;
  std::vector<Record> records_;
  std::vector<Dense_vertex> preordered_;
};

} // namespace CGAL::Reeb_graph::internal

#endif // CGAL_REEB_GRAPH_INTERNAL_COMPLEX_ST_NUMBERING_H
