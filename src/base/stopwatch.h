// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_SRC_STOPWATCH_H
#define CGAL_REEB_GRAPH_SRC_STOPWATCH_H

#include <chrono>

namespace reeb_graph_program {
class Stopwatch
{
public:
  double seconds() const { return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count(); }

private:
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

} // namespace reeb_graph_program

#endif // CGAL_REEB_GRAPH_SRC_STOPWATCH_H
