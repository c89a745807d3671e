// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#include "input/field_input.h"

#include "base/progress_bar.h"
#include "base/surface.h"
#include "computation/analysis.h"
#include "computation/scalar_fields.h"
#include "input/File_contents.h"
#include "input/input_error.h"
#include "input/mesh_formats.h"
#include "input/number_types.h"
#include "input/text_input.h"

#include <boost/endian/conversion.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstring>
#include <filesystem>
#include <sstream>
#include <stdexcept>
#include <string>
#include <string_view>
#include <system_error>
#include <type_traits>
#include <utility>
#include <vector>

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
  std::vector<double> result;
  if(!call_with_any_number(number_type(npy_spellings, kind), [&](auto number) {
       result = decode_all<decltype(number)>(path, array.numbers, count, is_reversed);
     }))
    throw Input_error(path, "the array has the dtype " + quote(array.type)
                              + ": it must be one of integers, float32, or float64");
  return result;
}

// The numbers of a file of NumPy, one for each vertex: an array of one dimension of floating-point numbers or integers,
// of any byte order. Throws Input_error, also for an integer that no double is equal to.
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

std::string_view trim(std::string_view text)
{
  while(!text.empty() && is_blank(text.front()))
    text.remove_prefix(1);
  while(!text.empty() && is_blank(text.back()))
    text.remove_suffix(1);
  return text;
}

double parse_scalar(const std::string& path, std::size_t line, std::string_view text)
{
  double value = 0;
  const std::errc error = parse_number(text, value);
  if(error == std::errc::result_out_of_range)
    throw Input_error(path, line, quote(text) + " is too large or too small for a double");
  if(error != std::errc())
    throw Input_error(path, line, quote(text) + " is not a number");
  return value;
}

// Reads the lines of a text that are no comments.
class Lines
{
public:
  explicit Lines(Text_input input) : input_(std::move(input)) {}

  bool next()
  {
    while(input_.next_line())
      if(trim(text()).substr(0, 1) != "#")
        return true;
    return false;
  }

  std::string_view text() const { return input_.line(); }
  [[noreturn]] void fail(const std::string& message) const { input_.fail(message); }

  double number(std::string_view text) const { return parse_scalar(input_.path(), input_.line_number(), text); }

  const Text_input& input() const { return input_; }

private:
  Text_input input_;
};

// Says which part of a line is the number: all of it.
struct Whole_line
{
  bool is_header(const Lines&) { return false; }
  std::string_view operator()(const Lines& lines) const { return trim(lines.text()); }
};

// Says which part of a line is the number: a column.
class Csv_column
{
public:
  explicit Csv_column(const std::string& column) : column_(column) {}

  // Finds the column in the first line, and returns whether that is one of names.
  bool is_header(const Lines& lines)
  {
    separator_ = find_separator(lines.text());
    const std::vector<std::string> cells = split(lines.text());
    if(column_.empty() && cells.size() > 1)
      lines.fail("there are " + std::to_string(cells.size())
                 + " columns; for --scalars, --column says which: " + list(cells));
    const bool is_number = parse_number(column_, place_) == std::errc();
    if(!column_.empty() && !is_number)
    {
      const auto number = std::count(cells.begin(), cells.end(), column_);
      if(number != 1)
        lines.fail((number == 0 ? "there is no column " : "there is more than one column ") + quote(column_) + " among "
                   + list(cells));
      place_ = static_cast<std::size_t>(std::find(cells.begin(), cells.end(), column_) - cells.begin());
      return true;
    }
    check_place(lines, cells);
    double ignored = 0;
    return parse_number(cells[place_], ignored) == std::errc::invalid_argument && !cells[place_].empty();
  }

  const std::string& operator()(const Lines& lines)
  {
    cells_ = trim(lines.text()).empty() ? std::vector<std::string>(place_ + 1) : split(lines.text());
    check_place(lines, cells_);
    return cells_[place_];
  }

private:
  static char find_separator(std::string_view text)
  {
    for(const char separator : {',', ';', '\t'})
      if(text.find(separator) != std::string_view::npos)
        return separator;
    return ',';
  }

  // The cells of a line, without the quotation marks around them; two within them stand for one. Behind other characters
  // of its cell, a quotation mark is one as they are.
  std::vector<std::string> split(std::string_view text) const
  {
    std::vector<std::string> cells(1);
    bool is_quoted = false, has_begun = false;
    for(std::size_t i = 0; i < text.size(); ++i)
      if(text[i] == '"' && is_quoted && i + 1 < text.size() && text[i + 1] == '"')
        cells.back() += text[++i];
      else if(text[i] == '"' && (is_quoted || !has_begun))
      {
        is_quoted = !is_quoted;
        has_begun = true;
      }
      else if(text[i] == separator_ && !is_quoted)
      {
        cells.emplace_back();
        has_begun = false;
      }
      else
      {
        cells.back() += text[i];
        has_begun = has_begun || !is_blank(text[i]);
      }
    for(std::string& cell : cells)
      cell = std::string(trim(cell));
    return cells;
  }

