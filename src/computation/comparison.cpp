// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#include "computation/comparison.h"

#include "base/progress_bar.h"

#include <CGAL/Reeb_graph/comparison/match_arcs.h>
#include <CGAL/Reeb_graph/comparison/match_tips.h>

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <map>

namespace reeb_graph_program {
Persistence_values find_persistence_values(const Graph& graph, double base)
{
  Persistence_values values;
  CGAL::Reeb_graph::persistence_values(graph, std::back_inserter(values));
  for(auto& pair : values)
  {
    pair.lower += base;
    pair.upper += base;
  }
  return values;
}

std::vector<std::pair<std::string, double>> distances_by_kind(const Persistence_values& a, const Persistence_values& b)
{
  using CGAL::Reeb_graph::Persistence_pair_kind;
  std::vector<std::pair<std::string, double>> distances;
  for(const Persistence_pair_kind kind : {Persistence_pair_kind::MINIMUM_SADDLE, Persistence_pair_kind::SADDLE_MAXIMUM,
                                          Persistence_pair_kind::MINIMUM_MAXIMUM, Persistence_pair_kind::LOOP})
  {
    const auto of_kind = [kind](const Persistence_values& pairs) {
      Persistence_values result;
      std::copy_if(pairs.begin(), pairs.end(), std::back_inserter(result),
                   [kind](const auto& pair) { return pair.kind == kind; });
      return result;
    };
    distances.emplace_back(to_string(kind), CGAL::Reeb_graph::bottleneck_distance(of_kind(a), of_kind(b)));
  }
  return distances;
}

std::vector<std::vector<double>> find_distances(const std::vector<Persistence_values>& shapes)
{
  std::vector<std::vector<double>> distances(shapes.size(), std::vector<double>(shapes.size(), 0));
  for(std::size_t i = 0; i != shapes.size(); ++i)
    for(std::size_t j = 0; j != i; ++j)
      distances[i][j] = distances[j][i] = CGAL::Reeb_graph::bottleneck_distance(shapes[i], shapes[j]);
  return distances;
}

Partners match_arcs(Mesh_graph& a, Mesh_graph& b, double price_alone)
{
  typedef boost::graph_traits<Graph>::edge_descriptor Arc;
  std::vector<std::pair<Arc, Arc>> arcs;
  const Augmentation &augmentation_a = a.surface_augmentation(), &augmentation_b = b.surface_augmentation();
  CGAL::Reeb_graph::match_arcs(augmentation_a.graph(), augmentation_a, augmentation_b.graph(), augmentation_b,
                               std::back_inserter(arcs), CGAL::parameters::price_alone(price_alone));
  Partners partners;
  for(const auto& [arc_a, arc_b] : arcs)
    partners.emplace_back(get(boost::edge_index, augmentation_a.graph(), arc_a),
                          get(boost::edge_index, augmentation_b.graph(), arc_b));
  return partners;
}

std::vector<std::size_t> find_like_tips(const std::vector<const Surface*>& surfaces)
{
  namespace internal = CGAL::Reeb_graph::internal;
  Progress_bar progress_bar("tips");
  std::vector<internal::Tips_of_mesh<Surface>> all;
  for(const Surface* surface : surfaces)
  {
    progress_bar(static_cast<double>(all.size()) / static_cast<double>(surfaces.size()));
    all.emplace_back(*surface);
  }
  // Each tip of the surface with the fewest ones has a partner on each other one.
  const auto first = std::min_element(all.begin(), all.end(),
                                      [](const auto& a, const auto& b) { return a.tips().size() < b.tips().size(); });
  struct Choice
  {
    std::vector<std::size_t> tips;
    double price = 0;
  };
  std::map<Surface::Vertex_index, Choice> choices; // by tip of that surface
  for(const auto& other : all)
    for(const auto& [tip, partner, price] : internal::match_tips(*first, other))
    {
      choices[tip].tips.push_back(&other == &*first ? tip : partner);
      choices[tip].price += price;
    }
  const auto best = std::min_element(choices.begin(), choices.end(),
                                     [](const auto& a, const auto& b) { return a.second.price < b.second.price; });
  return best == choices.end() ? std::vector<std::size_t>() : best->second.tips;
}

} // namespace reeb_graph_program
