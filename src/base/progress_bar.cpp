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
#include <iostream>

namespace reeb_graph_program {
namespace {
const std::function<bool(double)>*& listener_of_thread()
{
  thread_local const std::function<bool(double)>* listener = nullptr;
  return listener;
}

} // namespace

Progress_bar::Progress_bar(const std::string& name_of_work)
  : Progress_bar(name_of_work, isatty(STDERR_FILENO) == 1 ? &std::cerr : nullptr, 0.5)
{
  listener_ = listener_of_thread();
}

Progress_bar::Progress_bar(const std::string& name_of_work, std::ostream* terminal, double seconds_until_shown)
  : name_of_work_(name_of_work),
    terminal_(terminal),
    seconds_until_shown_(seconds_until_shown)
{}

Progress_bar::~Progress_bar() { clear(); }

bool Progress_bar::operator()(double fraction)
{
  if(listener_ != nullptr)
    return (*listener_)(fraction);
  if(terminal_ == nullptr || stopwatch_.seconds() < seconds_until_shown_)
    return true;
  constexpr std::size_t width = 40;
  const double part = std::clamp(fraction, 0., 1.);
  const auto filled = static_cast<std::size_t>(part * width);
  const std::string percentage = std::to_string(static_cast<int>(100 * part));
  const std::string line = name_of_work_ + " [" + std::string(filled, '#') + std::string(width - filled, ' ') + "] "
                         + std::string(3 - std::min<std::size_t>(3, percentage.size()), ' ') + percentage + " %";
  *terminal_ << '\r' << line << std::flush;
  shown_width_ = line.size();
  return true;
}

void Progress_bar::clear()
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
