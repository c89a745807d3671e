// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_INTERNAL_IO_REQUIREMENTS_H
#define CGAL_REEB_GRAPH_INTERNAL_IO_REQUIREMENTS_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/internal/base/graph_requirements.h>
#include <CGAL/Reeb_graph/internal/base/requirements.h>
#include <CGAL/Reeb_graph/internal/base/scalars.h>

#include <istream>
#include <ostream>
#include <type_traits>
#include <utility>

// Requirements of functions that read and write graphs on the types of their arguments.

namespace CGAL::Reeb_graph::internal {

// ---- Values as texts: by the operators of streams, or else as the numbers that the traits class makes of them.

template <class Scalar>
using Written_scalar = decltype(std::declval<std::ostream&>() << std::declval<const Scalar&>());
template <class Scalar>
using Read_scalar = decltype(std::declval<std::istream&>() >> std::declval<Scalar&>());

template <class Traits>
struct Scalars_can_be_written
  : std::disjunction<Has<Written_scalar, typename Traits::Scalar>, Has<Scalar_to_double, Traits>>
{
  static_assert(Scalars_can_be_written::value,
                "The scalar values cannot be written: give their type an operator<<, or pass as named parameter "
                "geom_traits a traits class with a member scalar_to_double_object() that makes numbers of them.");
};

template <class Traits>
struct Scalars_can_be_read
  : std::disjunction<Has<Read_scalar, typename Traits::Scalar>, Has<Scalar_from_double, Traits>>
{
  static_assert(Scalars_can_be_read::value,
                "The scalar values cannot be read: give their type an operator>>, or pass as named parameter "
                "geom_traits a traits class with a member scalar_from_double_object() that makes them of numbers.");
};

// A graph and a map of the vertices of its mesh, for functions that see no mesh.
template <class Graph, class Map>
struct Keys_are_vertices_of_nodes : Has_key<Map, Vertex_of_node<Graph>>
{
  static_assert(Keys_are_vertices_of_nodes::value,
                "The keys of this index map are not the vertices of the mesh that the graph is of: its key_type has "
                "to be their descriptor.");
};

template <class Graph, class Map>
struct Graph_and_vertex_map
  : std::conjunction<Augmented_reeb_graph<Graph>, Map_is_property_map<Map>, Keys_are_vertices_of_nodes<Graph, Map>>
{
};

// A graph and a map of the vertices of its mesh, for functions that write its values.
template <class Graph, class Map, class NamedParameters>
struct Graph_to_write
  : std::conjunction<Graph_and_vertex_map<Graph, Map>, Scalars_can_be_written<Traits_of_nodes<Graph, NamedParameters>>>
{
};

} // namespace CGAL::Reeb_graph::internal

#endif // CGAL_REEB_GRAPH_INTERNAL_IO_REQUIREMENTS_H
