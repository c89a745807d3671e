// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of the CGAL-style package Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#include "arrays.h"
#include "run.h"

#include "commands/commands.h"
#include "computation/Mesh_graph.h"
#include "computation/simplification.h"
#include "computation/simplified_field.h"
#include "input/mesh_input.h"
#include "output/report_output.h"

#include <CGAL/Reeb_graph/graph_topology.h>

#include <boost/property_map/property_map.hpp>

#include <pybind11/stl/filesystem.h>

#include <cmath>
#include <iterator>
#include <memory>
#include <mutex>
#include <optional>
#include <sstream>
#include <tuple>
#include <variant>

// The module reeb_graph._core, on which the Python of the package reeb_graph stands: numbers and arrays only.
namespace reeb_graph_python {
namespace {
typedef std::vector<std::size_t> Numbers;

struct Input
{
  Mesh mesh;
  Scalar_map scalar_map;
  std::mutex mutex;
};

// A graph, as it has been computed or simplified. Who uses it holds the mutex of the input: what is found on demand is
// kept, and the mesh gets more maps.
struct Graph_of_arrays
{
  std::shared_ptr<Input> input = std::make_shared<Input>();
  Graph_options options;
  Simplification_options simplification;
  Report report; // of computing it
  std::unique_ptr<Mesh_graph> mesh_graph;

