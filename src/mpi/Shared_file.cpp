// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#include "mpi/Shared_file.h"

#include "input/input_error.h"

#include <algorithm>
#include <filesystem>

namespace reeb_graph_program {
namespace {
constexpr std::size_t most_bytes_at_once = std::size_t(1) << 28;

int number_of_bytes_done(MPI_Status& status)
{
  int number = 0;
  MPI_Get_count(&status, MPI_BYTE, &number);
  return number;
}

} // namespace

Shared_file::Shared_file(const std::string& path) : path_(path)
{
  if(!std::filesystem::is_regular_file(path)
     || MPI_File_open(MPI_COMM_SELF, path.c_str(), MPI_MODE_RDONLY, MPI_INFO_NULL, &file_) != MPI_SUCCESS)
    throw Input_error(path_, "the file cannot be read");
  MPI_Offset size = 0;
  MPI_File_get_size(file_, &size);
  size_ = static_cast<std::uint64_t>(size);
}

Shared_file::~Shared_file()
{
  if(file_ != MPI_FILE_NULL)
    MPI_File_close(&file_);
}

void Shared_file::read(std::uint64_t offset, char* bytes, std::size_t number_of_bytes) const
{
  for(std::size_t begin = 0; begin < number_of_bytes;)
  {
    const int number = static_cast<int>(std::min(number_of_bytes - begin, most_bytes_at_once));
    MPI_Status status;
    const int error = MPI_File_read_at(file_, static_cast<MPI_Offset>(offset) + static_cast<MPI_Offset>(begin),
                                       bytes + begin, number, MPI_BYTE, &status);
    if(error != MPI_SUCCESS || number_of_bytes_done(status) != number)
      throw Input_error(path_, "the file cannot be read");
    begin += static_cast<std::size_t>(number);
  }
}

} // namespace reeb_graph_program
