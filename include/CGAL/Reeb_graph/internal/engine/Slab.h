// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_INTERNAL_ENGINE_SLAB_H
#define CGAL_REEB_GRAPH_INTERNAL_ENGINE_SLAB_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/internal/base/Index.h>
#include <CGAL/Reeb_graph/internal/base/arrays.h>
#include <CGAL/Reeb_graph/internal/base/parallel.h>
#include <CGAL/Reeb_graph/internal/base/tuning.h>
#include <CGAL/Reeb_graph/internal/engine/contour_tracing.h>
#include <CGAL/Reeb_graph/internal/engine/monotone_paths.h>
#include <CGAL/Reeb_graph/visitor.h>

#include <cstddef>
#include <memory>
#include <utility>

namespace CGAL::Reeb_graph::internal {

struct Swept_tag;
struct Sector_tag;
typedef Index_of<Swept_tag> Swept_index;
typedef Index_of<Sector_tag> Sector_index; // among those of one side

typedef By_side<std::size_t> Sector_counts;

// The vertices that a sweep visits: the critical ones, with link sectors other than one lower and one upper. Stages
// name such a vertex by its position here, where they have the order that they have in the mesh: what is near on the
// surface is then near in memory. Its lower and its upper link sectors are named by their positions among all lower and
// all upper ones.
class Swept_vertices
{
public:
  Number size() const { return static_cast<Number>(entries_.size()) - 1; }
  Index_range<Swept_index> indices() const { return Index_range<Swept_index>(size()); }
  Vertex_index vertex(Swept_index critical) const { return entries_[critical].vertex; }
  bool is_on_border(Swept_index critical) const { return entries_[critical].is_on_border; }

  Number number_of_sectors(Swept_index critical, Side side) const
  {
    return end_of_sectors(critical, side).number() - first_sector(critical, side).number();
  }
  Number number_of_lower_sectors(Swept_index critical) const { return number_of_sectors(critical, Side::LOWER); }
  Number number_of_upper_sectors(Swept_index critical) const { return number_of_sectors(critical, Side::UPPER); }

  // Sectors are in clockwise order. The turn around a vertex begins with an upper sector or with a lower one, then they
  // alternate.
  Sector_index first_sector(Swept_index critical, Side side) const { return entries_[critical].first_sectors[side]; }
  Sector_index end_of_sectors(Swept_index critical, Side side) const
  {
    return entries_[Swept_index(critical.number() + 1)].first_sectors[side];
  }
  bool is_first_upper(Swept_index critical) const { return entries_[critical].is_first_upper; }

  // The lower or the upper sectors of a vertex.
  Index_range<Sector_index> sectors(Swept_index critical, Side side) const
  {
    return {first_sector(critical, side), end_of_sectors(critical, side)};
  }

  Number total_number_of_sectors(Side side) const { return static_cast<Number>(sectors_[side].size()); }
  const Link_sector& sector(Side side, Sector_index sector) const { return sectors_[side][sector]; }

  // Neighbors of vertices of the surface, critical or not.
  const Kept_neighbors& kept_neighbors() const { return *kept_neighbors_; }
  void set_kept_neighbors(std::shared_ptr<const Kept_neighbors> neighbors) { kept_neighbors_ = std::move(neighbors); }

  void resize(std::size_t number_of_vertices, const Sector_counts& numbers_of_sectors)
  {
    entries_.renew(number_of_vertices + 1);
    entries_.back() = Entry();
    for(const Side side : both_sides)
    {
      sectors_[side].renew(checked_index(numbers_of_sectors[side]));
      entries_.back().first_sectors[side] = sectors_[side].end_key();
    }
  }

  // Sets one vertex. Returns the places from `first_sectors` on, to which its lower and its upper sectors have to be
  // written.
  By_side<Link_sector*> set(Swept_index critical,
                            Vertex_index vertex,
                            bool is_first_upper,
                            bool is_on_border,
                            const Sector_counts& first_sectors)
  {
    entries_[critical] = {{Sector_index(first_sectors[Side::LOWER]), Sector_index(first_sectors[Side::UPPER])},
                          vertex,
                          is_first_upper,
                          is_on_border};
    return {sectors_[Side::LOWER].data() + first_sectors[Side::LOWER],
            sectors_[Side::UPPER].data() + first_sectors[Side::UPPER]};
  }

