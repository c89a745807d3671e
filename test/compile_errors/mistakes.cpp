// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#include <CGAL/Reeb_graph/Augmentation.h>
#include <CGAL/Reeb_graph/IO.h>
#include <CGAL/Reeb_graph/IO/graphml.h>
#include <CGAL/Reeb_graph/IO/svg.h>
#include <CGAL/Reeb_graph/arc_measures.h>
#include <CGAL/Reeb_graph/curves/cutting_system.h>
#include <CGAL/Reeb_graph/curves/segmentation.h>
#include <CGAL/Reeb_graph/fields/height_field.h>
#include <CGAL/Reeb_graph/fields/make_borders_level.h>
#include <CGAL/Reeb_graph/plane_layout.h>
#include <CGAL/Reeb_graph/simplification/persistence_pairs.h>
#include <CGAL/Reeb_graph/simplification/simplification_thresholds.h>
#include <CGAL/Reeb_graph/simplification/simplify.h>
#include <CGAL/Reeb_graph/simplification/simplify_field.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/compute_reeb_graph.h>

#include <boost/graph/adjacency_list.hpp>
#include <boost/property_map/property_map.hpp>

#include <cstddef>
#include <istream>
#include <iterator>
#include <ostream>
#include <vector>

// Each function has one mistake, and the message that tells it.

typedef CGAL::Simple_cartesian<double> Kernel;
typedef CGAL::Surface_mesh<Kernel::Point_3> Mesh;
typedef Mesh::Property_map<Mesh::Vertex_index, double> Scalar_map;
typedef Mesh::Property_map<Mesh::Face_index, double> Face_map;
typedef CGAL::Reeb_graph_traits<Mesh, Scalar_map> Traits;
typedef Traits::Graph Graph;
typedef CGAL::Reeb_graph::Curve<Mesh::Halfedge_index> Curve;

template <class Edges, class Vertices, class Directed>
using Graph_of = boost::adjacency_list<Edges, Vertices, Directed, Traits::Node, Traits::Arc>;

struct Unordered
{
};

struct Ordered
{
  friend bool operator<(const Ordered&, const Ordered&) { return false; }
};

// Types of values that are no numbers and no texts: one for each function, as a compiler tells each type once.
template <int number>
struct Value
{
  friend bool operator<(const Value&, const Value&) { return false; }
};
template <int number>
using Value_map = Mesh::Property_map<Mesh::Vertex_index, Value<number>>;
template <int number>
using Value_graph = typename CGAL::Reeb_graph_traits<Mesh, Value_map<number>>::Graph;

// message: The mesh is const
void call_with_const_mesh(const Mesh& mesh, Scalar_map scalar_map, std::vector<Curve>& curves)
{
  CGAL::Reeb_graph::cutting_system(mesh, scalar_map, std::back_inserter(curves));
}

// message: The mesh is not a FaceListGraph of CGAL
void call_with_no_mesh(const std::vector<Mesh::Vertex_index>& triangles, Scalar_map scalar_map, Graph& graph)
{
  CGAL::compute_reeb_graph(triangles, scalar_map, graph);
}

// message: A property map is needed
void call_with_no_map(const Mesh& mesh, const std::vector<double>& scalars)
{
  CGAL::Reeb_graph_traits<Mesh, std::vector<double>>::Graph graph;
  CGAL::compute_reeb_graph(mesh, scalars, graph);
}

// message: The keys of this property map are not the vertices of the mesh
void call_with_map_of_faces(const Mesh& mesh, Face_map scalar_map, Graph& graph)
{
  CGAL::compute_reeb_graph(mesh, scalar_map, graph);
}

// message: This property map can only be read
void call_with_read_only_map(const Mesh& mesh)
{
  const boost::static_property_map<double, Mesh::Vertex_index> scalar_map(0);
  CGAL::Reeb_graph::compute_height_field(mesh, scalar_map, Kernel::Vector_3(0, 0, 1));
}

// message: The scalar values have no order
void call_with_no_order(const Mesh& mesh, Mesh::Property_map<Mesh::Vertex_index, Unordered> scalar_map)
{
  CGAL::Reeb_graph_traits<Mesh, decltype(scalar_map)>::Graph graph;
  CGAL::compute_reeb_graph(mesh, scalar_map, graph);
}

// message: The graph is one for scalar values of another type
void call_with_other_scalars(const Mesh& mesh, Mesh::Property_map<Mesh::Vertex_index, Ordered> scalar_map, Graph& graph)
{
  CGAL::compute_reeb_graph(mesh, scalar_map, graph);
}

// message: The graph is const
void call_with_const_graph(const Mesh& mesh, Scalar_map scalar_map, const Graph& graph)
{
  CGAL::compute_reeb_graph(mesh, scalar_map, graph);
}

