// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#include "base/report.h"
#include "base/surface.h"
#include "commands/commands.h"
#include "computation/Mesh_graph.h"
#include "computation/analysis.h"
#include "computation/longest_loop.h"
#include "computation/simplification.h"
#include "input/field_input.h"
#include "input/input_error.h"
#include "output/graph_output.h"
#include "output/mesh_output.h"
#include "output/output_file.h"
#include "output/polylines_output.h"
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
// Whether the file of the graph has measures of arcs. On what is no surface, that can take long, and is left to who asks
// for the table.
bool are_attributes_written(const Compute_options& options, bool is_surface)
{
  return !options.graph_path.empty() && has_arc_attributes(options.graph_path)
      && (is_surface || options.is_table_wanted.value_or(false));
}

// What needs the places of vertices, but for the table of a graph of few arcs, which is not known before.
bool are_places_wanted(const Compute_options& options, bool is_surface)
{
  return options.is_table_wanted.value_or(false) || are_attributes_written(options, is_surface)
      || !options.vertex_arcs_path.empty() || !options.mesh_path.empty() || !options.page_path.empty()
      || !options.simplified_scalars_path.empty() || !options.loop_path.empty();
}

std::vector<std::filesystem::path> output_files(const Compute_options& options)
{
  std::vector<std::filesystem::path> paths = graph_files(options.graph_path);
  paths.insert(paths.end(), {options.vertex_arcs_path, options.pairs_path, options.diagram_path, options.loop_path,
                             options.mesh_path, options.simplified_scalars_path, options.page_path});
  return paths;
}

void add_base(double base, std::vector<double>& values)
{
  for(double& value : values)
    value += base;
}

Embedding embed_and_time(const Compute_options& options, bool is_surface, Mesh_graph& graph, Report& report)
{
  const Timed_step timed(report, "embed");
  // tables hold no lines, only the points of nodes
  const auto default_manner = !is_surface || std::filesystem::path(options.graph_path).extension() == ".csv"
                              ? CGAL::Reeb_graph::Embedding_manner::STRAIGHT
                              : CGAL::Reeb_graph::Embedding_manner::BY_COST;
  Embedding result = graph.embed(options.embedding_manner.value_or(default_manner));
  add_base(options.base, result.node_values);
  for(std::vector<double>& values : result.arc_values)
    add_base(options.base, values);
  report.embedding_manner = result.manner;
  return result;
}

// Arcs are measured if a file or the table needs it. Returns what files of graphs write of them.
std::vector<CGAL::Reeb_graph::Attribute> write_files_of_mesh(const Compute_options& options,
                                                             Mesh_graph& graph,
                                                             const Mesh& mesh,
                                                             Scalar_map scalar_map,
                                                             Report& report)
{
  constexpr std::size_t few_arcs = 40;
  const std::size_t number_of_nodes = num_vertices(graph.result());
  const bool is_surface = !mesh.complex;
  const bool has_table = options.is_table_wanted.value_or(num_edges(graph.result()) <= few_arcs);
  const bool has_places = !options.vertex_arcs_path.empty() || !options.mesh_path.empty();
  const bool has_attributes = are_attributes_written(options, is_surface);
  if(!options.graph_path.empty() && has_arc_attributes(options.graph_path) && !has_attributes
     && !options.is_table_wanted)
    report.notes.push_back(options.graph_path
                           + ": measures of arcs are left out, as they can take long; --table adds them");
  std::vector<CGAL::Reeb_graph::Attribute> attributes;
  if(has_table || has_attributes)
  {
    const Timed_step timed(report, "measure");
    const Arc_table& table = graph.arc_table();
    if(has_table)
      report.arc_table = &table;
    if(has_attributes)
      attributes = table.attributes(options.base);
  }
  std::optional<Embedding> embedding;
  if(is_format_in_space(options.graph_path))
    embedding = embed_and_time(options, is_surface, graph, report);
  if(!embedding && !has_places)
    return attributes;
  const Timed_step timed(report, "output");
  if(!options.vertex_arcs_path.empty())
    write_vertex_arcs(options.vertex_arcs_path, graph.places(), number_of_nodes);
  if(!options.mesh_path.empty())
    write_mesh(options.mesh_path, mesh, {scalar_map, graph.places(), number_of_nodes, std::nullopt}, report.notes);
  std::optional<Graph> copy;
  if(embedding)
  {
    note_lost_nodes(options.graph_path, graph.result(), report.notes);
    write_graph_in_space(options.graph_path, with_base(graph.result(), options.base, copy), *embedding, attributes,
                         [&](std::ostream& stream) { graph.write_json(stream, *embedding, attributes, options.base); });
  }
  return attributes;
}

void write_graph_file(const Compute_options& options,
                      const Graph& graph,
                      const std::vector<CGAL::Reeb_graph::Attribute>& arc_attributes,
                      Report& report)
{
  if(options.graph_path.empty() || is_format_in_space(options.graph_path))
    return;
  const Timed_step timed(report, "output");
  std::optional<Graph> copy;
  write_graph(options.graph_path, with_base(graph, options.base, copy), field_label(options.input, options.unit),
              own_numbers, arc_attributes);
}

void write_page_file(const Compute_options& options,
                     Mesh_graph& graph,
                     Scalar_map scalar_map,
                     const Loops_of_surface& loops,
                     Report& report)
{
  if(options.page_path.empty())
    return;
  const Timed_step timed(report, "page");
  write_page(options.page_path,
             {scalar_map, graph, options.title.empty() ? name_of_input(options.input.mesh_path) : options.title,
              field_label(options.input, options.unit), options.simplification, options.up, std::nullopt,
              loops.polylines, loops.rows});
}

