// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of the CGAL-style package Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_INTERNAL_FLATTEN_H
#define CGAL_REEB_GRAPH_INTERNAL_FLATTEN_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/exceptions.h>
#include <CGAL/Reeb_graph/internal/Descriptor_list.h>
#include <CGAL/Reeb_graph/internal/Descriptor_positions.h>
#include <CGAL/Reeb_graph/internal/Large_vector.h>
#include <CGAL/Reeb_graph/internal/Triangle_complex.h>
#include <CGAL/Reeb_graph/internal/parallel.h>
#include <CGAL/Reeb_graph/internal/read_halfedges.h>

#include <boost/graph/graph_traits.hpp>

#include <algorithm>
#include <cstddef>
#include <type_traits>
#include <utility>

namespace CGAL {
namespace Reeb_graph {
namespace internal {

// A mesh with its field in flat arrays. Vertices are numbered by their positions in vertices(mesh), halfedges as in
// Triangle_complex; the descriptors lead back.
template <class FaceListGraph, class Scalar>
struct Flat_surface
{
  typedef typename boost::graph_traits<FaceListGraph>::vertex_descriptor vertex_descriptor;

  Triangle_complex complex;
  Large_vector<Scalar> values;
  Descriptor_list<FaceListGraph, vertex_descriptor> vertices;
  Numbered_halfedges<FaceListGraph> halfedges;
};

// Only plain numbers are read in parallel: copies of others may share parts.
template <class ConcurrencyTag, class VertexList, class ScalarMap, class Traits>
Large_vector<typename Traits::Scalar> read_values(const VertexList& vertices,
                                                  const ScalarMap& scalar_map,
                                                  const Traits& traits)
{
  typedef typename Traits::Scalar Scalar;
  typedef std::conditional_t<std::is_arithmetic_v<Scalar>, ConcurrencyTag, Sequential_tag> Tag;
  const auto is_ordered = traits.is_ordered_object();
  Large_vector<Scalar> values;
  values.resize(vertices.size());
  Shared_counter<Tag> number_of_unordered;
  for_each_block<Tag>(vertices.size(), [&](std::size_t begin, std::size_t end) {
    std::size_t unordered = 0;
    for(std::size_t v = begin; v != end; ++v)
    {
      values[v] = get(scalar_map, vertices[v]);
      unordered += is_ordered(values[v]) ? 0 : 1;
    }
    number_of_unordered.add(unordered);
  });
  if(number_of_unordered.get() != 0)
    throw Unordered_scalar_error(
      static_cast<std::size_t>(std::find_if_not(values.begin(), values.end(), is_ordered) - values.begin()));
  return values;
}

template <class ConcurrencyTag, class FaceListGraph, class ScalarMap, class Traits, class NamedParameters>
Flat_surface<FaceListGraph, typename Traits::Scalar> flatten(const FaceListGraph& mesh,
                                                             const ScalarMap& scalar_map,
                                                             const Traits& traits,
                                                             const NamedParameters& np)
{
  typedef typename boost::graph_traits<FaceListGraph>::vertex_descriptor vertex_descriptor;
  Descriptor_list<FaceListGraph, vertex_descriptor> vertex_list(mesh, CGAL::make_range(vertices(mesh)));
  checked_index(vertex_list.size());
  auto values = read_values<ConcurrencyTag>(vertex_list, scalar_map, traits);
  auto read = read_halfedges<ConcurrencyTag>(mesh, vertex_list, make_vertex_positions(mesh, vertex_list, np), np);
  return {Triangle_complex(ConcurrencyTag(), std::move(read.arrays)), std::move(values), std::move(vertex_list),
          std::move(read.numbered_halfedges)};
}

} // namespace internal
} // namespace Reeb_graph
} // namespace CGAL

#endif // CGAL_REEB_GRAPH_INTERNAL_FLATTEN_H