  void check_place(const Lines& lines, const std::vector<std::string>& cells) const
  {
    if(place_ >= cells.size())
      lines.fail("there is no column " + std::to_string(place_) + ": the line has " + std::to_string(cells.size())
                 + ", numbered from 0");
  }

  static std::string list(const std::vector<std::string>& cells)
  {
    std::string names;
    for(const std::string& cell : cells)
      names += (names.empty() ? "" : ", ") + cell;
    return quote(names);
  }

  std::string column_;
  std::size_t place_ = 0;
  char separator_ = ',';
  std::vector<std::string> cells_;
};

std::size_t count_lines(Text_input& input)
{
  Lines lines(input);
  std::size_t number = 0;
  while(lines.next())
    ++number;
  return number;
}

// Reads the numbers of a text that has so many lines of the file before it.
template <class Part_of_line>
std::vector<double> read_lines(Lines lines,
                               Part_of_line part,
                               std::size_t number_before,
                               std::size_t number_of_vertices)
{
  std::vector<double> scalars;
  while(lines.next())
    if(number_before + scalars.size() < number_of_vertices)
      scalars.push_back(lines.number(part(lines)));
    else if(!trim(lines.text()).empty()) // empty lines at the end only
      lines.fail("more values than the " + std::to_string(number_of_vertices) + " vertices of the mesh");
  return scalars;
}

template <class Part_of_line>
std::vector<double> read_parts(const std::string& path, Part_of_line part, std::size_t number_of_vertices)
{
  const File_contents file(path);
  Text_input input(path, file.text());
  Lines first(input);
  if(first.next() && part.is_header(first))
    input = first.input();
  const Text_blocks blocks(input);
  const std::vector<std::size_t> before = blocks.count_before(count_lines);
  std::vector<std::vector<double>> parts(blocks.size());
  run_tasks(blocks.size(),
            [&](std::size_t i) { parts[i] = read_lines(Lines(blocks.input(i)), part, before[i], number_of_vertices); });
  std::vector<double> scalars;
  for(std::vector<double>& numbers : parts)
    if(scalars.empty())
      scalars = std::move(numbers);
    else
      scalars.insert(scalars.end(), numbers.begin(), numbers.end());
  if(scalars.size() < number_of_vertices)
    throw Input_error(path, blocks.number_of_lines(),
                      "the file ends after " + std::to_string(scalars.size()) + " values for "
                        + std::to_string(number_of_vertices) + " vertices");
  return scalars;
}

} // namespace

std::vector<double> read_scalars(const std::string& path, const std::string& column, std::size_t number_of_vertices)
{
  if(lower_case_extension(path) == ".npy")
  {
    if(!column.empty())
      throw Input_error(path, "--column goes with CSV files only");
    return read_npy(path, number_of_vertices);
  }
  if(!column.empty() || lower_case_extension(path) == ".csv")
    return read_parts(path, Csv_column(column), number_of_vertices);
  return read_parts(path, Whole_line(), number_of_vertices);
}

void read_scalars(const std::string& path, const std::string& column, const Surface& surface, Scalar_map scalar_map)
{
  const std::vector<double> scalars = read_scalars(path, column, number_of_given_vertices(surface));
  for(std::size_t v = 0; v < scalars.size(); ++v)
    scalar_map[Surface::Vertex_index(static_cast<Surface::size_type>(v))] = scalars[v];
  set_added_vertices(surface, scalar_map);
}

namespace {
// A finite number, or one with a percent sign, perhaps behind a space.
bool read_number_or_percentage(std::string_view text, Threshold& threshold)
{
  threshold.is_percentage = !text.empty() && text.back() == '%';
  text.remove_suffix(threshold.is_percentage ? 1 : 0);
  text.remove_suffix(threshold.is_percentage && !text.empty() && text.back() == ' ' ? 1 : 0);
  return parse_number(text, threshold.number) == std::errc() && std::isfinite(threshold.number);
}

} // namespace

Threshold parse_size(const std::string& text)
{
  Threshold threshold;
  if(!read_number_or_percentage(text, threshold))
    throw std::runtime_error("the size '" + text + "' is neither a number nor a percentage: as 0.5 or 5%");
  if(threshold.number < 0)
    throw std::runtime_error("the size '" + text + "' is negative");
  return threshold;
}

Threshold parse_threshold(const std::string& text)
{
  Threshold threshold;
  threshold.is_suggested = text == "auto";
  if(threshold.is_suggested)
    return threshold;
  if(!read_number_or_percentage(text, threshold))
    throw std::runtime_error("the threshold '" + text
                             + "' is neither a number, nor a percentage, nor auto: as 0.5 or 5%");
  if(threshold.number < 0)
    throw std::runtime_error("the threshold '" + text + "' is negative");
  if(threshold.is_percentage && threshold.number > 100)
    throw std::runtime_error("the threshold '" + text + "' is more than the whole range of the field");
  return threshold;
}

