// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_EMBED_H
#define CGAL_REEB_GRAPH_EMBED_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/Augmentation.h>
#include <CGAL/Reeb_graph/internal/base/Progress.h>
#include <CGAL/Reeb_graph/internal/base/Threads.h>
#include <CGAL/Reeb_graph/internal/base/interpolation.h>
#include <CGAL/Reeb_graph/internal/base/lengths.h>
#include <CGAL/Reeb_graph/internal/way_back/arc_polylines.h>
#include <CGAL/Reeb_graph/named_parameters.h>
#include <CGAL/Reeb_graph/options.h>

#include <CGAL/Bbox_3.h>
#include <CGAL/boost/graph/helpers.h>
#include <CGAL/boost/graph/iterator.h>

#include <boost/property_map/property_map.hpp>
#include <boost/unordered_map.hpp>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL::Reeb_graph {

/// \ingroup PkgReebGraphEmbedding
///
/// \brief a Reeb graph in space: what `embed()` returns.
///
/// \tparam Point_ the type of the points
template <class Point_>
struct Embedding
{
  typedef Point_ Point; ///< a point

  /// the manner in which it has been made, not `BY_COST`
  Embedding_manner manner = Embedding_manner::STRAIGHT;

  /// the point of each node, by its descriptor
  std::vector<Point> node_points;

  /// the value of each node, by its descriptor
  std::vector<double> node_values;

  /// the polyline of each arc, in the order of `edges(graph)`: from the point of its lower node to that of its upper
  /// node, both included
  std::vector<std::vector<Point>> arc_polylines;

  /// the value of each point of `arc_polylines`: that of the contour or of the place on the surface that the point
  /// stands for. Values ascend weakly, if their order is that of numbers, and are NaN if they are not numbers
  std::vector<std::vector<double>> arc_values;
};

} // namespace CGAL::Reeb_graph

namespace CGAL::Reeb_graph::internal {

// Contours along an arc, and for each one its centroid, a point of it, and its value.
struct Contours_of_arc
{
  std::vector<Coordinates> centroids;
  std::vector<Coordinates> contour_points;
  std::vector<double> values;
};

// The nodes and arcs of a graph at the centroids of contours.
template <class Augmentation, class PointMap>
class Centroid_polylines
{
  typedef typename Augmentation::Contour Contour;
  typedef typename Augmentation::arc_descriptor arc_descriptor;
  typedef typename Augmentation::node_descriptor node_descriptor;
  typedef typename Augmentation::vertex_descriptor vertex_descriptor;
  typedef typename Augmentation::halfedge_descriptor halfedge_descriptor;
  typedef typename boost::property_traits<PointMap>::value_type Point;
  static constexpr bool is_mesh = Is_face_list_graph<typename Augmentation::Mesh>::value;

public:
  Centroid_polylines(const Augmentation& augmentation, const PointMap& point_map)
    : augmentation_(augmentation),
      graph_(augmentation.graph()),
      point_map_(point_map)
  {
    if constexpr(is_mesh)
      for(const node_descriptor node : CGAL::make_range(vertices(graph_)))
      {
        const bool is_leaf = (in_degree(node, graph_) == 0) != (out_degree(node, graph_) == 0);
        if(is_leaf && loop_of_vertex_.count(graph_[node].vertex) == 0)
          add_border_loop(graph_[node].vertex);
      }
  }

