// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_SRC_COSTS_H
#define CGAL_REEB_GRAPH_SRC_COSTS_H

#include <sys/resource.h>
#include <unistd.h>

#include <chrono>
#include <cstddef>

namespace reeb_graph_program {
// The most memory that the process has had at any time.
inline std::size_t peak_memory_bytes()
{
#ifdef __APPLE__
  constexpr std::size_t unit = 1;
#else
  constexpr std::size_t unit = 1024;
#endif
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  // WebAssembly does not count, but its memory never gets smaller.
  return usage.ru_maxrss == 0 ? reinterpret_cast<std::size_t>(sbrk(0))
                              : unit * static_cast<std::size_t>(usage.ru_maxrss);
}

class Stopwatch
{
public:
  double seconds() const { return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count(); }

private:
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

} // namespace reeb_graph_program

#endif // CGAL_REEB_GRAPH_SRC_COSTS_H
