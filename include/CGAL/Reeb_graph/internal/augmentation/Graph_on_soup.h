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

#include <CGAL/Reeb_graph/Soup_contour.h>
#include <CGAL/Reeb_graph/exceptions.h>
#include <CGAL/Reeb_graph/internal/augmentation/Graph_on_complex.h>
#include <CGAL/Reeb_graph/internal/augmentation/Level_set_component.h>
#include <CGAL/Reeb_graph/internal/augmentation/flatten_cells.h>
#include <CGAL/Reeb_graph/internal/base/Index.h>
#include <CGAL/Reeb_graph/internal/base/Progress.h>
#include <CGAL/Reeb_graph/internal/base/crossing_fraction.h>
#include <CGAL/Reeb_graph/internal/mesh/Simplicial_complex.h>
#include <CGAL/Reeb_graph/internal/mesh/flatten_soup.h>
#include <CGAL/Reeb_graph/internal/mesh/mesh_indices.h>

#include <cstddef>
#include <memory>
#include <utility>
#include <vector>

namespace CGAL {
namespace Reeb_graph {
namespace internal {

// A graph and the complex that its nodes and chains are on, whose vertices are numbers for the user, too. `CellList`
// holds the triangles or tetrahedra as the user lists them. A derived class traces the contours.
template <class ReebGraph, class Traits, class CellList, template <class> class ContourOfArc>
class Graph_on_soup : public Graph_on_complex<ReebGraph, Traits, std::size_t, Flat_soup<typename Traits::Scalar>>
{
  typedef Graph_on_complex<ReebGraph, Traits, std::size_t, Flat_soup<typename Traits::Scalar>> Base;

public:
  typedef Simplicial_complex Mesh;
  typedef typename Base::node_descriptor node_descriptor;
  typedef typename Base::arc_descriptor arc_descriptor;
  typedef std::pair<std::size_t, std::size_t> halfedge_descriptor;
  typedef ContourOfArc<arc_descriptor> Contour;
  typedef Soup_critical_set<Contour> Critical_set;
  using Base::complex;

  template <class PointsOrNumber, class Cells, class Scalars, class NamedParameters>
  Graph_on_soup(const PointsOrNumber& points,
                const Cells& cells,
                const Scalars& scalars,
                const ReebGraph& graph,
                const Traits& traits,
                const NamedParameters& np,
                const Progress& progress)
    : Base(graph, traits, flatten_reported(points, cells, scalars, traits, np, progress)),
      cells_(this->end_of_vertices(), points, cells)
  {}

  // The edges of the complex are a mesh as far as chains need one.
  const Mesh& mesh() const { return complex(); }
  bool has_vertices() const { return this->end_of_vertices() != 0; }

  Vertex_index source_of(const halfedge_descriptor& h) const { return this->number(h.first); }
  Vertex_index target_of(const halfedge_descriptor& h) const { return this->number(h.second); }

  // The ends of an edge that may be one of another complex.
  Vertex_index checked_source(const halfedge_descriptor& h) const { return checked(source_of(h)); }
  Vertex_index checked_target(const halfedge_descriptor& h) const { return checked(target_of(h)); }

  Edge_index find_start(const halfedge_descriptor& h) const
  {
    const Halfedge_index halfedge = complex().find_halfedge(checked_source(h), checked_target(h));
    if(halfedge == no_index)
      throw Graph_mismatch_error();
    return edge_of(halfedge);
  }

  Critical_set critical_set(node_descriptor node, std::vector<Contour> lower, std::vector<Contour> upper) const
  {
    return {std::move(lower), std::move(upper), cells_.at_vertex(this->node_vertex(node))};
  }

  const CellList& cells() const { return cells_; }

protected:
  // A contour that has the points on the crossed edges, and nothing between them.
  template <class Level>
  Contour make_points(arc_descriptor arc, const Level_set_component& component, const Level& level) const
  {
    Contour contour;
    contour.arc = arc;
    contour.value = level.value;
    contour.edges.reserve(component.edges.size());
    contour.fractions.reserve(component.edges.size());
    for(const Edge_index edge : component.edges)
    {
      Vertex_index lower = complex().lower_end(edge), higher = complex().higher_end(edge);
      if(!level.is_below(lower))
        std::swap(lower, higher);
      contour.edges.emplace_back(lower.number(), higher.number());
      contour.fractions.push_back(crossing_fraction(this->value(lower), this->value(higher), level.value));
    }
    return contour;
  }

private:
  static Vertex_index checked(Vertex_index vertex)
  {
    if(vertex == no_index)
      throw Graph_mismatch_error();
    return vertex;
  }

  template <class PointsOrNumber, class Cells, class Scalars, class NamedParameters>
  static std::shared_ptr<const Flat_soup<typename Traits::Scalar>> flatten_reported(const PointsOrNumber& points,
                                                                                    const Cells& cells,
                                                                                    const Scalars& scalars,
                                                                                    const Traits& traits,
                                                                                    const NamedParameters& np,
                                                                                    const Progress& progress)
  {
    progress.report(0);
    auto soup = std::make_shared<const Flat_soup<typename Traits::Scalar>>(
      flatten_cells<CellList::vertices_per_cell>(points, cells, scalars, traits, np));
    progress.report(0.8);
    return soup;
  }

  const CellList cells_;
};

} // namespace internal
} // namespace Reeb_graph
} // namespace CGAL

#endif // CGAL_REEB_GRAPH_INTERNAL_AUGMENTATION_GRAPH_ON_SOUP_H
