// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_HANDLES_HANDLE_AND_TUNNEL_LOOPS_H
#define CGAL_REEB_GRAPH_HANDLES_HANDLE_AND_TUNNEL_LOOPS_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/Flat_field.h>
#include <CGAL/Reeb_graph/handles/Handle_loop.h>
#include <CGAL/Reeb_graph/handles/internal/Closed_surface.h>
#include <CGAL/Reeb_graph/handles/internal/make_loops.h>
#include <CGAL/Reeb_graph/internal/base/Progress.h>
#include <CGAL/Reeb_graph/internal/base/Threads.h>
#include <CGAL/Reeb_graph/named_parameters.h>
#include <CGAL/Reeb_graph_traits.h>
#include <CGAL/compute_reeb_graph.h>

#include <CGAL/tags.h>

#include <boost/graph/graph_traits.hpp>

#include <cstddef>
#include <limits>
#include <memory>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL::Reeb_graph {

/// \ingroup PkgReebGraphHandles
///
/// \brief the loops of a surface, with what certifies them: what `handle_and_tunnel_loops()` returns.
///
/// The mesh has to outlive it and must not change. It can be moved, and all copies share what they know.
///
/// \tparam FaceListGraph the type of the mesh
template <class FaceListGraph>
class Handle_and_tunnel_loops
{
public:
  /// a halfedge of the mesh
  typedef typename boost::graph_traits<FaceListGraph>::halfedge_descriptor halfedge_descriptor;
  /// a loop
  typedef Handle_loop<halfedge_descriptor> Loop;

  /// \brief returns the loops: those of one component after the other, by the length of the shorter one of each pair,
  /// where a handle stands before its partner; behind them the holes of all components.
  const std::vector<Loop>& loops() const { return loops_; }

  /// \brief returns the number of times that a loop of the list links another one, or itself, that is pushed to the
  /// outside of the surface: 0 for loops of different components, which are not compared, and for those without inside.
  ///
  /// \param loop the position of the loop
  /// \param pushed the position of the one that is pushed
  long long linking_number(std::size_t loop, std::size_t pushed) const
  {
    return found_->linking_number(walks_[loop], walks_[pushed]);
  }

  /// \brief returns the number of times that a loop of the list crosses another one from the right of that to its left,
  /// less those the other way round.
  ///
  /// \param loop the position of the one that is crossed
  /// \param other the position of the one that crosses it
  long long intersection_number(std::size_t loop, std::size_t other) const
  {
    return found_->intersection_number(walks_[loop], walks_[other]);
  }

  /// \brief returns whether a loop bounds inside of its component, but not on the surface. No loop of a surface without
  /// inside does.
  ///
  /// \param halfedges consecutive halfedges of the mesh, a range; may pass anything more than once
  ///
  /// \exception Open_loop_error if the halfedges are not a closed walk of the mesh
  template <class HalfedgeRange>
  bool is_handle(const HalfedgeRange& halfedges) const
  {
    return found_->is_bounding(walk(halfedges), true);
  }

  /// \brief returns whether a loop bounds outside of its component, but not on the surface.
  ///
  /// \param halfedges as above
  ///
  /// \exception Open_loop_error if the halfedges are not a closed walk of the mesh
  template <class HalfedgeRange>
  bool is_tunnel(const HalfedgeRange& halfedges) const
  {
    return found_->is_bounding(walk(halfedges), false);
  }

  /// \brief returns the number of pairs of faces of a component that intersect, and of its faces without area. Where it is
  /// not 0, the loops have no kind, or, with the named parameter `ignore_self_intersections`, kinds that are not certain.
  /// They are counted where a component has handles and no holes, unless `check_self_intersections` is `false`, else it is
  /// 0.
  ///
  /// \param component the number of the component
  std::size_t number_of_self_intersections(std::size_t component) const
  {
    return component < self_intersections_.size() ? self_intersections_[component] : 0;
  }

#ifndef DOXYGEN_RUNNING
  Handle_and_tunnel_loops(std::shared_ptr<const internal::Loop_finder> found,
                          std::shared_ptr<const internal::Surface_closing<FaceListGraph>> closing,
                          const std::vector<internal::Surface_loop>& loops,
                          std::vector<std::size_t> self_intersections)
    : found_(std::move(found)),
      closing_(std::move(closing)),
      self_intersections_(std::move(self_intersections))
  {
    for(const internal::Surface_loop& loop : loops)
    {
      walks_.push_back(loop.halfedges);
      loops_.push_back({loop.kind, {}, loop.partner, loop.length, loop.persistence, loop.component, loop.is_simple});
      for(const internal::Index h : loop.halfedges)
        loops_.back().halfedges.push_back(closing_->halfedge_of(h));
    }
  }
#endif

private:
  template <class HalfedgeRange>
  internal::Halfedge_walk walk(const HalfedgeRange& halfedges) const
  {
    internal::Halfedge_walk result;
    for(const halfedge_descriptor h : halfedges)
    {
      result.push_back(closing_->number(h));
      if(result.back() == internal::no_index)
        throw Open_loop_error(result.size() - 1);
    }
    const auto& surface = found_->surface();
    for(std::size_t i = 0; i != result.size(); ++i)
    {
      const internal::Index before = result[(i + result.size() - 1) % result.size()];
      if(surface.target[before] != surface.source(result[i]))
        throw Open_loop_error(i);
    }
    return result;
  }

