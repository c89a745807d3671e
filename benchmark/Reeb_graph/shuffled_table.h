// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_BENCHMARK_SHUFFLED_TABLE_H
#define CGAL_REEB_GRAPH_BENCHMARK_SHUFFLED_TABLE_H

#include "Table.h"
#include "inputs.h"
#include "measurements.h"
#include "tables.h"
#include "timed_runs.h"

#include <cstddef>
#include <string>

// The same surfaces in a bad order of their vertices and faces: each step on them misses the caches.
namespace benchmark {
inline void print_shuffled(const Options& options)
{
  const Table table("With vertices and faces shuffled, one thread: times of the ordered mesh; places: of all vertices",
                    {{"surface", "", 8},
                     {"field", "", 6},
                     {"vertices", "", 8},
                     {"ordered", "ms", 7},
                     {"shuffled", "ms", 8},
                     {"shuffled", "times"},
                     {"places", "ms", 7},
                     {"shuffled", "ms", 8},
                     {"shuffled", "times"}});
  for(const std::size_t size : options.sizes)
    for(const std::string& surface : options.surfaces)
    {
      Input ordered(surface, size), shuffled(surface, size, Mesh_order::SHUFFLED);
      for(const std::string& field : options.fields)
      {
        ordered.set_field(field);
        shuffled.set_field(field);
        const Graph graph = find_properties(ordered).graph, graph_of_shuffled = find_properties(shuffled).graph;
        Engine_times times, times_of_shuffled;
        Sample places, places_of_shuffled;
        for(std::size_t repetition = 0; repetition != options.number_of_repetitions; ++repetition)
        {
          run_engine(ordered, Method::CONTOUR_TREES, 1, times);
          run_engine(shuffled, Method::CONTOUR_TREES, 1, times_of_shuffled);
          places.add(time_vertex_places(ordered, graph));
          places_of_shuffled.add(time_vertex_places(shuffled, graph_of_shuffled));
        }
        const auto time = times.total.median(), time_of_shuffled = times_of_shuffled.total.median();
        table.print_row({surface, field, cell(std::size_t(ordered.mesh().number_of_vertices())), cell(time, 1),
                         cell(time_of_shuffled, 1), cell(ratio(time_of_shuffled, time), 2), cell(places.median(), 1),
                         cell(places_of_shuffled.median(), 1),
                         cell(ratio(places_of_shuffled.median(), places.median()), 2)});
      }
    }
}

} // namespace benchmark

#endif // CGAL_REEB_GRAPH_BENCHMARK_SHUFFLED_TABLE_H
