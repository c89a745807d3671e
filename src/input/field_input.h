// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_SRC_FIELD_INPUT_H
#define CGAL_REEB_GRAPH_SRC_FIELD_INPUT_H

#include "base/options.h"
#include "base/report.h"
#include "base/surface.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace reeb_graph_program {
// Reads the mesh, and the field if it is a property of its vertices. Throws Input_error, and std::runtime_error if the
// options do not fit together, or there is no such field on a complex. The time goes into the report.
Mesh read_mesh(const Input_options& options, Work_report& report);

// The same for a command that needs an oriented manifold surface.
Surface read_surface(const std::string& command, const Input_options& options, Work_report& report);

// Why the mesh is not an oriented manifold surface, and what repairs it.
std::string describe_obstacle(const Mesh& mesh);

// How the field is called in the input: by its name, or by that of its column or file.
Field_label field_label(const Input_options& options, const std::string& unit);

// Adds the field to the surface that has been read, and tells the report what it took. Throws Input_error,
// std::runtime_error, and the exceptions of the library.
Scalar_map add_field(const Input_options& options, Surface& surface, Work_report& report);
Scalar_map add_field(const Input_options& options, Mesh& mesh, Work_report& report);

// Reads one number per line, whatever the locale, or a column of a CSV file, which is one if its name ends in .csv or
// if a column is given: by its number, from 0, or by its name in the first line. The column is not needed if there is
// only one. Lines that begin with # are comments. Throws Input_error unless there are as many numbers as vertices.
std::vector<double> read_scalars(const std::string& path, const std::string& column, std::size_t number_of_vertices);

// The same for the vertices of a surface, of which a repair may have added some.
void read_scalars(const std::string& path, const std::string& column, const Surface& surface, Scalar_map scalar_map);

// Reads a threshold: a number that is not negative, a percentage, P%, or auto. Throws std::runtime_error.
Threshold parse_threshold(const std::string& text);

// Reads a length: a number that is not negative, or a percentage of another length, P%. Throws std::runtime_error.
Threshold parse_size(const std::string& text);

// What is not for each kind of mesh: a command, an option, or a field, and whether it takes triangles that are no oriented
// manifold surface, tetrahedra, and both together. The manual has the same table.
struct Limit
{
  std::string_view what;
  bool takes_triangles, takes_tetrahedra, takes_both;
  std::string_view why; // if it is not that it needs a surface
};

constexpr std::string_view no_surface = "the mesh is not an oriented manifold surface";

constexpr std::array<Limit, 12> limits = {{
  {"compare", false, false, false, no_surface},
  {"curves", false, false, false, no_surface},
  {"handles", false, false, false, no_surface},
  {"skeleton", false, false, false, no_surface},
  {"--html", false, false, false, ""},
  {"--simplified-scalars", false, false, false, ""},
  {"the field harmonic", false, false, false, ""},
  {"the field harmonic-between-borders", false, false, false, ""},
  {"the field poisson", false, false, false, ""},
  {"the field unit-gradient", false, false, false, ""},
  {"--mesh-out", true, false, false,
   "--mesh-out writes triangles, and the mesh has tetrahedra: --vertex-arcs writes where each vertex belongs"},
  {"contour", true, true, false,
   "there are triangles that are faces of no tetrahedron: contours of such a mesh are neither polylines nor triangles"},
}};

// Why that is not for the mesh; nothing if it is.
inline std::string reason_against(std::string_view what, const Mesh& mesh)
{
  const auto limit = std::find_if(limits.begin(), limits.end(), [&](const Limit& l) { return l.what == what; });
  if(!mesh.complex || limit == limits.end()
     || (mesh.complex->has_triangles_and_tetrahedra() ? limit->takes_both
         : mesh.complex->tetrahedra.empty()           ? limit->takes_triangles
                                                      : limit->takes_tetrahedra))
    return "";
  if(!limit->why.empty() && limit->why != no_surface)
    return std::string(limit->why);
  if(mesh.complex->triangles.empty() && mesh.complex->tetrahedra.empty())
    return std::string(what) + " needs faces, and the mesh has lines alone";
  return (limit->why.empty() ? std::string(what) + " needs an oriented manifold surface" : std::string(limit->why))
       + "; " + describe_obstacle(mesh);
}

} // namespace reeb_graph_program

#endif // CGAL_REEB_GRAPH_SRC_FIELD_INPUT_H
