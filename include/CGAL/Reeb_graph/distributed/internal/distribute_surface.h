// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_DISTRIBUTED_INTERNAL_DISTRIBUTE_SURFACE_H
#define CGAL_REEB_GRAPH_DISTRIBUTED_INTERNAL_DISTRIBUTE_SURFACE_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/distributed/exceptions.h>
#include <CGAL/Reeb_graph/distributed/internal/Vertex_numbering.h>
#include <CGAL/Reeb_graph/distributed/internal/exchange.h>
#include <CGAL/Reeb_graph/distributed/internal/solve_slab.h>
#include <CGAL/Reeb_graph/exceptions.h>
#include <CGAL/Reeb_graph/internal/base/Index.h>
#include <CGAL/Reeb_graph/internal/base/scalars.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <limits>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL::Reeb_graph::internal {

// Whether a double holds a number; of integers, those up to 2^53 count.
template <class Number>
bool is_held_by_double(Number number)
{
  constexpr int digits = std::numeric_limits<double>::digits;
  if constexpr(std::numeric_limits<Number>::digits <= digits)
    return true;
  else if constexpr(std::is_integral_v<Number>)
  {
    constexpr Number largest = Number(1) << digits;
    return number <= largest && (std::is_unsigned_v<Number> || number >= Number(0) - largest);
  }
  else
    return static_cast<Number>(static_cast<double>(number)) == number;
}

// The part of the surface that a rank has brought, and how large that of all ranks is.
template <class TriangleRange, class ScalarRange>
struct Local_part
{
  // Throws if the ranges of the ranks do not fit together, or a rank has not as many values as vertices. Collective.
  template <class VertexRange>
  Local_part(Exchange& exchange,
             const VertexRange& local_vertices,
             const TriangleRange& local_triangles,
             const ScalarRange& local_scalars)
    : triangles(local_triangles),
      scalars(local_scalars),
      size(size_of(local_vertices)),
      number_of_local_triangles(size_of(local_triangles)),
      ranges({})
  {
    Sizes own = {0, size, size_of(local_scalars), number_of_local_triangles};
    exchange.in_agreement([&] {
      if(own.vertices == own.scalars) // else the range may be anything
        own.begin = first_of_contiguous(local_vertices);
    });
    begin = own.begin;
    const std::vector<Sizes> all = exchange.all_gather(own);
    std::vector<Vertex_range> all_ranges;
    for(std::size_t rank = 0; rank != all.size(); ++rank)
    {
      if(all[rank].vertices != all[rank].scalars)
        throw Scalar_count_error(all[rank].scalars, all[rank].vertices);
      all_ranges.push_back({all[rank].begin, all[rank].begin + all[rank].vertices, rank});
      if(rank == exchange.rank())
        first_triangle = number_of_triangles;
      number_of_triangles += all[rank].triangles;
    }
    ranges = Vertex_ranges(std::move(all_ranges));
  }

  const TriangleRange& triangles;
  const ScalarRange& scalars;
  Long_index begin = 0; // of the vertices of this rank
  std::size_t size;
  std::size_t number_of_local_triangles;
  std::uint64_t first_triangle = 0;      // among those of all ranks
  std::uint64_t number_of_triangles = 0; // of all ranks
  Vertex_ranges ranges;

  std::uint64_t number_of_vertices() const { return ranges.number_of_vertices(); }

  // The value of a vertex of this rank.
  auto value(Long_index vertex) const
  {
    auto value = std::begin(scalars)[static_cast<std::ptrdiff_t>(vertex - begin)];
    return value;
  }
  double key(Long_index vertex) const { return static_cast<double>(value(vertex)); }

  // Throws if a value is NaN, or none that a double holds: ranks of all values are not known where a few are.
  void check_scalars() const
  {
    for(Long_index v = begin; v != begin + size; ++v)
    {
      if(!is_ordered(value(v)))
        throw Unordered_scalar_error(static_cast<std::size_t>(v));
      if(!is_held_by_double(value(v)))
        throw Inexact_scalar_error(static_cast<std::size_t>(v));
    }
  }

