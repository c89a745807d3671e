// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_SRC_FILE_BUFFER_H
#define CGAL_REEB_GRAPH_SRC_FILE_BUFFER_H

#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstddef>
#include <streambuf>

namespace reeb_graph_program {
// The buffer of a stream that writes to a file descriptor, and owns it. Other than that of the standard library, it tells
// why it has failed.
class File_buffer : public std::streambuf
{
public:
  explicit File_buffer(int file) : file_(file) { setp(buffer_.data(), buffer_.data() + buffer_.size()); }
  ~File_buffer() override { close(); }
  File_buffer(const File_buffer&) = delete;
  File_buffer& operator=(const File_buffer&) = delete;

  // Writes what is left, and closes the file. Returns the number of the first error since the begin, 0 if there is none.
  int close()
  {
    if(file_ < 0)
      return error_;
    write_buffered();
    if(::close(file_) != 0 && error_ == 0)
      error_ = errno;
    file_ = -1;
    return error_;
  }

protected:
  int_type overflow(int_type c) override
  {
    if(!write_buffered())
      return traits_type::eof();
    if(!traits_type::eq_int_type(c, traits_type::eof()))
      sputc(traits_type::to_char_type(c));
    return traits_type::not_eof(c);
  }

  std::streamsize xsputn(const char* text, std::streamsize size) override
  {
    if(size < epptr() - pptr())
      return std::streambuf::xsputn(text, size);
    return write_buffered() && write_all(text, size) ? size : 0;
  }

  int sync() override { return write_buffered() ? 0 : -1; }

private:
  bool write_buffered()
  {
    const std::ptrdiff_t size = pptr() - pbase();
    setp(buffer_.data(), buffer_.data() + buffer_.size());
    return write_all(buffer_.data(), size);
  }

  bool write_all(const char* text, std::ptrdiff_t size)
  {
    while(error_ == 0 && size > 0)
    {
      const ::ssize_t written = ::write(file_, text, static_cast<std::size_t>(size));
      if(written < 0 && errno != EINTR)
        error_ = errno;
      if(written > 0)
      {
        text += written;
        size -= written;
      }
    }
    return error_ == 0;
  }

  int file_, error_ = 0;
  std::array<char, 1 << 16> buffer_;
};

} // namespace reeb_graph_program

#endif // CGAL_REEB_GRAPH_SRC_FILE_BUFFER_H
