// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_BENCHMARK_TABLES_H
#define CGAL_REEB_GRAPH_BENCHMARK_TABLES_H

#include "Table.h"
#include "inputs.h"
#include "measurements.h"
#include "timed_runs.h"

#include <algorithm>
#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

// The tables that the benchmark prints.
namespace benchmark {
struct Options
{
  std::vector<std::size_t> sizes = {200000, 1000000};
  std::vector<std::size_t> growth_sizes = {50000, 100000, 200000, 400000, 800000, 1600000, 3200000};
  std::vector<std::size_t> numbers_of_triangles = {50000, 200000, 1000000, 3000000};
  std::vector<std::string> surfaces = surface_names();
  std::vector<std::string> fields = field_names();
  std::size_t number_of_repetitions = 5;
  std::size_t number_of_threads = 2;
  // The method of critical sets is left out where it would be quadratic.
  std::size_t largest_number_for_critical_sets = 2000;
};

struct Measurements
{
  Sample sort, sweep, vertex_places, graph_with_vertex_places;
  Sample sorts_side_by_side, copy, parallel_copy;
  std::map<std::pair<Method, std::size_t>, Engine_times> engines; // by method and number of threads
};

inline std::vector<std::size_t> thread_counts(const Options& options)
{
  if(!is_parallel_available || options.number_of_threads < 2)
    return {1};
  return {1, options.number_of_threads};
}

// The different things take turns, so that a machine that slows down does so for all of them. One and more threads also
// change places: memory that the one has used is at hand for the other.
inline Measurements measure(const Input& input, const Properties& properties, const Options& options)
{
  std::vector<Method> methods = {Method::CONTOUR_TREES};
  if(properties.number_of_critical_vertices <= options.largest_number_for_critical_sets)
    methods.push_back(Method::CRITICAL_SETS);
  Engine_times first_times; // threads start in the first parallel run
  run_engine(input, Method::CONTOUR_TREES, thread_counts(options).back(), first_times);

  Measurements measurements;
  for(std::size_t repetition = 0; repetition != options.number_of_repetitions; ++repetition)
  {
    measurements.sort.add(time_sort(input));
    measurements.sweep.add(time_sweep(input));
    measurements.sorts_side_by_side.add(time_sorts_side_by_side(input, options.number_of_threads));
    measurements.copy.add(time_copy_into_new_memory(input, 1));
    measurements.parallel_copy.add(time_copy_into_new_memory(input, options.number_of_threads));
    std::vector<std::size_t> turns = thread_counts(options);
    std::rotate(turns.begin(), turns.begin() + repetition % turns.size(), turns.end());
    for(const Method method : methods)
      for(const std::size_t threads : turns)
        run_engine(input, method, threads, measurements.engines[{method, threads}]);
    measurements.vertex_places.add(time_vertex_places(input, properties.graph));
    measurements.graph_with_vertex_places.add(time_graph_with_vertex_places(input));
  }
  return measurements;
}

inline std::optional<double> ratio(std::optional<double> a, std::optional<double> b)
{
  if(!a || !b || *b <= 0)
    return std::nullopt;
  return *a / *b;
}

inline std::optional<double> sum(std::optional<double> a, std::optional<double> b)
{
  if(!a || !b)
    return std::nullopt;
  return *a + *b;
}

// The parallel efficiency in per cent.
inline std::string efficiency(std::optional<double> sequential, std::optional<double> parallel, std::size_t threads)
{
  const auto speed_up = ratio(sequential, parallel);
  if(!speed_up)
    return "-";
  return cell(100 * *speed_up / static_cast<double>(threads), 0);
}

class Comparison_table
{
public:
  explicit Comparison_table(const Options& options)
    : options_(options),
      table_("Time and memory from the mesh to the graph; medians of " + cell(options.number_of_repetitions) + " runs",
             columns(cell(options.number_of_threads) + " thr."))
  {}

  void add(const Input& input, const Properties& properties, Measurements& measurements) const
  {
    const std::size_t threads = options_.number_of_threads;
    const auto total = [&](Method method, std::size_t threads) {
      return measurements.engines[{method, threads}].total.median();
    };
    const auto sort = measurements.sort.median();
    const auto sequential = total(Method::CONTOUR_TREES, 1), parallel = total(Method::CONTOUR_TREES, threads);
    const double n = static_cast<double>(input.mesh().number_of_vertices());
    table_.print_row({input.surface(), input.field(), cell(std::size_t(input.mesh().number_of_vertices())),
                      cell(num_edges(properties.graph)), cell(sort, 1), cell(measurements.sweep.median(), 1),
                      cell(sequential, 1), cell(ratio(sequential, sort), 2), cell(parallel, 1),
                      efficiency(sequential, parallel, threads), sorts_efficiency(measurements),
                      efficiency(measurements.copy.median(), measurements.parallel_copy.median(), threads),
                      cell(total(Method::CRITICAL_SETS, 1), 1), cell(total(Method::CRITICAL_SETS, threads), 1),
                      cell(ratio(properties.extra_peak_bytes, n), 0),
                      cell(ratio(measurements.engines[{Method::CONTOUR_TREES, 1}].minor_faults.median(), n / 1000), 1),
                      cell(ratio(sum(sequential, measurements.vertex_places.median()), sort), 2),
                      cell(ratio(measurements.graph_with_vertex_places.median(), sort), 2),
                      cell(nanoseconds_per_crossed_edge(input, properties.graph), 0)});
  }

private:
  static std::string sorts_efficiency(const Measurements& measurements)
  {
    const auto efficiency = ratio(measurements.sort.median(), measurements.sorts_side_by_side.median());
    return efficiency ? cell(100 * *efficiency, 0) : "-";
  }

