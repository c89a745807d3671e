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
#include <thread>
#include <utility>
#include <vector>

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

// Signals do not interrupt this thread, and no other one, nor the handler of signals, changes or reads the list of what is
// unfinished. Nobody asks for memory meanwhile: the handler, which waits for this, may have interrupted just that in another
// thread.
class List_lock : boost::noncopyable
{
public:
  List_lock()
  {
    sigset_t all;
    sigfillset(&all);
    pthread_sigmask(SIG_BLOCK, &all, &old_mask_);
    take();
  }
  ~List_lock()
  {
    is_taken.clear();
    pthread_sigmask(SIG_SETMASK, &old_mask_, nullptr);
  }

  static void take()
  {
    while(is_taken.test_and_set())
      std::this_thread::yield();
  }

private:
  static inline std::atomic_flag is_taken = ATOMIC_FLAG_INIT;
  sigset_t old_mask_ = {};
};

class Unfinished;
// Those of all threads, the newest one first, as what is in a folder is removed before that.
Unfinished* newest_unfinished = nullptr;

// Ends the program as the signal would have done. All that it calls can be called by a signal handler, and it keeps the
// lock: nothing is made any more.
void remove_unfinished(int signal);

// Lets the signals that users and limits end a program by remove what is unfinished, except those that are ignored, as long
// as there is one of any thread.
class Interrupt_guard : boost::noncopyable
{
public:
  Interrupt_guard()
  {
    const std::lock_guard lock(mutex);
    if(number_of_guards++ > 0)
      return;
    struct sigaction action = {};
    action.sa_handler = remove_unfinished;
    sigfillset(&action.sa_mask); // no second one waits within this thread for the lock of the first one
    for(std::size_t i = 0; i != signals.size(); ++i)
    {
      sigaction(signals[i], nullptr, &old_actions[i]);
      if(old_actions[i].sa_handler != SIG_IGN)
        sigaction(signals[i], &action, nullptr);
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

// A name of our own can be shorter than that of the file.
fs::path temporary_path_beside(const fs::path& target)
{
  std::random_device random;
  return target.parent_path() / ("reeb_graph-" + std::to_string(random()) + std::to_string(random()) + ".partial");
}

// A new folder, or a file beside its target, which is removed in the end, unless it has been put in place before, also if the
// program is interrupted.
class Unfinished : boost::noncopyable
{
public:
  Unfinished(fs::path path, fs::path target) : path_(std::move(path)), target_(std::move(target)) {}
  ~Unfinished()
  {
    if(!is_listed_)
      return;
    const List_lock lock;
    remove();
    leave_list(lock);
  }

  // Makes it by a function that asks for no memory, and returns what that does: an error if it is negative.
  template <class Make>
  int make(const Make& make_it)
  {
    const List_lock lock;
    const int result = make_it(path_.c_str());
    if(result < 0)
      return -errno;
    is_listed_ = true;
    older_ = newest_unfinished;
    newest_unfinished = this;
    if(older_ != nullptr)
      older_->newer_ = this;
    return result;
  }

  // Returns the error. A folder is in place already, and what could not be made never is.
  int put_in_place(const List_lock& lock)
  {
    if(!is_listed_)
      return 0;
    if(!target_.empty() && ::rename(path_.c_str(), target_.c_str()) != 0)
      return errno;
    leave_list(lock);
    return 0;
  }

  const fs::path& target() const { return target_; }

  void remove() const { target_.empty() ? ::rmdir(path_.c_str()) : ::unlink(path_.c_str()); }
  const Unfinished* older() const { return older_; }

private:
  void leave_list(const List_lock&)
  {
    is_listed_ = false;
    (newer_ == nullptr ? newest_unfinished : newer_->older_) = older_;
    if(older_ != nullptr)
      older_->newer_ = newer_;
  }

  const Interrupt_guard guard_;
  const fs::path path_, target_; // no target of a folder
  bool is_listed_ = false;
  Unfinished *older_ = nullptr, *newer_ = nullptr;
};

void remove_unfinished(int signal)
{
  List_lock::take();
  for(const Unfinished* i = newest_unfinished; i != nullptr; i = i->older())
    i->remove();
  ::signal(signal, SIG_DFL);
  raise(signal);
}

// A new file with the owner and the mode of that which it will replace; nobody else reads it before.
int create_temporary(const char* path, const File_status* replaced)
{
  const int file = ::open(path, O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, replaced != nullptr ? 0600 : 0666);
  if(file >= 0 && replaced != nullptr && (fchown(file, replaced->st_uid, replaced->st_gid) == 0 || errno == EPERM))
    fchmod(file, replaced->st_mode & 07777U);
  return file;
}

// A file descriptor, or an error that is negative, as below.
int open_at_once(const fs::path& path)
{
  const bool is_standard = is_standard_output(path);
  if(is_standard) // To open it again would mean to begin at the begin of a file.
    std::cout.flush();
  const int file = is_standard ? fcntl(STDOUT_FILENO, F_DUPFD_CLOEXEC, 0) : ::open(path.c_str(), O_WRONLY | O_CLOEXEC);
  return file < 0 ? -errno : file;
}

int open_beside(const fs::path& target, Unfinished& unfinished)
{
  File_status old = {};
  const bool is_replaced = look_up(target, old);
  return unfinished.make([&](const char* path) { return create_temporary(path, is_replaced ? &old : nullptr); });
}

void write_stream(const fs::path& path, int file, const std::function<void(std::ostream&)>& write)
{
  int error = 0;
  bool is_written = false;
  {
    boost::iostreams::stream<File_sink> stream(File_sink{file, &error}, 1 << 16);
    write(stream);
    is_written = !stream.fail();
  }
  if(!is_written || error != 0)
    throw output_error(path, error);
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
  std::list<Unfinished> made; // the newest first, which is to be removed first
  std::vector<fs::path> to_be_removed;
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
  int error = 0;
  auto last = files_->made.rbegin();
  {
    const List_lock lock;
    for(; last != files_->made.rend(); ++last)
      if(error = last->put_in_place(lock); error != 0)
        break;
    if(error == 0)
      for(const fs::path& path : files_->to_be_removed)
        ::unlink(path.c_str());
  }
  if(error != 0)
    throw output_error(last->target(), error);
  files_->made.clear();
  files_->to_be_removed.clear();
}

void write_file(const fs::path& path, const std::function<void(std::ostream&)>& write)
{
  Output_group group;
  std::optional<Progress_bar> progress_bar;
  int file = 0;
  if(is_written_at_once(path)) // which may be on the terminal, as the bar is
    file = open_at_once(path);
  else
  {
    std::error_code ignored; // of a path that cannot be looked up, as it will be told
    if(fs::is_directory(path, ignored))
      throw output_error(path, EISDIR);
    const fs::path target = target_of(path);
    file = open_beside(target, files_of_thread->made.emplace_front(temporary_path_beside(target), target));
    progress_bar.emplace("writing");
  }
  if(file < 0)
    throw output_error(path, -file);
  write_stream(path, file, write);
  group.put_in_place();
}

void make_folder(const fs::path& path)
{
  Output_group group;
  fs::path folder;
  for(const fs::path& part : path)
  {
    folder /= part;
    std::error_code error;
    if(fs::is_directory(folder, error) || part.empty())
      continue;
    const int result = files_of_thread->made.emplace_front(folder, fs::path()).make([](const char* name) {
      return ::mkdir(name, 0777);
    });
    if(result < 0 && !fs::is_directory(folder, error)) // which another program may have made meanwhile
      throw Output_error(path.string() + ": the folder cannot be made: " + std::generic_category().message(-result));
  }
  group.put_in_place();
}

void remove_file(const fs::path& path)
{
  Output_group group;
  files_of_thread->to_be_removed.push_back(path);
  group.put_in_place();
}

} // namespace reeb_graph_program
