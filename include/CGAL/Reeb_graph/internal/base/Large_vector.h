// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of the CGAL-style package Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_INTERNAL_BASE_LARGE_VECTOR_H
#define CGAL_REEB_GRAPH_INTERNAL_BASE_LARGE_VECTOR_H

#include <CGAL/license/Reeb_graph.h>

#ifdef __linux__
#include <sys/mman.h>
#endif

#include <cstddef>
#include <limits>
#include <memory>
#include <new>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Reeb_graph {
namespace internal {

// Memory for long arrays. Of a sweep over a million of vertices, half the time was spent on page faults: large pages
// save them where the system has such pages, and elements without a constructor are not written twice.
inline constexpr std::size_t large_page_size = std::size_t(1) << 21;

// Asks for large pages in the part of the memory that they fit into.
inline void advise_large_pages(void* memory, std::size_t size)
{
#ifdef __linux__
  void* begin = memory;
  if(memory != nullptr && std::align(large_page_size, large_page_size, begin, size) != nullptr)
    madvise(begin, size / large_page_size * large_page_size, MADV_HUGEPAGE);
#else
  static_cast<void>(memory);
  static_cast<void>(size);
#endif
}

template <class T>
class Large_page_allocator
{
public:
  typedef T value_type;

  Large_page_allocator() = default;
  template <class U>
  Large_page_allocator(const Large_page_allocator<U>&)
  {}

  T* allocate(std::size_t size)
  {
    if(size > (std::numeric_limits<std::size_t>::max)() / sizeof(T))
      throw std::bad_array_new_length();
    if(!has_large_pages(size))
      return static_cast<T*>(::operator new(size * sizeof(T)));
    void* memory = ::operator new(size * sizeof(T), std::align_val_t(large_page_size));
    advise_large_pages(memory, size * sizeof(T));
    return static_cast<T*>(memory);
  }

  void deallocate(T* memory, std::size_t size)
  {
    if(has_large_pages(size))
      ::operator delete(memory, std::align_val_t(large_page_size));
    else
      ::operator delete(memory);
  }

  template <class U>
  void construct(U* place)
  {
    ::new(static_cast<void*>(place)) U;
  }

  template <class U, class... Arguments>
  void construct(U* place, Arguments&&... arguments)
  {
    ::new(static_cast<void*>(place)) U(std::forward<Arguments>(arguments)...);
  }

  friend bool operator==(const Large_page_allocator&, const Large_page_allocator&) { return true; }
  friend bool operator!=(const Large_page_allocator&, const Large_page_allocator&) { return false; }

private:
  static bool has_large_pages(std::size_t size) { return size * sizeof(T) >= large_page_size; }
};

// resize() leaves new numbers unset: give a value where that matters.
template <class T>
using Large_vector = std::vector<T, Large_page_allocator<T>>;

} // namespace internal
} // namespace Reeb_graph
} // namespace CGAL

#endif // CGAL_REEB_GRAPH_INTERNAL_BASE_LARGE_VECTOR_H
