// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_SRC_PAGE_OUTPUT_H
#define CGAL_REEB_GRAPH_SRC_PAGE_OUTPUT_H

#include "base/options.h"
#include "base/surface.h"
#include "computation/Mesh_graph.h"
#include "page/page_data.h"
#include "page/page_skeleton.h"

#include <filesystem>
#include <optional>
#include <vector>

namespace reeb_graph_program {
// Whether the program has been built with the page.
bool is_page_available();

// Throws std::runtime_error, which tells how to get the page, if there is none, if the path is no .html file, or if
// there is no path but a direction that would be up.
void check_page(const std::filesystem::path& path, const std::string& up);

// What a page is written of.
struct Page_request
{
  Scalar_map scalar_map;
  Mesh_graph& graph; // of a surface
  std::string title;
  Field_label field_label;
  Simplification_options simplification = {}; // that of the graph
  std::string up = {};                        // which way is up: x, y, z, -x, -y, -z, or as the page finds it
  std::optional<Patch_map> patch_map = std::nullopt;
  std::vector<Polyline> curves = {};
  std::vector<Loop_row> loops = {};
};

// Writes a page that shows the simplified graph on its surface, in one file. A graph of more than 2000 arcs is
// simplified until no more are left.
void write_page(const std::filesystem::path& path, const Page_request& request);
void write_page(const std::filesystem::path& path, const Page_of_skeleton& page);

} // namespace reeb_graph_program

#endif // CGAL_REEB_GRAPH_SRC_PAGE_OUTPUT_H
