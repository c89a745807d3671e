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

#include <CGAL/Reeb_graph/internal/base/Index.h>
#include <CGAL/Reeb_graph/internal/base/Progress.h>
#include <CGAL/Reeb_graph/internal/base/Scalar_conversion.h>
#include <CGAL/Reeb_graph/internal/base/Threads.h>
#include <CGAL/Reeb_graph/internal/base/interpolation.h>
#include <CGAL/Reeb_graph/internal/complex/Flat_mesh.h>
#include <CGAL/Reeb_graph/internal/complex/Weighted_graph.h>
#include <CGAL/Reeb_graph/options.h>

#include <CGAL/boost/graph/iterator.h>
#include <CGAL/tags.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <limits>
#include <optional>
#include <queue>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL::Reeb_graph::internal::scalar_fields {

// A border component, and the values in it and around it.
template <class Scalar>
struct Field_border
{
  std::vector<Index> adjacent_borders;                          // those that share an edge with it
  Scalar lowest, highest, middle;                               // of its vertices; middle: that of the median one
  std::optional<Scalar> lowest_neighbor, highest_neighbor;      // of the vertices next to it that are on no border
  std::optional<Scalar> kept_level;                             // if it is an extremal level already
  bool has_lower_neighbor = false, has_higher_neighbor = false; // on other borders as well, if it is a level
};

// The borders by number; `borders` has the vertices of each.
template <class Scalar, class Less>
std::vector<Field_border<Scalar>> find_field_borders(const Weighted_graph& graph,
                                                     const std::vector<Scalar>& values,
                                                     const std::vector<std::vector<Index>>& borders,
                                                     const Less& less)
{
  std::vector<Index> border_of_vertex(graph.number_of_vertices(), no_index);
  for(std::size_t b = 0; b != borders.size(); ++b)
    for(const Index v : borders[b])
      border_of_vertex[v] = static_cast<Index>(b);
  std::vector<Field_border<Scalar>> result;
  for(std::size_t b = 0; b != borders.size(); ++b)
  {
    std::vector<Scalar> own_values, neighbors;
    for(const Index v : borders[b])
      own_values.push_back(values[v]);
    std::sort(own_values.begin(), own_values.end(), less);
    const Scalar &lowest = own_values.front(), &highest = own_values.back();
    Field_border<Scalar> border = {{}, lowest, highest, own_values[own_values.size() / 2], {}, {}, {}};
    for(const Index v : borders[b])
      for(const auto& neighbor : graph.neighbors(v))
      {
        const Index number = border_of_vertex[neighbor.vertex];
        if(number == b)
          continue;
        const Scalar& value = values[neighbor.vertex];
        border.has_lower_neighbor = border.has_lower_neighbor || less(value, lowest);
        border.has_higher_neighbor = border.has_higher_neighbor || less(highest, value);
        if(number == no_index)
          neighbors.push_back(value);
        else
          border.adjacent_borders.push_back(number);
      }
    if(!neighbors.empty())
    {
      border.lowest_neighbor = *std::min_element(neighbors.begin(), neighbors.end(), less);
      border.highest_neighbor = *std::max_element(neighbors.begin(), neighbors.end(), less);
    }
    if(!less(lowest, highest) && !(border.has_lower_neighbor && border.has_higher_neighbor))
      border.kept_level = lowest;
    auto& adjacent = border.adjacent_borders;
    std::sort(adjacent.begin(), adjacent.end());
    adjacent.erase(std::unique(adjacent.begin(), adjacent.end()), adjacent.end());
    result.push_back(border);
  }
  return result;
}

// The difference of infinities is no number.
template <class Traits, class Scalar>
double distance_of_values(const Scalar_conversion<Traits>& conversion, const Scalar& a, const Scalar& b)
{
  const double first = conversion.to_double(a), second = conversion.to_double(b);
  return first == second ? 0 : std::abs(first - second);
}

// Whether levels of borders can be in the middle between values, or beyond them: with floating point numbers. Of any
// other type, and with any other order, they are values that there are.
template <class Scalar, class Traits>
inline constexpr bool has_level_numbers =
  std::conjunction_v<std::is_floating_point<Scalar>, std::is_same<typename Traits::Less_scalar, std::less<Scalar>>>;

// Chooses a level for each border component, so that it is an extremum of the field.
//
// Borders that share an edge become extrema of opposite kinds where that can be. Where it cannot, as for three borders
// each of which touches the other two, those of one kind that touch each other, a group, share one level.
template <class Scalar, class Traits>
class Border_levels
{
  typedef Field_border<Scalar> Border;
  typedef std::optional<Border_extremum> Kind; // MINIMUM or MAXIMUM, nothing before it is chosen

public:
  Border_levels(const Weighted_graph& graph,
                const std::vector<Scalar>& values,
                const std::vector<std::vector<Index>>& borders,
                const Traits& traits)
    : less_(traits.less_scalar_object()),
      conversion_(traits),
      borders_(find_field_borders(graph, values, borders, less_)),
      kinds_(borders.size()),
      groups_of_borders_(borders.size(), no_index)
  {}

