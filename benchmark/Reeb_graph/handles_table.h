// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_BENCHMARK_HANDLES_TABLE_H
#define CGAL_REEB_GRAPH_BENCHMARK_HANDLES_TABLE_H

#include "Table.h"
#include "inputs.h"
#include "measurements.h"
#include "tables.h"
#include "timed_runs.h"

#include <CGAL/Reeb_graph/handles/handle_and_tunnel_loops.h>

#include <algorithm>
#include <cstddef>
#include <string>

// Handles and tunnels, beside the graph of the same field.
namespace benchmark {
inline double time_loops(const Input& input, bool are_shortened, bool is_checked)
{
  namespace parameters = CGAL::parameters;
  return milliseconds([&] {
    CGAL::Reeb_graph::handle_and_tunnel_loops(
      input.mesh(), input.scalar_map(), parameters::shorten_loops(are_shortened).check_self_intersections(is_checked));
  });
}

inline void print_handles(const Options& options)
{
  const Table table("Handles and tunnels, long, with a test for self-intersections, and shortened; one thread",
                    {{"surface", "", 9},
                     {"vertices", "", 8},
                     {"graph", "ms", 7},
                     {"long", "ms", 8},
                     {"long", "/ graph"},
                     {"tested", "ms", 8},
                     {"short", "ms", 8}});
  for(const std::size_t size : options.sizes)
    for(const std::string surface : {"genus-3", "genus-25", "genus-133"})
    {
      Input input(surface, surface == "genus-133" ? size / 20 : size);
      input.set_field("smooth");
      Engine_times graph_times;
      Sample long_loops, tested_loops, short_loops;
      for(std::size_t repetition = 0; repetition != (std::min<std::size_t>)(options.number_of_repetitions, 3);
          ++repetition)
      {
        run_engine(input, Method::CONTOUR_TREES, 1, graph_times);
        long_loops.add(time_loops(input, false, false));
        tested_loops.add(time_loops(input, false, true));
      }
      short_loops.add(time_loops(input, true, false));
      table.print_row({surface, cell(std::size_t(input.mesh().number_of_vertices())),
                       cell(graph_times.total.median(), 1), cell(long_loops.median(), 0),
                       cell(ratio(long_loops.median(), graph_times.total.median()), 1), cell(tested_loops.median(), 0),
                       cell(short_loops.median(), 0)});
    }
}

} // namespace benchmark

#endif // CGAL_REEB_GRAPH_BENCHMARK_HANDLES_TABLE_H
