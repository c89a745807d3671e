// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#include "mesh_files.h"

#include "random_meshes.h"

#include <fcntl.h>
#include <spawn.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <iterator>
#include <regex>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

// Files of meshes and of scalars that are damaged at random places, every other one in its first bytes, where headers
// are. The program takes such a file and writes the whole graph, or it ends with its error code and a message of its own,
// not one of the standard library, and writes nothing: within seconds and 2 GB of memory.
//
// Usage: test_mutated_mesh_files PROGRAM FOLDER [FIRST SEED] [NUMBER OF SEEDS]
// Each seed is one file of each format, seed 0 the files as they are. A file that fails stays in the folder.

namespace {
namespace fs = std::filesystem;
using mesh_files::Mesh_file;
using random_meshes::Random;

std::size_t random_position(const std::string& content, Random& random) { return random.below(content.size() + 1); }

void flip_bit(std::string& content, Random& random)
{
  if(!content.empty())
    content[random.below(content.size())] ^= static_cast<char>(1 << random.below(8));
}

void delete_range(std::string& content, Random& random)
{
  const std::size_t begin = random_position(content, random);
  content.erase(begin, 1 + random.below(random.below(4) == 0 ? 60 : 4));
}

void insert_characters(std::string& content, Random& random)
{
  static const std::string characters = "0123456789 \n\t-+.eE#/\\\r\"nanifx\0\xff";
  std::string inserted;
  for(std::size_t i = 1 + random.below(6); i > 0; --i)
    inserted += characters[random.below(characters.size())];
  content.insert(random_position(content, random), inserted);
}

void repeat_range(std::string& content, Random& random)
{
  const std::size_t begin = random_position(content, random);
  const std::string repeated = content.substr(begin, 1 + random.below(80));
  content.insert(random_position(content, random), repeated);
}

// The places of a line with its end, that of a random one if the content has any.
std::pair<std::size_t, std::size_t> random_line(const std::string& content, Random& random)
{
  const std::size_t inside = random_position(content, random);
  const std::size_t before = inside == 0 ? std::string::npos : content.rfind('\n', inside - 1);
  const std::size_t begin = before == std::string::npos ? 0 : before + 1, end = content.find('\n', begin);
  return {begin, (end == std::string::npos ? content.size() : end + 1) - begin};
}

// Moves a line elsewhere, or copies it, or only deletes it.
void move_line(std::string& content, Random& random)
{
  const auto [begin, size] = random_line(content, random);
  const std::string line = content.substr(begin, size);
  const std::size_t way = random.below(3);
  if(way != 0)
    content.erase(begin, size);
  if(way != 1)
    content.insert(random_line(content, random).first, line);
}

void replace_number(std::string& content, Random& random)
{
  static const std::array<std::string, 20> numbers = {
    "0",          "-1",         "1",   "2",   "255", "256",  "65536", "2147483647",           "-2147483648",
    "2147483648", "4294967295", "1e9", "1.5", "nan", "-inf", "1e999", "18446744073709551615", "99999999999999999999",
    "0x10",       "1e-400"};
  const char* const digits = "0123456789";
  std::size_t begin = content.find_first_of(digits, random_position(content, random));
  if(begin == std::string::npos)
    begin = content.find_first_of(digits);
  if(begin == std::string::npos)
    return;
  const std::size_t end = content.find_first_not_of(digits, begin);
  content.replace(begin, (end == std::string::npos ? content.size() : end) - begin, numbers[random.below(20)]);
}

void replace_four_bytes(std::string& content, Random& random)
{
  static const std::array<std::string, 4> patterns = {std::string(4, '\xff'), std::string(4, '\0'),
                                                      std::string("\x7f\xff\xff\xff", 4), std::string(2, '\x80')};
  content.replace((std::min)(content.size(), random_position(content, random)), 4, patterns[random.below(4)]);
}

void truncate(std::string& content, Random& random) { content.resize(random_position(content, random)); }

std::string mutate(std::string content, std::size_t longest, Random& random)
{
  const std::string rest = content.size() > longest ? content.substr(longest) : std::string();
  content.resize(std::min(content.size(), longest));
  static constexpr std::array<void (*)(std::string&, Random&), 8> mutations = {
    flip_bit, delete_range, insert_characters, repeat_range, move_line, replace_number, replace_four_bytes, truncate};
  for(std::size_t i = 1 + random.below(3); i > 0; --i)
    mutations[random.below(random.below(3) == 0 ? mutations.size() : mutations.size() - 1)](content, random);
  return content + rest;
}

std::string read_file(const fs::path& path)
{
  std::ifstream stream(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
}

void write_file(const fs::path& path, const std::string& content)
{
  std::ofstream stream(path, std::ios::binary);
  stream << content;
  if(!stream.flush())
    throw std::runtime_error("no file can be written to " + path.string());
}

// Programs that are started from now on may take so much only.
void limit_resources()
{
#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__) // these take terabytes of addresses
  const rlimit memory = {2'000'000'000, 2'000'000'000};
  setrlimit(RLIMIT_AS, &memory);
#endif
  const rlimit seconds = {60, 60};
  setrlimit(RLIMIT_CPU, &seconds);
}

struct Result
{
  int status = 0;
  std::string message, graph;
};

class Folder
{
public:
  Folder(fs::path program, fs::path folder) : program_(std::move(program)), folder_(std::move(folder))
  {
    fs::remove_all(folder_);
    fs::create_directories(folder_);
    write_file(folder_ / ".." / "octahedron.off", mesh_files::all_mesh_files().front().content);
  }

  fs::path mesh_path(const Mesh_file& file) const { return folder_ / ("mesh" + file.extension); }
  fs::path graph_path() const { return folder_ / "graph.graphml"; }

  // Runs the program in a process of its own.
  Result run(const Mesh_file& file) const
  {
    const bool is_mesh = file.extension != ".npy" && file.extension != ".txt" && file.extension != ".csv";
    const std::string mesh_of_scalars = (folder_ / ".." / "octahedron.off").string();
    std::array<std::string, 7> arguments = {program_.string(),
                                            "compute",
                                            is_mesh ? mesh_path(file).string() : mesh_of_scalars,
                                            is_mesh ? "--field" : "--scalars",
                                            is_mesh ? "z" : mesh_path(file).string(),
                                            "--graph",
                                            graph_path().string()};
    if(file.extension == ".csv")
      arguments[3] = "--column=5\" z", arguments[4] = "--scalars=" + mesh_path(file).string();
    std::array<char*, 8> argument_pointers{};
    for(std::size_t i = 0; i < arguments.size(); ++i)
      argument_pointers[i] = arguments[i].data();
    posix_spawn_file_actions_t actions{};
    posix_spawn_file_actions_init(&actions);
    const std::string message_path = (folder_ / "message.txt").string();
    posix_spawn_file_actions_addopen(&actions, STDERR_FILENO, message_path.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
    posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, "/dev/null", O_WRONLY, 0);
    pid_t process = 0;
    Result result;
    if(posix_spawn(&process, arguments[0].c_str(), &actions, nullptr, argument_pointers.data(), environ) != 0
       || waitpid(process, &result.status, 0) != process)
      throw std::runtime_error("the program cannot be run");
    posix_spawn_file_actions_destroy(&actions);
    result.message = read_file(message_path);
    result.graph = read_file(graph_path());
    fs::remove(message_path);
    return result;
  }

  // What is wrong with how the program ends on a file, empty if nothing is. A file that is not damaged has to be taken,
  // and all of these but STL files, whose vertices are in another order, give the same graph. The measures of arcs, which
  // only surfaces have, are left out.
  std::string fault(const Mesh_file& file, bool is_damaged)
  {
    write_file(mesh_path(file), file.content);
    const Result result = run(file);
    const auto number_of_files = std::distance(fs::directory_iterator(folder_), fs::directory_iterator());
    fs::remove(mesh_path(file));
    fs::remove(graph_path());
    if(!WIFEXITED(result.status))
      return "the program is ended by signal " + std::to_string(WTERMSIG(result.status)) + ": " + result.message;
    if(number_of_files == 1 && is_refused(result) && is_damaged)
      return "";
    if(number_of_files != 2 || !is_taken(result))
      return "the program ends with " + std::to_string(WEXITSTATUS(result.status)) + ", "
           + std::to_string(result.graph.size()) + " bytes of a graph, and the message: " + result.message;
    std::string& known_graph = graphs_[file.extension == ".stl" ? 1 : 0];
    const std::string graph = std::regex_replace(result.graph, std::regex("\n[^\n]*\"key[4-9]\"[^\n]*"), "");
    if(!is_damaged && known_graph.empty())
      known_graph = graph;
    return is_damaged || known_graph == graph ? "" : "the graph is not that of the other files";
  }

  void keep(const Mesh_file& file, const std::string& name) const { write_file(folder_ / ".." / name, file.content); }

private:
  static bool is_refused(const Result& result)
  {
    const std::string beginning = "reeb_graph: error: ";
    return WEXITSTATUS(result.status) == 1 && result.graph.empty()
        && result.message.substr(0, beginning.size()) == beginning && result.message != beginning + "out of memory\n"
        && !is_of_standard_library(result.message);
  }

  // Whether the message has the text of an exception of the standard library, or of one that only a mistake of ours throws.
  static bool is_of_standard_library(const std::string& message)
  {
    static const std::array<std::string, 15> texts = {"std::",
                                                      "basic_string",
                                                      "vector::",
                                                      "_M_",
                                                      "::at",
                                                      "stod",
                                                      "stoul",
                                                      "regex",
                                                      "bad_",
                                                      "iostream",
                                                      "filesystem error",
                                                      "json.exception",
                                                      "invalid string position",
                                                      "mutex",
                                                      "Precondition"};
    return std::any_of(texts.begin(), texts.end(),
                       [&](const std::string& text) { return message.find(text) != std::string::npos; });
  }

  static bool is_taken(const Result& result)
  {
    const std::string end = "</graphml>\n";
    return WEXITSTATUS(result.status) == 0 && result.message.empty() && result.graph.size() > end.size()
        && result.graph.substr(result.graph.size() - end.size()) == end;
  }

  fs::path program_, folder_;
  std::array<std::string, 2> graphs_;
};

// Returns the number of files on which the program fails.
std::size_t test_seed(Folder& folder, std::size_t seed)
{
  std::size_t number_of_faults = 0, number = 0;
  std::vector<Mesh_file> files = mesh_files::all_mesh_files(), scalars = mesh_files::all_scalar_files();
  files.insert(files.end(), scalars.begin(), scalars.end());
  for(Mesh_file file : files)
  {
    Random random(1000 * seed + number++);
    if(seed > 0)
      file.content = mutate(file.content, seed % 2 == 0 ? file.content.size() : 150, random);
    const std::string fault = folder.fault(file, seed > 0);
    if(fault.empty())
      continue;
    ++number_of_faults;
    const std::string name = "seed_" + std::to_string(seed) + "_" + file.name + file.extension;
    std::cerr << name << ": " << fault << '\n';
    folder.keep(file, name);
  }
  return number_of_faults;
}

} // namespace

int main(int argc, char** argv)
{
  if(argc < 3)
    return EXIT_FAILURE;
  const std::size_t first_seed = argc > 3 ? std::strtoul(argv[3], nullptr, 10) : 0;
  const std::size_t number_of_seeds = argc > 4 ? std::strtoul(argv[4], nullptr, 10) : 40;
  Folder folder(argv[1], argv[2]);
  limit_resources();
  std::size_t number_of_faults = 0;
  for(std::size_t seed = first_seed; seed < first_seed + number_of_seeds; ++seed)
    number_of_faults += test_seed(folder, seed);
  return number_of_faults == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