  std::shared_ptr<const internal::Loop_finder> found_;
  std::shared_ptr<const internal::Surface_closing<FaceListGraph>> closing_;
  std::vector<internal::Halfedge_walk> walks_;
  std::vector<Loop> loops_;
  std::vector<std::size_t> self_intersections_;
};

/// \ingroup PkgReebGraphHandles
///
/// \brief finds the handles and the tunnels of a surface in space.
///
/// The homology of a closed surface of genus \f$ g \f$ is that of its inside plus that of its outside. For each
/// component, other components ignored, this function finds \f$ g \f$ loops that bound inside (handles) and \f$ g \f$
/// that bound outside (tunnels): a basis of the homology with integers in which each handle crosses its partner once,
/// and no other tunnel. They are closed walks along edges of the mesh. On coarse meshes, loops can share vertices and
/// edges, and one that passes a vertex twice says so by `Handle_loop::is_simple`.
///
/// What bounds on which side is decided by linking numbers, by exact predicates on the points as they are: see the
/// manual. The field decides nothing but the persistences: it has no influence on the loops.
///
/// By default the loops are short: they are chosen by length, the shortest first, as long as the choice is part of such
/// a basis, among loops that an edge closes with a tree of shortest paths. Of those within 4 percent,
/// the ones of whose kind there are fewer come first. A loop is not longer than the shortest one of
/// its class by more than 4 percent, unless searches stop as they see too much. This is common at high genus, most of all
/// for the longer loop of a pair, and lets it be several times as long.
///
/// A component with holes has no inside. Each hole gives a `Loop_kind::HOLE`, and the genus that is left once all are
/// filled gives pairs of `Loop_kind::LOOP`. So does a component that intersects itself; its loops are as short
/// where linking numbers are those of a surface with two sides.
///
/// Without shortening, it takes \f$ O(n + g^3 + k \log^2 k + c) \f$ time, where \f$ n \f$ is the number of vertices and
/// faces, \f$ k \f$ the number of edges on the loops of a tree, and \f$ c \f$ the number of their crossings as they are
/// seen in one direction. The time of the Reeb graph comes on top. The shortening takes some tens of searches for each loop, of
/// which each sees the part of the surface that is nearer than half the length of that loop.
///
/// The idea to combine loops by linking numbers is that of \cgalCite{dfw-echtlr-13}.
///
/// \tparam ConcurrencyTag `Sequential_tag`, `Parallel_tag`, or `Parallel_if_available_tag`. It has no influence on the
///         result. `Parallel_tag` needs TBB; the threads are those of the calling `tbb::task_arena`.
/// \tparam FaceListGraph a model of `FaceListGraph` with dynamic property maps, such as `Surface_mesh` and
///         `Polyhedron_3`
/// \tparam ScalarMap a model of `ReadablePropertyMap` with the vertex descriptors of the mesh as key type
/// \tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"
///
/// \param mesh the mesh
/// \param scalar_map the scalar field, by which persistences are measured
/// \param np an optional sequence of \ref bgl_namedparameters "Named Parameters" among those below
///
/// \cgalNamedParamsBegin
///   \reebGraphPointsOfLoops{ReadablePropertyMap}
///   \cgalParamNBegin{shorten_loops}
///     \cgalParamDescription{whether the loops are made short}
///     \cgalParamType{`bool`}
///     \cgalParamDefault{`true`}
///     \cgalParamExtra{use the function `parameters::shorten_loops()`}
///   \cgalParamNEnd
///   \cgalParamNBegin{check_self_intersections}
///     \cgalParamDescription{whether triangles that intersect are looked for, so that what has no inside is known. This
///                           takes half of the time that is taken without shortening; leave it out if there are
///                           none. Without it, a component whose linking numbers are those of no surface with two sides
///                           is still found. Not every intersection changes these, so the default is to look.}
///     \cgalParamType{`bool`}
///     \cgalParamDefault{`true`}
///     \cgalParamExtra{use the function `parameters::check_self_intersections()`}
///   \cgalParamNEnd
///   \cgalParamNBegin{ignore_self_intersections}
///     \cgalParamDescription{whether loops of a component that intersects itself get the kinds that their linking numbers
///                           tell, if these are those of a surface with two sides. They are not certain then.}
///     \cgalParamType{`bool`}
///     \cgalParamDefault{`false`}
///     \cgalParamExtra{use the function `parameters::ignore_self_intersections()`}
///   \cgalParamNEnd
///   \cgalParamNBegin{geom_traits}
///     \cgalParamDescription{an instance of a traits class, for scalar values ordered by another function object}
///     \cgalParamType{a model of `ReebGraphTraits`}
///     \cgalParamDefault{`Reeb_graph_traits<FaceListGraph, ScalarMap>`}
///   \cgalParamNEnd
///   \reebGraphCallback
/// \cgalNamedParamsEnd
///
/// \reebGraphComplexity
///
/// \returns the loops.
///
/// \exception Reeb_graph::Non_finite_point_error if a coordinate of a point is infinite or NaN
///
/// and the exceptions of `compute_reeb_graph()`.
template <class ConcurrencyTag = Sequential_tag,
          class FaceListGraph,
          class ScalarMap,
          class NamedParameters = parameters::Default_named_parameters>