  // Calls visit(vertex) for each corner of each triangle. Throws if a triangle has not three different vertices, by its
  // position among those of all ranks, one rank behind the other.
  template <class Visit>
  void check_triangles(const Visit& visit) const
  {
    const Long_index end = ranges.number_of_vertices();
    std::uint64_t position = first_triangle;
    for_each_triangle([&](Long_index a, Long_index b, Long_index c) {
      if(a >= end || b >= end || c >= end)
        throw Vertex_out_of_range_error("face", static_cast<std::size_t>(position));
      if(a == b || b == c || c == a)
        throw Degenerate_face_error(static_cast<std::size_t>(position));
      visit(a);
      visit(b);
      visit(c);
      ++position;
    });
  }

  // Calls visit(a, b, c) for the vertices of each triangle. Negative indices become large ones.
  template <class Visit>
  void for_each_triangle(const Visit& visit) const
  {
    for(const auto& t : triangles)
      visit(static_cast<Long_index>(t[0]), static_cast<Long_index>(t[1]), static_cast<Long_index>(t[2]));
  }

private:
  struct Sizes
  {
    Long_index begin;
    std::uint64_t vertices, scalars, triangles;
  };

  template <class Range>
  static std::size_t size_of(const Range& range)
  {
    return static_cast<std::size_t>(std::distance(std::begin(range), std::end(range)));
  }

  template <class VertexRange>
  static Long_index first_of_contiguous(const VertexRange& vertices)
  {
    if(std::begin(vertices) == std::end(vertices))
      return 0;
    const Long_index first = static_cast<Long_index>(*std::begin(vertices));
    Long_index next = first;
    for(const auto vertex : vertices)
      if(static_cast<Long_index>(vertex) != next++)
        throw Vertex_ranges_error(static_cast<std::size_t>(next - 1));
    return first;
  }
};

// The number of a slab where there is one for each triangle or vertex.
typedef std::uint16_t Short_slab;
inline constexpr std::size_t most_slabs = std::size_t(1) << 16;

struct Slab_range
{
  Short_slab lowest;
  Short_slab highest;
};

// How many triangles a rank gets, and how many of these a lower rank gets as well.
struct Triangle_counts
{
  std::uint64_t triangles = 0;
  std::uint64_t copies = 0;
};

// A vertex of a triangle on the way: as 32 bits where that is enough for the vertices of all ranks.
inline Long_index global_vertex(Vertex_index vertex) { return vertex.number(); }
inline Long_index global_vertex(Long_index vertex) { return vertex; }

template <class Vertex>
using Triangles_of = std::vector<std::array<Vertex, 3>>;

// Counts, for each rank, the triangles that it will get from this one.
inline std::vector<Triangle_counts> count_triangles(const std::vector<Slab_range>& slabs, std::size_t number_of_ranks)
{
  std::vector<Triangle_counts> counts(number_of_ranks);
  for(const Slab_range& range : slabs)
  {
    ++counts[range.lowest].triangles;
    for(std::size_t slab = std::size_t(range.lowest) + 1; slab <= range.highest; ++slab)
    {
      ++counts[slab].triangles;
      ++counts[slab].copies;
    }
  }
  return counts;
}

// The end of the triangles from `begin` on that are sent in one round.
inline std::size_t end_of_round(const std::vector<Slab_range>& slabs, std::size_t begin, std::size_t most_items)
{
  std::size_t end = begin;
  for(std::size_t sum = 0; end != slabs.size() && sum < most_items; ++end)
    sum += std::size_t(slabs[end].highest) - slabs[end].lowest + 1;
  return end;
}

