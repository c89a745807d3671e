// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_INTERNAL_ENGINE_MERGE_TREE_SWEEP_H
#define CGAL_REEB_GRAPH_INTERNAL_ENGINE_MERGE_TREE_SWEEP_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/internal/engine/slabs.h>
#include <CGAL/Reeb_graph/internal/engine/walks.h>

#include <cstddef>

namespace CGAL::Reeb_graph::internal {

// The sweep over the critical vertices that builds a merge tree from the ends of monotone paths: the join tree from
// those that descend to the lower side, the split tree from those that ascend to the upper side. (Y. Chiang, T. Lenz,
// X. Lu, G. Rote, Simple and optimal output-sensitive construction of contour trees using monotone paths, 2005.)
template <class Complex, Side side>
class Merge_tree_sweep
{
  typedef Monotone_path_ends<Complex, side> Path_ends;

public:
  Merge_tree_sweep(const Slab<Complex>& slab, const Vertex_order& order)
    : slab_(slab),
      order_(order),
      critical_vertices_(slab.critical_vertices()),
      path_ends_(slab.complex(), order, slab.critical_vertices().kept_neighbors())
  {
    tree_.parents.reserve(slab.number_of_nodes() + slab.number_of_nodes() / 16); // There may be a few cuts.
    tree_.parents.assign(slab.number_of_nodes(), no_index);
    tree_.is_border_reached.reset(slab.number_of_nodes(), false);
    tree_.is_class_shared.reset(critical_vertices_.size(), false);
    sector_components_.reset(critical_vertices_.total_number_of_sectors(side));
    tree_.classes.reset(sector_components_.size());
    for(const Swept_index i : critical_vertices_.indices())
    {
      if(is_extremum(i))
        path_ends_.set_end(critical_vertices_.vertex(i), components_.add(node_of(i)));
      // A border vertex reaches a critical one or a cut along the border, downwards or upwards: their flags suffice.
      if(critical_vertices_.is_on_border(i))
        tree_.is_border_reached[node_of(i)] = true;
    }
    number_of_extrema_ = components_.size();
    for(const Contour_index i : slab.contours(side))
    {
      const Tree_node node = slab.contour_node(side, i);
      components_.add(node);
      tree_.is_border_reached[node] = slab.is_border_reached(side, i);
    }
  }

  // Paths are walked where they are on the surface, before the order of the field jumps about on it.
  void find_path_ends(const Threads& threads)
  {
    const std::size_t size = sector_components_.size();
    constexpr std::size_t smallest_part = 4; // On a smooth field there are few paths, but long ones.
    const auto find_ends = [&](std::size_t, std::size_t begin, std::size_t end) {
      Plain_vector<Vertex_index> passed;
      for(const Sector_index i : Index_range(Sector_index(begin), Sector_index(end)))
        find_path_end(i, end_at_level(), passed);
    };
    threads.for_each_part(threads.number_of_parts(size, smallest_part), size, find_ends);
  }

  // Finds the ends of the paths from all vertices.
  void find_path_ends_of_vertices(const Threads& threads)
  {
    threads.for_each_block(slab_.complex().number_of_vertices(), [&](std::size_t begin, std::size_t end) {
      Plain_vector<Vertex_index> passed;
      for(const Vertex_index vertex : Index_range(Vertex_index(begin), Vertex_index(end)))
      {
        if(slab_.complex().has_vertex(vertex))
          path_ends_.end_of_path(vertex, end_at_level(), passed);
      }
    });
  }

  // Merges components at a critical vertex, which come in the order of the sweep. All classes are named before the
  // first of them gets a new top.
  void merge_at(Swept_index critical)
  {
    merged_components_.clear();
    for(const Sector_index i : critical_vertices_.sectors(critical, side))
    {
      const Component_index component = components_.find(sector_components_[i]);
      merged_components_.push_back(component);
      tree_.classes[i] = components_.top(component);
    }
    for(const Component_index component : merged_components_)
    {
      if(components_.top(component) == node_of(critical)) // It has been merged, and keeps its last top.
      {
        tree_.is_class_shared[critical] = true;
        continue;
      }
      put_on(component, node_of(critical));
      components_.link(component, merged_components_.front());
    }
  }

  // The class of a regular vertex at which the sweep has arrived: the top of the component that it is in.
  Tree_node class_of(Vertex_index vertex) { return class_of(vertex, end_at_level(), passed_); }
  template <class EndOfStep>
  Tree_node class_of(Vertex_index vertex, const EndOfStep& end_of_step, Plain_vector<Vertex_index>& passed)
  {
    return components_.top(components_.find(path_ends_.end_of_path(vertex, end_of_step, passed)));
  }

