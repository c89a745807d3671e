// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_INTERNAL_ENGINE_SLICING_H
#define CGAL_REEB_GRAPH_INTERNAL_ENGINE_SLICING_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/internal/base/Index.h>
#include <CGAL/Reeb_graph/internal/base/arrays.h>
#include <CGAL/Reeb_graph/internal/base/parallel.h>
#include <CGAL/Reeb_graph/internal/engine/Bounding_level.h>
#include <CGAL/Reeb_graph/internal/engine/Slab.h>
#include <CGAL/Reeb_graph/internal/engine/Swept_arcs.h>
#include <CGAL/Reeb_graph/internal/engine/Swept_vertices.h>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::Reeb_graph::internal {

// The partition of the surface into slabs with about the same number of critical vertices, as those make the work.
// There is a bounding level just above the last critical vertex of each slab but the highest. (The paper, Section 5.1.)
template <class Complex>
class Slicing
{
public:
  template <class ConcurrencyTag, class Order>
  Slicing(ConcurrencyTag,
          const Complex& complex,
          const Order& order,
          const Swept_vertices& critical_vertices,
          Number number_of_slabs)
    : complex_(complex),
      critical_vertices_(critical_vertices)
  {
    // The memory that levels may take, in indices: at most a few for each edge, whatever the number of slabs asked for.
    const std::size_t number_of_edges = complex.number_of_edges(),
                      largest_size_of_levels = 8 * number_of_edges + (std::size_t(1) << 20),
                      most_slabs = largest_size_of_levels / (number_of_edges / 16 + 1) + 1;
    number_of_slabs = static_cast<Number>((std::min)(std::size_t(number_of_slabs), most_slabs));
    find_slabs_of_vertices<ConcurrencyTag>(order, number_of_slabs);
    while(number_of_slabs > 2 && size_of_levels<ConcurrencyTag>() > largest_size_of_levels)
    {
      number_of_slabs = (number_of_slabs + 1) / 2;
      find_slabs_of_vertices<ConcurrencyTag>(order, number_of_slabs);
    }
    levels_.assign(number_of_slabs - 1, Bounding_level(complex.number_of_edges()));
    find_crossed_edges<ConcurrencyTag>();
    for_each_index<ConcurrencyTag>(levels_.size(), [&](std::size_t i) {
      levels_[i].find_contours(complex, [&](Vertex_index u) { return slabs_of_vertices_[u] <= Slab_index(i); });
    });
    distribute_critical_vertices();
    for_each_index<ConcurrencyTag>(parts_.size(), [&](std::size_t slab) { fill_part(Slab_index(slab)); });
  }

  const Complex& complex() const { return complex_; }

  Number number_of_slabs() const { return static_cast<Number>(parts_.size()); }

  Slab<Complex> slab(Slab_index index) const
  {
    const std::size_t i = index.number();
    return Slab<Complex>(complex_, parts_[index].critical_vertices, slabs_of_vertices_, index,
                         {i == 0 ? nullptr : &levels_[i - 1], i == levels_.size() ? nullptr : &levels_[i]});
  }

  // The name of a slab's critical vertex among those of the surface.
  Swept_index critical_vertex(Slab_index slab, Swept_index critical) const { return parts_[slab].names[critical]; }

  // The levels, each above the slab of the same number.
  const std::vector<Bounding_level>& levels() const { return levels_; }

private:
  struct Part
  {
    Swept_vertices critical_vertices;
    Indexed_vector<Swept_index, Swept_index> names;
  };

  // The place of a slab's first critical vertex in ascending order.
  std::size_t first_of_slab(std::size_t slab) const { return slab * critical_vertices_.size() / parts_.size(); }

  template <class ConcurrencyTag, class Order>
  void find_slabs_of_vertices(const Order& order, Number number_of_slabs)
  {
    parts_.resize(number_of_slabs);
    Plain_vector<Vertex_index> level_vertices;
    for(std::size_t slab = 1; slab != number_of_slabs; ++slab)
      level_vertices.push_back(critical_vertices_.vertex(critical_vertices_.ascending()[first_of_slab(slab) - 1]));
    slabs_of_vertices_.reset(complex_.number_of_vertices(), Slab_index(0));
    for_each_block<ConcurrencyTag>(slabs_of_vertices_.size(), [&](std::size_t begin, std::size_t end) {
      for(const Vertex_index v : Index_range(Vertex_index(begin), Vertex_index(end)))
      {
        if(!complex_.has_vertex(v))
          continue;
        const auto level = std::partition_point(level_vertices.begin(), level_vertices.end(),
                                                [&](Vertex_index level_vertex) { return order(level_vertex, v); });
        slabs_of_vertices_[v] = Slab_index(static_cast<std::size_t>(level - level_vertices.begin()));
      }
    });
  }

  template <class ConcurrencyTag>
  std::size_t size_of_levels() const
  {
    const auto count = [&](std::size_t begin, std::size_t end, std::size_t& crossings) {
      for(const Edge_index edge : Index_range(Edge_index(begin), Edge_index(end)))
      {
        if(complex_.is_on_triangle(edge))
          crossings += range_of_levels(edge).second - range_of_levels(edge).first;
      }
    };
    return sum_of_parts<ConcurrencyTag, std::size_t>(complex_.number_of_edges(), count)
         + (parts_.size() - 1) * (complex_.number_of_edges() / 16);
  }

