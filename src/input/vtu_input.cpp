// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of the CGAL-style package Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#include "input/File_contents.h"
#include "input/field_names.h"
#include "input/mesh_formats.h"
#include "input/text_input.h"
#include "input/vtk_cells.h"

#include <boost/endian/conversion.hpp>

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>
#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace reeb_graph_program {
namespace {
// The opening tag of an element of XML, and where what it holds begins.
struct Tag
{
  std::string name; // with a slash at its beginning if it closes the element
  std::map<std::string, std::string> attributes;
  std::size_t end = 0;

  std::string attribute(const std::string& key, const std::string& otherwise = std::string()) const
  {
    const auto found = attributes.find(key);
    return found == attributes.end() ? otherwise : found->second;
  }
};

// The numbers of an element DataArray, as they are in the file.
struct Data_array
{
  Tag tag;
  std::string_view text;
};

// The elements of a piece of the grid.
struct Piece
{
  std::size_t number_of_points = 0, number_of_cells = 0;
  std::map<std::string, Data_array> arrays; // of cells by their names; "points"; the field as "scalars"
  Field_names names;
};

std::string decode_base64(std::string_view text)
{
  static const std::string digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string bytes;
  std::uint32_t bits = 0;
  int number_of_bits = 0;
  for(const char c : text)
  {
    const std::size_t digit = digits.find(c);
    if(c == '=')
      number_of_bits = 0; // what follows begins anew
    if(digit == std::string::npos)
      continue;
    bits = bits << 6 | static_cast<std::uint32_t>(digit);
    number_of_bits += 6;
    if(number_of_bits >= 8)
      bytes.push_back(static_cast<char>(bits >> (number_of_bits -= 8) & 0xff));
  }
  return bytes;
}

class Vtu_reader
{
public:
  Vtu_reader(const std::string& path, std::string_view text, const std::string& vertex_property)
    : path_(path),
      text_(text),
      vertex_property_(vertex_property)
  {}

  Polygon_soup read()
  {
    read_elements();
    Polygon_soup soup;
    for(const Piece& piece : pieces_)
      add_piece(piece, soup);
    return soup;
  }

private:
  [[noreturn]] void fail(const std::string& message) const { throw Input_error(path_, message); }

  std::size_t parse_size(const std::string& text) const
  {
    std::size_t number = 0;
    if(parse_number(text, number) != std::errc())
      fail(quote(text) + " is not a number that is possible here");
    return number;
  }

  // The end of the tag that begins at a place: the first closing bracket that is not in a quoted value.
  std::size_t end_of_tag(std::size_t place) const
  {
    char quotation = '\0';
    for(; place < text_.size(); ++place)
    {
      const char c = text_[place];
      if(quotation == '\0' && c == '>')
        return place;
      if(quotation == '\0' && (c == '"' || c == '\''))
        quotation = c;
      else if(c == quotation)
        quotation = '\0';
    }
    return std::string_view::npos;
  }

  // The next tag from a place on; one without a name at the end of the text. Comments and declarations are left out.
  Tag next_tag(std::size_t begin) const
  {
    Tag tag;
    for(begin = text_.find('<', begin); begin != std::string_view::npos; begin = text_.find('<', begin + 1))
    {
      if(text_.substr(begin, 4) == "<!--")
        begin = std::min(text_.find("-->", begin), text_.size());
      else if(text_.substr(begin, 2) != "<?" && text_.substr(begin, 2) != "<!")
        break;
    }
    tag.end = end_of_tag(begin);
    if(tag.end == std::string_view::npos)
      return tag;
    std::string_view inside = text_.substr(begin + 1, tag.end++ - begin - 1);
    const std::size_t end_of_name = inside.find_first_of(" \t\r\n");
    tag.name = std::string(inside.substr(0, end_of_name));
    inside.remove_prefix(std::min(end_of_name, inside.size()));
    for(std::size_t equals = inside.find('='); equals != std::string_view::npos; equals = inside.find('='))
    {
      const std::size_t quotation = inside.find_first_of("\"'", equals);
      const std::size_t end =
        quotation == std::string_view::npos ? quotation : inside.find(inside[quotation], quotation + 1);
      if(end == std::string_view::npos)
        fail("an attribute of XML has no end");
      std::string_view key = inside.substr(0, equals);
      key.remove_prefix(std::min(key.find_first_not_of(" \t\r\n"), key.size()));
      key = key.substr(0, key.find_first_of(" \t\r\n"));
      tag.attributes[std::string(key)] = std::string(inside.substr(quotation + 1, end - quotation - 1));
      inside.remove_prefix(end + 1);
    }
    return tag;
  }