// Sends each triangle to the ranks of all slabs that it meets. Returns those that come, which together are `expected`,
// and adds their vertices to the numbering. Collective.
template <class Vertex, class Triangles>
Triangles_of<Vertex> send_triangles(Exchange& exchange,
                                    const Triangles& triangles,
                                    const std::vector<Slab_range>& slabs,
                                    std::uint64_t expected,
                                    Vertex_numbering& numbering)
{
  Triangles_of<Vertex> received;
  std::size_t begin = 0, number_of_known = 0;
  const auto add_vertices = [&] {
    for(; number_of_known != received.size(); ++number_of_known)
      for(const Vertex vertex : received[number_of_known])
        numbering.add(global_vertex(vertex));
  };
  exchange.in_agreement([&] { received.reserve(static_cast<std::size_t>(expected)); });
  while(exchange.is_on_any_rank(begin != slabs.size()))
  {
    Parcels<std::array<Vertex, 3>> parcels(exchange.number_of_ranks());
    exchange.in_agreement([&] {
      add_vertices();
      const std::size_t end = end_of_round(slabs, begin, exchange.most_items_in_round<std::array<Vertex, 3>>());
      parcels = Parcels<std::array<Vertex, 3>>(exchange.number_of_ranks(), [&](const auto& visit) {
        for(std::size_t i = begin; i != end; ++i)
        {
          const auto& t = std::begin(triangles)[static_cast<std::ptrdiff_t>(i)];
          for(std::size_t slab = slabs[i].lowest; slab <= slabs[i].highest; ++slab)
            visit(slab, std::array<Vertex, 3>{Vertex(t[0]), Vertex(t[1]), Vertex(t[2])});
        }
      });
      begin = end;
    });
    exchange.send(parcels, received);
  }
  exchange.in_agreement(add_vertices);
  return received;
}

// Adds the vertices of each slab to the numbering of its rank. Those of this rank begin at `begin`. Collective.
inline void send_vertices(Exchange& exchange,
                          Long_index begin,
                          const std::vector<Short_slab>& slabs,
                          Vertex_numbering& numbering)
{
  const std::size_t most_vertices = exchange.most_items_in_round<Vertex_word>();
  typedef std::pair<std::size_t, Vertex_word> Word_of_slab;
  std::vector<Word_of_slab> words;
  std::size_t next = 0;
  while(exchange.is_on_any_rank(next != slabs.size()))
  {
    Parcels<Vertex_word> parcels(exchange.number_of_ranks());
    exchange.in_agreement([&] {
      words.clear();
      std::size_t first_of_block = 0;
      for(const std::size_t end = (std::min)(next + most_vertices, slabs.size()); next != end; ++next)
      {
        const std::uint64_t position = (begin + next) / Vertex_word::size;
        if(!words.empty() && words.back().second.position != position)
          first_of_block = words.size();
        auto word = words.begin() + static_cast<std::ptrdiff_t>(first_of_block);
        word = std::find_if(word, words.end(), [&](const Word_of_slab& w) { return w.first == slabs[next]; });
        if(word == words.end())
          word = words.insert(word, {slabs[next], {position, 0}});
        word->second.bits |= Vertex_word::Bits(1) << ((begin + next) % Vertex_word::size);
      }
      parcels = Parcels<Vertex_word>(exchange.number_of_ranks(), [&](const auto& visit) {
        for(const Word_of_slab& word : words)
          visit(word.first, word.second);
      });
    });
    std::vector<Vertex_word> received;
    exchange.send(parcels, received);
    exchange.in_agreement([&] {
      for(const Vertex_word& word : received)
        numbering.add(word);
    });
  }
}

// The triangles by the numbers of their vertices on this rank.
template <class Vertex>
Triangles_of<Vertex_index> number_triangles(Triangles_of<Vertex> triangles, const Vertex_numbering& numbering)
{
  const auto numbered = [&](const std::array<Vertex, 3>& t) {
    return std::array<Vertex_index, 3>{numbering[global_vertex(t[0])], numbering[global_vertex(t[1])],
                                       numbering[global_vertex(t[2])]};
  };
  if constexpr(std::is_same_v<Vertex, Vertex_index>)
  {
    std::transform(triangles.begin(), triangles.end(), triangles.begin(), numbered);
    return triangles;
  }
  else
  {
    Triangles_of<Vertex_index> result(triangles.size());
    std::transform(triangles.begin(), triangles.end(), result.begin(), numbered);
    return result;
  }
}

// Counts of what a rank sends and gets when the surface is distributed.
struct Distribution_counts
{
  double slabs_per_triangle_if_all = 1; // that a triangle meets with as many slabs as have been asked for
  std::uint64_t vertices = 0;           // in its slab
  std::uint64_t copies = 0;             // its triangles that a lower rank holds as well
};

