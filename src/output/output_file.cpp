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
// The file to be removed when a signal ends the program.
std::atomic<const char*> partial_file = nullptr;

// Ends the program as the signal would have done. All that it calls can be called by a signal handler.
void remove_partial_file(int signal)
{
  if(const char* path = partial_file)
    unlink(path);
  ::signal(signal, SIG_DFL);
  raise(signal);
}

// Lets the signals that users end a program by remove the file, except those that are ignored.
class Interrupt_guard
{
public:
  explicit Interrupt_guard(const char* path)
  {
    partial_file = path;
    for(std::size_t i = 0; i != signals.size(); ++i)
    {
      sigaction(signals[i], nullptr, &old_actions_[i]);
      if(old_actions_[i].sa_handler != SIG_IGN)
        signal(signals[i], remove_partial_file);
    }
  }
  ~Interrupt_guard()
  {
    for(std::size_t i = 0; i != signals.size(); ++i)
      sigaction(signals[i], &old_actions_[i], nullptr);
    partial_file = nullptr;
  }
  Interrupt_guard(const Interrupt_guard&) = delete;
  Interrupt_guard& operator=(const Interrupt_guard&) = delete;

private:
  static constexpr std::array<int, 3> signals = {SIGINT, SIGTERM, SIGHUP};
  std::array<struct sigaction, 3> old_actions_;
};

// Removes the file in the end, whether it is there or not, also if the program is interrupted.
struct Temporary_file
{
  explicit Temporary_file(const fs::path& target)
    : path(target.string() + "." + std::to_string(getpid()) + ".partial"),
      guard(path.c_str())
  {}
  ~Temporary_file()
  {
    std::error_code ignored;
    fs::remove(path, ignored);
  }
  Temporary_file(const Temporary_file&) = delete;
  Temporary_file& operator=(const Temporary_file&) = delete;

  const fs::path path;
  const Interrupt_guard guard;
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
