// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_SRC_NPY_INPUT_H
#define CGAL_REEB_GRAPH_SRC_NPY_INPUT_H

#include <cstddef>
#include <string>
#include <vector>

namespace reeb_graph_program {
// The numbers of a file of NumPy, one for each vertex: an array of one dimension of floating-point numbers or integers,
// of any byte order. Throws Input_error, also for an integer that no double is equal to.
std::vector<double> read_npy(const std::string& path, std::size_t number_of_vertices);

} // namespace reeb_graph_program

#endif // CGAL_REEB_GRAPH_SRC_NPY_INPUT_H
