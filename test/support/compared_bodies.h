// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_TEST_COMPARED_BODIES_H
#define CGAL_REEB_GRAPH_TEST_COMPARED_BODIES_H

#include "generated_surfaces/build_mesh.h"
#include "generated_surfaces/posed_body.h"
#include "random_meshes.h"
#include "shuffle.h"

#include <CGAL/Reeb_graph/Augmentation.h>
#include <CGAL/Reeb_graph/comparison/match_arcs.h>
#include <CGAL/Reeb_graph/fields/geodesic_field.h>
#include <CGAL/Reeb_graph/simplification/simplification_thresholds.h>
#include <CGAL/Reeb_graph/simplification/simplify.h>
#include <CGAL/Reeb_graph_traits.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/compute_reeb_graph.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <numeric>
#include <optional>
#include <utility>
#include <vector>

// Bodies in poses, and the limbs that match_arcs() takes for the same.
namespace compared_bodies {
typedef CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3> Mesh;
typedef Mesh::Property_map<Mesh::Vertex_index, double> Scalar_map;
typedef CGAL::Reeb_graph_traits<Mesh, Scalar_map>::Graph Graph;

// A body with the distance from the top of its head, or from another vertex, and its graph, simplified as is suggested.
struct Compared_body
{
  Compared_body(generated_surfaces::Posed_body body, double unit, const std::vector<std::size_t>& new_numbers)
    : top_of_head(static_cast<Mesh::size_type>(new_numbers[body.top_of_head]))
  {
    for(auto& point : body.soup.points)
      for(double& coordinate : point)
        coordinate *= unit;
    const std::size_t n = body.parts.size();
    parts.resize(n);
    for(std::size_t v = 0; v != n; ++v)
      parts[new_numbers[v]] = body.parts[v];
    generated_surfaces::renumber(body.soup, new_numbers);
    generated_surfaces::build(mesh, body.soup);
    field = mesh.add_property_map<Mesh::Vertex_index, double>("v:field").first;
    see_from(top_of_head);
  }

  void see_from(Mesh::Vertex_index source)
  {
    CGAL::Reeb_graph::compute_geodesic_field(mesh, field, std::vector<Mesh::Vertex_index>(1, source));
    Graph given;
    CGAL::compute_reeb_graph(mesh, field, given);
    std::vector<CGAL::Reeb_graph::Simplification_threshold> thresholds;
    CGAL::Reeb_graph::simplification_thresholds(given, std::back_inserter(thresholds));
    double threshold = 0;
    for(const auto& found : thresholds)
      if(found.is_suggested)
        threshold = found.threshold;
    simplification = CGAL::Reeb_graph::simplify(given, threshold, graph);
  }

  auto augmentation() const
  {
    return CGAL::Reeb_graph::Augmentation<Mesh, Scalar_map>(mesh, field, graph,
                                                            CGAL::parameters::simplification(*simplification));
  }

  // The vertex of the leaf at the end of an arc; that of the lower one at the top of the head.
  std::size_t leaf(boost::graph_traits<Graph>::edge_descriptor arc) const
  {
    for(const auto node : {source(arc, graph), target(arc, graph)})
      if(degree(node, graph) == 1)
        return graph[node].vertex;
    return parts.size();
  }

  Mesh::Vertex_index top_of_head;
  Mesh mesh;
  Scalar_map field;
  Graph graph;
  std::optional<CGAL::Reeb_graph::Simplification<Graph>> simplification;
  std::vector<generated_surfaces::Body_part> parts; // by vertex
};

inline std::vector<std::size_t> own_numbers(std::size_t n)
{
  std::vector<std::size_t> numbers(n);
  std::iota(numbers.begin(), numbers.end(), std::size_t(0));
  return numbers;
}

// Points are moved by at most `noise` in each direction, in parts of the diagonal of the box.
inline generated_surfaces::Posed_body posed_body(unsigned body_seed, unsigned pose_seed, double noise)
{
  auto posed = generated_surfaces::posed_body(body_seed, pose_seed, 4500);
  random_meshes::Random random(pose_seed);
  double square = 0;
  for(std::size_t i = 0; i != 3; ++i)
  {
    const auto [low, high] = std::minmax_element(posed.soup.points.begin(), posed.soup.points.end(),
                                                 [i](const auto& p, const auto& q) { return p[i] < q[i]; });
    square += ((*high)[i] - (*low)[i]) * ((*high)[i] - (*low)[i]);
  }
  for(auto& point : posed.soup.points)
    for(double& coordinate : point)
      coordinate += noise * std::sqrt(square) * (static_cast<double>(random.below(2000001)) / 1000000 - 1);
  return posed;
}

inline Compared_body body(unsigned body_seed, unsigned pose_seed, double noise = 0)
{
  const auto posed = posed_body(body_seed, pose_seed, noise);
  return Compared_body(posed, 1, own_numbers(posed.parts.size()));
}

// The vertices of leaves whose arcs are partners.
inline std::vector<std::pair<std::size_t, std::size_t>> matched_leaves(const Compared_body& a, const Compared_body& b)
{
  typedef boost::graph_traits<Graph>::edge_descriptor Arc;
  std::vector<std::pair<Arc, Arc>> partners;
  CGAL::Reeb_graph::match_arcs(a.graph, a.augmentation(), b.graph, b.augmentation(), std::back_inserter(partners));
  std::vector<std::pair<std::size_t, std::size_t>> leaves;
  for(const auto& [arc_a, arc_b] : partners)
    if(a.leaf(arc_a) != a.parts.size() && b.leaf(arc_b) != b.parts.size())
      leaves.emplace_back(a.leaf(arc_a), b.leaf(arc_b));
  return leaves;
}

} // namespace compared_bodies

#endif // CGAL_REEB_GRAPH_TEST_COMPARED_BODIES_H
