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
#include <future>
#include <memory>
#include <utility>
#include <vector>

namespace reeb_graph_python {
namespace {
namespace py = pybind11;
using std::chrono::milliseconds;

struct State
{
  std::atomic<double> fraction = 0;
  std::atomic<bool> is_stopped = false;
};

bool has_ended(const std::future<void>& work, milliseconds time)
{
  const py::gil_scoped_release released;
  return work.wait_for(time) == std::future_status::ready;
}

// With the interpreter's lock.
void attend(const py::object& progress, double fraction, double& told)
{
  if(PyErr_CheckSignals() != 0)
    throw py::error_already_set();
  if(progress.is_none() || fraction <= told)
    return;
  told = fraction;
  if(progress(fraction).is(py::bool_(false)))
    throw Stopped_error();
}

// Work that was stopped, and goes on until it looks for that. The end of the interpreter waits for it. All of this is
// used with the interpreter's lock.
std::vector<std::future<void>>& stopped_work()
{
  static auto* const works = new std::vector<std::future<void>>;
  return *works;
}

void give_up(std::future<void> work)
{
  auto& works = stopped_work();
  const auto is_over = [](const std::future<void>& w) {
    return w.wait_for(milliseconds(0)) == std::future_status::ready;
  };
  works.erase(std::remove_if(works.begin(), works.end(), is_over), works.end());
  works.push_back(std::move(work));
}

} // namespace

void run(const py::object& progress, std::size_t number_of_threads, std::function<void()> work, bool owns_all_it_uses)
{
  constexpr milliseconds turn(30), patience(300);
  const auto state = std::make_shared<State>();
  std::future<void> running = std::async(std::launch::async, [state, number_of_threads, work = std::move(work)] {
    const std::function<bool(double)> listener = [&](double fraction) {
      state->fraction = fraction;
      return !state->is_stopped;
    };
    reeb_graph_program::run_with_threads(number_of_threads, [&] {
      const reeb_graph_program::Progress_listener listening(listener);
      work();
    });
  });
  double told = -1;
  try
  {
    while(!has_ended(running, turn))
      attend(progress, state->fraction, told);
  }
  catch(...)
  {
    state->is_stopped = true;
    while(!has_ended(running, patience))
      if(owns_all_it_uses)
      {
        give_up(std::move(running));
        break;
      }
    throw;
  }
  running.get();
  if(!progress.is_none() && told < 1)
    progress(1.);
}

void wait_for_stopped_work()
{
  std::vector<std::future<void>> works;
  works.swap(stopped_work());
  const py::gil_scoped_release released;
  works.clear();
}

} // namespace reeb_graph_python
