// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of the CGAL-style package Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_INTERNAL_OUTPUT_BASE64_H
#define CGAL_REEB_GRAPH_INTERNAL_OUTPUT_BASE64_H

#include <CGAL/license/Reeb_graph.h>

#include <boost/archive/iterators/base64_from_binary.hpp>
#include <boost/archive/iterators/transform_width.hpp>

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <ostream>
#include <string>
#include <vector>

namespace CGAL {
namespace Reeb_graph {
namespace internal {

inline void write_base64(std::ostream& out, std::vector<unsigned char> bytes)
{
  using boost::archive::iterators::base64_from_binary;
  using boost::archive::iterators::transform_width;
  typedef base64_from_binary<transform_width<std::vector<unsigned char>::const_iterator, 6, 8>> Digits;
  const std::size_t padding = (3 - bytes.size() % 3) % 3;
  const std::size_t number_of_digits = (4 * bytes.size() + 2) / 3;
  bytes.resize(bytes.size() + padding, 0);
  std::string text; // in one piece: an iterator of the stream's buffer would not tell the stream that it failed
  text.reserve(number_of_digits + padding);
  std::copy_n(Digits(bytes.cbegin()), number_of_digits, std::back_inserter(text));
  out << text.append(padding, '=');
}

} // namespace internal
} // namespace Reeb_graph
} // namespace CGAL

#endif // CGAL_REEB_GRAPH_INTERNAL_OUTPUT_BASE64_H
