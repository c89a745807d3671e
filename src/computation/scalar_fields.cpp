// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#include "computation/scalar_fields.h"

#include "base/progress_bar.h"
#include "input/repair_soup.h"

#include <CGAL/Reeb_graph/fields/geodesic_field.h>
#include <CGAL/Reeb_graph/fields/harmonic_field.h>
#include <CGAL/Reeb_graph/fields/height_field.h>
#include <CGAL/Reeb_graph/fields/poisson_field.h>
#include <CGAL/Reeb_graph/internal/base/lengths.h>
#include <CGAL/Reeb_graph/internal/complex/Flat_mesh.h>
#include <CGAL/property_map.h>

#include <boost/graph/compressed_sparse_row_graph.hpp>
#include <boost/graph/dijkstra_shortest_paths.hpp>
#include <boost/property_map/property_map.hpp>

#include <algorithm>
#include <array>
#include <functional>
#include <iterator>
#include <limits>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace reeb_graph_program {
namespace {
typedef Surface::Vertex_index Vertex;
typedef std::vector<std::pair<std::size_t, std::size_t>> Edges;

Vertex vertex(const Surface& surface, std::size_t number)
{
  if(number >= surface.number_of_vertices())
    throw std::runtime_error("there is no vertex " + std::to_string(number) + ": the mesh has "
                             + std::to_string(surface.number_of_vertices()) + ", numbered from 0");
  return Vertex(static_cast<Surface::size_type>(number));
}

struct Length
{
  double length = 0;
};

// Each edge twice, once in each direction, in ascending order.
Edges directed_edges(const Mesh& mesh)
{
  Edges edges;
  visit_edges(mesh, [&](std::size_t u, std::size_t v) {
    edges.emplace_back(u, v);
    edges.emplace_back(v, u);
  });
  std::sort(edges.begin(), edges.end());
  edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
  return edges;
}

// The distances of all vertices from the nearest source. Behind the vertices there is one more, from which edges of
// length 0 lead to the sources.
std::vector<double> distances_from(const Surface& surface, Edges edges, const std::vector<std::size_t>& sources)
{
  typedef boost::compressed_sparse_row_graph<boost::directedS, boost::no_property, Length> Graph;
  std::vector<Length> lengths;
  lengths.reserve(edges.size() + sources.size());
  const auto point = [&](std::size_t v) {
    return surface.point(Surface::Vertex_index(static_cast<Surface::size_type>(v)));
  };
  for(const auto& [u, v] : edges)
    lengths.push_back({CGAL::Reeb_graph::internal::distance_between(point(u), point(v))});
  const std::size_t number_of_vertices = surface.number_of_vertices();
  for(const std::size_t source : sources)
    edges.emplace_back(number_of_vertices, source);
  lengths.resize(edges.size());
  const Graph graph(boost::edges_are_sorted, edges.begin(), edges.end(), lengths.begin(), number_of_vertices + 1);
  std::vector<double> distances(number_of_vertices + 1);
  boost::dijkstra_shortest_paths(
    graph, number_of_vertices,
    boost::weight_map(get(&Length::length, graph))
      .distance_map(boost::make_iterator_property_map(distances.begin(), get(boost::vertex_index, graph)))
      .distance_inf(std::numeric_limits<double>::infinity()));
  distances.pop_back();
  return distances;
}

// The connected components, in the order of their first vertices.
class Components
{
public:
  Components(const Edges& edges, std::size_t number_of_vertices) : numbers_(number_of_vertices)
  {
    Union_find_of_indices sets(number_of_vertices);
    for(const auto& [u, v] : edges)
      sets.unite(u, v);
    std::vector<std::size_t> numbers(number_of_vertices, no_vertex); // by representative
    for(std::size_t v = 0; v < number_of_vertices; ++v)
    {
      std::size_t& number = numbers[sets.find(v)];
      if(number == no_vertex)
      {
        number = firsts_.size();
        firsts_.push_back(v);
      }
      numbers_[v] = number;
    }
  }

