// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_TEST_TEST_HEADERS_H
#define CGAL_REEB_GRAPH_TEST_TEST_HEADERS_H

// What most of the tests begin with, to be precompiled. Tests include what they use nevertheless.
#include "mesh_builders.h"

#include <CGAL/Reeb_graph/Augmentation.h>
#include <CGAL/compute_reeb_graph.h>

#include <boost/mpl/list.hpp>
#include <boost/test/unit_test.hpp>

#include <algorithm>
#include <map>
#include <set>
#include <string>
#include <vector>

#endif // CGAL_REEB_GRAPH_TEST_TEST_HEADERS_H
