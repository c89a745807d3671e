// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of the CGAL-style package Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#include "Graph_of_arrays.h"

#include "computation/analysis.h"
#include "computation/simplified_field.h"
#include "output/graph_output.h"
#include "output/mesh_output.h"
#include "output/pairs_output.h"
#include "output/report_output.h"
#include "page/page_output.h"

#include <CGAL/Reeb_graph/IO/json.h>
#include <CGAL/Reeb_graph/graph_topology.h>
#include <CGAL/Reeb_graph/internal/base/scalars.h>
#include <CGAL/Reeb_graph/simplification/arc_persistences.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <sstream>
#include <stdexcept>

namespace reeb_graph_python {
namespace {
using CGAL::Reeb_graph::Embedding_manner;

template <class AnyGraph>
void set_values(AnyGraph& graph, Scalar_map scalar_map)
{
  for(const auto node : CGAL::make_range(vertices(graph)))
    graph[node].value = scalar_map[Surface::Vertex_index(static_cast<Surface::size_type>(graph[node].vertex))];
}

// The copy of a graph with the values of a map.
template <class AnyGraph>
std::shared_ptr<const AnyGraph> copy_with_values(const AnyGraph& graph, Scalar_map scalar_map)
{
  auto copy = std::make_shared<AnyGraph>(graph);
  set_values(*copy, scalar_map);
  return copy;
}

// A rank need not be a whole number.
double value_of_rank(const std::vector<double>& levels, double rank)
{
  const double bounded = std::clamp(rank, 0., static_cast<double>(levels.size() - 1));
  const auto lower = static_cast<std::size_t>(bounded);
  const double fraction = bounded - static_cast<double>(lower);
  return fraction == 0 ? levels[lower]
                       : CGAL::Reeb_graph::internal::value_at_fraction(levels[lower], levels[lower + 1], fraction);
}

// Each arc is a straight line between the vertices of its nodes.
Graph_in_space embed_straight(const Graph& graph, const Surface& surface)
{
  Graph_in_space result;
  for(const auto node : CGAL::make_range(vertices(graph)))
  {
    result.embedding.node_points.push_back(surface.point(graph[node].vertex));
    result.embedding.node_values.push_back(graph[node].value);
  }
  for(const auto arc : CGAL::make_range(edges(graph)))
  {
    const std::size_t lower = source(arc, graph), upper = target(arc, graph);
    result.embedding.arc_polylines.push_back(
      {result.embedding.node_points[lower], result.embedding.node_points[upper]});
    result.embedding.arc_values.push_back({graph[lower].value, graph[upper].value});
  }
  return result;
}

} // namespace

Graph_of_arrays::Graph_of_arrays(std::shared_ptr<Input> input, const Graph_options& options)
  : input_(std::move(input)),
    options_(options)
{
  Report report;
  if(is_surface())
  {
    given_ = std::make_shared<const Graph>(compute_and_time(input_->surface(), input_->scalar_map, options_, report));
    surface_graph_.emplace(*given_, simplification_, threshold_);
  }
  else
  {
    given_complex_ = std::make_shared<const Complex_graph>(compute_complex(report));
    complex_graph_.emplace(*given_complex_, simplification_, threshold_);
    graph_on_vertices_ = on_vertices(*given_complex_);
  }
  report_ = std::make_shared<const Report>(std::move(report));
}

Graph_of_arrays::Graph_of_arrays(const Graph_of_arrays& given, const Simplification_options& options)
  : input_(given.input_),
    options_(given.options_),
    report_(given.report_),
    given_(given.given_),
    given_complex_(given.given_complex_),
    simplification_(options),
    threshold_(threshold_in_units(options, input_->surface(), input_->value_map))
{
  simplify();
}

// Branches are measured by values, and the ranks are put back: the order of the nodes is the same.
void Graph_of_arrays::simplify()
{
  const bool is_ranked = input_->is_ranked();
  if(is_surface())
  {
    given_with_values_ = is_ranked ? copy_with_values(*given_, input_->value_map) : given_;
    surface_graph_.emplace(*given_with_values_, simplification_, threshold_);
    if(is_ranked)
      set_values(surface_graph_->simplified(), input_->scalar_map);
    return;
  }
  given_complex_with_values_ = is_ranked ? copy_with_values(*given_complex_, input_->value_map) : given_complex_;
  complex_graph_.emplace(*given_complex_with_values_, simplification_, threshold_);
  if(is_ranked)
    set_values(complex_graph_->simplified(), input_->scalar_map);
  graph_on_vertices_ = on_vertices(complex_graph_->result());
}

std::shared_ptr<const Graph> Graph_of_arrays::with_values(const Graph& graph) const
{
  if(input_->is_ranked())
    return copy_with_values(graph, input_->value_map);
  return {std::shared_ptr<const Graph>(), &graph};
}

std::shared_ptr<const Graph> Graph_of_arrays::to_write(const Graph& graph) const
{
  const std::shared_ptr<const Graph> values = with_values(graph);
  if(input_->base == 0)
    return values;
  auto copy = std::make_shared<Graph>(*values);
  for(const auto node : CGAL::make_range(vertices(*copy)))
    (*copy)[node].value += input_->base;
  return copy;
}

std::vector<std::vector<std::size_t>> Graph_of_arrays::chains() const
{
  std::vector<std::vector<std::size_t>> chains;
  const auto add = [&](const auto& chain, const auto& ends) {
    std::vector<std::size_t>& vertices = chains.emplace_back();
    for(const auto& edge : chain)
    {
      const auto [lower, upper] = ends(edge);
      if(vertices.empty() || vertices.back() != lower) // where it passes a plateau, a chain can go on elsewhere
        vertices.push_back(lower);
      vertices.push_back(upper);
    }
  };
  if(is_surface())
    for(const auto arc : CGAL::make_range(edges(graph())))
      add(graph()[arc].chain, [this](Surface::Halfedge_index h) {
        const Surface& surface = input_->surface();
        return std::pair<std::size_t, std::size_t>(surface.source(h), surface.target(h));
      });
  else
    for(const auto arc : CGAL::make_range(edges(complex_graph_->result())))
      add(complex_graph_->result()[arc].chain, [](const std::pair<std::size_t, std::size_t>& edge) { return edge; });
  return chains;
}

const Augmentation& Graph_of_arrays::augmentation() const
{
  if(!augmentation_)
  {
    // An augmentation cannot be moved: it is made where it stays.
    struct Made_in_place
    {
      const Graph_of_arrays& graph;
      operator Augmentation() const
      {
        return graph.surface_graph_->augmentation(graph.input_->surface(), graph.input_->scalar_map, graph.options_);
      }
    };
    augmentation_.emplace(Made_in_place{*this});
  }
  return *augmentation_;
}

const Vertex_locations& Graph_of_arrays::locations() const
{
  if(!locations_)
    locations_ = reeb_graph_program::locate_vertices(augmentation());
  return *locations_;
}

std::vector<std::size_t> Graph_of_arrays::places() const
{
  const std::lock_guard lock(mutex_);
  if(!is_surface())
    return places_in_complex();
  std::vector<std::size_t> places;
  places.reserve(input_->number_of_vertices());
  for(const Surface::Vertex_index v : input_->surface().vertices())
    places.push_back(locations().index(v));
  return places;
}

std::vector<std::vector<std::size_t>> Graph_of_arrays::loops() const
{
  std::vector<std::vector<boost::graph_traits<Graph>::edge_descriptor>> loops;
  CGAL::Reeb_graph::cycle_basis(graph(), std::back_inserter(loops));
  std::vector<std::vector<std::size_t>> numbers;
  for(const auto& loop : loops)
  {
    numbers.emplace_back();
    for(const auto arc : loop)
      numbers.back().push_back(get(boost::edge_index, graph(), arc));
  }
  return numbers;
}

std::vector<std::size_t> Graph_of_arrays::components() const
{
  std::vector<std::size_t> components(num_vertices(graph()));
  CGAL::Reeb_graph::number_components(
    graph(), boost::make_iterator_property_map(components.begin(), boost::typed_identity_property_map<std::size_t>()));
  return components;
}

std::vector<Arc_row> Graph_of_arrays::measure_rows() const
{
  return measure_arcs(input_->surface(), input_->value_map, *with_values(graph()), locations());
}

Arc_measures Graph_of_arrays::measures() const
{
  const std::lock_guard lock(mutex_);
  Arc_measures measures;
  for(const Arc_row& row : measure_rows())
  {
    measures.lengths.push_back(row.length);
    measures.areas.push_back(row.area);
    measures.numbers_of_vertices.push_back(row.vertices);
  }
  measures.persistences = CGAL::Reeb_graph::arc_persistences(*with_values(graph()));
  return measures;
}

Graph_in_space Graph_of_arrays::embed_locked(Embedding_manner manner, const std::vector<Arc_row>* rows) const
{
  if(!is_surface())
  {
    if(manner != Embedding_manner::STRAIGHT && manner != Embedding_manner::BY_COST)
      check_is_surface(input_->mesh, "an embedding that is not straight");
    return embed_straight(*to_write(graph()), input_->surface());
  }
  Graph_in_space result = {embed_on_surface(manner), {}};
  if(rows != nullptr)
    result.arc_attributes = attributes_of_arcs(*with_values(graph()), *rows);
  if(!input_->is_ranked())
    return result;
  for(double& value : result.embedding.node_values)
    value = input_->base + value_of_rank(input_->levels, value);
  for(std::vector<double>& values : result.embedding.arc_values)
    for(double& value : values)
      value = input_->base + value_of_rank(input_->levels, value);
  return result;
}

Graph_in_space Graph_of_arrays::embed(std::optional<Embedding_manner> manner) const
{
  const std::lock_guard lock(mutex_);
  return embed_locked(manner.value_or(Embedding_manner::BY_COST), nullptr);
}

std::pair<std::vector<double>, bool> Graph_of_arrays::simplified_scalars() const
{
  std::vector<double> scalars(input_->scalar_map.begin(), input_->scalar_map.end());
  if(!simplification_.is_anything_removed())
    return {std::move(scalars), false};
  check_is_surface(input_->mesh, "a simplified field");
  check_simplification_of_field(simplification_);
  Surface surface = input_->surface(); // a copy, which has room for another map
  const Scalar_map map = add_scalar_map(surface, "v:simplified", scalars);
  const bool are_ties_contracted =
    compute_simplified_field(surface, map, simplification_, threshold_, options_.ties, map).are_ties_contracted;
  scalars.assign(map.begin(), map.end());
  return {std::move(scalars), are_ties_contracted};
}

void Graph_of_arrays::write_page_or_mesh(const std::filesystem::path& path, const File_options& options) const
{
  const bool is_page = path.extension() == ".html";
  check_is_surface(input_->mesh, is_page ? "a page" : "a coloured mesh");
  if(!is_page)
  {
    const std::vector<std::size_t> places = places_of(input_->surface().vertices(), locations());
    return write_mesh(path, input_->mesh, {input_->value_map, places, num_vertices(graph()), std::nullopt});
  }
  check_page(path);
  Page_request request = {input_->surface(), input_->scalar_map, *given_, options_, options.title, options.label};
  // The page compares the values of nodes with those of the field: it shows ranks.
  if(input_->is_ranked() && simplification_.is_anything_removed())
    throw std::invalid_argument("there is no page of a simplified graph whose scalars are ranked");
  request.simplification = simplification_;
  request.threshold = threshold_;
  write_page(path, request);
}

void Graph_of_arrays::write_in_space(const std::filesystem::path& path, const File_options& options) const
{
  const bool is_table = path.extension() == ".csv";
  std::vector<Arc_row> rows;
  const bool has_rows = is_surface() && has_arc_attributes(path);
  if(has_rows)
    rows = measure_rows();
  const Graph_in_space graph_in_space =
    embed_locked(options.manner.value_or(is_table ? Embedding_manner::STRAIGHT : Embedding_manner::BY_COST),
                 has_rows ? &rows : nullptr);
  const std::shared_ptr<const Graph> graph_to_write = to_write(graph());
  const auto attributes = CGAL::parameters::arc_attributes(graph_in_space.arc_attributes);
  write_graph_in_space(path, *graph_to_write, graph_in_space, [&](std::ostream& stream) {
    const Surface& surface = input_->surface();
    if(is_surface())
      CGAL::Reeb_graph::write_json(stream, surface, *graph_to_write, graph_in_space.embedding,
                                   get(boost::vertex_index, surface), attributes);
    else
      CGAL::Reeb_graph::write_json(stream, complex_graph_->result(), graph_in_space.embedding, attributes);
  });
}

void Graph_of_arrays::write(const std::filesystem::path& path, const File_options& options) const
{
  const std::lock_guard lock(mutex_);
  const std::string ending = path.extension().string();
  if(ending == ".html" || ending == ".ply")
    return write_page_or_mesh(path, options);
  if(ending == ".pers")
    return write_pairs(path, *to_write(graph()), pairs());
  if(is_format_in_space(path))
    return write_in_space(path, options);
  std::vector<CGAL::Reeb_graph::Attribute> attributes;
  if(is_surface() && has_arc_attributes(path))
    attributes = attributes_of_arcs(*with_values(graph()), measure_rows());
  write_graph(path, *to_write(graph()), options.label, {}, attributes);
}

std::string Graph_of_arrays::report() const
{
  Report report = *report_;
  count_all(input_->mesh, is_surface() ? *given_ : on_vertices(*given_complex_), report);
  if(simplification_.is_anything_removed())
    count_simplified(graph(), threshold_, report);
  std::ostringstream stream;
  write_json(stream, report);
  return stream.str();
}

} // namespace reeb_graph_python
