// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_BENCHMARK_TIMED_RUNS_H
#define CGAL_REEB_GRAPH_BENCHMARK_TIMED_RUNS_H

#include "inputs.h"
#include "measurements.h"

#include <CGAL/Reeb_graph/Augmentation.h>
#include <CGAL/compute_reeb_graph.h>

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/global_control.h>
#endif

#include <algorithm>
#include <cstddef>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <thread>
#include <utility>
#include <vector>

// What is timed: the way from a mesh in memory to the finished graph with its chains, the floors beside it, and the way
// back from the graph to the mesh.
namespace benchmark {
typedef CGAL::Reeb_graph_traits<Mesh, Scalar_map>::Graph Graph;
typedef CGAL::Reeb_graph::Method Method;
typedef CGAL::Reeb_graph::Stage Stage;

#ifdef CGAL_LINKED_WITH_TBB
constexpr bool is_parallel_available = true;
#else
constexpr bool is_parallel_available = false;
#endif

struct Engine_times
{
  Sample total, minor_faults;
  std::map<Stage, Sample> stages;
};

class Stage_clock : public CGAL::Reeb_graph::Default_visitor
{
public:
  explicit Stage_clock(Engine_times& times) : times_(times) {}

  void begin_stage(Stage) { stopwatch_ = Stopwatch(); }
  void end_stage(Stage stage) { times_.stages[stage].add(stopwatch_.milliseconds()); }
  void critical_vertices(const CGAL::Reeb_graph::Critical_vertex_counts& counts)
  {
    number_of_critical_vertices_ = counts.minima + counts.maxima + counts.border_saddles;
    for(const auto& saddles : counts.saddles)
      number_of_critical_vertices_ += saddles.second;
  }

