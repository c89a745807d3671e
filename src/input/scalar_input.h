// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_SRC_SCALAR_INPUT_H
#define CGAL_REEB_GRAPH_SRC_SCALAR_INPUT_H

#include "base/options.h"

#include <cstddef>
#include <string>
#include <vector>

namespace reeb_graph_program {
// Reads one number per line, whatever the locale, or a column of a CSV file, which is one if its name ends in .csv or
// if a column is given: by its number, from 0, or by its name in the first line. The column is not needed if there is
// only one. Lines that begin with # are comments. Throws Input_error unless there are as many numbers as vertices.
std::vector<double> read_scalars(const std::string& path, const std::string& column, std::size_t number_of_vertices);

// Reads a threshold: a number that is not negative, a percentage, P%, or auto. Throws std::runtime_error.
Threshold parse_threshold(const std::string& text);

// Reads a length: a number that is not negative, or a percentage of another length, P%. Throws std::runtime_error.
Threshold parse_size(const std::string& text);

} // namespace reeb_graph_program

#endif // CGAL_REEB_GRAPH_SRC_SCALAR_INPUT_H
