// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_HANDLES_HANDLE_REMOVAL_H
#define CGAL_REEB_GRAPH_HANDLES_HANDLE_REMOVAL_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/handles/Handle_loop.h>

#include <array>
#include <cstddef>
#include <string>
#include <vector>

namespace CGAL::Reeb_graph {

/// \addtogroup PkgReebGraphHandles
/// @{

/// \brief what has become of a handle that was to be removed.
enum class Removal_result
{
  REMOVED,        ///< the surface has been cut along the loop, and closed by two discs
  CROSSES_ITSELF, ///< refused: the loop passes a vertex twice
  PASSES_HOLE,    ///< refused: the loop passes a vertex of a border
  NO_DISC, ///< refused: no disc has been found that fills the loop and meets its component nowhere else, or the loop has
           ///< more than 1000 edges
  OTHER_COMPONENT, ///< refused: the discs would meet another component
  INTERSECTS       ///< refused: the surface would intersect itself beside the loop
};

/// \brief returns `removed`, or the reason why not, as reports have it.
///
/// \param result the result
inline std::string to_string(Removal_result result)
{
  switch(result)
  {
  case Removal_result::REMOVED: return "removed";
  case Removal_result::CROSSES_ITSELF: return "the loop crosses itself";
  case Removal_result::PASSES_HOLE: return "the loop passes a hole";
  case Removal_result::NO_DISC: return "the loop bounds no disc";
  case Removal_result::OTHER_COMPONENT: return "another component passes through";
  case Removal_result::INTERSECTS: return "the surface would intersect itself";
  }
  return "unknown";
}

/// \brief a handle that was to be removed: what `remove_handles()` returns.
///
/// \tparam VertexDescriptor that of the mesh
template <class VertexDescriptor>
struct Handle_removal
{
  /// what the loop is along which the surface has been cut, or would have been: the shorter one of its pair
  Loop_kind kind = Loop_kind::LOOP;

  /// the length of that loop
  double length = 0;

  /// the number of the connected component, in the order of the first vertices
  std::size_t component = 0;

  /// whether it has been removed, or why not
  Removal_result result = Removal_result::REMOVED;

  /// the vertices of that loop, in order along it; the first one is not repeated
  std::vector<VertexDescriptor> vertices = {};

  /// where these vertices were before the cut along the loop
  std::vector<std::array<double, 3>> points = {};
};

/// @}

} // namespace CGAL::Reeb_graph

#endif // CGAL_REEB_GRAPH_HANDLES_HANDLE_REMOVAL_H
