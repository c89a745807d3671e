// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of the CGAL-style package Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_SRC_PAGE_OUTPUT_H
#define CGAL_REEB_GRAPH_SRC_PAGE_OUTPUT_H

#include "page/page_data.h"

#include <filesystem>

namespace reeb_graph_program {
// Whether the program has been built with the page.
bool is_page_available();

// Throws std::runtime_error, which tells how to get the page, if there is none, or if the path is no .html file.
void check_page(const std::filesystem::path& path);

// Writes a page that shows the graph on its surface, in one file.
void write_page(const std::filesystem::path& path, const Page_subject& subject);

} // namespace reeb_graph_program

#endif // CGAL_REEB_GRAPH_SRC_PAGE_OUTPUT_H
