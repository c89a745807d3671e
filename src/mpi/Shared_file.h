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
// A file of which each rank reads or writes parts of its own by MPI-IO. Opening and closing it is no collective work: a
// rank that fails leaves no other one waiting.
class Shared_file
{
public:
  enum class Access
  {
    READ,
    WRITE // of a file that is there
  };

  // Throws Input_error, or std::runtime_error where it is to be written.
  Shared_file(const std::string& path, Access access) : Shared_file(path, access, path) {}
  // The same with another name in messages.
  Shared_file(const std::string& path, Access access, const std::string& shown_path);
  Shared_file(const Shared_file&) = delete;
  Shared_file& operator=(const Shared_file&) = delete;
  ~Shared_file();

  std::uint64_t size() const { return size_; }

  // The bytes have to be in the file.
  void read(std::uint64_t offset, char* bytes, std::size_t number_of_bytes) const;
  void write(std::uint64_t offset, const char* bytes, std::size_t number_of_bytes) const;

  // Says whether what was written is there.
  void close();

private:
  std::string path_;
  MPI_File file_ = MPI_FILE_NULL;
  std::uint64_t size_ = 0;
};

} // namespace reeb_graph_program

#endif // CGAL_REEB_GRAPH_SRC_SHARED_FILE_H
