// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_CURVES_INTERNAL_CHOOSE_CONTOURS_H
#define CGAL_REEB_GRAPH_CURVES_INTERNAL_CHOOSE_CONTOURS_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Named_function_parameters.h>
#include <CGAL/Reeb_graph/Augmentation.h>
#include <CGAL/Reeb_graph/arc_measures.h>
#include <CGAL/Reeb_graph/curves/Curve.h>
#include <CGAL/Reeb_graph/curves/internal/cut_and_mark.h>
#include <CGAL/Reeb_graph/curves/internal/simple_reeb_graph.h>
#include <CGAL/Reeb_graph/exceptions.h>
#include <CGAL/Reeb_graph/fields/make_borders_level.h>
#include <CGAL/Reeb_graph/internal/base/Index.h>
#include <CGAL/Reeb_graph/internal/base/Progress.h>
#include <CGAL/Reeb_graph/internal/base/lengths.h>
#include <CGAL/Reeb_graph/internal/graph/Leaf_pruning.h>
#include <CGAL/Reeb_graph/internal/graph/graph_loops.h>
#include <CGAL/Reeb_graph/named_parameters.h>
#include <CGAL/Reeb_graph/simplification/simplify.h>

#include <CGAL/number_utils.h>

#include <boost/graph/adjacency_list.hpp>
#include <boost/graph/graph_traits.hpp>
#include <boost/graph/kruskal_min_spanning_tree.hpp>

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <limits>
#include <set>
#include <type_traits>
#include <utility>
#include <vector>

// The choice of contours of a Reeb graph with simple saddles that become curves.

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
inline std::vector<Arc_path> paths_of_retract(const std::vector<Ascending_arc>& arcs, const std::vector<bool>& is_kept)
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

// Thresholds that a branch has to reach, each 0 if it does not count, and the measure of the caller.
template <class NamedParameters>
struct Branch_thresholds
{
  static constexpr bool has_measure =
    is_given<decltype(parameters::get_parameter(std::declval<const NamedParameters&>(), branch_measure))>;

  double persistence, area, vertex_count, measure;
  const NamedParameters& named_parameters;

  explicit Branch_thresholds(const NamedParameters& np)
    : persistence(internal::parameter_or(np, persistence_threshold, 0.)),
      area(CGAL::to_double(internal::parameter_or(np, internal_np::area_threshold, 0.))), // of any type
      vertex_count(static_cast<double>(internal::parameter_or(np, vertex_count_threshold, std::size_t(0)))),
      measure(internal::parameter_or(np, measure_threshold, 0.)),
      named_parameters(np)
  {
    static_assert(has_measure == is_given<decltype(parameters::get_parameter(np, measure_threshold))>,
                  "The named parameters branch_measure and measure_threshold of branch_curves() go together.");
    if(!(persistence >= 0))
      throw Parameter_error("the persistence threshold is negative or not a number (NaN)");
    if(!(area >= 0))
      throw Parameter_error("the area threshold is negative or not a number (NaN)");
    if(!(measure >= 0))
      throw Parameter_error("the measure threshold is negative or not a number (NaN)");
  }

  bool needs_areas() const { return area > 0 || (has_measure && measure > 0); }
  bool needs_places() const { return needs_areas() || vertex_count > 0; }

  // The size relative to the thresholds, less than 1 if one of them is not reached.
  template <class Branch>
  double relative_size(const Branch& branch, double vertex_count_of_branch) const
  {
    double size = std::numeric_limits<double>::infinity();
    if(persistence > 0)
      size = (std::min)(size, branch.persistence / persistence);
    if(area > 0)
      size = (std::min)(size, branch.weight / area);
    if(vertex_count > 0)
      size = (std::min)(size, vertex_count_of_branch / vertex_count);
    if constexpr(has_measure)
    {
      if(measure > 0)
        size = (std::min)(size, measure_of_branch(branch, named_parameters) / measure);
    }
    return size;
  }
};

// The weights of a branch.
struct Branch_weight
{
  double area = 0, vertex_count = 0;

  Branch_weight& operator+=(const Branch_weight& other)
  {
    area += other.area;
    vertex_count += other.vertex_count;
    return *this;
  }
};

// By place in the graph. The vertices that count are those of the given mesh.
template <class RankedMesh, class Thresholds>
std::vector<Branch_weight> branch_weights(const RankedMesh& ranked,
                                          const Simple_reeb_graph<RankedMesh>& simple,
                                          const Thresholds& thresholds)
{
  std::vector<Branch_weight> weights(num_vertices(simple.graph) + num_edges(simple.graph));
  if(!thresholds.needs_places())
    return weights;
  struct
  {
    const typename Simple_reeb_graph<RankedMesh>::Place_map& places;
    std::size_t index(typename RankedMesh::vertex_descriptor v) const { return get(places, v); }
  } const vertex_places = {*simple.places};
  for(const auto v : simple.given_vertices)
    ++weights[vertex_places.index(v)].vertex_count;
  if(thresholds.needs_areas())
  {
    const auto areas = areas_of_places(ranked.mesh(), simple.graph, vertex_places,
                                       parameters::vertex_point_map(ranked.vertex_point_map()));
    for(std::size_t place = 0; place != weights.size(); ++place)
      weights[place].area = areas[place];
  }
  return weights;
}

