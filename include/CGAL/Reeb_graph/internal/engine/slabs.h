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
    const Index first = critical_vertices_->size() + (side == Side::UPPER ? number_of_contours(Side::LOWER) : 0);
    return Tree_node(first + contour.number());
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
    threads.for_each<Vertex_index>(slabs_of_vertices_.size(), [&](Vertex_index v) {
      if(!complex_.has_vertex(v))
        return;
      const auto level = std::partition_point(level_vertices.begin(), level_vertices.end(),
                                              [&](Vertex_index level_vertex) { return order(level_vertex, v); });
      slabs_of_vertices_[v] = Slab_index(static_cast<std::size_t>(level - level_vertices.begin()));
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
  // The surface has the contours of all levels as nodes, behind its critical vertices; those of a slab are some of them
  // in a row.
  Plain_vector<Index> first_contours = {number_of_critical_vertices}; // by level
  for(const Bounding_level& level : slicing.levels())
    first_contours.push_back(checked_index(std::size_t(first_contours.back()) + level.number_of_contours()));
  const auto is_contour = [&](Tree_node node) { return node.number() >= number_of_critical_vertices; };
  Indexed_vector<Tree_node, Tree_node> upper_ends(first_contours.back(), no_index); // of arcs from contours

  Swept_arcs arcs;
  for(const Slab_index i : arcs_of_slabs.keys())
  {
    const Slab<Complex> slab = slicing.slab(i);
    const Index first_contour = first_contours[i == Slab_index(0) ? 0 : i.number() - 1];
    const auto node_of_surface = [&](Tree_node node) {
      if(!slab.is_contour(node))
        return node_of(slicing.critical_vertex(i, critical_vertex_of(node)));
      return Tree_node(first_contour + (node.number() - slab.critical_vertices().size()));
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

} // namespace CGAL::Reeb_graph::internal

#endif // CGAL_REEB_GRAPH_INTERNAL_ENGINE_SLABS_H
