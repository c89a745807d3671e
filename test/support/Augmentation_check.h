// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_TEST_AUGMENTATION_CHECK_H
#define CGAL_REEB_GRAPH_TEST_AUGMENTATION_CHECK_H

#include "complex_oracle.h"
#include "random_complexes.h"
#include "soup_augmentation_checks.h"
#include "soup_samples.h"

#include <CGAL/Reeb_graph/Complex_augmentation.h>
#include <CGAL/Reeb_graph/graph_topology.h>
#include <CGAL/Reeb_graph/simplification/persistence_pairs.h>

#include <boost/property_map/property_map.hpp>
#include <boost/test/unit_test.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <set>
#include <string>
#include <variant>
#include <vector>

namespace soup_augmentation_checks {
using CGAL::Reeb_graph::Soup_augmentation;
using CGAL::Reeb_graph::Tetrahedra_augmentation;
using CGAL::Reeb_graph::Ties;
using random_complexes::Complex;
using soup_samples::arc_descriptor;
using soup_samples::Graph;

template <class Contour>
std::string fault_of_shape(const Soup_augmentation<double>&, const Contour& contour, const Complex& complex)
{
  return fault_of_polylines(contour, different(complex.triangles));
}

template <class Contour>
std::string fault_of_shape(const Tetrahedra_augmentation<double>&, const Contour& contour, const Complex& complex)
{
  return fault_of_patch(contour, different(complex.tetrahedra));
}

// The vertices of each height.
inline std::vector<std::vector<std::size_t>> vertices_by_height(const Oracle& oracle)
{
  std::vector<std::vector<std::size_t>> result(oracle.number_of_heights());
  for(std::size_t v = 0; v < oracle.heights.size(); ++v)
    result[oracle.heights[v]].push_back(v);
  return result;
}

// The edges of the strip of an arc above a height.
inline std::vector<std::size_t> strip_of_arc(const Oracle& oracle, std::size_t height, std::size_t oracle_arc)
{
  for(std::size_t edge = 0; edge < oracle.edges.size(); ++edge)
  {
    const std::size_t strip = oracle.strip_of_edge(height, edge);
    if(strip != none && oracle.strips[strip].arc == oracle_arc)
      return oracle.strips[strip].edges;
  }
  return {};
}

// Compares all that an augmentation of a complex tells with the oracle. The complex, the values, the oracle and the
// augmentation have to outlive it.
template <class Augmentation>
class Augmentation_check
{
public:
  Augmentation_check(const Complex& c, const std::vector<double>& v, const Oracle& o, const Augmentation& a)
    : complex(c),
      values(v),
      oracle(o),
      augmentation(a),
      graph(a.graph()),
      vertices(vertices_by_height(o)),
      arcs(edges(graph).first, edges(graph).second)
  {}

  void run(Ties ties)
  {
    check_topology();
    check_locations(ties);
    for(std::size_t height = 0; height + 1 < oracle.number_of_heights(); ++height)
      check_level(height);
    for(std::size_t i = 0; i < arcs.size(); ++i)
      check_parameters(i);
    for(std::size_t node = 0; node < num_vertices(graph); ++node)
      check_critical_set(node);
  }

  void check_locations(Ties ties)
  {
    const auto fault = complex_oracle::fault_of_arcs(oracle, graph, ties);
    BOOST_REQUIRE(fault.first == "");
    oracle_arcs = fault.second;
    const auto places = augmentation.locate_vertices();
    for(std::size_t v = 0; v < oracle.heights.size(); ++v)
    {
      const auto& point = oracle.points[oracle.point_of_vertex[v]];
      const auto place = places[v];
      if(point.node != none)
        BOOST_TEST((place == typename Augmentation::Vertex_places::Place(point.node)));
      else
      {
        BOOST_REQUIRE(std::holds_alternative<arc_descriptor>(place));
        BOOST_TEST(oracle_arcs[places.index(v) - num_vertices(graph)] == point.arc);
        BOOST_TEST((std::get<arc_descriptor>(place) == arcs[places.index(v) - num_vertices(graph)]));
      }
    }
    check_lists(places);
  }

private:
  void check_topology() const
  {
    BOOST_TEST(CGAL::Reeb_graph::number_of_loops(graph) == oracle.number_of_loops());
    std::vector<typename Augmentation::Contour> contours;
    CGAL::Reeb_graph::loop_contours(graph, augmentation, std::back_inserter(contours));
    BOOST_TEST(contours.size() == oracle.number_of_loops());
    typedef CGAL::Reeb_graph::Persistence_pair<std::size_t> Pair;
    std::vector<Pair> pairs;
    CGAL::Reeb_graph::persistence_pairs(graph, std::back_inserter(pairs));
    const auto number_of_loops = std::count_if(pairs.begin(), pairs.end(), [](const Pair& pair) {
      return pair.kind == CGAL::Reeb_graph::Persistence_pair_kind::LOOP;
    });
    BOOST_TEST(static_cast<std::size_t>(number_of_loops) == oracle.number_of_loops());
  }

