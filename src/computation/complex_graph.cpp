// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of the CGAL-style package Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#include "computation/complex_graph.h"

#include "base/progress_bar.h"
#include "computation/Report_visitor.h"
#include "computation/choose_contours.h"
#include "computation/complex_counts.h"
#include "computation/nearest_place.h"

#include <CGAL/Reeb_graph/IO/polylines.h>
#include <CGAL/Reeb_graph/Soup_augmentation.h>
#include <CGAL/Reeb_graph/Tetrahedra_augmentation.h>
#include <CGAL/Reeb_graph/graph_topology.h>
#include <CGAL/compute_reeb_graph_of_soup.h>

#include <functional>
#include <iterator>
#include <memory>
#include <stdexcept>
#include <string>
#include <utility>

namespace reeb_graph_program {
namespace {
typedef CGAL::Reeb_graph::Soup_augmentation<double> Soup_augmentation;
typedef CGAL::Reeb_graph::Tetrahedra_augmentation<double> Tetrahedra_augmentation;

// Where tetrahedra and other triangles are together, the faces of all tetrahedra are triangles too: the graph is the
// same.
std::vector<std::array<std::uint32_t, 3>> triangles_and_faces(const Complex& complex)
{
  std::vector<std::array<std::uint32_t, 3>> triangles = complex.triangles;
  for(const auto& t : complex.tetrahedra)
    triangles.insert(triangles.end(), {{t[0], t[1], t[2]}, {t[0], t[1], t[3]}, {t[0], t[2], t[3]}, {t[1], t[2], t[3]}});
  return triangles;
}

template <class NamedParameters>
Complex_graph compute(const Mesh& mesh, Scalar_map scalar_map, const NamedParameters& np)
{
  typedef CGAL::Parallel_if_available_tag Tag;
  const Complex& complex = *mesh.complex;
  const auto scalars = CGAL::make_range(scalar_map.begin(), scalar_map.end());
  const std::size_t number_of_vertices = mesh.surface.number_of_vertices();
  Complex_graph graph;
  if(complex.triangles.empty() && !complex.tetrahedra.empty())
    CGAL::compute_reeb_graph_of_tetrahedra<Tag>(number_of_vertices, complex.tetrahedra, scalars, graph, np);
  else if(complex.tetrahedra.empty())
    CGAL::compute_reeb_graph_of_soup<Tag>(number_of_vertices, complex.triangles, scalars, graph, np);
  else
    CGAL::compute_reeb_graph_of_soup<Tag>(number_of_vertices, triangles_and_faces(complex), scalars, graph, np);
  return graph;
}

// Named parameters of the complex itself, in front of other ones.
template <class NamedParameters>
auto with_edges(const Mesh& mesh, const NamedParameters& np)
{
  return CGAL::parameters::edges(std::cref(mesh.complex->edges), np);
}

// Calls function(augmentation) for the graph on triangles or on tetrahedra.
template <class Function>
void with_augmentation(const Mesh& mesh,
                       Scalar_map scalar_map,
                       const Simplified_complex_graph& graph,
                       const Graph_options& options,
                       const Function& function)
{
  const Complex& complex = *mesh.complex;
  const auto scalars = CGAL::make_range(scalar_map.begin(), scalar_map.end());
  const std::size_t number_of_vertices = mesh.surface.number_of_vertices();
  const auto call = [&](const auto& np) {
    if(complex.tetrahedra.empty())
      function(Soup_augmentation(number_of_vertices, complex.triangles, scalars, graph.result(), np));
    else if(complex.triangles.empty())
      function(Tetrahedra_augmentation(number_of_vertices, complex.tetrahedra, scalars, graph.result(), np));
    else
      function(Soup_augmentation(number_of_vertices, triangles_and_faces(complex), scalars, graph.result(), np));
  };
  const auto np = with_edges(mesh, named_parameters(options));
  if(graph.simplification())
    call(CGAL::parameters::simplification(*graph.simplification(), np));
  else
    call(np);
}

// Draws the contours of soups as lines, and those of tetrahedra as triangles.
class Complex_drawer
{
public:
  Complex_drawer(const Mesh& mesh, const Complex_graph& graph)
    : points_(mesh.surface.points().begin(), mesh.surface.points().end()),
      graph_(graph)
  {}

  void add(const Soup_augmentation::Contour& contour, Contours& contours) const
  {
    const std::size_t arc = get(boost::edge_index, graph_, contour.arc);
    for(Polyline& points : CGAL::Reeb_graph::polylines_of_contour(contour, points_))
    {
      const bool is_closed = points.size() > 1 && points.front() == points.back();
      add_line(std::move(points), arc, contour.value, is_closed, contours);
    }
    if(contour.polylines.empty()) // a point of an edge without triangles
    {
      Polyline points;
      Soup_augmentation::points_of_contour(contour, std::back_inserter(points), points_);
      add_line(std::move(points), arc, contour.value, false, contours);
    }
    ++contours.number;
  }

