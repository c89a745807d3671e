// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of the CGAL-style package Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors
#ifndef CGAL_REEB_GRAPH_INTERNAL_DISTRIBUTED_AGREEMENT_H
#define CGAL_REEB_GRAPH_INTERNAL_DISTRIBUTED_AGREEMENT_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/internal/distributed/Fault.h>
#include <CGAL/Reeb_graph/internal/distributed/wait_for.h>

#include <boost/mpi/collectives.hpp>
#include <boost/mpi/communicator.hpp>
#include <boost/mpi/exception.hpp>

#include <exception>
#include <string>
#include <vector>

namespace CGAL {
namespace Reeb_graph {
namespace internal {

// Throws on all ranks the first of the faults that some of them have: a copy where it is another rank's. Collective.
inline void throw_first_fault(const boost::mpi::communicator& communicator,
                              const Fault& own,
                              const std::exception_ptr& own_exception)
{
  namespace mpi = boost::mpi;
  const int is_thrown = own_exception != nullptr ? 1 : 0;
  int is_thrown_anywhere = 0;
  MPI_Request request = MPI_REQUEST_NULL;
  BOOST_MPI_CHECK_RESULT(MPI_Iallreduce,
                         (&is_thrown, &is_thrown_anywhere, 1, MPI_INT, MPI_MAX, communicator, &request));
  wait_for(request); // Most waiting for ranks with more work is here.
  if(is_thrown_anywhere == 0)
    return;
  const auto numbers = own.numbers();
  std::vector<Fault::Numbers::value_type> all(numbers.size() * static_cast<std::size_t>(communicator.size()));
  mpi::all_gather(communicator, numbers.data(), static_cast<int>(numbers.size()), all.data());
  const int rank = Fault::rank_of_first(all);
  std::string text = own.text();
  mpi::broadcast(communicator, text, rank);
  if(rank == communicator.rank())
    std::rethrow_exception(own_exception);
  Fault::rethrow(rank, all, text);
}

// Calls the function, which must not wait for another rank. If it throws on some ranks, all of them throw the same
// exception, that with the least index. Collective.
template <class Function>
void run_in_agreement(const boost::mpi::communicator& communicator, const Function& function)
{
  std::exception_ptr exception;
  Fault fault;
  try
  {
    function();
  }
  catch(...)
  {
    exception = std::current_exception();
    fault = Fault::of_current_exception();
  }
  throw_first_fault(communicator, fault, exception);
}

} // namespace internal
} // namespace Reeb_graph
} // namespace CGAL

#endif // CGAL_REEB_GRAPH_INTERNAL_DISTRIBUTED_AGREEMENT_H
