// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_CURVES_INTERNAL_SIMPLE_REEB_GRAPH_H
#define CGAL_REEB_GRAPH_CURVES_INTERNAL_SIMPLE_REEB_GRAPH_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/curves/exceptions.h>
#include <CGAL/Reeb_graph/curves/internal/Ranked_mesh.h>
#include <CGAL/Reeb_graph/internal/base/Progress.h>
#include <CGAL/Reeb_graph/internal/base/Threads.h>
#include <CGAL/Reeb_graph/internal/base/requirements.h>
#include <CGAL/Reeb_graph/internal/complex/Flat_mesh.h>
#include <CGAL/Reeb_graph_traits.h>
#include <CGAL/compute_reeb_graph.h>

#include <CGAL/Polygon_mesh_processing/connected_components.h>
#include <CGAL/boost/graph/iterator.h>
#include <CGAL/tags.h>

#include <algorithm>
#include <cstddef>
#include <optional>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL::Reeb_graph::internal {

// Makes simple saddles of one multi-saddle inside of the surface, by refining its star.
//
// Let w_a .. w_b be the neighbors in one of its upper link sectors. The edge to each of them is split at a point p_i,
// with ranks just below the multi-saddle that fall from p_a to p_b. The link sector has then become lower and joins
// the two lower ones beside it; p_a, whose lower neighbors are w_{a-1} and p_{a+1}, or w_{a-1} and w_{b+1}, is a
// simple saddle; and p_{a+1} .. p_b are regular. Nothing changes for the other vertices.
template <class RankedMesh>
class Vertex_unfolding
{
  typedef typename RankedMesh::vertex_descriptor vertex_descriptor;
  typedef typename RankedMesh::halfedge_descriptor halfedge_descriptor;

  struct Sector
  {
    std::size_t first, size; // positions of the spokes
    Long_index first_rank;   // makes the order independent of the spoke with which they begin
  };

public:
  explicit Vertex_unfolding(const RankedMesh& ranked) : ranked_(ranked), mesh_(ranked.mesh()) {}

  void operator()(vertex_descriptor v)
  {
    find_spokes(v);
    find_upper_sectors(v);
    if(sectors_.size() < 3)
      return;
    std::sort(sectors_.begin(), sectors_.end(), [](const Sector& a, const Sector& b) {
      return std::tie(a.size, a.first_rank) < std::tie(b.size, b.first_rank);
    });
    sectors_.resize(sectors_.size() - 2);
    Long_index rank = ranked_.rank(v);
    for(const Sector& sector : sectors_)
    {
      split_spokes(v, sector, rank);
      split_faces(sector);
    }
  }

private:
  halfedge_descriptor& spoke(std::size_t i) { return spokes_[i % spokes_.size()]; }
  bool is_upper(vertex_descriptor v, std::size_t i) { return ranked_.rank(v) < ranked_.rank(target(spoke(i), mesh_)); }

  // The halfedges that leave the vertex, counterclockwise.
  void find_spokes(vertex_descriptor v)
  {
    spokes_.clear();
    const halfedge_descriptor first = opposite(halfedge(v, mesh_), mesh_);
    halfedge_descriptor h = first;
    do
    {
      spokes_.push_back(h);
      h = opposite(prev(h, mesh_), mesh_);
    } while(h != first);
  }

  void find_upper_sectors(vertex_descriptor v)
  {
    sectors_.clear();
    for(std::size_t i = 0; i != spokes_.size(); ++i)
    {
      const bool is_first = is_upper(v, i) && !is_upper(v, i + spokes_.size() - 1);
      if(!is_first)
        continue;
      Sector sector = {i, 1, ranked_.rank(target(spoke(i), mesh_))};
      while(is_upper(v, i + sector.size))
        ++sector.size;
      sectors_.push_back(sector);
    }
  }

  void split_spokes(vertex_descriptor v, const Sector& sector, Long_index& rank)
  {
    for(std::size_t i = sector.first; i != sector.first + sector.size; ++i)
    {
      const double fraction = 1. / 3;
      const halfedge_descriptor first = ranked_.split_edge(spoke(i), v, target(spoke(i), mesh_), fraction);
      ranked_.place(target(first, mesh_), --rank, ranked_.value(v));
    }
  }

  // Splits the faces at a sector whose spokes have been split, and begin at their new vertices.
  void split_faces(const Sector& sector)
  {
    const std::size_t first = sector.first, last = sector.first + sector.size - 1;
    const halfedge_descriptor before = spoke(first + spokes_.size() - 1);
    ranked_.split_face(before, opposite(spoke(first), mesh_));
    for(std::size_t i = first; i != last; ++i)
    {
      const halfedge_descriptor to_next = opposite(spoke(i + 1), mesh_);
      ranked_.split_face(prev(spoke(i), mesh_), to_next);
      ranked_.triangulate(to_next);
    }
    ranked_.split_face(prev(spoke(last), mesh_), next(spoke(last), mesh_));
  }

  const RankedMesh& ranked_;
  typename RankedMesh::Mesh& mesh_;
  std::vector<halfedge_descriptor> spokes_;
  std::vector<Sector> sectors_;
};

