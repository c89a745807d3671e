// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of the CGAL-style package Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#include "computation/simplified_field.h"

#include "base/progress_bar.h"

#include <CGAL/Reeb_graph/simplification/simplify_field.h>

#include <functional>

namespace reeb_graph_program {
Simplified_field compute_simplified_field(const Surface& surface,
                                          Scalar_map scalar_map,
                                          const Simplification_options& options,
                                          double threshold,
                                          CGAL::Reeb_graph::Ties ties,
                                          Scalar_map simplified_map)
{
  namespace parameters = CGAL::parameters;
  const auto leaves = parameters::number_of_leaves(options.number_of_leaves.value_or(0));
  const auto simplify = [&](CGAL::Reeb_graph::Ties ties_of_field) {
    Progress_bar progress_bar("simplified field");
    const auto np = leaves.ties(ties_of_field).callback(std::ref(progress_bar));
    const double change = CGAL::Reeb_graph::simplify_field(surface, scalar_map, threshold, simplified_map, np);
    return Simplified_field{change, ties_of_field != ties};
  };
  try
  {
    return simplify(ties);
  }
  catch(const CGAL::Reeb_graph::Perturbed_ties_error&)
  {
    return simplify(CGAL::Reeb_graph::Ties::CONTRACT);
  }
}

} // namespace reeb_graph_program
