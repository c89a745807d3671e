// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_FIELDS_INTERNAL_LEVEL_BORDER_VALUES_H
#define CGAL_REEB_GRAPH_FIELDS_INTERNAL_LEVEL_BORDER_VALUES_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/fields/internal/Border_levels.h>
#include <CGAL/Reeb_graph/internal/base/Progress.h>
#include <CGAL/Reeb_graph/internal/base/scalars.h>
#include <CGAL/Reeb_graph/internal/complex/Flat_mesh.h>
#include <CGAL/Reeb_graph/internal/complex/Weighted_graph.h>
#include <CGAL/Reeb_graph/options.h>

#include <CGAL/boost/graph/iterator.h>
#include <CGAL/tags.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <queue>
#include <utility>
#include <vector>

namespace CGAL::Reeb_graph::internal::scalar_fields {

// Removes minima by filling the basins around them: the vertices below the lowest pass out of the basin get values just
// above that of the pass, in an order in which each has a lower and a higher neighbor. The order of the basin and any
// other vertex around it stays the same, so that no other extremum arises. `sign` is -1 to remove maxima instead.
template <class Scalar>
class Basin_filling
{
public:
  // Only values of free vertices are changed. Basins must not reach up to vertices of borders.
  Basin_filling(const Weighted_graph& graph,
                const std::vector<bool>& is_free,
                const std::vector<bool>& is_on_border,
                std::vector<Scalar>& values)
    : graph_(graph),
      is_free_(is_free),
      is_on_border_(is_on_border),
      values_(values),
      st_numbering_(graph),
      basins_(values.size(), 0),
      basins_next_to_(values.size(), 0)
  {}

  // Fills the basins of those candidates that are minima, but not minima of `old_values`, where the basin lies among
  // the free vertices.
  void remove_new_minima(const std::vector<Index>& candidates, const std::vector<Scalar>& old_values, int sign)
  {
    sign_ = static_cast<Scalar>(sign);
    std::vector<Index> minima;
    for(const Index v : candidates)
    {
      if(is_minimum(v, values_) && !is_minimum(v, old_values))
        minima.push_back(v);
    }
    std::sort(minima.begin(), minima.end(), [&](Index u, Index v) { return is_lower(v, u, values_); });
    for(const Index v : minima)
    {
      if(is_minimum(v, values_))
        fill(v);
    }
  }

private:
  typedef std::pair<Scalar, std::ptrdiff_t> Order_key; // in the total order
  typedef std::pair<Order_key, Index> Vertex_with_key;
  typedef std::priority_queue<Vertex_with_key, std::vector<Vertex_with_key>, std::greater<Vertex_with_key>> Queue;

  Order_key key(Index v, const std::vector<Scalar>& values) const
  {
    return {sign_ * values[v], static_cast<std::ptrdiff_t>(v) * (sign_ > 0 ? 1 : -1)};
  }
  bool is_lower(Index u, Index v, const std::vector<Scalar>& values) const { return key(u, values) < key(v, values); }

  bool is_minimum(Index v, const std::vector<Scalar>& values) const
  {
    const auto neighbors = graph_.neighbors(v);
    return std::none_of(neighbors.begin(), neighbors.end(),
                        [&](const auto& n) { return is_lower(n.vertex, v, values); });
  }

  bool has_lower_neighbor_outside(Index v) const
  {
    const auto neighbors = graph_.neighbors(v);
    return std::any_of(neighbors.begin(), neighbors.end(),
                       [&](const auto& n) { return basins_[n.vertex] != basin_ && is_lower(n.vertex, v, values_); });
  }

  void add(Index v)
  {
    basins_[v] = basins_next_to_[v] = basin_;
    vertices_.push_back(v);
    for(const auto& n : graph_.neighbors(v))
    {
      if(basins_next_to_[n.vertex] == basin_)
        continue;
      basins_next_to_[n.vertex] = basin_;
      shore_.push({key(n.vertex, values_), n.vertex});
    }
  }

  // Grows the basin of a minimum to the lowest pass. Nothing is changed if there is none among the free vertices.
  void fill(Index minimum)
  {
    ++basin_;
    vertices_.clear();
    shore_ = Queue();
    for(add(minimum); !shore_.empty();)
    {
      const Index v = shore_.top().second;
      shore_.pop();
      if(is_on_border_[v])
        return;
      if(has_lower_neighbor_outside(v))
        return raise_above(v);
      if(!is_free_[v])
        return;
      add(v);
    }
  }

