// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of the CGAL-style package Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_INTERNAL_WAY_BACK_EMBED_ARCS_H
#define CGAL_REEB_GRAPH_INTERNAL_WAY_BACK_EMBED_ARCS_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/Embedding.h>
#include <CGAL/Reeb_graph/internal/base/Progress.h>
#include <CGAL/Reeb_graph/internal/base/named_parameter.h>
#include <CGAL/Reeb_graph/internal/base/parallel.h>
#include <CGAL/Reeb_graph/internal/way_back/arc_polylines.h>
#include <CGAL/Reeb_graph/named_parameters.h>
#include <CGAL/Reeb_graph/options.h>

#include <CGAL/boost/graph/iterator.h>

#include <boost/property_map/property_map.hpp>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL::Reeb_graph::internal {

template <class Augmentation>
std::vector<typename Augmentation::arc_descriptor> arcs_of(const Augmentation& augmentation)
{
  const auto arcs = edges(augmentation.graph());
  return std::vector<typename Augmentation::arc_descriptor>(arcs.first, arcs.second);
}

template <class Result, class Augmentation, class PointMap>
void embed_nodes_at_vertices(const Augmentation& augmentation, const PointMap& point_map, Result& result)
{
  const auto& graph = augmentation.graph();
  for(const auto node : CGAL::make_range(vertices(graph)))
  {
    result.node_points.push_back(get(point_map, graph[node].vertex));
    result.node_values.push_back(augmentation.value(graph[node].vertex));
  }
}

template <class Result, class Augmentation>
void embed_straight(const Augmentation& augmentation, Result& result)
{
  const auto& graph = augmentation.graph();
  for(const auto arc : CGAL::make_range(edges(graph)))
  {
    const auto lower = source(arc, graph), upper = target(arc, graph);
    result.arc_polylines.push_back({result.node_points[lower], result.node_points[upper]});
    result.arc_values.push_back({result.node_values[lower], result.node_values[upper]});
  }
}

// Calls function(i) for i from 0 to size - 1, and tells the progress before some blocks of them.
template <class ConcurrencyTag, class Function>
void for_each_reported(std::size_t size, const Stage_progress& progress, const Function& function)
{
  const std::size_t block = size / 64 + 1;
  for(std::size_t begin = 0; begin < size; begin += block)
  {
    progress(static_cast<double>(begin) / static_cast<double>(size));
    for_each_index<ConcurrencyTag>((std::min)(block, size - begin), [&](std::size_t i) { function(begin + i); });
  }
}

