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

#include <CGAL/Reeb_graph/internal/base/Scalar_conversion.h>
#include <CGAL/Reeb_graph/internal/base/interpolation.h>
#include <CGAL/Reeb_graph/internal/base/lengths.h>
#include <CGAL/Reeb_graph/internal/base/requirements.h>
#include <CGAL/Reeb_graph/internal/way_back/Graph_on_mesh.h>
#include <CGAL/Reeb_graph/named_parameters.h>
#include <CGAL/Reeb_graph_traits.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/boost/graph/iterator.h>
#include <CGAL/number_utils.h>

#include <boost/graph/graph_traits.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL::Reeb_graph {

// A user who measures arcs of one has included it.
template <class GraphOnMesh>
class Basic_augmentation;

namespace internal {

// Functions of a mesh and a graph are no functions of an augmentation and places.
template <class GraphOnMesh>
std::true_type test_augmentation(const Basic_augmentation<GraphOnMesh>*);
std::false_type test_augmentation(const void*);
template <class Mesh>
using If_mesh = std::enable_if_t<!decltype(test_augmentation(std::declval<const Mesh*>()))::value>;

// The area of a triangle, and the volume of a tetrahedron.
template <class PointMap, class Vertex>
double measure_of(const PointMap& point_map, const std::array<Vertex, 3>& v)
{
  return area_of(get(point_map, v[0]), get(point_map, v[1]), get(point_map, v[2]));
}
template <class PointMap, class Vertex>
double measure_of(const PointMap& point_map, const std::array<Vertex, 4>& v)
{
  return std::abs(
    CGAL::to_double(volume(get(point_map, v[0]), get(point_map, v[1]), get(point_map, v[2]), get(point_map, v[3]))));
}

// Calls visit(vertex, part) for the vertices of each cell, each with an equal part of the measure of the cell.
template <class Cells, class PointMap, class Visit>
void visit_cells(const Cells& cells, const PointMap& point_map, const Visit& visit)
{
  for(const auto& cell : cells.cells())
  {
    const auto& vertices = cells.vertices_of(cell);
    const double part = measure_of(point_map, vertices) / static_cast<double>(vertices.size());
    for(const auto v : vertices)
      visit(v, part);
  }
}

// The measures of nodes, and behind them those of arcs.
template <class Cells, class ReebGraph, class VertexPlaces, class PointMap>
std::vector<double> measures_of_places(const Cells& cells,
                                       const ReebGraph& graph,
                                       const VertexPlaces& places,
                                       const PointMap& point_map)
{
  std::vector<double> sums(num_vertices(graph) + num_edges(graph), 0);
  visit_cells(cells, point_map, [&](const auto v, double part) { sums.at(places.index(v)) += part; });
  return sums;
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

// The areas, or volumes.
template <class Augmentation, class VertexPlaces, class Points>
std::vector<double> measures_of_arcs(const Augmentation& augmentation, const VertexPlaces& places, const Points& points)
{
  const auto& cells = augmentation.on_mesh();
  return measures_of_arcs(cells.graph(), measures_of_places(cells, cells.graph(), places, cells.point_map(points)));
}

// Points in a unit in which the largest coordinate is about 1, so that areas and volumes are neither 0 nor infinite.
template <class PointMap>
struct Points_in_unit
{
  typedef Simple_cartesian<double>::Point_3 Point;

  PointMap point_map;
  int exponent = 0;

  template <class Cells>
  Points_in_unit(const Cells& cells, const PointMap& points) : point_map(points)
  {
    double largest = 0;
    for(const auto& cell : cells.cells())
      for(const auto v : cells.vertices_of(cell))
        for(int i = 0; i != 3; ++i)
          largest = (std::max)(largest, std::abs(CGAL::to_double(get(point_map, v)[i])));
    exponent = largest > 0 && std::isfinite(largest) ? -std::ilogb(largest) : 0;
  }

  template <class Vertex>
  friend Point get(const Points_in_unit& points, const Vertex v)
  {
    const auto& p = get(points.point_map, v);
    const auto coordinate = [&](int i) { return std::scalbn(CGAL::to_double(p[i]), points.exponent); };
    return {coordinate(0), coordinate(1), coordinate(2)};
  }
};

// Shares of arcs in the area, or volume, in any unit.
template <class Augmentation, class VertexPlaces>
std::vector<double> shares_of_arcs(const Augmentation& augmentation, const VertexPlaces& places)
{
  const auto& cells = augmentation.on_mesh();
  const Points_in_unit points(cells, cells.point_map(parameters::default_values()));
  return measures_of_arcs(cells.graph(), measures_of_places(cells, cells.graph(), places, points));
}

// The mean of the values at the vertices of each arc, weighted by what measures_of_arcs() has of them. `value` is called
// with a vertex.
template <class Cells, class ReebGraph, class VertexPlaces, class PointMap, class Value>
std::vector<double> mean_values_of_arcs(const Cells& cells,
                                        const ReebGraph& graph,
                                        const VertexPlaces& places,
                                        const PointMap& point_map,
                                        const Value& value)
{
  std::vector<Weighted_mean> sums(num_vertices(graph) + num_edges(graph));
  visit_cells(cells, Points_in_unit(cells, point_map),
              [&](const auto v, double part) { sums.at(places.index(v)).add(value(v), part); });
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

// The values of a field as numbers.
template <class Traits, class ScalarMap, class NamedParameters>
auto double_values(const ScalarMap& scalar_map, const NamedParameters& np)
{
  return [scalar_map, conversion = Scalar_conversion<Traits>(choose_traits<Traits>(np))](const auto v) {
    return conversion.to_double(get(scalar_map, v));
  };
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
  static_assert(internal::are_met<internal::Mesh_is_face_list_graph<FaceListGraph>>);
  std::vector<double> counts(num_vertices(graph) + num_edges(graph), 0);
  for(const auto v : CGAL::make_range(vertices(mesh)))
    counts.at(places.index(v)) += 1;
  return counts;
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
  static_assert(internal::are_met<internal::Mesh_is_face_list_graph<FaceListGraph>>);
  return internal::measures_of_places(internal::Mesh_cells(mesh), graph, places, internal::choose_point_map(mesh, np));
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
          class NamedParameters = parameters::Default_named_parameters,
          class = internal::If_mesh<FaceListGraph>>
std::vector<double> arc_areas(const FaceListGraph& mesh,
                              const ReebGraph& graph,
                              const VertexPlaces& places,
                              const NamedParameters& np = parameters::default_values())
{
  return internal::measures_of_arcs(graph, areas_of_places(mesh, graph, places, np));
}

/// \brief adds up the area of the triangles that belongs to each arc of a Reeb graph, as that of a mesh. A triangle of a
/// soup that is listed several times counts once.
///
/// \param augmentation an `Augmentation` or a `Soup_augmentation`
/// \param places what `augmentation.locate_vertices()` has returned
/// \param points the points of the vertices, as `Basic_augmentation::points_of_contour()` takes them
///
/// \reebGraphComplexity
///
/// \returns the areas of the arcs, in the order of `edges(graph)`.
///
/// \exception Attribute_count_error if points are a range, and not one for each vertex
/// \exception Reeb_graph::Unknown_vertex_error if the places are not those of this mesh
template <class GraphOnMesh, class VertexPlaces, class Points = parameters::Default_named_parameters>
std::vector<double> arc_areas(const Basic_augmentation<GraphOnMesh>& augmentation,
                              const VertexPlaces& places,
                              const Points& points = parameters::default_values())
{
  static_assert(GraphOnMesh::vertices_per_cell == 3, "Tetrahedra have volumes: see arc_volumes().");
  return internal::measures_of_arcs(augmentation, places, points);
}

/// \brief adds up the volume of the tetrahedra that belongs to each arc of their Reeb graph, as the area of a mesh: a
/// quarter of each tetrahedron to each of its vertices. One that is listed several times counts once.
///
/// \param augmentation a `Tetrahedra_augmentation`
/// \param places what `augmentation.locate_vertices()` has returned
/// \param points the points of the vertices, a random access range
///
/// \reebGraphComplexity
///
/// \returns the volumes of the arcs, in the order of `edges(graph)`.
///
/// \exception Attribute_count_error if there is not one point for each vertex
/// \exception Reeb_graph::Unknown_vertex_error if the places are not those of these tetrahedra
template <class GraphOnMesh, class VertexPlaces, class Points>
std::vector<double> arc_volumes(const Basic_augmentation<GraphOnMesh>& augmentation,
                                const VertexPlaces& places,
                                const Points& points)
{
  static_assert(GraphOnMesh::vertices_per_cell == 4, "Triangles have areas: see arc_areas().");
  return internal::measures_of_arcs(augmentation, places, points);
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
  static_assert(internal::are_met<internal::Mesh_with_numbers<FaceListGraph, ScalarMap, Traits>>);
  return internal::mean_values_of_arcs(internal::Mesh_cells(mesh), graph, places, internal::choose_point_map(mesh, np),
                                       internal::double_values<Traits>(scalar_map, np));
}

/// \brief computes the mean value of the field on each arc of a Reeb graph, as that of a mesh: of a soup, weighted by the
/// areas of the triangles, of tetrahedra, weighted by their volumes.
///
/// An arc without triangles or tetrahedra, as on an edge that is on none, has the middle of the values of its nodes.
///
/// \param augmentation an `Augmentation`, `Soup_augmentation`, or `Tetrahedra_augmentation`
/// \param places what `augmentation.locate_vertices()` has returned
/// \param points the points of the vertices, as `Basic_augmentation::points_of_contour()` takes them
///
/// \returns the means, in the order of `edges(graph)`.
///
/// \exception Attribute_count_error if points are a range, and not one for each vertex
/// \exception Reeb_graph::Unknown_vertex_error if the places are not those of this mesh
template <class GraphOnMesh, class VertexPlaces, class Points = parameters::Default_named_parameters>
std::vector<double> arc_mean_values(const Basic_augmentation<GraphOnMesh>& augmentation,
                                    const VertexPlaces& places,
                                    const Points& points = parameters::default_values())
{
  return internal::mean_values_of_arcs(augmentation.on_mesh(), augmentation.graph(), places,
                                       augmentation.on_mesh().point_map(points),
                                       [&](const auto v) { return augmentation.value(v); });
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
  static_assert(internal::are_met<internal::Mesh_with_numbers<FaceListGraph, ScalarMap, Traits>>);
  return internal::lengths_of_arcs(mesh, graph, internal::choose_point_map(mesh, np),
                                   internal::double_values<Traits>(scalar_map, np));
}

/// \brief measures the length of each arc of the Reeb graph of a mesh, of a soup, or of tetrahedra, in the same way.
///
/// \param augmentation an `Augmentation`, `Soup_augmentation`, or `Tetrahedra_augmentation`
/// \param points the points of the vertices, as `Basic_augmentation::points_of_contour()` takes them
///
/// \reebGraphComplexity
///
/// \returns the lengths, in the order of `edges(graph)`.
///
/// \exception Attribute_count_error if points are a range, and not one for each vertex
template <class GraphOnMesh, class Points = parameters::Default_named_parameters>
std::vector<double> arc_lengths(const Basic_augmentation<GraphOnMesh>& augmentation,
                                const Points& points = parameters::default_values())
{
  return internal::lengths_of_arcs(augmentation.mesh(), augmentation.graph(), augmentation.on_mesh().point_map(points),
                                   [&](const auto v) { return augmentation.value(v); });
}

/// @}

} // namespace CGAL::Reeb_graph

#endif // CGAL_REEB_GRAPH_ARC_MEASURES_H
