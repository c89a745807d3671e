// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of the CGAL-style package Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_INTERNAL_CRITICAL_VERTICES_CLASSIFY_VERTICES_H
#define CGAL_REEB_GRAPH_INTERNAL_CRITICAL_VERTICES_CLASSIFY_VERTICES_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/internal/base/Index.h>
#include <CGAL/Reeb_graph/internal/base/Large_vector.h>
#include <CGAL/Reeb_graph/internal/base/parallel.h>
#include <CGAL/Reeb_graph/internal/base/prefetch.h>
#include <CGAL/Reeb_graph/internal/critical_vertices/link_sectors.h>
#include <CGAL/Reeb_graph/internal/mesh/Triangle_complex_base.h>
#include <CGAL/Reeb_graph/visitor.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <memory>
#include <utility>
#include <vector>

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

// Some of a part of the vertices.
struct Found_vertices
{
  struct Vertex
  {
    Index vertex;
    Link_summary link;
  };

  Large_vector<Vertex> vertices;
  Sector_counts numbers_of_sectors = {0, 0};
  Fan_counts fan_counts; // if fans have been found on the way
};

// find_link(vertex, fan counts) tells the link of a vertex, is_wanted(number of link sectors) whether to take it.
template <class Complex, class FindLink, class IsWanted>
Found_vertices find_vertices(const Complex& complex,
                             std::size_t begin,
                             std::size_t end,
                             const FindLink& find_link,
                             const IsWanted& is_wanted,
                             Kept_neighbors& kept_neighbors)
{
  Found_vertices found;
  Kept_neighbors::Block neighbors = {};
  std::size_t number_of_found = 0;
  for(std::size_t block = begin; block < end; block += neighbors.size())
  {
    const std::size_t end_of_block = (std::min)(block + neighbors.size(), end), number_of_earlier = number_of_found;
    if(found.vertices.size() < number_of_found + neighbors.size())
      found.vertices.resize(2 * (number_of_found + neighbors.size()));
    for(std::size_t v = block; v != end_of_block; ++v)
    {
      if(!complex.has_vertex(static_cast<Index>(v)))
        continue;
      const Vertex_link link = find_link(static_cast<Index>(v), found.fan_counts);
      neighbors[v - block] = link.neighbors;
      const bool is_found = is_wanted(link.summary.number_of_sectors);
      found.vertices[number_of_found] = {static_cast<Index>(v), link.summary};
      number_of_found += is_found;
      found.numbers_of_sectors[false] += is_found * link.summary.number_of_lower_sectors();
      found.numbers_of_sectors[true] += is_found * link.summary.number_of_upper_sectors();
    }
    if(Kept_neighbors::are_worth_keeping(number_of_found - number_of_earlier, end_of_block - block))
      kept_neighbors.keep(neighbors, block, end_of_block);
  }
  found.vertices.resize(number_of_found);
  return found;
}

struct Found_parts
{
  std::vector<Found_vertices> parts;
  std::shared_ptr<Kept_neighbors> kept_neighbors;
};

template <class ConcurrencyTag, class Complex, class FindLink, class IsWanted>
Found_parts find_vertices_in_parts(const Complex& complex, const FindLink& find_link, const IsWanted& is_wanted)
{
  const std::size_t size = complex.number_of_vertices();
  Found_parts found = {std::vector<Found_vertices>(number_of_parts<ConcurrencyTag>(size)),
                       std::make_shared<Kept_neighbors>(size)};
  for_each_part<ConcurrencyTag>(found.parts.size(), size, [&](std::size_t part, std::size_t begin, std::size_t end) {
    found.parts[part] = find_vertices(complex, begin, end, find_link, is_wanted, *found.kept_neighbors);
  });
  return found;
}

