// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of the CGAL-style package Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_SRC_EMBEDDING_H
#define CGAL_REEB_GRAPH_SRC_EMBEDDING_H

#include "base/report.h"
#include "base/surface.h"

#include <CGAL/Reeb_graph/Embedding.h>
#include <CGAL/Reeb_graph/options.h>

#include <vector>

namespace reeb_graph_program {
// A graph in space, with the measures of its arcs.
struct Graph_in_space
{
  CGAL::Reeb_graph::Embedding<Point> embedding;
  std::vector<CGAL::Reeb_graph::Attribute> arc_attributes;
};

// The numbers of arcs for files: the persistence, and what has been measured.
std::vector<CGAL::Reeb_graph::Attribute> attributes_of_arcs(const Graph& graph, const std::vector<Arc_row>& arcs);

} // namespace reeb_graph_program

#endif // CGAL_REEB_GRAPH_SRC_EMBEDDING_H
