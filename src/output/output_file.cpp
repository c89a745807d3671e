// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of the CGAL-style package Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#include "output/output_file.h"

#include <signal.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <cstddef>
#include <fstream>
#include <set>
#include <stdexcept>
#include <string>
#include <system_error>

namespace fs = std::filesystem;

namespace reeb_graph_program {
namespace {
// The files to be removed when a signal ends the program.
constexpr std::size_t most_files = 2;
std::array<std::atomic<const char*>, most_files> partial_files = {};

// Ends the program as the signal would have done. All that it calls can be called by a signal handler.
void remove_partial_files(int signal)
{
  for(const auto& file : partial_files)
    if(const char* path = file)
      unlink(path);
  ::signal(signal, SIG_DFL);
  raise(signal);
}

// Lets the signals that users end a program by remove the files, except those that are ignored.
class Interrupt_guard
{
public:
  explicit Interrupt_guard(const std::vector<fs::path>& paths)
  {
    for(std::size_t i = 0; i != paths.size(); ++i)
      partial_files.at(i) = paths[i].c_str();
    for(std::size_t i = 0; i != signals.size(); ++i)
    {
      sigaction(signals[i], nullptr, &old_actions_[i]);
      if(old_actions_[i].sa_handler != SIG_IGN)
        signal(signals[i], remove_partial_files);
    }
  }
  ~Interrupt_guard()
  {
    for(std::size_t i = 0; i != signals.size(); ++i)
      sigaction(signals[i], &old_actions_[i], nullptr);
    for(auto& file : partial_files)
      file = nullptr;
  }
  Interrupt_guard(const Interrupt_guard&) = delete;
  Interrupt_guard& operator=(const Interrupt_guard&) = delete;

private:
  static constexpr std::array<int, 3> signals = {SIGINT, SIGTERM, SIGHUP};
  std::array<struct sigaction, 3> old_actions_;
};

// Files beside the targets, which are removed in the end, whether they are there or not, also if the program is
// interrupted.
struct Temporary_files
{
  explicit Temporary_files(const std::vector<fs::path>& targets) : paths(paths_beside(targets)), guard(paths) {}
  ~Temporary_files()
  {
    std::error_code ignored;
    for(const fs::path& path : paths)
      fs::remove(path, ignored);
  }
  Temporary_files(const Temporary_files&) = delete;
  Temporary_files& operator=(const Temporary_files&) = delete;

  const std::vector<fs::path> paths;
  const Interrupt_guard guard;

private:
  static std::vector<fs::path> paths_beside(const std::vector<fs::path>& targets)
  {
    std::vector<fs::path> result;
    result.reserve(targets.size());
    for(const fs::path& target : targets)
      result.emplace_back(target.string() + "." + std::to_string(getpid()) + ".partial");
    return result;
  }
};

std::runtime_error output_error(const fs::path& path)
{
  return std::runtime_error(path.string() + ": the file cannot be written");
}

// The file that will be replaced: a symbolic link stays one.
fs::path target_of(const fs::path& path)
{
  std::error_code error;
  fs::path target = fs::weakly_canonical(path, error);
  if(error || (fs::exists(target, error) && !fs::is_regular_file(target, error)))
    throw output_error(path);
  return target;
}

void write_stream(const fs::path& temporary_path, const fs::path& path, const std::function<void(std::ostream&)>& write)
{
  std::ofstream stream(temporary_path, std::ios::binary);
  if(stream)
    write(stream);
  stream.close();
  if(!stream)
    throw output_error(path);
}

void rename_file(const fs::path& temporary_path, const fs::path& target, const fs::path& path)
{
  std::error_code error;
  fs::rename(temporary_path, target, error);
  if(error)
    throw output_error(path);
}

} // namespace

void check_distinct_paths(const std::vector<fs::path>& paths)
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
  const fs::path target = target_of(path);
  const Temporary_files temporary_files({target});
  write(temporary_files.paths[0]);
  rename_file(temporary_files.paths[0], target, path);
}

void write_file(const fs::path& path, const std::function<void(std::ostream&)>& write)
{
  replace_file(path, [&](const fs::path& temporary_path) { write_stream(temporary_path, path, write); });
}

void write_both_files(const Output_file& first, const Output_file& second)
{
  const fs::path first_target = target_of(first.path), second_target = target_of(second.path);
  const Temporary_files temporary_files({first_target, second_target});
  write_stream(temporary_files.paths[0], first.path, first.write);
  write_stream(temporary_files.paths[1], second.path, second.write);
  rename_file(temporary_files.paths[0], first_target, first.path);
  rename_file(temporary_files.paths[1], second_target, second.path);
}

} // namespace reeb_graph_program