// Puts each part in its place.
template <class ConcurrencyTag, class Complex, class Order>
Swept_vertices join_parts(const Complex& complex, const Order& order, const Found_parts& found)
{
  const std::vector<Found_vertices>& parts = found.parts;
  std::size_t number_of_vertices = 0;
  Sector_counts numbers_of_sectors = {0, 0};
  std::vector<std::size_t> first_vertices;
  std::vector<Sector_counts> first_sectors;
  for(const Found_vertices& part : parts)
  {
    first_vertices.push_back(number_of_vertices);
    first_sectors.push_back(numbers_of_sectors);
    number_of_vertices += part.vertices.size();
    for(const bool is_upper : {false, true})
      numbers_of_sectors[is_upper] += part.numbers_of_sectors[is_upper];
  }
  Swept_vertices result;
  result.resize(number_of_vertices, numbers_of_sectors);
  for_each_index<ConcurrencyTag>(parts.size(), [&](std::size_t part) {
    std::size_t i = first_vertices[part];
    Sector_counts sectors = first_sectors[part];
    for(const auto& [vertex, link] : parts[part].vertices)
    {
      result.set(static_cast<Index>(i++), complex, order, vertex, link, sectors);
      sectors[false] += link.number_of_lower_sectors();
      sectors[true] += link.number_of_upper_sectors();
    }
  });
  result.template sort<ConcurrencyTag>(order);
  result.set_kept_neighbors(found.kept_neighbors);
  return result;
}

inline bool has_critical_number_of_sectors(Index number_of_sectors) { return number_of_sectors != 2; }

// Finds the critical vertices: all but those with one lower and one upper sector. (The paper, Section 3.1; a border
// vertex has a path as link, so its sectors are counted.)
template <class ConcurrencyTag, class Complex, class Order>
Swept_vertices classify_vertices(const Complex& complex, const Order& order)
{
  const auto find = [&](Index vertex, Fan_counts&) { return find_link(complex, order, vertex); };
  return join_parts<ConcurrencyTag>(
    complex, order, find_vertices_in_parts<ConcurrencyTag>(complex, find, has_critical_number_of_sectors));
}

// The same for a complex that has not been checked, which is done on the way: both have to turn around each vertex.
template <class ConcurrencyTag, class Complex, class Order>
Swept_vertices check_and_classify_vertices(Complex& complex, const Order& order)
{
  const auto find = [&](Index vertex, Fan_counts& counts) { return find_fan_and_link(complex, order, vertex, counts); };
  const auto found = find_vertices_in_parts<ConcurrencyTag>(complex, find, has_critical_number_of_sectors);
  Fan_counts counts;
  for(const Found_vertices& part : found.parts)
    counts += part.fan_counts;
  complex.check(counts);
  return join_parts<ConcurrencyTag>(complex, order, found);
}

// All vertices in the place of the critical ones: with them, the engines find where each vertex is in the graph.
template <class ConcurrencyTag, class Complex, class Order>
Swept_vertices sort_all_vertices(const Complex& complex, const Order& order)
{
  const auto find = [&](Index vertex, Fan_counts&) { return find_link(complex, order, vertex); };
  return join_parts<ConcurrencyTag>(complex, order,
                                    find_vertices_in_parts<ConcurrencyTag>(complex, find, [](Index) { return true; }));
}

inline Critical_vertex_counts count_critical_vertices(const Swept_vertices& critical_vertices)
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

// That of the surface, to which a vertex contributes 1 minus the Euler characteristic of its lower link. (T. Banchoff,
// Critical points and curvature for embedded polyhedra, 1967.)
inline std::ptrdiff_t euler_characteristic(const Swept_vertices& critical_vertices)
{
  std::ptrdiff_t result = 0;
  for(Index i = 0; i != critical_vertices.size(); ++i)
  {
    const bool is_lower_link_closed =
      critical_vertices.number_of_upper_sectors(i) == 0 && !critical_vertices.is_on_border(i);
    result +=
      1 - (is_lower_link_closed ? 0 : static_cast<std::ptrdiff_t>(critical_vertices.number_of_lower_sectors(i)));
  }
  return result;
}

} // namespace internal
} // namespace Reeb_graph
} // namespace CGAL

#endif // CGAL_REEB_GRAPH_INTERNAL_CRITICAL_VERTICES_CLASSIFY_VERTICES_H