  const std::vector<std::size_t>& firsts() const { return firsts_; }
  std::size_t size() const { return firsts_.size(); }
  std::size_t operator[](std::size_t vertex) const { return numbers_[vertex]; }

private:
  std::vector<std::size_t> numbers_, firsts_;
};

// A vertex of each component that is farthest away from its first one.
std::vector<std::size_t> far_sources(const Surface& surface, const Edges& edges, const Components& components)
{
  const std::vector<double> distances = distances_from(surface, edges, components.firsts());
  std::vector<std::size_t> farthest = components.firsts();
  for(std::size_t v = 0; v < distances.size(); ++v)
  {
    std::size_t& best = farthest[components[v]];
    best = distances[v] > distances[best] ? v : best;
  }
  std::sort(farthest.begin(), farthest.end());
  return farthest;
}

// The vertices of components without a source, that is, without a vertex whose value is given.
struct Unreached
{
  std::vector<std::size_t> firsts; // one of each component
  std::vector<std::size_t> vertices;

  void set_nan(Scalar_map scalar_map) const
  {
    for(const std::size_t v : vertices)
      scalar_map[Vertex(static_cast<Surface::size_type>(v))] = std::numeric_limits<double>::quiet_NaN();
  }
};

// Throws std::runtime_error if there are any, unless they may be left: then the report says so.
Unreached find_unreached(const Components& components,
                         std::size_t number_of_vertices,
                         const std::vector<std::size_t>& sources,
                         const Input_options& options,
                         Work_report& report)
{
  constexpr std::size_t most_names = 8;
  std::vector<char> is_reached(components.size(), 0);
  for(const std::size_t source : sources)
    is_reached[components[source]] = 1;
  Unreached unreached;
  std::string names;
  for(std::size_t i = 0; i < components.size(); ++i)
    if(is_reached[i] == 0)
    {
      unreached.firsts.push_back(components.firsts()[i]);
      if(unreached.firsts.size() <= most_names)
        names += (names.empty() ? "component " : ", component ") + std::to_string(i) + ", that of vertex "
               + std::to_string(components.firsts()[i]);
    }
  for(std::size_t v = 0; v < number_of_vertices; ++v)
    if(is_reached[components[v]] == 0)
      unreached.vertices.push_back(v);
  const std::size_t number = unreached.firsts.size();
  if(number == 0)
    return unreached;
  const std::string description = names
                                + (number > most_names ? ", and " + std::to_string(number - most_names) + " more" : "")
                                + (number == 1 ? ", has" : ", have") + " no vertex whose value is given";
  if(!options.is_unreached_left)
    throw std::runtime_error(description + "; reeb_graph field --unreached nan leaves " + (number == 1 ? "it" : "them")
                             + " NaN, and reeb_graph repair --unused leaves out points " + "of no face");
  report.notes.push_back(description + ": NaN");
  return unreached;
}

} // namespace

std::vector<std::size_t> compute_distances_along_edges(const Mesh& mesh,
                                                       const Input_options& options,
                                                       Scalar_map scalar_map,
                                                       Work_report& report)
{
  const Surface& surface = mesh.surface;
  std::vector<std::size_t> sources = options.source_vertices;
  for(const std::size_t source : sources)
    vertex(surface, source);
  const Edges edges = directed_edges(mesh);
  const Components components(edges, surface.number_of_vertices());
  if(sources.empty())
    sources = far_sources(surface, edges, components);
  const Unreached unreached = find_unreached(components, surface.number_of_vertices(), sources, options, report);
  const std::vector<double> distances = distances_from(surface, edges, sources);
  for(const Surface::Vertex_index v : surface.vertices())
    scalar_map[v] = distances[v];
  unreached.set_nan(scalar_map);
  return sources;
}

