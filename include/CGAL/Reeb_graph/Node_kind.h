// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of the CGAL-style package Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_NODE_KIND_H
#define CGAL_REEB_GRAPH_NODE_KIND_H

#include <CGAL/license/Reeb_graph.h>

#include <ostream>
#include <string>

namespace CGAL::Reeb_graph {

/// \ingroup PkgReebGraphEnums
///
/// \brief what happens to the contours at a node of the Reeb graph.
enum class Node_kind
{
  ISOLATED,  ///< no contour below and none above: a vertex without a face, or a component that ties contract
  MINIMUM,   ///< a contour is born: no arc below
  SADDLE,    ///< contours join, split, or both: at least three arcs
  MAXIMUM,   ///< a contour dies: no arc above
  DEGREE_TWO ///< a critical vertex that is touched by one contour below and by one above; kept on request only
};

/// \ingroup PkgReebGraphEnums
///
/// \brief returns the name under which a kind of node is written:
/// `"isolated"`, `"minimum"`, `"saddle"`, `"maximum"`, or `"degree-two"`.
inline std::string to_string(Node_kind kind)
{
  switch(kind)
  {
  case Node_kind::ISOLATED: return "isolated";
  case Node_kind::MINIMUM: return "minimum";
  case Node_kind::SADDLE: return "saddle";
  case Node_kind::MAXIMUM: return "maximum";
  case Node_kind::DEGREE_TWO: return "degree-two";
  }
  return "unknown";
}

/// \ingroup PkgReebGraphEnums
///
/// \brief writes what `to_string()` returns.
inline std::ostream& operator<<(std::ostream& out, Node_kind kind) { return out << to_string(kind); }

} // namespace CGAL::Reeb_graph

#endif // CGAL_REEB_GRAPH_NODE_KIND_H
