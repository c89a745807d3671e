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

/// \brief base of the exceptions that name a tetrahedron.
class Tetrahedron_error : public Error
{
public:
  /// the position of the tetrahedron in the range that was given.
  std::size_t tetrahedron() const { return tetrahedron_; }

protected:
  /// constructs the exception for the tetrahedron at position `tetrahedron`.
  Tetrahedron_error(std::size_t tetrahedron, const std::string& message) : Error(message), tetrahedron_(tetrahedron) {}

private:
  std::size_t tetrahedron_;
};

/// \brief thrown for a range of vertices that should be a tetrahedron, but has not exactly four of them.
class Non_tetrahedral_cell_error : public Tetrahedron_error
{
public:
  /// constructs the exception for the tetrahedron at position `tetrahedron`.
  explicit Non_tetrahedral_cell_error(std::size_t tetrahedron)
    : Tetrahedron_error(tetrahedron, message("cell ", tetrahedron, " is not a tetrahedron"))
  {}
};

/// \brief thrown for a tetrahedron that has the same vertex at two of its corners.
class Degenerate_tetrahedron_error : public Tetrahedron_error
{
public:
  /// constructs the exception for the tetrahedron at position `tetrahedron`.
  explicit Degenerate_tetrahedron_error(std::size_t tetrahedron)
    : Tetrahedron_error(tetrahedron, message("tetrahedron ", tetrahedron, " has one vertex at two of its corners"))
  {}
};

/// \brief thrown for an edge of the named parameter `edges` that has the same vertex at both ends.
class Degenerate_edge_error : public Error
{
public:
  /// constructs the exception for the edge at position `edge`.
  explicit Degenerate_edge_error(std::size_t edge)
    : Error(message("edge ", edge, " has one vertex at both ends")),
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
