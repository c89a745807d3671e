// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_BENCHMARK_WORK_AND_SPAN_H
#define CGAL_REEB_GRAPH_BENCHMARK_WORK_AND_SPAN_H

#include <algorithm>
#include <array>
#include <chrono>
#include <cstddef>
#include <iterator>
#include <utility>

// Stands in for those parts of TBB that the package uses: runs everything on one thread, and adds up how long it would
// take on several ones whose memory is as fast as that of one.
namespace benchmark {
// The milliseconds that something takes with one thread, with Meter::number_of_threads, and with any number of them.
struct Work_and_span
{
  double work = 0, forecast = 0, span = 0;

  // What comes one after the other.
  Work_and_span& operator+=(const Work_and_span& other)
  {
    work += other.work;
    forecast += other.forecast;
    span += other.span;
    return *this;
  }
};

inline Work_and_span operator-(const Work_and_span& a, const Work_and_span& b)
{
  return {a.work - b.work, a.forecast - b.forecast, a.span - b.span};
}

class Meter
{
public:
  inline static std::size_t number_of_threads = 1;

  // What has been spent since the program began, in the task that runs now.
  static Work_and_span spent()
  {
    const auto now = std::chrono::steady_clock::now();
    const double time = std::chrono::duration<double, std::milli>(now - last_look_).count();
    last_look_ = now;
    return spent_ += {time, time, time};
  }

  // Adds tasks that can run side by side.
  template <class ForEachTask>
  static void spend_side_by_side(const ForEachTask& for_each_task)
  {
    const Work_and_span before = spent();
    double work = 0;
    Work_and_span longest;
    for_each_task([&](const auto& task) {
      spent_ = Work_and_span();
      task();
      const Work_and_span spent_on_task = spent();
      work += spent_on_task.work;
      longest.forecast = (std::max)(longest.forecast, spent_on_task.forecast);
      longest.span = (std::max)(longest.span, spent_on_task.span);
    });
    spent_ = before;
    spent_ += {work, (std::max)(longest.forecast, work / static_cast<double>(number_of_threads)), longest.span};
  }

private:
  inline static std::chrono::steady_clock::time_point last_look_ = std::chrono::steady_clock::now();
  inline static Work_and_span spent_;
};

} // namespace benchmark

namespace tbb {
template <class Index, class Function>
void parallel_for(Index begin, Index end, const Function& function)
{
  benchmark::Meter::spend_side_by_side([&](const auto& spend) {
    for(Index i = begin; i < end; ++i)
      spend([&] { function(i); });
  });
}

template <class First, class Second>
void parallel_invoke(const First& first, const Second& second)
{
  benchmark::Meter::spend_side_by_side([&](const auto& spend) {
    spend(first);
    spend(second);
  });
}

// A quicksort as that of TBB: parts are sorted side by side, and split by one task.
template <class Iterator, class Less>
void parallel_sort(Iterator first, Iterator last, const Less& less)
{
  const auto size = last - first;
  if(size < 500)
    return std::sort(first, last, less);
  std::array<typename std::iterator_traits<Iterator>::value_type, 3> candidates = {*first, first[size / 2], last[-1]};
  std::sort(candidates.begin(), candidates.end(), less);
  const Iterator middle = std::partition(first, last, [&](const auto& x) { return less(x, candidates[1]); });
  parallel_invoke([&] { parallel_sort(first, middle, less); }, [&] { parallel_sort(middle, last, less); });
}

class global_control
{
public:
  enum parameter
  {
    max_allowed_parallelism
  };

  static std::size_t active_value(parameter) { return benchmark::Meter::number_of_threads; }
};

namespace this_task_arena {
inline int max_concurrency() { return static_cast<int>(benchmark::Meter::number_of_threads); }
} // namespace this_task_arena

} // namespace tbb

#endif // CGAL_REEB_GRAPH_BENCHMARK_WORK_AND_SPAN_H