// The most slabs that a triangle may meet on average: more memory goes into copies than slabs save. Surfaces of few
// triangles are sliced all the same.
inline constexpr double most_slabs_per_triangle = 2;
inline constexpr std::uint64_t smallest_limited_surface = std::uint64_t(1) << 15;

// Chooses the levels between as many slabs as are asked for, or fewer if a triangle meets too many of them, as on noise.
// Collective.
template <class LocalPart>
Splitters choose_slabs(Exchange& exchange,
                       const LocalPart& part,
                       std::size_t number_of_slabs,
                       Distribution_counts& counts)
{
  if(number_of_slabs == 1)
    return {};
  const auto vertices = sample_vertices(exchange, part.begin, part.scalars, part.number_of_vertices(), number_of_slabs);
  const auto triangles = sample_triangles(exchange, part.ranges, part.triangles, part.number_of_triangles,
                                          [&](Long_index v) { return part.key(v); });
  Splitters splitters = choose_splitters(exchange, vertices, number_of_slabs);
  double crossings = slabs_per_triangle(exchange, triangles, splitters);
  counts.slabs_per_triangle_if_all = crossings;
  while(crossings > most_slabs_per_triangle && part.number_of_triangles >= smallest_limited_surface)
  {
    // A level is crossed by about the same share of the triangles, wherever it is.
    const double crossings_of_level = (crossings - 1) / static_cast<double>(number_of_slabs - 1);
    const std::size_t fitting = 1 + static_cast<std::size_t>((most_slabs_per_triangle - 1) / crossings_of_level);
    number_of_slabs = (std::min)(number_of_slabs - 1, fitting);
    splitters = choose_splitters(exchange, vertices, number_of_slabs);
    crossings = slabs_per_triangle(exchange, triangles, splitters);
  }
  return splitters;
}

// The slabs that each triangle of this rank meets. Collective.
template <class LocalPart>
std::vector<Slab_range> find_slabs_of_triangles(Exchange& exchange,
                                                const LocalPart& part,
                                                const Vertex_numbering& vertices,
                                                const std::vector<Short_slab>& slabs_of_range)
{
  std::vector<Short_slab> slabs;
  ask_owners(
    exchange, part.ranges, vertices,
    [&](Long_index v) { return slabs_of_range[static_cast<std::size_t>(v - part.begin)]; }, slabs);
  std::vector<Slab_range> result;
  exchange.in_agreement([&] {
    result.reserve(part.number_of_local_triangles);
    part.for_each_triangle([&](Long_index a, Long_index b, Long_index c) {
      const auto ends =
        std::minmax({slabs[vertices[a].number()], slabs[vertices[b].number()], slabs[vertices[c].number()]});
      result.push_back({ends.first, ends.second});
    });
  });
  return result;
}

// Fills in the vertices that are numbered, their keys, and on which side of the slab they are. Collective.
template <class LocalPart>
void fill_vertices(Exchange& exchange,
                   const LocalPart& part,
                   const Vertex_numbering& numbering,
                   const Splitters& splitters,
                   Slab_surface& surface)
{
  ask_owners(
    exchange, part.ranges, numbering, [&](Long_index v) { return part.key(v); }, surface.keys);
  exchange.in_agreement([&] {
    surface.global_vertices.reserve(numbering.size());
    surface.slabs_of_vertices.reserve(numbering.size());
    numbering.for_each_word(0, [&](const Vertex_word& word) {
      word.for_each([&](Long_index v) {
        const Order_key place = {surface.keys[surface.global_vertices.end_key()], v};
        const bool is_below = surface.slab != 0 && !(splitters[surface.slab - 1] < place);
        const bool is_above = surface.slab < splitters.size() && splitters[surface.slab] < place;
        surface.global_vertices.push_back(v);
        surface.slabs_of_vertices.push_back(is_below ? surface.below()
                                                     : (is_above ? surface.above() : surface.inside()));
      });
      return true;
    });
  });
}

