// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of the CGAL-style package Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_EXCEPTIONS_H
#define CGAL_REEB_GRAPH_EXCEPTIONS_H

#include <CGAL/license/Reeb_graph.h>

#include <cstddef>
#include <stdexcept>
#include <string>

namespace CGAL {
namespace Reeb_graph {

/// \ingroup PkgReebGraphExceptions
///
/// \brief base of all exceptions that the package throws.
///
/// They are thrown whatever the build type: checking the input does not depend on `NDEBUG`.
/// Faces and vertices are named by their position in `faces(mesh)` and `vertices(mesh)`, from 0.
class Error : public std::runtime_error
{
public:
  /// constructs the exception from a message.
  explicit Error(const std::string& message) : std::runtime_error(message) {}
};

/// \ingroup PkgReebGraphExceptions
///
/// \brief thrown for a face that has not exactly three vertices.
class Non_triangular_face_error : public Error
{
public:
  /// constructs the exception for the face at position `face`.
  explicit Non_triangular_face_error(std::size_t face)
    : Error("face " + std::to_string(face) + " is not a triangle"),
      face_(face)
  {}

  /// the position of the face in `faces(mesh)`.
  std::size_t face() const { return face_; }

private:
  std::size_t face_;
};

/// \ingroup PkgReebGraphExceptions
///
/// \brief thrown for a triangle that has the same vertex at two of its corners.
class Degenerate_face_error : public Error
{
public:
  /// constructs the exception for the face at position `face`.
  explicit Degenerate_face_error(std::size_t face)
    : Error("face " + std::to_string(face) + " has one vertex at two of its corners"),
      face_(face)
  {}

  /// the position of the face in `faces(mesh)`.
  std::size_t face() const { return face_; }

private:
  std::size_t face_;
};

/// \ingroup PkgReebGraphExceptions
///
/// \brief thrown for a vertex whose faces form more than one fan.
class Non_manifold_vertex_error : public Error
{
public:
  /// constructs the exception for the vertex at position `vertex`.
  explicit Non_manifold_vertex_error(std::size_t vertex)
    : Error("vertex " + std::to_string(vertex) + " is not manifold: its faces form more than one fan"),
      vertex_(vertex)
  {}

  /// the position of the vertex in `vertices(mesh)`.
  std::size_t vertex() const { return vertex_; }

private:
  std::size_t vertex_;
};

/// \ingroup PkgReebGraphExceptions
///
/// \brief thrown for a scalar value that the order does not place, such as NaN.
class Unordered_scalar_error : public Error
{
public:
  /// constructs the exception for the vertex at position `vertex`.
  explicit Unordered_scalar_error(std::size_t vertex)
    : Error("the scalar value of vertex " + std::to_string(vertex) + " is not a number (NaN)"),
      vertex_(vertex)
  {}

