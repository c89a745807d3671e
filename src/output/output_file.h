// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_SRC_OUTPUT_FILE_H
#define CGAL_REEB_GRAPH_SRC_OUTPUT_FILE_H

#include <boost/core/noncopyable.hpp>
#include <boost/endian/conversion.hpp>

#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <ostream>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <vector>

namespace reeb_graph_program {
// Paths of outputs: `-` is standard output. Pipes, devices, and standard output are written at once, all else is written
// beside its place and put there when it is complete.
// A file cannot be written.
struct Output_error : std::runtime_error
{
  using std::runtime_error::runtime_error;
};

// Which of the endings, of which the first one stands for a pipe, a device, or standard output without any of them, and
// for no file, the file name has. Throws std::runtime_error, which names them and what they are the endings of.
std::string ending_of(const std::filesystem::path& path,
                      const std::string& contents,
                      const std::vector<std::string>& endings);

// Refuses output of which one part would replace another one, or an input. Empty paths are not given.
void check_outputs(const std::vector<std::filesystem::path>& outputs, const std::vector<std::filesystem::path>& inputs);

// Where the report goes: standard error if standard output is one of the files.
std::ostream& report_stream(const std::vector<std::filesystem::path>& outputs);

// Throws std::runtime_error if standard output has not arrived.
void flush_standard_output();

// Files that belong together: what this thread writes while such an object lives stays beside its place. None is there
// before put_in_place(), nor after an exception before it, nor if a signal ends the program: all are put in place before
// that, or none is. The same is so of folders that are made, and of files that are removed. A group within another one is a
// part of that. What is written at once, as standard output, does not wait.
class Output_group : boost::noncopyable
{
public:
  Output_group();
  ~Output_group();

  void put_in_place();

  struct Files;

private:
  std::unique_ptr<Files> files_; // none within another group
};

// Calls `write` with a stream to a temporary file in the same folder, and renames that file to `path` afterwards: the file is
// complete or as it was before, and keeps its mode. Throws std::runtime_error, and what `write` throws.
void write_file(const std::filesystem::path& path, const std::function<void(std::ostream&)>& write);

// Makes a folder, and those that it is in, if they are not there. Throws Output_error.
void make_folder(const std::filesystem::path& path);

// Removes a file, if it is there.
void remove_file(const std::filesystem::path& path);

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

#endif // CGAL_REEB_GRAPH_SRC_OUTPUT_FILE_H
