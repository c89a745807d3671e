// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#include "base/costs.h"
#include "base/message_of.h"
#include "base/progress_bar.h"
#include "base/report.h"
#include "computation/Report_visitor.h"
#include "computation/analysis.h"
#include "computation/simplification.h"
#include "input/field_input.h"
#include "mpi/local_input.h"
#include "mpi/ranks.h"
#include "output/graph_output.h"
#include "output/output_file.h"
#include "output/report_output.h"

#include <CGAL/Reeb_graph/distributed/compute_reeb_graph_distributed.h>
#include <CGAL/Reeb_graph/distributed/internal/exchange.h>
#include <CGAL/Reeb_graph/graph_topology.h>
#include <CGAL/Reeb_graph/options.h>
#include <CGAL/Reeb_graph/simplification/simplification_thresholds.h>

#include <boost/mpi/collectives.hpp>
#include <boost/mpi/exception.hpp>
#include <boost/range/irange.hpp>
#include <boost/serialization/string.hpp>
#include <boost/serialization/utility.hpp>
#include <boost/serialization/vector.hpp>

#include <mpi.h>

#include <unistd.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <ctime>
#include <exception>
#include <filesystem>
#include <functional>
#include <iostream>
#include <limits>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace reeb_graph_program {
void run_together(const Communicator& communicator, const std::function<void()>& work)
{
  std::string message;
  int failed_rank = communicator.size(); // none
  try
  {
    work();
  }
  catch(const std::exception& error)
  {
    message = message_of(error);
    failed_rank = communicator.rank();
  }
  int first = 0;
  MPI_Request request = MPI_REQUEST_NULL;
  BOOST_MPI_CHECK_RESULT(MPI_Iallreduce, (&failed_rank, &first, 1, MPI_INT, MPI_MIN, communicator, &request));
  CGAL::Reeb_graph::internal::wait_for(request);
  if(first == communicator.size())
    return;
  boost::mpi::broadcast(communicator, message, first);
  throw std::runtime_error(message);
}

void run_on_rank_0(const Communicator& communicator, const std::function<void()>& work)
{
  run_together(communicator, [&] {
    if(communicator.rank() == 0)
      work();
  });
}

Part part_of_rank(const Communicator& communicator, std::uint64_t number)
{
  const auto size = static_cast<std::uint64_t>(communicator.size());
  const auto rank = static_cast<std::uint64_t>(communicator.rank());
  const std::uint64_t each = number / size, more = number % size;
  const auto first = [&](std::uint64_t r) { return r * each + std::min(r, more); };
  return {first(rank), first(rank + 1)};
}

