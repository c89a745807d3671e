// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_FIELDS_INTERNAL_CONSTRAINTS_H
#define CGAL_REEB_GRAPH_FIELDS_INTERNAL_CONSTRAINTS_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/fields/exceptions.h>
#include <CGAL/Reeb_graph/fields/field_constraints.h>
#include <CGAL/Reeb_graph/fields/internal/Indexed_surface.h>
#include <CGAL/Reeb_graph/fields/internal/laplacian_graph.h>
#include <CGAL/Reeb_graph/internal/base/Progress.h>
#include <CGAL/Reeb_graph/internal/base/requirements.h>
#include <CGAL/Reeb_graph/internal/complex/Flat_mesh.h>
#include <CGAL/Reeb_graph/internal/complex/Weighted_graph.h>
#include <CGAL/Reeb_graph/named_parameters.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/boost/graph/iterator.h>
#include <CGAL/boost/graph/properties.h>
#include <CGAL/number_utils.h>

#include <boost/property_map/property_map.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL::Reeb_graph::internal::scalar_fields {

// The floating point type in which the values of a field are found: that of the map, else double.
template <class FieldMap>
using Scalar_of_field = std::conditional_t<std::is_same_v<typename Value_of_map<FieldMap>::type, float>, float, double>;

// Vertices whose values are given, and these values.
template <class Scalar>
struct Constraints
{
  std::vector<bool> is_fixed;
  std::vector<Scalar> values; // zero for free vertices

  explicit Constraints(std::size_t number_of_vertices)
    : is_fixed(number_of_vertices, false),
      values(number_of_vertices, Scalar(0))
  {}

  void fix(Index v, Scalar value)
  {
    if(v == no_index)
      throw Unknown_vertex_error();
    if(!std::isfinite(value))
      throw Non_finite_scalar_error(v);
    if(is_fixed[v] && values[v] != value)
      throw Contradictory_constraints_error(v);
    is_fixed[v] = true;
    values[v] = value;
  }
};

// Fixes the vertices of a range of pairs of a vertex and its value.
template <class Surface, class ConstraintRange, class Scalar>
void fix_vertices(const Surface& surface, const ConstraintRange& range, Constraints<Scalar>& constraints)
{
  for(const auto& [vertex, value] : range)
    constraints.fix(surface.dense_vertex(vertex), static_cast<Scalar>(CGAL::to_double(value)));
}

inline void check_components(const Weighted_graph& graph, const std::vector<bool>& is_fixed)
{
  const std::vector<Index> labels = label_components(graph);
  std::vector<bool> is_constrained(graph.number_of_vertices(), false); // by component
  for(Index v = 0; v != graph.number_of_vertices(); ++v)
    if(is_fixed[v])
      is_constrained[labels[v]] = true;
  for(Index v = 0; v != graph.number_of_vertices(); ++v)
    if(!is_constrained[labels[v]])
      throw Unconstrained_component_error(labels[v], v);
}

template <class Scalar>
void check_finite(const std::vector<Scalar>& values)
{
  for(std::size_t v = 0; v != values.size(); ++v)
    if(!std::isfinite(values[v]))
      throw Non_finite_scalar_error(v);
}

// Writes a field only when all of its values are known to be finite: the last step of a computation, which cannot be
// cancelled any more.
template <class Surface, class Scalar, class FieldMap>
void write_field(const Surface& surface,
                 const std::vector<Scalar>& values,
                 FieldMap field_map,
                 const Progress& progress)
{
  typedef typename boost::property_traits<FieldMap>::value_type Value;
  static_assert(!std::is_integral_v<Value>, "the value type of the field map must not be an integer type");
  for(std::size_t v = 0; v != values.size(); ++v)
    if(!std::isfinite(static_cast<Scalar_of_field<FieldMap>>(values[v])))
      throw Non_finite_scalar_error(v);
  for(std::size_t v = 0; v != values.size(); ++v)
    put(field_map, surface.vertex_handle(v), static_cast<Value>(values[v]));
  progress.report_end();
}

// Reads a field all of whose values have to be finite.
template <class Surface, class ScalarMap>
std::vector<double> read_field(const Surface& surface, const ScalarMap& scalar_map)
{
  std::vector<double> values;
  if constexpr(Vertex_map<ScalarMap, typename Surface::Mesh>::value)
  {
    values.reserve(surface.number_of_vertices());
    for(const auto v : surface.vertex_handles())
    {
      values.push_back(CGAL::to_double(get(scalar_map, v)));
      if(!std::isfinite(values.back()))
        throw Non_finite_scalar_error(values.size() - 1);
    }
  }
  return values;
}

