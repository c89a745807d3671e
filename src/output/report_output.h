// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of the CGAL-style package Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_SRC_REPORT_OUTPUT_H
#define CGAL_REEB_GRAPH_SRC_REPORT_OUTPUT_H

#include "base/report.h"

#include <ostream>

namespace reeb_graph_program {
void write_text(std::ostream& out, const Report& report);
void write_json(std::ostream& out, const Report& report);

void write_text(std::ostream& out, const Curves_report& report);
void write_json(std::ostream& out, const Curves_report& report);

// Tells how the field has been changed, if it has.
void write_border_changes(std::ostream& out, const CGAL::Reeb_graph::Border_level_changes& changes);

} // namespace reeb_graph_program

#endif // CGAL_REEB_GRAPH_SRC_REPORT_OUTPUT_H
