// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_SRC_PLY_HEADER_H
#define CGAL_REEB_GRAPH_SRC_PLY_HEADER_H

#include "input/File_contents.h"
#include "input/number_types.h"
#include "input/text_input.h"

#include <algorithm>
#include <cctype>
#include <cstddef>
#include <initializer_list>
#include <string>
#include <string_view>
#include <vector>

namespace reeb_graph_program {
// The header of a PLY file.
namespace ply {
enum class Format
{
  ASCII,
  BINARY_LITTLE_ENDIAN,
  BINARY_BIG_ENDIAN
};

struct Property
{
  Number_type list_size_type = Number_type::NONE; // NONE if the property is a single number
  Number_type type = Number_type::NONE;
  std::string name;

  bool is_list() const { return list_size_type != Number_type::NONE; }
};

struct Element
{
  std::string name;
  std::size_t number = 0;
  std::vector<Property> properties;

  bool is_vertex() const { return name == "vertex" || name == "vertices"; }
  bool is_face() const { return name == "face" || name == "faces"; }

  // The place of the first property that has one of the names, the number of properties if there is none.
  std::size_t find(std::initializer_list<std::string_view> names) const
  {
    const auto is_named = [&](const Property& p) {
      return std::find(names.begin(), names.end(), p.name) != names.end();
    };
    return static_cast<std::size_t>(std::find_if(properties.begin(), properties.end(), is_named) - properties.begin());
  }
};

struct Header
{
  Format format = Format::ASCII;
  std::vector<Element> elements;
};

inline std::size_t size_in_bytes(Number_type type)
{
  return call_with_number(type, [](auto number) { return sizeof(number); });
}

// Reads the header from its first line on, up to the line that ends it. Throws Input_error if it is none, as if a
// property belongs to no element.
Header read_header(Text_input& input);

// The place of the property of these vertices that is asked for as field. Throws Input_error if there is none.
std::size_t find_scalars(const Text_input& input,
                         const Header& header,
                         const Element& vertices,
                         const std::string& name);

// Throws Input_error for an element that may be a part of the mesh: it has lists of integers, or vertices.
void refuse_geometry(const Text_input& input, const Element& element);

// The elements of a binary PLY file whose faces are triangles are records of one size: all lists have three numbers.
inline std::size_t size_in_record(const Property& property)
{
  const std::size_t size = size_in_bytes(property.type);
  return property.is_list() ? size_in_bytes(property.list_size_type) + 3 * size : size;
}

inline std::size_t offset_in_record(const Element& element, std::size_t place)
{
  std::size_t offset = 0;
  for(std::size_t i = 0; i < place; ++i)
    offset += size_in_record(element.properties[i]);
  return offset;
}

inline double decode_number(Number_type type, const char* bytes, bool is_reversed)
{
  return call_with_number(type, [&](auto n) -> double { return decode<decltype(n)>(bytes, is_reversed); });
}

// Reads numbers of one property out of records.
class Column
{
public:
  Column(const Element& element, std::size_t place, bool is_reversed)
    : offset_(offset_in_record(element, place)),
      type_(element.properties[place].type),
      is_reversed_(is_reversed)
  {}

  double operator()(const char* record) const { return decode_number(type_, record + offset_, is_reversed_); }

private:
  std::size_t offset_;
  Number_type type_;
  bool is_reversed_;
};

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
  double read(Number_type type)
  {
    if(format_ == Format::ASCII)
      return read_word(type);
    const std::size_t size = size_in_bytes(type);
    if(bytes_.size() < size)
      input_.fail("the file ends too early");
    const char* const first = bytes_.data();
    bytes_.remove_prefix(size);
    return decode_number(type, first, is_reversed());
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
  double read_word(Number_type type)
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

#endif // CGAL_REEB_GRAPH_SRC_PLY_HEADER_H
