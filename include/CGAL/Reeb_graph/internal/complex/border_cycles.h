// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_INTERNAL_COMPLEX_BORDER_CYCLES_H
#define CGAL_REEB_GRAPH_INTERNAL_COMPLEX_BORDER_CYCLES_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/boost/graph/helpers.h>
#include <CGAL/boost/graph/iterator.h>
#include <CGAL/boost/graph/properties.h>

#include <boost/graph/graph_traits.hpp>

#include <cstddef>
#include <vector>

namespace CGAL::Reeb_graph::internal {

// A border component of a mesh.
template <class HalfedgeDescriptor>
struct Border_cycle
{
  HalfedgeDescriptor halfedge; // of the border, leads to the first vertex
  std::size_t first_vertex;    // position in vertices(mesh)
};

// Finds the border components, in the order of their first vertices in vertices(mesh).
template <class Mesh>
auto find_border_cycles(const Mesh& mesh)
{
  typedef typename boost::graph_traits<Mesh>::halfedge_descriptor halfedge_descriptor;
  std::vector<Border_cycle<halfedge_descriptor>> cycles;
  const auto is_found = get(dynamic_vertex_property_t<bool>(), mesh);
  for(const auto v : vertices(mesh))
    put(is_found, v, false);
  std::size_t position = 0;
  for(const auto v : vertices(mesh))
  {
    const std::size_t first_vertex = position++;
    if(get(is_found, v) || halfedge(v, mesh) == boost::graph_traits<Mesh>::null_halfedge())
      continue;
    const auto border = is_border(v, mesh);
    if(!border)
      continue;
    cycles.push_back({*border, first_vertex});
    for(const auto u : vertices_around_face(*border, mesh))
      put(is_found, u, true);
  }
  return cycles;
}

} // namespace CGAL::Reeb_graph::internal

#endif // CGAL_REEB_GRAPH_INTERNAL_COMPLEX_BORDER_CYCLES_H
