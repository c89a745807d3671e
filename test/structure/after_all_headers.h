// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

// What users do after they have included our headers: algorithms of Boost.Graph on graphs as in its examples, with
// pointers as property maps, and on meshes as in CGAL's. It is compiled by scripts/check_syntax; some headers of Boost
// hide names that its algorithms look up, and those hidden by one header are hidden behind all of them.

#include <CGAL/Reeb_graph_traits.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

#include <boost/graph/adjacency_list.hpp>
#include <boost/graph/connected_components.hpp>
#include <boost/graph/dijkstra_shortest_paths.hpp>
#include <boost/graph/graphml.hpp>
#include <boost/graph/kruskal_min_spanning_tree.hpp>
#include <boost/graph/prim_minimum_spanning_tree.hpp>

#include <fstream>
#include <iterator>
#include <vector>

inline void use_boost_graph()
{
  typedef boost::property<boost::edge_weight_t, double> Weight;
  typedef boost::adjacency_list<boost::vecS, boost::vecS, boost::undirectedS, boost::no_property, Weight> Graph;
  Graph graph(2);
  add_edge(0, 1, 1.0, graph);
  std::vector<double> distances(2);
  std::vector<int> numbers(2), predecessors(2);
  boost::dijkstra_shortest_paths(graph, 0, boost::distance_map(distances.data()).predecessor_map(predecessors.data()));
  boost::connected_components(graph, numbers.data());
}

inline void use_cgal()
{
  typedef CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3> Mesh;
  typedef boost::graph_traits<Mesh> Traits;
  Mesh mesh;
  const auto start = mesh.add_vertex();
  const auto predecessor_map = mesh.add_property_map<Traits::vertex_descriptor, Traits::vertex_descriptor>("").first;
  boost::prim_minimum_spanning_tree(mesh, predecessor_map, boost::root_vertex(start));
  std::vector<Traits::edge_descriptor> tree;
  boost::kruskal_minimum_spanning_tree(mesh, std::back_inserter(tree));
}

// Boost's function of the same name is meant: it takes a stream as it is, and ours makes something of it.
inline void write_by_boost(std::ofstream& out)
{
  typedef CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3> Mesh;
  CGAL::Reeb_graph_traits<Mesh, Mesh::Property_map<Mesh::Vertex_index, double>>::Graph graph;
  const boost::dynamic_properties properties;
  write_graphml(out, graph, properties);
}
