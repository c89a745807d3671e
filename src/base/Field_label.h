// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_SRC_FIELD_LABEL_H
#define CGAL_REEB_GRAPH_SRC_FIELD_LABEL_H

#include <string>

namespace reeb_graph_program {
// How drawings call the field.
struct Field_label
{
  std::string name;
  std::string unit; // may be empty
};

} // namespace reeb_graph_program

#endif // CGAL_REEB_GRAPH_SRC_FIELD_LABEL_H
