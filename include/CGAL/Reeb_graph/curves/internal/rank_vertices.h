// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of the CGAL-style package Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_CURVES_INTERNAL_RANK_VERTICES_H
#define CGAL_REEB_GRAPH_CURVES_INTERNAL_RANK_VERTICES_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/curves/exceptions.h>
#include <CGAL/Reeb_graph/curves/internal/Ranked_mesh.h>
#include <CGAL/Reeb_graph/internal/base/scalars.h>
#include <CGAL/Reeb_graph/internal/complex/border_cycles.h>

#include <CGAL/boost/graph/iterator.h>

#include <boost/range/iterator_range.hpp>

#include <algorithm>
#include <cstddef>
#include <tuple>
#include <vector>

namespace CGAL {
namespace Reeb_graph {
namespace internal {

// A border component all of whose vertices have one value, which no neighbor is below, or none is above.
template <class VertexDescriptor>
struct Level_border
{
  std::vector<VertexDescriptor> vertices;
  bool is_minimum = true;
  std::size_t group = 0; // number of the group of borders at one level on one side
};

// All border components of a mesh, each of which is an extremum of the field.
template <class Mesh>
struct Level_borders
{
  typedef typename boost::graph_traits<Mesh>::vertex_descriptor vertex_descriptor;
  typedef typename boost::property_map<Mesh, dynamic_vertex_property_t<std::size_t>>::type Number_map;

  explicit Level_borders(Mesh& mesh) : number_map(get(dynamic_vertex_property_t<std::size_t>(), mesh)) {}

  bool is_on_border(vertex_descriptor v) const { return get(number_map, v) != 0; }
  const Level_border<vertex_descriptor>& border_of(vertex_descriptor v) const
  {
    return borders[get(number_map, v) - 1];
  }

