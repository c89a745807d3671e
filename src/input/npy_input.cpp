// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#include "input/npy_input.h"

#include "input/File_contents.h"
#include "input/binary_numbers.h"
#include "input/input_error.h"

#include <boost/endian/conversion.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>
#include <type_traits>

namespace reeb_graph_program {
namespace {
// What the header of a file says, and what follows it.
struct Npy_array
{
  std::string type;  // as NumPy writes it: byte order, kind, and size
  std::string shape; // the numbers between the parentheses
  std::string_view numbers;
};

// The value of a key of the header, a dict of Python in a form that NumPy always writes: what is between two
// characters behind the key.
std::string header_value(const std::string& path,
                         const std::string& header,
                         const std::string& key,
                         char begin,
                         char end)
{
  std::size_t place = header.find("'" + key + "':");
  if(place != std::string::npos)
    place = header.find_first_not_of(' ', place + key.size() + 3);
  const std::size_t last = place < header.size() ? header.find(end, place + 1) : std::string::npos;
  if(last == std::string::npos || header[place] != begin)
    throw Input_error(path, "the header of the file has no " + std::string(key == "descr" ? "dtype of numbers" : key)
                              + ": " + quote(header));
  return header.substr(place + 1, last - place - 1);
}

Npy_array split_npy(const std::string& path, std::string_view text)
{
  constexpr std::string_view magic("\x93NUMPY", 6);
  constexpr std::size_t begin_of_size = 8, longest_header = 4096;
  if(text.size() < begin_of_size + 2 || text.substr(0, magic.size()) != magic)
    throw Input_error(path, "the file does not begin as those of NumPy");
  const bool is_long = text[magic.size()] > 1;
  if(is_long && text.size() < begin_of_size + 4)
    throw Input_error(path, "the file ends in its header");
  const auto* const size_bytes = reinterpret_cast<const unsigned char*>(text.data() + begin_of_size);
  const std::size_t size =
    is_long ? boost::endian::load_little_u32(size_bytes) : boost::endian::load_little_u16(size_bytes);
  const std::size_t begin = begin_of_size + (is_long ? 4 : 2);
  if(size > longest_header || text.size() - begin < size)
    throw Input_error(path, "the file ends in its header");
  const std::string header(text.substr(begin, size));
  return {header_value(path, header, "descr", '\'', '\''), header_value(path, header, "shape", '(', ')'),
          text.substr(begin + size)};
}

template <class Number>
std::vector<double> decode_all(const std::string& path, std::string_view bytes, std::size_t count, bool is_reversed)
{
  if(bytes.size() != count * sizeof(Number))
    throw Input_error(path, "the file has " + std::to_string(bytes.size()) + " bytes of numbers instead of "
                              + std::to_string(count * sizeof(Number)));
  std::vector<double> result(count);
  for(std::size_t i = 0; i < count; ++i)
  {
    const auto number = decode<Number>(bytes.data() + i * sizeof(Number), is_reversed);
    result[i] = static_cast<double>(number);
    if constexpr(std::is_integral_v<Number> && sizeof(Number) == 8)
    {
      const bool is_too_large = result[i] >= std::ldexp(1., std::is_signed_v<Number> ? 63 : 64);
      if(is_too_large || static_cast<Number>(result[i]) != number)
        throw Input_error(path, "vertex " + std::to_string(i) + " has the value " + std::to_string(number)
                                  + ", to which no double is equal");
    }
  }
  return result;
}

std::vector<double> decode_array(const std::string& path, const Npy_array& array, std::size_t count)
{
  const std::string kind = array.type.substr(array.type.empty() ? 0 : 1);
  const bool is_reversed = array.type.substr(0, 1) == (is_machine_big_endian() ? "<" : ">");
  const auto decode_as = [&](auto number) {
    return decode_all<decltype(number)>(path, array.numbers, count, is_reversed);
  };
  if(kind == "f8")
    return decode_as(double());
  if(kind == "f4")
    return decode_as(float());
  if(kind == "i1")
    return decode_as(std::int8_t());
  if(kind == "u1" || kind == "b1")
    return decode_as(std::uint8_t());
  if(kind == "i2")
    return decode_as(std::int16_t());
  if(kind == "u2")
    return decode_as(std::uint16_t());
  if(kind == "i4")
    return decode_as(std::int32_t());
  if(kind == "u4")
    return decode_as(std::uint32_t());
  if(kind == "i8")
    return decode_as(std::int64_t());
  if(kind == "u8")
    return decode_as(std::uint64_t());
  throw Input_error(path, "the array has the dtype " + quote(array.type)
                            + ": it must be one of integers, float32, or float64");
}

} // namespace

std::vector<double> read_npy(const std::string& path, std::size_t number_of_vertices)
{
  const File_contents file(path);
  const Npy_array array = split_npy(path, file.text());
  std::string shape = array.shape;
  shape.erase(std::remove(shape.begin(), shape.end(), ' '), shape.end());
  if(shape != std::to_string(number_of_vertices) + ",")
    throw Input_error(path, "the array has the shape (" + array.shape + "): it must be ("
                              + std::to_string(number_of_vertices) + ",), one number for each vertex of the mesh");
  return decode_array(path, array, number_of_vertices);
}

} // namespace reeb_graph_program
