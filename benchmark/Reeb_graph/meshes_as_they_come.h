// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_BENCHMARK_MESHES_AS_THEY_COME_H
#define CGAL_REEB_GRAPH_BENCHMARK_MESHES_AS_THEY_COME_H

#include "generated_surfaces.h"
#include "generated_surfaces/Triangle_soup.h"
#include "generated_surfaces/implicit_surface.h"
#include "shuffle.h"

#include <CGAL/boost/graph/Euler_operations.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <numeric>
#include <random>
#include <utility>
#include <vector>

// Surfaces of genus 3 in the order that other programs give their vertices and faces.
namespace benchmark {
using generated_surfaces::Triangle_soup;

// A plate with three holes, cut out of a grid of cells. Its vertices and triangles are in the order of the cells, or,
// if faces go across, the triangles are in the order of the cells along another axis.
inline Triangle_soup isosurface(std::size_t number_of_vertices, bool do_faces_go_across)
{
  const auto function = [](const std::array<double, 3>& p) {
    double value = std::pow(p[0] / 2.1, 4) + std::pow(p[1] / 0.9, 4) - 1;
    for(const double x : {-1.2, 0., 1.2})
      value = std::max(value, 0.16 - (p[0] - x) * (p[0] - x) - p[1] * p[1]);
    return value + 4 * p[2] * p[2] - 0.05;
  };
  const double cell_size = std::sqrt(87 / static_cast<double>(number_of_vertices)); // area times vertices of a cell
  generated_surfaces::internal::Marching_tetrahedra cells(function, {-2.3, -1.1, -.6}, {2.3, 1.1, .6}, cell_size);
  Triangle_soup soup = cells.take_surface();
  generated_surfaces::internal::smooth(soup, function, 4);
  if(do_faces_go_across)
  {
    const auto column = [&](const auto& triangle) { return std::floor(soup.points[triangle[0]][0] / cell_size); };
    std::stable_sort(soup.triangles.begin(), soup.triangles.end(),
                     [&](const auto& s, const auto& t) { return column(s) < column(t); });
  }
  return soup;
}

// The vertices by their coordinates, as in a file that has been sorted to find equal ones.
inline Triangle_soup with_sorted_vertices(Triangle_soup soup)
{
  std::vector<std::size_t> old_numbers(soup.points.size());
  std::iota(old_numbers.begin(), old_numbers.end(), std::size_t(0));
  const auto reversed = [&](std::size_t v) {
    const auto& p = soup.points[v];
    return std::array<double, 3>{p[2], p[1], p[0]};
  };
  std::sort(old_numbers.begin(), old_numbers.end(),
            [&](std::size_t u, std::size_t v) { return reversed(u) < reversed(v); });
  std::vector<std::size_t> new_numbers(soup.points.size());
  for(std::size_t i = 0; i < old_numbers.size(); ++i)
    new_numbers[old_numbers[i]] = i;
  generated_surfaces::renumber(soup, new_numbers);
  return soup;
}

// A coarse surface of which each triangle has been divided into four, again and again: new vertices come behind all
// earlier ones.
inline Triangle_soup subdivided_surface(std::size_t number_of_vertices)
{
  Triangle_soup soup = generated_surfaces::closed_surface(3, (std::max)(number_of_vertices / 256, std::size_t(500)));
  while(2 * soup.points.size() < number_of_vertices)
  {
    std::map<std::pair<std::size_t, std::size_t>, std::size_t> middles;
    const auto middle = [&](std::size_t u, std::size_t v) {
      const auto [place, is_new] = middles.emplace(std::minmax(u, v), soup.points.size());
      if(is_new)
      {
        const auto p = soup.points[u], q = soup.points[v];
        soup.points.push_back({(p[0] + q[0]) / 2, (p[1] + q[1]) / 2, (p[2] + q[2]) / 2});
      }
      return place->second;
    };
    std::vector<std::array<std::size_t, 3>> triangles;
    for(const auto& [a, b, c] : soup.triangles)
    {
      const std::size_t ab = middle(a, b), bc = middle(b, c), ca = middle(c, a);
      triangles.insert(triangles.end(), {{a, ab, ca}, {ab, b, bc}, {ca, bc, c}, {ab, bc, ca}});
    }
    soup.triangles = std::move(triangles);
  }
  return soup;
}

// Collapses random edges until a fourth of the vertices is gone, and takes the rest together.
template <class Mesh>
void decimate(Mesh& mesh)
{
  std::mt19937 random(1);
  const std::size_t target = mesh.number_of_vertices() / 4 * 3;
  for(std::size_t attempt = mesh.number_of_vertices(); mesh.number_of_vertices() > target && attempt != 0; --attempt)
  {
    const typename Mesh::Edge_index e(random() % static_cast<std::uint32_t>(mesh.num_edges()));
    if(!mesh.is_removed(e) && CGAL::Euler::does_satisfy_link_condition(e, mesh))
      CGAL::Euler::collapse_edge(e, mesh);
  }
  mesh.collect_garbage();
}

// Divides long edges and collapses short ones, as a remeshing does, and takes the rest together.
template <class Mesh>
void remesh(Mesh& mesh)
{
  const auto squared_length = [&](typename Mesh::Edge_index e) {
    return squared_distance(mesh.point(mesh.vertex(e, 0)), mesh.point(mesh.vertex(e, 1)));
  };
  double mean = 0;
  for(const auto e : mesh.edges())
    mean += squared_length(e) / static_cast<double>(mesh.number_of_edges());
  const std::vector<typename Mesh::Edge_index> old_edges(mesh.edges().begin(), mesh.edges().end());
  for(const auto e : old_edges)
    if(squared_length(e) > 1.3 * mean)
    {
      const auto middle = midpoint(mesh.point(mesh.vertex(e, 0)), mesh.point(mesh.vertex(e, 1)));
      const auto left = CGAL::Euler::split_edge(mesh.halfedge(e), mesh), right = mesh.opposite(left);
      mesh.point(mesh.target(left)) = middle;
      CGAL::Euler::split_face(left, mesh.next(mesh.next(left)), mesh);
      CGAL::Euler::split_face(mesh.prev(right), mesh.next(right), mesh);
    }
  for(const auto e : old_edges)
    if(!mesh.is_removed(e) && squared_length(e) < 0.7 * mean && CGAL::Euler::does_satisfy_link_condition(e, mesh))
      CGAL::Euler::collapse_edge(e, mesh);
  mesh.collect_garbage();
}

} // namespace benchmark

#endif // CGAL_REEB_GRAPH_BENCHMARK_MESHES_AS_THEY_COME_H
