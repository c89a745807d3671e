// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#include <boost/test/unit_test.hpp>

#include "augmentation_checks.h"
#include "mesh_builders.h"
#include "quotient_oracle.h"
#include "random_fields.h"
#include "random_meshes.h"

#include <boost/mpl/list.hpp>

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

// Contracted ties: graph and augmentation against the quotient by definition.

BOOST_AUTO_TEST_SUITE(test_contraction)

using namespace augmentation_checks;
using CGAL::Reeb_graph::Node_kind;
using mesh_builders::make_mesh;
using mesh_builders::Polyhedron;
using mesh_builders::Surface_mesh;
using quotient_oracle::Quotient;
using random_meshes::Combinatorial_mesh;
using random_meshes::Field_class;
using random_meshes::Mesh_class;
using random_meshes::Random;

typedef boost::mpl::list<Surface_mesh, Polyhedron> Meshes;

namespace {
template <class A>
Quotient make_quotient(const A& a, bool keeps_degree_two_nodes)
{
  const Oracle oracle = graph_checks::make_oracle(a.numbers, a.values, false);
  std::vector<bool> is_critical;
  for(std::size_t v = 0; v < a.values.size(); ++v)
    is_critical.push_back(oracle.is_critical(v));
  return Quotient(a.values.size(), a.numbers.template triangles<brute_force_oracle::Triangle>(), a.values, is_critical,
                  keeps_degree_two_nodes);
}

template <class A>
std::string fault_of_nodes(const A& a, const Quotient& quotient)
{
  if(num_vertices(a.graph) != quotient.nodes.size())
    return "another number of nodes";
  for(std::size_t node = 0; node < quotient.nodes.size(); ++node)
  {
    const auto& point = quotient.points[quotient.nodes[node]];
    const std::string name = "node " + std::to_string(node) + ": ";
    if(a.numbers.vertex(a.graph[node].vertex) != quotient.name_of_node(node))
      return name + "another vertex";
    if(a.graph[node].value != a.values[quotient.name_of_node(node)])
      return name + "another value";
    if(a.graph[node].kind != graph_checks::expected_kind(point.strips_below.size(), point.strips_above.size()))
      return name + "another kind";
  }
  return "";
}

std::size_t find_strip(const Quotient& quotient, const Edges& edges)
{
  for(std::size_t strip = 0; strip < quotient.strips.size(); ++strip)
    if(quotient.strips[strip].edges == edges)
      return strip;
  return none;
}

// The contours of an arc for ascending parameters are curves in the strips of one arc of the quotient, whose number is
// returned too, and ascend.
template <class A, class ContourAtParameter>
std::pair<std::string, std::size_t> fault_of_contours(const A& a,
                                                      const Quotient& quotient,
                                                      typename A::arc_descriptor arc,
                                                      const ContourAtParameter& contour_at_parameter)
{
  std::size_t quotient_arc = none;
  double lowest_value = static_cast<double>(a.values[a.lower(arc)]);
  for(const double t : parameters_of_contours())
  {
    const auto contour = contour_at_parameter(t);
    const std::string name = "at " + text(t) + ": ", fault = fault_of_curve(a, contour);
    if(!fault.empty())
      return {name + fault, none};
    const std::size_t strip = find_strip(quotient, a.edges_of(contour));
    if(strip == none)
      return {name + "the contour is not in a strip", none};
    if(quotient_arc != none && quotient.strips[strip].arc != quotient_arc)
      return {name + "the contour is in another arc", none};
    if(number_of_chain_crossings(a, contour) == 0)
      return {name + "the contour does not cross the chain", none};
    if(contour.value < lowest_value || contour.value > static_cast<double>(a.values[a.upper(arc)]))
      return {name + "the value does not ascend, or is not between those of the ends", none};
    quotient_arc = quotient.strips[strip].arc;
    lowest_value = contour.value;
  }
  return {"", quotient_arc};
}

// The arcs are those of the quotient, which are returned too, in the order of edges(graph).
template <class A>
std::pair<std::string, std::vector<std::size_t>> fault_of_arcs(const A& a, const Quotient& quotient)
{
  std::vector<std::size_t> quotient_arcs;
  Random random(a.values.size());
  const auto other_map =
    CGAL::Reeb_graph::make_scalar_map(a.mesh, random_meshes::random_integers(a.values.size(), 4, random));
  for(const auto arc : a.arcs)
  {
    const auto fault = fault_of_contours(a, quotient, arc, [&](double t) { return a.augmentation.contour(arc, t); });
    if(!fault.first.empty())
      return {"arc " + std::to_string(quotient_arcs.size()) + " " + fault.first, {}};
    const auto other_fault =
      fault_of_contours(a, quotient, arc, [&](double t) { return a.augmentation.contour(arc, t, other_map); });
    if(!other_fault.first.empty() || other_fault.second != fault.second)
      return {"arc " + std::to_string(quotient_arcs.size()) + " with another field " + other_fault.first, {}};
    const auto& quotient_arc = quotient.arcs[fault.second];
    if(quotient_arc.lower != source(arc, a.graph) || quotient_arc.upper != target(arc, a.graph))
      return {"an arc joins other nodes", {}};
    quotient_arcs.push_back(fault.second);
  }
  const std::set<std::size_t> different(quotient_arcs.begin(), quotient_arcs.end());
  const bool are_all = different.size() == a.arcs.size() && a.arcs.size() == quotient.arcs.size();
  return {are_all ? "" : "an arc is missing, or occurs twice", quotient_arcs};
}

// The chain begins in the lower node, ascends, goes on where it has been inside of its arc, and ends at the upper node.
template <class A>
std::string fault_of_chain(const A& a,
                           const Quotient& quotient,
                           typename A::arc_descriptor arc,
                           std::size_t quotient_arc)
{
  const auto& chain = a.graph[arc].chain;
  const auto upper_value = a.values[a.upper(arc)];
  const auto value_at = [&](std::size_t v) { return a.values[v]; };
  if(quotient.points[quotient.point_of_vertex[a.numbers.source_vertex(chain.front())]].node != source(arc, a.graph))
    return "a chain begins elsewhere";
  for(std::size_t i = 0; i < chain.size(); ++i)
  {
    const std::size_t from = a.numbers.source_vertex(chain[i]), to = a.numbers.target_vertex(chain[i]);
    if(value_at(to) < value_at(from) || (value_at(from) == value_at(to) && to < from))
      return "a chain does not ascend";
    const bool is_last = i + 1 == chain.size();
    const std::size_t end = is_last ? to : a.numbers.source_vertex(chain[i + 1]);
    if(is_last ? value_at(to) < upper_value : value_at(to) < value_at(end))
      return "a chain has a gap";
    if(!is_last && !(value_at(end) < upper_value))
      continue;
    if(!is_last && quotient.points[quotient.point_of_vertex[end]].arc != quotient_arc
       && quotient.points[quotient.point_of_vertex[end]].node != source(arc, a.graph))
      return "a chain leaves its arc";
  }
  return "";
}

// The vertices of nodes and arcs are those of the points, a node has all its vertices.
template <class A>
std::string fault_of_locations(const A& a, const Quotient& quotient, const std::vector<std::size_t>& quotient_arcs)
{
  const auto places = a.augmentation.locate_vertices();
  const auto parallel = a.augmentation.template locate_vertices<CGAL::Parallel_if_available_tag>();
  for(const auto v : vertices(a.mesh))
  {
    const auto& point = quotient.points[quotient.point_of_vertex[a.numbers.vertex(v)]];
    const std::size_t index = places.index(v), number_of_nodes = num_vertices(a.graph);
    const bool is_right = point.node != none
                          ? index == point.node
                          : index >= number_of_nodes && quotient_arcs[index - number_of_nodes] == point.arc;
    if(!is_right || parallel.index(v) != index)
      return "vertex " + std::to_string(a.numbers.vertex(v)) + " is at another place";
  }
  return fault_of_vertex_ranges(a, places);
}

// The contours at a value are the strips just above it.
template <class A>
std::string fault_of_level_sets(const A& a, const Quotient& quotient)
{
  std::map<typename A::Scalar, std::set<Edges>> expected;
  for(const auto value : a.values)
    expected[value];
  for(const auto& strip : quotient.strips)
    std::next(expected.begin(), static_cast<std::ptrdiff_t>(quotient.points[strip.lower].value))
      ->second.insert(strip.edges);
  for(const auto& entry : expected)
  {
    std::set<Edges> found;
    const auto contours = a.augmentation.contours_at_value(entry.first);
    for(const auto& contour : contours)
    {
      if(!fault_of_curve(a, contour).empty())
        return "a contour at a value is no curve";
      found.insert(a.edges_of(contour));
    }
    if(found != entry.second || found.size() != contours.size())
      return "the contours at a value are not those just above it";
  }
  return "";
}

// The contours next to a node are the strips next to it.
template <class A>
std::string fault_of_critical_sets(const A& a, const Quotient& quotient)
{
  for(std::size_t node = 0; node < quotient.nodes.size(); ++node)
  {
    const auto set = a.augmentation.critical_set(node);
    const auto& point = quotient.points[quotient.nodes[node]];
    for(const bool is_upper : {false, true})
    {
      const auto& contours = is_upper ? set.upper_contours : set.lower_contours;
      std::set<Edges> expected, found;
      for(const std::size_t strip : is_upper ? point.strips_above : point.strips_below)
        expected.insert(quotient.strips[strip].edges);
      for(const auto& contour : contours)
        found.insert(a.edges_of(contour));
      if(found != expected || contours.size() != expected.size())
        return "node " + std::to_string(node) + " has other contours";
    }
  }
  return "";
}

template <class Mesh, class Scalar>
std::string fault_of_contraction(const Mesh& mesh, const std::vector<Scalar>& values, bool keeps_degree_two_nodes)
{
  const Augmented_mesh<Mesh, Scalar> a(mesh, values, Ties::CONTRACT, keeps_degree_two_nodes);
  const Quotient quotient = make_quotient(a, keeps_degree_two_nodes);
  if(!quotient.is_consistent)
    return "the oracle is wrong";
  std::string fault = fault_of_nodes(a, quotient);
  if(!fault.empty())
    return fault;
  const auto fault_and_arcs = fault_of_arcs(a, quotient);
  if(!fault_and_arcs.first.empty())
    return fault_and_arcs.first;
  for(std::size_t i = 0; fault.empty() && i < a.arcs.size(); ++i)
    fault = fault_of_chain(a, quotient, a.arcs[i], fault_and_arcs.second[i]);
  if(fault.empty())
    fault = fault_of_locations(a, quotient, fault_and_arcs.second);
  if(fault.empty())
    fault = fault_of_level_sets(a, quotient);
  if(fault.empty())
    fault = fault_of_critical_sets(a, quotient);
  return fault;
}

template <class Mesh, class Scalar>
void check_contraction(const Mesh& mesh, const std::vector<Scalar>& values)
{
  for(const bool keeps_degree_two_nodes : {false, true})
    BOOST_TEST_CONTEXT("degree two nodes kept: " << keeps_degree_two_nodes)
  BOOST_TEST(fault_of_contraction(mesh, values, keeps_degree_two_nodes) == "");
}

// a field of few values more often than not
std::vector<double> field_with_ties(const Combinatorial_mesh& mesh, std::size_t seed, Random& random)
{
  if(seed % 2 == 0)
    return random_meshes::random_integers(mesh.number_of_vertices, 2 + random.below(6), random);
  const auto field_class =
    static_cast<Field_class>(random.below(static_cast<std::size_t>(Field_class::NUMBER_OF_CLASSES)));
  return random_meshes::random_field(mesh, field_class, random);
}

Combinatorial_mesh random_mesh(std::size_t seed, Random& random)
{
  const auto number_of_classes = static_cast<std::size_t>(Mesh_class::NUMBER_OF_CLASSES);
  return random_meshes::random_mesh(static_cast<Mesh_class>(seed / 2 % number_of_classes), random);
}
} // namespace

