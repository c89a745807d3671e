// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of the CGAL-style package Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_DISTRIBUTED_INTERNAL_SEND_TRIANGLES_H
#define CGAL_REEB_GRAPH_DISTRIBUTED_INTERNAL_SEND_TRIANGLES_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/distributed/internal/Slab_surface.h>
#include <CGAL/Reeb_graph/distributed/internal/Vertex_numbering.h>
#include <CGAL/Reeb_graph/distributed/internal/exchange.h>
#include <CGAL/Reeb_graph/internal/base/Index.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Reeb_graph {
namespace internal {

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
inline Global_vertex global_vertex(Vertex_index vertex) { return vertex.number(); }
inline Global_vertex global_vertex(Global_vertex vertex) { return vertex; }

template <class Vertex>
using Triangles_of = std::vector<std::array<Vertex, 3>>;

// What each rank will get of the triangles of this one.
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
      const std::size_t end = end_of_round(slabs, begin, exchange.most_items_in_round());
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
                          Global_vertex begin,
                          const std::vector<Short_slab>& slabs,
                          Vertex_numbering& numbering)
{
  const std::size_t most_vertices = exchange.most_items_in_round();
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

} // namespace internal
} // namespace Reeb_graph
} // namespace CGAL

#endif // CGAL_REEB_GRAPH_DISTRIBUTED_INTERNAL_SEND_TRIANGLES_H
