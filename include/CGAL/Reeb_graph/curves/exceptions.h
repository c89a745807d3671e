// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_CURVES_EXCEPTIONS_H
#define CGAL_REEB_GRAPH_CURVES_EXCEPTIONS_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/exceptions.h>

#include <cstddef>
#include <string>

namespace CGAL::Reeb_graph {

/// \addtogroup PkgReebGraphExceptions
/// @{

/// \brief thrown for a border that does not lie in one level, or is neither a minimum nor a maximum of the field.
class Border_level_error : public Vertex_error
{
public:
  /// what is wrong with the border
  enum class Reason
  {
    SEVERAL_VALUES, ///< not all its vertices have the same value
    NOT_EXTREMAL    ///< it has lower neighbors as well as higher ones
  };

  /// constructs the exception for the border component of which `vertex`, a position in `vertices(mesh)`, is the first
  /// vertex.
  Border_level_error(std::size_t vertex, Reason reason)
    : Vertex_error(vertex,
                   "the border component of vertex " + std::to_string(vertex)
                     + (reason == Reason::SEVERAL_VALUES ? " does not lie in one level of the scalar field"
                                                         : " has lower neighbors as well as higher ones")
                     + "; make_borders_level() changes a field so that it does, as the named parameter "
                       "borders(Borders::MAKE_LEVEL) does"),
      reason_(reason)
  {}

  /// what is wrong with the border.
  Reason reason() const { return reason_; }

private:
  Reason reason_;
};

/// \brief thrown for a connected component that has no pants decomposition: a sphere, a disk, an annulus, or a torus.
class No_pants_decomposition_error : public Face_error
{
public:
  /// constructs the exception for the component of which `face`, a position in `faces(mesh)`, is the first face.
  No_pants_decomposition_error(std::size_t face, long euler_characteristic, bool has_border)
    : Face_error(face,
                 "the connected component of face " + std::to_string(face) + " is "
                   + (euler_characteristic == 2   ? "a sphere"
                      : euler_characteristic == 1 ? "a disk"
                      : has_border                ? "an annulus"
                                                  : "a torus")
                   + ", which has no pants decomposition: its Euler characteristic is "
                   + std::to_string(euler_characteristic) + ", and would have to be negative"),
      euler_characteristic_(euler_characteristic)
  {}

  /// the Euler characteristic of the component.
  long euler_characteristic() const { return euler_characteristic_; }

private:
  long euler_characteristic_;
};

/// \brief thrown for a sequence of halfedges that is not a contour of the scalar field.
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

/// \brief thrown for a level that the order does not place, such as NaN.
class Unordered_level_error : public Error
{
public:
  /// constructs the exception for the level at position `level`.
  explicit Unordered_level_error(std::size_t level)
    : Error(message("level ", level, " is not a number (NaN)")),
      level_(level)
  {}

  /// the position of the level in its range.
  std::size_t level() const { return level_; }

private:
  std::size_t level_;
};

/// \brief thrown if the named parameter `face_count_callback` returns `false`.
class Face_count_error : public Error
{
public:
  /// constructs the exception for a cut mesh of `number_of_faces` faces.
  explicit Face_count_error(std::size_t number_of_faces)
    : Error(message("the cut mesh would have ", number_of_faces, " faces: more than are wanted")),
      number_of_faces_(number_of_faces)
  {}

  /// the number of faces that the cut mesh would have.
  std::size_t number_of_faces() const { return number_of_faces_; }

private:
  std::size_t number_of_faces_;
};

/// @}

} // namespace CGAL::Reeb_graph

#endif // CGAL_REEB_GRAPH_CURVES_EXCEPTIONS_H
