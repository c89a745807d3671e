// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of the CGAL-style package Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

// Times of the whole way from a mesh in memory to the finished graph with its chains, beside two floors measured in
// the same run: std::sort of (value, index) pairs, and one sweep over the faces as flat triangles.
//
// Usage: benchmark_reeb_graph [NUMBER OF VERTICES] [REPETITIONS]

#include "generated_surfaces.h"

#include <CGAL/Reeb_graph/Augmentation.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/compute_reeb_graph.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <random>
#include <string>
#include <utility>
#include <vector>

typedef CGAL::Simple_cartesian<double> Kernel;
typedef CGAL::Surface_mesh<Kernel::Point_3> Mesh;
typedef Mesh::Property_map<Mesh::Vertex_index, double> Scalar_map;
typedef CGAL::Reeb_graph_traits<Mesh, Scalar_map>::Graph Reeb_graph;
typedef CGAL::Reeb_graph::Method Method;

namespace {
double milliseconds(const std::function<void()>& function)
{
  const auto start = std::chrono::steady_clock::now();
  function();
  return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
}

double median_of_milliseconds(std::size_t repetitions, const std::function<void()>& function)
{
  std::vector<double> times;
  for(std::size_t i = 0; i != repetitions; ++i)
    times.push_back(milliseconds(function));
  std::nth_element(times.begin(), times.begin() + repetitions / 2, times.end());
  return times[repetitions / 2];
}

Mesh make_mesh(const generated_surfaces::Triangle_soup& soup)
{
  Mesh mesh;
  mesh.reserve(soup.points.size(), soup.points.size() + soup.triangles.size(), soup.triangles.size());
  for(const auto& p : soup.points)
    mesh.add_vertex(Kernel::Point_3(p[0], p[1], p[2]));
  for(const auto& t : soup.triangles)
    mesh.add_face(Mesh::Vertex_index(t[0]), Mesh::Vertex_index(t[1]), Mesh::Vertex_index(t[2]));
  return mesh;
}

double field_value(const std::string& field, const Kernel::Point_3& p, std::mt19937& random)
{
  if(field == "height")
    return p.y();
  if(field == "noise")
    return static_cast<double>(random());
  const double smooth = std::sin(2 * p.x()) + 0.5 * std::sin(3 * p.y() + p.x()) + 0.1 * p.z();
  return field == "smooth" ? smooth : std::floor(20 * smooth); // tied
}

void sort_values(const Mesh& mesh, Scalar_map scalar_map)
{
  std::vector<std::pair<double, Mesh::size_type>> pairs;
  for(const Mesh::Vertex_index v : mesh.vertices())
    pairs.emplace_back(scalar_map[v], v.idx());
  std::sort(pairs.begin(), pairs.end());
}

// The sum keeps the loop from being optimized away.
double sweep_faces(const std::vector<std::array<std::size_t, 3>>& triangles, Scalar_map scalar_map)
{
  double sum = 0;
  for(const auto& t : triangles)
    sum += std::max({scalar_map[Mesh::Vertex_index(t[0])], scalar_map[Mesh::Vertex_index(t[1])],
                     scalar_map[Mesh::Vertex_index(t[2])]});
  return sum;
}

// About 1000 contours: at three places of some or all arcs, again and again if there are few.
double nanoseconds_per_crossed_edge(const Mesh& mesh, Scalar_map scalar_map, const Reeb_graph& graph)
{
  const CGAL::Reeb_graph::Augmentation augmentation(mesh, scalar_map, graph);
  const auto arc_range = edges(graph);
  const std::vector<boost::graph_traits<Reeb_graph>::edge_descriptor> arcs(arc_range.first, arc_range.second);
  const std::size_t stride = arcs.size() / 333 + 1;
  std::size_t number_of_contours = 0, number_of_edges = 0;
  const double time = milliseconds([&] {
    while(number_of_contours < 900)
      for(std::size_t i = 0; i < arcs.size(); i += stride)
        for(const double t : {0.25, 0.5, 0.75})
        {
          number_of_edges += augmentation.contour(arcs[i], t).halfedges.size();
          ++number_of_contours;
        }
  });
  return 1e6 * time / static_cast<double>(number_of_edges);
}

void measure(const std::string& name, const generated_surfaces::Triangle_soup& soup, std::size_t repetitions)
{
  Mesh mesh = make_mesh(soup);
  const Scalar_map scalar_map = mesh.add_property_map<Mesh::Vertex_index, double>("v:scalar").first;
  for(const std::string field : {"smooth", "height", "noise", "tied"})
  {
    std::mt19937 random(1);
    for(const Mesh::Vertex_index v : mesh.vertices())
      scalar_map[v] = field_value(field, mesh.point(v), random);

    Reeb_graph graph;
    volatile double sum = 0;
    const double sort = median_of_milliseconds(repetitions, [&] { sort_values(mesh, scalar_map); });
    const double sweep = median_of_milliseconds(repetitions, [&] { sum = sweep_faces(soup.triangles, scalar_map); });
    const double total =
      median_of_milliseconds(repetitions, [&] { CGAL::compute_reeb_graph(mesh, scalar_map, graph); });
    const double location =
      milliseconds([&] { CGAL::Reeb_graph::Augmentation(mesh, scalar_map, graph).locate_vertices(); });
    std::printf("%-10s %-8s %9zu %8zu %9.1f %9.1f %9.1f %8.2f %9.1f %10.1f\n", name.c_str(), field.c_str(),
                std::size_t(mesh.number_of_vertices()), std::size_t(num_edges(graph)), sort, sweep, total, total / sort,
                location / sort, nanoseconds_per_crossed_edge(mesh, scalar_map, graph));
    std::fflush(stdout);
  }
}

} // namespace

int main(int argc, char* argv[])
{
  const std::size_t number_of_vertices = argc > 1 ? std::strtoul(argv[1], nullptr, 10) : 1000000;
  const std::size_t repetitions = argc > 2 ? std::strtoul(argv[2], nullptr, 10) : 5;
  if(number_of_vertices == 0 || repetitions == 0)
  {
    std::fprintf(stderr, "usage: benchmark_reeb_graph [NUMBER OF VERTICES] [REPETITIONS]\n");
    return EXIT_FAILURE;
  }
  const auto side = static_cast<std::size_t>(std::sqrt(static_cast<double>(number_of_vertices)));

  std::printf("times in ms, medians of %zu; one thread\n", repetitions);
  std::printf("%-10s %-8s %9s %8s %9s %9s %9s %8s %9s %10s\n", "surface", "field", "vertices", "arcs", "sort", "sweep",
              "graph", "graph", "locate", "contours");
  std::printf("%-10s %-8s %9s %8s %9s %9s %9s %8s %9s %10s\n", "", "", "", "", "ms", "ms", "ms", "/ sort", "/ sort",
              "ns / edge");
  measure("genus 0", generated_surfaces::closed_surface(0, number_of_vertices), repetitions);
  measure("genus 3", generated_surfaces::closed_surface(3, number_of_vertices), repetitions);
  measure("genus 25", generated_surfaces::closed_surface(25, number_of_vertices), repetitions);
  measure("terrain", generated_surfaces::terrain(side, side), repetitions);
  return EXIT_SUCCESS;
}
