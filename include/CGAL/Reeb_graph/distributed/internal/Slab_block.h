// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of the CGAL-style package Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_DISTRIBUTED_INTERNAL_SLAB_BLOCK_H
#define CGAL_REEB_GRAPH_DISTRIBUTED_INTERNAL_SLAB_BLOCK_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/distributed/internal/Slab_surface.h>
#include <CGAL/Reeb_graph/distributed/internal/exchange.h>
#include <CGAL/Reeb_graph/distributed/internal/pass_arrays.h>
#include <CGAL/Reeb_graph/distributed/internal/solve_slab.h>
#include <CGAL/Reeb_graph/internal/base/Index.h>
#include <CGAL/Reeb_graph/internal/base/arrays.h>
#include <CGAL/Reeb_graph/internal/engine/Slab.h>
#include <CGAL/Reeb_graph/internal/engine/Swept_vertices.h>

#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Reeb_graph {
namespace internal {

// An arc that begins at a critical vertex, as all ranks know it, and the first step of its chain. Critical vertices are
// numbered in ascending order.
template <class Scalar>
struct Critical_arc
{
  Number lower;
  Number upper; // a critical vertex; of an open arc, a contour of the highest level of its block
  Global_vertex first_target;
  Scalar value_of_first_target;
};

// Where a contour of the lowest level of a block leads to: a critical vertex, or a contour of its highest level.
struct Upper_end
{
  Number number;
  Number is_contour;
};

// Adjacent slabs with the arcs between their critical vertices, and what crosses their lowest and their highest level.
template <class Scalar>
class Slab_block
{
public:
  Slab_block() = default;

  // One slab. `names` has the numbers of its critical vertices among those of all slabs.
  Slab_block(const Arcs_of_slab& found,
             const Slab_surface<Scalar>& surface,
             const Indexed_vector<Swept_index, Number>& names)
    : ends_of_contours_(found.numbers_of_contours[Side::LOWER])
  {
    const Slab_node first_contour(names.size());
    const Slab_node first_upper_contour(first_contour.number() + found.numbers_of_contours[Side::LOWER]);
    for(const Slab_arc& arc : found.arcs)
    {
      const bool is_open = arc.upper >= first_contour;
      const Number upper = is_open ? arc.upper.number() - first_upper_contour.number() : names[arc.upper_vertex()];
      if(arc.lower >= first_contour)
      {
        ends_of_contours_[arc.lower.number() - first_contour.number()] = {upper, is_open ? Number(1) : Number(0)};
        continue;
      }
      const Vertex_index target = arc.first_step.target;
      add({names[arc.lower_vertex()], upper, surface.global_vertices[target], surface.values[target]}, is_open);
    }
  }

  // The parts of a block that are needed to put it on top of another one.
  const std::vector<Upper_end>& ends_of_contours() const { return ends_of_contours_; }
  const std::vector<Critical_arc<Scalar>>& open_arcs() const { return open_arcs_; }

  // Glues these parts of another block on top of this one. (The paper, Section 5.3.)
  void put_on_top(const std::vector<Upper_end>& ends_of_contours, std::vector<Critical_arc<Scalar>> open_arcs)
  {
    for(Upper_end& end : ends_of_contours_)
    {
      if(end.is_contour != 0)
        end = ends_of_contours[end.number];
    }
    open_arcs_.swap(open_arcs);
    for(Critical_arc<Scalar>& arc : open_arcs)
    {
      const Upper_end end = ends_of_contours[arc.upper];
      arc.upper = end.number;
      add(arc, end.is_contour != 0);
    }
  }

  // The arcs of which both ends are critical vertices.
  const std::vector<Critical_arc<Scalar>>& arcs() const { return arcs_; }

private:
  void add(const Critical_arc<Scalar>& arc, bool is_open) { (is_open ? open_arcs_ : arcs_).push_back(arc); }

  std::vector<Upper_end> ends_of_contours_; // of the lowest level
  std::vector<Critical_arc<Scalar>> open_arcs_;
  std::vector<Critical_arc<Scalar>> arcs_;
};

// Glues the slabs of the ranks, each rank's block to the one above it, in as many rounds as it takes to double one slab
// to all of them. Afterwards, each arc between critical vertices is in the block of the rank where its last two parts
// have met. Collective.
template <class Scalar>
void glue_slabs(Exchange& exchange, std::size_t number_of_slabs, Slab_block<Scalar>& block)
{
  const std::size_t slab = exchange.rank();
  for(std::size_t size = 1; size < number_of_slabs; size *= 2)
  {
    const bool is_leader = slab % (2 * size) == 0 && slab + size < number_of_slabs;
    const bool is_on_top = slab % (2 * size) == size && slab < number_of_slabs;
    const int to = is_on_top ? static_cast<int>(slab - size) : no_rank;
    const int from = is_leader ? static_cast<int>(slab + size) : no_rank;
    const auto ends_of_contours = pass_array(exchange, block.ends_of_contours(), to, from);
    auto open_arcs = pass_array(exchange, block.open_arcs(), to, from);
    exchange.in_agreement([&] {
      if(is_leader)
        block.put_on_top(ends_of_contours, std::move(open_arcs));
    });
  }
}

} // namespace internal
} // namespace Reeb_graph
} // namespace CGAL

#endif // CGAL_REEB_GRAPH_DISTRIBUTED_INTERNAL_SLAB_BLOCK_H
