// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#include "complex_oracle.h"
#include "graph_checks.h"
#include "mesh_builders.h"
#include "random_complexes.h"
#include "random_fields.h"
#include "random_meshes.h"

#include <CGAL/compute_reeb_graph_of_soup.h>

#include <boost/test/unit_test.hpp>

#include <cstddef>
#include <functional>
#include <iterator>
#include <limits>
#include <type_traits>
#include <vector>

// Reeb graphs of soups and tetrahedra, against the oracle, and against those of the same surfaces as meshes.

BOOST_AUTO_TEST_SUITE(test_soup)

using CGAL::Reeb_graph::Method;
using CGAL::Reeb_graph::Ties;
using random_complexes::Complex;
using random_complexes::Complex_class;
using random_meshes::Combinatorial_mesh;
using random_meshes::Field_class;
using random_meshes::Mesh_class;
using random_meshes::Random;

namespace params = CGAL::parameters;
namespace rg = CGAL::Reeb_graph;

typedef CGAL::Reeb_graph_soup_traits<double> Traits;
typedef Traits::Graph Graph;

namespace {
// `np` has the edges of the complex, if there are any.
template <class NamedParameters>
Graph graph_of(const Complex& complex, const std::vector<double>& values, const NamedParameters& np)
{
  Graph graph;
  if(complex.tetrahedra.empty())
    CGAL::compute_reeb_graph_of_soup(complex.number_of_vertices, complex.triangles, values, graph, np);
  else
    CGAL::compute_reeb_graph_of_tetrahedra(complex.number_of_vertices, complex.tetrahedra, values, graph, np);
  return graph;
}
} // namespace

// A range of scalars of which each is read through something else.
struct Scalars_behind_proxies
{
  struct Iterator
  {
    typedef double value_type;
    typedef float reference;
    typedef std::ptrdiff_t difference_type;
    typedef void pointer;
    typedef std::input_iterator_tag iterator_category;
    float operator*() const { return 0; }
  };
  Iterator begin() const { return {}; }
};
static_assert(std::is_same_v<CGAL::Reeb_graph::internal::Value_of_range<Scalars_behind_proxies>, double>);

BOOST_AUTO_TEST_CASE(graphs_of_random_complexes_are_those_of_the_oracle)
{
  for(std::size_t seed = 0; seed < 4000; ++seed)
    BOOST_TEST_CONTEXT("seed " << seed)
    {
      Random random(seed);
      const auto complex_class = static_cast<Complex_class>(seed % static_cast<int>(Complex_class::NUMBER_OF_CLASSES));
      const Complex complex = random_complexes::random_complex(complex_class, random);
      const auto values = random_complexes::random_values(complex.number_of_vertices, random);
      const Ties ties = random.below(2) == 0 ? Ties::PERTURB : Ties::CONTRACT;
      const bool keeps = random.below(2) == 0;
      const complex_oracle::Oracle oracle(complex.number_of_vertices, complex.simplices(), values, ties, keeps);
      const auto np = params::edges(std::cref(complex.edges)).ties(ties).keep_degree_two_nodes(keeps);
      const Graph graph = graph_of(complex, values, np);
      BOOST_TEST(fault_of_graph(oracle, graph, values, ties) == "");
      const Graph other_graph = graph_of(complex, values, np.method(Method::CRITICAL_SETS));
      BOOST_TEST(fault_of_graph(oracle, other_graph, values, ties) == "");
      const Graph third = graph_of(complex, values, np.number_of_slabs(1 + random.below(5)));
      BOOST_TEST(fault_of_graph(oracle, third, values, ties) == "");
    }
}

