// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of the CGAL-style package Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_INTERNAL_BASE_PROGRESS_H
#define CGAL_REEB_GRAPH_INTERNAL_BASE_PROGRESS_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/exceptions.h>

#include <CGAL/Named_function_parameters.h>

#include <functional>

namespace CGAL {
namespace Reeb_graph {
namespace internal {

// Tells the named parameter `callback` how far a computation is, and throws Cancelled_error if it wants no more.
class Progress
{
public:
  template <class NamedParameters>
  explicit Progress(const NamedParameters& np)
    : callback_(parameters::choose_parameter(parameters::get_parameter(np, internal_np::callback), No_callback()))
  {}

  void report(double fraction) const
  {
    if(!callback_(fraction))
      throw Cancelled_error();
  }

  // The end: there is nothing left to cancel.
  void report_end() const { callback_(1); }

private:
  struct No_callback
  {
    bool operator()(double) const { return true; }
  };

  std::function<bool(double)> callback_;
};

// Tells how far a stage is, which begins and ends at fractions of the whole.
class Stage_progress
{
public:
  Stage_progress(const Progress& progress, double begin, double end) : progress_(progress), begin_(begin), end_(end) {}

  void operator()(double fraction) const { progress_.report(begin_ + fraction * (end_ - begin_)); }

private:
  const Progress& progress_;
  double begin_, end_;
};

// Progress that nobody wants to know of.
struct No_progress
{
  void operator()(double) const {}
};

} // namespace internal
} // namespace Reeb_graph
} // namespace CGAL

#endif // CGAL_REEB_GRAPH_INTERNAL_BASE_PROGRESS_H
