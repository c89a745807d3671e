// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_SRC_THREADS_H
#define CGAL_REEB_GRAPH_SRC_THREADS_H

#include <cstddef>
#include <functional>

namespace reeb_graph_program {
constexpr std::size_t largest_number_of_threads = 1024;

// Runs the work with that many threads, with one per core if it is 0. Throws an exception for several threads if the
// program has been built without TBB.
void run_with_threads(std::size_t number_of_threads, const std::function<void()>& work);

// The number of threads that work, 1 without TBB.
std::size_t number_of_threads();

// Calls the task with each number below `number_of_tasks`, on all threads. If tasks throw exceptions, the one of the
// lowest number is thrown here, as if they had come one after the other.
void run_tasks(std::size_t number_of_tasks, const std::function<void(std::size_t)>& task);

} // namespace reeb_graph_program

#endif // CGAL_REEB_GRAPH_SRC_THREADS_H
