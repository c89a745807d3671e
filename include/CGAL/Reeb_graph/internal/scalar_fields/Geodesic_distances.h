// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of the CGAL-style package Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_INTERNAL_SCALAR_FIELDS_GEODESIC_DISTANCES_H
#define CGAL_REEB_GRAPH_INTERNAL_SCALAR_FIELDS_GEODESIC_DISTANCES_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/scalar_field_exceptions.h>
#include <CGAL/Reeb_graph/internal/scalar_fields/Indexed_surface.h>
#include <CGAL/Reeb_graph/internal/Progress.h>
#include <CGAL/Reeb_graph/internal/scalar_fields/Weighted_graph.h>

#include <CGAL/Heat_method_3/Surface_mesh_geodesic_distances_3.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/Face_filtered_graph.h>
#include <CGAL/boost/graph/copy_face_graph.h>
#include <CGAL/exceptions.h>

#include <boost/iterator/function_output_iterator.hpp>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Reeb_graph {
namespace internal {
namespace scalar_fields {

// The heat method knows distances up to a constant for each component, so each component is a mesh of its own. It also
// depends on there being no isolated vertex. So it works on copies, which know the positions of their vertices.
class Geodesic_distances
{
public:
  typedef CGAL::Surface_mesh<Simple_cartesian<double>::Point_3> Copy;

  template <class Surface>
  Geodesic_distances(const Surface& surface, const std::vector<bool>& is_source)
    : is_source_(is_source),
      distances_(surface.number_of_vertices(), 0)
  {}

  template <class FaceListGraph, class Surface>
  void run(const FaceListGraph& mesh,
           const Surface& surface,
           const std::vector<Position>& component_of_vertex,
           const Progress& progress)
  {
    Copy copy;
    auto positions = copy.add_property_map<Copy::Vertex_index, Position>("v:position", no_position).first;
    copy_face_graph(mesh, copy,
                    parameters::vertex_to_vertex_output_iterator(boost::make_function_output_iterator(
                      [&](const auto& pair) { positions[pair.second] = surface.position(pair.first); })));
    for(const Copy::Vertex_index v : copy.vertices())
    {
      const Vector& p = surface.point(positions[v]);
      copy.point(v) = Copy::Point(p[0], p[1], p[2]);
    }
    auto components = copy.add_property_map<Copy::Face_index, std::size_t>("f:component").first;
    std::vector<std::size_t> names_of_components;
    for(const Copy::Face_index f : copy.faces())
    {
      components[f] = component_of_vertex[positions[copy.target(copy.halfedge(f))]];
      names_of_components.push_back(components[f]);
    }
    std::sort(names_of_components.begin(), names_of_components.end());
    names_of_components.erase(std::unique(names_of_components.begin(), names_of_components.end()),
                              names_of_components.end());
    for(std::size_t i = 0; i != names_of_components.size(); ++i)
    {
      const Face_filtered_graph<Copy> filtered(copy, names_of_components[i], components);
      run_on_component(filtered, positions);
      progress.report(0.1 + 0.9 * static_cast<double>(i + 1) / static_cast<double>(names_of_components.size()));
    }
  }

  // for the points divided by Indexed_surface::scale()
  const std::vector<double>& distances() const { return distances_; }

private:
  template <class Filtered_graph, class Positions>
  void run_on_component(const Filtered_graph& filtered, const Positions& positions)
  {
    typedef Heat_method_3::Surface_mesh_geodesic_distances_3<Copy, Heat_method_3::Intrinsic_Delaunay> Heat_method;
    Copy component;
    std::vector<std::pair<Copy::Vertex_index, Position>> vertices;
    copy_face_graph(filtered, component,
                    parameters::vertex_to_vertex_output_iterator(boost::make_function_output_iterator(
                      [&](const auto& pair) { vertices.emplace_back(pair.second, positions[pair.first]); })));
    auto distance_map = component.add_property_map<Copy::Vertex_index, double>("v:distance", 0).first;
    try
    {
      Heat_method heat_method(component);
      for(const auto& vertex : vertices)
        if(is_source_[vertex.second])
          heat_method.add_source(vertex.first);
      heat_method.estimate_geodesic_distances(distance_map);
    }
    catch(const Failure_exception&)
    {
      throw Linear_solver_error();
    }
    for(const auto& vertex : vertices)
      distances_[vertex.second] = distance_map[vertex.first];
  }

  const std::vector<bool>& is_source_;
  std::vector<double> distances_;
};

} // namespace scalar_fields
} // namespace internal
} // namespace Reeb_graph
} // namespace CGAL

#endif // CGAL_REEB_GRAPH_INTERNAL_SCALAR_FIELDS_GEODESIC_DISTANCES_H