// The branches of a surface: leaf arcs that reach the thresholds, once those that do not have been removed from the
// graph as by simplify(). A leaf at a border is no branch, and an arc between two leaves has none.
template <class RankedMesh, class Thresholds>
std::vector<Arc_path> find_branches(const RankedMesh& ranked,
                                    const Simple_reeb_graph<RankedMesh>& simple,
                                    const Thresholds& thresholds)
{
  typedef typename RankedMesh::vertex_descriptor vertex_descriptor;
  const auto& graph = simple.graph;
  const auto difference = [&](Index a, Index b) {
    return persistence(ranked.value(graph[a].vertex), ranked.value(graph[b].vertex));
  };
  typedef Weighted_leaf_arc<Branch_weight> Measured_arc;
  const auto size = [&](const Measured_arc& arc) {
    if(simple.is_border[arc.leaf])
      return std::numeric_limits<double>::infinity(); // It stays.
    const Branch<vertex_descriptor> branch = {graph[arc.leaf].vertex, graph[arc.saddle].vertex, arc.is_minimum,
                                              persistence_of_leaf_arc(arc, difference), arc.weight.area};
    return thresholds.relative_size(branch, arc.weight.vertex_count);
  };
  Weighted_leaf_pruning<Branch_weight> pruned(static_cast<Index>(num_vertices(graph)), read_arcs(graph),
                                              branch_weights(ranked, simple, thresholds));
  const auto small_size = [&](const Measured_arc& arc) {
    const double relative_size = size(arc);
    return relative_size < 1 ? relative_size : std::numeric_limits<double>::quiet_NaN();
  };
  pruned(small_size, [](Index, double) { return true; });
  std::vector<Arc_path> branches;
  for(Index arc = 0; arc != pruned.number_of_arcs(); ++arc)
  {
    const auto [lower, upper] = pruned.arc(arc);
    if(!pruned.is_left(pruned.place_of_arc(arc)) || pruned.is_leaf(lower) == pruned.is_leaf(upper))
      continue;
    const Measured_arc leaf_arc = pruned.leaf_arc_of(pruned.is_leaf(lower) ? lower : upper);
    if(simple.is_border[leaf_arc.leaf] || !(size(leaf_arc) >= 1))
      continue;
    Arc_path path = {leaf_arc.saddle, leaf_arc.leaf, {}};
    pruned.for_each_piece(arc, [&](Index piece) { path.arcs.push_back({piece, !leaf_arc.is_minimum}); });
    if(leaf_arc.is_minimum)
      std::reverse(path.arcs.begin(), path.arcs.end());
    branches.push_back(std::move(path));
  }
  return branches;
}

struct Length_of_curve
{
  double operator()(const Candidate_curve& candidate) const { return candidate.length; }
};

// The cost of a place is the length of its contour. Beyond the half that is next to the saddle, a place is the worse
// the farther it is.
struct Cost_of_branch_curve
{
  double operator()(const Candidate_curve& candidate) const
  {
    const double beyond = (std::numeric_limits<double>::max)() / 2;
    return candidate.position <= 0.5 ? candidate.length : beyond * (1 + candidate.position);
  }
};

// A contour, and what is known of it when it is chosen.
template <class HalfedgeDescriptor>
struct Chosen_contour : Contour_to_cut<HalfedgeDescriptor>
{
  Candidate_curve properties;
};

// The length of a contour at its value.
template <class RankedMesh>
double length_of_contour(const RankedMesh& ranked,
                         const Contour_to_cut<typename RankedMesh::halfedge_descriptor>& contour)
{
  const auto point = [&](typename RankedMesh::halfedge_descriptor h) {
    const auto u = source(h, ranked.mesh()), w = target(h, ranked.mesh());
    return ranked.point_between(u, w, ranked.crossing_fraction(u, w, contour.value));
  };
  double sum = 0;
  auto last = point(contour.is_closed ? contour.halfedges.back() : contour.halfedges.front());
  for(const auto h : contour.halfedges)
  {
    const auto next = point(h);
    sum += distance_between(next, last);
    last = next;
  }
  return sum;
}

