// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of the CGAL-style package Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#include "complex_oracle.h"
#include "generated_surfaces/generated_complexes.h"
#include "generated_surfaces/generated_surfaces.h"
#include "generated_surfaces/mesh_builders.h"
#include "generated_surfaces/random_meshes.h"
#include "graph_checks.h"
#include "random_complexes.h"
#include "random_fields.h"

#include <CGAL/Reeb_graph/internal/level_sets/Components_of_complex.h>
#include <CGAL/Reeb_graph/internal/level_sets/Contour_search.h>
#include <CGAL/Reeb_graph/internal/level_sets/Contours_of_sectors.h>
#include <CGAL/compute_reeb_graph_of_soup.h>

#include <boost/test/unit_test.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <limits>
#include <random>
#include <string>
#include <utility>
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
template <class NamedParameters>
Graph graph_of(const Complex& complex, const std::vector<double>& values, const NamedParameters& np)
{
  Graph graph;
  const auto np_with_edges = params::edges(std::cref(complex.edges), np);
  if(complex.tetrahedra.empty())
    CGAL::compute_reeb_graph_of_soup(complex.number_of_vertices, complex.triangles, values, graph, np_with_edges);
  else
    CGAL::compute_reeb_graph_of_tetrahedra(complex.number_of_vertices, complex.tetrahedra, values, graph,
                                           np_with_edges);
  return graph;
}
} // namespace

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
      const auto np = params::ties(ties, params::keep_degree_two_nodes(keeps));
      const Graph graph = graph_of(complex, values, np);
      BOOST_TEST(fault_of_graph(oracle, graph, values, ties) == "");
      const Graph other_graph = graph_of(complex, values, params::method(Method::CRITICAL_SETS, np));
      BOOST_TEST(fault_of_graph(oracle, other_graph, values, ties) == "");
      const Graph third = graph_of(complex, values, params::number_of_slabs(1 + random.below(5), np));
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
        graph_of(complex, values, params::geom_traits(traits));
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

namespace {
namespace stages = CGAL::Reeb_graph::internal;

template <class Cells>
stages::Simplicial_complex make_complex(std::size_t number_of_vertices, const Cells& cells)
{
  using stages::Vertex_index;
  const auto for_each_triangle = [&](const auto& visit) {
    for(const auto& cell : cells)
      for(std::size_t i = 2; i < cell.size(); ++i)
        for(std::size_t j = 1; j < i; ++j)
          for(std::size_t k = 0; k < j; ++k)
            visit(Vertex_index(cell[i]), Vertex_index(cell[j]), Vertex_index(cell[k]));
  };
  return stages::Simplicial_complex(number_of_vertices, for_each_triangle, [](const auto&) {});
}

// Finds for all vertices with several lower sectors which of these are in one contour.
struct Found_contours
{
  template <class Cells>
  Found_contours(const Cells& cells, const std::vector<double>& values)
    : complex(make_complex(values.size(), cells)),
      scalars(values.begin(), values.end()),
      critical_vertices(stages::classify_vertices<CGAL::Sequential_tag>(complex, order))
  {
    for(const stages::Swept_index i : critical_vertices.ascending())
      if(critical_vertices.number_of_lower_sectors(i) > 1)
        vertices.push_back(i);
    names.assign(critical_vertices.total_number_of_sectors(stages::Side::LOWER), stages::no_index);
    stages::Contours_of_sectors contours(complex, order, critical_vertices, vertices);
    contours([](stages::Vertex_index) { return false; }, names);
    number_of_steps = contours.number_of_steps();
  }

  stages::Simplicial_complex complex;
  stages::Indexed_vector<stages::Vertex_index, double> scalars;
  stages::Vertex_order<double, std::less<double>> order = {scalars, std::less<double>()};
  stages::Swept_vertices critical_vertices;
  stages::Plain_vector<stages::Swept_index> vertices;
  stages::Indexed_vector<stages::Sector_index, stages::Number> names; // by lower sector
  std::size_t number_of_steps = 0;
};

// By edge, one edge of its contour just below the vertex.
std::vector<stages::Edge_index> find_contours_below(const Found_contours& found, stages::Vertex_index vertex)
{
  const auto& complex = found.complex;
  const auto is_crossed = [&](stages::Edge_index edge) {
    return found.order(complex.lower_end(edge), vertex) != found.order(complex.higher_end(edge), vertex);
  };
  std::vector<stages::Edge_index> contours;
  for(const stages::Edge_index edge : complex.edges())
    contours.push_back(edge);
  for(const stages::Triangle_index triangle : complex.triangles())
    for(const stages::Edge_index a : complex.edges_of(triangle))
      for(const stages::Edge_index b : complex.edges_of(triangle))
        if(is_crossed(a) && is_crossed(b))
          std::replace(contours.begin(), contours.end(), stages::Edge_index(contours[a.number()]),
                       stages::Edge_index(contours[b.number()]));
  return contours;
}
} // namespace

