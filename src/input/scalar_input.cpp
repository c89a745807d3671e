// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of the CGAL-style package Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#include "input/scalar_input.h"

#include "input/input_error.h"
#include "input/text_input.h"

#include <fstream>
#include <string_view>
#include <system_error>

namespace reeb_graph_program {
namespace {
std::string_view trim(std::string_view text)
{
  const char* const blanks = " \t\r\v\f";
  const std::size_t first = text.find_first_not_of(blanks);
  return first == std::string_view::npos ? std::string_view()
                                         : text.substr(first, text.find_last_not_of(blanks) + 1 - first);
}

double parse_scalar(const std::string& path, std::size_t line, std::string_view text)
{
  double value = 0;
  const std::errc error = parse_number(text, value);
  if(error == std::errc::result_out_of_range)
    throw Input_error(path, line, "'" + std::string(text) + "' is too large or too small for a double");
  if(error != std::errc())
    throw Input_error(path, line, "'" + std::string(text) + "' is not a number");
  return value;
}

} // namespace

std::vector<double> read_scalars(const std::string& path, std::size_t number_of_vertices)
{
  std::ifstream file(path);
  if(!file)
    throw Input_error(path, "the file cannot be read");
  std::vector<double> scalars;
  std::string text;
  std::size_t line = 0;
  while(std::getline(file, text))
  {
    ++line;
    if(scalars.size() == number_of_vertices)
    {
      if(trim(text).empty())
        continue; // at the end only
      throw Input_error(path, line,
                        "more values than the " + std::to_string(number_of_vertices) + " vertices of the mesh");
    }
    scalars.push_back(parse_scalar(path, line, trim(text)));
  }
  if(file.bad())
    throw Input_error(path, "the file cannot be read");
  if(scalars.size() < number_of_vertices)
    throw Input_error(path, line,
                      "the file ends after " + std::to_string(scalars.size()) + " values for "
                        + std::to_string(number_of_vertices) + " vertices");
  return scalars;
}

} // namespace reeb_graph_program
