// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of the CGAL-style package Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_CURVES_INTERNAL_CONTOUR_CHOICE_H
#define CGAL_REEB_GRAPH_CURVES_INTERNAL_CONTOUR_CHOICE_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/Augmentation.h>
#include <CGAL/Reeb_graph/curves/Curve.h>
#include <CGAL/Reeb_graph/curves/exceptions.h>
#include <CGAL/Reeb_graph/curves/internal/Contour_cutting.h>
#include <CGAL/Reeb_graph/internal/base/Index.h>
#include <CGAL/Reeb_graph/internal/base/Progress.h>
#include <CGAL/Reeb_graph/internal/base/scalars.h>
#include <CGAL/Reeb_graph/simplification/internal/persistence.h>

#include <boost/graph/graph_traits.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::Reeb_graph::internal {

// A sequence of arcs that a curve can be moved along, by their numbers in the order of edges(graph).
struct Arc_path
{
  struct Passed_arc
  {
    Index arc;
    bool is_passed_upwards;
  };
  Index first_node = 0, last_node = 0;
  std::vector<Passed_arc> arcs;
};

// The paths of the deformation retract of a Reeb graph: leaves are removed one after the other, unless they are to be
// kept; arcs that meet at a node of degree 2 are joined. A component that is a cycle then is one path from a node to
// itself.
inline std::vector<Arc_path> paths_of_retract(const std::vector<Pruned_arc>& arcs, const std::vector<bool>& is_kept)
{
  const auto number_of_nodes = static_cast<Index>(is_kept.size());
  std::vector<Index> core = core_arcs(number_of_nodes, arcs, is_kept);
  std::sort(core.begin(), core.end());
  std::vector<std::vector<Index>> arcs_of_node(number_of_nodes);
  for(const Index arc : core)
  {
    arcs_of_node[arcs[arc].lower].push_back(arc);
    arcs_of_node[arcs[arc].upper].push_back(arc);
  }
  std::vector<bool> is_followed(arcs.size(), false);
  std::vector<Arc_path> paths;
  const auto follow = [&](Index first_node, Index arc) {
    Arc_path path = {first_node, first_node, {}};
    Index& node = path.last_node;
    do
    {
      path.arcs.push_back({arc, arcs[arc].lower == node});
      is_followed[arc] = true;
      node = arcs[arc].lower == node ? arcs[arc].upper : arcs[arc].lower;
      for(const Index next : arcs_of_node[node])
        if(!is_followed[next])
          arc = next;
    } while(arcs_of_node[node].size() == 2 && node != first_node);
    paths.push_back(path);
  };
  for(const bool is_passed : {false, true}) // Those that are left for nodes that are passed are cycles.
    for(Index node = 0; node != number_of_nodes; ++node)
      for(const Index arc : arcs_of_node[node])
        if((arcs_of_node[node].size() == 2) == is_passed && !is_followed[arc])
          follow(node, arc);
  return paths;
}

// The levels at which a contour stays the same lie between two ranks; its value is in the middle of theirs.
template <class RankedMesh, class HalfedgeDescriptor>
Contour_to_cut<HalfedgeDescriptor> make_contour_to_cut(const RankedMesh& ranked,
                                                       const std::vector<HalfedgeDescriptor>& halfedges,
                                                       bool is_closed)
{
  const auto& mesh = ranked.mesh();
  const auto has_lower_source = [&](HalfedgeDescriptor a, HalfedgeDescriptor b) {
    return ranked.rank(source(a, mesh)) < ranked.rank(source(b, mesh));
  };
  const auto has_lower_target = [&](HalfedgeDescriptor a, HalfedgeDescriptor b) {
    return ranked.rank(target(a, mesh)) < ranked.rank(target(b, mesh));
  };
  const auto lower = source(*std::max_element(halfedges.begin(), halfedges.end(), has_lower_source), mesh);
  const auto upper = target(*std::min_element(halfedges.begin(), halfedges.end(), has_lower_target), mesh);
  const double value = value_at_fraction(ranked.value(lower), ranked.value(upper), 0.5);
  return {halfedges, is_closed, std::isfinite(value) ? value : ranked.value(lower), ranked.rank(lower),
          ranked.value(upper) < ranked.value(lower)};
}

// A contour, and what is known of it when it is chosen.
template <class HalfedgeDescriptor>
struct Chosen_contour : Contour_to_cut<HalfedgeDescriptor>
{
  Candidate_curve properties;
};

// Chooses contours of the Reeb graph of the ranks.
template <class RankedMesh, class CurveCost>
class Contour_choice
{
  typedef typename RankedMesh::Mesh Mesh;
  typedef typename RankedMesh::halfedge_descriptor halfedge_descriptor;
  typedef typename RankedMesh::Rank_map Rank_map;

public:
  typedef typename Reeb_graph_traits<Mesh, Rank_map>::Graph Graph;
  typedef Chosen_contour<halfedge_descriptor> Choice;

