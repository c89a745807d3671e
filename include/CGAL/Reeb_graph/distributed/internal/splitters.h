// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of the CGAL-style package Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_DISTRIBUTED_INTERNAL_SPLITTERS_H
#define CGAL_REEB_GRAPH_DISTRIBUTED_INTERNAL_SPLITTERS_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/distributed/internal/Slab_surface.h>
#include <CGAL/Reeb_graph/distributed/internal/Vertex_numbering.h>
#include <CGAL/Reeb_graph/distributed/internal/exchange.h>
#include <CGAL/Reeb_graph/internal/base/arrays.h>

#include <boost/mpi/collectives.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <random>
#include <vector>

namespace CGAL {
namespace Reeb_graph {
namespace internal {

// Calls visit(i) for numbers below `size`, of each of `sample_size` equal parts one at random; for all if they are
// fewer.
template <class Visit>
void for_each_of_sample(std::uint64_t size, std::uint64_t sample_size, const Visit& visit)
{
  std::minstd_rand random;
  sample_size = (std::min)(sample_size, size);
  for(std::uint64_t i = 0; i != sample_size; ++i)
  {
    const std::uint64_t begin = i * size / sample_size, end = (i + 1) * size / sample_size;
    visit(begin + random() % (end - begin)); // NOLINT(clang-analyzer-core.DivideZero): parts are not empty
  }
}

// The share of a rank that has `local_size` of `size` things in a sample of all, rounded up.
inline std::uint64_t share_of_sample(std::uint64_t sample_size, std::uint64_t local_size, std::uint64_t size)
{
  if(size <= sample_size)
    return local_size;
  return static_cast<std::uint64_t>(static_cast<double>(local_size) / static_cast<double>(size)
                                    * static_cast<double>(sample_size))
       + (local_size != 0);
}

// Chooses the levels between slabs by a sample of the vertices, so that slabs have about the same number of them.
template <class Scalar>
class Splitter_choice
{
public:
  // The vertices of this rank have the indices from `begin` on, and the given values. Collective.
  template <class Scalars>
  Splitter_choice(Exchange& exchange,
                  Global_vertex begin,
                  const Scalars& scalars,
                  std::uint64_t number_of_vertices,
                  std::size_t number_of_slabs)
  {
    Parcels<Order_key<Scalar>> parcels(exchange.number_of_ranks());
    exchange.in_agreement([&] {
      const std::uint64_t size = static_cast<std::uint64_t>(std::end(scalars) - std::begin(scalars));
      const std::uint64_t sample_size = share_of_sample(size_of_sample(number_of_slabs), size, number_of_vertices);
      for_each_of_sample(size, sample_size, [&](std::uint64_t i) {
        const auto place = std::begin(scalars) + static_cast<std::ptrdiff_t>(i);
        parcels.items.push_back({static_cast<Scalar>(*place), begin + i});
      });
      parcels.counts[0] = static_cast<int>(parcels.items.size());
    });
    exchange.send(parcels, sample_);
    std::sort(sample_.begin(), sample_.end());
  }

  // The same on all ranks. Collective.
  Splitters<Scalar> choose(Exchange& exchange, std::size_t number_of_slabs) const
  {
    Splitters<Scalar> splitters;
    exchange.in_agreement([&] {
      if(exchange.rank() == 0)
        for(std::size_t slab = 1; slab < number_of_slabs; ++slab)
          splitters.push_back(sample_[slab * sample_.size() / number_of_slabs - 1]);
    });
    exchange.broadcast(splitters);
    return splitters;
  }

private:
  // The numbers of vertices of slabs differ by about the square root of this in as many. Rank 0 has room for the
  // sample.
  static std::uint64_t size_of_sample(std::size_t number_of_slabs)
  {
    constexpr std::uint64_t most_per_slab = 2048, least_per_slab = 64, most = std::uint64_t(1) << 22;
    return number_of_slabs * (std::max)(least_per_slab, (std::min)(most_per_slab, most / number_of_slabs));
  }

  std::vector<Order_key<Scalar>> sample_; // at rank 0, ascending
};

// Some triangles, by the places of their vertices, to foresee how many slabs triangles meet.
template <class Scalar>
class Triangle_sample
{
public:
  // value_of(vertex) is asked for vertices of this rank's range. Collective.
  template <class Triangles, class ValueOf>
  Triangle_sample(Exchange& exchange,
                  const Vertex_ranges& ranges,
                  const Triangles& triangles,
                  std::uint64_t number_of_triangles,
                  const ValueOf& value_of)
  {
    std::vector<std::array<Global_vertex, 3>> sample;
    Vertex_numbering vertices;
    exchange.in_agreement([&] {
      vertices = Vertex_numbering(ranges.number_of_vertices());
      const std::uint64_t size = static_cast<std::uint64_t>(std::end(triangles) - std::begin(triangles));
      for_each_of_sample(size, share_of_sample(sample_size, size, number_of_triangles), [&](std::uint64_t i) {
        const auto& triangle = std::begin(triangles)[static_cast<std::ptrdiff_t>(i)];
        sample.push_back({static_cast<Global_vertex>(triangle[0]), static_cast<Global_vertex>(triangle[1]),
                          static_cast<Global_vertex>(triangle[2])});
        for(const Global_vertex vertex : sample.back())
          vertices.add(vertex);
      });
      vertices.number();
    });
    Indexed_vector<Vertex_index, Scalar> values;
    ask_owners(exchange, ranges, vertices, value_of, values);
    exchange.in_agreement([&] {
      const auto place = [&](Global_vertex v) { return Order_key<Scalar>{values[vertices[v]], v}; };
      for(const std::array<Global_vertex, 3>& t : sample)
        triangles_.push_back({place(t[0]), place(t[1]), place(t[2])});
    });
  }

  // How many slabs a triangle meets, on average. Collective.
  double slabs_per_triangle(const Exchange& exchange, const Splitters<Scalar>& splitters) const
  {
    std::array<std::uint64_t, 2> counts = {0, triangles_.size()}, sums = {};
    for(const std::array<Order_key<Scalar>, 3>& triangle : triangles_)
    {
      const auto ends = std::minmax_element(triangle.begin(), triangle.end());
      counts[0] += slab_of(splitters, *ends.second) - slab_of(splitters, *ends.first) + 1;
    }
    boost::mpi::all_reduce(exchange.communicator(), counts.data(), 2, sums.data(), std::plus<std::uint64_t>());
    return sums[1] == 0 ? 1 : static_cast<double>(sums[0]) / static_cast<double>(sums[1]);
  }

private:
  static constexpr std::uint64_t sample_size = std::uint64_t(1) << 15;

  std::vector<std::array<Order_key<Scalar>, 3>> triangles_;
};

} // namespace internal
} // namespace Reeb_graph
} // namespace CGAL

#endif // CGAL_REEB_GRAPH_DISTRIBUTED_INTERNAL_SPLITTERS_H
