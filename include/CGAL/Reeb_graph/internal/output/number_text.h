// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of the CGAL-style package Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_INTERNAL_OUTPUT_NUMBER_TEXT_H
#define CGAL_REEB_GRAPH_INTERNAL_OUTPUT_NUMBER_TEXT_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/internal/base/Scalar_conversion.h>
#include <CGAL/Reeb_graph/internal/base/graph_requirements.h>

#include <charconv>
#include <cstddef>
#include <limits>
#include <locale>
#include <sstream>
#include <string>
#include <type_traits>

namespace CGAL {
namespace Reeb_graph {
namespace internal {

// Whether std::to_chars() writes such numbers.
template <class Value>
#ifdef __cpp_lib_to_chars
constexpr bool is_written_by_to_chars = std::is_same_v<Value, double> || std::is_same_v<Value, float>;
#else
constexpr bool is_written_by_to_chars = false;
#endif

// A sign, 17 digits, a point, and an exponent.
constexpr std::size_t most_characters_of_number = 32;

template <class Value>
char* write_with_precision(const Value& value, int precision, char* out)
{
  return std::to_chars(out, out + most_characters_of_number, value, std::chars_format::general, precision).ptr;
}

template <class Value>
std::string to_string_with_precision(const Value& value, int precision)
{
  if constexpr(is_written_by_to_chars<Value>)
  {
    char digits[most_characters_of_number];
    if(precision <= std::numeric_limits<double>::max_digits10)
      return {digits, write_with_precision(value, precision, digits)};
  }
  std::ostringstream text;
  text.imbue(std::locale::classic());
  text.precision(precision);
  if constexpr(std::is_integral_v<Value>)
    text << +value; // those of 8 bits are no characters
  else
    text << value;
  return text.str();
}

// Six digits: what a person reads.
template <class Value>
std::string to_short_string(const Value& value)
{
  return to_string_with_precision(value, 6);
}

// As many digits as it takes to read back the same floating-point number.
template <class Value>
std::string to_round_trip_string(const Value& value)
{
  if constexpr(std::is_floating_point_v<Value>)
    return to_string_with_precision(value, std::numeric_limits<Value>::max_digits10);
  else
    return to_short_string(value);
}

// What is written for a scalar value: itself, or its number if it has no operator<<.
template <class Traits>
auto written_scalar(const Scalar_conversion<Traits>& conversion, const typename Traits::Scalar& value)
{
  if constexpr(Has<Written_scalar, typename Traits::Scalar>::value)
    return value;
  else
    return conversion.to_double(value);
}

} // namespace internal
} // namespace Reeb_graph
} // namespace CGAL

#endif // CGAL_REEB_GRAPH_INTERNAL_OUTPUT_NUMBER_TEXT_H
