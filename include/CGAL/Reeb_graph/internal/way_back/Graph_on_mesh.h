// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_INTERNAL_WAY_BACK_GRAPH_ON_MESH_H
#define CGAL_REEB_GRAPH_INTERNAL_WAY_BACK_GRAPH_ON_MESH_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/Contour.h>
#include <CGAL/Reeb_graph/exceptions.h>
#include <CGAL/Reeb_graph/internal/base/Index.h>
#include <CGAL/Reeb_graph/internal/base/arrays.h>
#include <CGAL/Reeb_graph/internal/base/parallel.h>
#include <CGAL/Reeb_graph/internal/base/scalars.h>
#include <CGAL/Reeb_graph/internal/complex/Flat_mesh.h>
#include <CGAL/Reeb_graph/internal/engine/walks.h>
#include <CGAL/Reeb_graph/internal/way_back/vertex_places.h>
#include <CGAL/Reeb_graph/named_parameters.h>

#include <CGAL/boost/graph/iterator.h>

#include <boost/graph/graph_traits.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <functional>
#include <memory>
#include <vector>

namespace CGAL::Reeb_graph::internal {

// A graph and the complex that its nodes are on: the way from the descriptors of nodes, arcs and vertices to numbers
// and back. The graph may be any whose nodes are vertices of the complex. It refers to the graph.
//
// `FaceListGraph` is what a Flat_mesh is of. A derived class is the way to the cells: the faces of a mesh, triangles, or
// tetrahedra. It has
// - cells(), a range, and vertices_of(cell), an array of the descriptors of its `vertices_per_cell` vertices;
// - star(node), those at a node, and border_loop(node);
// - a type Contour, and find_start(halfedge), and trace(arc, start, level), which makes one of what is inside of cells;
// - mesh(), where chains have their halfedges, and point_map(points), of what the user gives for points.
template <class ReebGraph, class Traits_, class FaceListGraph>
class Graph_on_complex
{
public:
  typedef ReebGraph Graph;
  typedef Traits_ Traits;
  typedef typename Traits::Scalar Scalar;
  typedef Vertex_order<Scalar, typename Traits::Less_scalar> Order;
  typedef Complex_of_t<FaceListGraph> Complex;
  typedef typename Vertex_list<FaceListGraph>::vertex_descriptor vertex_descriptor;
  typedef typename boost::graph_traits<ReebGraph>::vertex_descriptor node_descriptor;
  typedef typename boost::graph_traits<ReebGraph>::edge_descriptor arc_descriptor;

  // The order refers to the values.
  Graph_on_complex(const Graph_on_complex&) = delete;
  Graph_on_complex& operator=(const Graph_on_complex&) = delete;

  const ReebGraph& graph() const { return graph_; }
  const Flat_mesh<FaceListGraph>& flat_mesh() const { return *flat_values_->mesh; }
  const Complex& complex() const { return flat_mesh().complex; }
  const Order& order() const { return order_; }
  auto arcs() const { return CGAL::make_range(edges(graph_)); }
  const auto& chain(arc_descriptor arc) const { return graph_[arc].chain; }

  // The numbers of vertices are less than that, but not all such numbers are those of vertices.
  std::size_t end_of_vertices() const { return numbers().vertices.size(); }
  const std::function<Vertex_index(vertex_descriptor)>& vertex_numbers() const { return numbers().number_of; }
  Vertex_index number(vertex_descriptor v) const { return numbers().number_of(v); }
  vertex_descriptor vertex(Vertex_index number) const { return numbers().vertices[number]; }
  std::size_t position(Vertex_index number) const { return numbers().vertices.position(number); }
  bool is_vertex(Vertex_index number, vertex_descriptor v) const
  {
    return number.number() < end_of_vertices() && numbers().vertices.contains(number) && vertex(number) == v;
  }

  // The maker that Vertex_lists needs. It can outlive this object and the mesh.
  auto list_vertices(const std::shared_ptr<const Place_of_vertex>& places, std::size_t number_of_places) const
  {
    return [flat_values = flat_values_, order = order_, places, number_of_places] {
      return sort_vertices_by_place(flat_values->mesh->numbers.vertices, order, *places, number_of_places);
    };
  }

  Vertex_index node_vertex(node_descriptor node) const { return number(graph_[node].vertex); }
  Vertex_index lower_vertex(arc_descriptor arc) const { return node_vertex(source(arc, graph_)); }
  Vertex_index upper_vertex(arc_descriptor arc) const { return node_vertex(target(arc, graph_)); }

  const Scalar& scalar(Vertex_index number) const { return flat_values_->values[number]; }
  const Scalar_conversion<Traits>& conversion() const { return conversion_; }
  double value(Vertex_index number) const { return conversion_.to_double(scalar(number)); }

protected:
  // make_flat_values() returns a shared pointer, and takes most of the time.
  template <class MakeFlatValues>
  Graph_on_complex(const ReebGraph& graph,
                   const Traits& traits,
                   const Progress& progress,
                   const MakeFlatValues& make_flat_values)
    : graph_(graph),
      flat_values_((progress.report(0), make_flat_values())),
      order_(flat_values_->values, traits.less_scalar_object()),
      conversion_(traits)
  {
    progress.report(0.8);
  }

