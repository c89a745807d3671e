// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#include "output/output_file.h"

#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <cstddef>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <functional>
#include <iostream>
#include <iterator>
#include <random>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

// Whoever interrupts the program finds the files as they were: argument 1 is a folder for them.

namespace fs = std::filesystem;
using reeb_graph_program::make_folder;
using reeb_graph_program::Output_group;
using reeb_graph_program::remove_file;
using reeb_graph_program::write_file;

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

// Writes so many files that belong together into a new folder, and removes one that is there.
constexpr std::size_t number_of_many = 3000;
void write_many(const fs::path& folder)
{
  Output_group files;
  make_folder(folder / "new" / "deep");
  for(std::size_t i = 0; i != number_of_many; ++i)
    write_file(folder / "new" / "deep" / std::to_string(i), [](std::ostream& stream) { stream << "first"; });
  remove_file(folder / "old");
  files.put_in_place();
}

// Lets a process write these for some microseconds, and then ends it by a signal, or not if there is none.
void interrupt_many(const fs::path& folder, int signal, unsigned microseconds)
{
  fs::remove_all(folder);
  fs::create_directories(folder);
  write_file(folder / "old", [](std::ostream& stream) { stream << "old"; });
  const pid_t child = fork();
  if(child == 0)
  {
    write_many(folder);
    _exit(EXIT_SUCCESS);
  }
  if(signal != 0)
  {
    std::this_thread::sleep_for(std::chrono::microseconds(microseconds));
    kill(child, signal);
  }
  waitpid(child, nullptr, 0);
}

// All of these files are there, or none of them and no folder.
bool are_all_or_none(const fs::path& folder)
{
  std::size_t number = 0, partial = 0;
  for(const auto& entry : fs::recursive_directory_iterator(folder))
  {
    number += entry.is_regular_file() ? 1 : 0;
    partial += entry.path().extension() == ".partial" ? 1 : 0;
  }
  const bool is_old = fs::exists(folder / "old");
  return partial == 0 && number == (is_old ? 1 : number_of_many) && is_old != fs::exists(folder / "new");
}

// Signals at random times, from before the first file to behind the last one.
bool are_many_all_or_none(const fs::path& folder)
{
  const auto begin = std::chrono::steady_clock::now();
  interrupt_many(folder, 0, 0);
  const std::chrono::microseconds time =
    std::chrono::duration_cast<std::chrono::microseconds>(std::chrono::steady_clock::now() - begin);
  const unsigned seed = std::random_device()();
  std::mt19937 random(seed);
  std::uniform_int_distribution<unsigned> microseconds(0, static_cast<unsigned>(time.count()) * 5 / 4);
  bool is_right = are_all_or_none(folder);
  for(int i = 0; i != 20 && is_right; ++i)
  {
    interrupt_many(folder, i % 2 == 0 ? SIGINT : SIGTERM, microseconds(random));
    is_right = are_all_or_none(folder);
  }
  if(!is_right)
    std::cerr << "seed " << seed << '\n';
  return is_right;
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
  // Of files that belong together, none is there if one fails or the program is interrupted, however many they are.
  fs::remove_all(folder);
  fs::create_directories(folder);
  const auto write_first = [](std::ostream& stream) { stream << "first"; };
  const auto write_group = [&](const std::function<void(std::ostream&)>& write_last) {
    Output_group files;
    for(const char name : std::string("abcdefgh"))
    {
      Output_group inner; // a part of the other one
      write_file(folder / std::string(1, name), write_first);
      inner.put_in_place();
    }
    write_file(folder / "last", write_last);
    check(!fs::exists(folder / "a"), "a file is there before those that belong to it");
    files.put_in_place();
  };
  bool has_thrown = false;
  try
  {
    write_group([](std::ostream& stream) { stream.setstate(std::ios::failbit); });
  }
  catch(const std::runtime_error&)
  {
    has_thrown = true;
  }
  check(has_thrown && fs::is_empty(folder), "the first ones of several files stay when the last one fails");
  const pid_t child = fork();
  if(child == 0)
  {
    write_group([](std::ostream&) { raise(SIGTERM); });
    _exit(EXIT_SUCCESS);
  }
  waitpid(child, nullptr, 0);
  check(fs::is_empty(folder), "an interrupt leaves some of several files");
  check(are_many_all_or_none(folder), "signals leave some of thousands of files, or a folder");
  fs::remove_all(folder);
  fs::create_directories(folder);
  has_thrown = false;
  try
  {
    Output_group files;
    make_folder(folder / "new" / "deep");
    write_file(folder / "new" / "deep" / "file", write_first);
    write_file(folder / "new" / "deep" / "last", [](std::ostream& stream) { stream.setstate(std::ios::failbit); });
  }
  catch(const std::runtime_error&)
  {
    has_thrown = true;
  }
  check(has_thrown && fs::is_empty(folder), "a folder stays when what belongs to it fails");
  // Threads write groups of their own.
  std::vector<std::thread> threads;
  for(int i = 0; i < 8; ++i)
    threads.emplace_back([&, i] {
      for(int j = 0; j < 20; ++j)
        write_file(folder / ("of_thread_" + std::to_string(i)), write_first);
    });
  for(std::thread& thread : threads)
    thread.join();
  struct sigaction action = {};
  sigaction(SIGTERM, nullptr, &action);
  check(action.sa_handler == SIG_DFL, "a handler of signals stays");
  write_group(write_first);
  std::size_t number_of_files = 0;
  for(const auto& entry : fs::directory_iterator(folder))
    number_of_files += fs::file_size(entry.path()) == 5 ? 1 : 0;
  check(number_of_files == 9 + 8, "several files are not written");
  fs::remove_all(folder);
  fs::create_directories(folder);

  // A signal that is ignored stays so, as under nohup.
  ::signal(SIGHUP, SIG_IGN);
  int ended_by = 0;
  check(contents_after_interrupt(folder, SIGHUP, ended_by) == "output.txt:half of", "an ignored signal is not ignored");
  check(ended_by == 0, "an ignored signal ends the program");
  return number_of_faults == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
