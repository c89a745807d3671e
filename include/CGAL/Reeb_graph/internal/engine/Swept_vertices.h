// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_INTERNAL_ENGINE_SWEPT_VERTICES_H
#define CGAL_REEB_GRAPH_INTERNAL_ENGINE_SWEPT_VERTICES_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/internal/base/Index.h>
#include <CGAL/Reeb_graph/internal/base/arrays.h>
#include <CGAL/Reeb_graph/internal/base/parallel.h>
#include <CGAL/Reeb_graph/internal/base/tuning.h>
#include <CGAL/Reeb_graph/internal/engine/monotone_paths.h>
#include <CGAL/Reeb_graph/internal/engine/vertex_links.h>

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

} // namespace CGAL::Reeb_graph::internal

#endif // CGAL_REEB_GRAPH_INTERNAL_ENGINE_SWEPT_VERTICES_H
