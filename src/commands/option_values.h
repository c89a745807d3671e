// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_SRC_OPTION_VALUES_H
#define CGAL_REEB_GRAPH_SRC_OPTION_VALUES_H

#include "input/input_error.h"
#include "input/text_input.h"

#include <CLI/CLI.hpp>

#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <limits>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>
#include <vector>

// Options whose values are numbers, read as those in files. CLI11 by itself wraps what is negative or too large around,
// takes a 0 in front for octal, and names bounds of hundreds of digits.
namespace reeb_graph_program {
struct Whole_number_bounds
{
  std::size_t lowest = 0, highest = (std::numeric_limits<std::size_t>::max)();
};

inline std::size_t parse_whole_number(const std::string& option, const std::string& text, Whole_number_bounds bounds)
{
  const bool is_negative = text.size() > 1 && text[0] == '-';
  std::size_t number = 0;
  const std::errc error = parse_number(std::string_view(text).substr(is_negative ? 1 : 0), number);
  const bool is_too_large = error == std::errc::result_out_of_range;
  if(error != std::errc() && !is_too_large)
    throw CLI::ValidationError(option, quote(text) + " is not a whole number");
  if(is_negative ? is_too_large || number != 0 || bounds.lowest > 0 : !is_too_large && number < bounds.lowest)
    throw CLI::ValidationError(option, quote(text) + " is less than " + std::to_string(bounds.lowest));
  if(is_too_large || number > bounds.highest)
    throw CLI::ValidationError(option, quote(text) + " is more than " + std::to_string(bounds.highest));
  return number;
}

inline double parse_real_number(const std::string& option, const std::string& text)
{
  double number = 0;
  std::errc error = parse_number(text, number);
  if(error == std::errc::result_out_of_range)
  {
    number = std::strtod(text.c_str(), nullptr);
    if(!(std::abs(number) < 1))
      throw CLI::ValidationError(option, quote(text) + " is too large");
  }
  else if(error != std::errc())
    throw CLI::ValidationError(option, quote(text) + " is not a number");
  return number;
}

template <class Variable>
CLI::Option* add_whole_number(CLI::App& command,
                              const std::string& name,
                              Variable& variable,
                              const std::string& description,
                              Whole_number_bounds bounds = {})
{
  const auto set = [&variable, name, bounds](const std::string& text) {
    variable = parse_whole_number(name, text, bounds);
  };
  return command.add_option_function<std::string>(name, set, description)->type_name("UINT");
}

template <class Variable>
CLI::Option* add_real_number(CLI::App& command,
                             const std::string& name,
                             Variable& variable,
                             const std::string& description)
{
  const auto set = [&variable, name](const std::string& text) { variable = parse_real_number(name, text); };
  return command.add_option_function<std::string>(name, set, description)->type_name("FLOAT");
}

// Numbers with commas between them.
template <class Number, class Parse>
CLI::Option* add_numbers(CLI::App& command,
                         const std::string& name,
                         std::vector<Number>& variable,
                         const std::string& description,
                         const Parse& parse)
{
  const auto set = [&variable, name, parse](const std::vector<std::string>& texts) {
    variable.clear();
    for(const std::string& text : texts)
      variable.push_back(parse(name, text));
  };
  return command.add_option_function<std::vector<std::string>>(name, set, description)->delimiter(',');
}

// Names, each of which stands for a value, and an option that takes one of them.
template <class Value>
using Choices = std::vector<std::pair<std::string, Value>>;

template <class Variable, class Value>
CLI::Option* add_choice(CLI::App& command,
                        const std::string& name,
                        Variable& variable,
                        const Choices<Value>& choices,
                        const std::string& description)
{
  std::vector<std::string> names;
  for(const auto& choice : choices)
    names.push_back(choice.first);
  const auto set = [&variable, choices](const std::string& chosen) {
    for(const auto& [name_of_value, value] : choices)
      if(name_of_value == chosen)
        variable = value;
  };
  return command.add_option_function<std::string>(name, set, description)->check(CLI::IsMember(names));
}

// A number that can be given several times.
inline void add_values(CLI::App& command,
                       const std::string& name,
                       std::vector<double>& values,
                       const std::string& description)
{
  const auto add = [&values, name](const std::vector<std::string>& texts) {
    for(const std::string& text : texts)
      values.push_back(parse_real_number(name, text));
  };
  command.add_option_function<std::vector<std::string>>(name, add, description)
    ->type_name("FLOAT")
    ->allow_extra_args(false);
}

// Names of files, and of fields, of which an empty one is a mistake, such as a variable of a script that is not set.
inline CLI::Validator is_not_empty()
{
  return CLI::Validator([](const std::string& name) { return name.empty() ? "it is empty" : ""; }, "");
}

template <class Path>
CLI::Option* add_file(CLI::App& command, const std::string& name, Path& path, const std::string& description)
{
  return command.add_option(name, path, description)->check(is_not_empty());
}

// --output, which takes one file or several. The last of several is the mesh if no other one is named.
inline CLI::Option* add_output_files(CLI::App& command, std::vector<std::string>& paths, const std::string& description)
{
  CLI::Option* const mesh = command.get_option("MESH");
  const auto set = [&paths, mesh](const std::vector<std::string>& given) {
    paths = given;
    if(mesh->count() > 0 || paths.size() < 2)
      return;
    mesh->add_result(paths.back());
    mesh->run_callback();
    paths.pop_back();
  };
  return command.add_option_function<std::vector<std::string>>("--output", set, description)
    ->type_name("FILE")
    ->check(is_not_empty());
}

} // namespace reeb_graph_program

#endif // CGAL_REEB_GRAPH_SRC_OPTION_VALUES_H
