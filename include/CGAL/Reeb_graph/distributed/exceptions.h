// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors
#ifndef CGAL_REEB_GRAPH_DISTRIBUTED_EXCEPTIONS_H
#define CGAL_REEB_GRAPH_DISTRIBUTED_EXCEPTIONS_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/exceptions.h>

#include <cstddef>
#include <string>
#include <utility>

namespace CGAL::Reeb_graph {

/// \addtogroup PkgReebGraphExceptions
/// @{

/// \brief thrown for ranges of vertices that are not all indices from 0, each one once.
class Vertex_ranges_error : public Vertex_error
{
public:
  /// constructs the exception for the least index that is in no range, or in two of them.
  explicit Vertex_ranges_error(std::size_t vertex)
    : Vertex_error(vertex, message("vertex ", vertex, " is not in exactly one of the ranges of the ranks"))
  {}
};

/// \brief thrown for a scalar value that no `double` holds: an integer beyond 2<sup>53</sup>, or a `long double`.
class Inexact_scalar_error : public Vertex_error
{
public:
  /// constructs the exception for the vertex of this index.
  explicit Inexact_scalar_error(std::size_t vertex)
    : Vertex_error(vertex,
                   message("the scalar value of vertex ", vertex, " is not one that a double holds, as ranks need it"))
  {}
};

/// \brief thrown for an edge that is on more than two triangles.
class Non_manifold_edge_error : public Error
{
public:
  /// constructs the exception for the edge between two vertices, the lower index first.
  explicit Non_manifold_edge_error(const std::pair<std::size_t, std::size_t>& edge)
    : Error("the edge from vertex " + std::to_string(edge.first) + " to vertex " + std::to_string(edge.second)
            + " is on more than two triangles"),
      edge_(edge)
  {}

  /// the indices of the two vertices of the edge, the lower one first.
  const std::pair<std::size_t, std::size_t>& edge() const { return edge_; }

private:
  std::pair<std::size_t, std::size_t> edge_;
};

/// \brief thrown for an edge at which the orientations of two triangles disagree.
class Inconsistent_orientation_error : public Error
{
public:
  /// constructs the exception for the edge between two vertices, the lower index first.
  explicit Inconsistent_orientation_error(const std::pair<std::size_t, std::size_t>& edge)
    : Error("the two triangles at the edge from vertex " + std::to_string(edge.first) + " to vertex "
            + std::to_string(edge.second) + " are not oriented alike"),
      edge_(edge)
  {}

  /// the indices of the two vertices of the edge, the lower one first.
  const std::pair<std::size_t, std::size_t>& edge() const { return edge_; }

private:
  std::pair<std::size_t, std::size_t> edge_;
};

/// \brief thrown if another rank has thrown an exception that is neither one of the package nor `std::bad_alloc`.
class Other_rank_error : public Error
{
public:
  /// constructs the exception from the number of the rank and the message of its exception.
  Other_rank_error(int rank, const std::string& message)
    : Error("rank " + std::to_string(rank) + ": " + message),
      rank_(rank)
  {}

  /// the rank.
  int rank() const { return rank_; }

private:
  int rank_;
};

/// @}

} // namespace CGAL::Reeb_graph

#endif // CGAL_REEB_GRAPH_DISTRIBUTED_EXCEPTIONS_H
