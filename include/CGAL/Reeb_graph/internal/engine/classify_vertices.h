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

#include <CGAL/Reeb_graph/internal/complex/Regular_vertices.h>
#include <CGAL/Reeb_graph/internal/complex/Stars_ahead.h>
#include <CGAL/Reeb_graph/internal/engine/Between_stages.h>

#include <algorithm>
#include <cstddef>
#include <functional>
#include <memory>
#include <utility>
#include <vector>

namespace CGAL::Reeb_graph::internal {

// Findings of one turn around a vertex.
struct Vertex_link
{
  Link_summary summary;
  Monotone_neighbors neighbors;
};

// The link of a vertex that is known to be regular, without a turn.
inline constexpr Vertex_link regular_link = {{2, false}, {no_index, no_index}};

// Counts how often the neighbors of a vertex change between lower and higher ones. That is the number of link sectors
// if the last neighbor is the first one again; on the border, where the link is a path, there is one more.
class Link_changes
{
public:
  Link_changes(const Vertex_order& order, Vertex_index vertex) : order_(order), vertex_(vertex) {}

  void begin(Vertex_index neighbor)
  {
    is_first_upper_ = is_last_upper_ = order_(vertex_, neighbor);
    set_neighbor(neighbor);
  }
  void add(Vertex_index neighbor)
  {
    const bool is_upper = order_(vertex_, neighbor);
    number_ += is_upper != is_last_upper_;
    is_last_upper_ = is_upper;
    set_neighbor(neighbor);
  }

  Vertex_link closed_link() const { return {{(std::max)(number_, Index(1)), is_first_upper_}, {lower_, higher_}}; }
  Vertex_link path() const { return {{number_ + 1, is_first_upper_}, {lower_, higher_}}; }

private:
  // Keeps a neighbor, without a branch that could not be predicted, nor an array, which would have to be in memory.
  void set_neighbor(Vertex_index neighbor)
  {
    lower_ = is_last_upper_ ? lower_ : neighbor;
    higher_ = is_last_upper_ ? neighbor : higher_;
  }

