// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of the CGAL-style package Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_PYTHON_FUNCTIONS_H
#define CGAL_REEB_GRAPH_PYTHON_FUNCTIONS_H

#include "arrays.h"

#include <pybind11/pybind11.h>

namespace reeb_graph_python {
// Adds the functions that compute fields, and those that cut along curves.
void add_functions(py::module_& module);

// Makes exceptions of C++ those of Python.
void translate_exceptions();

} // namespace reeb_graph_python

#endif // CGAL_REEB_GRAPH_PYTHON_FUNCTIONS_H
