// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#include "mpi/local_input.h"

#include "input/text_input.h"
#include "mpi/local_files.h"

#include <CGAL/Reeb_graph/fields/exceptions.h>

#include <cmath>
#include <stdexcept>

namespace reeb_graph_program {
namespace {
bool is_coordinate(const std::string& field) { return field == "x" || field == "y" || field == "z"; }

} // namespace

Field_of_point field_of_point(const Input_options& options)
{
  if(is_coordinate(options.field))
    return [i = options.field[0] - 'x'](const Point& point) { return point[i]; };
  if(options.field != "height")
    return {};
  std::vector<double> d = options.direction;
  if(d.empty())
    d = {0, 0, 1};
  if(!std::isfinite(d[0]) || !std::isfinite(d[1]) || !std::isfinite(d[2]) || (d[0] == 0 && d[1] == 0 && d[2] == 0))
    throw CGAL::Reeb_graph::Parameter_error("the direction is zero, or not finite");
  return [d](const Point& p) { return d[0] * p.x() + d[1] * p.y() + d[2] * p.z(); };
}

Local_mesh read_local_mesh(const Communicator& communicator, const Input_options& options)
{
  const std::string extension = lower_case_extension(options.mesh_path);
  if(extension == ".raw")
  {
    if(!options.field.empty())
      throw std::runtime_error("--field does not go with a raw file, which has the values of one field");
    return read_local_raw(communicator, options.mesh_path);
  }
  if(extension != ".ply")
    throw Input_error(options.mesh_path, "ranks share binary .ply files, and .raw files");
  if(options.field.empty())
    throw std::runtime_error("a field is needed, such as --field z");
  const Field_of_point of_point = field_of_point(options);
  return read_local_ply(communicator, options.mesh_path, {of_point, of_point ? std::string() : options.field});
}

} // namespace reeb_graph_program