Handle_and_tunnel_loops<FaceListGraph> handle_and_tunnel_loops(const FaceListGraph& mesh,
                                                               ScalarMap scalar_map,
                                                               const NamedParameters& np = parameters::default_values())
{
  const internal::Progress progress(np);
  progress.report(0);
  const auto traits = internal::choose_traits<Reeb_graph_traits<FaceListGraph, ScalarMap>>(np);
  const auto flat_field = internal::make_flat_field(mesh, scalar_map, parameters::geom_traits(traits));
  const auto reeb_loops = [&] { // The graph takes memory.
    typename Reeb_graph_traits<FaceListGraph, std::decay_t<decltype(flat_field)>>::Graph graph;
    const internal::Stage_progress stage(progress, 0, 0.05);
    compute_reeb_graph<ConcurrencyTag>(mesh, flat_field, graph,
                                       parameters::geom_traits(traits).callback(stage.callback()));
    return internal::find_reeb_loops(mesh, flat_field, graph, traits, internal::Stage_progress(progress, 0.05, 0.1));
  }();
  const auto closing = std::make_shared<internal::Surface_closing<FaceListGraph>>(
    mesh, flat_field.flat_values(mesh)->mesh, internal::choose_point_map(mesh, np));
  const std::shared_ptr<internal::Loop_finder> found =
    internal::make_loop_finder(std::move(closing->surface()), internal::Stage_progress(progress, 0.1, 0.2));
  const bool are_checked = internal::parameter_or(np, internal::check_self_intersections, true);
  const bool are_ignored = internal::parameter_or(np, internal::ignore_self_intersections, false);
  const bool are_short = internal::parameter_or(np, internal::shorten_loops, true);
  std::vector<std::size_t> self_intersections;
  const auto find_self_intersections = [&] {
    if(!are_checked)
      return;
    self_intersections = found->self_intersections(true);
    if(!are_ignored)
      found->refuse_self_intersections(self_intersections);
  };
  auto loops = found->make_loops(are_short ? std::numeric_limits<double>::infinity() : 0,
                                 (std::numeric_limits<std::size_t>::max)(), find_self_intersections,
                                 internal::threads_of<ConcurrencyTag>(), internal::Stage_progress(progress, 0.2, 1));
  internal::set_persistences(
    reeb_loops, [&](const auto h) { return closing->number(h); }, loops);
  progress.report_end();
  return Handle_and_tunnel_loops<FaceListGraph>(found, closing, loops, self_intersections);
}

} // namespace CGAL::Reeb_graph

#endif // CGAL_REEB_GRAPH_HANDLES_HANDLE_AND_TUNNEL_LOOPS_H
