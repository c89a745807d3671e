// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of the CGAL-style package Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_INTERNAL_DISTRIBUTED_WAIT_FOR_H
#define CGAL_REEB_GRAPH_INTERNAL_DISTRIBUTED_WAIT_FOR_H

#include <CGAL/license/Reeb_graph.h>

#include <boost/mpi/exception.hpp>

#include <mpi.h>

#include <algorithm>
#include <chrono>
#include <thread>

namespace CGAL {
namespace Reeb_graph {
namespace internal {

// Waits until a request is done. MPI itself would keep the core busy, which another rank may need, and which counts as
// work done; whoever waits for longer than a message takes sleeps now and then.
inline void wait_for(MPI_Request& request)
{
  constexpr int tests_without_sleep = 200;
  constexpr std::chrono::microseconds longest_sleep(1000);
  std::chrono::microseconds sleep(20);
  int is_done = 0;
  for(int tests = 0; true; ++tests)
  {
    BOOST_MPI_CHECK_RESULT(MPI_Test, (&request, &is_done, MPI_STATUS_IGNORE));
    if(is_done != 0)
      return;
    if(tests < tests_without_sleep)
      continue;
    std::this_thread::sleep_for(sleep);
    sleep = (std::min)(2 * sleep, longest_sleep);
  }
}

} // namespace internal
} // namespace Reeb_graph
} // namespace CGAL

#endif // CGAL_REEB_GRAPH_INTERNAL_DISTRIBUTED_WAIT_FOR_H
