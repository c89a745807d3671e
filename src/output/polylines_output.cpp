// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of the CGAL-style package Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#include "output/polylines_output.h"

#include "output/output_file.h"

#include <CGAL/IO/OFF.h>
#include <CGAL/Reeb_graph/IO/polylines.h>

#include <limits>
#include <ostream>

namespace reeb_graph_program {
void check_polylines_format(const std::string& path) { ending_of(path, "polylines", {".polylines.txt"}); }

void check_contour_format(const std::string& path) { ending_of(path, "contours", {".polylines.txt", ".off"}); }

void check_contour_format(const std::string& path, bool are_contours_surfaces)
{
  if(are_contours_surfaces)
    ending_of(path, "contours in tetrahedra, which are surfaces,", {".off"});
  else
    check_polylines_format(path);
}

void write_triangles(const std::string& path,
                     const std::vector<Point>& points,
                     const std::vector<std::array<std::size_t, 3>>& triangles)
{
  write_file(path, [&](std::ostream& stream) {
    const int precision = std::numeric_limits<double>::max_digits10;
    CGAL::IO::write_OFF(stream, points, triangles, CGAL::parameters::stream_precision(precision));
  });
}

void write_polylines(const std::string& path, const std::vector<Polyline>& polylines)
{
  write_file(path, [&](std::ostream& stream) { CGAL::Reeb_graph::write_polylines(stream, polylines); });
}

} // namespace reeb_graph_program