  const Graph& graph() const { return mesh_graph->result(); }
};
typedef std::shared_ptr<Graph_of_arrays> Graph_pointer;

Graph_pointer compute(const Mesh_arrays& arrays,
                      const Value_array& scalars,
                      bool are_ties_contracted,
                      bool are_degree_two_nodes_kept,
                      std::size_t threads,
                      const py::object& progress)
{
  struct Work
  {
    Values scalars;
    Polygon_soup soup;
    Graph_pointer graph = std::make_shared<Graph_of_arrays>();
  };
  const auto work = std::make_shared<Work>();
  work->scalars = Values(scalars);
  work->soup = copy_arrays(arrays, work->scalars.size());
  Graph_options& options = work->graph->options;
  options.ties = are_ties_contracted ? CGAL::Reeb_graph::Ties::CONTRACT : CGAL::Reeb_graph::Ties::PERTURB;
  options.are_degree_two_nodes_kept = are_degree_two_nodes_kept;
  run(
    progress, threads,
    [work] {
      Graph_of_arrays& graph = *work->graph;
      Input& input = *graph.input;
      input.mesh = make_mesh(work->soup, "the mesh");
      work->soup = Polygon_soup();
      input.scalar_map = work->scalars.add_to(input.mesh.surface, "v:scalar");
      work->scalars = Values();
      graph.mesh_graph = compute_mesh_graph(input.mesh, input.scalar_map, graph.options, {}, 0, graph.report);
    },
    true);
  return work->graph;
}

// A function that does `work` on the graph without the interpreter's lock, and makes an object of the result.
template <class Result, class... Arguments>
auto running(Result (*work)(Graph_of_arrays&, Arguments...))
{
  return [work](Graph_of_arrays& graph, Arguments... arguments, std::size_t threads, const py::object& progress) {
    std::optional<Result> result;
    run(progress, threads, [&] {
      const std::lock_guard lock(graph.input->mutex);
      result.emplace(work(graph, arguments...));
    });
    if constexpr(std::is_same_v<Result, Graph_pointer>)
      return *result;
    else
      return to_object(*result);
  };
}

// With an option of the program: a threshold in units of the field or in percent, NaN for the one that the graph
// suggests, or a number of leaves.
Graph_pointer simplify(Graph_of_arrays& graph,
                       std::optional<double> threshold,
                       bool is_percentage,
                       std::optional<std::size_t> leaves,
                       bool are_loops_cancelled)
{
  const auto result = std::make_shared<Graph_of_arrays>();
  result->input = graph.input;
  result->options = graph.options;
  result->report = graph.report;
  if(threshold)
    result->simplification.threshold = Threshold{*threshold, is_percentage, std::isnan(*threshold)};
  result->simplification.number_of_leaves = leaves;
  result->simplification.are_loops_cancelled = are_loops_cancelled;
  result->mesh_graph = graph.mesh_graph->simplify(
    result->simplification,
    threshold_in_units(result->simplification, graph.input->mesh.surface, graph.input->scalar_map));
  return result;
}

std::tuple<Numbers, std::vector<double>, Numbers> nodes(Graph_of_arrays& given)
{
  const Graph& graph = given.graph();
  std::tuple<Numbers, std::vector<double>, Numbers> result;
  for(const auto node : CGAL::make_range(vertices(graph)))
  {
    std::get<0>(result).push_back(graph[node].vertex);
    std::get<1>(result).push_back(graph[node].value);
    std::get<2>(result).push_back(static_cast<std::size_t>(graph[node].kind));
  }
  return result;
}

std::vector<std::array<std::size_t, 2>> arcs(Graph_of_arrays& given)
{
  std::vector<std::array<std::size_t, 2>> ends;
  for(const auto arc : CGAL::make_range(edges(given.graph())))
    ends.push_back({source(arc, given.graph()), target(arc, given.graph())});
  return ends;
}

std::tuple<Numbers, Numbers, std::vector<std::string>> pairs(Graph_of_arrays& given)
{
  std::tuple<Numbers, Numbers, std::vector<std::string>> result;
  for(const Persistence_pair& pair : find_persistence_pairs(given.graph()))
  {
    std::get<0>(result).push_back(pair.lower_node);
    std::get<1>(result).push_back(pair.upper_node);
    std::get<2>(result).push_back(to_string(pair.kind));
  }
  return result;
}

std::vector<Numbers> loops(Graph_of_arrays& given)
{
  std::vector<std::vector<boost::graph_traits<Graph>::edge_descriptor>> loops;
  CGAL::Reeb_graph::cycle_basis(given.graph(), std::back_inserter(loops));
  std::vector<Numbers> numbers;
  for(const auto& loop : loops)
  {
    numbers.emplace_back();
    for(const auto arc : loop)
      numbers.back().push_back(get(boost::edge_index, given.graph(), arc));
  }
  return numbers;
}

Numbers components(Graph_of_arrays& given)
{
  Numbers components(num_vertices(given.graph()));
  CGAL::Reeb_graph::number_components(
    given.graph(),
    boost::make_iterator_property_map(components.begin(), boost::typed_identity_property_map<std::size_t>()));
  return components;
}

// Those at the place `t` of all arcs, or of one, or at a level.
std::vector<Contour> contours(Graph_of_arrays& graph,
                              std::optional<std::size_t> arc,
                              std::optional<double> t,
                              std::optional<double> level)
{
  Contour_choice choice;
  choice.arc = arc;
  choice.t = t;
  if(level)
    choice.levels = {*level};
  choice.may_be_none = true;
  return graph.mesh_graph->find_contours(choice);
}

// The names of the measures of arcs, and a column for each.
std::tuple<std::vector<std::string>, std::vector<std::vector<double>>> measures(Graph_of_arrays& graph)
{
  std::tuple<std::vector<std::string>, std::vector<std::vector<double>>> result;
  for(const CGAL::Reeb_graph::Attribute& attribute :
      attributes_of_arcs(graph.graph(), graph.mesh_graph->measure_arcs()))
  {
    std::get<0>(result).push_back(attribute.name);
    std::visit([&](const auto& values) { std::get<1>(result).emplace_back(values.begin(), values.end()); },
               attribute.numbers);
  }
  return result;
}

typedef CGAL::Reeb_graph::Embedding_manner Manner;

std::tuple<Numbers, std::vector<Point>, std::vector<Polyline>, std::vector<std::vector<double>>> embed(
  Graph_of_arrays& graph,
  Manner manner)
{
  const auto embedding = graph.mesh_graph->embed(manner, nullptr).embedding;
  return {
    {static_cast<std::size_t>(embedding.manner)}, embedding.node_points, embedding.arc_polylines, embedding.arc_values};
}

// A field that has the graph, and whether ties were contracted for it, though not asked for.
std::tuple<std::vector<double>, Numbers> simplified_scalars(Graph_of_arrays& graph)
{
  Surface& surface = graph.input->mesh.surface;
  const Scalar_map map = surface.add_property_map<Surface::Vertex_index, double>("v:simplified").first;
  const Simplified_field field = compute_simplified_field(surface, graph.input->scalar_map, graph.simplification,
                                                          graph.mesh_graph->threshold(), graph.options.ties, map);
  return {std::vector<double>(map.begin(), map.end()), Numbers(1, field.are_ties_contracted ? 1 : 0)};
}

// Writes the files that are asked for, and returns the report of the program as JSON.
std::string write(Graph_of_arrays& graph, Compute_options options)
{
  Input& input = *graph.input;
  options.input.mesh_path = "the mesh";
  options.graph = graph.options;
  options.simplification = graph.simplification;
  options.is_table_wanted = false;
  check(options);
  if(input.mesh.complex)
    check_for_complex(options, *input.mesh.complex);
  Report report = graph.report;
  write_results(options, input.mesh, input.scalar_map, *graph.mesh_graph, report);
  std::ostringstream stream;
  write_json(stream, report);
  return stream.str();
}

auto mesh_arrays(Graph_of_arrays& graph)
{
  const Mesh& mesh = graph.input->mesh;
  const Complex complex = mesh.complex.value_or(Complex());
  const Scalar_map map = graph.input->scalar_map;
  return std::make_tuple(triangles_of(mesh), points_of(mesh.surface), complex.edges, complex.tetrahedra,
                         std::vector<double>(map.begin(), map.end()));
}

void add_graph(py::module_& module)
{
  typedef Graph_of_arrays G;
  py::enum_<Manner>(module, "Manner")
    .value("centroids", Manner::CENTROIDS)
    .value("on_surface", Manner::ON_SURFACE)
    .value("straight", Manner::STRAIGHT)
    .value("by_cost", Manner::BY_COST);
  py::class_<Compute_options> options(module, "Files");
  options.def(py::init<>())
    .def_readwrite("graph", &Compute_options::graph_path)
    .def_readwrite("page", &Compute_options::page_path)
    .def_readwrite("mesh", &Compute_options::mesh_path)
    .def_readwrite("pairs", &Compute_options::pairs_path)
    .def_readwrite("diagram", &Compute_options::diagram_path)
    .def_readwrite("vertex_arcs", &Compute_options::vertex_arcs_path)
    .def_readwrite("simplified_scalars", &Compute_options::simplified_scalars_path)
    .def_readwrite("embedding", &Compute_options::embedding_manner)
    .def_readwrite("title", &Compute_options::title)
    .def_readwrite("unit", &Compute_options::unit)
    .def_readwrite("base", &Compute_options::base)
    .def_property(
      "name", [](const Compute_options& o) { return o.input.field; },
      [](Compute_options& o, const std::string& name) { o.input.field = name; });
  py::class_<G, Graph_pointer>(module, "Graph")
    .def_property_readonly("is_surface", [](const G& g) { return !g.input->mesh.complex; })
    .def("nodes", running(&nodes))
    .def("arcs", running(&arcs))
    .def("pairs", running(&pairs))
    .def("chains", running(+[](G& g) { return g.mesh_graph->chains(); }))
    .def("loops", running(&loops))
    .def("components", running(&components))
    .def("mesh_arrays", running(&mesh_arrays))
    .def("simplify", running(&simplify))
    .def("places", running(+[](G& g) { return g.mesh_graph->places(); }))
    .def("contours", running(&contours))
    .def("critical_set", running(+[](G& g, std::size_t node) { return g.mesh_graph->critical_set(node); }))
    .def("measures", running(&measures))
    .def("embed", running(&embed))
    .def("simplified_scalars", running(&simplified_scalars))
    .def("write", running(&write));
}

} // namespace
} // namespace reeb_graph_python

PYBIND11_MODULE(_core, module)
{
  namespace py = pybind11;
  using namespace reeb_graph_python; // NOLINT(google-build-using-namespace)
  translate_exceptions();
  py::class_<Mesh_arrays>(module, "MeshArrays").def(py::init<py::object, py::object, py::object, py::object>());
  add_functions(module);
  add_graph(module);
  module.def("compute", &compute);
  py::module_::import("atexit").attr("register")(py::cpp_function(&wait_for_stopped_work));
  module.attr("__version__") = REEB_GRAPH_VERSION;
}
