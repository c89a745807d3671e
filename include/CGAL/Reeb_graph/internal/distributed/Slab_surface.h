// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of the CGAL-style package Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors
#ifndef CGAL_REEB_GRAPH_INTERNAL_DISTRIBUTED_SLAB_SURFACE_H
#define CGAL_REEB_GRAPH_INTERNAL_DISTRIBUTED_SLAB_SURFACE_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/internal/base/Indexed_vector.h>
#include <CGAL/Reeb_graph/internal/mesh/mesh_indices.h>
#include <CGAL/Reeb_graph/internal/slabs/Slab.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace CGAL {
namespace Reeb_graph {
namespace internal {

// The index of a vertex among those of all ranks.
typedef std::uint64_t Global_vertex;

// The slabs as a rank sees them: all that is below its own one, its own one, and all that is above.
struct Slabs_of_rank
{
  static constexpr Slab_index below() { return Slab_index(0); }
  static constexpr Slab_index inside() { return Slab_index(1); }
  static constexpr Slab_index above() { return Slab_index(2); }
};

// The part of the surface that a rank holds: each triangle that meets its slab, also those that only pass it, and each
// vertex of the slab. A level between two slabs crosses only triangles with vertices on both sides of it, and these
// meet both slabs, so both ranks hold all of the level, and find and close its contours alike. A vertex of the slab has
// its whole star here, and any other one any part of it. Rank r has slab r; a rank beyond the slabs has empty arrays.
template <class Scalar>
struct Slab_surface : Slabs_of_rank
{
  bool has_slab() const { return slab < number_of_slabs; }
  bool is_lowest() const { return slab == 0; }
  bool is_highest() const { return slab + 1 == number_of_slabs; }

  Indexed_vector<Vertex_index, Global_vertex> global_vertices; // ascending, so local indices break ties as global ones
  Indexed_vector<Vertex_index, Scalar> values;
  Indexed_vector<Vertex_index, Slab_index> slabs_of_vertices; // below(), inside() or above()
  std::vector<std::array<Vertex_index, 3>> triangles;         // in no order
  std::size_t slab = 0;
  std::size_t number_of_slabs = 1;
  // the values of the levels between the slab and its neighbors, as far as it has any
  std::optional<Scalar> lower_bound, upper_bound;
};

} // namespace internal
} // namespace Reeb_graph
} // namespace CGAL

#endif // CGAL_REEB_GRAPH_INTERNAL_DISTRIBUTED_SLAB_SURFACE_H
