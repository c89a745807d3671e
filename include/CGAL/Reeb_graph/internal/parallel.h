// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of the CGAL-style package Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_INTERNAL_PARALLEL_H
#define CGAL_REEB_GRAPH_INTERNAL_PARALLEL_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/tags.h>

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/parallel_for.h>
#include <tbb/parallel_invoke.h>
#include <tbb/parallel_sort.h>
#endif

#include <algorithm>
#include <cstddef>
#include <type_traits>

namespace CGAL {
namespace Reeb_graph {
namespace internal {

// The few places where the package asks for TBB. With Sequential_tag none of it is needed.
template <class ConcurrencyTag>
constexpr bool is_parallel()
{
#ifndef CGAL_LINKED_WITH_TBB
  static_assert(!std::is_convertible<ConcurrencyTag, Parallel_tag>::value,
                "Parallel_tag is enabled but TBB is unavailable.");
  return false;
#else
  return std::is_convertible<ConcurrencyTag, Parallel_tag>::value;
#endif
}

// Calls function(i) for i from 0 to size - 1.
template <class ConcurrencyTag, class Function>
void for_each_index(std::size_t size, const Function& function)
{
#ifdef CGAL_LINKED_WITH_TBB
  if constexpr(is_parallel<ConcurrencyTag>())
  {
    tbb::parallel_for(std::size_t(0), size, function);
    return;
  }
#endif
  static_cast<void>(is_parallel<ConcurrencyTag>());
  for(std::size_t i = 0; i != size; ++i)
    function(i);
}

// Sorts by an order without ties, so that the result is the same in any case.
template <class ConcurrencyTag, class Iterator, class Less>
void sort(Iterator first, Iterator last, const Less& less)
{
#ifdef CGAL_LINKED_WITH_TBB
  if constexpr(is_parallel<ConcurrencyTag>())
  {
    tbb::parallel_sort(first, last, less);
    return;
  }
#endif
  static_cast<void>(is_parallel<ConcurrencyTag>());
  std::sort(first, last, less);
}

// Calls both functions.
template <class ConcurrencyTag, class First, class Second>
void invoke_both(const First& first, const Second& second)
{
#ifdef CGAL_LINKED_WITH_TBB
  if constexpr(is_parallel<ConcurrencyTag>())
  {
    tbb::parallel_invoke(first, second);
    return;
  }
#endif
  static_cast<void>(is_parallel<ConcurrencyTag>());
  first();
  second();
}

} // namespace internal
} // namespace Reeb_graph
} // namespace CGAL

#endif // CGAL_REEB_GRAPH_INTERNAL_PARALLEL_H
