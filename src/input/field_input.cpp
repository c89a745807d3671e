// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#include "input/field_input.h"

#include "base/costs.h"
#include "base/progress_bar.h"
#include "base/vertex_properties.h"
#include "computation/complex_counts.h"
#include "computation/scalar_fields.h"
#include "input/input_error.h"
#include "input/limits_of_kinds.h"
#include "input/mesh_formats.h"
#include "input/scalar_input.h"

#include <filesystem>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace reeb_graph_program {
namespace {
bool is_coordinate(const std::string& field) { return field == "x" || field == "y" || field == "z"; }

// The property of the vertices that is the field, empty if it is none.
std::string vertex_property(const Input_options& options)
{
  return is_coordinate(options.field) || is_computed(options.field) ? std::string() : options.field;
}

void read_field(const Input_options& options, const Surface& surface, Scalar_map scalar_map)
{
  if(!options.scalars_path.empty())
  {
    const std::vector<double> scalars =
      read_scalars(options.scalars_path, options.column, number_of_given_vertices(surface));
    for(std::size_t v = 0; v < scalars.size(); ++v)
      scalar_map[Surface::Vertex_index(static_cast<Surface::size_type>(v))] = scalars[v];
    set_added_vertices(surface, scalar_map);
  }
  if(is_coordinate(options.field))
    for(const Surface::Vertex_index v : surface.vertices())
      scalar_map[v] = surface.point(v)[options.field[0] - 'x'];
}

// The map, with the field if it is read.
Scalar_map add_given_field(const Input_options& options, Surface& surface, Work_report& report)
{
  const Stopwatch stopwatch;
  Scalar_map scalar_map = surface.add_property_map<Surface::Vertex_index, double>("v:scalar").first;
  read_field(options, surface, scalar_map);
  report.add_seconds("read", stopwatch.seconds());
  return scalar_map;
}

} // namespace

std::string describe_obstacle(const Mesh& mesh)
{
  const Complex& complex = *mesh.complex;
  const std::string obstacle = describe_obstacle(complex);
  if(mesh.findings.close_points.is_any())
    return obstacle + "; " + std::to_string(mesh.findings.close_points.coinciding + mesh.findings.close_points.close)
         + " points of borders coincide with others, or nearly: " + suggested_repair(mesh.findings.close_points)
         + " merges them";
  if(!complex.tetrahedra.empty())
    return obstacle;
  return obstacle
       + (complex.edges.empty() ? "; reeb_graph repair --all makes a surface of it"
                                : "; reeb_graph repair leaves edges of no face out");
}

namespace {
void check_kind(const std::string& what, const Input_options& options, const Mesh& mesh)
{
  const std::string reason = reason_against(what, mesh);
  if(!reason.empty())
    throw Input_error(options.mesh_path, reason);
}
} // namespace

Mesh read_mesh(const Input_options& options, Work_report& report)
{
  const Stopwatch stopwatch;
  const Progress_bar progress_bar("reading");
  check_field_options(options);
  Repair_options repair = all_repairs(options.least_share);
  repair.is_split = options.is_repaired;
  Mesh mesh = read_mesh(options.mesh_path, options.are_faces_triangulated, vertex_property(options), &repair);
  report.add_seconds("read", stopwatch.seconds());
  report.notes.insert(report.notes.end(), mesh.notes.begin(), mesh.notes.end());
  report.input = mesh.findings;
  report.repair = mesh.repair;
  if(mesh.repair)
  {
    std::ostringstream command;
    command << "reeb_graph repair " << name_of_input(options.mesh_path)
            << (mesh.repair->given.is_surface() ? "" : " --all");
    if(options.least_share > 0)
      command << " --least-piece " << options.least_share;
    command << (options.are_faces_triangulated ? " --triangulate" : "") << " --output repaired.ply";
    report.repair_command = command.str();
  }
  check_kind("the field " + options.field, options, mesh);
  return mesh;
}

Surface read_surface(const std::string& command, const Input_options& options, Work_report& report)
{
  Mesh mesh = read_mesh(options, report);
  check_kind(command, options, mesh);
  return std::move(mesh.surface);
}

Scalar_map add_field(const Input_options& options, Surface& surface, Work_report& report)
{
  Scalar_map scalar_map = add_given_field(options, surface, report);
  if(is_computed(options.field))
  {
    const Stopwatch field_stopwatch;
    compute_scalar_field(options, surface, scalar_map, report);
    report.add_seconds("field", field_stopwatch.seconds());
  }
  return scalar_map;
}

Scalar_map add_field(const Input_options& options, Mesh& mesh, Work_report& report)
{
  if(!mesh.complex || options.field != "geodesic")
    return add_field(options, mesh.surface, report);
  Scalar_map scalar_map = add_given_field(options, mesh.surface, report);
  const Stopwatch field_stopwatch;
  report.fixed_values = Fixed_values{options.field, {}, {}};
  for(const std::size_t source : compute_distances_along_edges(mesh, options.source_vertices, scalar_map))
    report.fixed_values->vertices.push_back({source, 0});
  report.add_seconds("field", field_stopwatch.seconds());
  return scalar_map;
}

Field_label field_label(const Input_options& options, const std::string& unit)
{
  if(!options.field.empty())
    return {options.field, unit};
  const bool is_column_named = options.column.find_first_not_of("0123456789") != std::string::npos;
  return {is_column_named ? options.column : std::filesystem::path(name_of_input(options.scalars_path)).stem().string(),
          unit};
}

} // namespace reeb_graph_program
