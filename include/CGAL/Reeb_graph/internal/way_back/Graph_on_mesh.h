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
#include <CGAL/Reeb_graph/internal/base/Buckets.h>
#include <CGAL/Reeb_graph/internal/base/Index.h>
#include <CGAL/Reeb_graph/internal/base/Made_on_demand.h>
#include <CGAL/Reeb_graph/internal/base/Progress.h>
#include <CGAL/Reeb_graph/internal/base/Scalar_conversion.h>
#include <CGAL/Reeb_graph/internal/base/Threads.h>
#include <CGAL/Reeb_graph/internal/base/compiled.h>
#include <CGAL/Reeb_graph/internal/base/interpolation.h>
#include <CGAL/Reeb_graph/internal/complex/Flat_mesh.h>
#include <CGAL/Reeb_graph/internal/engine/classify_vertices.h>
#include <CGAL/Reeb_graph/internal/engine/find_arcs.h>
#include <CGAL/Reeb_graph/internal/engine/walks.h>
#include <CGAL/Reeb_graph/internal/engine/write_graph.h>
#include <CGAL/Reeb_graph/internal/way_back/vertex_places.h>
#include <CGAL/Reeb_graph/named_parameters.h>

#include <CGAL/Iterator_range.h>
#include <CGAL/boost/graph/iterator.h>

#include <boost/graph/graph_traits.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <functional>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL::Reeb_graph::internal {

// A level: a place between two vertices of the total order, which is named by the first one that could be above it.
class Level
{
public:
  // Just above or just below a vertex.
  Level(const Vertex_order& order, Side side, Vertex_index vertex)
    : order_(&order),
      first_above_(order.key(vertex, Vertex_index(vertex.number() + (side == Side::UPPER ? 1 : 0))))
  {}

  // Just above or just below all vertices that have a key, or would have it. No vertex is below NaN.
  Level(const Vertex_order& order, Side side, double key)
    : order_(&order),
      first_above_{key, side == Side::UPPER ? Vertex_index(no_index) : Vertex_index(0)}
  {}

  // Whether the vertex is below the level.
  bool operator()(Vertex_index u) const { return (*order_)(order_->key(u, u), first_above_); }

private:
  const Vertex_order* order_;
  Vertex_order::Key<Vertex_index> first_above_;
};

struct Place_tag;
typedef Index_of<Place_tag> Place_index;

// The vertices of each place in ascending order. They are sorted when they are asked for, which takes longer than to
// find the places.
template <class VertexDescriptor>
class Vertex_lists
{
public:
  typedef Buckets<Place_index, VertexDescriptor> Lists;

  explicit Vertex_lists(std::function<Lists()> make) : make_(std::move(make)) {}

  Iterator_range<const VertexDescriptor*> operator()(std::size_t place) const
  {
    const Lists& lists = lists_([this] {
      Lists result = make_();
      make_ = nullptr; // It holds what the lists are made of.
      return result;
    });
    return lists[Place_index(place)];
  }

private:
  mutable std::function<Lists()> make_;
  Made_on_demand<Lists> lists_;
};

