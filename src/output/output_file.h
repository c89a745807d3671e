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
#include <ostream>
#include <vector>

namespace reeb_graph_program {
// Refuses output of which one part would replace another one. Empty paths are not given.
void check_distinct_paths(const std::vector<std::filesystem::path>& paths);

// Calls `write` with the name of a temporary file in the same folder and renames that file to `path` afterwards: the
// file is complete or as it was before. Throws std::runtime_error, and what `write` throws.
void replace_file(const std::filesystem::path& path, const std::function<void(const std::filesystem::path&)>& write);

// The same with a stream, whose failure is an error.
void write_file(const std::filesystem::path& path, const std::function<void(std::ostream&)>& write);

// The same for two files that belong together: neither is there before both are complete.
struct Output_file
{
  std::filesystem::path path;
  std::function<void(std::ostream&)> write;
};
void write_both_files(const Output_file& first, const Output_file& second);

} // namespace reeb_graph_program

#endif // CGAL_REEB_GRAPH_SRC_OUTPUT_FILE_H
