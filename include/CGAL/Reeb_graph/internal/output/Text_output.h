// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of the CGAL-style package Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_INTERNAL_OUTPUT_TEXT_OUTPUT_H
#define CGAL_REEB_GRAPH_INTERNAL_OUTPUT_TEXT_OUTPUT_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/internal/output/number_text.h>

#include <charconv>
#include <cstddef>
#include <limits>
#include <ostream>
#include <string>
#include <string_view>
#include <type_traits>

namespace CGAL {
namespace Reeb_graph {
namespace internal {

// Text that goes to a stream in large pieces. A stream takes longer to find its place and its locale for each piece
// than it takes to write it.
class Text_output
{
public:
  explicit Text_output(std::ostream& out) : out_(out) { text_.reserve(2 * size_of_piece); }

  Text_output(const Text_output&) = delete;
  Text_output& operator=(const Text_output&) = delete;

  Text_output& operator<<(std::string_view text)
  {
    text_ += text;
    if(text_.size() > size_of_piece)
      flush();
    return *this;
  }

  Text_output& operator<<(std::size_t number)
  {
    char digits[std::numeric_limits<std::size_t>::digits10 + 1];
    const auto end = std::to_chars(std::begin(digits), std::end(digits), number).ptr;
    return *this << std::string_view(digits, static_cast<std::size_t>(end - digits));
  }

  // Writes what is left. It is not left to a destructor, in which a stream could throw an exception.
  void flush()
  {
    out_.write(text_.data(), static_cast<std::streamsize>(text_.size()));
    text_.clear();
  }

private:
  static constexpr std::size_t size_of_piece = 1 << 16;

  std::ostream& out_;
  std::string text_;
};

} // namespace internal
} // namespace Reeb_graph
} // namespace CGAL

#endif // CGAL_REEB_GRAPH_INTERNAL_OUTPUT_TEXT_OUTPUT_H
