// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_TEST_AUGMENTATION_CHECKS_H
#define CGAL_REEB_GRAPH_TEST_AUGMENTATION_CHECKS_H

#include "graph_checks.h"

#include <CGAL/Reeb_graph/Augmentation.h>
#include <CGAL/boost/graph/helpers.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <set>
#include <sstream>
#include <string>
#include <utility>
#include <variant>
#include <vector>

// What the tests ask of the way from a Reeb graph back to the mesh. The checks return the first fault that they find,
// the empty string if none.
namespace augmentation_checks {
using brute_force_oracle::none;
using brute_force_oracle::Oracle;
using CGAL::Reeb_graph::Ties;
using mesh_builders::Mesh_numbers;

typedef std::vector<std::size_t> Edges; // sorted

// A mesh with its graph and the way back.
template <class Mesh_, class Scalar_ = double>
struct Augmented_mesh
{
  typedef Mesh_ Mesh;
  typedef Scalar_ Scalar;
  typedef graph_checks::Scalar_map_of<Mesh, Scalar> Scalar_map;
  typedef graph_checks::Graph_of<Mesh, Scalar> Graph;
  typedef CGAL::Reeb_graph::Augmentation<Mesh, Scalar_map> Augmentation;
  typedef typename Augmentation::Contour Contour;
  typedef typename Augmentation::arc_descriptor arc_descriptor;

  Augmented_mesh(const Mesh& m, const std::vector<Scalar>& v, Ties ties, bool keeps_degree_two_nodes)
    : mesh(m),
      numbers(m),
      values(v),
      scalar_map(CGAL::Reeb_graph::make_scalar_map(m, v)),
      graph(compute(m, scalar_map, parameters(ties, keeps_degree_two_nodes))),
      arcs(edges(graph).first, edges(graph).second),
      augmentation(m, scalar_map, graph, parameters(ties, keeps_degree_two_nodes))
  {}

  std::size_t lower(arc_descriptor arc) const { return numbers.vertex(graph[source(arc, graph)].vertex); }
  std::size_t upper(arc_descriptor arc) const { return numbers.vertex(graph[target(arc, graph)].vertex); }

  Edges edges_of(const Contour& contour) const
  {
    Edges result;
    for(const auto h : contour.edges)
      result.push_back(numbers.edge(h));
    std::sort(result.begin(), result.end());
    return result;
  }

  const Mesh& mesh;
  const Mesh_numbers<Mesh> numbers;
  const std::vector<Scalar> values;
  const Scalar_map scalar_map;
  const Graph graph;
  const std::vector<arc_descriptor> arcs;
  const Augmentation augmentation;

private:
  static auto parameters(Ties ties, bool keeps_degree_two_nodes)
  {
    return CGAL::parameters::ties(ties).keep_degree_two_nodes(keeps_degree_two_nodes);
  }

  template <class NamedParameters>
  static Graph compute(const Mesh& mesh, const Scalar_map& scalar_map, const NamedParameters& np)
  {
    Graph graph;
    CGAL::compute_reeb_graph(mesh, scalar_map, graph, np);
    return graph;
  }
};

// The contours of the oracle.
class Oracle_contours
{
public:
  explicit Oracle_contours(const Oracle& o) : oracle(o)
  {
    for(const auto& arc_of_edge : o.arc_of_edge)
    {
      edges_.emplace_back();
      for(std::size_t edge = 0; edge < arc_of_edge.size(); ++edge)
        if(arc_of_edge[edge] != none)
          edges_.back()[arc_of_edge[edge]].push_back(edge);
    }
  }

  const std::map<std::size_t, Edges>& at_level(std::size_t level) const { return edges_[level]; }