// The graph of a soup with the names of nodes and chains that plain() gives to graphs of meshes.
namespace {
graph_checks::Plain_graph plain_of_soup(const Graph& graph)
{
  graph_checks::Plain_graph result;
  for(std::size_t node = 0; node < num_vertices(graph); ++node)
    result.nodes.emplace_back(graph[node].vertex, graph[node].kind);
  for(const auto arc : CGAL::make_range(edges(graph)))
  {
    result.arcs.push_back({graph[source(arc, graph)].vertex, graph[target(arc, graph)].vertex, {}});
    result.arcs.back().chain_vertices.push_back(graph[arc].chain.front().first);
    for(const auto& edge : graph[arc].chain)
      result.arcs.back().chain_vertices.push_back(edge.second);
  }
  return result;
}

// Keeps what it is told.
struct Telling_visitor : rg::Default_visitor
{
  rg::Critical_vertex_counts counts;
  std::size_t number_of_stages = 0;
  void end_stage(rg::Stage) { ++number_of_stages; }
  void critical_vertices(const rg::Critical_vertex_counts& c) { counts = c; }
};
} // namespace

BOOST_AUTO_TEST_CASE(surfaces_have_the_same_graphs_as_soups)
{
  for(std::size_t seed = 0; seed < 400; ++seed)
    BOOST_TEST_CONTEXT("seed " << seed)
    {
      Random random(seed);
      const auto mesh_class = static_cast<Mesh_class>(seed % static_cast<int>(Mesh_class::NUMBER_OF_CLASSES));
      const Combinatorial_mesh surface = random_meshes::random_mesh(mesh_class, random);
      const auto field_class = seed % 2 == 0 ? Field_class::PERMUTATION : Field_class::FEW_VALUES;
      const auto values = random_meshes::random_field(surface, field_class, random);
      const bool keeps = random.below(2) == 0;
      const auto mesh = mesh_builders::make_mesh<mesh_builders::Surface_mesh>(surface);
      const auto expected = graph_checks::compute_plain(mesh, values, keeps);
      const auto np = params::keep_degree_two_nodes(keeps);
      const Graph graph = graph_of(random_complexes::complex_of(surface), values, np);
      BOOST_TEST((plain_of_soup(graph) == expected));

      Telling_visitor of_mesh, of_soup;
      graph_checks::Graph_of<mesh_builders::Surface_mesh> graph_of_mesh;
      CGAL::compute_reeb_graph(mesh, rg::make_scalar_map(mesh, values), graph_of_mesh,
                               params::visitor(std::ref(of_mesh)));
      Graph other_graph;
      CGAL::compute_reeb_graph_of_soup(values, surface.triangles, values, other_graph,
                                       params::visitor(std::ref(of_soup)));
      BOOST_TEST(of_soup.number_of_stages == of_mesh.number_of_stages);
      BOOST_TEST((of_soup.counts.saddles == of_mesh.counts.saddles));
      BOOST_TEST(of_soup.counts.border_saddles == of_mesh.counts.border_saddles);
      BOOST_TEST(of_soup.counts.minima + of_soup.counts.maxima + of_soup.counts.isolated
                 == of_mesh.counts.minima + of_mesh.counts.maxima + of_mesh.counts.isolated);
    }
}

