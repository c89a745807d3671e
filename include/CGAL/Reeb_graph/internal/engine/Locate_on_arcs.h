// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_INTERNAL_ENGINE_LOCATE_ON_ARCS_H
#define CGAL_REEB_GRAPH_INTERNAL_ENGINE_LOCATE_ON_ARCS_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/internal/engine/Between_stages.h>

#include <algorithm>
#include <cstddef>
#include <utility>

namespace CGAL::Reeb_graph::internal {

// By vertex, the arc between critical vertices that it is on; no_index if it is critical.
typedef Indexed_vector<Vertex_index, Swept_arc_index> Arc_of_vertex;

// By node of the join tree and of the split tree: the arc that the arc to the parent of the node has gone to, the first
// one if it has been split; no_index if none.
typedef By_side<Indexed_vector<Tree_node, Swept_arc_index>> Arcs_of_classes;

// The join tree and the split tree of all of the surface, and the cuts, whose edges are registered.
struct Trees_with_cuts
{
  By_side<const Merge_tree*> trees;
  const Contour_cuts& cuts;
};

// Asks the engine for nothing besides the arcs between critical vertices.
class Locate_nothing
{
public:
  static constexpr bool are_any = false, are_in_order = false;

  template <Side, class Sweep>
  void ask_beyond(std::size_t, Sweep&)
  {}
};

// Asks the sweeps for the regular vertices, each at its place in the order of the field: its class in a merge tree is
// the top of the component that it is in. The two classes tell its arc.
template <class Complex>
class Locate_by_sorting
{
  struct Query_tag;
  typedef Index_of<Query_tag> Query;

public:
  static constexpr bool are_any = true, are_in_order = true;

  Locate_by_sorting(const Complex& complex, const Vertex_order& order, const Swept_vertices& critical_vertices)
    : complex_(complex),
      order_(order),
      critical_vertices_(critical_vertices)
  {
    find_vertices();
  }

  // Puts the vertices, which are in the order of the mesh so far, in that of the field.
  void sort(const Threads& threads)
  {
    typedef Vertex_order::Key<Vertex_index> Key;
    Vector_of<Key> keys(vertices_.size());
    threads.for_each<Query>(keys.size(), [&](Query i) { keys[i.number()] = order_.key(vertices_[i], vertices_[i]); });
    internal::sort(threads, keys.begin(), keys.end(), order_);
    find_bounds(keys);
    threads.for_each<Query>(keys.size(), [&](Query i) { vertices_[i] = keys[i.number()].name; });
    for(const Side side : both_sides)
      classes_[side].reset(vertices_.size(), no_index);
  }

  // Asks a sweep, that for the join tree, which comes from below, or that for the split tree, for the vertices beyond the
  // critical vertex at that place in ascending order, which it has visited, up to the next one.
  template <Side side, class Sweep>
  void ask_beyond(std::size_t place, Sweep& sweep)
  {
    constexpr std::size_t far_ahead = 16, ahead = 8;
    const std::size_t begin = bounds_[side == Side::LOWER ? place + 1 : place],
                      end = bounds_[side == Side::LOWER ? place + 2 : place + 1];
    // Below zero, the result is larger than all places.
    const auto moved = [](std::size_t i, std::size_t steps) { return side == Side::LOWER ? i + steps : i - steps; };
    for(std::size_t i = side == Side::LOWER ? begin : end - 1; i - begin < end - begin; i = moved(i, 1))
    {
      if(moved(i, far_ahead) < vertices_.size())
        sweep.prefetch_path_end(vertices_[Query(moved(i, far_ahead))]);
      if(moved(i, ahead) < vertices_.size())
        sweep.prefetch_component(vertices_[Query(moved(i, ahead))]);
      classes_[side][Query(i)] = sweep.class_of(vertices_[Query(i)]);
    }
  }

  // Finds the arcs of the vertices when all of them have been asked for.
  //
  // When the arc of a vertex is taken from what is left of the trees, it is that of a leaf, say an upper one: then all
  // that is left above the vertex is the rest of this arc, and the vertex is on the arc of the leaf in the split tree.
  // No earlier leaf has the vertex on its arc in either tree: all that was left on one side of it would have been the
  // rest of that leaf's arc. So the arc is the first one that a class of the vertex has gone to.
  void find_arcs(const Threads& threads, const Arcs_of_classes& arcs_of_classes, const Trees_with_cuts&)
  {
    arc_of_vertex_.assign(complex_.number_of_vertices(), no_index);
    constexpr std::size_t ahead = 16;
    threads.for_each<Query>(vertices_.size(), [&](Query i) {
      const Query later(i.number() + ahead);
      if(vertices_.contains(later))
      {
        for(const Side side : both_sides)
          prefetch_element(arcs_of_classes[side], classes_[side][later]);
        prefetch_element(arc_of_vertex_, vertices_[later]);
      }
      Swept_arc_index arc = no_index;
      for(const Side side : both_sides)
      {
        const Tree_node node = classes_[side][i];
        if(node != no_index)
          arc = (std::min)(arc, arcs_of_classes[side][node]);
      }
      arc_of_vertex_[vertices_[i]] = arc;
    });
  }

