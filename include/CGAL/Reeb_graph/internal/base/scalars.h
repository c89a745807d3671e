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

#include <array>
#include <cstddef>
#include <functional>
#include <limits>
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
