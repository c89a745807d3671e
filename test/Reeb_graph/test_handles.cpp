// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#include <boost/test/unit_test.hpp>

#include "handle_samples.h"
#include "linking_oracle.h"
#include "shortest_loop_oracle.h"
#include "shuffle.h"
#include "voxel_solids.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/self_intersections.h>
#include <CGAL/Reeb_graph/handles/area_of_filling_disc.h>
#include <CGAL/Reeb_graph/handles/handle_and_tunnel_loops.h>
#include <CGAL/Reeb_graph/handles/internal/Loop_choice.h>
#include <CGAL/Reeb_graph/scalar_maps.h>

#include <boost/mpl/list.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <map>
#include <utility>
#include <vector>

// Handles and tunnels: what bounds on which side, that they are dual, and short.

BOOST_AUTO_TEST_SUITE(test_handles)

using CGAL::Reeb_graph::handle_and_tunnel_loops;
using CGAL::Reeb_graph::Loop_kind;
using generated_surfaces::make_mesh;
using handle_samples::closed_samples;
using handle_samples::Sample;
using mesh_builders::Polyhedron;
using mesh_builders::Surface_mesh;
namespace parameters = CGAL::parameters;

typedef boost::mpl::list<Surface_mesh, Polyhedron> Meshes;
typedef CGAL::Surface_mesh<CGAL::Exact_predicates_inexact_constructions_kernel::Point_3> Exact_mesh;
typedef std::vector<std::pair<Exact_mesh::Face_index, Exact_mesh::Face_index>> Pairs_of_faces;

namespace {
template <class Mesh>
std::map<typename boost::graph_traits<Mesh>::vertex_descriptor, double> random_values(const Mesh& mesh,
                                                                                      std::size_t seed)
{
  random_meshes::Random random(seed);
  std::map<typename boost::graph_traits<Mesh>::vertex_descriptor, double> values;
  for(const auto v : vertices(mesh))
    values[v] = static_cast<double>(random.below(1000));
  return values;
}

template <class Mesh, class NamedParameters>
auto find_loops(const Mesh& mesh, std::size_t seed, const NamedParameters& np)
{
  const auto values = random_values(mesh, seed);
  return handle_and_tunnel_loops(mesh, boost::make_assoc_property_map(values), np);
}

template <class Mesh>
auto find_loops(const Mesh& mesh, std::size_t seed)
{
  return find_loops(mesh, seed, parameters::default_values());
}

template <class Loops>
std::size_t count(const Loops& loops, Loop_kind kind)
{
  return std::count_if(loops.begin(), loops.end(), [&](const auto& loop) { return loop.kind == kind; });
}

template <class Mesh, class Loop>
bool is_closed_walk(const Mesh& mesh, const Loop& loop)
{
  for(std::size_t i = 0; i != loop.halfedges.size(); ++i)
    if(target(loop.halfedges[i], mesh) != source(loop.halfedges[(i + 1) % loop.halfedges.size()], mesh))
      return false;
  return !loop.halfedges.empty();
}

// Each loop crosses its partner once, and no other one: counted without a tree or a basis. So the loops of a component of
// genus g are 2g with a unimodular matrix, that is, a basis of its homology over the integers.
template <class Mesh, class Found>
void check_intersections(const Mesh& mesh, const Found& found)
{
  const auto& loops = found.loops();
  for(std::size_t i = 0; i != loops.size(); ++i)
  {
    const auto crossings = shortest_loop_oracle::crossings_on_the_left(mesh, loops[i].halfedges);
    for(std::size_t j = 0; j != loops.size(); ++j)
    {
      long long number = 0;
      for(const auto h : loops[j].halfedges)
      {
        const auto crossing = crossings.find(h);
        number += crossing == crossings.end() ? 0 : crossing->second;
      }
      BOOST_TEST(std::abs(number) == (loops[i].partner == j ? 1 : 0));
      if(loops.size() <= 64 || j == loops[i].partner)
        BOOST_TEST(number == found.intersection_number(i, j));
    }
  }
}

// What the list says of itself, by intersection and linking numbers of its own.
template <class Mesh, class Found>
void check_list(const Mesh& mesh, const Found& found)
{
  check_intersections(mesh, found);
  const auto& loops = found.loops();
  for(std::size_t i = 0; i != loops.size(); ++i)
  {
    BOOST_TEST(is_closed_walk(mesh, loops[i]));
    BOOST_TEST(found.is_handle(loops[i].halfedges) == (loops[i].kind == Loop_kind::HANDLE));
    BOOST_TEST(found.is_tunnel(loops[i].halfedges) == (loops[i].kind == Loop_kind::TUNNEL));
    if(loops[i].kind == Loop_kind::HOLE)
      continue;
    BOOST_TEST(loops[loops[i].partner].partner == i);
    for(std::size_t j = 0; j != loops.size(); ++j)
    {
      if(loops[j].kind == Loop_kind::HOLE)
        continue;
      const bool are_partners = loops[i].partner == j;
      BOOST_TEST(std::abs(found.intersection_number(i, j)) == (are_partners ? 1 : 0));
      BOOST_TEST(std::abs(found.linking_number(i, j)) == (are_partners && loops[i].kind == Loop_kind::TUNNEL ? 1 : 0));
    }
  }
}

// The same by moving the loops off the surface. `outside` is 1 if normals point outwards, or -1.
template <class Mesh, class Found>
void check_by_oracle(const Mesh& mesh, const Found& found, double distance, const std::vector<int>& outside)
{
  const linking_oracle::Offset<Mesh> offset(mesh, distance);
  const auto& loops = found.loops();
  const std::size_t number = (std::min)(loops.size(), std::size_t(64));
  std::map<int, std::vector<linking_oracle::Polygon>> polygons; // by side
  for(const int side : {0, 1, -1})
    for(std::size_t i = 0; i != number; ++i)
      polygons[side].push_back(offset.polygon(loops[i].halfedges, side * outside[loops[i].component]));
  for(std::size_t i = 0; i != number; ++i)
    for(std::size_t j = 0; j != number; ++j)
    {
      if(loops[i].component != loops[j].component)
        continue;
      const bool are_partners = loops[i].partner == j;
      for(const int side : {1, -1})
      {
        const bool is_linked = are_partners && (loops[i].kind == Loop_kind::TUNNEL) == (side == 1);
        const double linking = linking_oracle::linking_number(polygons[0][i], polygons[side][j]);
        BOOST_TEST(std::abs(linking) == (is_linked ? 1 : 0));
        if(side == 1 && (loops.size() <= 64 || are_partners))
          BOOST_TEST(linking == static_cast<double>(found.linking_number(i, j)));
      }
    }
}

std::vector<int> outside_of(const Sample& sample)
{
  if(sample.name == "nested tori")
    return {1, -1};
  return std::vector<int>(sample.genera.size(), sample.name.find("turned over") == std::string::npos ? 1 : -1);
}

} // namespace

