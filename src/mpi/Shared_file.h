// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_SRC_SHARED_FILE_H
#define CGAL_REEB_GRAPH_SRC_SHARED_FILE_H

#include <mpi.h>

#include <cstddef>
#include <cstdint>
#include <string>

namespace reeb_graph_program {
// A file of which each rank reads parts of its own by MPI-IO. Opening and closing it is no collective work: a
// rank that fails leaves no other one waiting.
class Shared_file
{
public:
  // Throws Input_error.
  explicit Shared_file(const std::string& path);
  Shared_file(const Shared_file&) = delete;
  Shared_file& operator=(const Shared_file&) = delete;
  ~Shared_file();

  std::uint64_t size() const { return size_; }

  // The bytes have to be in the file.
  void read(std::uint64_t offset, char* bytes, std::size_t number_of_bytes) const;

private:
  std::string path_;
  MPI_File file_ = MPI_FILE_NULL;
  std::uint64_t size_ = 0;
};

} // namespace reeb_graph_program

#endif // CGAL_REEB_GRAPH_SRC_SHARED_FILE_H
