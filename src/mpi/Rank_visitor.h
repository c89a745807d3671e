// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_SRC_RANK_VISITOR_H
#define CGAL_REEB_GRAPH_SRC_RANK_VISITOR_H

#include "base/report.h"
#include "base/stopwatch.h"
#include "computation/Report_visitor.h"

#include <CGAL/Reeb_graph/options.h>

#include <ctime>
#include <string>
#include <utility>

namespace reeb_graph_program {
// The seconds of CPU that the process has spent.
inline double cpu_seconds_of_process()
{
  timespec time = {};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

// Notes what a step takes: its seconds in the report, and those of CPU in that of the rank.
class Step
{
public:
  Step(const std::string& name, Report& report, Rank_report& rank) : name_(name), report_(report), rank_(rank) {}
  Step(const Step&) = delete;
  Step& operator=(const Step&) = delete;

  void end()
  {
    report_.seconds.emplace_back(name_, stopwatch_.seconds());
    rank_.cpu_seconds.emplace_back(name_, cpu_seconds_of_process() - first_cpu_seconds_);
  }

private:
  std::string name_;
  Report& report_;
  Rank_report& rank_;
  Stopwatch stopwatch_;
  double first_cpu_seconds_ = cpu_seconds_of_process();
};

// Notes what each stage of the computation takes: its seconds in the report, and those of CPU in that of the rank.
class Rank_visitor
{
public:
  Rank_visitor(Report& report, Rank_report& rank) : visitor_(report), report_(report), rank_(rank) {}

  void begin_stage(CGAL::Reeb_graph::Stage stage)
  {
    visitor_.begin_stage(stage);
    first_cpu_seconds_ = cpu_seconds_of_process();
  }
  void end_stage(CGAL::Reeb_graph::Stage stage)
  {
    visitor_.end_stage(stage);
    rank_.cpu_seconds.emplace_back(report_.seconds.back().first, cpu_seconds_of_process() - first_cpu_seconds_);
  }
  void critical_vertices(const CGAL::Reeb_graph::Critical_vertex_counts& counts) { visitor_.critical_vertices(counts); }

private:
  Report_visitor visitor_;
  Report& report_;
  Rank_report& rank_;
  double first_cpu_seconds_ = 0;
};

} // namespace reeb_graph_program

#endif // CGAL_REEB_GRAPH_SRC_RANK_VISITOR_H
