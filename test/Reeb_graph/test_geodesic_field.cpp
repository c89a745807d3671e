// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#include <boost/test/unit_test.hpp>

#include "field_samples.h"

#include <CGAL/Reeb_graph/fields/geodesic_field.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh_shortest_path.h>

#include <boost/mpl/list.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <set>
#include <string>
#include <utility>
#include <vector>

// Geodesic distances.

BOOST_AUTO_TEST_SUITE(test_geodesic_field)

using namespace CGAL::Reeb_graph;
using namespace field_samples;
using mesh_builders::make_mesh;
using mesh_builders::Polyhedron;
namespace fields = CGAL::Reeb_graph::internal::scalar_fields;

typedef boost::mpl::list<Surface_mesh, Polyhedron> Meshes;
typedef std::vector<std::size_t> Sources;

namespace {
template <class Mesh>
std::vector<double> distances(const Mesh& mesh, const Sources& sources)
{
  const auto field = vertex_map(mesh);
  const auto handles = vertex_vector(mesh);
  std::vector<typename boost::graph_traits<Mesh>::vertex_descriptor> source_handles;
  for(const std::size_t s : sources)
    source_handles.push_back(handles[s]);
  compute_geodesic_field(mesh, field, source_handles);
  return values_of(mesh, field);
}

// The distances of all polyhedral geodesics, by CGAL.
std::vector<double> exact_distances(const Triangle_soup& soup, const Sources& sources)
{
  typedef CGAL::Exact_predicates_inexact_constructions_kernel Kernel;
  typedef CGAL::Surface_mesh<Kernel::Point_3> Mesh;
  const Mesh mesh = make_mesh<Mesh>(soup);
  CGAL::Surface_mesh_shortest_path<CGAL::Surface_mesh_shortest_path_traits<Kernel, Mesh>> paths(mesh);
  for(const std::size_t s : sources)
    paths.add_source_point(Mesh::Vertex_index(static_cast<Mesh::size_type>(s)));
  std::vector<double> result;
  for(const auto v : mesh.vertices())
    result.push_back(paths.shortest_distance_to_source_points(v).first);
  return result;
}

// What is wrong with the distances: that they are not zero at the sources only, less than those in space, or differ by
// more than the length of an edge.
template <class Mesh>
std::string fault_of_distances(const Mesh& mesh, const std::vector<double>& values, const Sources& sources)
{
  const auto handles = vertex_vector(mesh);
  const auto points = get(CGAL::vertex_point, mesh);
  const double rounding = 1e-13 * (1 + *std::max_element(values.begin(), values.end()));
  for(const std::size_t s : sources)
    if(values[s] != 0)
      return "source " + std::to_string(s) + " is not at zero";
  for(std::size_t v = 0; v != values.size(); ++v)
  {
    double nearest = std::numeric_limits<double>::infinity();
    for(const std::size_t s : sources)
      nearest = (std::min)(nearest, length(get(points, handles[v]) - get(points, handles[s])));
    if(!(values[v] >= nearest - rounding) || !std::isfinite(values[v]))
      return "vertex " + std::to_string(v) + " is too near";
  }
  const mesh_builders::Mesh_numbers<Mesh> numbers(mesh);
  for(const auto e : edges(mesh))
  {
    const auto u = source(e, mesh), v = target(e, mesh);
    if(std::abs(values[numbers.vertex(u)] - values[numbers.vertex(v)])
       > length(get(points, u) - get(points, v)) + rounding)
      return "the edge between " + std::to_string(numbers.vertex(u)) + " and " + std::to_string(numbers.vertex(v))
           + " is too steep";
  }
  return "";
}

double mean_error(const std::vector<double>& values, const std::vector<double>& expected)
{
  double sum = 0;
  for(std::size_t v = 0; v != values.size(); ++v)
    sum += std::abs(values[v] - expected[v]);
  return sum / static_cast<double>(values.size()) / *std::max_element(expected.begin(), expected.end());
}

std::size_t number_of_maxima(const Surface_mesh& mesh, const std::vector<double>& values)
{
  std::size_t number = 0;
  for(const auto v : mesh.vertices())
  {
    const auto neighbors = vertices_around_target(v, mesh);
    number += std::none_of(neighbors.begin(), neighbors.end(),
                           [&](auto w) { return std::make_pair(values[w], w) > std::make_pair(values[v], v); })
              ? 1
              : 0;
  }
  return number;
}

Triangle_soup with_holes(Triangle_soup soup, Random& random)
{
  random_meshes::Combinatorial_mesh mesh = {soup.points.size(), soup.triangles};
  random_meshes::remove_random_triangles(mesh, 200, random);
  soup.triangles = mesh.triangles;
  return soup;
}
} // namespace