  std::size_t number_of_critical_vertices() const { return number_of_critical_vertices_; }

private:
  Engine_times& times_;
  Stopwatch stopwatch_;
  std::size_t number_of_critical_vertices_ = 0;
};

template <class ConcurrencyTag>
void run_engine(const Input& input, Method method, Engine_times& times)
{
  Stage_clock clock(times);
  Graph graph; // a fresh one each time: destroying the one before is not timed
  const auto np = CGAL::parameters::method(method).visitor(std::ref(clock));
  const double earlier_faults = number_of_minor_faults();
  times.total.add(
    milliseconds([&] { CGAL::compute_reeb_graph<ConcurrencyTag>(input.mesh(), input.scalar_map(), graph, np); }));
  times.minor_faults.add(number_of_minor_faults() - earlier_faults);
}

// One thread is the sequential algorithm.
inline void run_engine(const Input& input, Method method, std::size_t number_of_threads, Engine_times& times)
{
  if(number_of_threads == 1)
    return run_engine<CGAL::Sequential_tag>(input, method, times);
#ifdef CGAL_LINKED_WITH_TBB
  const tbb::global_control control(tbb::global_control::max_allowed_parallelism, number_of_threads);
  run_engine<CGAL::Parallel_tag>(input, method, times);
#endif
}

// What a first run, which is not timed, tells.
struct Properties
{
  std::size_t number_of_critical_vertices = 0;
  std::optional<double> extra_peak_bytes;
  Graph graph;
};

inline Properties find_properties(const Input& input)
{
  Properties properties;
  Engine_times times;
  Stage_clock clock(times);
  const Memory_gauge gauge;
  CGAL::compute_reeb_graph(input.mesh(), input.scalar_map(), properties.graph,
                           CGAL::parameters::visitor(std::ref(clock)));
  properties.extra_peak_bytes = gauge.extra_peak_bytes();
  properties.number_of_critical_vertices = clock.number_of_critical_vertices();
  return properties;
}

typedef std::vector<std::pair<double, Mesh::size_type>> Pairs;

inline Pairs make_pairs(const Input& input)
{
  Pairs pairs;
  pairs.reserve(input.mesh().number_of_vertices());
  for(const Mesh::Vertex_index v : input.mesh().vertices())
    pairs.emplace_back(input.scalar_map()[v], v.idx());
  return pairs;
}

inline double time_sort(const Input& input)
{
  Pairs pairs = make_pairs(input);
  return milliseconds([&] { std::sort(pairs.begin(), pairs.end()); });
}

template <class Function>
double time_in_threads(std::size_t number_of_threads, const Function& function)
{
  return milliseconds([&] {
    std::vector<std::thread> threads;
    for(std::size_t i = 1; i < number_of_threads; ++i)
      threads.emplace_back([&function, i] { function(i); });
    function(0);
    for(std::thread& thread : threads)
      thread.join();
  });
}

// Each thread has the whole work for itself: what threads reach that share nothing but the machine.
inline double time_sorts_side_by_side(const Input& input, std::size_t number_of_threads)
{
  std::vector<Pairs> pairs(number_of_threads, make_pairs(input));
  return time_in_threads(number_of_threads, [&](std::size_t i) { std::sort(pairs[i].begin(), pairs[i].end()); });
}

// The threads share the work: what the memory of the machine lets them reach.
inline double time_copy_into_new_memory(const Input& input, std::size_t number_of_threads)
{
  const std::vector<char> source(64 * input.mesh().number_of_vertices(), 1);
  const std::unique_ptr<char[]> copy(new char[source.size()]);
  return time_in_threads(number_of_threads, [&](std::size_t i) {
    const std::size_t begin = i * source.size() / number_of_threads, end = (i + 1) * source.size() / number_of_threads;
    std::copy(source.begin() + begin, source.begin() + end, copy.get() + begin);
  });
}

inline double time_sweep(const Input& input)
{
  volatile double sum_kept = 0; // lest the loop is optimized away
  return milliseconds([&] {
    double sum = 0;
    for(const auto& t : input.triangles())
      sum += std::max({input.scalar_map()[Mesh::Vertex_index(t[0])], input.scalar_map()[Mesh::Vertex_index(t[1])],
                       input.scalar_map()[Mesh::Vertex_index(t[2])]});
    sum_kept = sum;
  });
}

inline double time_vertex_places(const Input& input, const Graph& graph)
{
  const Stopwatch stopwatch;
  const CGAL::Reeb_graph::Augmentation augmentation(input.mesh(), input.scalar_map(), graph);
  const auto vertex_places = augmentation.locate_vertices();
  return stopwatch.milliseconds();
}

// With the graph, all in one call.
inline double time_graph_with_vertex_places(const Input& input)
{
  std::vector<std::size_t> places(input.mesh().number_of_vertices());
  Graph graph;
  return milliseconds([&] {
    CGAL::compute_reeb_graph(input.mesh(), input.scalar_map(), graph,
                             CGAL::parameters::vertex_place_map(CGAL::make_property_map(places)));
  });
}

// About 1000 contours: at three places of some or all arcs, again and again if there are few.
inline double nanoseconds_per_crossed_edge(const Input& input, const Graph& graph)
{
  const CGAL::Reeb_graph::Augmentation augmentation(input.mesh(), input.scalar_map(), graph);
  const auto arc_range = edges(graph);
  const std::vector<boost::graph_traits<Graph>::edge_descriptor> arcs(arc_range.first, arc_range.second);
  const std::size_t stride = arcs.size() / 333 + 1;
  std::size_t number_of_contours = 0, number_of_edges = 0;
  const double time = milliseconds([&] {
    while(number_of_contours < 900)
      for(std::size_t i = 0; i < arcs.size(); i += stride)
        for(const double t : {0.25, 0.5, 0.75})
        {
          number_of_edges += augmentation.contour(arcs[i], t).edges.size();
          ++number_of_contours;
        }
  });
  return 1e6 * time / static_cast<double>(number_of_edges);
}

} // namespace benchmark

#endif // CGAL_REEB_GRAPH_BENCHMARK_TIMED_RUNS_H