BOOST_AUTO_TEST_CASE_TEMPLATE(the_loops_bound_on_their_sides_and_are_dual, Mesh, Meshes)
{
  for(const Sample& sample : closed_samples())
  {
    BOOST_TEST_CONTEXT(sample.name)
    {
      const Mesh mesh = make_mesh<Mesh>(sample.soup);
      const auto found = find_loops(mesh, 1);
      std::vector<std::size_t> handles(sample.genera.size(), 0), tunnels = handles;
      for(const auto& loop : found.loops())
        ++(loop.kind == Loop_kind::HANDLE ? handles : tunnels)[loop.component];
      BOOST_TEST(handles == sample.genera, boost::test_tools::per_element());
      BOOST_TEST(tunnels == sample.genera, boost::test_tools::per_element());
      check_list(mesh, found);
      check_by_oracle(mesh, found, 1e-3, outside_of(sample));
    }
  }
}

BOOST_AUTO_TEST_CASE(loops_that_are_not_shortened_are_dual_too)
{
  for(const Sample& sample : closed_samples())
  {
    BOOST_TEST_CONTEXT(sample.name)
    {
      const Surface_mesh mesh = make_mesh<Surface_mesh>(sample.soup);
      const auto found = find_loops(mesh, 2, parameters::shorten_loops(false));
      check_list(mesh, found);
      check_by_oracle(mesh, found, 1e-3, outside_of(sample));
    }
  }
}

BOOST_AUTO_TEST_CASE(gyroids_and_plates_of_high_genus)
{
  for(const auto& soup : {handle_samples::gyroid(7, 0.6), generated_surfaces::closed_surface(30, 9000),
                          generated_surfaces::closed_surface(100, 6000)})
  {
    const Surface_mesh mesh = make_mesh<Surface_mesh>(soup);
    const auto found = find_loops(mesh, 3, parameters::shorten_loops(false).check_self_intersections(false));
    const long characteristic =
      static_cast<long>(mesh.number_of_vertices() + mesh.number_of_faces()) - static_cast<long>(mesh.number_of_edges());
    std::size_t number_of_components = 0;
    for(const auto& loop : found.loops())
      number_of_components = (std::max)(number_of_components, loop.component + 1);
    BOOST_TEST(number_of_components == 1u);
    const std::size_t genus = static_cast<std::size_t>(1 - characteristic / 2);
    BOOST_TEST(genus > 10u);
    BOOST_TEST(count(found.loops(), Loop_kind::HANDLE) == genus);
    BOOST_TEST(count(found.loops(), Loop_kind::TUNNEL) == genus);
    check_intersections(mesh, found);
    check_by_oracle(mesh, found, 1e-5, {1});
  }
}

