// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#include <boost/test/unit_test.hpp>

#include "brute_force_oracle.h"
#include "complex_oracle.h"
#include "generated_complexes.h"
#include "known_meshes.h"
#include "quotient_oracle.h"
#include "random_complexes.h"
#include "random_fields.h"
#include "random_meshes.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <map>
#include <set>
#include <utility>
#include <vector>

// The tests' own tools: the oracles on cases done by hand and on identities, and the random meshes and complexes.

BOOST_AUTO_TEST_SUITE(test_brute_force_oracle)

using brute_force_oracle::Oracle;
using CGAL::Reeb_graph::Ties;
using random_complexes::Complex;
using random_complexes::Complex_class;
using random_meshes::Combinatorial_mesh;
using random_meshes::Field_class;
using random_meshes::Mesh_class;
using random_meshes::Random;

typedef std::vector<std::pair<std::size_t, std::size_t>> Arcs;

namespace {
Oracle oracle(const Combinatorial_mesh& mesh, const std::vector<double>& values, bool keeps_degree_two_nodes = false)
{
  return Oracle(mesh.number_of_vertices, brute_force_oracle::make_triangles(mesh.triangles), values,
                keeps_degree_two_nodes);
}

Arcs sorted_arcs(const Oracle& graph)
{
  Arcs arcs;
  for(const auto& arc : graph.arcs)
    arcs.emplace_back(arc.lower, arc.upper);
  std::sort(arcs.begin(), arcs.end());
  return arcs;
}

std::size_t number_of_nodes(const Oracle& graph)
{
  std::size_t nodes = 0;
  for(std::size_t v : graph.order)
    nodes += graph.is_node(v) ? 1 : 0;
  return nodes;
}

long euler_characteristic(const Combinatorial_mesh& mesh)
{
  const auto edges = random_meshes::directed_edges(mesh);
  std::size_t number_of_edges = 0;
  for(const auto& edge : edges)
    if(edge.first.first < edge.first.second || edges.count({edge.first.second, edge.first.first}) == 0)
      ++number_of_edges;
  return static_cast<long>(mesh.number_of_vertices) - static_cast<long>(number_of_edges)
       + static_cast<long>(mesh.triangles.size());
}

bool is_on_border(const random_meshes::Directed_edges& edges, std::size_t v)
{
  for(auto e = edges.lower_bound({v, 0}); e != edges.end() && e->first.first == v; ++e)
    if(edges.count({e->first.second, v}) == 0)
      return true;
  return false;
}

complex_oracle::Oracle oracle_of_complex(const Complex& complex,
                                         const std::vector<double>& values,
                                         Ties ties = Ties::PERTURB,
                                         bool keeps_degree_two_nodes = false)
{
  return complex_oracle::Oracle(complex.number_of_vertices, complex.simplices(), values, ties, keeps_degree_two_nodes);
}

// by vertices, whatever the type of the nodes
template <class Graph>
Arcs sorted_arcs_between_vertices(const Graph& graph)
{
  Arcs arcs;
  for(const auto& arc : graph.arcs)
    arcs.emplace_back(graph.vertex_of_node(arc.lower), graph.vertex_of_node(arc.upper));
  std::sort(arcs.begin(), arcs.end());
  return arcs;
}

Arcs sorted_arcs_between_vertices(const quotient_oracle::Quotient& graph)
{
  Arcs arcs;
  for(const auto& arc : graph.arcs)
    arcs.emplace_back(graph.name_of_node(arc.lower), graph.name_of_node(arc.upper));
  std::sort(arcs.begin(), arcs.end());
  return arcs;
}

std::map<complex_oracle::Edge, std::size_t> triangles_at_edges(
  const std::vector<std::array<std::size_t, 3>>& all_triangles)
{
  std::map<complex_oracle::Edge, std::size_t> triangles;
  for(const auto& t : all_triangles)
    for(int i = 0; i < 3; ++i)
      ++triangles[complex_oracle::make_edge(t[i], t[(i + 1) % 3])];
  return triangles;
}

// Is it one, without border, of that Euler characteristic?
bool is_closed_surface(const Complex& complex, long characteristic)
{
  const auto triangles = triangles_at_edges(complex.triangles);
  const bool has_border =
    std::any_of(triangles.begin(), triangles.end(), [](const auto& edge) { return edge.second != 2; });
  return !has_border
      && static_cast<long>(complex.number_of_vertices + complex.triangles.size()) - static_cast<long>(triangles.size())
           == characteristic;
}

// Of the lower link: a circle if all of an interior link is below, else disjoint paths.
long euler_characteristic_of_lower_link(const Oracle& graph, bool is_interior, std::size_t v)
{
  const bool is_circle = is_interior && graph.upper_link_sectors[v] == 0;
  return is_circle ? 0 : static_cast<long>(graph.lower_link_sectors[v]);
}
} // namespace