// message: A Reeb graph has parallel arcs
void call_with_graph_without_parallel_arcs(const Graph_of<boost::setS, boost::vecS, boost::bidirectionalS>& graph)
{
  auto simplified = graph;
  CGAL::Reeb_graph::simplify(graph, 1, simplified);
}

// message: The nodes of a Reeb graph are numbered
void call_with_graph_without_numbers(const Mesh& mesh,
                                     Scalar_map scalar_map,
                                     const Graph_of<boost::vecS, boost::listS, boost::bidirectionalS>& graph)
{
  CGAL::Reeb_graph::Augmentation augmentation(mesh, scalar_map, graph);
}

// message: The arcs of a Reeb graph are directed upwards
void call_with_undirected_graph(const Mesh& mesh, Scalar_map scalar_map)
{
  Graph_of<boost::vecS, boost::vecS, boost::undirectedS> graph;
  CGAL::compute_reeb_graph(mesh, scalar_map, graph);
}

// message: The graph has no places for what a Reeb graph stores
void call_with_graph_without_chains(const Mesh& mesh, Scalar_map scalar_map)
{
  boost::adjacency_list<boost::vecS, boost::vecS, boost::bidirectionalS> graph;
  CGAL::compute_reeb_graph(mesh, scalar_map, graph);
}

// message: The keys of this index map are not the vertices of the mesh that the graph is of
void call_with_map_of_faces_for_nodes(const Graph& graph, Face_map index_map, std::ostream& out)
{
  CGAL::Reeb_graph::write_graphml(out, graph, index_map);
}

// message: The scalar values are not numbers
void simplify_other_values(const Value_graph<0>& graph, Value_graph<0>& simplified)
{
  CGAL::Reeb_graph::simplify(graph, 1, simplified);
}

// message: The scalar values are not numbers
void find_arc_persistences_of_other_values(const Value_graph<1>& graph) { CGAL::Reeb_graph::arc_persistences(graph); }

// message: The scalar values are not numbers
void find_persistence_of_other_values(const Value_graph<2>& graph,
                                      const CGAL::Reeb_graph::Persistence_pair<std::size_t>& pair)
{
  CGAL::Reeb_graph::persistence(graph, pair);
}

// message: The scalar values are not numbers
void lay_out_other_values(const Value_graph<3>& graph) { CGAL::Reeb_graph::lay_out_in_plane(graph); }

// message: The scalar values are not numbers
void draw_other_values(const Value_graph<4>& graph, std::ostream& out) { CGAL::Reeb_graph::write_svg(out, graph); }

// message: The scalar values are not numbers
void measure_arcs_of_other_values(const Mesh& mesh, Value_map<5> scalar_map, const Value_graph<5>& graph)
{
  CGAL::Reeb_graph::arc_lengths(mesh, scalar_map, graph);
}

// message: The scalar values are not numbers
void cut_along_curves_of_other_values(Mesh& mesh, Value_map<6> scalar_map, std::vector<Curve>& curves)
{
  CGAL::Reeb_graph::cutting_system(mesh, scalar_map, std::back_inserter(curves));
}

// message: The scalar values are not numbers
void segment_by_other_values(Mesh& mesh, Value_map<7> scalar_map, const Value_graph<7>& graph, Face_map patches)
{
  CGAL::Reeb_graph::segment_by_arcs(mesh, scalar_map, graph, patches);
}

// message: The scalar values are not numbers
void simplify_field_of_other_values(const Mesh& mesh, Value_map<8> scalar_map)
{
  CGAL::Reeb_graph::simplify_field(mesh, scalar_map, 1, scalar_map);
}

// message: The scalar values are not numbers
void make_borders_level_by_other_values(const Mesh& mesh, Value_map<9> scalar_map)
{
  CGAL::Reeb_graph::make_borders_level(mesh, scalar_map);
}

// message: The scalar values cannot be written
void write_other_values(const Mesh& mesh, const Value_graph<10>& graph, std::ostream& out)
{
  CGAL::Reeb_graph::write_graphml(out, graph, get(boost::vertex_index, mesh), get(boost::halfedge_index, mesh));
}

// message: The scalar values cannot be written
void write_other_values_as_graphviz(const Mesh& mesh, const Value_graph<11>& graph, std::ostream& out)
{
  CGAL::Reeb_graph::write_graphviz(out, graph, get(boost::vertex_index, mesh));
}

// message: The scalar values cannot be read
void read_other_values(const Mesh& mesh, Value_graph<12>& graph, std::istream& in)
{
  CGAL::Reeb_graph::read_graphml(in, mesh, graph);
}

// message: The nodes of the graph have no scalar values
void lay_out_graph_without_values(const boost::adjacency_list<boost::vecS, boost::vecS, boost::bidirectionalS>& graph)
{
  CGAL::Reeb_graph::lay_out_in_plane(graph);
}
