// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#include "base/threads.h"
#include "input/input_error.h"
#include "input/mesh_formats.h"
#include "input/number_types.h"
#include "input/text_input.h"
#include "input/vtk_input.h"

#include <zlib.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <set>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>
#include <vector>

namespace reeb_graph_program {
namespace {
// The opening tag of an element of XML, and where what it holds begins.
struct Xml_tag
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

// The end of the tag that begins at a place: the first closing bracket that is not in a quoted value.
std::size_t end_of_tag(std::string_view text, std::size_t place)
{
  char quotation = '\0';
  for(; place < text.size(); ++place)
  {
    const char c = text[place];
    if(quotation == '\0' && c == '>')
      return place;
    if(quotation == '\0' && (c == '"' || c == '\''))
      quotation = c;
    else if(c == quotation)
      quotation = '\0';
  }
  return std::string_view::npos;
}

std::string decode_entities(std::string_view text)
{
  static constexpr std::array<std::pair<std::string_view, char>, 5> entities = {
    {{"&lt;", '<'}, {"&gt;", '>'}, {"&quot;", '"'}, {"&apos;", '\''}, {"&amp;", '&'}}};
  std::string decoded;
  while(!text.empty())
  {
    const auto found = std::find_if(entities.begin(), entities.end(), [&](const auto& entity) {
      return text.substr(0, entity.first.size()) == entity.first;
    });
    decoded += found == entities.end() ? text.front() : found->second;
    text.remove_prefix(found == entities.end() ? 1 : found->first.size());
  }
  return decoded;
}

// The next tag of a file from a place on; one without a name at its end. Comments and declarations are left out. Throws
// Input_error. Readers of XML take no file whose end is no XML, as VTK's files with raw data are.
Xml_tag next_tag(const std::string& path, std::string_view text, std::size_t begin)
{
  Xml_tag tag;
  for(begin = text.find('<', begin); begin != std::string_view::npos; begin = text.find('<', begin + 1))
  {
    if(text.substr(begin, 4) == "<!--")
      begin = std::min(text.find("-->", begin), text.size());
    else if(text.substr(begin, 2) != "<?" && text.substr(begin, 2) != "<!")
      break;
  }
  tag.end = end_of_tag(text, begin);
  if(tag.end == std::string_view::npos)
    return tag;
  std::string_view inside = text.substr(begin + 1, tag.end++ - begin - 1);
  const std::size_t end_of_name = inside.find_first_of(" \t\r\n");
  tag.name = std::string(inside.substr(0, end_of_name));
  inside.remove_prefix(std::min(end_of_name, inside.size()));
  for(std::size_t equals = inside.find('='); equals != std::string_view::npos; equals = inside.find('='))
  {
    const std::size_t quotation = inside.find_first_of("\"'", equals);
    const std::size_t end =
      quotation == std::string_view::npos ? quotation : inside.find(inside[quotation], quotation + 1);
    if(end == std::string_view::npos)
      throw Input_error(path, "an attribute of XML has no end");
    std::string_view key = inside.substr(0, equals);
    key.remove_prefix(std::min(key.find_first_not_of(" \t\r\n"), key.size()));
    key = key.substr(0, key.find_first_of(" \t\r\n"));
    tag.attributes[std::string(key)] = decode_entities(inside.substr(quotation + 1, end - quotation - 1));
    inside.remove_prefix(end + 1);
  }
  return tag;
}

// The numbers of an element DataArray, as they are in the file.
struct Vtk_xml_array
{
  Xml_tag tag;
  std::string_view text;
};

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
  Vtk_xml_bytes(const std::string& path,
                const std::string& name,
                std::string_view text,
                bool is_base64,
                std::size_t size_of_number,
                bool is_swapped)
    : path_(path),
      name_(name),
      text_(text),
      is_base64_(is_base64),
      is_swapped_(is_swapped),
      size_of_number_(size_of_number)
  {}

  std::string_view read() { return take(add(size_of_number_, header_number(0))).substr(size_of_number_); }

  std::string_view read_compressed()
  {
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
  bool is_base64_, is_swapped_;
  std::size_t size_of_number_;
};

// Reads the numbers of arrays: as text, in base64 code, or raw, each of which may be behind all elements, and the last
// two compressed by zlib.
class Vtk_xml_arrays
{
public:
  Vtk_xml_arrays(const std::string& path, std::string_view file) : path_(path), file_(file) {}

