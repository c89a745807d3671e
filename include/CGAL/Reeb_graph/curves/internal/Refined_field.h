// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_CURVES_INTERNAL_REFINED_FIELD_H
#define CGAL_REEB_GRAPH_CURVES_INTERNAL_REFINED_FIELD_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/curves/Curve.h>
#include <CGAL/Reeb_graph/curves/internal/Contour_cutting.h>
#include <CGAL/Reeb_graph/internal/base/scalars.h>

#include <CGAL/Dynamic_property_map.h>
#include <CGAL/boost/graph/iterator.h>
#include <CGAL/boost/graph/properties.h>

#include <boost/property_map/property_map.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <optional>
#include <type_traits>
#include <unordered_map>
#include <utility>
#include <vector>

namespace CGAL::Reeb_graph::internal {

template <class Scalar>
using Half_of_difference = decltype(Scalar((std::declval<Scalar>() - std::declval<Scalar>()) / Scalar(2)));
template <class Scalar>
inline constexpr bool has_mean = Has<Half_of_difference, Scalar>::value;

// The value that is asked for, or the next to it that there is for certain between the two.
template <class Scalar>
Scalar candidate_between(const Scalar& lower, const Scalar& upper, double wish)
{
  if constexpr(std::is_floating_point_v<Scalar>)
  {
    const bool is_rising = lower < upper;
    const Scalar first = std::nextafter(lower, upper), last = std::nextafter(upper, lower);
    const Scalar low = is_rising ? first : last, high = is_rising ? last : first;
    return (std::min)((std::max)(static_cast<Scalar>(wish), low), high);
  }
  else if constexpr(std::is_integral_v<Scalar>)
  {
    const auto [low, high] = std::minmax(lower, upper);
    if(low == high || static_cast<Scalar>(low + 1) == high)
      return lower;
    const Scalar first = static_cast<Scalar>(low + 1), last = static_cast<Scalar>(high - 1);
    // Conversions to `double` round, so that a wish between the two may be a little beyond them.
    if(!(wish > static_cast<double>(first)))
      return first;
    return wish < static_cast<double>(last) ? (std::min)((std::max)(static_cast<Scalar>(std::floor(wish)), first), last)
                                            : last;
  }
  else if constexpr(has_mean<Scalar>)
    return (lower + upper) / Scalar(2);
  else
    return lower;
}

// A bound for the values next to one, on the way to another: numbers that are not rounded have no next one.
template <class Scalar>
Scalar value_near(const Scalar& value, const Scalar& other)
{
  if constexpr(has_mean<Scalar> && !std::is_arithmetic_v<Scalar>)
    return value + (other - value) / Scalar(1 << 30);
  else
    return other;
}

// A value strictly between two others, as near as possible to the one that is asked for. If there is none, it is the
// lower one: a vertex that is added comes behind the others of its value.
template <class Scalar, class Less>
Scalar value_between(const Scalar& lower, const Scalar& upper, double wish, const Less& less)
{
  const auto is_between = [&](const Scalar& value) { return less(lower, value) && less(value, upper); };
  if constexpr(!std::is_integral_v<Scalar> && std::is_constructible_v<Scalar, double>)
  {
    const Scalar value(std::isfinite(wish) ? wish : 0.); // not all numbers can be infinite
    if(is_between(value))
      return value;
  }
  const Scalar value = candidate_between(lower, upper, wish);
  return is_between(value) ? value : lower;
}

// Whether a map can be written at vertices that are added. One over a range of fixed size has no room for them.
template <class PropertyMap>
struct Has_room_for_added_vertices : std::bool_constant<CGAL::internal::Is_writable_property_map<PropertyMap>::value>
{
};
template <class Iterator, class IndexMap, class Value, class Reference>
struct Has_room_for_added_vertices<boost::iterator_property_map<Iterator, IndexMap, Value, Reference>> : std::false_type
{
};
template <class Iterator, class IndexMap, class Value, class Reference>
struct Has_room_for_added_vertices<boost::safe_iterator_property_map<Iterator, IndexMap, Value, Reference>>
  : std::false_type
{
};
// of a mesh that is const
template <class Key, class Value>
struct Has_room_for_added_vertices<CGAL::internal::Dynamic_with_index<Key, Value>> : std::false_type
{
};

// Whether the field is written at vertices that are added.
template <class ScalarMap, class Traits>
inline constexpr bool is_field_written =
  Has_room_for_added_vertices<ScalarMap>::value
  && (std::is_constructible_v<typename Traits::Scalar, double> || Has<Scalar_from_double, Traits>::value)
  && std::is_convertible_v<typename Traits::Scalar, typename boost::property_traits<ScalarMap>::value_type>;

// The field at the vertices that a refinement adds: values in the order of the ranks and of the contours, as far as
// there are numbers, so that the Reeb graph stays the same.
template <class RankedMesh, class ScalarMap, class Traits>
class Refined_field
{
  typedef typename Traits::Scalar Scalar;
  typedef typename RankedMesh::vertex_descriptor vertex_descriptor;
  typedef typename RankedMesh::halfedge_descriptor halfedge_descriptor;
  typedef Contour_to_cut<halfedge_descriptor> Contour;
  static constexpr bool is_written = is_field_written<ScalarMap, Traits>;

public:
  Refined_field(const RankedMesh& ranked, const ScalarMap& scalar_map, const Traits& traits)
    : ranked_(ranked),
      scalar_map_(scalar_map),
      less_(traits.less_scalar_object()),
      conversion_(traits)
  {}