BOOST_AUTO_TEST_CASE_TEMPLATE(distances_in_the_plane_depend_little_on_triangles, Mesh, Meshes)
{
  for(const double stretch : {1., 8., 64., 1 / 8.})
    for(const double randomness : {0., 0.7})
      BOOST_TEST_CONTEXT("stretched by " << stretch << ", " << randomness)
      {
        const Mesh mesh = make_mesh<Mesh>(stretched(square(20, randomness), stretch, 1, 1));
        const auto points = get(CGAL::vertex_point, mesh);
        const auto handles = vertex_vector(mesh);
        for(const Sources& sources : {Sources{215}, Sources{0}, Sources{3, 118, 300, 301}})
        {
          std::vector<double> expected;
          for(const auto v : handles)
          {
            expected.push_back(std::numeric_limits<double>::infinity());
            for(const std::size_t s : sources)
              expected.back() = (std::min)(expected.back(), length(get(points, v) - get(points, handles[s])));
          }
          const std::vector<double> values = distances(mesh, sources);
          BOOST_TEST(fault_of_distances(mesh, values, sources) == "");
          BOOST_TEST(mean_error(values, expected) < (randomness == 0 ? 1e-3 : 2e-3));
        }
      }
}

// Rows of the manual's table on generated meshes are what this test prints with --log_level=message.
BOOST_AUTO_TEST_CASE(distances_are_close_to_exact_ones)
{
  struct Row
  {
    std::string name;
    Triangle_soup soup;
    double largest_mean_error;
  };
  Random random(3);
  const std::vector<Row> rows = {
    {"sphere of 66 vertices", sphere(4), 0.006},
    {"sphere of 1,026 vertices", sphere(16), 0.003},
    {"sphere of 1,026 vertices, stretched 8 times", stretched(sphere(16), 1, 1, 8), 0.003},
    {"plane of 25 vertices", square(4, 0.7), 0.003},
    {"plane of 1,681 vertices", square(40, 0.7), 0.002},
    {"plane of 1,681 vertices, stretched 8 times", stretched(square(40, 0.7), 8, 1, 1), 0.002},
    {"genus 2, 300 vertices", generated_surfaces::closed_surface(2, 300), 0.01},
    {"genus 2, 1,500 vertices", generated_surfaces::closed_surface(2, 1500), 0.006},
    {"genus 2, 1,500 vertices, stretched 8 times", stretched(generated_surfaces::closed_surface(2, 1500), 1, 1, 8),
     0.006},
    {"genus 2, 800 vertices, with noise", noisy_surface(), 0.01},
    {"genus 2, 1,500 vertices, with holes", with_holes(generated_surfaces::closed_surface(2, 1500), random), 0.006}};
  for(const Row& row : rows)
    BOOST_TEST_CONTEXT(row.name)
    {
      const Surface_mesh mesh = make_mesh<Surface_mesh>(row.soup);
      double error = 0, largest_error = 0, maxima = 0, exact_maxima = 0, steepness = 0;
      constexpr std::size_t number_of_trials = 3;
      for(std::size_t trial = 0; trial != number_of_trials; ++trial)
      {
        const Sources sources = {random.below(mesh.number_of_vertices())};
        const std::vector<double> values = distances(mesh, sources), expected = exact_distances(row.soup, sources);
        BOOST_TEST(fault_of_distances(mesh, values, sources) == "");
        error += mean_error(values, expected) / number_of_trials;
        largest_error =
          (std::max)(largest_error, distance(values, expected) / *std::max_element(expected.begin(), expected.end()));
        steepness = (std::max)(steepness, *std::max_element(values.begin(), values.end())
                                            / *std::max_element(expected.begin(), expected.end()));
        maxima += static_cast<double>(number_of_maxima(mesh, values));
        exact_maxima += static_cast<double>(number_of_maxima(mesh, expected));
      }
      BOOST_TEST_MESSAGE(row.name << ": mean error " << 100 * error << " %, largest " << 100 * largest_error
                                  << " %, maxima " << maxima << ", exact " << exact_maxima);
      BOOST_TEST(error < row.largest_mean_error);
      BOOST_TEST(steepness < 1.05);
      BOOST_TEST(maxima <= 1.5 * exact_maxima + 1);
    }
}

