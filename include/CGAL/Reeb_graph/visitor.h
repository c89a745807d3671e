// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_VISITOR_H
#define CGAL_REEB_GRAPH_VISITOR_H

#include <CGAL/license/Reeb_graph.h>

#include <cstddef>
#include <map>

namespace CGAL::Reeb_graph {

/// \ingroup PkgReebGraphRef
///
/// \brief the number of critical vertices of each kind: a property of the field, not of its Reeb graph.
///
/// With \f$ m \f$ the multiplicity, the number of lower link sectors minus one, a closed surface has Euler
/// characteristic \f$ minima - \sum m + maxima \f$.
struct Critical_vertex_counts
{
  std::size_t isolated = 0; ///< vertices without a face
  std::size_t minima = 0;   ///< vertices whose link is all above, border vertices included
  std::size_t maxima = 0;   ///< vertices whose link is all below, border vertices included
  /// interior vertices with at least two lower link sectors, by multiplicity
  std::map<std::size_t, std::size_t> saddles;
  std::size_t border_saddles = 0; ///< border vertices with at least two lower or two upper link sectors
};

/// \ingroup PkgReebGraphEnums
///
/// \brief the stages of `compute_reeb_graph()`, in the order in which they run.
enum class Stage
{
  FLATTEN,  ///< the scalar map is copied, and the mesh, if it is no `CGAL::Surface_mesh`
  CLASSIFY, ///< the mesh is checked; critical vertices are found and sorted
  ARCS,     ///< the arcs between critical vertices are found
  WRITE     ///< the halfedge chains of the arcs are walked, and the graph is written
};

/// \ingroup PkgReebGraphRef
///
/// \brief a visitor of `compute_reeb_graph()` that does nothing; derive from it, and redefine one or more members.
///
/// \cgalModels{ReebGraphVisitor}
struct Default_visitor
{
  void begin_stage(Stage) {} ///< called before a stage
  void end_stage(Stage) {}   ///< called after a stage
  /// called once in the stage `Stage::CLASSIFY`.
  void critical_vertices(const Critical_vertex_counts&) {}
};

} // namespace CGAL::Reeb_graph

#endif // CGAL_REEB_GRAPH_VISITOR_H
