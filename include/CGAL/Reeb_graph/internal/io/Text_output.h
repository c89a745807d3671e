// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of the CGAL-style package Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_INTERNAL_IO_TEXT_OUTPUT_H
#define CGAL_REEB_GRAPH_INTERNAL_IO_TEXT_OUTPUT_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/exceptions.h>
#include <CGAL/Reeb_graph/internal/io/text.h>

#include <cerrno>
#include <charconv>
#include <cstddef>
#include <fstream>
#include <limits>
#include <locale>
#include <memory>
#include <ostream>
#include <string>
#include <string_view>
#include <system_error>
#include <type_traits>

namespace CGAL {
namespace Reeb_graph {
namespace internal {

// Text that goes to a stream in large pieces. A stream takes longer to find its place and its locale for each piece
// than it takes to write it.
class Text_output
{
public:
  explicit Text_output(std::ostream& out) : out_(out), piece_(new char[size_of_piece]), end_(piece_.get()) {}

  Text_output(const Text_output&) = delete;
  Text_output& operator=(const Text_output&) = delete;

  Text_output& operator<<(std::string_view text)
  {
    if(text.size() > size_of_piece)
    {
      flush();
      out_.write(text.data(), static_cast<std::streamsize>(text.size()));
      return *this;
    }
    make_room(text.size());
    end_ += text.copy(end_, text.size());
    return *this;
  }

  Text_output& operator<<(char c) { return *this << std::string_view(&c, 1); }

  // Writes what to_round_trip_string() makes of the number.
  template <class Number, std::enable_if_t<std::is_arithmetic_v<Number>, int> = 0>
  Text_output& operator<<(Number number)
  {
    if constexpr(is_written_by_to_chars<Number>)
    {
      make_room(most_characters_of_number);
      end_ = write_with_precision(number, std::numeric_limits<Number>::max_digits10, end_);
      return *this;
    }
    else if constexpr(std::is_integral_v<Number> && sizeof(Number) > 1)
    {
      make_room(most_characters_of_number);
      end_ = std::to_chars(end_, end_ + most_characters_of_number, number).ptr;
      return *this;
    }
    else
      return *this << to_round_trip_string(number);
  }

  // Writes what is left. It is not left to a destructor, in which a stream could throw an exception.
  void flush()
  {
    out_.write(piece_.get(), end_ - piece_.get());
    end_ = piece_.get();
  }

private:
  static constexpr std::size_t size_of_piece = 1 << 16;

  void make_room(std::size_t size)
  {
    if(size > size_of_piece - static_cast<std::size_t>(end_ - piece_.get()))
      flush();
  }

  std::ostream& out_;
  std::unique_ptr<char[]> piece_;
  char* end_; // of what is written in the piece
};

// Lets a stream write numbers as programs read them, whatever its locale is before and after. A stream that has failed
// keeps this locale: to set another one on a full disk would break its buffer, which then throws std::bad_cast.
class Classic_locale
{
public:
  explicit Classic_locale(std::ostream& out) : out_(out), before_(out.getloc())
  {
    if(out.flush())
      out.imbue(std::locale::classic());
  }
  ~Classic_locale()
  {
    try
    {
      if(out_.flush())
        out_.imbue(before_);
    }
    catch(...) // The state of the stream tells it, too.
    {}
  }
  Classic_locale(const Classic_locale&) = delete;
  Classic_locale& operator=(const Classic_locale&) = delete;

private:
  std::ostream& out_;
  std::locale before_;
};

// Says why, where the system does.
template <class Write>
void write_file(const std::string& filename, const Write& write)
{
  errno = 0;
  std::ofstream out(filename);
  if(out)
    write(out);
  out.close();
  if(!out)
    throw File_error(filename + " cannot be written"
                     + (errno == 0 ? "" : ": " + std::generic_category().message(errno)));
}

} // namespace internal
} // namespace Reeb_graph
} // namespace CGAL

#endif // CGAL_REEB_GRAPH_INTERNAL_IO_TEXT_OUTPUT_H
