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
#include <CGAL/Reeb_graph/internal/base/Progress.h>
#include <CGAL/Reeb_graph/internal/base/Scalar_conversion.h>
#include <CGAL/Reeb_graph/internal/base/interpolation.h>
#include <CGAL/Reeb_graph/internal/base/requirements.h>
#include <CGAL/Reeb_graph/internal/complex/Curve_opening.h>
#include <CGAL/Reeb_graph/named_parameters.h>

#include <CGAL/Dynamic_property_map.h>
#include <CGAL/Polygon_mesh_processing/connected_components.h>
#include <CGAL/boost/graph/iterator.h>
#include <CGAL/boost/graph/named_params_helper.h>
#include <CGAL/boost/graph/properties.h>

#include <boost/property_map/property_map.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <type_traits>
#include <unordered_map>
#include <utility>
#include <vector>

namespace CGAL::Reeb_graph::internal {

template <class Scalar>
using Half_of_difference = decltype(Scalar((std::declval<Scalar>() - std::declval<Scalar>()) / Scalar(2)));
template <class Scalar>
inline constexpr bool has_mean = Has<Half_of_difference, Scalar>::value;

// The value that is asked for, or the next to it that there is for certain between the two.
template <class Scalar>
Scalar candidate_between(const Scalar& lower, const Scalar& upper, double wish)
{
  if constexpr(std::is_floating_point_v<Scalar>)
  {
    const bool is_rising = lower < upper;
    const Scalar first = std::nextafter(lower, upper), last = std::nextafter(upper, lower);
    const Scalar low = is_rising ? first : last, high = is_rising ? last : first;
    return (std::min)((std::max)(static_cast<Scalar>(wish), low), high);
  }
  else if constexpr(std::is_integral_v<Scalar>)
  {
    const auto [low, high] = std::minmax(lower, upper);
    if(low == high || static_cast<Scalar>(low + 1) == high)
      return lower;
    const Scalar first = static_cast<Scalar>(low + 1), last = static_cast<Scalar>(high - 1);
    // Conversions to `double` round, so that a wish between the two may be a little beyond them.
    if(!(wish > static_cast<double>(first)))
      return first;
    return wish < static_cast<double>(last) ? (std::min)((std::max)(static_cast<Scalar>(std::floor(wish)), first), last)
                                            : last;
  }
  else if constexpr(has_mean<Scalar>)
    return (lower + upper) / Scalar(2);
  else
    return lower;
}

// A bound for the values next to one, on the way to another: numbers that are not rounded have no next one.
template <class Scalar>
Scalar value_near(const Scalar& value, const Scalar& other)
{
  if constexpr(has_mean<Scalar> && !std::is_arithmetic_v<Scalar>)
    return value + (other - value) / Scalar(1 << 30);
  else
    return other;
}

// A value strictly between two others, as near as possible to the one that is asked for. If there is none, it is the
// lower one: a vertex that is added comes behind the others of its value.
template <class Scalar, class Less>
Scalar value_between(const Scalar& lower, const Scalar& upper, double wish, const Less& less)
{
  const auto is_between = [&](const Scalar& value) { return less(lower, value) && less(value, upper); };
  if constexpr(!std::is_integral_v<Scalar> && std::is_constructible_v<Scalar, double>)
  {
    const Scalar value(std::isfinite(wish) ? wish : 0.); // not all numbers can be infinite
    if(is_between(value))
      return value;
  }
  const Scalar value = candidate_between(lower, upper, wish);
  return is_between(value) ? value : lower;
}

// Whether a map can be written at vertices that are added. One over a range of fixed size has no room for them.
template <class PropertyMap>
struct Has_room_for_added_vertices : std::bool_constant<CGAL::internal::Is_writable_property_map<PropertyMap>::value>
{
};
template <class Iterator, class IndexMap, class Value, class Reference>
struct Has_room_for_added_vertices<boost::iterator_property_map<Iterator, IndexMap, Value, Reference>> : std::false_type
{
};
template <class Iterator, class IndexMap, class Value, class Reference>
struct Has_room_for_added_vertices<boost::safe_iterator_property_map<Iterator, IndexMap, Value, Reference>>
  : std::false_type
{
};
// of a mesh that is const
template <class Key, class Value>
struct Has_room_for_added_vertices<CGAL::internal::Dynamic_with_index<Key, Value>> : std::false_type
{
};

// Whether the field is written at vertices that are added.
template <class ScalarMap, class Traits>
inline constexpr bool is_field_written =
  Has_room_for_added_vertices<ScalarMap>::value
  && (std::is_constructible_v<typename Traits::Scalar, double> || Has<Scalar_from_double, Traits>::value)
  && std::is_convertible_v<typename Traits::Scalar, typename boost::property_traits<ScalarMap>::value_type>;

// The field at the vertices that a refinement adds: values in the order of the ranks and of the contours, as far as
// there are numbers, so that the Reeb graph stays the same.
template <class RankedMesh, class ScalarMap, class Traits>
class Refined_field
{
  typedef typename Traits::Scalar Scalar;
  typedef typename RankedMesh::vertex_descriptor vertex_descriptor;
  typedef typename RankedMesh::halfedge_descriptor halfedge_descriptor;
  typedef Contour_to_cut<halfedge_descriptor> Contour;
  static constexpr bool is_written = is_field_written<ScalarMap, Traits>;

public:
  Refined_field(const RankedMesh& ranked, const ScalarMap& scalar_map, const Traits& traits)
    : ranked_(ranked),
      scalar_map_(scalar_map),
      less_(traits.less_scalar_object()),
      conversion_(traits)
  {}