// The seconds of CPU that the process has spent.
inline double cpu_seconds_of_process()
{
  timespec time = {};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

// Notes what a step takes: its seconds in the report, and those of CPU in that of the rank.
class Step
{
public:
  Step(const std::string& name, Report& report, Rank_report& rank) : name_(name), report_(report), rank_(rank) {}
  Step(const Step&) = delete;
  Step& operator=(const Step&) = delete;

  void end()
  {
    report_.seconds.emplace_back(name_, stopwatch_.seconds());
    rank_.cpu_seconds.emplace_back(name_, cpu_seconds_of_process() - first_cpu_seconds_);
  }

private:
  std::string name_;
  Report& report_;
  Rank_report& rank_;
  Stopwatch stopwatch_;
  double first_cpu_seconds_ = cpu_seconds_of_process();
};

// Notes what each stage of the computation takes: its seconds in the report, and those of CPU in that of the rank.
class Rank_visitor : public Report_visitor
{
public:
  Rank_visitor(Report& report, Rank_report& rank) : Report_visitor(report), report_(report), rank_(rank) {}

  void begin_stage(CGAL::Reeb_graph::Stage stage)
  {
    Report_visitor::begin_stage(stage);
    first_cpu_seconds_ = cpu_seconds_of_process();
  }
  void end_stage(CGAL::Reeb_graph::Stage stage)
  {
    Report_visitor::end_stage(stage);
    rank_.cpu_seconds.emplace_back(report_.seconds.back().first, cpu_seconds_of_process() - first_cpu_seconds_);
  }

private:
  Report& report_;
  Rank_report& rank_;
  double first_cpu_seconds_ = 0;
};

namespace {
typedef CGAL::Reeb_graph_soup_traits<double>::Graph Graph_of_ranks;
typedef CGAL::Reeb_graph::Distributed_slab<double> Slab;

[[noreturn]] void refuse(const std::string& option, const std::string& reason)
{
  throw std::runtime_error(option + " is not available on ranks: " + reason);
}

std::vector<std::filesystem::path> output_files(const Compute_options& options)
{
  return {options.graph_path, options.pairs_path, options.diagram_path};
}

// What needs the whole surface in one memory.
void check_left_out(const Compute_options& options)
{
  const std::string surface = "it needs the whole surface in one memory, as the program reeb_graph has it";
  const std::pair<bool, const char*> given[] = {{!options.page_path.empty() || !options.up.empty(), "--html"},
                                                {!options.mesh_path.empty(), "--mesh-out"},
                                                {!options.vertex_arcs_path.empty(), "--vertex-arcs"},
                                                {!options.simplified_scalars_path.empty(), "--simplified-scalars"},
                                                {!options.loop_path.empty(), "--longest-loop"},
                                                {options.is_table_wanted.value_or(false), "--table"},
                                                {options.input.are_faces_triangulated, "--triangulate"},
                                                {options.input.lowest_vertex.has_value(), "--min"},
                                                {options.input.highest_vertex.has_value(), "--max"},
                                                {!options.input.weights.empty(), "--weights"},
                                                {!options.input.source_vertices.empty(), "--source"}};
  for(const auto& [is_given, name] : given)
    if(is_given)
      refuse(name, surface);
  for(const char* field : {"harmonic", "poisson", "geodesic", "unit-gradient"})
    if(options.input.field == field)
      refuse("--field " + options.input.field, surface);
  if(!options.input.scalars_path.empty() || !options.input.column.empty())
    refuse("--scalars", "the field is a coordinate, height, a property of the vertices, or in a raw file");
  if(!options.input.direction.empty() && options.input.field != "height")
    throw std::runtime_error("--direction goes with the field height only");
  if(options.graph.number_of_threads > 1)
    refuse("--threads", "each rank works with one thread; more ranks do more at a time");
}

void check_on_ranks(const Compute_options& options)
{
  if(is_standard_input(options.input.mesh_path) || is_standard_input(options.input.scalars_path))
    refuse("standard input", "each rank reads its part of a file");
  check_left_out(options);
  check_graph_format(options.graph_path);
  if(is_format_in_space(options.graph_path))
  {
    if(has_arc_attributes(options.graph_path))
      refuse(options.graph_path, "the format has lengths and areas of arcs; .graphml, .dot, .svg, .obj, and "
                                 ".polylines.txt have none");
    if(options.embedding_manner != CGAL::Reeb_graph::Embedding_manner::STRAIGHT)
      refuse(options.graph_path, "arcs are drawn through contours; --embedding straight leaves them straight");
  }
  else if(options.embedding_manner)
    throw std::runtime_error("--embedding straight goes with --graph and .obj or .polylines.txt only");
  check_pairs_format(options.pairs_path);
  check_diagram_format(options.diagram_path);
  check_outputs(output_files(options), input_files(options.input));
  check_simplification_options(options.simplification);
}

// Collective.
std::optional<Value_range> find_range(const Communicator& communicator, const Local_mesh& mesh)
{
  constexpr double infinity = std::numeric_limits<double>::infinity();
  Value_range range(infinity, -infinity);
  if(!mesh.scalars.empty())
  {
    const auto [lowest, highest] = std::minmax_element(mesh.scalars.begin(), mesh.scalars.end());
    range = {*lowest, *highest};
  }
  range.first = boost::mpi::all_reduce(communicator, range.first, boost::mpi::minimum<double>());
  range.second = boost::mpi::all_reduce(communicator, range.second, boost::mpi::maximum<double>());
  return mesh.number_of_vertices == 0 ? std::nullopt : std::make_optional(range);
}

Graph_of_ranks compute(const Communicator& communicator,
                       const Local_mesh& mesh,
                       const Graph_options& options,
                       Slab& slab,
                       Report& report,
                       Rank_report& rank)
{
  namespace parameters = CGAL::parameters;
  const bool is_shown = communicator.rank() == 0 && isatty(STDERR_FILENO) == 1;
  Progress_bar progress_bar("graph", is_shown ? &std::cerr : nullptr, 0.5);
  Rank_visitor visitor(report, rank);
  Graph_of_ranks graph;
  const Timed_step timed(report, "compute");
  const double cpu_seconds = cpu_seconds_of_process();
  const auto place = static_cast<std::ptrdiff_t>(rank.cpu_seconds.size());
  const auto vertices = boost::irange<std::uint64_t>(mesh.first_vertex, mesh.first_vertex + mesh.scalars.size());
  const auto np = named_parameters(options)
                    .slab(std::ref(slab))
                    .gather_chains(false)
                    .visitor(std::ref(visitor))
                    .callback(std::ref(progress_bar));
  std::visit(
    [&](const auto& triangles) {
      CGAL::compute_reeb_graph_distributed(communicator, vertices, triangles, mesh.scalars, graph, np);
    },
    mesh.triangles);
  rank.cpu_seconds.insert(rank.cpu_seconds.begin() + place, {"compute", cpu_seconds_of_process() - cpu_seconds});
  return graph;
}

// The graph with the descriptors of a surface that has the vertices of its nodes only, for the functions that write
// graphs.
struct Graph_of_nodes
{
  std::vector<std::uint64_t> numbers; // of the vertices
  Surface surface;
  Graph graph;
};

void put_on_nodes(const Graph_of_ranks& graph, const Local_mesh& mesh, bool are_points_wanted, Graph_of_nodes& result)
{
  typedef CGAL::Reeb_graph_traits<Surface, Scalar_map> Traits;
  for(const auto node : CGAL::make_range(vertices(graph)))
  {
    const std::uint64_t number = graph[node].vertex;
    result.numbers.push_back(number);
    const auto v = result.surface.add_vertex(are_points_wanted ? mesh.point(number) : Point());
    add_vertex(Traits::Node{graph[node].value, v, graph[node].kind}, result.graph);
  }
  for(const auto arc : CGAL::make_range(edges(graph)))
  {
    const auto added = add_edge(source(arc, graph), target(arc, graph), result.graph).first;
    put(boost::edge_index, result.graph, added, get(boost::edge_index, graph, arc));
  }
}

void count_surface(const Local_mesh& mesh, const Slab& slab, const Graph& graph, Report& report)
{
  Mesh_counts& counts = report.surface;
  counts.vertices = mesh.number_of_vertices;
  counts.faces = mesh.number_of_triangles;
  counts.edges = (3 * mesh.number_of_triangles + slab.border_edges) / 2;
  counts.components = CGAL::Reeb_graph::number_of_components(graph); // as many as the surface has
  counts.border_loops = slab.border_loops;
  count_graph_of_surface(graph, report);
}

Field_label label(const Compute_options& options)
{
  Field_label result = field_label(options.input, options.unit);
  if(result.name.empty()) // that of a raw file
    result.name = std::filesystem::path(options.input.mesh_path).stem().string();
  return result;
}

// Each arc is a straight line between the vertices of its nodes.
Embedding embed_straight(const Graph& graph, const Surface& surface)
{
  Embedding result;
  for(const auto node : CGAL::make_range(vertices(graph)))
  {
    result.node_points.push_back(surface.point(graph[node].vertex));
    result.node_values.push_back(graph[node].value);
  }
  for(const auto arc : CGAL::make_range(edges(graph)))
  {
    const std::size_t lower = source(arc, graph), upper = target(arc, graph);
    result.arc_polylines.push_back({result.node_points[lower], result.node_points[upper]});
    result.arc_values.push_back({graph[lower].value, graph[upper].value});
  }
  return result;
}

// What rank 0 does with the graph.
void write_results(const Compute_options& options,
                   const Graph_of_ranks& graph,
                   const Local_mesh& mesh,
                   double asked_threshold,
                   const Slab& slab,
                   Report& report)
{
  Graph_of_nodes given;
  put_on_nodes(graph, mesh, is_format_in_space(options.graph_path), given);
  count_surface(mesh, slab, given.graph, report);
  const Stopwatch simplify_stopwatch;
  const Simplified_graph simplified(given.graph, options.simplification, asked_threshold);
  const double threshold = simplified.threshold();
  if(options.simplification.is_anything_removed())
  {
    report.seconds.emplace_back("simplify", simplify_stopwatch.seconds());
    count_simplified(simplified.result(), threshold, report);
  }
  const Vertex_numbers numbers([&](Surface::Vertex_index v) { return given.numbers[v]; });
  write_pairs_and_diagram(options, given.graph, threshold, report, numbers);
  if(options.graph_path.empty())
    return;
  const Timed_step timed(report, "output");
  if(is_format_in_space(options.graph_path))
  {
    const Embedding embedding = embed_straight(simplified.result(), given.surface);
    report.embedding_manner = embedding.manner;
    write_graph_in_space(options.graph_path, simplified.result(), embedding, {}, {}); // which is no JSON
  }
  else
  {
    // lengths, areas, and numbers of vertices would need the surface
    std::vector<CGAL::Reeb_graph::Attribute> attributes;
    if(has_arc_attributes(options.graph_path))
      attributes.push_back({"persistence", CGAL::Reeb_graph::arc_persistences(simplified.result())});
    write_graph(options.graph_path, simplified.result(), label(options), numbers, attributes);
  }
}

// Collective.
Ranks_report gather(const Communicator& communicator, const Slab& slab, Rank_report& rank)
{
  rank.vertices = slab.vertices;
  rank.triangles = slab.triangles;
  rank.copies = slab.copies;
  rank.bytes_sent = slab.bytes_sent;
  rank.peak_memory_bytes = peak_memory_bytes();
  rank.cpu_seconds.emplace_back("total", cpu_seconds_of_process());
  Ranks_report report;
  report.slabs = slab.number_of_slabs;
  report.slabs_per_triangle = slab.crossings_per_triangle;
  boost::mpi::gather(communicator, rank, report.ranks, 0);
  return report;
}

} // namespace

template <class Archive>
void serialize(Archive& archive, Rank_report& rank, unsigned)
{
  archive& rank.vertices& rank.triangles& rank.copies& rank.bytes_sent& rank.peak_memory_bytes& rank.cpu_seconds;
}

void run_compute_on_ranks(const Communicator& communicator, const Compute_options& options)
{
  check_on_ranks(options);
  Report report;
  Rank_report rank;
  Step read("read", report, rank);
  const Local_mesh mesh = read_local_mesh(communicator, options.input);
  if(is_format_in_space(options.graph_path) && !mesh.point)
    refuse(options.graph_path, "a raw file has no points");
  const double threshold = threshold_in_units(options.simplification, [&] { return find_range(communicator, mesh); });
  read.end();
  Slab slab;
  const Graph_of_ranks graph = compute(communicator, mesh, options.graph, slab, report, rank);
  const double cpu_seconds = cpu_seconds_of_process();
  run_on_rank_0(communicator, [&] {
    Output_group files;
    write_results(options, graph, mesh, threshold, slab, report);
    files.put_in_place();
  });
  rank.cpu_seconds.emplace_back("output", cpu_seconds_of_process() - cpu_seconds);
  report.ranks = gather(communicator, slab, rank);
  run_on_rank_0(communicator, [&] {
    write_report(options.is_report_json, output_files(options), report);
    flush_standard_output();
  });
}

} // namespace reeb_graph_program
