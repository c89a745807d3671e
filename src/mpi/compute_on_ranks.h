// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_SRC_COMPUTE_ON_RANKS_H
#define CGAL_REEB_GRAPH_SRC_COMPUTE_ON_RANKS_H

#include "commands/commands.h"
#include "mpi/ranks.h"

namespace reeb_graph_program {
// Rank 0 prints to std::cout and writes the files of the graph. All ranks throw the same exception, derived from
// std::exception, for any error. Collective.
void run_compute_on_ranks(const Communicator& communicator, const Compute_options& options);

} // namespace reeb_graph_program

#endif // CGAL_REEB_GRAPH_SRC_COMPUTE_ON_RANKS_H
