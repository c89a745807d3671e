// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#include "output/output_file.h"

#include "base/progress_bar.h"

#include <boost/core/noncopyable.hpp>
#include <boost/iostreams/categories.hpp>
#include <boost/iostreams/stream.hpp>

#include <sys/stat.h>

#include <fcntl.h>
#include <signal.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cerrno>
#include <cstddef>
#include <ios>
#include <iostream>
#include <list>
#include <mutex>
#include <optional>
#include <random>
#include <stdexcept>
#include <string>
#include <system_error>

namespace reeb_graph_program {
namespace {
namespace fs = std::filesystem;

// A file descriptor, which is closed in the end, for a stream. It keeps the first error, and writes nothing behind it: streams
// of the standard library do not tell why they have failed.
struct File_sink
{
  typedef char char_type;
  struct category : boost::iostreams::sink_tag, boost::iostreams::closable_tag
  {
  };

  std::streamsize write(const char* text, std::streamsize size) const
  {
    for(std::streamsize done = 0; done < size;)
    {
      check(*error == 0);
      const ::ssize_t written = ::write(file, text + done, static_cast<std::size_t>(size - done));
      check(written >= 0 || errno == EINTR);
      done += std::max<::ssize_t>(written, 0);
    }
    return size;
  }

  void close() const { check(::close(file) == 0); }

  void check(bool is_right) const
  {
    if(is_right)
      return;
    *error = *error == 0 ? errno : *error;
    throw std::ios_base::failure("the file cannot be written");
  }

  int file;
  int* error;
};

// The files to be removed when a signal ends the program; more than any command writes.
std::array<std::atomic<const char*>, 64> partial_files = {};

// Ends the program as the signal would have done. All that it calls can be called by a signal handler.
void remove_partial_files(int signal)
{
  for(const auto& file : partial_files)
    if(const char* path = file)
      unlink(path);
  ::signal(signal, SIG_DFL);
  raise(signal);
}

// Lets the signals that users and limits end a program by remove the files, except those that are ignored, as long as
// there is one of any thread.
class Interrupt_guard : boost::noncopyable
{
public:
  Interrupt_guard()
  {
    const std::lock_guard lock(mutex);
    if(number_of_guards++ > 0)
      return;
    for(std::size_t i = 0; i != signals.size(); ++i)
    {
      sigaction(signals[i], nullptr, &old_actions[i]);
      if(old_actions[i].sa_handler != SIG_IGN)
        signal(signals[i], remove_partial_files);
    }
  }
  ~Interrupt_guard()
  {
    const std::lock_guard lock(mutex);
    if(--number_of_guards > 0)
      return;
    for(std::size_t i = 0; i != signals.size(); ++i)
      sigaction(signals[i], &old_actions[i], nullptr);
  }

private:
  static constexpr std::array<int, 5> signals = {SIGINT, SIGTERM, SIGHUP, SIGPIPE, SIGXCPU};
  static inline std::array<struct sigaction, signals.size()> old_actions;
  static inline std::mutex mutex;
  static inline std::size_t number_of_guards = 0;
};

typedef struct stat File_status;

Output_error output_error(const fs::path& path, int reason)
{
  return Output_error(path.string() + ": the file cannot be written"
                      + (reason == 0 ? "" : ": " + std::generic_category().message(reason)));
}

bool look_up(const fs::path& path, File_status& status)
{
  return ::stat(path == "-" ? "/dev/stdout" : path.c_str(), &status) == 0;
}

bool is_same(const File_status& a, const File_status& b) { return a.st_dev == b.st_dev && a.st_ino == b.st_ino; }

// Also by another name, but not as another device that is not a terminal: it is no matter if two are /dev/null.
bool is_standard_output(const fs::path& path)
{
  File_status status = {}, of_standard_output = {};
  if(path == "-")
    return true;
  return look_up(path, status) && fstat(STDOUT_FILENO, &of_standard_output) == 0 && is_same(status, of_standard_output)
      && (!S_ISCHR(status.st_mode) || isatty(STDOUT_FILENO) == 1);
}

bool is_written_at_once(const fs::path& path)
{
  File_status status = {};
  return is_standard_output(path) || (look_up(path, status) && !S_ISREG(status.st_mode) && !S_ISDIR(status.st_mode));
}

// The file that will be replaced: a symbolic link stays one, also if there is no such file yet.
fs::path target_of(const fs::path& path)
{
  constexpr int most_links = 40; // as in Linux
  fs::path target = path;
  std::error_code error;
  for(int links = 0; fs::is_symlink(target, error); ++links)
  {
    if(links == most_links)
      throw output_error(path, ELOOP);
    target = target.parent_path() / fs::read_symlink(target);
  }
  return target;
}

// What is written in the place of a file, and where, which is the path itself if it is written at once.
struct Place
{
  explicit Place(const fs::path& given) : path(given), is_at_once(is_written_at_once(given))
  {
    if(is_at_once)
      return;
    std::error_code error; // of a path that cannot be looked up, as it will be told
    if(fs::is_directory(path, error))
      throw output_error(path, EISDIR);
    target = target_of(path);
    std::random_device random; // A name of our own can be shorter than that of the file.
    temporary_path =
      target.parent_path() / ("reeb_graph-" + std::to_string(random()) + std::to_string(random()) + ".partial");
  }

