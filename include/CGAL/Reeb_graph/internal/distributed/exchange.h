// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of the CGAL-style package Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors
#ifndef CGAL_REEB_GRAPH_INTERNAL_DISTRIBUTED_EXCHANGE_H
#define CGAL_REEB_GRAPH_INTERNAL_DISTRIBUTED_EXCHANGE_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/internal/distributed/agreement.h>

#include <boost/mpi/collectives.hpp>
#include <boost/mpi/communicator.hpp>
#include <boost/mpi/exception.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <type_traits>
#include <vector>

namespace CGAL {
namespace Reeb_graph {
namespace internal {

// MPI's type of items that are sent as their bytes.
template <class Item>
class Item_type
{
  static_assert(std::is_trivially_copyable_v<Item>);

public:
  Item_type()
  {
    BOOST_MPI_CHECK_RESULT(MPI_Type_contiguous, (static_cast<int>(sizeof(Item)), MPI_BYTE, &type_));
    BOOST_MPI_CHECK_RESULT(MPI_Type_commit, (&type_));
  }
  ~Item_type() { MPI_Type_free(&type_); }
  Item_type(const Item_type&) = delete;
  Item_type& operator=(const Item_type&) = delete;

  MPI_Datatype get() const { return type_; }

private:
  MPI_Datatype type_;
};

// Items for all ranks, or from all ranks, in the order of the ranks, and how many there are of each rank.
template <class Item>
struct Parcels
{
  explicit Parcels(std::size_t number_of_ranks) : counts(number_of_ranks, 0) {}

  // for_each_item(visit) calls visit(rank, item), and is called twice.
  template <class ForEachItem>
  Parcels(std::size_t number_of_ranks, const ForEachItem& for_each_item) : Parcels(number_of_ranks)
  {
    for_each_item([&](std::size_t rank, const Item&) { ++counts[rank]; });
    std::vector<int> ends = begins();
    items.resize(static_cast<std::size_t>(ends.back()) + static_cast<std::size_t>(counts.back()));
    for_each_item([&](std::size_t rank, const Item& item) { items[static_cast<std::size_t>(ends[rank]++)] = item; });
  }

  // Where the items of each rank begin.
  std::vector<int> begins() const
  {
    std::vector<int> result(counts.size(), 0);
    std::partial_sum(counts.begin(), counts.end() - 1, result.begin() + 1);
    return result;
  }

  std::vector<Item> items;
  std::vector<int> counts;
};

// Exchanges arrays among all ranks, and counts what leaves this one. All of its functions are collective.
class Exchange
{
public:
  explicit Exchange(const boost::mpi::communicator& communicator) : communicator_(communicator) {}

  const boost::mpi::communicator& communicator() const { return communicator_; }
  std::size_t number_of_ranks() const { return static_cast<std::size_t>(communicator_.size()); }
  std::size_t rank() const { return static_cast<std::size_t>(communicator_.rank()); }
  std::uint64_t bytes_sent() const { return bytes_sent_; }
  void count_bytes(std::size_t number) { bytes_sent_ += number; }

  template <class Function>
  void in_agreement(const Function& function) const
  {
    run_in_agreement(communicator_, function);
  }

  // How many items a rank may send in a round, so that the buffers stay small, and what comes to a rank from all others
  // can be counted by an int.
  std::size_t most_items_in_round() const
  {
    constexpr std::size_t most_sent = std::size_t(1) << 20, most_received = std::size_t(1) << 30;
    return (std::min)(most_sent, most_received / number_of_ranks());
  }

  // Whether this is so on any rank.
  bool is_on_any_rank(bool value) const
  {
    return boost::mpi::all_reduce(communicator_, static_cast<int>(value), boost::mpi::maximum<int>()) != 0;
  }

  // One item for each rank against one from each rank.
  template <class Item>
  std::vector<Item> all_to_all(const std::vector<Item>& items)
  {
    std::vector<Item> received(items.size());
    const Item_type<Item> type;
    BOOST_MPI_CHECK_RESULT(MPI_Alltoall, (items.data(), 1, type.get(), received.data(), 1, type.get(), communicator_));
    bytes_sent_ += (items.size() - 1) * sizeof(Item);
    return received;
  }

  // The same items on all ranks: those of each rank.
  template <class Item>
  std::vector<Item> all_gather(const Item& item)
  {
    return all_to_all(std::vector<Item>(number_of_ranks(), item));
  }

  // Sends the parcels, appends the items that come to an array, in the order of the ranks, and returns how many have
  // come from each rank. Those who call bound the sizes; the sum over all ranks must not exceed the largest int.
  template <class Item>
  std::vector<int> send(const Parcels<Item>& parcels, std::vector<Item>& received)
  {
    Parcels<Item> incoming(number_of_ranks());
    incoming.counts = all_to_all(parcels.counts);
    const std::vector<int> incoming_begins = incoming.begins(), begins = parcels.begins();
    const std::size_t old_size = received.size();
    in_agreement([&] { received.resize(old_size + number_of_items(incoming)); });
    const Item_type<Item> type;
    BOOST_MPI_CHECK_RESULT(MPI_Alltoallv, (parcels.items.data(), parcels.counts.data(), begins.data(), type.get(),
                                           received.data() + old_size, incoming.counts.data(), incoming_begins.data(),
                                           type.get(), communicator_));
    const std::size_t sent = number_of_items(parcels) - static_cast<std::size_t>(parcels.counts[rank()]);
    bytes_sent_ += sent * sizeof(Item);
    return incoming.counts;
  }

  // Replaces the items of all ranks by those of rank 0.
  template <class Item>
  void broadcast(std::vector<Item>& items)
  {
    std::size_t size = items.size();
    boost::mpi::broadcast(communicator_, size, 0);
    in_agreement([&] { items.resize(size); });
    const Item_type<Item> type;
    BOOST_MPI_CHECK_RESULT(MPI_Bcast, (items.data(), static_cast<int>(size), type.get(), 0, communicator_));
  }

private:
  template <class Item>
  static std::size_t number_of_items(const Parcels<Item>& parcels)
  {
    return std::accumulate(parcels.counts.begin(), parcels.counts.end(), std::size_t(0),
                           [](std::size_t sum, int count) { return sum + static_cast<std::size_t>(count); });
  }

  boost::mpi::communicator communicator_;
  std::uint64_t bytes_sent_ = 0;
};

} // namespace internal
} // namespace Reeb_graph
} // namespace CGAL

#endif // CGAL_REEB_GRAPH_INTERNAL_DISTRIBUTED_EXCHANGE_H
