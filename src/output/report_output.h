// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_SRC_REPORT_OUTPUT_H
#define CGAL_REEB_GRAPH_SRC_REPORT_OUTPUT_H

#include "base/report.h"
#include "output/output_file.h"

#include <nlohmann/json.hpp>

#include <cmath>
#include <cstddef>
#include <filesystem>
#include <iterator>
#include <limits>
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

namespace reeb_graph_program {
// The number of values of a field, and where those that are no NaN lie.
struct Field_range
{
  template <class Iterator>
  Field_range(Iterator begin, Iterator end) : number_of_values(static_cast<std::size_t>(std::distance(begin, end)))
  {
    for(; begin != end; ++begin)
    {
      lowest = std::fmin(lowest, *begin); // which leave NaN out
      highest = std::fmax(highest, *begin);
    }
  }

  std::size_t number_of_values;
  double lowest = std::numeric_limits<double>::quiet_NaN(), highest = std::numeric_limits<double>::quiet_NaN();
};

// The number of contours that have been written.
struct Contours_report : Work_report
{
  std::size_t contours = 0;
};

// The report of a graph.
void write_text(std::ostream& out, const Report& report);
void write_json(std::ostream& out, const Report& report);

void write_text(std::ostream& out, const Contours_report& report);
void write_json(std::ostream& out, const Contours_report& report);

void write_text(std::ostream& out, const Curves_report& report);
void write_json(std::ostream& out, const Curves_report& report);

// The list of loops.
void write_text(std::ostream& out, const Handles_report& report);
void write_json(std::ostream& out, const Handles_report& report);

// The report of a field alone.
void write_text(std::ostream& out, const Field_range& range, const Work_report& report);
void write_json(std::ostream& out, const Field_range& range, const Work_report& report);

// Writes the report to standard output, or to standard error if a file is written there.
template <class... Report_parts>
void write_report(bool is_json, const std::vector<std::filesystem::path>& outputs, const Report_parts&... parts)
{
  std::ostream& stream = report_stream(outputs);
  if(is_json)
    write_json(stream, parts...);
  else
    write_text(stream, parts...);
}

// What is said of the mesh by all commands, as far as it applies: lines of faces of the file that are left out, of isolated
// points, and of those that repair merges, and notes.
void write_input_text(std::ostream& out, const Work_report& report);

// The report of a repaired mesh.
void write_text(std::ostream& out, const Repair_report& report);
void write_json(std::ostream& out, const Repair_report& report);

// Lines of where a field has its values from, and of what was done about bad faces, as far as they apply.
void write_field_text(std::ostream& out, const Work_report& report);

// Tells how the field has been changed, if it has.
void write_border_changes(std::ostream& out, const CGAL::Reeb_graph::Border_level_changes& changes);

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

// The counts of a mesh, but for places where it is no surface.
void write_counts(std::ostream& out, const std::string& title, const Mesh_counts& counts);
nlohmann::ordered_json json_of(const Mesh_counts& counts);

// Writes the report and a line end. Names of files and fields may be no UTF-8, which JSON has to be.
void write_line(std::ostream& out, const nlohmann::ordered_json& json);

// What a repair has done, but for what it was given and has made.
void write_steps(std::ostream& out, const Repair_counts& counts);
void add_steps(nlohmann::ordered_json& json, const Repair_counts& counts);

// Adds what the reports of all commands have in common, and writes the report.
void add_field_and_costs(nlohmann::ordered_json& json, const Work_report& report);
void write_with_costs(std::ostream& out, nlohmann::ordered_json json, const Work_report& report);

} // namespace reeb_graph_program

#endif // CGAL_REEB_GRAPH_SRC_REPORT_OUTPUT_H
