// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of the CGAL-style package Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_CURVES_REFINEMENT_VISITOR_H
#define CGAL_REEB_GRAPH_CURVES_REFINEMENT_VISITOR_H

#include <CGAL/license/Reeb_graph.h>

#include <boost/graph/graph_traits.hpp>

namespace CGAL::Reeb_graph {

/// \ingroup PkgReebGraphCurves
///
/// \brief a visitor of a refinement that does nothing; derive from it, and redefine one or more members.
///
/// \tparam FaceGraph the type of the mesh
///
/// \cgalModels{ReebGraphRefinementVisitor}
template <class FaceGraph>
struct Default_refinement_visitor
{
  typedef typename boost::graph_traits<FaceGraph>::vertex_descriptor vertex_descriptor;     ///< a vertex
  typedef typename boost::graph_traits<FaceGraph>::halfedge_descriptor halfedge_descriptor; ///< a halfedge
  typedef typename boost::graph_traits<FaceGraph>::face_descriptor face_descriptor;         ///< a face

  /// called when the halfedge `first` has been split off from `second`, which it leads to.
  void edge_split(halfedge_descriptor /* first */, halfedge_descriptor /* second */) {}

  /// called when `v` has been placed at the fraction `t` of the way from `source` to `target`.
  void vertex_added(vertex_descriptor /* v */,
                    vertex_descriptor /* source */,
                    vertex_descriptor /* target */,
                    double /* t */)
  {}

  /// called when the face `created` has been split off from `old`.
  void face_split(face_descriptor /* old */, face_descriptor /* created */) {}

  /// called when the mesh is cut open and the lower side of a curve gets the vertex `created` in the place of `old`.
  void vertex_duplicated(vertex_descriptor /* old */, vertex_descriptor /* created */) {}

  /// called when the mesh is cut open and the lower side of a curve gets the halfedge `created` in the place of `old`.
  void halfedge_duplicated(halfedge_descriptor /* old */, halfedge_descriptor /* created */) {}
};

} // namespace CGAL::Reeb_graph

#endif // CGAL_REEB_GRAPH_CURVES_REFINEMENT_VISITOR_H
