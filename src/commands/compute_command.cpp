// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of the CGAL-style package Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#include "base/complex.h"
#include "base/report.h"
#include "base/stopwatch.h"
#include "commands/commands.h"
#include "computation/analysis.h"
#include "computation/augmentation.h"
#include "computation/complex_counts.h"
#include "computation/complex_graph.h"
#include "computation/embedding.h"
#include "computation/simplification.h"
#include "computation/simplified_field.h"
#include "input/field_input.h"
#include "input/input_error.h"
#include "output/diagram_output.h"
#include "output/graph_output.h"
#include "output/mesh_output.h"
#include "output/output_file.h"
#include "output/pairs_output.h"
#include "output/report_output.h"
#include "page/page_output.h"

#include <cstddef>
#include <filesystem>
#include <optional>
#include <ostream>
#include <stdexcept>
#include <string>
#include <vector>

namespace reeb_graph_program {
namespace {
bool is_graph_in_space(const Compute_options& options)
{
  return !options.graph_path.empty() && is_format_in_space(options.graph_path);
}

std::vector<std::filesystem::path> output_files(const Compute_options& options)
{
  std::vector<std::filesystem::path> paths = graph_files(options.graph_path);
  paths.insert(paths.end(), {options.vertex_arcs_path, options.pairs_path, options.diagram_path, options.mesh_path,
                             options.simplified_scalars_path, options.page_path});
  return paths;
}

void check(const Compute_options& options)
{
  if(!options.graph_path.empty())
    check_graph_format(options.graph_path);
  if(!options.pairs_path.empty())
    check_pairs_format(options.pairs_path);
  if(!options.diagram_path.empty())
    check_diagram_format(options.diagram_path);
  if(!options.page_path.empty())
    check_page(options.page_path);
  if(!options.mesh_path.empty())
    check_mesh_format(options.mesh_path);
  check_outputs(output_files(options), input_files(options.input));
  if(options.embedding_manner && !is_graph_in_space(options))
    throw std::runtime_error("--embedding goes with --graph and a format in space only: .vtp, .obj, .polylines.txt, "
                             ".json, or .csv");
  check_simplification_options(options.simplification);
  if(options.simplified_scalars_path.empty())
    return;
  if(!options.simplification.is_anything_removed())
    throw std::runtime_error("--simplified-scalars goes with --simplify or --leaves only");
  check_simplification_of_field(options.simplification);
}

std::vector<std::size_t> places_of(const Surface& surface, const Vertex_locations& locations)
{
  std::vector<std::size_t> places;
  places.reserve(surface.number_of_vertices());
  for(const Surface::Vertex_index v : surface.vertices())
    places.push_back(locations.index(v));
  return places;
}

Graph_in_space embed_and_time(const Compute_options& options,
                              const Augmentation& augmentation,
                              const std::vector<Arc_row>& arcs,
                              Report& report)
{
  const Stopwatch stopwatch;
  // tables hold no lines, only the points of nodes
  const auto default_manner = std::filesystem::path(options.graph_path).extension() == ".csv"
                              ? CGAL::Reeb_graph::Embedding_manner::STRAIGHT
                              : CGAL::Reeb_graph::Embedding_manner::BY_COST;
  Graph_in_space result = embed_graph(augmentation, options.embedding_manner.value_or(default_manner),
                                      has_arc_attributes(options.graph_path) ? &arcs : nullptr);
  report.embedding_manner = result.embedding.manner;
  report.seconds.emplace_back("embed", stopwatch.seconds());
  return result;
}

// The vertices are located if one of the files or the table needs it. Returns the arcs, if one of these tells of them.
std::vector<Arc_row> write_files_of_surface(const Compute_options& options,
                                            const Simplified_graph& graph,
                                            const Surface& surface,
                                            Scalar_map scalar_map,
                                            Report& report)
{
  constexpr std::size_t few_arcs = 40;
  const bool has_table = options.is_table_wanted.value_or(num_edges(graph.result()) <= few_arcs);
  const bool has_measures = !options.graph_path.empty() && has_arc_attributes(options.graph_path);
  const bool has_file = !options.vertex_arcs_path.empty() || !options.mesh_path.empty() || is_graph_in_space(options);
  if(!has_table && !has_measures && !has_file)
    return {};
  const Stopwatch stopwatch;
  const Augmentation augmentation = graph.augmentation(surface, scalar_map, options.graph);
  const Vertex_locations locations = locate_vertices(augmentation);
  std::vector<Arc_row> arcs;
  if(has_table || has_measures)
    arcs = measure_arcs(surface, scalar_map, graph.result(), locations);
  if(has_table)
    report.arc_table = arcs;
  report.seconds.emplace_back("locate", stopwatch.seconds());
  if(!has_file)
    return arcs;
  std::optional<Graph_in_space> graph_in_space;
  if(is_graph_in_space(options))
    graph_in_space = embed_and_time(options, augmentation, arcs, report);
  const Stopwatch output_stopwatch;
  if(!options.vertex_arcs_path.empty())
    write_vertex_arcs(options.vertex_arcs_path, places_of(surface, locations), num_vertices(graph.result()));
  if(!options.mesh_path.empty())
    write_mesh(options.mesh_path, surface, {scalar_map, locations, num_vertices(graph.result()), std::nullopt});
  if(graph_in_space)
    write_graph_in_space(options.graph_path, graph.result(), *graph_in_space, surface);
  report.add_seconds("output", output_stopwatch.seconds());
  return arcs;
}

void write_graph_file(const Compute_options& options,
                      const Graph& graph,
                      const std::vector<CGAL::Reeb_graph::Attribute>& attributes,
                      Report& report)
{
  if(options.graph_path.empty() || is_graph_in_space(options))
    return;
  const Stopwatch stopwatch;
  write_graph(options.graph_path, graph, field_label(options.input, options.unit), {}, attributes);
  report.add_seconds("output", stopwatch.seconds());
}

// The attributes of a graph file without points.
std::vector<CGAL::Reeb_graph::Attribute> arc_attributes_of_file(const Compute_options& options,
                                                                const Graph& graph,
                                                                const std::vector<Arc_row>& arcs)
{
  const bool has_attributes =
    !options.graph_path.empty() && !is_graph_in_space(options) && has_arc_attributes(options.graph_path);
  return has_attributes ? arc_attributes(graph, arcs) : std::vector<CGAL::Reeb_graph::Attribute>();
}

void write_page_file(const Compute_options& options,
                     const Graph& given,
                     const Surface& surface,
                     Scalar_map scalar_map,
                     double threshold,
                     Report& report)
{
  if(options.page_path.empty())
    return;
  const Stopwatch stopwatch;
  write_page(options.page_path, {surface, scalar_map, given, options.graph,
                                 std::filesystem::path(options.input.mesh_path).filename().string(),
                                 field_label(options.input, options.unit), options.simplification, threshold});
  report.seconds.emplace_back("page", stopwatch.seconds());
}

void write_simplified_field(const Compute_options& options,
                            Surface& surface,
                            Scalar_map scalar_map,
                            double threshold,
                            Report& report)
{
  if(options.simplified_scalars_path.empty())
    return;
  const Stopwatch stopwatch;
  const Scalar_map simplified_map = surface.add_property_map<Surface::Vertex_index, double>("v:simplified").first;
  const Simplified_field field = compute_simplified_field(surface, scalar_map, options.simplification, threshold,
                                                          options.graph.ties, simplified_map);
  report.simplification->largest_change = field.largest_change;
  report.simplification->are_ties_contracted = field.are_ties_contracted;
  write_scalars(options.simplified_scalars_path, surface, simplified_map);
  report.seconds.emplace_back("simplified field", stopwatch.seconds());
}

void write_report(const Compute_options& options, const Report& report)
{
  std::ostream& stream = report_stream(output_files(options));
  if(options.is_report_json)
    write_json(stream, report);
  else
    write_text(stream, report);
}

void compute_on_surface(const Compute_options& options, Surface& surface, Report& report)
{
  const Scalar_map scalar_map = add_field(options.input, surface, report);
  const double threshold = threshold_in_units(options.simplification, surface, scalar_map);
  const Graph given = compute_and_time(surface, scalar_map, options.graph, report);
  const Stopwatch simplify_stopwatch;
  const Simplified_graph graph(given, options.simplification, threshold);
  const double simplify_seconds = simplify_stopwatch.seconds();
  count_all(surface, given, report);
  if(options.simplification.is_anything_removed())
  {
    report.seconds.emplace_back("simplify", simplify_seconds);
    count_simplified(graph.result(), threshold, report);
  }
  write_simplified_field(options, surface, scalar_map, threshold, report);
  write_pairs_and_diagram(options, given, threshold, report);
  const std::vector<Arc_row> arcs = write_files_of_surface(options, graph, surface, scalar_map, report);
  write_graph_file(options, graph.result(), arc_attributes_of_file(options, graph.result(), arcs), report);
  write_page_file(options, given, surface, scalar_map, threshold, report);
  write_report(options, report);
}

// What needs contours that are curves, or faces with two sides.
void check_for_complex(const Compute_options& options, const Complex& complex)
{
  const auto check_left_out = [&](bool is_left_out, const std::string& option) {
    if(!is_left_out)
      throw Input_error(options.input.mesh_path,
                        option + " needs an oriented manifold surface; " + describe_obstacle(complex));
  };
  check_left_out(options.page_path.empty(), "--html");
  check_left_out(options.mesh_path.empty(), "--mesh-out");
  check_left_out(options.simplified_scalars_path.empty(), "--simplified-scalars");
  check_left_out(!options.is_table_wanted.value_or(false), "--table");
  check_left_out(options.embedding_manner.value_or(CGAL::Reeb_graph::Embedding_manner::STRAIGHT)
                   == CGAL::Reeb_graph::Embedding_manner::STRAIGHT,
                 "--embedding but straight");
}

void compute_on_complex(const Compute_options& options, Mesh& mesh, Report& report)
{
  check_for_complex(options, *mesh.complex);
  const Scalar_map scalar_map = add_field(options.input, mesh, report);
  const double threshold = threshold_in_units(options.simplification, mesh.surface, scalar_map);
  const Complex_graph given = compute_and_time(mesh, scalar_map, options.graph, report);
  const Stopwatch simplify_stopwatch;
  const Simplified_complex_graph graph(given, options.simplification, threshold);
  const double simplify_seconds = simplify_stopwatch.seconds();
  count_all(mesh, given, report);
  if(options.simplification.is_anything_removed())
    report.seconds.emplace_back("simplify", simplify_seconds);
  const Stopwatch locate_stopwatch;
  if(!options.vertex_arcs_path.empty())
  {
    write_vertex_arcs(options.vertex_arcs_path, locate_vertices(mesh, scalar_map, graph, options.graph),
                      num_vertices(graph.result()));
    report.seconds.emplace_back("locate", locate_stopwatch.seconds());
  }
  const bool are_chains_written = std::filesystem::path(options.graph_path).extension() == ".json";
  const Graph result = graph_on_vertices(graph.result(), mesh.surface, are_chains_written);
  if(options.simplification.is_anything_removed())
    count_simplified(result, threshold, report);
  write_pairs_and_diagram(options, graph_on_vertices(given, mesh.surface, false), threshold, report);
  if(is_graph_in_space(options))
  {
    const Stopwatch embed_stopwatch;
    const Graph_in_space graph_in_space = embed_straight(result, mesh.surface);
    report.embedding_manner = graph_in_space.embedding.manner;
    report.seconds.emplace_back("embed", embed_stopwatch.seconds());
    const Stopwatch stopwatch;
    write_graph_in_space(options.graph_path, result, graph_in_space, mesh.surface);
    report.add_seconds("output", stopwatch.seconds());
  }
  write_graph_file(options, result, {}, report);
  write_report(options, report);
}

} // namespace

void write_pairs_and_diagram(const Compute_options& options,
                             const Graph& graph,
                             double threshold,
                             Report& report,
                             const Vertex_numbers& vertex_numbers)
{
  if(options.pairs_path.empty() && options.diagram_path.empty() && !options.is_report_json)
    return;
  const Stopwatch stopwatch;
  const std::vector<Persistence_pair> pairs = find_persistence_pairs(graph);
  report.suggested_threshold = suggest_threshold(graph, pairs);
  report.seconds.emplace_back("pairs", stopwatch.seconds());
  if(!options.pairs_path.empty())
    write_pairs(options.pairs_path, graph, pairs, vertex_numbers);
  if(!options.diagram_path.empty())
    write_diagram(options.diagram_path, graph, pairs,
                  options.simplification.threshold ? std::optional<double>(threshold) : std::nullopt);
}

void run_compute(const Compute_options& options)
{
  check(options);
  Report report;
  Mesh mesh = read_mesh(options.input, report);
  if(mesh.complex)
    compute_on_complex(options, mesh, report);
  else
    compute_on_surface(options, mesh.surface, report);
}

} // namespace reeb_graph_program