  // Writes the values of the vertices that have got ranks between those of others.
  void write_ranked_vertices()
  {
    if constexpr(is_written)
    {
      std::vector<vertex_descriptor> added;
      for(const vertex_descriptor v : vertices(ranked_.mesh()))
      {
        if(is_added(v))
          added.push_back(v);
      }
      std::sort(added.begin(), added.end(),
                [&](vertex_descriptor u, vertex_descriptor v) { return ranked_.rank(u) < ranked_.rank(v); });
      place(added);
    }
  }

  // Finds the values of contours, for write_curves().
  void place_contours(const std::vector<Contour>& contours)
  {
    if constexpr(is_written)
    {
      for(const Contour& contour : contours)
        lower_values_.push_back(end_value(contour, false));
      values_ = lower_values_;
      const std::vector<std::size_t> order = sorted_contours(contours);
      // first above those below it, then, where there was no number left, below those above it
      for_each_contour(contours, order.begin(), order.end(), [&](std::size_t i, const std::vector<std::size_t>& lower) {
        std::optional<Scalar> below = lower_values_[i];
        for(const std::size_t j : lower)
          bound_by(below, values_[j], false);
        values_[i] = between(*below, end_value(contours[i], true), contours[i].value);
      });
      for_each_contour(contours, order.rbegin(), order.rend(),
                       [&](std::size_t i, const std::vector<std::size_t>& upper) {
                         std::optional<Scalar> above = end_value(contours[i], true);
                         for(const std::size_t j : upper)
                           bound_by(above, values_[j], true);
                         if(!less_(values_[i], *above))
                           values_[i] = between(lower_values_[i], *above, contours[i].value);
                       });
    }
  }

  // Writes the values of the vertices on both sides of the curves that the contours have become.
  void write_curves(const std::vector<Curve<halfedge_descriptor>>& curves)
  {
    if constexpr(is_written)
    {
      const auto& mesh = ranked_.mesh();
      for(std::size_t i = 0; i != curves.size(); ++i)
        for(const auto* halfedges : {&curves[i].halfedges, &curves[i].lower_halfedges})
          for(const halfedge_descriptor h : *halfedges)
          {
            put(scalar_map_, source(h, mesh), values_[i]);
            put(scalar_map_, target(h, mesh), values_[i]);
          }
    }
  }

private:
  Scalar scalar(vertex_descriptor v) const { return get(scalar_map_, v); }
  bool is_added(vertex_descriptor v) const { return ranked_.rank(v) % ranked_.rank_spacing() != 0; }
  // Lowers an upper bound, or raises a lower one.
  void bound_by(std::optional<Scalar>& bound, const Scalar& value, bool is_upper) const
  {
    if(!bound || (is_upper ? less_(value, *bound) : less_(*bound, value)))
      bound = value;
  }

  // Calls visit(u) for each neighbor and for the vertex that comes before, if both are between the same two vertices.
  template <class Visit>
  void for_each_bound(vertex_descriptor v, const vertex_descriptor* before, const Visit& visit) const
  {
    for(const vertex_descriptor u : vertices_around_target(v, ranked_.mesh()))
      visit(u);
    if(before != nullptr && ranked_.rank(*before) / ranked_.rank_spacing() == ranked_.rank(v) / ranked_.rank_spacing())
      visit(*before);
  }

