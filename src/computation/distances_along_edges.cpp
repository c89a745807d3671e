// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#include "computation/distances_along_edges.h"

#include <CGAL/Reeb_graph/internal/base/lengths.h>

// Before that of compressed graphs, which hides a function that it needs.
#include <boost/pending/disjoint_sets.hpp>

#include <boost/graph/compressed_sparse_row_graph.hpp>
#include <boost/graph/dijkstra_shortest_paths.hpp>
#include <boost/property_map/property_map.hpp>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <stdexcept>
#include <string>
#include <utility>

namespace reeb_graph_program {
namespace {
typedef std::vector<std::pair<std::size_t, std::size_t>> Edges;
constexpr std::size_t no_vertex = static_cast<std::size_t>(-1);

struct Length
{
  double length = 0;
};

// Each edge twice, once in each direction, in ascending order.
Edges directed_edges(const Complex& complex)
{
  Edges edges;
  const auto add_edges_of = [&](const auto& simplices) {
    for(const auto& simplex : simplices)
      for(const std::size_t u : simplex)
        for(const std::size_t v : simplex)
          if(u != v)
            edges.emplace_back(u, v);
  };
  add_edges_of(complex.edges);
  add_edges_of(complex.triangles);
  add_edges_of(complex.tetrahedra);
  std::sort(edges.begin(), edges.end());
  edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
  return edges;
}

// The distances of all vertices from the nearest source. Behind the vertices there is one more, from which edges of
// length 0 lead to the sources.
std::vector<double> distances_from(const Surface& surface, Edges edges, const std::vector<std::size_t>& sources)
{
  typedef boost::compressed_sparse_row_graph<boost::directedS, boost::no_property, Length> Graph;
  std::vector<Length> lengths;
  lengths.reserve(edges.size() + sources.size());
  const auto point = [&](std::size_t v) {
    return surface.point(Surface::Vertex_index(static_cast<Surface::size_type>(v)));
  };
  for(const auto& [u, v] : edges)
    lengths.push_back({CGAL::Reeb_graph::internal::distance_between(point(u), point(v))});
  const std::size_t number_of_vertices = surface.number_of_vertices();
  for(const std::size_t source : sources)
    edges.emplace_back(number_of_vertices, source);
  lengths.resize(edges.size());
  const Graph graph(boost::edges_are_sorted, edges.begin(), edges.end(), lengths.begin(), number_of_vertices + 1);
  std::vector<double> distances(number_of_vertices + 1);
  boost::dijkstra_shortest_paths(
    graph, number_of_vertices,
    boost::weight_map(get(&Length::length, graph))
      .distance_map(boost::make_iterator_property_map(distances.begin(), get(boost::vertex_index, graph)))
      .distance_inf(std::numeric_limits<double>::infinity()));
  distances.pop_back();
  return distances;
}

// A vertex of each component that is farthest away from its first one.
std::vector<std::size_t> far_sources(const Surface& surface, const Edges& edges)
{
  boost::disjoint_sets_with_storage<> components(surface.number_of_vertices());
  for(const auto& [u, v] : edges)
    components.union_set(u, v);
  std::vector<std::size_t> first(surface.number_of_vertices(), no_vertex), firsts;
  for(std::size_t v = 0; v < first.size(); ++v)
    if(first[components.find_set(v)] == no_vertex)
    {
      first[components.find_set(v)] = v;
      firsts.push_back(v);
    }
  const std::vector<double> distances = distances_from(surface, edges, firsts);
  std::vector<std::size_t>& farthest = first;
  for(std::size_t v = 0; v < distances.size(); ++v)
  {
    std::size_t& best = farthest[components.find_set(v)];
    best = distances[v] > distances[best] ? v : best;
  }
  std::vector<std::size_t> sources;
  std::copy_if(farthest.begin(), farthest.end(), std::back_inserter(sources),
               [](std::size_t v) { return v != no_vertex; });
  std::sort(sources.begin(), sources.end());
  return sources;
}

} // namespace

std::vector<std::size_t> compute_distances_along_edges(const Mesh& mesh,
                                                       std::vector<std::size_t> sources,
                                                       Scalar_map scalar_map)
{
  const Surface& surface = mesh.surface;
  for(const std::size_t source : sources)
    if(source >= surface.number_of_vertices())
      throw std::runtime_error("there is no vertex " + std::to_string(source) + ": the mesh has "
                               + std::to_string(surface.number_of_vertices()) + ", numbered from 0");
  const Edges edges = directed_edges(*mesh.complex);
  if(sources.empty())
    sources = far_sources(surface, edges);
  const std::vector<double> distances = distances_from(surface, edges, sources);
  for(const Surface::Vertex_index v : surface.vertices())
  {
    if(!std::isfinite(distances[v]))
      throw std::runtime_error("no edges lead from a source to vertex " + std::to_string(v.idx())
                               + ": --source needs a vertex of each component");
    scalar_map[v] = distances[v];
  }
  return sources;
}

} // namespace reeb_graph_program
