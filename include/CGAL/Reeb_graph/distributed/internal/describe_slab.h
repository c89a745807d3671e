// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of the CGAL-style package Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_DISTRIBUTED_INTERNAL_DESCRIBE_SLAB_H
#define CGAL_REEB_GRAPH_DISTRIBUTED_INTERNAL_DESCRIBE_SLAB_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/distributed/Distributed_slab.h>
#include <CGAL/Reeb_graph/distributed/internal/Chain_parts.h>
#include <CGAL/Reeb_graph/distributed/internal/Slab_surface.h>
#include <CGAL/Reeb_graph/distributed/internal/distribute_surface.h>
#include <CGAL/Reeb_graph/distributed/internal/exchange.h>
#include <CGAL/Reeb_graph/distributed/internal/pass_arrays.h>
#include <CGAL/Reeb_graph/internal/base/Index.h>
#include <CGAL/Reeb_graph/internal/base/arrays.h>
#include <CGAL/Reeb_graph/internal/base/union_find.h>
#include <CGAL/Reeb_graph/internal/engine/Slab.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <tuple>
#include <vector>

namespace CGAL::Reeb_graph::internal {

struct Border_counts
{
  std::uint64_t edges = 0;
  std::uint64_t loops = 0;
};

struct Border_path_tag;
typedef Index_of<Border_path_tag> Border_path;

// The parts of the border loops that are in the slab of a rank: paths between its levels, and closed loops.
class Border_paths
{
public:
  template <class Scalar>
  Border_paths(const Slab_complex& complex, const Slab_surface<Scalar>& surface)
  {
    const auto& slabs = surface.slabs_of_vertices;
    Indexed_vector<Border_path, Edge_index> edges;
    for(const Edge_index edge : Index_range<Edge_index>(complex.number_of_edges()))
    {
      const Slab_index a = slabs[complex.source(even_halfedge(edge))], b = slabs[complex.target(even_halfedge(edge))];
      if(!complex.is_on_border_edge(even_halfedge(edge)) || (a == b && a != surface.inside()))
        continue;
      edges.push_back(edge);
      if(a == surface.inside()) // One end of each edge comes first in the order of all vertices.
        ++number_of_edges_;
    }
    join_edges(complex, surface, edges);
  }

  std::uint64_t number_of_edges() const { return number_of_edges_; }
  std::uint64_t number_of_loops() const { return number_of_loops_; }
  Number number_of_paths() const { return number_of_paths_; }

  // The paths that cross a level, in the order of the edges that cross it: the same on both sides.
  const std::vector<Border_path>& paths_across(Side side) const { return paths_across_[side]; }

private:
  template <class Scalar>
  void join_edges(const Slab_complex& complex,
                  const Slab_surface<Scalar>& surface,
                  const Indexed_vector<Border_path, Edge_index>& edges)
  {
    const auto& slabs = surface.slabs_of_vertices;
    Disjoint_sets<Border_path> sets(static_cast<Number>(edges.size()));
    Indexed_vector<Vertex_index, Number> edges_at_vertices(complex.number_of_vertices(), 0); // from 1 on
    Indexed_vector<Border_path, Number> names(edges.size(), no_index);
    for(const Border_path i : edges.keys())
    {
      for(const Halfedge_index halfedge : {even_halfedge(edges[i]), opposite_of(even_halfedge(edges[i]))})
      {
        Number& other = edges_at_vertices[complex.target(halfedge)];
        if(slabs[complex.target(halfedge)] == surface.inside() && other != 0)
          sets.unite(i, Border_path(other - 1));
        other = i.number() + 1;
      }
    }
    for(const Border_path i : edges.keys())
    {
      const Slab_index a = slabs[complex.source(even_halfedge(edges[i]))];
      const Slab_index b = slabs[complex.target(even_halfedge(edges[i]))];
      for(const Side side : both_sides)
      {
        const Slab_index outside = side == Side::LOWER ? surface.below() : surface.above();
        if((a == outside) == (b == outside))
          continue;
        Number& name = names[sets.find(i)];
        name = name == no_index ? number_of_paths_++ : name;
        paths_across_[side].push_back(Border_path(name));
      }
    }
    for(const Border_path i : edges.keys())
      number_of_loops_ += sets.find(i) == i && names[i] == no_index ? 1 : 0;
  }