  // Places vertices, in ascending order, first above what is below them, then, where there was no number left, below
  // what is above them.
  void place(const std::vector<vertex_descriptor>& added)
  {
    std::unordered_map<Long_index, Scalar> lower_values; // the highest ones of vertices that are not added
    for(std::size_t i = 0; i != added.size(); ++i)
    {
      const vertex_descriptor v = added[i];
      std::optional<Scalar> below, given_below, above;
      for_each_bound(v, i == 0 ? nullptr : &added[i - 1], [&](vertex_descriptor u) {
        if(ranked_.rank(u) < ranked_.rank(v))
        {
          bound_by(below, scalar(u), false);
          bound_by(given_below, is_added(u) ? lower_values.at(ranked_.rank(u)) : scalar(u), false);
        }
        else if(!is_added(u))
          bound_by(above, scalar(u), true);
      });
      lower_values.emplace(ranked_.rank(v), given_below ? *given_below : *above);
      const Scalar lowest = below ? *below : *above;
      put(scalar_map_, v, value_next_to_vertex(v, lowest, above ? *above : lowest));
    }
    for(std::size_t i = added.size(); i-- != 0;)
    {
      const vertex_descriptor v = added[i];
      std::optional<Scalar> above;
      for_each_bound(v, i + 1 == added.size() ? nullptr : &added[i + 1], [&](vertex_descriptor u) {
        if(ranked_.rank(v) < ranked_.rank(u))
          bound_by(above, scalar(u), true);
      });
      if(above && !less_(scalar(v), *above))
        put(scalar_map_, v, value_next_to_vertex(v, lower_values.at(ranked_.rank(v)), *above));
    }
  }

  // The rank of an added vertex is next to that of the vertex below or above.
  Scalar value_next_to_vertex(vertex_descriptor v, const Scalar& below, const Scalar& above) const
  {
    const bool is_next_to_lower = ranked_.rank(v) % ranked_.rank_spacing() < ranked_.rank_spacing() / 2;
    return is_next_to_lower ? between(below, value_near(below, above), ranked_.value(v))
                            : between(value_near(above, below), above, ranked_.value(v));
  }

  // A value strictly between two others, if possible the one that the traits class makes of the number.
  Scalar between(const Scalar& lower, const Scalar& upper, double wish) const
  {
    if constexpr(Has<Scalar_from_double, Traits>::value)
    {
      const Scalar value = std::isfinite(wish) ? *conversion_.from_double(wish, false) : lower;
      if(less_(lower, value) && less_(value, upper))
        return value;
    }
    return value_between(lower, upper, wish, less_);
  }

  // Of all upper ends the lowest, or of all lower ones the highest.
  Scalar end_value(const Contour& contour, bool is_upper) const
  {
    std::optional<Scalar> value;
    for(const halfedge_descriptor h : contour.halfedges)
      bound_by(value, scalar(is_upper ? target(h, ranked_.mesh()) : source(h, ranked_.mesh())), is_upper);
    return *value;
  }

  // Calls place(i, those of the contours before it that are the last ones at its edges) for each contour, in this
  // order.
  template <class Iterator, class Place>
  void for_each_contour(const std::vector<Contour>& contours, Iterator begin, Iterator end, const Place& place)
  {
    const auto& mesh = ranked_.mesh();
    const auto last_map = get(dynamic_edge_property_t<std::size_t>(), ranked_.mesh()); // one more than the contour
    for(const Contour& contour : contours)
      for(const halfedge_descriptor h : contour.halfedges)
        put(last_map, edge(h, mesh), 0);
    std::vector<std::size_t> before;
    for(; begin != end; ++begin)
    {
      before.clear();
      for(const halfedge_descriptor h : contours[*begin].halfedges)
      {
        const std::size_t last = get(last_map, edge(h, mesh));
        if(last != 0)
          before.push_back(last - 1);
        put(last_map, edge(h, mesh), *begin + 1);
      }
      place(*begin, before);
    }
  }

  const RankedMesh& ranked_;
  ScalarMap scalar_map_;
  const typename Traits::Less_scalar less_;
  const Scalar_conversion<Traits> conversion_;
  std::vector<Scalar> lower_values_, values_; // of the highest lower ends of contours, and of contours
};

template <class Mesh, class NamedParameters>
auto choose_refinement_visitor(const Mesh&, const NamedParameters& np)
{
  return internal::parameter_or(np, internal_np::visitor, Default_refinement_visitor<Mesh>());
}

template <class Mesh, class Visitor, class NamedParameters>
auto make_ranked_mesh(Mesh& mesh, Visitor& visitor, const NamedParameters& np)
{
  const auto vertex_point_map =
    internal::parameter_or(np, internal_np::vertex_point, get_property_map(vertex_point, mesh));
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
  if(internal::parameter_or(np, cut_open, false))
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
