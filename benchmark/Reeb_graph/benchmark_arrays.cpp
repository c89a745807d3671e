// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

// How long C++ takes from the arrays that benchmark_arrays.py hands in, on standard input: the numbers of vertices and
// triangles, scalars, points, and triangles. For each line that follows, it makes a surface and its graph, and prints the
// seconds of wall time and of CPU time.
#include "base/surface.h"
#include "input/assemble_surface.h"

#include <CGAL/compute_reeb_graph.h>

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <ctime>
#include <iostream>
#include <string>
#include <vector>

namespace {
using namespace reeb_graph_program; // NOLINT(google-build-using-namespace)

template <class Number>
std::vector<Number> read(std::size_t count)
{
  std::vector<Number> numbers(count);
  std::cin.read(reinterpret_cast<char*>(numbers.data()), static_cast<std::streamsize>(count * sizeof(Number)));
  return numbers;
}

std::size_t number_of_arcs(const std::vector<double>& scalars,
                           const std::vector<double>& points,
                           const std::vector<std::int64_t>& triangles)
{
  Polygon_soup soup;
  for(std::size_t v = 0; v < scalars.size(); ++v)
    soup.points.emplace_back(points[3 * v], points[3 * v + 1], points[3 * v + 2]);
  Corner* const corners = soup.polygons.make_triangles(triangles.size() / 3);
  std::transform(triangles.begin(), triangles.end(), corners, [](std::int64_t v) { return static_cast<Corner>(v); });
  Surface surface;
  if(!assemble_surface(soup, surface))
    return 0;
  const Scalar_map map = surface.add_property_map<Surface::Vertex_index, double>("v:scalar").first;
  for(const Surface::Vertex_index v : surface.vertices())
    map[v] = scalars[v];
  Graph graph;
  CGAL::compute_reeb_graph<CGAL::Parallel_if_available_tag>(surface, map, graph);
  return num_edges(graph);
}

} // namespace

int main()
{
  const std::vector<std::int64_t> sizes = read<std::int64_t>(2);
  const auto scalars = read<double>(static_cast<std::size_t>(sizes[0]));
  const auto points = read<double>(static_cast<std::size_t>(3 * sizes[0]));
  const auto triangles = read<std::int64_t>(static_cast<std::size_t>(3 * sizes[1]));
  for(char line = 0; std::cin.get(line);)
  {
    const auto start = std::chrono::steady_clock::now();
    const std::clock_t cpu_start = std::clock();
    const std::size_t arcs = number_of_arcs(scalars, points, triangles);
    const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
    const double cpu_seconds = static_cast<double>(std::clock() - cpu_start) / CLOCKS_PER_SEC;
    std::cout << seconds.count() << ' ' << cpu_seconds << ' ' << arcs << std::endl;
  }
}
