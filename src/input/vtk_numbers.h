// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_SRC_VTK_NUMBERS_H
#define CGAL_REEB_GRAPH_SRC_VTK_NUMBERS_H

#include "input/File_contents.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <map>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

// The numbers in binary arrays of VTK's files.
namespace reeb_graph_program {
// Calls `use` with a number of the type that has this name in XML files. Returns false if none has it.
template <class Use>
bool call_with_vtk_type(std::string_view type, const Use& use)
{
  const auto call = [&](std::string_view name, auto number) {
    if(type != name)
      return false;
    use(number);
    return true;
  };
  return call("Float32", float()) || call("Float64", double()) || call("Int32", std::int32_t())
      || call("Int64", std::int64_t()) || call("UInt8", std::uint8_t()) || call("Int8", std::int8_t())
      || call("Int16", std::int16_t()) || call("UInt16", std::uint16_t()) || call("UInt32", std::uint32_t())
      || call("UInt64", std::uint64_t());
}

// The name in XML files of a type of legacy ones, in which identifiers have 32 bits; empty for a type of no numbers.
inline std::string vtk_type_of_legacy_name(std::string name)
{
  static const std::map<std::string, std::string> types = {{"float", "Float32"},
                                                           {"double", "Float64"},
                                                           {"int", "Int32"},
                                                           {"unsigned_int", "UInt32"},
                                                           {"long", "Int64"},
                                                           {"unsigned_long", "UInt64"},
                                                           {"short", "Int16"},
                                                           {"unsigned_short", "UInt16"},
                                                           {"char", "Int8"},
                                                           {"signed_char", "Int8"},
                                                           {"unsigned_char", "UInt8"},
                                                           {"vtkidtype", "Int32"},
                                                           {"vtktypeint64", "Int64"},
                                                           {"vtktypeuint64", "UInt64"},
                                                           {"vtktypeint32", "Int32"},
                                                           {"vtktypeint16", "Int16"},
                                                           {"vtktypeuint32", "UInt32"},
                                                           {"vtktypeint8", "Int8"},
                                                           {"long_long", "Int64"},
                                                           {"unsigned_long_long", "UInt64"},
                                                           {"__int64", "Int64"},
                                                           {"vtktypeuint16", "UInt16"},
                                                           {"vtktypeuint8", "UInt8"},
                                                           {"unsigned___int64", "UInt64"}};
  std::transform(name.begin(), name.end(), name.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  const auto found = types.find(name);
  return found == types.end() ? std::string() : found->second;
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

#endif // CGAL_REEB_GRAPH_SRC_VTK_NUMBERS_H