  // The first level from `first` on and below `last` at which these are the edges of the arc, and between whose
  // vertices the value lies; none if there is none.
  template <class Scalar>
  std::size_t find_level(const Edges& edges,
                         std::size_t arc,
                         double value,
                         std::size_t first,
                         std::size_t last,
                         const std::vector<Scalar>& values) const
  {
    for(std::size_t level = first; level < last; ++level)
    {
      const auto found = edges_[level].find(arc);
      if(found != edges_[level].end() && found->second == edges
         && static_cast<double>(values[oracle.order[level]]) <= value
         && value <= static_cast<double>(values[oracle.order[level + 1]]))
        return level;
    }
    return none;
  }

  const Oracle& oracle;

private:
  std::vector<std::map<std::size_t, Edges>> edges_; // by level and arc
};

// The halfedges follow each other through the triangles, with their targets on the left, once around or from border to
// border.
template <class A>
std::string fault_of_curve(const A& a, const typename A::Contour& contour)
{
  const auto& halfedges = contour.edges;
  if(halfedges.empty())
    return "the contour is empty";
  const Edges edges = a.edges_of(contour);
  if(std::adjacent_find(edges.begin(), edges.end()) != edges.end())
    return "the contour crosses an edge twice";
  const auto leads_to = [&](auto h, auto next) {
    const auto right = opposite(h, a.mesh);
    return !is_border(right, a.mesh) && face(right, a.mesh) == face(next, a.mesh);
  };
  for(std::size_t i = 0; i + 1 < halfedges.size(); ++i)
    if(!leads_to(halfedges[i], halfedges[i + 1]))
      return "the contour has a gap, or the higher side on the right";
  if(contour.is_closed())
    return leads_to(halfedges.back(), halfedges.front()) ? "" : "the contour is not closed";
  const bool is_between_borders =
    is_border(halfedges.front(), a.mesh) && is_border(opposite(halfedges.back(), a.mesh), a.mesh);
  return is_between_borders ? "" : "the contour ends inside of the surface";
}

// The arcs of the oracle by those of the graph, in the order of edges(graph), ties not contracted.
template <class A>
std::vector<std::size_t> arcs_of_oracle(const A& a, const Oracle& oracle)
{
  std::vector<std::size_t> result;
  for(const auto arc : a.arcs)
    result.push_back(oracle.arc_of_edge[oracle.rank[a.lower(arc)]][a.numbers.edge(a.graph[arc].chain.front())]);
  return result;
}

template <class A>
std::size_t number_of_chain_crossings(const A& a, const typename A::Contour& contour)
{
  const Edges edges = a.edges_of(contour);
  const auto& chain = a.graph[contour.arc].chain;
  return static_cast<std::size_t>(std::count_if(chain.begin(), chain.end(), [&](auto h) {
    return std::binary_search(edges.begin(), edges.end(), a.numbers.edge(h));
  }));
}

inline std::string text(double number)
{
  std::ostringstream out;
  out.precision(17);
  out << number;
  return out.str();
}

inline const std::vector<double>& parameters_of_contours()
{
  static const std::vector<double> parameters = {1e-300, 1e-9, 0.1, 0.25, 0.5, 0.75, 0.9, 1 - 1e-9, 1 - 1e-16};
  return parameters;
}

// The contours of an arc for ascending parameters: curves of that arc at levels that ascend, each crossing the chain
// once.
template <class A, class ContourAtParameter>
std::string fault_of_contours(const A& a,
                              const Oracle_contours& contours,
                              typename A::arc_descriptor arc,
                              std::size_t oracle_arc,
                              const ContourAtParameter& contour_at_parameter)
{
  const std::size_t first_level = contours.oracle.rank[a.lower(arc)], last_level = contours.oracle.rank[a.upper(arc)];
  std::size_t lowest_level = first_level;
  for(const double t : parameters_of_contours())
  {
    const std::string name = "at " + text(t) + ": ";
    const auto contour = contour_at_parameter(t);
    const std::string fault = fault_of_curve(a, contour);
    if(!fault.empty())
      return name + fault;
    if(contour.arc != arc)
      return name + "the contour names another arc";
    const Edges edges = a.edges_of(contour);
    const auto find_level = [&](std::size_t from) {
      return contours.find_level(edges, oracle_arc, contour.value, from, last_level, a.values);
    };
    if(find_level(first_level) == none)
      return name + "the contour is not one of its arc, or has a wrong value";
    lowest_level = find_level(lowest_level);
    if(lowest_level == none)
      return name + "the contour is lower than that of a smaller parameter";
    if(number_of_chain_crossings(a, contour) != 1)
      return name + "the contour does not cross the chain once";
  }
  return "";
}

// The contours by parameters, with the values along the arc and with `other_values`, one for each vertex.
template <class A>
std::string fault_of_contours(const A& a, const Oracle_contours& contours, const std::vector<double>& other_values)
{
  const auto arcs = arcs_of_oracle(a, contours.oracle);
  const auto other_map = CGAL::Reeb_graph::make_scalar_map(a.mesh, other_values);
  for(std::size_t i = 0; i < a.arcs.size(); ++i)
  {
    const auto arc = a.arcs[i];
    std::string fault =
      fault_of_contours(a, contours, arc, arcs[i], [&](double t) { return a.augmentation.contour(arc, t); });
    if(!fault.empty())
      return "arc " + std::to_string(i) + " " + fault;
    fault =
      fault_of_contours(a, contours, arc, arcs[i], [&](double t) { return a.augmentation.contour(arc, t, other_map); });
    if(!fault.empty())
      return "arc " + std::to_string(i) + " with another field " + fault;
  }
  return "";
}

template <class Contours>
bool are_same_contours(const Contours& a, const Contours& b)
{
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](const auto& c, const auto& d) {
    return c.arc == d.arc && c.value == d.value && c.is_closed() == d.is_closed() && c.edges == d.edges;
  });
}

