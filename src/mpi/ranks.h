// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_SRC_RANKS_H
#define CGAL_REEB_GRAPH_SRC_RANKS_H

#include "commands/commands.h"

#include <boost/mpi/communicator.hpp>

#include <cstdint>
#include <functional>

namespace reeb_graph_program {
typedef boost::mpi::communicator Communicator;

// Calls the work, which must not wait for another rank. If it throws on some ranks, all of them throw an exception with
// the message of the lowest of these ranks. Collective.
void run_together(const Communicator& communicator, const std::function<void()>& work);

// The same for work of rank 0 only.
void run_on_rank_0(const Communicator& communicator, const std::function<void()>& work);

// A contiguous part of things that are numbered from 0.
struct Part
{
  std::uint64_t first = 0, last = 0;

  std::uint64_t size() const { return last - first; }
};

// The rank's part of so many things, of which all ranks have as many, up to one.
Part part_of_rank(const Communicator& communicator, std::uint64_t number);

// Rank 0 prints to std::cout and writes the files of the graph. All ranks throw the same exception, derived from
// std::exception, for any error. Collective.
void run_compute_on_ranks(const Communicator& communicator, const Compute_options& options);

} // namespace reeb_graph_program

#endif // CGAL_REEB_GRAPH_SRC_RANKS_H
