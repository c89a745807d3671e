// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
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

// An exception as numbers and text, from which other ranks make their own copy.
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
    catch(const std::exception& error)
    {
      return of(error);
    }
    catch(...)
    {
      return Fault(Kind::OTHER, 0, 0, "an exception that is not a std::exception");
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
    case Kind::INEXACT_SCALAR: throw Inexact_scalar_error(first);
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
    INEXACT_SCALAR,
    VERTEX_OUT_OF_RANGE,
    NON_TRIANGULAR_FACE,
    DEGENERATE_FACE,
    NON_MANIFOLD_EDGE,
    INCONSISTENT_ORIENTATION,
    NON_MANIFOLD_VERTEX
  };

  static Fault of(const std::exception& error)
  {
    if(dynamic_cast<const std::bad_alloc*>(&error) != nullptr)
      return Fault(Kind::BAD_ALLOC);
    if(dynamic_cast<const Cancelled_error*>(&error) != nullptr)
      return Fault(Kind::CANCELLED);
    if(dynamic_cast<const Mesh_size_error*>(&error) != nullptr)
      return Fault(Kind::MESH_SIZE);
    if(const auto* ranges = dynamic_cast<const Vertex_ranges_error*>(&error))
      return Fault(Kind::VERTEX_RANGES, ranges->vertex());
    if(const auto* scalar = dynamic_cast<const Unordered_scalar_error*>(&error))
      return Fault(Kind::UNORDERED_SCALAR, scalar->vertex());
    if(const auto* scalar = dynamic_cast<const Inexact_scalar_error*>(&error))
      return Fault(Kind::INEXACT_SCALAR, scalar->vertex());
    if(const auto* index = dynamic_cast<const Vertex_out_of_range_error*>(&error))
      return Fault(Kind::VERTEX_OUT_OF_RANGE, index->position());
    if(const auto* face = dynamic_cast<const Non_triangular_face_error*>(&error))
      return Fault(Kind::NON_TRIANGULAR_FACE, face->face());
    if(const auto* face = dynamic_cast<const Degenerate_face_error*>(&error))
      return Fault(Kind::DEGENERATE_FACE, face->face());
    if(const auto* edge = dynamic_cast<const Non_manifold_edge_error*>(&error))
      return Fault(Kind::NON_MANIFOLD_EDGE, edge->edge().first, edge->edge().second);
    if(const auto* edge = dynamic_cast<const Inconsistent_orientation_error*>(&error))
      return Fault(Kind::INCONSISTENT_ORIENTATION, edge->edge().first, edge->edge().second);
    if(const auto* vertex = dynamic_cast<const Non_manifold_vertex_error*>(&error))
      return Fault(Kind::NON_MANIFOLD_VERTEX, vertex->vertex());
    return Fault(Kind::OTHER, 0, 0, error.what());
  }

  explicit Fault(Kind kind, std::uint64_t first = 0, std::uint64_t second = 0, const std::string& text = {})
    : numbers_{static_cast<std::uint64_t>(stage_of(kind)), first, second, static_cast<std::uint64_t>(kind)},
      text_(text)
  {}

  // Faults of triangles are all found in one stage, so that the first triangle is named.
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

// Items for all ranks, or from all ranks, in the order of the ranks, and how many there are of each rank. They are sent
// as their bytes.
template <class Item>
struct Parcels
{
  static_assert(std::is_trivially_copyable_v<Item>);

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

  // Calls the function, which must not wait for another rank. If it throws on some ranks, all of them throw the same
  // exception, that with the least index.
  template <class Function>
  void in_agreement(const Function& function) const
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
    throw_first_fault(communicator_, fault, exception);
  }

  // How many items a rank may send in a round, so that the buffers stay small, and the bytes that come to a rank from all
  // others can be counted by an int.
  template <class Item>
  std::size_t most_items_in_round() const
  {
    constexpr std::size_t most_sent = std::size_t(1) << 20, most_received = std::size_t(1) << 30;
    return (std::min)(most_sent, most_received / sizeof(Item) / number_of_ranks());
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
    BOOST_MPI_CHECK_RESULT(
      MPI_Alltoall, (items.data(), sizeof(Item), MPI_BYTE, received.data(), sizeof(Item), MPI_BYTE, communicator_));
    bytes_sent_ += (items.size() - 1) * sizeof(Item);
    return received;
  }

  // Gathers an item of each rank on all ranks.
  template <class Item>
  std::vector<Item> all_gather(const Item& item)
  {
    return all_to_all(std::vector<Item>(number_of_ranks(), item));
  }

  // Sends the parcels, appends the items that come to an array, in the order of the ranks, and returns how many have
  // come from each rank. Those who call bound the sizes: the bytes of all ranks together must not exceed the largest int.
  template <class Item>
  std::vector<int> send(const Parcels<Item>& parcels, std::vector<Item>& received)
  {
    Parcels<Item> incoming(number_of_ranks());
    incoming.counts = all_to_all(parcels.counts);
    const auto in_bytes = [](std::vector<int> numbers) {
      for(int& number : numbers)
        number *= static_cast<int>(sizeof(Item));
      return numbers;
    };
    const std::size_t old_size = received.size();
    in_agreement([&] { received.resize(old_size + number_of_items(incoming)); });
    BOOST_MPI_CHECK_RESULT(MPI_Alltoallv,
                           (parcels.items.data(), in_bytes(parcels.counts).data(), in_bytes(parcels.begins()).data(),
                            MPI_BYTE, received.data() + old_size, in_bytes(incoming.counts).data(),
                            in_bytes(incoming.begins()).data(), MPI_BYTE, communicator_));
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
    const int bytes = static_cast<int>(size * sizeof(Item));
    BOOST_MPI_CHECK_RESULT(MPI_Bcast, (items.data(), bytes, MPI_BYTE, 0, communicator_));
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

} // namespace CGAL::Reeb_graph::internal

#endif // CGAL_REEB_GRAPH_DISTRIBUTED_INTERNAL_EXCHANGE_H
