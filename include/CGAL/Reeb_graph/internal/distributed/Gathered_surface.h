// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of the CGAL-style package Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_INTERNAL_DISTRIBUTED_GATHERED_SURFACE_H
#define CGAL_REEB_GRAPH_INTERNAL_DISTRIBUTED_GATHERED_SURFACE_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/exceptions.h>
#include <CGAL/Reeb_graph/internal/base/Index.h>
#include <CGAL/Reeb_graph/internal/base/Indexed_vector.h>
#include <CGAL/Reeb_graph/internal/base/Side.h>
#include <CGAL/Reeb_graph/internal/critical_vertices/Swept_vertices.h>
#include <CGAL/Reeb_graph/internal/critical_vertices/link_sectors.h>
#include <CGAL/Reeb_graph/internal/distributed/Place.h>
#include <CGAL/Reeb_graph/internal/distributed/Slab_block.h>
#include <CGAL/Reeb_graph/internal/distributed/Slab_surface.h>
#include <CGAL/Reeb_graph/internal/mesh/Vertex_order.h>
#include <CGAL/Reeb_graph/internal/mesh/mesh_indices.h>
#include <CGAL/Reeb_graph/internal/slabs/Slab_arc.h>
#include <CGAL/Reeb_graph/internal/walks/ascending_path.h>

#include <algorithm>
#include <cstddef>
#include <functional>
#include <vector>

namespace CGAL {
namespace Reeb_graph {
namespace internal {

// The critical vertices and the arcs between them, of all ranks, as rank 0 takes them where a whole surface has been
// before: a surface without triangles, of the critical vertices and the ends of the first steps from them, where each
// arc has one halfedge, its first step.
template <class Scalar>
class Gathered_surface
{
public:
  Gathered_surface(const std::vector<Place<Scalar>>& critical_vertices, const std::vector<Critical_arc<Scalar>>& arcs)
  {
    collect_vertices(critical_vertices, arcs);
    first_vertices_.reserve(arcs.size());
    arcs_.reserve(arcs.size());
    for(const Critical_arc<Scalar>& arc : arcs)
    {
      const Halfedge_index first_step(first_vertices_.size());
      first_vertices_.push_back(vertex(critical_vertices[arc.lower].vertex));
      arcs_.push_back({Slab_node(arc.lower), Slab_node(arc.upper), {first_step, vertex(arc.first_target)}});
    }
    sort_critical_vertices(critical_vertices);
  }

  const Indexed_vector<Vertex_index, Global_vertex>& global_vertices() const { return global_vertices_; }
  const Indexed_vector<Vertex_index, Scalar>& values() const { return values_; }
  Vertex_order<Scalar, std::less<Scalar>> order() const { return {values_, std::less<Scalar>()}; }
  const Swept_vertices& critical_vertices() const { return critical_vertices_; }
  const Slab_arcs& arcs() const { return arcs_; }

  // What is asked of a complex here.
  Vertex_index source(Halfedge_index first_step) const { return first_vertices_[first_step]; }
  Vertex_index target(Halfedge_index first_step) const
  {
    return arcs_[Slab_arc_index(first_step.number())].first_step.target;
  }
  bool is_on_border(Vertex_index) const { return false; }
  [[noreturn]] void throw_contradiction_near(Vertex_index vertex) const
  {
    throw Unordered_scalar_error::contradiction_near(static_cast<std::size_t>(global_vertices_[vertex]));
  }

private:
  // The sectors of the critical vertices stay on their ranks: they have made the arcs.
  struct No_sectors
  {
    void write(Vertex_index, const By_side<Link_sector*>&) const {}
  };

  void collect_vertices(const std::vector<Place<Scalar>>& critical_vertices,
                        const std::vector<Critical_arc<Scalar>>& arcs)
  {
    std::vector<Place<Scalar>> all;
    all.reserve(critical_vertices.size() + arcs.size());
    all = critical_vertices;
    for(const Critical_arc<Scalar>& arc : arcs)
      all.push_back({arc.value_of_first_target, arc.first_target});
    const auto is_before = [](const auto& a, const auto& b) { return a.vertex < b.vertex; };
    const auto is_same = [](const auto& a, const auto& b) { return a.vertex == b.vertex; };
    std::sort(all.begin(), all.end(), is_before);
    all.erase(std::unique(all.begin(), all.end(), is_same), all.end());
    global_vertices_.reserve(checked_index(all.size()));
    values_.reserve(all.size());
    for(const Place<Scalar>& v : all)
    {
      global_vertices_.push_back(v.vertex);
      values_.push_back(v.value);
    }
  }

  Vertex_index vertex(Global_vertex global) const
  {
    const auto place = std::lower_bound(global_vertices_.begin(), global_vertices_.end(), global);
    return Vertex_index(static_cast<std::size_t>(place - global_vertices_.begin()));
  }

  void sort_critical_vertices(const std::vector<Place<Scalar>>& critical_vertices)
  {
    critical_vertices_.resize(critical_vertices.size(), {0, 0});
    No_sectors no_sectors;
    for(const Swept_index i : critical_vertices_.indices())
      critical_vertices_.set(i, *this, vertex(critical_vertices[i.number()].vertex), no_sectors, {0, 0});
    critical_vertices_.template sort<Sequential_tag>(order());
  }

  Indexed_vector<Vertex_index, Global_vertex> global_vertices_; // ascending, so local indices break ties as global ones
  Indexed_vector<Vertex_index, Scalar> values_;
  Indexed_vector<Halfedge_index, Vertex_index> first_vertices_; // by first step
  Swept_vertices critical_vertices_;                            // numbered slab by slab
  Slab_arcs arcs_;
};

} // namespace internal
} // namespace Reeb_graph
} // namespace CGAL

#endif // CGAL_REEB_GRAPH_INTERNAL_DISTRIBUTED_GATHERED_SURFACE_H
