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
#include <CGAL/Reeb_graph/fields/gradient_and_divergence.h>
#include <CGAL/Reeb_graph/fields/harmonic_field.h>
#include <CGAL/Reeb_graph/fields/poisson_field.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <iterator>
#include <limits>
#include <memory>
#include <utility>
#include <vector>

// Scalar fields on meshes with faces that have no area, or next to none.

BOOST_AUTO_TEST_SUITE(test_fields_on_bad_faces)

using namespace CGAL::Reeb_graph;
using namespace field_samples;
using mesh_builders::make_mesh;

namespace {
constexpr double infinity = std::numeric_limits<double>::infinity();

typedef CGAL::Reeb_graph::internal::scalar_fields::Indexed_mesh<Surface_mesh> Indexed_mesh;

// Ways to place the points so that triangles have no area, or next to none.
enum class Bad_points
{
  ONE_FACE,         // two corners of a face are at one point
  COINCIDENT,       // the same, of half of the faces
  SMALL_INTEGERS,   // many collinear and coincident corners
  ON_A_LINE,        // equally far apart
  ON_A_SKEW_LINE,   // anywhere
  ONE_POINT,        // all
  NEEDLES,          // next to a line
  NEEDLES_IN_DIGITS // so close to it that squares of distances vanish
};
constexpr int number_of_bad_points = 8;

Triangle_soup with_bad_points(Triangle_soup soup, Bad_points kind, Random& random)
{
  const auto unit = [&] { return random_unit(random); };
  const auto integer = [&] { return static_cast<double>(random.below(3)); };
  for(auto& p : soup.points)
    switch(kind)
    {
    case Bad_points::SMALL_INTEGERS: p = {integer(), integer(), integer()}; break;
    case Bad_points::ON_A_LINE: p = {integer(), 0, 0}; break;
    case Bad_points::ON_A_SKEW_LINE: p[0] = unit(), p[1] = 2 * p[0], p[2] = -p[0] / 3; break;
    case Bad_points::ONE_POINT: p = {1, 2, 3}; break;
    case Bad_points::NEEDLES: p = {unit(), 1e-9 * unit(), 1e3 * unit()}; break;
    case Bad_points::NEEDLES_IN_DIGITS: p = {unit(), 1e-160 * unit(), 1e-160 * unit()}; break;
    default: break;
    }
  const std::size_t number_of_faces = kind == Bad_points::ONE_FACE   ? (std::min)(std::size_t(1), soup.triangles.size())
                                    : kind == Bad_points::COINCIDENT ? soup.triangles.size() / 2
                                                                     : 0;
  for(std::size_t i = 0; i < number_of_faces; ++i)
    soup.points[soup.triangles[i][0]] = soup.points[soup.triangles[i][1]];
  return soup;
}

// Calls test(soup, random) for surfaces and random meshes, with border and several components, with bad points.
template <class Test>
void for_each_bad_mesh(const Test& test)
{
  using random_meshes::Mesh_class;
  constexpr std::size_t number_of_classes = static_cast<std::size_t>(Mesh_class::NUMBER_OF_CLASSES);
  for(std::size_t seed = 0; seed < 8 * number_of_bad_points; ++seed)
    BOOST_TEST_CONTEXT("seed " << seed)
    {
      Random random(seed);
      const auto kind = static_cast<Bad_points>(seed % number_of_bad_points);
      const std::size_t number = seed / number_of_bad_points;
      const Triangle_soup soup =
        number % 2 == 0
          ? generated_surfaces::closed_surface(static_cast<unsigned>(number / 2), 200)
          : with_random_points(
            random_meshes::random_mesh(static_cast<Mesh_class>(number / 2 % number_of_classes), random), random);
      test(with_bad_points(soup, kind, random), random);
    }
}

// The first vertices of the components, fixed.
Fixed_values fixed_first_vertices(const Surface_mesh& mesh)
{
  std::vector<std::pair<Surface_mesh::Vertex_index, Surface_mesh::Vertex_index>> pairs;
  find_far_apart_vertices(mesh, std::back_inserter(pairs));
  Fixed_values fixed;
  for(const auto& pair : pairs)
    fixed[pair.first] = 0;
  return fixed;
}

void check_report(const Field_report& report, const Surface_mesh& mesh)
{
  BOOST_TEST(report.number_of_bad_faces <= mesh.number_of_faces());
  BOOST_TEST(report.added_length >= 0);
  if(report.number_of_bad_faces > 0)
    BOOST_TEST(report.added_length > 0);
  if(report.mean_length > 0)
    BOOST_TEST(report.added_length < 1e-5 * report.mean_length);
}

template <class Map>
void check_finite(const Surface_mesh& mesh, const Map& map)
{
  for(const auto v : mesh.vertices())
    BOOST_TEST_REQUIRE(std::isfinite(get(map, v)));
}
} // namespace

