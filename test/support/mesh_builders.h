// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_SRC_GENERATED_SURFACES_MESH_BUILDERS_H
#define CGAL_REEB_GRAPH_SRC_GENERATED_SURFACES_MESH_BUILDERS_H

#include "generated_surfaces.h"
#include "generated_surfaces/build_mesh.h"
#include "random_meshes.h"

#include <CGAL/Polyhedron_3.h>
#include <CGAL/Polyhedron_items_with_id_3.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/Euler_operations.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <map>
#include <vector>

// CGAL meshes of index triples. The vertices of each mesh are in the order of the triples' indices, the faces in the
// order of the triples.
namespace mesh_builders {
using generated_surfaces::add_point;
using generated_surfaces::build;
using generated_surfaces::make_mesh;
using generated_surfaces::Triangle_soup;

typedef CGAL::Simple_cartesian<double> Kernel;
typedef Kernel::Point_3 Point;
typedef CGAL::Surface_mesh<Point> Surface_mesh;
typedef CGAL::Polyhedron_3<Kernel> Polyhedron;
typedef CGAL::Polyhedron_3<Kernel, CGAL::Polyhedron_items_with_id_3> Polyhedron_with_id;

// Points are only there to tell the vertices apart.
inline Triangle_soup make_soup(const random_meshes::Combinatorial_mesh& mesh)
{
  Triangle_soup soup = {{}, mesh.triangles};
  for(std::size_t v = 0; v < mesh.number_of_vertices; ++v)
  {
    const double t = static_cast<double>(v);
    soup.points.push_back({t, t * t, t * t * t});
  }
  return soup;
}

template <class Mesh>
Mesh make_mesh(const random_meshes::Combinatorial_mesh& mesh)
{
  return make_mesh<Mesh>(make_soup(mesh));
}

// A mesh from which vertices, edges and faces have been removed, so that its indices have holes.
inline void build_with_garbage(Surface_mesh& mesh, const Triangle_soup& soup)
{
  typedef Surface_mesh::Vertex_index Vertex;
  std::vector<Vertex> vertices, junk_vertices;
  const auto add_junk = [&] {
    junk_vertices.push_back(add_point(mesh, {-1, -1, static_cast<double>(junk_vertices.size())}));
  };
  add_junk();
  for(std::size_t v = 0; v < soup.points.size(); ++v)
  {
    vertices.push_back(add_point(mesh, soup.points[v]));
    if(v % 3 == 0)
      add_junk();
  }
  while(junk_vertices.size() % 3 != 0 || junk_vertices.size() < 6)
    add_junk();
  std::vector<Surface_mesh::Face_index> junk_faces;
  for(std::size_t i = 0; i < (std::max)(soup.triangles.size(), junk_vertices.size() / 3); ++i)
  {
    if(3 * i < junk_vertices.size())
      junk_faces.push_back(CGAL::Euler::add_face(
        std::array<Vertex, 3>{junk_vertices[3 * i], junk_vertices[3 * i + 1], junk_vertices[3 * i + 2]}, mesh));
    if(i < soup.triangles.size())
    {
      const auto& t = soup.triangles[i];
      CGAL::Euler::add_face(std::array<Vertex, 3>{vertices[t[0]], vertices[t[1]], vertices[t[2]]}, mesh);
    }
  }
  for(const Surface_mesh::Face_index f : junk_faces)
    CGAL::Euler::remove_face(halfedge(f, mesh), mesh);
}

// Flips random edges of a closed mesh as often as tried, even if two edges with the same ends come out.
inline void flip_edges_carelessly(Surface_mesh& mesh, std::size_t number_of_trials, random_meshes::Random& random)
{
  for(; number_of_trials > 0; --number_of_trials)
  {
    const Surface_mesh::Halfedge_index h(
      static_cast<Surface_mesh::size_type>(random.below(mesh.number_of_halfedges())));
    const auto u = mesh.target(mesh.next(h)), v = mesh.target(mesh.next(mesh.opposite(h)));
    if(u != v && mesh.degree(mesh.source(h)) > 2 && mesh.degree(mesh.target(h)) > 2)
      CGAL::Euler::flip_edge(h, mesh);
  }
}

// The vertices by their position, the edges by numbers, as the tests see them.
template <class Mesh>
class Mesh_numbers
{
public:
  typedef typename boost::graph_traits<Mesh>::vertex_descriptor vertex_descriptor;
  typedef typename boost::graph_traits<Mesh>::halfedge_descriptor halfedge_descriptor;

  explicit Mesh_numbers(const Mesh& mesh) : mesh_(mesh)
  {
    for(const auto v : vertices(mesh))
      vertices_.emplace(v, vertices_.size());
    for(const auto f : faces(mesh))
      for(const auto h : halfedges_around_face(halfedge(f, mesh), mesh))
        edges_.emplace((std::min)(h, opposite(h, mesh)), edges_.size());
  }

  std::size_t number_of_vertices() const { return vertices_.size(); }
  std::size_t vertex(vertex_descriptor v) const { return vertices_.at(v); }
  std::size_t edge(halfedge_descriptor h) const { return edges_.at((std::min)(h, opposite(h, mesh_))); }
  std::size_t source_vertex(halfedge_descriptor h) const { return vertex(source(h, mesh_)); }
  std::size_t target_vertex(halfedge_descriptor h) const { return vertex(target(h, mesh_)); }

  // Triangle is an aggregate of the three vertices and the three edges behind them.
  template <class Triangle>
  std::vector<Triangle> triangles() const
  {
    std::vector<Triangle> result;
    for(const auto f : faces(mesh_))
    {
      const auto h0 = halfedge(f, mesh_), h1 = next(h0, mesh_), h2 = next(h1, mesh_);
      result.push_back({{source_vertex(h0), source_vertex(h1), source_vertex(h2)}, {edge(h0), edge(h1), edge(h2)}});
    }
    return result;
  }

private:
  const Mesh& mesh_;
  std::map<vertex_descriptor, std::size_t> vertices_;
  std::map<halfedge_descriptor, std::size_t> edges_;
};

} // namespace mesh_builders

#endif // CGAL_REEB_GRAPH_SRC_GENERATED_SURFACES_MESH_BUILDERS_H