  // The contours of all arcs between a height and the next one, by each way to ask for them.
  void check_level(std::size_t height)
  {
    const std::size_t below = vertices[height].front(), above = vertices[height + 1].back();
    const bool is_value = values[below] < values[above];
    const auto all =
      is_value ? augmentation.contours_at_value(values[below]) : std::vector<typename Augmentation::Contour>();
    auto next = all.begin();
    for(std::size_t i = 0; i < arcs.size(); ++i)
    {
      const std::vector<std::size_t> expected = strip_of_arc(oracle, height, oracle_arcs[i]);
      if(expected.empty())
      {
        BOOST_CHECK_THROW(augmentation.contour_above(arcs[i], below), CGAL::Reeb_graph::Parameter_error);
        BOOST_CHECK_THROW(augmentation.contour_below(arcs[i], above), CGAL::Reeb_graph::Parameter_error);
        if(is_value)
          BOOST_CHECK_THROW(augmentation.contour_at_value(arcs[i], values[below]), CGAL::Reeb_graph::Parameter_error);
        continue;
      }
      const auto contour = augmentation.contour_above(arcs[i], below);
      check_contour(contour, i, expected);
      BOOST_TEST(edges_of(oracle, augmentation.contour_below(arcs[i], above)) == expected);
      if(is_value)
      {
        BOOST_TEST(edges_of(oracle, augmentation.contour_at_value(arcs[i], values[below])) == expected);
        BOOST_REQUIRE((next != all.end()));
        BOOST_TEST((next->arc == arcs[i]));
        BOOST_TEST(edges_of(oracle, *next++) == expected);
      }
    }
    BOOST_TEST((next == all.end()));
  }

  void check_contour(const typename Augmentation::Contour& contour,
                     std::size_t arc,
                     const std::vector<std::size_t>& expected)
  {
    BOOST_TEST((contour.arc == arcs[arc]));
    BOOST_TEST(edges_of(oracle, contour) == expected);
    const auto& chain = graph[arcs[arc]].chain;
    BOOST_TEST((std::find(chain.begin(), chain.end(), contour.edges.front()) != chain.end()));
    BOOST_TEST(fault_of_points(oracle, augmentation, contour, values) == "");
    BOOST_TEST(fault_of_shape(augmentation, contour, complex) == "");
  }

  void check_parameters(std::size_t i)
  {
    const double lower = values[graph[source(arcs[i], graph)].vertex],
                 upper = values[graph[target(arcs[i], graph)].vertex];
    const auto parametrization =
      boost::make_iterator_property_map(values.begin(), boost::typed_identity_property_map<std::size_t>());
    for(const double t : {0.01, 0.5, 0.99})
      for(const auto& contour : {augmentation.contour(arcs[i], t), augmentation.contour(arcs[i], t, parametrization)})
      {
        std::vector<std::size_t> expected;
        for(std::size_t height = 0; height + 1 < oracle.number_of_heights() && expected != edges_of(oracle, contour);
            ++height)
          expected = strip_of_arc(oracle, height, oracle_arcs[i]);
        check_contour(contour, i, expected);
        BOOST_TEST(contour.value >= lower);
        BOOST_TEST(contour.value <= upper);
      }
    for(const double t : {0., 1., -1., std::nan("")})
      BOOST_CHECK_THROW(augmentation.contour(arcs[i], t), CGAL::Reeb_graph::Parameter_error);
  }

  void check_critical_set(std::size_t node)
  {
    const auto set = augmentation.critical_set(node);
    const auto& point = oracle.points[oracle.nodes[node]];
    const auto check_contours = [&](const auto& contours, const std::vector<std::size_t>& strips) {
      std::set<std::vector<std::size_t>> found, expected;
      for(const auto& contour : contours)
        found.insert(edges_of(oracle, contour));
      for(const std::size_t strip : strips)
        expected.insert(oracle.strips[strip].edges);
      BOOST_TEST(contours.size() == strips.size());
      BOOST_TEST((found == expected));
    };
    check_contours(set.lower_contours, point.strips_below);
    check_contours(set.upper_contours, point.strips_above);
    std::vector<std::size_t> star;
    const auto add = [&](const auto& cells) {
      for(std::size_t i = 0; i < cells.size(); ++i)
        if(std::find(cells[i].begin(), cells[i].end(), graph[node].vertex) != cells[i].end())
          star.push_back(i);
    };
    add(complex.triangles);
    add(complex.tetrahedra);
    BOOST_TEST(set.star == star);
  }

  void check_lists(const typename Augmentation::Vertex_places& places)
  {
    std::size_t number_of_vertices = 0;
    for(std::size_t i = 0; i < arcs.size(); ++i)
      for(const std::size_t v : places.vertices_of_arc(i))
      {
        BOOST_TEST(places.index(v) == num_vertices(graph) + i);
        ++number_of_vertices;
      }
    for(std::size_t node = 0; node < num_vertices(graph); ++node)
      number_of_vertices += places.vertices_of_node(node).size();
    BOOST_TEST(number_of_vertices == values.size());
    BOOST_CHECK_THROW(places[values.size()], CGAL::Reeb_graph::Unknown_vertex_error);
  }

  const Complex& complex;
  const std::vector<double>& values;
  const Oracle& oracle;
  const Augmentation& augmentation;
  const Graph& graph;
  const std::vector<std::vector<std::size_t>> vertices; // by height
  const std::vector<arc_descriptor> arcs;
  std::vector<std::size_t> oracle_arcs;
};

} // namespace soup_augmentation_checks

#endif // CGAL_REEB_GRAPH_TEST_AUGMENTATION_CHECK_H