  // A node with arcs above and below is at the centroid of the contours that meet there, a leaf at its vertex or, on a
  // mesh, in the middle of the border loop or of the tied vertices that it stands for.
  Point node_point(node_descriptor node) const
  {
    const vertex_descriptor vertex = graph_[node].vertex;
    const bool is_minimum = in_degree(node, graph_) == 0, is_leaf = is_minimum || out_degree(node, graph_) == 0;
    const auto loop = is_leaf ? loop_of_vertex_.find(vertex) : loop_of_vertex_.end();
    Centroid centroid = loop == loop_of_vertex_.end() ? Centroid() : centroids_of_loops_[loop->second];
    if(centroid.is_of_length_zero() && (is_mesh || !is_leaf))
    {
      for(const arc_descriptor arc : CGAL::make_range(in_edges(node, graph_)))
        add_contour(augmentation_.contour_below(arc, vertex), vertex, is_leaf, centroid);
      if(is_minimum)
        for(const arc_descriptor arc : CGAL::make_range(out_edges(node, graph_)))
          add_contour(augmentation_.contour_above(arc, vertex), vertex, is_leaf, centroid);
    }
    return centroid.is_of_length_zero() ? Point(get(point_map_, vertex)) : make_point<Point>(centroid());
  }

  // `contour_at` is called with the arc and a place between 0 and 1.
  template <class ContourAt>
  Contours_of_arc contours(arc_descriptor arc, std::size_t number_of_contours, const ContourAt& contour_at) const
  {
    Contours_of_arc result;
    for(std::size_t i = 1; i <= number_of_contours; ++i)
    {
      const double t = static_cast<double>(i) / static_cast<double>(number_of_contours + 1);
      const Contour contour = contour_at(arc, t);
      const std::vector<Point> points = points_of(augmentation_, contour, point_map_);
      Centroid centroid;
      centroid.add(contour, points);
      result.centroids.push_back(centroid());
      // off the ends of a curve
      result.contour_points.push_back(coordinates_of(points[is_mesh && !contour.is_closed() ? points.size() / 2 : 0]));
      result.values.push_back(contour.value);
    }
    return result;
  }

private:
  // Adds the border loop that the vertex of a leaf is on, if it is. Each loop is walked once, however many leaves it
  // has. The centroid is of length 0 unless the loop has one value.
  void add_border_loop(vertex_descriptor v)
  {
    const auto& mesh = augmentation_.mesh();
    const auto border = CGAL::is_border(v, mesh);
    if(!border)
      return;
    std::vector<Point> points;
    bool is_level = true;
    halfedge_descriptor h = *border;
    do
    {
      points.push_back(get(point_map_, target(h, mesh)));
      is_level = is_level && augmentation_.value(target(h, mesh)) == augmentation_.value(v);
      loop_of_vertex_[target(h, mesh)] = centroids_of_loops_.size();
      h = next(h, mesh);
    } while(h != *border);
    centroids_of_loops_.emplace_back();
    for(std::size_t i = 0; is_level && i != points.size(); ++i)
      centroids_of_loops_.back().add_segment(coordinates_of(points[i]),
                                             coordinates_of(points[(i + 1) % points.size()]));
  }

  // Adds a contour next to a node, but not one that is no more than the vertex of a leaf.
  void add_contour(const Contour& contour, vertex_descriptor vertex, bool is_leaf, Centroid& centroid) const
  {
    const auto& mesh = augmentation_.mesh();
    const bool is_point =
      is_leaf && std::all_of(contour.edges.begin(), contour.edges.end(), [&](const auto& h) {
        const vertex_descriptor from = source(h, mesh), to = target(h, mesh);
        return (from == vertex || to == vertex) && augmentation_.value(from) != augmentation_.value(to);
      });
    if(!is_point)
      centroid.add(contour, points_of(augmentation_, contour, point_map_));
  }

