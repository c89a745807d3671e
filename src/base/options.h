// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_SRC_OPTIONS_H
#define CGAL_REEB_GRAPH_SRC_OPTIONS_H

#include "base/standard_input.h"

#include <CGAL/Reeb_graph/named_parameters.h>

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace reeb_graph_program {
// The mesh and the field that it carries.
struct Input_options
{
  std::string mesh_path;    // - for standard input, as below
  std::string scalars_path; // the field, or the one whose unit gradient field is taken; may be empty
  std::string column;       // of the file of scalars, by its name or number; empty if there is only one
  // x, y, z, a name of scalar_fields.h, or a property of the vertices of the file; empty if the field is that of the
  // file of scalars
  std::string field;
  std::string weights; // of harmonic fields: mean-value, cotangent, or uniform; empty for the default
  std::optional<std::size_t> lowest_vertex, highest_vertex;
  std::vector<std::size_t> source_vertices;
  bool is_unreached_left = false; // components without a vertex whose value is given are NaN
  std::vector<double> direction;  // empty or three coordinates
  bool are_faces_triangulated = false;
  bool is_strict = false;       // a mesh that is no surface is refused where one is needed
  bool is_repaired = false;     // one is needed, and made of what is read
  bool is_border_taken = false; // of tetrahedra
  double least_share = 0;       // of the area, of components that stay then
};

inline std::vector<std::filesystem::path> input_files(const Input_options& options)
{
  return input_files({options.mesh_path}, {options.scalars_path});
}

// What decides the graph. The same options give the same numbers of nodes and arcs.
struct Graph_options
{
  bool are_degree_two_nodes_kept = false;
  CGAL::Reeb_graph::Ties ties = CGAL::Reeb_graph::Ties::PERTURB;
  CGAL::Reeb_graph::Method method = CGAL::Reeb_graph::Method::AUTOMATIC;
  // These have no influence on the result, and are chosen by the program if they are 0.
  std::size_t number_of_threads = 0;
  std::size_t number_of_slabs = 0;
  // Whether the places of the vertices are found with the graph, which takes less time than to find them later.
  bool are_places_wanted = false;
};

enum class Curves_type
{
  CUTTING_SYSTEM,
  PANTS,
  BRANCH,
  LEVELS,
  DISKS
};

// Values of a field: some, or so many that cut its range into equal steps, or the multiples of a distance.
struct Level_choice
{
  std::vector<double> values;
  std::optional<std::size_t> number;
  std::optional<double> spacing;
};

// Which curves the mesh is cut along.
struct Cut_options
{
  Curves_type type = Curves_type::PANTS;
  std::optional<double> persistence, area; // thresholds of branches
  bool is_cut_open = false;
  std::optional<CGAL::Reeb_graph::Borders> borders; // by default, they are made levels
  Level_choice levels;
};

// A threshold of the persistence of branches and loops, in units of the field or in percent of its range, or the one
// that the graph suggests. Or one of the size of handles, in units of length or in percent of the diagonal of the mesh.
struct Threshold
{
  double number = 0;
  bool is_percentage = false;
  bool is_suggested = false;
};

// What is removed from the graph. Nothing is if neither a threshold nor a number of leaves is given.
struct Simplification_options
{
  std::optional<Threshold> threshold;
  std::optional<std::size_t> number_of_leaves;
  bool are_loops_cancelled = false;

  bool is_anything_removed() const { return threshold || number_of_leaves; }
};

inline auto named_parameters(const Graph_options& options)
{
  return CGAL::parameters::ties(options.ties)
    .method(options.method)
    .keep_degree_two_nodes(options.are_degree_two_nodes_kept)
    .number_of_slabs(options.number_of_slabs);
}

// How drawings call the field.
struct Field_label
{
  std::string name;
  std::string unit; // may be empty
};

} // namespace reeb_graph_program

#endif // CGAL_REEB_GRAPH_SRC_OPTIONS_H
