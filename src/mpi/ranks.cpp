// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#include "mpi/ranks.h"

#include "base/message_of.h"

#include <CGAL/Reeb_graph/distributed/internal/exchange.h>

#include <boost/mpi/collectives.hpp>
#include <boost/mpi/exception.hpp>

#include <mpi.h>

#include <algorithm>
#include <exception>
#include <stdexcept>
#include <string>

namespace reeb_graph_program {
void run_together(const Communicator& communicator, const std::function<void()>& work)
{
  std::string message;
  int failed_rank = communicator.size(); // none
  try
  {
    work();
  }
  catch(const std::exception& error)
  {
    message = message_of(error);
    failed_rank = communicator.rank();
  }
  int first = 0;
  MPI_Request request = MPI_REQUEST_NULL;
  BOOST_MPI_CHECK_RESULT(MPI_Iallreduce, (&failed_rank, &first, 1, MPI_INT, MPI_MIN, communicator, &request));
  CGAL::Reeb_graph::internal::wait_for(request);
  if(first == communicator.size())
    return;
  boost::mpi::broadcast(communicator, message, first);
  throw std::runtime_error(message);
}

void run_on_rank_0(const Communicator& communicator, const std::function<void()>& work)
{
  run_together(communicator, [&] {
    if(communicator.rank() == 0)
      work();
  });
}

Part part_of_rank(const Communicator& communicator, std::uint64_t number)
{
  const auto size = static_cast<std::uint64_t>(communicator.size());
  const auto rank = static_cast<std::uint64_t>(communicator.rank());
  const std::uint64_t each = number / size, more = number % size;
  const auto first = [&](std::uint64_t r) { return r * each + std::min(r, more); };
  return {first(rank), first(rank + 1)};
}

} // namespace reeb_graph_program
