// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of the CGAL-style package Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_INTERNAL_CLASSIFY_VERTICES_H
#define CGAL_REEB_GRAPH_INTERNAL_CLASSIFY_VERTICES_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/internal/Large_vector.h>
#include <CGAL/Reeb_graph/internal/Triangle_complex.h>
#include <CGAL/Reeb_graph/internal/link_sectors.h>
#include <CGAL/Reeb_graph/internal/parallel.h>
#include <CGAL/Reeb_graph/internal/prefetch.h>
#include <CGAL/Reeb_graph/visitor.h>

#include <CGAL/Iterator_range.h>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Reeb_graph {
namespace internal {

// The vertices with link sectors other than one lower and one upper. Stages name a critical vertex by its position
// here, which is that among the vertices of the mesh: what is near on the surface is then near in memory.
class Critical_vertices
{
public:
  typedef Iterator_range<const Link_sector*> Sectors;

  Index size() const { return static_cast<Index>(entries_.size()); }
  Index vertex(Index critical) const { return entries_[critical].vertex; }
  Index number_of_lower_sectors(Index critical) const { return number_of_sectors(critical, false); }
  Index number_of_upper_sectors(Index critical) const { return number_of_sectors(critical, true); }

  bool is_on_border(Index critical) const { return entries_[critical].is_on_border; }

  Index number_of_sectors(Index critical, bool is_upper) const
  {
    const Entry& entry = entries_[critical];
    return (entry.number_of_sectors + (entry.is_first_upper == is_upper ? 1 : 0)) / 2;
  }

  bool is_critical(Index critical) const
  {
    return number_of_lower_sectors(critical) != 1 || number_of_upper_sectors(critical) != 1;
  }

  // The link sectors in clockwise order; first_sector() is the position of the first one among all.
  Sectors sectors(Index critical) const
  {
    const Link_sector* first = sectors_.data() + first_sector(critical);
    return Sectors(first, first + entries_[critical].number_of_sectors);
  }
  Index first_sector(Index critical) const { return entries_[critical].first_sector; }
  Index total_number_of_sectors() const { return static_cast<Index>(sectors_.size()); }
  const Link_sector& sector(Index position) const { return sectors_[position]; }

  // The positions among all of the upper or of the lower sectors: every second one.
  template <class Visit>
  void for_each_sector(Index critical, bool is_upper, const Visit& visit) const
  {
    const Index end = entries_[critical].first_sector + entries_[critical].number_of_sectors;
    for(Index i = first_sector_of(critical, is_upper); i < end; i += 2)
      visit(i);
  }

  Index first_sector_of(Index critical, bool is_upper) const
  {
    const Entry& entry = entries_[critical];
    return entry.first_sector + (entry.is_first_upper == is_upper ? 0 : 1);
  }

  void resize(std::size_t number_of_vertices, std::size_t number_of_sectors)
  {
    checked_index(number_of_sectors);
    entries_.resize(number_of_vertices);
    sectors_.resize(number_of_sectors);
  }

  // Sets the critical vertex number `critical`, which has `number_of_sectors` from `first_sector` on.
  template <class Order>
  void set(Index critical,
           const Triangle_complex& complex,
           const Order& order,
           Index vertex,
           Index first_sector,
           Index number_of_sectors)
  {
    const bool is_first_upper =
      find_link_sectors(complex, order, vertex, number_of_sectors, sectors_.data() + first_sector);
    entries_[critical] = {first_sector, vertex, number_of_sectors, is_first_upper, complex.is_on_border(vertex)};
  }

  // To be called after the last vertex has been set. Ties are ordered by critical vertex as by vertex.
  template <class ConcurrencyTag, class Order>
  void sort(const Order& order)
  {
    Large_vector<typename Order::Key> keys;
    keys.resize(entries_.size());
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
  Critical_vertices part(const Large_vector<Index>& critical_vertices, Large_vector<Index> ascending) const
  {
    Critical_vertices result;
    result.entries_.reserve(critical_vertices.size());
    for(const Index critical : critical_vertices)
    {
      result.entries_.push_back(entries_[critical]);
      result.entries_.back().first_sector = result.total_number_of_sectors();
      const Sectors sectors = this->sectors(critical);
      result.sectors_.insert(result.sectors_.end(), sectors.begin(), sectors.end());
    }
    result.ascending_ = std::move(ascending);
    return result;
  }

  void prefetch(Index critical) const { internal::prefetch(&entries_[critical]); }

private:
  struct Entry
  {
    Index first_sector;
    Index vertex;
    Index number_of_sectors;
    bool is_first_upper;
    bool is_on_border;
  };

  Large_vector<Entry> entries_;
  Large_vector<Link_sector> sectors_;
  Large_vector<Index> ascending_;
};

// Some of a part of the vertices.
struct Found_vertices
{
  struct Vertex
  {
    Index vertex;
    Index number_of_sectors;
  };