BOOST_AUTO_TEST_CASE(a_tetrahedron_has_one_arc)
{
  BOOST_TEST((sorted_arcs(oracle(random_meshes::tetrahedron(), {3, 1, 0, 2})) == Arcs{{2, 0}}));
  BOOST_TEST((sorted_arcs(oracle(random_meshes::tetrahedron(), {5, 5, 5, 5})) == Arcs{{0, 3}}));
}

BOOST_AUTO_TEST_CASE(isolated_vertices_are_nodes)
{
  const Oracle graph = oracle({5, {{1, 2, 3}}}, {0, 1, 2, 3, 4});
  BOOST_TEST((sorted_arcs(graph) == Arcs{{1, 3}}));
  BOOST_TEST(graph.is_node(0));
  BOOST_TEST(graph.is_node(4));
  BOOST_TEST(!graph.is_node(2));
  BOOST_TEST(number_of_nodes(oracle({0, {}}, {})) == 0);
}

BOOST_AUTO_TEST_CASE(a_bipyramid_with_a_zigzag_field_has_a_multi_saddle)
{
  // pole 0 lies between the vertices around it, which are alternately minima and maxima; pole 1 is the top
  const Combinatorial_mesh mesh = random_meshes::bipyramid(6);
  const Oracle graph = oracle(mesh, {0, 9, -1, 1, -2, 2, -3, 3});
  BOOST_TEST(graph.lower_link_sectors[0] == 3);
  BOOST_TEST(graph.upper_link_sectors[0] == 3);
  BOOST_TEST((sorted_arcs(graph) == Arcs{{0, 1}, {2, 0}, {4, 0}, {6, 0}}));
}

BOOST_AUTO_TEST_CASE(contours_that_share_a_lower_vertex_are_two)
{
  const Combinatorial_mesh mesh = known_meshes::nine_vertex_torus();
  const Oracle graph = oracle(mesh, {0, 1, 2, 3, 4, 5, 6, 7, 8});
  BOOST_TEST((sorted_arcs(graph) == Arcs{{0, 3}, {3, 4}, {3, 4}, {4, 8}}));
}

BOOST_AUTO_TEST_CASE(contours_of_a_cylinder_close_and_open_without_a_node)
{
  // both rings have one height: at vertex 2 the contour becomes a circle, at vertex 3 a path again
  const Combinatorial_mesh mesh = random_meshes::cylinder(3, 2);
  BOOST_TEST((sorted_arcs(oracle(mesh, {0, 0, 0, 1, 1, 1})) == Arcs{{0, 5}}));
  BOOST_TEST((sorted_arcs(oracle(mesh, {0, 0, 0, 1, 1, 1}, true)) == Arcs{{0, 2}, {2, 3}, {3, 5}}));
}

BOOST_AUTO_TEST_CASE(an_annulus_across_has_a_loop)
{
  const Oracle graph = oracle(known_meshes::seven_vertex_annulus(), {0, 1, 2, 3, 4, 5, 6});
  BOOST_TEST((graph.arcs.size() == number_of_nodes(graph)));
}

BOOST_AUTO_TEST_CASE(random_meshes_are_oriented_manifold_and_of_the_wanted_genus)
{
  for(std::size_t seed = 0; seed < 300; ++seed)
    BOOST_TEST_CONTEXT("seed " << seed)
    {
      Random random(seed);
      const unsigned genus = static_cast<unsigned>(seed % 6);
      BOOST_TEST(euler_characteristic(random_meshes::random_closed_surface(genus, 5, random)) == 2 - 2 * long(genus));
      for(int c = 0; c < static_cast<int>(Mesh_class::NUMBER_OF_CLASSES); ++c)
      {
        const Combinatorial_mesh mesh = random_meshes::random_mesh(static_cast<Mesh_class>(c), random);
        BOOST_TEST(random_meshes::directed_edges(mesh).size() == 3 * mesh.triangles.size());
        for(std::size_t v = 0; v < mesh.number_of_vertices; ++v)
          BOOST_TEST(random_meshes::number_of_fans(mesh, v) <= 1);
      }
    }
}

