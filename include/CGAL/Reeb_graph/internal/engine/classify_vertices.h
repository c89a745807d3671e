// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_INTERNAL_ENGINE_CLASSIFY_VERTICES_H
#define CGAL_REEB_GRAPH_INTERNAL_ENGINE_CLASSIFY_VERTICES_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/internal/base/Index.h>
#include <CGAL/Reeb_graph/internal/base/arrays.h>
#include <CGAL/Reeb_graph/internal/base/compiled.h>
#include <CGAL/Reeb_graph/internal/base/parallel.h>
#include <CGAL/Reeb_graph/internal/base/union_find.h>
#include <CGAL/Reeb_graph/internal/complex/Regular_vertices.h>
#include <CGAL/Reeb_graph/internal/complex/Unchecked_complex.h>
#include <CGAL/Reeb_graph/internal/engine/Swept_vertices.h>
#include <CGAL/Reeb_graph/internal/engine/monotone_paths.h>
#include <CGAL/Reeb_graph/internal/engine/vertex_links.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <memory>
#include <utility>
#include <vector>

namespace CGAL::Reeb_graph::internal {

// Findings in a part of the vertices.
struct Found_vertices
{
  struct Vertex
  {
    Vertex_index vertex;
    Link_summary link;
  };

  Plain_vector<Vertex> vertices;
  Sector_counts numbers_of_sectors = {0, 0};
  Fan_counts fan_counts; // if fans have been found on the way
};

// Finds the critical vertices from `begin` to `end`: all but those with one lower and one upper sector. (The paper,
// Section 3.1; a border vertex has a path as link, so its sectors are counted.) find_link(vertex, fan counts) tells the
// link of a vertex.
template <class Complex, class FindLink>
Found_vertices find_vertices(const Complex& complex,
                             std::size_t begin,
                             std::size_t end,
                             const FindLink& find_link,
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
    for(const Vertex_index v : Index_range(Vertex_index(block), Vertex_index(end_of_block)))
    {
      if(!complex.has_vertex(v))
        continue;
      const Vertex_link link = find_link(v, found.fan_counts);
      neighbors[v.number() - block] = link.neighbors;
      const std::size_t is_found = link.summary.number_of_sectors != 2 ? 1 : 0;
      found.vertices[number_of_found] = {v, link.summary};
      number_of_found += is_found;
      found.numbers_of_sectors[Side::LOWER] += is_found * link.summary.number_of_lower_sectors();
      found.numbers_of_sectors[Side::UPPER] += is_found * link.summary.number_of_upper_sectors();
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

template <class ConcurrencyTag, class Complex, class FindLink>
Found_parts find_vertices_in_parts(const Complex& complex, const FindLink& find_link)
{
  const std::size_t size = complex.number_of_vertices();
  Found_parts found = {std::vector<Found_vertices>(number_of_parts<ConcurrencyTag>(size)),
                       std::make_shared<Kept_neighbors>(size)};
  for_each_part<ConcurrencyTag>(found.parts.size(), size, [&](std::size_t part, std::size_t begin, std::size_t end) {
    found.parts[part] = find_vertices(complex, begin, end, find_link, *found.kept_neighbors);
  });
  return found;
}

// The vertices of all parts, each in its place.
template <class ConcurrencyTag, class Complex, class Order>
Swept_vertices join_parts(const Complex& complex, const Order& order, const Found_parts& found)
{
  const std::vector<Found_vertices>& parts = found.parts;
  std::size_t number_of_vertices = 0;
  Sector_counts numbers_of_sectors = {0, 0};
  Plain_vector<std::size_t> first_vertices;
  Plain_vector<Sector_counts> first_sectors;
  for(const Found_vertices& part : parts)
  {
    first_vertices.push_back(number_of_vertices);
    first_sectors.push_back(numbers_of_sectors);
    number_of_vertices += part.vertices.size();
    for(const Side side : both_sides)
      numbers_of_sectors[side] += part.numbers_of_sectors[side];
  }
  Swept_vertices result;
  result.resize(number_of_vertices, numbers_of_sectors);
  for_each_index<ConcurrencyTag>(parts.size(), [&](std::size_t part) {
    Swept_index i(first_vertices[part]);
    Sector_counts sectors = first_sectors[part];
    for(const auto& [vertex, link] : parts[part].vertices)
    {
      const auto places = result.set(i, vertex, link.is_first_upper, complex.is_on_border(vertex), sectors);
      find_link_sectors(complex, order, vertex, link, places);
      ++i;
      sectors[Side::LOWER] += link.number_of_lower_sectors();
      sectors[Side::UPPER] += link.number_of_upper_sectors();
    }
  });
  result.template sort<ConcurrencyTag>(order);
  result.set_kept_neighbors(found.kept_neighbors);
  return result;
}

// Finds the critical vertices.
template <class ConcurrencyTag, class Complex, class Order>
Swept_vertices classify_vertices(const Complex& complex, const Order& order)
{
  const auto regular_vertices = find_regular_vertices<ConcurrencyTag>(complex, order);
  const auto find = [&](Vertex_index vertex, Fan_counts&) {
    return regular_vertices.number_of_corners(vertex) != 0 ? regular_link : find_link(complex, order, vertex);
  };
  return join_parts<ConcurrencyTag>(complex, order, find_vertices_in_parts<ConcurrencyTag>(complex, find));
}

template <class Complex>
struct Classified_complex
{
  Complex complex;
  Swept_vertices critical_vertices;
};

// Finds the critical vertices of a complex that has not been checked, which is done on the way: both have to turn
// around each vertex that is not one of the regular ones known before.
template <class ConcurrencyTag, class Complex, class Order>
Classified_complex<Complex> check_and_classify_vertices(Unchecked_complex<Complex> unchecked, const Order& order)
{
  const auto regular_vertices = find_regular_vertices<ConcurrencyTag>(unchecked.at_set_fans(), order);
  const auto find = [&](Vertex_index vertex, Fan_counts& counts) {
    const Number number_of_corners = regular_vertices.number_of_corners(vertex);
    if(number_of_corners == 0)
      return set_fan_and_find_link(unchecked, order, vertex, counts);
    unchecked.set_closed_fan(vertex);
    counts.corners += number_of_corners;
    return regular_link;
  };
  const auto found = find_vertices_in_parts<ConcurrencyTag>(unchecked, find);
  Fan_counts counts;
  for(const Found_vertices& part : found.parts)
    counts += part.fan_counts;
  Complex complex = std::move(unchecked).check(counts);
  Swept_vertices critical_vertices = join_parts<ConcurrencyTag>(complex, order, found);
  return {std::move(complex), std::move(critical_vertices)};
}

// A complex that has been checked before.
template <class Complex>
struct Checked_complex
{
  const Complex& complex;
};

template <class ConcurrencyTag, class Complex, class Order>
Classified_complex<const Complex&> check_and_classify_vertices(Checked_complex<Complex> checked, const Order& order)
{
  return {checked.complex, classify_vertices<ConcurrencyTag>(checked.complex, order)};
}

#define CGAL_REEB_GRAPH_CLASSIFY_VERTICES(PREFIX, TAG, COMPLEX, SCALAR)                                                \
  PREFIX template Classified_complex<COMPLEX> check_and_classify_vertices<TAG>(Unchecked_complex<COMPLEX>,             \
                                                                               const Natural_order<SCALAR>&);          \
  PREFIX template Swept_vertices classify_vertices<TAG>(const COMPLEX&, const Natural_order<SCALAR>&);
CGAL_REEB_GRAPH_FOR_SURFACES(CGAL_REEB_GRAPH_CLASSIFY_VERTICES)

} // namespace CGAL::Reeb_graph::internal

#endif // CGAL_REEB_GRAPH_INTERNAL_ENGINE_CLASSIFY_VERTICES_H
