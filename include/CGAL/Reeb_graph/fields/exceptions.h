// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_FIELDS_EXCEPTIONS_H
#define CGAL_REEB_GRAPH_FIELDS_EXCEPTIONS_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/exceptions.h>

#include <cstddef>
#include <string>

namespace CGAL::Reeb_graph {

/// \ingroup PkgReebGraphExceptions
///
/// \brief thrown for a vector of a face that is infinite or NaN, one that is given or a gradient.
class Non_finite_vector_error : public Face_error
{
public:
  /// constructs the exception for the face at position `face`.
  explicit Non_finite_vector_error(std::size_t face)
    : Face_error(face, "the vector of face " + std::to_string(face) + " is not finite")
  {}
};

/// \ingroup PkgReebGraphExceptions
///
/// \brief thrown for a halfedge that has a face, where one of a border cycle is asked for.
class Not_on_border_error : public Error
{
public:
  /// constructs the exception.
  Not_on_border_error() : Error("the halfedge is not on the border, it has a face; its opposite may be meant") {}
};

/// \ingroup PkgReebGraphExceptions
///
/// \brief thrown for a vertex whose value is fixed to two different values.
class Contradictory_constraints_error : public Vertex_error
{
public:
  /// constructs the exception for the vertex at position `vertex`.
  explicit Contradictory_constraints_error(std::size_t vertex)
    : Vertex_error(vertex, "the value of vertex " + std::to_string(vertex) + " is fixed to two different values")
  {}
};

/// \ingroup PkgReebGraphExceptions
///
/// \brief thrown for a connected component of the mesh without any vertex whose value is fixed, or without a source.
class Unconstrained_component_error : public Vertex_error
{
public:
  /// constructs the exception for a component and its first vertex.
  Unconstrained_component_error(std::size_t component, std::size_t vertex)
    : Vertex_error(vertex,
                   "component " + std::to_string(component) + ", that of vertex " + std::to_string(vertex)
                     + ", has no vertex whose value is given"),
      component_(component)
  {}

  /// the number of the component, from 0, in the order of their first vertices.
  std::size_t component() const { return component_; }

private:
  std::size_t component_;
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
/// \brief thrown for a named parameter `solver_tolerance` that is not a positive number.
class Solver_tolerance_error : public Error
{
public:
  /// constructs the exception for a tolerance.
  explicit Solver_tolerance_error(double tolerance)
    : Error("the tolerance of the solver is " + std::to_string(tolerance) + "; it has to be a positive number"),
      tolerance_(tolerance)
  {}

  /// the tolerance.
  double tolerance() const { return tolerance_; }

private:
  double tolerance_;
};

/// \ingroup PkgReebGraphExceptions
///
/// \brief thrown if the number type of the field has too few numbers between two fixed values.
class Scalar_resolution_error : public Vertex_error
{
public:
  /// constructs the exception for the vertex at position `vertex`.
  explicit Scalar_resolution_error(std::size_t vertex)
    : Vertex_error(vertex,
                   "there are too few numbers between the fixed values to give vertex " + std::to_string(vertex)
                     + " one")
  {}
};

/// \ingroup PkgReebGraphFields
///
/// \brief what a scalar field took, mainly on bad triangles: the functions that compute one return it.
///
/// A face is bad if it has no area, or so little that its angles are beyond the range of numbers. If there is one, the
/// geometry is that of edges which are all longer by the same length, the least one that makes every triangle proper.
/// Proper means that any two of its sides are together longer than the third one, by at least a millionth of the mean
/// length of the edges, and 10<sup>-12</sup> of the longest edge. See \cgalCite{sc-lntm-20}, Section 4.5: intrinsic
/// mollification. If there is none, nothing is added, and nothing changes.
struct Field_report
{
  /// the number of bad faces
  std::size_t number_of_bad_faces = 0;
  /// the length that each edge is longer by, in the unit of the points; zero if nothing is added. It is also added if
  /// there are no bad faces, but the equations have no finite solution in floating-point numbers without it.
  double added_length = 0;
  /// the mean length of the edges before, in the unit of the points; zero if nothing is added
  double mean_length = 0;
  /// for harmonic, Poisson and unit gradient fields: the number of steps of the iteration that solves large systems of
  /// equations; zero if the equations were solved directly
  std::size_t number_of_iterations = 0;
};

} // namespace CGAL::Reeb_graph

#endif // CGAL_REEB_GRAPH_FIELDS_EXCEPTIONS_H
