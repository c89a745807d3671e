// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_DISTRIBUTED_INTERNAL_GATHERED_SURFACE_H
#define CGAL_REEB_GRAPH_DISTRIBUTED_INTERNAL_GATHERED_SURFACE_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/distributed/internal/Slab_surface.h>
#include <CGAL/Reeb_graph/distributed/internal/exchange.h>
#include <CGAL/Reeb_graph/distributed/internal/solve_slab.h>
#include <CGAL/Reeb_graph/exceptions.h>
#include <CGAL/Reeb_graph/internal/base/Index.h>
#include <CGAL/Reeb_graph/internal/base/arrays.h>
#include <CGAL/Reeb_graph/internal/complex/Vertex_order.h>
#include <CGAL/Reeb_graph/internal/engine/Between_stages.h>
#include <CGAL/Reeb_graph/options.h>

#include <algorithm>
#include <cstddef>
#include <functional>
#include <numeric>
#include <utility>
#include <vector>

namespace CGAL::Reeb_graph::internal {

// An arc that begins at a critical vertex, as all ranks know it, and the first step of its chain. Critical vertices are
// numbered in ascending order.
template <class Scalar>
struct Critical_arc
{
  Index lower;
  Index upper; // a critical vertex; of an open arc, a contour of the highest level of its block
  Long_index first_target;
  Scalar value_of_first_target;
};

// Where a contour of the lowest level of a block leads to: a critical vertex, or a contour of its highest level.
struct Upper_end
{
  Index number;
  Index is_contour;
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
             const Indexed_vector<Swept_index, Index>& names)
    : ends_of_contours_(found.numbers_of_contours[Side::LOWER])
  {
    const Tree_node first_contour(names.size());
    const Tree_node first_upper_contour(first_contour.number() + found.numbers_of_contours[Side::LOWER]);
    for(const Swept_arc& arc : found.arcs)
    {
      const bool is_open = arc.upper >= first_contour;
      const Index upper = is_open ? arc.upper.number() - first_upper_contour.number() : names[arc.upper_vertex()];
      if(arc.lower >= first_contour)
      {
        ends_of_contours_[arc.lower.number() - first_contour.number()] = {upper, is_open ? Index(1) : Index(0)};
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

// The total order of vertices that are not numbered as on the surface: by value, then by global index.
template <class Scalar>
class Gathered_order : public Vertex_order<Scalar, std::less<Scalar>>
{
  typedef Vertex_order<Scalar, std::less<Scalar>> Base;

public:
  Gathered_order(const Indexed_vector<Vertex_index, Scalar>& values,
                 const Indexed_vector<Vertex_index, Long_index>& global_vertices)
    : Base(values, std::less<Scalar>()),
      values_(&values),
      global_vertices_(&global_vertices)
  {}

  using Base::operator();
  bool operator()(Vertex_index u, Vertex_index v) const { return place(u) < place(v); }

private:
  Order_key<Scalar> place(Vertex_index v) const { return {(*values_)[v], (*global_vertices_)[v]}; }

  const Indexed_vector<Vertex_index, Scalar>* values_;
  const Indexed_vector<Vertex_index, Long_index>* global_vertices_;
};

// The critical vertices and the arcs between them, of all ranks, as rank 0 takes them where a whole surface has been
// before: a surface without triangles, of the critical vertices and the ends of the first steps from them, where each
// arc has one halfedge, its first step.
template <class Scalar>
class Gathered_surface
{
public:
  // The critical vertices have to be in ascending order.
  Gathered_surface(const std::vector<Order_key<Scalar>>& critical_vertices,
                   const std::vector<Critical_arc<Scalar>>& arcs,
                   Ties ties)
  {
    values_.reserve(critical_vertices.size() + arcs.size());
    global_vertices_.reserve(values_.capacity());
    for(const Order_key<Scalar>& place : critical_vertices)
      add_vertex(place);
    add_first_targets(arcs, ties);
    critical_vertices_.resize(critical_vertices.size(), {0, 0});
    for(const Swept_index i :
        critical_vertices_.indices()) // Their sectors stay on their ranks: they have made the arcs.
      critical_vertices_.set(i, Vertex_index(i.number()), false, false, {0, 0});
    critical_vertices_.template sort<Sequential_tag>(order());
  }

  const Indexed_vector<Vertex_index, Long_index>& global_vertices() const { return global_vertices_; }
  const Indexed_vector<Vertex_index, Scalar>& values() const { return values_; }
  Gathered_order<Scalar> order() const { return {values_, global_vertices_}; }
  const Swept_vertices& critical_vertices() const { return critical_vertices_; }
  const Swept_arcs& arcs() const { return arcs_; }

  // The interface of a complex, as far as it is needed here.
  Vertex_index source(Halfedge_index first_step) const { return Vertex_index(arc(first_step).lower.number()); }
  Vertex_index target(Halfedge_index first_step) const { return arc(first_step).first_step.target; }
  [[noreturn]] void throw_contradiction_near(Vertex_index vertex) const
  {
    throw Unordered_scalar_error::contradiction_near(static_cast<std::size_t>(global_vertices_[vertex]));
  }

private:
  const Swept_arc& arc(Halfedge_index first_step) const { return arcs_[Swept_arc_index(first_step.number())]; }

  void add_vertex(const Order_key<Scalar>& place)
  {
    checked_index(values_.size());
    values_.push_back(place.value);
    global_vertices_.push_back(place.vertex);
  }

  // Where ties are contracted, first steps from several vertices of a plateau can end at one vertex, which gets one
  // number then; otherwise, nobody compares those that do.
  void add_first_targets(const std::vector<Critical_arc<Scalar>>& arcs, Ties ties)
  {
    std::vector<Index> order(checked_index(arcs.size()));
    std::iota(order.begin(), order.end(), Index(0));
    if(ties == Ties::CONTRACT)
      std::sort(order.begin(), order.end(),
                [&](Index a, Index b) { return arcs[a].first_target < arcs[b].first_target; });
    arcs_.resize(arcs.size());
    const Critical_arc<Scalar>* last = nullptr;
    for(const Index i : order)
    {
      if(last == nullptr || last->first_target != arcs[i].first_target)
        add_vertex({arcs[i].value_of_first_target, arcs[i].first_target});
      last = &arcs[i];
      arcs_[Swept_arc_index(i)] = {
        Tree_node(last->lower), Tree_node(last->upper), {Halfedge_index(i), values_.last_key()}};
    }
  }

  Indexed_vector<Vertex_index, Long_index> global_vertices_; // the critical ones, ascending, then others
  Indexed_vector<Vertex_index, Scalar> values_;
  Swept_vertices critical_vertices_;
  Swept_arcs arcs_;
};

} // namespace CGAL::Reeb_graph::internal

#endif // CGAL_REEB_GRAPH_DISTRIBUTED_INTERNAL_GATHERED_SURFACE_H