  std::uint64_t number_of_edges_ = 0;
  std::uint64_t number_of_loops_ = 0; // closed ones
  Number number_of_paths_ = 0;
  By_side<std::vector<Border_path>> paths_across_;
};

// The border edges and loops of the whole surface, on all ranks. Collective.
template <class Scalar>
Border_counts count_borders(Exchange& exchange, const Slab_complex& complex, const Slab_surface<Scalar>& surface)
{
  std::optional<Border_paths> paths;
  exchange.in_agreement([&] { paths.emplace(complex, surface); });
  const auto lower = gather_arrays(exchange, paths->paths_across(Side::LOWER));
  const auto upper = gather_arrays(exchange, paths->paths_across(Side::UPPER));
  const auto first_paths = gather_begins(exchange, paths->number_of_paths());
  std::uint64_t loops_across = 0;
  exchange.in_agreement([&] {
    if(exchange.rank() != 0)
      return;
    Disjoint_sets<Border_path> loops(checked_index(first_paths.back()));
    loops_across = first_paths.back();
    for(std::size_t slab = 0; slab + 1 < surface.number_of_slabs; ++slab)
      for(std::size_t i = 0; i != upper.begins[slab + 1] - upper.begins[slab]; ++i)
      {
        const Border_path below = upper.elements[upper.begins[slab] + i];
        const Border_path above = lower.elements[lower.begins[slab + 1] + i];
        const Border_path root_below = loops.find(Border_path(first_paths[slab] + below.number()));
        const Border_path root_above = loops.find(Border_path(first_paths[slab + 1] + above.number()));
        if(root_below == root_above)
          continue;
        loops.link(root_below, root_above);
        --loops_across;
      }
  });
  Border_counts sum;
  for(const Border_counts& counts :
      exchange.all_gather(Border_counts{paths->number_of_edges(), paths->number_of_loops() + loops_across}))
  {
    sum.edges += counts.edges;
    sum.loops += counts.loops;
  }
  return sum;
}

// The parts of chains for the user: those of each arc in their order.
template <class Scalar>
void describe_chains(const std::vector<Part_of_piece>& parts,
                     const std::vector<Global_vertex>& vertices,
                     Distributed_slab<Scalar>& slab)
{
  std::vector<std::size_t> begins, order;
  std::size_t begin = 0;
  for(const Part_of_piece& part : parts)
  {
    order.push_back(begins.size());
    begins.push_back(begin);
    begin += part.size;
  }
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return std::tie(parts[a].arc, parts[a].piece) < std::tie(parts[b].arc, parts[b].piece);
  });
  slab.chain_vertices = vertices;
  slab.chain_parts.reserve(parts.size());
  for(const std::size_t i : order)
    slab.chain_parts.push_back({parts[i].arc, begins[i], parts[i].size});
}

// Tells the user what the rank holds. Collective.
template <class Scalar, class Complex, class ChainParts>
void describe_slab(Exchange& exchange,
                   const std::shared_ptr<Linked_slab<Scalar, Complex>>& linked_slab,
                   const Distribution_counts& counts,
                   std::size_t number_of_triangles,
                   const ChainParts& parts,
                   bool are_chains_kept,
                   Distributed_slab<Scalar>& slab)
{
  const Slab_surface<Scalar>& surface = linked_slab->surface;
  Distributed_slab<Scalar> result;
  exchange.in_agreement([&] {
    if(are_chains_kept)
      describe_chains(parts.parts(), parts.vertices(), result);
  });
  result.is_surface_kept = slab.is_surface_kept;
  if constexpr(Complex::is_surface)
  {
    if(result.is_surface_kept)
      result.keep(linked_slab);
    const Border_counts borders = count_borders(exchange, linked_slab->classified->complex, surface);
    result.border_edges = borders.edges;
    result.border_loops = borders.loops;
  }
  result.has_slab = surface.has_slab();
  result.lower_bound = surface.lower_bound;
  result.upper_bound = surface.upper_bound;
  result.number_of_slabs = surface.number_of_slabs;
  result.crossings_per_triangle = counts.slabs_per_triangle_if_all;
  result.vertices = counts.vertices;
  result.triangles = number_of_triangles;
  result.copies = counts.copies;
  slab = std::move(result);
}

} // namespace CGAL::Reeb_graph::internal

#endif // CGAL_REEB_GRAPH_DISTRIBUTED_INTERNAL_DESCRIBE_SLAB_H