BOOST_AUTO_TEST_CASE(random_small_meshes)
{
  for(std::size_t seed = 0; seed < 1800; ++seed)
  {
    Random random(500000 + seed);
    const auto mesh = random_mesh(seed, random);
    const auto values = field_with_ties(mesh, seed, random);
    BOOST_TEST_CONTEXT("seed " << seed)
    {
      check_contraction(make_mesh<Surface_mesh>(mesh), values);
      if(seed % 10 == 0)
        check_contraction(make_mesh<Polyhedron>(mesh), values);
    }
  }
}

BOOST_AUTO_TEST_CASE(integer_scalars)
{
  for(std::size_t seed = 0; seed < 200; ++seed)
  {
    Random random(600000 + seed);
    const auto mesh = random_mesh(seed, random);
    std::vector<int> values;
    for(const double value : random_meshes::random_integers(mesh.number_of_vertices, 6, random))
      values.push_back(static_cast<int>(value) - 3);
    BOOST_TEST_CONTEXT("seed " << seed)
    check_contraction(make_mesh<Surface_mesh>(mesh), values);
  }
}

BOOST_AUTO_TEST_CASE(several_edges_between_two_vertices)
{
  for(std::size_t seed = 0; seed < 300; ++seed)
  {
    Random random(seed);
    const std::size_t number_of_splits = random.below(4);
    const auto combinatorial_mesh =
      random_meshes::random_closed_surface(static_cast<unsigned>(random.below(4)), number_of_splits, random);
    auto mesh = make_mesh<Surface_mesh>(combinatorial_mesh);
    mesh_builders::flip_edges_carelessly(mesh, 100, random);
    BOOST_TEST_CONTEXT("seed " << seed)
    check_contraction(mesh, field_with_ties(combinatorial_mesh, seed, random));
  }
}

