// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of the CGAL-style package Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_INTERNAL_OUTPUT_UTF8_H
#define CGAL_REEB_GRAPH_INTERNAL_OUTPUT_UTF8_H

#include <CGAL/license/Reeb_graph.h>

#include <cstddef>
#include <string>
#include <string_view>

namespace CGAL {
namespace Reeb_graph {
namespace internal {

// How many bytes the character takes that a text begins with, in UTF-8; 0 if there is none.
inline std::size_t size_of_character(std::string_view text)
{
  const auto byte = [&](std::size_t i) { return i < text.size() ? static_cast<unsigned char>(text[i]) : 0U; };
  const unsigned first = byte(0), second = byte(1);
  if(first < 0x80)
    return text.empty() ? 0 : 1;
  const std::size_t size = first < 0xC2 ? 0 : first < 0xE0 ? 2 : first < 0xF0 ? 3 : first < 0xF5 ? 4 : 0;
  for(std::size_t i = 1; i < size; ++i)
    if((byte(i) & 0xC0U) != 0x80)
      return 0;
  const bool is_too_long = (first == 0xE0 && second < 0xA0) || (first == 0xF0 && second < 0x90);
  const bool is_surrogate = first == 0xED && second > 0x9F;
  const bool is_none = (first == 0xF4 && second > 0x8F) || (first == 0xEF && second == 0xBF && byte(2) > 0xBD);
  return is_too_long || is_surrogate || is_none ? 0 : size;
}

// The text with the replacement character for each byte that is no part of a character in UTF-8.
inline std::string to_utf8(std::string_view text)
{
  std::string result;
  while(!text.empty())
  {
    const std::size_t size = size_of_character(text);
    result += size == 0 ? std::string_view("\xEF\xBF\xBD") : text.substr(0, size);
    text.remove_prefix(size == 0 ? 1 : size);
  }
  return result;
}

} // namespace internal
} // namespace Reeb_graph
} // namespace CGAL

#endif // CGAL_REEB_GRAPH_INTERNAL_OUTPUT_UTF8_H