BOOST_AUTO_TEST_CASE(distances_are_nearly_symmetric)
{
  const Surface_mesh mesh = make_mesh<Surface_mesh>(noisy_surface());
  Random random(8);
  for(std::size_t trial = 0; trial != 20; ++trial)
  {
    const std::size_t a = random.below(mesh.number_of_vertices()), b = random.below(mesh.number_of_vertices());
    const std::vector<double> from_a = distances(mesh, {a}), from_b = distances(mesh, {b});
    BOOST_TEST(std::abs(from_a[b] - from_b[a]) < 0.03 * *std::max_element(from_a.begin(), from_a.end()));
  }
}

BOOST_AUTO_TEST_CASE(distances_scale_with_the_points)
{
  const Sources sources = {7, 300};
  const std::vector<double> expected = distances(make_mesh<Surface_mesh>(noisy_surface()), sources);
  for(const int exponent : {-900, -40, 3, 900})
  {
    const double unit = std::ldexp(1., exponent);
    std::vector<double> values =
      distances(make_mesh<Surface_mesh>(stretched(noisy_surface(), unit, unit, unit)), sources);
    for(double& value : values)
      value /= unit;
    BOOST_TEST(values == expected, boost::test_tools::per_element());
  }
}

BOOST_AUTO_TEST_CASE(removed_elements_do_not_count)
{
  const Triangle_soup soup = noisy_surface();
  Surface_mesh mesh;
  mesh_builders::build_with_garbage(mesh, soup);
  BOOST_TEST(mesh.has_garbage());
  BOOST_TEST(distances(mesh, {40}) == distances(make_mesh<Surface_mesh>(soup), {40}), boost::test_tools::per_element());
}

// No equation is solved, so nothing is too far away.
BOOST_AUTO_TEST_CASE(distances_on_a_long_tube)
{
  const Surface_mesh mesh = make_mesh<Surface_mesh>(tube(5, 4000));
  const std::vector<double> values = distances(mesh, {0});
  BOOST_TEST(fault_of_distances(mesh, values, {0}) == "");
  for(const auto v : mesh.vertices())
    BOOST_TEST(values[v] < 1.1 * (mesh.point(v).z() - mesh.point(Surface_mesh::Vertex_index(0)).z()) + 3);
}

BOOST_AUTO_TEST_CASE(distances_do_not_mix_components)
{
  const Triangle_soup one = generated_surfaces::closed_surface(1, 500), other = sphere(6);
  Triangle_soup both = one;
  for(const auto& p : other.points)
    both.points.push_back({p[0] + 50, p[1], p[2]});
  for(const auto& t : other.triangles)
    both.triangles.push_back({t[0] + one.points.size(), t[1] + one.points.size(), t[2] + one.points.size()});
  both.points.push_back({9, 9, 9}); // an isolated vertex
  const auto distances = [](const Triangle_soup& soup, const std::vector<Surface_mesh::Vertex_index>& sources) {
    const Surface_mesh mesh = make_mesh<Surface_mesh>(soup);
    const auto field = vertex_map(mesh);
    compute_geodesic_field(mesh, field, sources);
    return values_of(mesh, field);
  };
  const Surface_mesh::Vertex_index source(5), other_source(one.points.size() + 8), isolated(both.points.size() - 1);
  std::vector<double> expected = distances(one, {source});
  const std::vector<double> other_expected = distances(other, {Surface_mesh::Vertex_index(8)});
  expected.insert(expected.end(), other_expected.begin(), other_expected.end());
  expected.push_back(0);
  BOOST_TEST(distance(distances(both, {source, other_source, isolated}), expected) < 1e-12);
}

