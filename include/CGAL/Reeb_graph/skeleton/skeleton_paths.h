// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_SKELETON_SKELETON_PATHS_H
#define CGAL_REEB_GRAPH_SKELETON_SKELETON_PATHS_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/internal/base/lengths.h>
#include <CGAL/Reeb_graph/skeleton/Curve_skeleton.h>

#include <boost/graph/dijkstra_shortest_paths.hpp>
#include <boost/graph/graph_traits.hpp>
#include <boost/property_map/function_property_map.hpp>
#include <boost/property_map/property_map.hpp>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL::Reeb_graph {

/// \ingroup PkgReebGraphSkeleton
///
/// \brief returns the shortest paths along a curve skeleton from a vertex to others, in the order of these, as sequences of
/// vertices. Where there is no path, it is empty. It takes \f$ O(n \log n) \f$ time for a skeleton of \f$ n \f$ vertices, and
/// the time of writing the paths.
///
/// \param skeleton a curve skeleton, as it has been extracted
/// \param from where all paths begin
/// \param to where they end
template <class CurveSkeleton>
std::vector<std::vector<std::size_t>> skeleton_paths(const CurveSkeleton& skeleton,
                                                     std::size_t from,
                                                     const std::vector<std::size_t>& to)
{
  typedef typename boost::graph_traits<CurveSkeleton>::edge_descriptor edge_descriptor;
  const auto length = [&](edge_descriptor e) {
    return internal::distance_between(skeleton[source(e, skeleton)].point, skeleton[target(e, skeleton)].point);
  };
  std::vector<std::size_t> before(num_vertices(skeleton));
  boost::dijkstra_shortest_paths(
    skeleton, from,
    boost::weight_map(boost::make_function_property_map<edge_descriptor, double>(length))
      .predecessor_map(boost::make_iterator_property_map(before.begin(), get(boost::vertex_index, skeleton))));
  std::vector<std::vector<std::size_t>> paths;
  for(std::size_t v : to)
  {
    std::vector<std::size_t>& path = paths.emplace_back();
    if(v != from && before[v] == v)
      continue;
    for(; v != from; v = before[v])
      path.push_back(v);
    path.push_back(from);
    std::reverse(path.begin(), path.end());
  }
  return paths;
}

} // namespace CGAL::Reeb_graph

#endif // CGAL_REEB_GRAPH_SKELETON_SKELETON_PATHS_H