  Contour_choice(const RankedMesh& ranked,
                 const Graph& graph,
                 const CurveCost& curve_cost,
                 std::size_t number_of_candidates,
                 const Stage_progress& progress)
    : ranked_(ranked),
      graph_(graph),
      arcs_(edges(graph).first, edges(graph).second),
      curve_cost_(curve_cost),
      number_of_candidates_((std::max)(number_of_candidates, std::size_t(1))),
      augmentation_(ranked.mesh(),
                    ranked.rank_map(),
                    graph,
                    parameters::ties(Ties::CONTRACT).callback(progress.callback()))
  {}

  // The contour of least cost among those just above some vertices of the chains along the path.
  Choice operator()(const Arc_path& path) const
  {
    std::size_t number_of_places = 0;
    for(const Arc_path::Passed_arc& passed : path.arcs)
      number_of_places += chain(passed).size();
    const std::size_t number_of_candidates = (std::min)(number_of_candidates_, number_of_places);
    Choice best;
    double least_cost = 0;
    std::size_t piece = 0, first_place = 0;
    for(std::size_t i = 0; i != number_of_candidates; ++i)
    {
      const std::size_t place = (2 * i + 1) * number_of_places / (2 * number_of_candidates);
      for(; place >= first_place + chain(path.arcs[piece]).size(); ++piece)
        first_place += chain(path.arcs[piece]).size();
      Choice choice = choice_at(path.arcs[piece], place - first_place);
      choice.properties.position = (place + 0.5) / static_cast<double>(number_of_places);
      const double cost = curve_cost_(choice.properties);
      if(i != 0 && !(cost < least_cost))
        continue;
      least_cost = cost;
      best = std::move(choice);
    }
    return best;
  }

private:
  const auto& chain(const Arc_path::Passed_arc& passed) const { return graph_[arcs_[passed.arc]].chain; }

  Choice choice_at(const Arc_path::Passed_arc& passed, std::size_t place) const
  {
    const auto& halfedges = chain(passed);
    const halfedge_descriptor h = halfedges[passed.is_passed_upwards ? place : halfedges.size() - 1 - place];
    const auto contour = augmentation_.contour_at_value(arcs_[passed.arc], ranked_.rank(source(h, ranked_.mesh())));
    Choice choice = {make_contour_to_cut(ranked_, contour.halfedges, contour.is_closed), Candidate_curve()};
    choice.properties.value = choice.value;
    choice.properties.length = length(choice);
    return choice;
  }

  double length(const Contour_to_cut<halfedge_descriptor>& contour) const
  {
    const auto point = [&](halfedge_descriptor h) {
      const auto u = source(h, ranked_.mesh()), w = target(h, ranked_.mesh());
      return ranked_.point_between(u, w, ranked_.crossing_fraction(u, w, contour.value));
    };
    double sum = 0;
    auto last = point(contour.is_closed ? contour.halfedges.back() : contour.halfedges.front());
    for(const halfedge_descriptor h : contour.halfedges)
    {
      const auto next = point(h);
      sum += std::sqrt(CGAL::to_double((next - last).squared_length()));
      last = next;
    }
    return sum;
  }

  const RankedMesh& ranked_;
  const Graph& graph_;
  std::vector<typename boost::graph_traits<Graph>::edge_descriptor> arcs_;
  const CurveCost& curve_cost_;
  std::size_t number_of_candidates_;
  Augmentation<Mesh, Rank_map> augmentation_;
};

// Whether each two halfedges that follow each other are edges of one face, on the right of the first one.
template <class RankedMesh, class HalfedgeDescriptor>
bool is_connected(const RankedMesh& ranked, const std::vector<HalfedgeDescriptor>& halfedges, bool is_closed)
{
  const auto& mesh = ranked.mesh();
  const std::size_t size = halfedges.size();
  for(std::size_t i = 0; i + (is_closed ? 0 : 1) < size; ++i)
  {
    const HalfedgeDescriptor h = opposite(halfedges[i], mesh), following = halfedges[(i + 1) % size];
    if(is_border(h, mesh) || (next(h, mesh) != following && prev(h, mesh) != following))
      return false;
  }
  return is_closed || (is_border(halfedges.front(), mesh) && is_border(opposite(halfedges.back(), mesh), mesh));
}

// Checks that the halfedges of each contour ascend, follow each other, and cross a common level.
template <class RankedMesh, class ContourRange>
auto make_contours_to_cut(const RankedMesh& ranked, const ContourRange& contours)
{
  typedef typename RankedMesh::halfedge_descriptor halfedge_descriptor;
  const auto& mesh = ranked.mesh();
  std::vector<Contour_to_cut<halfedge_descriptor>> result;
  for(const auto& contour : contours)
  {
    if(contour.halfedges.empty() || !is_connected(ranked, contour.halfedges, contour.is_closed))
      throw Invalid_contour_error(result.size());
    result.push_back(make_contour_to_cut(ranked, contour.halfedges, contour.is_closed));
    for(const halfedge_descriptor h : contour.halfedges)
    {
      if(ranked.rank(target(h, mesh)) <= result.back().lower_rank)
        throw Invalid_contour_error(result.size() - 1);
    }
    result.back().value = contour.value;
  }
  return result;
}

} // namespace CGAL::Reeb_graph::internal

#endif // CGAL_REEB_GRAPH_CURVES_INTERNAL_CONTOUR_CHOICE_H