BOOST_AUTO_TEST_CASE(lower_sectors_in_one_contour_are_found)
{
  std::size_t number_of_pairs = 0, number_of_joined_pairs = 0;
  for(std::size_t seed = 0; seed < 1000; ++seed)
    BOOST_TEST_CONTEXT("seed " << seed)
    {
      Random random(seed);
      const auto complex_class = static_cast<Complex_class>(seed % static_cast<int>(Complex_class::NUMBER_OF_CLASSES));
      const Complex complex = skeleton(random_complexes::random_complex(complex_class, random));
      const Found_contours found(complex.triangles,
                                 random_complexes::random_values(complex.number_of_vertices, random));
      for(const stages::Swept_index i : found.vertices)
      {
        const auto contours = find_contours_below(found, found.critical_vertices.vertex(i));
        const auto sectors = found.critical_vertices.sectors(i, stages::Side::LOWER);
        const auto contour = [&](stages::Sector_index sector) {
          return contours[edge_of(found.critical_vertices.sector(stages::Side::LOWER, sector).edge).number()];
        };
        for(const stages::Sector_index a : sectors)
          for(const stages::Sector_index b : sectors)
          {
            BOOST_TEST((found.names[a] == found.names[b]) == (contour(a) == contour(b)));
            ++number_of_pairs;
            number_of_joined_pairs += a != b && contour(a) == contour(b) ? 1 : 0;
          }
      }
    }
  BOOST_TEST(number_of_pairs > 1000u);
  BOOST_TEST(number_of_joined_pairs > 100u);
}

// What excludes loops saves searches only: graphs do not tell whether it is found.
BOOST_AUTO_TEST_CASE(components_are_closed_or_simply_connected)
{
  const auto check = [](const Complex& complex, bool is_closed, bool is_simply_connected) {
    // The complex twice, and a triangle.
    const auto one = skeleton(complex).triangles;
    auto triangles = one;
    for(const auto& t : one)
      triangles.push_back(
        {t[0] + complex.number_of_vertices, t[1] + complex.number_of_vertices, t[2] + complex.number_of_vertices});
    const std::size_t lone = 2 * complex.number_of_vertices;
    triangles.push_back({lone, lone + 1, lone + 2});
    const stages::Simplicial_complex both = make_complex(lone + 3, triangles);
    const stages::Components_of_complex components(both);
    for(const stages::Vertex_index v : both.vertices())
    {
      BOOST_TEST(components.is_closed(v) == (v.number() < lone && is_closed));
      BOOST_TEST(components.is_simply_connected(v) == (v.number() >= lone || is_simply_connected));
    }
  };
  for(const std::size_t size : {4, 6, 9})
  {
    check(random_complexes::complex_of(random_meshes::bipyramid(size)), true, true);
    check(random_complexes::complex_of(random_meshes::disk(size)), false, true);
    check(random_complexes::complex_of(random_meshes::cylinder(size, 3)), false, false);
    check(random_complexes::closed_grid(size, size, false), true, false);
    check(random_complexes::closed_grid(size, size, true), true, false);
    check(random_complexes::book(size, 4), false, true);
  }
  check(random_complexes::projective_plane(), true, false);
  check(random_complexes::triangle_strip(7), false, false);
  check(random_complexes::sphere_with_wall(), false, true);
  check({4, {}, {}, {{0, 1, 2, 3}}}, true, true);
}

namespace {
template <class Cells>
std::pair<std::size_t, std::size_t> count_steps(const Cells& cells, const std::vector<double>& values)
{
  const Found_contours found(cells, values);
  return {found.complex.number_of_triangles(), found.number_of_steps};
}
} // namespace

BOOST_AUTO_TEST_CASE(the_steps_of_noise_are_near_linear)
{
  std::vector<std::pair<std::size_t, std::size_t>> books, solids;
  for(const std::size_t side : {6, 12})
  {
    const auto book = generated_surfaces::book(12, 2 * side);
    books.push_back(count_steps(book.triangles, generated_surfaces::noise_field(book.points)));
    const auto solid = generated_surfaces::solid(side);
    solids.push_back(count_steps(solid.tetrahedra, generated_surfaces::noise_field(solid.points)));
  }
  for(const auto& counts : {books, solids})
  {
    // four, or eight, times as many triangles; a quadratic number of steps would be 16, or 64, times as large
    const double growth = static_cast<double>(counts[1].second) / static_cast<double>(counts[0].second);
    const double triangles = static_cast<double>(counts[1].first) / static_cast<double>(counts[0].first);
    BOOST_TEST(growth > triangles / 2);
    BOOST_TEST(growth < 1.6 * triangles);
    BOOST_TEST(counts[1].second < 4 * counts[1].first * std::log2(static_cast<double>(counts[1].first)));
  }
}

