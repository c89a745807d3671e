// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of the CGAL-style package Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors
#ifndef CGAL_REEB_GRAPH_INTERNAL_DISTRIBUTED_VERTEX_RANGES_H
#define CGAL_REEB_GRAPH_INTERNAL_DISTRIBUTED_VERTEX_RANGES_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/distributed/exceptions.h>
#include <CGAL/Reeb_graph/internal/distributed/Slab_surface.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Reeb_graph {
namespace internal {

// The vertices that one rank has brought, and knows the values of.
struct Vertex_range
{
  Global_vertex begin;
  Global_vertex end;
  std::size_t rank;
};

// The ranges of all ranks, which together are the indices from 0, each one once. Empty ones are left out.
class Vertex_ranges
{
public:
  explicit Vertex_ranges(std::vector<Vertex_range> ranges) : ranges_(std::move(ranges))
  {
    const auto is_empty = [](const Vertex_range& range) { return range.begin == range.end; };
    ranges_.erase(std::remove_if(ranges_.begin(), ranges_.end(), is_empty), ranges_.end());
    std::sort(ranges_.begin(), ranges_.end(),
              [](const Vertex_range& a, const Vertex_range& b) { return a.begin < b.begin; });
    Global_vertex end = 0;
    for(const Vertex_range& range : ranges_)
    {
      if(range.begin != end)
        throw Vertex_ranges_error(static_cast<std::size_t>((std::min)(range.begin, end)));
      end = range.end;
    }
    number_of_vertices_ = end;
  }

  Global_vertex number_of_vertices() const { return number_of_vertices_; }

  // In ascending order.
  const std::vector<Vertex_range>& ranges() const { return ranges_; }

private:
  std::vector<Vertex_range> ranges_;
  Global_vertex number_of_vertices_;
};

} // namespace internal
} // namespace Reeb_graph
} // namespace CGAL

#endif // CGAL_REEB_GRAPH_INTERNAL_DISTRIBUTED_VERTEX_RANGES_H
