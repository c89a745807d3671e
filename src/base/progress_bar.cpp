// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#include "base/progress_bar.h"

#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <iostream>
#include <mutex>
#include <system_error>

namespace reeb_graph_program {
namespace {
const std::function<bool(double)>*& listener_of_thread()
{
  thread_local const std::function<bool(double)>* listener = nullptr;
  return listener;
}

Progress_bar*& innermost_bar_of_thread()
{
  thread_local Progress_bar* bar = nullptr;
  return bar;
}

// Bars, and what shows them, may belong to several threads.
std::mutex& mutex_of_terminal()
{
  static std::mutex mutex;
  return mutex;
}

} // namespace

Progress_bar::Progress_bar(const std::string& name_of_work)
  : Progress_bar(name_of_work,
                 listener_of_thread() == nullptr && isatty(STDERR_FILENO) == 1 ? &std::cerr : nullptr,
                 0.5)
{
  listener_ = listener_of_thread();
}

Progress_bar::Progress_bar(const std::string& name_of_work, std::ostream* terminal, double seconds_until_shown)
  : name_of_work_(name_of_work),
    terminal_(terminal),
    seconds_until_shown_(seconds_until_shown),
    outer_(innermost_bar_of_thread())
{
  innermost_bar_of_thread() = this;
  if(outer_ != nullptr)
  {
    const std::lock_guard<std::mutex> lock(mutex_of_terminal());
    outer_->is_covered_ = true;
    outer_->remove_line();
  }
  if(terminal_ == nullptr || seconds_until_shown_ <= 0)
    return;
  try
  {
    timer_ = std::thread([this] { wait_and_show(); });
  }
  catch(const std::system_error&) // where there are no threads, what takes long is not known before
  {
    seconds_until_shown_ = 0;
    show();
  }
}

Progress_bar::~Progress_bar()
{
  innermost_bar_of_thread() = outer_;
  {
    const std::lock_guard<std::mutex> lock(mutex_of_terminal());
    is_done_ = true;
    remove_line();
    if(outer_ != nullptr)
    {
      outer_->is_covered_ = false;
      outer_->show_if_long();
    }
  }
  end_of_work_.notify_one();
  if(timer_.joinable())
    timer_.join();
}

// Work without steps shows its name, too.
void Progress_bar::wait_and_show()
{
  std::unique_lock<std::mutex> lock(mutex_of_terminal());
  const std::chrono::duration<double> time(seconds_until_shown_);
  if(!end_of_work_.wait_for(lock, time, [&] { return is_done_; }) && shown_width_ == 0)
    show();
}

bool Progress_bar::operator()(double fraction)
{
  if(listener_ != nullptr)
    return (*listener_)(fraction);
  if(terminal_ == nullptr)
    return true;
  const std::lock_guard<std::mutex> lock(mutex_of_terminal());
  fraction_ = std::clamp(fraction, 0., 1.);
  show_if_long();
  return true;
}

void Progress_bar::show_if_long()
{
  if(terminal_ != nullptr && stopwatch_.seconds() >= seconds_until_shown_)
    show();
}

void Progress_bar::show()
{
  if(is_covered_)
    return;
  std::string line = name_of_work_ + " ...";
  if(fraction_)
  {
    constexpr std::size_t width = 40;
    const auto filled = static_cast<std::size_t>(*fraction_ * width);
    const std::string percentage = std::to_string(static_cast<int>(100 * *fraction_));
    line = name_of_work_ + " [" + std::string(filled, '#') + std::string(width - filled, ' ') + "] "
         + std::string(3 - std::min<std::size_t>(3, percentage.size()), ' ') + percentage + " %";
  }
  *terminal_ << '\r' << line << std::flush;
  shown_width_ = line.size();
}

void Progress_bar::clear()
{
  const std::lock_guard<std::mutex> lock(mutex_of_terminal());
  remove_line();
}

void Progress_bar::remove_line()
{
  if(shown_width_ > 0)
    *terminal_ << '\r' << std::string(shown_width_, ' ') << '\r' << std::flush;
  shown_width_ = 0;
}

Progress_listener::Progress_listener(const std::function<bool(double)>& listener) : outer_(listener_of_thread())
{
  listener_of_thread() = &listener;
}

Progress_listener::~Progress_listener() { listener_of_thread() = outer_; }

} // namespace reeb_graph_program
