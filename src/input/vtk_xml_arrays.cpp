// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#include "input/vtk_xml_arrays.h"

#include "base/threads.h"
#include "input/input_error.h"
#include "input/text_input.h"
#include "input/vtk_numbers.h"

#include <zlib.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace reeb_graph_program {
namespace {
constexpr unsigned char no_digit = 64;

std::array<unsigned char, 256> values_of_base64_digits()
{
  constexpr std::string_view digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::array<unsigned char, 256> values;
  values.fill(no_digit);
  for(std::size_t i = 0; i < digits.size(); ++i)
    values[static_cast<unsigned char>(digits[i])] = static_cast<unsigned char>(i);
  return values;
}

// The first bytes, so many or all. What is no digit is left out, and behind = a code begins anew.
std::string decode_base64(std::string_view text, std::size_t most)
{
  static const std::array<unsigned char, 256> values = values_of_base64_digits();
  std::string bytes;
  bytes.reserve(std::min(most, text.size() / 4 * 3 + 3));
  std::uint32_t bits = 0;
  unsigned number_of_bits = 0;
  for(std::size_t i = 0; i < text.size() && bytes.size() < most; ++i)
  {
    if(text[i] == '=')
      number_of_bits = 0;
    const unsigned char value = values[static_cast<unsigned char>(text[i])];
    if(value == no_digit)
      continue;
    bits = bits << 6U | value;
    number_of_bits += 6;
    if(number_of_bits >= 8)
      bytes.push_back(static_cast<char>(bits >> (number_of_bits -= 8) & 0xffU));
  }
  return bytes;
}

// The bytes of an array behind a header of numbers that say how many there are. Without compression, that is one
// number. With it, there are the number of blocks, the size of each and that of the last one, unless that is as large,
// and the compressed size of each.
class Vtk_xml_bytes
{
public:
  Vtk_xml_bytes(const std::string& path, const std::string& name, std::string_view text, bool is_base64)
    : path_(path),
      name_(name),
      text_(text),
      is_base64_(is_base64)
  {}

  std::string_view read(std::size_t size_of_number, bool is_swapped)
  {
    size_of_number_ = size_of_number;
    is_swapped_ = is_swapped;
    const std::size_t size = header_number(0);
    return take(add(size_of_number_, size)).substr(size_of_number_);
  }

  std::string_view read_compressed(std::size_t size_of_number, bool is_swapped)
  {
    size_of_number_ = size_of_number;
    is_swapped_ = is_swapped;
    const std::size_t number = header_number(0);
    if(number == 0)
      return {};
    if(number > text_.size())
      fail("ends too early");
    const std::size_t size = header_number(1), last = header_number(2);
    const std::size_t size_of_header = (3 + number) * size_of_number_;
    take(size_of_header);
    std::vector<std::size_t> begins(1, size_of_header), ends(1, 0);
    for(std::size_t i = 0; i < number; ++i)
    {
      const std::size_t compressed = number_at(3 + i), whole = i + 1 < number || last == 0 ? size : last;
      begins.push_back(add(begins.back(), compressed));
      if(whole / 1032 > compressed) // zlib gains no more
        fail("is damaged");
      ends.push_back(ends.back() + whole);
    }
    take(begins.back());
    whole_.resize(ends.back());
    std::vector<char> are_complete(number, 0);
    run_tasks(number, [&](std::size_t i) {
      uLongf size_of_block = static_cast<uLongf>(ends[i + 1] - ends[i]);
      const uLongf wanted = size_of_block;
      are_complete[i] = static_cast<char>(uncompress(reinterpret_cast<Bytef*>(&whole_[ends[i]]), &size_of_block,
                                                     reinterpret_cast<const Bytef*>(bytes_.data() + begins[i]),
                                                     static_cast<uLong>(begins[i + 1] - begins[i]))
                                            == Z_OK
                                          && size_of_block == wanted);
    });
    if(std::find(are_complete.begin(), are_complete.end(), 0) != are_complete.end())
      fail("is damaged: zlib does not decompress it");
    return whole_;
  }

private:
  [[noreturn]] void fail(const std::string& message) const
  {
    throw Input_error(path_, "the array of " + name_ + " " + message);
  }

  std::size_t add(std::size_t a, std::size_t b) const
  {
    if(b > text_.size())
      fail("ends too early");
    return a + b;
  }