BOOST_AUTO_TEST_CASE(harmonic_fields_keep_their_promise_on_bad_faces)
{
  for_each_bad_mesh([](const Triangle_soup& soup, Random&) {
    const Surface_mesh mesh = make_mesh<Surface_mesh>(soup);
    std::vector<std::pair<Surface_mesh::Vertex_index, Surface_mesh::Vertex_index>> pairs;
    find_far_apart_vertices(mesh, std::back_inserter(pairs));
    Fixed_values fixed;
    for(const auto& [lowest, highest] : pairs)
    {
      fixed[highest] = 1;
      fixed[lowest] = 0;
    }
    for(const Laplacian_weights weights :
        {Laplacian_weights::MEAN_VALUE, Laplacian_weights::COTANGENT, Laplacian_weights::UNIFORM})
    {
      const auto field = vertex_map(mesh);
      const Field_report report =
        compute_harmonic_field_between_far_apart_vertices(mesh, field, CGAL::parameters::laplacian_weights(weights));
      check_report(report, mesh);
      BOOST_TEST(fault_of_extrema(soup, fixed, values_of(mesh, field)) == "");
      if(weights == Laplacian_weights::UNIFORM)
        BOOST_TEST((report.number_of_bad_faces == 0 && report.added_length == 0));
    }
  });
}

BOOST_AUTO_TEST_CASE(all_fields_are_finite_on_bad_faces)
{
  for_each_bad_mesh([](const Triangle_soup& soup, Random& random) {
    const Surface_mesh mesh = make_mesh<Surface_mesh>(soup);
    const Fixed_values fixed = fixed_first_vertices(mesh);
    const auto constraints = constraints_of(mesh, fixed);
    const auto random_field = vertex_map(mesh), field = vertex_map(mesh);
    for(const auto v : mesh.vertices())
      put(random_field, v, random_unit(random));
    for(const auto& compute : std::vector<std::function<Field_report()>>{
          [&] { return compute_poisson_field(mesh, field, random_field, constraints); },
          [&] { return compute_curvature_poisson_field(mesh, field, constraints); },
          [&] { return compute_unit_gradient_field(mesh, random_field, field); },
          [&] { return compute_mean_curvature(mesh, field); }})
    {
      check_report(compute(), mesh);
      check_finite(mesh, field);
    }
    std::vector<Surface_mesh::Vertex_index> sources;
    for(const auto& constraint : constraints)
      sources.push_back(constraint.first);
    compute_geodesic_field(mesh, field, sources);
    check_finite(mesh, field);
    for(const auto v : mesh.vertices())
      BOOST_TEST((get(field, v) >= 0 && (get(field, v) == 0 || fixed.count(v) == 0)));
    double unit = 0;
    for(const auto v : mesh.vertices())
      unit = (std::max)(unit, length(mesh.point(v) - CGAL::ORIGIN));
    for(const auto e : mesh.edges()) // No edge is steeper than its length.
      BOOST_TEST(std::abs(get(field, mesh.vertex(e, 0)) - get(field, mesh.vertex(e, 1)))
                 <= length(mesh.point(mesh.vertex(e, 0)) - mesh.point(mesh.vertex(e, 1))) + 1e-12 * unit);
  });
}

