// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of the CGAL-style package Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_INTERNAL_CURVES_SIMPLE_REEB_GRAPH_H
#define CGAL_REEB_GRAPH_INTERNAL_CURVES_SIMPLE_REEB_GRAPH_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/curves/exceptions.h>
#include <CGAL/Reeb_graph/internal/base/Progress.h>
#include <CGAL/Reeb_graph/internal/base/requirements.h>
#include <CGAL/Reeb_graph/internal/curves/Ranked_mesh.h>
#include <CGAL/Reeb_graph/internal/curves/level_borders.h>
#include <CGAL/Reeb_graph/internal/curves/rank_vertices.h>
#include <CGAL/Reeb_graph/internal/curves/unfold_vertex.h>
#include <CGAL/Reeb_graph/internal/mesh/flatten.h>
#include <CGAL/Reeb_graph_traits.h>
#include <CGAL/compute_reeb_graph.h>

#include <CGAL/Polygon_mesh_processing/connected_components.h>
#include <CGAL/tags.h>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Reeb_graph {
namespace internal {

// Throws what compute_reeb_graph() throws for input that has no Reeb graph, as long as nothing has been changed yet and
// no values have been compared.
template <class Mesh, class ScalarMap, class NamedParameters>
void check_input(const Mesh& mesh, const ScalarMap& scalar_map, const NamedParameters& np)
{
  typedef Chosen_traits<Reeb_graph_traits<Mesh, ScalarMap>, NamedParameters> Traits;
  if constexpr(Scalar_field<Mesh, ScalarMap, Traits>::value)
    flatten<Sequential_tag>(mesh, scalar_map, choose_traits<Traits>(np), parameters::default_values());
}

struct Component_counts
{
  std::size_t first_face;
  long euler_characteristic;
  bool has_border;
};

template <class Mesh>
std::vector<Component_counts> count_components(const Mesh& mesh)
{
  const auto component_map = get(dynamic_face_property_t<std::size_t>(), mesh);
  Polygon_mesh_processing::connected_components(mesh, component_map);
  std::vector<Component_counts> components;
  std::size_t position = 0;
  for(const auto f : faces(mesh))
  {
    const std::size_t component = get(component_map, f);
    if(component >= components.size())
      components.resize(component + 1, {position, 0, false});
    ++components[component].euler_characteristic;
    ++position;
  }
  for(const auto e : edges(mesh))
  {
    const auto h = halfedge(e, mesh), g = opposite(h, mesh);
    const bool is_on_border = is_border(h, mesh) || is_border(g, mesh);
    Component_counts& component = components[get(component_map, face(is_border(h, mesh) ? g : h, mesh))];
    --component.euler_characteristic;
    component.has_border = component.has_border || is_on_border;
  }
  for(const auto v : vertices(mesh))
  {
    auto h = halfedge(v, mesh);
    if(h == boost::graph_traits<Mesh>::null_halfedge())
      continue;
    h = is_border(h, mesh) ? opposite(h, mesh) : h;
    ++components[get(component_map, face(h, mesh))].euler_characteristic;
  }
  return components;
}

template <class Mesh>
void check_negative_euler_characteristics(const Mesh& mesh)
{
  for(const Component_counts& component : count_components(mesh))
  {
    if(component.euler_characteristic >= 0)
      throw No_pants_decomposition_error(component.first_face, component.euler_characteristic, component.has_border);
  }
}

// The Reeb graph of a refinement of the mesh all of whose saddles are simple, and in which each border is one leaf.
template <class RankedMesh>
struct Simple_reeb_graph
{
  typedef typename Reeb_graph_traits<typename RankedMesh::Mesh, typename RankedMesh::Rank_map>::Graph Graph;

  Graph graph;
  std::vector<bool> is_border;                                        // whether a node is a border, by node
  std::vector<typename RankedMesh::vertex_descriptor> given_vertices; // those that refining the mesh has not added
};

// Refines the mesh so that its Reeb graph is simple. The input has been checked by check_input().
template <class RankedMesh, class ScalarMap, class Traits>
Simple_reeb_graph<RankedMesh> compute_simple_reeb_graph(const RankedMesh& ranked,
                                                        const ScalarMap& scalar_map,
                                                        const Traits& traits,
                                                        const Stage_progress& progress)
{
  auto& mesh = ranked.mesh();
  Simple_reeb_graph<RankedMesh> result;
  result.given_vertices.assign(vertices(mesh).first, vertices(mesh).second);
  progress(0);
  auto borders = find_level_borders(mesh, scalar_map, traits.less_scalar_object());
  rank_vertices(ranked, scalar_map, traits, borders);
  progress(0.4);
  split_chords(ranked, borders);
  unfold_all_vertices(ranked);

  compute_reeb_graph(mesh, ranked.rank_map(), result.graph,
                     parameters::ties(Ties::CONTRACT).callback(progress.part(0.55, 1).callback()));
  for(const auto node : CGAL::make_range(vertices(result.graph)))
    result.is_border.push_back(borders.is_on_border(result.graph[node].vertex));
  return result;
}

} // namespace internal
} // namespace Reeb_graph
} // namespace CGAL

#endif // CGAL_REEB_GRAPH_INTERNAL_CURVES_SIMPLE_REEB_GRAPH_H
