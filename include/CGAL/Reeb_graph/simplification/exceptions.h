// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_SIMPLIFICATION_EXCEPTIONS_H
#define CGAL_REEB_GRAPH_SIMPLIFICATION_EXCEPTIONS_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/exceptions.h>

#include <cstddef>
#include <string>

namespace CGAL::Reeb_graph {

/// \ingroup PkgReebGraphExceptions
///
/// \brief thrown for a graph with an arc whose lower node does not have a lower number than its upper node.
class Arc_direction_error : public Error
{
public:
  /// constructs the exception.
  Arc_direction_error() : Error("an arc of the graph does not lead to a node of higher number") {}
};

/// \ingroup PkgReebGraphExceptions
///
/// \brief thrown for a threshold that is negative or NaN.
class Threshold_error : public Error
{
public:
  /// constructs the exception for the threshold `name`.
  explicit Threshold_error(const std::string& name) : Error("the " + name + " is negative or not a number (NaN)") {}
};

/// \ingroup PkgReebGraphExceptions
///
/// \brief thrown for a measure, a weight of a piece, or the number of a value that is NaN.
class Measure_error : public Error
{
public:
  /// constructs the exception for what is not a number, `name`.
  explicit Measure_error(const std::string& name) : Error("the " + name + " is not a number (NaN)") {}
};

/// \ingroup PkgReebGraphExceptions
///
/// \brief thrown if there is not one weight for each node and each arc of a graph.
class Piece_count_error : public Error
{
public:
  /// constructs the exception from the two numbers.
  Piece_count_error(std::size_t weights, std::size_t pieces)
    : Error(std::to_string(weights) + " weights given for " + std::to_string(pieces) + " nodes and arcs")
  {}
};

/// \ingroup PkgReebGraphExceptions
///
/// \brief thrown if `simplify_field()` is asked to cancel loops: a field has those that the surface asks for.
class Loop_cancellation_error : public Error
{
public:
  /// constructs the exception.
  Loop_cancellation_error() : Error("loops of a field cannot be cancelled, but only those of a graph") {}
};

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

#endif // CGAL_REEB_GRAPH_SIMPLIFICATION_EXCEPTIONS_H