  // Sorts the vertices when all have been set. Ties are ordered by critical vertex as by vertex.
  template <class ConcurrencyTag, class Order>
  void sort(const Order& order)
  {
    Vector_of<typename Order::template Key<Swept_index>> keys(size());
    for_each_block<ConcurrencyTag>(keys.size(), [&](std::size_t begin, std::size_t end) {
      for(std::size_t i = begin; i != end; ++i)
        keys[i] = order.key(vertex(Swept_index(i)), Swept_index(i));
    });
    internal::sort<ConcurrencyTag>(keys.begin(), keys.end(), order);
    ascending_ = Plain_vector<Swept_index>(keys.size());
    for_each_block<ConcurrencyTag>(keys.size(), [&](std::size_t begin, std::size_t end) {
      for(std::size_t i = begin; i != end; ++i)
        ascending_[i] = keys[i].name;
    });
  }

  // All critical vertices, from the lowest to the highest.
  const Plain_vector<Swept_index>& ascending() const { return ascending_; }

  // The given vertices alone. Their order has to be that of the names in the part.
  template <class SweptIndices>
  Swept_vertices part(const SweptIndices& critical_vertices, Plain_vector<Swept_index> ascending) const
  {
    Swept_vertices result;
    result.entries_.reserve(critical_vertices.size() + 1);
    const auto add_entry = [&](Swept_index critical) {
      result.entries_.push_back(entries_[critical]);
      for(const Side side : both_sides)
        result.entries_.back().first_sectors[side] = result.sectors_[side].end_key();
    };
    for(const Swept_index critical : critical_vertices)
    {
      add_entry(critical);
      for(const Side side : both_sides)
        for(const Sector_index sector : sectors(critical, side))
          result.sectors_[side].push_back(sectors_[side][sector]);
    }
    add_entry(entries_.last_key());
    result.ascending_ = std::move(ascending);
    result.kept_neighbors_ = kept_neighbors_;
    return result;
  }

  // Fetch memory ahead, the second one less far.
  void prefetch(Swept_index critical) const { internal::prefetch(&entries_[critical]); }
  void prefetch_sectors(Swept_index critical, Side side) const
  {
    prefetch_element(sectors_[side], first_sector(critical, side));
  }

private:
  struct Entry
  {
    By_side<Sector_index> first_sectors;
    Vertex_index vertex;
    bool is_first_upper;
    bool is_on_border;
  };

  Indexed_vector<Swept_index, Entry> entries_; // and one behind the last, that tells where its sectors end
  By_side<Indexed_vector<Sector_index, Link_sector>> sectors_;
  Plain_vector<Swept_index> ascending_;
  std::shared_ptr<const Kept_neighbors> kept_neighbors_; // shared with the parts
};

inline Critical_vertex_counts count_critical_vertices(const Swept_vertices& critical_vertices)
{
  Critical_vertex_counts counts;
  for(const Swept_index i : critical_vertices.indices())
  {
    const Number number_of_lower_sectors = critical_vertices.number_of_lower_sectors(i);
    const Number number_of_upper_sectors = critical_vertices.number_of_upper_sectors(i);
    if(number_of_lower_sectors == 0 && number_of_upper_sectors == 0)
      ++counts.isolated;
    else if(number_of_lower_sectors == 0)
      ++counts.minima;
    else if(number_of_upper_sectors == 0)
      ++counts.maxima;
    else if(critical_vertices.is_on_border(i))
      ++counts.border_saddles;
    else
      ++counts.saddles[number_of_lower_sectors - 1];
  }
  return counts;
}

// The Euler characteristic of the surface, to which a vertex contributes 1 minus the Euler characteristic of its lower
// link. (T. Banchoff, Critical points and curvature for embedded polyhedra, 1967.)
inline std::ptrdiff_t euler_characteristic(const Swept_vertices& critical_vertices)
{
  std::ptrdiff_t result = 0;
  for(const Swept_index i : critical_vertices.indices())
  {
    const bool is_lower_link_closed =
      critical_vertices.number_of_upper_sectors(i) == 0 && !critical_vertices.is_on_border(i);
    result +=
      1 - (is_lower_link_closed ? 0 : static_cast<std::ptrdiff_t>(critical_vertices.number_of_lower_sectors(i)));
  }
  return result;
}

// The nodes of a slab: its critical vertices, then others.
struct Slab_node_tag;
typedef Index_of<Slab_node_tag> Slab_node;

constexpr Slab_node node_of(Swept_index critical) { return Slab_node(critical.number()); }
constexpr Swept_index critical_vertex_of(Slab_node node) { return Swept_index(node.number()); }

// What an engine returns: an arc from one node to the next one above. Its chain begins with the step from the lower
// vertex to its highest neighbor inside the arc.
struct Slab_arc
{
  Slab_node lower;
  Slab_node upper;
  Ascending_step first_step;

