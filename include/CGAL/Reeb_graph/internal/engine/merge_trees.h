// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_INTERNAL_ENGINE_MERGE_TREES_H
#define CGAL_REEB_GRAPH_INTERNAL_ENGINE_MERGE_TREES_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/internal/base/Index.h>
#include <CGAL/Reeb_graph/internal/base/arrays.h>
#include <CGAL/Reeb_graph/internal/base/parallel.h>
#include <CGAL/Reeb_graph/internal/base/tuning.h>
#include <CGAL/Reeb_graph/internal/base/union_find.h>
#include <CGAL/Reeb_graph/internal/engine/Bounding_level.h>
#include <CGAL/Reeb_graph/internal/engine/Slab.h>
#include <CGAL/Reeb_graph/internal/engine/Swept_arcs.h>
#include <CGAL/Reeb_graph/internal/engine/Swept_vertices.h>
#include <CGAL/Reeb_graph/internal/engine/monotone_paths.h>
#include <CGAL/Reeb_graph/internal/engine/vertex_links.h>

#include <cstddef>
#include <utility>

namespace CGAL::Reeb_graph::internal {

// A join tree or a split tree. Its nodes are those of a slab, and two of each loop cut.
struct Merge_tree
{
  Indexed_vector<Tree_node, Tree_node> parents;      // where the component of a node merges; no_index at a root
  Indexed_vector<Tree_node, bool> is_border_reached; // whether the component of which the node is the top has border
  Indexed_vector<Swept_index, bool> is_class_shared; // whether two sectors of the vertex are in one component

  // By lower link sector in the join tree, by upper one in the split tree: the class of the sector, which is the top of
  // the component that it is in when the sweep arrives at its vertex.
  Indexed_vector<Sector_index, Tree_node> classes;
};

// The sweep over the critical vertices that builds a merge tree from the ends of monotone paths: the join tree from
// those that descend to the lower side, the split tree from those that ascend to the upper side. (Y. Chiang, T. Lenz,
// X. Lu, G. Rote, Simple and optimal output-sensitive construction of contour trees using monotone paths, 2005.)
template <class Complex, class Order, Side side>
class Merge_tree_sweep
{
  typedef Monotone_path_ends<Complex, Order, side> Path_ends;

public:
  Merge_tree_sweep(const Slab<Complex>& slab, const Order& order)
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
  template <class ConcurrencyTag>
  void find_path_ends()
  {
    const std::size_t size = sector_components_.size();
    constexpr std::size_t smallest_part = 4; // On a smooth field there are few paths, but long ones.
    const auto find_ends = [&](std::size_t, std::size_t begin, std::size_t end) {
      Plain_vector<Vertex_index> passed;
      for(const Sector_index i : Index_range(Sector_index(begin), Sector_index(end)))
        find_path_end(i, end_at_level(), passed);
    };
    for_each_part<ConcurrencyTag>(number_of_parts<ConcurrencyTag>(size, smallest_part), size, find_ends);
  }