  void add(const Tetrahedra_augmentation::Contour& patch, Contours& contours) const
  {
    const std::size_t first = contours.points.size();
    Tetrahedra_augmentation::points_of_contour(patch, std::back_inserter(contours.points), points_);
    for(const std::array<std::size_t, 3>& t : patch.triangles)
      contours.triangles.push_back({first + t[0], first + t[1], first + t[2]});
    ++contours.number;
  }

private:
  std::vector<Point> points_;
  const Complex_graph& graph_;
};

Nearest_place nearest_place(const Mesh& mesh, Scalar_map scalar_map, const Point& point)
{
  Nearest_place place(point);
  const auto vertex = [](std::uint32_t v) { return Surface::Vertex_index(v); };
  const auto at = [&](auto v) { return mesh.surface.point(vertex(v)); };
  const auto value = [&](auto v) { return scalar_map[vertex(v)]; };
  for(const auto& [a, b] : mesh.complex->edges)
    place.add_triangle({at(a), at(b), at(b)}, {value(a), value(b), value(b)});
  for(const auto& [a, b, c] : mesh.complex->triangles)
    place.add_triangle({at(a), at(b), at(c)}, {value(a), value(b), value(c)});
  for(const auto& [a, b, c, d] : mesh.complex->tetrahedra)
    place.add_tetrahedron({at(a), at(b), at(c), at(d)}, {value(a), value(b), value(c), value(d)});
  return place;
}

} // namespace

Complex_graph compute_and_time(const Mesh& mesh, Scalar_map scalar_map, const Graph_options& options, Report& report)
{
  Report_visitor visitor(report);
  Progress_bar progress_bar("graph");
  const Timed_computation timed(report);
  return compute(
    mesh, scalar_map,
    with_edges(mesh, named_parameters(options).visitor(std::ref(visitor)).callback(std::ref(progress_bar))));
}

void count_all(const Mesh& mesh, const Complex_graph& graph, Report& report)
{
  report.complex = count_complex(*mesh.complex);
  report.complex->vertices = mesh.surface.number_of_vertices();
  report.complex->components = CGAL::Reeb_graph::number_of_components(graph); // as many as the complex has
  report.graph = count_graph(graph, report.complex->components);
}

Graph graph_on_vertices(const Complex_graph& graph, Surface& vertices, bool are_chains_wanted)
{
  typedef Surface::Vertex_index Vertex;
  typedef CGAL::Reeb_graph_traits<Surface, Scalar_map> Traits;
  const auto vertex = [](std::size_t v) { return Vertex(static_cast<Surface::size_type>(v)); };
  auto halfedges = std::make_shared<std::vector<Surface::Halfedge_index>>();
  if(are_chains_wanted)
    for(const auto arc : CGAL::make_range(edges(graph)))
      for(const auto& [source, target] : graph[arc].chain)
        halfedges->push_back(vertices.add_edge(vertex(source), vertex(target)));
  Graph result;
  for(const auto node : CGAL::make_range(boost::vertices(graph)))
    add_vertex(Traits::Node{graph[node].value, vertex(graph[node].vertex), graph[node].kind}, result);
  std::size_t first = 0;
  for(const auto arc : CGAL::make_range(edges(graph)))
  {
    const auto added = add_edge(source(arc, graph), target(arc, graph), result).first;
    put(boost::edge_index, result, added, get(boost::edge_index, graph, arc));
    if(!are_chains_wanted)
      continue;
    result[added].chain = {halfedges, first, graph[arc].chain.size()};
    first += graph[arc].chain.size();
  }
  return result;
}

std::vector<std::size_t> locate_vertices(const Mesh& mesh,
                                         Scalar_map scalar_map,
                                         const Simplified_complex_graph& graph,
                                         const Graph_options& options)
{
  std::vector<std::size_t> places;
  with_augmentation(mesh, scalar_map, graph, options, [&](const auto& augmentation) {
    Progress_bar progress_bar("places");
    const auto locations = augmentation.template locate_vertices<CGAL::Parallel_if_available_tag>(
      CGAL::parameters::callback(std::ref(progress_bar)));
    for(std::size_t v = 0; v < mesh.surface.number_of_vertices(); ++v)
      places.push_back(locations.index(v));
  });
  return places;
}

Contours find_contours(const Mesh& mesh, Scalar_map scalar_map, const Contour_choice& choice)
{
  Progress_bar progress_bar("graph");
  const Complex_graph given =
    compute(mesh, scalar_map, with_edges(mesh, named_parameters(choice.graph).callback(std::ref(progress_bar))));
  const Simplified_complex_graph graph(given, choice.simplification,
                                       threshold_in_units(choice.simplification, mesh.surface, scalar_map));
  Contours contours;
  with_augmentation(mesh, scalar_map, graph, choice.graph, [&](const auto& augmentation) {
    contours = choose_contours(augmentation, Complex_drawer(mesh, graph.result()), scalar_map, choice,
                               [&](const Point& point) { return nearest_place(mesh, scalar_map, point); });
  });
  return contours;
}

} // namespace reeb_graph_program
