// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_SRC_BASE64_H
#define CGAL_REEB_GRAPH_SRC_BASE64_H

#include <CGAL/Reeb_graph/IO/vtp.h>

#include <boost/endian/conversion.hpp>

#include <algorithm>
#include <cstring>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace reeb_graph_program {
// The base64 code of numbers, little-endian on any machine.
template <class Number>
std::string base64(const std::vector<Number>& numbers)
{
  std::vector<unsigned char> bytes(numbers.size() * sizeof(Number));
  if(!numbers.empty())
    std::memcpy(bytes.data(), numbers.data(), bytes.size());
  if(boost::endian::order::native == boost::endian::order::big)
    for(auto number = bytes.begin(); number != bytes.end(); number += sizeof(Number))
      std::reverse(number, number + sizeof(Number));
  std::ostringstream out;
  CGAL::Reeb_graph::internal::write_base64(out, std::move(bytes));
  return out.str();
}

} // namespace reeb_graph_program

#endif // CGAL_REEB_GRAPH_SRC_BASE64_H