// Makes what Vertex_lists needs.
template <class VertexList>
auto sort_vertices_by_place(const VertexList& vertex_list,
                            const Vertex_order& order,
                            const Place_of_vertex& places,
                            std::size_t number_of_places)
{
  typedef Vertex_order::Key<Vertex_index> Key;
  Buckets<Place_index, Key> keys(number_of_places, [&](const auto& visit) {
    for(const Vertex_index v : places.keys())
      if(places[v] != no_index)
        visit(Place_index(places[v]), order.key(v, v));
  });
  const Index_range<Place_index> all_places(number_of_places);
  for(const Place_index place : all_places)
    internal::sort(Threads(), keys[place].begin(), keys[place].end(), order);
  typedef typename VertexList::vertex_descriptor vertex_descriptor;
  return Buckets<Place_index, vertex_descriptor>(number_of_places, [&](const auto& visit) {
    for(const Place_index place : all_places)
      for(const Key& key : keys[place])
        visit(place, vertex_list[key.name]);
  });
}

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
  typedef Complex_of_t<FaceListGraph> Complex;
  typedef typename Vertex_list<FaceListGraph>::vertex_descriptor vertex_descriptor;
  typedef typename boost::graph_traits<ReebGraph>::vertex_descriptor node_descriptor;
  typedef typename boost::graph_traits<ReebGraph>::edge_descriptor arc_descriptor;

  // The order refers to the keys.
  Graph_on_complex(const Graph_on_complex&) = delete;
  Graph_on_complex& operator=(const Graph_on_complex&) = delete;

  const ReebGraph& graph() const { return graph_; }
  const Flat_mesh<FaceListGraph>& flat_mesh() const { return *flat_values_->mesh; }
  const Complex& complex() const { return flat_mesh().complex; }
  const Vertex_order& order() const { return order_; }
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

  // The values of vertices, and of users, as keys and as numbers.
  double key(Vertex_index number) const { return flat_values_->field.keys()[number]; }
  double key_of(const Scalar& value) const { return flat_values_->field.key_of(value, less_); }
  const Scalar_conversion<Traits>& conversion() const { return conversion_; }
  double value(Vertex_index number) const { return conversion_.to_double(flat_values_->field.value(number)); }

protected:
  // make_flat_values() returns a shared pointer, and takes most of the time.
  template <class MakeFlatValues>
  Graph_on_complex(const ReebGraph& graph,
                   const Traits& traits,
                   const Progress& progress,
                   const MakeFlatValues& make_flat_values)
    : graph_(graph),
      flat_values_((progress.report(0), make_flat_values())),
      order_(flat_values_->field.keys()),
      less_(traits.less_scalar_object()),
      conversion_(traits)
  {
    progress.report(0.8);
  }

  const Mesh_numbers<FaceListGraph>& numbers() const { return flat_mesh().numbers; }

private:
  const ReebGraph& graph_;
  const std::shared_ptr<const Flat_values<FaceListGraph, Scalar>> flat_values_;
  const Vertex_order order_;
  const typename Traits::Less_scalar less_;
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
    : Base(graph, traits, progress, [&] { return share_flat(Threads(), mesh, scalar_map, traits, np); }),
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

// The places in a simplified graph of the nodes, and behind them the arcs, of the exact graph, by the named parameter
// `simplification`. There are none if that is not given, as each has the same place then.
typedef std::optional<std::vector<Index>> Simplified_places;

template <class NamedParameters>
Simplified_places read_simplified_places(const NamedParameters& np)
{
  Simplified_places places;
  const auto simplification = parameters::get_parameter(np, internal::simplification);
  if constexpr(is_given<decltype(simplification)>)
  {
    places.emplace();
    for(std::size_t node = 0; node != simplification.number_of_old_nodes(); ++node)
      places->push_back(static_cast<Index>(simplification.index_of_node(node)));
    for(std::size_t arc = 0; arc != simplification.number_of_old_arcs(); ++arc)
      places->push_back(static_cast<Index>(simplification.index_of_arc(arc)));
  }
  return places;
}

// The checks below throw Graph_mismatch_error for a graph that is not of this mesh and field.

// Checks that the nodes are vertices of the mesh with their values, in ascending order.
template <class GraphOnMesh>
void check_nodes(const GraphOnMesh& on_mesh)
{
  const auto& graph = on_mesh.graph();
  if(num_vertices(graph) == 0 && on_mesh.has_vertices())
    throw Graph_mismatch_error();
  Vertex_index lower_vertex = no_index;
  for(const auto node : CGAL::make_range(vertices(graph)))
  {
    const Vertex_index v = on_mesh.node_vertex(node);
    if(!on_mesh.is_vertex(v, graph[node].vertex) || on_mesh.key(v) != on_mesh.key_of(graph[node].value)
       || (lower_vertex != no_index && !on_mesh.order()(lower_vertex, v)))
      throw Graph_mismatch_error();
    lower_vertex = v;
  }
}