  // Takes the order of bytes, and whether they are compressed. Throws Input_error if not by zlib.
  void read_file_tag(const Xml_tag& tag)
  {
    const std::string compressor = tag.attribute("compressor");
    if(!compressor.empty() && compressor != "vtkZLibDataCompressor")
      throw Input_error(path_, "data compressed by " + quote(compressor)
                                 + " are not read, but by vtkZLibDataCompressor: "
                                 + (compressor == "vtkLZMADataCompressor" ? "'meshio decompress FILE', or " : "")
                                 + "ParaView with the compressor ZLib or None, saves such a file");
    are_numbers_compressed_ = !compressor.empty();
    are_bytes_swapped_ = (tag.attribute("byte_order", "LittleEndian") == "BigEndian") != is_machine_big_endian();
    size_of_header_number_ = tag.attribute("header_type", "UInt32") == "UInt64" ? 8 : 4;
  }

  // Finds the data behind all elements.
  void read_appended_tag(const Xml_tag& tag)
  {
    is_appended_raw_ = tag.attribute("encoding") != "base64";
    const std::size_t begin = file_.find('_', tag.end);
    if(begin == std::string_view::npos)
      throw Input_error(path_, "the appended data do not begin with _");
    appended_ = file_.substr(begin + 1);
  }

  // All numbers of an array. `name` is for messages.
  template <class Number>
  std::vector<Number> read(const std::string& name, const Vtk_xml_array& array) const
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
                         !is_appended || !is_appended_raw_, size_of_header_number_, are_bytes_swapped_);
    const std::string_view bytes = are_numbers_compressed_ ? source.read_compressed() : source.read();
    std::vector<Number> result;
    if(!call_with_vtk_type(array.tag.attribute("type"), [&](auto number) {
         result = decode_vtk_numbers<Number, decltype(number)>(bytes, are_bytes_swapped_);
       }))
      throw Input_error(path_, "the array of " + name + " has numbers of a type that is not read");
    return result;
  }

private:
  template <class Number>
  std::vector<Number> read_text(std::string_view text) const
  {
    std::vector<Number> result;
    Text_input input(path_, text, static_cast<std::size_t>(std::count(file_.data(), text.data(), '\n')));
    for(std::string_view word = input.word_of_file(); !word.empty(); word = input.word_of_file())
      result.push_back(input.number<Number>(word));
    return result;
  }

  std::string path_;
  std::string_view file_, appended_;
  bool are_bytes_swapped_ = false, are_numbers_compressed_ = false, is_appended_raw_ = false;
  std::size_t size_of_header_number_ = 4;
};

// The elements of a piece of the grid.
struct Vtk_xml_piece
{
  Xml_tag tag;
  std::map<std::string, Vtk_xml_array> arrays; // by the names of sections and arrays
};

// Reads files of unstructured grids, whose cells have types, and of polygonal data, whose sections do.
class Vtk_xml_reader
{
public:
  Vtk_xml_reader(const std::string& path, std::string_view text, const Vtk_field_choice& choice)
    : path_(path),
      text_(text),
      choice_(choice),
      arrays_(path, text)
  {}

  Polygon_soup read()
  {
    read_elements();
    Polygon_soup soup;
    for(const Vtk_xml_piece& piece : pieces_)
      add_piece(piece, soup);
    return soup;
  }

private:
  [[noreturn]] void fail(const std::string& message) const { throw Input_error(path_, message); }

  // A number of points or cells of a piece; those that there are none of may be left out.
  std::size_t size(const Vtk_xml_piece& piece, const std::string& attribute) const
  {
    const std::string text = piece.tag.attribute(attribute, "0");
    std::size_t number = 0;
    if(parse_number(text, number) != std::errc())
      fail(quote(text) + " is not a number that is possible here");
    return number;
  }

  void read_elements()
  {
    static const std::set<std::string> sections = {"PointData", "CellData", "Points", "Cells",
                                                   "Verts",     "Lines",    "Strips", "Polys"};
    std::string section, type;
    bool has_end = false;
    for(std::size_t place = 0; !has_end;)
    {
      const Xml_tag tag = next_tag(path_, text_, place);
      if(tag.name.empty())
        break;
      place = tag.end;
      if(tag.name == "VTKFile")
        type = read_file_tag(tag);
      else if(tag.name == "Piece")
        pieces_.push_back({tag, {}});
      else if(sections.count(tag.name) != 0)
        section = tag.name;
      else if(tag.name == "DataArray" && !pieces_.empty())
      {
        add_name(section, tag);
        pieces_.back().arrays[section + " " + tag.attribute("Name")] = {
          tag, text_.substr(tag.end, text_.find('<', tag.end) - tag.end)};
      }
      else if(tag.name == "AppendedData")
        arrays_.read_appended_tag(tag);
      has_end = tag.name == "AppendedData" || tag.name == "/VTKFile"; // raw data are no XML
    }
    if(type.empty())
      fail("the file does not begin as a VTK file");
    if(!has_end)
      fail("the file ends too early: </VTKFile> is missing");
  }