// Each triangle in four, so that edges lie on straight lines.
generated_surfaces::Triangle_soup subdivided(const generated_surfaces::Triangle_soup& soup)
{
  generated_surfaces::Triangle_soup result = {soup.points, {}};
  std::map<std::pair<std::size_t, std::size_t>, std::size_t> middles;
  const auto middle = [&](std::size_t a, std::size_t b) {
    const auto entry = middles.emplace(std::minmax(a, b), result.points.size());
    if(entry.second)
      result.points.push_back(
        handle_samples::sum(handle_samples::sum({0, 0, 0}, 0.5, soup.points[a]), 0.5, soup.points[b]));
    return entry.first->second;
  };
  for(const auto& [a, b, c] : soup.triangles)
  {
    const std::size_t p = middle(a, b), q = middle(b, c), r = middle(c, a);
    result.triangles.insert(result.triangles.end(), {{a, p, r}, {b, q, p}, {c, r, q}, {p, q, r}});
  }
  return result;
}

BOOST_AUTO_TEST_CASE(coarse_tori_and_straight_edges)
{
  generated_surfaces::Triangle_soup seven_vertices = mesh_builders::make_soup(random_meshes::seven_vertex_torus());
  seven_vertices.points = {{3, -3, 0}, {3, 3, 1}, {1, 2, 3}, {-1, -2, 3}, {-3, -3, 1}, {-3, 3, 0}, {0, 0, 15}};
  generated_surfaces::Triangle_soup slanted = generated_surfaces::torus(3, 5);
  for(auto& point : slanted.points)
  {
    point[0] *= 4;
    point[1] += 3 * point[0];
  }
  for(const auto& soup :
      {seven_vertices, generated_surfaces::torus(3, 3), slanted, subdivided(slanted), subdivided(subdivided(slanted))})
  {
    const Surface_mesh mesh = make_mesh<Surface_mesh>(soup);
    const auto found = find_loops(mesh, 19);
    BOOST_TEST(count(found.loops(), Loop_kind::HANDLE) == 1u);
    BOOST_TEST(count(found.loops(), Loop_kind::TUNNEL) == 1u);
    check_list(mesh, found);
  }
}

// Coarse surfaces have too few edges for disjoint loops, but those that bound are the same.
BOOST_AUTO_TEST_CASE(loops_of_random_cubes_bound_on_their_sides)
{
  std::size_t number_of_loops = 0, number_of_others = 0;
  for(std::size_t seed = 0; seed != 200; ++seed)
    BOOST_TEST_CONTEXT("seed " << seed)
    {
      Voxel_solid solid(4, seed);
      const Surface_mesh mesh = make_mesh<Surface_mesh>(solid.surface());
      for(const bool are_short : {false, true})
      {
        const auto found = find_loops(mesh, seed, parameters::shorten_loops(are_short));
        check_list(mesh, found);
        for(const auto& loop : found.loops())
        {
          std::vector<Voxel_solid::Cell> polygon;
          for(const auto h : loop.halfedges)
          {
            const auto& p = mesh.point(source(h, mesh));
            polygon.push_back({int(p.x()), int(p.y()), int(p.z())});
          }
          BOOST_TEST(solid.is_bounding(polygon, true) == (loop.kind == Loop_kind::HANDLE));
          BOOST_TEST(solid.is_bounding(polygon, false) == (loop.kind == Loop_kind::TUNNEL));
          ++number_of_loops;
          number_of_others += loop.is_simple ? 0 : 1;
        }
      }
    }
  BOOST_TEST(number_of_loops > 400u);
  BOOST_TEST(number_of_others > 0u);
}

BOOST_AUTO_TEST_CASE(short_loops_of_a_gyroid)
{
  const Surface_mesh mesh = make_mesh<Surface_mesh>(handle_samples::gyroid(5, 0.6));
  const auto found = find_loops(mesh, 4);
  BOOST_TEST(found.loops().size() > 8u);
  check_list(mesh, found);
  check_by_oracle(mesh, found, 1e-5, {1});
}

