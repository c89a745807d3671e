// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_SRC_PAGE_SKELETON_H
#define CGAL_REEB_GRAPH_SRC_PAGE_SKELETON_H

#include "base/surface.h"
#include "computation/skeleton.h"

#include <nlohmann/json_fwd.hpp>

#include <string>

namespace reeb_graph_program {
// What the data of the page of a skeleton are made of.
struct Page_of_skeleton
{
  Surface& surface; // gets the distances along the lines, which the page has as its field, as a property
  const Skeleton& skeleton;
  std::string title;
  std::string unit; // of lengths
  std::string up = {};
};

// The data of the page, in which the skeleton is the graph: its arcs have neither chains nor contours, and rise and fall in
// the plane where they close a loop. Nodes have the number of their point in the place of a vertex. `skeleton` has counts.
nlohmann::ordered_json page_data(const Page_of_skeleton& page);

} // namespace reeb_graph_program

#endif // CGAL_REEB_GRAPH_SRC_PAGE_SKELETON_H
