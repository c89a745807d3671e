// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of the CGAL-style package Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_INTERNAL_BASE_ZEROED_ARRAY_H
#define CGAL_REEB_GRAPH_INTERNAL_BASE_ZEROED_ARRAY_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/internal/base/tuning.h>

#include <cstddef>
#include <cstdlib>
#include <memory>
#include <new>
#include <type_traits>

namespace CGAL {
namespace Reeb_graph {
namespace internal {

// An array of zeros, for few of which another value comes: most systems let the pages where none does take neither
// memory nor time. For numbers, whose zero has no bit set, and which need no constructor.
template <class Key, class T>
class Zeroed_array
{
  static_assert(std::is_trivial_v<T>);

public:
  explicit Zeroed_array(std::size_t size) : elements_(static_cast<T*>(std::calloc(size, sizeof(T))))
  {
    if(elements_ == nullptr && size != 0)
      throw std::bad_alloc();
    if(!is_used(Tuned_part::ZEROED_ARRAY))
      touch(size);
  }

  T& operator[](Key key) { return elements_.get()[key.number()]; }
  const T& operator[](Key key) const { return elements_.get()[key.number()]; }

private:
  // What other arrays do: each line of the cache is written. Compilers know that calloc() leaves zeros, and drop a
  // memset().
  void touch(std::size_t size)
  {
    constexpr std::size_t line = 64;
    volatile char* const bytes = reinterpret_cast<volatile char*>(elements_.get());
    for(std::size_t i = 0; i < size * sizeof(T); i += line)
      bytes[i] = 0;
  }

  struct Free
  {
    void operator()(T* elements) const { std::free(elements); }
  };

  std::unique_ptr<T, Free> elements_;
};

} // namespace internal
} // namespace Reeb_graph
} // namespace CGAL

#endif // CGAL_REEB_GRAPH_INTERNAL_BASE_ZEROED_ARRAY_H
