// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#include "generated_complexes.h"
#include "generated_surfaces.h"
#include "graph_checks.h"
#include "random_complexes.h"

#include <CGAL/Reeb_graph/internal/engine/find_arcs.h>
#include <CGAL/Reeb_graph/internal/engine/loops_of_complexes.h>
#include <CGAL/compute_reeb_graph_of_soup.h>

#include <boost/test/unit_test.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <iterator>
#include <random>
#include <utility>
#include <vector>

// The search for loops in complexes: what it finds before it looks at single contours, and what it costs.

BOOST_AUTO_TEST_SUITE(test_soup_loops)

using CGAL::Reeb_graph::Method;
using random_complexes::Complex;
using random_complexes::Complex_class;
using random_meshes::Random;

namespace params = CGAL::parameters;
namespace stages = CGAL::Reeb_graph::internal;

typedef CGAL::Reeb_graph_soup_traits<double>::Graph Graph;

namespace {
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
      critical_vertices(stages::classify_vertices(stages::Threads(), complex, order))
  {
    for(const stages::Swept_index i : critical_vertices.ascending())
      if(critical_vertices.number_of_lower_sectors(i) > 1)
        vertices.push_back(i);
    names.assign(critical_vertices.total_number_of_sectors(stages::Side::LOWER), stages::no_index);
    number_of_steps = stages::find_contours_of_sectors(
      complex, order, critical_vertices, vertices, [](stages::Vertex_index) { return false; }, names);
  }

  stages::Simplicial_complex complex;
  stages::Indexed_vector<stages::Vertex_index, double> scalars;
  stages::Vertex_order order = stages::Vertex_order(scalars);
  stages::Swept_vertices critical_vertices;
  stages::Plain_vector<stages::Swept_index> vertices;
  stages::Indexed_vector<stages::Sector_index, stages::Index> names; // by lower sector
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
  Random random(0);
  const auto check = [&](Complex complex, bool is_closed, bool is_simply_connected) {
    // The complex twice, and a triangle.
    relabel(complex, random);
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
  const auto visit = [&](const stages::Plain_vector<stages::Halfedge_index>& crossed_edges, bool) {
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

namespace {
struct Complex_with_values
{
  std::vector<std::vector<std::size_t>> triangles = {};
  std::vector<double> values = {};
};

// A sphere with crosscaps, which has no loop, but its contours pass each of the one-sided saddles twice.
Complex_with_values sphere_with_crosscaps(std::size_t number_of_vertices, unsigned seed)
{
  // A projective plane of six vertices, and its copies glued at one triangle each to the triangles of a sphere.
  const std::vector<std::array<std::size_t, 3>> plane = {{0, 1, 2}, {0, 1, 3}, {0, 2, 4}, {0, 3, 5}, {0, 4, 5},
                                                         {1, 2, 5}, {1, 3, 4}, {1, 4, 5}, {2, 3, 4}, {2, 3, 5}};
  const auto sphere = generated_surfaces::closed_surface(0, number_of_vertices);
  std::mt19937 random(seed);
  Complex_with_values result;
  for(const auto& point : sphere.points)
    result.values.push_back(point[2]);
  for(const auto& t : sphere.triangles)
  {
    if(random() % 2 == 0)
    {
      result.triangles.push_back({t[0], t[1], t[2]});
      continue;
    }
    std::vector<std::size_t> names(t.begin(), t.end());
    for(int i = 0; i < 3; ++i)
    {
      names.push_back(result.values.size());
      const double value = result.values[t[random() % 3]];
      result.values.push_back(value + 1e-3 * static_cast<double>(random() % 1000));
    }
    for(std::size_t i = 1; i < plane.size(); ++i)
      result.triangles.push_back({names[plane[i][0]], names[plane[i][1]], names[plane[i][2]]});
  }
  return result;
}
} // namespace

BOOST_AUTO_TEST_CASE(contours_that_close_no_loop_are_found_at_once)
{
  for(unsigned seed = 0; seed < 20; ++seed)
  {
    const auto [triangles, values] = sphere_with_crosscaps(300, seed);
    Graph graph, expected;
    CGAL::compute_reeb_graph_of_soup(values.size(), triangles, values, graph);
    CGAL::compute_reeb_graph_of_soup(values.size(), triangles, values, expected, params::method(Method::CRITICAL_SETS));
    BOOST_TEST(graph_checks::are_identical(graph, expected), "seed " << seed);
  }
}

// How many edges are searched for loops, per triangle.
namespace {
template <class Cells>
double searched_edges(const Cells& cells, const std::vector<double>& values)
{
  typedef stages::Simplicial_complex Stage_complex;
  const Stage_complex complex = make_complex(values.size(), cells);
  const stages::Indexed_vector<stages::Vertex_index, double> scalars(values.begin(), values.end());
  const stages::Vertex_order order(scalars);
  const auto critical_vertices = stages::classify_vertices(stages::Threads(), complex, order);
  const auto& ascending = critical_vertices.ascending();
  const stages::Slab slab(complex, critical_vertices);
  stages::Merge_tree_sweep<Stage_complex, stages::Side::LOWER> upwards(slab, order);
  upwards.find_path_ends(stages::Threads());
  std::for_each(ascending.begin(), ascending.end(), [&](stages::Swept_index critical) { upwards.merge_at(critical); });
  stages::Cutting_sweep<Stage_complex> downwards(slab, order);
  downwards.find_path_ends(stages::Threads());
  stages::Loop_surgery<Stage_complex> surgery(slab, order, upwards.tree(), downwards.tree());
  const auto begin = std::make_reverse_iterator(ascending.end()), end = std::make_reverse_iterator(ascending.begin());
  std::for_each(begin, end, [&](stages::Swept_index critical) {
    downwards.merge_at(critical);
    if(surgery.can_close_loop(critical))
      surgery.visit_loop_contours(critical, [&](auto... cut) { downwards.cut(critical, cut...); });
  });
  return static_cast<double>(surgery.number_of_steps()) / static_cast<double>(complex.number_of_triangles());
}
} // namespace

// Graphs do not tell whether more is searched than has to be.
BOOST_AUTO_TEST_CASE(few_edges_are_searched_for_loops)
{
  const auto searched_edges_of_noise = [](const auto& cells, const auto& soup) {
    return searched_edges(cells, generated_surfaces::noise_field(soup.points));
  };
  // No closed path of these is not contractible.
  const auto sphere = generated_surfaces::closed_surface(0, 4000);
  BOOST_TEST(searched_edges_of_noise(sphere.triangles, sphere) == 0);
  const auto book = generated_surfaces::book(6, 12);
  BOOST_TEST(searched_edges_of_noise(book.triangles, book) == 0);
  // Counting tells where closed curves can close a loop; the contours of what has a border are found at once.
  const auto surface = generated_surfaces::closed_surface(3, 4000);
  BOOST_TEST(searched_edges_of_noise(surface.triangles, surface) < 0.9);
  const auto holed = generated_surfaces::with_holes(sphere, 50);
  BOOST_TEST(searched_edges_of_noise(holed.triangles, holed) < 3);
  const auto solid = generated_surfaces::solid(10, 2);
  BOOST_TEST(searched_edges_of_noise(solid.tetrahedra, solid) == 0);
  // Once searches have taken as many steps as there are triangles, and closed no loop, so are those of closed curves.
  const auto [triangles, values] = sphere_with_crosscaps(500, 1);
  BOOST_TEST(searched_edges(triangles, values) < 1.3);
}

BOOST_AUTO_TEST_SUITE_END()
