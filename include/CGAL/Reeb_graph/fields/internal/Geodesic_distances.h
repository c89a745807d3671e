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
#include <CGAL/Reeb_graph/fields/internal/Weighted_graph.h>
#include <CGAL/Reeb_graph/internal/base/Progress.h>
#include <CGAL/Reeb_graph/internal/base/arrays.h>

#include <CGAL/Heat_method_3/Surface_mesh_geodesic_distances_3.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/Face_filtered_graph.h>
#include <CGAL/boost/graph/copy_face_graph.h>
#include <CGAL/exceptions.h>

#include <boost/iterator/function_output_iterator.hpp>

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

// The distances of the heat method, and those of marching on the components where it fails. It knows distances up to a
// constant for each component, and depends on there being no isolated vertex. So each component is copied to a mesh of
// its own, which knows the positions of its vertices.
class Geodesic_distances
{
public:
  Geodesic_distances(const std::vector<bool>& is_source, std::vector<double> marched_distances)
    : is_source_(is_source),
      distances_(std::move(marched_distances))
  {}

  template <class FaceListGraph, class Surface>
  void run(const FaceListGraph& mesh,
           const Surface& surface,
           const std::vector<Position>& component_of_vertex,
           const Progress& progress)
  {
    Copy copy(
      mesh, [&](const auto v) { return surface.position(v); },
      [&](const auto f) { return component_of_vertex[surface.position(target(halfedge(f, mesh), mesh))]; });
    for(const auto v : copy.mesh.vertices())
      copy.mesh.point(v) = ORIGIN + surface.point(copy.positions[v]);
    std::vector<std::size_t> components;
    for(const auto f : copy.mesh.faces())
      components.push_back(copy.components[f]);
    std::sort(components.begin(), components.end());
    components.erase(std::unique(components.begin(), components.end()), components.end());
    number_of_components_ = components.size();
    if(!components.empty())
      run_on_components(copy, components, progress);
  }

  // The distances for the points divided by Indexed_surface::scale().
  const std::vector<double>& distances() const { return distances_; }

  std::size_t number_of_marched_components() const { return number_of_marched_components_; }

private:
  typedef CGAL::Surface_mesh<Simple_cartesian<double>::Point_3> Mesh;
  typedef Mesh::Property_map<Mesh::Vertex_index, double> Distance_map;

  // A copy of the faces of a mesh.
  struct Copy
  {
    template <class Graph, class PositionOf, class ComponentOf>
    Copy(const Graph& graph, const PositionOf& position_of, const ComponentOf& component_of)
      : mesh(), // NOLINT(readability-redundant-member-init): clang asks for it before the maps
        positions(mesh.add_property_map<Mesh::Vertex_index, Position>("v:position", no_position).first),
        components(mesh.add_property_map<Mesh::Face_index, std::size_t>("f:component", 0).first)
    {
      copy_face_graph(
        graph, mesh,
        parameters::vertex_to_vertex_output_iterator(boost::make_function_output_iterator([&](const auto& pair) {
          positions[pair.second] = position_of(pair.first);
        }))
          .face_to_face_output_iterator(boost::make_function_output_iterator(
            [&](const auto& pair) { components[pair.second] = component_of(pair.first); })));
      for(const auto v : mesh.vertices())
        if(mesh.is_isolated(v))
          mesh.remove_vertex(v);
      mesh.collect_garbage();
    }

    Mesh mesh;
    Mesh::Property_map<Mesh::Vertex_index, Position> positions;
    Mesh::Property_map<Mesh::Face_index, std::size_t> components;
  };

  // Splits the components into halves, as to take one after the other from all of them would be quadratic.
  void run_on_components(Copy& copy, const std::vector<std::size_t>& components, const Progress& progress)
  {
    if(components.size() == 1)
    {
      run_on_component(copy);
      ++number_of_finished_components_;
      progress.report(
        0.1 + 0.8 * static_cast<double>(number_of_finished_components_) / static_cast<double>(number_of_components_));
      return;
    }
    const auto middle = components.begin() + static_cast<std::ptrdiff_t>(components.size() / 2);
    for(const auto& half :
        {std::vector<std::size_t>(components.begin(), middle), std::vector<std::size_t>(middle, components.end())})
    {
      const Face_filtered_graph<Mesh> faces_of_half(copy.mesh, half, copy.components);
      Copy copy_of_half(
        faces_of_half, [&](const auto v) { return copy.positions[v]; },
        [&](const auto f) { return copy.components[f]; });
      run_on_components(copy_of_half, half, progress);
    }
  }

  void run_on_component(Copy& component)
  {
    auto distance_map = component.mesh.add_property_map<Mesh::Vertex_index, double>("v:distance", 0).first;
    if(is_fit_for_heat_method(component.mesh) && run_heat_method(component, distance_map)
       && is_plausible(component, distance_map))
      for(const auto v : component.mesh.vertices())
        distances_[component.positions[v]] = distance_map[v];
    else
      ++number_of_marched_components_;
  }

  // Whether all triangles are wide enough for the edge flips of CGAL's intrinsic Delaunay triangulation, which computes
  // lengths from lengths. It does not end, or crashes, for some that are narrower, or of very different sizes.
  static bool is_fit_for_heat_method(const Mesh& mesh)
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

  // Returns whether the heat method finds a solution of its equations.
  bool run_heat_method(const Copy& component, const Distance_map& distance_map) const
  {
    typedef Heat_method_3::Surface_mesh_geodesic_distances_3<Mesh, Heat_method_3::Intrinsic_Delaunay> Heat_method;
    try
    {
      Heat_method heat_method(component.mesh);
      for(const auto v : component.mesh.vertices())
        if(is_source_[component.positions[v]])
          heat_method.add_source(v);
      heat_method.estimate_geodesic_distances(distance_map);
      return true;
    }
    catch(const Failure_exception&)
    {
      return false;
    }
  }

  // Whether no distance of the heat method is off by more than half of the largest marched one. Where it divides zero
  // by zero, as on some tetrahedra and some thousand edges away from the sources, it gives NaN or the largest number.
  bool is_plausible(const Copy& component, const Distance_map& distance_map) const
  {
    double largest = 0;
    for(const auto v : component.mesh.vertices())
      largest = (std::max)(largest, distances_[component.positions[v]]);
    return std::all_of(component.mesh.vertices().begin(), component.mesh.vertices().end(), [&](const auto v) {
      return std::abs(distance_map[v] - distances_[component.positions[v]]) <= largest / 2;
    });
  }

  const std::vector<bool>& is_source_;
  std::vector<double> distances_;
  std::size_t number_of_components_ = 0, number_of_finished_components_ = 0, number_of_marched_components_ = 0;
};

} // namespace CGAL::Reeb_graph::internal::scalar_fields

#endif // CGAL_REEB_GRAPH_FIELDS_INTERNAL_GEODESIC_DISTANCES_H
