// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of the CGAL-style package Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_INTERNAL_OUTPUT_JSON_TEXT_H
#define CGAL_REEB_GRAPH_INTERNAL_OUTPUT_JSON_TEXT_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/internal/output/number_text.h>
#include <CGAL/Reeb_graph/internal/output/utf8.h>

#include <CGAL/number_utils.h>

#include <boost/graph/graph_traits.hpp>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>

namespace CGAL {
namespace Reeb_graph {
namespace internal {

// JSON has no numbers that are infinite or NaN.
inline std::string json_of(double number) { return std::isfinite(number) ? to_round_trip_string(number) : "null"; }

inline std::string json_of(std::int64_t number) { return std::to_string(number); }

inline std::string json_of(const std::string& text)
{
  constexpr char digits[] = "0123456789abcdef";
  std::string result = "\"";
  for(const char c : to_utf8(text))
  {
    const auto code = static_cast<unsigned char>(c);
    if(code < 32)
      result += std::string("\\u00") + digits[code / 16] + digits[code % 16];
    else
      result += c == '"' || c == '\\' ? std::string("\\") + c : std::string(1, c);
  }
  return result + '"';
}

template <class Range, class JsonOfElement>
std::string json_list(const Range& range, const JsonOfElement& json_of_element)
{
  std::string result = "[";
  for(const auto& element : range)
    result += (result.size() == 1 ? "" : ", ") + json_of_element(element);
  return result + "]";
}

template <class Point>
std::string json_of_point(const Point& point)
{
  return "[" + json_of(CGAL::to_double(point.x())) + ", " + json_of(CGAL::to_double(point.y())) + ", "
       + json_of(CGAL::to_double(point.z())) + "]";
}

// The pieces of a chain as paths of vertices. `ends_of` returns the two vertices of a halfedge by their indices.
template <class Chain, class EndsOf>
std::string json_of_chain(const Chain& chain, const EndsOf& ends_of)
{
  std::string result = "[";
  for(std::size_t i = 0; i != chain.size(); ++i)
  {
    const auto [source, target] = ends_of(chain[i]);
    const bool is_first = i == 0 || ends_of(chain[i - 1]).second != source;
    if(is_first)
      result += (i == 0 ? "[" : "], [") + std::to_string(source);
    result += ", " + std::to_string(target);
  }
  return result + (chain.size() == 0 ? "]" : "]]");
}

} // namespace internal
} // namespace Reeb_graph
} // namespace CGAL

#endif // CGAL_REEB_GRAPH_INTERNAL_OUTPUT_JSON_TEXT_H