void write_simplified_field(const Compute_options& options,
                            Mesh& mesh,
                            Scalar_map scalar_map,
                            Mesh_graph& graph,
                            Report& report)
{
  if(options.simplified_scalars_path.empty())
    return;
  const Timed_step timed(report, "simplified field");
  const Scalar_map simplified_map = mesh.surface.add_property_map<Surface::Vertex_index, double>("v:simplified").first;
  const Simplified_field field =
    compute_simplified_field(mesh, scalar_map, graph, options.graph, options.simplification, simplified_map);
  report.simplification->largest_change = field.largest_change;
  report.simplification->are_ties_contracted = field.are_ties_contracted;
  write_scalars(options.simplified_scalars_path, mesh.surface, simplified_map);
}

// Returns what the file has.
Loops_of_surface write_longest_loop(const Compute_options& options, Mesh_graph& graph, Report& report)
{
  if(options.loop_path.empty())
    return {};
  const Timed_step timed(report, "longest loop");
  const Loops_of_surface loops = find_longest_loop(graph);
  write_loops(options.loop_path, loops);
  report.longest_loop = loops.rows.front();
  return loops;
}

} // namespace

void check(const Compute_options& options)
{
  check_graph_format(options.graph_path);
  check_pairs_format(options.pairs_path);
  check_diagram_format(options.diagram_path);
  check_loops_format(options.loop_path);
  check_page(options.page_path, options.up, options.input.is_strict);
  check_mesh_format(options.mesh_path);
  check_outputs(output_files(options), input_files(options.input));
  check_numbers_format(options.vertex_arcs_path);
  check_numbers_format(options.simplified_scalars_path);
  if(options.embedding_manner && !is_format_in_space(options.graph_path))
    throw std::runtime_error("--embedding goes with --graph and a format in space only: .vtp, .obj, .polylines.txt, "
                             ".json, or .csv");
  check_simplification_options(options.simplification);
  if(options.simplified_scalars_path.empty())
    return;
  if(!options.simplification.is_anything_removed())
    throw std::runtime_error("--simplified-scalars goes with --simplify or --leaves only");
  check_simplification_of_field(options.simplification);
}

void check_for_complex(const Compute_options& options, const Mesh& mesh)
{
  const auto check = [&](const std::filesystem::path& path, const std::string& option) {
    const std::string reason = path.empty() ? "" : reason_against(option, mesh);
    if(!reason.empty())
      throw Input_error(options.input.mesh_path, reason);
  };
  check(options.page_path, "--html");
  check(options.simplified_scalars_path, "--simplified-scalars");
  check(options.mesh_path, "--mesh-out");
}

void write_results(const Compute_options& options, Mesh& mesh, Scalar_map scalar_map, Mesh_graph& graph, Report& report)
{
  const double threshold = graph.threshold();
  count_all(mesh, graph.given(), report);
  if(options.simplification.is_anything_removed())
    count_simplified(graph.result(), threshold, report);
  Output_group files;
  const Loops_of_surface loops = write_longest_loop(options, graph, report);
  write_simplified_field(options, mesh, scalar_map, graph, report);
  write_pairs_and_diagram(options, graph.given(), threshold, report);
  const auto attributes = write_files_of_mesh(options, graph, mesh, scalar_map, report);
  write_graph_file(options, graph.result(), attributes, report);
  write_page_file(options, graph, scalar_map, loops, report);
  files.put_in_place();
  const bool is_unit_shown =
    !options.page_path.empty() || std::filesystem::path(options.graph_path).extension() == ".svg";
  note_lost_unit(options.unit, is_unit_shown, report.notes);
}

void write_pairs_and_diagram(const Compute_options& options,
                             const Graph& graph,
                             double threshold,
                             Report& report,
                             const Vertex_numbers& vertex_numbers)
{
  report.thresholds =
    timed(report, "thresholds", [&] { return find_thresholds(graph, options.simplification.are_loops_cancelled); });
  if(options.pairs_path.empty() && options.diagram_path.empty())
    return;
  const std::vector<Persistence_pair> pairs = timed(report, "pairs", [&] { return find_persistence_pairs(graph); });
  std::optional<Graph> copy;
  if(!options.pairs_path.empty())
    write_pairs(options.pairs_path, with_base(graph, options.base, copy), pairs, vertex_numbers);
  if(!options.diagram_path.empty())
    write_diagram(options.diagram_path, graph, pairs,
                  options.simplification.threshold ? std::optional<double>(threshold) : std::nullopt);
}

void run_compute(const Compute_options& options)
{
  check(options);
  Report report;
  Input_options input = options.input;
  input.is_repaired = !input.is_strict && !options.page_path.empty();
  Mesh mesh = read_mesh(input, report);
  if(mesh.complex)
    check_for_complex(options, mesh);
  const Scalar_map scalar_map = add_field(options.input, mesh, report);
  Graph_options graph_options = options.graph;
  graph_options.are_places_wanted = are_places_wanted(options, !mesh.complex);
  const auto graph = compute_mesh_graph(mesh, scalar_map, graph_options, options.simplification,
                                        threshold_in_units(options.simplification, mesh.surface, scalar_map), report);
  write_results(options, mesh, scalar_map, *graph, report);
  write_report(options.is_report_json, output_files(options), report);
}

} // namespace reeb_graph_program
