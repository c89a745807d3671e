// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of the CGAL-style package Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#include "augmentation.h"
#include "commands.h"
#include "field_input.h"
#include "output_file.h"

#include <iostream>
#include <limits>
#include <sstream>
#include <stdexcept>
#include <string>

namespace reeb_graph_program {
namespace {
const std::string polylines_ending = ".polylines.txt";

void check_polylines_format(const std::string& path)
{
  if(path.size() <= polylines_ending.size()
     || path.compare(path.size() - polylines_ending.size(), polylines_ending.size(), polylines_ending) != 0)
    throw std::runtime_error(path + ": the file name of polylines ends in " + polylines_ending);
}

std::vector<Polyline> find_contours(const Contour_options& options)
{
  Surface surface = read_surface(options.input);
  const Scalar_map scalar_map = add_field(options.input, surface);
  if(options.arc)
    return contour_of_arc(surface, scalar_map, options.graph, *options.arc, options.t);
  const auto polylines = contours_at_level(surface, scalar_map, options.graph, options.level);
  if(polylines.empty())
  {
    std::ostringstream message;
    message << "there is no contour at the level " << options.level;
    throw std::runtime_error(message.str());
  }
  return polylines;
}

// The polylines format of CGAL: the number of points, and their coordinates.
void write_polylines(const std::string& path, const std::vector<Polyline>& polylines)
{
  write_file(path, [&](std::ostream& stream) {
    stream.precision(std::numeric_limits<double>::max_digits10);
    for(const Polyline& polyline : polylines)
    {
      stream << polyline.size();
      for(const Point& point : polyline)
        stream << ' ' << point;
      stream << '\n';
    }
  });
}

} // namespace

void run_contour(const Contour_options& options)
{
  check_polylines_format(options.output_path);
  const std::vector<Polyline> polylines = find_contours(options);
  write_polylines(options.output_path, polylines);
  std::cout << polylines.size() << (polylines.size() == 1 ? " contour\n" : " contours\n");
}

} // namespace reeb_graph_program