// The values of the field, and values below, above and between them.
template <class Scalar>
std::vector<Scalar> values_to_try(const std::vector<Scalar>& values)
{
  const std::set<Scalar> sorted(values.begin(), values.end());
  std::vector<Scalar> result(sorted.begin(), sorted.end());
  const std::size_t size = result.size();
  for(std::size_t i = 0; i + 1 < size; ++i)
    result.push_back(result[i] / 2 + result[i + 1] / 2);
  if(size > 0)
    result.insert(result.end(), {result[0] - 1, result[size - 1] + 1});
  result.erase(std::remove_if(result.begin(), result.end(), [](Scalar value) { return value != value; }), result.end());
  return result;
}

// One contour for each arc that is alive at the value, and no other one.
template <class A>
std::string fault_of_contour_at_value(const A& a,
                                      typename A::Scalar value,
                                      const std::vector<typename A::Contour>& contours)
{
  auto contour = contours.begin();
  for(const auto arc : a.arcs)
  {
    const bool is_alive = contour != contours.end() && contour->arc == arc;
    try
    {
      const auto single = a.augmentation.contour_at_value(arc, value);
      if(!is_alive || single.edges != contour->edges || single.value != contour->value)
        return "the contour of an arc at a value is not the one among those of all arcs";
    }
    catch(const CGAL::Reeb_graph::Parameter_error&)
    {
      if(is_alive)
        return "a contour of an arc at a value is refused";
    }
    contour += is_alive ? 1 : 0;
  }
  return contour == contours.end() ? "" : "the contours at a value are not sorted by their arcs";
}

