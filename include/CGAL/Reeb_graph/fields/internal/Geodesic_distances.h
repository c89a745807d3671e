// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of the CGAL-style package Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_FIELDS_INTERNAL_GEODESIC_DISTANCES_H
#define CGAL_REEB_GRAPH_FIELDS_INTERNAL_GEODESIC_DISTANCES_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/fields/internal/Indexed_surface.h>
#include <CGAL/Reeb_graph/internal/base/Index.h>
#include <CGAL/Reeb_graph/internal/base/Progress.h>
#include <CGAL/Reeb_graph/internal/base/arrays.h>
#include <CGAL/Reeb_graph/internal/base/union_find.h>

#include <CGAL/Heat_method_3/Surface_mesh_geodesic_distances_3.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/exceptions.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <limits>
#include <queue>
#include <utility>
#include <vector>

namespace CGAL::Reeb_graph::internal::scalar_fields {

// Distances from the sources that grow from vertex to vertex, as those of Dijkstra's algorithm, along the edges and
// straight through the triangles (M. Novotni and R. Klein, Computing Geodesic Distances on Triangular Meshes, 2002).
// They depend on the lengths of edges only, no equation is solved, and each vertex of a component with a source gets a
// finite one. Along an edge they grow by no more than its length.
class Marching
{
public:
  Marching(const Indexed_surface& surface, const std::vector<bool>& is_source)
    : surface_(surface),
      triangles_(surface.number_of_vertices(),
                 [&](const auto& visit) {
                   for(std::size_t t = 0; t != surface.triangles().size(); ++t)
                     for(const Position v : surface.triangles()[t].vertices)
                       visit(Vertex_index(v), static_cast<Number>(t));
                 }),
      distances_(surface.number_of_vertices(), std::numeric_limits<double>::infinity()),
      is_final_(surface.number_of_vertices(), false)
  {
    for(Position v = 0; v != surface.number_of_vertices(); ++v)
      if(is_source[v])
        reach(v, 0);
    march();
  }

  // The distances for the points divided by surface.scale().
  const std::vector<double>& distances() const { return distances_; }

private:
  typedef std::pair<double, Position> Entry;

  void march()
  {
    while(!queue_.empty())
    {
      const Position v = queue_.top().second;
      queue_.pop();
      if(is_final_[v])
        continue;
      is_final_[v] = true;
      for(const Number t : triangles_[Vertex_index(v)])
        cross_triangle(surface_.triangles()[t], v);
    }
  }

  // Reaches the other corners of a triangle from one that has just got its distance.
  void cross_triangle(const Indexed_triangle& triangle, Position v)
  {
    const auto& corners = triangle.vertices;
    const std::size_t i = static_cast<std::size_t>(std::find(corners.begin(), corners.end(), v) - corners.begin());
    const Position a = corners[(i + 1) % 3], b = corners[(i + 2) % 3];
    for(const auto& [from, to] : {std::make_pair(a, b), std::make_pair(b, a)})
    {
      reach(to, distances_[v] + surface_.edge_length(v, to));
      if(is_final_[from])
        reach(to, distance_through(v, from, to));
    }
  }

  void reach(Position v, double distance)
  {
    if(is_final_[v] || !(distance < distances_[v]))
      return;
    distances_[v] = distance;
    queue_.push({distance, v});
  }

  // The distance of c through the edge from a to b, of one source of their distances that lies in the plane of the
  // triangle beyond the edge: infinite if there is none, or if the way misses the edge.
  double distance_through(Position a, Position b, Position c) const
  {
    const double ab = surface_.edge_length(a, b), ac = surface_.edge_length(a, c), bc = surface_.edge_length(b, c);
    const auto [x_of_source, y_of_source] = place(ab, distances_[a], distances_[b]);
    const auto [x, y] = place(ab, ac, bc);
    const double crossing = x_of_source + (x - x_of_source) * (y_of_source / (y_of_source + y));
    return crossing >= 0 && crossing <= ab ? std::hypot(x - x_of_source, y + y_of_source)
                                           : std::numeric_limits<double>::infinity();
  }

  // The point, above the x-axis, at these distances from the origin and from the point (base, 0).
  static std::pair<double, double> place(double base, double from_origin, double from_end)
  {
    const double x = (base + (from_origin - from_end) * ((from_origin + from_end) / base)) / 2;
    return {x, std::sqrt((std::max)((from_origin - x) * (from_origin + x), 0.))};
  }

  const Indexed_surface& surface_;
  const Buckets<Vertex_index, Number> triangles_; // of each vertex
  std::vector<double> distances_;
  std::vector<bool> is_final_;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<Entry>> queue_;
};

// A component of a surface as a mesh, with vertices and faces in the same order. The heat method knows distances up to
// a constant for each component, and depends on there being no isolated vertex.
struct Surface_component
{
  typedef CGAL::Surface_mesh<Simple_cartesian<double>::Point_3> Mesh;

