// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of the CGAL-style package Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_INTERNAL_SCALAR_FIELDS_LEVEL_BORDER_VALUES_H
#define CGAL_REEB_GRAPH_INTERNAL_SCALAR_FIELDS_LEVEL_BORDER_VALUES_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/internal/base/Progress.h>
#include <CGAL/Reeb_graph/internal/base/Scalar_conversion.h>
#include <CGAL/Reeb_graph/internal/mesh/border_cycles.h>
#include <CGAL/Reeb_graph/internal/mesh/flatten.h>
#include <CGAL/Reeb_graph/internal/scalar_fields/Basin_filling.h>
#include <CGAL/Reeb_graph/internal/scalar_fields/Border_levels.h>
#include <CGAL/Reeb_graph/internal/scalar_fields/Weighted_graph.h>
#include <CGAL/Reeb_graph/options.h>

#include <CGAL/boost/graph/iterator.h>
#include <CGAL/tags.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Reeb_graph {
namespace internal {
namespace scalar_fields {

// The vertices of each border component.
template <class Mesh, class NumberOfVertex>
std::vector<std::vector<Position>> vertices_of_borders(const Mesh& mesh, const NumberOfVertex& number)
{
  std::vector<std::vector<Position>> borders;
  for(const auto& cycle : find_border_cycles(mesh))
  {
    borders.emplace_back();
    for(const auto v : vertices_around_face(cycle.halfedge, mesh))
      borders.back().push_back(number(v).number());
  }
  return borders;
}

// The vertices that are on no border, and at most `width` edges away from the given ones; nearer ones come first.
inline std::vector<Position> vertices_around(const Weighted_graph& graph,
                                             const std::vector<Position>& border_vertices,
                                             const std::vector<bool>& is_on_border,
                                             std::size_t width)
{
  std::vector<Position> reached = border_vertices;
  std::vector<bool> is_reached(graph.number_of_vertices(), false);
  for(const Position v : border_vertices)
    is_reached[v] = true;
  std::size_t begin = 0;
  for(; width > 0 && begin != reached.size(); --width)
    for(const std::size_t end = reached.size(); begin != end; ++begin)
      for(const auto& n : graph.neighbors(reached[begin]))
      {
        if(is_reached[n.vertex] || is_on_border[n.vertex])
          continue;
        is_reached[n.vertex] = true;
        reached.push_back(n.vertex);
      }
  reached.erase(reached.begin(), reached.begin() + static_cast<std::ptrdiff_t>(border_vertices.size()));
  return reached;
}

// The values of a field, changed so that each border component is an extremal level; see make_borders_level().
template <class Scalar, class Traits>
std::vector<Scalar> level_border_values(const Weighted_graph& graph,
                                        const std::vector<std::vector<Position>>& borders,
                                        const std::vector<Scalar>& values,
                                        const Traits& traits,
                                        Border_extremum wish,
                                        std::size_t collar_width)
{
  const auto less = traits.less_scalar_object();
  std::vector<Scalar> result = values;
  std::vector<bool> is_on_border(values.size(), false), is_free(values.size(), false);
  std::vector<Position> changed;
  const std::vector<Scalar> levels = Border_levels<Scalar, Traits>(graph, values, borders, traits)(wish);
  for(std::size_t b = 0; b != borders.size(); ++b)
    for(const Position v : borders[b])
    {
      is_on_border[v] = true;
      if(less(values[v], levels[b]) || less(levels[b], values[v]))
        changed.push_back(v);
      result[v] = levels[b];
    }
  if constexpr(Level_arithmetic<Scalar, Traits>::has_numbers)
  {
    const std::vector<Position> collar = vertices_around(graph, changed, is_on_border, collar_width);
    if(collar.empty())
      return result;
    for(const Position v : collar)
      is_free[v] = true;
    Basin_filling<Scalar> basins(graph, is_free, is_on_border, result);
    for(const int sign : {1, -1})
      basins.remove_new_minima(collar, values, sign);
  }
  return result;
}

// Checks mesh and field, changes the field, and counts the changes.
template <class Changes, class Mesh, class ScalarMap, class Traits>
Changes write_level_borders(const Mesh& mesh,
                            const ScalarMap& scalar_map,
                            const Traits& traits,
                            Border_extremum wish,
                            std::size_t collar_width,
                            const Progress& progress)
{
  progress.report(0);
  const auto surface = share_flat<Sequential_tag>(mesh, scalar_map, traits, parameters::default_values());
  const auto& [complex, field] = *surface;
  const auto less = traits.less_scalar_object();
  progress.report(0.2);
  const std::vector<typename Traits::Scalar> values(field.values.begin(), field.values.end());
  const auto borders = vertices_of_borders(mesh, field.numbers);
  const auto graph = edge_graph(complex);
  progress.report(0.9);
  const auto new_values = level_border_values(graph, borders, values, traits, wish, collar_width);
  progress.report(0.95); // the last one before the field changes
  Changes changes;
  const Scalar_conversion<Traits> conversion(traits);
  const auto is_changed = [&](Position v) { return less(values[v], new_values[v]) || less(new_values[v], values[v]); };
  changes.number_of_borders = borders.size();
  for(const auto& border : borders)
    changes.number_of_changed_borders += std::any_of(border.begin(), border.end(), is_changed) ? 1 : 0;
  for(Position v = 0; v != values.size(); ++v)
  {
    if(!is_changed(v))
      continue;
    ++changes.number_of_changed_vertices;
    changes.largest_change =
      (std::max)(changes.largest_change, distance_of_values(conversion, values[v], new_values[v]));
    put(scalar_map, field.vertices[Vertex_index(v)], new_values[v]);
  }
  progress.report_end();
  return changes;
}

} // namespace scalar_fields
} // namespace internal
} // namespace Reeb_graph
} // namespace CGAL

#endif // CGAL_REEB_GRAPH_INTERNAL_SCALAR_FIELDS_LEVEL_BORDER_VALUES_H
