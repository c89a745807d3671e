// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of the CGAL-style package Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_INTERNAL_BASE_ARC_INDEX_H
#define CGAL_REEB_GRAPH_INTERNAL_BASE_ARC_INDEX_H

#include <CGAL/license/Reeb_graph.h>

#include <boost/graph/properties.hpp>
#include <boost/pending/property.hpp>

#include <cstddef>
#include <type_traits>

namespace CGAL {
namespace Reeb_graph {
namespace internal {

// Whether the arcs of a graph have the property boost::edge_index.
template <class Graph, class = void>
struct Has_arc_index : std::false_type
{
};
template <class Graph>
struct Has_arc_index<Graph, std::void_t<typename Graph::edge_property_type>>
  : std::bool_constant<boost::lookup_one_property<typename Graph::edge_property_type, boost::edge_index_t>::found>
{
};

// Numbers an arc if its graph has a place for the number.
template <class Graph>
void set_arc_index(Graph& graph, const typename Graph::edge_descriptor& arc, std::size_t number)
{
  if constexpr(Has_arc_index<Graph>::value)
    put(boost::edge_index, graph, arc, number);
}

} // namespace internal
} // namespace Reeb_graph
} // namespace CGAL

#endif // CGAL_REEB_GRAPH_INTERNAL_BASE_ARC_INDEX_H
