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

#include <CGAL/Reeb_graph/internal/Triangle_complex.h>
#include <CGAL/Reeb_graph/internal/link_sectors.h>
#include <CGAL/Reeb_graph/visitor.h>

#include <CGAL/Iterator_range.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Reeb_graph {
namespace internal {

// The vertices with link sectors other than one lower and one upper, in ascending order. Stages name a critical
// vertex by its position here.
class Critical_vertices
{
public:
  typedef Iterator_range<const Link_sector*> Sectors;

  Index size() const { return static_cast<Index>(entries_.size()); }
  Index vertex(Index critical) const { return entries_[critical].vertex; }
  Index number_of_lower_sectors(Index critical) const { return entries_[critical].number_of_lower_sectors; }
  Index number_of_upper_sectors(Index critical) const
  {
    return entries_[critical].number_of_sectors - entries_[critical].number_of_lower_sectors;
  }

  // The link sectors in counterclockwise order; first_sector() is the position of the first one among all.
  Sectors sectors(Index critical) const
  {
    const Link_sector* first = sectors_.data() + first_sector(critical);
    return Sectors(first, first + entries_[critical].number_of_sectors);
  }
  std::size_t first_sector(Index critical) const { return entries_[critical].first_sector; }
  std::size_t total_number_of_sectors() const { return sectors_.size(); }

  // Adds `vertex` if it is critical.
  template <class Order>
  void test_and_add(const Triangle_complex& complex, const Order& order, Index vertex)
  {
    const std::size_t first = sectors_.size();
    append_link_sectors(complex, order, vertex, sectors_);
    const Index number_of_sectors = static_cast<Index>(sectors_.size() - first);
    const Index number_of_lower_sectors = static_cast<Index>(std::count_if(
      sectors_.begin() + first, sectors_.end(), [](const Link_sector& sector) { return !sector.is_upper; }));
    if(number_of_sectors == 2 && number_of_lower_sectors == 1)
      sectors_.resize(first);
    else
      entries_.push_back({first, vertex, number_of_sectors, number_of_lower_sectors});
  }

  template <class Order>
  void sort(const Order& order)
  {
    std::sort(entries_.begin(), entries_.end(),
              [&](const Entry& a, const Entry& b) { return order(a.vertex, b.vertex); });
  }

private:
  struct Entry
  {
    std::size_t first_sector;
    Index vertex;
    Index number_of_sectors;
    Index number_of_lower_sectors;
  };

  std::vector<Entry> entries_;
  std::vector<Link_sector> sectors_;
};

// For each vertex, the number of triangles in which it is the middle one: for an interior vertex twice the number
// of its lower sectors, and of its upper ones, except that an extremum has none.
template <class Order>
std::vector<Index> count_middle_corners(const Triangle_complex& complex, const Order& order)
{
  std::vector<Index> counts(complex.number_of_vertices(), 0);
  for(Index corner = 0; corner != complex.number_of_corners(); corner += 3)
  {
    const Index a = complex.vertex(corner), b = complex.vertex(corner + 1), c = complex.vertex(corner + 2);
    const bool is_a_below_b = order(a, b), is_b_below_c = order(b, c), is_a_below_c = order(a, c);
    ++counts[is_a_below_b == is_b_below_c ? b : (is_a_below_b == is_a_below_c ? c : a)];
  }
  return counts;
}

// Finds the critical vertices. (The paper, Section 3.1; a border vertex has a path as link, so its sectors are
// counted.)
template <class Order>
Critical_vertices classify_vertices(const Triangle_complex& complex, const Order& order)
{
  const std::vector<Index> middle_corners = count_middle_corners(complex, order);
  Critical_vertices critical_vertices;
  for(Index v = 0; v != complex.number_of_vertices(); ++v)
  {
    if(middle_corners[v] != 2 || complex.is_on_border(v))
      critical_vertices.test_and_add(complex, order, v);
  }
  critical_vertices.sort(order);
  return critical_vertices;
}

inline Critical_vertex_counts count_critical_vertices(const Triangle_complex& complex,
                                                      const Critical_vertices& critical_vertices)
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
    else if(complex.is_on_border(critical_vertices.vertex(i)))
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
