// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#include "objects.h"

#include "base/surface.h"
#include "commands/commands.h"
#include "computation/Mesh_graph.h"
#include "computation/comparison.h"
#include "computation/curves.h"
#include "computation/handles.h"
#include "computation/longest_loop.h"
#include "computation/scalar_fields.h"
#include "computation/simplification.h"
#include "computation/skeleton.h"
#include "input/assemble_surface.h"
#include "input/field_input.h"
#include "input/mesh_formats.h"
#include "input/repair_soup.h"
#include "output/report_output.h"
#include "output/skeleton_output.h"

#include <CGAL/Reeb_graph/fields/make_borders_level.h>
#include <CGAL/Reeb_graph/graph_topology.h>

#include <boost/property_map/property_map.hpp>

#include <pybind11/stl/filesystem.h>

#include <array>
#include <cstdint>
#include <filesystem>
#include <iterator>
#include <map>
#include <memory>
#include <mutex>
#include <numeric>
#include <sstream>
#include <tuple>
#include <type_traits>
#include <variant>

// The module reeb_graph._core, on which the Python of the package reeb_graph stands: numbers and arrays only.
namespace reeb_graph_python {
namespace {
typedef std::vector<std::size_t> Numbers;
typedef CGAL::Reeb_graph::Ties Ties;
typedef CGAL::Reeb_graph::Embedding_manner Manner;

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
                      Ties ties,
                      bool are_degree_two_nodes_kept,
                      Run& run)
{
  Polygon_soup soup = copy_arrays(arrays, scalars.size());
  const auto graph = std::make_shared<Graph_of_arrays>();
  graph->options.ties = ties;
  graph->options.are_degree_two_nodes_kept = are_degree_two_nodes_kept;
  run([&] {
    Input& input = *graph->input;
    input.mesh = make_mesh(soup);
    soup = Polygon_soup();
    input.scalar_map = add_map(input.mesh.surface, "v:scalar", &scalars);
    graph->mesh_graph = compute_mesh_graph(input.mesh, input.scalar_map, graph->options, {}, 0, graph->report);
  });
  return graph;
}

// A function that does `work` on the graph without the interpreter's lock, and makes an object of the result.
template <class Result, class... Arguments>
auto running(Result (*work)(Graph_of_arrays&, Arguments...))
{
  return [work](Graph_of_arrays& graph, Arguments... arguments, Run& run) {
    std::optional<Result> result;
    run([&] {
      const std::lock_guard lock(graph.input->mutex);
      result.emplace(work(graph, arguments...));
    });
    return to_object(*result);
  };
}

// In units, or as the program reads it.
typedef std::optional<std::variant<double, std::string>> Number_or_text;

std::optional<Threshold> threshold_of(const Number_or_text& given, Threshold (*parse)(const std::string&))
{
  if(!given)
    return std::nullopt;
  return given->index() == 0 ? Threshold{std::get<double>(*given), false, false} : parse(std::get<std::string>(*given));
}

// With a threshold, or a number of leaves.
Graph_pointer simplify(Graph_of_arrays& graph,
                       Number_or_text threshold,
                       std::optional<std::size_t> leaves,
                       bool are_loops_cancelled)
{
  const Simplification_options options{threshold_of(threshold, &parse_threshold), leaves, are_loops_cancelled};
  auto simplified = graph.mesh_graph->simplify(
    options, threshold_in_units(options, graph.input->mesh.surface, graph.input->scalar_map));
  return std::make_shared<Graph_of_arrays>(
    Graph_of_arrays{graph.input, graph.options, options, graph.report, std::move(simplified)});
}

// The vertex, the kind, and the component of each node, its value, and the ends of each arc.
auto table(Graph_of_arrays& given)
{
  const Graph& graph = given.graph();
  Numbers components(num_vertices(graph));
  CGAL::Reeb_graph::connected_components(
    graph, boost::make_iterator_property_map(components.begin(), boost::typed_identity_property_map<std::size_t>()));
  std::vector<std::array<std::size_t, 3>> nodes;
  std::vector<std::array<std::size_t, 2>> arcs;
  std::vector<double> values;
  for(const auto node : CGAL::make_range(vertices(graph)))
  {
    nodes.push_back({graph[node].vertex, static_cast<std::size_t>(graph[node].kind), components[node]});
    values.push_back(graph[node].value);
  }
  for(const auto arc : CGAL::make_range(edges(graph)))
    arcs.push_back({source(arc, graph), target(arc, graph)});
  return std::make_tuple(nodes, values, arcs);
}

auto pairs(Graph_of_arrays& given)
{
  std::vector<std::array<std::size_t, 2>> nodes;
  std::vector<std::string> kinds;
  for(const Persistence_pair& pair : find_persistence_pairs(given.graph()))
  {
    nodes.push_back({pair.lower_node, pair.upper_node});
    kinds.emplace_back(to_string(pair.kind));
  }
  return std::make_tuple(nodes, kinds);
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

// Those at the place `t` of all arcs, or of one, which is measured by the values of another field if there are any; or at a
// level.
py::object contours(Graph_of_arrays& graph,
                    std::optional<std::size_t> arc,
                    std::optional<double> t,
                    std::optional<double> level,
                    const std::optional<Value_array>& parametrization,
                    Run& run)
{
  Contour_choice choice;
  choice.arc = arc;
  choice.t = t;
  if(parametrization)
    choice.parametrization.assign(parametrization->data(), parametrization->data() + parametrization->size());
  if(level)
    choice.levels = {*level};
  choice.may_be_none = true;
  const auto find = +[](Graph_of_arrays& g, const Contour_choice* c) { return g.mesh_graph->find_contours(*c); };
  return running(find)(graph, &choice, run);
}

// The unit gradient field of that of the graph.
std::vector<double> unit_gradient_values(Graph_of_arrays& graph)
{
  const Mesh& mesh = graph.input->mesh;
  if(const std::string reason = reason_against("the field unit-gradient", mesh); !reason.empty())
    throw std::runtime_error(reason);
  Work_report report;
  return compute_unit_gradient(mesh.surface, graph.input->scalar_map, report);
}

// The names of the measures of arcs, a column for each, and whether it has values of the field.
auto measures(Graph_of_arrays& graph)
{
  std::vector<std::string> names;
  std::vector<std::vector<double>> columns;
  std::vector<bool> are_values;
  for(const Arc_column& column : graph.mesh_graph->arc_table().columns)
  {
    names.push_back(column.attribute.name);
    std::visit([&](const auto& numbers) { columns.emplace_back(numbers.begin(), numbers.end()); },
               column.attribute.numbers);
    are_values.push_back(column.unit == Arc_unit::VALUE);
  }
  return std::make_tuple(names, columns, are_values);
}

// By default in the manner of the program.
auto embed(Graph_of_arrays& graph, std::optional<Manner> manner)
{
  const Manner by_default = graph.input->mesh.complex ? Manner::STRAIGHT : Manner::BY_COST;
  const Embedding embedding = graph.mesh_graph->embed(manner.value_or(by_default));
  return std::make_tuple(embedding.manner, embedding.node_points, embedding.arc_polylines, embedding.arc_values);
}

// A field that has the graph, and whether ties were contracted for it, though not asked for.
std::tuple<std::vector<double>, bool> simplified_scalars(Graph_of_arrays& graph)
{
  Surface& surface = graph.input->mesh.surface;
  const Scalar_map map = add_map(surface, "v:simplified", nullptr);
  const Simplified_field field = compute_simplified_field(graph.input->mesh, graph.input->scalar_map, *graph.mesh_graph,
                                                          graph.options, graph.simplification, map);
  return {std::vector<double>(map.begin(), map.end()), field.are_ties_contracted};
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
    check_for_complex(options, input.mesh);
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

std::vector<double> values_of(const Scalar_map& map) { return {map.begin(), map.end()}; }

// Repairs the mesh if that is wanted, and it is no surface or is to lose components; of tetrahedra, the border is taken.
Mesh make_surface(Polygon_soup soup,
                  const std::string& what,
                  const std::optional<Repair_options>& repairs = std::nullopt)
{
  if(repairs && repairs->is_split && !soup.tetrahedra.empty())
    take_border_of_tetrahedra(soup);
  Mesh mesh = make_mesh(soup);
  if(repairs && is_to_be_repaired(soup, mesh, *repairs))
  {
    Input_findings unused;
    leave_out_repeated_faces(soup, unused);
    repair_mesh(std::move(soup), *repairs, mesh);
  }
  if(mesh.complex)
    throw std::runtime_error(what + " needs an oriented manifold surface; " + describe_obstacle(mesh));
  return mesh;
}

// The field of this name, with options as the program has them; for unit gradients, of the scalars if there are any. Or
// "with level borders": the scalars, changed so that they have them.
py::object field(const Mesh_arrays& arrays,
                 std::size_t number_of_vertices,
                 Input_options options,
                 const std::optional<Value_array>& scalars,
                 Run& run)
{
  options.scalars_path = scalars ? "scalars" : "";
  const Value_array* const given = scalars ? &*scalars : nullptr;
  const Polygon_soup soup = copy_arrays(arrays, number_of_vertices);
  std::vector<double> values;
  run([&] {
    const bool is_for_complexes = options.field == "geodesic" || options.field == "height";
    Mesh mesh = is_for_complexes ? make_mesh(soup) : make_surface(soup, "the field " + options.field);
    const Scalar_map map = add_map(mesh.surface, "v:scalar", given);
    Work_report report;
    if(options.field == "with level borders")
      CGAL::Reeb_graph::make_borders_level(mesh.surface, map);
    else if(mesh.complex && options.field == "geodesic")
      compute_distances_along_edges(mesh, options, map, report);
    else
      compute_scalar_field(options, mesh.surface, map, report);
    values = values_of(map);
  });
  return to_object(values);
}

std::vector<Any_vertex_property> add_vertex_arrays(Surface& surface, const std::vector<Value_array>& vertex_arrays)
{
  std::vector<Any_vertex_property> properties;
  for(const Value_array& array : vertex_arrays)
    properties.emplace_back(add_map(surface, "v:array" + std::to_string(properties.size()), &array));
  return properties;
}

std::vector<std::vector<double>> columns_of(const std::vector<Any_vertex_property>& properties)
{
  std::vector<std::vector<double>> columns;
  for(const Any_vertex_property& property : properties)
    columns.push_back(values_of(std::get<Scalar_map>(property)));
  return columns;
}

std::vector<int> numbers_of_faces(const Surface& surface, Patch_map map)
{
  std::vector<int> numbers;
  for(const Surface::Face_index f : surface.faces())
    numbers.push_back(map[f]);
  return numbers;
}

// Points, triangles, their patches, curves, scalars, and vertex arrays of what has been cut along levels; the bands, and
// value, arc, or -1, and whether it is closed, of each curve.
py::object cut_levels(const Mesh_arrays& arrays,
                      const Value_array& scalars,
                      const std::vector<Value_array>& vertex_arrays,
                      const Level_choice& choice,
                      bool is_cut_open,
                      std::size_t largest_number_of_faces,
                      Run& run)
{
  const Polygon_soup soup = copy_arrays(arrays, scalars.size());
  Mesh mesh;
  Scalar_map map;
  std::vector<Any_vertex_property> properties;
  Cut_result result;
  std::vector<double> values;
  std::vector<std::int64_t> arcs;
  std::vector<bool> are_closed;
  run([&] {
    mesh = make_surface(soup, "cutting");
    map = add_map(mesh.surface, "v:scalar", &scalars);
    properties = add_vertex_arrays(mesh.surface, vertex_arrays);
    result = cut_along_levels(mesh.surface, map, properties, values_of_levels(choice, map), is_cut_open,
                              [&](std::size_t number_of_faces) { return number_of_faces <= largest_number_of_faces; });
    Report unused;
    const auto graph = compute_mesh_graph(mesh, map, {}, {}, 0, unused);
    for(const Contour& curve : contours_of_levels(result, map, *graph))
    {
      values.push_back(curve.value);
      arcs.push_back(static_cast<std::int64_t>(curve.arc));
      are_closed.push_back(curve.is_closed);
    }
  });
  return to_object(std::make_tuple(points_of(mesh.surface), triangles_of(mesh),
                                   numbers_of_faces(mesh.surface, result.patch_map), result.polylines, values_of(map),
                                   columns_of(properties), numbers_of_faces(mesh.surface, *result.band_map), values,
                                   arcs, std::vector<int>(are_closed.begin(), are_closed.end())));
}

// Points, triangles, their disks, curves, vertex arrays, and the vertex that each vertex is a copy of.
py::object cut_disks(const Mesh_arrays& arrays,
                     std::size_t number_of_vertices,
                     const std::vector<Value_array>& vertex_arrays,
                     Run& run)
{
  const Polygon_soup soup = copy_arrays(arrays, number_of_vertices);
  Mesh mesh;
  std::vector<Any_vertex_property> properties;
  Cut_result result;
  run([&] {
    mesh = make_surface(soup, "cutting");
    properties = add_vertex_arrays(mesh.surface, vertex_arrays);
    result = cut_to_disks(mesh.surface, properties);
  });
  std::vector<int> originals;
  for(const Surface::Vertex_index v : mesh.surface.vertices())
    originals.push_back((*result.original_map)[v]);
  return to_object(std::make_tuple(points_of(mesh.surface), triangles_of(mesh),
                                   numbers_of_faces(mesh.surface, result.patch_map), result.polylines,
                                   columns_of(properties), originals));
}

// Points, triangles, their patches, curves, scalars, and vertex arrays of what has been cut.
py::object cut(const Mesh_arrays& arrays,
               const Value_array& scalars,
               const std::vector<Value_array>& vertex_arrays,
               const Cut_options& options,
               std::size_t largest_number_of_faces,
               Run& run)
{
  const Polygon_soup soup = copy_arrays(arrays, scalars.size());
  Mesh mesh;
  Scalar_map map;
  std::vector<Any_vertex_property> properties;
  Cut_result result;
  run([&] {
    mesh = make_surface(soup, "cutting");
    map = add_map(mesh.surface, "v:scalar", &scalars);
    properties = add_vertex_arrays(mesh.surface, vertex_arrays);
    result = cut_along_curves(mesh.surface, map, properties, options,
                              [&](std::size_t number_of_faces) { return number_of_faces <= largest_number_of_faces; });
  });
  return to_object(std::make_tuple(points_of(mesh.surface), triangles_of(mesh),
                                   numbers_of_faces(mesh.surface, result.patch_map), result.polylines, values_of(map),
                                   columns_of(properties)));
}

// Where a loop is, as rows of the program have it.
auto place_arrays(const Loop_place& place) { return std::make_tuple(place.center, place.box, place.vertices); }

// Loops, what is known of each, and the number of pairs of triangles that intersect, if they are ignored.
py::object handles(const Mesh_arrays& arrays,
                   std::size_t number_of_vertices,
                   const std::optional<Value_array>& scalars,
                   bool are_shortened,
                   bool are_self_intersections_ignored,
                   Run& run)
{
  const Polygon_soup soup = copy_arrays(arrays, number_of_vertices);
  const Value_array* const given = scalars ? &*scalars : nullptr;
  Loops_of_surface found;
  run([&] {
    Mesh mesh = make_surface(soup, "finding handles");
    const Scalar_map map = add_map(mesh.surface, "v:scalar", given);
    if(!given)
      write_least_rough_height(mesh.surface, map);
    found = find_loops(mesh.surface, map, are_shortened, are_self_intersections_ignored);
  });
  py::list rows;
  for(const Loop_row& row : found.rows)
    rows.append(to_object(std::make_tuple(row.kind, row.length, row.component, place_arrays(row.place), row.partner,
                                          row.persistence, row.area, row.is_simple, row.is_certain)));
  return py::make_tuple(rows, found.self_intersections);
}

// Triangles, points, and vertex arrays of what is left; the loops of handles that are removed or refused, and why.
py::object remove(const Mesh_arrays& arrays,
                  std::size_t number_of_vertices,
                  const std::vector<Value_array>& vertex_arrays,
                  const Number_or_text& size,
                  std::size_t number,
                  bool are_self_intersections_ignored,
                  Run& run)
{
  const Polygon_soup soup = copy_arrays(arrays, number_of_vertices);
  Mesh mesh;
  std::vector<Any_vertex_property> properties;
  std::vector<Removal_row> removals;
  run([&] {
    mesh = make_surface(soup, "removing handles");
    properties = add_vertex_arrays(mesh.surface, vertex_arrays);
    const Scalar_map unused = add_map(mesh.surface, "v:scalar", nullptr);
    removals = remove_handles(mesh.surface, unused, properties, threshold_of(size, &parse_size), number,
                              are_self_intersections_ignored);
  });
  py::list rows;
  for(const Removal_row& row : removals)
    rows.append(to_object(std::make_tuple(row.kind, row.length, row.component, place_arrays(row.place), row.reason)));
  return py::make_tuple(to_object(triangles_of(mesh)), to_object(points_of(mesh.surface)),
                        to_object(columns_of(properties)), rows);
}

// Triangles, points, edges and tetrahedra of a file, the names and numbers of what it has for its vertices, and what the
// program says of it, line by line.
py::object read(const std::string& path, bool are_faces_triangulated, Run& run)
{
  Mesh mesh;
  std::vector<Any_vertex_property> properties;
  std::ostringstream text;
  run([&] {
    mesh = read_mesh(path, are_faces_triangulated, "");
    properties = read_vertex_properties(path, mesh.surface);
    Work_report report;
    report.input = mesh.findings;
    report.notes = mesh.notes;
    write_input_text(text, report);
  });
  py::dict data;
  visit_vertex_properties(mesh.surface, [&](const std::string& name, const auto& map) {
    typedef typename std::decay_t<decltype(map)>::value_type Number;
    data[name.c_str()] = py::array_t<Number>(static_cast<py::ssize_t>(mesh.surface.number_of_vertices()), map.data());
  });
  const Complex complex = mesh.complex.value_or(Complex());
  return py::make_tuple(to_object(triangles_of(mesh)), to_object(points_of(mesh.surface)), to_object(complex.edges),
                        to_object(complex.tetrahedra), data, text.str());
}

// Triangles, points, and the new number of each given one, -1 for none.
py::object repair(const Mesh_arrays& arrays, std::size_t number_of_points, const Repair_options& options, Run& run)
{
  Polygon_soup soup = copy_arrays(arrays, number_of_points, true);
  std::vector<std::array<std::uint32_t, 3>> triangles;
  std::vector<std::int64_t> map;
  run([&] {
    if(!soup.tetrahedra.empty())
      take_border_of_tetrahedra(soup);
    Input_findings unused;
    leave_out_degenerate_faces(soup.polygons, unused);
    leave_out_repeated_faces(soup, unused);
    for(const std::size_t v : repair_soup(soup, options).new_vertices)
      map.push_back(v == no_vertex ? -1 : static_cast<std::int64_t>(v));
    for(std::size_t i = 0; i < soup.polygons.size(); ++i)
    {
      const Corner* const v = soup.polygons[i].begin();
      triangles.push_back({v[0], v[1], v[2]});
    }
  });
  return to_object(std::make_tuple(triangles, soup.points, map));
}

// Points, radii, inscribed radii, arcs, the point of each vertex or -1, and the numbers that certify them.
// A column for each thing that is measured of branches, where -1 and NaN stand for what there is not.
py::dict columns_of(const std::vector<CGAL::Reeb_graph::Skeleton_branch>& branches)
{
  typedef CGAL::Reeb_graph::Skeleton_branch Branch;
  py::dict columns;
  const auto add = [&](const char* name, const auto& member) {
    typedef std::decay_t<decltype(Branch().*member)> Number;
    std::vector<std::conditional_t<std::is_integral_v<Number>, std::int64_t, Number>> column;
    for(const Branch& branch : branches)
      column.push_back(branch.*member); // the largest number becomes -1
    columns[name] = to_object(column);
  };
  add("component", &Branch::component);
  add("parent", &Branch::parent);
  add("from", &Branch::first);
  add("to", &Branch::last);
  add("length", &Branch::length);
  add("tortuosity", &Branch::tortuosity);
  add("strahler", &Branch::order);
  add("radius", &Branch::radius);
  add("least_radius", &Branch::least_radius);
  add("greatest_radius", &Branch::greatest_radius);
  add("inscribed_radius", &Branch::inscribed_radius);
  add("volume", &Branch::volume);
  add("area", &Branch::area);
  add("junction_volume", &Branch::junction_volume);
  add("junction_area", &Branch::junction_area);
  return columns;
}

py::object skeleton(const Mesh_arrays& arrays,
                    std::size_t number_of_vertices,
                    const std::optional<Value_array>& scalars,
                    const Skeleton_settings& settings,
                    const std::optional<Repair_options>& repairs,
                    Run& run)
{
  const Polygon_soup soup = copy_arrays(arrays, number_of_vertices);
  const Value_array* const given = scalars ? &*scalars : nullptr;
  Skeleton result;
  run([&] {
    Mesh mesh = make_surface(soup, "a skeleton", repairs);
    std::optional<Scalar_map> map;
    if(given)
      map = add_map(mesh.surface, "v:scalar", given);
    result = extract_skeleton(mesh.surface, map, settings);
    if(mesh.repair)
      result.face_arcs.clear(); // which are those of a copy
  });
  const auto& known = result.certificate;
  std::vector<std::int64_t> vertex_map;
  for(const std::size_t v : result.vertex_map)
    vertex_map.push_back(v == Skeleton::none ? -1 : static_cast<std::int64_t>(v));
  vertex_map.resize(number_of_vertices); // without those that a repair has added
  const std::map<std::string, std::size_t> numbers = {
    {"components", known.number_of_components},
    {"genus", known.genus},
    {"arcs", known.number_of_arcs},
    {"ends", known.number_of_ends},
    {"border_ends", known.number_of_border_ends},
    {"junctions", known.number_of_junctions},
    {"loops", known.number_of_loops},
    {"hidden_handles", known.number_of_hidden_handles},
    {"contractible_loops", known.number_of_contractible_loops},
    {"loop_index", known.loop_index},
    {"vertices_outside", known.number_of_vertices_outside},
    {"crossing_edges", known.number_of_crossing_edges},
    {"inside_out_components", result.number_inside_out},
    {"self_intersecting_components", known.number_of_crossing_components}};
  std::vector<Point> points;
  std::vector<double> radii, inscribed_radii;
  std::vector<std::int64_t> are_in_junctions;
  for(const auto v : CGAL::make_range(vertices(result.graph)))
  {
    are_in_junctions.push_back(result.graph[v].is_in_junction ? 1 : 0);
    points.push_back(result.graph[v].point);
    radii.push_back(result.graph[v].radius);
    inscribed_radii.push_back(result.graph[v].inscribed_radius);
  }
  std::vector<std::int64_t> are_edges_in_junctions;
  for(const auto e : CGAL::make_range(edges(result.graph)))
    are_edges_in_junctions.push_back(result.graph[e].is_in_junction ? 1 : 0);
  const auto& are_faces = result.are_faces_in_junctions;
  return py::make_tuple(to_object(points), to_object(radii), to_object(inscribed_radii), to_object(result.arcs),
                        to_object(vertex_map), py::cast(numbers), columns_of(result.branches),
                        to_object(are_in_junctions), to_object(are_edges_in_junctions),
                        to_object(std::vector<std::int64_t>(result.face_arcs.begin(), result.face_arcs.end())),
                        to_object(std::vector<std::int64_t>(are_faces.begin(), are_faces.end())));
}

// Sizes are the volume, the area, and what of them lies in junctions, of each branch. The root is a point of the skeleton.
void write_skeleton_file(const std::filesystem::path& path,
                         const Value_array& points,
                         const std::vector<double>& radii,
                         const std::vector<double>& inscribed_radii,
                         const std::vector<Numbers>& arcs,
                         const std::vector<std::array<double, 4>>& sizes,
                         const std::optional<Skeleton_place>& root,
                         const Swc_options& options)
{
  Skeleton skeleton;
  std::vector<Point> places(radii.size());
  copy_points(points, places);
  for(std::size_t v = 0; v != radii.size(); ++v)
    skeleton.graph[add_vertex(skeleton.graph)] = {places[v], {}, radii[v], inscribed_radii[v]};
  for(std::size_t arc = 0; arc != arcs.size(); ++arc)
    for(std::size_t i = 1; i != arcs[arc].size(); ++i)
      add_edge(arcs[arc][i - 1], arcs[arc][i], {arc}, skeleton.graph);
  skeleton.vertex_map.resize(radii.size());
  std::iota(skeleton.vertex_map.begin(), skeleton.vertex_map.end(), std::size_t(0));
  complete(skeleton, root);
  for(std::size_t arc = 0; arc != arcs.size(); ++arc)
  {
    auto& branch = skeleton.branches[arc];
    std::tie(branch.volume, branch.area, branch.junction_volume, branch.junction_area) = std::tuple_cat(sizes.at(arc));
  }
  write_skeleton(path, skeleton, options);
}

// The pairs of graphs before they were simplified. Bases are added to their values.
std::vector<Persistence_values> persistence_values(const std::vector<Graph_pointer>& graphs,
                                                   const std::vector<double>& bases)
{
  std::vector<Persistence_values> values;
  for(std::size_t i = 0; i != graphs.size(); ++i)
  {
    const std::lock_guard lock(graphs[i]->input->mutex);
    values.push_back(find_persistence_values(graphs[i]->mesh_graph->given(), bases[i]));
  }
  return values;
}

py::object compare(const std::vector<Graph_pointer>& graphs,
                   const std::vector<double>& bases,
                   double price_alone,
                   Run& run)
{
  std::vector<std::pair<std::string, double>> by_kind;
  Partners partners;
  run([&] {
    const auto values = persistence_values(graphs, bases);
    by_kind = distances_by_kind(values[0], values[1]);
    std::unique_lock first(graphs[0]->input->mutex, std::defer_lock), second(graphs[1]->input->mutex, std::defer_lock);
    if(graphs[0]->input == graphs[1]->input)
      first.lock();
    else
      std::lock(first, second);
    partners = match_arcs(*graphs[0]->mesh_graph, *graphs[1]->mesh_graph, price_alone);
  });
  std::vector<std::array<std::size_t, 2>> rows;
  for(const auto& [a, b] : partners)
    rows.push_back({a, b});
  return py::make_tuple(py::cast(by_kind), to_object(rows));
}

// A matrix, row by row.
py::object distances(const std::vector<Graph_pointer>& graphs, const std::vector<double>& bases, Run& run)
{
  std::vector<double> matrix;
  run([&] {
    for(const std::vector<double>& row : find_distances(persistence_values(graphs, bases)))
      matrix.insert(matrix.end(), row.begin(), row.end());
  });
  return to_object(matrix);
}

// None if a mesh is not connected.
py::object like_tips(const std::vector<Mesh_arrays>& arrays, const std::vector<std::size_t>& numbers, Run& run)
{
  std::vector<Polygon_soup> soups;
  for(std::size_t i = 0; i != arrays.size(); ++i)
    soups.push_back(copy_arrays(arrays[i], numbers[i]));
  std::vector<std::size_t> tips;
  run([&] {
    std::vector<Mesh> meshes;
    std::vector<const Surface*> surfaces;
    for(Polygon_soup& soup : soups)
      meshes.push_back(make_surface(std::move(soup), "a tip"));
    for(const Mesh& mesh : meshes)
      surfaces.push_back(&mesh.surface);
    tips = find_like_tips(surfaces);
  });
  return to_object(tips);
}

void add_functions(py::module_& module)
{
  using CGAL::Reeb_graph::Borders;
  py::class_<Input_options>(module, "FieldOptions")
    .def(py::init<>())
    .def_readwrite("field", &Input_options::field)
    .def_readwrite("weights", &Input_options::weights)
    .def_readwrite("minimum", &Input_options::lowest_vertex)
    .def_readwrite("maximum", &Input_options::highest_vertex)
    .def_readwrite("sources", &Input_options::source_vertices)
    .def_readwrite("unreached_left", &Input_options::is_unreached_left)
    .def_readwrite("direction", &Input_options::direction);
  py::class_<Cut_options>(module, "CutOptions")
    .def(py::init([](Curves_type type, std::optional<double> persistence, std::optional<double> area, bool is_cut_open,
                     Borders borders) { return Cut_options{type, persistence, area, is_cut_open, borders, {}}; }));
  py::class_<Level_choice>(module, "LevelChoice")
    .def(py::init([](std::vector<double> values, std::optional<std::size_t> number, std::optional<double> spacing) {
      return Level_choice{std::move(values), number, spacing};
    }));
  py::enum_<Borders>(module, "Borders").value("make-level", Borders::MAKE_LEVEL).value("level", Borders::LEVEL);
  py::enum_<Curves_type>(module, "Curves")
    .value("cutting_system", Curves_type::CUTTING_SYSTEM)
    .value("pants", Curves_type::PANTS)
    .value("branches", Curves_type::BRANCH);
  py::class_<Repair_options>(module, "RepairOptions")
    .def(py::init([](bool are_coinciding_points_merged, std::optional<double> distance, const Number_or_text& stitching,
                     bool are_opposite_faces_cancelled, bool is_split, bool are_faces_oriented, double least_share,
                     std::size_t most_filled_edges, bool is_largest_kept, bool are_unused_points_left_out) {
      return Repair_options{are_coinciding_points_merged,
                            distance,
                            threshold_of(stitching, &parse_size),
                            are_opposite_faces_cancelled,
                            false,
                            is_split,
                            are_faces_oriented,
                            least_share,
                            most_filled_edges,
                            is_largest_kept,
                            are_unused_points_left_out};
    }));
  module.def("read", &read);
  module.def("repair", &repair);
  module.def("handles", &handles);
  module.def("remove_handles", &remove);
  module.def("field", &field);
  module.def("cut", &cut);
  module.def("cut_levels", &cut_levels);
  module.def("cut_disks", &cut_disks);
  py::class_<Skeleton_settings>(module, "SkeletonSettings").def(py::init<double, double, bool, double, double>());
  module.def("skeleton", &skeleton);
  py::class_<Swc_options>(module, "SwcOptions").def(py::init([](bool are_radii_inscribed, std::size_t type) {
    return Swc_options{are_radii_inscribed, type};
  }));
  py::class_<Skeleton_place>(module, "SkeletonPlace").def(py::init([](std::optional<std::size_t> point) {
    return point ? Skeleton_place{Skeleton_place::VERTEX, *point} : Skeleton_place{Skeleton_place::THICKEST};
  }));
  module.def("write_skeleton", &write_skeleton_file);
}

void add_graph(py::module_& module)
{
  typedef Graph_of_arrays G;
  py::enum_<Ties>(module, "Ties").value("perturb", Ties::PERTURB).value("contract", Ties::CONTRACT);
  py::enum_<Manner>(module, "Manner")
    .value("centroids", Manner::CENTROIDS)
    .value("on-surface", Manner::ON_SURFACE)
    .value("straight", Manner::STRAIGHT);
  py::class_<Compute_options>(module, "Files")
    .def(py::init<>())
    .def_readwrite("graph", &Compute_options::graph_path)
    .def_readwrite("page", &Compute_options::page_path)
    .def_readwrite("mesh", &Compute_options::mesh_path)
    .def_readwrite("pairs", &Compute_options::pairs_path)
    .def_readwrite("diagram", &Compute_options::diagram_path)
    .def_readwrite("loop", &Compute_options::loop_path)
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
    .def("table", running(&table))
    .def("pairs", running(&pairs))
    .def("chains", running(+[](G& g) { return g.mesh_graph->chains(); }))
    .def("loops", running(&loops))
    .def("mesh_arrays", running(&mesh_arrays))
    .def("simplify", running(&simplify))
    .def("places", running(+[](G& g) { return g.mesh_graph->places(); }))
    .def("contours", &contours)
    .def("unit_gradient", running(&unit_gradient_values))
    .def("critical_set", running(+[](G& g, std::size_t node) { return g.mesh_graph->critical_set(node); }))
    .def("longest_loop", running(+[](G& g) { return find_longest_loop(*g.mesh_graph).polylines.front(); }))
    .def("measures", running(&measures))
    .def("embed", running(&embed))
    .def("simplified_scalars", running(&simplified_scalars))
    .def("write", running(&write));
  module.def("compute", &compute);
  module.def("compare", &compare);
  module.def("distances", &distances);
  module.def("like_tips", &like_tips);
}

} // namespace
} // namespace reeb_graph_python

PYBIND11_MODULE(_core, module)
{
  namespace py = pybind11;
  using reeb_graph_python::Run;
  py::register_exception_translator(&reeb_graph_python::translate);
  py::class_<Run>(module, "Run")
    .def(py::init<std::size_t>())
    .def_property_readonly("fraction", [](const Run& run) { return run.fraction.load(); })
    .def("stop", [](Run& run) { run.is_stopped = true; });
  reeb_graph_python::add_functions(module);
  reeb_graph_python::add_graph(module);
  module.attr("__version__") = REEB_GRAPH_VERSION;
}