  static std::vector<Column> columns(const std::string& threads)
  {
    return {{"surface", "", 8},     {"field", "", 6},      {"vertices", "", 8},      {"arcs", "", 7},
            {"sort", "ms", 6},      {"sweep", "ms", 5},    {"trees", "ms", 7},       {"trees", "/ sort"},
            {threads, "ms", 7},     {threads, "effic. %"}, {"sorts", "effic. %"},    {"copy", "effic. %"},
            {"sets", "ms", 7},      {threads, "ms", 7},    {"memory", "B / vertex"}, {"faults", "/ 1000 v."},
            {"+ places", "/ sort"}, {"in one", "/ sort"},  {"contours", "ns / edge"}};
  }

  const Options& options_;
  Table table_;
};

// Where the time of the method of contour trees goes.
class Stage_table
{
public:
  explicit Stage_table(const Options& options) : options_(options), table_(title(options), columns(options)) {}

  static const std::vector<std::pair<Stage, std::string>>& stages()
  {
    static const std::vector<std::pair<Stage, std::string>> result = {
      {Stage::FLATTEN, "flatten"}, {Stage::CLASSIFY, "classify"}, {Stage::ARCS, "arcs"}, {Stage::WRITE, "write"}};
    return result;
  }

  void print_row(const std::vector<std::string>& names, Measurements& measurements) const
  {
    std::vector<std::string> cells = names;
    auto& sequential = measurements.engines[{Method::CONTOUR_TREES, 1}].stages;
    auto& parallel = measurements.engines[{Method::CONTOUR_TREES, options_.number_of_threads}].stages;
    for(const auto& [stage, name] : stages())
    {
      cells.push_back(cell(sequential[stage].median(), 1));
      cells.push_back(cell(parallel[stage].median(), 1));
      cells.push_back(efficiency(sequential[stage].median(), parallel[stage].median(), options_.number_of_threads));
    }
    table_.print_row(cells);
  }

private:
  static std::string title(const Options& options)
  {
    return "The stages, with contour trees: ms with one thread, ms with " + cell(options.number_of_threads)
         + " threads, parallel efficiency in per cent";
  }

  static std::vector<Column> columns(const Options& options)
  {
    std::vector<Column> columns = {{"surface", "", 8}, {"field", "", 6}, {"vertices", "", 8}};
    for(const auto& [stage, name] : stages())
    {
      columns.push_back({name, "1 thr.", 8});
      columns.push_back({"", cell(options.number_of_threads) + " thr.", 6});
      columns.push_back({"", "%", 3});
    }
    return columns;
  }

  const Options& options_;
  Table table_;
};

inline void print_comparison_and_stages(const Options& options)
{
  std::vector<std::pair<std::vector<std::string>, Measurements>> rows;
  const Comparison_table comparison(options);
  for(const std::size_t size : options.sizes)
    for(const std::string& surface : options.surfaces)
    {
      Input input(surface, size);
      for(const std::string& field : options.fields)
      {
        input.set_field(field);
        const Properties properties = find_properties(input);
        rows.emplace_back(
          std::vector<std::string>{surface, field, cell(std::size_t(input.mesh().number_of_vertices()))},
          measure(input, properties, options));
        comparison.add(input, properties, rows.back().second);
      }
    }
  const Stage_table stages(options);
  for(auto& [names, measurements] : rows)
    stages.print_row(names, measurements);
}

inline void print_growth(const Options& options)
{
  std::vector<Column> columns = {{"vertices", "", 8}};
  for(const std::string& field : options.fields)
    columns.insert(columns.end(), {{field, "ms", 9}, {"sort", "ms", 8}});
  const Table table("Growth on genus 3, contour trees, one thread", columns);

  std::map<std::string, std::vector<std::pair<double, double>>> times, sort_times; // by field
  for(const std::size_t size : options.growth_sizes)
  {
    Input input("genus-3", size);
    const double n = static_cast<double>(input.mesh().number_of_vertices());
    std::vector<std::string> cells = {cell(n, 0)};
    for(const std::string& field : options.fields)
    {
      input.set_field(field);
      Engine_times engine_times;
      Sample sort;
      for(std::size_t repetition = 0; repetition != options.number_of_repetitions; ++repetition)
      {
        run_engine(input, Method::CONTOUR_TREES, 1, engine_times);
        sort.add(time_sort(input));
      }
      times[field].emplace_back(n, *engine_times.total.median());
      sort_times[field].emplace_back(n, *sort.median());
      cells.insert(cells.end(), {cell(times[field].back().second, 1), cell(sort_times[field].back().second, 1)});
    }
    table.print_row(cells);
  }
  std::vector<std::string> cells = {"exponent"};
  for(const std::string& field : options.fields)
    cells.insert(cells.end(), {cell(growth_exponent(times[field]), 3), cell(growth_exponent(sort_times[field]), 3)});
  table.print_row(cells);
}

} // namespace benchmark

#endif // CGAL_REEB_GRAPH_BENCHMARK_TABLES_H