// Gives each rank the part of the surface that it needs for its slab, of as many slabs as asked for at most. `Vertex`
// is the type of the vertices on the way. Collective.
template <class Vertex, class LocalPart>
Slab_surface exchange_surface(Exchange& exchange,
                              const LocalPart& part,
                              Vertex_numbering vertices,
                              const Splitters& splitters,
                              Distribution_counts& counts)
{
  std::vector<Short_slab> slabs_of_range;
  exchange.in_agreement([&] {
    slabs_of_range.reserve(part.size);
    for(Long_index v = part.begin; v != part.begin + part.size; ++v)
      slabs_of_range.push_back(static_cast<Short_slab>(slab_of(splitters, Order_key{part.key(v), v})));
  });
  std::vector<Slab_range> slabs = find_slabs_of_triangles(exchange, part, vertices, slabs_of_range);
  exchange.in_agreement([&] { vertices = Vertex_numbering(part.number_of_vertices()); });
  send_vertices(exchange, part.begin, slabs_of_range, vertices);
  std::vector<Short_slab>().swap(slabs_of_range);

  Triangle_counts expected;
  for(const Triangle_counts& from_rank : exchange.all_to_all(count_triangles(slabs, exchange.number_of_ranks())))
  {
    expected.triangles += from_rank.triangles;
    expected.copies += from_rank.copies;
  }
  counts.copies = expected.copies;
  exchange.in_agreement([&] { checked_index(static_cast<std::size_t>(3 * expected.triangles)); });

  Slab_surface surface;
  surface.slab = exchange.rank();
  surface.number_of_slabs = splitters.size() + 1;
  if(surface.has_slab() && !surface.is_lowest())
    surface.lower_bound = splitters[surface.slab - 1].key;
  if(surface.has_slab() && !surface.is_highest())
    surface.upper_bound = splitters[surface.slab].key;
  auto received = send_triangles<Vertex>(exchange, part.triangles, slabs, expected.triangles, vertices);
  std::vector<Slab_range>().swap(slabs);
  exchange.in_agreement([&] {
    vertices.number();
    surface.triangles = number_triangles(std::move(received), vertices);
  });
  fill_vertices(exchange, part, vertices, splitters, surface);
  counts.vertices = static_cast<std::uint64_t>(
    std::count(surface.slabs_of_vertices.begin(), surface.slabs_of_vertices.end(), surface.inside()));
  return surface;
}

// Gives each rank the part of the surface that it needs for its slab. There are as many slabs as are asked for and
// ranks are there, or fewer if triangles meet too many slabs; 0 asks for as many as ranks. Collective: what is wrong on
// any rank is thrown on all.
template <class VertexRange, class TriangleRange, class ScalarRange>
Slab_surface distribute_surface(Exchange& exchange,
                                const VertexRange& local_vertices,
                                const TriangleRange& local_triangles,
                                const ScalarRange& local_scalars,
                                std::size_t number_of_slabs,
                                Distribution_counts& counts)
{
  const Local_part<TriangleRange, ScalarRange> part(exchange, local_vertices, local_triangles, local_scalars);
  Vertex_numbering vertices;
  exchange.in_agreement([&] {
    vertices = Vertex_numbering(part.number_of_vertices());
    part.check_scalars();
    part.check_triangles([&](Long_index v) { vertices.add(v); });
    vertices.number();
  });
  const std::size_t most = (std::min)({exchange.number_of_ranks(), most_slabs,
                                       static_cast<std::size_t>((std::max)(part.number_of_vertices(), Long_index(1)))});
  number_of_slabs = number_of_slabs == 0 ? most : (std::min)(number_of_slabs, most);
  const Splitters splitters = choose_slabs(exchange, part, number_of_slabs, counts);
  if(part.number_of_vertices() < no_index)
    return exchange_surface<Vertex_index>(exchange, part, std::move(vertices), splitters, counts);
  return exchange_surface<Long_index>(exchange, part, std::move(vertices), splitters, counts);
}

} // namespace CGAL::Reeb_graph::internal

#endif // CGAL_REEB_GRAPH_DISTRIBUTED_INTERNAL_DISTRIBUTE_SURFACE_H