  // The levels of the borders. Those that are extremal levels already keep theirs, unless they touch others that leave
  // them no choice.
  std::vector<Scalar> operator()(Border_extremum wish)
  {
    choose_kinds(wish);
    for(Index b = 0; b != borders_.size(); ++b)
    {
      if(groups_of_borders_[b] == no_index)
        add_group(b);
    }
    part_groups();
    std::vector<Scalar> levels;
    for(Index b = 0; b != borders_.size(); ++b)
      levels.push_back(groups_[groups_of_borders_[b]].level);
    return levels;
  }

private:
  // Borders of one level, and all that bounds it.
  struct Group
  {
    Border_extremum kind;
    Border bounds;
    Scalar level;
  };

  Scalar middle_between(const Scalar& lower, const Scalar& upper) const
  {
    if constexpr(has_level_numbers<Scalar, Traits>)
    {
      const Scalar result = lower / 2 + upper / 2;
      return std::isnan(result) ? 0 : result; // between infinities
    }
    else
      return upper;
  }

  // Farther than `level`, by a small part of the range of the values in the border and around it.
  Scalar beyond(const Scalar& level, Border_extremum kind, const Border& border) const
  {
    if constexpr(has_level_numbers<Scalar, Traits>)
    {
      const Scalar infinity = std::numeric_limits<Scalar>::infinity();
      const Scalar sign = kind == Border_extremum::MAXIMUM ? 1 : -1;
      const Scalar highest = (std::max)(border.highest, border.highest_neighbor.value_or(border.highest));
      const Scalar lowest = (std::min)(border.lowest, border.lowest_neighbor.value_or(border.lowest));
      Scalar result = level + sign * part_of_difference(lowest, highest, margin_divisor);
      if(!(sign * level < sign * result))
        result = std::nextafter(level, sign * infinity);
      return std::isfinite(result) ? result : level;
    }
    else
      return level;
  }

  // The level nearest to the values of the border at which it is an extremum.
  Scalar choose_level(const Border& border, Border_extremum kind) const
  {
    const auto& bound = kind == Border_extremum::MAXIMUM ? border.highest_neighbor : border.lowest_neighbor;
    Scalar level = border.kept_level ? *border.kept_level : middle_of(border);
    if(bound && (border.kept_level ? is_farther(*bound, level, kind) : !is_farther(level, *bound, kind)))
      level = beyond(*bound, kind, border);
    return level;
  }

  // Adds a border of the same kind to a group, `sum`.
  void add(Border& sum, const Border& border, Border_extremum kind) const
  {
    if(less_(border.lowest, sum.lowest))
      sum.lowest = border.lowest;
    if(less_(sum.highest, border.highest))
      sum.highest = border.highest;
    add_bound(sum.lowest_neighbor, border.lowest_neighbor, Border_extremum::MINIMUM);
    add_bound(sum.highest_neighbor, border.highest_neighbor, Border_extremum::MAXIMUM);
    add_bound(sum.kept_level, border.kept_level, kind);
  }

  double largest_distance(const Border& border, const Scalar& level) const
  {
    return (std::max)(distance_of_values(conversion_, border.lowest, level),
                      distance_of_values(conversion_, border.highest, level));
  }

  bool is_farther(const Scalar& a, const Scalar& b, Border_extremum kind) const
  {
    return kind == Border_extremum::MAXIMUM ? less_(b, a) : less_(a, b);
  }

  Scalar middle_of(const Border& border) const
  {
    if constexpr(has_level_numbers<Scalar, Traits>)
      return middle_between(border.lowest, border.highest);
    else
      return border.middle;
  }

  void add_bound(std::optional<Scalar>& sum, const std::optional<Scalar>& bound, Border_extremum kind) const
  {
    if(bound && (!sum || is_farther(*bound, *sum, kind)))
      sum = bound;
  }

  static Border_extremum opposite_kind(Border_extremum kind)
  {
    return kind == Border_extremum::MINIMUM ? Border_extremum::MAXIMUM : Border_extremum::MINIMUM;
  }

  void choose_kinds(Border_extremum wish)
  {
    std::vector<Index> decided;
    for(Index b = 0; b != borders_.size(); ++b)
    {
      if(borders_[b].kept_level && borders_[b].has_lower_neighbor != borders_[b].has_higher_neighbor)
        kinds_[b] = borders_[b].has_lower_neighbor ? Border_extremum::MAXIMUM : Border_extremum::MINIMUM;
      else if(wish != Border_extremum::AUTOMATIC)
        kinds_[b] = wish;
      if(kinds_[b])
        decided.push_back(b);
    }
    spread_kinds(std::move(decided));
    for(Index b = 0; b != borders_.size(); ++b)
    {
      if(!kinds_[b])
        choose_kinds_around(b);
    }
  }

