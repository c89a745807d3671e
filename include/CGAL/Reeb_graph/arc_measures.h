// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_ARC_MEASURES_H
#define CGAL_REEB_GRAPH_ARC_MEASURES_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/internal/base/Weighted_mean.h>
#include <CGAL/Reeb_graph/internal/base/lengths.h>
#include <CGAL/Reeb_graph/internal/base/named_parameter.h>
#include <CGAL/Reeb_graph/internal/base/requirements.h>
#include <CGAL/Reeb_graph/internal/base/scalars.h>
#include <CGAL/Reeb_graph_traits.h>

#include <CGAL/boost/graph/iterator.h>
#include <CGAL/boost/graph/named_params_helper.h>
#include <CGAL/boost/graph/properties.h>
#include <CGAL/number_utils.h>

#include <boost/graph/graph_traits.hpp>

#include <array>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <vector>

namespace CGAL::Reeb_graph {

// A user who measures arcs of one of these has included it.
template <class GraphOnCells>
class Complex_augmentation;
template <class Scalar, class ReebGraph, class Traits>
class Soup_augmentation;
template <class Scalar, class ReebGraph, class Traits>
class Tetrahedra_augmentation;

namespace internal {

// Adds equal parts of the measure of a face, or of a cell, to the sums of its vertices.
template <class VertexPlaces, class VertexRange>
void add_to_places(double measure, const VertexRange& vertices, const VertexPlaces& places, std::vector<double>& sums)
{
  for(const auto v : vertices)
    sums.at(places.index(v)) += measure / static_cast<double>(std::size(vertices));
}

// Measures of arcs: each node shares its own out equally among the arcs there.
template <class ReebGraph>
std::vector<double> measures_of_arcs(const ReebGraph& graph, const std::vector<double>& sums)
{
  std::vector<double> result(sums.begin() + static_cast<std::ptrdiff_t>(num_vertices(graph)), sums.end());
  std::size_t arc_number = 0;
  for(const auto arc : CGAL::make_range(edges(graph)))
  {
    for(const auto node : {source(arc, graph), target(arc, graph)})
      result[arc_number] += sums[node] / static_cast<double>(degree(node, graph));
    ++arc_number;
  }
  return result;
}

// Calls visit(area, vertices) for each face.
template <class FaceListGraph, class PointMap, class Visit>
void visit_faces(const FaceListGraph& mesh, const PointMap& point_map, const Visit& visit)
{
  for(const auto f : CGAL::make_range(faces(mesh)))
  {
    const auto h = halfedge(f, mesh);
    const auto a = source(h, mesh), b = target(h, mesh), c = target(next(h, mesh), mesh);
    visit(area_of(get(point_map, a), get(point_map, b), get(point_map, c)), std::array{a, b, c});
  }
}

// Calls visit(area, vertices) for each triangle.
template <class Scalar, class ReebGraph, class Traits, class PointRange, class Visit>
void visit_cells(const Soup_augmentation<Scalar, ReebGraph, Traits>& augmentation,
                 const PointRange& points,
                 const Visit& visit)
{
  const auto point_map = checked_point_map(points, augmentation.number_of_vertices());
  for(const auto triangle : augmentation.mesh().triangles())
  {
    const auto& t = augmentation.mesh().vertices_of(triangle);
    const std::array<std::size_t, 3> v = {t[0].number(), t[1].number(), t[2].number()};
    visit(area_of(get(point_map, v[0]), get(point_map, v[1]), get(point_map, v[2])), v);
  }
}

// Calls visit(volume, vertices) for each tetrahedron.
template <class Scalar, class ReebGraph, class Traits, class PointRange, class Visit>
void visit_cells(const Tetrahedra_augmentation<Scalar, ReebGraph, Traits>& augmentation,
                 const PointRange& points,
                 const Visit& visit)
{
  const auto point_map = checked_point_map(points, augmentation.number_of_vertices());
  for(const auto& t : augmentation.cells())
  {
    const std::array<std::size_t, 4> v = {t[0].number(), t[1].number(), t[2].number(), t[3].number()};
    visit(std::abs(CGAL::to_double(
            volume(get(point_map, v[0]), get(point_map, v[1]), get(point_map, v[2]), get(point_map, v[3])))),
          v);
  }
}

// The measures of the arcs of a soup or of tetrahedra.
template <class AnyAugmentation, class PointRange, class VertexPlaces>
std::vector<double> measures_of_cells(const AnyAugmentation& augmentation,
                                      const PointRange& points,
                                      const VertexPlaces& places)
{
  const auto& graph = augmentation.graph();
  std::vector<double> sums(num_vertices(graph) + num_edges(graph), 0);
  visit_cells(augmentation, points,
              [&](double measure, const auto& vertices) { add_to_places(measure, vertices, places, sums); });
  return measures_of_arcs(graph, sums);
}

// The mean of the values at the vertices of each arc, weighted by what measures_of_arcs() has of them. `value` is called
// with a vertex; visit_all(visit) calls visit(measure, vertices) for each face or cell.
template <class ReebGraph, class VertexPlaces, class Value, class VisitAll>
std::vector<double> mean_values_of_arcs(const ReebGraph& graph,
                                        const VertexPlaces& places,
                                        const Value& value,
                                        const VisitAll& visit_all)
{
  std::vector<Weighted_mean> sums(num_vertices(graph) + num_edges(graph));
  visit_all([&](double measure, const auto& vertices) {
    for(const auto v : vertices)
      sums.at(places.index(v)).add(value(v), measure / static_cast<double>(std::size(vertices)));
  });
  std::vector<double> result;
  for(const auto arc : CGAL::make_range(edges(graph)))
  {
    const auto lower = source(arc, graph), upper = target(arc, graph);
    Weighted_mean& mean = sums[num_vertices(graph) + result.size()];
    for(const auto node : {lower, upper})
      mean.add(sums[node].mean, sums[node].weight / static_cast<double>(degree(node, graph)));
    result.push_back(mean.mean_or_middle(value(graph[lower].vertex), value(graph[upper].vertex)));
  }
  return result;
}

// `value` is called with a vertex. The mesh may be one of soups.
template <class Mesh, class ReebGraph, class PointMap, class Value>
std::vector<double> lengths_of_arcs(const Mesh& mesh,
                                    const ReebGraph& graph,
                                    const PointMap& point_map,
                                    const Value& value)
{
  const auto used_length = [&](const auto& h, const auto end) {
    const auto u = source(h, mesh), w = target(h, mesh);
    const double length = distance_between(get(point_map, w), get(point_map, u));
    return end == w ? length : length * crossing_fraction(value(u), value(w), value(end));
  };
  std::vector<double> lengths;
  for(const auto arc : CGAL::make_range(edges(graph)))
  {
    const auto& chain = graph[arc].chain;
    double length = 0;
    for(std::size_t i = 0; i != chain.size(); ++i)
      length +=
        used_length(chain[i], i + 1 == chain.size() ? graph[target(arc, graph)].vertex : source(chain[i + 1], mesh));
    lengths.push_back(length);
  }
  return lengths;
}

} // namespace internal

/// \addtogroup PkgReebGraphAugmentation
/// @{

/// \brief counts the vertices of the mesh that belong to each node and to each arc of a Reeb graph: weights for
/// `simplify()`, as named parameter `place_weights`.
///
/// \reebGraphLocatedVertices
///
/// \returns the counts of the nodes, and behind them those of the arcs, in the order of `edges(graph)`.
///
/// \exception Reeb_graph::Unknown_vertex_error if the places are not those of this mesh
template <class FaceListGraph, class ReebGraph, class VertexPlaces>
std::vector<double> vertex_counts_of_places(const FaceListGraph& mesh,
                                            const ReebGraph& graph,
                                            const VertexPlaces& places)
{
  if constexpr(internal::Mesh_is_face_list_graph<FaceListGraph>::value)
  {
    std::vector<double> counts(num_vertices(graph) + num_edges(graph), 0);
    for(const auto v : CGAL::make_range(vertices(mesh)))
      counts.at(places.index(v)) += 1;
    return counts;
  }
  else
    return {};
}

/// \brief adds up the area that belongs to each node and to each arc of a Reeb graph: weights for `simplify()`, as
/// named parameter `place_weights`.
///
/// A third of the area of each face belongs to each of its vertices.
///
/// \reebGraphLocatedVertices
/// \param np an optional sequence of \ref bgl_namedparameters "Named Parameters" among the ones listed below
///
/// \cgalNamedParamsBegin
///   \reebGraphPoints{ReadablePropertyMap}
/// \cgalNamedParamsEnd
///
/// \reebGraphComplexity
///
/// \returns the areas of the nodes, and behind them those of the arcs, in the order of `edges(graph)`.
///
/// \exception Reeb_graph::Unknown_vertex_error if the places are not those of this mesh
template <class FaceListGraph,
          class ReebGraph,
          class VertexPlaces,
          class NamedParameters = parameters::Default_named_parameters>
std::vector<double> areas_of_places(const FaceListGraph& mesh,
                                    const ReebGraph& graph,
                                    const VertexPlaces& places,
                                    const NamedParameters& np = parameters::default_values())
{
  if constexpr(internal::Mesh_is_face_list_graph<FaceListGraph>::value)
  {
    const auto point_map = internal::choose_point_map(mesh, np);
    std::vector<double> areas(num_vertices(graph) + num_edges(graph), 0);
    internal::visit_faces(mesh, point_map, [&](double area, const auto& vertices) {
      internal::add_to_places(area, vertices, places, areas);
    });
    return areas;
  }
  else
    return {};
}

/// \brief adds up the area of the surface that belongs to each arc of a Reeb graph.
///
/// A third of the area of each face belongs to each of its vertices, as in `areas_of_places()`; what belongs to a node
/// is shared out equally among its arcs. So the sum is the area of the mesh, but for components without an arc, which
/// contracted ties can leave.
///
/// \reebGraphLocatedVertices
/// \param np named parameters: those of `areas_of_places()`
///
/// \reebGraphComplexity
///
/// \returns the areas of the arcs, in the order of `edges(graph)`.
///
/// \exception Reeb_graph::Unknown_vertex_error if the places are not those of this mesh
template <class FaceListGraph,
          class ReebGraph,
          class VertexPlaces,
          class NamedParameters = parameters::Default_named_parameters>
std::vector<double> arc_areas(const FaceListGraph& mesh,
                              const ReebGraph& graph,
                              const VertexPlaces& places,
                              const NamedParameters& np = parameters::default_values())
{
  return internal::measures_of_arcs(graph, areas_of_places(mesh, graph, places, np));
}

/// \brief adds up the area of the triangles of a soup that belongs to each arc of its Reeb graph, as that of a mesh. A
/// triangle that is listed several times counts once.
///
/// \param augmentation the way from the graph to the soup
/// \param points the points of the vertices, a random access range
/// \param places what `augmentation.locate_vertices()` has returned
///
/// \reebGraphComplexity
///
/// \returns the areas of the arcs, in the order of `edges(graph)`.
///
/// \exception Attribute_count_error if there is not one point for each vertex
/// \exception Reeb_graph::Unknown_vertex_error if the places are not those of this soup
template <class Scalar, class ReebGraph, class Traits, class PointRange, class VertexPlaces>
std::vector<double> arc_areas(const Soup_augmentation<Scalar, ReebGraph, Traits>& augmentation,
                              const PointRange& points,
                              const VertexPlaces& places)
{
  return internal::measures_of_cells(augmentation, points, places);
}

/// \brief adds up the volume of the tetrahedra that belongs to each arc of their Reeb graph, as the area of a mesh: a
/// quarter of each tetrahedron to each of its vertices. One that is listed several times counts once.
///
/// \param augmentation the way from the graph to the tetrahedra
/// \param points the points of the vertices, a random access range
/// \param places what `augmentation.locate_vertices()` has returned
///
/// \reebGraphComplexity
///
/// \returns the volumes of the arcs, in the order of `edges(graph)`.
///
/// \exception Attribute_count_error if there is not one point for each vertex
/// \exception Reeb_graph::Unknown_vertex_error if the places are not those of these tetrahedra
template <class Scalar, class ReebGraph, class Traits, class PointRange, class VertexPlaces>
std::vector<double> arc_volumes(const Tetrahedra_augmentation<Scalar, ReebGraph, Traits>& augmentation,
                                const PointRange& points,
                                const VertexPlaces& places)
{
  return internal::measures_of_cells(augmentation, points, places);
}

/// \brief computes the mean value of the field on each arc of a Reeb graph, weighted by area.
///
/// The weight of a vertex is what it has of the areas of `arc_areas()`: a third of each of its faces, and for that of a
/// node an equal part for each arc there. So the means, each times the area of its arc, add up to the integral of the
/// field over the mesh, which is linear on each face. A mean lies between the least and the greatest value at vertices of
/// its arc and at its ends. An arc without area has the middle of the values of its nodes. With an infinite value, the
/// mean is infinite, or NaN with both of them.
///
/// It takes time linear in the size of the mesh.
///
/// \param mesh the mesh that the graph has been computed of
/// \param scalar_map the field that it has been computed of
/// \param graph the Reeb graph, or a simplified one
/// \param places what `Augmentation::locate_vertices()` has returned for the graph
/// \param np named parameters: those of `areas_of_places()`, and `geom_traits`, as for `simplify()`
///
/// \reebGraphComplexity
///
/// \returns the means, in the order of `edges(graph)`.
///
/// \exception Reeb_graph::Unknown_vertex_error if the places are not those of this mesh
template <class FaceListGraph,
          class ScalarMap,
          class ReebGraph,
          class VertexPlaces,
          class NamedParameters = parameters::Default_named_parameters>
std::vector<double> arc_mean_values(const FaceListGraph& mesh,
                                    ScalarMap scalar_map,
                                    const ReebGraph& graph,
                                    const VertexPlaces& places,
                                    const NamedParameters& np = parameters::default_values())
{
  typedef internal::Chosen_traits<Reeb_graph_traits<FaceListGraph, ScalarMap>, NamedParameters> Traits;
  if constexpr(internal::Mesh_with_numbers<FaceListGraph, ScalarMap, Traits>::value)
  {
    const internal::Scalar_conversion<Traits> conversion(internal::choose_traits<Traits>(np));
    const auto value = [&](const auto v) { return conversion.to_double(get(scalar_map, v)); };
    const auto point_map = internal::choose_point_map(mesh, np);
    return internal::mean_values_of_arcs(graph, places, value,
                                         [&](const auto& visit) { internal::visit_faces(mesh, point_map, visit); });
  }
  else
    return {};
}

/// \brief computes the mean value of the field on each arc of the Reeb graph of a soup, weighted by the areas of the
/// triangles, or of tetrahedra, weighted by their volumes, as on a mesh.
///
/// An arc without triangles or tetrahedra, as on an edge that is on none, has the middle of the values of its nodes.
///
/// \param augmentation a `Soup_augmentation` or `Tetrahedra_augmentation` of the graph
/// \param points the points of the vertices, a random access range
/// \param places what `augmentation.locate_vertices()` has returned
///
/// \returns the means, in the order of `edges(graph)`.
///
/// \exception Attribute_count_error if there is not one point for each vertex
/// \exception Reeb_graph::Unknown_vertex_error if the places are not those of these triangles or tetrahedra
template <template <class, class, class> class AnyAugmentation,
          class Scalar,
          class ReebGraph,
          class Traits,
          class PointRange,
          class VertexPlaces>
std::vector<double> arc_mean_values(const AnyAugmentation<Scalar, ReebGraph, Traits>& augmentation,
                                    const PointRange& points,
                                    const VertexPlaces& places)
{
  return internal::mean_values_of_arcs(
    augmentation.graph(), places, [&](std::size_t v) { return augmentation.value(v); },
    [&](const auto& visit) { internal::visit_cells(augmentation, points, visit); });
}

/// \brief measures the length of each arc of a Reeb graph on the surface.
///
/// That is the length of its chain as a polyline, from the vertex of the lower node up to the value of the upper node.
/// The target of the last halfedge can be beyond: it counts up to that value. Where a chain passes a plateau, the last
/// halfedge of a piece counts up to where the arc enters it. It takes time linear in the length of the chains.
///
/// \param mesh the mesh that the graph has been computed of
/// \param scalar_map the field that it has been computed of
/// \param graph the Reeb graph
/// \param np named parameters: those of `areas_of_places()`, and `geom_traits`, as for `simplify()`
///
/// \reebGraphComplexity
///
/// \returns the lengths, in the order of `edges(graph)`.
template <class FaceListGraph,
          class ScalarMap,
          class ReebGraph,
          class NamedParameters = parameters::Default_named_parameters>
std::vector<double> arc_lengths(const FaceListGraph& mesh,
                                ScalarMap scalar_map,
                                const ReebGraph& graph,
                                const NamedParameters& np = parameters::default_values())
{
  typedef internal::Chosen_traits<Reeb_graph_traits<FaceListGraph, ScalarMap>, NamedParameters> Traits;
  if constexpr(internal::Mesh_with_numbers<FaceListGraph, ScalarMap, Traits>::value)
  {
    const internal::Scalar_conversion<Traits> conversion(internal::choose_traits<Traits>(np));
    const auto value = [&](const auto v) { return conversion.to_double(get(scalar_map, v)); };
    return internal::lengths_of_arcs(mesh, graph, internal::choose_point_map(mesh, np), value);
  }
  else
    return {};
}

/// \brief measures the length of each arc of the Reeb graph of a soup or of tetrahedra, as on a mesh.
///
/// \param augmentation a `Soup_augmentation` or `Tetrahedra_augmentation` of the graph
/// \param points the points of the vertices, a random access range
///
/// \reebGraphComplexity
///
/// \returns the lengths, in the order of `edges(graph)`.
///
/// \exception Attribute_count_error if there is not one point for each vertex
template <class GraphOnCells, class PointRange>
std::vector<double> arc_lengths(const Complex_augmentation<GraphOnCells>& augmentation, const PointRange& points)
{
  return internal::lengths_of_arcs(augmentation.mesh(), augmentation.graph(),
                                   internal::checked_point_map(points, augmentation.number_of_vertices()),
                                   [&](std::size_t v) { return augmentation.value(v); });
}

/// @}

} // namespace CGAL::Reeb_graph

#endif // CGAL_REEB_GRAPH_ARC_MEASURES_H
