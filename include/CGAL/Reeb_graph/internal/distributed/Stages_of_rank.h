// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of the CGAL-style package Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_INTERNAL_DISTRIBUTED_STAGES_OF_RANK_H
#define CGAL_REEB_GRAPH_INTERNAL_DISTRIBUTED_STAGES_OF_RANK_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/internal/base/Progress.h>
#include <CGAL/Reeb_graph/internal/distributed/exchange.h>
#include <CGAL/Reeb_graph/visitor.h>

#include <CGAL/Named_function_parameters.h>

#include <optional>

namespace CGAL {
namespace Reeb_graph {
namespace internal {

// Leads all ranks from stage to stage. The visitor of each rank is told, the callback of rank 0 is asked, and what any
// of them throws, all ranks throw.
template <class Visitor>
class Stages_of_rank
{
public:
  template <class NamedParameters>
  Stages_of_rank(Exchange& exchange, Visitor& visitor, const NamedParameters& np)
    : exchange_(exchange),
      visitor_(visitor),
      progress_(exchange.rank() == 0 ? Progress(np) : Progress(parameters::default_values()))
  {}

  // Ends a stage, if there has been one, and begins another one, at a fraction of the whole. Collective.
  void go_on(double fraction, Stage next)
  {
    exchange_.in_agreement([&] {
      if(last_)
        visitor_.end_stage(*last_);
      progress_.report(fraction);
      last_ = next;
      visitor_.begin_stage(next);
    });
  }

  // Ends the last stage. There is nothing left to cancel. Collective.
  void end()
  {
    exchange_.in_agreement([&] {
      visitor_.end_stage(*last_);
      progress_.report_end();
    });
  }

  // Collective.
  void tell_critical_vertices(const Critical_vertex_counts& counts)
  {
    exchange_.in_agreement([&] { visitor_.critical_vertices(counts); });
  }

  Stage_progress part(double begin, double end) const { return {progress_, begin, end}; }

private:
  Exchange& exchange_;
  Visitor& visitor_;
  const Progress progress_;
  std::optional<Stage> last_;
};

} // namespace internal
} // namespace Reeb_graph
} // namespace CGAL

#endif // CGAL_REEB_GRAPH_INTERNAL_DISTRIBUTED_STAGES_OF_RANK_H