  // Finds the ends of the paths from all vertices.
  template <class ConcurrencyTag>
  void find_path_ends_of_vertices()
  {
    for_each_block<ConcurrencyTag>(slab_.complex().number_of_vertices(), [&](std::size_t begin, std::size_t end) {
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
    const Number size = slab_.number_of_contours(last_side);
    for(Number i = 0; i != size; ++i)
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
  const Order& order_;
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

  Number number_of_extrema_;
  Merging_components<Tree_node> components_;
  Plain_vector<Component_index> merged_components_;
  Merge_tree tree_;
};

// A rooted tree from which leaves and nodes with one child are taken away. The children of a node are known by their
// number and by the exclusive or of their names, which is the name of the last one.
class Shrinking_tree
{
public:
  Shrinking_tree() = default;
  // Room that is left for more nodes is left here too.
  explicit Shrinking_tree(const Indexed_vector<Tree_node, Tree_node>& parents)
  {
    nodes_.reserve(parents.capacity());
    nodes_.assign(parents.size(), Node{no_index, 0, 0});
    constexpr Number ahead = 16;
    for(const Tree_node node : parents.keys())
    {
      const Tree_node later(node.number() + ahead);
      if(parents.contains(later) && parents[later] != no_index)
        prefetch(&nodes_[parents[later]]);
      nodes_[node].parent = parents[node];
      if(parents[node] == no_index)
      {
        ++number_of_roots_;
        continue;
      }
      ++nodes_[parents[node]].number_of_children;
      nodes_[parents[node]].child_names ^= node.number();
    }
  }

  // Adds nodes, which have to be put somewhere then.
  void resize(std::size_t number_of_nodes) { nodes_.resize(number_of_nodes); }

  // The child is no root.
  void put_above(Tree_node child, Tree_node node)
  {
    const Tree_node parent = nodes_[child].parent;
    nodes_[node] = {parent, 1, child.number()};
    nodes_[child].parent = node;
    nodes_[parent].child_names ^= node.number() ^ child.number();
  }

  void put_leaf_below(Tree_node parent, Tree_node node)
  {
    nodes_[node] = {parent, 0, 0};
    ++nodes_[parent].number_of_children;
    nodes_[parent].child_names ^= node.number();
  }

  // How many roots the tree has before any node is removed.
  Number number_of_roots() const { return number_of_roots_; }

  Tree_node parent(Tree_node node) const { return nodes_[node].parent; }
  Number number_of_children(Tree_node node) const { return nodes_[node].number_of_children; }
  Tree_node only_child(Tree_node node) const { return Tree_node(nodes_[node].child_names); }

  void remove_leaf(Tree_node node)
  {
    Node& parent = nodes_[nodes_[node].parent];
    --parent.number_of_children;
    parent.child_names ^= node.number();
  }

  // The only child takes the place of the node.
  void remove_inner_node(Tree_node node)
  {
    const Tree_node child = only_child(node), parent = nodes_[node].parent;
    nodes_[child].parent = parent;
    if(parent != no_index)
      nodes_[parent].child_names ^= node.number() ^ child.number();
    nodes_[node].number_of_children = 0;
  }

private:
  struct Node
  {
    Tree_node parent;
    Number number_of_children;
    Number child_names;
  };

  Indexed_vector<Tree_node, Node> nodes_;
  Number number_of_roots_ = 0;
};

// By node of the join tree and of the split tree: the arc that the arc to the parent of the node has gone to, the first
// one if it has been split; no_index if none.
typedef By_side<Indexed_vector<Tree_node, Swept_arc_index>> Arcs_of_classes;

// Combines a join tree and a split tree of the same nodes to the arcs of the contour tree, leaf by leaf. (H. Carr,
// J. Snoeyink, U. Axen, Computing contour trees in all dimensions, 2003.) On request, it keeps what
// find_arcs_of_classes() needs.
template <bool are_leaves_kept>
class Tree_combination
{
public:
  Tree_combination(Shrinking_tree join_tree,
                   Shrinking_tree split_tree,
                   Indexed_vector<Tree_node, Ascending_step> first_steps)
    : trees_{{std::move(join_tree), std::move(split_tree)}},
      first_steps_(std::move(first_steps))
  {
    arcs_.reserve(first_steps_.size());
  }

  Swept_arcs operator()()
  {
    for(const Tree_node node : first_steps_.keys())
      take_leaves_from(node);
    return std::move(arcs_);
  }

  // Follows the classes to the arcs that have been found: in the tree where a leaf of the other one is no leaf, the
  // only child takes its place, and goes later.
  Arcs_of_classes find_arcs_of_classes(const Swept_arcs& arcs) const
  {
    static_assert(are_leaves_kept);
    Arcs_of_classes result;
    for(const Side side : both_sides)
      result[side].reset(first_steps_.size(), no_index);
    for(std::size_t i = arcs.size(); i != 0;)
    {
      const Swept_arc_index arc(--i);
      const Side side = sides_of_leaves_[i];
      const Tree_node leaf = side == Side::LOWER ? arcs[arc].lower : arcs[arc].upper;
      const Side other = opposite_of(side);
      result[side][leaf] = arc;
      result[other][leaf] = result[other][trees_[other].only_child(leaf)];
    }
    return result;
  }

private:
  // Whether the node is a leaf that is left at one side: the lower one in the join tree, the upper one in the split tree.
  // A root is no leaf, as it is none of trees of the same order.
  template <Side side>
  bool is_leaf(Tree_node node) const
  {
    return trees_[side].number_of_children(node) == 0 && trees_[opposite_of(side)].number_of_children(node) == 1
        && trees_[side].parent(node) != no_index;
  }

  // Takes the node away if it is a leaf, and then its neighbor if that makes it one, and so on.
  void take_leaves_from(Tree_node node)
  {
    while(node != no_index)
    {
      if(is_leaf<Side::LOWER>(node))
        node = take_leaf<Side::LOWER>(node);
      else if(is_leaf<Side::UPPER>(node))
        node = take_leaf<Side::UPPER>(node);
      else
        node = no_index;
    }
  }

  // Returns the other end of the leaf's arc.
  template <Side side>
  Tree_node take_leaf(Tree_node leaf)
  {
    const Tree_node end = trees_[side].parent(leaf);
    if constexpr(side == Side::LOWER)
    {
      const Tree_node child = trees_[Side::UPPER].only_child(leaf);
      arcs_.push_back({leaf, end, first_steps_[child]});
      first_steps_[child] = first_steps_[leaf];
    }
    else
      arcs_.push_back({end, leaf, first_steps_[leaf]});
    if constexpr(are_leaves_kept)
      sides_of_leaves_.push_back(side);
    trees_[side].remove_leaf(leaf);
    trees_[opposite_of(side)].remove_inner_node(leaf);
    return end;
  }

  By_side<Shrinking_tree> trees_;
  Indexed_vector<Tree_node, Ascending_step> first_steps_; // from its parent in the split tree towards it
  Swept_arcs arcs_;
  Plain_vector<Side> sides_of_leaves_; // by arc
};

} // namespace CGAL::Reeb_graph::internal

#endif // CGAL_REEB_GRAPH_INTERNAL_ENGINE_MERGE_TREES_H
