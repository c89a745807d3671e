// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_SRC_FILE_CONTENTS_H
#define CGAL_REEB_GRAPH_SRC_FILE_CONTENTS_H

#include "input/input_error.h"

#include <boost/core/noncopyable.hpp>
#include <boost/endian/conversion.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <memory>
#include <string>
#include <string_view>

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

// All bytes of a file. They are read, not mapped: a file that shrinks meanwhile is an error, and no end of the program.
class File_contents : boost::noncopyable
{
public:
  explicit File_contents(const std::string& path)
  {
    if(is_standard_input(path))
    {
      text_ = contents_of_standard_input();
      return;
    }
    std::ifstream file(path, std::ios::binary);
    if(!file || std::filesystem::is_directory(path))
      throw unreadable_file(path);
    if(std::filesystem::is_regular_file(path))
      read(file, std::filesystem::file_size(path));
    else
      read_to_end(file);
    if(!file)
      throw Input_error(path, "the file cannot be read");
  }

  std::string_view text() const { return text_; }

private:
  void read(std::ifstream& file, std::size_t size)
  {
    bytes_.reset(new char[size]); // not set to zero
    file.read(bytes_.get(), static_cast<std::streamsize>(size));
    text_ = std::string_view(bytes_.get(), size);
  }

  // Reads what has no size before: a pipe.
  void read_to_end(std::ifstream& file)
  {
    piped_.assign(std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>());
    text_ = piped_;
  }

  std::unique_ptr<char[]> bytes_;
  std::string piped_;
  std::string_view text_;
};

} // namespace reeb_graph_program

#endif // CGAL_REEB_GRAPH_SRC_FILE_CONTENTS_H