BOOST_AUTO_TEST_CASE(short_loops_of_a_torus)
{
  const std::size_t around = 24, along = 60;
  const Surface_mesh mesh = make_mesh<Surface_mesh>(generated_surfaces::torus(around, along));
  const auto found = find_loops(mesh, 5);
  const double pi = generated_surfaces::internal::pi;
  // the ring around the tube, and the innermost circle
  const double handle = 2 * around * 0.4 * std::sin(pi / around), tunnel = 2 * along * 0.6 * std::sin(pi / along);
  BOOST_TEST(found.loops().size() == 2u);
  BOOST_TEST(found.loops()[0].length == handle, boost::test_tools::tolerance(1e-9));
  BOOST_TEST(found.loops()[1].length < 1.05 * tunnel);
  BOOST_TEST(found.loops()[1].length > 0.999 * tunnel);
}

// The searches for loops wind around thin rings, and around the holes of thick ones, and stop. With a face missing, the loops need
// cross each other only. None is short if both cross themselves at first: 1 of 40.
BOOST_AUTO_TEST_CASE(short_loops_of_thin_and_of_thick_rings)
{
  const double pi = generated_surfaces::internal::pi;
  std::size_t number_of_long_ones = 0;
  for(std::size_t seed = 0; seed != 40; ++seed)
    BOOST_TEST_CONTEXT("seed " << seed)
    {
      random_meshes::Random random(seed);
      const bool is_thin = seed % 2 == 0, is_closed = seed % 4 < 2;
      const std::size_t around = is_thin ? 4 + random.below(8) : 40 + random.below(40),
                        along = is_thin ? 40 + random.below(200) : 6 + random.below(10);
      const double thin = 1. / static_cast<double>(5 + random.below(75)), radius = is_thin ? thin : 1 - thin;
      auto soup =
        generated_surfaces::internal::grid(around, along, true, true, [&](std::size_t column, std::size_t row) {
          const double t = 2 * pi * row / along, u = 2 * pi * column / around, far = 1 + radius * std::cos(u);
          return handle_samples::Vector{far * std::cos(t), far * std::sin(t), radius * std::sin(u)};
        });
      generated_surfaces::shuffle(soup, random);
      if(!is_closed)
        soup.triangles.pop_back();
      std::vector<double> lengths,
        expected = {2 * around * radius * std::sin(pi / around), 2 * along * (1 - radius) * std::sin(pi / along)};
      const auto mesh = make_mesh<Surface_mesh>(soup);
      const auto found = find_loops(mesh, seed);
      for(const auto& loop : found.loops())
        if(loop.kind != Loop_kind::HOLE)
          lengths.push_back(loop.length);
      std::sort(lengths.begin(), lengths.end());
      std::sort(expected.begin(), expected.end());
      BOOST_REQUIRE(lengths.size() == 2u);
      if(!(lengths[0] < 1.08 * expected[0] && lengths[1] < 1.08 * expected[1] + expected[0]))
        ++number_of_long_ones;
    }
  BOOST_TEST(number_of_long_ones <= 1u);
}

// There are more bars than holes.
BOOST_AUTO_TEST_CASE(plates_have_a_short_tunnel_for_each_hole)
{
  std::size_t number = 0, number_of_long_ones = 0;
  for(const auto& [rows, columns] : {std::pair(1, 2), std::pair(1, 5), std::pair(2, 3), std::pair(4, 4)})
    for(std::size_t seed = 0; seed != 10; ++seed)
    {
      const int height = 2 * rows + 1, width = 2 * columns + 1;
      auto soup = Voxel_solid::of_cells(width, [&](const Voxel_solid::Cell& cell) {
                    return cell[1] < height && cell[2] == 0 && (cell[0] % 2 == 0 || cell[1] % 2 == 0);
                  }).surface();
      random_meshes::Random random(seed);
      generated_surfaces::shuffle(soup, random);
      for(auto& point : soup.points)
        for(double& coordinate : point)
          coordinate += 0.00001 * static_cast<double>(random.below(1000));
      const auto mesh = make_mesh<Surface_mesh>(soup);
      const auto found = find_loops(mesh, seed);
      for(const auto& loop : found.loops())
        if(loop.kind == Loop_kind::TUNNEL)
        {
          ++number;
          number_of_long_ones += loop.length < 4.2 ? 0 : 1;
        }
    }
  BOOST_TEST(number == 290u);
  BOOST_TEST(20 * number_of_long_ones < number);
}

// Solids of cubes have loops that bound; random points make all kinds of lengths.
generated_surfaces::Triangle_soup small_surface(std::size_t seed)
{
  if(seed % 2 == 0)
    return Voxel_solid(3, seed).surface();
  random_meshes::Random random(seed);
  auto soup = mesh_builders::make_soup(random_meshes::random_closed_surface(1 + seed / 2 % 4, 10, random));
  for(auto& point : soup.points)
    for(double& coordinate : point)
      coordinate = static_cast<double>(random.below(1000)) / 1000;
  return soup;
}