  // Of several pieces, the first one has the names.
  void add_name(const std::string& section, const Xml_tag& tag)
  {
    std::size_t components = 1;
    parse_number(tag.attribute("NumberOfComponents", "1"), components);
    if(pieces_.size() == 1 && (section == "PointData" || section == "CellData"))
      choice_.names->add(section == "CellData", tag.attribute("Name"), components);
  }

  std::string read_file_tag(const Xml_tag& tag)
  {
    const std::string type = tag.attribute("type");
    if(type != "UnstructuredGrid" && type != "PolyData")
      fail(refused_vtk_type(type));
    arrays_.read_file_tag(tag);
    return type;
  }

  void add_piece(const Vtk_xml_piece& piece, Polygon_soup& soup) const
  {
    const std::size_t first_vertex = soup.points.size(), number_of_points = size(piece, "NumberOfPoints");
    add_points(piece, number_of_points, soup);
    for(const auto& [name, array] : piece.arrays)
      if(name.substr(0, 10) == "PointData " && array.tag.attribute("NumberOfComponents", "1") == "1")
        add_field(array, number_of_points, soup);
    Vtk_cells cells;
    if(const std::size_t number_of_cells = size(piece, "NumberOfCells"))
    {
      const Vtk_xml_array& types = array(piece, "Cells types");
      cells.types = arrays_.read<std::size_t>("types", types);
      if(cells.types.size() != number_of_cells)
        fail("the array of types has " + std::to_string(cells.types.size()) + " numbers instead of "
             + std::to_string(number_of_cells));
      check_vtk_types(path_, cells.types);
      add_cells(piece, "Cells", number_of_cells, cells);
    }
    const std::pair<const char*, std::size_t> sections[] = {
      {"Verts", vtk_vertices}, {"Lines", vtk_lines}, {"Polys", vtk_polygons}, {"Strips", vtk_strips}};
    for(const auto& [section, type] : sections)
      if(const std::size_t number_of_cells = size(piece, std::string("NumberOf") + section))
      {
        add_cells(piece, section, number_of_cells, cells);
        cells.types.resize(cells.vertices.size(), type);
      }
    add_vtk_cells(path_, cells, first_vertex, soup);
  }

  void add_points(const Vtk_xml_piece& piece, std::size_t number, Polygon_soup& soup) const
  {
    for(const auto& [name, array] : piece.arrays)
      if(name.substr(0, 7) == "Points ")
      {
        const std::vector<double> coordinates = arrays_.read<double>("points", array);
        const std::string components = array.tag.attribute("NumberOfComponents", "1");
        if(components != "3" || coordinates.size() / 3 != number || coordinates.size() % 3 != 0)
          fail("the array of points has " + std::to_string(coordinates.size()) + " numbers, " + components
               + " of each, instead of " + std::to_string(number) + " times 3");
        for(std::size_t i = 0; i < number; ++i)
          soup.points.emplace_back(coordinates[3 * i], coordinates[3 * i + 1], coordinates[3 * i + 2]);
        return;
      }
    if(number > 0)
      fail("there is no array of points");
  }

  void add_field(const Vtk_xml_array& array, std::size_t number_of_points, Polygon_soup& soup) const
  {
    Vertex_field field = {array.tag.attribute("Name"), array.tag.attribute("type"), {}};
    if(!choice_.is_wanted(field.name) || (choice_.are_all_wanted && field.type == "Bit"))
      return;
    field.numbers = arrays_.read<double>(quote(field.name), array);
    if(field.numbers.size() != number_of_points)
      fail("the array of " + quote(field.name) + " has " + std::to_string(field.numbers.size()) + " numbers instead of "
           + std::to_string(number_of_points));
    choice_.add(field, soup);
  }

  const Vtk_xml_array& array(const Vtk_xml_piece& piece, const std::string& name) const
  {
    const auto found = piece.arrays.find(name);
    if(found == piece.arrays.end())
      fail("there is no array of " + name);
    return found->second;
  }

  void add_cells(const Vtk_xml_piece& piece, const std::string& section, std::size_t number, Vtk_cells& cells) const
  {
    const std::vector<std::size_t> ends = arrays_.read<std::size_t>("offsets", array(piece, section + " offsets"));
    if(ends.size() != number)
      fail("the array of offsets has " + std::to_string(ends.size()) + " numbers instead of " + std::to_string(number));
    add_vtk_vertices(path_, ends, arrays_.read<std::size_t>("connectivity", array(piece, section + " connectivity")),
                     cells.vertices);
  }

  std::string path_;
  std::string_view text_;
  Vtk_field_choice choice_;
  Vtk_xml_arrays arrays_;
  std::vector<Vtk_xml_piece> pieces_;
};

} // namespace

Polygon_soup read_vtk_xml(const std::string& path, std::string_view text, const Vtk_field_choice& choice)
{
  return Vtk_xml_reader(path, text, choice).read();
}

} // namespace reeb_graph_program
