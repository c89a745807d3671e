// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_INTERNAL_IO_READ_NUMBER_H
#define CGAL_REEB_GRAPH_INTERNAL_IO_READ_NUMBER_H

#include <CGAL/license/Reeb_graph.h>

#include <algorithm>
#include <charconv>
#include <cstddef>
#include <limits>
#include <locale>
#include <sstream>
#include <string>
#include <string_view>
#include <system_error>
#include <type_traits>

#if !defined(__cpp_lib_to_chars) && __has_include(<fast_float/fast_float.h>)
#include <fast_float/fast_float.h>
#define CGAL_REEB_GRAPH_HAS_FAST_FLOAT
#endif

namespace CGAL::Reeb_graph::internal {

// How many characters at the beginning of a text are a number with a point and an exponent, after a sign; 0 if none are.
inline std::size_t size_of_decimal_number(std::string_view text)
{
  const auto skip_digits = [&](std::size_t i) {
    while(i < text.size() && text[i] >= '0' && text[i] <= '9')
      ++i;
    return i;
  };
  const std::size_t begin = !text.empty() && text[0] == '-' ? 1 : 0;
  std::size_t end = skip_digits(begin), digits = end - begin;
  if(end < text.size() && text[end] == '.')
  {
    const std::size_t end_of_fraction = skip_digits(end + 1);
    digits += end_of_fraction - end - 1;
    end = digits == 0 ? begin : end_of_fraction;
  }
  if(digits == 0)
    return 0;
  if(end < text.size() && (text[end] == 'e' || text[end] == 'E'))
  {
    const bool is_signed = end + 1 < text.size() && (text[end + 1] == '+' || text[end + 1] == '-');
    const std::size_t exponent = end + (is_signed ? 2 : 1), end_of_exponent = skip_digits(exponent);
    end = end_of_exponent == exponent ? end : end_of_exponent;
  }
  return end;
}

// How many characters at the beginning of a text are this word, in small letters, or in capitals.
inline std::size_t size_of_word(std::string_view text, std::string_view word)
{
  for(std::size_t i = 0; i != word.size(); ++i)
    if(i == text.size() || (text[i] != word[i] && text[i] != word[i] - 'a' + 'A'))
      return 0;
  return word.size();
}

// The value of a decimal number: by fast_float if it is there, as a stream takes fifteen times as long. Whether it is one.
template <class Number>
bool read_decimal_number(std::string_view text, Number& value)
{
#ifdef CGAL_REEB_GRAPH_HAS_FAST_FLOAT
  const auto result = fast_float::from_chars(text.data(), text.data() + text.size(), value);
  return result.ec == std::errc() && value <= (std::numeric_limits<Number>::max)()
      && value >= std::numeric_limits<Number>::lowest();
#else
  std::istringstream stream{std::string(text)};
  stream.imbue(std::locale::classic());
  stream >> value;
  return !stream.fail();
#endif
}

// Does what std::from_chars() does for floating-point numbers.
template <class Number>
std::from_chars_result read_floating_number(const char* begin, const char* end, Number& number)
{
  const std::string_view text(begin, static_cast<std::size_t>(end - begin));
  if(const std::size_t size = size_of_decimal_number(text))
  {
    Number value = 0;
    const bool is_read = read_decimal_number(text.substr(0, size), value);
    const std::string_view digits = text.substr(0, (std::min)(size, text.find_first_of("eE")));
    const bool is_lost = value == 0 && digits.find_first_of("123456789") != std::string_view::npos;
    if(!is_read || is_lost)
      return {begin + size, std::errc::result_out_of_range};
    number = value;
    return {begin + size, std::errc()};
  }
  const std::size_t sign = !text.empty() && text[0] == '-' ? 1 : 0;
  const std::string_view word = text.substr(sign);
  const std::size_t infinity = (std::max)(size_of_word(word, "infinity"), size_of_word(word, "inf"));
  const std::size_t size = infinity != 0 ? infinity : size_of_word(word, "nan");
  if(size == 0)
    return {begin, std::errc::invalid_argument};
  number = infinity != 0 ? std::numeric_limits<Number>::infinity() : std::numeric_limits<Number>::quiet_NaN();
  number = sign == 1 ? -number : number;
  return {begin + sign + size, std::errc()};
}

// std::from_chars(). Standard libraries before that of g++ 11, and that of clang, have it for whole numbers alone.
template <class Number>
std::from_chars_result read_number(const char* begin, const char* end, Number& number)
{
#ifdef __cpp_lib_to_chars
  return std::from_chars(begin, end, number);
#else
  if constexpr(std::is_floating_point_v<Number>)
    return read_floating_number(begin, end, number);
  else
    return std::from_chars(begin, end, number);
#endif
}

} // namespace CGAL::Reeb_graph::internal

#endif // CGAL_REEB_GRAPH_INTERNAL_IO_READ_NUMBER_H
