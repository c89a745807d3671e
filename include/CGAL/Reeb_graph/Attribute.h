// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of the CGAL-style package Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_ATTRIBUTE_H
#define CGAL_REEB_GRAPH_ATTRIBUTE_H

#include <CGAL/license/Reeb_graph.h>

#include <cstdint>
#include <string>
#include <variant>
#include <vector>

namespace CGAL::Reeb_graph {

/// \ingroup PkgReebGraphIO
///
/// \brief numbers that are written to a file with a name: one for each arc, vertex, or face.
struct Attribute
{
  /// the name, in files a column or an array; in files of XML and JSON, bytes that are not UTF-8 become U+FFFD
  std::string name;

  /// the numbers, in the order of `edges(graph)`, `vertices(mesh)`, or `faces(mesh)`
  std::variant<std::vector<double>, std::vector<std::int64_t>> numbers;
};

} // namespace CGAL::Reeb_graph

#endif // CGAL_REEB_GRAPH_ATTRIBUTE_H