  const Augmentation& augmentation_;
  const typename Augmentation::Graph& graph_;
  const PointMap& point_map_;
  boost::unordered_map<vertex_descriptor, std::size_t> loop_of_vertex_; // by vertex of borders that leaves are on
  std::vector<Centroid> centroids_of_loops_;
};

// How far apart two lines are that look like one: about the width of a line in a picture of all.
inline double width_of_lines(const std::vector<Contours_of_arc>& contours)
{
  constexpr double part_of_picture = 0.015;
  Bbox_3 box;
  for(const Contours_of_arc& arc : contours)
    for(const auto& [x, y, z] : arc.contour_points)
      box += Bbox_3(x, y, z, x, y, z);
  return box.xmin() <= box.xmax() ? part_of_picture * length_of(box.x_span(), box.y_span(), box.z_span()) : 0;
}

// Whether the two sides of a loop look like one line, as those of a round tube inside of another one.
inline bool do_coincide(const Contours_of_arc& a, const Contours_of_arc& b, double small)
{
  return std::equal(a.centroids.begin(), a.centroids.end(), b.centroids.begin(), b.centroids.end(),
                    [&](const Coordinates& p, const Coordinates& q) { return distance(p, q) <= small; });
}

// Moves those arcs halfway to their contours that lead from the same node to the same node along the same line.
template <class Graph>
void separate_parallel_arcs(const Graph& graph, std::vector<Contours_of_arc>& contours)
{
  std::vector<std::pair<std::pair<std::size_t, std::size_t>, std::size_t>> arcs; // by their ends
  for(const auto arc : CGAL::make_range(edges(graph)))
    arcs.push_back({{source(arc, graph), target(arc, graph)}, arcs.size()});
  std::sort(arcs.begin(), arcs.end());
  std::vector<bool> is_moved(contours.size(), false);
  const double width = width_of_lines(contours);
  for(auto first = arcs.begin(), last = first; first != arcs.end(); first = last)
  {
    last = std::find_if(first, arcs.end(), [&](const auto& arc) { return arc.first != first->first; });
    for(auto i = first; i != last; ++i)
      for(auto j = first; j != i; ++j)
        if(do_coincide(contours[i->second], contours[j->second], width))
          is_moved[i->second] = is_moved[j->second] = true;
  }
  for(std::size_t i = 0; i != contours.size(); ++i)
  {
    for(std::size_t j = 0; is_moved[i] && j != contours[i].centroids.size(); ++j)
      contours[i].centroids[j] = mix(0.5, contours[i].centroids[j], contours[i].contour_points[j]);
  }
}

// Replaces each inner point by the mean of itself and the middle of its neighbors, as many times as given.
inline void smooth_inner_points(std::vector<Coordinates>& points, std::size_t number_of_steps)
{
  for(std::size_t step = 0; step != number_of_steps; ++step)
  {
    const std::vector<Coordinates> old = points;
    for(std::size_t i = 1; i + 1 < points.size(); ++i)
      points[i] = mix(0.5, old[i], mix(0.5, old[i - 1], old[i + 1]));
  }
}

// Calls function(i) for i from 0 to size - 1, and tells the progress before some blocks of them.
template <class Function>
void for_each_reported(const Threads& threads,
                       std::size_t size,
                       const Stage_progress& progress,
                       const Function& function)
{
  const std::size_t block = size / 64 + 1;
  for(std::size_t begin = 0; begin < size; begin += block)
  {
    progress(static_cast<double>(begin) / static_cast<double>(size));
    threads.for_each_index((std::min)(block, size - begin), [&](std::size_t i) { function(begin + i); });
  }
}

// Where the contours of a line are that leads through `inner` ones at equal steps, and through `outer` more at each end,
// each a quarter as far from the end as the next one inwards. `t` counts them all as if they were at equal steps.
inline double graded_place(double t, std::size_t inner, std::size_t outer)
{
  if(outer == 0)
    return t;
  const double step = 1 / static_cast<double>(inner + 1);
  const long number = std::lround(t * static_cast<double>(inner + 2 * outer + 1)) - static_cast<long>(outer);
  const long beyond = number - static_cast<long>(inner);
  return number < 1 ? step * std::pow(0.25, static_cast<double>(1 - number))
       : beyond > 0 ? 1 - step * std::pow(0.25, static_cast<double>(beyond))
                    : static_cast<double>(number) * step;
}

// Puts a graph into space, its nodes at their vertices first.
template <class Augmentation, class PointMap>
class Graph_embedder
{
  typedef typename boost::property_traits<PointMap>::value_type Point;

public:
  Embedding<Point> result;

