// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_SRC_RECORDS_H
#define CGAL_REEB_GRAPH_SRC_RECORDS_H

#include "mpi/Shared_file.h"
#include "mpi/ranks.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace reeb_graph_program {
// Records of the same number of bytes, one after the other, in a file.
struct Records
{
  std::uint64_t offset = 0; // of the first one in the file
  std::uint64_t number = 0;
  std::size_t size = 0; // in bytes
};

// Calls the function with each record of a part, in their order, and its number.
template <class Function>
void read_records(const Shared_file& file, const Records& records, const Part& part, const Function& function)
{
  constexpr std::size_t bytes_at_once = std::size_t(1) << 22;
  const std::uint64_t records_at_once =
    std::max<std::size_t>(bytes_at_once / std::max<std::size_t>(records.size, 1), 1);
  std::vector<char> bytes;
  for(std::uint64_t first = part.first; first < part.last; first += records_at_once)
  {
    const std::uint64_t last = std::min(first + records_at_once, part.last);
    bytes.resize((last - first) * records.size);
    file.read(records.offset + first * records.size, bytes.data(), bytes.size());
    for(std::uint64_t i = first; i < last; ++i)
      function(i, bytes.data() + (i - first) * records.size);
  }
}

} // namespace reeb_graph_program

#endif // CGAL_REEB_GRAPH_SRC_RECORDS_H
