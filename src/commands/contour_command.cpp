// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of the CGAL-style package Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#include "commands/commands.h"
#include "computation/augmentation.h"
#include "input/field_input.h"
#include "output/polylines_output.h"
#include "output/report_output.h"

#include <iostream>
#include <sstream>
#include <stdexcept>
#include <vector>

namespace reeb_graph_program {
void run_contour(const Contour_options& options)
{
  check_polylines_format(options.output_path);
  check_simplification_options(options.choice.simplification);
  Work_report report;
  Surface surface = read_surface(options.input, report);
  const Scalar_map scalar_map = add_field(options.input, surface, report);
  const std::vector<Polyline> polylines = find_contours(surface, scalar_map, options.choice);
  if(polylines.empty())
  {
    std::ostringstream message;
    message << "there is no contour at the level " << options.choice.level;
    throw std::runtime_error(message.str());
  }
  write_polylines(options.output_path, polylines);
  std::cout << polylines.size() << (polylines.size() == 1 ? " contour\n" : " contours\n");
  write_field_text(std::cout, report);
}

} // namespace reeb_graph_program
