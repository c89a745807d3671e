// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_CURVES_INTERNAL_CUT_AND_MARK_H
#define CGAL_REEB_GRAPH_CURVES_INTERNAL_CUT_AND_MARK_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/curves/Curve.h>
#include <CGAL/Reeb_graph/curves/Refinement_visitor.h>
#include <CGAL/Reeb_graph/curves/exceptions.h>
#include <CGAL/Reeb_graph/curves/internal/Contour_cutting.h>
#include <CGAL/Reeb_graph/curves/internal/Refined_field.h>
#include <CGAL/Reeb_graph/internal/base/Progress.h>
#include <CGAL/Reeb_graph/internal/base/scalars.h>
#include <CGAL/Reeb_graph/internal/complex/Curve_opening.h>
#include <CGAL/Reeb_graph/named_parameters.h>

#include <CGAL/Polygon_mesh_processing/connected_components.h>
#include <CGAL/boost/graph/named_params_helper.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <type_traits>
#include <vector>

namespace CGAL::Reeb_graph::internal {

template <class Mesh, class NamedParameters>
auto choose_refinement_visitor(const Mesh&, const NamedParameters& np)
{
  return parameters::choose_parameter<Default_refinement_visitor<Mesh>>(
    parameters::get_parameter(np, internal_np::visitor));
}

template <class Mesh, class Visitor, class NamedParameters>
auto make_ranked_mesh(Mesh& mesh, Visitor& visitor, const NamedParameters& np)
{
  const auto vertex_point_map = parameters::choose_parameter(parameters::get_parameter(np, internal_np::vertex_point),
                                                             get_property_map(vertex_point, mesh));
  return Ranked_mesh<Mesh, std::decay_t<decltype(vertex_point_map)>, Visitor>(mesh, vertex_point_map, visitor);
}

// The levels at which a contour stays the same lie between two ranks; its value is in the middle of theirs.
template <class RankedMesh, class HalfedgeDescriptor>
Contour_to_cut<HalfedgeDescriptor> make_contour_to_cut(const RankedMesh& ranked,
                                                       const std::vector<HalfedgeDescriptor>& halfedges,
                                                       bool is_closed)
{
  const auto& mesh = ranked.mesh();
  const auto has_lower_source = [&](HalfedgeDescriptor a, HalfedgeDescriptor b) {
    return ranked.rank(source(a, mesh)) < ranked.rank(source(b, mesh));
  };
  const auto has_lower_target = [&](HalfedgeDescriptor a, HalfedgeDescriptor b) {
    return ranked.rank(target(a, mesh)) < ranked.rank(target(b, mesh));
  };
  const auto lower = source(*std::max_element(halfedges.begin(), halfedges.end(), has_lower_source), mesh);
  const auto upper = target(*std::min_element(halfedges.begin(), halfedges.end(), has_lower_target), mesh);
  const double value = value_at_fraction(ranked.value(lower), ranked.value(upper), 0.5);
  return {halfedges, is_closed, std::isfinite(value) ? value : ranked.value(lower), ranked.rank(lower),
          ranked.value(upper) < ranked.value(lower)};
}

// Whether each two halfedges that follow each other are edges of one face, on the right of the first one.
template <class RankedMesh, class HalfedgeDescriptor>
bool is_connected(const RankedMesh& ranked, const std::vector<HalfedgeDescriptor>& halfedges, bool is_closed)
{
  const auto& mesh = ranked.mesh();
  const std::size_t size = halfedges.size();
  for(std::size_t i = 0; i + (is_closed ? 0 : 1) < size; ++i)
  {
    const HalfedgeDescriptor h = opposite(halfedges[i], mesh), following = halfedges[(i + 1) % size];
    if(is_border(h, mesh) || (next(h, mesh) != following && prev(h, mesh) != following))
      return false;
  }
  return is_closed || (is_border(halfedges.front(), mesh) && is_border(opposite(halfedges.back(), mesh), mesh));
}

// Checks that the halfedges of each contour ascend, follow each other, and cross a common level.
template <class RankedMesh, class ContourRange>
auto make_contours_to_cut(const RankedMesh& ranked, const ContourRange& contours)
{
  typedef typename RankedMesh::halfedge_descriptor halfedge_descriptor;
  const auto& mesh = ranked.mesh();
  std::vector<Contour_to_cut<halfedge_descriptor>> result;
  for(const auto& contour : contours)
  {
    if(contour.edges.empty() || !is_connected(ranked, contour.edges, contour.is_closed()))
      throw Invalid_contour_error(result.size());
    result.push_back(make_contour_to_cut(ranked, contour.edges, contour.is_closed()));
    for(const halfedge_descriptor h : contour.edges)
    {
      if(ranked.rank(target(h, mesh)) <= result.back().lower_rank)
        throw Invalid_contour_error(result.size() - 1);
    }
    result.back().value = contour.value;
  }
  return result;
}

// Calls mark(edge, curve) for each edge of each curve, for both copies if the mesh has been cut open.
template <class Mesh, class HalfedgeDescriptor, class Mark>
void for_each_curve_edge(const Mesh& mesh, const std::vector<Curve<HalfedgeDescriptor>>& curves, const Mark& mark)
{
  for(std::size_t curve = 0; curve != curves.size(); ++curve)
  {
    for(const HalfedgeDescriptor h : curves[curve].halfedges)
      mark(edge(h, mesh), curve);
    for(const HalfedgeDescriptor h : curves[curve].lower_halfedges)
      mark(edge(h, mesh), curve);
  }
}

template <class Mesh, class HalfedgeDescriptor, class NamedParameters>
void mark_edges(const Mesh& mesh, const std::vector<Curve<HalfedgeDescriptor>>& curves, const NamedParameters& np)
{
  using parameters::get_parameter;
  typedef typename boost::graph_traits<Mesh>::edge_descriptor edge_descriptor;
  if constexpr(is_given<decltype(get_parameter(np, internal_np::edge_is_constrained))>)
  {
    auto map = get_parameter(np, internal_np::edge_is_constrained);
    for_each_curve_edge(mesh, curves, [&](edge_descriptor e, std::size_t) { put(map, e, true); });
  }
  if constexpr(is_given<decltype(get_parameter(np, edge_curve_map))>)
  {
    auto map = get_parameter(np, edge_curve_map);
    for_each_curve_edge(mesh, curves, [&](edge_descriptor e, std::size_t curve) { put(map, e, curve); });
  }
}

// Numbers the pieces into which the curves cut the mesh in the order of their first faces. Returns their number.
template <class Mesh, class HalfedgeDescriptor, class PatchMap>
std::size_t number_patches(const Mesh& mesh,
                           const std::vector<Curve<HalfedgeDescriptor>>& curves,
                           const PatchMap& patch_map)
{
  typedef typename boost::graph_traits<Mesh>::edge_descriptor edge_descriptor;
  const auto is_curve_edge = get(dynamic_edge_property_t<bool>(), mesh);
  for(const edge_descriptor e : edges(mesh))
    put(is_curve_edge, e, false);
  for_each_curve_edge(mesh, curves, [&](edge_descriptor e, std::size_t) { put(is_curve_edge, e, true); });
  return Polygon_mesh_processing::connected_components(mesh, patch_map,
                                                       parameters::edge_is_constrained_map(is_curve_edge));
}

// Tells the named parameter `face_count_callback` the number of faces that cutting is going to make.
template <class NamedParameters>
void check_face_count(std::size_t number, const NamedParameters& np)
{
  using parameters::get_parameter;
  if constexpr(is_given<decltype(get_parameter(np, face_count_callback))>)
  {
    auto callback = get_parameter(np, face_count_callback);
    if(!callback(number))
      throw Face_count_error(number);
  }
}

// Their number for contours. A triangle with k new vertices on its edges becomes k + 1 triangles, and a contour has two
// of them in each triangle that it crosses.
template <class Mesh, class HalfedgeDescriptor>
std::size_t number_of_faces_cut_along(const Mesh& mesh, const std::vector<Contour_to_cut<HalfedgeDescriptor>>& contours)
{
  std::size_t number = faces(mesh).size();
  for(const auto& contour : contours)
    number += 2 * (contour.halfedges.size() - (contour.is_closed ? 0 : 1));
  return number;
}

// Writes the edges of curves and the pieces between them to the property maps that have been asked for.
template <class Mesh, class HalfedgeDescriptor, class NamedParameters>
void mark_edges_and_pieces(const Mesh& mesh,
                           const std::vector<Curve<HalfedgeDescriptor>>& curves,
                           const NamedParameters& np)
{
  using parameters::get_parameter;
  mark_edges(mesh, curves, np);
  if constexpr(is_given<decltype(get_parameter(np, internal_np::face_patch))>)
  {
    auto face_patch_map = get_parameter(np, internal_np::face_patch);
    const auto patch_map = get(dynamic_face_property_t<std::size_t>(), mesh);
    number_patches(mesh, curves, patch_map);
    for(const auto f : faces(mesh))
      put(face_patch_map, f, get(patch_map, f));
  }
}

// Cuts a mesh along contours, and writes the field and the property maps that have been asked for. If it is
// cancelled, the mesh is as it was before the first split.
template <class RankedMesh, class ScalarMap, class Traits, class NamedParameters>
std::vector<Curve<typename RankedMesh::halfedge_descriptor>> cut_and_mark(
  const RankedMesh& ranked,
  const std::vector<Contour_to_cut<typename RankedMesh::halfedge_descriptor>>& contours,
  const ScalarMap& scalar_map,
  const Traits& traits,
  const NamedParameters& np,
  const Stage_progress& progress)
{
  using parameters::choose_parameter;
  using parameters::get_parameter;
  auto& mesh = ranked.mesh();
  check_face_count(number_of_faces_cut_along(mesh, contours), np);
  Refined_field<RankedMesh, ScalarMap, Traits> field(ranked, scalar_map, traits);
  field.write_ranked_vertices();
  field.place_contours(contours);
  if constexpr(!is_given<decltype(get_parameter(np, internal_np::callback))>)
    ranked.keep_splits(); // There may be many, and to remember them takes memory.
  auto curves = Contour_cutting<RankedMesh>(ranked, contours)(progress.part(0.05, 0.8));
  progress(0.8);
  ranked.keep_splits();
  if(choose_parameter(get_parameter(np, cut_open), false))
  {
    Curve_opening open(mesh, ranked.vertex_point_map(), ranked.visitor());
    open(curves);
  }
  progress.tell(0.9);
  field.write_curves(curves);
  mark_edges_and_pieces(mesh, curves, np);
  return curves;
}

// Refines a mesh so that the contours of find_contours(ranked mesh, its progress) become paths of edges, and outputs
// these.
template <class Mesh, class ScalarMap, class Traits, class OutputIterator, class NamedParameters, class FindContours>
OutputIterator cut_along_found_contours(Mesh& mesh,
                                        const ScalarMap& scalar_map,
                                        const Traits& traits,
                                        OutputIterator output,
                                        const NamedParameters& np,
                                        const Stage_progress& finding,
                                        const Stage_progress& cutting,
                                        const FindContours& find_contours)
{
  auto visitor_parameter = choose_refinement_visitor(mesh, np);
  const auto ranked = make_ranked_mesh(mesh, unwrap_reference(visitor_parameter), np);
  const auto contours = find_contours(ranked, finding);
  const auto curves = cut_and_mark(ranked, contours, scalar_map, traits, np, cutting);
  return std::copy(curves.begin(), curves.end(), output);
}

} // namespace CGAL::Reeb_graph::internal

#endif // CGAL_REEB_GRAPH_CURVES_INTERNAL_CUT_AND_MARK_H
