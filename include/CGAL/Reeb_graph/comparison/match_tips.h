// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_COMPARISON_MATCH_TIPS_H
#define CGAL_REEB_GRAPH_COMPARISON_MATCH_TIPS_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/Augmentation.h>
#include <CGAL/Reeb_graph/comparison/match_arcs.h>
#include <CGAL/Reeb_graph/fields/field_constraints.h>
#include <CGAL/Reeb_graph/fields/geodesic_field.h>
#include <CGAL/Reeb_graph/internal/base/lengths.h>
#include <CGAL/Reeb_graph/simplification/simplification_thresholds.h>
#include <CGAL/Reeb_graph/simplification/simplify.h>
#include <CGAL/Reeb_graph_traits.h>
#include <CGAL/compute_reeb_graph.h>

#include <CGAL/boost/graph/iterator.h>
#include <CGAL/boost/graph/properties.h>
#include <CGAL/centroid.h>

#include <boost/graph/graph_traits.hpp>
#include <boost/iterator/transform_iterator.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <utility>
#include <vector>

namespace CGAL::Reeb_graph {

/// \ingroup PkgReebGraphComparison
///
/// \brief a tip of one mesh, and the tip of another one that stands for the same place.
///
/// \tparam VertexA, VertexB the vertex descriptors of the meshes
template <class VertexA, class VertexB>
struct Tip_pair
{
  VertexA tip_a; ///< a vertex of the first mesh
  VertexB tip_b; ///< a vertex of the second mesh
  /// what `match_arcs()` pays in all for the graphs of the distances from these two, and a millionth of how much their greatest
  /// distances differ, as shares of the greatest one of each mesh
  double price;
};

namespace internal {

// The tips of a mesh that is connected but for vertices without faces, none of another one, and the arcs of the graph of the distance from each: the leaves of
// the graph of the distance from an end of a long way. Graphs are simplified as is suggested.
template <class Mesh>
class Tips_of_mesh
{
public:
  typedef typename boost::graph_traits<Mesh>::vertex_descriptor Vertex;

  explicit Tips_of_mesh(const Mesh& mesh) : mesh_(mesh)
  {
    std::vector<std::pair<Vertex, Vertex>> far_apart;
    find_far_apart_vertices(mesh, std::back_inserter(far_apart));
    for(const auto& [v, any] : far_apart)
      if(is_isolated(v))
        sources_.push_back(v);
    if(far_apart.size() != 1 + sources_.size())
      return;
    tips_.push_back(find_end(find_start()));
    for(std::size_t i = 0; i != tips_.size(); ++i) // The first one adds others.
      see_from(i);
  }

  const std::vector<Vertex>& tips() const { return tips_; }
  const std::vector<Compared_arc>& arcs_seen_from(std::size_t tip) const { return arcs_[tip]; }

  // The greatest distance, by that from any tip.
  double reach_of(std::size_t tip) const
  {
    return part_of(reaches_[tip], *std::max_element(reaches_.begin(), reaches_.end()));
  }

private:
  typedef typename boost::property_map<Mesh, dynamic_vertex_property_t<double>>::const_type Distance_map;

  bool is_isolated(Vertex v) const { return halfedge(v, mesh_) == boost::graph_traits<Mesh>::null_halfedge(); }

  Distance_map distance_from(Vertex source) const
  {
    const Distance_map distance = get(dynamic_vertex_property_t<double>(), mesh_);
    std::vector<Vertex> sources = sources_;
    sources.push_back(source);
    compute_geodesic_field(mesh_, distance, sources);
    return distance;
  }

  template <class Distance>
  Vertex farthest(const Distance& distance) const
  {
    const auto all = vertices(mesh_);
    return *std::max_element(all.first, all.second, [&](Vertex u, Vertex v) { return distance(u) < distance(v); });
  }

  // The vertex farthest from the middle of all, which does not depend on their order. One without faces is on no way.
  Vertex find_start() const
  {
    const auto point = [points = get(vertex_point, mesh_)](Vertex v) { return get(points, v); };
    const auto all = vertices(mesh_);
    const auto middle = CGAL::centroid(boost::make_transform_iterator(all.first, point),
                                       boost::make_transform_iterator(all.second, point));
    return farthest([&](Vertex v) { return is_isolated(v) ? -1 : distance_between(point(v), middle); });
  }

  // Goes to the farthest vertex until the way leads back, and returns the one of both ends that is farther from all
  // vertices. So it hardly depends on where it begins.
  Vertex find_end(Vertex v) const
  {
    constexpr int most_steps = 16;
    Vertex last = v;
    double last_sum = 0;
    for(int step = 0; step != most_steps; ++step)
    {
      const Distance_map distance = distance_from(v);
      double sum = 0;
      for(const Vertex u : CGAL::make_range(vertices(mesh_)))
        sum += get(distance, u);
      const Vertex next = farthest([&](Vertex u) { return get(distance, u); });
      if(next == last)
        return last_sum < sum ? v : last;
      last_sum = sum;
      last = std::exchange(v, next);
    }
    return v;
  }

