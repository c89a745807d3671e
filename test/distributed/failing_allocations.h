// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef REEB_GRAPH_TEST_FAILING_ALLOCATIONS_H
#define REEB_GRAPH_TEST_FAILING_ALLOCATIONS_H

#include <cstddef>
#include <limits>

// An allocation of the process can be made to fail.
namespace failing_allocations {
// Only allocations of so many bytes count: arrays with an element for each rank are smaller.
constexpr std::size_t smallest_size = 300;
constexpr std::size_t never = std::numeric_limits<std::size_t>::max();

// How many allocations are left until one fails.
extern std::size_t allocations_left;
} // namespace failing_allocations

#endif // REEB_GRAPH_TEST_FAILING_ALLOCATIONS_H
