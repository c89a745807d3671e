// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_SRC_COMPARISON_OUTPUT_H
#define CGAL_REEB_GRAPH_SRC_COMPARISON_OUTPUT_H

#include "base/report.h"
#include "computation/comparison.h"

#include <filesystem>
#include <iosfwd>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace reeb_graph_program {
// What has been found of shapes: of two, also which arcs are partners.
struct Comparison_report : Work_report
{
  std::vector<std::string> names;
  std::vector<Report> shapes;
  std::string field;
  std::vector<std::vector<double>> distances;               // a row for each shape
  std::vector<std::pair<std::string, double>> by_kind = {}; // of two shapes, by kinds of pairs
  std::optional<Partners> partners = std::nullopt;
  std::optional<bool> are_sources_on_partners = std::nullopt; // where each of two shapes has one
};

void write_text(std::ostream& out, const Comparison_report& report);
void write_json(std::ostream& out, const Comparison_report& report);

// Throws std::runtime_error unless the file name ends in .csv.
void check_matrix_format(const std::filesystem::path& path);

// Writes the distances, with names of rows and columns.
void write_matrix(const std::filesystem::path& path, const Comparison_report& report);

} // namespace reeb_graph_program

#endif // CGAL_REEB_GRAPH_SRC_COMPARISON_OUTPUT_H
