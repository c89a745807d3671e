// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_CURVES_CUT_ALONG_LEVELS_H
#define CGAL_REEB_GRAPH_CURVES_CUT_ALONG_LEVELS_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/curves/Curve.h>
#include <CGAL/Reeb_graph/curves/exceptions.h>
#include <CGAL/Reeb_graph/curves/internal/Contour_cutting.h>
#include <CGAL/Reeb_graph/curves/internal/Ranked_mesh.h>
#include <CGAL/Reeb_graph/curves/internal/cut_and_mark.h>
#include <CGAL/Reeb_graph/curves/internal/simple_reeb_graph.h>
#include <CGAL/Reeb_graph/internal/base/Progress.h>
#include <CGAL/Reeb_graph/internal/base/Threads.h>

#include <CGAL/Dynamic_property_map.h>
#include <CGAL/boost/graph/helpers.h>
#include <CGAL/boost/graph/iterator.h>
#include <CGAL/boost/graph/properties.h>

#include <boost/graph/graph_traits.hpp>
#include <boost/property_map/property_map.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::Reeb_graph::internal {

// The place of a value among ascending levels, as a rank: 2 i + 1 on level i, 2 i between level i - 1 and level i.
template <class Scalar, class Less>
Long_index rank_among_levels(const std::vector<Scalar>& levels, const Scalar& value, const Less& less)
{
  const auto level = std::lower_bound(levels.begin(), levels.end(), value, less);
  const bool is_on_level = level != levels.end() && !less(value, *level);
  return 2 * static_cast<Long_index>(level - levels.begin()) + (is_on_level ? 1 : 0);
}

// The levels strictly between two ranks, the lower one first: those from `first` on, before `last`.
struct Levels_between
{
  Levels_between(Long_index lower, Long_index upper) : first((lower + 1) / 2), last((std::max)(first, upper / 2)) {}

  static Long_index rank_of(Long_index level) { return 2 * level + 1; }
  std::size_t size() const { return last - first; }

  Long_index first, last;
};

// Refines a mesh so that levels become paths of edges: edges are split where they cross a level, and faces between these
// points and the vertices on levels. All vertices have ranks among the levels.
template <class RankedMesh>
class Level_cutting
{
  typedef typename RankedMesh::Mesh Mesh;
  typedef typename RankedMesh::vertex_descriptor vertex_descriptor;
  typedef typename RankedMesh::halfedge_descriptor halfedge_descriptor;
  typedef typename RankedMesh::edge_descriptor edge_descriptor;
  typedef typename RankedMesh::face_descriptor face_descriptor;

public:
  // A vertex that has been added, and the number of its level.
  struct Added_vertex
  {
    vertex_descriptor vertex;
    std::size_t level;
  };

  // The levels have numbers as values of the field have.
  Level_cutting(const RankedMesh& ranked, const std::vector<double>& levels)
    : ranked_(ranked),
      mesh_(ranked.mesh()),
      levels_(levels)
  {
    for(const edge_descriptor e : edges(mesh_))
    {
      const Levels_between levels_between = levels_of(e);
      if(levels_between.size() == 0)
        continue;
      crossed_edges_.push_back(e);
      number_of_points_ += levels_between.size();
      number_of_added_faces_ += levels_between.size() * (is_border(e, mesh_) ? 1 : 2);
    }
    for(const face_descriptor f : faces(mesh_))
    {
      const auto [lowest, highest] = ends_of(f);
      if(Levels_between(rank(lowest), rank(highest)).size() > 0)
        crossed_faces_.push_back(f);
    }
  }

  // Each point on an edge makes one triangle more of each face beside it.
  std::size_t number_of_added_faces() const { return number_of_added_faces_; }

  std::vector<Added_vertex> operator()(const Stage_progress& progress)
  {
    std::vector<Added_vertex> added;
    added.reserve(number_of_points_);
    for(std::size_t i = 0; i != crossed_edges_.size(); ++i)
    {
      progress.part(0, 0.4).report_step(i, crossed_edges_.size());
      split_edge(crossed_edges_[i], added);
    }
    for(std::size_t i = 0; i != crossed_faces_.size(); ++i)
    {
      progress.part(0.4, 1).report_step(i, crossed_faces_.size());
      split_face(crossed_faces_[i]);
    }
    return added;
  }

private:
  Long_index rank(halfedge_descriptor h) const { return ranked_.rank(target(h, mesh_)); }

  auto ends_of(face_descriptor f) const
  {
    return ranked_.ends_of(f, [](halfedge_descriptor) { return true; });
  }

  Levels_between levels_of(edge_descriptor e) const
  {
    const auto [lower, upper] = std::minmax({ranked_.rank(source(e, mesh_)), ranked_.rank(target(e, mesh_))});
    return Levels_between(lower, upper);
  }