BOOST_AUTO_TEST_CASE_TEMPLATE(loops_are_nearly_the_shortest_of_their_classes, Mesh, Meshes)
{
  std::size_t number_of_loops = 0, number_of_long_ones = 0;
  for(std::size_t seed = 0; seed != 16; ++seed)
    BOOST_TEST_CONTEXT("seed " << seed)
    {
      const Mesh mesh = make_mesh<Mesh>(small_surface(seed));
      for(const bool are_short : {true, false})
      {
        const auto found = find_loops(mesh, seed, parameters::shorten_loops(are_short));
        const auto& loops = found.loops();
        if(loops.size() > (are_short && seed % 2 == 1 ? 8u : 4u))
          continue; // too many paths
        const shortest_loop_oracle::Shortest_loops<Mesh> shortest(mesh, loops);
        for(const auto& loop : loops)
        {
          const double bound = loop.length / 1.0401;
          const bool is_long = shortest(loop.halfedges, loops[loop.partner].halfedges, bound) < bound;
          BOOST_TEST((!are_short || !is_long));
          (are_short ? number_of_loops : number_of_long_ones) += are_short || is_long ? 1 : 0;
        }
      }
    }
  BOOST_TEST(number_of_loops > 40u);
  BOOST_TEST(number_of_long_ones > 0u); // where nothing is shortened
}

BOOST_AUTO_TEST_CASE(the_handle_of_a_tube_is_where_it_is_narrow)
{
  const std::size_t around = 16, along = 60;
  const double pi = generated_surfaces::internal::pi;
  const auto soup =
    generated_surfaces::internal::grid(around, along, true, true, [&](std::size_t column, std::size_t row) {
      const double t = 2 * pi * row / along, u = 2 * pi * column / around, radius = 0.35 - 0.2 * std::cos(t);
      return handle_samples::Vector{(1 + radius * std::cos(u)) * std::cos(t), (1 + radius * std::cos(u)) * std::sin(t),
                                    radius * std::sin(u)};
    });
  const Surface_mesh mesh = make_mesh<Surface_mesh>(soup);
  const auto found = find_loops(mesh, 18);
  BOOST_TEST(found.loops()[0].length < 1.05 * 2 * around * 0.15 * std::sin(pi / around));
  BOOST_TEST((found.loops()[0].kind == Loop_kind::HANDLE));
}

BOOST_AUTO_TEST_CASE(the_tunnel_of_a_knotted_torus_has_no_disc)
{
  const Surface_mesh mesh = make_mesh<Surface_mesh>(handle_samples::knotted_torus());
  const auto found = find_loops(mesh, 6);
  std::vector<std::vector<Surface_mesh::Halfedge_index>> loops;
  for(const auto& loop : found.loops())
  {
    BOOST_TEST(loop.is_simple);
    loops.push_back(loop.halfedges);
  }
  const auto areas = CGAL::Reeb_graph::areas_of_filling_discs(mesh, loops);
  BOOST_TEST(areas[0].has_value());
  BOOST_TEST(!areas[1].has_value());
  for(const int exponent : {-500, 300})
  {
    Surface_mesh scaled = mesh;
    for(const auto v : scaled.vertices())
      scaled.point(v) = CGAL::ORIGIN + std::ldexp(1., exponent) * (scaled.point(v) - CGAL::ORIGIN);
    const auto in_unit = CGAL::Reeb_graph::areas_of_filling_discs(scaled, loops);
    BOOST_TEST(std::ldexp(in_unit[0].value(), -2 * exponent) == areas[0].value(), boost::test_tools::tolerance(1e-12));
  }
  const double pi = generated_surfaces::internal::pi;
  BOOST_TEST(found.loops()[0].length == 24 * 0.35 * std::sin(pi / 12), boost::test_tools::tolerance(1e-6));
  BOOST_TEST(areas[0].value() == 6 * 0.35 * 0.35 * std::sin(pi / 6), boost::test_tools::tolerance(1e-3));
}

BOOST_AUTO_TEST_CASE(the_field_changes_persistences_only)
{
  const Surface_mesh mesh = make_mesh<Surface_mesh>(generated_surfaces::closed_surface(3, 800));
  const auto first = find_loops(mesh, 7), second = find_loops(mesh, 8);
  for(std::size_t i = 0; i != first.loops().size(); ++i)
    BOOST_TEST((first.loops()[i].halfedges == second.loops()[i].halfedges));
}

