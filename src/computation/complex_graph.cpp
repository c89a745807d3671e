// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#include "computation/Mesh_graph_of.h"

#include <CGAL/Reeb_graph/Complex_augmentation.h>
#include <CGAL/Reeb_graph/arc_measures.h>
#include <CGAL/Reeb_graph/embed.h>
#include <CGAL/compute_reeb_graph_of_soup.h>

#include <boost/property_map/property_map.hpp>
#include <boost/range/irange.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <iterator>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

namespace reeb_graph_program {
namespace {
typedef CGAL::Reeb_graph::Soup_augmentation<double> Soup_augmentation;
typedef CGAL::Reeb_graph::Tetrahedra_augmentation<double> Tetrahedra_augmentation;

// What graphs of triangles and those of tetrahedra have in common.
class Complex_kind
{
public:
  typedef Complex_graph Graph;

  Complex_kind(const Mesh& mesh, Scalar_map scalar_map) : mesh_(mesh), scalar_map_(scalar_map) {}

  auto named_parameters(const Graph_options& options) const
  {
    return reeb_graph_program::named_parameters(options).edges(std::cref(complex().edges));
  }

  // The same graph with descriptors of the surface that has the vertices, without chains.
  const reeb_graph_program::Graph& on_surface(const Complex_graph& graph,
                                              std::optional<reeb_graph_program::Graph>& result) const
  {
    typedef CGAL::Reeb_graph_traits<Surface, Scalar_map> Traits;
    if(result)
      return *result;
    result.emplace();
    for(const auto node : CGAL::make_range(boost::vertices(graph)))
    {
      const Surface::Vertex_index v(static_cast<Surface::size_type>(graph[node].vertex));
      add_vertex(Traits::Node{graph[node].value, v, graph[node].kind}, *result);
    }
    for(const auto arc : CGAL::make_range(edges(graph)))
      put(boost::edge_index, *result, add_edge(source(arc, graph), target(arc, graph), *result).first,
          get(boost::edge_index, graph, arc));
    return *result;
  }

  std::size_t end_of_vertices() const { return number_of_vertices(); }
  auto points() const { return CGAL::make_range(mesh_.surface.points().begin(), mesh_.surface.points().end()); }
  boost::typed_identity_property_map<std::size_t> vertex_numbers() const { return {}; }

  template <class Any_augmentation, class NamedParameters>
  auto embed(const Any_augmentation& augmentation, const NamedParameters& np) const
  {
    return CGAL::Reeb_graph::embed<CGAL::Parallel_if_available_tag>(augmentation, points(), np);
  }

  const std::pair<std::size_t, std::size_t>& ends(const std::pair<std::size_t, std::size_t>& edge) const
  {
    return edge;
  }
  template <class CriticalSet>
  std::vector<std::size_t> border_loop(const CriticalSet&) const
  {
    return {};
  }

  Scalar_map scalar_map() const { return scalar_map_; }

  Nearest_place nearest_place(const Point& point) const
  {
    Nearest_place place(point);
    const auto vertex = [](std::uint32_t v) { return Surface::Vertex_index(v); };
    const auto at = [&](auto v) { return mesh_.surface.point(vertex(v)); };
    const auto value = [&](auto v) { return scalar_map_[vertex(v)]; };
    for(const auto& [a, b] : complex().edges)
      place.add_triangle({at(a), at(b), at(b)}, {value(a), value(b), value(b)});
    for(const auto& [a, b, c] : complex().triangles)
      place.add_triangle({at(a), at(b), at(c)}, {value(a), value(b), value(c)});
    for(const auto& [a, b, c, d] : complex().tetrahedra)
      place.add_tetrahedron({at(a), at(b), at(c), at(d)}, {value(a), value(b), value(c), value(d)});
    return place;
  }

protected:
  const Complex& complex() const { return *mesh_.complex; }
  std::size_t number_of_vertices() const { return mesh_.surface.number_of_vertices(); }
  auto vertices() const { return boost::irange(std::size_t(0), number_of_vertices()); }
  auto scalars() const { return CGAL::make_range(scalar_map_.begin(), scalar_map_.end()); }

  template <class AnyAugmentation>
  Arc_column mean_value_column(const AnyAugmentation& augmentation, const std::vector<std::size_t>& places) const
  {
    return {{"mean_value", CGAL::Reeb_graph::arc_mean_values(augmentation, points(), Vertex_places{places})},
            Arc_joining::MEAN_BY_AREA,
            Arc_unit::VALUE,
            false};
  }

  template <class AnyAugmentation>
  Contour crossings(const AnyAugmentation& augmentation, const typename AnyAugmentation::Contour& contour) const
  {
    Contour result;
    for(const auto& [lower, upper] : contour.edges)
      result.edges.push_back({lower, upper});
    augmentation.points_of_contour(contour, std::back_inserter(result.points), points());
    return result;
  }

