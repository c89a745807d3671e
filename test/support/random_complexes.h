// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_TEST_RANDOM_COMPLEXES_H
#define CGAL_REEB_GRAPH_TEST_RANDOM_COMPLEXES_H

#include "random_fields.h"
#include "random_meshes.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <set>
#include <type_traits>
#include <utility>
#include <vector>

// Small complexes without geometry, which are no oriented manifold surfaces, the same for a seed on every platform.
namespace random_complexes {
using random_meshes::Combinatorial_mesh;
using random_meshes::Random;
using random_meshes::Vertex_triple;

typedef std::pair<std::size_t, std::size_t> Vertex_pair;
typedef std::array<std::size_t, 4> Vertex_quadruple;

// Either triangles and edges, or tetrahedra. A simplex may be listed more than once.
struct Complex
{
  std::size_t number_of_vertices = 0;
  std::vector<Vertex_triple> triangles = {};
  std::vector<Vertex_pair> edges = {};
  std::vector<Vertex_quadruple> tetrahedra = {};

  // all that are listed, as lists of vertices
  std::vector<std::vector<std::size_t>> simplices() const
  {
    std::vector<std::vector<std::size_t>> result;
    for(const Vertex_pair& edge : edges)
      result.push_back({edge.first, edge.second});
    for(const Vertex_triple& triangle : triangles)
      result.emplace_back(triangle.begin(), triangle.end());
    for(const Vertex_quadruple& tetrahedron : tetrahedra)
      result.emplace_back(tetrahedron.begin(), tetrahedron.end());
    return result;
  }
};

// the same complex, or the 2-skeleton of the tetrahedra
inline Complex skeleton(const Complex& complex)
{
  Complex result = {complex.number_of_vertices, complex.triangles, complex.edges, {}};
  for(const Vertex_quadruple& t : complex.tetrahedra)
    for(std::size_t i = 0; i < 4; ++i)
      result.triangles.push_back({t[(i + 1) % 4], t[(i + 2) % 4], t[(i + 3) % 4]});
  return result;
}

inline Complex complex_of(const Combinatorial_mesh& mesh) { return {mesh.number_of_vertices, mesh.triangles, {}, {}}; }

// a strip of `length` >= 5 triangles, whose ends are joined: a Möbius strip if the length is odd, else an annulus
inline Complex triangle_strip(std::size_t length)
{
  Complex complex = {length};
  for(std::size_t i = 0; i < length; ++i)
    complex.triangles.push_back({i, (i + 1) % length, (i + 2) % length});
  return complex;
}

// a grid of columns >= 4 and rows >= 3, joined to a torus, or with a flip to a Klein bottle
inline Complex closed_grid(std::size_t columns, std::size_t rows, bool is_flipped)
{
  const auto vertex = [&](std::size_t column, std::size_t row) {
    const bool is_seam = column == columns;
    return (column % columns) * rows + (is_seam && is_flipped ? (rows - row % rows) % rows : row % rows);
  };
  Complex complex = {columns * rows};
  for(std::size_t i = 0; i < columns; ++i)
    for(std::size_t j = 0; j < rows; ++j)
    {
      complex.triangles.push_back({vertex(i, j), vertex(i + 1, j), vertex(i + 1, j + 1)});
      complex.triangles.push_back({vertex(i, j), vertex(i + 1, j + 1), vertex(i, j + 1)});
    }
  return complex;
}

inline Complex projective_plane()
{
  return {
    6, {{0, 1, 2}, {0, 2, 3}, {0, 3, 4}, {0, 4, 5}, {0, 5, 1}, {1, 2, 4}, {2, 3, 5}, {3, 4, 1}, {4, 5, 2}, {5, 1, 3}}};
}

// a sphere of five vertices with a wall inside, at whose edges there are three triangles
inline Complex sphere_with_wall()
{
  return {5, {{0, 1, 2}, {0, 1, 3}, {4, 1, 2}, {4, 1, 3}, {0, 2, 3}, {4, 2, 3}, {1, 2, 3}}};
}

// `pages` disks, all of which have one path of `spine` >= 2 vertices in common
inline Complex book(std::size_t pages, std::size_t spine)
{
  Complex complex = {spine + pages};
  for(std::size_t page = 0; page < pages; ++page)
    for(std::size_t i = 0; i + 1 < spine; ++i)
      complex.triangles.push_back({i, i + 1, spine + page});
  return complex;
}

// replaces vertex v by u, and takes out the triangles and edges that lose a vertex so; v becomes isolated
inline void identify(Complex& complex, std::size_t u, std::size_t v)
{
  const auto replace = [&](auto& simplices) {
    typedef typename std::decay_t<decltype(simplices)>::value_type Simplex;
    for(Simplex& simplex : simplices)
      std::replace(simplex.begin(), simplex.end(), v, u);
    simplices.erase(std::remove_if(simplices.begin(), simplices.end(),
                                   [](const Simplex& simplex) {
                                     return std::set<std::size_t>(simplex.begin(), simplex.end()).size()
                                          < simplex.size();
                                   }),
                    simplices.end());
  };
  replace(complex.triangles);
  replace(complex.tetrahedra);
}

// a torus with a circle pinched to a point: the poles of a sphere are one vertex
inline Complex pinched_torus(std::size_t around, std::size_t along)
{
  Complex complex = complex_of(random_meshes::cylinder(around, along));
  const std::size_t apex = complex.number_of_vertices++;
  for(std::size_t i = 0; i < around; ++i)
    for(const std::size_t ring : {std::size_t(0), along - 1})
      complex.triangles.push_back({ring * around + i, ring * around + (i + 1) % around, apex});
  return complex;
}

inline Vertex_pair random_edge(std::size_t number_of_vertices, Random& random)
{
  const std::size_t u = random.below(number_of_vertices), v = random.below(number_of_vertices - 1);
  return {u, v < u ? v : v + 1};
}

template <class Simplex>
Simplex random_simplex(std::size_t number_of_vertices, Random& random)
{
  std::vector<std::size_t> vertices(number_of_vertices);
  for(std::size_t v = 0; v < number_of_vertices; ++v)
    vertices[v] = v;
  random.shuffle(vertices);
  Simplex simplex = {};
  std::copy_n(vertices.begin(), simplex.size(), simplex.begin());
  return simplex;
}

// the cone over a random graph, or the two cones of its suspension
inline Complex random_cone(Random& random)
{
  const std::size_t n = 3 + random.below(7), apices = 1 + random.below(2);
  Complex complex = {n + apices};
  for(std::size_t i = 0; i < n + random.below(2 * n); ++i)
  {
    const Vertex_pair edge = random_edge(n, random);
    for(std::size_t apex = 0; apex < apices; ++apex)
      complex.triangles.push_back({edge.first, n + apex, edge.second});
  }
  for(std::size_t v = 0; v < n; ++v)
    complex.edges.push_back({v, n});
  return complex;
}

// tetrahedra of a grid of cubes, six around a diagonal each, some of which are taken out
inline Complex random_solid(Random& random)
{
  const std::size_t sizes[3] = {2, 2, 2 + random.below(2)};
  Complex complex = {sizes[0] * sizes[1] * sizes[2]};
  std::array<std::size_t, 3> axes = {0, 1, 2};
  for(std::size_t layer = 0; layer + 1 < sizes[2]; ++layer)
  {
    std::sort(axes.begin(), axes.end());
    do
    {
      const std::size_t steps[3] = {1, 2, 4};
      std::size_t v = 4 * layer;
      Vertex_quadruple tetrahedron = {v, 0, 0, 0};
      for(std::size_t i = 0; i < 3; ++i)
        tetrahedron[i + 1] = v += steps[axes[i]];
      if(random.below(4) != 0)
        complex.tetrahedra.push_back(tetrahedron);
    } while(std::next_permutation(axes.begin(), axes.end()));
  }
  return complex;
}

// a surface of which vertices are identified: pinched ones, edges with three or four triangles, walls
inline Complex random_glued_surface(Random& random)
{
  const std::size_t number_of_splits = 3 + random.below(3);
  Combinatorial_mesh mesh =
    random_meshes::random_closed_surface(static_cast<unsigned>(random.below(3)), number_of_splits, random);
  if(random.below(2) == 0)
    random_meshes::remove_random_triangles(mesh, 1 + random.below(mesh.triangles.size() / 2), random);
  Complex complex = complex_of(mesh);
  for(std::size_t i = 1 + random.below(3); i > 0; --i)
  {
    const Vertex_pair pair = random_edge(complex.number_of_vertices, random);
    identify(complex, pair.first, pair.second);
  }
  return complex;
}

enum class Complex_class
{
  RANDOM_TRIANGLES,
  RANDOM_EDGES, // and a few triangles
  RANDOM_TETRAHEDRA,
  SOLID,
  PINCHED,        // tori, and surfaces with identified vertices
  NOT_ORIENTABLE, // Möbius strips, Klein bottles, projective planes
  BOOK,
  CONE,
  WALLED,
  TINY, // no vertex, isolated vertices, one edge, one triangle, one tetrahedron, the same twice
  NUMBER_OF_CLASSES
};

inline Complex random_tiny_complex(Random& random)
{
  const std::array<Complex, 8> complexes = {Complex(),
                                            Complex{1 + random.below(3)},
                                            Complex{3, {}, {{2, 0}}, {}},
                                            Complex{4, {{2, 0, 1}}, {{0, 1}, {3, 1}}, {}},
                                            Complex{4, {{2, 0, 1}, {1, 0, 2}, {2, 0, 1}}, {{1, 2}, {2, 1}}, {}},
                                            Complex{4, {}, {}, {{3, 1, 0, 2}}},
                                            Complex{5, {}, {}, {{3, 1, 0, 2}, {0, 1, 2, 3}, {4, 1, 2, 3}}},
                                            Complex{4, {}, {{0, 1}, {1, 2}, {2, 3}, {3, 0}}, {}}};
  return complexes[random.below(complexes.size())];
}

// random triangles, edges and tetrahedra on 4 to 12 vertices
inline Complex random_simplices(Complex_class complex_class, Random& random)
{
  const std::size_t n = 4 + random.below(9);
  Complex complex = {n};
  if(complex_class == Complex_class::RANDOM_TETRAHEDRA)
    for(std::size_t i = 1 + random.below(n); i > 0; --i)
      complex.tetrahedra.push_back(random_simplex<Vertex_quadruple>(n, random));
  else
  {
    const bool has_few_triangles = complex_class == Complex_class::RANDOM_EDGES;
    for(std::size_t i = has_few_triangles ? random.below(4) : 1 + random.below(3 * n); i > 0; --i)
      complex.triangles.push_back(random_simplex<Vertex_triple>(n, random));
    for(std::size_t i = has_few_triangles ? random.below(3 * n) : random.below(3); i > 0; --i)
      complex.edges.push_back(random_edge(n, random));
  }
  return complex;
}

// the identity up to names: other numbers of vertices, other orders of simplices and within them
inline void relabel(Complex& complex, Random& random)
{
  std::vector<std::size_t> new_names(complex.number_of_vertices);
  for(std::size_t v = 0; v < new_names.size(); ++v)
    new_names[v] = v;
  random.shuffle(new_names);
  const auto relabel_all = [&](auto& simplices) {
    for(auto& simplex : simplices)
    {
      for(std::size_t& v : simplex)
        v = new_names[v];
      for(std::size_t i = simplex.size(); i > 1; --i)
        std::swap(simplex[i - 1], simplex[random.below(i)]);
    }
    random.shuffle(simplices);
  };
  relabel_all(complex.triangles);
  relabel_all(complex.tetrahedra);
  for(Vertex_pair& edge : complex.edges)
    edge = {new_names[edge.first], new_names[edge.second]};
}

inline Complex random_surface_without_orientation(Random& random)
{
  switch(random.below(3))
  {
  case 0: return triangle_strip(5 + 2 * random.below(4));
  case 1: return closed_grid(4, 3, true);
  default: return projective_plane();
  }
}

// A complex of at most about 14 vertices, some of which are isolated; a simplex of it may be listed twice.
inline Complex random_complex(Complex_class complex_class, Random& random)
{
  Complex complex;
  std::size_t size = 0;
  switch(complex_class)
  {
  case Complex_class::SOLID: complex = random_solid(random); break;
  case Complex_class::PINCHED:
    complex = random.below(2) == 0 ? pinched_torus(3 + random.below(2), 3) : random_glued_surface(random);
    break;
  case Complex_class::NOT_ORIENTABLE: complex = random_surface_without_orientation(random); break;
  case Complex_class::BOOK:
    size = 2 + random.below(5);
    complex = book(1 + random.below(6), size);
    break;
  case Complex_class::CONE: complex = random_cone(random); break;
  case Complex_class::WALLED:
    complex = sphere_with_wall();
    for(std::size_t i = random.below(6); i > 0; --i)
    {
      const Vertex_triple t = complex.triangles[random.below(complex.triangles.size())];
      complex.triangles.push_back({t[0], t[1], complex.number_of_vertices++});
    }
    break;
  case Complex_class::TINY: return random_tiny_complex(random);
  default: complex = random_simplices(complex_class, random);
  }
  if(random.below(4) == 0)
    ++complex.number_of_vertices;
  if(!complex.triangles.empty() && random.below(4) == 0)
    complex.triangles.push_back(complex.triangles[random.below(complex.triangles.size())]);
  relabel(complex, random);
  return complex;
}

// Values of all the kinds that tell something about ties.
inline std::vector<double> random_values(std::size_t number_of_vertices, Random& random)
{
  switch(random.below(8))
  {
  case 0: return random_meshes::random_integers(number_of_vertices, 2, random);
  case 1: return random_meshes::random_integers(number_of_vertices, 3, random);
  case 2: return random_meshes::random_integers(number_of_vertices, number_of_vertices + 1, random);
  case 3: return std::vector<double>(number_of_vertices, 7);
  default: return random_meshes::random_permutation(number_of_vertices, random);
  }
}

} // namespace random_complexes

#endif // CGAL_REEB_GRAPH_TEST_RANDOM_COMPLEXES_H
