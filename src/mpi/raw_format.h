// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_SRC_RAW_FORMAT_H
#define CGAL_REEB_GRAPH_SRC_RAW_FORMAT_H

#include "mpi/Records.h"

#include <cstddef>
#include <cstdint>
#include <string_view>

namespace reeb_graph_program {
// What raw files begin with.
constexpr std::string_view raw_magic = "ReebRaw1";

// Where the parts of a raw file are, which read_local_raw() describes.
class Raw_layout
{
public:
  static constexpr std::size_t size_of_header = 24;

  Raw_layout(std::uint64_t number_of_vertices, std::uint64_t number_of_triangles)
    : scalars_{size_of_header, number_of_vertices, sizeof(double)},
      triangles_{size_of_header + number_of_vertices * sizeof(double), number_of_triangles, 3 * sizeof(std::uint64_t)}
  {}

  const Records& scalars() const { return scalars_; }
  const Records& triangles() const { return triangles_; }
  std::uint64_t size() const { return triangles_.offset + triangles_.number * triangles_.size; }

private:
  Records scalars_, triangles_;
};

} // namespace reeb_graph_program

#endif // CGAL_REEB_GRAPH_SRC_RAW_FORMAT_H
