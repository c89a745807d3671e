// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_INTERNAL_ENGINE_SLABS_H
#define CGAL_REEB_GRAPH_INTERNAL_ENGINE_SLABS_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/internal/base/arrays.h>
#include <CGAL/Reeb_graph/internal/engine/walks.h>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::Reeb_graph::internal {

struct Contour_tag;
typedef Index_of<Contour_tag> Contour_index;

// A level between two slabs, and its contours, numbered in the order of their first edges. It
// holds the map from crossed edges to contours by which slabs are glued. (The paper, Section 5.3.)
class Bounding_level
{
public:
  explicit Bounding_level(Index number_of_edges) : crossed_edges_(number_of_edges) {}

  void add_crossed_edge(Edge_index edge) { crossed_edges_.add(edge); }

  // Finds the contours when all crossed edges have been added.
  template <class Complex, class IsBelow>
  void find_contours(const Complex& complex, const IsBelow& is_below)
  {
    crossed_edges_.count_ranks();
    contours_.reset(crossed_edges_.size(), no_index);
    crossed_edges_.for_each([&](Edge_index edge) {
      if(contours_[crossed_edges_.rank(edge)] != no_index)
        return;
      first_edges_.push_back(edge);
      const Contour_index contour = first_edges_.last_key();
      is_border_reached_.push_back(false);
      trace_contour(complex, complex.halfedge_of_triangle(edge), is_below, [&](Halfedge_index halfedge) {
        contours_[crossed_edges_.rank(edge_of(halfedge))] = contour;
        if(complex.is_on_border_edge(halfedge))
          is_border_reached_.back() = true;
      });
    });
  }

  Index number_of_contours() const { return static_cast<Index>(first_edges_.size()); }
  Edge_index first_edge(Contour_index contour) const { return first_edges_[contour]; }
  bool is_border_reached(Contour_index contour) const { return is_border_reached_[contour]; }

  Contour_index contour_at_edge(Halfedge_index halfedge) const
  {
    return contours_[crossed_edges_.rank(edge_of(halfedge))];
  }

private:
  typedef Index_set<Edge_index> Edge_set;

  Edge_set crossed_edges_;
  Indexed_vector<Edge_set::Rank_index, Contour_index> contours_;
  Indexed_vector<Contour_index, Edge_index> first_edges_;
  Indexed_vector<Contour_index, bool> is_border_reached_;
};

struct Slab_tag;
typedef Index_of<Slab_tag> Slab_index;

// The part of the surface between two bounding levels, or all of it. It is no copy: it has the numbers of the slabs in
// which all vertices are, and its own critical vertices. Its nodes are these, followed by the contours of its lower
// level and those of its upper level.
template <class Complex>
class Slab
{
public:
  // The slab that is all of the surface.
  Slab(const Complex& complex, const Swept_vertices& critical_vertices)
    : complex_(&complex),
      critical_vertices_(&critical_vertices)
  {}

  // The slab of the given index, between two levels, each of which can be missing.
  Slab(const Complex& complex,
       const Swept_vertices& critical_vertices,
       const Indexed_vector<Vertex_index, Slab_index>& slabs_of_vertices,
       Slab_index index,
       const By_side<const Bounding_level*>& levels)
    : complex_(&complex),
      critical_vertices_(&critical_vertices),
      slabs_of_vertices_(&slabs_of_vertices),
      index_(index),
      levels_(levels)
  {}

  bool is_whole_surface() const { return slabs_of_vertices_ == nullptr; }

  const Complex& complex() const { return *complex_; }
  const Swept_vertices& critical_vertices() const { return *critical_vertices_; }

  // The contours of the lower or of the upper level.
  Index number_of_contours(Side side) const { return levels_[side] ? levels_[side]->number_of_contours() : 0; }
  Index_range<Contour_index> contours(Side side) const { return Index_range<Contour_index>(number_of_contours(side)); }

  Index number_of_nodes() const
  {
    return critical_vertices_->size() + number_of_contours(Side::LOWER) + number_of_contours(Side::UPPER);
  }
  bool is_contour(Tree_node node) const { return node.number() >= critical_vertices_->size(); }
  Tree_node contour_node(Side side, Contour_index contour) const
  {
    return Tree_node(first_contour_node(side) + contour.number());
  }

  // The contour that a node is: its side and its name there.
  Side side_of_contour(Tree_node node) const { return side_of(node.number() >= first_contour_node(Side::UPPER)); }
  Contour_index contour_of_node(Tree_node node) const
  {
    return Contour_index(node.number() - first_contour_node(side_of_contour(node)));
  }

  bool is_border_reached(Side side, Contour_index contour) const { return levels_[side]->is_border_reached(contour); }

  // The contour at which a monotone path leaves the slab with a step to `target` over the edge find_edge(), no_index if
  // it does not.
  template <class FindEdge>
  Contour_index contour_at_step(Side side, Vertex_index target, const FindEdge& find_edge) const
  {
    const Bounding_level* level = levels_[side];
    if(level == nullptr || !is_outside(side, target))
      return no_index;
    return level->contour_at_edge(find_edge());
  }

