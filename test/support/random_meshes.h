// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_SRC_GENERATED_SURFACES_RANDOM_MESHES_H
#define CGAL_REEB_GRAPH_SRC_GENERATED_SURFACES_RANDOM_MESHES_H

#include <algorithm>
#include <array>
#include <cstddef>
#include <map>
#include <random>
#include <utility>
#include <vector>

// Small oriented simplicial surfaces without geometry, the same for a seed on every platform.
namespace random_meshes {
typedef std::array<std::size_t, 3> Vertex_triple;

struct Combinatorial_mesh
{
  std::size_t number_of_vertices = 0;
  std::vector<Vertex_triple> triangles;
};

// The engines of the standard library are the same everywhere, its distributions are not.
class Random
{
public:
  explicit Random(std::size_t seed) : engine_(static_cast<std::mt19937::result_type>(seed * 2654435761u + 1)) {}

  std::size_t below(std::size_t bound) { return engine_() % bound; }

  template <class T>
  void shuffle(std::vector<T>& values)
  {
    for(std::size_t i = values.size(); i > 1; --i)
      std::swap(values[i - 1], values[below(i)]);
  }

private:
  std::mt19937 engine_;
};

inline Combinatorial_mesh tetrahedron() { return {4, {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}}}; }

// the smallest simplicial torus: each of its 7 vertices is joined to all the other ones
inline Combinatorial_mesh seven_vertex_torus()
{
  Combinatorial_mesh mesh = {7, {}};
  for(std::size_t i = 0; i < 7; ++i)
  {
    mesh.triangles.push_back({i, (i + 1) % 7, (i + 3) % 7});
    mesh.triangles.push_back({i, (i + 3) % 7, (i + 2) % 7});
  }
  return mesh;
}

// a sphere with two poles, 0 and 1, of degree `degree` >= 3
inline Combinatorial_mesh bipyramid(std::size_t degree)
{
  Combinatorial_mesh mesh = {2 + degree, {}};
  for(std::size_t i = 0; i < degree; ++i)
  {
    const std::size_t u = 2 + i, v = 2 + (i + 1) % degree;
    mesh.triangles.push_back({0, u, v});
    mesh.triangles.push_back({1, v, u});
  }
  return mesh;
}

// a disk around vertex 0 of degree `degree` >= 3
inline Combinatorial_mesh disk(std::size_t degree)
{
  Combinatorial_mesh mesh = {1 + degree, {}};
  for(std::size_t i = 0; i < degree; ++i)
    mesh.triangles.push_back({0, 1 + i, 1 + (i + 1) % degree});
  return mesh;
}

// half a disk around vertex 0, which is on the border, of degree `degree` >= 2
inline Combinatorial_mesh half_disk(std::size_t degree)
{
  Combinatorial_mesh mesh = {1 + degree, {}};
  for(std::size_t i = 1; i < degree; ++i)
    mesh.triangles.push_back({0, i, i + 1});
  return mesh;
}

// a cylinder of `along` rings of `around` >= 3 vertices each; vertex v is on ring v / around
inline Combinatorial_mesh cylinder(std::size_t around, std::size_t along)
{
  Combinatorial_mesh mesh = {around * along, {}};
  for(std::size_t ring = 0; ring + 1 < along; ++ring)
    for(std::size_t i = 0; i < around; ++i)
    {
      const std::size_t a = ring * around + i, b = ring * around + (i + 1) % around;
      mesh.triangles.push_back({a, b, b + around});
      mesh.triangles.push_back({a, b + around, a + around});
    }
  return mesh;
}

inline Combinatorial_mesh disjoint_union(Combinatorial_mesh mesh, const Combinatorial_mesh& other)
{
  const std::size_t shift = mesh.number_of_vertices;
  for(const Vertex_triple& t : other.triangles)
    mesh.triangles.push_back({t[0] + shift, t[1] + shift, t[2] + shift});
  mesh.number_of_vertices += other.number_of_vertices;
  return mesh;
}

// removes a triangle from both meshes and glues the two holes
inline Combinatorial_mesh connected_sum(const Combinatorial_mesh& mesh, const Combinatorial_mesh& other, Random& random)
{
  const std::size_t hole = random.below(mesh.triangles.size());
  const std::size_t other_hole = mesh.triangles.size() + random.below(other.triangles.size());
  Combinatorial_mesh sum = disjoint_union(mesh, other);
  const Vertex_triple t = sum.triangles[hole], u = sum.triangles[other_hole];
  sum.triangles.erase(sum.triangles.begin() + other_hole);
  sum.triangles.erase(sum.triangles.begin() + hole);

  std::vector<std::size_t> new_names(sum.number_of_vertices);
  const std::size_t turn = random.below(3);
  std::size_t next_name = 0;
  for(std::size_t v = 0; v < sum.number_of_vertices; ++v)
    if(std::find(u.begin(), u.end(), v) == u.end())
      new_names[v] = next_name++;
  for(std::size_t i = 0; i < 3; ++i)
    new_names[u[i]] = new_names[t[(turn + 3 - i) % 3]];
  for(Vertex_triple& triangle : sum.triangles)
    for(std::size_t& v : triangle)
      v = new_names[v];
  sum.number_of_vertices = next_name;
  return sum;
}

