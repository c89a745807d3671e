// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
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

namespace CGAL::Reeb_graph {

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

/// \brief thrown for a face that has not exactly three vertices.
class Non_triangular_face_error : public Face_error
{
public:
  /// constructs the exception for the face at position `face`.
  explicit Non_triangular_face_error(std::size_t face) : Face_error(face, message("face ", face, " is not a triangle"))
  {}
};

/// \brief thrown for a triangle that has the same vertex at two of its corners.
class Degenerate_face_error : public Face_error
{
public:
  /// constructs the exception for the face at position `face`.
  explicit Degenerate_face_error(std::size_t face)
    : Face_error(face, message("face ", face, " has one vertex at two of its corners"))
  {}
};

/// \brief thrown for a 3-cell that is not a tetrahedron with four different vertices.
class Non_tetrahedral_cell_error : public Error
{
public:
  /// constructs the exception for the 3-cell at position `cell`.
  explicit Non_tetrahedral_cell_error(std::size_t cell)
    : Error(message("3-cell ", cell, " is not a tetrahedron with four vertices")),
      cell_(cell)
  {}

  /// the position of the 3-cell among those of its data structure.
  std::size_t cell() const { return cell_; }

private:
  std::size_t cell_;
};

/// \brief thrown for an edge that is on no face.
class Edge_without_face_error : public Error
{
public:
  /// constructs the exception for the edge at position `edge`.
  explicit Edge_without_face_error(std::size_t edge) : Error(message("edge ", edge, " is on no face")), edge_(edge) {}

  /// the position of the edge in `edges(mesh)`.
  std::size_t edge() const { return edge_; }

private:
  std::size_t edge_;
};

/// \brief thrown for a vertex whose faces form more than one fan.
class Non_manifold_vertex_error : public Vertex_error
{
public:
  /// constructs the exception for the vertex at position `vertex`.
  explicit Non_manifold_vertex_error(std::size_t vertex)
    : Vertex_error(vertex, message("vertex ", vertex, " is not manifold: its faces form more than one fan"))
  {}
};

/// \brief thrown for a vertex that does not belong to the mesh.
class Unknown_vertex_error : public Error
{
public:
  Unknown_vertex_error() : Error("the vertex is not one of the mesh") {} ///< constructs the exception.
};

/// \brief thrown for a scalar value that the order does not place, such as NaN, and where the order is found to
/// contradict itself.
class Unordered_scalar_error : public Vertex_error
{
public:
  /// constructs the exception for the vertex at position `vertex`, whose value is not placed.
  explicit Unordered_scalar_error(std::size_t vertex)
    : Vertex_error(vertex, message("the scalar value of vertex ", vertex, " is not a number (NaN)"))
  {}

