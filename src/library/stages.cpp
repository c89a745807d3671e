// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

// The stages of the pipeline, which need no TBB: internal/base/compiled.h tells more. These are the headers with functions
// of the seam, but those of loops.cpp, skeletons.cpp and solvers.cpp, and what they are compiled for.
#define CGAL_REEB_GRAPH_STAGES

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

// before those below, which instantiate what classifies vertices of complexes, too
#include <CGAL/Reeb_graph/internal/engine/loops_of_complexes.h>

#include <CGAL/Reeb_graph/Augmentation.h>
#include <CGAL/Reeb_graph/Complex_augmentation.h>
#include <CGAL/Reeb_graph/simplification/simplify_field.h>
#include <CGAL/compute_reeb_graph.h>
#include <CGAL/compute_reeb_graph_of_soup.h>