  // Splits an edge from its lower end on, so that what is left of it is the upper part.
  void split_edge(edge_descriptor e, std::vector<Added_vertex>& added)
  {
    halfedge_descriptor h = halfedge(e, mesh_);
    if(ranked_.rank(source(h, mesh_)) > rank(h))
      h = opposite(h, mesh_);
    const vertex_descriptor lower = source(h, mesh_), upper = target(h, mesh_);
    const Levels_between levels_between = levels_of(e);
    for(Long_index level = levels_between.first; level != levels_between.last; ++level)
    {
      const double value = levels_[level];
      const halfedge_descriptor first =
        ranked_.split_edge(h, lower, upper, ranked_.crossing_fraction(lower, upper, value));
      ranked_.place(target(first, mesh_), Levels_between::rank_of(level), value);
      added.push_back({target(first, mesh_), static_cast<std::size_t>(level)});
    }
  }

  void split_face(face_descriptor f)
  {
    const auto ends = ends_of(f);
    const Long_index lowest = rank(ends[0]), highest = rank(ends[1]);
    const auto is_on_level = [&](halfedge_descriptor h) {
      return rank(h) % 2 == 1 && lowest < rank(h) && rank(h) < highest;
    };
    ranked_.split_triangle(ends, is_on_level, [](halfedge_descriptor) {});
  }

  const RankedMesh& ranked_;
  Mesh& mesh_;
  const std::vector<double>& levels_;
  std::vector<edge_descriptor> crossed_edges_;
  std::vector<face_descriptor> crossed_faces_;
  std::size_t number_of_points_ = 0, number_of_added_faces_ = 0;
};

// Whether a face on the left of a halfedge of a level is higher than that, 1, or lower, -1. It is 0 beyond the border,
// and for a face in the level.
template <class RankedMesh>
int side_of_level(const RankedMesh& ranked, typename RankedMesh::halfedge_descriptor h)
{
  const auto& mesh = ranked.mesh();
  if(is_border(h, mesh))
    return 0;
  const Long_index level = ranked.rank(target(h, mesh)), third = ranked.rank(target(next(h, mesh), mesh));
  return (level < third ? 1 : 0) - (third < level ? 1 : 0);
}

// The curves of the levels of a refined mesh, those of a lower level first, with the higher side on the left of most
// edges.
template <class RankedMesh>
auto curves_of_levels(const RankedMesh& ranked, const std::vector<double>& levels)
{
  typedef typename RankedMesh::halfedge_descriptor halfedge_descriptor;
  auto& mesh = ranked.mesh();
  std::vector<typename RankedMesh::edge_descriptor> edges_of_curves;
  for(const auto e : edges(mesh))
  {
    const Long_index rank = ranked.rank(source(e, mesh));
    if(rank % 2 == 1 && rank == ranked.rank(target(e, mesh)))
      edges_of_curves.push_back(e);
  }
  auto paths = Edge_tracing(mesh)(edges_of_curves);
  const auto rank_of_path = [&](const auto& path) { return ranked.rank(target(path.front(), mesh)); };
  std::stable_sort(paths.begin(), paths.end(),
                   [&](const auto& a, const auto& b) { return rank_of_path(a) < rank_of_path(b); });
  std::vector<Curve<halfedge_descriptor>> curves;
  for(auto& path : paths)
  {
    long sides = 0;
    for(const halfedge_descriptor h : path)
      sides += side_of_level(ranked, h) - side_of_level(ranked, opposite(h, mesh));
    if(sides < 0)
    {
      std::reverse(path.begin(), path.end());
      for(halfedge_descriptor& h : path)
        h = opposite(h, mesh);
    }
    const double value = levels[rank_of_path(path) / 2];
    curves.push_back(make_curve(mesh, ranked.vertex_point_map(), std::move(path), value));
  }
  return curves;
}

// The levels in ascending order, each once.
template <class LevelRange, class Traits>
std::vector<typename Traits::Scalar> sorted_levels(const LevelRange& given, const Traits& traits)
{
  const auto less = traits.less_scalar_object();
  const auto is_ordered_object = traits.is_ordered_object();
  std::vector<typename Traits::Scalar> levels;
  for(const auto& level : given)
  {
    levels.emplace_back(level);
    if(!internal::is_ordered(level) || !is_ordered_object(levels.back()))
      throw Unordered_level_error(levels.size() - 1);
  }
  std::sort(levels.begin(), levels.end(), less);
  const auto is_same = [&](const auto& a, const auto& b) { return !less(a, b); };
  levels.erase(std::unique(levels.begin(), levels.end(), is_same), levels.end());
  return levels;
}

