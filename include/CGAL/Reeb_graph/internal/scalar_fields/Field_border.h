// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of the CGAL-style package Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_INTERNAL_SCALAR_FIELDS_FIELD_BORDER_H
#define CGAL_REEB_GRAPH_INTERNAL_SCALAR_FIELDS_FIELD_BORDER_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/internal/base/Scalar_conversion.h>
#include <CGAL/Reeb_graph/internal/base/crossing_fraction.h>
#include <CGAL/Reeb_graph/internal/scalar_fields/Weighted_graph.h>
#include <CGAL/Reeb_graph/options.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <optional>
#include <type_traits>
#include <vector>

namespace CGAL {
namespace Reeb_graph {
namespace internal {
namespace scalar_fields {

// A border component, and the values in it and around it.
template <class Scalar>
struct Field_border
{
  std::vector<Position> adjacent_borders;                       // those that share an edge with it
  Scalar lowest, highest, middle;                               // of its vertices; middle: that of the median one
  std::optional<Scalar> lowest_neighbor, highest_neighbor;      // of the vertices next to it that are on no border
  std::optional<Scalar> kept_level;                             // if it is an extremal level already
  bool has_lower_neighbor = false, has_higher_neighbor = false; // on other borders as well, if it is a level
};

// The borders by number; `borders` has the vertices of each.
template <class Scalar, class Less>
std::vector<Field_border<Scalar>> find_field_borders(const Weighted_graph& graph,
                                                     const std::vector<Scalar>& values,
                                                     const std::vector<std::vector<Position>>& borders,
                                                     const Less& less)
{
  std::vector<Position> number_of_vertex(graph.number_of_vertices(), no_position);
  for(std::size_t b = 0; b != borders.size(); ++b)
    for(const Position v : borders[b])
      number_of_vertex[v] = static_cast<Position>(b);
  std::vector<Field_border<Scalar>> result;
  for(std::size_t b = 0; b != borders.size(); ++b)
  {
    std::vector<Scalar> own_values, neighbors;
    for(const Position v : borders[b])
      own_values.push_back(values[v]);
    std::sort(own_values.begin(), own_values.end(), less);
    const Scalar &lowest = own_values.front(), &highest = own_values.back();
    Field_border<Scalar> border = {{}, lowest, highest, own_values[own_values.size() / 2], {}, {}, {}};
    for(const Position v : borders[b])
      for(const auto& neighbor : graph.neighbors(v))
      {
        const Position number = number_of_vertex[neighbor.vertex];
        if(number == b)
          continue;
        const Scalar& value = values[neighbor.vertex];
        border.has_lower_neighbor = border.has_lower_neighbor || less(value, lowest);
        border.has_higher_neighbor = border.has_higher_neighbor || less(highest, value);
        if(number == no_position)
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

// What is done with values to choose the levels of borders. With floating point numbers, levels are in the middle
// between values, or beyond them; of any other type, and with any other order, they are values that there are.
template <class Scalar, class Traits>
class Level_arithmetic
{
  typedef Field_border<Scalar> Border;
  typedef typename Traits::Less_scalar Less;

public:
  static constexpr bool has_numbers = std::is_floating_point_v<Scalar> && std::is_same_v<Less, std::less<Scalar>>;

  explicit Level_arithmetic(const Traits& traits) : less_(traits.less_scalar_object()), conversion_(traits) {}

  bool less(const Scalar& a, const Scalar& b) const { return less_(a, b); }

  Scalar middle(const Scalar& lower, const Scalar& upper) const
  {
    if constexpr(has_numbers)
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
    if constexpr(has_numbers)
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

private:
  bool is_farther(const Scalar& a, const Scalar& b, Border_extremum kind) const
  {
    return kind == Border_extremum::MAXIMUM ? less_(b, a) : less_(a, b);
  }

  Scalar middle_of(const Border& border) const
  {
    if constexpr(has_numbers)
      return middle(border.lowest, border.highest);
    else
      return border.middle;
  }

  void add_bound(std::optional<Scalar>& sum, const std::optional<Scalar>& bound, Border_extremum kind) const
  {
    if(bound && (!sum || is_farther(*bound, *sum, kind)))
      sum = bound;
  }

  static constexpr int margin_divisor = 1024;

  Less less_;
  Scalar_conversion<Traits> conversion_;
};

} // namespace scalar_fields
} // namespace internal
} // namespace Reeb_graph
} // namespace CGAL

#endif // CGAL_REEB_GRAPH_INTERNAL_SCALAR_FIELDS_FIELD_BORDER_H
