// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_SRC_COMPARISON_H
#define CGAL_REEB_GRAPH_SRC_COMPARISON_H

#include "base/surface.h"
#include "computation/Mesh_graph.h"

#include <CGAL/Reeb_graph/comparison/bottleneck_distance.h>

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace reeb_graph_program {
typedef std::vector<CGAL::Reeb_graph::Persistence_values> Persistence_values;

// The pairs of a graph that has not been simplified, with `base` added to values.
Persistence_values find_persistence_values(const Graph& graph, double base = 0);

// How far two shapes are from each other, by each kind of pairs; the greatest number is the distance. And the distances
// of all shapes, a row for each.
std::vector<std::pair<std::string, double>> distances_by_kind(const Persistence_values& a, const Persistence_values& b);
std::vector<std::vector<double>> find_distances(const std::vector<Persistence_values>& shapes);

// The arcs of two graphs of surfaces that are partners, by their numbers. Throws the exceptions of match_arcs().
typedef std::vector<std::pair<std::size_t, std::size_t>> Partners;
Partners match_arcs(Mesh_graph& a, Mesh_graph& b, double price_alone);

// For each surface a tip such that all stand for the same place: those which are most alike to one of the first surface.
// None if a surface has not one component. Throws the exceptions of match_tips().
std::vector<std::size_t> find_like_tips(const std::vector<const Surface*>& surfaces);

} // namespace reeb_graph_program

#endif // CGAL_REEB_GRAPH_SRC_COMPARISON_H
