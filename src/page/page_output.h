// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_SRC_PAGE_OUTPUT_H
#define CGAL_REEB_GRAPH_SRC_PAGE_OUTPUT_H

#include "page/page_data.h"

#include <filesystem>
#include <string>

namespace reeb_graph_program {
// Whether the program has been built with the page.
bool is_page_available();

// Throws std::runtime_error, which tells how to get the page, if there is none, if the path is no .html file, or if
// there is no path but a direction that would be up, or what only a page refuses.
void check_page(const std::filesystem::path& path, const std::string& up, bool is_strict = false);

// Writes a page that shows the simplified graph on its surface, in one file. A graph of more than 2000 arcs is
// simplified until no more are left.
void write_page(const std::filesystem::path& path, const Page_request& request);
void write_page(const std::filesystem::path& path, const Page_of_skeleton& page);
void write_page(const std::filesystem::path& path, const Page_of_shapes& page);

} // namespace reeb_graph_program

#endif // CGAL_REEB_GRAPH_SRC_PAGE_OUTPUT_H
