// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_SKELETON_INTERNAL_SKELETON_OPTIONS_H
#define CGAL_REEB_GRAPH_SKELETON_INTERNAL_SKELETON_OPTIONS_H

#include <CGAL/license/Reeb_graph.h>

namespace CGAL::Reeb_graph::internal::skeleton {

// How far branches are pruned, and how dense and smooth lines are, with the defaults of the parameters.
struct Skeleton_options
{
  double pruning_ratio = 0.5;
  double sampling_ratio = 0.5;
  double spacing = 0; // of the points, if they are to be at equal steps
  double smooth = 1;
  bool are_borders_ends = true;
};

} // namespace CGAL::Reeb_graph::internal::skeleton

#endif // CGAL_REEB_GRAPH_SKELETON_INTERNAL_SKELETON_OPTIONS_H