namespace {
bool is_coordinate(const std::string& field) { return field == "x" || field == "y" || field == "z"; }

// The property of the vertices that is the field, empty if it is none.
std::string vertex_property(const Input_options& options)
{
  return is_coordinate(options.field) || is_computed(options.field) ? std::string() : options.field;
}

void read_field(const Input_options& options, const Surface& surface, Scalar_map scalar_map)
{
  if(!options.scalars_path.empty())
    read_scalars(options.scalars_path, options.column, surface, scalar_map);
  if(is_coordinate(options.field))
    for(const Surface::Vertex_index v : surface.vertices())
      scalar_map[v] = surface.point(v)[options.field[0] - 'x'];
}

// The map, with the field if it is read.
Scalar_map add_given_field(const Input_options& options, Surface& surface, Work_report& report)
{
  const Timed_step timed(report, "read");
  Scalar_map scalar_map = surface.add_property_map<Surface::Vertex_index, double>("v:scalar").first;
  read_field(options, surface, scalar_map);
  return scalar_map;
}

} // namespace

std::string describe_obstacle(const Mesh& mesh)
{
  const Complex& complex = *mesh.complex;
  const std::string obstacle = describe_obstacle(complex);
  if(mesh.findings.close_points.is_any())
  {
    const Close_points& points = mesh.findings.close_points;
    return obstacle + "; " + std::to_string(points.coinciding + points.close + points.on_edges)
         + " points of borders coincide with others, or nearly, or lie on edges: " + suggested_repair(points)
         + " joins them";
  }
  if(!complex.tetrahedra.empty() || complex.triangles.empty())
    return obstacle;
  return obstacle
       + (complex.edges.empty() ? "; reeb_graph repair --all makes a surface of it"
                                : "; reeb_graph repair leaves edges of no face out");
}

namespace {
void check_kind(const std::string& what, const Input_options& options, const Mesh& mesh)
{
  const std::string reason = reason_against(what, mesh);
  if(!reason.empty())
    throw Input_error(options.mesh_path, reason);
}
} // namespace

Mesh read_mesh(const Input_options& options, Work_report& report)
{
  const Timed_step timed(report, "read");
  const Progress_bar progress_bar("reading");
  check_field_options(options);
  Repair_options repair = all_repairs(options.least_share);
  repair.is_split = options.is_repaired;
  Mesh mesh = read_mesh(options.mesh_path, options.are_faces_triangulated, vertex_property(options), &repair,
                        options.is_border_taken);
  report.notes.insert(report.notes.end(), mesh.notes.begin(), mesh.notes.end());
  report.input = mesh.findings;
  report.repair = mesh.repair;
  if(mesh.repair)
  {
    std::ostringstream command;
    command << "reeb_graph repair " << name_of_input(options.mesh_path)
            << (mesh.repair->given.is_surface() ? "" : " --all");
    if(options.least_share > 0)
      command << " --least-piece " << options.least_share;
    command << (options.are_faces_triangulated ? " --triangulate" : "") << " --output repaired.ply";
    report.repair_command = command.str();
  }
  check_kind("the field " + options.field, options, mesh);
  return mesh;
}

Surface read_surface(const std::string& command, const Input_options& options, Work_report& report)
{
  Mesh mesh = read_mesh(options, report);
  check_kind(command, options, mesh);
  return std::move(mesh.surface);
}

Scalar_map add_field(const Input_options& options, Surface& surface, Work_report& report)
{
  Scalar_map scalar_map = add_given_field(options, surface, report);
  if(is_computed(options.field))
  {
    const Timed_step timed(report, "field");
    compute_scalar_field(options, surface, scalar_map, report);
  }
  return scalar_map;
}

Scalar_map add_field(const Input_options& options, Mesh& mesh, Work_report& report)
{
  if(!mesh.complex || options.field != "geodesic")
    return add_field(options, mesh.surface, report);
  Scalar_map scalar_map = add_given_field(options, mesh.surface, report);
  const Timed_step timed(report, "field");
  report.fixed_values = Fixed_values{options.field, {}, {}};
  for(const std::size_t source : compute_distances_along_edges(mesh, options, scalar_map, report))
    report.fixed_values->vertices.push_back({source, 0});
  return scalar_map;
}

Field_label field_label(const Input_options& options, const std::string& unit)
{
  if(!options.field.empty())
    return {options.field, unit};
  const bool is_column_named = options.column.find_first_not_of("0123456789") != std::string::npos;
  return {is_column_named ? options.column : std::filesystem::path(name_of_input(options.scalars_path)).stem().string(),
          unit};
}

} // namespace reeb_graph_program
