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

#include <algorithm>
#include <cstddef>
#include <filesystem>
#include <iterator>
#include <limits>
#include <ostream>
#include <vector>

namespace reeb_graph_program {
// The number of values of a field, and where they lie.
struct Field_range
{
  template <class Iterator>
  Field_range(Iterator begin, Iterator end) : number_of_values(static_cast<std::size_t>(std::distance(begin, end)))
  {
    if(begin != end)
    {
      const auto extrema = std::minmax_element(begin, end);
      lowest = *extrema.first;
      highest = *extrema.second;
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

} // namespace reeb_graph_program

#endif // CGAL_REEB_GRAPH_SRC_REPORT_OUTPUT_H