// Contours of one edge beside a contour at whose edge all pages of a book meet, one at a time and all at once.
BOOST_AUTO_TEST_CASE(the_steps_of_short_contours_do_not_depend_on_the_long_ones)
{
  using stages::Vertex_index;
  constexpr std::size_t number_of_pages = 1000;
  // Below the level are vertex 0 and the second half of the other ones, above it vertex 1 and the first half.
  const auto for_each_triangle = [&](const auto& visit) {
    for(std::size_t i = 0; i < number_of_pages; ++i)
      visit(Vertex_index(0), Vertex_index(1), Vertex_index(2 + i));
  };
  const auto for_each_edge = [&](const auto& visit) {
    for(std::size_t i = 0; i < number_of_pages; ++i)
      visit(Vertex_index(2 + i), Vertex_index(2 + number_of_pages + i));
  };
  const stages::Simplicial_complex complex(2 + 2 * number_of_pages, for_each_triangle, for_each_edge);
  const auto is_below = [&](Vertex_index v) { return v.number() == 0 || v.number() >= 2 + number_of_pages; };
  const auto spine = complex.find_halfedge(Vertex_index(0), Vertex_index(1));
  stages::Plain_vector<stages::Halfedge_index> all = {spine};
  std::size_t number_of_visited = 0;
  const auto visit = [&](const stages::Plain_vector<stages::Halfedge_index>& crossed_edges) {
    number_of_visited += crossed_edges.size() == 1 ? 1 : 0;
  };
  stages::Contour_search one_at_a_time(complex), all_at_once(complex);
  for(std::size_t i = 0; i < number_of_pages; ++i)
  {
    all.push_back(complex.find_halfedge(Vertex_index(2 + i), Vertex_index(2 + number_of_pages + i)));
    one_at_a_time.visit_all_but_one({spine, all.back()}, is_below, visit);
  }
  BOOST_TEST(number_of_visited == number_of_pages);
  BOOST_TEST(one_at_a_time.number_of_steps() <= 2 * number_of_pages);
  all_at_once.visit_all_but_one(all, is_below, visit);
  BOOST_TEST(number_of_visited == 2 * number_of_pages);
  BOOST_TEST(all_at_once.number_of_steps() <= 2 * number_of_pages);
}

// A sphere with crosscaps has no loop, but its contours pass each of the one-sided saddles twice.
BOOST_AUTO_TEST_CASE(contours_that_close_no_loop_are_found_at_once)
{
  // A projective plane of six vertices, and its copies glued at one triangle each to the triangles of a sphere.
  const std::vector<std::array<std::size_t, 3>> plane = {{0, 1, 2}, {0, 1, 3}, {0, 2, 4}, {0, 3, 5}, {0, 4, 5},
                                                         {1, 2, 5}, {1, 3, 4}, {1, 4, 5}, {2, 3, 4}, {2, 3, 5}};
  const auto sphere = generated_surfaces::closed_surface(0, 300);
  for(unsigned seed = 0; seed < 20; ++seed)
  {
    std::mt19937 random(seed);
    std::vector<double> values;
    for(const auto& point : sphere.points)
      values.push_back(point[2]);
    std::vector<std::vector<std::size_t>> triangles;
    for(const auto& t : sphere.triangles)
    {
      if(random() % 2 == 0)
      {
        triangles.push_back({t[0], t[1], t[2]});
        continue;
      }
      std::vector<std::size_t> names(t.begin(), t.end());
      for(int i = 0; i < 3; ++i)
      {
        names.push_back(values.size());
        const double value = values[t[random() % 3]];
        values.push_back(value + 1e-3 * static_cast<double>(random() % 1000));
      }
      for(std::size_t i = 1; i < plane.size(); ++i)
        triangles.push_back({names[plane[i][0]], names[plane[i][1]], names[plane[i][2]]});
    }
    Graph graph, expected;
    CGAL::compute_reeb_graph_of_soup(values.size(), triangles, values, graph);
    CGAL::compute_reeb_graph_of_soup(values.size(), triangles, values, expected, params::method(Method::CRITICAL_SETS));
    BOOST_TEST(graph_checks::are_identical(graph, expected), "seed " << seed);
  }
}

BOOST_AUTO_TEST_SUITE_END()
