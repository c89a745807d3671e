// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#include "base/report.h"
#include "commands/commands.h"
#include "computation/Mesh_graph.h"
#include "computation/analysis.h"
#include "computation/comparison.h"
#include "computation/simplification.h"
#include "input/field_input.h"
#include "input/input_error.h"
#include "output/comparison_output.h"
#include "output/graph_output.h"
#include "output/output_file.h"
#include "output/report_output.h"
#include "page/page_output.h"

#include <CGAL/Reeb_graph/comparison/match_arcs.h>

#include <algorithm>
#include <cstddef>
#include <deque>
#include <filesystem>
#include <memory>
#include <optional>
#include <set>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace reeb_graph_program {
namespace {
struct Shape
{
  Input_options input;
  Mesh mesh = {};
  Scalar_map scalar_map = {};
  std::unique_ptr<Mesh_graph> graph = {};
};

// That of a shape: the only one is that of all.
template <class T>
void set_if_given(T& option, const std::vector<T>& given, std::size_t shape)
{
  if(!given.empty())
    option = given[given.size() == 1 ? 0 : shape];
}

std::vector<Input_options> inputs_of(const Compare_options& options)
{
  const std::size_t number = options.mesh_paths.size();
  if(number < 2)
    throw std::runtime_error("compare needs two meshes or more");
  const auto check_number = [number](const std::string& name, std::size_t given) {
    if(given > 1 && given != number)
      throw std::runtime_error(name + " is given once for all meshes, or once for each: there are "
                               + std::to_string(number) + " meshes, and it is given " + std::to_string(given)
                               + " times");
  };
  check_number("--source", options.sources.size());
  check_number("--scalars", options.scalars_paths.size());
  std::vector<Input_options> inputs(number, options.input);
  for(std::size_t i = 0; i != number; ++i)
  {
    inputs[i].mesh_path = options.mesh_paths[i];
    inputs[i].is_repaired = inputs[i].is_border_taken = !options.input.is_strict;
    set_if_given(inputs[i].scalars_path, options.scalars_paths, i);
    set_if_given(inputs[i].source_vertices, options.sources, i);
  }
  return inputs;
}

std::vector<std::filesystem::path> check_options(const Compare_options& options)
{
  if(!options.page_path.empty() && options.mesh_paths.size() != 2)
    throw std::runtime_error("--html shows two meshes, not " + std::to_string(options.mesh_paths.size()));
  if(!(options.price_alone >= 0))
    throw std::runtime_error("--price-alone must not be negative or NaN");
  check_page(options.page_path, options.up);
  check_matrix_format(options.matrix_path);
  check_simplification_options(options.simplification);
  if(std::count_if(options.mesh_paths.begin(), options.mesh_paths.end(), is_standard_input) > 1)
    throw std::runtime_error("only one input can be standard input");
  const std::vector<std::filesystem::path> outputs = {options.matrix_path, options.page_path};
  check_outputs(outputs, input_files(options.mesh_paths, options.scalars_paths));
  return outputs;
}

// The names of the files, or where two are the same, as they were given.
std::vector<std::string> names_of(const std::vector<std::string>& paths)
{
  std::vector<std::string> names;
  for(const std::string& path : paths)
    names.push_back(name_of_input(path));
  return std::set<std::string>(names.begin(), names.end()).size() == names.size() ? names : paths;
}

// Distances from tips that stand for the same place mean the same on all shapes.
void choose_sources(std::deque<Shape>& shapes, Comparison_report& report)
{
  const auto [first, last] = std::make_pair(shapes.begin(), shapes.end());
  if((first->input.field != "geodesic" && first->input.field != "poisson")
     || std::any_of(first, last, [](const Shape& shape) { return !shape.input.source_vertices.empty(); }))
    return;
  std::vector<const Surface*> surfaces;
  for(const Shape& shape : shapes)
    surfaces.push_back(&shape.mesh.surface);
  const std::vector<std::size_t> tips = timed(report, "tips", [&] { return find_like_tips(surfaces); });
  report.notes.push_back(tips.empty() ? "sources may stand for different places, as no tips are alike: choose them by "
                                        "--source"
                                      : "sources are the tips that are most alike");
  for(std::size_t i = 0; i != tips.size(); ++i)
  {
    shapes[i].input.source_vertices = {tips[i]};
    for(const auto v : surfaces[i]->vertices())
      if(surfaces[i]->is_isolated(v))
        shapes[i].input.source_vertices.push_back(v);
  }
}

void compute(Shape& shape, const Compare_options& options, Report& report)
{
  shape.scalar_map = add_field(shape.input, shape.mesh.surface, report);
  Graph_options graph_options = options.graph;
  graph_options.are_places_wanted = !options.page_path.empty();
  shape.graph =
    compute_mesh_graph(shape.mesh, shape.scalar_map, graph_options, options.simplification,
                       threshold_in_units(options.simplification, shape.mesh.surface, shape.scalar_map), report);
  count_all(shape.mesh, shape.graph->given(), report);
  if(options.simplification.is_anything_removed())
    count_simplified(shape.graph->result(), shape.graph->threshold(), report);
}

// The only arc that begins at a source.
std::optional<std::size_t> arc_at_source(const Shape& shape, const Report& report)
{
  std::vector<std::size_t> arcs;
  const Graph& graph = shape.graph->result();
  for(const auto arc : CGAL::make_range(edges(graph)))
    for(const auto& [vertex, value] :
        report.fixed_values ? report.fixed_values->vertices : std::vector<Fixed_values::Place>())
      if(value == 0 && graph[source(arc, graph)].vertex.idx() == vertex)
        arcs.push_back(get(boost::edge_index, graph, arc));
  return arcs.size() == 1 ? std::optional(arcs.front()) : std::nullopt;
}

void match(Shape& a, Shape& b, double price_alone, Comparison_report& report)
{
  const Timed_step timed(report, "match");
  try
  {
    report.partners = match_arcs(*a.graph, *b.graph, price_alone);
  }
  catch(const CGAL::Reeb_graph::Too_many_arcs_error& error)
  {
    throw std::runtime_error(std::string(error.what()) + ", as by --simplify auto");
  }
  const auto arc_a = arc_at_source(a, report.shapes[0]), arc_b = arc_at_source(b, report.shapes[1]);
  if(arc_a && arc_b)
    report.are_sources_on_partners =
      std::count(report.partners->begin(), report.partners->end(), std::make_pair(*arc_a, *arc_b)) != 0;
}

void measure(const std::deque<Shape>& shapes, Comparison_report& report)
{
  const Timed_step timed(report, "distances");
  std::vector<Persistence_values> pairs;
  for(const Shape& shape : shapes)
    pairs.push_back(find_persistence_values(shape.graph->given()));
  report.distances = find_distances(pairs);
  if(pairs.size() == 2)
    report.by_kind = distances_by_kind(pairs[0], pairs[1]);
}

void write_files(const Compare_options& options, std::deque<Shape>& shapes, Comparison_report& report)
{
  const Timed_step timed(report, "output");
  Output_group files;
  if(!options.matrix_path.empty())
    write_matrix(options.matrix_path, report);
  if(!options.page_path.empty())
  {
    const auto request = [&](std::size_t i) {
      return Page_request{
        shapes[i].scalar_map, *shapes[i].graph, report.names[i], {report.field, options.unit}, {}, options.up};
    };
    write_page(options.page_path, {request(0), request(1), *report.partners, report.distances[0][1]});
  }
  files.put_in_place();
}

} // namespace

