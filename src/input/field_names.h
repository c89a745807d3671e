// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_SRC_FIELD_NAMES_H
#define CGAL_REEB_GRAPH_SRC_FIELD_NAMES_H

#include "input/input_error.h"

#include <algorithm>
#include <cstddef>
#include <string>
#include <vector>

namespace reeb_graph_program {
// What a file has for its vertices and for its cells, in its order, for the message that a field is none of it.
struct Field_names
{
  std::vector<std::string> of_vertices, of_cells;
  std::vector<std::string> others_of_vertices; // those of them that are not one number for each vertex

  void add(bool is_of_cells, const std::string& name, std::size_t numbers_per_item)
  {
    std::string shown = quote(name);
    shown = shown.substr(1, shown.size() - 2); // no control characters
    if(numbers_per_item != 1)
      shown += " (" + std::to_string(numbers_per_item) + " numbers)";
    (is_of_cells ? of_cells : of_vertices).push_back(shown);
    if(!is_of_cells && numbers_per_item != 1)
      others_of_vertices.push_back(shown);
  }

  // `cells` is what they are called.
  std::string message(const std::string& field, const std::string& cells) const
  {
    const bool is_of_cells = std::find(of_cells.begin(), of_cells.end(), field) != of_cells.end();
    return (is_of_cells ? "the field " + quote(field) + " is one of the " + cells : "there is no field " + quote(field))
         + ": the vertices have " + list(of_vertices)
         + (of_cells.empty() ? "" : "; the " + cells + " have " + list(of_cells));
  }

private:
  static std::string list(const std::vector<std::string>& names)
  {
    std::string result;
    for(const std::string& name : names)
      result += (result.empty() ? "" : ", ") + name;
    return result.empty() ? "none" : result;
  }
};

} // namespace reeb_graph_program

#endif // CGAL_REEB_GRAPH_SRC_FIELD_NAMES_H