  Large_vector<Vertex> vertices;
  std::size_t number_of_sectors = 0;
};

template <class Order, class IsWanted>
Found_vertices find_vertices(const Triangle_complex& complex,
                             const Order& order,
                             std::size_t begin,
                             std::size_t end,
                             const IsWanted& is_wanted)
{
  Found_vertices found;
  found.vertices.resize(end - begin);
  std::size_t number_of_found = 0;
  for(std::size_t v = begin; v != end; ++v)
  {
    const Index number_of_sectors = count_link_sectors(complex, order, static_cast<Index>(v));
    const bool is_found = is_wanted(number_of_sectors);
    found.vertices[number_of_found] = {static_cast<Index>(v), number_of_sectors};
    number_of_found += is_found;
    found.number_of_sectors += is_found ? number_of_sectors : 0;
  }
  found.vertices.resize(number_of_found);
  return found;
}

// The vertices with wanted numbers of link sectors. They are found in parts, and then each part is put in its place.
template <class ConcurrencyTag, class Order, class IsWanted>
Critical_vertices collect_vertices(const Triangle_complex& complex, const Order& order, const IsWanted& is_wanted)
{
  const std::size_t size = complex.number_of_vertices();
  std::vector<Found_vertices> parts(number_of_parts<ConcurrencyTag>(size));
  for_each_part<ConcurrencyTag>(parts.size(), size, [&](std::size_t part, std::size_t begin, std::size_t end) {
    parts[part] = find_vertices(complex, order, begin, end, is_wanted);
  });
  std::vector<std::size_t> first_vertices(1, 0), first_sectors(1, 0);
  for(const Found_vertices& part : parts)
  {
    first_vertices.push_back(first_vertices.back() + part.vertices.size());
    first_sectors.push_back(first_sectors.back() + part.number_of_sectors);
  }
  Critical_vertices result;
  result.resize(first_vertices.back(), first_sectors.back());
  for_each_index<ConcurrencyTag>(parts.size(), [&](std::size_t part) {
    Index i = static_cast<Index>(first_vertices[part]), sector = static_cast<Index>(first_sectors[part]);
    for(const Found_vertices::Vertex& found : parts[part].vertices)
    {
      result.set(i++, complex, order, found.vertex, sector, found.number_of_sectors);
      sector += found.number_of_sectors;
    }
  });
  result.sort<ConcurrencyTag>(order);
  return result;
}

// Finds the critical vertices: all but those with one lower and one upper sector. (The paper, Section 3.1; a border
// vertex has a path as link, so its sectors are counted.)
template <class ConcurrencyTag, class Order>
Critical_vertices classify_vertices(const Triangle_complex& complex, const Order& order)
{
  return collect_vertices<ConcurrencyTag>(complex, order,
                                          [](Index number_of_sectors) { return number_of_sectors != 2; });
}

// All vertices in the place of the critical ones: with them, the engines find where each vertex is in the graph.
template <class ConcurrencyTag, class Order>
Critical_vertices sort_all_vertices(const Triangle_complex& complex, const Order& order)
{
  return collect_vertices<ConcurrencyTag>(complex, order, [](Index) { return true; });
}

inline Critical_vertex_counts count_critical_vertices(const Critical_vertices& critical_vertices)
{
  Critical_vertex_counts counts;
  for(Index i = 0; i != critical_vertices.size(); ++i)
  {
    const Index number_of_lower_sectors = critical_vertices.number_of_lower_sectors(i);
    const Index number_of_upper_sectors = critical_vertices.number_of_upper_sectors(i);
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

} // namespace internal
} // namespace Reeb_graph
} // namespace CGAL

#endif // CGAL_REEB_GRAPH_INTERNAL_CLASSIFY_VERTICES_H