BOOST_AUTO_TEST_CASE(the_persistences_are_those_of_the_reeb_graph)
{
  const Surface_mesh mesh = make_mesh<Surface_mesh>(generated_surfaces::closed_surface(5, 1500));
  for(const std::size_t seed : {9, 10, 11})
  {
    const auto values = random_values(mesh, seed);
    const auto map = boost::make_assoc_property_map(values);
    const auto found = handle_and_tunnel_loops(mesh, map, parameters::shorten_loops(false));
    std::vector<double> persistences, expected;
    for(std::size_t i = 0; i != found.loops().size(); i += 2)
      persistences.push_back(found.loops()[i].persistence);
    CGAL::Reeb_graph_traits<Surface_mesh, std::decay_t<decltype(map)>>::Graph graph;
    CGAL::compute_reeb_graph(mesh, map, graph);
    std::vector<CGAL::Reeb_graph::Persistence_pair<boost::graph_traits<decltype(graph)>::vertex_descriptor>> pairs;
    CGAL::Reeb_graph::persistence_pairs(graph, std::back_inserter(pairs));
    for(const auto& pair : pairs)
      if(pair.kind == CGAL::Reeb_graph::Persistence_pair_kind::LOOP)
        expected.push_back(CGAL::Reeb_graph::persistence(graph, pair));
    expected.resize(persistences.size(), 0);
    std::sort(expected.begin(), expected.end());
    std::sort(persistences.begin(), persistences.end());
    BOOST_TEST(persistences == expected, boost::test_tools::per_element());
  }
}

BOOST_AUTO_TEST_CASE_TEMPLATE(surfaces_with_holes_have_loops_without_inside, Mesh, Meshes)
{
  auto soup = generated_surfaces::closed_surface(2, 600);
  soup.triangles.erase(soup.triangles.begin() + 40);
  soup.triangles.erase(soup.triangles.begin());
  soup =
    handle_samples::together(soup, handle_samples::scaled_and_moved(generated_surfaces::torus(9, 12), 1, {9, 9, 9}));
  const Mesh mesh = make_mesh<Mesh>(soup);
  const auto found = find_loops(mesh, 12);
  BOOST_TEST(count(found.loops(), Loop_kind::LOOP) == 4u);
  BOOST_TEST(count(found.loops(), Loop_kind::HOLE) == 2u);
  BOOST_TEST(count(found.loops(), Loop_kind::HANDLE) == 1u);
  BOOST_TEST(count(found.loops(), Loop_kind::TUNNEL) == 1u);
  check_list(mesh, found);
  for(const auto& loop : found.loops())
    if(loop.kind == Loop_kind::HOLE)
      BOOST_TEST(loop.halfedges.size() == 3u);
}

BOOST_AUTO_TEST_CASE(without_inside_loops_are_not_much_longer)
{
  generated_surfaces::Triangle_soup soup = Voxel_solid(9, 3).surface();
  const auto length = [&] {
    double sum = 0;
    const auto mesh = make_mesh<Surface_mesh>(soup);
    const auto found = find_loops(mesh, 4);
    for(const auto& loop : found.loops())
      sum += loop.length;
    return sum;
  };
  const double closed = length();
  soup.triangles.pop_back();
  BOOST_TEST(length() < 2.5 * closed);
}

BOOST_AUTO_TEST_CASE(what_intersects_itself_has_no_inside)
{
  const auto circle = [](double t) { return handle_samples::Vector{std::cos(t), std::sin(t), 0}; };
  const Surface_mesh mesh = make_mesh<Surface_mesh>(handle_samples::tube(circle, 16, 12, 1.3));
  const auto found = find_loops(mesh, 13);
  BOOST_TEST(found.loops().size() == 2u);
  BOOST_TEST(count(found.loops(), Loop_kind::LOOP) == 2u);
  check_list(mesh, found);
}

