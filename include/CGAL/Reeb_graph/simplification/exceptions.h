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