  // Calls function(triangles). Where tetrahedra and other triangles are together, the faces of all tetrahedra are
  // triangles too: the graph is the same.
  template <class Function>
  auto with_triangles(const Function& function) const
  {
    if(complex().tetrahedra.empty())
      return function(complex().triangles);
    std::vector<std::array<std::uint32_t, 3>> triangles = complex().triangles;
    for(const auto& t : complex().tetrahedra)
      triangles.insert(triangles.end(),
                       {{t[0], t[1], t[2]}, {t[0], t[1], t[3]}, {t[0], t[2], t[3]}, {t[1], t[2], t[3]}});
    return function(triangles);
  }

private:
  const Mesh& mesh_;
  const Scalar_map scalar_map_;
};

// Contours are polylines.
class Triangles_kind : public Complex_kind
{
public:
  typedef Soup_augmentation Augmentation;
  using Complex_kind::Complex_kind;

  template <class NamedParameters>
  Complex_graph compute(const NamedParameters& np) const
  {
    Complex_graph graph;
    with_triangles([&](const auto& triangles) {
      CGAL::compute_reeb_graph_of_soup<CGAL::Parallel_if_available_tag>(number_of_vertices(), triangles, scalars(),
                                                                        graph, np);
    });
    return graph;
  }

  template <class NamedParameters>
  std::unique_ptr<const Augmentation> augment(const Complex_graph& graph, const NamedParameters& np) const
  {
    return with_triangles([&](const auto& triangles) {
      return std::make_unique<const Augmentation>(number_of_vertices(), triangles, scalars(), graph, np);
    });
  }

  template <class MakeAugmentation>
  std::vector<Arc_column> measure_arcs(const Complex_graph& graph,
                                       const std::vector<std::size_t>& places,
                                       const MakeAugmentation& make_augmentation) const
  {
    const Augmentation& augmentation = make_augmentation();
    return {length_column(CGAL::Reeb_graph::arc_lengths(augmentation, points())),
            size_column("area", CGAL::Reeb_graph::arc_areas(augmentation, points(), Vertex_places{places})),
            vertices_column(vertices(), places, num_vertices(graph), num_edges(graph)),
            mean_value_column(augmentation, places)};
  }

  Contour contour(const Augmentation& augmentation, const Augmentation::Contour& contour) const
  {
    Contour result = crossings(augmentation, contour);
    result.polylines = contour.polylines;
    if(contour.polylines.empty())
      result.polylines = {{0}}; // the point of an edge without triangles
    const std::vector<std::size_t>& line = result.polylines[0];
    result.is_closed =
      result.polylines.size() == 1 && line.size() > 1 && line.front() == line.back() && contour.branch_points.empty();
    return result;
  }
};

// Contours are triangles, and arcs have volumes.
class Tetrahedra_kind : public Complex_kind
{
public:
  typedef Tetrahedra_augmentation Augmentation;
  using Complex_kind::Complex_kind;

  template <class NamedParameters>
  Complex_graph compute(const NamedParameters& np) const
  {
    Complex_graph graph;
    CGAL::compute_reeb_graph_of_tetrahedra<CGAL::Parallel_if_available_tag>(number_of_vertices(), complex().tetrahedra,
                                                                            scalars(), graph, np);
    return graph;
  }

  template <class NamedParameters>
  std::unique_ptr<const Augmentation> augment(const Complex_graph& graph, const NamedParameters& np) const
  {
    return std::make_unique<const Augmentation>(number_of_vertices(), complex().tetrahedra, scalars(), graph, np);
  }

  template <class MakeAugmentation>
  std::vector<Arc_column> measure_arcs(const Complex_graph& graph,
                                       const std::vector<std::size_t>& places,
                                       const MakeAugmentation& make_augmentation) const
  {
    const Augmentation& augmentation = make_augmentation();
    return {length_column(CGAL::Reeb_graph::arc_lengths(augmentation, points())),
            size_column("volume", CGAL::Reeb_graph::arc_volumes(augmentation, points(), Vertex_places{places})),
            vertices_column(vertices(), places, num_vertices(graph), num_edges(graph)),
            mean_value_column(augmentation, places)};
  }

  Contour contour(const Augmentation& augmentation, const Augmentation::Contour& patch) const
  {
    Contour result = crossings(augmentation, patch);
    result.triangles = patch.triangles;
    return result;
  }
};

} // namespace

std::unique_ptr<Mesh_graph> compute_complex_graph(const Mesh& mesh,
                                                  Scalar_map scalar_map,
                                                  const Graph_options& options,
                                                  const Simplification_options& simplification,
                                                  double threshold,
                                                  Report& report)
{
  if(mesh.complex->triangles.empty() && !mesh.complex->tetrahedra.empty())
    return std::make_unique<Mesh_graph_of<Tetrahedra_kind>>(mesh, scalar_map, options, simplification, threshold,
                                                            report);
  return std::make_unique<Mesh_graph_of<Triangles_kind>>(mesh, scalar_map, options, simplification, threshold, report);
}

} // namespace reeb_graph_program
