// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of the CGAL-style package Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_DISTRIBUTED_INTERNAL_EXCHANGE_H
#define CGAL_REEB_GRAPH_DISTRIBUTED_INTERNAL_EXCHANGE_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/distributed/exceptions.h>
#include <CGAL/Reeb_graph/exceptions.h>

#include <boost/mpi/collectives.hpp>
#include <boost/mpi/communicator.hpp>
#include <boost/mpi/exception.hpp>

#include <algorithm>
#include <array>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <exception>
#include <mpi.h>
#include <new>
#include <numeric>
#include <string>
#include <thread>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL::Reeb_graph::internal {

// Waits until a request is done. MPI itself would keep the core busy, which another rank may need, and which counts as
// work done; whoever waits for longer than a message takes sleeps now and then.
inline void wait_for(MPI_Request& request)
{
  constexpr int tests_without_sleep = 200;
  constexpr std::chrono::microseconds longest_sleep(1000);
  std::chrono::microseconds sleep(20);
  int is_done = 0;
  for(int tests = 0; true; ++tests)
  {
    BOOST_MPI_CHECK_RESULT(MPI_Test, (&request, &is_done, MPI_STATUS_IGNORE));
    if(is_done != 0)
      return;
    if(tests < tests_without_sleep)
      continue;
    std::this_thread::sleep_for(sleep);
    sleep = (std::min)(2 * sleep, longest_sleep);
  }
}

// What can be told to other ranks of an exception, from which they make their own copy.
class Fault
{
public:
  // Its place among all faults of all ranks, lexicographically: the stage that finds it, indices, and its kind.
  typedef std::array<std::uint64_t, 4> Numbers;

  Fault() = default;

  const Numbers& numbers() const { return numbers_; }
  const std::string& text() const { return text_; }

  // Called in a handler.
  static Fault of_current_exception()
  {
    try
    {
      throw;
    }
    catch(const std::bad_alloc&)
    {
      return Fault(Kind::BAD_ALLOC);
    }
    catch(const Cancelled_error&)
    {
      return Fault(Kind::CANCELLED);
    }
    catch(const Mesh_size_error&)
    {
      return Fault(Kind::MESH_SIZE);
    }
    catch(const Vertex_ranges_error& error)
    {
      return Fault(Kind::VERTEX_RANGES, error.vertex());
    }
    catch(const Unordered_scalar_error& error)
    {
      return Fault(Kind::UNORDERED_SCALAR, error.vertex());
    }
    catch(const Vertex_out_of_range_error& error)
    {
      return Fault(Kind::VERTEX_OUT_OF_RANGE, error.position());
    }
    catch(const Non_triangular_face_error& error)
    {
      return Fault(Kind::NON_TRIANGULAR_FACE, error.face());
    }
    catch(const Degenerate_face_error& error)
    {
      return Fault(Kind::DEGENERATE_FACE, error.face());
    }
    catch(const Non_manifold_edge_error& error)
    {
      return Fault(Kind::NON_MANIFOLD_EDGE, error.edge().first, error.edge().second);
    }
    catch(const Inconsistent_orientation_error& error)
    {
      return Fault(Kind::INCONSISTENT_ORIENTATION, error.edge().first, error.edge().second);
    }
    catch(const Non_manifold_vertex_error& error)
    {
      return Fault(Kind::NON_MANIFOLD_VERTEX, error.vertex());
    }
    catch(const std::exception& error)
    {
      return Fault(Kind::OTHER, 0, 0, error.what());
    }
    catch(...)
    {
      return Fault(Kind::OTHER, 0, 0, "an exception that is no std::exception");
    }
  }

  // The rank with the first fault, if each has given its numbers; the lowest one if several have the same.
  static int rank_of_first(const std::vector<std::uint64_t>& numbers_of_ranks)
  {
    int first = 0;
    for(std::size_t rank = 1; rank != numbers_of_ranks.size() / size; ++rank)
      if(numbers_at(static_cast<int>(rank), numbers_of_ranks) < numbers_at(first, numbers_of_ranks))
        first = static_cast<int>(rank);
    return first;
  }

