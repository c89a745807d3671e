// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_SRC_REPORT_PARTS_H
#define CGAL_REEB_GRAPH_SRC_REPORT_PARTS_H

#include "base/report.h"

#include <nlohmann/json.hpp>

#include <cstddef>
#include <optional>
#include <ostream>
#include <string>
#include <vector>

// What may be missing is null, as numbers are that are not finite.
template <class T>
struct nlohmann::adl_serializer<std::optional<T>>
{
  template <class Json>
  static void to_json(Json& json, const std::optional<T>& value)
  {
    json = value ? Json(*value) : Json();
  }
};

// What reports have in common.
namespace reeb_graph_program {
inline std::string count(std::size_t number, const std::string& singular, const std::string& plural)
{
  return std::to_string(number) + " " + (number == 1 ? singular : plural);
}

inline std::string count(std::size_t number, const std::string& singular)
{
  return count(number, singular, singular + "s");
}

// The first number of a list, if there is one.
inline std::optional<std::size_t> first_of(const std::vector<std::size_t>& numbers)
{
  return numbers.empty() ? std::nullopt : std::make_optional(numbers.front());
}

// Writes the report and a line end. Names of files and fields may be no UTF-8, which JSON has to be.
void write_line(std::ostream& out, const nlohmann::ordered_json& json);

// What a repair has done, but for what it was given and has made.
void write_steps(std::ostream& out, const Repair_counts& counts);
void add_steps(nlohmann::ordered_json& json, const Repair_counts& counts);

void add_field_and_costs(nlohmann::ordered_json& json, const Work_report& report);

} // namespace reeb_graph_program

#endif // CGAL_REEB_GRAPH_SRC_REPORT_PARTS_H