void run_compare(const Compare_options& options)
{
  const std::vector<Input_options> inputs = inputs_of(options);
  const std::vector<std::filesystem::path> outputs = check_options(options);
  Comparison_report report;
  report.names = names_of(options.mesh_paths);
  report.field = field_label(inputs.front(), "").name;
  report.shapes.resize(inputs.size());
  std::deque<Shape> shapes; // which stay where they are
  for(std::size_t i = 0; i != inputs.size(); ++i)
  {
    Shape& shape = shapes.emplace_back(Shape{inputs[i]});
    shape.mesh.surface = read_surface("compare", inputs[i], report.shapes[i]);
    if(shape.mesh.surface.number_of_faces() == 0)
      throw Input_error(inputs[i].mesh_path, "there are no faces, and so nothing to compare");
  }
  choose_sources(shapes, report);
  for(std::size_t i = 0; i != shapes.size(); ++i)
    compute(shapes[i], options, report.shapes[i]);
  measure(shapes, report);
  if(shapes.size() == 2)
    match(shapes[0], shapes[1], options.price_alone, report);
  write_files(options, shapes, report);
  note_lost_unit(options.unit, !options.page_path.empty(), report.notes);
  write_report(options.is_report_json, outputs, report);
}

} // namespace reeb_graph_program