  Graph_embedder(const Threads& threads,
                 const Augmentation& augmentation,
                 const PointMap& point_map,
                 const Progress& progress)
    : threads_(threads),
      augmentation_(augmentation),
      graph_(augmentation.graph()),
      point_map_(point_map),
      progress_(progress),
      arcs_(edges(graph_).first, edges(graph_).second)
  {
    for(const auto node : CGAL::make_range(vertices(graph_)))
    {
      result.node_points.push_back(get(point_map, graph_[node].vertex));
      result.node_values.push_back(augmentation.value(graph_[node].vertex));
    }
  }

  void embed_straight()
  {
    for(const auto arc : arcs_)
    {
      const auto lower = source(arc, graph_), upper = target(arc, graph_);
      result.arc_polylines.push_back({result.node_points[lower], result.node_points[upper]});
      result.arc_values.push_back({result.node_values[lower], result.node_values[upper]});
    }
  }

  void embed_on_surface()
  {
    const Chain_polylines<Augmentation, PointMap> polylines(augmentation_, point_map_);
    result.arc_polylines.resize(arcs_.size());
    result.arc_values.resize(arcs_.size());
    for_each_reported(threads_, arcs_.size(), Stage_progress(progress_, 0, 1),
                      [&](std::size_t i) { polylines(arcs_[i], result.arc_polylines[i], result.arc_values[i]); });
  }

  // Returns false if the contours of arcs cross more than so many edges.
  template <class NamedParameters>
  bool embed_at_centroids(std::size_t most_crossings, const NamedParameters& np)
  {
    using parameters::get_parameter;
    const std::size_t number_of_contours = internal::parameter_or(np, internal::number_of_contours, std::size_t(12));
    const std::size_t number_of_contours_at_nodes =
      internal::parameter_or(np, internal::number_of_contours_at_nodes, std::size_t(0));
    const auto parametrization_map = get_parameter(np, internal::parametrization_map);
    const Centroid_polylines<Augmentation, PointMap> centroids(augmentation_, point_map_);
    std::vector<Contours_of_arc> contours(arcs_.size());
    std::atomic<std::size_t> crossings = 0;
    const auto contour_at = [&](const auto arc, double place) {
      const double t = graded_place(place, number_of_contours, number_of_contours_at_nodes);
      typename Augmentation::Contour contour;
      if constexpr(is_given<decltype(parametrization_map)>)
        contour = augmentation_.contour(arc, t, parametrization_map);
      else
        contour = augmentation_.contour(arc, t);
      crossings += contour.number_of_crossings();
      return contour;
    };
    for_each_reported(threads_, arcs_.size(), Stage_progress(progress_, 0, 0.9), [&](std::size_t i) {
      if(crossings <= most_crossings)
        contours[i] = centroids.contours(arcs_[i], number_of_contours + 2 * number_of_contours_at_nodes, contour_at);
    });
    if(crossings > most_crossings)
      return false;
    for_each_reported(threads_, result.node_points.size(), Stage_progress(progress_, 0.9, 1),
                      [&](std::size_t i) { result.node_points[i] = centroids.node_point(i); });
    separate_parallel_arcs(graph_, contours);
    embed_straight();
    for(std::size_t i = 0; i != arcs_.size(); ++i)
      add_inner_points(contours[i], internal::parameter_or(np, number_of_smoothing_steps, std::size_t(0)),
                       result.arc_polylines[i], result.arc_values[i]);
    return true;
  }

private:
  // Makes a straight line one through centroids.
  static void add_inner_points(const Contours_of_arc& contours,
                               std::size_t number_of_smoothing_steps,
                               std::vector<Point>& polyline,
                               std::vector<double>& values)
  {
    std::vector<Coordinates> line = {coordinates_of(polyline.front())};
    line.insert(line.end(), contours.centroids.begin(), contours.centroids.end());
    line.push_back(coordinates_of(polyline.back()));
    smooth_inner_points(line, number_of_smoothing_steps);
    const Point last = polyline.back();
    polyline.pop_back();
    for(std::size_t j = 1; j + 1 < line.size(); ++j)
      polyline.push_back(make_point<Point>(line[j]));
    polyline.push_back(last);
    values.insert(values.begin() + 1, contours.values.begin(), contours.values.end());
  }

