// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_INTERNAL_BASE_PARALLEL_H
#define CGAL_REEB_GRAPH_INTERNAL_BASE_PARALLEL_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/exceptions.h>
#include <CGAL/Reeb_graph/named_parameters.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/tags.h>

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/global_control.h>
#include <tbb/parallel_for.h>
#include <tbb/parallel_invoke.h>
#include <tbb/parallel_sort.h>
#include <tbb/task_arena.h>
#endif

#include <boost/sort/pdqsort/pdqsort.hpp>

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <functional>
#include <iterator>
#include <memory>
#include <mutex>
#include <thread>
#include <type_traits>
#include <vector>

namespace CGAL::Reeb_graph::internal {

// The number of faces below which a second thread does not pay.
inline constexpr std::size_t smallest_parallel_mesh = 20000;

// The few places where the package asks for TBB. With Sequential_tag none of it is needed.
template <class ConcurrencyTag>
constexpr bool is_parallel()
{
#ifndef CGAL_LINKED_WITH_TBB
  static_assert(!std::is_convertible<ConcurrencyTag, Parallel_tag>::value,
                "Parallel_tag needs TBB: link CGAL::TBB_support, or ask for Parallel_if_available_tag.");
#endif
  return std::is_convertible<ConcurrencyTag, Parallel_tag>::value;
}

// Calls function(i) for i from 0 to size - 1. TBB is compiled once for all functions, which makes a tenth less code.
template <class ConcurrencyTag, class Function>
void for_each_index(std::size_t size, const Function& function)
{
  if constexpr(is_parallel<ConcurrencyTag>())
  {
#ifdef CGAL_LINKED_WITH_TBB
    tbb::parallel_for(std::size_t(0), size, std::function<void(std::size_t)>([&](std::size_t i) { function(i); }));
#endif
  }
  else
    for(std::size_t i = 0; i != size; ++i)
      function(i);
}

// A for_each_index() that is chosen at run time, for what is compiled once for all tags.
typedef std::function<void(std::size_t size, const std::function<void(std::size_t)>& function)> Task_runner;

template <class ConcurrencyTag>
Task_runner task_runner()
{
  return [](std::size_t size, const std::function<void(std::size_t)>& function) {
    for_each_index<ConcurrencyTag>(size, function);
  };
}

template <class ConcurrencyTag>
std::size_t number_of_threads()
{
#ifdef CGAL_LINKED_WITH_TBB
  if constexpr(is_parallel<ConcurrencyTag>())
    return (std::min)(static_cast<std::size_t>(tbb::this_task_arena::max_concurrency()),
                      tbb::global_control::active_value(tbb::global_control::max_allowed_parallelism));
#endif
  static_cast<void>(is_parallel<ConcurrencyTag>());
  return 1;
}

// Into how many parts to divide numbers from 0 to size - 1 for for_each_part().
template <class ConcurrencyTag>
std::size_t number_of_parts(std::size_t size, std::size_t smallest_part = 4096)
{
  constexpr std::size_t parts_per_thread = 16; // Some take longer than others, and some threads start late.
  const std::size_t threads = number_of_threads<ConcurrencyTag>();
  return threads == 1 ? 1 : (std::min)(size / smallest_part + 1, parts_per_thread * threads);
}

// Calls function(part, begin, end) for the parts, in which order what they give may be put together again.
template <class ConcurrencyTag, class Function>
void for_each_part(std::size_t number_of_parts, std::size_t size, const Function& function)
{
  for_each_index<ConcurrencyTag>(number_of_parts, [&](std::size_t part) {
    function(part, part * size / number_of_parts, (part + 1) * size / number_of_parts);
  });
}

// Calls function(begin, end) for blocks of the numbers from 0 to size - 1: for all of them at once if sequential.
template <class ConcurrencyTag, class Function>
void for_each_block(std::size_t size, const Function& function)
{
  for_each_part<ConcurrencyTag>(number_of_parts<ConcurrencyTag>(size), size,
                                [&](std::size_t, std::size_t begin, std::size_t end) { function(begin, end); });
}

// The sum to which function(begin, end, sum) adds for the parts of the numbers from 0 to size - 1.
template <class ConcurrencyTag, class Sum, class Function>
Sum sum_of_parts(std::size_t size, const Function& function)
{
  std::vector<Sum> sums(number_of_parts<ConcurrencyTag>(size));
  for_each_part<ConcurrencyTag>(sums.size(), size, [&](std::size_t part, std::size_t begin, std::size_t end) {
    Sum sum = Sum();
    function(begin, end, sum);
    sums[part] = sum;
  });
  Sum result = Sum();
  for(const Sum& sum : sums)
    result += sum;
  return result;
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

// Calls both functions.
template <class ConcurrencyTag, class First, class Second>
void invoke_both(const First& first, const Second& second)
{
  if constexpr(is_parallel<ConcurrencyTag>())
  {
#ifdef CGAL_LINKED_WITH_TBB
    tbb::parallel_invoke(std::function<void()>([&] { first(); }), std::function<void()>([&] { second(); }));
#endif
  }
  else
  {
    first();
    second();
  }
}

// Sorts by a Vertex_order, which has no ties, so that the result is the same in any case. On two threads,
// tbb::parallel_sort is no faster than the other one on one.
template <class ConcurrencyTag, class Iterator, class Less>
void sort(Iterator first, Iterator last, const Less& less)
{
#ifdef CGAL_LINKED_WITH_TBB
  if(is_parallel<ConcurrencyTag>() && number_of_threads<ConcurrencyTag>() > 3)
    return tbb::parallel_sort(first, last, less);
#endif
  boost::sort::pdqsort_branchless(first, last, less);
}

// A part of a constant object that is made when it is asked for first, by whichever thread that is.
template <class T>
class Made_on_demand
{
public:
  // make() is called by the first call only.
  template <class Make>
  const T& operator()(const Make& make) const
  {
    std::call_once(part_->is_made, [&] { part_->value = make(); });
    return part_->value;
  }

private:
  struct Part
  {
    std::once_flag is_made;
    T value;
  };

  std::unique_ptr<Part> part_ = std::make_unique<Part>(); // so that the object can be moved
};

// Tells the named parameter `callback` how far a computation is, and throws Cancelled_error if it wants no more.
class Progress
{
public:
  template <class NamedParameters>
  explicit Progress(const NamedParameters& np)
    : callback_(internal::parameter_or(np, internal_np::callback, No_callback()))
  {}

  void report(double fraction) const
  {
    if(!call(fraction))
      throw Cancelled_error();
  }

  // How far it is where nothing can be cancelled.
  void tell(double fraction) const { call(fraction); }

  // The end: there is nothing left to cancel.
  void report_end() const { tell(1); }

private:
  struct No_callback
  {
    bool operator()(double) const { return true; }
  };

  // Only the thread that the callback is known on calls it, and never with less than before, as stages run side by side.
  bool call(double fraction) const
  {
    if(std::this_thread::get_id() != thread_)
      return true;
    last_ = (std::max)(last_, fraction);
    return callback_(last_);
  }

  std::function<bool(double)> callback_;
  std::thread::id thread_ = std::this_thread::get_id();
  mutable double last_ = 0;
};

// Tells how far a stage is, which begins and ends at fractions of the whole. It refers to the progress of the whole.
class Stage_progress
{
public:
  Stage_progress(const Progress& progress, double begin, double end) : progress_(progress), begin_(begin), end_(end) {}

  // A stage of this stage.
  Stage_progress part(double begin, double end) const { return {progress_, of_whole(begin), of_whole(end)}; }

  void operator()(double fraction) const { progress_.report(of_whole(fraction)); }
  void tell(double fraction) const { progress_.tell(of_whole(fraction)); }

  // Reports before some of the steps of a loop.
  void report_step(std::size_t step, std::size_t number_of_steps) const
  {
    if(step % (number_of_steps / 64 + 1) == 0)
      (*this)(static_cast<double>(step) / static_cast<double>(number_of_steps));
  }

  // The named parameter `callback` of a function that does the stage. It throws Cancelled_error itself, also at the
  // end.
  auto callback() const
  {
    return [stage = *this](double fraction) {
      stage(fraction);
      return true;
    };
  }

private:
  // Not more than the end, so that the fractions of one stage after the other ascend.
  double of_whole(double fraction) const { return (std::min)(end_, begin_ + fraction * (end_ - begin_)); }

  const Progress& progress_;
  double begin_, end_;
};

// Progress that nobody wants to know of.
struct No_progress
{
  void operator()(double) const {}
};

} // namespace CGAL::Reeb_graph::internal

#endif // CGAL_REEB_GRAPH_INTERNAL_BASE_PARALLEL_H
