// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_INTERNAL_ENGINE_GRAPH_STORAGE_H
#define CGAL_REEB_GRAPH_INTERNAL_ENGINE_GRAPH_STORAGE_H

#include <CGAL/license/Reeb_graph.h>

#include <boost/container/small_vector.hpp>
#include <boost/graph/adjacency_list.hpp>
#include <boost/pending/container_traits.hpp>
#include <boost/pool/pool.hpp>

#include <cstddef>
#include <forward_list>
#include <list>
#include <memory>
#include <new>
#include <type_traits>
#include <utility>

// How a Reeb graph is stored: with the containers that are usual for an adjacency list, the many arcs of a noisy field
// would take most of the time that the whole graph takes, for allocations and new pages of memory.

namespace CGAL::Reeb_graph::internal {

// The arcs at one side of a node. There are rarely more than two of them.
template <class T>
class Inline_edge_list : public boost::container::small_vector<T, 2>
{
};

// How Boost.Graph is told to handle a container of its users as a vector.
template <class T>
boost::graph_detail::vector_tag container_category(const Inline_edge_list<T>&)
{
  return boost::graph_detail::vector_tag();
}
template <class T>
boost::graph_detail::unstable_tag iterator_stability(const Inline_edge_list<T>&)
{
  return boost::graph_detail::unstable_tag();
}

// The large blocks from which the allocators of one container take single objects, of one size or of several.
class Block_pools
{
  // The number of objects in a block, which is written to when it is taken.
  static constexpr std::size_t smallest_block = 8, largest_block = 100000;

public:
  typedef boost::pool<boost::default_user_allocator_malloc_free> Pool;

  Pool& pool_of(std::size_t size_of_object)
  {
    for(Pool& pool : pools_)
    {
      if(pool.get_requested_size() == size_of_object)
        return pool;
    }
    return pools_.emplace_front(size_of_object, +smallest_block, +largest_block);
  }

private:
  std::forward_list<Pool> pools_; // a few, which stay where they are
};

// Takes single objects from blocks. Copied allocators share them, those for other types, too; copied containers do not.
template <class T>
class Block_allocator
{
  template <class U>
  friend class Block_allocator;

public:
  typedef T value_type;
  typedef std::true_type propagate_on_container_move_assignment;
  typedef std::true_type propagate_on_container_swap;
  typedef std::false_type is_always_equal;

  Block_allocator() : Block_allocator(std::make_shared<Block_pools>()) {}
  Block_allocator(const Block_allocator&) = default; // and no move, which would leave an allocator without a pool
  Block_allocator& operator=(const Block_allocator&) = default;
  template <class U>
  Block_allocator(const Block_allocator<U>& other) : Block_allocator(other.pools_)
  {}

  Block_allocator select_on_container_copy_construction() const { return Block_allocator(); }

  T* allocate(std::size_t size)
  {
    if(size != 1)
      return std::allocator<T>().allocate(size);
    void* place = (pool_->malloc)();
    if(place == nullptr)
      throw std::bad_alloc();
    return static_cast<T*>(place);
  }

  void deallocate(T* place, std::size_t size)
  {
    if(size != 1)
      std::allocator<T>().deallocate(place, size);
    else
      (pool_->free)(place);
  }

  template <class U>
  bool operator==(const Block_allocator<U>& other) const
  {
    return pools_ == other.pools_;
  }
  template <class U>
  bool operator!=(const Block_allocator<U>& other) const
  {
    return !(*this == other);
  }

private:
  explicit Block_allocator(std::shared_ptr<Block_pools> pools)
    : pools_(std::move(pools)),
      pool_(&pools_->pool_of(sizeof(T)))
  {}

  std::shared_ptr<Block_pools> pools_;
  Block_pools::Pool* pool_; // that of the objects
};

struct Inline_edge_list_selector
{
};
struct Block_list_selector
{
};

} // namespace CGAL::Reeb_graph::internal

namespace boost {

template <class T>
struct container_gen<CGAL::Reeb_graph::internal::Inline_edge_list_selector, T>
{
  typedef CGAL::Reeb_graph::internal::Inline_edge_list<T> type;
};

template <>
struct parallel_edge_traits<CGAL::Reeb_graph::internal::Inline_edge_list_selector>
{
  typedef allow_parallel_edge_tag type;
};

template <class T>
struct container_gen<CGAL::Reeb_graph::internal::Block_list_selector, T>
{
  typedef std::list<T, CGAL::Reeb_graph::internal::Block_allocator<T>> type;
};

} // namespace boost

#endif // CGAL_REEB_GRAPH_INTERNAL_ENGINE_GRAPH_STORAGE_H
