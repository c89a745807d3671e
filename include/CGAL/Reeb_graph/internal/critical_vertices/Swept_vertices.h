// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of the CGAL-style package Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_INTERNAL_CRITICAL_VERTICES_SWEPT_VERTICES_H
#define CGAL_REEB_GRAPH_INTERNAL_CRITICAL_VERTICES_SWEPT_VERTICES_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/internal/base/Index.h>
#include <CGAL/Reeb_graph/internal/base/Large_vector.h>
#include <CGAL/Reeb_graph/internal/base/parallel.h>
#include <CGAL/Reeb_graph/internal/base/prefetch.h>
#include <CGAL/Reeb_graph/internal/critical_vertices/Monotone_neighbors.h>
#include <CGAL/Reeb_graph/internal/critical_vertices/link_sectors.h>

#include <array>
#include <cstddef>
#include <memory>
#include <utility>

namespace CGAL {
namespace Reeb_graph {
namespace internal {

typedef std::array<std::size_t, 2> Sector_counts; // of lower and of upper sectors

// The vertices with link sectors other than one lower and one upper. Stages name a critical vertex by its position
// here, which is that among the vertices of the mesh: what is near on the surface is then near in memory. Its lower and
// its upper link sectors are named by their positions among all lower and all upper ones.
class Swept_vertices
{
public:
  Index size() const { return static_cast<Index>(entries_.size()) - 1; }
  Index vertex(Index critical) const { return entries_[critical].vertex; }
  bool is_on_border(Index critical) const { return entries_[critical].is_on_border; }

  Index number_of_sectors(Index critical, bool is_upper) const
  {
    return entries_[critical + 1].first_sectors[is_upper] - entries_[critical].first_sectors[is_upper];
  }
  Index number_of_lower_sectors(Index critical) const { return number_of_sectors(critical, false); }
  Index number_of_upper_sectors(Index critical) const { return number_of_sectors(critical, true); }

  bool is_critical(Index critical) const
  {
    return number_of_lower_sectors(critical) != 1 || number_of_upper_sectors(critical) != 1;
  }

  // In clockwise order. The turn around a vertex begins with an upper sector or with a lower one, then they alternate.
  Index first_sector(Index critical, bool is_upper) const { return entries_[critical].first_sectors[is_upper]; }
  bool is_first_upper(Index critical) const { return entries_[critical].is_first_upper; }

  Index total_number_of_sectors(bool is_upper) const { return static_cast<Index>(sectors_[is_upper].size()); }
  const Link_sector& sector(bool is_upper, Index position) const { return sectors_[is_upper][position]; }

  // Calls visit(position) for the upper or the lower sectors.
  template <class Visit>
  void for_each_sector(Index critical, bool is_upper, const Visit& visit) const
  {
    const Index end = entries_[critical + 1].first_sectors[is_upper];
    for(Index i = entries_[critical].first_sectors[is_upper]; i != end; ++i)
      visit(i);
  }

  // Of vertices of the surface, critical or not.
  const Kept_neighbors& kept_neighbors() const { return *kept_neighbors_; }
  void set_kept_neighbors(std::shared_ptr<const Kept_neighbors> neighbors) { kept_neighbors_ = std::move(neighbors); }

  void resize(std::size_t number_of_vertices, const Sector_counts& numbers_of_sectors)
  {
    checked_index(numbers_of_sectors[false]);
    checked_index(numbers_of_sectors[true]);
    entries_.resize(number_of_vertices + 1);
    entries_.back() = Entry();
    for(const bool is_upper : {false, true})
    {
      sectors_[is_upper].resize(numbers_of_sectors[is_upper]);
      entries_.back().first_sectors[is_upper] = static_cast<Index>(numbers_of_sectors[is_upper]);
    }
  }

  // Sets the critical vertex number `critical`, which has the given sectors from `first_sectors` on.
  template <class Complex, class Order>
  void set(Index critical,
           const Complex& complex,
           const Order& order,
           Index vertex,
           const Link_summary& link,
           const Sector_counts& first_sectors)
  {
    find_link_sectors(complex, order, vertex, link,
                      {sectors_[false].data() + first_sectors[false], sectors_[true].data() + first_sectors[true]});
    entries_[critical] = {{static_cast<Index>(first_sectors[false]), static_cast<Index>(first_sectors[true])},
                          vertex,
                          link.is_first_upper,
                          complex.is_on_border(vertex)};
  }

  // To be called after the last vertex has been set. Ties are ordered by critical vertex as by vertex.
  template <class ConcurrencyTag, class Order>
  void sort(const Order& order)
  {
    Large_vector<typename Order::Key> keys;
    keys.resize(size());
    for_each_block<ConcurrencyTag>(keys.size(), [&](std::size_t begin, std::size_t end) {
      for(std::size_t i = begin; i != end; ++i)
        keys[i] = {order.key(entries_[i].vertex).value, static_cast<Index>(i)};
    });
    internal::sort<ConcurrencyTag>(keys.begin(), keys.end(), order);
    ascending_.resize(keys.size());
    for_each_block<ConcurrencyTag>(keys.size(), [&](std::size_t begin, std::size_t end) {
      for(std::size_t i = begin; i != end; ++i)
        ascending_[i] = keys[i].vertex;
    });
  }

  // All critical vertices, from the lowest to the highest.
  const Large_vector<Index>& ascending() const { return ascending_; }

  // The given ones alone. Their order has to be that of the names in the part.
  Swept_vertices part(const Large_vector<Index>& critical_vertices, Large_vector<Index> ascending) const
  {
    Swept_vertices result;
    result.entries_.reserve(critical_vertices.size() + 1);
    const auto add_entry = [&](Index critical) {
      result.entries_.push_back(entries_[critical]);
      for(const bool is_upper : {false, true})
        result.entries_.back().first_sectors[is_upper] = result.total_number_of_sectors(is_upper);
    };
    for(const Index critical : critical_vertices)
    {
      add_entry(critical);
      for(const bool is_upper : {false, true})
        for_each_sector(critical, is_upper,
                        [&](Index i) { result.sectors_[is_upper].push_back(sectors_[is_upper][i]); });
    }
    add_entry(size());
    result.ascending_ = std::move(ascending);
    result.kept_neighbors_ = kept_neighbors_;
    return result;
  }

  void prefetch(Index critical) const { internal::prefetch(&entries_[critical]); }

private:
  struct Entry
  {
    std::array<Index, 2> first_sectors;
    Index vertex;
    bool is_first_upper;
    bool is_on_border;
  };

  Large_vector<Entry> entries_; // and one behind the last, that tells where its sectors end
  std::array<Large_vector<Link_sector>, 2> sectors_;
  Large_vector<Index> ascending_;
  std::shared_ptr<const Kept_neighbors> kept_neighbors_; // shared with the parts
};

} // namespace internal
} // namespace Reeb_graph
} // namespace CGAL

#endif // CGAL_REEB_GRAPH_INTERNAL_CRITICAL_VERTICES_SWEPT_VERTICES_H
