// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of the CGAL-style package Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#include "Graph_of_arrays.h"

#include "base/progress_bar.h"
#include "computation/Mesh_graph_of.h"

#include <CGAL/Reeb_graph/embed.h>
#include <CGAL/Reeb_graph/internal/base/scalars.h>
#include <CGAL/compute_reeb_graph_of_soup.h>

#include <boost/range/irange.hpp>

#include <stdexcept>

// The way from the graph back to the mesh: contours and critical sets.
namespace reeb_graph_python {
namespace {
// Makes contours of the library, of surfaces, soups, and tetrahedra, to numbers and points.
class Contour_conversion
{
public:
  // The points have the value that is given, if the field is ranks.
  Contour_conversion(const Input& input, std::optional<double> value) : input_(input), value_(value) {}

  template <class AnyAugmentation, class Contour>
  Contour_of_arrays operator()(const AnyAugmentation& augmentation, const Contour& contour) const
  {
    Contour_of_arrays result;
    result.arc = get(boost::edge_index, augmentation.graph(), contour.arc);
    result.value = value_ ? *value_ + input_.base : contour.value;
    add_edges(contour, result);
    if(!input_.has_points)
      return result;
    if(!value_)
      return add_points(augmentation, contour, result);
    for(const std::array<std::size_t, 2>& edge : result.edges)
      result.points.push_back(crossing(vertex(edge[0]), vertex(edge[1]), *value_));
    return result;
  }

private:
  typedef Surface::Vertex_index Vertex;

  static Vertex vertex(std::size_t v) { return Vertex(static_cast<Surface::size_type>(v)); }

  Point crossing(Vertex lower, Vertex upper, double value) const
  {
    namespace internal = CGAL::Reeb_graph::internal;
    return internal::point_between(
      input_.surface().point(lower), input_.surface().point(upper),
      internal::crossing_fraction(input_.value_map[lower], input_.value_map[upper], value));
  }

  void add_edges(const Augmentation::Contour& contour, Contour_of_arrays& result) const
  {
    result.is_closed = contour.is_closed;
    std::vector<std::size_t>& polyline = result.polylines.emplace_back();
    for(const Surface::Halfedge_index h : contour.halfedges)
    {
      polyline.push_back(result.edges.size());
      result.edges.push_back({input_.surface().source(h), input_.surface().target(h)});
    }
    if(contour.is_closed)
      polyline.push_back(0);
  }

  template <class Arc>
  void add_edges(const CGAL::Reeb_graph::Soup_contour<Arc>& contour, Contour_of_arrays& result) const
  {
    add_crossed_edges(contour.edges, result);
    result.polylines = contour.polylines;
    result.is_closed = contour.branch_points.empty() && contour.polylines.size() == 1
                    && contour.polylines[0].front() == contour.polylines[0].back();
  }

  template <class Arc>
  void add_edges(const CGAL::Reeb_graph::Isosurface_patch<Arc>& patch, Contour_of_arrays& result) const
  {
    add_crossed_edges(patch.edges, result);
    result.triangles = patch.triangles;
  }

  void add_crossed_edges(const std::vector<std::pair<std::size_t, std::size_t>>& edges, Contour_of_arrays& result) const
  {
    for(const auto& [lower, upper] : edges)
      result.edges.push_back({lower, upper});
  }

  Contour_of_arrays add_points(const Augmentation& augmentation,
                               const Augmentation::Contour& contour,
                               Contour_of_arrays& result) const
  {
    augmentation.points_of_contour(contour, std::back_inserter(result.points));
    return result;
  }

  template <class AnyAugmentation, class Contour>
  Contour_of_arrays add_points(const AnyAugmentation&, const Contour& contour, Contour_of_arrays& result) const
  {
    const auto point_of = [this](std::size_t v) { return input_.surface().point(vertex(v)); };
    for(std::size_t i = 0; i < contour.edges.size(); ++i)
      result.points.push_back(CGAL::Reeb_graph::internal::point_of_crossing(contour, i, point_of));
    return result;
  }

