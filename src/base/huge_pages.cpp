// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

// Lets large arrays have huge pages where the system has them for those who ask. To touch a new page for the first time
// costs more than to write what is in it: without them, the program takes 15 to 70 percent longer. Most are those of a
// Surface_mesh, which has no allocator to choose.

#if defined(__linux__) && !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
#ifdef __has_feature
#if __has_feature(address_sanitizer) || __has_feature(thread_sanitizer)
#define REEB_GRAPH_IS_SANITIZED
#endif
#endif

#ifndef REEB_GRAPH_IS_SANITIZED
#include <sys/mman.h>

#include <cstddef>
#include <cstdlib>
#include <new>

namespace {
void* allocate(std::size_t size) noexcept
{
  constexpr std::size_t huge_page = std::size_t(1) << 21, smallest_array = 2 * huge_page;
  if(size < smallest_array || size > static_cast<std::size_t>(-1) - huge_page)
    return std::malloc(size > 0 ? size : 1);
  const std::size_t rounded_size = (size + huge_page - 1) / huge_page * huge_page;
  void* const array = std::aligned_alloc(huge_page, rounded_size);
  if(array != nullptr)
    madvise(array, rounded_size, MADV_HUGEPAGE); // Without them, nothing is lost but time.
  return array;
}
} // namespace

void* operator new(std::size_t size)
{
  while(true)
  {
    if(void* const array = allocate(size))
      return array;
    const std::new_handler handler = std::get_new_handler();
    if(handler == nullptr)
      throw std::bad_alloc();
    handler();
  }
}

void operator delete(void* array) noexcept { std::free(array); }
void operator delete(void* array, std::size_t) noexcept { std::free(array); }
#endif
#endif
