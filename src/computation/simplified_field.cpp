// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of the CGAL-style package Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#include "computation/simplified_field.h"

#include <CGAL/Reeb_graph/simplification/simplify_field.h>

namespace reeb_graph_program {
double compute_simplified_field(const Surface& surface,
                                Scalar_map scalar_map,
                                const Simplification_options& options,
                                double threshold,
                                CGAL::Reeb_graph::Ties ties,
                                Scalar_map simplified_map)
{
  namespace parameters = CGAL::parameters;
  const auto leaves = parameters::number_of_leaves(options.number_of_leaves.value_or(0));
  return CGAL::Reeb_graph::simplify_field(surface, scalar_map, threshold, simplified_map,
                                          parameters::ties(ties, leaves));
}

} // namespace reeb_graph_program
