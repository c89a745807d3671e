// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors
#ifndef CGAL_REEB_GRAPH_SKELETON_SKELETON_TREES_H
#define CGAL_REEB_GRAPH_SKELETON_SKELETON_TREES_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/skeleton/Curve_skeleton.h>

#include <CGAL/boost/graph/iterator.h>

#include <boost/graph/graph_traits.hpp>

#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL::Reeb_graph {

/// \addtogroup PkgReebGraphSkeleton
/// @{

/// \brief a record of the trees of a curve skeleton, as files of neurons have them.
struct Skeleton_record
{
  /// no number
  static constexpr std::size_t none = (std::numeric_limits<std::size_t>::max)();

  std::size_t vertex = none; ///< of the skeleton
  std::size_t parent = none; ///< the number of the record that the line comes from, a smaller one; `none` at a root
  std::size_t arc = none;    ///< the number of the arc that leads from there; `none` at a root
  std::size_t edge = none;   ///< the number of that edge, in the order of the skeleton
  /// of a copy, at which a loop has been cut: the number of the other record of that vertex
  std::size_t original = none;
};

/// \brief returns the trees of a curve skeleton: an edge that would close a loop ends at a copy of its vertex.
///
/// There is a tree for each component, and the records of one follow each other, depth first. It takes linear time.
///
/// \param skeleton a curve skeleton, as it has been extracted
/// \param roots vertices, of which the first one in each component is the root of its tree. Others begin at the first
///              vertex of their first arc
template <class CurveSkeleton>
std::vector<Skeleton_record> skeleton_trees(const CurveSkeleton& skeleton, std::vector<std::size_t> roots = {})
{
  typedef std::pair<typename boost::graph_traits<CurveSkeleton>::edge_descriptor, std::size_t> Numbered_edge;
  std::vector<std::vector<Numbered_edge>> edges_of_vertices(num_vertices(skeleton));
  std::size_t number_of_edges = 0;
  for(const auto e : CGAL::make_range(edges(skeleton)))
  {
    edges_of_vertices[source(e, skeleton)].emplace_back(e, number_of_edges);
    edges_of_vertices[target(e, skeleton)].emplace_back(e, number_of_edges++);
    roots.push_back(source(e, skeleton)); // that of the first edge of an arc comes first
  }
  std::vector<bool> is_passed(number_of_edges, false);
  std::vector<std::size_t> numbers(num_vertices(skeleton), Skeleton_record::none);
  std::vector<Skeleton_record> records;
  const auto add = [&](std::size_t vertex, std::size_t parent, std::size_t arc, std::size_t edge) {
    records.push_back({vertex, parent, arc, edge, numbers[vertex]});
    if(numbers[vertex] == Skeleton_record::none)
      numbers[vertex] = records.size() - 1;
  };
  for(const std::size_t root : roots)
  {
    if(numbers[root] != Skeleton_record::none)
      continue;
    add(root, Skeleton_record::none, Skeleton_record::none, Skeleton_record::none);
    std::vector<std::size_t> path = {root};
    while(!path.empty())
    {
      std::vector<Numbered_edge>& waiting = edges_of_vertices[path.back()];
      while(!waiting.empty() && is_passed[waiting.back().second])
        waiting.pop_back();
      if(waiting.empty())
      {
        path.pop_back();
        continue;
      }
      const auto [e, number] = waiting.back();
      is_passed[number] = true;
      const std::size_t next = source(e, skeleton) == path.back() ? target(e, skeleton) : source(e, skeleton);
      add(next, numbers[path.back()], skeleton[e].arc, number);
      if(records.back().original == Skeleton_record::none)
        path.push_back(next);
    }
  }
  return records;
}

/// \brief returns the Strahler number of each record: 1 at a leaf, that of its highest child elsewhere, and one more where
/// two have that. It takes linear time.
inline std::vector<std::size_t> strahler_orders(const std::vector<Skeleton_record>& trees)
{
  std::vector<std::size_t> orders(trees.size(), 0), numbers_of_highest(trees.size(), 0); // children
  for(std::size_t i = trees.size(); i-- != 0;)
  {
    orders[i] += numbers_of_highest[i] == 1 ? 0 : 1;
    const std::size_t parent = trees[i].parent;
    if(parent == Skeleton_record::none || orders[i] < orders[parent])
      continue;
    numbers_of_highest[parent] = orders[i] > orders[parent] ? 1 : numbers_of_highest[parent] + 1;
    orders[parent] = orders[i];
  }
  return orders;
}

/// @}

} // namespace CGAL::Reeb_graph

#endif // CGAL_REEB_GRAPH_SKELETON_SKELETON_TREES_H
