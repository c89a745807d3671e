// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of the CGAL-style package Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#include "run.h"

#include "base/progress_bar.h"
#include "base/threads.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <condition_variable>
#include <exception>
#include <memory>
#include <mutex>
#include <thread>
#include <utility>
#include <vector>

namespace reeb_graph_python {
namespace {
namespace py = pybind11;

class Running_work
{
public:
  Running_work(std::size_t number_of_threads, std::function<void()> work)
    : work_(std::move(work)),
      thread_([this, number_of_threads] { do_work(number_of_threads); })
  {}
  Running_work(const Running_work&) = delete;
  Running_work& operator=(const Running_work&) = delete;
  ~Running_work()
  {
    is_stopped_ = true;
    thread_.join();
  }

  void stop() { is_stopped_ = true; }
  double fraction() const { return fraction_; }

  // Whether the work has ended within so much time.
  bool wait(std::chrono::milliseconds time)
  {
    std::unique_lock lock(mutex_);
    return ended_.wait_for(lock, time, [this] { return has_ended_; });
  }

  void rethrow_error() const
  {
    if(error_)
      std::rethrow_exception(error_);
  }

private:
  void do_work(std::size_t number_of_threads)
  {
    const std::function<bool(double)> listener = [this](double fraction) {
      fraction_ = fraction;
      return !is_stopped_;
    };
    try
    {
      reeb_graph_program::run_with_threads(number_of_threads, [&] {
        const reeb_graph_program::Progress_listener listening(listener);
        work_();
      });
    }
    catch(...)
    {
      error_ = std::current_exception();
    }
    const std::lock_guard lock(mutex_);
    has_ended_ = true;
    ended_.notify_one();
  }

  std::function<void()> work_;
  std::atomic<double> fraction_ = 0;
  std::atomic<bool> is_stopped_ = false;
  std::mutex mutex_;
  std::condition_variable ended_;
  bool has_ended_ = false;
  std::exception_ptr error_;
  std::thread thread_; // the last one: it uses the others
};

void tell(const py::object& progress, double fraction)
{
  if(progress(fraction).is(py::bool_(false)))
    throw Stopped_error();
}

// With the interpreter's lock.
void attend(const py::object& progress, const Running_work& work, double& told)
{
  if(PyErr_CheckSignals() != 0)
    throw py::error_already_set();
  if(!progress.is_none() && work.fraction() > told)
  {
    told = work.fraction();
    tell(progress, told);
  }
}

// Work that was stopped, and goes on until it looks for that. The end of the interpreter waits for it. All of this is
// used with the interpreter's lock.
std::vector<std::unique_ptr<Running_work>>& stopped_work()
{
  static auto* const works = new std::vector<std::unique_ptr<Running_work>>;
  return *works;
}

} // namespace

void run(const py::object& progress, std::size_t number_of_threads, std::function<void()> work, bool owns_all_it_uses)
{
  constexpr std::chrono::milliseconds turn(30), patience(300);
  double told = -1;
  std::unique_ptr<Running_work> running;
  try
  {
    const py::gil_scoped_release released;
    running = std::make_unique<Running_work>(number_of_threads, std::move(work));
    while(!running->wait(turn))
    {
      const py::gil_scoped_acquire acquired;
      attend(progress, *running, told);
    }
  }
  catch(...)
  {
    if(running)
    {
      const py::gil_scoped_release released;
      running->stop();
      if(!owns_all_it_uses || running->wait(patience))
        running.reset();
    }
    if(running)
    {
      auto& works = stopped_work();
      works.erase(std::remove_if(works.begin(), works.end(), [](const auto& work) { return work->wait({}); }),
                  works.end());
      works.push_back(std::move(running));
    }
    throw;
  }
  running->rethrow_error();
  if(!progress.is_none() && told < 1)
    progress(1.);
}

void wait_for_stopped_work()
{
  std::vector<std::unique_ptr<Running_work>> works;
  works.swap(stopped_work());
  const py::gil_scoped_release released;
  works.clear();
}

} // namespace reeb_graph_python
