// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of the CGAL-style package Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#include "output/output_file.h"

#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <iterator>
#include <stdexcept>
#include <string>

// Whoever interrupts the program finds the files as they were: argument 1 is a folder for them.

namespace fs = std::filesystem;
using reeb_graph_program::write_file;
using reeb_graph_program::write_files;

namespace {
// What the signal that ends a process while it writes the file leaves: no file, or those that were there, unchanged.
std::string contents_after_interrupt(const fs::path& folder, int signal, int& ended_by)
{
  const pid_t child = fork();
  if(child == 0)
  {
    write_file(folder / "output.txt", [&](std::ostream& stream) {
      stream << "half of" << std::flush;
      raise(signal);
    });
    _exit(EXIT_SUCCESS);
  }
  int status = 0;
  waitpid(child, &status, 0);
  ended_by = WIFSIGNALED(status) ? WTERMSIG(status) : 0;
  std::string contents;
  for(const auto& entry : fs::directory_iterator(folder))
  {
    std::ifstream stream(entry.path());
    contents += entry.path().filename().string() + ":";
    contents.append(std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>());
  }
  return contents;
}
} // namespace

int main(int, char** arguments)
{
  const fs::path folder = arguments[1];
  int number_of_faults = 0;
  const auto check = [&](bool is_right, const std::string& what) {
    if(is_right)
      return;
    std::cerr << "wrong: " << what << '\n';
    ++number_of_faults;
  };
  for(const int signal : {SIGINT, SIGTERM, SIGHUP, SIGPIPE, SIGXCPU})
  {
    fs::remove_all(folder);
    fs::create_directories(folder);
    const std::string name = "signal " + std::to_string(signal);
    int ended_by = 0;
    check(contents_after_interrupt(folder, signal, ended_by).empty(), name + " leaves a new file");
    check(ended_by == signal, name + " does not end the program");
    write_file(folder / "output.txt", [](std::ostream& stream) { stream << "old"; });
    check(contents_after_interrupt(folder, signal, ended_by) == "output.txt:old", name + " changes an old file");
    check(ended_by == signal, name + " does not end the program that replaces a file");
  }
  // Of two files that belong together, neither is there if the second one fails or the program is interrupted.
  fs::remove_all(folder);
  fs::create_directories(folder);
  const auto write_first = [](std::ostream& stream) { stream << "first"; };
  const auto fail = [](std::ostream& stream) { stream.setstate(std::ios::failbit); };
  bool has_thrown = false;
  try
  {
    write_files({{folder / "a.txt", write_first}, {folder / "b.txt", fail}});
  }
  catch(const std::runtime_error&)
  {
    has_thrown = true;
  }
  check(has_thrown && fs::is_empty(folder), "the first one of two files stays when the second one fails");
  const pid_t child = fork();
  if(child == 0)
  {
    write_files({{folder / "a.txt", write_first}, {folder / "b.txt", [](std::ostream&) { raise(SIGTERM); }}});
    _exit(EXIT_SUCCESS);
  }
  waitpid(child, nullptr, 0);
  check(fs::is_empty(folder), "an interrupt leaves one of two files");
  write_files({{folder / "a.txt", write_first}, {folder / "b.txt", write_first}});
  check(fs::file_size(folder / "a.txt") == 5 && fs::file_size(folder / "b.txt") == 5, "two files are not written");
  fs::remove(folder / "a.txt");
  fs::remove(folder / "b.txt");

  // A signal that is ignored stays so, as under nohup.
  ::signal(SIGHUP, SIG_IGN);
  int ended_by = 0;
  check(contents_after_interrupt(folder, SIGHUP, ended_by) == "output.txt:half of", "an ignored signal is not ignored");
  check(ended_by == 0, "an ignored signal ends the program");
  return number_of_faults == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
