// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of the CGAL-style package Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_INTERNAL_CURVES_RANK_VERTICES_H
#define CGAL_REEB_GRAPH_INTERNAL_CURVES_RANK_VERTICES_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/internal/base/Scalar_conversion.h>
#include <CGAL/Reeb_graph/internal/curves/Ranked_mesh.h>
#include <CGAL/Reeb_graph/internal/curves/level_borders.h>

#include <algorithm>
#include <cstddef>
#include <tuple>
#include <vector>

namespace CGAL {
namespace Reeb_graph {
namespace internal {

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

#endif // CGAL_REEB_GRAPH_INTERNAL_CURVES_RANK_VERTICES_H
