// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_INTERNAL_BASE_THREADS_H
#define CGAL_REEB_GRAPH_INTERNAL_BASE_THREADS_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/tags.h>

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/global_control.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>
#endif

#include <boost/sort/pdqsort/pdqsort.hpp>

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <functional>
#include <type_traits>
#include <vector>

namespace CGAL::Reeb_graph::internal {

// The number of faces below which a second thread does not pay.
inline constexpr std::size_t smallest_parallel_mesh = 20000;

// The threads that share a work. A function with a tag makes them of it, by threads_of(): nothing behind it depends on
// the tag, or asks for TBB.
class Threads
{
public:
  typedef void (*Run)(std::size_t size, const std::function<void(std::size_t)>& function);
  typedef std::size_t (*Number)();

  // The calling thread alone.
  Threads() = default;

  Threads(Run run, Number number) : run_(run), number_(number) {}

  bool are_parallel() const { return run_ != nullptr; }
  std::size_t number() const { return are_parallel() ? number_() : 1; }

  // Calls function(i) for i from 0 to size - 1.
  void for_each_index(std::size_t size, const std::function<void(std::size_t)>& function) const
  {
    if(are_parallel())
      return run_(size, function);
    for(std::size_t i = 0; i != size; ++i)
      function(i);
  }

  // Into how many parts to divide numbers from 0 to size - 1 for for_each_part().
  std::size_t number_of_parts(std::size_t size, std::size_t smallest_part = 4096) const
  {
    constexpr std::size_t parts_per_thread = 16; // Some take longer than others, and some threads start late.
    const std::size_t threads = number();
    return threads == 1 ? 1 : (std::min)(size / smallest_part + 1, parts_per_thread * threads);
  }

  // Calls function(part, begin, end) for the parts, in which order what they give may be put together again.
  template <class Function>
  void for_each_part(std::size_t number_of_parts, std::size_t size, const Function& function) const
  {
    for_each_index(number_of_parts, [&](std::size_t part) {
      function(part, part * size / number_of_parts, (part + 1) * size / number_of_parts);
    });
  }

  // Calls function(begin, end) for blocks of the numbers from 0 to size - 1: for all of them at once if sequential.
  template <class Function>
  void for_each_block(std::size_t size, const Function& function) const
  {
    for_each_part(number_of_parts(size), size,
                  [&](std::size_t, std::size_t begin, std::size_t end) { function(begin, end); });
  }

  // Calls function(key) for the keys, or the numbers, from 0 to size - 1.
  template <class Key, class Function>
  void for_each(std::size_t size, const Function& function) const
  {
    for_each_block(size, [&](std::size_t begin, std::size_t end) {
      for(std::size_t i = begin; i != end; ++i)
        function(Key(i));
    });
  }

  // The sum to which function(begin, end, sum) adds for the parts of the numbers from 0 to size - 1.
  template <class Sum, class Function>
  Sum sum_of_parts(std::size_t size, const Function& function) const
  {
    std::vector<Sum> sums(number_of_parts(size));
    for_each_part(sums.size(), size, [&](std::size_t part, std::size_t begin, std::size_t end) {
      Sum sum = Sum();
      function(begin, end, sum);
      sums[part] = sum;
    });
    Sum result = Sum();
    for(const Sum& sum : sums)
      result += sum;
    return result;
  }

  // Calls both functions.
  template <class First, class Second>
  void invoke_both(const First& first, const Second& second) const
  {
    for_each_index(2, [&](std::size_t i) { i == 0 ? first() : second(); });
  }

private:
  Run run_ = nullptr;
  Number number_ = nullptr;
};

#ifdef CGAL_LINKED_WITH_TBB
inline void run_on_tbb(std::size_t size, const std::function<void(std::size_t)>& function)
{
  tbb::parallel_for(std::size_t(0), size, function);
}

inline std::size_t number_of_tbb_threads()
{
  return (std::min)(static_cast<std::size_t>(tbb::this_task_arena::max_concurrency()),
                    tbb::global_control::active_value(tbb::global_control::max_allowed_parallelism));
}
#endif

// The only place where the package asks for TBB. With Sequential_tag none of it is needed.
template <class ConcurrencyTag>
Threads threads_of()
{
  if constexpr(std::is_convertible_v<ConcurrencyTag, Parallel_tag>)
  {
#ifdef CGAL_LINKED_WITH_TBB
    return {run_on_tbb, number_of_tbb_threads};
#else
    static_assert(!std::is_convertible_v<ConcurrencyTag, Parallel_tag>,
                  "Parallel_tag needs TBB: link CGAL::TBB_support, or ask for Parallel_if_available_tag.");
#endif
  }
  return {};
}

// Sorts by an order without ties, so that the result is the same in any case. On up to three threads, parts and their
// merging take as long as the whole on one.
template <class Iterator, class Less>
void sort(const Threads& threads, Iterator first, Iterator last, const Less& less)
{
  const std::size_t size = static_cast<std::size_t>(last - first), number_of_threads = threads.number();
  std::size_t number_of_parts = 1; // a power of two
  while(4 <= number_of_threads && 2 * number_of_parts <= number_of_threads && number_of_parts < size / 4096)
    number_of_parts *= 2;
  const auto end_of = [=](std::size_t part) { return first + part * size / number_of_parts; };
  threads.for_each_index(
    number_of_parts, [&](std::size_t part) { boost::sort::pdqsort_branchless(end_of(part), end_of(part + 1), less); });
  for(std::size_t width = 1; width != number_of_parts; width *= 2)
    threads.for_each_index(number_of_parts / (2 * width), [&](std::size_t pair) {
      const std::size_t part = 2 * width * pair;
      std::inplace_merge(end_of(part), end_of(part + width), end_of(part + 2 * width), less);
    });
}

// A number that threads can read and write at once if it does not matter who comes first.
template <class T>
class Relaxed_value
{
public:
  T get() const { return value_.load(std::memory_order_relaxed); }
  void set(T value) { value_.store(value, std::memory_order_relaxed); }

private:
  std::atomic<T> value_{T()};
};

} // namespace CGAL::Reeb_graph::internal

#endif // CGAL_REEB_GRAPH_INTERNAL_BASE_THREADS_H