  const Input& input_;
  std::optional<double> value_;
};

template <class AnyGraph>
auto arc_of_number(const AnyGraph& graph, std::size_t arc)
{
  return *std::next(edges(graph).first, static_cast<std::ptrdiff_t>(arc));
}

template <class Function>
auto with_triangles(const Complex& complex, const Function& function)
{
  if(complex.tetrahedra.empty())
    return function(complex.triangles);
  std::vector<std::array<std::uint32_t, 3>> triangles = complex.triangles;
  for(const auto& t : complex.tetrahedra)
    triangles.insert(triangles.end(), {{t[0], t[1], t[2]}, {t[0], t[1], t[3]}, {t[0], t[2], t[3]}, {t[1], t[2], t[3]}});
  return function(triangles);
}

} // namespace

// Where tetrahedra and other triangles are together, the faces of all tetrahedra are triangles too.
Complex_graph Graph_of_arrays::compute_complex(Report& report) const
{
  typedef CGAL::Parallel_if_available_tag Tag;
  const Complex& complex = *input_->mesh.complex;
  const auto scalars = CGAL::make_range(input_->scalar_map.begin(), input_->scalar_map.end());
  const std::size_t number = input_->number_of_vertices();
  return compute_and_time(options_, report, [&](const auto& given_parameters) {
    const auto np = CGAL::parameters::edges(std::cref(complex.edges), given_parameters);
    Complex_graph graph;
    if(complex.triangles.empty() && !complex.tetrahedra.empty())
      CGAL::compute_reeb_graph_of_tetrahedra<Tag>(number, complex.tetrahedra, scalars, graph, np);
    else
      with_triangles(complex, [&](const auto& triangles) {
        CGAL::compute_reeb_graph_of_soup<Tag>(number, triangles, scalars, graph, np);
      });
    return graph;
  });
}

// Without chains.
Graph Graph_of_arrays::on_vertices(const Complex_graph& graph) const
{
  typedef CGAL::Reeb_graph_traits<Surface, Scalar_map> Traits;
  Graph result;
  for(const auto node : CGAL::make_range(vertices(graph)))
  {
    const Surface::Vertex_index v(static_cast<Surface::size_type>(graph[node].vertex));
    add_vertex(Traits::Node{graph[node].value, v, graph[node].kind}, result);
  }
  for(const auto arc : CGAL::make_range(edges(graph)))
    put(boost::edge_index, result, add_edge(source(arc, graph), target(arc, graph), result).first,
        get(boost::edge_index, graph, arc));
  return result;
}

std::vector<std::size_t> Graph_of_arrays::places_in_complex() const
{
  const auto locate = [this](const auto& augmentation) {
    return places_of(boost::irange(std::size_t(0), input_->number_of_vertices()),
                     augmentation.template locate_vertices<CGAL::Parallel_if_available_tag>());
  };
  const Complex& complex = *input_->mesh.complex;
  return complex.triangles.empty() && !complex.tetrahedra.empty() ? locate(make(tetrahedra_augmentation_))
                                                                  : locate(make(soup_augmentation_));
}

CGAL::Reeb_graph::Embedding<Point> Graph_of_arrays::embed_on_surface(CGAL::Reeb_graph::Embedding_manner manner) const
{
  Progress_bar progress_bar("embedding");
  return CGAL::Reeb_graph::embed<CGAL::Parallel_if_available_tag>(
    augmentation(), CGAL::parameters::embedding_manner(manner).callback(std::ref(progress_bar)));
}

// Calls the function with the augmentation that the mesh needs.
template <class Function>
auto Graph_of_arrays::with_augmentation(const Function& function) const
{
  const std::lock_guard lock(mutex_);
  if(is_surface())
    return function(augmentation());
  const Complex& complex = *input_->mesh.complex;
  if(complex.has_triangles_and_tetrahedra())
    throw std::invalid_argument("there are triangles that are faces of no tetrahedron: contours of such a mesh are "
                                "neither polylines nor triangles");
  if(complex.tetrahedra.empty())
    return function(make(soup_augmentation_));
  return function(make(tetrahedra_augmentation_));
}

template <class AnyAugmentation>
const AnyAugmentation& Graph_of_arrays::make(std::unique_ptr<AnyAugmentation>& augmentation) const
{
  if(augmentation)
    return *augmentation;
  const Complex& complex = *input_->mesh.complex;
  const auto construct = [&](const auto& cells) {
    const auto& map = input_->scalar_map;
    const auto call = [&](const auto& np) {
      augmentation = std::make_unique<AnyAugmentation>(
        input_->number_of_vertices(), cells, CGAL::make_range(map.begin(), map.end()), complex_graph_->result(), np);
    };
    const auto np = CGAL::parameters::edges(std::cref(complex.edges), named_parameters(options_));
    if(const auto& simplification = complex_graph_->simplification())
      call(CGAL::parameters::simplification(*simplification, np));
    else
      call(np);
  };
  if constexpr(std::is_same_v<AnyAugmentation, Soup_augmentation>)
    with_triangles(complex, construct);
  else
    construct(complex.tetrahedra);
  return *augmentation;
}

Contour_of_arrays Graph_of_arrays::contour_at_parameter(std::size_t arc, double t) const
{
  return with_augmentation([&](const auto& augmentation) {
    return Contour_conversion(*input_, std::nullopt)(augmentation,
                                                     augmentation.contour(arc_of_number(augmentation.graph(), arc), t));
  });
}

Contour_of_arrays Graph_of_arrays::contour_at_level(std::size_t arc, double level, std::optional<double> value) const
{
  return with_augmentation([&](const auto& augmentation) {
    return Contour_conversion(*input_, value)(
      augmentation, augmentation.contour_at_value(arc_of_number(augmentation.graph(), arc), level));
  });
}

std::vector<Contour_of_arrays> Graph_of_arrays::contours_at_level(double level, std::optional<double> value) const
{
  return with_augmentation([&](const auto& augmentation) {
    std::vector<Contour_of_arrays> contours;
    for(const auto& contour : augmentation.template contours_at_value<CGAL::Parallel_if_available_tag>(level))
      contours.push_back(Contour_conversion(*input_, value)(augmentation, contour));
    return contours;
  });
}

Critical_set_of_arrays Graph_of_arrays::critical_set(std::size_t node) const
{
  return with_augmentation([&](const auto& augmentation) {
    const auto set = augmentation.critical_set(node);
    const Surface::Vertex_index v = graph()[node].vertex;
    const std::optional<double> value =
      input_->is_ranked() ? std::optional<double>(input_->value_map[v]) : std::nullopt;
    const Contour_conversion convert(*input_, value);
    Critical_set_of_arrays result;
    for(const auto& contour : set.lower_contours)
      result.lower_contours.push_back(convert(augmentation, contour));
    for(const auto& contour : set.upper_contours)
      result.upper_contours.push_back(convert(augmentation, contour));
    result.star.assign(set.star.begin(), set.star.end());
    if constexpr(std::is_same_v<std::decay_t<decltype(augmentation)>, Augmentation>)
      for(const Surface::Halfedge_index h : set.border_loop)
        result.border_loop.push_back(input_->surface().target(h));
    return result;
  });
}

} // namespace reeb_graph_python