  const Threads threads_;
  const Augmentation& augmentation_;
  const typename Augmentation::Graph& graph_;
  const PointMap& point_map_;
  const Progress& progress_;
  const std::vector<typename Augmentation::arc_descriptor> arcs_;
};

template <class Augmentation, class PointMap, class NamedParameters>
auto embed_in_manner(const Threads& threads,
                     const Augmentation& augmentation,
                     const PointMap& point_map,
                     const NamedParameters& np)
{
  const Progress progress(np);
  Graph_embedder<Augmentation, PointMap> embedder(threads, augmentation, point_map, progress);
  Embedding_manner& manner = embedder.result.manner;
  manner = internal::parameter_or(np, internal::embedding_manner, Embedding_manner::BY_COST);
  std::size_t most_crossings = (std::numeric_limits<std::size_t>::max)();
  if(manner == Embedding_manner::BY_COST)
  {
    most_crossings = 64 * num_vertices(augmentation.mesh()) + (std::size_t(1) << 20);
    manner = Embedding_manner::CENTROIDS;
  }
  if(manner == Embedding_manner::CENTROIDS && !embedder.embed_at_centroids(most_crossings, np))
    manner = Embedding_manner::STRAIGHT;
  if(manner == Embedding_manner::ON_SURFACE)
    embedder.embed_on_surface();
  if(manner == Embedding_manner::STRAIGHT)
    embedder.embed_straight();
  progress.report_end();
  return std::move(embedder.result);
}

} // namespace CGAL::Reeb_graph::internal

