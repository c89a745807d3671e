// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
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
#include <optional>
#include <vector>

namespace reeb_graph_program {
// The places of vertices, by their indices, as functions that measure pieces of a mesh ask for them.
struct Vertex_places
{
  const std::vector<std::size_t>& places;
  std::size_t index(std::size_t v) const { return places[v]; }
};

// The graph with values to which `base` is added, in `copy` if need be.
template <class AnyGraph>
const AnyGraph& with_base(const AnyGraph& graph, double base, std::optional<AnyGraph>& copy)
{
  if(base == 0)
    return graph;
  copy = graph;
  for(const auto node : CGAL::make_range(vertices(*copy)))
    (*copy)[node].value += base;
  return *copy;
}

// The places in a simplified graph of what has the given ones in the graph before.
template <class AnySimplification>
std::vector<std::size_t> simplified_places(std::vector<std::size_t> places, const AnySimplification& simplification)
{
  const std::size_t number_of_nodes = simplification.number_of_old_nodes();
  for(std::size_t& place : places)
    place = place < number_of_nodes ? simplification.index_of_node(place)
                                    : simplification.index_of_arc(place - number_of_nodes);
  return places;
}

} // namespace reeb_graph_program

#endif // CGAL_REEB_GRAPH_SRC_AUGMENTATION_H
