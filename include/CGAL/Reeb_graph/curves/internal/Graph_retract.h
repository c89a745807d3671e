// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of the CGAL-style package Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_CURVES_INTERNAL_GRAPH_RETRACT_H
#define CGAL_REEB_GRAPH_CURVES_INTERNAL_GRAPH_RETRACT_H

#include <CGAL/license/Reeb_graph.h>

#include <boost/graph/graph_traits.hpp>
#include <boost/range/iterator_range.hpp>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL {
namespace Reeb_graph {
namespace internal {

// A sequence of arcs that a curve can be moved along.
template <class ArcDescriptor>
struct Arc_path
{
  struct Passed_arc
  {
    ArcDescriptor arc;
    bool is_passed_upwards;
  };

  std::size_t first_node = 0, last_node = 0;
  std::vector<Passed_arc> arcs;
};

// The deformation retract of a Reeb graph: leaves are removed one after the other, unless they are to be kept; arcs
// that meet at a node of degree 2 are joined. A component that is a cycle then is one path from a node to itself.
template <class ReebGraph>
class Graph_retract
{
  typedef typename boost::graph_traits<ReebGraph>::edge_descriptor arc_descriptor;
  static constexpr std::size_t none = (std::numeric_limits<std::size_t>::max)();

public:
  typedef Arc_path<arc_descriptor> Path;

  // A leaf stays if `is_kept` is true for its node.
  Graph_retract(const ReebGraph& graph, const std::vector<bool>& is_kept)
    : graph_(graph),
      arcs_(edges(graph).first, edges(graph).second),
      is_left_(arcs_.size(), true)
  {
    list_arcs_of_nodes();
    remove_leaves(is_kept);
    for(std::size_t node = 0; node != degrees_.size(); ++node)
    {
      if(degrees_[node] != 0 && degrees_[node] != 2)
        add_paths(node);
    }
    for(std::size_t node = 0; node != degrees_.size(); ++node)
    {
      if(degrees_[node] == 2)
        add_paths(node);
    }
  }

  const std::vector<Path>& paths() const { return paths_; }

private:
  std::size_t lower(std::size_t arc) const { return source(arcs_[arc], graph_); }
  std::size_t upper(std::size_t arc) const { return target(arcs_[arc], graph_); }
  std::size_t other_end(std::size_t arc, std::size_t node) const
  {
    return lower(arc) == node ? upper(arc) : lower(arc);
  }

  void list_arcs_of_nodes()
  {
    arcs_of_node_.resize(num_vertices(graph_));
    for(std::size_t arc = 0; arc != arcs_.size(); ++arc)
    {
      arcs_of_node_[lower(arc)].push_back(arc);
      arcs_of_node_[upper(arc)].push_back(arc);
    }
    for(const auto& arcs : arcs_of_node_)
      degrees_.push_back(arcs.size());
  }

  std::size_t any_arc_left(std::size_t node) const
  {
    const auto& arcs = arcs_of_node_[node];
    const auto found = std::find_if(arcs.begin(), arcs.end(), [&](std::size_t arc) { return is_left_[arc]; });
    return found == arcs.end() ? none : *found;
  }

  void remove_leaves(const std::vector<bool>& is_kept)
  {
    for(std::size_t leaf = 0; leaf != degrees_.size(); ++leaf)
    {
      std::size_t node = leaf;
      while(degrees_[node] == 1 && !is_kept[node])
      {
        const std::size_t arc = any_arc_left(node);
        is_left_[arc] = false;
        --degrees_[node];
        node = other_end(arc, node);
        --degrees_[node];
      }
    }
  }

  // Adds all paths that leave the node and have not been followed from their other end.
  void add_paths(std::size_t node)
  {
    for(const std::size_t arc : arcs_of_node_[node])
    {
      if(is_left_[arc])
        follow_path(node, arc);
    }
  }

  void follow_path(std::size_t first_node, std::size_t arc)
  {
    Path path;
    std::size_t node = first_node;
    do
    {
      path.arcs.push_back({arcs_[arc], lower(arc) == node});
      is_left_[arc] = false;
      node = other_end(arc, node);
      arc = any_arc_left(node);
    } while(degrees_[node] == 2 && node != first_node);
    path.first_node = first_node;
    path.last_node = node;
    paths_.push_back(path);
  }

  const ReebGraph& graph_;
  std::vector<arc_descriptor> arcs_;
  std::vector<bool> is_left_;
  std::vector<std::vector<std::size_t>> arcs_of_node_;
  std::vector<std::size_t> degrees_;
  std::vector<Path> paths_;
};

} // namespace internal
} // namespace Reeb_graph
} // namespace CGAL

#endif // CGAL_REEB_GRAPH_CURVES_INTERNAL_GRAPH_RETRACT_H
