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
/// \brief thrown for an index map that does not number vertices, edges or faces one to one by non-negative integers.
class Invalid_index_map_error : public Error
{
public:
  /// constructs the exception for an index map over `simplices` (`"vertices"`, `"edges"` or `"faces"`).
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
/// \brief thrown for a mesh of more than 2<sup>32</sup> - 2 vertices or halfedges.
class Mesh_size_error : public Error
{
public:
  /// constructs the exception.
  Mesh_size_error() : Error("the mesh has more vertices or halfedges than 32-bit indices can number") {}
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
/// \brief thrown if the named parameter `callback` returns `false`.
class Cancelled_error : public Error
{
public:
  /// constructs the exception.
  Cancelled_error() : Error("the computation has been cancelled") {}
};

/// \ingroup PkgReebGraphExceptions
///
/// \brief thrown by scalar fields for a point with a coordinate that is infinite or NaN.
class Non_finite_point_error : public Error
{
public:
  /// constructs the exception for the vertex at position `vertex`.
  explicit Non_finite_point_error(std::size_t vertex)
    : Error("the point of vertex " + std::to_string(vertex) + " is not finite"),
      vertex_(vertex)
  {}

  /// the position of the vertex in `vertices(mesh)`.
  std::size_t vertex() const { return vertex_; }

private:
  std::size_t vertex_;
};

/// \ingroup PkgReebGraphExceptions
///
/// \brief thrown by scalar fields that depend on angles for a face without area.
class Zero_area_error : public Error
{
public:
  /// constructs the exception for the face at position `face`.
  explicit Zero_area_error(std::size_t face)
    : Error("face " + std::to_string(face) + " has no area, or too little to have angles"),
      face_(face)
  {}

  /// the position of the face in `faces(mesh)`.
  std::size_t face() const { return face_; }

private:
  std::size_t face_;
};

/// \ingroup PkgReebGraphExceptions
///
/// \brief thrown by scalar fields for a scalar value or result that is infinite or NaN.
class Non_finite_scalar_error : public Error
{
public:
  /// constructs the exception for the vertex at position `vertex`.
  explicit Non_finite_scalar_error(std::size_t vertex)
    : Error("the scalar value of vertex " + std::to_string(vertex) + " is not finite"),
      vertex_(vertex)
  {}

  /// the position of the vertex in `vertices(mesh)`.
  std::size_t vertex() const { return vertex_; }

private:
  std::size_t vertex_;
};

/// \ingroup PkgReebGraphExceptions
///
/// \brief thrown by `Reeb_graph::compute_divergence()` for a vector that is infinite or NaN.
class Non_finite_vector_error : public Error
{
public:
  /// constructs the exception for the face at position `face`.
  explicit Non_finite_vector_error(std::size_t face)
    : Error("the vector of face " + std::to_string(face) + " is not finite"),
      face_(face)
  {}

  /// the position of the face in `faces(mesh)`.
  std::size_t face() const { return face_; }

private:
  std::size_t face_;
};

/// \ingroup PkgReebGraphExceptions
///
/// \brief thrown for a vertex that does not belong to the mesh.
class Unknown_vertex_error : public Error
{
public:
  /// constructs the exception.
  Unknown_vertex_error() : Error("the vertex is not one of the mesh") {}
};

/// \ingroup PkgReebGraphExceptions
///
/// \brief thrown for a vertex whose value is fixed to two different values.
class Contradictory_constraints_error : public Error
{
public:
  /// constructs the exception for the vertex at position `vertex`.
  explicit Contradictory_constraints_error(std::size_t vertex)
    : Error("the value of vertex " + std::to_string(vertex) + " is fixed to two different values"),
      vertex_(vertex)
  {}

  /// the position of the vertex in `vertices(mesh)`.
  std::size_t vertex() const { return vertex_; }

private:
  std::size_t vertex_;
};

/// \ingroup PkgReebGraphExceptions
///
/// \brief thrown for a connected component of the mesh without any vertex whose value is fixed, or without a source.
class Unconstrained_component_error : public Error
{
public:
  /// constructs the exception for a component and its first vertex.
  Unconstrained_component_error(std::size_t component, std::size_t vertex)
    : Error("component " + std::to_string(component) + ", that of vertex " + std::to_string(vertex)
            + ", has no vertex whose value is given"),
      component_(component),
      vertex_(vertex)
  {}

  /// the number of the component, from 0, in the order of their first vertices.
  std::size_t component() const { return component_; }
  /// the position in `vertices(mesh)` of the first vertex of the component.
  std::size_t vertex() const { return vertex_; }

private:
  std::size_t component_, vertex_;
};

/// \ingroup PkgReebGraphExceptions
///
/// \brief thrown if the linear solver does not find the solution.
class Linear_solver_error : public Error
{
public:
  /// constructs the exception.
  Linear_solver_error() : Error("the linear solver found no solution") {}
};

/// \ingroup PkgReebGraphExceptions
///
/// \brief thrown if the number type of the field has too few numbers between two fixed values.
class Scalar_resolution_error : public Error
{
public:
  /// constructs the exception for the vertex at position `vertex`.
  explicit Scalar_resolution_error(std::size_t vertex)
    : Error("there are too few numbers between the fixed values to give vertex " + std::to_string(vertex) + " one"),
      vertex_(vertex)
  {}

  /// the position of the vertex in `vertices(mesh)`.
  std::size_t vertex() const { return vertex_; }

private:
  std::size_t vertex_;
};

/// \ingroup PkgReebGraphExceptions
///
/// \brief thrown for a direction that is zero, or not finite.
class Direction_error : public Error
{
public:
  /// constructs the exception.
  Direction_error() : Error("the direction is zero, or not finite") {}
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