  const Vertex_order& order_;
  const Vertex_index vertex_;
  Index number_ = 0;
  Vertex_index lower_ = no_index;
  Vertex_index higher_ = no_index;
  bool is_first_upper_ = false;
  bool is_last_upper_ = false;
};

template <class Complex>
Vertex_link find_link(const Complex& complex, const Vertex_order& order, Vertex_index vertex)
{
  const Halfedge_index first = complex.first_halfedge(vertex);
  if(first == no_index)
    return {{0, false}, {no_index, no_index}};
  Link_changes changes(order, vertex);
  changes.begin(complex.source(first));
  complex.for_each_halfedge_around(
    vertex, [&](Halfedge_index halfedge) { changes.add(complex.target(complex.next(halfedge))); });
  return complex.is_on_border(vertex) ? changes.path() : changes.closed_link();
}

// Sets the fan of a vertex and finds its link: both in one turn if the vertex is inside of the surface.
template <class Complex>
Vertex_link set_fan_and_find_link(Unchecked_complex<Complex>& complex,
                                  const Vertex_order& order,
                                  Vertex_index vertex,
                                  Fan_counts& counts)
{
  Link_changes changes(order, vertex);
  return complex.set_fan(vertex, counts, changes) ? changes.closed_link()
                                                  : find_link(complex.at_set_fans(), order, vertex);
}

// Makes `neighbor` the extreme one of its sector if it is. Without a branch that could not be predicted.
inline void add_to_sector(Link_sector& sector,
                          const Vertex_order& order,
                          Side side,
                          Vertex_index neighbor,
                          Halfedge_index halfedge)
{
  const bool is_more_extreme = order(sector.extreme_neighbor, neighbor) == (side == Side::UPPER);
  sector.extreme_neighbor = is_more_extreme ? neighbor : sector.extreme_neighbor;
  sector.edge = is_more_extreme ? halfedge : sector.edge;
}

// Writes the link sectors of `vertex`, the lower ones and the upper ones each in clockwise order, to the two places.
template <class Complex>
void find_link_sectors(const Complex& complex,
                       const Vertex_order& order,
                       Vertex_index vertex,
                       const Link_summary& summary,
                       const By_side<Link_sector*>& places)
{
  Side last_side = summary.first_side();
  for(Index i = 0; i != summary.number_of_sectors; ++i, last_side = opposite_of(last_side))
    places[last_side][i / 2] = {vertex, no_index};

  last_side = summary.first_side();
  Index i = 0;
  complex.for_each_edge_around(vertex, [&](Vertex_index neighbor, Halfedge_index halfedge) {
    const Side side = side_of(order(vertex, neighbor));
    i += side != last_side;
    i = i == summary.number_of_sectors ? 0 : i; // The turn has begun within a sector, which goes on here.
    last_side = side;
    Link_sector sector = places[side][i / 2];
    add_to_sector(sector, order, side, neighbor, halfedge);
    places[side][i / 2] = sector;
  });
}

inline Critical_vertex_counts count_critical_vertices(const Swept_vertices& critical_vertices)
{
  Critical_vertex_counts counts;
  for(const Swept_index i : critical_vertices.indices())
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
template <class Complex, class Stars, class FindLink>
Found_vertices find_vertices(const Complex& complex,
                             const Stars& stars,
                             std::size_t begin,
                             std::size_t end,
                             const FindLink& find_link,
                             Kept_neighbors& kept_neighbors)
{
  Found_vertices found;
  Kept_neighbors::Block neighbors = {};
  std::size_t number_of_found = 0;
  const auto vertex_at = [](std::size_t i) { return Vertex_index(i); };
  for(std::size_t block = begin; block < end; block += neighbors.size())
  {
    const std::size_t end_of_block = (std::min)(block + neighbors.size(), end), number_of_earlier = number_of_found;
    if(found.vertices.size() < number_of_found + neighbors.size())
      found.vertices.resize(2 * (number_of_found + neighbors.size()));
    stars.visit(block, end_of_block, vertex_at, [&](std::size_t i) {
      const Vertex_index v(i);
      if(!complex.has_vertex(v))
        return;
      const Vertex_link link = find_link(v, found.fan_counts);
      neighbors[i - block] = link.neighbors;
      found.vertices[number_of_found] = {v, link.summary};
      number_of_found += link.summary.number_of_sectors != 2 ? 1 : 0;
    });
    if(Kept_neighbors::are_worth_keeping(number_of_found - number_of_earlier, end_of_block - block))
      kept_neighbors.keep(neighbors, block, end_of_block);
  }
  found.vertices.resize(number_of_found);
  for(const auto& [vertex, link] : found.vertices)
  {
    found.numbers_of_sectors[Side::LOWER] += link.number_of_lower_sectors();
    found.numbers_of_sectors[Side::UPPER] += link.number_of_upper_sectors();
  }
  return found;
}

struct Found_parts
{
  std::vector<Found_vertices> parts;
  std::shared_ptr<Kept_neighbors> kept_neighbors;
};

template <class Complex, class Stars, class FindLink>
Found_parts find_vertices_in_parts(const Threads& threads,
                                   const Complex& complex,
                                   const Stars& stars,
                                   const FindLink& find_link)
{
  const std::size_t size = complex.number_of_vertices();
  Found_parts found = {std::vector<Found_vertices>(threads.number_of_parts(size)),
                       std::make_shared<Kept_neighbors>(size)};
  threads.for_each_part(found.parts.size(), size, [&](std::size_t part, std::size_t begin, std::size_t end) {
    found.parts[part] = find_vertices(complex, stars, begin, end, find_link, *found.kept_neighbors);
  });
  return found;
}

// The vertices of all parts, each in its place.
template <class Complex>
Swept_vertices join_parts(const Threads& threads,
                          const Complex& complex,
                          const Vertex_order& order,
                          Way_of_turning way,
                          const Found_parts& found)
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
  const Stars_ahead stars(complex, order, way == Way_of_turning::STARS_AHEAD);
  threads.for_each_index(parts.size(), [&](std::size_t part) {
    Swept_index i(first_vertices[part]);
    Sector_counts sectors = first_sectors[part];
    const auto& vertices = parts[part].vertices;
    const auto vertex_at = [&](std::size_t k) { return vertices[k].vertex; };
    stars.visit(0, vertices.size(), vertex_at, [&](std::size_t k) {
      const auto& [vertex, link] = vertices[k];
      const auto places = result.set(i, vertex, link.is_first_upper, complex.is_on_border(vertex), sectors);
      find_link_sectors(complex, order, vertex, link, places);
      ++i;
      sectors[Side::LOWER] += link.number_of_lower_sectors();
      sectors[Side::UPPER] += link.number_of_upper_sectors();
    });
  });
  result.sort(threads, order);
  result.set_kept_neighbors(found.kept_neighbors);
  return result;
}

// Finds the critical vertices.
template <class Complex>
Swept_vertices classify_vertices(const Threads& threads, const Complex& complex, const Vertex_order& order)
{
  const Way_of_turning way = fastest_way(complex, order);
  const auto regular_vertices = find_regular_vertices(threads, complex, order, way);
  const Stars_ahead stars(complex, order, way == Way_of_turning::STARS_AHEAD);
  const auto find = [&](Vertex_index vertex, Fan_counts&) {
    return regular_vertices.number_of_corners(vertex) != 0 ? regular_link : find_link(complex, order, vertex);
  };
  return join_parts(threads, complex, order, way, find_vertices_in_parts(threads, complex, stars, find));
}

template <class Complex>
struct Classified_complex
{
  Complex complex;
  Swept_vertices critical_vertices;
};

// Finds the critical vertices of a complex that has not been checked, which is done on the way: both have to turn
// around each vertex that is not one of the regular ones known before.
template <class Complex>
Classified_complex<Complex> check_and_classify_vertices(const Threads& threads,
                                                        Unchecked_complex<Complex> unchecked,
                                                        const Vertex_order& order)
{
  const Way_of_turning way = fastest_way(unchecked.at_set_fans(), order);
  const auto regular_vertices = find_regular_vertices(threads, unchecked.at_set_fans(), order, way);
  const Stars_ahead stars(unchecked.at_set_fans(), order, way == Way_of_turning::STARS_AHEAD);
  const auto find = [&](Vertex_index vertex, Fan_counts& counts) {
    const Index number_of_corners = regular_vertices.number_of_corners(vertex);
    if(number_of_corners == 0)
      return set_fan_and_find_link(unchecked, order, vertex, counts);
    unchecked.set_closed_fan(vertex);
    counts.corners += number_of_corners;
    return regular_link;
  };
  const auto found = find_vertices_in_parts(threads, unchecked, stars, find);
  Fan_counts counts;
  for(const Found_vertices& part : found.parts)
    counts += part.fan_counts;
  Complex complex = std::move(unchecked).check(counts);
  Swept_vertices critical_vertices = join_parts(threads, complex, order, way, found);
  return {std::move(complex), std::move(critical_vertices)};
}

// A complex that is given by reference has been checked before.
template <class Complex>
Classified_complex<const Complex&> check_and_classify_vertices(const Threads& threads,
                                                               std::reference_wrapper<const Complex> checked,
                                                               const Vertex_order& order)
{
  return {checked, classify_vertices(threads, checked.get(), order)};
}

#define CGAL_REEB_GRAPH_CLASSIFY_VERTICES(PREFIX, COMPLEX)                                                             \
  PREFIX template Classified_complex<COMPLEX> check_and_classify_vertices(const Threads&, Unchecked_complex<COMPLEX>,  \
                                                                          const Vertex_order&);                        \
  PREFIX template Swept_vertices classify_vertices(const Threads&, const COMPLEX&, const Vertex_order&);
CGAL_REEB_GRAPH_FOR_SURFACES(CGAL_REEB_GRAPH_CLASSIFY_VERTICES)

} // namespace CGAL::Reeb_graph::internal

#endif // CGAL_REEB_GRAPH_INTERNAL_ENGINE_CLASSIFY_VERTICES_H
