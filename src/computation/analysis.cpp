// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#include "computation/analysis.h"

#include "computation/Report_visitor.h"
#include "input/repair_soup.h"

#include <CGAL/Polygon_mesh_processing/border.h>
#include <CGAL/Reeb_graph/graph_topology.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <string>
#include <utility>
#include <vector>

namespace reeb_graph_program {
namespace {
typedef std::array<std::uint32_t, 2> Edge;
typedef std::array<std::uint32_t, 3> Triangle;
typedef std::array<std::uint32_t, 4> Tetrahedron;

// Each simplex once, with ascending vertices, in ascending order.
template <class Simplex>
void normalize(std::vector<Simplex>& simplices)
{
  for(Simplex& simplex : simplices)
    std::sort(simplex.begin(), simplex.end());
  std::sort(simplices.begin(), simplices.end());
  simplices.erase(std::unique(simplices.begin(), simplices.end()), simplices.end());
}

// Appends the faces of one dimension less.
template <class Simplex, class Face>
void append_faces(const std::vector<Simplex>& simplices, std::vector<Face>& faces)
{
  for(const Simplex& simplex : simplices)
    for(std::size_t left_out = 0; left_out < simplex.size(); ++left_out)
    {
      Face face;
      std::remove_copy(simplex.begin(), simplex.end(), face.begin(), simplex[left_out]);
      faces.push_back(face);
    }
}

// The simplices that are no faces of larger ones.
template <class Simplex, class Face>
void remove_faces(const std::vector<Simplex>& simplices, std::vector<Face>& faces)
{
  std::vector<Face> faces_of_simplices, rest;
  append_faces(simplices, faces_of_simplices);
  normalize(faces_of_simplices);
  normalize(faces);
  std::set_difference(faces.begin(), faces.end(), faces_of_simplices.begin(), faces_of_simplices.end(),
                      std::back_inserter(rest));
  faces = std::move(rest);
}

// Says what is wrong with triangles, whose vertices ascend.
void count_faults(const Polygons& triangles, const std::vector<Polygon_side>& sides, Complex_counts& counts)
{
  Union_find_of_indices orientations(2 * triangles.size());
  std::size_t number_of_vertices = 0;
  for_each_edge(sides, [&](std::size_t begin, std::size_t end) {
    const Polygon_side &one = sides[begin], &other = sides[end - 1];
    number_of_vertices = std::max<std::size_t>(number_of_vertices, one.v + std::size_t(1));
    if(end - begin > 2 && counts.edges_of_many_faces++ == 0)
      counts.first_edge_of_many_faces = {one.u, one.v, end - begin};
    if(end - begin != 2 || counts.first_edge_without_orientation)
      return;
    const std::size_t turn = one.is_descending == other.is_descending ? 1 : 0;
    for(const std::size_t orientation : {0, 1})
      orientations.unite(2 * one.face + orientation, 2 * other.face + (orientation ^ turn));
    if(orientations.find(2 * one.face) == orientations.find(2 * one.face + 1))
      counts.first_edge_without_orientation = {one.u, one.v};
  });
  const std::vector<std::size_t> fans = count_fans(triangles, sides, number_of_vertices);
  for(std::size_t v = 0; v < number_of_vertices; ++v)
    if(fans[v] > 1 && counts.vertices_of_several_fans++ == 0)
      counts.first_vertex_of_several_fans = {v, fans[v]};
}

} // namespace

Complex_counts count_complex(const Complex& complex)
{
  std::vector<Tetrahedron> tetrahedra = complex.tetrahedra;
  normalize(tetrahedra);
  std::vector<Triangle> triangles = complex.triangles;
  append_faces(tetrahedra, triangles);
  normalize(triangles);
  Polygons polygons;
  for(const Triangle& triangle : triangles)
    polygons.add(triangle);
  const std::vector<Polygon_side> sides = sides_of(polygons);
  std::vector<Edge> edges = complex.edges;
  const std::size_t number_before = edges.size();
  for_each_edge(sides, [&](std::size_t begin, std::size_t) { edges.push_back({sides[begin].u, sides[begin].v}); });
  const std::size_t number_of_sides = edges.size() - number_before;
  normalize(edges);
  Complex_counts counts;
  counts.edges = edges.size();
  counts.edges_without_triangles = edges.size() - number_of_sides;
  if(counts.edges_without_triangles > 0)
  {
    const Edge first = *std::min_element(complex.edges.begin(), complex.edges.end());
    counts.first_edge_without_triangles = {first[0], first[1]};
  }
  counts.duplicate_faces = complex.duplicate_faces;
  counts.first_duplicate_face = complex.first_duplicate_face;
  counts.triangles = triangles.size();
  counts.tetrahedra = tetrahedra.size();
  if(tetrahedra.empty())
    count_faults(polygons, sides, counts);
  return counts;
}

std::string describe_obstacle(const Complex& complex)
{
  if(!complex.tetrahedra.empty())
    return "the mesh has tetrahedra; reeb_graph repair takes their border";
  if(complex.triangles.empty())
    return "the mesh has lines and no faces";
  const Complex_counts counts = count_complex(complex);
  const auto number = [](std::size_t n, const std::string& singular, const std::string& plural) {
    return std::to_string(n) + (n == 1 ? singular : plural);
  };
  const auto ends = [](std::size_t u, std::size_t v) {
    return "the vertices " + std::to_string(u) + " and " + std::to_string(v);
  };
  if(counts.first_duplicate_face)
    return number(counts.duplicate_faces, " face repeats an earlier one", " faces repeat earlier ones")
         + ", the first one, face " + std::to_string(*counts.first_duplicate_face);
  if(const auto& edge = counts.first_edge_without_triangles)
    return number(counts.edges_without_triangles, " edge is on no face", " edges are on no face")
         + ", the first one, of " + ends(edge->first, edge->second);
  if(const auto& edge = counts.first_edge_of_many_faces)
    return "the edge between " + ends(edge->u, edge->v) + " has " + std::to_string(edge->faces) + " faces";
  if(const auto& vertex = counts.first_vertex_of_several_fans)
    return "the faces at vertex " + std::to_string(vertex->vertex) + " form " + std::to_string(vertex->fans) + " fans";
  if(const auto& edge = counts.first_edge_without_orientation)
    return "the faces cannot be oriented, which shows at the edge of " + ends(edge->first, edge->second);
  return "the faces and edges form no manifold surface";
}

void remove_faces_of_cells(Complex& complex)
{
  if(!complex.tetrahedra.empty())
    remove_faces(complex.tetrahedra, complex.triangles);
  if(complex.edges.empty())
    return;
  std::vector<Triangle> triangles = complex.triangles;
  append_faces(complex.tetrahedra, triangles);
  remove_faces(triangles, complex.edges);
}

namespace {
namespace PMP = CGAL::Polygon_mesh_processing;
Mesh_counts count_surface(const Surface& surface, const Graph& graph)
{
  Mesh_counts counts;
  counts.vertices = surface.number_of_vertices();
  counts.edges = surface.number_of_edges();
  counts.faces = surface.number_of_faces();
  counts.components = CGAL::Reeb_graph::number_of_components(graph); // as many as the surface has
  counts.border_loops = PMP::number_of_borders(surface);
  return counts;
}

} // namespace

void count_graph_of_surface(const Graph& graph, Report& report)
{
  report.graph = count_graph(graph, report.surface.components);
  if(const auto genus = report.surface.genus(); genus && report.surface.border_loops == 0)
    report.graph.hidden_handles = *genus - static_cast<long>(report.graph.loops);
}

void count_all(const Surface& surface, const Graph& graph, Report& report)
{
  report.surface = count_surface(surface, graph);
  count_graph_of_surface(graph, report);
}

void count_all(const Mesh& mesh, const Graph& graph, Report& report)
{
  if(!mesh.complex)
    return count_all(mesh.surface, graph, report);
  report.complex = count_complex(*mesh.complex);
  report.complex->vertices = mesh.surface.number_of_vertices();
  report.complex->components = CGAL::Reeb_graph::number_of_components(graph); // as many as the complex has
  report.graph = count_graph(graph, report.complex->components);
}

void count_simplified(const Graph& simplified, double threshold, Report& report)
{
  const std::size_t number_of_components = report.complex ? report.complex->components : report.surface.components;
  report.simplification = Simplification_counts{threshold, count_graph(simplified, number_of_components), {}};
}

} // namespace reeb_graph_program