  const Mesh_numbers<FaceListGraph>& numbers() const { return flat_mesh().numbers; }

private:
  const ReebGraph& graph_;
  const std::shared_ptr<const Flat_values<FaceListGraph, Scalar>> flat_values_;
  const Order order_;
  const Scalar_conversion<Traits> conversion_;
};

// The place of a value on an ascending halfedge: 0 at its source, 1 at its target, in the middle if that is unclear.
template <class GraphOnComplex, class HalfedgeDescriptor>
double crossing_fraction(const GraphOnComplex& on_complex, const HalfedgeDescriptor& h, double value)
{
  return crossing_fraction(on_complex.value(on_complex.source_of(h)), on_complex.value(on_complex.target_of(h)), value);
}

// The faces of a mesh, to which it refers, as cells.
template <class FaceListGraph>
class Mesh_cells
{
public:
  static constexpr std::size_t vertices_per_cell = 3;

  explicit Mesh_cells(const FaceListGraph& mesh) : mesh_(mesh) {}

  const FaceListGraph& mesh() const { return mesh_; }
  auto cells() const { return CGAL::make_range(faces(mesh_)); }
  auto vertices_of(typename boost::graph_traits<FaceListGraph>::face_descriptor f) const
  {
    const auto h = halfedge(f, mesh_);
    return std::array{source(h, mesh_), target(h, mesh_), target(next(h, mesh_), mesh_)};
  }

protected:
  const FaceListGraph& mesh_;
};

// A graph and the flat surface that its nodes and chains are on: the way from descriptors to numbers and back. The
// graph may be any whose nodes are vertices and whose chains are halfedges of the mesh. It refers to both. Contours are
// sequences of halfedges.
template <class FaceListGraph, class ReebGraph, class Traits>
class Graph_on_mesh : public Graph_on_complex<ReebGraph, Traits, FaceListGraph>, public Mesh_cells<FaceListGraph>
{
  typedef Graph_on_complex<ReebGraph, Traits, FaceListGraph> Base;

public:
  typedef FaceListGraph Mesh;
  typedef typename Base::node_descriptor node_descriptor;
  typedef typename Base::arc_descriptor arc_descriptor;
  typedef typename boost::graph_traits<FaceListGraph>::halfedge_descriptor halfedge_descriptor;
  typedef typename boost::graph_traits<FaceListGraph>::face_descriptor face_descriptor;
  typedef Reeb_graph::Contour<arc_descriptor, halfedge_descriptor> Contour;
  typedef Reeb_graph::Critical_set<Contour, halfedge_descriptor, face_descriptor> Critical_set;
  using Base::complex;
  using Base::end_of_vertices;
  using Base::node_vertex;
  using Base::number;
  using Base::order;

  template <class ScalarMap, class NamedParameters>
  Graph_on_mesh(const FaceListGraph& mesh,
                const ScalarMap& scalar_map,
                const ReebGraph& graph,
                const Traits& traits,
                const NamedParameters& np,
                const Progress& progress)
    : Base(graph, traits, progress, [&] { return share_flat<Sequential_tag>(mesh, scalar_map, traits, np); }),
      Mesh_cells<FaceListGraph>(mesh)
  {}

  bool has_vertices() const { return vertices(mesh_).first != vertices(mesh_).second; }

  Vertex_index source_of(halfedge_descriptor h) const { return number(source(h, mesh_)); }
  Vertex_index target_of(halfedge_descriptor h) const { return number(target(h, mesh_)); }

  halfedge_descriptor halfedge(Halfedge_index h) const { return this->numbers().halfedges(mesh_, h); }

  // Where to trace the contour from that crosses h: the number of the opposite of h, or that of h if only h has a
  // triangle.
  Halfedge_index find_start(halfedge_descriptor h) const
  {
    const Halfedge_index found = find_halfedge(mesh_, this->flat_mesh(), h);
    if(found == no_index)
      throw Graph_mismatch_error();
    const Halfedge_index across = opposite_of(found);
    return complex().has_triangle(across) ? across : opposite_of(across);
  }

  template <class Level>
  Contour trace(arc_descriptor arc, Halfedge_index start, const Level& level) const
  {
    Contour contour;
    contour.arc = arc;
    contour.value = level.value;
    Plain_vector<Halfedge_index> crossed;
    contour.is_cyclic = trace_oriented_contour(complex(), start, level.is_below, crossed);
    contour.edges.reserve(crossed.size());
    for(const Halfedge_index h : crossed)
      contour.edges.push_back(halfedge(level.is_below(complex().target(h)) ? opposite_of(h) : h));
    return contour;
  }

  // A point map of the mesh, or named parameters.
  template <class Points>
  auto point_map(const Points& points) const
  {
    if constexpr(are_named_parameters<Points>)
      return choose_point_map(mesh_, points);
    else
      return points;
  }

  // The ends of a halfedge that may be one of another mesh.
  Vertex_index checked_source(halfedge_descriptor h) const
  {
    if(!can_be_halfedge(mesh_, h))
      throw Graph_mismatch_error();
    const Vertex_index v = source_of(h);
    if(v.number() >= end_of_vertices())
      throw Graph_mismatch_error();
    return v;
  }
  Vertex_index checked_target(halfedge_descriptor h) const { return checked_source(opposite(h, mesh_)); }

  // The faces at a node, counterclockwise.
  std::vector<face_descriptor> star(node_descriptor node) const
  {
    std::vector<face_descriptor> faces;
    complex().for_each_halfedge_around(node_vertex(node),
                                       [&](Halfedge_index h) { faces.push_back(face(halfedge(h), mesh_)); });
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
      if(!order().are_tied(v, target_of(h)))
        return {};
      loop.push_back(h);
      h = next(h, mesh_);
    } while(h != first);
    return loop;
  }

private:
  using Mesh_cells<FaceListGraph>::mesh_;
};

} // namespace CGAL::Reeb_graph::internal

#endif // CGAL_REEB_GRAPH_INTERNAL_WAY_BACK_GRAPH_ON_MESH_H
