// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of the CGAL-style package Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_INTERNAL_AUGMENTATION_GRAPH_ON_SOUP_H
#define CGAL_REEB_GRAPH_INTERNAL_AUGMENTATION_GRAPH_ON_SOUP_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/exceptions.h>
#include <CGAL/Reeb_graph/internal/augmentation/Graph_on_complex.h>
#include <CGAL/Reeb_graph/internal/base/Index.h>
#include <CGAL/Reeb_graph/internal/mesh/Simplicial_complex.h>
#include <CGAL/Reeb_graph/internal/mesh/flatten_soup.h>
#include <CGAL/Reeb_graph/internal/mesh/mesh_indices.h>

#include <cstddef>
#include <utility>

namespace CGAL {
namespace Reeb_graph {
namespace internal {

// A graph and the complex that its nodes and chains are on, whose vertices are numbers for the user, too.
template <class ReebGraph, class Traits>
class Graph_on_soup : public Graph_on_complex<ReebGraph, Traits, std::size_t, Flat_soup<typename Traits::Scalar>>
{
  typedef Graph_on_complex<ReebGraph, Traits, std::size_t, Flat_soup<typename Traits::Scalar>> Base;

public:
  typedef std::pair<std::size_t, std::size_t> halfedge_descriptor;

  Graph_on_soup(Flat_soup<typename Traits::Scalar> soup, const ReebGraph& graph, const Traits& traits)
    : Base(graph, traits, std::move(soup), [](const auto& vertices) {
        return [size = vertices.size()](std::size_t v) { return v < size ? Vertex_index(v) : Vertex_index(no_index); };
      })
  {}

  bool has_vertices() const { return this->end_of_vertices() != 0; }

  Vertex_index source_of(const halfedge_descriptor& h) const { return this->number(h.first); }
  Vertex_index target_of(const halfedge_descriptor& h) const { return this->number(h.second); }

  // The ends of an edge that may be one of another complex.
  Vertex_index checked_source(const halfedge_descriptor& h) const { return checked(source_of(h)); }
  Vertex_index checked_target(const halfedge_descriptor& h) const { return checked(target_of(h)); }

private:
  static Vertex_index checked(Vertex_index vertex)
  {
    if(vertex == no_index)
      throw Graph_mismatch_error();
    return vertex;
  }
};

} // namespace internal
} // namespace Reeb_graph
} // namespace CGAL

#endif // CGAL_REEB_GRAPH_INTERNAL_AUGMENTATION_GRAPH_ON_SOUP_H
