// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_HANDLES_REMOVE_HANDLES_H
#define CGAL_REEB_GRAPH_HANDLES_REMOVE_HANDLES_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/curves/Refinement_visitor.h>
#include <CGAL/Reeb_graph/exceptions.h>
#include <CGAL/Reeb_graph/handles/Handle_loop.h>
#include <CGAL/Reeb_graph/handles/internal/Handle_remover.h>
#include <CGAL/Reeb_graph/internal/base/Progress.h>
#include <CGAL/Reeb_graph/internal/base/Threads.h>
#include <CGAL/Reeb_graph/internal/base/requirements.h>
#include <CGAL/Reeb_graph/internal/complex/Flat_mesh.h>
#include <CGAL/Reeb_graph/named_parameters.h>

#include <CGAL/boost/graph/named_params_helper.h>
#include <CGAL/tags.h>

#include <boost/graph/graph_traits.hpp>

#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL::Reeb_graph {

/// \ingroup PkgReebGraphHandles
///
/// \brief removes small handles and tunnels of a surface, such as the noise of scans and isosurfaces has.
///
/// The size of a pair of a handle and a tunnel is the length of its shorter loop. The mesh is cut along this loop. The
/// two copies of the loop move a little away from each other, by at most a quarter of the way to their neighbors. Each is
/// closed by a disc of few triangles. So the genus falls by one, and no component falls apart. All other vertices stay
/// where they are, with their descriptors and their faces; new vertices and faces come behind them.
///
/// The smallest handle comes first. Loops are those of `handle_and_tunnel_loops()`, found anew until no handle is left
/// that is smaller than the given size and can be removed. One stays if its loop passes a vertex twice or a hole, if it
/// bounds no disc, or if the new faces would intersect each other, the rest of the surface, or another component. So a
/// surface that does not intersect itself does not afterwards, either. For loops of more than 50 halfedges, the triangles of
/// discs can differ from run to run where others are as good: see `areas_of_filling_discs()`.
///
/// Loops that are not shorter than the size are not looked for. A round takes the time of `handle_and_tunnel_loops()` for
/// short loops, and all handles that do not touch each other are removed in one round.
///
/// \tparam ConcurrencyTag as for `handle_and_tunnel_loops()`
/// \reebGraphRefinedMesh
/// \tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"
///
/// \param mesh the mesh, which is changed. To keep it, pass a copy made by `CGAL::copy_face_graph()`.
/// \param size handles that are smaller are removed; may be infinite
/// \param np an optional sequence of \ref bgl_namedparameters "Named Parameters" among those below
///
/// \cgalNamedParamsBegin
///   \cgalParamNBegin{number_of_handles}
///     \cgalParamDescription{at most this many are removed, the smallest first}
///     \cgalParamType{`std::size_t`}
///     \cgalParamDefault{all that are smaller than the size}
///     \cgalParamExtra{use the function `parameters::number_of_handles()`}
///   \cgalParamNEnd
///   \reebGraphPointsOfLoops{ReadWritePropertyMap}
///   \cgalParamNBegin{visitor}
///     \cgalParamDescription{is called for the vertices and halfedges of loops that are doubled, and for the faces of
///                           discs, as if they were split off from a face beside them. An `Interpolating_visitor`
///                           carries property maps over.}
///     \cgalParamType{a model of `ReebGraphRefinementVisitor`, by value or as `std::reference_wrapper`}
///     \cgalParamDefault{`Reeb_graph::Default_refinement_visitor`}
///   \cgalParamNEnd
///   \cgalParamNBegin{ignore_self_intersections}
///     \cgalParamDescription{as for `handle_and_tunnel_loops()`; they are not looked for then, which is also faster}
///     \cgalParamType{`bool`}
///     \cgalParamDefault{`false`}
///     \cgalParamExtra{use the function `parameters::ignore_self_intersections()`}
///   \cgalParamNEnd
///   \reebGraphCallback
/// \cgalNamedParamsEnd
///
/// \reebGraphComplexity
///
/// \returns the handles that have been removed, in this order, and behind them those that are refused.
///
/// \exception Reeb_graph::Parameter_error if the size is negative or NaN
/// \exception Reeb_graph::Non_finite_point_error if a coordinate of a point is infinite or NaN
///
/// and the exceptions of `compute_reeb_graph()` for meshes. When one of these is thrown, the mesh is as it was before.
///
/// \exception Reeb_graph::Cancelled_error if `callback` returns `false`; handles that are removed by then stay removed
template <class ConcurrencyTag = Sequential_tag,
          class MutableFaceGraph,
          class NamedParameters = parameters::Default_named_parameters>
std::vector<Handle_removal<typename boost::graph_traits<MutableFaceGraph>::vertex_descriptor>> remove_handles(
  MutableFaceGraph& mesh,
  double size,
  const NamedParameters& np = parameters::default_values())
{
  static_assert(internal::are_met<internal::Refinable_mesh<MutableFaceGraph>>);
  if(!(size >= 0))
    throw Parameter_error("the size of handles is negative or not a number (NaN)");
  const internal::Progress progress(np);
  progress.report(0);
  internal::check_mesh(mesh);
  const auto point_map = internal::parameter_or(np, internal_np::vertex_point, get_property_map(vertex_point, mesh));
  auto visitor_parameter =
    internal::parameter_or(np, internal_np::visitor, Default_refinement_visitor<MutableFaceGraph>());
  auto& visitor = internal::unwrap_reference(visitor_parameter);
  internal::Handle_remover<MutableFaceGraph, std::decay_t<decltype(point_map)>, std::decay_t<decltype(visitor)>> remove(
    mesh, point_map, visitor, internal::threads_of<ConcurrencyTag>());
  const auto result =
    remove(size, internal::parameter_or(np, internal::number_of_handles, (std::numeric_limits<std::size_t>::max)()),
           !internal::parameter_or(np, internal::ignore_self_intersections, false), progress);
  progress.report_end();
  return result;
}

} // namespace CGAL::Reeb_graph

#endif // CGAL_REEB_GRAPH_HANDLES_REMOVE_HANDLES_H
