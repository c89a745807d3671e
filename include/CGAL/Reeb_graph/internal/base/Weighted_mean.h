// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_INTERNAL_BASE_WEIGHTED_MEAN_H
#define CGAL_REEB_GRAPH_INTERNAL_BASE_WEIGHTED_MEAN_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/internal/base/scalars.h>

#include <algorithm>

namespace CGAL::Reeb_graph::internal {

// The mean of values, each of which counts by a weight. It is never beyond them, nor does a sum grow too large.
struct Weighted_mean
{
  double weight = 0, mean = 0;

  void add(double value, double its_weight)
  {
    if(!(its_weight > 0))
      return;
    weight += its_weight;
    const double share = its_weight / weight;
    mean = share < 1 ? std::clamp((1 - share) * mean + share * value, (std::min)(mean, value), (std::max)(mean, value))
                     : value;
  }

  // Where nothing has a weight, the middle between the two values.
  double mean_or_middle(double lower, double upper) const
  {
    return weight > 0 ? mean : lower == upper ? lower : value_at_fraction(lower, upper, 0.5);
  }
};

} // namespace CGAL::Reeb_graph::internal

#endif // CGAL_REEB_GRAPH_INTERNAL_BASE_WEIGHTED_MEAN_H
