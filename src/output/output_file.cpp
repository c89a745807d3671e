// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of the CGAL-style package Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#include "output/output_file.h"

#include <unistd.h>

#include <fstream>
#include <set>
#include <stdexcept>
#include <string>
#include <system_error>

namespace fs = std::filesystem;

namespace reeb_graph_program {
namespace {
// Removes the file in the end, whether it is there or not.
struct Temporary_file
{
  explicit Temporary_file(const fs::path& target) : path(target.string() + "." + std::to_string(getpid()) + ".partial")
  {}
  ~Temporary_file()
  {
    std::error_code ignored;
    fs::remove(path, ignored);
  }
  Temporary_file(const Temporary_file&) = delete;
  Temporary_file& operator=(const Temporary_file&) = delete;

  const fs::path path;
};

std::runtime_error output_error(const fs::path& path)
{
  return std::runtime_error(path.string() + ": the file cannot be written");
}

} // namespace

void check_distinct_paths(std::initializer_list<fs::path> paths)
{
  std::set<fs::path> targets;
  for(const fs::path& path : paths)
  {
    std::error_code error; // of a path that cannot be written either
    const fs::path target = fs::weakly_canonical(fs::absolute(path, error), error);
    if(!path.empty() && !error && !targets.insert(target).second)
      throw std::runtime_error(path.string() + ": two outputs have this name");
  }
}

void replace_file(const fs::path& path, const std::function<void(const fs::path&)>& write)
{
  std::error_code error;
  const fs::path target = fs::weakly_canonical(path, error); // a symbolic link stays one
  if(error || (fs::exists(target, error) && !fs::is_regular_file(target, error)))
    throw output_error(path);
  const Temporary_file temporary_file(target);
  write(temporary_file.path);
  fs::rename(temporary_file.path, target, error);
  if(error)
    throw output_error(path);
}

void write_file(const fs::path& path, const std::function<void(std::ostream&)>& write)
{
  replace_file(path, [&](const fs::path& temporary_path) {
    std::ofstream stream(temporary_path, std::ios::binary);
    if(stream)
      write(stream);
    stream.close();
    if(!stream)
      throw output_error(path);
  });
}

} // namespace reeb_graph_program