  // The ends of an arc between critical vertices.
  Swept_index lower_vertex() const { return critical_vertex_of(lower); }
  Swept_index upper_vertex() const { return critical_vertex_of(upper); }
};

struct Slab_arc_tag;
typedef Index_of<Slab_arc_tag> Slab_arc_index;
typedef Indexed_vector<Slab_arc_index, Slab_arc> Slab_arcs;

struct Contour_tag;
typedef Index_of<Contour_tag> Contour_index;

// A level between two slabs, and its contours, numbered in the order of their first edges. It
// holds the map from crossed edges to contours by which slabs are glued. (The paper, Section 5.3.)
class Bounding_level
{
public:
  explicit Bounding_level(Number number_of_edges) : crossed_edges_(number_of_edges) {}

  void add_crossed_edge(Edge_index edge) { crossed_edges_.add(edge); }

  // Finds the contours when all crossed edges have been added.
  template <class Complex, class IsBelow>
  void find_contours(const Complex& complex, const IsBelow& is_below)
  {
    crossed_edges_.count_ranks();
    contours_.renew(crossed_edges_.size(), no_index);
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

  Number number_of_contours() const { return static_cast<Number>(first_edges_.size()); }
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

  // Throws the error of an order of the vertices that contradicts itself, which has shown at an end of the arc, as far
  // as it has any.
  [[noreturn]] void throw_contradiction_near(const Slab_arc& arc) const
  {
    const Slab_node node = !is_contour(arc.lower) ? arc.lower : (!is_contour(arc.upper) ? arc.upper : Slab_node(0));
    complex_->throw_contradiction_near(critical_vertices_->vertex(critical_vertex_of(node)));
  }

  // The contours of the lower or of the upper level.
  Number number_of_contours(Side side) const { return levels_[side] ? levels_[side]->number_of_contours() : 0; }
  Index_range<Contour_index> contours(Side side) const { return Index_range<Contour_index>(number_of_contours(side)); }

  Number number_of_nodes() const
  {
    return critical_vertices_->size() + number_of_contours(Side::LOWER) + number_of_contours(Side::UPPER);
  }
  bool is_contour(Slab_node node) const { return node.number() >= critical_vertices_->size(); }
  Slab_node contour_node(Side side, Contour_index contour) const
  {
    return Slab_node(first_contour_node(side) + contour.number());
  }

  // The contour that a node is: its side and its name there.
  Side side_of_contour(Slab_node node) const { return side_of(node.number() >= first_contour_node(Side::UPPER)); }
  Contour_index contour_of_node(Slab_node node) const
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
  Number first_contour_node(Side side) const
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

} // namespace CGAL::Reeb_graph::internal

#endif // CGAL_REEB_GRAPH_INTERNAL_ENGINE_SLAB_H