// The contours at a value are the components of the level set.
template <class A>
std::string fault_of_level_sets(const A& a, const Oracle_contours& oracle_contours)
{
  const auto arcs = arcs_of_oracle(a, oracle_contours.oracle);
  std::map<typename A::arc_descriptor, std::size_t> oracle_arcs;
  for(std::size_t i = 0; i < arcs.size(); ++i)
    oracle_arcs.emplace(a.arcs[i], arcs[i]);
  for(const auto value : values_to_try(a.values))
  {
    const std::string name = "value " + text(static_cast<double>(value)) + ": ";
    const auto contours = a.augmentation.contours_at_value(value);
    const std::size_t below = static_cast<std::size_t>(
      std::count_if(a.values.begin(), a.values.end(), [&](auto other) { return !(value < other); }));
    std::map<std::size_t, Edges> found;
    for(const auto& contour : contours)
    {
      const std::string fault = fault_of_curve(a, contour);
      if(!fault.empty() || contour.value != static_cast<double>(value))
        return name + fault + " (or a wrong value)";
      found.emplace(oracle_arcs.at(contour.arc), a.edges_of(contour));
    }
    if(found.size() != contours.size())
      return name + "two contours have the same arc";
    if(found != (below == 0 ? std::map<std::size_t, Edges>() : oracle_contours.at_level(below - 1)))
      return name + "the contours are not the components of the level set";
    if(!are_same_contours(contours, a.augmentation.template contours_at_value<CGAL::Parallel_if_available_tag>(value)))
      return name + "parallel and sequential contours differ";
    const std::string fault = fault_of_contour_at_value(a, value, contours);
    if(!fault.empty())
      return name + fault;
  }
  return "";
}

// Each vertex is among the vertices of its place, and these ascend.
template <class A, class Places>
std::string fault_of_vertex_ranges(const A& a, const Places& vertex_places)
{
  std::size_t size = 0;
  for(std::size_t place = 0; place < num_vertices(a.graph) + a.arcs.size(); ++place)
  {
    const bool is_node = place < num_vertices(a.graph);
    const auto range =
      is_node ? vertex_places.vertices_of_node(place) : vertex_places.vertices_of_arc(place - num_vertices(a.graph));
    std::vector<std::pair<typename A::Scalar, std::size_t>> keys;
    for(const auto v : range)
    {
      keys.emplace_back(a.values[a.numbers.vertex(v)], a.numbers.vertex(v));
      const auto vertex_place = get(vertex_places, v);
      typedef typename Places::Place Place;
      const bool is_right = is_node ? vertex_place == Place(typename Places::node_descriptor(place))
                                    : vertex_place == Place(a.arcs[place - num_vertices(a.graph)]);
      if(vertex_places.index(v) != place || !is_right)
        return "a vertex is among those of another place";
    }
    if(!std::is_sorted(keys.begin(), keys.end()))
      return "the vertices of a place do not ascend";
    size += keys.size();
  }
  return size == a.values.size() ? "" : "not all vertices have a place, or some have two";
}

// The places of the vertices are those of the oracle.
template <class A>
std::string fault_of_locations(const A& a, const Oracle& oracle)
{
  const auto arcs = arcs_of_oracle(a, oracle);
  const auto vertex_places = a.augmentation.locate_vertices();
  const auto parallel = a.augmentation.template locate_vertices<CGAL::Parallel_if_available_tag>();
  typedef typename A::Augmentation::node_descriptor node_descriptor;
  for(const auto v : vertices(a.mesh))
  {
    const std::size_t number = a.numbers.vertex(v), index = vertex_places.index(v);
    const auto vertex_place = vertex_places[v];
    const std::string name = "vertex " + std::to_string(number);
    if(oracle.is_node(number) != std::holds_alternative<node_descriptor>(vertex_place))
      return name + " is at an arc instead of a node, or the other way round";
    if(oracle.is_node(number) ? a.graph[std::get<node_descriptor>(vertex_place)].vertex != v
                              : arcs[index - num_vertices(a.graph)] != oracle.arc_of_vertex[number])
      return name + " is at another place";
    if(parallel.index(v) != index)
      return name + " has another place in parallel";
  }
  return fault_of_vertex_ranges(a, vertex_places);
}

