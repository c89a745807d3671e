// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#include <boost/test/unit_test.hpp>

#include "Augmentation_check.h"
#include "complex_oracle.h"
#include "generated_complexes.h"
#include "random_complexes.h"
#include "random_meshes.h"

#include <CGAL/Reeb_graph/Complex_augmentation.h>
#include <CGAL/Reeb_graph/simplification/simplify.h>
#include <CGAL/compute_reeb_graph_of_soup.h>

#include <boost/property_map/property_map.hpp>

#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <limits>
#include <memory>
#include <string>
#include <type_traits>
#include <vector>

// From the graph of any complex back to it: contours, critical sets and vertex_places against the oracle.

BOOST_AUTO_TEST_SUITE(test_soup_augmentation)

using namespace soup_augmentation_checks;
using random_complexes::Complex_class;
using random_meshes::Random;

namespace {
struct Falling_traits : CGAL::Reeb_graph_soup_traits<int>
{
  typedef std::greater<int> Less_scalar;
  Less_scalar less_scalar_object() const { return Less_scalar(); }
};

void check_complex(const Complex& complex, const std::vector<double>& values, Ties ties, bool keeps_degree_two_nodes)
{
  namespace parameters = CGAL::parameters;
  const auto np = parameters::ties(ties).keep_degree_two_nodes(keeps_degree_two_nodes).edges(complex.edges);
  const Oracle oracle(complex.number_of_vertices, complex.simplices(), values, ties, keeps_degree_two_nodes);
  Graph graph;
  if(complex.tetrahedra.empty())
  {
    std::vector<std::size_t> places(values.size());
    CGAL::compute_reeb_graph_of_soup(complex.number_of_vertices, complex.triangles, values, graph,
                                     np.vertex_place_map(places.data()));
    const Soup_augmentation augmentation(complex.number_of_vertices, complex.triangles, values, graph, np);
    Augmentation_check(complex, values, oracle, augmentation).run(ties);
    const auto vertex_places = augmentation.locate_vertices();
    for(std::size_t v = 0; v != places.size(); ++v)
      BOOST_TEST(places[v] == vertex_places.index(v));
  }
  else
  {
    std::vector<std::size_t> places(values.size());
    CGAL::compute_reeb_graph_of_tetrahedra(complex.number_of_vertices, complex.tetrahedra, values, graph,
                                           np.vertex_place_map(places.data()));
    const Tetrahedra_augmentation augmentation(complex.number_of_vertices, complex.tetrahedra, values, graph, np);
    Augmentation_check(complex, values, oracle, augmentation).run(ties);
    const auto vertex_places = augmentation.locate_vertices();
    for(std::size_t v = 0; v != places.size(); ++v)
      BOOST_TEST(places[v] == vertex_places.index(v));
  }
}
} // namespace

BOOST_AUTO_TEST_CASE(the_way_back_to_random_complexes_is_that_of_the_oracle)
{
  constexpr std::size_t number_of_classes = static_cast<std::size_t>(Complex_class::NUMBER_OF_CLASSES);
  for(std::size_t seed = 0; seed < 2000; ++seed)
    BOOST_TEST_CONTEXT("seed " << seed)
    {
      Random random(seed);
      const Complex complex =
        random_complexes::random_complex(static_cast<Complex_class>(seed % number_of_classes), random);
      const std::vector<double> values = random_complexes::random_values(complex.number_of_vertices, random);
      const bool keeps_degree_two_nodes = random.below(2) == 0;
      check_complex(complex, values, random.below(2) == 0 ? Ties::PERTURB : Ties::CONTRACT, keeps_degree_two_nodes);
    }
}

