// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of the CGAL-style package Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_SRC_INPUT_ERROR_H
#define CGAL_REEB_GRAPH_SRC_INPUT_ERROR_H

#include <cstddef>
#include <stdexcept>
#include <string>

namespace reeb_graph_program {
// What is wrong with an input file, and where.
class Input_error : public std::runtime_error
{
public:
  Input_error(const std::string& path, const std::string& message) : std::runtime_error(path + ": " + message) {}
  Input_error(const std::string& path, std::size_t line, const std::string& message)
    : std::runtime_error(path + ":" + std::to_string(line) + ": " + message)
  {}
};

} // namespace reeb_graph_program

#endif // CGAL_REEB_GRAPH_SRC_INPUT_ERROR_H
