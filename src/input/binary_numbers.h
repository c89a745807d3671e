// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_SRC_BINARY_NUMBERS_H
#define CGAL_REEB_GRAPH_SRC_BINARY_NUMBERS_H

#include <boost/endian/conversion.hpp>

#include <algorithm>
#include <array>
#include <cstring>

namespace reeb_graph_program {
// The number that bytes of a file stand for, in the order of this machine or the other way round.
template <class Number>
Number decode(const char* bytes, bool is_reversed)
{
  Number number;
  if(!is_reversed)
  {
    std::memcpy(&number, bytes, sizeof(Number));
    return number;
  }
  std::array<char, sizeof(Number)> reversed;
  std::reverse_copy(bytes, bytes + sizeof(Number), reversed.begin());
  std::memcpy(&number, reversed.data(), sizeof(Number));
  return number;
}

inline bool is_machine_big_endian() { return boost::endian::order::native == boost::endian::order::big; }

} // namespace reeb_graph_program

#endif // CGAL_REEB_GRAPH_SRC_BINARY_NUMBERS_H
