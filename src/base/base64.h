// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of the CGAL-style package Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_SRC_BASE64_H
#define CGAL_REEB_GRAPH_SRC_BASE64_H

#include <boost/endian/conversion.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <string>
#include <vector>

namespace reeb_graph_program {
// The base64 code of bytes.
inline std::string base64(const std::vector<unsigned char>& bytes)
{
  constexpr char digits[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  text.reserve((bytes.size() + 2) / 3 * 4);
  for(std::size_t i = 0; i < bytes.size(); i += 3)
  {
    std::uint32_t group = 0;
    for(std::size_t k = 0; k < 3; ++k)
      group = group << 8 | (i + k < bytes.size() ? bytes[i + k] : 0u);
    for(std::size_t k = 0; k < 4; ++k)
      text += i + k <= bytes.size() ? digits[group >> (18 - 6 * k) & 63] : '=';
  }
  return text;
}

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
  return base64(bytes);
}

} // namespace reeb_graph_program

#endif // CGAL_REEB_GRAPH_SRC_BASE64_H
