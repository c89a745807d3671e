// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

// Which part of the time of one thread no number of threads can share, by stage, and how much faster 4, 16, and 64
// threads can be at best. The parallel work is done by one thread, see measured_tbb/work_and_span.h.
//
// Usage: benchmark_sequential_share [NUMBER OF VERTICES] [REPETITIONS]

#include "Table.h"
#include "inputs.h"
#include "measurements.h"
#include "work_and_span.h"

#include <CGAL/compute_reeb_graph.h>

#include <array>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <map>
#include <string>
#include <vector>

namespace {
using benchmark::cell;
typedef CGAL::Reeb_graph::Stage Stage;

constexpr std::array<Stage, 4> stages = {Stage::FLATTEN, Stage::CLASSIFY, Stage::ARCS, Stage::WRITE};
constexpr std::array<std::size_t, 3> numbers_of_threads = {4, 16, 64};

class Stage_meter : public CGAL::Reeb_graph::Default_visitor
{
public:
  void begin_stage(Stage) { begin_ = benchmark::Meter::spent(); }
  void end_stage(Stage stage) { spans[stage] = (benchmark::Meter::spent() - begin_).span; }

  std::map<Stage, double> spans;

private:
  benchmark::Work_and_span begin_;
};

template <class ConcurrencyTag>
benchmark::Work_and_span measure(const benchmark::Input& input, Stage_meter& meter)
{
  CGAL::Reeb_graph_traits<benchmark::Mesh, benchmark::Scalar_map>::Graph graph;
  const benchmark::Work_and_span begin = benchmark::Meter::spent();
  const auto np = CGAL::parameters::visitor(std::ref(meter));
  CGAL::compute_reeb_graph<ConcurrencyTag>(input.mesh(), input.scalar_map(), graph, np);
  return benchmark::Meter::spent() - begin;
}

// The shares are those with as many parts of the work as the most threads want.
void print_row(const benchmark::Table& table, const benchmark::Input& input, std::size_t repetitions)
{
  benchmark::Sample sequential;
  std::array<benchmark::Sample, numbers_of_threads.size()> forecasts;
  std::array<benchmark::Sample, stages.size() + 1> shares; // and of all stages
  for(std::size_t repetition = 0; repetition < repetitions; ++repetition)
  {
    Stage_meter meter;
    const double time = measure<CGAL::Sequential_tag>(input, meter).work;
    sequential.add(time);
    benchmark::Work_and_span last;
    for(std::size_t i = 0; i < numbers_of_threads.size(); ++i)
    {
      benchmark::Meter::number_of_threads = numbers_of_threads[i];
      last = measure<CGAL::Parallel_tag>(input, meter);
      forecasts[i].add(time / last.forecast);
    }
    for(std::size_t i = 0; i < stages.size(); ++i)
      shares[i].add(100 * meter.spans[stages[i]] / time);
    shares.back().add(100 * last.span / time);
  }
  std::vector<std::string> cells = {input.surface(), input.field(), cell(std::size_t(num_vertices(input.mesh()))),
                                    cell(sequential.median(), 1)};
  for(const benchmark::Sample& share : shares)
    cells.push_back(cell(share.median(), 1));
  for(const benchmark::Sample& forecast : forecasts)
    cells.push_back(cell(forecast.median(), 2));
  table.print_row(cells);
}
} // namespace

int main(int argc, char* argv[])
{
  const std::size_t number_of_vertices = argc > 1 ? std::strtoul(argv[1], nullptr, 10) : 1000000;
  const std::size_t repetitions = argc > 2 ? std::strtoul(argv[2], nullptr, 10) : 5;
  if(number_of_vertices < 100 || repetitions == 0)
  {
    std::fprintf(stderr, "usage: benchmark_sequential_share [NUMBER OF VERTICES] [REPETITIONS]\n");
    return EXIT_FAILURE;
  }
  std::vector<benchmark::Column> columns = {{"surface", "", 8},    {"field", "", 6}, {"vertices", "", 8},
                                            {"1 thread", "ms", 8}, {"flatten", "%"}, {"classify", "%"},
                                            {"arcs", "%"},         {"write", "%"},   {"all", "%", 5}};
  for(const std::size_t threads : numbers_of_threads)
    columns.push_back({cell(threads) + " thr.", "times", 7});
  const benchmark::Table table(
    "The part of the time of one thread that threads cannot share, and how many times as fast "
    "more of them can be; medians of "
      + cell(repetitions) + " runs",
    columns);
  const benchmark::Stopwatch stopwatch;
  for(const std::string& surface : benchmark::surface_names())
  {
    benchmark::Input input(surface, number_of_vertices);
    for(const std::string& field : benchmark::field_names())
    {
      input.set_field(field);
      print_row(table, input, repetitions);
    }
  }
  std::printf("\nsequential share: %.0f seconds\n", stopwatch.milliseconds() / 1000);
  return EXIT_SUCCESS;
}
