// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

// What the tuned parts gain: the time of the whole graph without the one that the macro CGAL_REEB_GRAPH_LEFT_OUT names.
// With all of them, also the time to write a graph from arrays: with the containers of Reeb_graph_traits, with the
// usual ones of an adjacency list, and as compressed rows, which cannot be changed. Shortest times of several runs.

#include "Table.h"
#include "inputs.h"
#include "measurements.h"

#include <CGAL/boost/graph/iterator.h>
#include <CGAL/compute_reeb_graph.h>

#include <boost/graph/adjacency_list.hpp>
#include <boost/graph/compressed_sparse_row_graph.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdlib>
#include <ctime>
#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace {
using benchmark::cell;

typedef CGAL::Reeb_graph_traits<benchmark::Mesh, benchmark::Scalar_map> Traits;
typedef Traits::Node Node;
typedef Traits::Arc Arc;
typedef boost::edge_property_type<Traits::Graph>::type Arc_property;
typedef boost::adjacency_list<boost::vecS, boost::vecS, boost::bidirectionalS, Node, Arc_property> Usual_graph;
typedef boost::compressed_sparse_row_graph<boost::bidirectionalS, Node, Arc> Compressed_graph;

constexpr int number_of_repetitions = 5;

// The time of the processor, as other programs may run beside this one, which has one thread.
template <class Function>
double processor_milliseconds(const Function& function)
{
  const std::clock_t begin = std::clock();
  function();
  return 1000. * static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC;
}

template <class Run>
double shortest_time(const Run& run)
{
  double shortest = std::numeric_limits<double>::max();
  for(int repetition = 0; repetition != number_of_repetitions; ++repetition)
    shortest = std::min(shortest, run());
  return shortest;
}

struct Graph_arrays
{
  explicit Graph_arrays(const Traits::Graph& graph)
  {
    for(const auto node : CGAL::make_range(vertices(graph)))
      nodes.push_back(graph[node]);
    for(const auto arc : CGAL::make_range(edges(graph)))
    {
      ends.emplace_back(source(arc, graph), target(arc, graph));
      arcs.push_back(graph[arc]);
    }
  }

  std::vector<Node> nodes;
  std::vector<std::pair<std::size_t, std::size_t>> ends;
  std::vector<Arc> arcs;
};

template <class Graph>
void write(const Graph_arrays& arrays, Graph& graph)
{
  CGAL::Reeb_graph::internal::reserve_nodes(CGAL::Reeb_graph::internal::Threads(), graph, arrays.nodes.size());
  for(const Node& node : arrays.nodes)
    add_vertex(node, graph);
  for(std::size_t i = 0; i != arrays.arcs.size(); ++i)
    graph[add_edge(arrays.ends[i].first, arrays.ends[i].second, graph).first] = arrays.arcs[i];
}

void write(const Graph_arrays& arrays, Compressed_graph& graph)
{
  graph = Compressed_graph(boost::edges_are_unsorted_multi_pass, arrays.ends.begin(), arrays.ends.end(),
                           arrays.arcs.begin(), arrays.nodes.size());
  for(std::size_t i = 0; i != arrays.nodes.size(); ++i)
    graph[i] = arrays.nodes[i];
}

template <class Graph>
double writing_time(const Graph_arrays& arrays)
{
  return shortest_time([&] {
    Graph graph;
    return processor_milliseconds([&] { write(arrays, graph); });
  });
}

double computing_time(const benchmark::Input& input)
{
  return shortest_time([&] {
    Traits::Graph graph;
    return processor_milliseconds([&] { CGAL::compute_reeb_graph(input.mesh(), input.scalar_map(), graph); });
  });
}

std::string memory_per_vertex(const benchmark::Input& input)
{
  const benchmark::Memory_gauge gauge;
  Traits::Graph graph;
  CGAL::compute_reeb_graph(input.mesh(), input.scalar_map(), graph);
  const std::optional<double> bytes = gauge.extra_peak_bytes();
  return bytes ? cell(*bytes / static_cast<double>(input.mesh().number_of_vertices()), 0) : "-";
}
} // namespace

// The name of what is left out, and the number of vertices.
int main(int argc, char* argv[])
{
  const std::string name = argc > 1 ? argv[1] : "nothing";
  const std::size_t number_of_vertices = argc > 2 ? std::strtoul(argv[2], nullptr, 10) : 1000000;
  const bool is_complete = !CGAL::Reeb_graph::internal::is_used(CGAL::Reeb_graph::internal::Tuned_part::NONE);
  benchmark::Input input("genus-3", number_of_vertices), across("across", number_of_vertices),
    shuffled("genus-3", number_of_vertices, benchmark::Mesh_order::SHUFFLED);
  std::vector<benchmark::Column> columns = {{"", "", 28}};
  for(const std::string& field : benchmark::field_names())
    columns.push_back({field, "ms", 8});
  std::vector<std::string> computing = {is_complete ? "with all parts" : "without " + name},
                           computing_across = {"faces across"}, computing_on_shuffled = {"vertices and faces shuffled"},
                           ours = {"our containers"}, usual = {"usual containers"}, compressed = {"compressed rows"},
                           memory = {"bytes per vertex, peak"};
  for(const std::string& field : benchmark::field_names())
  {
    input.set_field(field);
    memory.push_back(memory_per_vertex(input));
    computing.push_back(cell(computing_time(input), 1));
    across.set_field(field);
    computing_across.push_back(cell(computing_time(across), 1));
    shuffled.set_field(field);
    computing_on_shuffled.push_back(cell(computing_time(shuffled), 1));
    if(!is_complete)
      continue;
    Traits::Graph graph;
    CGAL::compute_reeb_graph(input.mesh(), input.scalar_map(), graph);
    const Graph_arrays arrays(graph);
    ours.push_back(cell(writing_time<Traits::Graph>(arrays), 1));
    usual.push_back(cell(writing_time<Usual_graph>(arrays), 1));
    compressed.push_back(cell(writing_time<Compressed_graph>(arrays), 1));
  }
  const std::string size = cell(std::size_t(input.mesh().number_of_vertices()));
  const benchmark::Table table("From the mesh to the graph, one thread, " + size + " vertices", columns);
  for(const auto& row : {computing, computing_across, computing_on_shuffled, memory})
    table.print_row(row);
  if(is_complete)
  {
    const benchmark::Table writing_table("Nodes and arcs alone, from arrays", columns);
    for(const auto& row : {ours, usual, compressed})
      writing_table.print_row(row);
  }
  return EXIT_SUCCESS;
}
