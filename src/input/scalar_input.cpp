// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#include "input/scalar_input.h"

#include "input/File_contents.h"
#include "input/input_error.h"
#include "input/npy_input.h"
#include "input/text_blocks.h"
#include "input/text_input.h"

#include <algorithm>
#include <string_view>
#include <system_error>
#include <utility>

namespace reeb_graph_program {
namespace {
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
      lines.fail("there are " + std::to_string(cells.size()) + " columns; --column is to say which: " + list(cells));
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

} // namespace reeb_graph_program
