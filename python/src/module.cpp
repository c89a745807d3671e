// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of the CGAL-style package Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#include "Graph_of_arrays.h"
#include "arrays.h"
#include "functions.h"
#include "run.h"

#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

// The module reeb_graph._core, on which the Python of the package reeb_graph stands: numbers and arrays only.
namespace reeb_graph_python {
namespace {
using CGAL::Reeb_graph::Embedding_manner;
typedef std::shared_ptr<const Graph_of_arrays> Graph_pointer;

py::list list_of(const std::vector<std::vector<std::size_t>>& lists)
{
  py::list result;
  for(const std::vector<std::size_t>& numbers : lists)
    result.append(array_of(numbers));
  return result;
}

// With ranks as scalars, `values` are what they are the ranks of, less `base`.
Graph_pointer compute(const Mesh_arrays& arrays,
                      const Value_array& scalars,
                      const std::optional<Value_array>& values,
                      double base,
                      bool are_ties_contracted,
                      bool are_degree_two_nodes_kept,
                      std::size_t threads,
                      const py::object& progress)
{
  struct Work
  {
    std::vector<double> scalars, values;
    Polygon_soup soup;
    std::shared_ptr<Input> input = std::make_shared<Input>();
    Graph_options options;
    Graph_pointer graph;
  };
  const auto work = std::make_shared<Work>();
  work->scalars = copy_values(scalars);
  if(values)
    work->values = copy_values(*values);
  work->soup = copy_arrays(arrays, work->scalars.size());
  work->input->base = base;
  work->input->has_points = !arrays.points.is_none();
  work->options.ties = are_ties_contracted ? CGAL::Reeb_graph::Ties::CONTRACT : CGAL::Reeb_graph::Ties::PERTURB;
  work->options.are_degree_two_nodes_kept = are_degree_two_nodes_kept;
  run(
    progress, threads,
    [work] {
      make_input(*work->input, work->soup, work->scalars, work->values);
      work->soup = Polygon_soup();
      work->graph = std::make_shared<const Graph_of_arrays>(work->input, work->options);
    },
    true);
  return work->graph;
}

// The graph with an option of the program: a threshold in units of the field or in percent, or a number of leaves.
Graph_pointer simplify(const Graph_of_arrays& graph,
                       std::optional<double> threshold,
                       bool is_percentage,
                       std::optional<std::size_t> leaves,
                       bool are_loops_cancelled,
                       const py::object& progress)
{
  Simplification_options options;
  if(threshold)
    options.threshold = Threshold{*threshold, is_percentage};
  options.number_of_leaves = leaves;
  options.are_loops_cancelled = are_loops_cancelled;
  Graph_pointer simplified;
  run(progress, 0, [&] { simplified = std::make_shared<const Graph_of_arrays>(graph, options); });
  return simplified;
}

py::tuple nodes(const Graph_of_arrays& given)
{
  const Graph& graph = given.graph();
  std::vector<std::size_t> vertex_numbers, kinds;
  std::vector<double> values;
  for(const auto node : CGAL::make_range(vertices(graph)))
  {
    vertex_numbers.push_back(graph[node].vertex);
    values.push_back(graph[node].value);
    kinds.push_back(static_cast<std::size_t>(graph[node].kind));
  }
  return py::make_tuple(array_of(vertex_numbers), array_of(values), array_of(kinds));
}

Index_array arcs(const Graph_of_arrays& given)
{
  std::vector<std::array<std::size_t, 2>> ends;
  for(const auto arc : CGAL::make_range(edges(given.graph())))
    ends.push_back({source(arc, given.graph()), target(arc, given.graph())});
  return array_of(ends);
}

py::tuple pairs(const Graph_of_arrays& given)
{
  std::vector<std::size_t> lower, upper;
  std::vector<std::string> kinds;
  for(const Persistence_pair& pair : given.pairs())
  {
    lower.push_back(pair.lower_node);
    upper.push_back(pair.upper_node);
    kinds.push_back(to_string(pair.kind));
  }
  return py::make_tuple(array_of(lower), array_of(upper), kinds);
}

py::dict dict_of(const Contour_of_arrays& contour)
{
  py::dict result;
  result["arc"] = contour.arc;
  result["value"] = contour.value;
  result["closed"] = contour.is_closed;
  result["edges"] = array_of(contour.edges);
  result["points"] = array_of(contour.points);
  result["polylines"] = list_of(contour.polylines);
  result["triangles"] = array_of(contour.triangles);
  return result;
}

py::list list_of(const std::vector<Contour_of_arrays>& contours)
{
  py::list result;
  for(const Contour_of_arrays& contour : contours)
    result.append(dict_of(contour));
  return result;
}

py::dict dict_of(const Critical_set_of_arrays& set)
{
  py::dict result;
  result["lower_contours"] = list_of(set.lower_contours);
  result["upper_contours"] = list_of(set.upper_contours);
  result["star"] = array_of(set.star);
  result["border_loop"] = array_of(set.border_loop);
  return result;
}

py::dict dict_of(const Graph_in_space& graph)
{
  py::dict result;
  py::list polylines, values;
  for(const Polyline& polyline : graph.embedding.arc_polylines)
    polylines.append(array_of(polyline));
  for(const std::vector<double>& numbers : graph.embedding.arc_values)
    values.append(array_of(numbers));
  result["manner"] = graph.embedding.manner;
  result["node_points"] = array_of(graph.embedding.node_points);
  result["arc_polylines"] = polylines;
  result["arc_values"] = values;
  return result;
}

py::tuple tuple_of(const Arc_measures& measures)
{
  return py::make_tuple(array_of(measures.lengths), array_of(measures.areas), array_of(measures.persistences),
                        array_of(measures.numbers_of_vertices));
}

py::tuple mesh_arrays(const Graph_of_arrays& graph)
{
  const Input& input = graph.input();
  const Mesh& mesh = input.mesh;
  const Complex none;
  const Complex& complex = mesh.complex ? *mesh.complex : none;
  return py::make_tuple(array_of(triangles_of(mesh)),
                        array_of(std::vector<Point>(mesh.surface.points().begin(), mesh.surface.points().end())),
                        array_of(complex.edges), array_of(complex.tetrahedra),
                        array_of(std::vector<double>(input.scalar_map.begin(), input.scalar_map.end())));
}

// A function that does `work`, which returns what can be made an object without it, and takes `progress` at the end.
template <class Result, class... Arguments>
auto running(Result (Graph_of_arrays::*work)(Arguments...) const)
{
  return [work](const Graph_of_arrays& graph, std::decay_t<Arguments>... arguments, std::size_t threads,
                const py::object& progress) {
    std::optional<Result> result;
    run(progress, threads, [&] { result.emplace((graph.*work)(arguments...)); });
    return std::move(*result);
  };
}

// The same, with a function that makes an object of the result.
template <class Result, class... Arguments, class Make>
auto running(Result (Graph_of_arrays::*work)(Arguments...) const, Make make)
{
  return [work = running(work), make](const Graph_of_arrays& graph, std::decay_t<Arguments>... arguments,
                                      std::size_t threads, const py::object& progress) {
    return make(work(graph, arguments..., threads, progress));
  };
}

void add_graph(py::module_& module)
{
  const auto to_array = [](const auto& result) { return array_of(result); };
  const auto to_list = [](const auto& result) { return list_of(result); };
  const auto to_dict = [](const auto& result) { return dict_of(result); };
  typedef Graph_of_arrays G;
  py::class_<G, std::shared_ptr<G>>(module, "Graph")
    .def_property_readonly("is_surface", &G::is_surface)
    .def_property_readonly("has_points", [](const G& graph) { return graph.input().has_points; })
    .def_property_readonly("is_ranked", [](const G& graph) { return graph.input().is_ranked(); })
    .def("nodes", &nodes)
    .def("arcs", &arcs)
    .def("pairs", &pairs)
    .def("chains", [to_list](const G& graph) { return to_list(graph.chains()); })
    .def("loops", [to_list](const G& graph) { return to_list(graph.loops()); })
    .def("components", [to_array](const G& graph) { return to_array(graph.components()); })
    .def("mesh_arrays", &mesh_arrays)
    .def("simplify", &simplify)
    .def("report", running(&G::report))
    .def("places", running(&G::places, to_array))
    .def("contour_at_parameter", running(&G::contour_at_parameter, to_dict))
    .def("contour_at_level", running(&G::contour_at_level, to_dict))
    .def("contours_at_level", running(&G::contours_at_level, to_list))
    .def("critical_set", running(&G::critical_set, to_dict))
    .def("measures", running(&G::measures, [](const Arc_measures& measures) { return tuple_of(measures); }))
    .def("embed", running(&G::embed, to_dict))
    .def("simplified_scalars", running(&G::simplified_scalars,
                                       [](const std::pair<std::vector<double>, bool>& result) {
                                         return py::make_tuple(array_of(result.first), result.second);
                                       }))
    .def("write", [](const G& graph, const std::filesystem::path& path, const std::string& title,
                     const std::string& name, const std::string& unit, std::optional<Embedding_manner> manner,
                     std::size_t threads, const py::object& progress) {
      run(progress, threads, [&] { graph.write(path, {{name, unit}, title, manner}); });
    });
}

} // namespace
} // namespace reeb_graph_python

PYBIND11_MODULE(_core, module)
{
  namespace py = pybind11;
  using CGAL::Reeb_graph::Embedding_manner;
  reeb_graph_python::translate_exceptions();
  py::enum_<Embedding_manner>(module, "Manner")
    .value("centroids", Embedding_manner::CENTROIDS)
    .value("on_surface", Embedding_manner::ON_SURFACE)
    .value("straight", Embedding_manner::STRAIGHT);
  reeb_graph_python::add_functions(module);
  reeb_graph_python::add_graph(module);
  module.def("compute", &reeb_graph_python::compute);
  py::module_::import("atexit").attr("register")(py::cpp_function(&reeb_graph_python::wait_for_stopped_work));
  module.attr("__version__") = REEB_GRAPH_VERSION;
}
