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

#include <cmath>
#include <cstddef>
#include <optional>
#include <ostream>
#include <string>

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

// A number, or null, which also stands for infinity.
inline nlohmann::ordered_json json_number(const std::optional<double>& number)
{
  return number && std::isfinite(*number) ? nlohmann::ordered_json(*number) : nlohmann::ordered_json();
}

// Writes the report and a line end. Names of files and fields may be no UTF-8, which JSON has to be.
void write_line(std::ostream& out, const nlohmann::ordered_json& json);

void add_field_and_costs(nlohmann::ordered_json& json, const Work_report& report);

} // namespace reeb_graph_program

#endif // CGAL_REEB_GRAPH_SRC_REPORT_PARTS_H
