// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_SRC_VTK_INPUT_H
#define CGAL_REEB_GRAPH_SRC_VTK_INPUT_H

#include "input/Polygon_soup.h"
#include "input/field_names.h"

#include <string>
#include <string_view>

namespace reeb_graph_program {
// Which numbers of the points are read.
struct Vtk_field_choice
{
  bool are_all_wanted = false;
  std::string name;             // of those that become scalars of the soup, or empty
  Field_names* names = nullptr; // what the file has is added here

  bool is_wanted(const std::string& field) const { return are_all_wanted || (!name.empty() && field == name); }
  // Adds the numbers of one more piece of the file, if they are wanted.
  void add(const Vertex_field& field, Polygon_soup& soup) const;
};

// Parts of read_vtk().
Polygon_soup read_vtk_legacy(const std::string& path, std::string_view text, const Vtk_field_choice& choice);
Polygon_soup read_vtk_xml(const std::string& path, std::string_view text, const Vtk_field_choice& choice);

} // namespace reeb_graph_program

#endif // CGAL_REEB_GRAPH_SRC_VTK_INPUT_H
