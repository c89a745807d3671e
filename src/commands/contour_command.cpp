// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of the CGAL-style package Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#include "base/complex.h"
#include "commands/commands.h"
#include "computation/Mesh_graph.h"
#include "computation/simplification.h"
#include "input/field_input.h"
#include "input/input_error.h"
#include "output/output_file.h"
#include "output/polylines_output.h"
#include "output/report_output.h"

#include <ostream>
#include <sstream>
#include <stdexcept>

namespace reeb_graph_program {
namespace {
void check_is_there(bool is_any_there, double level)
{
  if(is_any_there)
    return;
  std::ostringstream message;
  message << "there is no contour at the level " << level;
  throw std::runtime_error(message.str());
}
} // namespace

void run_contour(const Contour_options& options)
{
  check_contour_format(options.output_path);
  check_outputs({options.output_path}, input_files(options.input));
  check_simplification_options(options.choice.simplification);
  Report report;
  Mesh mesh = read_mesh(options.input, report);
  if(mesh.complex && mesh.complex->has_triangles_and_tetrahedra())
    throw Input_error(options.input.mesh_path, "there are triangles that are faces of no tetrahedron: contours of such "
                                               "a mesh are neither polylines nor triangles");
  const bool has_tetrahedra = mesh.complex && !mesh.complex->tetrahedra.empty();
  check_contour_format(options.output_path, has_tetrahedra);
  const Scalar_map scalar_map = add_field(options.input, mesh, report);
  const Contour_choice& choice = options.choice;
  const Contours contours =
    compute_mesh_graph(mesh, scalar_map, choice.graph, choice.simplification,
                       threshold_in_units(choice.simplification, mesh.surface, scalar_map), report)
      ->find_contours(choice);
  check_is_there(contours.number > 0, choice.level);
  if(has_tetrahedra)
    write_triangles(options.output_path, contours.points, contours.triangles);
  else
    write_polylines(options.output_path, contours.polylines);
  std::ostream& stream = report_stream({options.output_path});
  stream << contours.number << (contours.number == 1 ? " contour\n" : " contours\n");
  write_field_text(stream, report);
}

} // namespace reeb_graph_program
