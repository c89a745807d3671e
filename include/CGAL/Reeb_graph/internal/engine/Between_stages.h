// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_INTERNAL_ENGINE_BETWEEN_STAGES_H
#define CGAL_REEB_GRAPH_INTERNAL_ENGINE_BETWEEN_STAGES_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/internal/base/Threads.h>
#include <CGAL/Reeb_graph/internal/base/Tuned_part.h>
#include <CGAL/Reeb_graph/internal/base/arrays.h>
#include <CGAL/Reeb_graph/internal/base/compiled.h>
#include <CGAL/Reeb_graph/internal/base/prefetch.h>
#include <CGAL/Reeb_graph/internal/complex/Vertex_order.h>
#include <CGAL/Reeb_graph/options.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <memory>
#include <unordered_map>
#include <utility>

// The engine in the order of the data. What goes from one stage to the next is here, with what all of them include.
//
// | stage                                   | from a complex, an order, and                 | to                     |
// | classify_vertices.h                     | nothing else                                  | Swept_vertices         |
// | Merge_tree_sweep.h, by paths of walks.h | Swept_vertices of a slab                      | Merge_tree, up or down |
// | cut_loops.h, by the contours of walks.h | the one up, and the one down so far           | Contour_cuts           |
// | Tree_combination.h                      | both trees and the cuts                       | Swept_arcs of the slab |
// | find_arcs.h, by the Slicing of slabs.h  | Swept_arcs of all slabs, or of critical sets  | Swept_arcs             |
// | write_graph.h                           | Swept_vertices, Swept_arcs, as a Flat_graph   | the graph of the user  |
//
// Locate_on_arcs.h asks the trees for other vertices; stages_of_complexes.h and
// loops_of_complexes.h have what differs where there is no surface.

namespace CGAL::Reeb_graph::internal {

// A lower neighbor of a vertex and a higher one, no_index if there is none.
typedef By_side<Vertex_index> Monotone_neighbors;

// A connected component of the upper or of the lower link of a vertex, given by its extreme neighbor: the highest
// one of an upper sector, the lowest one of a lower sector.
struct Link_sector
{
  Vertex_index extreme_neighbor;
  Halfedge_index edge; // a halfedge of a triangle on the edge to that neighbor
};

// Upper and lower link sectors alternate, so it is enough to know how many there are and with which a turn begins.
struct Link_summary
{
  Index number_of_sectors;
  bool is_first_upper;

  Index number_of_upper_sectors() const { return (number_of_sectors + is_first_upper) / 2; }
  Index number_of_lower_sectors() const { return number_of_sectors - number_of_upper_sectors(); }
  Side first_side() const { return side_of(is_first_upper); }
};

// The monotone neighbors of the vertices in blocks of which many are critical. There, nearly each vertex is on a
// monotone path; elsewhere, to find the few steps of paths again takes less than to keep all of them.
class Kept_neighbors
{
public:
  static constexpr std::size_t block_size = 512;
  typedef std::array<Monotone_neighbors, block_size> Block;

  explicit Kept_neighbors(std::size_t number_of_vertices) : neighbors_(number_of_vertices, {no_index, no_index}) {}

  static bool are_worth_keeping(std::size_t number_of_critical_vertices, std::size_t number_of_vertices)
  {
    return is_used(Tuned_part::KEPT_NEIGHBORS) && number_of_critical_vertices > number_of_vertices / 8;
  }

  void keep(const Block& block, std::size_t begin, std::size_t end)
  {
    std::copy_n(block.begin(), end - begin, &neighbors_[Vertex_index(begin)]);
  }

  // Whether neighbors have been kept: in unset places, both are the same.
  bool has_neighbors(Vertex_index vertex) const
  {
    return neighbors_[vertex][Side::LOWER] != neighbors_[vertex][Side::UPPER];
  }
  Vertex_index neighbor(Vertex_index vertex, Side side) const { return neighbors_[vertex][side]; }

  void prefetch(Vertex_index vertex) const { internal::prefetch(&neighbors_[vertex]); }

private:
  Indexed_vector<Vertex_index, Monotone_neighbors> neighbors_;
};

// A step of an ascending path: the edge of which `edge` is a halfedge that has a triangle, up to its higher end
// `target`.
struct Ascending_step
{
  Halfedge_index edge;
  Vertex_index target;
};

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
  Index size() const { return static_cast<Index>(entries_.size()) - 1; }
  Index_range<Swept_index> indices() const { return Index_range<Swept_index>(size()); }
  Vertex_index vertex(Swept_index critical) const { return entries_[critical].vertex; }
  bool is_on_border(Swept_index critical) const { return entries_[critical].is_on_border; }