inline void split_random_triangle(Combinatorial_mesh& mesh, Random& random)
{
  const std::size_t chosen = random.below(mesh.triangles.size()), v = mesh.number_of_vertices++;
  const Vertex_triple t = mesh.triangles[chosen];
  mesh.triangles[chosen] = {t[0], t[1], v};
  mesh.triangles.push_back({t[1], t[2], v});
  mesh.triangles.push_back({t[2], t[0], v});
}

// The number of the triangle that has a directed edge, and the vertex opposite to it, by directed edge.
typedef std::map<std::pair<std::size_t, std::size_t>, std::pair<std::size_t, std::size_t>> Directed_edges;

inline Directed_edges directed_edges(const Combinatorial_mesh& mesh)
{
  Directed_edges edges;
  for(std::size_t i = 0; i < mesh.triangles.size(); ++i)
    for(int j = 0; j < 3; ++j)
    {
      const Vertex_triple& t = mesh.triangles[i];
      edges[{t[j], t[(j + 1) % 3]}] = {i, t[(j + 2) % 3]};
    }
  return edges;
}

// flips random edges as often as tried, where the mesh stays simplicial
inline void flip_random_edges(Combinatorial_mesh& mesh, std::size_t number_of_trials, Random& random)
{
  Directed_edges edges = directed_edges(mesh);
  const auto replace = [&](std::size_t i, const Vertex_triple& t) {
    mesh.triangles[i] = t;
    for(int j = 0; j < 3; ++j)
      edges[{t[j], t[(j + 1) % 3]}] = {i, t[(j + 2) % 3]};
  };
  for(; number_of_trials > 0; --number_of_trials)
  {
    const Vertex_triple& t = mesh.triangles[random.below(mesh.triangles.size())];
    const std::size_t corner = random.below(3), u = t[corner], v = t[(corner + 1) % 3];
    const auto left = edges.find({u, v}), right = edges.find({v, u});
    if(right == edges.end())
      continue;
    const std::size_t left_triangle = left->second.first, right_triangle = right->second.first;
    const std::size_t x = left->second.second, y = right->second.second;
    if(x == y || edges.count({x, y}) != 0 || edges.count({y, x}) != 0)
      continue;
    edges.erase(left);
    edges.erase(right);
    replace(left_triangle, {x, u, y});
    replace(right_triangle, {y, v, x});
  }
}

// the number of components of the link of a vertex: 1 if it is manifold, 0 if it is isolated
inline std::size_t number_of_fans(const Combinatorial_mesh& mesh, std::size_t v)
{
  std::map<std::size_t, std::size_t> next, previous; // in the link, counterclockwise
  for(const Vertex_triple& t : mesh.triangles)
    for(int i = 0; i < 3; ++i)
      if(t[i] == v)
      {
        next[t[(i + 1) % 3]] = t[(i + 2) % 3];
        previous[t[(i + 2) % 3]] = t[(i + 1) % 3];
      }
  std::size_t fans = 0;
  for(; !next.empty(); ++fans)
  {
    std::size_t first = next.begin()->first;
    for(std::size_t i = 0; i < previous.size() && previous.count(first) != 0; ++i)
      first = previous[first];
    for(auto step = next.find(first); step != next.end(); step = next.find(first))
    {
      first = step->second;
      next.erase(step);
    }
  }
  return fans;
}

// removes random triangles as often as tried, where all vertices stay manifold
inline void remove_random_triangles(Combinatorial_mesh& mesh, std::size_t number_of_trials, Random& random)
{
  for(; number_of_trials > 0 && !mesh.triangles.empty(); --number_of_trials)
  {
    const std::size_t chosen = random.below(mesh.triangles.size());
    const Vertex_triple t = mesh.triangles[chosen];
    std::swap(mesh.triangles[chosen], mesh.triangles.back());
    mesh.triangles.pop_back();
    if(std::any_of(t.begin(), t.end(), [&](std::size_t v) { return number_of_fans(mesh, v) > 1; }))
      mesh.triangles.push_back(t);
  }
}

// gives vertices and triangles other numbers, and triangles another first vertex
inline void relabel(Combinatorial_mesh& mesh, Random& random)
{
  std::vector<std::size_t> new_names;
  for(std::size_t v = 0; v < mesh.number_of_vertices; ++v)
    new_names.push_back(v);
  random.shuffle(new_names);
  for(Vertex_triple& t : mesh.triangles)
  {
    for(std::size_t& v : t)
      v = new_names[v];
    std::rotate(t.begin(), t.begin() + random.below(3), t.end());
  }
  random.shuffle(mesh.triangles);
}