// The number of faces at added vertices whose heights on their longest edges are less than a hundredth of these.
template <class RankedMesh, class AddedVertices>
std::size_t count_slivers(const RankedMesh& ranked, const AddedVertices& added_vertices)
{
  auto& mesh = ranked.mesh();
  const auto is_added = get(dynamic_vertex_property_t<bool>(), mesh);
  for(const auto v : vertices(mesh))
    put(is_added, v, false);
  for(const auto& added : added_vertices)
    put(is_added, added.vertex, true);
  std::size_t number = 0;
  for(const auto f : faces(mesh))
  {
    const auto h = halfedge(f, mesh);
    const auto u = source(h, mesh), v = target(h, mesh), w = target(next(h, mesh), mesh);
    if(!get(is_added, u) && !get(is_added, v) && !get(is_added, w))
      continue;
    const std::array<double, 3> lengths = {ranked.distance(u, v), ranked.distance(v, w), ranked.distance(w, u)};
    const double longest = *std::max_element(lengths.begin(), lengths.end());
    const double half = (lengths[0] / longest + lengths[1] / longest + lengths[2] / longest) / 2;
    double square = half; // of the area, where the longest edge is 1
    for(const double length : lengths)
      square *= half - length / longest;
    number += square >= 0.005 * 0.005 ? 0 : 1;
  }
  return number;
}

// The band of a face is the number of levels below its highest vertex.
template <class RankedMesh, class NamedParameters>
void write_bands(const RankedMesh& ranked, const NamedParameters& np)
{
  using parameters::get_parameter;
  if constexpr(is_given<decltype(get_parameter(np, face_band_map))>)
  {
    auto map = get_parameter(np, face_band_map);
    const auto& mesh = ranked.mesh();
    for(const auto f : faces(mesh))
    {
      Long_index highest = 0;
      for(const auto v : vertices_around_face(halfedge(f, mesh), mesh))
        highest = (std::max)(highest, ranked.rank(v));
      put(map, f, static_cast<std::size_t>(highest / 2));
    }
  }
}

// Cuts along levels that are in their order, where the mesh has been checked.
template <class Mesh, class ScalarMap, class Traits, class OutputIterator, class NamedParameters>
Level_cut_report cut_along_sorted_levels(Mesh& mesh,
                                         ScalarMap scalar_map,
                                         const Traits& traits,
                                         const std::vector<typename Traits::Scalar>& levels,
                                         OutputIterator& output,
                                         const NamedParameters& np,
                                         const Stage_progress& progress)
{
  constexpr bool is_written = is_field_written<ScalarMap, Traits>;
  const Scalar_conversion<Traits> conversion(traits);
  std::vector<double> numbers;
  for(const auto& level : levels)
    numbers.push_back(conversion.to_double(level));
  auto visitor_parameter = choose_refinement_visitor(mesh, np);
  auto& visitor = unwrap_reference(visitor_parameter);
  const auto ranked = make_ranked_mesh(mesh, visitor, np);
  for(const auto v : vertices(mesh))
  {
    const typename Traits::Scalar value = get(scalar_map, v);
    ranked.place(v, rank_among_levels(levels, value, traits.less_scalar_object()), conversion.to_double(value));
  }
  Level_cutting cut(ranked, numbers);
  Level_cut_report report = {levels.size(), 0, cut.number_of_added_faces(), 0};
  check_face_count(faces(mesh).size() + report.number_of_added_faces, np);
  if constexpr(!is_given<decltype(parameters::get_parameter(np, internal_np::callback))>)
    ranked.keep_splits(); // There may be many, and to remember them takes memory.
  const auto added_vertices = cut(progress.part(0.1, 0.8));
  progress(0.8);
  ranked.keep_splits();
  report.number_of_added_vertices = added_vertices.size();
  report.number_of_slivers = count_slivers(ranked, added_vertices);
  if constexpr(is_written)
    for(const auto& added : added_vertices)
      put(scalar_map, added.vertex, levels[added.level]);
  auto curves = curves_of_levels(ranked, numbers);
  write_bands(ranked, np);
  if(internal::parameter_or(np, cut_open, false))
  {
    const auto copy_value = [&](auto old, auto created) {
      if constexpr(is_written)
        put(scalar_map, created, static_cast<typename Traits::Scalar>(get(scalar_map, old)));
    };
    Curve_opening open(mesh, ranked.vertex_point_map(), visitor, copy_value);
    open(curves);
  }
  mark_edges_and_pieces(mesh, curves, np);
  output = std::copy(curves.begin(), curves.end(), output);
  return report;
}

} // namespace CGAL::Reeb_graph::internal