  // `triangles` are the numbers of those of the component; `vertices` is scratch space by position.
  template <class Triangles>
  Surface_component(const Indexed_surface& surface,
                    const Triangles& triangles,
                    std::vector<Mesh::Vertex_index>& vertices)
  {
    for(const Number t : triangles)
      for(const Position v : surface.triangles()[t].vertices)
        positions.push_back(v);
    std::sort(positions.begin(), positions.end());
    positions.erase(std::unique(positions.begin(), positions.end()), positions.end());
    for(const Position v : positions)
      vertices[v] = mesh.add_vertex(ORIGIN + surface.point(v));
    for(const Number t : triangles)
    {
      const auto& v = surface.triangles()[t].vertices;
      // Edges are numbered, and faces begin, as in a copy of a mesh: sums are in this order.
      const auto face = mesh.add_face(vertices[v[1]], vertices[v[2]], vertices[v[0]]);
      mesh.set_halfedge(face, mesh.prev(mesh.halfedge(face)));
    }
  }

  Mesh mesh;
  std::vector<Position> positions; // by vertex
};

// Whether all triangles are wide enough for the edge flips of CGAL's intrinsic Delaunay triangulation, which computes
// lengths from lengths. It does not end, or crashes, for some that are narrower, or of very different sizes.
inline bool is_fit_for_heat_method(const Surface_component::Mesh& mesh)
{
  constexpr double least_slack = 1e-14, largest_ratio = 1e7;
  double shortest = std::numeric_limits<double>::infinity(), longest = 0;
  for(const auto f : mesh.faces())
  {
    std::vector<double> sides;
    for(const auto h : mesh.halfedges_around_face(mesh.halfedge(f)))
      sides.push_back(std::sqrt(squared_distance(mesh.point(mesh.source(h)), mesh.point(mesh.target(h)))));
    std::sort(sides.begin(), sides.end());
    if(!(sides[0] - (sides[2] - sides[1]) > least_slack * sides[2]))
      return false;
    shortest = (std::min)(shortest, sides[0]);
    longest = (std::max)(longest, sides[2]);
  }
  return longest < largest_ratio * shortest;
}

// Replaces marched distances on a component by those of the heat method, and returns whether this finds a solution of
// its equations in which none is off by more than half of the largest marched one. Where it divides zero by zero, as on
// some tetrahedra and some thousand edges away from the sources, it gives NaN or the largest number.
inline bool run_heat_method(Surface_component& component,
                            const std::vector<bool>& is_source,
                            std::vector<double>& distances)
{
  typedef Surface_component::Mesh Mesh;
  typedef Heat_method_3::Surface_mesh_geodesic_distances_3<Mesh, Heat_method_3::Intrinsic_Delaunay> Heat_method;
  Mesh& mesh = component.mesh;
  if(!is_fit_for_heat_method(mesh))
    return false;
  const auto distance_map = mesh.add_property_map<Mesh::Vertex_index, double>("v:distance", 0).first;
  try
  {
    Heat_method heat_method(mesh);
    for(const auto v : mesh.vertices())
      if(is_source[component.positions[v]])
        heat_method.add_source(v);
    heat_method.estimate_geodesic_distances(distance_map);
  }
  catch(const Failure_exception&)
  {
    return false;
  }
  double largest = 0;
  for(const Position v : component.positions)
    largest = (std::max)(largest, distances[v]);
  for(const auto v : mesh.vertices())
    if(!(std::abs(distance_map[v] - distances[component.positions[v]]) <= largest / 2))
      return false;
  for(const auto v : mesh.vertices())
    distances[component.positions[v]] = distance_map[v];
  return true;
}

// The same on all components, by the numbers of those of vertices. Returns on how many the heat method fails.
inline std::size_t run_heat_method_on_components(const Indexed_surface& surface,
                                                 const std::vector<Position>& components,
                                                 const std::vector<bool>& is_source,
                                                 const Progress& progress,
                                                 std::vector<double>& distances)
{
  const Buckets<Component_index, Number> triangles_of_components(components.size(), [&](const auto& visit) {
    for(std::size_t t = 0; t != surface.triangles().size(); ++t)
      visit(Component_index(components[surface.triangles()[t].vertices[0]]), static_cast<Number>(t));
  });
  std::vector<Surface_component::Mesh::Vertex_index> vertices(surface.number_of_vertices());
  std::size_t number_of_failures = 0, number_of_done_triangles = 0;
  for(const Component_index c : Index_range<Component_index>(components.size()))
  {
    const auto triangles = triangles_of_components[c];
    if(triangles.size() == 0)
      continue;
    Surface_component component(surface, triangles, vertices);
    number_of_failures += run_heat_method(component, is_source, distances) ? 0 : 1;
    number_of_done_triangles += triangles.size();
    progress.report(
      0.1 + 0.8 * static_cast<double>(number_of_done_triangles) / static_cast<double>(triangles_of_components.size()));
  }
  return number_of_failures;
}

} // namespace CGAL::Reeb_graph::internal::scalar_fields

#endif // CGAL_REEB_GRAPH_FIELDS_INTERNAL_GEODESIC_DISTANCES_H