  Index number_of_sectors(Swept_index critical, Side side) const
  {
    return end_of_sectors(critical, side).number() - first_sector(critical, side).number();
  }
  Index number_of_lower_sectors(Swept_index critical) const { return number_of_sectors(critical, Side::LOWER); }
  Index number_of_upper_sectors(Swept_index critical) const { return number_of_sectors(critical, Side::UPPER); }

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

  Index total_number_of_sectors(Side side) const { return static_cast<Index>(sectors_[side].size()); }
  const Link_sector& sector(Side side, Sector_index sector) const { return sectors_[side][sector]; }

  // Neighbors of vertices of the surface, critical or not.
  const Kept_neighbors& kept_neighbors() const { return *kept_neighbors_; }
  void set_kept_neighbors(std::shared_ptr<const Kept_neighbors> neighbors) { kept_neighbors_ = std::move(neighbors); }

  void resize(std::size_t number_of_vertices, const Sector_counts& numbers_of_sectors)
  {
    entries_.reset(number_of_vertices + 1);
    entries_.back() = Entry();
    for(const Side side : both_sides)
    {
      sectors_[side].reset(checked_index(numbers_of_sectors[side]));
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
  void sort(const Threads& threads, const Vertex_order& order)
  {
    Vector_of<Vertex_order::Key<Swept_index>> keys(size());
    threads.for_each<Swept_index>(size(), [&](Swept_index i) { keys[i.number()] = order.key(vertex(i), i); });
    internal::sort(threads, keys.begin(), keys.end(), order);
    ascending_ = Plain_vector<Swept_index>(keys.size());
    threads.for_each<std::size_t>(keys.size(), [&](std::size_t i) { ascending_[i] = keys[i].name; });
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

// The nodes of a slab: its critical vertices, then others.
struct Tree_node_tag;
typedef Index_of<Tree_node_tag> Tree_node;

constexpr Tree_node node_of(Swept_index critical) { return Tree_node(critical.number()); }
constexpr Swept_index critical_vertex_of(Tree_node node) { return Swept_index(node.number()); }

// An arc that an engine returns, from one node to the next one above. Its chain begins with the step from the lower
// vertex to its highest neighbor inside the arc.
struct Swept_arc
{
  Tree_node lower;
  Tree_node upper;
  Ascending_step first_step;

  // The ends of an arc between critical vertices.
  Swept_index lower_vertex() const { return critical_vertex_of(lower); }
  Swept_index upper_vertex() const { return critical_vertex_of(upper); }
};

struct Swept_arc_tag;
typedef Index_of<Swept_arc_tag> Swept_arc_index;
typedef Indexed_vector<Swept_arc_index, Swept_arc> Swept_arcs;

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

struct Cut_tag;
typedef Index_of<Cut_tag> Cut_index;

// Contours along which the surface is cut so that no loop is left, each just below a critical vertex that it touches. A
// cut adds two nodes to the trees: one below it, a maximum joined to the lower ends of the crossed edges, and one above
// it, a minimum joined to the upper ends.
class Contour_cuts
{
public:
  Contour_cuts(Index number_of_other_nodes, Index number_of_edges)
    : number_of_other_nodes_(number_of_other_nodes),
      number_of_edges_(number_of_edges)
  {}

  // Adds a contour just below the critical vertex `critical`, the top of whose sublevel component is
  // `sublevel_class`. Critical vertices have to come in descending order: an edge keeps its lowest contour.
  void add(Swept_index critical, Tree_node sublevel_class, const Plain_vector<Halfedge_index>& crossed_edges)
  {
    critical_vertices_.push_back(critical);
    sublevel_classes_.push_back(sublevel_class);
    unregistered_edges_.append(crossed_edges.begin(), crossed_edges.end());
    ends_of_unregistered_.push_back(unregistered_edges_.size());
    if(unregistered_edges_.size() > number_of_edges_) // So that they never take more memory than the registered ones.
      register_edges();
  }

  // Lets lowest_at_edge() know the contours that have been added since the last call. Done on demand, as it takes
  // longer than all else here, and is seldom needed.
  void register_edges()
  {
    is_edge_cut_.resize(number_of_edges_, false);
    if(unregistered_edges_.size() + few_lowest_cuts_.size() > number_of_edges_ / 32)
      switch_to_array();
    std::size_t i = 0;
    Cut_index cut(size() - ends_of_unregistered_.size());
    for(const std::size_t end : ends_of_unregistered_)
    {
      for(; i != end; ++i)
        register_edge(edge_of(unregistered_edges_[i]), cut);
      ++cut;
    }
    unregistered_edges_.clear();
    ends_of_unregistered_.clear();
  }

  Index size() const { return static_cast<Index>(critical_vertices_.size()); }
  Index_range<Cut_index> cuts() const { return critical_vertices_.keys(); }
  Cut_index next_cut() const { return critical_vertices_.end_key(); }

  Index number_of_nodes() const { return number_of_other_nodes_ + 2 * size(); }
  Tree_node node_below(Cut_index cut) const { return Tree_node(number_of_other_nodes_ + 2 * cut.number()); }
  Tree_node node_above(Cut_index cut) const { return Tree_node(number_of_other_nodes_ + 2 * cut.number() + 1); }

  bool is_cut_node(Tree_node node) const { return node.number() >= number_of_other_nodes_; }
  Cut_index cut_of_node(Tree_node node) const { return Cut_index((node.number() - number_of_other_nodes_) / 2); }

  Swept_index critical_vertex(Cut_index cut) const { return critical_vertices_[cut]; }
  Tree_node sublevel_class(Cut_index cut) const { return sublevel_classes_[cut]; }

  bool has_registered_edges() const { return !is_edge_cut_.empty(); }

  // The lowest registered contour that crosses the edge of the halfedge, no_index if there is none.
  Cut_index lowest_at_edge(Halfedge_index halfedge) const
  {
    const Edge_index edge = edge_of(halfedge);
    if(!has_registered_edges() || !is_edge_cut_[edge])
      return no_index;
    return lowest_cuts_.empty() ? few_lowest_cuts_.find(edge.number())->second : lowest_cuts_[edge];
  }

private:
  void register_edge(Edge_index edge, Cut_index cut)
  {
    is_edge_cut_[edge] = true;
    (lowest_cuts_.empty() ? few_lowest_cuts_[edge.number()] : lowest_cuts_[edge]) = cut;
  }

  void switch_to_array()
  {
    lowest_cuts_.resize(number_of_edges_);
    for(const auto& [edge, cut] : few_lowest_cuts_)
      lowest_cuts_[Edge_index(edge)] = cut;
    few_lowest_cuts_.clear();
  }

  Index number_of_other_nodes_;
  Index number_of_edges_;
  Indexed_vector<Cut_index, Swept_index> critical_vertices_;
  Indexed_vector<Cut_index, Tree_node> sublevel_classes_;
  Plain_vector<Halfedge_index> unregistered_edges_;
  Plain_vector<std::size_t> ends_of_unregistered_; // by one of the last cuts: where its unregistered edges end
  // The lowest cuts at edges. With few cut edges, to touch the pages of an array would take longer than all else that
  // has to do with cuts; with many, a hash map would.
  std::unordered_map<Index, Cut_index> few_lowest_cuts_;
  Indexed_vector<Edge_index, Cut_index> lowest_cuts_; // unset where no cut is
  Indexed_vector<Edge_index, bool> is_edge_cut_;      // asked first; empty as long as nothing is registered
};

struct Chain_segment_tag;
typedef Index_of<Chain_segment_tag> Chain_segment_index;

struct Flat_node
{
  Vertex_index vertex;
  Node_kind kind;
};

// A segment of a chain: steepest steps from the first one on, up to the level just below a vertex. An arc has one, and
// one more for each plateau of several critical vertices that it passes.
struct Chain_segment
{
  Ascending_step first_step;
  Vertex_index upper_vertex;
};

struct Flat_arc
{
  Node_index lower;
  Node_index upper;
  Chain_segment_index first_segment;
  Index number_of_segments;
};

// The Reeb graph by indices: nodes in ascending order, arcs sorted.
struct Flat_graph
{
  Indexed_vector<Node_index, Flat_node> nodes;
  Indexed_vector<Arc_index, Flat_arc> arcs;
  Indexed_vector<Chain_segment_index, Chain_segment> segments;

  // By critical vertex: the node that it is part of, or else, on request, the arc that passes it.
  Indexed_vector<Swept_index, Node_index> node_of_critical;
  Indexed_vector<Swept_index, Arc_index> arc_of_critical;

  // By arc between critical vertices, on request: the arc that it is part of, no_index if it has been contracted.
  Indexed_vector<Swept_arc_index, Arc_index> arc_of_critical_arc;
};

} // namespace CGAL::Reeb_graph::internal

#endif // CGAL_REEB_GRAPH_INTERNAL_ENGINE_BETWEEN_STAGES_H