BOOST_AUTO_TEST_CASE(edges_are_no_longer_than_it_takes)
{
  namespace fields = CGAL::Reeb_graph::internal::scalar_fields;
  for_each_bad_mesh([](const Triangle_soup& soup, Random&) {
    const Surface_mesh mesh = make_mesh<Surface_mesh>(soup);
    Indexed_mesh surface(mesh, CGAL::parameters::default_values());
    const Field_report report = fields::make_triangles_proper(surface);
    if(report.number_of_bad_faces == 0)
    {
      BOOST_TEST(surface.added_length() == 0);
      return;
    }
    double least_slack = infinity, longest = 0;
    for(const auto& t : surface.triangles())
    {
      std::array<double, 3> sides;
      for(std::size_t i = 0; i < 3; ++i)
        sides[i] = surface.edge_length(t.vertices[i], t.vertices[(i + 1) % 3]);
      std::sort(sides.begin(), sides.end());
      least_slack = (std::min)(least_slack, sides[0] - (sides[2] - sides[1]));
      longest = (std::max)(longest, sides[2]);
    }
    const double mean = report.mean_length > 0 ? report.mean_length / surface.scale() : 1;
    const double margin = (std::max)(1e-6 * mean, 1e-12 * (longest - surface.added_length()));
    BOOST_TEST(std::abs(least_slack - margin) < 1e-15 * (1 + longest));
    for(std::size_t t = 0; t < surface.triangles().size(); ++t)
    {
      const auto geometry = fields::triangle_geometry(surface, t);
      const auto& v = surface.triangles()[t].vertices;
      BOOST_TEST(geometry.is_proper());
      for(std::size_t i = 0; i < 3; ++i)
        BOOST_TEST(std::abs(fields::length(geometry.edges[i]) - surface.edge_length(v[i], v[(i + 1) % 3]))
                   < 1e-14 * longest);
      BOOST_TEST(fields::length(geometry.edges[0] + geometry.edges[1] + geometry.edges[2]) < 1e-14 * longest);
      BOOST_TEST(
        std::abs(fields::length(CGAL::cross_product(geometry.edges[0], geometry.edges[1])) - geometry.double_area)
        < 1e-12 * longest * longest);
    }
  });
}

BOOST_AUTO_TEST_CASE(gradient_and_divergence_are_adjoint_on_bad_faces)
{
  namespace fields = CGAL::Reeb_graph::internal::scalar_fields;
  for_each_bad_mesh([](const Triangle_soup& soup, Random& random) {
    const Surface_mesh mesh = make_mesh<Surface_mesh>(soup);
    Indexed_mesh surface(mesh, CGAL::parameters::default_values());
    if(fields::make_triangles_proper(surface).number_of_bad_faces == 0)
      return;
    const auto field = vertex_map(mesh), divergence = vertex_map(mesh);
    const auto vectors = face_vector_map(mesh), gradient = face_vector_map(mesh);
    for(const auto v : mesh.vertices())
      put(field, v, random_unit(random));
    for(const auto f : mesh.faces())
      put(vectors, f, Vector_3(random_unit(random), random_unit(random), 0.5));
    compute_gradient(mesh, field, gradient);
    compute_divergence(mesh, vectors, divergence);
    double over_faces = 0, over_vertices = 0, size = 0;
    for(const auto f : mesh.faces())
    {
      const auto geometry = fields::triangle_geometry(surface, f.idx());
      const double term =
        geometry.double_area / 2 * surface.scale() * surface.scale() * (get(gradient, f) * get(vectors, f));
      over_faces += term;
      size += std::abs(term);
      // the field grows along the edges as its gradient says
      const auto& v = surface.triangles()[f.idx()].vertices;
      for(std::size_t i = 0; i < 3; ++i)
      {
        const auto& edge = geometry.edges[i];
        const double growth = get(gradient, f) * Vector_3(edge[0], edge[1], edge[2]) * surface.scale();
        const double expected =
          get(field, Surface_mesh::Vertex_index(v[(i + 1) % 3])) - get(field, Surface_mesh::Vertex_index(v[i]));
        BOOST_TEST(std::abs(growth - expected) < 1e-6);
      }
    }
    for(const auto v : mesh.vertices())
      over_vertices += get(field, v) * get(divergence, v);
    BOOST_TEST(std::abs(over_faces + over_vertices) < 1e-6 * (1 + size));
  });
}