  // Puts the contours of the level at which the sweep ends on their components, when all vertices have been merged. What
  // a cut has parted is one component again by then, so paths may pass cuts.
  void merge_last_contours()
  {
    Plain_vector<Vertex_index> passed;
    constexpr Side last_side = opposite_of(side);
    const Index size = slab_.number_of_contours(last_side);
    for(Index i = 0; i != size; ++i)
    {
      const Contour_index contour(side == Side::UPPER ? size - 1 - i : i);
      const Component_index end = path_ends_(slab_.step_from_contour(last_side, contour), end_at_level(), passed);
      put_on(components_.find(end), slab_.contour_node(last_side, contour));
    }
  }

  // Fetch memory ahead of merge_at(), the second one less far ahead. Nearly all vertices have two sectors at most.
  void prefetch_classes(Swept_index critical) const
  {
    prefetch_element(sector_components_, critical_vertices_.first_sector(critical, side));
    prefetch_element(tree_.classes, critical_vertices_.first_sector(critical, side));
  }
  void prefetch_components(Swept_index critical) const
  {
    const Sector_index first = critical_vertices_.first_sector(critical, side), second(first.number() + 1);
    if(!sector_components_.contains(second))
      return;
    components_.prefetch(sector_components_[first]);
    components_.prefetch(sector_components_[second]);
  }

  // Fetch memory ahead of class_of(), the second one if the ends of paths are known.
  void prefetch_path_end(Vertex_index vertex) const { path_ends_.prefetch(vertex); }
  void prefetch_component(Vertex_index vertex) const { components_.prefetch(path_ends_.end(vertex)); }

  const Merge_tree& tree() const { return tree_; }

protected:
  template <class EndOfStep>
  void find_path_end(Sector_index i, const EndOfStep& end_of_step, Plain_vector<Vertex_index>& passed)
  {
    const Link_sector& sector = critical_vertices_.sector(side, i);
    sector_components_[i] = path_ends_(Ascending_step{sector.edge, sector.extreme_neighbor}, end_of_step, passed);
  }

  // The end of a step that leaves the slab; see Monotone_path_ends.
  auto end_at_level() const
  {
    return [this](Vertex_index target, const auto& find_edge) -> Component_index {
      const Contour_index contour = slab_.contour_at_step(side, target, find_edge);
      if(contour == no_index)
        return no_index;
      return Component_index(number_of_extrema_ + contour.number());
    };
  }

  // The ends that paths are known to have are components that begin with extrema, then with contours of the level from
  // which the sweep comes.
  void forget_path_ends()
  {
    path_ends_ = Path_ends(slab_.complex(), order_, critical_vertices_.kept_neighbors());
    Component_index component(0);
    for(const Swept_index i : critical_vertices_.indices())
    {
      if(!is_extremum(i))
        continue;
      path_ends_.set_end(critical_vertices_.vertex(i), component);
      ++component;
    }
  }

  // Puts a node on the component in which the critical vertex is that has been merged at last. An extremum has begun
  // one of its own; on a surface, none has a node to be put there.
  void put_on_last(Swept_index critical, Tree_node node)
  {
    add_nodes_up_to(node);
    const Vertex_index vertex = critical_vertices_.vertex(critical);
    put_on(merged_components_.empty() ? path_ends_.end(vertex) : merged_components_.front(), node);
  }

  // Adds a component that begins with a new node. Returns its number.
  Component_index add_component_of_cut(Tree_node node, bool is_border_reached)
  {
    add_nodes_up_to(node);
    tree_.is_border_reached[node] = is_border_reached;
    return components_.add(node);
  }

  const Slab<Complex>& slab_;
  const Vertex_order& order_;
  const Swept_vertices& critical_vertices_;
  Path_ends path_ends_;
  Indexed_vector<Sector_index, Component_index> sector_components_; // in which a monotone path from there ends
  Plain_vector<Vertex_index> passed_;

private:
  bool is_extremum(Swept_index critical) const { return critical_vertices_.number_of_sectors(critical, side) == 0; }

  void add_nodes_up_to(Tree_node node)
  {
    if(tree_.parents.contains(node))
      return;
    tree_.parents.resize(node.number() + 1, no_index);
    tree_.is_border_reached.resize(node.number() + 1, false);
  }

  void put_on(Component_index component, Tree_node top)
  {
    const Tree_node old_top = components_.top(component);
    tree_.parents[old_top] = top;
    if(tree_.is_border_reached[old_top])
      tree_.is_border_reached[top] = true;
    components_.set_top(component, top);
  }

  Index number_of_extrema_;
  Merging_components<Tree_node> components_;
  Plain_vector<Component_index> merged_components_;
  Merge_tree tree_;
};

} // namespace CGAL::Reeb_graph::internal

#endif // CGAL_REEB_GRAPH_INTERNAL_ENGINE_MERGE_TREE_SWEEP_H
