// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of the CGAL-style package Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_INTERNAL_AUGMENTATION_GRAPH_ON_COMPLEX_H
#define CGAL_REEB_GRAPH_INTERNAL_AUGMENTATION_GRAPH_ON_COMPLEX_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/internal/augmentation/Vertex_lists.h>
#include <CGAL/Reeb_graph/internal/base/Scalar_conversion.h>
#include <CGAL/Reeb_graph/internal/base/crossing_fraction.h>
#include <CGAL/Reeb_graph/internal/mesh/Vertex_order.h>
#include <CGAL/Reeb_graph/internal/mesh/mesh_indices.h>

#include <CGAL/boost/graph/iterator.h>

#include <boost/graph/graph_traits.hpp>

#include <cstddef>
#include <functional>
#include <memory>
#include <utility>

namespace CGAL {
namespace Reeb_graph {
namespace internal {

// A graph and the complex that its nodes are on: the way from the descriptors of nodes, arcs and vertices to numbers
// and back. The graph may be any whose nodes are vertices of the complex. It refers to the graph.
//
// `ComplexWithField` is a Complex_with_field. A derived class knows what a contour is: it has a type Contour,
// find_start(halfedge), and trace(arc, start, level).
template <class ReebGraph, class Traits_, class VertexDescriptor, class ComplexWithField>
class Graph_on_complex
{
public:
  typedef ReebGraph Graph;
  typedef Traits_ Traits;
  typedef typename Traits::Scalar Scalar;
  typedef Vertex_order<Scalar, typename Traits::Less_scalar> Order;
  typedef decltype(ComplexWithField::complex) Complex;
  typedef VertexDescriptor vertex_descriptor;
  typedef typename boost::graph_traits<ReebGraph>::vertex_descriptor node_descriptor;
  typedef typename boost::graph_traits<ReebGraph>::edge_descriptor arc_descriptor;

  // The order refers to the values.
  Graph_on_complex(const Graph_on_complex&) = delete;
  Graph_on_complex& operator=(const Graph_on_complex&) = delete;

  const ReebGraph& graph() const { return graph_; }
  const Complex& complex() const { return complex_->complex; }
  const Order& order() const { return order_; }
  auto arcs() const { return CGAL::make_range(edges(graph_)); }
  const auto& chain(arc_descriptor arc) const { return graph_[arc].chain; }

  // The numbers of vertices are less than that, but not all such numbers are those of vertices.
  std::size_t end_of_vertices() const { return field().vertices.size(); }
  const std::function<Vertex_index(vertex_descriptor)>& vertex_numbers() const { return field().numbers; }
  Vertex_index number(vertex_descriptor v) const { return field().numbers(v); }
  vertex_descriptor vertex(Vertex_index number) const { return field().vertices[number]; }
  std::size_t position(Vertex_index number) const { return field().vertices.position(number); }
  bool is_vertex(Vertex_index number, vertex_descriptor v) const
  {
    return number.number() < end_of_vertices() && field().vertices.contains(number) && vertex(number) == v;
  }

  // What Vertex_lists needs. It can outlive this object and the mesh.
  auto list_vertices(const std::shared_ptr<const Vertex_places>& places, std::size_t number_of_places) const
  {
    return [complex = complex_, order = order_, places, number_of_places](auto& vertices, auto& begins) {
      sort_vertices_by_place(complex->field.vertices, order, *places, number_of_places, vertices, begins);
    };
  }

  Vertex_index node_vertex(node_descriptor node) const { return number(graph_[node].vertex); }
  Vertex_index lower_vertex(arc_descriptor arc) const { return node_vertex(source(arc, graph_)); }
  Vertex_index upper_vertex(arc_descriptor arc) const { return node_vertex(target(arc, graph_)); }

  const Scalar& scalar(Vertex_index number) const { return field().values[number]; }
  const Scalar_conversion<Traits>& conversion() const { return conversion_; }
  double value(Vertex_index number) const { return conversion_.to_double(scalar(number)); }

protected:
  Graph_on_complex(const ReebGraph& graph, const Traits& traits, std::shared_ptr<const ComplexWithField> complex)
    : graph_(graph),
      complex_(std::move(complex)),
      order_(field().values, traits.less_scalar_object()),
      conversion_(traits)
  {}

  const decltype(ComplexWithField::field)& field() const { return complex_->field; }

private:
  const ReebGraph& graph_;
  const std::shared_ptr<const ComplexWithField> complex_;
  const Order order_;
  const Scalar_conversion<Traits> conversion_;
};

// The place of a value on an ascending halfedge: 0 at its source, 1 at its target, in the middle if that is unclear.
template <class GraphOnComplex, class HalfedgeDescriptor>
double crossing_fraction(const GraphOnComplex& on_complex, const HalfedgeDescriptor& h, double value)
{
  return crossing_fraction(on_complex.value(on_complex.source_of(h)), on_complex.value(on_complex.target_of(h)), value);
}

} // namespace internal
} // namespace Reeb_graph
} // namespace CGAL

#endif // CGAL_REEB_GRAPH_INTERNAL_AUGMENTATION_GRAPH_ON_COMPLEX_H
