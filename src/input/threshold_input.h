// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_SRC_THRESHOLD_INPUT_H
#define CGAL_REEB_GRAPH_SRC_THRESHOLD_INPUT_H

#include "base/options.h"

#include <string>

namespace reeb_graph_program {
// Reads a threshold: a number that is not negative, a percentage, P%, or auto. Throws std::runtime_error.
Threshold parse_threshold(const std::string& text);

// Reads a length: a number that is not negative, or a percentage of another length, P%. Throws std::runtime_error.
Threshold parse_size(const std::string& text);

} // namespace reeb_graph_program

#endif // CGAL_REEB_GRAPH_SRC_THRESHOLD_INPUT_H