  std::vector<Level_border<vertex_descriptor>> borders;
  Number_map number_map;        // number of the border of a vertex plus one, 0 if it is on none
  std::vector<Rank> last_ranks; // rank nearest to those of the other vertices, by group
};

// Finds out on which side of the field the border is. Throws if it is on none.
template <class Mesh, class ScalarMap, class Less>
void check_level_border(const Mesh& mesh,
                        const ScalarMap& scalar_map,
                        const Less& less,
                        std::size_t first_vertex,
                        Level_border<typename boost::graph_traits<Mesh>::vertex_descriptor>& border)
{
  const auto value = get(scalar_map, border.vertices.front());
  bool has_lower = false, has_higher = false;
  for(const auto v : border.vertices)
  {
    const auto value_of_vertex = get(scalar_map, v);
    if(less(value, value_of_vertex) || less(value_of_vertex, value))
      throw Border_level_error(first_vertex, Border_level_error::Reason::SEVERAL_VALUES);
    for(const auto h : halfedges_around_target(v, mesh))
    {
      const auto value_of_neighbor = get(scalar_map, source(h, mesh));
      has_lower = has_lower || less(value_of_neighbor, value);
      has_higher = has_higher || less(value, value_of_neighbor);
    }
  }
  if(has_lower && has_higher)
    throw Border_level_error(first_vertex, Border_level_error::Reason::NOT_EXTREMAL);
  border.is_minimum = !has_lower;
}

// Finds the border components, in the order of their first vertices in vertices(mesh).
template <class Mesh, class ScalarMap, class Less>
Level_borders<Mesh> find_level_borders(Mesh& mesh, const ScalarMap& scalar_map, const Less& less)
{
  Level_borders<Mesh> result(mesh);
  for(const auto v : vertices(mesh))
    put(result.number_map, v, 0);
  for(const auto& cycle : find_border_cycles(mesh))
  {
    result.borders.emplace_back();
    for(const auto v : vertices_around_face(cycle.halfedge, mesh))
    {
      result.borders.back().vertices.push_back(v);
      put(result.number_map, v, result.borders.size());
    }
    check_level_border(mesh, scalar_map, less, cycle.first_vertex, result.borders.back());
  }
  return result;
}

// Splits all edges between two vertices of borders that lie at one level on the same side, so that each border is
// strictly lower or strictly higher than all its other neighbors.
template <class RankedMesh>
void split_chords(const RankedMesh& ranked, Level_borders<typename RankedMesh::Mesh>& borders)
{
  typedef typename RankedMesh::halfedge_descriptor halfedge_descriptor;
  auto& mesh = ranked.mesh();
  std::vector<halfedge_descriptor> chords;
  const auto is_listed = get(dynamic_edge_property_t<bool>(), mesh);
  for(const auto e : edges(mesh))
    put(is_listed, e, false);
  for(const auto& border : borders.borders)
    for(const auto v : border.vertices)
      for(const halfedge_descriptor h : halfedges_around_target(v, mesh))
      {
        const auto u = source(h, mesh);
        const bool is_chord = borders.is_on_border(u) && borders.border_of(u).group == border.group
                           && !is_border(h, mesh) && !is_border(opposite(h, mesh), mesh);
        if(!is_chord || get(is_listed, edge(h, mesh)))
          continue;
        put(is_listed, edge(h, mesh), true);
        chords.push_back(h);
      }
  const Rank step = rank_spacing / 2 / (chords.size() + 1);
  for(const halfedge_descriptor h : chords)
  {
    const auto u = source(h, mesh), w = target(h, mesh);
    const auto& border = borders.border_of(u);
    Rank& rank = borders.last_ranks[border.group];
    rank += border.is_minimum ? step : Rank(0) - step;
    const halfedge_descriptor first = ranked.split_edge(h, u, w, 0.5);
    ranked.place(target(first, mesh), rank, ranked.value(u));
    ranked.split_face(first, next(h, mesh));
    ranked.split_face(opposite(h, mesh), next(opposite(first, mesh), mesh));
  }
}

// The place of a vertex in the order: by value, then by side, then by position. The side is -1 for vertices of a border
// that is a minimum, 1 for those of one that is a maximum, and 0 else. All vertices of such a border have one position.
template <class RankedMesh, class Scalar>
struct Vertex_key
{
  Scalar value;
  int side;
  std::size_t position;
  typename RankedMesh::vertex_descriptor vertex;
};

template <class RankedMesh, class ScalarMap, class Traits>
auto sorted_vertex_keys(const RankedMesh& ranked,
                        const ScalarMap& scalar_map,
                        const Traits& traits,
                        const Level_borders<typename RankedMesh::Mesh>* borders)
{
  typedef Vertex_key<RankedMesh, typename Traits::Scalar> Key;
  std::vector<Key> keys;
  for(const auto v : vertices(ranked.mesh()))
  {
    const bool is_on_border = borders && borders->is_on_border(v);
    const int side = !is_on_border ? 0 : borders->border_of(v).is_minimum ? -1 : 1;
    const std::size_t position = is_on_border ? get(borders->number_map, v) : keys.size();
    keys.push_back({get(scalar_map, v), side, position, v});
  }
  const auto less = traits.less_scalar_object();
  std::stable_sort(keys.begin(), keys.end(), [&](const Key& a, const Key& b) {
    if(less(a.value, b.value))
      return true;
    return !less(b.value, a.value) && std::tie(a.side, a.position) < std::tie(b.side, b.position);
  });
  return keys;
}

// Gives each vertex the rank of its place in the total order.
template <class RankedMesh, class ScalarMap, class Traits>
void rank_vertices(const RankedMesh& ranked, const ScalarMap& scalar_map, const Traits& traits)
{
  const Scalar_conversion<Traits> conversion(traits);
  Rank rank = 0;
  for(const auto& key : sorted_vertex_keys(ranked, scalar_map, traits, nullptr))
    ranked.place(key.vertex, rank += rank_spacing, conversion.to_double(key.value));
}

// Gives each vertex the rank of its place in the total order, but all vertices of a border component one rank, beyond
// all other vertices of their value.
template <class RankedMesh, class ScalarMap, class Traits>
void rank_vertices(const RankedMesh& ranked,
                   const ScalarMap& scalar_map,
                   const Traits& traits,
                   Level_borders<typename RankedMesh::Mesh>& borders)
{
  const Scalar_conversion<Traits> conversion(traits);
  const auto less = traits.less_scalar_object();
  const auto keys = sorted_vertex_keys(ranked, scalar_map, traits, &borders);
  Rank rank = 0;
  for(std::size_t i = 0; i != keys.size(); ++i)
  {
    const bool is_same_side =
      i != 0 && keys[i].side != 0 && keys[i].side == keys[i - 1].side && !less(keys[i - 1].value, keys[i].value);
    const bool is_same_border = is_same_side && keys[i].position == keys[i - 1].position;
    if(!is_same_border)
      rank += rank_spacing;
    ranked.place(keys[i].vertex, rank, conversion.to_double(keys[i].value));
    if(keys[i].side == 0 || is_same_border)
      continue;
    if(!is_same_side)
      borders.last_ranks.push_back(rank); // where a group of maxima begins
    if(keys[i].side < 0)
      borders.last_ranks.back() = rank; // where a group of minima ends
    borders.borders[keys[i].position - 1].group = borders.last_ranks.size() - 1;
  }
}

} // namespace internal
} // namespace Reeb_graph
} // namespace CGAL

#endif // CGAL_REEB_GRAPH_CURVES_INTERNAL_RANK_VERTICES_H
