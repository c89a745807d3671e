// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

// Boost.Test itself and the main function, compiled once for all tests: no library has to be installed.
#define BOOST_TEST_MODULE Reeb_graph
#include <boost/test/included/unit_test.hpp>