BOOST_AUTO_TEST_CASE_TEMPLATE(a_border_in_one_level_becomes_one_node, Mesh, Meshes)
{
  const std::size_t around = 5, along = 4;
  const auto mesh = make_mesh<Mesh>(random_meshes::cylinder(around, along));
  std::vector<double> values;
  for(std::size_t v = 0; v < around * along; ++v)
    values.push_back(static_cast<double>(v / around));
  const Augmented_mesh<Mesh> a(mesh, values, Ties::CONTRACT, false);
  BOOST_TEST_REQUIRE(num_vertices(a.graph) == 2u);
  BOOST_TEST_REQUIRE(num_edges(a.graph) == 1u);
  BOOST_TEST((a.graph[0].kind == Node_kind::MINIMUM));
  BOOST_TEST((a.graph[1].kind == Node_kind::MAXIMUM));
  const auto places = a.augmentation.locate_vertices();
  for(std::size_t node : {0, 1})
  {
    BOOST_TEST(places.vertices_of_node(node).size() == around);
    const auto set = a.augmentation.critical_set(node);
    BOOST_TEST(set.border_loop.size() == around);
    for(const auto h : set.border_loop)
    {
      BOOST_TEST(is_border(h, mesh));
      BOOST_TEST(a.values[a.numbers.target_vertex(h)] == a.graph[node].value);
    }
    BOOST_TEST(set.lower_contours.size() == node);
    BOOST_TEST(set.upper_contours.size() == 1 - node);
  }
  BOOST_TEST(places.vertices_of_arc(0).size() == around * (along - 2));
}

