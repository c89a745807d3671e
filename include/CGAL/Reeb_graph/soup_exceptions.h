// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of the CGAL-style package Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_SOUP_EXCEPTIONS_H
#define CGAL_REEB_GRAPH_SOUP_EXCEPTIONS_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/exceptions.h>

#include <cstddef>
#include <string>

namespace CGAL {
namespace Reeb_graph {

/// \addtogroup PkgReebGraphExceptions
/// @{

/// \brief thrown for an edge of the named parameter `edges` that has not two different vertices.
class Degenerate_edge_error : public Error
{
public:
  /// constructs the exception for the edge at position `edge`.
  explicit Degenerate_edge_error(std::size_t edge)
    : Error(message("edge ", edge, " has not two different vertices")),
      edge_(edge)
  {}

  /// the position of the edge in the range that was given.
  std::size_t edge() const { return edge_; }

private:
  std::size_t edge_;
};

/// \brief thrown for a triangle, a tetrahedron or an edge with an index of a vertex that there is not.
class Vertex_out_of_range_error : public Error
{
public:
  /// constructs the exception for the item at position `position`, where `name` is `"face"`, `"tetrahedron"` or
  /// `"edge"`.
  Vertex_out_of_range_error(const std::string& name, std::size_t position)
    : Error(name + " " + std::to_string(position) + " has an index of no vertex"),
      position_(position)
  {}

  /// the position of the triangle, tetrahedron or edge in the range that was given.
  std::size_t position() const { return position_; }

private:
  std::size_t position_;
};

/// @}

} // namespace Reeb_graph
} // namespace CGAL

#endif // CGAL_REEB_GRAPH_SOUP_EXCEPTIONS_H