// Checks that each arc ascends, and that its chain begins at its lower node. With other ties than those of the graph,
// the levels next to a node could miss its arcs.
template <class GraphOnMesh>
void check_arcs(const GraphOnMesh& on_mesh, Ties ties)
{
  const auto& order = on_mesh.order();
  for(const auto arc : on_mesh.arcs())
  {
    const Vertex_index lower = on_mesh.lower_vertex(arc), upper = on_mesh.upper_vertex(arc);
    if(!order(lower, upper) || on_mesh.chain(arc).empty())
      throw Graph_mismatch_error();
    const Vertex_index first = on_mesh.checked_source(on_mesh.chain(arc).front());
    const bool fits =
      ties == Ties::CONTRACT ? order.are_tied(lower, first) && !order.are_tied(lower, upper) : lower == first;
    if(!fits)
      throw Graph_mismatch_error();
  }
}

// Whether the graph is the exact one, which `flat_graph` is.
template <class GraphOnMesh>
bool is_same_graph(const GraphOnMesh& on_mesh, const Flat_graph& flat_graph)
{
  const auto& graph = on_mesh.graph();
  bool is_same = flat_graph.nodes.size() == num_vertices(graph) && flat_graph.arcs.size() == num_edges(graph);
  for(std::size_t node = 0; is_same && node != flat_graph.nodes.size(); ++node)
    is_same = flat_graph.nodes[Node_index(node)].vertex == on_mesh.node_vertex(node);
  auto flat_arc = flat_graph.arcs.begin();
  for(auto arc = edges(graph).first; is_same && flat_arc != flat_graph.arcs.end(); ++arc, ++flat_arc)
    is_same = source(*arc, graph) == flat_arc->lower.number() && target(*arc, graph) == flat_arc->upper.number();
  return is_same;
}

// Whether the exact graph, which `flat_graph` is, has been simplified to this one: whether each node here is one of
// those that have come to its place.
template <class GraphOnMesh>
bool is_simplified_graph(const GraphOnMesh& on_mesh,
                         const Flat_graph& flat_graph,
                         const std::vector<Index>& simplified_places)
{
  if(simplified_places.size() != flat_graph.nodes.size() + flat_graph.arcs.size())
    return false;
  const std::size_t number_of_nodes = num_vertices(on_mesh.graph());
  std::size_t number_of_found = 0;
  for(Index old_place = 0; old_place != simplified_places.size(); ++old_place)
  {
    const Index place = simplified_places[old_place];
    if(place >= number_of_nodes + num_edges(on_mesh.graph()))
      return false;
    const bool is_node = old_place < flat_graph.nodes.size() && place < number_of_nodes;
    if(is_node && on_mesh.node_vertex(place) == flat_graph.nodes[Node_index(old_place)].vertex)
      ++number_of_found;
  }
  return number_of_found == number_of_nodes;
}

// The number of a vertex that may be one of another mesh.
template <class GraphOnComplex>
Vertex_index checked_number(const GraphOnComplex& on_complex, typename GraphOnComplex::vertex_descriptor v)
{
  const Vertex_index number = on_complex.number(v);
  if(!on_complex.is_vertex(number, v))
    throw Unknown_vertex_error();
  return number;
}

template <class ReebGraph>
void check_is_node(const ReebGraph& graph, typename boost::graph_traits<ReebGraph>::vertex_descriptor node)
{
  if(node >= num_vertices(graph))
    throw Graph_mismatch_error("the node is not one of the graph");
}

template <class ReebGraph>
void check_is_arc(const ReebGraph& graph, typename boost::graph_traits<ReebGraph>::edge_descriptor arc)
{
  const auto lower = source(arc, graph), upper = target(arc, graph);
  if(lower >= num_vertices(graph) || upper >= num_vertices(graph))
    throw Graph_mismatch_error("the arc is not one of the graph");
  const auto is_in = [&](const auto& range) { return std::find(range.first, range.second, arc) != range.second; };
  // Nodes of high degree mostly have neighbors of low degree.
  const bool is_known =
    out_degree(lower, graph) < in_degree(upper, graph) ? is_in(out_edges(lower, graph)) : is_in(in_edges(upper, graph));
  if(!is_known)
    throw Graph_mismatch_error("the arc is not one of the graph");
}