  Arc_of_vertex take_arc_of_vertex() { return std::move(arc_of_vertex_); }

private:
  void find_vertices()
  {
    vertices_.reserve(complex_.number_of_vertices() - critical_vertices_.size());
    Swept_index critical(0);
    for(const Vertex_index vertex : complex_.vertices())
    {
      if(critical.number() != critical_vertices_.size() && critical_vertices_.vertex(critical) == vertex)
        ++critical;
      else if(complex_.has_vertex(vertex))
        vertices_.push_back(vertex);
    }
  }

  template <class Keys>
  void find_bounds(const Keys& keys)
  {
    constexpr std::size_t far_ahead = 32, ahead = 16;
    const Plain_vector<Swept_index>& ascending = critical_vertices_.ascending();
    bounds_.reserve(ascending.size() + 2);
    bounds_.push_back(0);
    std::size_t end = 0;
    for(std::size_t i = 0; i != ascending.size(); ++i)
    {
      if(i + far_ahead < ascending.size())
        critical_vertices_.prefetch(ascending[i + far_ahead]);
      if(i + ahead < ascending.size())
        order_.prefetch(critical_vertices_.vertex(ascending[i + ahead]));
      const Vertex_index vertex = critical_vertices_.vertex(ascending[i]);
      const auto key = order_.key(vertex, vertex);
      while(end != keys.size() && order_(keys[end], key))
        ++end;
      bounds_.push_back(static_cast<Index>(end));
    }
    bounds_.push_back(static_cast<Index>(keys.size()));
  }

  const Complex& complex_;
  const Vertex_order& order_;
  const Swept_vertices& critical_vertices_;
  Indexed_vector<Query, Vertex_index> vertices_; // in ascending order, when sorted
  Plain_vector<Index> bounds_; // 0, how many are below each critical vertex in ascending order, the number of all
  By_side<Indexed_vector<Query, Tree_node>> classes_;
  Arc_of_vertex arc_of_vertex_;
};

// Finds the arcs of the regular vertices when the trees are known, for which no vertex has to be sorted: the class of a
// vertex in a tree is that of any neighbor from which the sweep comes, or further on towards the root. So classes go from
// vertex to vertex, in the order of the mesh. Where critical vertices are many, there are many nodes on the way.
template <class Complex>
class Locate_by_climbing
{
public:
  static constexpr bool are_any = true, are_in_order = false;

  Locate_by_climbing(const Complex& complex, const Vertex_order& order, const Swept_vertices& critical_vertices)
    : complex_(complex),
      order_(order),
      critical_vertices_(critical_vertices)
  {}

  static bool are_fast(const Complex& complex, const Swept_vertices& critical_vertices)
  {
    return critical_vertices.size() <= complex.number_of_vertices() / 16 && complex.number_of_vertices() < is_class;
  }

  template <Side, class Sweep>
  void ask_beyond(std::size_t, Sweep&)
  {}

  void find_arcs(const Threads& threads, const Arcs_of_classes& arcs_of_classes, const Trees_with_cuts& found)
  {
    for(const Side side : both_sides)
    {
      set_nodes(side, found);
      links_[side] = Links(complex_.number_of_vertices());
    }
    threads.for_each_block(complex_.number_of_edges(), [&](std::size_t begin, std::size_t end) {
      for(std::size_t i = end; i != begin; --i) // backwards, as an earlier neighbor has its class first
        set_neighbors(Edge_index(i - 1), found.cuts);
    });
    for(const Swept_index critical : critical_vertices_.indices())
      for(const Side side : both_sides)
        set_class(side, critical_vertices_.vertex(critical), node_of(critical));
    arc_of_vertex_.assign(complex_.number_of_vertices(), no_index);
    threads.for_each_block(complex_.number_of_vertices(), [&](std::size_t begin, std::size_t end) {
      find_arcs_of_block(begin, end, arcs_of_classes);
    });
    for(const Swept_index critical : critical_vertices_.indices())
      arc_of_vertex_[critical_vertices_.vertex(critical)] = no_index;
  }

  Arc_of_vertex take_arc_of_vertex() { return std::move(arc_of_vertex_); }

private:
  // Links of vertices: the number behind that of a neighbor, or the class with a bit; 0 where nothing is known.
  typedef Indexed_vector<Vertex_index, Relaxed_value<Index>> Links;
  static constexpr Index is_class = Index(1) << 31;