BOOST_AUTO_TEST_CASE(lower_links_sum_up_to_the_euler_characteristic)
{
  for(std::size_t seed = 0; seed < 1000; ++seed)
    BOOST_TEST_CONTEXT("seed " << seed)
    {
      Random random(seed);
      const auto mesh_class = static_cast<Mesh_class>(seed % static_cast<int>(Mesh_class::NUMBER_OF_CLASSES));
      const auto field_class = static_cast<Field_class>(random.below(static_cast<int>(Field_class::NUMBER_OF_CLASSES)));
      const Combinatorial_mesh mesh = random_meshes::random_mesh(mesh_class, random);
      const Oracle graph = oracle(mesh, random_meshes::random_field(mesh, field_class, random));
      const auto edges = random_meshes::directed_edges(mesh);
      long sum = 0;
      for(std::size_t v = 0; v < mesh.number_of_vertices; ++v)
        sum += 1 - euler_characteristic_of_lower_link(graph, !is_on_border(edges, v), v);
      BOOST_TEST(sum == euler_characteristic(mesh));
    }
}

BOOST_AUTO_TEST_CASE(kept_nodes_of_degree_two_only_subdivide_arcs)
{
  std::size_t number_of_kept_nodes = 0;
  for(std::size_t seed = 0; seed < 300; ++seed)
    BOOST_TEST_CONTEXT("seed " << seed)
    {
      Random random(seed);
      const Combinatorial_mesh mesh = random_meshes::random_mesh(Mesh_class::HIGH_DEGREE, random);
      const auto values = random_meshes::random_field(mesh, Field_class::HUB, random);
      const Oracle strict = oracle(mesh, values), kept = oracle(mesh, values, true);
      const std::size_t difference = number_of_nodes(kept) - number_of_nodes(strict);
      BOOST_TEST(kept.arcs.size() - strict.arcs.size() == difference);
      number_of_kept_nodes += difference;
    }
  BOOST_TEST(number_of_kept_nodes > 0);
}

BOOST_AUTO_TEST_CASE(graphs_of_complexes_done_by_hand)
{
  // three pages, two of them above the spine and one below it
  const Complex book = random_complexes::book(3, 2);
  BOOST_TEST((sorted_arcs_between_vertices(oracle_of_complex(book, {3, 2, 5, 1, 4})) == Arcs{{0, 2}, {0, 4}, {3, 0}}));

  // a circle without triangles has one loop, and a tetrahedron on it closes it
  Complex circle = {4, {}, {{0, 1}, {1, 2}, {2, 3}, {3, 0}}, {}};
  BOOST_TEST((sorted_arcs_between_vertices(oracle_of_complex(circle, {0, 1, 2, 3})) == Arcs{{0, 3}, {0, 3}}));
  circle.tetrahedra = {{0, 1, 2, 3}};
  BOOST_TEST((sorted_arcs_between_vertices(oracle_of_complex(circle, {0, 1, 2, 3})) == Arcs{{0, 3}}));

  // with ties, the circle of two levels is two arcs between two vertices, and a triangle is one arc
  circle.tetrahedra.clear();
  BOOST_TEST((sorted_arcs_between_vertices(oracle_of_complex(circle, {0, 1, 0, 1}, Ties::CONTRACT))
              == Arcs{{0, 1}, {0, 3}, {2, 1}, {2, 3}}));
  BOOST_TEST((sorted_arcs_between_vertices(oracle_of_complex(Complex{3, {{0, 1, 2}}}, {0, 1, 0}, Ties::CONTRACT))
              == Arcs{{0, 1}}));

  // two circles grow from the apex where a torus is pinched, and meet
  BOOST_TEST(oracle_of_complex(random_complexes::pinched_torus(3, 3), {1, 2, 3, 4, 5, 6, 7, 8, 9, 0}).number_of_loops()
             == 1);
}

BOOST_AUTO_TEST_CASE(complexes_are_what_their_names_say)
{
  BOOST_TEST(is_closed_surface(random_complexes::closed_grid(4, 3, true), 0));
  BOOST_TEST(is_closed_surface(random_complexes::closed_grid(4, 3, false), 0));
  BOOST_TEST(is_closed_surface(random_complexes::projective_plane(), 1));
  BOOST_TEST(is_closed_surface(random_complexes::pinched_torus(4, 3), 1));
  for(const std::size_t length : {5, 6, 7, 8})
  {
    const auto triangles = triangles_at_edges(random_complexes::triangle_strip(length).triangles);
    BOOST_TEST(triangles.size() == 2 * length);
    const auto on_border =
      std::count_if(triangles.begin(), triangles.end(), [](const auto& edge) { return edge.second == 1; });
    BOOST_TEST(on_border == static_cast<long>(length));
  }
}