BOOST_AUTO_TEST_CASE(graphs_and_arguments_that_do_not_fit)
{
  using namespace CGAL::Reeb_graph;
  namespace parameters = CGAL::parameters;
  const Complex complex = random_complexes::sphere_with_wall();
  const std::vector<double> values = {0, 1, 2, 3, 4};
  Graph graph, other_graph;
  CGAL::compute_reeb_graph_of_soup(5, complex.triangles, values, graph);
  const auto augment = [&](std::size_t size, const auto& triangles, const std::vector<double>& scalars, const Graph& of,
                           const auto& np) {
    const Soup_augmentation augmentation(size, triangles, scalars, of, np);
    return augmentation.locate_vertices();
  };
  const auto np = parameters::default_values();
  augment(5, complex.triangles, values, graph, np);

  // another number of vertices, other values, another soup
  BOOST_CHECK_THROW(augment(6, complex.triangles, values, graph, np), Scalar_count_error);
  BOOST_CHECK_THROW(augment(5, complex.triangles, {0, 1, 2, 3, 5}, graph, np), Graph_mismatch_error);
  BOOST_CHECK_THROW(augment(5, random_complexes::book(2, 3).triangles, values, graph, np), Graph_mismatch_error);
  BOOST_CHECK_THROW(augment(5, complex.triangles, values, Graph(), np), Graph_mismatch_error);
  BOOST_CHECK_THROW(augment(5, complex.triangles, {0, 1, 2, std::nan(""), 4}, graph, np), Unordered_scalar_error);
  BOOST_CHECK_THROW(augment(5, std::vector<std::vector<int>>{{0, 1, 2, 3}}, values, graph, np),
                    Non_triangular_face_error);
  BOOST_CHECK_THROW(augment(5, std::vector<std::vector<int>>{{0, 1, 5}}, values, graph, np), Vertex_out_of_range_error);
  BOOST_CHECK_THROW(augment(5, std::vector<std::vector<int>>{{0, 1, -1}}, values, graph, np),
                    Vertex_out_of_range_error);
  BOOST_CHECK_THROW(augment(5, std::vector<std::vector<int>>{{0, 1, 0}}, values, graph, np), Degenerate_face_error);
  BOOST_CHECK_THROW(Tetrahedra_augmentation(5, complex.triangles, values, graph), Non_tetrahedral_cell_error);
  for(const std::vector<int>& edge : {std::vector<int>{2}, std::vector<int>{0, 1, 2}, std::vector<int>{2, 2}})
  {
    const std::vector<std::vector<int>> edges = {{0, 1}, edge};
    BOOST_CHECK_EXCEPTION(augment(5, complex.triangles, values, graph, parameters::edges(edges)), Degenerate_edge_error,
                          [](const auto& error) {
                            return error.edge() == 1
                                && std::string(error.what()).find("edge 1 has not two different vertices")
                                     != std::string::npos;
                          });
  }

  // the ties of another graph
  const std::vector<double> tied_values = {1, 1, 1, 1, 1};
  CGAL::compute_reeb_graph_of_soup(5, complex.triangles, tied_values, other_graph);
  BOOST_CHECK_THROW(augment(5, complex.triangles, tied_values, other_graph, parameters::ties(Ties::CONTRACT)),
                    Graph_mismatch_error);

  // a chain of another soup, and the end of one that is no vertex
  Graph broken = graph;
  const Soup_augmentation augmentation(5, complex.triangles, values, graph),
    of_broken(5, complex.triangles, values, broken);
  const arc_descriptor arc = *edges(graph).first, broken_arc = *edges(broken).first;
  for(const Edge& edge : {Edge(0, 4), Edge(0, 9), Edge(9, 4)})
  {
    broken[broken_arc].chain = {std::make_shared<const std::vector<Edge>>(1, edge), 0, 1};
    BOOST_CHECK_THROW(of_broken.contour(broken_arc, 0.5), Graph_mismatch_error);
  }

  // what the graph and the soup do not have
  BOOST_CHECK_THROW(augmentation.contour(broken_arc, 0.5), Graph_mismatch_error);
  BOOST_CHECK_THROW(augmentation.contour_above(arc, 5), Unknown_vertex_error);
  BOOST_CHECK_THROW(augmentation.contour_below(arc, std::size_t(1) << 32), Unknown_vertex_error);
  BOOST_CHECK_THROW(augmentation.value(5), Unknown_vertex_error);
  BOOST_CHECK_THROW(augmentation.critical_set(num_vertices(graph)), Graph_mismatch_error);
  BOOST_CHECK_THROW(augmentation.contour_at_value(arc, -1), Parameter_error);
  BOOST_CHECK_THROW(augmentation.contour_at_value(arc, 4), Parameter_error);
  const std::vector<double> infinite(5, std::numeric_limits<double>::infinity());
  BOOST_CHECK_THROW(
    augmentation.contour(
      arc, 0.5, boost::make_iterator_property_map(infinite.begin(), boost::typed_identity_property_map<std::size_t>())),
    Non_finite_scalar_error);
  static_assert(!std::is_constructible_v<Soup_augmentation<double>, int, std::vector<std::array<int, 3>>,
                                         std::vector<double>, Graph&&>,
                "The graph is not copied.");
}