  void raise_above(Index pass)
  {
    const Scalar infinity = std::numeric_limits<Scalar>::infinity();
    const Scalar from = sign_ * values_[pass], lowest = sign_ * values_[vertices_.front()];
    const Scalar to = shore_.empty() ? infinity : shore_.top().first.first;
    const Scalar room = (std::min)((to - from) / 2, part_of_difference(lowest, from, 16));
    const auto size = static_cast<Scalar>(vertices_.size());
    std::vector<Scalar> ascending;
    Scalar last = from;
    for(std::size_t i = 0; i != vertices_.size(); ++i)
    {
      last = (std::max)(from + room * (static_cast<Scalar>(i + 1) / size), std::nextafter(last, infinity));
      ascending.push_back(last);
    }
    if(!(last < to))
      return;
    const auto order = st_numbering_(
      vertices_, [&](Index v) { return basins_[v] == basin_; }, [&](Index v) { return v == pass; });
    for(std::size_t i = 0; i != order.size(); ++i)
      values_[order[i]] = sign_ * ascending[i];
  }

  const Weighted_graph& graph_;
  const std::vector<bool>&is_free_, &is_on_border_;
  std::vector<Scalar>& values_;
  St_numbering st_numbering_;
  Scalar sign_ = 1;
  std::size_t basin_ = 0;                            // number of the basin that is being filled
  std::vector<std::size_t> basins_, basins_next_to_; // by vertex, the last basin that it was in, or in or next to
  std::vector<Index> vertices_;                      // of the basin
  Queue shore_;                                      // the vertices next to the basin
};

// The vertices of each border component.
template <class Mesh, class NumberOfVertex>
std::vector<std::vector<Index>> vertices_of_borders(const Mesh& mesh, const NumberOfVertex& number)
{
  std::vector<std::vector<Index>> borders;
  for(const auto& cycle : find_border_cycles(mesh))
  {
    borders.emplace_back();
    for(const auto v : vertices_around_face(cycle.halfedge, mesh))
      borders.back().push_back(number(v).number());
  }
  return borders;
}

// The vertices that are on no border, and at most `width` edges away from the given ones; nearer ones come first.
inline std::vector<Index> vertices_around(const Weighted_graph& graph,
                                          const std::vector<Index>& border_vertices,
                                          const std::vector<bool>& is_on_border,
                                          std::size_t width)
{
  std::vector<Index> reached = border_vertices;
  std::vector<bool> is_reached(graph.number_of_vertices(), false);
  for(const Index v : border_vertices)
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
                                        const std::vector<std::vector<Index>>& borders,
                                        const std::vector<Scalar>& values,
                                        const Traits& traits,
                                        Border_extremum wish,
                                        std::size_t collar_width)
{
  const auto less = traits.less_scalar_object();
  std::vector<Scalar> result = values;
  std::vector<bool> is_on_border(values.size(), false), is_free(values.size(), false);
  std::vector<Index> changed;
  const std::vector<Scalar> levels = Border_levels<Scalar, Traits>(graph, values, borders, traits)(wish);
  for(std::size_t b = 0; b != borders.size(); ++b)
    for(const Index v : borders[b])
    {
      is_on_border[v] = true;
      if(less(values[v], levels[b]) || less(levels[b], values[v]))
        changed.push_back(v);
      result[v] = levels[b];
    }
  if constexpr(has_level_numbers<Scalar, Traits>)
  {
    const std::vector<Index> collar = vertices_around(graph, changed, is_on_border, collar_width);
    if(collar.empty())
      return result;
    for(const Index v : collar)
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
  const auto flat = share_flat<Sequential_tag>(mesh, scalar_map, traits, parameters::default_values());
  const auto& numbers = flat->mesh->numbers;
  const auto less = traits.less_scalar_object();
  progress.report(0.2);
  const std::vector<typename Traits::Scalar> values(flat->values.begin(), flat->values.end());
  const auto borders = vertices_of_borders(mesh, numbers.number_of);
  const auto graph = edge_graph(flat->mesh->complex);
  progress.report(0.9);
  const auto new_values = level_border_values(graph, borders, values, traits, wish, collar_width);
  progress.report(0.95); // the last one before the field changes
  Changes changes;
  const Scalar_conversion<Traits> conversion(traits);
  const auto is_changed = [&](Index v) { return less(values[v], new_values[v]) || less(new_values[v], values[v]); };
  changes.number_of_borders = borders.size();
  for(const auto& border : borders)
    changes.number_of_changed_borders += std::any_of(border.begin(), border.end(), is_changed) ? 1 : 0;
  for(Index v = 0; v != values.size(); ++v)
  {
    if(!is_changed(v))
      continue;
    ++changes.number_of_changed_vertices;
    changes.largest_change =
      (std::max)(changes.largest_change, distance_of_values(conversion, values[v], new_values[v]));
    put(scalar_map, numbers.vertices[Vertex_index(v)], new_values[v]);
  }
  progress.report_end();
  return changes;
}

} // namespace CGAL::Reeb_graph::internal::scalar_fields

#endif // CGAL_REEB_GRAPH_FIELDS_INTERNAL_LEVEL_BORDER_VALUES_H