  // Writes the values of the vertices that have got ranks between those of others.
  void write_ranked_vertices()
  {
    if constexpr(is_written)
    {
      std::vector<vertex_descriptor> added;
      for(const vertex_descriptor v : vertices(ranked_.mesh()))
      {
        if(is_added(v))
          added.push_back(v);
      }
      std::sort(added.begin(), added.end(),
                [&](vertex_descriptor u, vertex_descriptor v) { return ranked_.rank(u) < ranked_.rank(v); });
      place(added);
    }
  }

  // Finds the values of contours, for write_curves().
  void place_contours(const std::vector<Contour>& contours)
  {
    if constexpr(is_written)
    {
      for(const Contour& contour : contours)
        lower_values_.push_back(end_value(contour, false));
      values_ = lower_values_;
      std::vector<std::size_t> order(contours.size());
      std::iota(order.begin(), order.end(), std::size_t(0));
      std::stable_sort(order.begin(), order.end(),
                       [&](std::size_t a, std::size_t b) { return contours[a] < contours[b]; });
      // first above those below it, then, where there was no number left, below those above it
      for_each_contour(contours, order.begin(), order.end(), [&](std::size_t i, const std::vector<std::size_t>& lower) {
        std::optional<Scalar> below = lower_values_[i];
        for(const std::size_t j : lower)
          bound_by(below, values_[j], false);
        values_[i] = between(*below, end_value(contours[i], true), contours[i].value);
      });
      for_each_contour(contours, order.rbegin(), order.rend(),
                       [&](std::size_t i, const std::vector<std::size_t>& upper) {
                         std::optional<Scalar> above = end_value(contours[i], true);
                         for(const std::size_t j : upper)
                           bound_by(above, values_[j], true);
                         if(!less_(values_[i], *above))
                           values_[i] = between(lower_values_[i], *above, contours[i].value);
                       });
    }
  }

  // Writes the values of the vertices on both sides of the curves that the contours have become.
  void write_curves(const std::vector<Curve<halfedge_descriptor>>& curves)
  {
    if constexpr(is_written)
    {
      const auto& mesh = ranked_.mesh();
      for(std::size_t i = 0; i != curves.size(); ++i)
        for(const auto* halfedges : {&curves[i].halfedges, &curves[i].lower_halfedges})
          for(const halfedge_descriptor h : *halfedges)
          {
            put(scalar_map_, source(h, mesh), values_[i]);
            put(scalar_map_, target(h, mesh), values_[i]);
          }
    }
  }

private:
  Scalar scalar(vertex_descriptor v) const { return get(scalar_map_, v); }
  bool is_added(vertex_descriptor v) const { return ranked_.rank(v) % rank_spacing != 0; }
  // Lowers an upper bound, or raises a lower one.
  void bound_by(std::optional<Scalar>& bound, const Scalar& value, bool is_upper) const
  {
    if(!bound || (is_upper ? less_(value, *bound) : less_(*bound, value)))
      bound = value;
  }

  // Calls visit(u) for each neighbor and for the vertex that comes before, if both are between the same two vertices.
  template <class Visit>
  void for_each_bound(vertex_descriptor v, const vertex_descriptor* before, const Visit& visit) const
  {
    for(const vertex_descriptor u : vertices_around_target(v, ranked_.mesh()))
      visit(u);
    if(before != nullptr && ranked_.rank(*before) / rank_spacing == ranked_.rank(v) / rank_spacing)
      visit(*before);
  }