namespace CGAL::Reeb_graph {

/// \ingroup PkgReebGraphCurves
///
/// \brief refines a mesh so that the level sets of a field at given values become paths of edges: isolines, and the
/// bands between them.
///
/// Each edge whose ends are below and above a level is split at the place where linear interpolation has its value, and
/// the faces between. Vertices whose value is a level are vertices of its curves, and an edge between two of them
/// belongs to a curve. No vertex moves, and the field is not changed: there is nothing to be done with borders. Unlike
/// `cut_along_contours()`, which keeps points away from vertices so that all faces keep a good shape, this makes slivers
/// where levels pass close to vertices or to each other, and counts them.
///
/// The curves are the longest paths of the edges at a level through vertices at which two of these meet. At all others,
/// curves end or branch: at the border, at saddles that are in the level, at ends of ridges and in plateaus. A vertex
/// that is the only one of a level near it is no curve. Those of a lower level come first. Of two sides, the higher one
/// is on the left, where there is one; on the border, `halfedges` or `lower_halfedges` has no face.
///
/// Faces in a level: of a face whose three vertices have the value of a level, all edges belong to curves, so that it is a
/// piece of its own. As for the contours of a value, the level lies above these vertices, so that such faces are in the
/// band below.
///
/// With `cut_open`, the mesh is cut along all these edges but those of the border. Shut stays an edge that is a curve by
/// itself, and ends at no other one and at no border: the two sides of it would have the same ends.
///
/// Handles of the mesh stay valid: an edge that is split keeps its upper part, a face that is split one of its parts.
/// With \f$ n \f$ vertices and faces, \f$ k \f$ levels, and \f$ l \f$ added faces it takes \f$ O(n \log k + l) \f$ time.
///
/// \reebGraphRefinedMeshAndField
/// \tparam LevelRange a range of values of the field, or of what can be converted to such
/// \tparam OutputIterator a model of `OutputIterator` for `Reeb_graph::Curve`
/// \tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"
///
/// \param mesh the mesh, which is changed. To keep it, pass a copy made by `CGAL::copy_face_graph()`.
/// \param scalar_map the scalar field
/// \param levels the values, in any order; one that is there twice counts once, and one that no edge has is no error
/// \param curves the output
/// \param np an optional sequence of \ref bgl_namedparameters "Named Parameters" among those below
///
/// \cgalNamedParamsBegin
///   \cgalParamNBegin{face_band_map}
///     \cgalParamDescription{is set to the number of the band of each face: how many levels are below its highest
///                           vertex. Band 0 is below all levels.}
///     \cgalParamType{a model of `WritablePropertyMap` with the face descriptors as key type and an integer type as
///                    value type}
///     \cgalParamDefault{none}
///     \cgalParamExtra{use the functions `parameters::face_band_map()`}
///   \cgalParamNEnd
/// \cgalNamedParamsEnd
///
/// \copydetails PkgReebGraphCuttingParameters
///
/// \copydetails PkgReebGraphRefinementParameters
///
/// Here, added vertices have exactly the values of their levels.
///
/// \reebGraphComplexity
///
/// \returns how many levels there are, and what has been added.
///
/// \exception Reeb_graph::Unordered_level_error if a level is NaN
///
/// and the exceptions of `compute_reeb_graph()`. When one is thrown, the mesh is as it was before.
template <class MutableFaceGraph,
          class ScalarMap,
          class LevelRange,
          class OutputIterator,
          class NamedParameters = parameters::Default_named_parameters>
Level_cut_report cut_along_levels(MutableFaceGraph& mesh,
                                  ScalarMap scalar_map,
                                  const LevelRange& levels,
                                  OutputIterator curves,
                                  const NamedParameters& np = parameters::default_values())
{
  typedef internal::Chosen_traits<Reeb_graph_traits<MutableFaceGraph, ScalarMap>, NamedParameters> Traits;
  static_assert(internal::are_met<internal::Refinable_mesh<MutableFaceGraph>,
                                  internal::Field_of_numbers<MutableFaceGraph, ScalarMap, Traits>>);
  const internal::Progress progress(np);
  progress.report(0);
  const auto traits = internal::choose_traits<Traits>(np);
  const auto sorted = internal::sorted_levels(levels, traits);
  internal::check_input(mesh, scalar_map, np);
  const Level_cut_report report = internal::cut_along_sorted_levels(mesh, scalar_map, traits, sorted, curves, np,
                                                                    internal::Stage_progress(progress, 0.1, 1));
  progress.report_end();
  return report;
}

} // namespace CGAL::Reeb_graph

#endif // CGAL_REEB_GRAPH_CURVES_CUT_ALONG_LEVELS_H