// The faces are those at v, each counterclockwise of the one before.
template <class A, class Vertex, class Faces>
std::string fault_of_star(const A& a, Vertex v, const Faces& star)
{
  std::size_t degree = 0;
  for(const auto f : faces(a.mesh))
    for(const auto h : halfedges_around_face(halfedge(f, a.mesh), a.mesh))
      degree += target(h, a.mesh) == v ? 1 : 0;
  if(star.size() != degree || std::set<typename Faces::value_type>(star.begin(), star.end()).size() != degree)
    return "the star has other faces";
  for(std::size_t i = 0; i < star.size(); ++i)
  {
    auto h = halfedge(star[i], a.mesh);
    for(int turn = 0; turn < 3 && target(h, a.mesh) != v; ++turn)
      h = next(h, a.mesh);
    if(target(h, a.mesh) != v)
      return "the star has a face elsewhere";
    if(i + 1 < star.size() && face(opposite(h, a.mesh), a.mesh) != star[i + 1])
      return "the star is not counterclockwise";
  }
  return "";
}

// The loop is that of the border at v, if all of it has one value.
template <class A, class Vertex, class Halfedges>
std::string fault_of_border_loop(const A& a, Vertex v, const Halfedges& loop)
{
  const std::string name = "the border loop is wrong: ";
  for(std::size_t i = 0; i < loop.size(); ++i)
    if(!is_border(loop[i], a.mesh) || next(loop[i], a.mesh) != loop[(i + 1) % loop.size()])
      return name + "not a loop";
  for(const auto first : halfedges(a.mesh))
  {
    if(!is_border(first, a.mesh) || target(first, a.mesh) != v)
      continue;
    std::size_t size = 0;
    bool is_level = true;
    auto h = first;
    do
    {
      is_level = is_level && a.values[a.numbers.target_vertex(h)] == a.values[a.numbers.vertex(v)];
      h = next(h, a.mesh);
      ++size;
    } while(h != first);
    if(loop.size() != (is_level ? size : 0))
      return name + std::to_string(loop.size()) + " instead of " + std::to_string(is_level ? size : 0);
    if(is_level && std::find(loop.begin(), loop.end(), first) == loop.end())
      return name + "another loop";
    return "";
  }
  return loop.empty() ? "" : name + "inside of the surface";
}

// What a node stands for: for each arc there, its contour next to the node, which touches it; star and border loop.
template <class A>
std::string fault_of_critical_sets(const A& a, const Oracle_contours& oracle_contours)
{
  const auto arcs = arcs_of_oracle(a, oracle_contours.oracle);
  for(std::size_t node = 0; node < num_vertices(a.graph); ++node)
  {
    const std::string name = "node " + std::to_string(node) + ": ";
    const auto v = a.graph[node].vertex;
    const std::size_t rank = oracle_contours.oracle.rank[a.numbers.vertex(v)];
    const auto set = a.augmentation.critical_set(node);
    if(set.lower_contours.size() != in_degree(node, a.graph) || set.upper_contours.size() != out_degree(node, a.graph))
      return name + "another number of contours";
    std::set<typename A::arc_descriptor> seen_arcs;
    for(const bool is_upper : {false, true})
      for(const auto& contour : is_upper ? set.upper_contours : set.lower_contours)
      {
        if((is_upper ? source(contour.arc, a.graph) : target(contour.arc, a.graph)) != node
           || !seen_arcs.insert(contour.arc).second)
          return name + "a contour of another arc";
        const std::size_t i =
          static_cast<std::size_t>(std::find(a.arcs.begin(), a.arcs.end(), contour.arc) - a.arcs.begin());
        if(oracle_contours.at_level(is_upper ? rank : rank - 1).at(arcs[i]) != a.edges_of(contour)
           || !fault_of_curve(a, contour).empty())
          return name + "another contour";
        if(std::none_of(contour.edges.begin(), contour.edges.end(),
                        [&](auto h) { return (is_upper ? source(h, a.mesh) : target(h, a.mesh)) == v; }))
          return name + "a contour does not touch it";
      }
    std::string fault = fault_of_star(a, v, set.star);
    if(fault.empty())
      fault = fault_of_border_loop(a, v, set.border_loop);
    if(!fault.empty())
      return name + fault;
  }
  return "";
}

} // namespace augmentation_checks

#endif // CGAL_REEB_GRAPH_TEST_AUGMENTATION_CHECKS_H