BOOST_AUTO_TEST_CASE(a_component_of_one_value_becomes_an_isolated_node)
{
  Random random(0);
  for(const bool keeps_degree_two_nodes : {false, true})
    for(const auto& component : {random_meshes::random_closed_surface(2, 5, random), random_meshes::cylinder(4, 3),
                                 random_meshes::disk(7), random_meshes::tetrahedron(), Combinatorial_mesh{1, {}}})
    {
      const auto both = disjoint_union(component, random_meshes::seven_vertex_torus());
      std::vector<double> values(both.number_of_vertices, 3);
      std::fill_n(values.begin(), component.number_of_vertices, 2);
      const auto mesh = make_mesh<Surface_mesh>(both);
      const Augmented_mesh<Surface_mesh> a(mesh, values, Ties::CONTRACT, keeps_degree_two_nodes);
      BOOST_TEST_REQUIRE(num_vertices(a.graph) == 2u);
      BOOST_TEST(num_edges(a.graph) == 0u);
      const auto places = a.augmentation.locate_vertices();
      for(const std::size_t node : {0, 1})
      {
        BOOST_TEST((a.graph[node].kind == Node_kind::ISOLATED));
        BOOST_TEST(a.graph[node].value == 2. + static_cast<double>(node));
      }
      BOOST_TEST(places.vertices_of_node(0).size() == component.number_of_vertices);
      BOOST_TEST(places.vertices_of_node(1).size() == 7u);
    }
}

BOOST_AUTO_TEST_SUITE_END()