// The places of all vertices in the exact graph, which is computed once more. Nothing but the surface and the order of
// its vertices is asked. check_graph(graph) may throw.
template <class Complex>
Place_of_vertex find_places(const Threads& threads,
                            const Complex& complex,
                            const Vertex_order& order,
                            Ties ties,
                            bool are_degree_two_nodes_kept,
                            const std::function<void(const Flat_graph&)>& check_graph,
                            const Progress& progress)
{
  progress.report(0);
  const Swept_vertices critical_vertices = classify_vertices(threads, complex, order);
  Arc_of_vertex arc_of_vertex;
  const Swept_arcs arcs = find_arcs_and_locate_vertices(threads, complex, order, critical_vertices, arc_of_vertex,
                                                        Stage_progress(progress, 0.3, 0.85));
  progress.report(0.9);
  const Flat_graph graph =
    reduce_arcs(threads, complex, order, critical_vertices, arcs, ties, are_degree_two_nodes_kept, true);
  progress.report(0.95);
  check_graph(graph);
  return find_vertex_places(threads, complex, order, critical_vertices, arcs, arc_of_vertex, graph, ties);
}

// The places of all vertices in the graph, which has to be the exact one, or one that this has been simplified to.
template <class VertexPlaces, class GraphOnMesh, class NamedParameters>
VertexPlaces locate_vertices(const Threads& threads,
                             const GraphOnMesh& on_mesh,
                             Ties ties,
                             bool are_degree_two_nodes_kept,
                             const Simplified_places& simplified_places,
                             const NamedParameters& np)
{
  typedef typename GraphOnMesh::vertex_descriptor vertex_descriptor;
  const Progress progress(np);
  const auto& graph = on_mesh.graph();
  const std::size_t number_of_places = num_vertices(graph) + num_edges(graph);
  const auto given_map = parameters::get_parameter(np, vertex_place_map);
  auto place_of_vertex = std::make_shared<Place_of_vertex>();
  if constexpr(is_given<decltype(given_map)>)
    *place_of_vertex =
      read_places(on_mesh.flat_mesh(), given_map, simplified_places ? simplified_places->size() : number_of_places);
  else
  {
    const auto check_graph = [&](const Flat_graph& flat_graph) {
      const bool is_right = simplified_places ? is_simplified_graph(on_mesh, flat_graph, *simplified_places)
                                              : is_same_graph(on_mesh, flat_graph);
      if(!is_right)
        throw Graph_mismatch_error();
    };
    *place_of_vertex =
      find_places(threads, on_mesh.complex(), on_mesh.order(), ties, are_degree_two_nodes_kept, check_graph, progress);
  }
  if(simplified_places)
  {
    for(Index& place : *place_of_vertex)
      place = place == no_index ? place : (*simplified_places)[place];
  }
  const auto arcs = edges(graph);
  progress.report_end();
  return VertexPlaces(
    on_mesh.vertex_numbers(), num_vertices(graph), {arcs.first, arcs.second}, place_of_vertex,
    std::make_shared<Vertex_lists<vertex_descriptor>>(on_mesh.list_vertices(place_of_vertex, number_of_places)));
}

#define CGAL_REEB_GRAPH_FIND_PLACES(PREFIX, COMPLEX)                                                                   \
  PREFIX template Place_of_vertex find_places(const Threads&, const COMPLEX&, const Vertex_order&, Ties, bool,         \
                                              const std::function<void(const Flat_graph&)>&, const Progress&);
CGAL_REEB_GRAPH_FOR_COMPLEXES(CGAL_REEB_GRAPH_FIND_PLACES)

} // namespace CGAL::Reeb_graph::internal

#endif // CGAL_REEB_GRAPH_INTERNAL_WAY_BACK_GRAPH_ON_MESH_H