  // The first bytes.
  std::string_view take(std::size_t size)
  {
    if(size > bytes_.size())
    {
      if(is_base64_)
      {
        decoded_ = decode_base64(text_, size);
        bytes_ = decoded_;
      }
      else
        bytes_ = text_;
      if(size > bytes_.size())
        fail("ends too early");
    }
    return bytes_.substr(0, size);
  }

  std::size_t header_number(std::size_t i)
  {
    take((i + 1) * size_of_number_);
    return number_at(i);
  }

  std::size_t number_at(std::size_t i) const
  {
    const char* const place = bytes_.data() + i * size_of_number_;
    return size_of_number_ == 8 ? static_cast<std::size_t>(decode<std::uint64_t>(place, is_swapped_))
                                : decode<std::uint32_t>(place, is_swapped_);
  }

  const std::string &path_, &name_;
  std::string_view text_, bytes_;
  std::string decoded_, whole_;
  bool is_base64_, is_swapped_ = false;
  std::size_t size_of_number_ = 4;
};

} // namespace

void Vtk_xml_arrays::read_file_tag(const Xml_tag& tag)
{
  const std::string compressor = tag.attribute("compressor");
  if(!compressor.empty() && compressor != "vtkZLibDataCompressor")
    throw Input_error(path_, "data compressed by " + quote(compressor) + " are not read, but by vtkZLibDataCompressor: "
                               + (compressor == "vtkLZMADataCompressor" ? "'meshio decompress FILE', or " : "")
                               + "ParaView with the compressor ZLib or None, saves such a file");
  are_numbers_compressed_ = !compressor.empty();
  are_bytes_swapped_ = (tag.attribute("byte_order", "LittleEndian") == "BigEndian") != is_machine_big_endian();
  size_of_header_number_ = tag.attribute("header_type", "UInt32") == "UInt64" ? 8 : 4;
}

void Vtk_xml_arrays::read_appended_tag(const Xml_tag& tag)
{
  is_appended_raw_ = tag.attribute("encoding") != "base64";
  const std::size_t begin = file_.find('_', tag.end);
  if(begin == std::string_view::npos)
    throw Input_error(path_, "the appended data do not begin with _");
  appended_ = file_.substr(begin + 1);
}

std::vector<double> Vtk_xml_arrays::numbers(const std::string& name, const Vtk_xml_array& array) const
{
  return read<double>(name, array);
}

std::vector<std::size_t> Vtk_xml_arrays::indices(const std::string& name, const Vtk_xml_array& array) const
{
  return read<std::size_t>(name, array);
}

template <class Number>
std::vector<Number> Vtk_xml_arrays::read(const std::string& name, const Vtk_xml_array& array) const
{
  const std::string format = array.tag.attribute("format", "ascii");
  if(format == "ascii")
    return read_text<Number>(array.text);
  if(format != "binary" && format != "appended")
    throw Input_error(path_, "the array of " + name + " has a format that is not read");
  const bool is_appended = format == "appended";
  std::size_t offset = 0;
  if(is_appended && (parse_number(array.tag.attribute("offset"), offset) != std::errc() || offset > appended_.size()))
    throw Input_error(path_, "the array of " + name + " begins behind the end of the file");
  Vtk_xml_bytes source(path_, name, is_appended ? appended_.substr(offset) : array.text,
                       !is_appended || !is_appended_raw_);
  const std::string_view bytes = are_numbers_compressed_
                                 ? source.read_compressed(size_of_header_number_, are_bytes_swapped_)
                                 : source.read(size_of_header_number_, are_bytes_swapped_);
  std::vector<Number> result;
  if(!call_with_vtk_type(array.tag.attribute("type"), [&](auto number) {
       result = decode_vtk_numbers<Number, decltype(number)>(bytes, are_bytes_swapped_);
     }))
    throw Input_error(path_, "the array of " + name + " has numbers of a type that is not read");
  return result;
}

template <class Number>
std::vector<Number> Vtk_xml_arrays::read_text(std::string_view text) const
{
  std::vector<Number> result;
  Text_input input(path_, text, static_cast<std::size_t>(std::count(file_.data(), text.data(), '\n')));
  for(std::string_view word = input.word_of_file(); !word.empty(); word = input.word_of_file())
    result.push_back(input.number<Number>(word));
  return result;
}

} // namespace reeb_graph_program