BOOST_AUTO_TEST_CASE(bad_soups_leave_the_graph_as_it_was)
{
  typedef std::vector<std::vector<int>> Cells;
  const std::vector<double> values = {0, 1, 2, 3};
  Graph graph;
  CGAL::compute_reeb_graph_of_soup(4, Cells{{0, 1, 2}, {3, 2, 1}}, values, graph);
  const auto before = plain_of_soup(graph);
  BOOST_TEST(before.arcs.size() == 1u);
  const auto compute = [&](const Cells& triangles, const Cells& edges = {}, const std::vector<double>& scalars = {}) {
    CGAL::compute_reeb_graph_of_soup(4, triangles, scalars.empty() ? values : scalars, graph, params::edges(edges));
  };
  const auto compute_cells = [&](const Cells& cells) {
    CGAL::compute_reeb_graph_of_tetrahedra(4, cells, values, graph);
  };
  const auto is_first = [](const auto& error) { return error.face() == 1; };
  const auto is_at_first = [](const auto& error) { return error.position() == 1; };
  BOOST_CHECK_EXCEPTION(compute({{0, 1, 2}, {0, 1}, {0}}), rg::Non_triangular_face_error, is_first);
  BOOST_CHECK_EXCEPTION(compute({{0, 1, 2}, {0, 1, 2, 3}}), rg::Non_triangular_face_error, is_first);
  BOOST_CHECK_EXCEPTION(compute({{0, 1, 2}, {3, 1, 3}}), rg::Degenerate_face_error, is_first);
  BOOST_CHECK_EXCEPTION(compute({{0, 1, 2}, {3, 1, 4}, {0, 0, 0}}), rg::Vertex_out_of_range_error, is_at_first);
  BOOST_CHECK_EXCEPTION(compute({{0, 1, 2}, {-1, 1, 2}}), rg::Vertex_out_of_range_error, is_at_first);
  BOOST_CHECK_EXCEPTION(compute({}, {{0, 1}, {0, 7}}), rg::Vertex_out_of_range_error, is_at_first);
  BOOST_CHECK_EXCEPTION(compute({}, {{0, 1}, {2, 2}}), rg::Degenerate_edge_error,
                        [](const auto& error) { return error.edge() == 1; });
  BOOST_CHECK_THROW(compute({{0, 1, 2}}, {}, {0, 1, 2}), rg::Scalar_count_error);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  BOOST_CHECK_EXCEPTION(compute({{0, 1, 2}}, {}, {0, 1, nan, 2}), rg::Unordered_scalar_error,
                        [](const auto& error) { return error.vertex() == 2; });
  for(const Cells& cells : {Cells{{0, 1, 2, 3}, {0, 1, 2}}, Cells{{0, 1, 2, 3}, {0, 1, 2, 2}}})
    BOOST_CHECK_EXCEPTION(compute_cells(cells), rg::Non_tetrahedral_cell_error,
                          [](const auto& error) { return error.cell() == 1; });
  BOOST_CHECK_EXCEPTION(compute_cells({{0, 1, 2, 3}, {0, 1, 2, 9}}), rg::Vertex_out_of_range_error, is_at_first);
  BOOST_CHECK_THROW(CGAL::compute_reeb_graph_of_soup(4, Cells{{0, 1, 2}}, values, graph,
                                                     params::callback([](double fraction) { return fraction < 0.5; })),
                    rg::Cancelled_error);
  BOOST_TEST((plain_of_soup(graph) == before));
}

// An order that contradicts itself, in a way that the seed decides.
namespace {
struct Contradictory_traits : Traits
{
  struct Less_scalar
  {
    std::size_t seed;
    bool operator()(double a, double b) const
    {
      if(seed % 3 == 0)
        return a <= b;
      const std::size_t code =
        (static_cast<std::size_t>(a) * 31 + static_cast<std::size_t>(b) + seed) * 2654435761u >> 7;
      return code % (seed % 3 == 1 ? 2 : 9) == 0 ? a > b : a < b;
    }
  };
  Less_scalar less_scalar_object() const { return {seed}; }
  std::size_t seed = 0;
};
} // namespace

BOOST_AUTO_TEST_CASE(orders_that_contradict_themselves_end)
{
  std::size_t number_of_graphs = 0, number_of_exceptions = 0;
  for(std::size_t seed = 0; seed < 1000; ++seed)
    BOOST_TEST_CONTEXT("seed " << seed)
    {
      Random random(seed);
      const auto complex_class = static_cast<Complex_class>(seed % static_cast<int>(Complex_class::NUMBER_OF_CLASSES));
      const Complex complex = random_complexes::random_complex(complex_class, random);
      const auto values = random_complexes::random_values(complex.number_of_vertices, random);
      Contradictory_traits traits;
      traits.seed = seed;
      try
      {
        graph_of(complex, values, params::edges(std::cref(complex.edges)).geom_traits(traits));
        ++number_of_graphs;
      }
      catch(const rg::Unordered_scalar_error&)
      {
        ++number_of_exceptions;
      }
    }
  BOOST_TEST(number_of_graphs > 50);
  BOOST_TEST(number_of_exceptions > 50);
}

BOOST_AUTO_TEST_SUITE_END()
