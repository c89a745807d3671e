// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of the CGAL-style package Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_INTERNAL_CURVES_VALUE_BETWEEN_H
#define CGAL_REEB_GRAPH_INTERNAL_CURVES_VALUE_BETWEEN_H

#include <CGAL/license/Reeb_graph.h>

#include <algorithm>
#include <cmath>
#include <type_traits>
#include <utility>

namespace CGAL {
namespace Reeb_graph {
namespace internal {

template <class Scalar, class = void>
struct Has_mean : std::false_type
{
};
template <class Scalar>
struct Has_mean<Scalar, std::void_t<decltype(Scalar((std::declval<Scalar>() - std::declval<Scalar>()) / Scalar(2)))>>
  : std::true_type
{
};

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
  else if constexpr(Has_mean<Scalar>::value)
    return (lower + upper) / Scalar(2);
  else
    return lower;
}

// A bound for the values next to one, on the way to another: numbers that are not rounded have no next one.
template <class Scalar>
Scalar value_near(const Scalar& value, const Scalar& other)
{
  if constexpr(Has_mean<Scalar>::value && !std::is_arithmetic_v<Scalar>)
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

} // namespace internal
} // namespace Reeb_graph
} // namespace CGAL

#endif // CGAL_REEB_GRAPH_INTERNAL_CURVES_VALUE_BETWEEN_H
