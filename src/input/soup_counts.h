// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_SRC_SOUP_COUNTS_H
#define CGAL_REEB_GRAPH_SRC_SOUP_COUNTS_H

#include "base/input_findings.h"
#include "input/Polygon_soup.h"

#include <boost/pending/disjoint_sets.hpp>

#include <cstddef>
#include <numeric>
#include <tuple>
#include <vector>

namespace reeb_graph_program {
class Union_find_of_indices
{
public:
  explicit Union_find_of_indices(std::size_t size)
    : ranks_(size, 0),
      parents_(size),
      sets_(ranks_.data(), parents_.data())
  {
    std::iota(parents_.begin(), parents_.end(), std::size_t(0));
  }
  std::size_t find(std::size_t i) { return sets_.find_set(i); }
  void unite(std::size_t i, std::size_t j) { sets_.union_set(i, j); }
  bool is_root(std::size_t i) { return find(i) == i; }

private:
  std::vector<std::size_t> ranks_, parents_;
  boost::disjoint_sets<std::size_t*, std::size_t*> sets_;
};

// A side of a polygon, by its vertices in ascending order, and which corners of all polygons it has there. The order is
// that of edges.
struct Polygon_side
{
  Corner u, v;
  std::size_t corner_of_u, corner_of_v, face;
  bool is_descending; // along the polygon

  bool operator<(const Polygon_side& other) const { return std::tie(u, v) < std::tie(other.u, other.v); }
};

// Those of all polygons, edge by edge; within one, in the order of the polygons.
std::vector<Polygon_side> sides_of(const Polygons& polygons);

// The end of the sides that begin at a place and are of the same edge.
inline std::size_t end_of_edge(const std::vector<Polygon_side>& sides, std::size_t begin)
{
  std::size_t end = begin + 1;
  while(end < sides.size() && !(sides[begin] < sides[end]))
    ++end;
  return end;
}

Soup_counts count_soup(const Polygons& polygons, std::size_t number_of_vertices);

// The component of each polygon; polygons that share a vertex are in one.
// How many fans the faces at each vertex form.
std::vector<std::size_t> count_fans(const Polygons& polygons,
                                    const std::vector<Polygon_side>& sides,
                                    std::size_t number_of_vertices);

// The component of each polygon, by a vertex of it. Polygons with a common vertex are in one.
std::vector<std::size_t> components_of_polygons(const Polygons& polygons, std::size_t number_of_vertices);

} // namespace reeb_graph_program

#endif // CGAL_REEB_GRAPH_SRC_SOUP_COUNTS_H
