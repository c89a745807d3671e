// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of the CGAL-style package Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_ERROR_H
#define CGAL_REEB_GRAPH_ERROR_H

#include <CGAL/license/Reeb_graph.h>

#include <cstddef>
#include <stdexcept>
#include <string>

namespace CGAL {
namespace Reeb_graph {

/// \addtogroup PkgReebGraphExceptions
/// @{

/// \brief base of all exceptions that the package throws.
///
/// They are thrown whatever the build type: checking the input does not depend on `NDEBUG`.
/// Faces, edges and vertices are named by their position in `faces(mesh)`, `edges(mesh)` and `vertices(mesh)`, from 0.
class Error : public std::runtime_error
{
public:
  /// constructs the exception from a message.
  explicit Error(const std::string& message) : std::runtime_error(message) {}

protected:
  /// \cond
  // Composed in one place, as each constructor that does it takes as long to compile as a stage of the computation.
  static std::string message(const char* before, std::size_t number, const char* behind)
  {
    return before + std::to_string(number) + behind;
  }
  /// \endcond
};

/// \brief base of the exceptions that name a vertex.
class Vertex_error : public Error
{
public:
  /// the position of the vertex in `vertices(mesh)`.
  std::size_t vertex() const { return vertex_; }

protected:
  /// constructs the exception for the vertex at position `vertex`.
  Vertex_error(std::size_t vertex, const std::string& message) : Error(message), vertex_(vertex) {}

private:
  std::size_t vertex_;
};

/// \brief base of the exceptions that name a face.
class Face_error : public Error
{
public:
  /// the position of the face in `faces(mesh)`.
  std::size_t face() const { return face_; }

protected:
  /// constructs the exception for the face at position `face`.
  Face_error(std::size_t face, const std::string& message) : Error(message), face_(face) {}

private:
  std::size_t face_;
};

/// @}

} // namespace Reeb_graph
} // namespace CGAL

#endif // CGAL_REEB_GRAPH_ERROR_H