BOOST_AUTO_TEST_CASE(one_bad_face_changes_little)
{
  const Triangle_soup soup = generated_surfaces::closed_surface(2, 1000);
  // one edge is cut at a point of it that is also a corner of a face without area
  Triangle_soup bad = soup;
  const auto [a, b, c] = soup.triangles[7];
  const std::size_t middle = bad.points.size();
  bad.points.push_back({(soup.points[a][0] + soup.points[b][0]) / 2, (soup.points[a][1] + soup.points[b][1]) / 2,
                        (soup.points[a][2] + soup.points[b][2]) / 2});
  bad.triangles[7] = {a, middle, c};
  bad.triangles.push_back({middle, b, c});
  bad.triangles.push_back({a, b, middle});
  const auto field_of = [](const Triangle_soup& s, const auto& compute) {
    const Surface_mesh mesh = make_mesh<Surface_mesh>(s);
    const auto field = vertex_map(mesh);
    compute(mesh, field);
    return values_of(mesh, field);
  };
  const auto compare = [&](const auto& compute, double tolerance) {
    const std::vector<double> values = field_of(soup, compute);
    std::vector<double> bad_values = field_of(bad, compute);
    bad_values.resize(values.size());
    const double largest = *std::max_element(values.begin(), values.end());
    BOOST_TEST(distance(values, bad_values) < tolerance * largest);
  };
  const Constraints poles = {{Surface_mesh::Vertex_index(0), 0}, {Surface_mesh::Vertex_index(500), 1}};
  const auto cotangent = CGAL::parameters::laplacian_weights(Laplacian_weights::COTANGENT);
  compare([&](const auto& mesh, const auto& map) { compute_harmonic_field(mesh, map, poles, cotangent); }, 1e-2);
  const std::vector<Surface_mesh::Vertex_index> source = {Surface_mesh::Vertex_index(0)};
  compare([&](const auto& mesh, const auto& map) { compute_geodesic_field(mesh, map, source); }, 0.01);
}

BOOST_AUTO_TEST_CASE(uniform_weights_need_no_area)
{
  Surface_mesh mesh = make_mesh<Surface_mesh>(stretched(small_surface(), 0, 0, 0));
  const auto field = vertex_map(mesh);
  compute_harmonic_field_between_far_apart_vertices(mesh, field,
                                                    CGAL::parameters::laplacian_weights(Laplacian_weights::UNIFORM));
  const auto values = values_of(mesh, field);
  BOOST_TEST(*std::min_element(values.begin(), values.end()) == 0);
  BOOST_TEST(*std::max_element(values.begin(), values.end()) == 1);
}

namespace {
// Fails the first time.
struct Failing_once_solver
  : CGAL::Eigen_solver_traits<Eigen::SimplicialLDLT<CGAL::Eigen_sparse_matrix<double>::EigenType>>
{
  std::shared_ptr<int> number_of_calls = std::make_shared<int>(0);

  bool factor(const Matrix& matrix, NT& denominator)
  {
    typedef CGAL::Eigen_solver_traits<Eigen::SimplicialLDLT<CGAL::Eigen_sparse_matrix<double>::EigenType>> Base;
    return ++*number_of_calls > 1 && Base::factor(matrix, denominator);
  }
};
} // namespace

BOOST_AUTO_TEST_CASE(edges_are_lengthened_if_there_is_no_solution_without)
{
  const Triangle_soup needles = stretched(small_surface(), 1, 1e-9, 1e-9);
  const Surface_mesh mesh = make_mesh<Surface_mesh>(needles);
  const auto field = vertex_map(mesh);
  const Constraints poles = {{Surface_mesh::Vertex_index(0), 0}, {Surface_mesh::Vertex_index(90), 1}};
  BOOST_TEST(compute_harmonic_field(mesh, field, poles).added_length == 0);
  std::vector<double> fractions;
  const auto np = CGAL::parameters::callback([&](double fraction) {
    fractions.push_back(fraction);
    return true;
  });
  for(const auto& compute : std::vector<std::function<Field_report(Failing_once_solver)>>{
        [&](Failing_once_solver solver) {
          return compute_harmonic_field(mesh, field, poles, np.sparse_linear_solver(solver));
        },
        [&](Failing_once_solver solver) {
          return compute_curvature_poisson_field(mesh, field, poles, np.sparse_linear_solver(solver));
        }})
  {
    fractions.clear();
    const Field_report report = compute(Failing_once_solver());
    BOOST_TEST(report.number_of_bad_faces == 0u);
    BOOST_TEST(report.added_length > 0);
    BOOST_TEST(report.added_length < 1e-5 * report.mean_length);
    BOOST_TEST(std::is_sorted(fractions.begin(), fractions.end()));
    check_finite(mesh, field);
  }
}

BOOST_AUTO_TEST_SUITE_END()
