// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of the CGAL-style package Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_FIELDS_INTERNAL_CONSTRAINTS_H
#define CGAL_REEB_GRAPH_FIELDS_INTERNAL_CONSTRAINTS_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/fields/exceptions.h>
#include <CGAL/Reeb_graph/fields/field_constraints.h>
#include <CGAL/Reeb_graph/fields/internal/Weighted_graph.h>
#include <CGAL/Reeb_graph/internal/base/Progress.h>
#include <CGAL/Reeb_graph/internal/base/named_parameter.h>
#include <CGAL/Reeb_graph/internal/base/requirements.h>
#include <CGAL/Reeb_graph/internal/complex/border_cycles.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/boost/graph/iterator.h>
#include <CGAL/boost/graph/properties.h>
#include <CGAL/number_utils.h>

#include <boost/property_map/property_map.hpp>

#include <cmath>
#include <cstddef>
#include <iterator>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL::Reeb_graph::internal::scalar_fields {

// The floating point type in which the values of a field are found: that of the map, else double.
template <class FieldMap>
struct Scalar_of_field
{
  typedef typename Value_of_map<FieldMap>::type Value;
  static_assert(!std::is_integral_v<Value>, "the value type of the field map must not be an integer type");
  typedef std::conditional_t<std::is_same_v<Value, float>, float, double> type;
};

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

  void fix(Position v, Scalar value)
  {
    if(v == no_position)
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
    constraints.fix(surface.position(vertex), static_cast<Scalar>(CGAL::to_double(value)));
}

inline void check_components(const Weighted_graph& graph, const std::vector<bool>& is_fixed)
{
  const std::vector<Position> labels = label_components(graph);
  std::vector<bool> is_constrained;
  std::vector<Position> first_vertices;
  for(Position v = 0; v != graph.number_of_vertices(); ++v)
  {
    if(labels[v] == first_vertices.size())
    {
      first_vertices.push_back(v);
      is_constrained.push_back(false);
    }
    if(is_fixed[v])
      is_constrained[labels[v]] = true;
  }
  for(std::size_t component = 0; component != first_vertices.size(); ++component)
    if(!is_constrained[component])
      throw Unconstrained_component_error(component, first_vertices[component]);
}

template <class Scalar>
void check_finite(const std::vector<Scalar>& values)
{
  for(std::size_t v = 0; v != values.size(); ++v)
    if(!std::isfinite(values[v]))
      throw Non_finite_scalar_error(v);
}

// Writes a field only when all of its values are known to be finite.
template <class Surface, class Scalar, class FieldMap>
void write_field(const Surface& surface, const std::vector<Scalar>& values, FieldMap field_map)
{
  if constexpr(Writable_vertex_map<FieldMap, typename Surface::Mesh>::value)
  {
    typedef typename boost::property_traits<FieldMap>::value_type Value;
    for(std::size_t v = 0; v != values.size(); ++v)
      if(!std::isfinite(static_cast<typename Scalar_of_field<FieldMap>::type>(values[v])))
        throw Non_finite_scalar_error(v);
    for(std::size_t v = 0; v != values.size(); ++v)
      put(field_map, surface.vertex_handle(v), static_cast<Value>(values[v]));
  }
}

// Writes the field as the last step of a computation, which cannot be cancelled any more.
template <class Surface, class Scalar, class FieldMap>
void write_field(const Surface& surface,
                 const std::vector<Scalar>& values,
                 FieldMap field_map,
                 const Progress& progress)
{
  write_field(surface, values, field_map);
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

// The vertices with given values of a harmonic field whose extrema are all borders: 0 on the first border of each
// component, 1 on the other ones. A component with one border has a vertex far from it as other end; a component
// without border has two vertices that are far apart.
template <class Mesh>
class Harmonic_constraints
{
  typedef typename boost::graph_traits<Mesh>::vertex_descriptor vertex_descriptor;
  typedef typename boost::graph_traits<Mesh>::halfedge_descriptor halfedge_descriptor;

public:
  typedef std::vector<std::pair<vertex_descriptor, double>> Range;

  template <class NamedParameters>
  Harmonic_constraints(const Mesh& mesh, const NamedParameters& np)
    : mesh_(mesh),
      is_reached_(get(dynamic_vertex_property_t<bool>(), mesh))
  {
    for(const vertex_descriptor v : vertices(mesh))
      put(is_reached_, v, false);
    fix_borders();
    std::vector<std::pair<vertex_descriptor, vertex_descriptor>> ends;
    // The callback is that of the field, whose progress begins later.
    find_far_apart_vertices(mesh, std::back_inserter(ends), parameters::vertex_point_map(choose_point_map(mesh, np)));
    for(const auto& pair : ends)
    {
      if(get(is_reached_, pair.first))
        continue;
      range_.emplace_back(pair.first, 0.);
      if(pair.second != pair.first)
        range_.emplace_back(pair.second, 1.);
    }
  }

  const Range& range() const { return range_; }

private:
  void fix_borders()
  {
    for(const auto& cycle : find_border_cycles(mesh_))
      fix_border(cycle.halfedge);
  }

  // Fixes a border; the first one of a component reaches all of its vertices.
  void fix_border(halfedge_descriptor border)
  {
    const bool is_first = !get(is_reached_, target(border, mesh_));
    fix_border_cycle(border, mesh_, is_first ? 0. : 1., std::back_inserter(range_));
    if(!is_first)
      return;
    std::vector<vertex_descriptor> reached;
    const auto reach = [&](vertex_descriptor v) {
      if(get(is_reached_, v))
        return;
      put(is_reached_, v, true);
      reached.push_back(v);
    };
    for(const vertex_descriptor v : vertices_around_face(border, mesh_))
      reach(v);
    const std::size_t size_of_border = reached.size();
    bool has_other_border = false;
    for(std::size_t i = 0; i != reached.size(); ++i)
      for(const halfedge_descriptor h : halfedges_around_target(reached[i], mesh_))
      {
        has_other_border = has_other_border || (i >= size_of_border && is_border(h, mesh_));
        reach(source(h, mesh_));
      }
    if(!has_other_border && reached.size() > size_of_border)
      range_.emplace_back(reached.back(), 1.);
  }

  const Mesh& mesh_;
  typename boost::property_map<Mesh, dynamic_vertex_property_t<bool>>::const_type is_reached_;
  Range range_;
};

} // namespace CGAL::Reeb_graph::internal::scalar_fields

#endif // CGAL_REEB_GRAPH_FIELDS_INTERNAL_CONSTRAINTS_H