// The graph of the user's order, upside down, has the same contours.
BOOST_AUTO_TEST_CASE(the_order_of_the_traits_class)
{
  for(std::size_t seed = 0; seed < 100; ++seed)
    BOOST_TEST_CONTEXT("seed " << seed)
    {
      Random random(seed);
      const Complex complex =
        random_complexes::random_complex(seed % 2 == 0 ? Complex_class::BOOK : Complex_class::WALLED, random);
      const auto permutation = random_meshes::random_permutation(complex.number_of_vertices, random);
      std::vector<int> values, negative_values;
      for(const double value : permutation)
      {
        values.push_back(static_cast<int>(value));
        negative_values.push_back(-values.back());
      }
      typedef CGAL::Reeb_graph_soup_traits<int>::Graph Integer_graph;
      Integer_graph falling, rising;
      const auto np = CGAL::parameters::geom_traits(Falling_traits());
      CGAL::compute_reeb_graph_of_soup(values.size(), complex.triangles, values, falling, np);
      CGAL::compute_reeb_graph_of_soup(values.size(), complex.triangles, negative_values, rising);
      const Soup_augmentation of_falling(values.size(), complex.triangles, values, falling, np);
      const Soup_augmentation of_rising(values.size(), complex.triangles, negative_values, rising);
      static_assert(std::is_same_v<decltype(of_falling), const Soup_augmentation<int, Integer_graph, Falling_traits>>);
      BOOST_REQUIRE(num_edges(falling) == num_edges(rising));
      auto arc = edges(rising).first;
      for(const auto falling_arc : CGAL::make_range(edges(falling)))
      {
        BOOST_TEST(of_falling.contour_above(falling_arc, falling[source(falling_arc, falling)].vertex).edges
                   == of_rising.contour_above(*arc, rising[source(*arc, rising)].vertex).edges);
        ++arc;
      }
    }
}

// Each vertex is where the node or arc is that took up its own.
BOOST_AUTO_TEST_CASE(the_way_back_from_a_simplified_graph)
{
  for(std::size_t seed = 0; seed < 200; ++seed)
    BOOST_TEST_CONTEXT("seed " << seed)
    {
      Random random(seed);
      const Complex complex = random_complexes::random_complex(Complex_class::RANDOM_TRIANGLES, random);
      const auto values = random_meshes::random_permutation(complex.number_of_vertices, random);
      const auto np = CGAL::parameters::edges(complex.edges);
      Graph graph, simplified;
      CGAL::compute_reeb_graph_of_soup(values.size(), complex.triangles, values, graph, np);
      const auto simplification = CGAL::Reeb_graph::simplify(graph, 2, simplified);
      const Soup_augmentation augmentation(values.size(), complex.triangles, values, graph, np);
      const Soup_augmentation of_simplified(values.size(), complex.triangles, values, simplified,
                                            np.simplification(simplification));
      const auto vertex_places = augmentation.locate_vertices(), new_places = of_simplified.locate_vertices();
      for(std::size_t v = 0; v < values.size(); ++v)
      {
        const std::size_t place = vertex_places.index(v);
        const std::size_t expected = place < num_vertices(graph)
                                     ? simplification.index_of_node(place)
                                     : simplification.index_of_arc(place - num_vertices(graph));
        BOOST_TEST(new_places.index(v) == expected);
      }
      for(const auto arc : CGAL::make_range(edges(simplified)))
        BOOST_TEST(fault_of_polylines(of_simplified.contour(arc, 0.5), different(complex.triangles)) == "");
      if(num_edges(simplified) != num_edges(graph))
        BOOST_CHECK_THROW(Soup_augmentation(values.size(), complex.triangles, values, simplified, np).locate_vertices(),
                          CGAL::Reeb_graph::Graph_mismatch_error);
    }
}