// Makes simple saddles of all multi-saddles inside of the surface.
template <class RankedMesh>
void unfold_all_vertices(const RankedMesh& ranked)
{
  auto& mesh = ranked.mesh();
  std::vector<typename RankedMesh::vertex_descriptor> inner_vertices;
  for(const auto v : vertices(mesh))
  {
    const auto h = halfedge(v, mesh);
    const bool is_isolated = h == boost::graph_traits<typename RankedMesh::Mesh>::null_halfedge();
    if(!is_isolated && !is_border(v, mesh))
      inner_vertices.push_back(v);
  }
  Vertex_unfolding<RankedMesh> unfold(ranked);
  for(const auto v : inner_vertices)
    unfold(v);
}

// Throws what compute_reeb_graph() throws for input that has no Reeb graph, as long as nothing has been changed yet and
// no values have been compared.
template <class Mesh, class ScalarMap, class NamedParameters>
void check_input(const Mesh& mesh, const ScalarMap& scalar_map, const NamedParameters& np)
{
  typedef Chosen_traits<Reeb_graph_traits<Mesh, ScalarMap>, NamedParameters> Traits;
  static_assert(are_met<Scalar_field<Mesh, ScalarMap, Traits>>);
  read_values(Threads(), Vertex_list<Mesh>(mesh), scalar_map, choose_traits<Traits>(np), [](const auto&) { return 0; });
  check_mesh(mesh);
}

template <class Mesh>
void check_negative_euler_characteristics(const Mesh& mesh)
{
  struct Component
  {
    std::size_t first_face = 0;
    long euler_characteristic = 0;
    bool has_border = false;
  };
  const auto component_map = get(dynamic_face_property_t<std::size_t>(), mesh);
  std::vector<Component> components(Polygon_mesh_processing::connected_components(mesh, component_map));
  const auto component_of = [&](auto h) -> Component& {
    return components[get(component_map, face(is_border(h, mesh) ? opposite(h, mesh) : h, mesh))];
  };
  std::size_t position = 0;
  for(const auto f : faces(mesh))
  {
    Component& component = components[get(component_map, f)];
    if(component.euler_characteristic++ == 0)
      component.first_face = position;
    ++position;
  }
  for(const auto e : edges(mesh))
  {
    Component& component = component_of(halfedge(e, mesh));
    --component.euler_characteristic;
    component.has_border = component.has_border || is_border(e, mesh);
  }
  for(const auto v : vertices(mesh))
    if(halfedge(v, mesh) != boost::graph_traits<Mesh>::null_halfedge())
      ++component_of(halfedge(v, mesh)).euler_characteristic;
  for(const Component& component : components)
    if(component.euler_characteristic >= 0)
      throw No_pants_decomposition_error(component.first_face, component.euler_characteristic, component.has_border);
}

// The Reeb graph of a refinement of the mesh all of whose saddles are simple, and in which each border is one leaf.
template <class RankedMesh>
struct Simple_reeb_graph
{
  typedef typename RankedMesh::Mesh Mesh;
  typedef typename Reeb_graph_traits<Mesh, typename RankedMesh::Rank_map>::Graph Graph;
  typedef decltype(get(dynamic_vertex_property_t<std::size_t>(), std::declval<const Mesh&>())) Place_map;

  Graph graph;
  std::optional<Place_map> places;                                    // of all vertices, if they are wanted
  std::vector<bool> is_border;                                        // whether a node is a border, by node
  std::vector<typename RankedMesh::vertex_descriptor> given_vertices; // those that refining the mesh has not added
};

// Refines the mesh so that its Reeb graph is simple. The input has been checked by check_input(). `ArePlacesWanted` is
// bool, or std::false_type where they never are.
template <class RankedMesh, class ScalarMap, class Traits, class ArePlacesWanted>
Simple_reeb_graph<RankedMesh> compute_simple_reeb_graph(const RankedMesh& ranked,
                                                        const ScalarMap& scalar_map,
                                                        const Traits& traits,
                                                        const ArePlacesWanted& are_places_wanted,
                                                        const Stage_progress& progress)
{
  auto& mesh = ranked.mesh();
  Simple_reeb_graph<RankedMesh> result;
  result.given_vertices.assign(vertices(mesh).first, vertices(mesh).second);
  progress(0);
  auto borders = find_level_borders(mesh, scalar_map, traits.less_scalar_object());
  rank_vertices(ranked, scalar_map, traits, &borders);
  progress(0.4);
  split_chords(ranked, borders);
  unfold_all_vertices(ranked);

  const auto ties = parameters::ties(Ties::CONTRACT);
  const auto callback = progress.part(0.55, 1).callback();
  if(!are_places_wanted)
    compute_reeb_graph(mesh, ranked.rank_map(), result.graph, ties.callback(callback));
  else if constexpr(std::is_same_v<ArePlacesWanted, bool>)
  {
    result.places = get(dynamic_vertex_property_t<std::size_t>(), std::as_const(mesh));
    compute_reeb_graph(mesh, ranked.rank_map(), result.graph, ties.vertex_place_map(*result.places).callback(callback));
  }
  for(const auto node : CGAL::make_range(vertices(result.graph)))
    result.is_border.push_back(borders.is_on_border(result.graph[node].vertex));
  return result;
}

} // namespace CGAL::Reeb_graph::internal

#endif // CGAL_REEB_GRAPH_CURVES_INTERNAL_SIMPLE_REEB_GRAPH_H
