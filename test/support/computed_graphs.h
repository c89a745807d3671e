// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_TEST_COMPUTED_GRAPHS_H
#define CGAL_REEB_GRAPH_TEST_COMPUTED_GRAPHS_H

#include "graph_checks.h"
#include "mesh_builders.h"
#include "random_fields.h"
#include "random_meshes.h"

#include <CGAL/Reeb_graph/IO.h>
#include <CGAL/compute_reeb_graph.h>

#include <boost/property_map/function_property_map.hpp>

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/global_control.h>
#include <tbb/task_arena.h>
#endif

#include <cstddef>
#include <sstream>
#include <string>
#include <vector>

// The same graph computed in several ways, to be compared to the byte.
namespace computed_graphs {
using CGAL::Reeb_graph::Method;
using CGAL::Reeb_graph::Ties;
using mesh_builders::make_mesh;
using mesh_builders::Mesh_numbers;
using random_meshes::Combinatorial_mesh;
using random_meshes::Field_class;
using random_meshes::Mesh_class;
using random_meshes::Random;

// The files that are written of it.
template <class Mesh, class Graph>
std::string written(const Mesh_numbers<Mesh>& numbers, const Graph& graph)
{
  typedef typename boost::graph_traits<Mesh>::vertex_descriptor vertex_descriptor;
  const auto vertex_index_map =
    boost::make_function_property_map<vertex_descriptor>([&](vertex_descriptor v) { return numbers.vertex(v); });
  std::ostringstream files;
  CGAL::Reeb_graph::write_graphml(files, graph, vertex_index_map);
  CGAL::Reeb_graph::write_graphviz(files, graph, vertex_index_map);
  return files.str();
}

// What decides the graph, and what does not.
struct Settings
{
  Ties ties = Ties::PERTURB;
  bool keeps_degree_two_nodes = false;
  Method method = Method::CONTOUR_TREES;
  std::size_t number_of_slabs = 1;
  std::size_t number_of_threads = 1;
};

inline std::ostream& operator<<(std::ostream& out, const Settings& settings)
{
  return out << (settings.method == Method::CRITICAL_SETS ? "critical sets, " : "contour trees, ")
             << settings.number_of_slabs << " slabs, " << settings.number_of_threads << " threads, ties "
             << (settings.ties == Ties::CONTRACT ? "contracted" : "perturbed")
             << (settings.keeps_degree_two_nodes ? ", degree two nodes kept" : "");
}

// the settings that decide the graph, all four combinations in turn
inline Settings settings_of_seed(std::size_t seed)
{
  Settings settings;
  settings.ties = seed % 2 == 0 ? Ties::PERTURB : Ties::CONTRACT;
  settings.keeps_degree_two_nodes = seed / 2 % 2 == 1;
  return settings;
}

inline auto named_parameters(const Settings& settings)
{
  namespace parameters = CGAL::parameters;
  return parameters::ties(settings.ties)
    .method(settings.method)
    .keep_degree_two_nodes(settings.keeps_degree_two_nodes)
    .number_of_slabs(settings.number_of_slabs);
}

// Calls the function in an arena of that many threads, even if there are fewer cores.
template <class Function>
void run_with_threads(std::size_t number_of_threads, const Function& function)
{
#ifdef CGAL_LINKED_WITH_TBB
  const tbb::global_control control(tbb::global_control::max_allowed_parallelism, number_of_threads);
  tbb::task_arena(static_cast<int>(number_of_threads)).execute(function);
#else
  static_cast<void>(number_of_threads);
  function();
#endif
}

template <class ConcurrencyTag, class Mesh>
graph_checks::Graph_of<Mesh> compute(const Mesh& mesh,
                                     const graph_checks::Scalar_map_of<Mesh>& scalar_map,
                                     const Settings& settings)
{
  graph_checks::Graph_of<Mesh> graph;
  run_with_threads(settings.number_of_threads, [&] {
    CGAL::compute_reeb_graph<ConcurrencyTag>(mesh, scalar_map, graph, named_parameters(settings));
  });
  return graph;
}

} // namespace computed_graphs

#endif // CGAL_REEB_GRAPH_TEST_COMPUTED_GRAPHS_H