inline Combinatorial_mesh random_closed_surface(unsigned genus, std::size_t number_of_splits, Random& random)
{
  Combinatorial_mesh mesh = genus == 0 ? tetrahedron() : seven_vertex_torus();
  for(unsigned handle = 1; handle < genus; ++handle)
    mesh = connected_sum(mesh, seven_vertex_torus(), random);
  for(std::size_t i = 0; i < number_of_splits; ++i)
    split_random_triangle(mesh, random);
  flip_random_edges(mesh, 2 * mesh.triangles.size(), random);
  return mesh;
}

enum class Mesh_class
{
  CLOSED,        // of any genus up to 4
  BORDERED,      // the same with holes
  LEVEL_BORDERS, // cylinders and disks; with Field_class::BORDER_LEVELS, borders are level sets
  HIGH_DEGREE,   // a hub of degree up to 40, in a closed or bordered surface of genus up to 2
  SEVERAL,       // components of the other classes, and isolated vertices
  TINY,          // no vertex, isolated vertices only, one triangle, two triangles, a tetrahedron
  NUMBER_OF_CLASSES
};

inline Combinatorial_mesh random_mesh(Mesh_class mesh_class, Random& random);

inline Combinatorial_mesh random_hub(Random& random)
{
  const std::size_t degree = 6 + random.below(35);
  Combinatorial_mesh mesh = random.below(2) == 0 ? bipyramid(degree)
                          : random.below(2) == 0 ? disk(degree)
                                                 : half_disk(degree);
  for(std::size_t handle = random.below(3); handle > 0; --handle)
    mesh = connected_sum(mesh, seven_vertex_torus(), random);
  if(random.below(3) == 0)
    flip_random_edges(mesh, 10, random);
  return mesh;
}

inline Combinatorial_mesh random_tiny_mesh(Random& random)
{
  const std::array<Combinatorial_mesh, 6> meshes = {
    Combinatorial_mesh(), Combinatorial_mesh{1 + random.below(4), {}},   Combinatorial_mesh{3, {{0, 1, 2}}},
    tetrahedron(),        Combinatorial_mesh{4, {{0, 1, 2}, {2, 1, 3}}}, Combinatorial_mesh{5, {{0, 1, 2}}}};
  return meshes[random.below(meshes.size())];
}

inline Combinatorial_mesh random_collection(Random& random)
{
  Combinatorial_mesh mesh;
  for(std::size_t components = 2 + random.below(3); components > 0; --components)
    mesh = disjoint_union(mesh, random_mesh(static_cast<Mesh_class>(random.below(4)), random));
  mesh.number_of_vertices += random.below(4);
  return mesh;
}

inline Combinatorial_mesh random_bordered_surface(Random& random)
{
  const std::size_t number_of_splits = 3 + random.below(20);
  Combinatorial_mesh mesh = random_closed_surface(static_cast<unsigned>(random.below(4)), number_of_splits, random);
  remove_random_triangles(mesh, 1 + random.below(mesh.triangles.size() / 2), random);
  flip_random_edges(mesh, random.below(30), random);
  return mesh;
}

inline Combinatorial_mesh random_mesh(Mesh_class mesh_class, Random& random)
{
  Combinatorial_mesh mesh;
  std::size_t size = 0;
  switch(mesh_class)
  {
  case Mesh_class::CLOSED:
    size = random.below(20);
    mesh = random_closed_surface(static_cast<unsigned>(random.below(5)), size, random);
    break;
  case Mesh_class::BORDERED: mesh = random_bordered_surface(random); break;
  case Mesh_class::LEVEL_BORDERS:
    if(random.below(4) == 0)
      mesh = disk(3 + random.below(8));
    else
    {
      size = 2 + random.below(4);
      mesh = cylinder(3 + random.below(5), size);
    }
    for(std::size_t i = random.below(6); i > 0; --i)
      split_random_triangle(mesh, random);
    for(std::size_t handle = random.below(2); handle > 0; --handle)
      mesh = connected_sum(mesh, seven_vertex_torus(), random);
    flip_random_edges(mesh, 10, random);
    break;
  case Mesh_class::HIGH_DEGREE: mesh = random_hub(random); break;
  case Mesh_class::SEVERAL: mesh = random_collection(random); break;
  default: mesh = random_tiny_mesh(random);
  }
  relabel(mesh, random);
  return mesh;
}

} // namespace random_meshes

#endif // CGAL_REEB_GRAPH_SRC_GENERATED_SURFACES_RANDOM_MESHES_H
