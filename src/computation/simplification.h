// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_SRC_SIMPLIFICATION_H
#define CGAL_REEB_GRAPH_SRC_SIMPLIFICATION_H

#include "base/options.h"
#include "base/surface.h"

#include <CGAL/Reeb_graph/Augmentation.h>
#include <CGAL/Reeb_graph/simplification/persistence_pairs.h>
#include <CGAL/Reeb_graph/simplification/simplification_thresholds.h>
#include <CGAL/Reeb_graph/simplification/simplify.h>

#include <boost/core/noncopyable.hpp>
#include <boost/graph/graph_traits.hpp>

#include <functional>
#include <optional>
#include <utility>
#include <vector>

namespace reeb_graph_program {
typedef CGAL::Reeb_graph::Augmentation<Surface, Scalar_map> Augmentation;
typedef CGAL::Reeb_graph::Persistence_pair<boost::graph_traits<Graph>::vertex_descriptor> Persistence_pair;
typedef CGAL::Reeb_graph::Simplification_threshold Simplification_threshold;

// Throws std::runtime_error if options do not go together.
void check_simplification_options(const Simplification_options& options);

// Throws std::runtime_error if there is no field that has the simplified graph.
void check_simplification_of_field(const Simplification_options& options);

// The least and the greatest value of a field.
typedef std::pair<double, double> Value_range;

// The threshold in units of the field, infinite if only the number of leaves counts, and NaN if the graph is to suggest
// it. The range is asked for where it
// matters only, and is none if there are no vertices. Throws std::runtime_error if it is not finite.
double threshold_in_units(const Simplification_options& options,
                          const std::function<std::optional<Value_range>()>& find_range);
double threshold_in_units(const Simplification_options& options, const Surface& surface, Scalar_map scalar_map);

// A graph, `Graph` or `Complex_graph`, and, if anything is removed from it, the simplified graph.
template <class AnyGraph>
class Simplified_graph_of : boost::noncopyable
{
public:
  // The threshold is that of threshold_in_units(); if it is NaN, the graph suggests one. `given` has to outlive this
  // object.
  Simplified_graph_of(const AnyGraph& given, const Simplification_options& options, double threshold);
  Simplified_graph_of(const AnyGraph&&, const Simplification_options&, double) = delete;

  // The simplified graph if there is one, else the given one.
  const AnyGraph& result() const { return simplification_ ? simplified_ : given_; }

  double threshold() const { return threshold_; } // which is no NaN

  // Where the nodes and arcs of the given graph are in the simplified one.
  const std::optional<CGAL::Reeb_graph::Simplification<AnyGraph>>& simplification() const { return simplification_; }

private:
  const AnyGraph& given_;
  double threshold_;
  AnyGraph simplified_;
  std::optional<CGAL::Reeb_graph::Simplification<AnyGraph>> simplification_;
};

typedef Simplified_graph_of<Graph> Simplified_graph;

std::vector<Persistence_pair> find_persistence_pairs(const Graph& graph);

// Those that matter for --simplify, with or without --cancel-loops.
template <class AnyGraph>
std::vector<Simplification_threshold> find_thresholds(const AnyGraph& graph, bool are_loops_cancelled);

// The one of find_thresholds() that --simplify auto takes, if there is any.
std::optional<double> suggested_threshold(const std::vector<Simplification_threshold>& thresholds);

} // namespace reeb_graph_program

#endif // CGAL_REEB_GRAPH_SRC_SIMPLIFICATION_H
