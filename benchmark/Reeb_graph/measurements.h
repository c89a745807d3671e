// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_BENCHMARK_MEASUREMENTS_H
#define CGAL_REEB_GRAPH_BENCHMARK_MEASUREMENTS_H

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstddef>
#include <fstream>
#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#ifdef __GLIBC__
#include <malloc.h>
#endif
#ifdef __unix__
#include <sys/resource.h>
#endif

// Clocks, medians, memory, and growth.
namespace benchmark {
class Stopwatch
{
public:
  double milliseconds() const
  {
    return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start_).count();
  }

private:
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

template <class Function>
double milliseconds(const Function& function)
{
  const Stopwatch stopwatch;
  function();
  return stopwatch.milliseconds();
}

class Sample
{
public:
  void add(double value) { values_.push_back(value); }
  bool empty() const { return values_.empty(); }

  // none of an empty sample
  std::optional<double> median() const
  {
    if(values_.empty())
      return std::nullopt;
    std::vector<double> values = values_;
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
  }

private:
  std::vector<double> values_;
};

// The memory that is resident beyond what was so at the start, at the peak since then. Only Linux tells.
class Memory_gauge
{
public:
  Memory_gauge()
  {
#ifdef __GLIBC__
    malloc_trim(0); // memory that was freed before must not hide what is needed now
#endif
    std::ofstream("/proc/self/clear_refs") << "5\n";
    resident_before_ = status("VmRSS:");
    const auto peak_before = status("VmHWM:");
    constexpr double tolerance = 1 << 20;
    is_reset_ = resident_before_ && peak_before && *peak_before <= *resident_before_ + tolerance;
  }

  std::optional<double> extra_peak_bytes() const
  {
    const auto peak = status("VmHWM:");
    if(!is_reset_ || !peak)
      return std::nullopt;
    return *peak - *resident_before_;
  }

private:
  static std::optional<double> status(const std::string& key)
  {
    std::ifstream file("/proc/self/status");
    std::string word;
    double kilobytes = 0;
    while(file >> word)
      if(word == key && file >> kilobytes)
        return 1024 * kilobytes;
    return std::nullopt;
  }

  std::optional<double> resident_before_;
  bool is_reset_ = false;
};

// How often the process has touched a page that it did not have yet, which takes longer than to write what is in it.
// Zero where no system tells.
inline double number_of_minor_faults()
{
#ifdef __unix__
  rusage usage = {};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<double>(usage.ru_minflt);
#else
  return 0;
#endif
}

// The exponent e of the power size^e that fits the times best: least squares of the logarithms.
inline double growth_exponent(const std::vector<std::pair<double, double>>& times_by_size)
{
  double n = 0, x = 0, y = 0, xx = 0, xy = 0;
  for(const auto& [size, time] : times_by_size)
  {
    const double log_size = std::log(size), log_time = std::log(time);
    n += 1;
    x += log_size;
    y += log_time;
    xx += log_size * log_size;
    xy += log_size * log_time;
  }
  const double variance = n * xx - x * x;
  return variance > 0 ? (n * xy - x * y) / variance : std::numeric_limits<double>::quiet_NaN();
}

} // namespace benchmark

#endif // CGAL_REEB_GRAPH_BENCHMARK_MEASUREMENTS_H