// Edges with the same ends are told apart.
BOOST_AUTO_TEST_CASE(distances_on_meshes_with_double_edges)
{
  std::size_t number_of_double_edges = 0;
  for(std::size_t seed = 0; seed < 40; ++seed)
    BOOST_TEST_CONTEXT("seed " << seed)
    {
      random_meshes::Random random(seed);
      Surface_mesh mesh = make_mesh<Surface_mesh>(sphere(4));
      mesh_builders::flip_edges_carelessly(mesh, 60, random);
      std::set<std::pair<Surface_mesh::Vertex_index, Surface_mesh::Vertex_index>> ends;
      for(const auto e : mesh.edges())
        ends.insert(std::minmax({mesh.vertex(e, 0), mesh.vertex(e, 1)}));
      number_of_double_edges += mesh.number_of_edges() - ends.size();
      const auto field = vertex_map(mesh);
      compute_geodesic_field(mesh, field, std::vector<Surface_mesh::Vertex_index>{Surface_mesh::Vertex_index(3)});
      BOOST_TEST(fault_of_distances(mesh, values_of(mesh, field), {3}) == "");
      for(const auto v : mesh.vertices())
        BOOST_TEST(get(field, v) < 20);
    }
  BOOST_TEST(number_of_double_edges > 10u);
}

// Flips keep the surface, end, and leave no edge that faces more than 180 degrees.
BOOST_AUTO_TEST_CASE(intrinsic_triangulations_become_delaunay)
{
  for(std::size_t seed = 0; seed < 60; ++seed)
    BOOST_TEST_CONTEXT("seed " << seed)
    {
      Random random(seed);
      Triangle_soup soup = seed % 3 == 0 ? square(8, 0.7) : sphere(5);
      soup = stretched(std::move(soup), seed % 2 == 0 ? 8 : 1, 1, 1);
      Surface_mesh mesh = make_mesh<Surface_mesh>(soup);
      if(seed % 3 == 2)
        mesh_builders::flip_edges_carelessly(mesh, 100, random);
      const fields::Indexed_mesh<Surface_mesh> surface(mesh, CGAL::parameters::default_values());
      fields::Intrinsic_triangulation triangulation(surface, fields::find_opposites(mesh, surface));
      const auto angle = [&](auto h) { // between a halfedge and the one before
        const double a = triangulation.length(h), b = triangulation.length(triangulation.previous(h)),
                     c = triangulation.length(triangulation.next(h));
        return std::acos((std::max)(-1., (std::min)(1., (a * a + b * b - c * c) / (2 * a * b))));
      };
      const auto angles_of_vertices = [&] { // which are the surface's curvature
        std::vector<double> sums(surface.number_of_vertices(), 0);
        for(CGAL::Reeb_graph::internal::Index h = 0; h != triangulation.number_of_halfedges(); ++h)
          sums[triangulation.source(h)] += angle(h);
        return sums;
      };
      const std::vector<double> before = angles_of_vertices();
      const CGAL::Reeb_graph::internal::Progress progress(CGAL::parameters::default_values());
      triangulation.make_delaunay({progress, 0, 1});
      BOOST_TEST(distance(before, angles_of_vertices()) < 1e-6);
      const double pi = std::acos(-1.);
      for(CGAL::Reeb_graph::internal::Index h = 0; h != triangulation.number_of_halfedges(); ++h)
      {
        const auto g = triangulation.opposite(h);
        if(g == CGAL::Reeb_graph::internal::no_index)
          continue;
        BOOST_TEST(triangulation.opposite(g) == h);
        BOOST_TEST(triangulation.length(g) == triangulation.length(h));
        BOOST_TEST(triangulation.source(g) == triangulation.source(triangulation.next(h)));
        BOOST_TEST(angle(triangulation.previous(h)) + angle(triangulation.previous(g)) < pi + 1e-6);
      }
    }
}

BOOST_AUTO_TEST_SUITE_END()