// The contour of least cost along each path, among those just above some vertices of its chains.
template <class DefaultCost, class RankedMesh, class NamedParameters>
auto choose_along_paths(const RankedMesh& ranked,
                        const Simple_reeb_graph<RankedMesh>& simple,
                        const std::vector<Arc_path>& paths,
                        const NamedParameters& np,
                        const Stage_progress& progress)
{
  typedef Chosen_contour<typename RankedMesh::halfedge_descriptor> Choice;
  const auto& graph = simple.graph;
  const std::vector<typename Simple_reeb_graph<RankedMesh>::Graph::edge_descriptor> arcs(edges(graph).first,
                                                                                         edges(graph).second);
  const auto cost = internal::parameter_or(np, curve_cost, DefaultCost());
  const std::size_t most =
    (std::max)(internal::parameter_or(np, number_of_candidates, std::size_t(16)), std::size_t(1));
  const Augmentation<typename RankedMesh::Mesh, typename RankedMesh::Rank_map> augmentation(
    ranked.mesh(), ranked.rank_map(), graph,
    parameters::ties(Ties::CONTRACT).callback(progress.part(0, 0.2).callback()));
  std::vector<Choice> choices;
  std::vector<std::pair<Index, typename RankedMesh::halfedge_descriptor>> places; // by arc, halfedges of its chain
  for(const Arc_path& path : paths)
  {
    progress.part(0.2, 1).report_step(choices.size(), paths.size());
    places.clear();
    for(const auto& [arc, is_passed_upwards] : path.arcs)
    {
      const auto& chain = graph[arcs[arc]].chain;
      for(std::size_t i = 0; i != chain.size(); ++i)
        places.emplace_back(arc, chain[is_passed_upwards ? i : chain.size() - 1 - i]);
    }
    const std::size_t number_of_tries = (std::min)(most, places.size());
    choices.emplace_back();
    double least_cost = 0;
    for(std::size_t i = 0; i != number_of_tries; ++i)
    {
      const std::size_t place = (2 * i + 1) * places.size() / (2 * number_of_tries);
      const auto& [arc, halfedge] = places[place];
      const auto contour = augmentation.contour_at_value(arcs[arc], ranked.rank(source(halfedge, ranked.mesh())));
      Choice choice = {make_contour_to_cut(ranked, contour.edges, contour.is_closed()), Candidate_curve()};
      choice.properties = {length_of_contour(ranked, choice), choice.value,
                           (static_cast<double>(place) + 0.5) / static_cast<double>(places.size())};
      const double cost_of_choice = cost(choice.properties);
      if(i != 0 && !(cost_of_choice < least_cost))
        continue;
      least_cost = cost_of_choice;
      choices.back() = std::move(choice);
    }
  }
  return choices;
}

// The positions of the edges that are in no maximum spanning tree of a graph with parallel edges and loops. A path has
// the ends of each edge.
inline std::vector<std::size_t> edges_outside_of_maximum_spanning_tree(const std::vector<Arc_path>& paths,
                                                                       const std::vector<double>& weights,
                                                                       std::size_t number_of_nodes)
{
  typedef boost::property<boost::edge_index_t, std::size_t, boost::property<boost::edge_weight_t, double>> Edge;
  typedef boost::adjacency_list<boost::vecS, boost::vecS, boost::undirectedS, boost::no_property, Edge> Graph;
  Graph graph(number_of_nodes);
  for(std::size_t i = 0; i != paths.size(); ++i)
    add_edge(paths[i].first_node, paths[i].last_node, Edge(i, -weights[i]), graph);
  std::vector<boost::graph_traits<Graph>::edge_descriptor> tree;
  boost::kruskal_minimum_spanning_tree(graph, std::back_inserter(tree));
  std::vector<bool> is_in_tree(paths.size(), false);
  for(const auto edge : tree)
    is_in_tree[get(boost::edge_index, graph, edge)] = true;
  std::vector<std::size_t> result;
  for(std::size_t i = 0; i != paths.size(); ++i)
  {
    if(!is_in_tree[i])
      result.push_back(i);
  }
  return result;
}

template <class RankedMesh, class NamedParameters>
auto choose_cutting_system(const RankedMesh& ranked,
                           const Simple_reeb_graph<RankedMesh>& simple,
                           const NamedParameters& np,
                           const Stage_progress& progress)
{
  const auto weight = internal::parameter_or(np, arc_weight, Length_of_curve());
  const std::size_t number_of_nodes = num_vertices(simple.graph);
  const auto paths = paths_of_retract(read_arcs(simple.graph), std::vector<bool>(number_of_nodes, false));
  auto candidates = choose_along_paths<Length_of_curve>(ranked, simple, paths, np, progress);
  std::vector<double> weights;
  for(const auto& candidate : candidates)
    weights.push_back(weight(candidate.properties));
  decltype(candidates) choices;
  for(const std::size_t i : edges_outside_of_maximum_spanning_tree(paths, weights, number_of_nodes))
    choices.push_back(std::move(candidates[i]));
  return choices;
}

