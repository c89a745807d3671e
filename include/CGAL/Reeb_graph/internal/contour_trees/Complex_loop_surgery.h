// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of the CGAL-style package Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_INTERNAL_CONTOUR_TREES_COMPLEX_LOOP_SURGERY_H
#define CGAL_REEB_GRAPH_INTERNAL_CONTOUR_TREES_COMPLEX_LOOP_SURGERY_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/internal/base/Index.h>
#include <CGAL/Reeb_graph/internal/base/Indexed_vector.h>
#include <CGAL/Reeb_graph/internal/base/Side.h>
#include <CGAL/Reeb_graph/internal/contour_trees/Loop_surgery.h>
#include <CGAL/Reeb_graph/internal/contour_trees/Merge_tree.h>
#include <CGAL/Reeb_graph/internal/critical_vertices/Swept_vertices.h>
#include <CGAL/Reeb_graph/internal/level_sets/Contour_search.h>
#include <CGAL/Reeb_graph/internal/level_sets/Contours_of_sectors.h>
#include <CGAL/Reeb_graph/internal/mesh/Simplicial_complex.h>
#include <CGAL/Reeb_graph/internal/mesh/mesh_indices.h>
#include <CGAL/Reeb_graph/internal/slabs/Slab.h>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Reeb_graph {
namespace internal {

// The same for any complex. Where several lower sectors are in one sublevel component, it is found for all vertices at
// once which of them are in one contour. Each contour that is cut closes a loop of the graph, so there are at most as
// many cuts as the first Betti number of the complex.
template <class Order>
class Loop_surgery<Simplicial_complex, Order>
{
public:
  Loop_surgery(const Slab<Simplicial_complex>& slab, const Order& order, const Merge_tree& join_tree, const Merge_tree&)
    : order_(order),
      critical_vertices_(slab.critical_vertices()),
      join_tree_(join_tree),
      search_(slab.complex())
  {
    std::vector<Swept_index> vertices;
    for(const Swept_index i : critical_vertices_.ascending())
    {
      if(join_tree.is_class_shared[i])
        vertices.push_back(i);
    }
    contours_ = Contours_of_sectors<Order>(slab.complex(), order, critical_vertices_, vertices)();
  }

  bool can_close_loop(Swept_index critical)
  {
    if(!join_tree_.is_class_shared[critical])
      return false;
    sort_contours(critical);
    for(std::size_t i = 1; i < contours_of_vertex_.size(); ++i)
    {
      if(contours_of_vertex_[i].sublevel_class == contours_of_vertex_[i - 1].sublevel_class)
        return true;
    }
    return false;
  }

  template <class Visit>
  void visit_loop_contours(Swept_index critical, const Visit& visit)
  {
    const Vertex_index vertex = critical_vertices_.vertex(critical);
    const auto is_below = [&](Vertex_index u) { return order_(u, vertex); };
    std::vector<Halfedge_index> starts;
    auto end = contours_of_vertex_.begin();
    for(auto begin = end; begin != contours_of_vertex_.end(); begin = end)
    {
      const Slab_node sublevel_class = begin->sublevel_class;
      starts.clear();
      for(; end != contours_of_vertex_.end() && end->sublevel_class == sublevel_class; ++end)
        starts.push_back(critical_vertices_.sector(Side::LOWER, end->sector).edge);
      search_.visit_all_but_one(starts, is_below, [&](const std::vector<Halfedge_index>& crossed_edges) {
        visit(sublevel_class, crossed_edges, false);
      });
    }
  }

private:
  // A lower contour of a vertex, and one sector that it passes.
  struct Lower_contour
  {
    Slab_node sublevel_class;
    Number name;
    Sector_index sector;

    friend bool operator<(const Lower_contour& a, const Lower_contour& b)
    {
      return a.sublevel_class != b.sublevel_class ? a.sublevel_class < b.sublevel_class : a.name < b.name;
    }
    friend bool operator==(const Lower_contour& a, const Lower_contour& b) { return a.name == b.name; }
  };

  // Sorts the lower contours of a vertex by their classes.
  void sort_contours(Swept_index critical)
  {
    contours_of_vertex_.clear();
    for(const Sector_index i : critical_vertices_.sectors(critical, Side::LOWER))
      contours_of_vertex_.push_back({join_tree_.classes[i], contours_[i], i});
    std::sort(contours_of_vertex_.begin(), contours_of_vertex_.end());
    contours_of_vertex_.erase(std::unique(contours_of_vertex_.begin(), contours_of_vertex_.end()),
                              contours_of_vertex_.end());
  }

  const Order& order_;
  const Swept_vertices& critical_vertices_;
  const Merge_tree& join_tree_;
  Contour_search search_;
  Indexed_vector<Sector_index, Number> contours_; // by lower sector
  std::vector<Lower_contour> contours_of_vertex_; // of the last one
};

} // namespace internal
} // namespace Reeb_graph
} // namespace CGAL

#endif // CGAL_REEB_GRAPH_INTERNAL_CONTOUR_TREES_COMPLEX_LOOP_SURGERY_H