// Writes the field that solve(surface, graph, constraints, progress, report) finds with the constraints that
// fix_vertices(surface, graph, constraints) gives.
template <class Scalar, class FaceListGraph, class FieldMap, class NamedParameters, class FixVertices, class Solve>
Field_report write_solution(const FaceListGraph& mesh,
                            FieldMap field_map,
                            Laplacian_weights weights,
                            const NamedParameters& np,
                            const FixVertices& fix_vertices,
                            const Solve& solve)
{
  Field_report report;
  static_assert(are_met<Mesh_with_vertex_map<FaceListGraph, FieldMap>>);
  const Progress progress(np);
  progress.report(0);
  Indexed_mesh<FaceListGraph> surface(mesh, np);
  if(weights != Laplacian_weights::UNIFORM)
    report = make_triangles_proper(surface);
  const Weighted_graph graph = laplacian_graph(surface, weights);
  progress.report(0.1);
  Constraints<Scalar> constraints(surface.number_of_vertices());
  fix_vertices(surface, graph, constraints);
  check_components(graph, constraints.is_fixed);
  const auto values = solve_or_lengthen_edges(
    surface, graph, weights, report, [&](const Weighted_graph& weighted_graph, double begin, double end) {
      return solve(surface, weighted_graph, constraints, Stage_progress(progress, begin, end), report);
    });
  write_field(surface, values, field_map, progress);
  return report;
}

// The vertices with given values of a harmonic field whose extrema are all borders: 0 on the first border of each
// component, 1 on the other ones. A component with one border has a vertex far from it as other end; a component
// without border has two vertices that are far apart.
template <class Mesh, class NamedParameters>
auto fix_borders(const Mesh& mesh, const NamedParameters& np)
{
  typedef typename boost::graph_traits<Mesh>::vertex_descriptor vertex_descriptor;
  std::vector<std::pair<vertex_descriptor, double>> constraints;
  const auto is_reached = get(dynamic_vertex_property_t<bool>(), mesh);
  for(const vertex_descriptor v : vertices(mesh))
  {
    const bool is_isolated = halfedge(v, mesh) == boost::graph_traits<Mesh>::null_halfedge();
    put(is_reached, v, is_isolated);
    if(is_isolated)
      constraints.emplace_back(v, 0.);
  }
  for(const auto& cycle : find_border_cycles(mesh))
  {
    const bool is_first = !get(is_reached, target(cycle.halfedge, mesh)); // which reaches all vertices of its component
    fix_border_cycle(cycle.halfedge, mesh, is_first ? 0. : 1., std::back_inserter(constraints));
    if(!is_first)
      continue;
    std::vector<vertex_descriptor> reached;
    const auto reach = [&](vertex_descriptor v) {
      if(get(is_reached, v))
        return;
      put(is_reached, v, true);
      reached.push_back(v);
    };
    for(const vertex_descriptor v : vertices_around_face(cycle.halfedge, mesh))
      reach(v);
    const std::size_t size_of_border = reached.size();
    bool has_other_border = false;
    for(std::size_t i = 0; i != reached.size(); ++i)
      for(const auto h : halfedges_around_target(reached[i], mesh))
      {
        has_other_border = has_other_border || (i >= size_of_border && is_border(h, mesh));
        reach(source(h, mesh));
      }
    if(!has_other_border && reached.size() > size_of_border)
      constraints.emplace_back(reached.back(), 1.);
  }
  const auto is_done = [&](vertex_descriptor v) { return get(is_reached, v); };
  if(std::all_of(vertices(mesh).begin(), vertices(mesh).end(), is_done))
    return constraints;
  std::vector<std::pair<vertex_descriptor, vertex_descriptor>> ends;
  // The callback is that of the field, whose progress begins later.
  find_far_apart_vertices(mesh, std::back_inserter(ends), parameters::vertex_point_map(choose_point_map(mesh, np)));
  for(const auto& [lowest, highest] : ends)
  {
    if(is_done(lowest))
      continue;
    constraints.emplace_back(lowest, 0.);
    if(highest != lowest)
      constraints.emplace_back(highest, 1.);
  }
  return constraints;
}

} // namespace CGAL::Reeb_graph::internal::scalar_fields

#endif // CGAL_REEB_GRAPH_FIELDS_INTERNAL_CONSTRAINTS_H