template <class RankedMesh, class NamedParameters>
auto choose_pants_decomposition(const RankedMesh& ranked,
                                const Simple_reeb_graph<RankedMesh>& simple,
                                const NamedParameters& np,
                                const Stage_progress& progress)
{
  std::vector<Arc_path> paths = paths_of_retract(read_arcs(simple.graph), simple.is_border);
  const auto ends_at_border = [&](const Arc_path& path) {
    return simple.is_border[path.first_node] || simple.is_border[path.last_node];
  };
  paths.erase(std::remove_if(paths.begin(), paths.end(), ends_at_border), paths.end());
  return choose_along_paths<Length_of_curve>(ranked, simple, paths, np, progress);
}

template <class RankedMesh, class NamedParameters>
auto choose_branch_curves(const RankedMesh& ranked,
                          const Simple_reeb_graph<RankedMesh>& simple,
                          const Branch_thresholds<NamedParameters>& thresholds,
                          const NamedParameters& np,
                          const Stage_progress& progress)
{
  const auto paths = find_branches(ranked, simple, thresholds);
  return choose_along_paths<Cost_of_branch_curve>(ranked, simple, paths, np, progress);
}

// Refines a mesh so that the contours of choose(ranked mesh, its Reeb graph with simple saddles, progress) become paths
// of edges, and outputs these. The input has been checked by check_input(). Whether choose() wants the places of vertices
// is told as to compute_simple_reeb_graph().
template <class Mesh, class ScalarMap, class OutputIterator, class NamedParameters, class ArePlacesWanted, class Choose>
OutputIterator cut_along_chosen_contours(Mesh& mesh,
                                         const ScalarMap& scalar_map,
                                         OutputIterator output,
                                         const NamedParameters& np,
                                         const Stage_progress& progress,
                                         const ArePlacesWanted& are_places_wanted,
                                         const Choose& choose)
{
  typedef Chosen_traits<Reeb_graph_traits<Mesh, ScalarMap>, NamedParameters> Traits;
  static_assert(are_met<Refinable_mesh<Mesh>, Field_of_numbers<Mesh, ScalarMap, Traits>>);
  const auto traits = choose_traits<Traits>(np);
  const auto cut = [&](const auto& map, const Stage_progress& stage) {
    const auto find_contours = [&](const auto& ranked, const Stage_progress& finding) {
      const auto simple = compute_simple_reeb_graph(ranked, map, traits, are_places_wanted, finding.part(0, 0.55));
      auto choices = choose(ranked, simple, finding.part(0.55, 1));
      return std::vector<Contour_to_cut<typename boost::graph_traits<Mesh>::halfedge_descriptor>>(
        std::make_move_iterator(choices.begin()), std::make_move_iterator(choices.end()));
    };
    return cut_along_found_contours(mesh, map, traits, output, np, stage.part(0, 0.85), stage.part(0.85, 1),
                                    find_contours);
  };
  if(internal::parameter_or(np, borders, Borders::LEVEL) == Borders::LEVEL)
    return cut(scalar_map, progress);
  const auto old_vertices = CGAL::make_range(vertices(mesh));
  const std::set<typename boost::graph_traits<Mesh>::vertex_descriptor> old(old_vertices.begin(), old_vertices.end());
  const auto level_map = get(dynamic_vertex_property_t<typename Traits::Scalar>(), mesh);
  for(const auto v : old)
    put(level_map, v, get(scalar_map, v));
  make_borders_level(mesh, level_map, np.callback(progress.part(0, 0.2).callback()));
  const OutputIterator end = cut(level_map, progress.part(0.2, 1));
  if constexpr(is_field_written<ScalarMap, Traits>)
  {
    ScalarMap written = scalar_map;
    for(const auto v : vertices(mesh))
      if(old.count(v) == 0)
        put(written, v, get(level_map, v));
  }
  return end;
}

// Refines a mesh so that the curves of a pants decomposition become paths of edges, and outputs these. The input has
// been checked.
template <class Mesh, class ScalarMap, class OutputIterator, class NamedParameters>
OutputIterator cut_into_pants(Mesh& mesh,
                              const ScalarMap& scalar_map,
                              OutputIterator output,
                              const NamedParameters& np,
                              const Stage_progress& progress)
{
  return cut_along_chosen_contours(mesh, scalar_map, output, np, progress, std::false_type(),
                                   [&](const auto& ranked, const auto& simple, const Stage_progress& stage) {
                                     return choose_pants_decomposition(ranked, simple, np, stage);
                                   });
}

} // namespace CGAL::Reeb_graph::internal

#endif // CGAL_REEB_GRAPH_CURVES_INTERNAL_CHOOSE_CONTOURS_H
