// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_SRC_STANDARD_INPUT_H
#define CGAL_REEB_GRAPH_SRC_STANDARD_INPUT_H

#include <algorithm>
#include <filesystem>
#include <iostream>
#include <iterator>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

// Standard input as a file, which options name `-`. It is read once, and kept.
namespace reeb_graph_program {
inline bool is_standard_input(const std::string& path) { return path == "-"; }

// What the option --format says, with a dot as the extension of a file; empty if it is not given.
inline std::string& extension_of_standard_input()
{
  static std::string extension;
  return extension;
}

inline std::string_view contents_of_standard_input()
{
  static const std::string contents((std::istreambuf_iterator<char>(std::cin)), std::istreambuf_iterator<char>());
  return contents;
}

// As messages and pages name an input.
inline std::string name_of_input(const std::string& path)
{
  return is_standard_input(path) ? "standard input" : std::filesystem::path(path).filename().string();
}

// The files that are read, for checks of outputs. A path is empty if there is none. Throws std::runtime_error if
// --format does not go with them.
inline std::vector<std::filesystem::path> input_files(const std::vector<std::string>& mesh_paths,
                                                      const std::vector<std::string>& scalars_paths)
{
  const auto is_among = [](const std::vector<std::string>& paths) {
    return std::any_of(paths.begin(), paths.end(), is_standard_input);
  };
  const bool is_mesh = is_among(mesh_paths), is_field = is_among(scalars_paths);
  if(is_mesh && is_field)
    throw std::runtime_error("MESH and --scalars cannot both be standard input");
  if(is_mesh && extension_of_standard_input().empty())
    throw std::runtime_error("to read the mesh from standard input, --format is needed: off, obj, ply, stl, ts, mesh, "
                             "vtk, vtu, or vtp");
  if(!is_mesh && !is_field && !extension_of_standard_input().empty())
    throw std::runtime_error("--format goes with standard input only, which is named -");
  std::vector<std::filesystem::path> files;
  for(const std::vector<std::string>* paths : {&mesh_paths, &scalars_paths})
    for(const std::string& path : *paths)
      files.push_back(is_standard_input(path) ? "/dev/stdin" : path);
  return files;
}

} // namespace reeb_graph_program

#endif // CGAL_REEB_GRAPH_SRC_STANDARD_INPUT_H
