// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of the CGAL-style package Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_INTERNAL_BASE_SCALAR_CONVERSION_H
#define CGAL_REEB_GRAPH_INTERNAL_BASE_SCALAR_CONVERSION_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Real_embeddable_traits.h>
#include <CGAL/number_utils.h>
#include <CGAL/tags.h>

#include <cmath>
#include <limits>
#include <optional>
#include <type_traits>
#include <utility>

namespace CGAL {
namespace Reeb_graph {
namespace internal {

template <class Traits, class = void>
struct Has_scalar_to_double : std::false_type
{
};
template <class Traits>
struct Has_scalar_to_double<Traits, std::void_t<decltype(std::declval<const Traits&>().scalar_to_double_object())>>
  : std::true_type
{
};

template <class Traits, class = void>
struct Has_scalar_from_double : std::false_type
{
};
template <class Traits>
struct Has_scalar_from_double<Traits, std::void_t<decltype(std::declval<const Traits&>().scalar_from_double_object())>>
  : std::true_type
{
};

// The way from the values of a field to numbers and back: that of the traits class, else that of number types. Values
// of any other type are not a number each.
template <class Traits>
class Scalar_conversion
{
  typedef typename Traits::Scalar Scalar;
  static constexpr bool is_given = Has_scalar_to_double<Traits>::value;
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
    if constexpr(Has_scalar_from_double<Traits>::value)
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

} // namespace internal
} // namespace Reeb_graph
} // namespace CGAL

#endif // CGAL_REEB_GRAPH_INTERNAL_BASE_SCALAR_CONVERSION_H