  void read_elements()
  {
    std::string section;
    bool has_end = false;
    for(std::size_t place = 0; !has_end;)
    {
      const Tag tag = next_tag(place);
      if(tag.name.empty())
        break;
      place = tag.end;
      if(tag.name == "VTKFile")
        read_file_tag(tag);
      else if(tag.name == "Piece")
        pieces_.push_back(
          {parse_size(tag.attribute("NumberOfPoints")), parse_size(tag.attribute("NumberOfCells")), {}, {}});
      else if(tag.name == "PointData" || tag.name == "CellData" || tag.name == "Points" || tag.name == "Cells")
        section = tag.name;
      else if(tag.name == "DataArray")
        add_array(section, tag);
      else if(tag.name == "AppendedData")
      {
        begin_appended_data(tag);
        has_end = true; // raw data are no XML
      }
      has_end = has_end || tag.name == "/VTKFile";
    }
    if(!has_file_tag_)
      fail("the file does not begin as a VTU file");
    if(!has_end)
      fail("the file ends too early: </VTKFile> is missing");
  }

  void read_file_tag(const Tag& tag)
  {
    has_file_tag_ = true;
    if(tag.attribute("type") != "UnstructuredGrid")
      fail("a VTK file of type " + quote(tag.attribute("type")) + " is not read: it is an UnstructuredGrid");
    if(!tag.attribute("compressor").empty())
      fail("compressed data are not read: write the file without compression");
    are_bytes_swapped_ = (tag.attribute("byte_order", "LittleEndian") == "BigEndian")
                      != (boost::endian::order::native == boost::endian::order::big);
    header_type_ = tag.attribute("header_type", "UInt32");
  }

  void begin_appended_data(const Tag& tag)
  {
    is_appended_raw_ = tag.attribute("encoding") != "base64";
    const std::size_t begin = text_.find('_', tag.end);
    if(begin == std::string_view::npos)
      fail("the appended data do not begin with _");
    appended_ = text_.substr(begin + 1);
  }

  // Of the points' arrays the field is kept, of the other ones those that say what the cells are.
  void add_array(const std::string& section, const Tag& tag)
  {
    if(pieces_.empty())
      return;
    const std::string name =
      section == "Points"  ? "points"
      : section == "Cells" ? tag.attribute("Name")
      : section == "PointData" && !vertex_property_.empty() && tag.attribute("Name") == vertex_property_
        ? "scalars"
        : std::string();
    const std::string components = tag.attribute("NumberOfComponents", "1");
    if(section == "PointData" || section == "CellData")
      pieces_.back().names.add(section == "CellData", tag.attribute("Name"),
                               components.empty() ? 1 : parse_size(components));
    if(!name.empty())
      pieces_.back().arrays[name] = {tag, text_.substr(tag.end, text_.find('<', tag.end) - tag.end)};
  }

  void add_piece(const Piece& piece, Polygon_soup& soup) const
  {
    const std::size_t first_vertex = soup.points.size();
    const std::vector<double> coordinates = numbers(piece, "points", piece.number_of_points, 3);
    for(std::size_t i = 0; i < piece.number_of_points; ++i)
      soup.points.emplace_back(coordinates[3 * i], coordinates[3 * i + 1], coordinates[3 * i + 2]);
    if(!vertex_property_.empty())
    {
      if(piece.arrays.count("scalars") == 0)
        fail(piece.names.message(vertex_property_, "cells"));
      const std::vector<double> scalars = numbers(piece, "scalars", piece.number_of_points, 1);
      soup.scalars.insert(soup.scalars.end(), scalars.begin(), scalars.end());
    }
    if(piece.number_of_cells == 0)
      return;
    const std::vector<double> types = numbers(piece, "types", piece.number_of_cells, 1);
    const std::vector<double> ends = numbers(piece, "offsets", piece.number_of_cells, 1);
    const std::vector<double> corners = numbers(piece, "connectivity");
    Polygons cells;
    std::size_t begin = 0;
    for(std::size_t i = 0; i < piece.number_of_cells; ++i)
    {
      if(!(ends[i] >= static_cast<double>(begin) && ends[i] <= static_cast<double>(corners.size())))
        fail("the offsets of the cells do not ascend, or are too large");
      for(const std::size_t end = to_size(ends[i]); begin != end; ++begin)
        cells.add_corner(to_size(corners[begin]));
      cells.end_polygon();
    }
    for(std::size_t i = 0; i < cells.size(); ++i)
      add_vtk_cell(path_, to_size(types[i]), cells[i], first_vertex, soup);
  }

  static std::size_t to_size(double number)
  {
    return number >= 0 && number < too_large_corner ? static_cast<std::size_t>(number) : too_large_corner;
  }

  std::vector<double> numbers(const Piece& piece, const std::string& name) const
  {
    const auto array = piece.arrays.find(name);
    if(array == piece.arrays.end())
      fail("there is no array of " + name);
    return decode(name, array->second);
  }