  // A step from a contour of the upper or the lower level into the slab, or across all of it.
  Ascending_step step_from_contour(Side side, Contour_index contour) const
  {
    const Halfedge_index edge = complex_->halfedge_of_triangle(levels_[side]->first_edge(contour));
    const Vertex_index source = complex_->source(edge), target = complex_->target(edge);
    const bool is_source_lower = (*slabs_of_vertices_)[source] < (*slabs_of_vertices_)[target];
    return {edge, is_source_lower == (side == Side::UPPER) ? source : target};
  }

private:
  Index first_contour_node(Side side) const
  {
    return critical_vertices_->size() + (side == Side::UPPER ? number_of_contours(Side::LOWER) : 0);
  }

  bool is_outside(Side side, Vertex_index vertex) const
  {
    const Slab_index slab = (*slabs_of_vertices_)[vertex];
    return side == Side::UPPER ? slab > index_ : slab < index_;
  }

  const Complex* complex_;
  const Swept_vertices* critical_vertices_;
  const Indexed_vector<Vertex_index, Slab_index>* slabs_of_vertices_ = nullptr;
  Slab_index index_ = Slab_index(0);
  By_side<const Bounding_level*> levels_ = {nullptr, nullptr};
};

// The partition of the surface into slabs with about the same number of critical vertices, as those make the work.
// There is a bounding level just above the last critical vertex of each slab but the highest. (The paper, Section 5.1.)
template <class Complex>
class Slicing
{
public:
  Slicing(const Threads& threads,
          const Complex& complex,
          const Vertex_order& order,
          const Swept_vertices& critical_vertices,
          Index number_of_slabs)
    : complex_(complex),
      critical_vertices_(critical_vertices)
  {
    // The memory that levels may take, in indices: at most a few for each edge, whatever the number of slabs asked for.
    const std::size_t number_of_edges = complex.number_of_edges(),
                      largest_size_of_levels = 8 * number_of_edges + (std::size_t(1) << 20),
                      most_slabs = largest_size_of_levels / (number_of_edges / 16 + 1) + 1;
    number_of_slabs = static_cast<Index>((std::min)(std::size_t(number_of_slabs), most_slabs));
    find_slabs_of_vertices(threads, order, number_of_slabs);
    while(number_of_slabs > 2 && size_of_levels(threads) > largest_size_of_levels)
    {
      number_of_slabs = (number_of_slabs + 1) / 2;
      find_slabs_of_vertices(threads, order, number_of_slabs);
    }
    levels_.assign(number_of_slabs - 1, Bounding_level(complex.number_of_edges()));
    find_crossed_edges(threads);
    threads.for_each_index(levels_.size(), [&](std::size_t i) {
      levels_[i].find_contours(complex, [&](Vertex_index u) { return slabs_of_vertices_[u] <= Slab_index(i); });
    });
    distribute_critical_vertices();
    threads.for_each_index(parts_.size(), [&](std::size_t slab) { fill_part(Slab_index(slab)); });
  }

  Index number_of_slabs() const { return static_cast<Index>(parts_.size()); }

  Slab<Complex> slab(Slab_index index) const
  {
    const std::size_t i = index.number();
    return Slab<Complex>(complex_, parts_[index].critical_vertices, slabs_of_vertices_, index,
                         {i == 0 ? nullptr : &levels_[i - 1], i == levels_.size() ? nullptr : &levels_[i]});
  }

  // The name of a slab's critical vertex among those of the surface.
  Swept_index critical_vertex(Slab_index slab, Swept_index critical) const { return parts_[slab].names[critical]; }

  // The levels, each above the slab of the same number.
  const std::vector<Bounding_level>& levels() const { return levels_; }

private:
  struct Part
  {
    Swept_vertices critical_vertices;
    Indexed_vector<Swept_index, Swept_index> names;
  };

  // The place of a slab's first critical vertex in ascending order.
  std::size_t first_of_slab(std::size_t slab) const { return slab * critical_vertices_.size() / parts_.size(); }

  void find_slabs_of_vertices(const Threads& threads, const Vertex_order& order, Index number_of_slabs)
  {
    parts_.resize(number_of_slabs);
    Plain_vector<Vertex_index> level_vertices;
    for(std::size_t slab = 1; slab != number_of_slabs; ++slab)
      level_vertices.push_back(critical_vertices_.vertex(critical_vertices_.ascending()[first_of_slab(slab) - 1]));
    slabs_of_vertices_.reset(complex_.number_of_vertices(), Slab_index(0));
    threads.for_each_block(slabs_of_vertices_.size(), [&](std::size_t begin, std::size_t end) {
      for(const Vertex_index v : Index_range(Vertex_index(begin), Vertex_index(end)))
      {
        if(!complex_.has_vertex(v))
          continue;
        const auto level = std::partition_point(level_vertices.begin(), level_vertices.end(),
                                                [&](Vertex_index level_vertex) { return order(level_vertex, v); });
        slabs_of_vertices_[v] = Slab_index(static_cast<std::size_t>(level - level_vertices.begin()));
      }
    });
  }

