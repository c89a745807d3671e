// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of the CGAL-style package Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_PYTHON_RUN_H
#define CGAL_REEB_GRAPH_PYTHON_RUN_H

#include <pybind11/pybind11.h>

#include <cstddef>
#include <functional>
#include <stdexcept>

namespace reeb_graph_python {
// The function that is told how far the work is has stopped it.
struct Stopped_error : std::runtime_error
{
  Stopped_error() : std::runtime_error("the function progress has stopped the work") {}
};

// Does the work in a thread of its own, with so many threads for what is parallel, 0 for one per core. The interpreter's
// lock is released. Meanwhile this thread looks for signals, which the work could not, and calls `progress`, unless that
// is None: with the fraction that is done; if it returns False, or a signal throws, the work stops. Throws what the work
// throws, error_already_set for a signal or an error of `progress`, and Stopped_error. What is stopped ends when it looks
// for that next; if the work owns all that it uses, this is not waited for longer than a moment.
void run(const pybind11::object& progress,
         std::size_t number_of_threads,
         std::function<void()> work,
         bool owns_all_it_uses = false);

// To be called before the interpreter ends.
void wait_for_stopped_work();

} // namespace reeb_graph_python

#endif // CGAL_REEB_GRAPH_PYTHON_RUN_H
