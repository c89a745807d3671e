// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of the CGAL-style package Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_SIMPLIFICATION_EXCEPTIONS_H
#define CGAL_REEB_GRAPH_SIMPLIFICATION_EXCEPTIONS_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/exceptions.h>

namespace CGAL {
namespace Reeb_graph {

/// \ingroup PkgReebGraphExceptions
///
/// \brief thrown for a graph with an arc whose lower node does not have a lower number than its upper node.
class Arc_direction_error : public Error
{
public:
  /// constructs the exception.
  Arc_direction_error() : Error("an arc of the graph does not lead to a node of higher number") {}
};

} // namespace Reeb_graph
} // namespace CGAL

#endif // CGAL_REEB_GRAPH_SIMPLIFICATION_EXCEPTIONS_H