// Some vertices are moved through the wall on the other side of a tube.
BOOST_AUTO_TEST_CASE(spikes_through_walls_make_no_loop_longer)
{
  const generated_surfaces::Triangle_soup torus = generated_surfaces::torus(24, 60);
  const auto moved = handle_samples::scaled_and_moved(torus, 1, {9, 0, 0});
  for(const generated_surfaces::Triangle_soup& given : {torus, handle_samples::together(torus, moved)})
    for(const std::size_t number_of_spikes : {1, 2, 5})
    {
      generated_surfaces::Triangle_soup soup = given;
      for(std::size_t spike = 0; spike != number_of_spikes; ++spike)
        soup.points[7 * spike * 24 + 6][2] = -0.6;
      const auto whole = make_mesh<Exact_mesh>(given), mesh = make_mesh<Exact_mesh>(soup);
      Pairs_of_faces pairs;
      CGAL::Polygon_mesh_processing::self_intersections(mesh, std::back_inserter(pairs));
      BOOST_TEST(!pairs.empty());
      const auto expected = find_loops(whole, 17);
      for(const bool are_ignored : {false, true})
      {
        const auto found = find_loops(mesh, 17, parameters::ignore_self_intersections(are_ignored));
        BOOST_TEST(found.number_of_self_intersections(0) == pairs.size());
        BOOST_TEST(found.number_of_self_intersections(1) == 0u);
        BOOST_REQUIRE(found.loops().size() == expected.loops().size());
        std::vector<double> lengths, expected_lengths;
        for(std::size_t i = 0; i != expected.loops().size(); ++i)
        {
          const auto& loop = found.loops()[i];
          const bool has_inside = are_ignored || loop.component == 1;
          BOOST_TEST((loop.kind == Loop_kind::LOOP) == !has_inside);
          lengths.push_back(loop.length);
          expected_lengths.push_back(expected.loops()[i].length);
        }
        if(are_ignored)
          for(const Loop_kind kind : {Loop_kind::HANDLE, Loop_kind::TUNNEL})
            BOOST_TEST(count(found.loops(), kind) == count(expected.loops(), kind));
        std::sort(lengths.begin(), lengths.end());
        std::sort(expected_lengths.begin(), expected_lengths.end());
        for(std::size_t i = 0; i != lengths.size(); ++i)
          BOOST_TEST(std::abs(lengths[i] / expected_lengths[i] - 1) < 0.05);
        check_list(mesh, found);
      }
    }
}

BOOST_AUTO_TEST_CASE(the_test_for_self_intersections_agrees_with_that_of_cgal)
{
  std::size_t number_of_crossed = 0;
  const std::size_t number_of_seeds = 200;
  for(std::size_t seed = 0; seed != number_of_seeds; ++seed)
    BOOST_TEST_CONTEXT("seed " << seed)
    {
      random_meshes::Random random(seed);
      const bool is_fine = seed % 4 >= 2; // with noise in some places only, so that most of it is flat
      generated_surfaces::Triangle_soup soup =
        is_fine ? generated_surfaces::torus(30, 50) : generated_surfaces::torus(9, 14);
      const double noise = (is_fine ? 0.6 : 0.4) * static_cast<double>(random.below(100)) / 100;
      const std::size_t steps = seed % 2 == 0 ? 3 : 1000; // few places, so that some are on a plane with others
      const std::size_t number_of_moved = is_fine ? 4 : soup.points.size();
      for(std::size_t i = 0; i != number_of_moved; ++i)
        for(double& coordinate : soup.points[is_fine ? random.below(soup.points.size()) : i])
          coordinate += noise * static_cast<double>(random.below(steps)) / static_cast<double>(steps);
      const auto mesh = make_mesh<Exact_mesh>(soup);
      Pairs_of_faces pairs;
      CGAL::Polygon_mesh_processing::self_intersections(mesh, std::back_inserter(pairs));
      const bool is_crossed = !pairs.empty();
      BOOST_TEST(count(find_loops(mesh, seed).loops(), Loop_kind::LOOP) == (is_crossed ? 2u : 0u));
      const auto found = find_loops(mesh, seed, parameters::ignore_self_intersections(true));
      BOOST_TEST(found.number_of_self_intersections(0) == pairs.size());
      number_of_crossed += is_crossed ? 1 : 0;
    }
  BOOST_TEST(number_of_crossed > number_of_seeds / 5);
  BOOST_TEST(number_of_crossed < number_of_seeds * 4 / 5);
}