// Small complexes with many critical vertices are swept. Climbing has to find the same arcs on them.
BOOST_AUTO_TEST_CASE(climbing_gives_the_arcs_of_complexes_that_sweeping_gives)
{
  for(std::size_t seed = 0; seed < 1000; ++seed)
    BOOST_TEST_CONTEXT("seed " << seed)
    {
      namespace internal = CGAL::Reeb_graph::internal;
      const internal::Threads one_thread;
      Random random(seed);
      const auto complex_class = static_cast<Complex_class>(seed % static_cast<int>(Complex_class::NUMBER_OF_CLASSES));
      const Complex complex = random_complexes::skeleton(random_complexes::random_complex(complex_class, random));
      const std::size_t size = complex.number_of_vertices;
      const auto values = random_complexes::random_values(size, random);
      const auto np = CGAL::parameters::keep_degree_two_nodes(true).edges(complex.edges);
      Graph graph;
      CGAL::compute_reeb_graph_of_soup(size, complex.triangles, values, graph, np);
      const auto vertex_places = Soup_augmentation(size, complex.triangles, values, graph, np).locate_vertices();

      const CGAL::Reeb_graph_soup_traits<double> traits;
      const auto soup = internal::flatten_cells<3>(one_thread, size, complex.triangles, complex.edges, values, traits);
      const internal::Vertex_order order(soup.field.keys());
      const auto critical_vertices = internal::classify_vertices(one_thread, soup.complex, order);
      internal::Locate_by_climbing queries(soup.complex, order, critical_vertices);
      const internal::Slab slab(soup.complex, critical_vertices);
      const auto arcs =
        internal::Contour_trees_engine(slab, order).find_arcs(one_thread, internal::No_progress(), queries);
      const internal::Arc_of_vertex arc_of_vertex = queries.take_arc_of_vertex();
      const std::vector<arc_descriptor> graph_arcs(edges(graph).first, edges(graph).second);
      for(std::size_t v = 0; v < size; ++v)
      {
        const std::size_t place = vertex_places.index(v);
        const internal::Swept_arc_index arc = arc_of_vertex[internal::Vertex_index(v)];
        BOOST_TEST((arc == internal::no_index) == (place < num_vertices(graph)));
        if(arc == internal::no_index || place < num_vertices(graph))
          continue;
        const Edge first = graph[graph_arcs[place - num_vertices(graph)]].chain.front();
        const auto found = internal::edge_of(arcs[arc].first_step.edge);
        BOOST_TEST((complex_oracle::make_edge(first.first, first.second)
                    == Edge(soup.complex.lower_end(found).number(), soup.complex.higher_end(found).number())));
      }
    }
}

// On large complexes most places are found by climbing.
BOOST_AUTO_TEST_CASE(places_of_vertices_in_large_complexes)
{
  for(std::size_t seed = 0; seed < 9; ++seed)
    BOOST_TEST_CONTEXT("seed " << seed)
    {
      Random random(seed);
      Complex complex;
      std::vector<std::array<double, 3>> points;
      const auto set = [&](const auto& soup) {
        points = soup.points;
        complex.number_of_vertices = points.size();
      };
      if(seed % 3 == 0)
      {
        const auto soup = generated_surfaces::foam(2, 1, 1, 1);
        set(soup);
        complex.triangles = soup.triangles;
      }
      else if(seed % 3 == 1)
      {
        const auto soup = generated_surfaces::book(6, 8);
        set(soup);
        complex.triangles = soup.triangles;
      }
      else
      {
        const auto soup = generated_surfaces::solid(6, 1);
        set(soup);
        complex.tetrahedra = soup.tetrahedra;
      }
      std::vector<double> values = generated_surfaces::smooth_field(points);
      const double noise = 0.002 * static_cast<double>(random.below(30));
      for(double& value : values)
        value += noise * static_cast<double>(random.below(1000)) / 1000;
      const Oracle oracle(complex.number_of_vertices, complex.simplices(), values);
      Graph graph;
      if(complex.tetrahedra.empty())
      {
        CGAL::compute_reeb_graph_of_soup(points.size(), complex.triangles, values, graph);
        const Soup_augmentation augmentation(points.size(), complex.triangles, values, graph);
        Augmentation_check(complex, values, oracle, augmentation).check_locations(Ties::PERTURB);
      }
      else
      {
        CGAL::compute_reeb_graph_of_tetrahedra(points.size(), complex.tetrahedra, values, graph);
        const Tetrahedra_augmentation augmentation(points.size(), complex.tetrahedra, values, graph);
        Augmentation_check(complex, values, oracle, augmentation).check_locations(Ties::PERTURB);
      }
    }
}

BOOST_AUTO_TEST_SUITE_END()