  // Throws a copy of the exception of a rank.
  [[noreturn]] static void rethrow(int rank,
                                   const std::vector<std::uint64_t>& numbers_of_ranks,
                                   const std::string& text)
  {
    const Numbers numbers = numbers_at(rank, numbers_of_ranks);
    const std::size_t first = static_cast<std::size_t>(numbers[1]), second = static_cast<std::size_t>(numbers[2]);
    switch(static_cast<Kind>(numbers[3]))
    {
    case Kind::BAD_ALLOC: throw std::bad_alloc();
    case Kind::CANCELLED: throw Cancelled_error();
    case Kind::MESH_SIZE: throw Mesh_size_error();
    case Kind::VERTEX_RANGES: throw Vertex_ranges_error(first);
    case Kind::UNORDERED_SCALAR: throw Unordered_scalar_error(first);
    case Kind::VERTEX_OUT_OF_RANGE: throw Vertex_out_of_range_error("face", first);
    case Kind::NON_TRIANGULAR_FACE: throw Non_triangular_face_error(first);
    case Kind::DEGENERATE_FACE: throw Degenerate_face_error(first);
    case Kind::NON_MANIFOLD_EDGE: throw Non_manifold_edge_error({first, second});
    case Kind::INCONSISTENT_ORIENTATION: throw Inconsistent_orientation_error({first, second});
    case Kind::NON_MANIFOLD_VERTEX: throw Non_manifold_vertex_error(first);
    case Kind::OTHER: break;
    }
    throw Other_rank_error(rank, text);
  }

private:
  static constexpr std::size_t size = std::tuple_size<Numbers>::value;

  // The kinds, in the order of the stages that find them.
  enum class Kind : std::uint64_t
  {
    BAD_ALLOC,
    OTHER,
    CANCELLED,
    MESH_SIZE,
    VERTEX_RANGES,
    UNORDERED_SCALAR,
    VERTEX_OUT_OF_RANGE,
    NON_TRIANGULAR_FACE,
    DEGENERATE_FACE,
    NON_MANIFOLD_EDGE,
    INCONSISTENT_ORIENTATION,
    NON_MANIFOLD_VERTEX
  };

  explicit Fault(Kind kind, std::uint64_t first = 0, std::uint64_t second = 0, const std::string& text = {})
    : numbers_{static_cast<std::uint64_t>(stage_of(kind)), first, second, static_cast<std::uint64_t>(kind)},
      text_(text)
  {}

  // What is wrong with a triangle is all found in one stage, so that the first triangle is named.
  static Kind stage_of(Kind kind)
  {
    return kind == Kind::NON_TRIANGULAR_FACE || kind == Kind::DEGENERATE_FACE ? Kind::VERTEX_OUT_OF_RANGE : kind;
  }

  static Numbers numbers_at(int rank, const std::vector<std::uint64_t>& numbers_of_ranks)
  {
    Numbers numbers;
    std::copy_n(numbers_of_ranks.begin() + rank * static_cast<std::ptrdiff_t>(size), size, numbers.begin());
    return numbers;
  }

  Numbers numbers_ = {~std::uint64_t(0), 0, 0, 0}; // no fault comes behind all others
  std::string text_;
};

// Throws on all ranks the first of the faults that some of them have: a copy where it is another rank's. Collective.
inline void throw_first_fault(const boost::mpi::communicator& communicator,
                              const Fault& own,
                              const std::exception_ptr& own_exception)
{
  namespace mpi = boost::mpi;
  const int is_thrown = own_exception != nullptr ? 1 : 0;
  int is_thrown_anywhere = 0;
  MPI_Request request = MPI_REQUEST_NULL;
  BOOST_MPI_CHECK_RESULT(MPI_Iallreduce,
                         (&is_thrown, &is_thrown_anywhere, 1, MPI_INT, MPI_MAX, communicator, &request));
  wait_for(request); // Most waiting for ranks with more work is here.
  if(is_thrown_anywhere == 0)
    return;
  const auto numbers = own.numbers();
  std::vector<Fault::Numbers::value_type> all(numbers.size() * static_cast<std::size_t>(communicator.size()));
  mpi::all_gather(communicator, numbers.data(), static_cast<int>(numbers.size()), all.data());
  const int rank = Fault::rank_of_first(all);
  std::string text = own.text();
  mpi::broadcast(communicator, text, rank);
  if(rank == communicator.rank())
    std::rethrow_exception(own_exception);
  Fault::rethrow(rank, all, text);
}

// Calls the function, which must not wait for another rank. If it throws on some ranks, all of them throw the same
// exception, that with the least index. Collective.
template <class Function>
void run_in_agreement(const boost::mpi::communicator& communicator, const Function& function)
{
  std::exception_ptr exception;
  Fault fault;
  try
  {
    function();
  }
  catch(...)
  {
    exception = std::current_exception();
    fault = Fault::of_current_exception();
  }
  throw_first_fault(communicator, fault, exception);
}

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

} // namespace CGAL::Reeb_graph::internal

#endif // CGAL_REEB_GRAPH_DISTRIBUTED_INTERNAL_EXCHANGE_H
