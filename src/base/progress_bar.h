// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_SRC_PROGRESS_BAR_H
#define CGAL_REEB_GRAPH_SRC_PROGRESS_BAR_H

#include "base/costs.h"

#include <boost/core/noncopyable.hpp>

#include <condition_variable>
#include <cstddef>
#include <functional>
#include <optional>
#include <ostream>
#include <string>
#include <thread>

namespace reeb_graph_program {
// Shows how far long work is. It appears after a while only, also if the work does not say how far it is, and is gone
// when the work is done. Of several bars of a thread, the last one is shown.
class Progress_bar : boost::noncopyable
{
public:
  // To the Progress_listener of this thread if there is one, else on standard error if that is a terminal.
  explicit Progress_bar(const std::string& name_of_work);
  Progress_bar(const std::string& name_of_work, std::ostream* terminal, double seconds_until_shown);
  ~Progress_bar();

  // The form that the named parameter `callback` has: `fraction` is between 0 and 1, and the work shall go on unless
  // the listener says no.
  bool operator()(double fraction);

  // Makes room for other messages.
  void clear();

private:
  void show();
  void show_if_long();
  void wait_and_show();
  void remove_line();

  std::string name_of_work_;
  std::ostream* terminal_; // null if nothing is shown
  double seconds_until_shown_;
  Stopwatch stopwatch_;
  std::optional<double> fraction_;
  std::size_t shown_width_ = 0;
  const std::function<bool(double)>* listener_ = nullptr;
  Progress_bar* outer_;
  bool is_covered_ = false; // by one within it
  bool is_done_ = false;
  std::condition_variable end_of_work_;
  std::thread timer_;
};

// As long as it lives, the bars that its thread makes show nothing, and ask this function instead whether to go on. It
// is called by any thread that does the work.
class Progress_listener : boost::noncopyable
{
public:
  explicit Progress_listener(const std::function<bool(double)>& listener);
  ~Progress_listener();

private:
  const std::function<bool(double)>* outer_;
};

} // namespace reeb_graph_program

#endif // CGAL_REEB_GRAPH_SRC_PROGRESS_BAR_H
