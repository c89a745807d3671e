// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of the CGAL-style package Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_INTERNAL_AUGMENTATION_GRAPH_ON_MESH_H
#define CGAL_REEB_GRAPH_INTERNAL_AUGMENTATION_GRAPH_ON_MESH_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/exceptions.h>
#include <CGAL/Reeb_graph/internal/augmentation/Vertex_lists.h>
#include <CGAL/Reeb_graph/internal/base/Index.h>
#include <CGAL/Reeb_graph/internal/base/Progress.h>
#include <CGAL/Reeb_graph/internal/base/Scalar_conversion.h>
#include <CGAL/Reeb_graph/internal/base/crossing_fraction.h>
#include <CGAL/Reeb_graph/internal/mesh/Vertex_order.h>
#include <CGAL/Reeb_graph/internal/mesh/flatten.h>
#include <CGAL/Reeb_graph/internal/mesh/mesh_indices.h>

#include <CGAL/boost/graph/iterator.h>

#include <boost/graph/graph_traits.hpp>

#include <algorithm>
#include <cstddef>
#include <functional>
#include <memory>
#include <utility>
#include <vector>

namespace CGAL {
namespace Reeb_graph {
namespace internal {

// A graph and the flat surface that its nodes and chains are on: the way from descriptors to numbers and back. The
// graph may be any whose nodes are vertices and whose chains are halfedges of the mesh. It refers to both.
template <class FaceListGraph, class ReebGraph, class Traits>
class Graph_on_mesh
{
  typedef Flat_surface<FaceListGraph, typename Traits::Scalar> Surface;

public:
  typedef ReebGraph Graph;
  typedef typename Traits::Scalar Scalar;
  typedef Vertex_order<Scalar, typename Traits::Less_scalar> Order;
  typedef Complex_of_t<FaceListGraph> Complex;
  typedef typename boost::graph_traits<FaceListGraph>::vertex_descriptor vertex_descriptor;
  typedef typename boost::graph_traits<FaceListGraph>::halfedge_descriptor halfedge_descriptor;
  typedef typename boost::graph_traits<FaceListGraph>::face_descriptor face_descriptor;
  typedef typename boost::graph_traits<ReebGraph>::vertex_descriptor node_descriptor;
  typedef typename boost::graph_traits<ReebGraph>::edge_descriptor arc_descriptor;

  template <class ScalarMap, class NamedParameters>
  Graph_on_mesh(const FaceListGraph& mesh,
                const ScalarMap& scalar_map,
                const ReebGraph& graph,
                const Traits& traits,
                const NamedParameters& np,
                const Progress& progress)
    : mesh_(mesh),
      graph_(graph),
      surface_(std::make_shared<const Surface>(flatten_reported(mesh, scalar_map, traits, np, progress))),
      order_(surface_->values, traits.less_scalar_object()),
      conversion_(traits),
      number_of_vertex_(find_vertex_numbers(mesh, surface_->vertices, np))
  {}

  // The order refers to the values.
  Graph_on_mesh(const Graph_on_mesh&) = delete;
  Graph_on_mesh& operator=(const Graph_on_mesh&) = delete;

  const FaceListGraph& mesh() const { return mesh_; }
  const ReebGraph& graph() const { return graph_; }
  const Complex& complex() const { return surface_->complex; }
  const Order& order() const { return order_; }
  auto arcs() const { return CGAL::make_range(edges(graph_)); }
  const auto& chain(arc_descriptor arc) const { return graph_[arc].chain; }

  // The numbers of vertices are less than that, but not all such numbers are those of vertices.
  std::size_t end_of_vertices() const { return surface_->vertices.size(); }
  const std::function<Vertex_index(vertex_descriptor)>& vertex_numbers() const { return number_of_vertex_; }
  Vertex_index number(vertex_descriptor v) const { return number_of_vertex_(v); }
  vertex_descriptor vertex(Vertex_index number) const { return surface_->vertices[number]; }
  std::size_t position(Vertex_index number) const { return surface_->vertices.position(number); }
  bool is_vertex(Vertex_index number, vertex_descriptor v) const
  {
    return number.number() < end_of_vertices() && surface_->vertices.contains(number) && vertex(number) == v;
  }