// Two apexes and a ring of many corners, in a plane as a lid has it, with noise, with neighbors exchanged, or in few places.
BOOST_AUTO_TEST_CASE(faces_around_a_vertex_with_many_are_tested_as_cgal_does)
{
  std::size_t number_of_crossed = 0;
  const std::size_t number_of_seeds = 120;
  for(std::size_t seed = 0; seed != number_of_seeds; ++seed)
    BOOST_TEST_CONTEXT("seed " << seed)
    {
      random_meshes::Random random(seed);
      const auto number = [&] { return static_cast<double>(random.below(2001)) / 1000 - 1; };
      const std::size_t sides = 50 + random.below(150), kind = seed % 6;
      const double unit = seed % 5 == 4 ? 1e-30 : 1;
      generated_surfaces::Triangle_soup soup;
      for(std::size_t i = 0; i != sides; ++i)
      {
        const double swap = kind == 4 ? 2 * number() : kind == 5 ? static_cast<double>(random.below(2)) : 0;
        const double turn = 2 * std::acos(-1.) * (static_cast<double>(i) + swap) / static_cast<double>(sides);
        const double radius = kind == 2 || kind == 3 ? 1 + 0.5 * number() : kind == 5 ? 1 + 0.5 * number() : 1;
        const double height = kind == 1 || kind == 3 ? number()
                            : kind == 5              ? 0.5 * static_cast<double>(random.below(2))
                                                     : 0;
        soup.points.push_back({unit * radius * std::cos(turn), unit * radius * std::sin(turn), unit * height});
        soup.triangles.push_back({sides, i, (i + 1) % sides});
        soup.triangles.push_back({sides + 1, (i + 1) % sides, i});
      }
      soup.points.push_back({random.below(3) == 0 ? 2 * unit * number() : 0, 0, random.below(3) == 0 ? 0 : unit});
      soup.points.push_back({0, 0, -unit});
      const auto mesh = make_mesh<Exact_mesh>(soup);
      Pairs_of_faces pairs;
      CGAL::Polygon_mesh_processing::self_intersections(mesh, std::back_inserter(pairs));
      const auto surface = CGAL::Reeb_graph::internal::closed_triangles(mesh);
      for(const bool are_counted : {false, true})
      {
        CGAL::Reeb_graph::internal::Self_intersections intersections(
          surface, std::vector<CGAL::Reeb_graph::internal::Index>(soup.points.size(), 0), 1, are_counted);
        const std::size_t found = intersections([](double) {})[0];
        BOOST_TEST((are_counted ? found == pairs.size() : (found != 0) == !pairs.empty()));
      }
      number_of_crossed += pairs.empty() ? 0 : 1;
    }
  BOOST_TEST(number_of_crossed > number_of_seeds / 5);
  BOOST_TEST(number_of_crossed < number_of_seeds * 4 / 5);
}

BOOST_AUTO_TEST_CASE(meshes_without_handles_have_no_loops)
{
  BOOST_TEST(find_loops(Surface_mesh(), 14).loops().empty());
  const Surface_mesh sphere = make_mesh<Surface_mesh>(generated_surfaces::closed_surface(0, 200));
  BOOST_TEST(find_loops(sphere, 15).loops().empty());
}

BOOST_AUTO_TEST_CASE(an_open_walk_is_refused_and_a_contractible_loop_is_neither)
{
  const Surface_mesh mesh = make_mesh<Surface_mesh>(generated_surfaces::torus(9, 12));
  const auto found = find_loops(mesh, 16);
  auto walk = found.loops()[0].halfedges;
  walk.pop_back();
  BOOST_CHECK_THROW(found.is_handle(walk), CGAL::Reeb_graph::Open_loop_error);
  const auto h = *halfedges(mesh).begin();
  const std::vector<Surface_mesh::Halfedge_index> face = {h, next(h, mesh), prev(h, mesh)};
  BOOST_TEST(!found.is_handle(face));
  BOOST_TEST(!found.is_tunnel(face));
}

BOOST_AUTO_TEST_CASE(it_can_be_cancelled)
{
  const Surface_mesh mesh = make_mesh<Surface_mesh>(generated_surfaces::closed_surface(3, 800));
  double last = 0;
  find_loops(mesh, 17, parameters::callback([&](double fraction) {
               BOOST_TEST(fraction >= last);
               last = fraction;
               return true;
             }));
  BOOST_TEST(last == 1);
  for(const double limit : {0., 0.15, 0.4, 0.6}) // the last two while loops are shortened
    BOOST_CHECK_THROW(find_loops(mesh, 17, parameters::callback([&](double fraction) { return fraction < limit; })),
                      CGAL::Reeb_graph::Cancelled_error);
}

BOOST_AUTO_TEST_CASE(integers_can_be_large)
{
  using namespace CGAL::Reeb_graph::internal;
  const long long large = 4000000000000000000;
  const auto lattice = find_row_lattice({{3, large}, {2, -large}});
  BOOST_TEST(lattice.basis.size() == 2u);
  const std::vector<std::vector<Integer>> rows = {{3, large}, {2, -large}};
  for(std::size_t i : {0, 1})
    for(std::size_t k : {0, 1})
      BOOST_TEST((lattice.coordinates[0][i] * lattice.basis[0][k] + lattice.coordinates[1][i] * lattice.basis[1][k]
                  == rows[i][k]));
}

BOOST_AUTO_TEST_SUITE_END()
