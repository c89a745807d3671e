// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_DISTRIBUTED_DISTRIBUTED_SLAB_H
#define CGAL_REEB_GRAPH_DISTRIBUTED_DISTRIBUTED_SLAB_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/distributed/internal/solve_slab.h>
#include <CGAL/Reeb_graph/internal/base/Index.h>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL::Reeb_graph {

/// \ingroup PkgReebGraphRef
///
/// \brief what a rank holds after `compute_reeb_graph_distributed()`.
template <class Scalar>
class Distributed_slab
{
public:
  std::size_t number_of_slabs = 1; ///< of all ranks; ranks of a higher number have no slab
  double crossings_per_triangle =
    1; ///< the average number of slabs that a triangle of the sample would meet, were there one per rank
  std::uint64_t vertices = 0;     ///< in the slab of this rank
  std::uint64_t triangles = 0;    ///< that this rank holds
  std::uint64_t copies = 0;       ///< those of these triangles that a lower rank holds as well
  std::uint64_t bytes_sent = 0;   ///< from this rank to other ones
  std::uint64_t border_edges = 0; ///< of the whole surface
  std::uint64_t border_loops = 0; ///< of the whole surface

  /// a part of the chain of an arc: an ascending path of vertices, at least two of them
  struct Chain_part
  {
    std::size_t arc;   ///< the number of the arc in the graph of rank 0
    std::size_t begin; ///< the place of the first vertex in `chain_vertices`
    std::size_t size;  ///< how many vertices follow each other there
  };

  /// the parts of chains whose steps begin in the slab of this rank, if chains are not gathered. Those of one arc are
  /// in the order of the chain, and the parts of a rank are before those of higher ranks.
  std::vector<Chain_part> chain_parts;
  std::vector<std::uint64_t> chain_vertices; ///< the vertices of all parts

  /// whether this rank is to keep its part of the surface for `contours_at_value()`. Set it before the computation.
  bool is_surface_kept = false;

  bool has_slab = false; ///< whether this rank has a slab
  /// the least value whose level this rank has; none if it has the lowest slab
  std::optional<Scalar> lower_bound;
  /// the value from which on levels belong to higher ranks; none if it has the highest slab
  std::optional<Scalar> upper_bound;

  /// a contour: the edges that one connected component of a level set crosses
  struct Contour
  {
    /// `true` if the contour is a closed curve, `false` if it leads from border to border
    bool is_closed;
    /// the crossed edges, from the lower to the higher vertex, in the order in which they follow each other; the higher
    /// side is on the left. Closed contours begin with their least edge, by its lower, then its higher index.
    std::vector<std::pair<std::uint64_t, std::uint64_t>> edges;
  };

  /// returns whether the level just above the last vertex of value at most `value` is one of this rank. Each value has
  /// one rank that has its level.
  bool has_level(const Scalar& value) const
  {
    return has_slab && !(lower_bound && value < *lower_bound) && !(upper_bound && !(value < *upper_bound));
  }

  /// \brief returns the contours of the whole surface at the level just above the last vertex of value at most `value`,
  /// in the order of their least edges.
  ///
  /// There are none if `has_level(value)` is `false`, or the surface has not been kept. It takes time proportional to
  /// the number of triangles that this rank holds.
  std::vector<Contour> contours_at_value(const Scalar& value) const
  {
    std::vector<Contour> contours;
    if(linked_slab_ == nullptr || !has_level(value))
      return contours;
    const auto& complex = linked_slab_->classified->complex;
    const auto is_below = [&](internal::Vertex_index v) {
      return !(value < static_cast<Scalar>(linked_slab_->surface.keys[v]));
    };
    internal::for_each_contour(complex, is_below, [&](const auto& halfedges, bool is_closed) {
      contours.push_back({is_closed, {}});
      contours.back().edges.reserve(halfedges.size());
      for(const internal::Halfedge_index halfedge : halfedges)
        contours.back().edges.emplace_back(complex.position(complex.source(halfedge)),
                                           complex.position(complex.target(halfedge)));
    });
    return contours;
  }

  /// \cond
  void keep(std::shared_ptr<const internal::Linked_slab<>> linked_slab) { linked_slab_ = std::move(linked_slab); }

private:
  std::shared_ptr<const internal::Linked_slab<>> linked_slab_;
  /// \endcond
};

} // namespace CGAL::Reeb_graph

#endif // CGAL_REEB_GRAPH_DISTRIBUTED_DISTRIBUTED_SLAB_H
