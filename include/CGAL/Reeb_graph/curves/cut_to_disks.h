// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_CURVES_CUT_TO_DISKS_H
#define CGAL_REEB_GRAPH_CURVES_CUT_TO_DISKS_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/curves/Curve.h>
#include <CGAL/Reeb_graph/curves/internal/Disk_cut.h>
#include <CGAL/Reeb_graph/curves/internal/cut_and_mark.h>
#include <CGAL/Reeb_graph/curves/internal/requirements.h>
#include <CGAL/Reeb_graph/curves/internal/trace_edges.h>
#include <CGAL/Reeb_graph/internal/base/Progress.h>
#include <CGAL/Reeb_graph/internal/complex/Curve_opening.h>
#include <CGAL/Reeb_graph/internal/complex/Flat_mesh.h>

#include <CGAL/number_utils.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <type_traits>
#include <vector>

namespace CGAL::Reeb_graph {

namespace internal {

// The edges along which a mesh is cut to disks, after it has been checked.
template <class Mesh, class VertexPointMap>
std::vector<typename boost::graph_traits<Mesh>::edge_descriptor> find_disk_cut(const Mesh& mesh,
                                                                               const VertexPointMap& vertex_point_map,
                                                                               const Stage_progress& progress)
{
  const auto flat_mesh = make_flat_mesh(mesh);
  const auto& complex = flat_mesh->complex;
  const auto halfedge_of = [&](Edge_index e) { return flat_mesh->numbers.halfedges(mesh, even_halfedge(e)); };
  Indexed_vector<Edge_index, double> lengths(complex.number_of_edges(), 0);
  for(const Edge_index e : lengths.keys())
  {
    if(!complex.has_edge(e))
      continue;
    const auto h = halfedge_of(e);
    const auto vector = get(vertex_point_map, target(h, mesh)) - get(vertex_point_map, source(h, mesh));
    const double length = std::sqrt(CGAL::to_double(vector.squared_length()));
    lengths[e] = length >= 0 ? length : 0; // not NaN
  }
  std::vector<typename boost::graph_traits<Mesh>::edge_descriptor> edges;
  for(const Edge_index e : Disk_cut(complex, lengths)(progress))
    edges.push_back(edge(halfedge_of(e), mesh));
  return edges;
}

} // namespace internal

/// \ingroup PkgReebGraphCurves
///
/// \brief cuts each connected component of a mesh to a disk along edges, as it is needed to flatten it.
///
/// Each component has Euler characteristic 1 and one border then, whatever its genus and its borders were. No face is
/// changed, and no point is new: vertices of the cut are doubled, or multiplied where it branches. The cut is a tree of
/// shortest paths and what a spanning tree of the faces does not join, without dead ends: short, but not the shortest
/// one, which is hard to find. A component that is a disk already is not cut. A closed one of genus 0 is cut along two
/// edges at one vertex. Vertices without faces stay as they are.
///
/// The curves are the longest paths of the edges of the cut through vertices at which two of these meet. Along them, the
/// left side keeps halfedges and vertices, which are `halfedges`; the other side gets `lower_halfedges`. Their values
/// are 0.
///
/// It takes \f$ O(n \log n) \f$ time for \f$ n \f$ vertices and faces. See \cgalCite{ew-gohhg-05}.
///
/// \tparam MutableFaceGraph a model of `MutableFaceGraph`
/// \tparam OutputIterator a model of `OutputIterator` for `Reeb_graph::Curve`
/// \tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"
///
/// \param mesh the mesh, which is changed: an oriented manifold surface of triangles. To keep it, pass a copy made by
///        `CGAL::copy_face_graph()`.
/// \param curves the output
/// \param np an optional sequence of \ref bgl_namedparameters "Named Parameters": `edge_is_constrained_map`,
///        `edge_curve_map` and `face_patch_map` as for \ref PkgReebGraphCuttingParameters "cutting along curves", whose
///        pieces are the disks; `visitor` and `callback` as for \ref PkgReebGraphRefinementParameters "refinements",
///        where the visitor is called for vertices and halfedges that are doubled; and those below
///
/// \cgalNamedParamsBegin
///   \reebGraphPoints{ReadWritePropertyMap}
///   \cgalParamNBegin{original_vertex_map}
///     \cgalParamDescription{is set to the vertex of the given mesh that each vertex is, or is a copy of}
///     \cgalParamType{a model of `WritablePropertyMap` with the vertex descriptors as key type and as value type}
///     \cgalParamDefault{none}
///     \cgalParamExtra{use the functions `parameters::original_vertex_map()`}
///   \cgalParamNEnd
/// \cgalNamedParamsEnd
///
/// \reebGraphComplexity
///
/// \returns the output iterator behind the last curve.
///
/// It throws the exceptions of `compute_reeb_graph()` that are not about a field; the mesh is as it was before then.
template <class MutableFaceGraph, class OutputIterator, class NamedParameters = parameters::Default_named_parameters>
OutputIterator cut_to_disks(MutableFaceGraph& mesh,
                            OutputIterator curves,
                            const NamedParameters& np = parameters::default_values())
{
  if constexpr(internal::Refinable_mesh<MutableFaceGraph>::value)
  {
    using parameters::get_parameter;
    typedef typename boost::graph_traits<MutableFaceGraph>::halfedge_descriptor halfedge_descriptor;
    const internal::Progress progress(np);
    progress.report(0);
    const auto vertex_point_map =
      parameters::choose_parameter(get_parameter(np, internal_np::vertex_point), get_property_map(vertex_point, mesh));
    const auto edges = internal::find_disk_cut(mesh, vertex_point_map, internal::Stage_progress(progress, 0.1, 0.8));
    std::vector<Curve<halfedge_descriptor>> found;
    for(auto& path : internal::Edge_tracing(mesh)(edges))
      found.push_back(internal::make_curve(mesh, vertex_point_map, std::move(path), 0));
    progress.report(0.9);

    auto original_map = get_parameter(np, internal::original_vertex_map);
    const auto set_original = [&](auto old, auto created) {
      if constexpr(internal::is_given<decltype(original_map)>)
        put(original_map, created, old);
    };
    for(const auto v : vertices(mesh))
      set_original(v, v);
    auto visitor_parameter = internal::choose_refinement_visitor(mesh, np);
    auto& visitor = internal::unwrap_reference(visitor_parameter);
    internal::Opening_visitor<decltype(set_original), std::decay_t<decltype(visitor)>> opening_visitor = {set_original,
                                                                                                          visitor};
    internal::Curve_opening open(mesh, vertex_point_map, opening_visitor);
    open(found);
    internal::mark_edges_and_pieces(mesh, found, np);
    progress.report_end();
    return std::copy(found.begin(), found.end(), curves);
  }
  else
    return curves;
}

} // namespace CGAL::Reeb_graph

#endif // CGAL_REEB_GRAPH_CURVES_CUT_TO_DISKS_H
