// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

// An object of its own, so that only who extracts skeletons has it.
#define CGAL_REEB_GRAPH_SKELETONS
#define CGAL_REEB_GRAPH_DEFINE_SKELETONS
#include <CGAL/Reeb_graph/skeleton/internal/make_component_skeleton.h>
