// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of the CGAL-style package Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_DISTRIBUTED_INTERNAL_PASS_ARRAYS_H
#define CGAL_REEB_GRAPH_DISTRIBUTED_INTERNAL_PASS_ARRAYS_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/distributed/internal/exchange.h>
#include <CGAL/Reeb_graph/visitor.h>

#include <boost/mpi/collectives.hpp>
#include <boost/mpi/exception.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <mpi.h>
#include <numeric>
#include <type_traits>
#include <vector>

namespace CGAL::Reeb_graph::internal {

// Arrays of plain data from rank to rank, of any size. All ranks are taken to store numbers alike. Memory is taken
// before anything is sent, so that all ranks throw if one of them has none.

constexpr int tag_of_arrays = 23;
constexpr int no_rank = MPI_PROC_NULL;

// Sends one array and receives another one, in pieces, as MPI counts by int. Each rank can be no_rank.
template <class T>
void send_and_receive(Exchange& exchange,
                      const T* sent,
                      std::size_t number_of_sent,
                      int to,
                      T* received,
                      std::size_t number_of_received,
                      int from)
{
  static_assert(std::is_trivially_copyable_v<T>);
  if(to != no_rank)
    exchange.count_bytes(number_of_sent * sizeof(T));
  constexpr std::size_t piece = (std::size_t(1) << 26) / sizeof(T);
  for(std::size_t i = 0; i < number_of_sent || i < number_of_received; i += piece)
  {
    const auto bytes = [&](std::size_t size) {
      return i < size ? static_cast<int>((std::min)(piece, size - i) * sizeof(T)) : 0;
    };
    BOOST_MPI_CHECK_RESULT(MPI_Sendrecv, (sent + (std::min)(i, number_of_sent), bytes(number_of_sent), MPI_BYTE,
                                          i < number_of_sent ? to : no_rank, tag_of_arrays,
                                          received + (std::min)(i, number_of_received), bytes(number_of_received),
                                          MPI_BYTE, i < number_of_received ? from : no_rank, tag_of_arrays,
                                          exchange.communicator(), MPI_STATUS_IGNORE));
  }
}

// Gives an array to one rank, and returns that of another one; either can be no_rank. Collective.
template <class T>
std::vector<T> pass_array(Exchange& exchange, const std::vector<T>& array, int to, int from)
{
  const std::uint64_t size = array.size();
  std::uint64_t size_of_received = 0;
  send_and_receive(exchange, &size, 1, to, &size_of_received, from == no_rank ? 0 : 1, from);
  std::vector<T> received;
  exchange.in_agreement([&] { received.resize(size_of_received); });
  send_and_receive(exchange, array.data(), to == no_rank ? 0 : array.size(), to, received.data(), received.size(),
                   from);
  return received;
}

// The arrays of all ranks, one behind the other, and where each begins; and the end.
template <class T>
struct Gathered_arrays
{
  std::vector<T> elements;
  std::vector<std::size_t> begins;
};

// The sizes of the arrays of all ranks as places where they begin, at rank 0. Collective.
inline std::vector<std::size_t> gather_begins(Exchange& exchange, std::size_t size)
{
  std::vector<std::size_t> begins(static_cast<std::size_t>(exchange.communicator().size()) + 1, 0);
  boost::mpi::gather(exchange.communicator(), size, begins.data() + 1, 0);
  std::partial_sum(begins.begin(), begins.end(), begins.begin());
  return begins;
}

// Gathers an array of each rank at rank 0. Collective.
template <class T>
Gathered_arrays<T> gather_arrays(Exchange& exchange, const std::vector<T>& array)
{
  Gathered_arrays<T> gathered = {{}, gather_begins(exchange, array.size())};
  const bool is_root = exchange.communicator().rank() == 0;
  exchange.in_agreement([&] {
    if(is_root)
      gathered.elements.resize(gathered.begins.back());
  });
  if(!is_root)
  {
    send_and_receive<T>(exchange, array.data(), array.size(), 0, nullptr, 0, no_rank);
    return gathered;
  }
  std::copy(array.begin(), array.end(), gathered.elements.begin());
  for(int rank = 1; rank != exchange.communicator().size(); ++rank)
    send_and_receive<T>(exchange, nullptr, 0, no_rank, gathered.elements.data() + gathered.begins[rank],
                        gathered.begins[rank + 1] - gathered.begins[rank], rank);
  return gathered;
}

// The part of a rank of what rank 0 has. Collective.
template <class T>
std::vector<T> scatter_arrays(Exchange& exchange, const Gathered_arrays<T>& all)
{
  std::vector<std::size_t> sizes(exchange.number_of_ranks(), 0);
  if(exchange.rank() == 0)
    for(std::size_t rank = 0; rank != sizes.size(); ++rank)
      sizes[rank] = all.begins[rank + 1] - all.begins[rank];
  const std::size_t size = exchange.all_to_all(sizes).front();
  std::vector<T> part;
  exchange.in_agreement([&] { part.resize(size); });
  if(exchange.communicator().rank() != 0)
  {
    send_and_receive<T>(exchange, nullptr, 0, no_rank, part.data(), part.size(), 0);
    return part;
  }
  std::copy_n(all.elements.begin(), size, part.begin());
  for(int rank = 1; rank != exchange.communicator().size(); ++rank)
    send_and_receive<T>(exchange, all.elements.data() + all.begins[rank], sizes[rank], rank, nullptr, 0, no_rank);
  return part;
}

// The sum of the counts of all ranks. Collective.
inline Critical_vertex_counts sum_counts(Exchange& exchange, const Critical_vertex_counts& own)
{
  typedef std::array<std::uint64_t, 2> Saddles; // their multiplicity, and how many they are
  std::vector<Saddles> saddles;
  exchange.in_agreement([&] { saddles.assign(own.saddles.size(), {}); });
  auto place = saddles.begin();
  for(const auto& [multiplicity, number] : own.saddles)
    *place++ = {multiplicity, number};
  std::vector<Saddles> all_saddles = gather_arrays(exchange, saddles).elements;
  exchange.broadcast(all_saddles);

  Critical_vertex_counts sum;
  exchange.in_agreement([&] {
    for(const auto& [multiplicity, number] : all_saddles)
      sum.saddles[static_cast<std::size_t>(multiplicity)] += static_cast<std::size_t>(number);
  });
  for(const auto& of_rank :
      exchange.all_gather(std::array<std::size_t, 4>{own.isolated, own.minima, own.maxima, own.border_saddles}))
  {
    sum.isolated += of_rank[0];
    sum.minima += of_rank[1];
    sum.maxima += of_rank[2];
    sum.border_saddles += of_rank[3];
  }
  return sum;
}

} // namespace CGAL::Reeb_graph::internal

#endif // CGAL_REEB_GRAPH_DISTRIBUTED_INTERNAL_PASS_ARRAYS_H