  // A node of a tree, with the vertex that it is at or, for one of a cut, just below. Its jump leads to an ancestor so far
  // away that to go on by parents and jumps takes a logarithm of the number of steps. (E. Myers, An applicative
  // random-access stack, 1983.)
  struct Node
  {
    Vertex_index vertex;
    Tree_node parent;
    Tree_node jump; // the node itself at a root
    Index depth;    // 1 at a root
  };
  typedef Indexed_vector<Tree_node, Node> Nodes;

  void set_nodes(Side side, const Trees_with_cuts& found)
  {
    const auto& parents = found.trees[side]->parents;
    Nodes& nodes = nodes_[side];
    nodes.reset(parents.size());
    for(const Tree_node node : parents.keys())
    {
      const Swept_index critical = found.cuts.is_cut_node(node)
                                   ? found.cuts.critical_vertex(found.cuts.cut_of_node(node))
                                   : critical_vertex_of(node);
      nodes[node] = {critical_vertices_.vertex(critical), parents[node], node, 0};
    }
    Plain_vector<Tree_node> path;
    for(Tree_node node : parents.keys())
    {
      for(; nodes[node].depth == 0; node = nodes[node].parent)
      {
        path.push_back(node);
        if(nodes[node].parent == no_index)
          break;
      }
      for(; !path.empty(); path.pop_back())
        set_jump(nodes, path.back());
    }
  }

  static void set_jump(Nodes& nodes, Tree_node node)
  {
    Node& set = nodes[node];
    set.depth = 1;
    if(set.parent == no_index)
      return;
    const Node &parent = nodes[set.parent], &jump = nodes[parent.jump];
    const bool are_jumps_equal = parent.depth - jump.depth == jump.depth - nodes[jump.jump].depth;
    set.jump = are_jumps_equal ? jump.jump : set.parent;
    set.depth = parent.depth + 1;
  }

  // Any lower and any higher neighbor will do. On an edge that is cut, the cut is what comes above the lower end.
  void set_neighbors(Edge_index edge, const Contour_cuts& cuts)
  {
    if(!complex_.has_edge(edge))
      return;
    const Vertex_index source = complex_.source(even_halfedge(edge)), target = complex_.target(even_halfedge(edge));
    const bool is_ascending = order_.is_lower(source, target);
    const Vertex_index lower = is_ascending ? source : target, higher = is_ascending ? target : source;
    links_[Side::LOWER][higher].set(lower.number() + 1);
    const Cut_index cut = cuts.lowest_at_edge(even_halfedge(edge));
    if(cut == no_index)
      links_[Side::UPPER][lower].set(higher.number() + 1);
    else
      set_class(Side::UPPER, lower, climb<Side::UPPER>(cuts.node_below(cut), lower));
  }

  void find_arcs_of_block(std::size_t begin, std::size_t end, const Arcs_of_classes& arcs_of_classes)
  {
    Plain_vector<Vertex_index> passed;
    for(const Vertex_index vertex : Index_range(Vertex_index(begin), Vertex_index(end)))
    {
      if(complex_.has_vertex(vertex))
        arc_of_vertex_[vertex] = (std::min)(arcs_of_classes[Side::LOWER][find_class<Side::LOWER>(vertex, passed)],
                                            arcs_of_classes[Side::UPPER][find_class<Side::UPPER>(vertex, passed)]);
    }
  }

  template <Side side>
  Tree_node find_class(Vertex_index vertex, Plain_vector<Vertex_index>& passed)
  {
    Index link;
    for(; (link = links_[side][vertex].get()) < is_class; vertex = Vertex_index(link - 1))
      passed.push_back(vertex);
    Tree_node node(link - is_class);
    for(; !passed.empty(); passed.pop_back())
    {
      node = climb<side>(node, passed.back());
      set_class(side, passed.back(), node);
    }
    return node;
  }

  // The last node from `node` on that the sweep meets before the vertex.
  template <Side side>
  Tree_node climb(Tree_node node, Vertex_index vertex) const
  {
    const Nodes& nodes = nodes_[side];
    const auto is_met_before = [&](Tree_node i) { return side_of(order_(vertex, nodes[i].vertex)) == side; };
    for(Tree_node parent; (parent = nodes[node].parent) != no_index && is_met_before(parent);)
      node = is_met_before(nodes[node].jump) ? nodes[node].jump : parent;
    return node;
  }

  void set_class(Side side, Vertex_index vertex, Tree_node node) { links_[side][vertex].set(node.number() + is_class); }

  const Complex& complex_;
  const Vertex_order& order_;
  const Swept_vertices& critical_vertices_;
  By_side<Nodes> nodes_;
  By_side<Links> links_; // to a lower and to a higher neighbor
  Arc_of_vertex arc_of_vertex_;
};

} // namespace CGAL::Reeb_graph::internal

#endif // CGAL_REEB_GRAPH_INTERNAL_ENGINE_LOCATE_ON_ARCS_H
