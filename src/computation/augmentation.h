// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of the CGAL-style package Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_SRC_AUGMENTATION_H
#define CGAL_REEB_GRAPH_SRC_AUGMENTATION_H

#include "base/options.h"
#include "base/report.h"
#include "base/surface.h"
#include "computation/simplification.h"

#include <cstddef>
#include <iterator>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

namespace reeb_graph_program {
typedef Augmentation::Vertex_locations Vertex_locations;

// Without a report of the stages.
Graph compute_graph(const Surface& surface, Scalar_map scalar_map, const Graph_options& options);

// The places are numbered as in the graph files.
Vertex_locations locate_vertices(const Augmentation& augmentation);

// The arcs of the graph, by their numbers.
std::vector<Arc_row> measure_arcs(const Surface& surface,
                                  Scalar_map scalar_map,
                                  const Graph& graph,
                                  const Vertex_locations& locations);

// Throws std::runtime_error if there is no such arc.
template <class AnyGraph>
typename boost::graph_traits<AnyGraph>::edge_descriptor arc_of_number(const AnyGraph& graph, std::size_t arc)
{
  if(arc >= num_edges(graph))
    throw std::runtime_error("there is no arc " + std::to_string(arc) + ": the graph has "
                             + std::to_string(num_edges(graph)) + ", numbered from 0");
  return *std::next(edges(graph).first, static_cast<std::ptrdiff_t>(arc));
}

// Which contours of which graph.
struct Contour_choice
{
  Graph_options graph;
  Simplification_options simplification;
  std::optional<std::size_t>
    arc; // its contour at the place `t` between 0 and 1; if not given, all contours at the level
  double t = 0;
  double level = 0;
};

// Throws std::runtime_error if there is no such arc. There is no contour at a level at which no arc is alive.
std::vector<Polyline> find_contours(const Surface& surface, Scalar_map scalar_map, const Contour_choice& choice);

} // namespace reeb_graph_program

#endif // CGAL_REEB_GRAPH_SRC_AUGMENTATION_H