  // So many tuples of so many components.
  std::vector<double> numbers(const Piece& piece,
                              const std::string& name,
                              std::size_t tuples,
                              std::size_t components) const
  {
    std::vector<double> result = numbers(piece, name);
    const std::string given = piece.arrays.at(name).tag.attribute("NumberOfComponents", "1");
    if(given != std::to_string(components) || result.size() / components != tuples || result.size() % components != 0)
      fail("the array of " + name + " has " + std::to_string(result.size()) + " numbers, " + given
           + " of each, instead of " + std::to_string(tuples) + " times " + std::to_string(components));
    return result;
  }

  std::vector<double> decode(const std::string& name, const Data_array& array) const
  {
    const std::string format = array.tag.attribute("format", "ascii"), type = array.tag.attribute("type");
    if(format == "ascii")
    {
      std::vector<double> result;
      Text_input input(path_, array.text);
      for(std::string_view word = input.word_of_file(); !word.empty(); word = input.word_of_file())
      {
        double number = 0;
        if(parse_number(word, number) != std::errc())
          fail("the array of " + name + " has " + quote(word) + ", which is not a number");
        result.push_back(number);
      }
      return result;
    }
    if(format == "binary")
      return decode_bytes(name, type, decode_base64(array.text));
    if(format != "appended")
      fail("the array of " + name + " has a format that is not read");
    const std::size_t offset = parse_size(array.tag.attribute("offset"));
    if(offset > appended_.size())
      fail("the array of " + name + " begins behind the end of the file");
    const std::string_view text = appended_.substr(offset);
    if(is_appended_raw_)
      return decode_bytes(name, type, text);
    return decode_bytes(name, type, decode_base64(text.substr(0, text.find('<'))));
  }

  // The bytes begin with the number of bytes that follow.
  std::vector<double> decode_bytes(const std::string& name, const std::string& type, std::string_view bytes) const
  {
    const std::size_t size_of_header = header_type_ == "UInt64" ? 8 : 4;
    if(bytes.size() < size_of_header)
      fail("the array of " + name + " ends too early");
    const auto size = static_cast<std::size_t>(size_of_header == 8 ? number_at<std::uint64_t>(bytes, 0)
                                                                   : number_at<std::uint32_t>(bytes, 0));
    if(size > bytes.size() - size_of_header)
      fail("the array of " + name + " ends too early");
    static const std::map<std::string,
                          std::vector<double> (Vtu_reader::*)(std::string_view, std::size_t, std::size_t) const>
      types = {{"Int8", &Vtu_reader::numbers_of<std::int8_t>},   {"UInt8", &Vtu_reader::numbers_of<std::uint8_t>},
               {"Int16", &Vtu_reader::numbers_of<std::int16_t>}, {"UInt16", &Vtu_reader::numbers_of<std::uint16_t>},
               {"Int32", &Vtu_reader::numbers_of<std::int32_t>}, {"UInt32", &Vtu_reader::numbers_of<std::uint32_t>},
               {"Int64", &Vtu_reader::numbers_of<std::int64_t>}, {"UInt64", &Vtu_reader::numbers_of<std::uint64_t>},
               {"Float32", &Vtu_reader::numbers_of<float>},      {"Float64", &Vtu_reader::numbers_of<double>}};
    const auto found = types.find(type);
    if(found == types.end())
      fail("the array of " + name + " has numbers of a type that is not read");
    return (this->*found->second)(bytes, size_of_header, size);
  }

  template <class Number>
  std::vector<double> numbers_of(std::string_view bytes, std::size_t begin, std::size_t size) const
  {
    std::vector<double> result;
    result.reserve(size / sizeof(Number));
    for(std::size_t i = 0; i + sizeof(Number) <= size; i += sizeof(Number))
      result.push_back(static_cast<double>(number_at<Number>(bytes, begin + i)));
    return result;
  }

  template <class Number>
  Number number_at(std::string_view bytes, std::size_t place) const
  {
    std::array<char, sizeof(Number)> copy;
    std::copy_n(bytes.begin() + place, sizeof(Number), copy.begin());
    if(are_bytes_swapped_)
      std::reverse(copy.begin(), copy.end());
    Number number;
    std::memcpy(&number, copy.data(), sizeof(Number));
    return number;
  }

  std::string path_;
  std::string_view text_, appended_;
  std::string vertex_property_, header_type_ = "UInt32";
  bool has_file_tag_ = false, are_bytes_swapped_ = false, is_appended_raw_ = false;
  std::vector<Piece> pieces_;
};

} // namespace

Polygon_soup read_vtu(const std::string& path, const std::string& vertex_property)
{
  const File_contents file(path);
  return Vtu_reader(path, file.text(), vertex_property).read();
}

} // namespace reeb_graph_program