  void see_from(std::size_t i)
  {
    const Distance_map distance = distance_from(tips_[i]);
    typename Reeb_graph_traits<Mesh, Distance_map>::Graph given, graph;
    compute_reeb_graph(mesh_, distance, given);
    std::vector<Simplification_threshold> thresholds;
    simplification_thresholds(given, std::back_inserter(thresholds));
    const auto suggested =
      std::find_if(thresholds.begin(), thresholds.end(), [](const auto& t) { return t.is_suggested; });
    const auto simplification = simplify(given, suggested == thresholds.end() ? 0 : suggested->threshold, graph);
    const Augmentation<Mesh, Distance_map> augmentation(mesh_, distance, graph,
                                                        parameters::simplification(simplification));
    arcs_.push_back(compared_arcs(graph, augmentation));
    reaches_.push_back(get(distance, farthest([&](Vertex v) { return get(distance, v); })));
    if(i == 0)
      for(const auto node : CGAL::make_range(vertices(graph)))
        if(degree(node, graph) == 1 && get(distance, graph[node].vertex) > 0) // All points can be one.
          tips_.push_back(graph[node].vertex);
  }

  const Mesh& mesh_;
  std::vector<Vertex> sources_; // those without faces: nothing else has a distance from them
  std::vector<Vertex> tips_;
  std::vector<std::vector<Compared_arc>> arcs_;
  std::vector<double> reaches_;
};

// Pairs of tips, the two that are most alike first.
template <class TipsA, class TipsB>
auto match_tips(const TipsA& a, const TipsB& b)
{
  const std::size_t number_a = a.tips().size(), number_b = b.tips().size();
  std::vector<std::vector<double>> prices(number_a);
  for(std::size_t i = 0; i != number_a; ++i)
    for(std::size_t j = 0; j != number_b; ++j)
      prices[i].push_back(match(a.arcs_seen_from(i), b.arcs_seen_from(j), 1).price
                          + 1e-6 * std::abs(a.reach_of(i) - b.reach_of(j))); // The graphs can be single arcs.
  const std::vector<std::size_t> assigned = assign((std::max)(number_a, number_b), [&](std::size_t i, std::size_t j) {
    return i < number_a && j < number_b ? prices[i][j] : 0.;
  });
  std::vector<Tip_pair<typename TipsA::Vertex, typename TipsB::Vertex>> pairs;
  for(std::size_t i = 0; i != number_a; ++i)
    if(assigned[i] < number_b)
      pairs.push_back({a.tips()[i], b.tips()[assigned[i]], prices[i][assigned[i]]});
  std::stable_sort(pairs.begin(), pairs.end(), [](const auto& p, const auto& q) { return p.price < q.price; });
  return pairs;
}

} // namespace internal

/// \ingroup PkgReebGraphComparison
///
/// \brief finds which tips of two meshes stand for the same place, as the heads of two bodies, without any field.
///
/// Distances from such tips are fields that mean the same on both meshes, as `match_arcs()` needs. The tips of a mesh are
/// where the Reeb graph of the distance from an end of a long way through it has leaves, once it is simplified by the
/// threshold that `simplification_thresholds()` suggests. Each tip of the one mesh is taken as a source with each of the
/// other one, and the arcs of their two graphs are matched. Then tips are assigned to each other, one to one, so that the
/// sum of the prices of all these matchings is least: two that are alike by chance cost more at the other tips.
///
/// There is no promise that tips are the right ones. Tips that are alike, as those of a left and a right arm, are not told
/// apart. Nothing depends on units; the order of vertices decides only where distances are nearly the same.
///
/// With \f$ t \f$ tips, it takes the time of \f$ t \f$ geodesic fields and graphs of each mesh, and of \f$ t^2 \f$
/// matchings.
///
/// \tparam MeshA, MeshB models of `FaceListGraph`, as for `compute_geodesic_field()`
/// \tparam OutputIterator a model of `OutputIterator` for `Tip_pair` of vertex descriptors of both meshes
///
/// \param mesh_a an oriented triangulated surface
/// \param mesh_b another one
/// \param tips the output: pairs of tips, the two that are most alike first
///
/// \returns the output iterator behind the last pair; there is none if a mesh has not one connected component,
///          vertices without faces aside.
///
/// \exception Reeb_graph::Too_many_arcs_error if a simplified graph has more than 300 arcs
///
/// and those of `compute_geodesic_field()`.
template <class MeshA, class MeshB, class OutputIterator>
OutputIterator match_tips(const MeshA& mesh_a, const MeshB& mesh_b, OutputIterator tips)
{
  const auto pairs = internal::match_tips(internal::Tips_of_mesh<MeshA>(mesh_a), internal::Tips_of_mesh<MeshB>(mesh_b));
  return std::copy(pairs.begin(), pairs.end(), tips);
}

} // namespace CGAL::Reeb_graph

#endif // CGAL_REEB_GRAPH_COMPARISON_MATCH_TIPS_H