  /// the position of the vertex in `vertices(mesh)`.
  std::size_t vertex() const { return vertex_; }

private:
  std::size_t vertex_;
};

/// \ingroup PkgReebGraphExceptions
///
/// \brief thrown for an index map that does not number vertices or faces one to one by non-negative integers.
class Invalid_index_map_error : public Error
{
public:
  /// constructs the exception for an index map over `simplices` (`"vertices"` or `"faces"`).
  explicit Invalid_index_map_error(const std::string& simplices)
    : Error("the index map of the " + simplices + " is negative, or the same for two of them")
  {}
};

/// \ingroup PkgReebGraphExceptions
///
/// \brief thrown for a range of scalar values that is not as long as the range of vertices.
class Scalar_count_error : public Error
{
public:
  /// constructs the exception from the two lengths.
  Scalar_count_error(std::size_t scalars, std::size_t vertices)
    : Error(std::to_string(scalars) + " scalar values given for " + std::to_string(vertices) + " vertices")
  {}
};

/// \ingroup PkgReebGraphExceptions
///
/// \brief thrown for a mesh of more than 2<sup>32</sup> - 2 vertices or face corners.
class Mesh_size_error : public Error
{
public:
  /// constructs the exception.
  Mesh_size_error() : Error("the mesh has more vertices or face corners than 32-bit indices can number") {}
};

/// \ingroup PkgReebGraphExceptions
///
/// \brief thrown for a graph that is not the Reeb graph of the mesh and the field that it is used with.
class Graph_mismatch_error : public Error
{
public:
  /// constructs the exception.
  Graph_mismatch_error() : Error("the graph is not the one that these mesh, scalar map and named parameters give") {}
};

/// \ingroup PkgReebGraphExceptions
///
/// \brief thrown for an arc descriptor that is none of the graph.
class Unknown_arc_error : public Error
{
public:
  /// constructs the exception.
  Unknown_arc_error() : Error("the arc is not one of the graph") {}
};

/// \ingroup PkgReebGraphExceptions
///
/// \brief thrown for a node descriptor that is none of the graph.
class Unknown_node_error : public Error
{
public:
  /// constructs the exception.
  Unknown_node_error() : Error("the node is not one of the graph") {}
};

/// \ingroup PkgReebGraphExceptions
///
/// \brief thrown for a place on an arc that is not between its ends.
class Parameter_error : public Error
{
public:
  /// constructs the exception for the parameter `t`.
  explicit Parameter_error(double t) : Error("the place on an arc must be between 0 and 1, not " + std::to_string(t)) {}
};

/// \ingroup PkgReebGraphExceptions
///
/// \brief thrown for a level at which an arc has no contour.
class Level_error : public Error
{
public:
  /// constructs the exception.
  Level_error() : Error("the arc has no contour at this level") {}
};

/// \ingroup PkgReebGraphExceptions
///
/// \brief thrown for a border that does not lie in one level, or is neither a minimum nor a maximum of the field.
class Border_level_error : public Error
{
public:
  /// what is wrong with the border
  enum class Reason
  {
    SEVERAL_VALUES, ///< not all its vertices have the same value
    NOT_EXTREMAL    ///< it has lower neighbors as well as higher ones
  };

  /// constructs the exception for the border component that `vertex`, a position in `vertices(mesh)`, is on.
  Border_level_error(std::size_t vertex, Reason reason)
    : Error("the border component of vertex " + std::to_string(vertex)
            + (reason == Reason::SEVERAL_VALUES ? " does not lie in one level of the scalar field"
                                                : " has lower neighbors as well as higher ones")),
      vertex_(vertex),
      reason_(reason)
  {}

  /// the position in `vertices(mesh)` of the first vertex of the border component.
  std::size_t vertex() const { return vertex_; }

  /// what is wrong with it.
  Reason reason() const { return reason_; }

private:
  std::size_t vertex_;
  Reason reason_;
};

/// \ingroup PkgReebGraphExceptions
///
/// \brief thrown for a connected component that has no pants decomposition: a sphere, a disk, an annulus, or a torus.
class No_pants_decomposition_error : public Error
{
public:
  /// constructs the exception for the component of `face`, a position in `faces(mesh)`.
  No_pants_decomposition_error(std::size_t face, long euler_characteristic, bool has_border)
    : Error("the connected component of face " + std::to_string(face) + " is "
            + (euler_characteristic == 2   ? "a sphere"
               : euler_characteristic == 1 ? "a disk"
               : has_border                ? "an annulus"
                                           : "a torus")
            + ", which has no pants decomposition: its Euler characteristic is " + std::to_string(euler_characteristic)
            + ", and would have to be negative"),
      face_(face),
      euler_characteristic_(euler_characteristic)
  {}

  /// the position in `faces(mesh)` of the first face of the component.
  std::size_t face() const { return face_; }

  /// the Euler characteristic of the component.
  long euler_characteristic() const { return euler_characteristic_; }

private:
  std::size_t face_;
  long euler_characteristic_;
};

/// \ingroup PkgReebGraphExceptions
///
/// \brief thrown for a sequence of halfedges that is no contour of the scalar field.
class Invalid_contour_error : public Error
{
public:
  /// constructs the exception for the contour at position `contour`.
  explicit Invalid_contour_error(std::size_t contour)
    : Error("contour " + std::to_string(contour) + " is not one of this mesh and scalar field"),
      contour_(contour)
  {}

  /// the position of the contour in its range.
  std::size_t contour() const { return contour_; }

private:
  std::size_t contour_;
};

} // namespace Reeb_graph
} // namespace CGAL

#endif // CGAL_REEB_GRAPH_EXCEPTIONS_H