  fs::path path;
  bool is_at_once;
  fs::path target, temporary_path; // empty if it is written at once
};

// The file beside the target, which is removed in the end, whether it is there or not, also if the program is
// interrupted.
class Partial_file : boost::noncopyable
{
public:
  explicit Partial_file(const fs::path& path) : place(path)
  {
    for(std::size_t i = 0; i != partial_files.size() && !place.is_at_once && slot_ == nullptr; ++i)
    {
      const char* none = nullptr;
      if(partial_files[i].compare_exchange_strong(none, place.temporary_path.c_str()))
        slot_ = &partial_files[i];
    }
  }
  ~Partial_file()
  {
    std::error_code ignored;
    if(!place.is_at_once)
      fs::remove(place.temporary_path, ignored);
    if(slot_ != nullptr)
      *slot_ = nullptr;
  }

private:
  const Interrupt_guard guard_;

public:
  const Place place;

private:
  std::atomic<const char*>* slot_ = nullptr;
};

// A new file with the owner and the mode of that which it will replace; nobody else reads it before.
int create_temporary(const Place& place)
{
  File_status old = {};
  const bool is_replaced = look_up(place.target, old);
  const int file =
    ::open(place.temporary_path.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, is_replaced ? 0600 : 0666);
  if(file >= 0 && is_replaced && (fchown(file, old.st_uid, old.st_gid) == 0 || errno == EPERM))
    fchmod(file, old.st_mode & 07777U);
  return file;
}

int open_output(const Place& place)
{
  if(is_standard_output(place.path)) // To open it again would mean to begin at the begin of a file.
  {
    std::cout.flush();
    return fcntl(STDOUT_FILENO, F_DUPFD_CLOEXEC, 0);
  }
  if(place.is_at_once)
    return ::open(place.path.c_str(), O_WRONLY | O_CLOEXEC);
  return create_temporary(place);
}

void write_stream(const Place& place, const std::function<void(std::ostream&)>& write)
{
  int error = 0;
  const int file = open_output(place);
  if(file < 0)
    throw output_error(place.path, errno);
  bool is_written = false;
  {
    boost::iostreams::stream<File_sink> stream(File_sink{file, &error}, 1 << 16);
    write(stream);
    is_written = !stream.fail();
  }
  if(!is_written || error != 0)
    throw output_error(place.path, error);
}

void put_in_place(const Place& place)
{
  std::error_code error;
  if(!place.is_at_once)
    fs::rename(place.temporary_path, place.target, error);
  if(error)
    throw output_error(place.path, error.value());
}

// Those of the group that lives.
thread_local Output_group::Files* files_of_thread = nullptr;

bool ends_in(const std::string& name, const std::string& ending)
{
  return name.size() > ending.size() && name.compare(name.size() - ending.size(), ending.size(), ending) == 0;
}

// Devices keep nothing that could be replaced.
bool is_same_file(const fs::path& a, const fs::path& b)
{
  File_status status_of_a = {}, status_of_b = {};
  const bool is_a_there = look_up(a, status_of_a), is_b_there = look_up(b, status_of_b);
  if(is_a_there || is_b_there)
    return is_a_there && is_b_there && is_same(status_of_a, status_of_b) && !S_ISCHR(status_of_a.st_mode);
  std::error_code error; // of a path that cannot be written either
  const fs::path target_of_a = fs::weakly_canonical(fs::absolute(target_of(a), error), error);
  return !error && target_of_a == fs::weakly_canonical(fs::absolute(target_of(b), error), error) && !error;
}

} // namespace

std::string ending_of(const fs::path& path, const std::string& contents, const std::vector<std::string>& endings)
{
  std::string names;
  for(const std::string& ending : endings)
  {
    if(ends_in(path.filename().string(), ending))
      return ending;
    const bool is_last = &ending == &endings.back();
    names += (names.empty() ? "" : !is_last ? ", " : endings.size() == 2 ? " or " : ", or ") + ending;
  }
  if(path.empty() || is_written_at_once(path))
    return endings.front();
  throw std::runtime_error(path.string() + ": the file name of " + contents + " ends in " + names);
}

void check_outputs(const std::vector<fs::path>& outputs, const std::vector<fs::path>& inputs)
{
  for(auto output = outputs.begin(); output != outputs.end(); ++output)
  {
    const auto is_it = [&](const fs::path& path) { return !path.empty() && is_same_file(path, *output); };
    if(output->empty())
      continue;
    if(std::any_of(outputs.begin(), output, is_it))
      throw std::runtime_error(output->string() + ": two outputs have this name");
    if(std::any_of(inputs.begin(), inputs.end(), is_it))
      throw std::runtime_error(output->string() + ": this output would replace an input");
  }
}

std::ostream& report_stream(const std::vector<fs::path>& outputs)
{
  return std::any_of(outputs.begin(), outputs.end(), is_standard_output) ? std::cerr : std::cout;
}

void flush_standard_output()
{
  errno = 0;
  if(!std::cout.flush())
    throw std::runtime_error("standard output cannot be written"
                             + (errno == 0 ? "" : ": " + std::generic_category().message(errno)));
}

struct Output_group::Files
{
  std::list<Partial_file> list;
};

Output_group::Output_group()
{
  if(files_of_thread != nullptr)
    return;
  files_ = std::make_unique<Files>();
  files_of_thread = files_.get();
}

Output_group::~Output_group()
{
  if(files_)
    files_of_thread = nullptr;
}

void Output_group::put_in_place()
{
  if(!files_)
    return;
  for(const Partial_file& file : files_->list)
    reeb_graph_program::put_in_place(file.place);
  files_->list.clear();
}

void write_file(const fs::path& path, const std::function<void(std::ostream&)>& write)
{
  Output_group group;
  const Place& place = files_of_thread->list.emplace_back(path).place;
  std::optional<Progress_bar> progress_bar;
  if(!place.is_at_once) // which may be on the terminal, too
    progress_bar.emplace("writing");
  write_stream(place, write);
  group.put_in_place();
}

} // namespace reeb_graph_program
