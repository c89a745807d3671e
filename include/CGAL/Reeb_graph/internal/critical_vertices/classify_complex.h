// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of the CGAL-style package Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_INTERNAL_CRITICAL_VERTICES_CLASSIFY_COMPLEX_H
#define CGAL_REEB_GRAPH_INTERNAL_CRITICAL_VERTICES_CLASSIFY_COMPLEX_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/internal/base/Plain_vector.h>
#include <CGAL/Reeb_graph/internal/base/Side.h>
#include <CGAL/Reeb_graph/internal/base/compiled.h>
#include <CGAL/Reeb_graph/internal/critical_vertices/Link_forests.h>
#include <CGAL/Reeb_graph/internal/critical_vertices/Monotone_neighbors.h>
#include <CGAL/Reeb_graph/internal/critical_vertices/Swept_vertices.h>
#include <CGAL/Reeb_graph/internal/critical_vertices/classify_vertices.h>
#include <CGAL/Reeb_graph/internal/mesh/Simplicial_complex.h>
#include <CGAL/Reeb_graph/internal/mesh/mesh_indices.h>

#include <algorithm>
#include <cstddef>
#include <memory>
#include <utility>

namespace CGAL {
namespace Reeb_graph {
namespace internal {

// What classify_vertices.h does for surfaces, for any complex: finds the vertices that is_wanted(vertex, its numbers of
// lower and upper sectors) takes. Both sides count, as they do not alternate around a vertex. Two sweeps on one
// thread; only sorting uses more.
template <class ConcurrencyTag, class Order, class IsWanted>
Swept_vertices find_vertices_of_complex(const Simplicial_complex& complex,
                                        const Order& order,
                                        const IsWanted& is_wanted)
{
  Link_forests<Order> forests(complex, order);
  Plain_vector<Vertex_index> wanted;
  Sector_counts numbers_of_sectors = {0, 0};
  auto kept_neighbors = std::make_shared<Kept_neighbors>(complex.number_of_vertices());
  Kept_neighbors::Block neighbors = {};
  for(std::size_t begin = 0; begin < complex.number_of_vertices(); begin += neighbors.size())
  {
    const std::size_t end = (std::min)(begin + neighbors.size(), std::size_t(complex.number_of_vertices()));
    const std::size_t number_of_earlier = wanted.size();
    for(const Vertex_index v : Index_range(Vertex_index(begin), Vertex_index(end)))
    {
      const By_side<Number> numbers = forests.numbers_of_sectors(v);
      if(!is_wanted(v, numbers))
        continue;
      wanted.push_back(v);
      for(const Side side : both_sides)
        numbers_of_sectors[side] += numbers[side];
    }
    if(!Kept_neighbors::are_worth_keeping(wanted.size() - number_of_earlier, end - begin))
      continue;
    for(const Vertex_index v : Index_range(Vertex_index(begin), Vertex_index(end)))
      neighbors[v.number() - begin] = forests.neighbors(v);
    kept_neighbors->keep(neighbors, begin, end);
  }

  Swept_vertices result;
  result.resize(wanted.size(), numbers_of_sectors);
  Sector_counts first_sectors = {0, 0};
  Swept_index i(0);
  for(const Vertex_index v : wanted)
  {
    result.set(i, complex, v, forests, first_sectors);
    ++i;
    for(const Side side : both_sides)
      first_sectors[side] += forests.numbers_of_sectors(v)[side];
  }
  result.template sort<ConcurrencyTag>(order);
  result.set_kept_neighbors(std::move(kept_neighbors));
  return result;
}

inline bool has_critical_numbers_of_sectors(const By_side<Number>& numbers_of_sectors)
{
  return numbers_of_sectors[Side::LOWER] != 1 || numbers_of_sectors[Side::UPPER] != 1;
}

template <class ConcurrencyTag, class Order>
Swept_vertices classify_vertices(const Simplicial_complex& complex, const Order& order)
{
  return find_vertices_of_complex<ConcurrencyTag>(complex, order, [](Vertex_index, const By_side<Number>& numbers) {
    return has_critical_numbers_of_sectors(numbers);
  });
}

// There is nothing left to check of a complex.
template <class ConcurrencyTag, class Order>
Classified_complex<Simplicial_complex> check_and_classify_vertices(Simplicial_complex complex, const Order& order)
{
  Swept_vertices critical_vertices = classify_vertices<ConcurrencyTag>(complex, order);
  return {std::move(complex), std::move(critical_vertices)};
}

#define CGAL_REEB_GRAPH_CLASSIFY_VERTICES_OF_SOUP(PREFIX, TAG, COMPLEX, SCALAR)                                        \
  PREFIX template Classified_complex<COMPLEX> check_and_classify_vertices<TAG>(COMPLEX, const Natural_order<SCALAR>&);
CGAL_REEB_GRAPH_FOR_SOUPS(CGAL_REEB_GRAPH_CLASSIFY_VERTICES_OF_SOUP)

} // namespace internal
} // namespace Reeb_graph
} // namespace CGAL

#endif // CGAL_REEB_GRAPH_INTERNAL_CRITICAL_VERTICES_CLASSIFY_COMPLEX_H
