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
#include <CGAL/Reeb_graph/internal/base/Progress.h>
#include <CGAL/Reeb_graph/internal/base/scalars.h>

#include <boost/graph/graph_traits.hpp>
#include <boost/range/iterator_range.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL::Reeb_graph::internal {

// A sequence of arcs that a curve can be moved along.
template <class ArcDescriptor>
struct Arc_path
{
  struct Passed_arc
  {
    ArcDescriptor arc;
    bool is_passed_upwards;
  };

  std::size_t first_node = 0, last_node = 0;
  std::vector<Passed_arc> arcs;
};

// The deformation retract of a Reeb graph: leaves are removed one after the other, unless they are to be kept; arcs
// that meet at a node of degree 2 are joined. A component that is a cycle then is one path from a node to itself.
template <class ReebGraph>
class Graph_retract
{
  typedef typename boost::graph_traits<ReebGraph>::edge_descriptor arc_descriptor;
  static constexpr std::size_t none = (std::numeric_limits<std::size_t>::max)();

public:
  typedef Arc_path<arc_descriptor> Path;

  // A leaf stays if `is_kept` is true for its node.
  Graph_retract(const ReebGraph& graph, const std::vector<bool>& is_kept)
    : graph_(graph),
      arcs_(edges(graph).first, edges(graph).second),
      is_left_(arcs_.size(), true)
  {
    list_arcs_of_nodes();
    remove_leaves(is_kept);
    for(std::size_t node = 0; node != degrees_.size(); ++node)
    {
      if(degrees_[node] != 0 && degrees_[node] != 2)
        add_paths(node);
    }
    for(std::size_t node = 0; node != degrees_.size(); ++node)
    {
      if(degrees_[node] == 2)
        add_paths(node);
    }
  }

  const std::vector<Path>& paths() const { return paths_; }

private:
  std::size_t lower(std::size_t arc) const { return source(arcs_[arc], graph_); }
  std::size_t upper(std::size_t arc) const { return target(arcs_[arc], graph_); }
  std::size_t other_end(std::size_t arc, std::size_t node) const
  {
    return lower(arc) == node ? upper(arc) : lower(arc);
  }

  void list_arcs_of_nodes()
  {
    arcs_of_node_.resize(num_vertices(graph_));
    for(std::size_t arc = 0; arc != arcs_.size(); ++arc)
    {
      arcs_of_node_[lower(arc)].push_back(arc);
      arcs_of_node_[upper(arc)].push_back(arc);
    }
    for(const auto& arcs : arcs_of_node_)
      degrees_.push_back(arcs.size());
  }

  std::size_t any_arc_left(std::size_t node) const
  {
    const auto& arcs = arcs_of_node_[node];
    const auto found = std::find_if(arcs.begin(), arcs.end(), [&](std::size_t arc) { return is_left_[arc]; });
    return found == arcs.end() ? none : *found;
  }

  void remove_leaves(const std::vector<bool>& is_kept)
  {
    for(std::size_t leaf = 0; leaf != degrees_.size(); ++leaf)
    {
      std::size_t node = leaf;
      while(degrees_[node] == 1 && !is_kept[node])
      {
        const std::size_t arc = any_arc_left(node);
        is_left_[arc] = false;
        --degrees_[node];
        node = other_end(arc, node);
        --degrees_[node];
      }
    }
  }

  // Adds all paths that leave the node and have not been followed from their other end.
  void add_paths(std::size_t node)
  {
    for(const std::size_t arc : arcs_of_node_[node])
    {
      if(is_left_[arc])
        follow_path(node, arc);
    }
  }

  void follow_path(std::size_t first_node, std::size_t arc)
  {
    Path path;
    std::size_t node = first_node;
    do
    {
      path.arcs.push_back({arcs_[arc], lower(arc) == node});
      is_left_[arc] = false;
      node = other_end(arc, node);
      arc = any_arc_left(node);
    } while(degrees_[node] == 2 && node != first_node);
    path.first_node = first_node;
    path.last_node = node;
    paths_.push_back(path);
  }

  const ReebGraph& graph_;
  std::vector<arc_descriptor> arcs_;
  std::vector<bool> is_left_;
  std::vector<std::vector<std::size_t>> arcs_of_node_;
  std::vector<std::size_t> degrees_;
  std::vector<Path> paths_;
};

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

// Chooses contours of the Reeb graph of the ranks.
template <class RankedMesh, class CurveCost>
class Contour_choice
{
  typedef typename RankedMesh::Mesh Mesh;
  typedef typename RankedMesh::halfedge_descriptor halfedge_descriptor;
  typedef typename RankedMesh::Rank_map Rank_map;

public:
  typedef typename Reeb_graph_traits<Mesh, Rank_map>::Graph Graph;
  typedef typename boost::graph_traits<Graph>::edge_descriptor arc_descriptor;
  typedef Arc_path<arc_descriptor> Path;
  typedef typename Path::Passed_arc Passed_arc;

  struct Choice
  {
    Contour_to_cut<halfedge_descriptor> contour;
    Candidate_curve properties;
  };

  Contour_choice(const RankedMesh& ranked,
                 const Graph& graph,
                 const CurveCost& curve_cost,
                 std::size_t number_of_candidates,
                 const Stage_progress& progress)
    : ranked_(ranked),
      graph_(graph),
      curve_cost_(curve_cost),
      number_of_candidates_((std::max)(number_of_candidates, std::size_t(1))),
      augmentation_(ranked.mesh(),
                    ranked.rank_map(),
                    graph,
                    parameters::ties(Ties::CONTRACT).callback(progress.callback()))
  {}

  // The contour of least cost among those just above some vertices of the chains along the path.
  Choice operator()(const Path& path) const
  {
    std::size_t number_of_places = 0;
    for(const Passed_arc& passed : path.arcs)
      number_of_places += graph_[passed.arc].chain.size();
    const std::size_t number_of_candidates = (std::min)(number_of_candidates_, number_of_places);
    Choice best;
    double least_cost = 0;
    std::size_t piece = 0, first_place = 0;
    for(std::size_t i = 0; i != number_of_candidates; ++i)
    {
      const std::size_t place = (2 * i + 1) * number_of_places / (2 * number_of_candidates);
      for(; place >= first_place + chain(path, piece).size(); ++piece)
        first_place += chain(path, piece).size();
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
  const auto& chain(const Path& path, std::size_t piece) const { return graph_[path.arcs[piece].arc].chain; }

  Choice choice_at(const Passed_arc& passed, std::size_t place) const
  {
    const auto& halfedges = graph_[passed.arc].chain;
    const halfedge_descriptor h = halfedges[passed.is_passed_upwards ? place : halfedges.size() - 1 - place];
    const auto contour = augmentation_.contour_at_value(passed.arc, ranked_.rank(source(h, ranked_.mesh())));
    Choice choice = {make_contour_to_cut(ranked_, contour.halfedges, contour.is_closed), Candidate_curve()};
    choice.properties.value = choice.contour.value;
    choice.properties.length = length(choice.contour);
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