  /// returns the exception for an order that is none, which has shown near the vertex at position `vertex`.
  static Unordered_scalar_error contradiction_near(std::size_t vertex)
  {
    return Unordered_scalar_error(vertex, message("the order of the scalar values contradicts itself near vertex ",
                                                  vertex, ": it is not a strict weak order"));
  }

private:
  Unordered_scalar_error(std::size_t vertex, const std::string& message) : Vertex_error(vertex, message) {}
};

/// \brief thrown for a scalar value or result that is infinite or NaN, by scalar fields, and where a field parametrizes
/// arcs.
class Non_finite_scalar_error : public Vertex_error
{
public:
  /// constructs the exception for the vertex at position `vertex`.
  explicit Non_finite_scalar_error(std::size_t vertex)
    : Vertex_error(vertex, message("the scalar value of vertex ", vertex, " is not finite"))
  {}
};

/// \brief thrown by scalar fields and handles for a point with a coordinate that is infinite or NaN.
class Non_finite_point_error : public Vertex_error
{
public:
  /// constructs the exception for the vertex at position `vertex`.
  explicit Non_finite_point_error(std::size_t vertex)
    : Vertex_error(vertex, message("the point of vertex ", vertex, " is not finite"))
  {}
};

/// \brief thrown for a range of scalar values that is not as long as the range of vertices.
class Scalar_count_error : public Error
{
public:
  /// constructs the exception from the two lengths.
  Scalar_count_error(std::size_t scalars, std::size_t vertices)
    : Error(std::to_string(scalars) + " scalar values given for " + std::to_string(vertices) + " vertices")
  {}
};

/// \brief thrown for an index map that does not number vertices, edges or faces one to one by non-negative integers
/// less than 2<sup>32</sup> - 1.
class Invalid_index_map_error : public Error
{
public:
  /// constructs the exception for an index map over `simplices` (`"vertices"`, `"edges"` or `"faces"`).
  explicit Invalid_index_map_error(const std::string& simplices)
    : Error("the index map of the " + simplices + " is negative, too large, or the same for two of them")
  {}
};

/// \brief thrown for a mesh of more than 2<sup>32</sup> - 2 vertices, halfedges or corners of faces.
class Mesh_size_error : public Error
{
public:
  /// constructs the exception.
  Mesh_size_error() : Error("the mesh has more vertices, halfedges, or corners of faces than 32-bit indices can number")
  {}
};

/// \brief thrown for a graph, a node or an arc that does not belong to the mesh, the scalar map, the graph or the
/// named parameters that it is used with, and for a graph of which an arc does not ascend.
class Graph_mismatch_error : public Error
{
public:
  /// constructs the exception for a graph of another mesh or field.
  Graph_mismatch_error()
    : Graph_mismatch_error("the graph is not the one that these mesh, scalar map and named parameters give")
  {}

  /// constructs the exception with a message.
  explicit Graph_mismatch_error(const std::string& message) : Error(message) {}
};

/// \brief thrown for a number that is out of its range, such as a threshold that is NaN, a level at which an arc has no
/// contour, or a direction that is zero.
class Parameter_error : public Error
{
public:
  /// constructs the exception with a message.
  explicit Parameter_error(const std::string& message) : Error(message) {}
};

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

/// \brief thrown if the named parameter `callback` returns `false`.
class Cancelled_error : public Error
{
public:
  Cancelled_error() : Error("the computation has been cancelled") {} ///< constructs the exception.
};

/// \brief thrown if there is not one number of an attribute for each arc, vertex, or face.
class Attribute_count_error : public Error
{
public:
  /// constructs the exception from the name of the attribute, and how many numbers there are and should be.
  Attribute_count_error(const std::string& name, std::size_t given, std::size_t needed)
    : Error("the attribute " + name + " has " + std::to_string(given) + " numbers instead of " + std::to_string(needed))
  {}
};

/// \brief thrown for a file that cannot be read or written, or that has no graph of the mesh.
class File_error : public Error
{
public:
  /// constructs the error with a message.
  explicit File_error(const std::string& message) : Error(message) {}
};

/// @}

/// \ingroup PkgReebGraphExceptions
///
/// \brief thrown by `simplify_field()` if it finds no field that has the simplified graph with `Ties::PERTURB`: because
/// of a border or a hidden handle in a removed piece, or for want of numbers. The message names the way out,
/// `Ties::CONTRACT`.
class Perturbed_ties_error : public Error
{
public:
  /// constructs the exception.
  explicit Perturbed_ties_error(const std::string& reason)
    : Error(reason + "; with ties(Ties::CONTRACT), there always is a simplified field")
  {}

  /// constructs the exception for the vertex at position `vertex`, which there is no number for.
  explicit Perturbed_ties_error(std::size_t vertex)
    : Perturbed_ties_error("there are too few numbers next to a saddle to give vertex " + std::to_string(vertex)
                           + " one")
  {}
};

} // namespace CGAL::Reeb_graph

#endif // CGAL_REEB_GRAPH_EXCEPTIONS_H