namespace CGAL::Reeb_graph {

/// \ingroup PkgReebGraphEmbedding
///
/// \brief puts a Reeb graph into space: finds a point for each node, and for each arc a polyline from node to node.
///
/// The polylines begin and end exactly at the points of the nodes. In the manner `CENTROIDS`, a node with arcs above
/// and below is at the centroid of the contours just below it. A leaf is at its vertex, or, on a mesh, in the middle of
/// the border loop or of the tied vertices around it. In the other manners each node is at its vertex.
///
/// - `CENTROIDS`: the polyline of an arc leads through the centroids, by length or, in tetrahedra, by area, of `number_of_contours` contours, at
///   equal steps of the field. Two arcs of the same nodes can have lines that coincide, as a tube inside of a round
///   tube. If they are nowhere further apart than 1.5 percent of the extent of all contours, about the width of a line
///   in a picture, they are moved halfway to the surface. It takes time proportional to the lengths of these contours
///   and of those just below the nodes, and to the square of the number of arcs that join the same two nodes.
/// - `ON_SURFACE`: the polyline follows the chain of the arc. Where that passes by the upper node, or by a node that
///   has been removed, it goes on along the contour just below that, the shortest way along its lines, or along the sides of
///   its triangles. It stays on the surface, and its values ascend, and stay the same on this part of a contour. Where
///   it passes a plateau of a complex, as ties are contracted, it goes straight, and can leave the complex. It takes
///   time near-linear in the lengths of the chains and of these contours.
/// - `STRAIGHT`: the polyline has two points; parallel arcs have the same ones.
/// - `BY_COST`: `STRAIGHT` if the contours of `CENTROIDS` cross more than 64 edges for each vertex of the mesh, and
///   \f$ 2^{20} \f$ besides; otherwise `CENTROIDS`. Finding out crosses no more edges than that. The result says which
///   manner it is, which does not depend on threads.
///
/// \tparam ConcurrencyTag `Sequential_tag`, `Parallel_tag`, or `Parallel_if_available_tag`: whether arcs are embedded
///         in parallel; the point map and `parametrization_map` are then read by several threads
///
/// \param augmentation an `Augmentation`, `Soup_augmentation`, or `Tetrahedra_augmentation`: the way from the graph
/// \param points the points of the vertices, which are those of a three-dimensional kernel, as
///        `Basic_augmentation::points_of_contour()` takes them. For a mesh, the named parameters can stand in this place
/// \param np an optional sequence of \ref bgl_namedparameters "Named Parameters" among the ones listed below
///
/// \cgalNamedParamsBegin
///   \cgalParamNBegin{embedding_manner}
///     \cgalParamDescription{the way of the arcs}
///     \cgalParamType{`Reeb_graph::Embedding_manner`}
///     \cgalParamDefault{`Embedding_manner::BY_COST`}
///   \cgalParamNEnd
///   \cgalParamNBegin{number_of_contours}
///     \cgalParamDescription{for `CENTROIDS`: the number of contours that the polyline of an arc leads through; 0 gives
///                           straight lines}
///     \cgalParamType{`std::size_t`}
///     \cgalParamDefault{12}
///   \cgalParamNEnd
///   \cgalParamNBegin{number_of_contours_at_nodes}
///     \cgalParamDescription{for `CENTROIDS`: the number of further contours between each node and the next one of
///                           these contours, each a quarter as far from the node as the one before. The contours of a
///                           saddle have another centroid than those just beyond it. With further contours, a line goes
///                           from the saddle to the middle of its own contours first, and does not leave the surface.}
///     \cgalParamType{`std::size_t`}
///     \cgalParamDefault{0}
///   \cgalParamNEnd
///   \cgalParamNBegin{number_of_smoothing_steps}
///     \cgalParamDescription{for `CENTROIDS`: the number of times that each inner point of a polyline is replaced by
///                           the mean of itself and of the middle of its neighbors}
///     \cgalParamType{`std::size_t`}
///     \cgalParamDefault{0}
///   \cgalParamNEnd
///   \cgalParamNBegin{parametrization_map}
///     \cgalParamDescription{for `CENTROIDS`: another field, whose differences along the chain of the arc are the steps
///                           between contours, as for `Augmentation::contour()`; that takes time proportional to the
///                           length of the chain for each contour}
///     \cgalParamType{a model of `ReadablePropertyMap` with the vertices as key type, and a value type that can be converted to `double`}
///     \cgalParamDefault{equal steps of the field itself}
///   \cgalParamNEnd
///   \reebGraphPoints{ReadablePropertyMap}
///   \reebGraphCallback
/// \cgalNamedParamsEnd
///
/// \pre The graph is that of the mesh and the field.
///
/// \reebGraphComplexity
///
/// \returns an `Embedding` with the type of the points.
///
/// \exception Attribute_count_error if points are a range, and not one for each vertex
/// \exception Graph_mismatch_error if the chain of an arc does not lead to its contours
/// \exception Non_finite_scalar_error if a value of `parametrization_map` along a chain is infinite or NaN
/// \exception Cancelled_error if `callback` returns `false`
template <class ConcurrencyTag = Sequential_tag,
          class GraphOnMesh,
          class Points = parameters::Default_named_parameters,
          class NamedParameters = parameters::Default_named_parameters>
auto embed(const Basic_augmentation<GraphOnMesh>& augmentation,
           const Points& points = parameters::default_values(),
           const NamedParameters& np = parameters::default_values())
{
  const auto point_map = augmentation.on_mesh().point_map(points);
  if constexpr(internal::are_named_parameters<Points>)
    return internal::embed_in_manner(internal::threads_of<ConcurrencyTag>(), augmentation, point_map, points);
  else
    return internal::embed_in_manner(internal::threads_of<ConcurrencyTag>(), augmentation, point_map, np);
}

} // namespace CGAL::Reeb_graph

#endif // CGAL_REEB_GRAPH_EMBED_H