  // The first level that the edge crosses, and the one behind the last.
  std::pair<std::size_t, std::size_t> range_of_levels(Edge_index edge) const
  {
    const Halfedge_index halfedge = even_halfedge(edge);
    return std::minmax<std::size_t>(
      {slabs_of_vertices_[complex_.source(halfedge)].number(), slabs_of_vertices_[complex_.target(halfedge)].number()});
  }

  // Finds the crossed edges in one sweep for all levels, in blocks that do not share a word of the sets.
  template <class ConcurrencyTag>
  void find_crossed_edges()
  {
    const std::size_t end_of_edges = complex_.number_of_edges(), word = Index_set<Edge_index>::bits_per_word;
    for_each_block<ConcurrencyTag>(end_of_edges / word + 1, [&](std::size_t begin, std::size_t end) {
      const Edge_index first(begin * word), last((std::min)(end * word, end_of_edges));
      for(const Edge_index edge : Index_range(first, last))
      {
        if(!complex_.is_on_triangle(edge))
          continue;
        const auto range = range_of_levels(edge);
        for(std::size_t level = range.first; level != range.second; ++level)
          levels_[level].add_crossed_edge(edge);
      }
    });
  }

  void distribute_critical_vertices()
  {
    names_in_slabs_.reset(critical_vertices_.size());
    for(const Swept_index i : critical_vertices_.indices())
    {
      Indexed_vector<Swept_index, Swept_index>& names = parts_[slabs_of_vertices_[critical_vertices_.vertex(i)]].names;
      names_in_slabs_[i] = names.end_key();
      names.push_back(i);
    }
  }

  void fill_part(Slab_index slab)
  {
    const auto ascending = critical_vertices_.ascending().begin();
    Plain_vector<Swept_index> ascending_in_slab;
    ascending_in_slab.reserve(parts_[slab].names.size());
    const auto add = [&](Swept_index critical) {
      const Vertex_index vertex = critical_vertices_.vertex(critical);
      if(slabs_of_vertices_[vertex] != slab)
        complex_.throw_contradiction_near(vertex);
      ascending_in_slab.push_back(names_in_slabs_[critical]);
    };
    std::for_each(ascending + first_of_slab(slab.number()), ascending + first_of_slab(slab.number() + 1), add);
    parts_[slab].critical_vertices = critical_vertices_.part(parts_[slab].names, std::move(ascending_in_slab));
  }

  const Complex& complex_;
  const Swept_vertices& critical_vertices_;
  Indexed_vector<Slab_index, Part> parts_;
  std::vector<Bounding_level> levels_;
  Indexed_vector<Vertex_index, Slab_index> slabs_of_vertices_;
  Indexed_vector<Swept_index, Swept_index> names_in_slabs_; // by critical vertex of the surface
};

// Joins the arcs of the slabs where they end and begin at the same contour of a bounding level. An arc of the surface
// can pass any number of slabs. (The paper, Section 5.3.)
template <class Complex>
Swept_arcs glue_slabs(const Slicing<Complex>& slicing,
                      const Indexed_vector<Slab_index, Swept_arcs>& arcs_of_slabs,
                      Number number_of_critical_vertices)
{
  // The surface has the contours of all levels as nodes, behind its critical vertices.
  Plain_vector<Number> first_contours = {number_of_critical_vertices}; // by level
  for(const Bounding_level& level : slicing.levels())
    first_contours.push_back(checked_index(std::size_t(first_contours.back()) + level.number_of_contours()));
  const auto is_contour = [&](Tree_node node) { return node.number() >= number_of_critical_vertices; };
  Indexed_vector<Tree_node, Tree_node> upper_ends(first_contours.back(), no_index); // of arcs from contours

  Swept_arcs arcs;
  for(const Slab_index i : arcs_of_slabs.keys())
  {
    const Slab<Complex> slab = slicing.slab(i);
    const auto node_of_surface = [&](Tree_node node) {
      if(!slab.is_contour(node))
        return node_of(slicing.critical_vertex(i, critical_vertex_of(node)));
      const std::size_t level = slab.side_of_contour(node) == Side::UPPER ? i.number() : i.number() - 1;
      return Tree_node(first_contours[level] + slab.contour_of_node(node).number());
    };
    for(const Swept_arc& arc : arcs_of_slabs[i])
    {
      const Tree_node lower = node_of_surface(arc.lower), upper = node_of_surface(arc.upper);
      if(is_contour(lower))
        upper_ends[lower] = upper;
      else
        arcs.push_back({lower, upper, arc.first_step});
    }
  }
  for(Swept_arc& arc : arcs)
  {
    while(is_contour(arc.upper))
    {
      const Tree_node above = upper_ends[arc.upper];
      if(above == no_index || (is_contour(above) && above <= arc.upper))
        slicing.complex().throw_contradiction_near(arc.first_step.target);
      arc.upper = above;
    }
  }
  return arcs;
}

} // namespace CGAL::Reeb_graph::internal

#endif // CGAL_REEB_GRAPH_INTERNAL_ENGINE_SLICING_H
