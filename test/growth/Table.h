// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_TEST_GROWTH_TABLE_H
#define CGAL_REEB_GRAPH_TEST_GROWTH_TABLE_H

#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <ctime>
#include <functional>
#include <string>
#include <utility>

// How the processor time of a function grows from n to 4n. The work is the size of the input and of the output, so that
// a function may take as long as it has to write.
namespace growth {
constexpr double near_linear = 1.75; // the largest exponent: caches and logarithms stay below it, squares do not

template <class Subject>
struct Function
{
  std::string name;
  std::function<std::size_t(const Subject&)> run; // returns the size of the output beyond that of the input
  double largest_exponent = near_linear;
};

class Table
{
public:
  // Only rows whose names have this part are measured.
  explicit Table(std::string filter) : filter_(std::move(filter))
  {
    std::printf("%-24s %-34s %9s %8s %8s %8s %9s %7s\n", "input", "function", "work", "n [ms]", "2n [ms]", "4n [ms]",
                "exponent", "bound");
  }

  template <class Subjects, class Subject>
  void measure(const std::string& input, const Subjects& subjects, const Function<Subject>& function)
  {
    if((input + ' ' + function.name).find(filter_) == std::string::npos)
      return;
    std::array<Best, 3> best;
    for(int trial = 0; trial < 3; ++trial) // others may use the caches, and the machine
    {
      for(std::size_t i = 0; i < best.size(); ++i)
        repeat(*subjects[i], function, best[i]);
      if(is_too_short(best) || exponent(best) <= function.largest_exponent)
        break;
    }
    print(input, function.name, best, function.largest_exponent);
  }

  // The same for megabytes of memory beyond those of the input, in place of milliseconds.
  template <class Subjects, class Subject>
  void measure_memory(const std::string& input, const Subjects& subjects, const Function<Subject>& function)
  {
    const std::string name = function.name + ", memory";
    if((input + ' ' + name).find(filter_) == std::string::npos)
      return;
    std::array<Best, 3> best;
    for(std::size_t i = 0; i < best.size(); ++i)
    {
      const double before = peak_of([] {});
      best[i].seconds = 1e-3 * (peak_of([&] { function.run(*subjects[i]); }) - before);
      best[i].work = static_cast<double>(subjects[i]->size());
    }
    print(input, name, best, function.largest_exponent);
  }

  std::size_t number_of_failures() const { return number_of_failures_; }

private:
  struct Best
  {
    double seconds = HUGE_VAL;
    double work = 0;
  };

  template <class Subject>
  static void repeat(const Subject& subject, const Function<Subject>& function, Best& best)
  {
    double sum = 0;
    for(int run = 0; run < 5 && sum < 0.3; ++run)
    {
      const std::clock_t start = std::clock();
      const std::size_t output = function.run(subject);
      const double seconds = static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
      best.seconds = (std::min)(best.seconds, seconds);
      best.work = static_cast<double>(subject.size() + output);
      sum += seconds;
    }
  }

  // In megabytes, of a process of its own.
  static double peak_of(const std::function<void()>& run)
  {
    const pid_t child = fork();
    if(child == 0)
    {
      run();
      _exit(0);
    }
    rusage usage = {};
    wait4(child, nullptr, 0, &usage);
    return static_cast<double>(usage.ru_maxrss) / 1024;
  }

  static bool is_too_short(const std::array<Best, 3>& best) { return best[2].seconds < 0.03; }

  static double exponent(const std::array<Best, 3>& best)
  {
    const double shortest = 1e-4; // what the clock tells of less says nothing
    return std::log(best[2].seconds / (std::max)(best[0].seconds, shortest)) / std::log(best[2].work / best[0].work);
  }

  void print(const std::string& input, const std::string& name, const std::array<Best, 3>& best, double bound)
  {
    const bool has_failed = !is_too_short(best) && !(exponent(best) <= bound);
    number_of_failures_ += has_failed ? 1 : 0;
    std::printf("%-24s %-34s %9.0f %8.1f %8.1f %8.1f %9.2f %7.2f %s\n", input.c_str(), name.c_str(), best[2].work,
                1e3 * best[0].seconds, 1e3 * best[1].seconds, 1e3 * best[2].seconds, exponent(best), bound,
                has_failed           ? "FAILS"
                : is_too_short(best) ? "too short to tell"
                                     : "");
    std::fflush(stdout);
  }

  std::string filter_;
  std::size_t number_of_failures_ = 0;
};

// The parts of the test.
void measure_graphs(Table& table);
void measure_fields(Table& table);
void measure_curves(Table& table);
void measure_handles(Table& table);
void measure_skeletons(Table& table);
void measure_complexes(Table& table);
void measure_comparisons(Table& table);

} // namespace growth

#endif // CGAL_REEB_GRAPH_TEST_GROWTH_TABLE_H