  // Gives the borders that are connected with the decided ones the kind opposite to that of a decided neighbor, or the
  // one that changes less where they have neighbors of both kinds. Returns all that are decided then.
  std::vector<Index> spread_kinds(std::vector<Index> decided)
  {
    for(std::size_t i = 0; i != decided.size(); ++i)
      for(const Index b : borders_[decided[i]].adjacent_borders)
      {
        if(kinds_[b])
          continue;
        kinds_[b] = opposite_kind(*kinds_[decided[i]]);
        const auto has_same_kind = [&](Index a) { return kinds_[a] == kinds_[b]; };
        const auto& adjacent = borders_[b].adjacent_borders;
        if(std::any_of(adjacent.begin(), adjacent.end(), has_same_kind))
          kinds_[b] = kind_of_less_change(borders_[b]);
        decided.push_back(b);
      }
    return decided;
  }

  double change(const Border& border, Border_extremum kind) const
  {
    return largest_distance(border, choose_level(border, kind));
  }

  Border_extremum kind_of_less_change(const Border& border) const
  {
    return change(border, Border_extremum::MINIMUM) < change(border, Border_extremum::MAXIMUM)
           ? Border_extremum::MINIMUM
           : Border_extremum::MAXIMUM;
  }

  // Decides a border and all that are connected with it so that the largest change is the smaller one of two choices.
  void choose_kinds_around(Index first)
  {
    std::vector<Index> decided;
    double changes[2] = {0, 0};
    for(const Border_extremum kind : {Border_extremum::MINIMUM, Border_extremum::MAXIMUM})
    {
      double& largest_change = changes[kind == Border_extremum::MAXIMUM];
      decided = decide(first, kind);
      for(const Index b : decided)
        largest_change = (std::max)(largest_change, change(borders_[b], *kinds_[b]));
      for(const Index b : decided)
        kinds_[b].reset();
    }
    decide(first, changes[0] < changes[1] ? Border_extremum::MINIMUM : Border_extremum::MAXIMUM);
  }

  std::vector<Index> decide(Index border, Border_extremum kind)
  {
    kinds_[border] = kind;
    return spread_kinds({border});
  }

  // Adds the group of a border, all borders of its kind that touch each other.
  void add_group(Index first)
  {
    const auto number = static_cast<Index>(groups_.size());
    Group group = {*kinds_[first], borders_[first], borders_[first].lowest};
    std::vector<Index> members = {first};
    groups_of_borders_[first] = number;
    for(std::size_t i = 0; i != members.size(); ++i)
      for(const Index b : borders_[members[i]].adjacent_borders)
      {
        if(kinds_[b] != kinds_[first] || groups_of_borders_[b] != no_index)
          continue;
        groups_of_borders_[b] = number;
        members.push_back(b);
        add(group.bounds, borders_[b], group.kind);
      }
    group.level = choose_level(group.bounds, group.kind);
    groups_.push_back(std::move(group));
  }

  // Calls visit(group of maxima, group of minima) for those that touch each other.
  template <class Visit>
  void for_each_touching_pair(const Visit& visit) const
  {
    for(Index b = 0; b != borders_.size(); ++b)
      for(const Index a : borders_[b].adjacent_borders)
      {
        if(kinds_[b] == Border_extremum::MAXIMUM && kinds_[a] == Border_extremum::MINIMUM)
          visit(groups_of_borders_[b], groups_of_borders_[a]);
      }
  }

  // Puts maxima above the minima that they touch. Kept levels stay if those of the other group can give way.
  void part_groups()
  {
    std::vector<Scalar> levels;
    for(const Group& group : groups_)
      levels.push_back(group.level);
    for_each_touching_pair([&](Index above, Index below) {
      const Scalar &low = groups_[above].level, &high = groups_[below].level;
      if(!less_(low, high))
        return;
      const bool is_above_kept = is_kept(groups_[above]), is_below_kept = is_kept(groups_[below]);
      const Scalar middle = is_above_kept == is_below_kept ? middle_between(low, high) : is_above_kept ? low : high;
      if(less_(levels[above], middle))
        levels[above] = middle;
      if(less_(middle, levels[below]))
        levels[below] = middle;
    });
    for(std::size_t i = 0; i != groups_.size(); ++i)
      groups_[i].level = levels[i];
    for_each_touching_pair([&](Index above, Index below) {
      Group &upper = groups_[above], &lower = groups_[below];
      if(less_(lower.level, upper.level) || (is_kept(upper) && is_kept(lower)))
        return;
      Group& moved = is_kept(upper) ? lower : upper;
      moved.level = beyond(moved.level, moved.kind, moved.bounds);
    });
  }

  static bool is_kept(const Group& group) { return group.bounds.kept_level.has_value(); }

  static constexpr int margin_divisor = 1024;

  const typename Traits::Less_scalar less_;
  const Scalar_conversion<Traits> conversion_;
  std::vector<Border> borders_;
  std::vector<Kind> kinds_;
  std::vector<Index> groups_of_borders_;
  std::vector<Group> groups_;
};

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
  const auto flat = share_flat(Threads(), mesh, scalar_map, traits, parameters::default_values());
  const auto& numbers = flat->mesh->numbers;
  const auto less = traits.less_scalar_object();
  progress.report(0.2);
  std::vector<typename Traits::Scalar> values;
  for(const Vertex_index v : flat->field.keys().keys())
    values.push_back(flat->field.value(v));
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
