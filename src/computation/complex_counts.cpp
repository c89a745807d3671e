// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#include "computation/complex_counts.h"

#include <boost/pending/disjoint_sets.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <map>
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

// An edge of a triangle, and which of its vertices is opposite to it.
struct Side
{
  Edge edge;
  std::size_t triangle;
  std::size_t opposite;
};

// The sides of all triangles, those of an edge one behind the other.
std::vector<Side> sorted_sides(const std::vector<Triangle>& triangles)
{
  std::vector<Side> sides;
  sides.reserve(3 * triangles.size());
  for(std::size_t i = 0; i < triangles.size(); ++i)
    for(std::size_t j = 0; j < 3; ++j)
    {
      const std::uint32_t u = triangles[i][(j + 1) % 3], v = triangles[i][(j + 2) % 3];
      sides.push_back({{std::min(u, v), std::max(u, v)}, i, j});
    }
  std::sort(sides.begin(), sides.end(),
            [](const Side& a, const Side& b) { return a.edge != b.edge ? a.edge < b.edge : a.triangle < b.triangle; });
  return sides;
}

// Calls visit(begin, end) for the sides of each edge, in the order of the edges.
template <class Visit>
void for_each_edge(const std::vector<Side>& sides, const Visit& visit)
{
  for(auto begin = sides.begin(); begin != sides.end();)
  {
    const auto end = std::find_if(begin, sides.end(), [&](const Side& side) { return side.edge != begin->edge; });
    visit(begin, end);
    begin = end;
  }
}

// The triangles at a vertex that are joined by edges at it are one fan, whatever else meets at these edges.
void count_fans(const std::vector<Triangle>& triangles, const std::vector<Side>& sides, Complex_counts& counts)
{
  boost::disjoint_sets_with_storage<> corners(3 * triangles.size());
  const auto corner_of = [&](std::size_t triangle, std::uint32_t v) {
    return 3 * triangle
         + static_cast<std::size_t>(std::find(triangles[triangle].begin(), triangles[triangle].end(), v)
                                    - triangles[triangle].begin());
  };
  for_each_edge(sides, [&](auto begin, auto end) {
    for(auto side = begin + 1; side != end; ++side)
      for(const std::uint32_t v : begin->edge)
        corners.union_set(corner_of(begin->triangle, v), corner_of(side->triangle, v));
  });
  std::map<std::uint32_t, std::size_t> vertices; // those of several fans
  std::vector<std::size_t> fans;
  for(std::size_t corner = 0; corner < 3 * triangles.size(); ++corner)
    if(corners.find_set(corner) == corner)
    {
      const std::uint32_t v = triangles[corner / 3][corner % 3];
      fans.resize(std::max<std::size_t>(fans.size(), v + std::size_t(1)));
      if(++fans[v] > 1)
        vertices[v] = fans[v];
    }
  counts.vertices_of_several_fans = vertices.size();
  if(!vertices.empty())
    counts.first_vertex_of_several_fans = {vertices.begin()->first, vertices.begin()->second};
}

// Triangles have two orientations each; those on both sides of an edge of two triangles agree. The first edge is found
// at which this asks for both orientations of a triangle.
void find_contradiction(const std::vector<Triangle>& triangles, const std::vector<Side>& sides, Complex_counts& counts)
{
  boost::disjoint_sets_with_storage<> orientations(2 * triangles.size());
  for_each_edge(sides, [&](auto begin, auto end) {
    if(end - begin != 2 || counts.first_edge_without_orientation)
      return;
    // vertices of triangles ascend, so that only the side that leaves out the middle one runs backwards
    const auto is_backwards = [](const Side& side) { return side.opposite == 1; };
    const std::size_t turn = is_backwards(begin[0]) == is_backwards(begin[1]) ? 1 : 0;
    for(const std::size_t orientation : {0, 1})
      orientations.union_set(2 * begin[0].triangle + orientation, 2 * begin[1].triangle + (orientation ^ turn));
    if(orientations.find_set(2 * begin[0].triangle) == orientations.find_set(2 * begin[0].triangle + 1))
      counts.first_edge_without_orientation = {begin->edge[0], begin->edge[1]};
  });
}

void count_faults(const std::vector<Triangle>& triangles, const std::vector<Side>& sides, Complex_counts& counts)
{
  for_each_edge(sides, [&](auto begin, auto end) {
    if(end - begin > 2 && counts.edges_of_many_faces++ == 0)
      counts.first_edge_of_many_faces = {begin->edge[0], begin->edge[1], static_cast<std::size_t>(end - begin)};
  });
  count_fans(triangles, sides, counts);
  find_contradiction(triangles, sides, counts);
}

} // namespace

Complex_counts count_complex(const Complex& complex)
{
  std::vector<Tetrahedron> tetrahedra = complex.tetrahedra;
  normalize(tetrahedra);
  std::vector<Triangle> triangles = complex.triangles;
  append_faces(tetrahedra, triangles);
  normalize(triangles);
  const std::vector<Side> sides = sorted_sides(triangles);
  std::vector<Edge> edges = complex.edges;
  const std::size_t number_before = edges.size();
  for_each_edge(sides, [&](auto begin, auto) { edges.push_back(begin->edge); });
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
    count_faults(triangles, sides, counts);
  return counts;
}

std::string describe_obstacle(const Complex& complex)
{
  if(!complex.tetrahedra.empty())
    return "the mesh has tetrahedra";
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
         + ", the first one, of " + ends(edge->first, edge->second)
         + "; without such edges, the file has a surface only";
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

} // namespace reeb_graph_program