namespace {
typedef CGAL::Reeb_graph::Field_report Field_report;

std::vector<std::pair<Vertex, Vertex>> far_apart_vertices(const Surface& surface)
{
  std::vector<std::pair<Vertex, Vertex>> pairs;
  Progress_bar progress_bar("far vertices");
  CGAL::Reeb_graph::find_far_apart_vertices(surface, std::back_inserter(pairs),
                                            CGAL::parameters::callback(std::ref(progress_bar)));
  return pairs;
}

typedef std::vector<std::pair<Vertex, double>> Constraints;

// The components that none of the given vertices are in.
Unreached find_unreached(const Surface& surface,
                         const Constraints& given,
                         const Input_options& options,
                         Work_report& report)
{
  if(options.source_vertices.empty() && !options.lowest_vertex)
    return {}; // There is one in each component.
  Edges edges;
  for(const Surface::Edge_index e : surface.edges())
    edges.emplace_back(surface.vertex(e, 0), surface.vertex(e, 1));
  std::vector<std::size_t> sources;
  for(const auto& constraint : given)
    sources.push_back(constraint.first);
  return find_unreached(Components(edges, surface.number_of_vertices()), surface.number_of_vertices(), sources, options,
                        report);
}

// The constraints, and any value where nothing reaches.
Constraints with_unreached(Constraints constraints, const Unreached& unreached)
{
  for(const std::size_t v : unreached.firsts)
    constraints.emplace_back(static_cast<Surface::size_type>(v), 0);
  return constraints;
}

// The value 0 at the vertices that are given, else at one in each component, far away from another one.
Constraints sources(const Input_options& options, const Surface& surface)
{
  Constraints result;
  for(const std::size_t number : options.source_vertices)
    result.emplace_back(vertex(surface, number), 0);
  if(!result.empty())
    return result;
  for(const auto& pair : far_apart_vertices(surface))
    result.emplace_back(pair.first, 0);
  return result;
}

CGAL::Reeb_graph::Laplacian_weights weights(const Input_options& options)
{
  using CGAL::Reeb_graph::Laplacian_weights;
  return options.weights == "cotangent" ? Laplacian_weights::COTANGENT
       : options.weights == "uniform"   ? Laplacian_weights::UNIFORM
                                        : Laplacian_weights::MEAN_VALUE;
}

// The two vertices that are given, else two in each component that are far apart.
Constraints poles(const Input_options& options, const Surface& surface)
{
  if(options.lowest_vertex)
    return {{vertex(surface, *options.lowest_vertex), 0}, {vertex(surface, *options.highest_vertex), 1}};
  Constraints result;
  for(const auto& [lowest, highest] : far_apart_vertices(surface))
  {
    result.emplace_back(lowest, 0);
    if(highest != lowest)
      result.emplace_back(highest, 1);
  }
  return result;
}

// Which vertices have been given a value; isolated ones are left out.
Fixed_values fixed_values(const std::string& field, const Surface& surface, const Constraints& constraints)
{
  Fixed_values fixed = {field, {}, {}};
  for(const auto& [v, value] : constraints)
    if(!surface.is_isolated(v))
      fixed.vertices.push_back({v, value});
  return fixed;
}

// Returns the vertices that no value reaches.
Unreached compute_harmonic(const Input_options& options,
                           const Surface& surface,
                           Scalar_map scalar_map,
                           Work_report& report)
{
  const Constraints constraints = poles(options, surface);
  const Unreached unreached = find_unreached(surface, constraints, options, report);
  Progress_bar progress_bar("harmonic field");
  const auto np = CGAL::parameters::laplacian_weights(weights(options)).callback(std::ref(progress_bar));
  report.field =
    CGAL::Reeb_graph::compute_harmonic_field(surface, scalar_map, with_unreached(constraints, unreached), np);
  report.fixed_values = fixed_values("harmonic", surface, constraints);
  return unreached;
}

void compute_between_borders(const Input_options& options,
                             const Surface& surface,
                             Scalar_map scalar_map,
                             Work_report& report)
{
  Progress_bar progress_bar("harmonic field");
  const auto np = CGAL::parameters::laplacian_weights(weights(options)).callback(std::ref(progress_bar));
  const auto constraints = CGAL::Reeb_graph::internal::scalar_fields::fix_borders(surface, np);
  report.field = CGAL::Reeb_graph::compute_harmonic_field(surface, scalar_map, constraints, np);
  Constraints inner;
  for(const auto& constraint : constraints)
    if(!surface.is_border(constraint.first, false))
      inner.push_back(constraint);
  report.fixed_values = fixed_values("harmonic", surface, inner);
  for(const auto& border : CGAL::Reeb_graph::internal::find_border_cycles(surface))
    report.fixed_values->borders.push_back({border.first_vertex, scalar_map[surface.target(border.halfedge)]});
}

// Returns the vertices that no value reaches.
Unreached compute_from_sources(const Input_options& options,
                               const Surface& surface,
                               Scalar_map scalar_map,
                               Work_report& report)
{
  Constraints constraints = sources(options, surface);
  report.fixed_values = fixed_values(options.field, surface, constraints);
  const Unreached unreached = find_unreached(surface, constraints, options, report);
  constraints = with_unreached(constraints, unreached);
  Progress_bar progress_bar(options.field + " field");
  const auto np = CGAL::parameters::callback(std::ref(progress_bar));
  if(options.field == "poisson")
  {
    report.field = CGAL::Reeb_graph::compute_curvature_poisson_field(surface, scalar_map, constraints, np);
    return unreached;
  }
  std::vector<Vertex> source_vertices;
  for(const auto& constraint : constraints)
    source_vertices.push_back(constraint.first);
  CGAL::Reeb_graph::compute_geodesic_field(surface, scalar_map, source_vertices, np);
  return unreached;
}

void compute_height(const Input_options& options, const Surface& surface, Scalar_map scalar_map)
{
  typedef CGAL::Kernel_traits<Point>::Kernel::Vector_3 Vector;
  const std::vector<double> z = {0, 0, 1}, &d = options.direction.empty() ? z : options.direction;
  Progress_bar progress_bar("height");
  CGAL::Reeb_graph::compute_height_field(surface, scalar_map, Vector(d[0], d[1], d[2]),
                                         CGAL::parameters::callback(std::ref(progress_bar)));
}

void check(bool is_right, const std::string& message)
{
  if(!is_right)
    throw std::runtime_error(message);
}

} // namespace

