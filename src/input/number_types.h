// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_SRC_NUMBER_TYPES_H
#define CGAL_REEB_GRAPH_SRC_NUMBER_TYPES_H

#include "input/File_contents.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

// The types of numbers in files, and the numbers in binary arrays of VTK's files.
namespace reeb_graph_program {
enum class Number_type
{
  INT8,
  UINT8,
  INT16,
  UINT16,
  INT32,
  UINT32,
  FLOAT32,
  FLOAT64,
  INT64, // from here on, in no PLY file
  UINT64,
  NONE
};

// The names of all types in this order, empty for those that are not spelled this way.
typedef std::array<std::string_view, std::size_t(Number_type::NONE)> Spelling;

constexpr std::array<Spelling, 1> xml_spellings = {
  {{"Int8", "UInt8", "Int16", "UInt16", "Int32", "UInt32", "Float32", "Float64", "Int64", "UInt64"}}};
constexpr std::array<Spelling, 2> ply_spellings = {
  {{"char", "uchar", "short", "ushort", "int", "uint", "float", "double"},
   {"int8", "uint8", "int16", "uint16", "int32", "uint32", "float32", "float64"}}};
constexpr std::array<Spelling, 2> npy_spellings = {
  {{"i1", "u1", "i2", "u2", "i4", "u4", "f4", "f8", "i8", "u8"}, {"", "b1"}}};
// Those of legacy files of VTK, without capitals. Identifiers have 32 bits there.
constexpr std::array<Spelling, 4> legacy_spellings = {
  {{"char", "unsigned_char", "short", "unsigned_short", "int", "unsigned_int", "float", "double", "long",
    "unsigned_long"},
   {"signed_char", "vtktypeuint8", "vtktypeint16", "vtktypeuint16", "vtkidtype", "vtktypeuint32", "", "", "long_long",
    "unsigned_long_long"},
   {"vtktypeint8", "", "", "", "vtktypeint32", "", "", "", "vtktypeint64", "vtktypeuint64"},
   {"", "", "", "", "", "", "", "", "__int64", "unsigned___int64"}}};

// The type of this name, NONE if no spelling has it.
template <std::size_t n>
Number_type number_type(const std::array<Spelling, n>& spellings, std::string_view name)
{
  for(const Spelling& spelling : spellings)
    if(const auto found = std::find(spelling.begin(), spelling.end(), name); found != spelling.end() && !name.empty())
      return Number_type(found - spelling.begin());
  return Number_type::NONE;
}

// Whether the type, one of PLY's, is one of integers.
inline bool is_integer(Number_type type) { return type < Number_type::FLOAT32; }

// Calls the function with a number of the type, one of PLY's.
template <class Function>
auto call_with_number(Number_type type, const Function& function)
{
  switch(type)
  {
  case Number_type::INT8: return function(std::int8_t(0));
  case Number_type::UINT8: return function(std::uint8_t(0));
  case Number_type::INT16: return function(std::int16_t(0));
  case Number_type::UINT16: return function(std::uint16_t(0));
  case Number_type::INT32: return function(std::int32_t(0));
  case Number_type::UINT32: return function(std::uint32_t(0));
  case Number_type::FLOAT32: return function(float(0));
  default: return function(double(0));
  }
}

// Calls `use` with a number of any type. Returns false for none.
template <class Use>
bool call_with_any_number(Number_type type, const Use& use)
{
  if(type == Number_type::INT64)
    use(std::int64_t(0));
  else if(type == Number_type::UINT64)
    use(std::uint64_t(0));
  else if(type != Number_type::NONE)
    call_with_number(type, use);
  return type != Number_type::NONE;
}

// The same for the type that has this name in XML files of VTK.
template <class Use>
bool call_with_vtk_type(std::string_view name, const Use& use)
{
  return call_with_any_number(number_type(xml_spellings, name), use);
}

// The name in XML files of a type of legacy ones; empty for a type of no numbers.
inline std::string vtk_type_of_legacy_name(std::string name)
{
  std::transform(name.begin(), name.end(), name.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  const Number_type type = number_type(legacy_spellings, name);
  return type == Number_type::NONE ? std::string() : std::string(xml_spellings[0][std::size_t(type)]);
}

// The number as one of the wanted type. What is no number of a vertex becomes the largest one, which is none either.
template <class Wanted, class Number>
Wanted convert_vtk_number(Number number)
{
  if constexpr(std::is_floating_point_v<Wanted>)
    return static_cast<Wanted>(number);
  else if constexpr(std::is_floating_point_v<Number>)
    return number >= 0 && number < Number(1e15) && number == std::floor(number) ? static_cast<Wanted>(number)
                                                                                : std::numeric_limits<Wanted>::max();
  else
    return number < Number(0) ? std::numeric_limits<Wanted>::max() : static_cast<Wanted>(number);
}

// As many numbers as there are whole ones in the bytes.
template <class Wanted, class Number>
std::vector<Wanted> decode_vtk_numbers(std::string_view bytes, bool are_reversed)
{
  std::vector<Wanted> numbers(bytes.size() / sizeof(Number));
  const char* place = bytes.data();
  for(Wanted& number : numbers)
  {
    number = convert_vtk_number<Wanted>(decode<Number>(place, are_reversed));
    place += sizeof(Number);
  }
  return numbers;
}

} // namespace reeb_graph_program

#endif // CGAL_REEB_GRAPH_SRC_NUMBER_TYPES_H