BOOST_AUTO_TEST_CASE(generated_complexes_are_what_their_names_say)
{
  const auto foam = generated_surfaces::foam(3, 4, 3, 1);
  const auto triangles = triangles_at_edges(foam.triangles);
  const auto is_edge_of_foam = [](const auto& edge) { return edge.second == 2 || edge.second == 3; };
  BOOST_TEST(std::all_of(triangles.begin(), triangles.end(), is_edge_of_foam));
  BOOST_TEST(foam.points.size() + foam.triangles.size() == triangles.size() + 1 + 3 * 4 * 3); // a sphere for each cell

  const auto solid = generated_surfaces::solid(5, 2);
  Complex complex = {solid.points.size()};
  complex.tetrahedra = solid.tetrahedra;
  const auto graph = oracle_of_complex(complex, generated_surfaces::smooth_field(solid.points));
  BOOST_TEST(graph.fault == "");
  BOOST_TEST(complex_oracle::first_betti_number(graph, complex.simplices()) == 4);

  const auto book = generated_surfaces::book(5, 4);
  const auto at_edges = triangles_at_edges(book.triangles);
  const auto of_spine = std::count_if(at_edges.begin(), at_edges.end(), [](const auto& e) { return e.second == 5; });
  BOOST_TEST(of_spine == 4);
  BOOST_TEST(book.points.size() + book.triangles.size() == at_edges.size() + 1);
}

BOOST_AUTO_TEST_CASE(the_oracles_agree_on_surfaces)
{
  for(std::size_t seed = 0; seed < 600; ++seed)
    BOOST_TEST_CONTEXT("seed " << seed)
    {
      Random random(seed);
      const auto mesh_class = static_cast<Mesh_class>(seed % static_cast<int>(Mesh_class::NUMBER_OF_CLASSES));
      const Combinatorial_mesh mesh = random_meshes::random_mesh(mesh_class, random);
      const auto field_class = seed % 2 == 0 ? Field_class::PERMUTATION : Field_class::FEW_VALUES;
      const auto values = random_meshes::random_field(mesh, field_class, random);
      const Complex complex = random_complexes::complex_of(mesh);
      const bool keeps_degree_two_nodes = seed % 4 < 2;
      const Oracle surface = oracle(mesh, values, keeps_degree_two_nodes);
      const auto perturbed = oracle_of_complex(complex, values, Ties::PERTURB, keeps_degree_two_nodes);
      BOOST_TEST(perturbed.fault == "");
      BOOST_TEST((sorted_arcs_between_vertices(perturbed) == sorted_arcs(surface)));
      BOOST_TEST(perturbed.nodes.size() == number_of_nodes(surface));

      std::vector<bool> is_critical;
      for(std::size_t v = 0; v < mesh.number_of_vertices; ++v)
        is_critical.push_back(surface.is_critical(v));
      const quotient_oracle::Quotient quotient(mesh.number_of_vertices,
                                               brute_force_oracle::make_triangles(mesh.triangles), values, is_critical,
                                               keeps_degree_two_nodes);
      const auto contracted = oracle_of_complex(complex, values, Ties::CONTRACT, keeps_degree_two_nodes);
      BOOST_TEST(contracted.fault == "");
      BOOST_TEST((sorted_arcs_between_vertices(contracted) == sorted_arcs_between_vertices(quotient)));
    }
}

BOOST_AUTO_TEST_CASE(graphs_of_complexes_keep_to_identities)
{
  std::set<std::size_t> numbers_of_loops;
  for(std::size_t seed = 0; seed < 1200; ++seed)
    BOOST_TEST_CONTEXT("seed " << seed)
    {
      Random random(seed);
      const auto complex_class = static_cast<Complex_class>(seed % static_cast<int>(Complex_class::NUMBER_OF_CLASSES));
      const Complex complex = random_complexes::random_complex(complex_class, random);
      const auto values = random_complexes::random_values(complex.number_of_vertices, random);
      const Ties ties = random.below(2) == 0 ? Ties::PERTURB : Ties::CONTRACT;
      const auto strict = oracle_of_complex(complex, values, ties),
                 kept = oracle_of_complex(complex, values, ties, true);
      BOOST_TEST(strict.fault == "");
      BOOST_TEST(kept.arcs.size() - strict.arcs.size() == kept.nodes.size() - strict.nodes.size());
      BOOST_TEST(strict.number_of_loops() == kept.number_of_loops());

      // tetrahedra have the graph of their faces, and no complex loses loops by contracting ties
      const auto faces = oracle_of_complex(random_complexes::skeleton(complex), values, ties);
      BOOST_TEST((sorted_arcs_between_vertices(faces) == sorted_arcs_between_vertices(strict)));
      const auto perturbed = oracle_of_complex(complex, values);
      BOOST_TEST(strict.number_of_loops() <= perturbed.number_of_loops());
      BOOST_TEST(perturbed.number_of_loops() <= complex_oracle::first_betti_number(strict, complex.simplices()));
      numbers_of_loops.insert(perturbed.number_of_loops());
    }
  BOOST_TEST(numbers_of_loops.size() > 5);
}

BOOST_AUTO_TEST_SUITE_END()