  std::size_t size_of_levels(const Threads& threads) const
  {
    const auto count = [&](std::size_t begin, std::size_t end, std::size_t& crossings) {
      for(const Edge_index edge : Index_range(Edge_index(begin), Edge_index(end)))
      {
        if(complex_.is_on_triangle(edge))
          crossings += range_of_levels(edge).second - range_of_levels(edge).first;
      }
    };
    return threads.sum_of_parts<std::size_t>(complex_.number_of_edges(), count)
         + (parts_.size() - 1) * (complex_.number_of_edges() / 16);
  }

  // The first level that the edge crosses, and the one behind the last.
  std::pair<std::size_t, std::size_t> range_of_levels(Edge_index edge) const
  {
    const Halfedge_index halfedge = even_halfedge(edge);
    return std::minmax<std::size_t>(
      {slabs_of_vertices_[complex_.source(halfedge)].number(), slabs_of_vertices_[complex_.target(halfedge)].number()});
  }

  // Finds the crossed edges in one sweep for all levels, in blocks that do not share a word of the sets.
  void find_crossed_edges(const Threads& threads)
  {
    const std::size_t end_of_edges = complex_.number_of_edges(), word = Index_set<Edge_index>::bits_per_word;
    threads.for_each_block(end_of_edges / word + 1, [&](std::size_t begin, std::size_t end) {
      const Edge_index first(begin * word), last((std::min)(end * word, end_of_edges));
      for(const Edge_index edge : Index_range(first, last))
      {
        if(!complex_.is_on_triangle(edge))
          continue;
        const auto range = range_of_levels(edge);
        for(std::size_t level = range.first; level != range.second; ++level)
          levels_[level].add_crossed_edge(edge);
      }
    });
  }

  void distribute_critical_vertices()
  {
    names_in_slabs_.reset(critical_vertices_.size());
    for(const Swept_index i : critical_vertices_.indices())
    {
      Indexed_vector<Swept_index, Swept_index>& names = parts_[slabs_of_vertices_[critical_vertices_.vertex(i)]].names;
      names_in_slabs_[i] = names.end_key();
      names.push_back(i);
    }
  }

  void fill_part(Slab_index slab)
  {
    const auto ascending = critical_vertices_.ascending().begin();
    Plain_vector<Swept_index> ascending_in_slab;
    ascending_in_slab.reserve(parts_[slab].names.size());
    std::for_each(ascending + first_of_slab(slab.number()), ascending + first_of_slab(slab.number() + 1),
                  [&](Swept_index critical) { ascending_in_slab.push_back(names_in_slabs_[critical]); });
    parts_[slab].critical_vertices = critical_vertices_.part(parts_[slab].names, std::move(ascending_in_slab));
  }

  const Complex& complex_;
  const Swept_vertices& critical_vertices_;
  Indexed_vector<Slab_index, Part> parts_;
  std::vector<Bounding_level> levels_;
  Indexed_vector<Vertex_index, Slab_index> slabs_of_vertices_;
  Indexed_vector<Swept_index, Swept_index> names_in_slabs_; // by critical vertex of the surface
};

// Joins the arcs of the slabs where they end and begin at the same contour of a bounding level. An arc of the surface
// can pass any number of slabs. (The paper, Section 5.3.)
template <class Complex>
Swept_arcs glue_slabs(const Slicing<Complex>& slicing,
                      const Indexed_vector<Slab_index, Swept_arcs>& arcs_of_slabs,
                      Index number_of_critical_vertices)
{
  // The surface has the contours of all levels as nodes, behind its critical vertices.
  Plain_vector<Index> first_contours = {number_of_critical_vertices}; // by level
  for(const Bounding_level& level : slicing.levels())
    first_contours.push_back(checked_index(std::size_t(first_contours.back()) + level.number_of_contours()));
  const auto is_contour = [&](Tree_node node) { return node.number() >= number_of_critical_vertices; };
  Indexed_vector<Tree_node, Tree_node> upper_ends(first_contours.back(), no_index); // of arcs from contours

  Swept_arcs arcs;
  for(const Slab_index i : arcs_of_slabs.keys())
  {
    const Slab<Complex> slab = slicing.slab(i);
    const auto node_of_surface = [&](Tree_node node) {
      if(!slab.is_contour(node))
        return node_of(slicing.critical_vertex(i, critical_vertex_of(node)));
      const std::size_t level = slab.side_of_contour(node) == Side::UPPER ? i.number() : i.number() - 1;
      return Tree_node(first_contours[level] + slab.contour_of_node(node).number());
    };
    for(const Swept_arc& arc : arcs_of_slabs[i])
    {
      const Tree_node lower = node_of_surface(arc.lower), upper = node_of_surface(arc.upper);
      if(is_contour(lower))
        upper_ends[lower] = upper;
      else
        arcs.push_back({lower, upper, arc.first_step});
    }
  }
  for(Swept_arc& arc : arcs)
  {
    while(is_contour(arc.upper))
      arc.upper = upper_ends[arc.upper];
  }
  return arcs;
}

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

#endif // CGAL_REEB_GRAPH_INTERNAL_ENGINE_SLABS_H