template <class ConcurrencyTag, class Result, class Augmentation, class PointMap>
void embed_on_surface(const Augmentation& augmentation,
                      const PointMap& point_map,
                      const Progress& progress,
                      Result& result)
{
  const Chain_polylines<Augmentation, PointMap> polylines(augmentation, point_map);
  const auto arcs = arcs_of(augmentation);
  result.arc_polylines.resize(arcs.size());
  result.arc_values.resize(arcs.size());
  for_each_reported<ConcurrencyTag>(arcs.size(), Stage_progress(progress, 0, 1), [&](std::size_t i) {
    auto line = polylines(arcs[i]);
    result.arc_polylines[i] = std::move(line.points);
    result.arc_values[i] = std::move(line.values);
  });
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

// Returns false if the contours of arcs cross more than so many edges.
template <class ConcurrencyTag, class Result, class Augmentation, class PointMap, class NamedParameters>
bool embed_at_centroids(const Augmentation& augmentation,
                        const PointMap& point_map,
                        std::size_t most_crossings,
                        const NamedParameters& np,
                        const Progress& progress,
                        Result& result)
{
  using parameters::choose_parameter;
  using parameters::get_parameter;
  typedef typename Result::Point Point;
  const auto& graph = augmentation.graph();
  const std::size_t number_of_contours =
    choose_parameter(get_parameter(np, internal::number_of_contours), std::size_t(12));
  const std::size_t number_of_contours_at_nodes =
    choose_parameter(get_parameter(np, internal::number_of_contours_at_nodes), std::size_t(0));
  const std::size_t number_of_smoothing_steps =
    choose_parameter(get_parameter(np, internal::number_of_smoothing_steps), std::size_t(0));
  const auto parametrization_map = get_parameter(np, internal::parametrization_map);
  const auto contour_at = [&](const auto arc, double t) {
    if constexpr(is_given<decltype(parametrization_map)>)
      return augmentation.contour(arc, t, parametrization_map);
    else
      return augmentation.contour(arc, t);
  };

  const Centroid_polylines<Augmentation, PointMap> centroids(augmentation, point_map);
  const auto arcs = arcs_of(augmentation);
  std::vector<Contours_of_arc> contours(arcs.size());
  std::atomic<std::size_t> crossings = 0;
  for_each_reported<ConcurrencyTag>(arcs.size(), Stage_progress(progress, 0, 0.9), [&](std::size_t i) {
    const auto counted_contour_at = [&](const auto arc, double t) {
      auto contour = contour_at(arc, graded_place(t, number_of_contours, number_of_contours_at_nodes));
      crossings += crossed_edges(contour).size();
      return contour;
    };
    if(crossings <= most_crossings)
      contours[i] =
        centroids.contours(arcs[i], number_of_contours + 2 * number_of_contours_at_nodes, counted_contour_at);
  });
  if(crossings > most_crossings)
    return false;
  for_each_reported<ConcurrencyTag>(result.node_points.size(), Stage_progress(progress, 0.9, 1),
                                    [&](std::size_t i) { result.node_points[i] = centroids.node_point(i); });
  separate_parallel_arcs(graph, contours);
  embed_straight(augmentation, result);
  for(std::size_t i = 0; i != arcs.size(); ++i)
  {
    std::vector<Coordinates>& line = contours[i].centroids;
    line.insert(line.begin(), coordinates_of(result.arc_polylines[i].front()));
    line.push_back(coordinates_of(result.arc_polylines[i].back()));
    smooth(line, number_of_smoothing_steps);
    std::vector<Point> inner_points;
    for(std::size_t j = 1; j + 1 < line.size(); ++j)
      inner_points.push_back(make_point<Point>(line[j]));
    auto& polyline = result.arc_polylines[i];
    auto& values = result.arc_values[i];
    polyline.insert(polyline.begin() + 1, inner_points.begin(), inner_points.end());
    values.insert(values.begin() + 1, contours[i].values.begin(), contours[i].values.end());
  }
  return true;
}

template <class ConcurrencyTag, class Augmentation, class PointMap, class NamedParameters>
auto embed_in_manner(const Augmentation& augmentation, const PointMap& point_map, const NamedParameters& np)
{
  using parameters::choose_parameter;
  using parameters::get_parameter;
  const Progress progress(np);
  Embedding<typename boost::property_traits<PointMap>::value_type> result;
  embed_nodes_at_vertices(augmentation, point_map, result);
  Embedding_manner& manner = result.manner;
  manner = choose_parameter(get_parameter(np, internal::embedding_manner), Embedding_manner::BY_COST);
  std::size_t most_crossings = (std::numeric_limits<std::size_t>::max)();
  if(manner == Embedding_manner::BY_COST)
  {
    most_crossings = 64 * num_vertices(augmentation.mesh()) + (std::size_t(1) << 20);
    manner = Embedding_manner::CENTROIDS;
  }
  if(manner == Embedding_manner::CENTROIDS
     && !embed_at_centroids<ConcurrencyTag>(augmentation, point_map, most_crossings, np, progress, result))
    manner = Embedding_manner::STRAIGHT;
  if(manner == Embedding_manner::ON_SURFACE)
    embed_on_surface<ConcurrencyTag>(augmentation, point_map, progress, result);
  if(manner == Embedding_manner::STRAIGHT)
    embed_straight(augmentation, result);
  progress.report_end();
  return result;
}

} // namespace CGAL::Reeb_graph::internal

#endif // CGAL_REEB_GRAPH_INTERNAL_WAY_BACK_EMBED_ARCS_H
