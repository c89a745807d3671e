// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#include "base/message_of.h"
#include "commands/command_line.h"
#include "mpi/ranks.h"
#include "output/output_file.h"

#include <CGAL/version.h>

#include <CLI/CLI.hpp>

#include <boost/mpi/environment.hpp>

#include <mpi.h>

#include <csignal>
#include <cstdlib>
#include <exception>
#include <iostream>
#include <memory>
#include <string>

namespace reeb_graph_program {
namespace {
void add_compute_on_ranks_command(CLI::App& app, Compute_options& options)
{
  CLI::App* command = add_compute_command(app, options);
  command->description("Compute the Reeb graph of a scalar field on a surface that the ranks share");
  command->get_option("MESH")->description("Mesh: a binary PLY file of triangles, or a raw file");
  add_list_of_fields(*command, "--field", coordinate_fields + height_field + fields_of_files);
  add_example(*command, "mpirun -n 4 reeb_graph_mpi compute scan.ply --field z --simplify auto --graph graph.graphml");
}

// Waits for the other ranks. Returns whether all of them have come: if one has failed alone, the others still wait for
// it elsewhere.
bool do_all_come(MPI_Comm communicator)
{
  constexpr double patience = 10; // seconds
  MPI_Request request = MPI_REQUEST_NULL;
  MPI_Ibarrier(communicator, &request);
  int have_come = 0;
  for(const double start = MPI_Wtime(); have_come == 0 && MPI_Wtime() - start < patience;)
    MPI_Test(&request, &have_come, MPI_STATUS_IGNORE);
  return have_come != 0;
}

// Rank 0 says what is wrong. A rank that fails alone does, and ends all of them.
int end_with_error(const Communicator& communicator, const Communicator& meeting, const std::string& message)
{
  const bool is_common = do_all_come(meeting);
  if(communicator.rank() == 0 || !is_common)
    std::cerr << "reeb_graph_mpi: error: " << message << std::endl;
  if(!is_common)
    communicator.abort(EXIT_FAILURE);
  return EXIT_FAILURE;
}

// Reads the command line. Rank 0 prints the help that is asked for there. Collective.
bool is_help_printed(CLI::App& app, int argc, char** argv, const Communicator& communicator)
{
  try
  {
    app.parse(argc, argv);
    return false;
  }
  catch(const CLI::Success& request_for_help)
  {
    run_on_rank_0(communicator, [&] {
      app.exit(request_for_help);
      flush_standard_output();
    });
    return true;
  }
}

int run(int argc, char** argv, const Communicator& communicator, const Communicator& meeting)
{
  CLI::App app("Exact Reeb graphs of scalar fields on surfaces that the ranks of MPI share", "reeb_graph_mpi");
  app.formatter(std::make_shared<Help_formatter>());
  app.require_subcommand(1);
  app.set_version_flag("--version",
                       "reeb_graph_mpi " REEB_GRAPH_VERSION " (CGAL " CGAL_VERSION_STR ", " REEB_GRAPH_COMPILER ")");
  Compute_options options;
  add_compute_on_ranks_command(app, options);
  try
  {
    if(!is_help_printed(app, argc, argv, communicator))
      run_compute_on_ranks(communicator, options);
    return EXIT_SUCCESS;
  }
  catch(const CLI::ParseError& error)
  {
    return end_with_error(communicator, meeting, describe(app, error));
  }
  catch(const std::exception& error)
  {
    return end_with_error(communicator, meeting, message_of(error));
  }
}

} // namespace
} // namespace reeb_graph_program

int main(int argc, char** argv)
{
  std::signal(SIGXFSZ, SIG_IGN); // A file that may not grow is an error, as a full disk is.
  const boost::mpi::environment environment(argc, argv);
  const reeb_graph_program::Communicator communicator;
  const reeb_graph_program::Communicator meeting(communicator, boost::mpi::comm_duplicate);
  return reeb_graph_program::run(argc, argv, communicator, meeting);
}
