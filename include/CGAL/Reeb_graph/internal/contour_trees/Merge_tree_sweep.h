// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of the CGAL-style package Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_INTERNAL_CONTOUR_TREES_MERGE_TREE_SWEEP_H
#define CGAL_REEB_GRAPH_INTERNAL_CONTOUR_TREES_MERGE_TREE_SWEEP_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/internal/base/Disjoint_sets.h>
#include <CGAL/Reeb_graph/internal/base/Index.h>
#include <CGAL/Reeb_graph/internal/base/Large_vector.h>
#include <CGAL/Reeb_graph/internal/base/parallel.h>
#include <CGAL/Reeb_graph/internal/base/prefetch.h>
#include <CGAL/Reeb_graph/internal/contour_trees/Merge_tree.h>
#include <CGAL/Reeb_graph/internal/critical_vertices/Swept_vertices.h>
#include <CGAL/Reeb_graph/internal/slabs/Slab.h>
#include <CGAL/Reeb_graph/internal/walks/Monotone_path_ends.h>

#include <cstddef>

namespace CGAL {
namespace Reeb_graph {
namespace internal {

// The sweep over the critical vertices that builds a merge tree from the ends of monotone paths. (Y. Chiang, T. Lenz,
// X. Lu, G. Rote, Simple and optimal output-sensitive construction of contour trees using monotone paths, 2005.)
template <class Complex, class Order, bool is_split_tree>
class Merge_tree_sweep
{
public:
  typedef Monotone_path_ends<Complex, Order, is_split_tree> Path_ends;

  Merge_tree_sweep(const Slab<Complex>& slab, const Order& order)
    : slab_(slab),
      order_(order),
      critical_vertices_(slab.critical_vertices()),
      path_ends_(slab.complex(), order, slab.critical_vertices().kept_neighbors())
  {
    tree_.parents.reserve(slab.number_of_nodes() + slab.number_of_nodes() / 16); // There may be a few cuts.
    tree_.parents.assign(slab.number_of_nodes(), no_index);
    tree_.is_border_reached.assign(slab.number_of_nodes(), false);
    tree_.is_class_shared.assign(critical_vertices_.size(), false);
    tree_.sector_classes.resize(critical_vertices_.total_number_of_sectors(is_split_tree));
    for(Index i = 0; i != critical_vertices_.size(); ++i)
    {
      if(is_extremum(i))
        path_ends_.set_end(critical_vertices_.vertex(i), components_.add(i));
      // A border vertex reaches a critical one or a cut along the border, downwards or upwards: their flags suffice.
      if(critical_vertices_.is_on_border(i))
        tree_.is_border_reached[i] = true;
    }
    number_of_extrema_ = components_.size();
    for(Index i = 0; i != slab.number_of_contours(is_split_tree); ++i)
    {
      const Index node = slab.contour_node(is_split_tree, i);
      components_.add(node);
      tree_.is_border_reached[node] = slab.is_border_reached(is_split_tree, i);
    }
  }

  // The ends that paths are known to have are the numbers of components that begin with extrema, then with contours of
  // the level from which the sweep comes.
  Path_ends& path_ends() { return path_ends_; }
  const Path_ends& path_ends() const { return path_ends_; }

  void forget_path_ends()
  {
    path_ends_ = Path_ends(slab_.complex(), order_, critical_vertices_.kept_neighbors());
    Index component = 0;
    for(Index i = 0; i != critical_vertices_.size(); ++i)
    {
      if(is_extremum(i))
        path_ends_.set_end(critical_vertices_.vertex(i), component++);
    }
  }

  // Paths are walked where they are on the surface, before the order of the field jumps about on it.
  template <class ConcurrencyTag>
  void find_path_ends()
  {
    const std::size_t size = tree_.sector_classes.size();
    constexpr std::size_t smallest_part = 4; // On a smooth field there are few paths, but long ones.
    const auto find_ends = [&](std::size_t, std::size_t begin, std::size_t end) {
      Large_vector<Index> passed;
      for(std::size_t i = begin; i != end; ++i)
        find_path_end(static_cast<Index>(i), end_at_level(), passed);
    };
    for_each_part<ConcurrencyTag>(number_of_parts<ConcurrencyTag>(size, smallest_part), size, find_ends);
  }

