// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_INTERNAL_BASE_PROGRESS_H
#define CGAL_REEB_GRAPH_INTERNAL_BASE_PROGRESS_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/exceptions.h>
#include <CGAL/Reeb_graph/named_parameters.h>

#include <CGAL/Named_function_parameters.h>

#include <algorithm>
#include <cstddef>
#include <functional>
#include <thread>

namespace CGAL::Reeb_graph::internal {

// Tells the named parameter `callback` how far a computation is, and throws Cancelled_error if it wants no more.
class Progress
{
public:
  template <class NamedParameters>
  explicit Progress(const NamedParameters& np)
    : callback_(internal::parameter_or(np, internal_np::callback, std::function<bool(double)>()))
  {}

  void report(double fraction) const
  {
    if(!call(fraction))
      throw Cancelled_error();
  }

  // How far it is where nothing can be cancelled.
  void tell(double fraction) const { call(fraction); }

  // The end: there is nothing left to cancel.
  void report_end() const { tell(1); }

private:
  // Only the thread that the callback is known on calls it, and never with less than before, as stages run side by side.
  bool call(double fraction) const
  {
    if(std::this_thread::get_id() != thread_)
      return true;
    last_ = (std::max)(last_, fraction);
    return !callback_ || callback_(last_);
  }

  std::function<bool(double)> callback_; // empty if there is none
  std::thread::id thread_ = std::this_thread::get_id();
  mutable double last_ = 0;
};

// Tells how far a stage is, which begins and ends at fractions of the whole. It refers to the progress of the whole.
class Stage_progress
{
public:
  Stage_progress(const Progress& progress, double begin, double end) : progress_(progress), begin_(begin), end_(end) {}

  // A stage of this stage.
  Stage_progress part(double begin, double end) const { return {progress_, of_whole(begin), of_whole(end)}; }

  void operator()(double fraction) const { progress_.report(of_whole(fraction)); }
  void tell(double fraction) const { progress_.tell(of_whole(fraction)); }

  // Reports before some of the steps of a loop.
  void report_step(std::size_t step, std::size_t number_of_steps) const
  {
    if(step % (number_of_steps / 64 + 1) == 0)
      (*this)(static_cast<double>(step) / static_cast<double>(number_of_steps));
  }

  // The named parameter `callback` of a function that does the stage. It throws Cancelled_error itself, also at the
  // end.
  auto callback() const
  {
    return [stage = *this](double fraction) {
      stage(fraction);
      return true;
    };
  }

private:
  // Not more than the end, so that the fractions of one stage after the other ascend.
  double of_whole(double fraction) const { return (std::min)(end_, begin_ + fraction * (end_ - begin_)); }

  const Progress& progress_;
  double begin_, end_;
};

// Progress that nobody wants to know of.
struct No_progress
{
  void operator()(double) const {}
};

} // namespace CGAL::Reeb_graph::internal

#endif // CGAL_REEB_GRAPH_INTERNAL_BASE_PROGRESS_H
