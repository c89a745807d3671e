// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_CURVES_UNFOLD_MULTI_SADDLES_H
#define CGAL_REEB_GRAPH_CURVES_UNFOLD_MULTI_SADDLES_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/curves/Curve.h>
#include <CGAL/Reeb_graph/curves/internal/cut_and_mark.h>
#include <CGAL/Reeb_graph/curves/internal/simple_reeb_graph.h>
#include <CGAL/Reeb_graph/internal/base/Progress.h>

namespace CGAL::Reeb_graph {

/// \ingroup PkgReebGraphCurves
///
/// \brief refines a mesh so that all saddles inside of the surface are simple.
///
/// Let an interior vertex have \f$ m + 1 \f$ lower link sectors, \f$ m > 1 \f$. The edges to the neighbors in the
/// smallest \f$ m - 1 \f$ upper link sectors are split, and the new vertices are put just below the vertex in the total
/// order. One of each sector becomes a simple saddle, and so does the vertex itself; the others become regular. The
/// kinds of all other vertices stay as they are. A multi-saddle can hide a handle of the surface from the Reeb graph,
/// or a contour; after this, a connected closed surface of genus \f$ g \f$ has exactly \f$ g \f$ independent loops in
/// its graph.
///
/// As values between those of the field need not exist, the result has ranks in their place: numbers in the same order.
/// Only comparisons decide the Reeb graph, so that of `rank_map` is the one of the unfolded field. It takes
/// \f$ O(n \log n) \f$ time for \f$ n \f$ vertices and faces.
///
/// \reebGraphRefinedMeshAndField
/// \tparam RankMap a model of `WritablePropertyMap` with the vertex descriptors of the mesh as key type, and a value
///         type that 64-bit unsigned integers can be converted to
/// \tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"
///
/// \param mesh the mesh, which is changed
/// \param scalar_map the scalar field
/// \param rank_map the result: for each vertex, new ones included, a different number
/// \param np an optional sequence of \ref bgl_namedparameters "Named Parameters" among those below
///
/// \copydetails PkgReebGraphRefinementParameters
///
/// It throws the exceptions of `compute_reeb_graph()`. When one is thrown, the mesh is as it was before.
///
/// \reebGraphComplexity
template <class MutableFaceGraph,
          class ScalarMap,
          class RankMap,
          class NamedParameters = parameters::Default_named_parameters>
void unfold_multi_saddles(MutableFaceGraph& mesh,
                          ScalarMap scalar_map,
                          RankMap rank_map,
                          const NamedParameters& np = parameters::default_values())
{
  typedef internal::Chosen_traits<Reeb_graph_traits<MutableFaceGraph, ScalarMap>, NamedParameters> Traits;
  static_assert(internal::are_met<internal::Refinable_mesh<MutableFaceGraph>,
                                  internal::Field_of_numbers<MutableFaceGraph, ScalarMap, Traits>,
                                  internal::Writable_vertex_map<RankMap, MutableFaceGraph>>);
  const internal::Progress progress(np);
  progress.report(0);
  internal::check_input(mesh, scalar_map, np);
  progress.report(0.2);
  auto visitor_parameter = internal::choose_refinement_visitor(mesh, np);
  const auto ranked = internal::make_ranked_mesh(mesh, internal::unwrap_reference(visitor_parameter), np);
  const auto traits = internal::choose_traits<Traits>(np);
  internal::rank_vertices(ranked, scalar_map, traits);
  progress.report(0.65);
  internal::unfold_all_vertices(ranked);
  progress.report(0.9);
  ranked.keep_splits();
  internal::Refined_field(ranked, scalar_map, traits).write_ranked_vertices();
  for(const auto v : vertices(mesh))
    put(rank_map, v, ranked.rank(v));
  progress.report_end();
}

} // namespace CGAL::Reeb_graph

#endif // CGAL_REEB_GRAPH_CURVES_UNFOLD_MULTI_SADDLES_H
