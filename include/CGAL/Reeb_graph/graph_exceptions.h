// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of the CGAL-style package Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_GRAPH_EXCEPTIONS_H
#define CGAL_REEB_GRAPH_GRAPH_EXCEPTIONS_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/Error.h>

#include <string>

namespace CGAL {
namespace Reeb_graph {

/// \addtogroup PkgReebGraphExceptions
/// @{

/// \brief thrown for a graph that is not the Reeb graph of the mesh and the field that it is used with.
class Graph_mismatch_error : public Error
{
public:
  /// constructs the exception.
  Graph_mismatch_error() : Error("the graph is not the one that these mesh, scalar map and named parameters give") {}
};

/// \brief thrown for an arc descriptor that is none of the graph.
class Unknown_arc_error : public Error
{
public:
  Unknown_arc_error() : Error("the arc is not one of the graph") {} ///< constructs the exception.
};

/// \brief thrown for a node descriptor that is none of the graph.
class Unknown_node_error : public Error
{
public:
  Unknown_node_error() : Error("the node is not one of the graph") {} ///< constructs the exception.
};

/// \brief thrown for a place on an arc that is not between its ends.
class Parameter_error : public Error
{
public:
  /// constructs the exception for the parameter `t`.
  explicit Parameter_error(double t)
    : Error("the place on an arc must be greater than 0 and less than 1, not " + std::to_string(t))
  {}
};

/// \brief thrown for a level at which an arc has no contour.
class Level_error : public Error
{
public:
  Level_error() : Error("the arc has no contour at this level") {} ///< constructs the exception.
};

/// @}

} // namespace Reeb_graph
} // namespace CGAL

#endif // CGAL_REEB_GRAPH_GRAPH_EXCEPTIONS_H
