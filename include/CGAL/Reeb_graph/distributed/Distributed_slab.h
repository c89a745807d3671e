// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of the CGAL-style package Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_DISTRIBUTED_DISTRIBUTED_SLAB_H
#define CGAL_REEB_GRAPH_DISTRIBUTED_DISTRIBUTED_SLAB_H

#include <CGAL/license/Reeb_graph.h>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace CGAL {
namespace Reeb_graph {

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

  /// the parts of chains whose steps begin in the slab of this rank, if chains are not gathered. Those of one arc are in
  /// the order of the chain, and the parts of a rank are before those of higher ranks.
  std::vector<Chain_part> chain_parts;
  std::vector<std::uint64_t> chain_vertices; ///< the vertices of all parts
};

} // namespace Reeb_graph
} // namespace CGAL

#endif // CGAL_REEB_GRAPH_DISTRIBUTED_DISTRIBUTED_SLAB_H
