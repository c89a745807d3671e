// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of the CGAL-style package Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_SRC_OUTPUT_FILE_H
#define CGAL_REEB_GRAPH_SRC_OUTPUT_FILE_H

#include <filesystem>
#include <functional>
#include <initializer_list>
#include <ostream>

namespace reeb_graph_program {
// Refuses output of which one part would replace another one. Empty paths are not given.
void check_distinct_paths(std::initializer_list<std::filesystem::path> paths);

// Calls `write` with the name of a temporary file in the same folder and renames that file to `path` afterwards: the
// file is complete or as it was before. Throws std::runtime_error, and what `write` throws.
void replace_file(const std::filesystem::path& path, const std::function<void(const std::filesystem::path&)>& write);

// The same with a stream, whose failure is an error.
void write_file(const std::filesystem::path& path, const std::function<void(std::ostream&)>& write);

} // namespace reeb_graph_program

#endif // CGAL_REEB_GRAPH_SRC_OUTPUT_FILE_H
