// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_HANDLES_HANDLE_LOOP_H
#define CGAL_REEB_GRAPH_HANDLES_HANDLE_LOOP_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/exceptions.h>

#include <array>
#include <cstddef>
#include <limits>
#include <string>
#include <vector>

namespace CGAL::Reeb_graph {

/// \addtogroup PkgReebGraphHandles
/// @{

/// \brief what a loop of a surface is.
enum class Loop_kind
{
  HANDLE, ///< it bounds inside of the surface, and not outside, as a ring around the tube of a torus does
  TUNNEL, ///< it bounds outside of the surface, and not inside, as a ring around the hole of a torus does
  HOLE,   ///< it leads around a hole: a border of the surface
  LOOP ///< it is one of a surface that has no inside, since it has a hole, intersects itself, or has faces without area
};

/// \brief returns `handle`, `tunnel`, `hole`, or `loop`, as files and reports have it.
///
/// \param kind the kind
inline std::string to_string(Loop_kind kind)
{
  switch(kind)
  {
  case Loop_kind::HANDLE: return "handle";
  case Loop_kind::TUNNEL: return "tunnel";
  case Loop_kind::HOLE: return "hole";
  case Loop_kind::LOOP: return "loop";
  }
  return "unknown";
}

/// \brief a loop of a surface, as `handle_and_tunnel_loops()` finds it.
///
/// \tparam HalfedgeDescriptor a halfedge descriptor of the mesh
template <class HalfedgeDescriptor>
struct Handle_loop
{
  /// the partner of a loop that has none
  static constexpr std::size_t no_partner = (std::numeric_limits<std::size_t>::max)();

  /// what it is
  Loop_kind kind = Loop_kind::LOOP;

  /// consecutive halfedges: each starts where the one before ends, the first one where the last one ends
  std::vector<HalfedgeDescriptor> halfedges;

  /// the position of the partner in the list: the only loop there with which it has an intersection number, 1 or -1; of
  /// a hole, `no_partner`
  std::size_t partner = no_partner;

  /// the length
  double length = 0;

  /// the persistence of the loop of the Reeb graph that belongs to it and its partner; 0 if that is hidden in a vertex
  /// of the mesh, and for a hole
  double persistence = 0;

  /// the number of the connected component, in the order of the first vertices
  std::size_t component = 0;

  /// whether it passes no vertex twice; one that is not the only one of its kind can, most of all on a coarse mesh
  bool is_simple = true;
};

/// @}

/// \ingroup PkgReebGraphExceptions
///
/// \brief thrown for a sequence of halfedges that is not a closed walk.
class Open_loop_error : public Error
{
public:
  /// constructs the exception for a halfedge that does not begin where the one before ends.
  explicit Open_loop_error(std::size_t position)
    : Error("halfedge " + std::to_string(position) + " of the loop does not begin where the one before it ends"),
      position_(position)
  {}

  /// the position of the halfedge.
  std::size_t position() const { return position_; }

private:
  std::size_t position_;
};

/// \addtogroup PkgReebGraphHandles
/// @{

/// \brief what has become of a handle that was to be removed.
enum class Removal_result
{
  REMOVED,         ///< the surface has been cut along the loop, and closed by two discs
  CROSSES_ITSELF,  ///< refused: the loop passes a vertex twice
  PASSES_HOLE,     ///< refused: the loop passes a vertex of a border
  NO_DISC,         ///< refused: no disc has been found that fills the loop and meets its component nowhere else
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

#endif // CGAL_REEB_GRAPH_HANDLES_HANDLE_LOOP_H
