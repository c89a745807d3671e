// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_SRC_NPY_OUTPUT_H
#define CGAL_REEB_GRAPH_SRC_NPY_OUTPUT_H

#include <boost/endian/conversion.hpp>

#include <cstdint>
#include <filesystem>
#include <ostream>
#include <string>
#include <type_traits>
#include <vector>

namespace reeb_graph_program {
inline bool is_npy(const std::filesystem::path& path) { return path.extension() == ".npy"; }

// Writes doubles, or integers of 64 bits, as NumPy does: a header whose size is a multiple of 64, and the bytes.
template <class Number>
void write_npy(std::ostream& stream, const std::vector<Number>& numbers)
{
  static_assert(std::is_same_v<Number, double> || std::is_same_v<Number, std::int64_t>);
  constexpr std::size_t size_before = 10, multiple = 64;
  const bool is_little = boost::endian::order::native == boost::endian::order::little;
  std::string header = std::string("{'descr': '") + (is_little ? '<' : '>') + (std::is_integral_v<Number> ? 'i' : 'f')
                     + "8', 'fortran_order': False, 'shape': (" + std::to_string(numbers.size()) + ",), }";
  header.append(multiple - (size_before + header.size() + 1) % multiple, ' ');
  header += '\n';
  const std::uint16_t size = boost::endian::native_to_little(static_cast<std::uint16_t>(header.size()));
  stream.write("\x93NUMPY\x01\x00", 8);
  stream.write(reinterpret_cast<const char*>(&size), sizeof(size));
  stream << header;
  stream.write(reinterpret_cast<const char*>(numbers.data()),
               static_cast<std::streamsize>(numbers.size() * sizeof(Number)));
}

} // namespace reeb_graph_program

#endif // CGAL_REEB_GRAPH_SRC_NPY_OUTPUT_H
