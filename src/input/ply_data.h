// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_SRC_PLY_DATA_H
#define CGAL_REEB_GRAPH_SRC_PLY_DATA_H

#include "input/binary_numbers.h"
#include "input/ply_header.h"
#include "input/ply_records.h"
#include "input/text_input.h"

#include <algorithm>
#include <cctype>
#include <cstddef>
#include <string_view>
#include <vector>

namespace reeb_graph_program {
namespace ply {
// The numbers behind the header.
class Data
{
public:
  Data(Text_input& input, Format format) : input_(input), bytes_(input.rest()), format_(format)
  {
    if(format == Format::ASCII)
      input.finish_line(); // that of end_header
  }

  // Each number of these types is a double as well.
  double read(Type type)
  {
    if(format_ == Format::ASCII)
      return read_word(type);
    const std::size_t size = size_in_bytes(type);
    if(bytes_.size() < size)
      input_.fail("the file ends too early");
    const char* const first = bytes_.data();
    bytes_.remove_prefix(size);
    const bool is_order_reversed = is_reversed();
    return call_with_number(type, [&](auto n) -> double { return decode<decltype(n)>(first, is_order_reversed); });
  }

  // Reads a property: one number, or those of a list.
  void read(const Property& property, std::vector<double>& numbers)
  {
    numbers.clear();
    const std::size_t size = property.is_list() ? read_list_size(property) : 1;
    while(numbers.size() < size)
      numbers.push_back(read(property.type));
  }

  std::size_t read_list_size(const Property& property)
  {
    const double size = read(property.list_size_type); // an integer
    if(size < 0)
      input_.fail("the size of a list is negative");
    return static_cast<std::size_t>(size);
  }

  // The next elements as records, nothing if the file is none of binary records or ends too early. Each list of theirs
  // has to be the vertices of a triangle, which is not checked.
  std::string_view records(const Element& element) const
  {
    const std::size_t size = offset_in_record(element, element.properties.size());
    const bool are_there = format_ != Format::ASCII && size > 0 && bytes_.size() / size >= element.number;
    return are_there ? bytes_.substr(0, element.number * size) : std::string_view();
  }

  void skip(const Element& element)
  {
    std::vector<double> ignored;
    for(std::size_t i = 0; i < element.number && !element.properties.empty(); ++i)
      for(const Property& property : element.properties)
        read(property, ignored);
  }

  bool is_reversed() const { return (format_ == Format::BINARY_BIG_ENDIAN) != is_machine_big_endian(); }
  void skip(std::string_view records) { bytes_.remove_prefix(records.size()); }
  Column column(const Element& element, std::size_t place) const { return {element, place, is_reversed()}; }

  void check_end()
  {
    const bool is_at_end = format_ == Format::ASCII ? input_.word_of_file().empty()
                                                    : std::all_of(bytes_.begin(), bytes_.end(),
                                                                  [](unsigned char c) { return std::isspace(c) != 0; });
    if(!is_at_end)
      input_.fail("there is more in the file than its header says");
  }

private:
  double read_word(Type type)
  {
    const std::string_view word = input_.word_of_file();
    return call_with_number(type, [&](auto n) -> double { return input_.number<decltype(n)>(word); });
  }

  Text_input& input_;
  std::string_view bytes_; // that have not been read, of a binary file
  Format format_;
};

} // namespace ply

} // namespace reeb_graph_program

#endif // CGAL_REEB_GRAPH_SRC_PLY_DATA_H