  template <class EndOfStep>
  void find_path_end(Index position, const EndOfStep& end_of_step, Large_vector<Index>& passed)
  {
    const Link_sector& sector = critical_vertices_.sector(is_split_tree, position);
    tree_.sector_classes[position] =
      path_ends_(Ascending_step{sector.edge, sector.extreme_neighbor}, end_of_step, passed);
  }

  void set_path_end(Index position, Index end) { tree_.sector_classes[position] = end; }

  // Of a step that leaves the slab; see Monotone_path_ends.
  auto end_at_level() const
  {
    return [this](Index target, const auto& find_edge) {
      const Index contour = slab_.contour_at_step(is_split_tree, target, find_edge);
      return contour == no_index ? no_index : number_of_extrema_ + contour;
    };
  }

  // To be called for the critical vertices in the order of the sweep. All classes are named before the first of them
  // gets a new top.
  void merge_at(Index critical)
  {
    merged_components_.clear();
    critical_vertices_.for_each_sector(critical, is_split_tree, [&](Index i) {
      const Index component = components_.find(tree_.sector_classes[i]);
      merged_components_.push_back(component);
      tree_.sector_classes[i] = components_.top(component);
    });
    for(const Index component : merged_components_)
    {
      if(components_.find(component) != component || components_.top(component) == critical)
      {
        tree_.is_class_shared[critical] = true;
        continue;
      }
      put_on(component, critical);
      components_.link(component, merged_components_.front());
    }
  }

  // Puts a node on the component in which the critical vertex is that has been merged at last.
  void put_on_last(Index node)
  {
    add_nodes_up_to(node);
    put_on(merged_components_.front(), node);
  }

  // Puts the contours of the level at which the sweep ends on their components. To be called at last.
  void merge_last_contours()
  {
    Large_vector<Index> passed;
    const Index size = slab_.number_of_contours(!is_split_tree);
    for(Index i = 0; i != size; ++i)
    {
      const Index contour = is_split_tree ? size - 1 - i : i;
      const Index end = path_ends_(slab_.step_from_contour(!is_split_tree, contour), end_at_level(), passed);
      put_on(components_.find(end), slab_.contour_node(!is_split_tree, contour));
    }
  }

  // Adds a component that begins with a new node. Returns its number.
  Index add_component_of_cut(Index node, bool is_border_reached)
  {
    add_nodes_up_to(node);
    tree_.is_border_reached[node] = is_border_reached;
    return components_.add(node);
  }

  // To be called ahead of merge_at(), and again less far ahead. Nearly all vertices have two sectors at most.
  void prefetch_classes(Index critical) const
  {
    prefetch_element(tree_.sector_classes, critical_vertices_.first_sector(critical, is_split_tree));
  }
  void prefetch_components(Index critical) const
  {
    const Index first = critical_vertices_.first_sector(critical, is_split_tree);
    if(first + 1 >= tree_.sector_classes.size())
      return;
    components_.prefetch(tree_.sector_classes[first]);
    components_.prefetch(tree_.sector_classes[first + 1]);
  }

  const Merge_tree& tree() const { return tree_; }

private:
  bool is_extremum(Index critical) const { return critical_vertices_.number_of_sectors(critical, is_split_tree) == 0; }

  void add_nodes_up_to(Index node)
  {
    if(node < tree_.parents.size())
      return;
    tree_.parents.resize(node + 1, no_index);
    tree_.is_border_reached.resize(node + 1, false);
  }

  void put_on(Index component, Index top)
  {
    const Index old_top = components_.top(component);
    tree_.parents[old_top] = top;
    if(tree_.is_border_reached[old_top])
      tree_.is_border_reached[top] = true;
    components_.set_top(component, top);
  }

  const Slab<Complex>& slab_;
  const Order& order_;
  const Swept_vertices& critical_vertices_;
  Path_ends path_ends_;
  Index number_of_extrema_;
  Merging_components components_;
  Large_vector<Index> merged_components_;
  Merge_tree tree_;
};

} // namespace internal
} // namespace Reeb_graph
} // namespace CGAL

#endif // CGAL_REEB_GRAPH_INTERNAL_CONTOUR_TREES_MERGE_TREE_SWEEP_H