std::vector<double> compute_unit_gradient(const Surface& surface, Scalar_map scalar_map, Work_report& report)
{
  Progress_bar progress_bar("unit gradient field");
  std::vector<double> values(surface.number_of_vertices());
  report.field = CGAL::Reeb_graph::compute_unit_gradient_field(surface, scalar_map, CGAL::make_property_map(values),
                                                               CGAL::parameters::callback(std::ref(progress_bar)));
  return values;
}

bool is_computed(const std::string& field)
{
  constexpr std::array<std::string_view, 6> names = {"height",  "harmonic", "harmonic-between-borders",
                                                     "poisson", "geodesic", "unit-gradient"};
  return std::find(names.begin(), names.end(), field) != names.end();
}

void check_field_options(const Input_options& options)
{
  const std::string& field = options.field;
  const bool is_harmonic = field == "harmonic" || (field == "unit-gradient" && options.scalars_path.empty());
  check(!field.empty() || !options.scalars_path.empty(), "a field is needed, such as --field z or --scalars FILE");
  check(field.empty() || field == "unit-gradient" || options.scalars_path.empty(),
        "--scalars goes with the field unit-gradient only, or without any");
  check(options.column.empty() || !options.scalars_path.empty(), "--column goes with --scalars only");
  check(options.lowest_vertex.has_value() == options.highest_vertex.has_value(), "--min and --max go together");
  check(!options.lowest_vertex || is_harmonic, "--min and --max go with the field harmonic only");
  check(options.weights.empty() || is_harmonic || field == "harmonic-between-borders",
        "--weights goes with the fields harmonic and harmonic-between-borders only");
  check(options.source_vertices.empty() || field == "poisson" || field == "geodesic",
        "--source goes with the fields poisson and geodesic only");
  check(!options.is_unreached_left || is_harmonic || field == "poisson" || field == "geodesic",
        "--unreached goes with the fields harmonic, poisson, geodesic, and unit-gradient only");
  check(options.direction.empty() || field == "height", "--direction goes with the field height only");
}

void compute_scalar_field(const Input_options& options,
                          const Surface& surface,
                          Scalar_map scalar_map,
                          Work_report& report)
{
  Unreached unreached;
  if(options.field == "harmonic" || (options.field == "unit-gradient" && options.scalars_path.empty()))
    unreached = compute_harmonic(options, surface, scalar_map, report);
  if(options.field == "harmonic-between-borders")
    compute_between_borders(options, surface, scalar_map, report);
  else if(options.field == "poisson" || options.field == "geodesic")
    unreached = compute_from_sources(options, surface, scalar_map, report);
  else if(options.field == "unit-gradient")
  {
    const std::vector<double> values = compute_unit_gradient(surface, scalar_map, report);
    std::copy(values.begin(), values.end(), scalar_map.begin());
  }
  else if(options.field == "height")
    compute_height(options, surface, scalar_map);
  unreached.set_nan(scalar_map);
}

} // namespace reeb_graph_program