  // What Vertex_lists needs. It can outlive this object and the mesh.
  auto list_vertices(const std::shared_ptr<const Place_of_vertex>& places, std::size_t number_of_places) const
  {
    return [surface = surface_, order = order_, places, number_of_places](auto& vertices, auto& begins) {
      sort_vertices_by_place(surface->vertices, order, *places, number_of_places, vertices, begins);
    };
  }

  Vertex_index node_vertex(node_descriptor node) const { return number(graph_[node].vertex); }
  Vertex_index lower_vertex(arc_descriptor arc) const { return node_vertex(source(arc, graph_)); }
  Vertex_index upper_vertex(arc_descriptor arc) const { return node_vertex(target(arc, graph_)); }

  const Scalar& scalar(Vertex_index number) const { return surface_->values[number]; }
  const Scalar_conversion<Traits>& conversion() const { return conversion_; }
  double value(Vertex_index number) const { return conversion_.to_double(scalar(number)); }

  halfedge_descriptor halfedge(Halfedge_index number) const { return surface_->halfedges(mesh_, number); }

  // The number of h or of its opposite, whichever has a triangle.
  Halfedge_index number_of_edge(halfedge_descriptor h) const
  {
    Halfedge_index result = no_index;
    complex().visit_edges_around(number(source(h, mesh_)), [&](Vertex_index, Halfedge_index halfedge_number) {
      const halfedge_descriptor around = halfedge(halfedge_number);
      if(around != h && around != opposite(h, mesh_))
        return false;
      result = halfedge_number;
      return true;
    });
    if(result == no_index)
      throw Graph_mismatch_error();
    return result;
  }

  // The source of a halfedge that may be one of another mesh.
  Vertex_index checked_source(halfedge_descriptor h) const
  {
    if(!can_be_halfedge(mesh_, h))
      throw Graph_mismatch_error();
    const Vertex_index v = number(source(h, mesh_));
    if(v.number() >= end_of_vertices())
      throw Graph_mismatch_error();
    return v;
  }

  // The place of a value on an ascending halfedge: 0 at its source, 1 at its target, in the middle if that is unclear.
  double crossing_fraction(halfedge_descriptor h, double value) const
  {
    return internal::crossing_fraction(this->value(number(source(h, mesh_))), this->value(number(target(h, mesh_))),
                                       value);
  }

  // The faces at a node, counterclockwise.
  std::vector<face_descriptor> star(node_descriptor node) const
  {
    std::vector<face_descriptor> faces;
    complex().for_each_halfedge_around(node_vertex(node),
                                       [&](Halfedge_index number) { faces.push_back(face(halfedge(number), mesh_)); });
    std::reverse(faces.begin(), faces.end());
    return faces;
  }

  // The border loop at a node if all of it has the value of the node.
  std::vector<halfedge_descriptor> border_loop(node_descriptor node) const
  {
    std::vector<halfedge_descriptor> loop;
    const Vertex_index v = node_vertex(node);
    if(!complex().is_on_border(v))
      return loop;
    const halfedge_descriptor first = halfedge(opposite_of(complex().first_halfedge(v)));
    halfedge_descriptor h = first;
    do
    {
      if(!order_.are_tied(v, number(target(h, mesh_))))
        return {};
      loop.push_back(h);
      h = next(h, mesh_);
    } while(h != first);
    return loop;
  }

private:
  template <class ScalarMap, class NamedParameters>
  static Surface flatten_reported(const FaceListGraph& mesh,
                                  const ScalarMap& scalar_map,
                                  const Traits& traits,
                                  const NamedParameters& np,
                                  const Progress& progress)
  {
    progress.report(0);
    Surface surface = flatten<Sequential_tag>(mesh, scalar_map, traits, np);
    progress.report(0.8);
    return surface;
  }

  const FaceListGraph& mesh_;
  const ReebGraph& graph_;
  const std::shared_ptr<const Surface> surface_;
  const Order order_;
  const Scalar_conversion<Traits> conversion_;
  const std::function<Vertex_index(vertex_descriptor)> number_of_vertex_;
};

} // namespace internal
} // namespace Reeb_graph
} // namespace CGAL

#endif // CGAL_REEB_GRAPH_INTERNAL_AUGMENTATION_GRAPH_ON_MESH_H
