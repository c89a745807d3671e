// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

// An object of its own, so that only who looks for loops has it.
#define CGAL_REEB_GRAPH_LOOPS
#define CGAL_REEB_GRAPH_DEFINE_LOOPS
#include <CGAL/Reeb_graph/handles/area_of_filling_disc.h>
#include <CGAL/Reeb_graph/handles/internal/make_loops.h>