  // Places vertices, in ascending order, first above what is below them, then, where there was no number left, below
  // what is above them.
  void place(const std::vector<vertex_descriptor>& added)
  {
    std::unordered_map<Long_index, Scalar> lower_values; // the highest ones of vertices that are not added
    for(std::size_t i = 0; i != added.size(); ++i)
    {
      const vertex_descriptor v = added[i];
      std::optional<Scalar> below, given_below, above;
      for_each_bound(v, i == 0 ? nullptr : &added[i - 1], [&](vertex_descriptor u) {
        if(ranked_.rank(u) < ranked_.rank(v))
        {
          bound_by(below, scalar(u), false);
          bound_by(given_below, is_added(u) ? lower_values.at(ranked_.rank(u)) : scalar(u), false);
        }
        else if(!is_added(u))
          bound_by(above, scalar(u), true);
      });
      lower_values.emplace(ranked_.rank(v), given_below ? *given_below : *above);
      const Scalar lowest = below ? *below : *above;
      put(scalar_map_, v, value_next_to_vertex(v, lowest, above ? *above : lowest));
    }
    for(std::size_t i = added.size(); i-- != 0;)
    {
      const vertex_descriptor v = added[i];
      std::optional<Scalar> above;
      for_each_bound(v, i + 1 == added.size() ? nullptr : &added[i + 1], [&](vertex_descriptor u) {
        if(ranked_.rank(v) < ranked_.rank(u))
          bound_by(above, scalar(u), true);
      });
      if(above && !less_(scalar(v), *above))
        put(scalar_map_, v, value_next_to_vertex(v, lower_values.at(ranked_.rank(v)), *above));
    }
  }

  // The rank of an added vertex is next to that of the vertex below or above.
  Scalar value_next_to_vertex(vertex_descriptor v, const Scalar& below, const Scalar& above) const
  {
    const bool is_next_to_lower = ranked_.rank(v) % rank_spacing < rank_spacing / 2;
    return is_next_to_lower ? between(below, value_near(below, above), ranked_.value(v))
                            : between(value_near(above, below), above, ranked_.value(v));
  }

  // A value strictly between two others, if possible the one that the traits class makes of the number.
  Scalar between(const Scalar& lower, const Scalar& upper, double wish) const
  {
    if constexpr(Has<Scalar_from_double, Traits>::value)
    {
      const Scalar value = std::isfinite(wish) ? *conversion_.from_double(wish, false) : lower;
      if(less_(lower, value) && less_(value, upper))
        return value;
    }
    return value_between(lower, upper, wish, less_);
  }

  // Of all upper ends the lowest, or of all lower ones the highest.
  Scalar end_value(const Contour& contour, bool is_upper) const
  {
    std::optional<Scalar> value;
    for(const halfedge_descriptor h : contour.halfedges)
      bound_by(value, scalar(is_upper ? target(h, ranked_.mesh()) : source(h, ranked_.mesh())), is_upper);
    return *value;
  }

  // Calls place(i, those of the contours before it that are the last ones at its edges) for each contour, in this
  // order.
  template <class Iterator, class Place>
  void for_each_contour(const std::vector<Contour>& contours, Iterator begin, Iterator end, const Place& place)
  {
    const auto& mesh = ranked_.mesh();
    const auto last_map = get(dynamic_edge_property_t<std::size_t>(), ranked_.mesh()); // one more than the contour
    for(const Contour& contour : contours)
      for(const halfedge_descriptor h : contour.halfedges)
        put(last_map, edge(h, mesh), 0);
    std::vector<std::size_t> before;
    for(; begin != end; ++begin)
    {
      before.clear();
      for(const halfedge_descriptor h : contours[*begin].halfedges)
      {
        const std::size_t last = get(last_map, edge(h, mesh));
        if(last != 0)
          before.push_back(last - 1);
        put(last_map, edge(h, mesh), *begin + 1);
      }
      place(*begin, before);
    }
  }

  const RankedMesh& ranked_;
  ScalarMap scalar_map_;
  const typename Traits::Less_scalar less_;
  const Scalar_conversion<Traits> conversion_;
  std::vector<Scalar> lower_values_, values_; // of the highest lower ends of contours, and of contours
};

} // namespace CGAL::Reeb_graph::internal

#endif // CGAL_REEB_GRAPH_CURVES_INTERNAL_REFINED_FIELD_H
