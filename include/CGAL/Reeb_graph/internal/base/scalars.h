// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_INTERNAL_BASE_SCALARS_H
#define CGAL_REEB_GRAPH_INTERNAL_BASE_SCALARS_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Real_embeddable_traits.h>
#include <CGAL/number_utils.h>
#include <CGAL/tags.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <limits>
#include <optional>
#include <tuple>
#include <type_traits>
#include <utility>

namespace CGAL::Reeb_graph::internal {

// Whether an expression compiles with a type.
template <class Void, template <class> class Expression, class T>
struct Has_expression : std::false_type
{
};
template <template <class> class Expression, class T>
struct Has_expression<std::void_t<Expression<T>>, Expression, T> : std::true_type
{
};
template <template <class> class Expression, class T>
using Has = Has_expression<void, Expression, T>;

template <class Traits>
using Scalar_to_double = decltype(std::declval<const Traits&>().scalar_to_double_object());
template <class Traits>
using Scalar_from_double = decltype(std::declval<const Traits&>().scalar_from_double_object());

// The way from the values of a field to numbers and back: that of the traits class, else that of number types. Values
// of any other type are not a number each.
template <class Traits>
class Scalar_conversion
{
  typedef typename Traits::Scalar Scalar;
  static constexpr bool is_given = Has<Scalar_to_double, Traits>::value;
  static constexpr bool is_number =
    std::is_arithmetic_v<
      Scalar> || std::is_same_v<typename Real_embeddable_traits<Scalar>::Is_real_embeddable, Tag_true>;

public:
  // Whether each value has a number.
  static constexpr bool has_numbers = is_given || is_number;

  explicit Scalar_conversion(const Traits& traits) : traits_(traits) {}

  double to_double(const Scalar& value) const
  {
    if constexpr(is_given)
      return traits_.scalar_to_double_object()(value);
    else if constexpr(std::is_arithmetic_v<Scalar>)
      return static_cast<double>(value);
    else if constexpr(is_number)
      return CGAL::to_double(value);
    else
      return std::numeric_limits<double>::quiet_NaN();
  }

  // The value of a number between two others; if the numbers of the field fall, integers are rounded up.
  std::optional<Scalar> from_double(double number, bool is_falling) const
  {
    if constexpr(Has<Scalar_from_double, Traits>::value)
      return traits_.scalar_from_double_object()(number);
    else if constexpr(is_given)
      return std::nullopt;
    else if constexpr(std::is_integral_v<Scalar>)
      return static_cast<Scalar>(is_falling ? std::ceil(number) : std::floor(number));
    else if constexpr(is_number && std::is_constructible_v<Scalar, double>)
      return static_cast<Scalar>(number);
    else
      return std::nullopt;
  }

private:
  Traits traits_;
};

// Types that the standard library orders lexicographically by their elements, which std::apply() shows.
template <class T>
struct Has_ordered_elements : std::false_type
{
};
template <class First, class Second>
struct Has_ordered_elements<std::pair<First, Second>> : std::true_type
{
};
template <class... Elements>
struct Has_ordered_elements<std::tuple<Elements...>> : std::true_type
{
};
template <class T, std::size_t size>
struct Has_ordered_elements<std::array<T, size>> : std::true_type
{
};

// Whether `operator<` places a value: it does not place NaN, nor anything with NaN inside.
template <class T>
bool is_ordered(const T& value)
{
  if constexpr(Has_ordered_elements<T>::value)
    return std::apply([](const auto&... elements) { return (is_ordered(elements) && ...); }, value);
  else if constexpr(std::numeric_limits<T>::has_quiet_NaN)
    return value == value;
  else
  {
    static_cast<void>(value);
    return true;
  }
}

// Whether `Less` is one of the types.
template <class Less, class... Types>
inline constexpr bool is_one_of = (std::is_same_v<Less, Types> || ...);

// Whether `Less` is the order of built-in numbers, up or down, which cannot contradict itself without NaN.
template <class T, class Less>
inline constexpr bool is_order_of_numbers =
  std::is_arithmetic_v<T>&& is_one_of<Less, std::less<T>, std::less<>, std::greater<T>, std::greater<>>;

} // namespace CGAL::Reeb_graph::internal

#endif // CGAL_REEB_GRAPH_INTERNAL_BASE_SCALARS_H
