// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of the CGAL-style package Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#include <boost/test/unit_test.hpp>

#include "field_checks.h"
#include "generated_surfaces/mesh_builders.h"
#include "generated_surfaces/random_meshes.h"

#include <CGAL/Reeb_graph/fields/geodesic_field.h>
#include <CGAL/Reeb_graph/fields/gradient_and_divergence.h>
#include <CGAL/Reeb_graph/fields/harmonic_field.h>
#include <CGAL/Reeb_graph/fields/harmonic_field_between_borders.h>
#include <CGAL/Reeb_graph/fields/height_field.h>
#include <CGAL/Reeb_graph/fields/poisson_field.h>
#include <CGAL/Reeb_graph/fields/unit_gradient_field.h>

#include <CGAL/Exact_rational.h>

#include <boost/mpl/list.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <iterator>
#include <limits>
#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

// Gradient, divergence, and the fields that are made of them; geodesic distances and heights; bad input to all fields.

BOOST_AUTO_TEST_SUITE(test_scalar_fields)

using namespace CGAL::Reeb_graph;
using field_checks::pi;
using field_checks::Triangle_soup;
using mesh_builders::Kernel;
using mesh_builders::make_mesh;
using mesh_builders::Polyhedron;
using mesh_builders::Surface_mesh;
using random_meshes::Random;

typedef boost::mpl::list<Surface_mesh, Polyhedron> Meshes;
typedef Kernel::Vector_3 Vector_3;

namespace {
template <class Mesh>
auto vertex_map(const Mesh& mesh)
{
  return get(CGAL::dynamic_vertex_property_t<double>(), mesh);
}

template <class Mesh>
auto face_vector_map(const Mesh& mesh)
{
  return get(CGAL::dynamic_face_property_t<Vector_3>(), mesh);
}

template <class Mesh>
Vector_3 normal_of(typename boost::graph_traits<Mesh>::face_descriptor f, const Mesh& mesh)
{
  const auto points = get(CGAL::vertex_point, mesh);
  const auto h = halfedge(f, mesh);
  return CGAL::cross_product(get(points, target(h, mesh)) - get(points, source(h, mesh)),
                             get(points, target(next(h, mesh), mesh)) - get(points, source(h, mesh)));
}

double length(const Vector_3& vector) { return std::sqrt(vector.squared_length()); }

Triangle_soup noisy_surface()
{
  Random random(5);
  return field_checks::with_noise(generated_surfaces::closed_surface(2, 800), 0.01, random);
}

// The unit sphere: an octahedron each of whose faces is cut into `size` squared ones.
Triangle_soup sphere(std::size_t size)
{
  std::map<std::array<long, 3>, std::size_t> names;
  Triangle_soup soup;
  const auto n = static_cast<long>(size);
  const auto vertex = [&](long x, long y, long sx, long sy, long sz) {
    const std::array<long, 3> key = {sx * x, sy * y, sz * (n - x - y)};
    const auto [it, is_new] = names.emplace(key, soup.points.size());
    if(is_new)
    {
      const double norm = std::sqrt(static_cast<double>(key[0] * key[0] + key[1] * key[1] + key[2] * key[2]));
      soup.points.push_back({key[0] / norm, key[1] / norm, key[2] / norm});
    }
    return it->second;
  };
  for(long sx : {-1, 1})
    for(long sy : {-1, 1})
      for(long sz : {-1, 1})
        for(long x = 0; x < n; ++x)
          for(long y = 0; x + y < n; ++y)
            for(const bool is_upright : {true, false})
            {
              if(!is_upright && x + y + 2 > n)
                continue;
              std::array<std::size_t, 3> t = {is_upright ? vertex(x, y, sx, sy, sz) : vertex(x + 1, y + 1, sx, sy, sz),
                                              is_upright ? vertex(x + 1, y, sx, sy, sz) : vertex(x, y + 1, sx, sy, sz),
                                              is_upright ? vertex(x, y + 1, sx, sy, sz) : vertex(x + 1, y, sx, sy, sz)};
              if(sx * sy * sz < 0)
                std::swap(t[0], t[1]);
              soup.triangles.push_back(t);
            }
  return soup;
}

// A flat square of side 1.
Triangle_soup square(std::size_t size, double randomness)
{
  Random random(size);
  const double n = static_cast<double>(size);
  return generated_surfaces::internal::grid(size + 1, size + 1, false, false, [&](std::size_t x, std::size_t y) {
    const auto move = [&](std::size_t i) {
      const double moved = static_cast<double>(i) + randomness * (field_checks::random_unit(random) - 0.5);
      return i == 0 || i == size ? static_cast<double>(i) / n : moved / n;
    };
    return std::array<double, 3>{move(x), move(y), 0};
  });
}

template <class Function>
double mean_order(const Function& error)
{
  return std::log2(error(10) / error(40)) / 2;
}
} // namespace

BOOST_AUTO_TEST_CASE_TEMPLATE(the_gradient_of_a_linear_function_is_exact, Mesh, Meshes)
{
  const Mesh mesh = make_mesh<Mesh>(noisy_surface());
  const Vector_3 direction(0.5, -2, 0.25);
  const auto height = vertex_map(mesh);
  compute_height_field(mesh, height, direction);
  const auto gradient = face_vector_map(mesh);
  compute_gradient(mesh, height, gradient);
  for(const auto f : faces(mesh))
  {
    const Vector_3 normal = normal_of(f, mesh) / length(normal_of(f, mesh));
    BOOST_TEST(length(get(gradient, f) - (direction - (direction * normal) * normal)) < 1e-11);
  }
}

BOOST_AUTO_TEST_CASE_TEMPLATE(gradient_and_divergence_are_adjoint, Mesh, Meshes)
{
  for(const double scale : {1., 1e-5, 1e7})
  {
    const Mesh mesh = make_mesh<Mesh>(field_checks::stretched(noisy_surface(), scale, scale, scale));
    Random random(6);
    const auto field = vertex_map(mesh), divergence = vertex_map(mesh);
    for(const auto v : vertices(mesh))
      put(field, v, field_checks::random_unit(random));
    const auto vectors = face_vector_map(mesh), gradient = face_vector_map(mesh);
    for(const auto f : faces(mesh))
      put(vectors, f, Vector_3(field_checks::random_unit(random), field_checks::random_unit(random), 0.5));
    compute_gradient(mesh, field, gradient);
    compute_divergence(mesh, vectors, divergence);
    double over_faces = 0, over_vertices = 0;
    for(const auto f : faces(mesh))
      over_faces += length(normal_of(f, mesh)) / 2 * (get(gradient, f) * get(vectors, f));
    for(const auto v : vertices(mesh))
      over_vertices += get(field, v) * get(divergence, v);
    BOOST_TEST(std::abs(over_faces + over_vertices) < 1e-10 * scale);
  }
}

BOOST_AUTO_TEST_CASE(linear_functions_have_no_divergence_in_the_plane)
{
  const Surface_mesh mesh = make_mesh<Surface_mesh>(square(10, 0.7));
  const auto height = vertex_map(mesh), divergence = vertex_map(mesh);
  compute_height_field(mesh, height, Vector_3(3, 1, 5));
  const auto gradient = face_vector_map(mesh);
  compute_gradient(mesh, height, gradient);
  compute_divergence(mesh, gradient, divergence);
  for(const auto v : vertices(mesh))
    if(!mesh.is_border(v))
      BOOST_TEST(std::abs(get(divergence, v)) < 1e-12);
}

BOOST_AUTO_TEST_CASE_TEMPLATE(the_mean_curvature_of_spheres_is_known, Mesh, Meshes)
{
  for(const double radius : {1., 1e-3, 50.})
  {
    const Mesh mesh = make_mesh<Mesh>(field_checks::stretched(sphere(30), radius, radius, radius));
    const auto curvature = vertex_map(mesh);
    compute_mean_curvature(mesh, curvature);
    for(const auto v : vertices(mesh))
      BOOST_TEST(std::abs(get(curvature, v) * radius - 1) < 0.05);
  }
}

BOOST_AUTO_TEST_CASE(the_mean_curvature_of_tori_converges)
{
  const double order = mean_order([](std::size_t size) {
    const Surface_mesh mesh = make_mesh<Surface_mesh>(field_checks::band(2 * size, size, 0, field_checks::torus_point));
    const auto curvature = vertex_map(mesh);
    compute_mean_curvature(mesh, curvature);
    double error = 0;
    for(const auto v : vertices(mesh))
    {
      const double radius = std::hypot(mesh.point(v).x(), mesh.point(v).y());
      const double expected = std::abs(2 * radius - 2) / (2 * radius);
      if(!mesh.is_border(v))
        error = (std::max)(error, std::abs(get(curvature, v) - expected));
    }
    return error;
  });
  BOOST_TEST(order > 1.8);
}

// On the unit sphere the Laplacian of z is -2 z.
BOOST_AUTO_TEST_CASE(poisson_fields_converge_on_the_sphere)
{
  const double order = mean_order([](std::size_t size) {
    const Surface_mesh mesh = make_mesh<Surface_mesh>(sphere(size));
    const auto right_side = vertex_map(mesh), field = vertex_map(mesh);
    for(const auto v : vertices(mesh))
      put(right_side, v, -2 * mesh.point(v).z());
    const Surface_mesh::Vertex_index fixed(7);
    const std::vector<std::pair<Surface_mesh::Vertex_index, double>> constraints = {{fixed, mesh.point(fixed).z()}};
    compute_poisson_field(mesh, field, right_side, constraints);
    double error = 0;
    for(const auto v : vertices(mesh))
      error = (std::max)(error, std::abs(get(field, v) - mesh.point(v).z()));
    return error;
  });
  BOOST_TEST(order > 1.5);
}

BOOST_AUTO_TEST_CASE_TEMPLATE(the_curvature_field_is_the_poisson_field_of_the_curvature, Mesh, Meshes)
{
  for(const double scale : {1., 1e3})
  {
    const Mesh mesh = make_mesh<Mesh>(field_checks::stretched(noisy_surface(), scale, scale, scale));
    const auto curvature = vertex_map(mesh), field = vertex_map(mesh), expected = vertex_map(mesh);
    const auto constraints = field_checks::constraints_of(mesh, {{3, 4.5}});
    compute_mean_curvature(mesh, curvature);
    compute_poisson_field(mesh, expected, curvature, constraints);
    compute_curvature_poisson_field(mesh, field, constraints);
    const auto values = field_checks::values_of(mesh, field);
    BOOST_TEST(field_checks::distance(values, field_checks::values_of(mesh, expected)) < 1e-8 * scale);
    // the curvature is never negative: nowhere but at the fixed vertex is there a maximum
    BOOST_TEST(values[3] == 4.5);
    BOOST_TEST(*std::max_element(values.begin(), values.end()) == 4.5);
  }
}

// f = x^3 has the level sets of x.
BOOST_AUTO_TEST_CASE(the_unit_gradient_field_of_a_function_of_x_is_x)
{
  const Surface_mesh mesh = make_mesh<Surface_mesh>(square(20, 0));
  const auto field = vertex_map(mesh), unit_field = vertex_map(mesh);
  for(const auto v : vertices(mesh))
    put(field, v, std::pow(mesh.point(v).x(), 3));
  compute_unit_gradient_field(mesh, field, unit_field);
  for(const auto v : vertices(mesh))
    BOOST_TEST(std::abs(get(unit_field, v) - mesh.point(v).x()) < 1e-12);
}

BOOST_AUTO_TEST_CASE_TEMPLATE(the_gradient_of_the_unit_gradient_field_is_about_one, Mesh, Meshes)
{
  const Mesh mesh = make_mesh<Mesh>(field_checks::tube(30, 60));
  const auto field = vertex_map(mesh), unit_field = vertex_map(mesh);
  const auto points = get(CGAL::vertex_point, mesh);
  for(const auto v : vertices(mesh))
    put(field, v, std::exp(get(points, v).z() / 5));
  compute_unit_gradient_field(mesh, field, unit_field);
  const auto gradient = face_vector_map(mesh);
  compute_gradient(mesh, unit_field, gradient);
  std::size_t number_of_good_faces = 0;
  for(const auto f : faces(mesh))
    number_of_good_faces += std::abs(length(get(gradient, f)) - 1) < 0.05 ? 1 : 0;
  BOOST_TEST(number_of_good_faces > 0.95 * static_cast<double>(faces(mesh).size()));
}

BOOST_AUTO_TEST_CASE(the_unit_gradient_field_of_a_harmonic_field_on_a_surface_with_handles)
{
  const Surface_mesh mesh = make_mesh<Surface_mesh>(generated_surfaces::closed_surface(3, 5000));
  const auto field = vertex_map(mesh), unit_field = vertex_map(mesh);
  compute_harmonic_field_between_far_apart_vertices(mesh, field);
  compute_unit_gradient_field(mesh, field, unit_field);
  const auto gradient = face_vector_map(mesh);
  compute_gradient(mesh, unit_field, gradient);
  std::vector<double> lengths;
  for(const auto f : faces(mesh))
    lengths.push_back(length(get(gradient, f)));
  std::sort(lengths.begin(), lengths.end());
  BOOST_TEST_MESSAGE("lengths of gradients: 10% " << lengths[lengths.size() / 10] << ", 50% "
                                                  << lengths[lengths.size() / 2] << ", 90% "
                                                  << lengths[lengths.size() * 9 / 10]);
  BOOST_TEST(lengths[lengths.size() / 10] > 0.6);
  BOOST_TEST(lengths[lengths.size() / 2] > 0.9);
  BOOST_TEST(lengths[lengths.size() * 9 / 10] < 1.2);
}

BOOST_AUTO_TEST_CASE(constant_fields_have_no_direction)
{
  Triangle_soup soup = noisy_surface();
  soup.points.push_back({9, 9, 9}); // an isolated vertex
  const Surface_mesh mesh = make_mesh<Surface_mesh>(soup);
  const auto field = vertex_map(mesh), unit_field = vertex_map(mesh);
  for(const auto v : vertices(mesh))
    put(field, v, 0.1);
  compute_unit_gradient_field(mesh, field, unit_field);
  for(const auto v : vertices(mesh))
    BOOST_TEST(get(unit_field, v) == 0);
}

BOOST_AUTO_TEST_CASE_TEMPLATE(geodesic_distances_on_the_sphere, Mesh, Meshes)
{
  const Mesh mesh = make_mesh<Mesh>(field_checks::stretched(sphere(25), 3, 3, 3));
  const auto field = vertex_map(mesh);
  const auto handles = field_checks::vertex_vector(mesh);
  const auto points = get(CGAL::vertex_point, mesh);
  compute_geodesic_field(mesh, field, std::vector<typename boost::graph_traits<Mesh>::vertex_descriptor>{handles[7]});
  const Vector_3 source = get(points, handles[7]) - CGAL::ORIGIN;
  for(const auto v : vertices(mesh))
  {
    const double cosine = (get(points, v) - CGAL::ORIGIN) * source / 9;
    const double expected = 3 * std::acos((std::max)(-1., (std::min)(1., cosine)));
    BOOST_TEST(std::abs(get(field, v) - expected) < 0.2);
  }
  BOOST_TEST(get(field, handles[7]) == 0);
}

BOOST_AUTO_TEST_CASE(geodesic_distances_do_not_mix_components)
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
    return field_checks::values_of(mesh, field);
  };
  const Surface_mesh::Vertex_index source(5), other_source(one.points.size() + 8), isolated(both.points.size() - 1);
  std::vector<double> expected = distances(one, {source});
  const std::vector<double> other_expected = distances(other, {Surface_mesh::Vertex_index(8)});
  expected.insert(expected.end(), other_expected.begin(), other_expected.end());
  expected.push_back(0);
  BOOST_TEST(field_checks::distance(distances(both, {source, other_source, isolated}), expected) < 1e-6);
}

BOOST_AUTO_TEST_CASE(heights_are_exact)
{
  typedef CGAL::Simple_cartesian<CGAL::Exact_rational> Exact_kernel;
  CGAL::Surface_mesh<Exact_kernel::Point_3> mesh;
  const CGAL::Exact_rational third = CGAL::Exact_rational(1) / 3;
  const auto v = mesh.add_vertex(Exact_kernel::Point_3(third, 2, 5));
  const auto exact = get(CGAL::dynamic_vertex_property_t<CGAL::Exact_rational>(), mesh);
  compute_height_field(mesh, exact, Exact_kernel::Vector_3(1, third, 0));
  BOOST_TEST((get(exact, v) == 1));
  const auto rounded = vertex_map(mesh);
  compute_height_field(mesh, rounded, Exact_kernel::Vector_3(1, third, 0));
  BOOST_TEST(get(rounded, v) == 1);
}

namespace {
constexpr double infinity = std::numeric_limits<double>::infinity();
typedef CGAL::Reeb_graph::internal::scalar_fields::Indexed_surface<Surface_mesh> Indexed_surface;

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
  const auto unit = [&] { return field_checks::random_unit(random); };
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
          : field_checks::with_random_points(
            random_meshes::random_mesh(static_cast<Mesh_class>(number / 2 % number_of_classes), random), random);
      test(with_bad_points(soup, kind, random), random);
    }
}

// The first vertices of the components, fixed.
field_checks::Fixed_values fixed_first_vertices(const Surface_mesh& mesh)
{
  std::vector<std::pair<Surface_mesh::Vertex_index, Surface_mesh::Vertex_index>> pairs;
  find_far_apart_vertices(mesh, std::back_inserter(pairs));
  field_checks::Fixed_values fixed;
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
    field_checks::Fixed_values fixed;
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
      BOOST_TEST(field_checks::fault_of_extrema(soup, fixed, field_checks::values_of(mesh, field)) == "");
      if(weights == Laplacian_weights::UNIFORM)
        BOOST_TEST((report.number_of_bad_faces == 0 && report.added_length == 0));
    }
  });
}

BOOST_AUTO_TEST_CASE(all_fields_are_finite_on_bad_faces)
{
  for_each_bad_mesh([](const Triangle_soup& soup, Random& random) {
    const Surface_mesh mesh = make_mesh<Surface_mesh>(soup);
    const field_checks::Fixed_values fixed = fixed_first_vertices(mesh);
    const auto constraints = field_checks::constraints_of(mesh, fixed);
    std::vector<Surface_mesh::Vertex_index> sources;
    for(const auto& constraint : constraints)
      sources.push_back(constraint.first);
    const auto random_field = vertex_map(mesh), field = vertex_map(mesh);
    for(const auto v : mesh.vertices())
      put(random_field, v, field_checks::random_unit(random));
    for(const auto& compute : std::vector<std::function<Field_report()>>{
          [&] { return compute_poisson_field(mesh, field, random_field, constraints); },
          [&] { return compute_curvature_poisson_field(mesh, field, constraints); },
          [&] { return compute_unit_gradient_field(mesh, random_field, field); },
          [&] { return compute_mean_curvature(mesh, field); },
          [&] { return compute_geodesic_field(mesh, field, sources); }})
    {
      check_report(compute(), mesh);
      check_finite(mesh, field);
    }
    for(const auto v : mesh.vertices())
      BOOST_TEST((get(field, v) >= 0 && (get(field, v) == 0 || fixed.count(v) == 0)));
  });
}

BOOST_AUTO_TEST_CASE(edges_are_no_longer_than_it_takes)
{
  namespace fields = CGAL::Reeb_graph::internal::scalar_fields;
  using fields::operator+;
  for_each_bad_mesh([](const Triangle_soup& soup, Random&) {
    const Surface_mesh mesh = make_mesh<Surface_mesh>(soup);
    Indexed_surface surface(mesh, CGAL::parameters::default_values());
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
      BOOST_TEST(std::abs(fields::length(fields::cross(geometry.edges[0], geometry.edges[1])) - geometry.double_area)
                 < 1e-12 * longest * longest);
    }
  });
}

BOOST_AUTO_TEST_CASE(gradient_and_divergence_are_adjoint_on_bad_faces)
{
  namespace fields = CGAL::Reeb_graph::internal::scalar_fields;
  for_each_bad_mesh([](const Triangle_soup& soup, Random& random) {
    const Surface_mesh mesh = make_mesh<Surface_mesh>(soup);
    Indexed_surface surface(mesh, CGAL::parameters::default_values());
    if(fields::make_triangles_proper(surface).number_of_bad_faces == 0)
      return;
    const auto field = vertex_map(mesh), divergence = vertex_map(mesh);
    const auto vectors = face_vector_map(mesh), gradient = face_vector_map(mesh);
    for(const auto v : mesh.vertices())
      put(field, v, field_checks::random_unit(random));
    for(const auto f : mesh.faces())
      put(vectors, f, Vector_3(field_checks::random_unit(random), field_checks::random_unit(random), 0.5));
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
    return field_checks::values_of(mesh, field);
  };
  const auto compare = [&](const auto& compute, double tolerance) {
    const std::vector<double> values = field_of(soup, compute);
    std::vector<double> bad_values = field_of(bad, compute);
    bad_values.resize(values.size());
    const double largest = *std::max_element(values.begin(), values.end());
    BOOST_TEST(field_checks::distance(values, bad_values) < tolerance * largest);
  };
  const std::vector<std::pair<Surface_mesh::Vertex_index, double>> poles = {{Surface_mesh::Vertex_index(0), 0},
                                                                            {Surface_mesh::Vertex_index(500), 1}};
  const auto cotangent = CGAL::parameters::laplacian_weights(Laplacian_weights::COTANGENT);
  compare([&](const auto& mesh, const auto& map) { compute_harmonic_field(mesh, map, poles, cotangent); }, 1e-2);
  const std::vector<Surface_mesh::Vertex_index> source = {Surface_mesh::Vertex_index(0)};
  compare([&](const auto& mesh, const auto& map) { compute_geodesic_field(mesh, map, source); }, 0.1);
}

BOOST_AUTO_TEST_CASE(marched_distances_are_close_in_the_plane)
{
  namespace fields = CGAL::Reeb_graph::internal::scalar_fields;
  const Surface_mesh mesh = make_mesh<Surface_mesh>(square(20, 0.7));
  const Indexed_surface surface(mesh, CGAL::parameters::default_values());
  std::vector<bool> is_source(mesh.number_of_vertices(), false);
  is_source[215] = true;
  const fields::Marching<Indexed_surface> marching(surface, is_source);
  for(const auto v : mesh.vertices())
  {
    const double expected = length(mesh.point(v) - mesh.point(Surface_mesh::Vertex_index(215)));
    BOOST_TEST(marching.distances()[v] * surface.scale() > expected - 1e-12);
    BOOST_TEST(marching.distances()[v] * surface.scale() < 1.1 * expected + 1e-12);
  }
}

BOOST_AUTO_TEST_CASE(geodesic_distances_far_away)
{
  // a thousand times as far as the heat method sees
  const Triangle_soup soup = field_checks::tube(5, 4000);
  const Surface_mesh mesh = make_mesh<Surface_mesh>(soup);
  const auto field = vertex_map(mesh);
  const Field_report report =
    compute_geodesic_field(mesh, field, std::vector<Surface_mesh::Vertex_index>{Surface_mesh::Vertex_index(0)});
  BOOST_TEST(report.number_of_marched_components == 1u);
  BOOST_TEST(report.added_length == 0);
  for(const auto v : mesh.vertices())
  {
    const double height = mesh.point(v).z() - mesh.point(Surface_mesh::Vertex_index(0)).z();
    BOOST_TEST(get(field, v) > height - 1e-9);
    BOOST_TEST(get(field, v) < 1.1 * height + 3);
  }
}

// Bad input: an exception, and the field as it was.
namespace {
constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();
constexpr double untouched = -77;

typedef Surface_mesh::Property_map<Surface_mesh::Vertex_index, double> Field_map;
typedef std::vector<std::pair<Surface_mesh::Vertex_index, double>> Constraints;

Triangle_soup small_surface() { return generated_surfaces::closed_surface(1, 200); }

Surface_mesh small_mesh() { return make_mesh<Surface_mesh>(small_surface()); }

// A computation of a field of a mesh, with vertex 0 fixed if it needs that.
typedef std::function<void(Surface_mesh&, Field_map)> Computation;

const Constraints fix_vertex_0 = {{Surface_mesh::Vertex_index(0), 1}};
const Constraints poles = {{Surface_mesh::Vertex_index(0), 0}, {Surface_mesh::Vertex_index(90), 1}};
const std::vector<Surface_mesh::Vertex_index> source_0 = {Surface_mesh::Vertex_index(0)};

template <class Exception>
void check_throws(Surface_mesh mesh, const Computation& compute, const std::string& message)
{
  const Field_map field = mesh.add_property_map<Surface_mesh::Vertex_index, double>("v:field", untouched).first;
  std::string what;
  BOOST_CHECK_THROW(
    try { compute(mesh, field); } catch(const Exception& error) {
      what = error.what();
      throw;
    },
    Exception);
  BOOST_TEST(what.find(message) != std::string::npos, what);
  for(const auto v : mesh.vertices())
    BOOST_TEST(field[v] == untouched);
}

void compute_harmonic_with_constraints(Surface_mesh& mesh, Field_map field)
{
  compute_harmonic_field(mesh, field, fix_vertex_0);
}

void compute_curvature_poisson(Surface_mesh& mesh, Field_map field)
{
  compute_curvature_poisson_field(mesh, field, fix_vertex_0);
}

void compute_geodesic(Surface_mesh& mesh, Field_map field) { compute_geodesic_field(mesh, field, source_0); }

void compute_unit_gradient(Surface_mesh& mesh, Field_map field)
{
  const auto scalar_map = vertex_map(mesh);
  for(const auto v : mesh.vertices())
    put(scalar_map, v, static_cast<double>(v.idx()));
  compute_unit_gradient_field(mesh, scalar_map, field);
}

void compute_divergence_of_zero(Surface_mesh& mesh, Field_map field)
{
  const auto vectors = face_vector_map(mesh);
  for(const auto f : mesh.faces())
    put(vectors, f, Vector_3(0, 0, 0));
  compute_divergence(mesh, vectors, field);
}

const std::vector<Computation> all_computations = {
  compute_harmonic_with_constraints,
  [](Surface_mesh& mesh, Field_map field) { compute_harmonic_field_between_far_apart_vertices(mesh, field); },
  compute_curvature_poisson,
  compute_unit_gradient,
  compute_geodesic,
  compute_divergence_of_zero,
  [](Surface_mesh& mesh, Field_map field) { compute_mean_curvature(mesh, field); }};

// those that need at least one given value per component
const std::vector<Computation> constrained_computations = {compute_harmonic_with_constraints, compute_curvature_poisson,
                                                           compute_geodesic};
} // namespace

BOOST_AUTO_TEST_CASE(bad_meshes_are_refused)
{
  Surface_mesh quadrangle;
  std::vector<Surface_mesh::Vertex_index> corners;
  for(int i = 0; i < 4; ++i)
    corners.push_back(quadrangle.add_vertex(mesh_builders::Point(i / 2, i % 2, 0)));
  quadrangle.add_face(corners[0], corners[1], corners[3], corners[2]);

  Surface_mesh bow_tie =
    make_mesh<Surface_mesh>({{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {0, -1, 0}}, {{{0, 1, 2}}, {{0, 3, 4}}}});

  Triangle_soup soup = small_surface();
  const std::size_t bad_vertex = soup.triangles[11][1];
  soup.points[bad_vertex] = {0, not_a_number, 0};
  const Surface_mesh not_finite = make_mesh<Surface_mesh>(soup);

  for(const Computation& compute : all_computations)
  {
    check_throws<Non_triangular_face_error>(quadrangle, compute, "face 0 ");
    check_throws<Non_manifold_vertex_error>(bow_tie, compute, "vertex 0 ");
    check_throws<Non_finite_point_error>(not_finite, compute, "vertex " + std::to_string(bad_vertex) + " ");
  }
}

BOOST_AUTO_TEST_CASE(uniform_weights_need_no_area)
{
  Surface_mesh mesh = make_mesh<Surface_mesh>(field_checks::stretched(small_surface(), 0, 0, 0));
  const auto field = vertex_map(mesh);
  compute_harmonic_field_between_far_apart_vertices(mesh, field,
                                                    CGAL::parameters::laplacian_weights(Laplacian_weights::UNIFORM));
  const auto values = field_checks::values_of(mesh, field);
  BOOST_TEST(*std::min_element(values.begin(), values.end()) == 0);
  BOOST_TEST(*std::max_element(values.begin(), values.end()) == 1);
}

BOOST_AUTO_TEST_CASE(components_without_a_given_value_are_named)
{
  Triangle_soup soup = small_surface();
  const std::size_t n = soup.points.size();
  for(const auto& p : small_surface().points)
    soup.points.push_back({p[0] + 9, p[1], p[2]});
  for(const auto& t : small_surface().triangles)
    soup.triangles.push_back({t[0] + n, t[1] + n, t[2] + n});
  Surface_mesh isolated = small_mesh();
  isolated.add_vertex(mesh_builders::Point(5, 5, 5));
  for(const Computation& compute : constrained_computations)
  {
    const std::string name = "component 1, that of vertex " + std::to_string(n) + ",";
    check_throws<Unconstrained_component_error>(make_mesh<Surface_mesh>(soup), compute, name);
    check_throws<Unconstrained_component_error>(isolated, compute, name);
  }
}

BOOST_AUTO_TEST_CASE(bad_constraints_are_refused)
{
  const Surface_mesh::Vertex_index v(3);
  const auto with = [](const Constraints& constraints) {
    return [constraints](Surface_mesh& mesh, Field_map field) { compute_harmonic_field(mesh, field, constraints); };
  };
  check_throws<Contradictory_constraints_error>(small_mesh(), with({{v, 1}, {v, 2}}), "vertex 3 ");
  check_throws<Non_finite_scalar_error>(small_mesh(), with({{v, infinity}}), "vertex 3 ");
  check_throws<Non_finite_scalar_error>(small_mesh(), with({{v, not_a_number}}), "vertex 3 ");
  check_throws<Unconstrained_component_error>(small_mesh(), with({}), "component 0,");
  check_throws<Unknown_vertex_error>(small_mesh(), with({{Surface_mesh::null_vertex(), 1}}), "vertex");
  check_throws<Unknown_vertex_error>(small_mesh(), with({{Surface_mesh::Vertex_index(1000000), 1}}), "vertex");
  Surface_mesh mesh = small_mesh();
  const auto removed = mesh.add_vertex();
  mesh.remove_vertex(removed);
  check_throws<Unknown_vertex_error>(mesh, with({{removed, 1}}), "vertex");
  const double next = std::nextafter(1., 2.);
  check_throws<Scalar_resolution_error>(small_mesh(), with({{v, 1}, {Surface_mesh::Vertex_index(90), next}}), "vertex");
}

BOOST_AUTO_TEST_CASE(bad_fields_vectors_and_directions_are_refused)
{
  const auto compute_unit_gradient_of = [](double value) {
    return [value](Surface_mesh& mesh, Field_map field) {
      const auto scalar_map = vertex_map(mesh);
      for(const auto v : mesh.vertices())
        put(scalar_map, v, v.idx() == 5 ? value : 0);
      compute_unit_gradient_field(mesh, scalar_map, field);
    };
  };
  check_throws<Non_finite_scalar_error>(small_mesh(), compute_unit_gradient_of(not_a_number), "vertex 5 ");
  check_throws<Non_finite_scalar_error>(small_mesh(), compute_unit_gradient_of(infinity), "vertex 5 ");
  const auto compute_divergence_of_infinity = [](Surface_mesh& mesh, Field_map field) {
    const auto vectors = face_vector_map(mesh);
    for(const auto f : mesh.faces())
      put(vectors, f, Vector_3(0, f.idx() == 6 ? infinity : 0, 0));
    compute_divergence(mesh, vectors, field);
  };
  check_throws<Non_finite_vector_error>(small_mesh(), compute_divergence_of_infinity, "face 6 ");
  const auto compute_height_along = [](const Vector_3& direction) {
    return [direction](Surface_mesh& mesh, Field_map field) { compute_height_field(mesh, field, direction); };
  };
  check_throws<Direction_error>(small_mesh(), compute_height_along(Vector_3(0, 0, 0)), "direction");
  check_throws<Direction_error>(small_mesh(), compute_height_along(Vector_3(0, not_a_number, 1)), "direction");
  Triangle_soup soup = small_surface();
  soup.points[4] = {infinity, 0, 0};
  check_throws<Non_finite_scalar_error>(make_mesh<Surface_mesh>(soup), compute_height_along(Vector_3(1, 0, 0)),
                                        "vertex 4 ");
}

namespace {
// Computes a field, or what comes with it, with a callback.
typedef std::function<void(Surface_mesh&, Field_map, const std::function<bool(double)>&)> Cancellable_computation;

std::vector<Cancellable_computation> cancellable_computations()
{
  const auto with = [](const auto& compute) {
    return [compute](Surface_mesh& mesh, Field_map field, const std::function<bool(double)>& callback) {
      compute(mesh, field, CGAL::parameters::callback(callback));
    };
  };
  const auto indices_of = [](const Surface_mesh& mesh) {
    const auto indices = vertex_map(mesh);
    for(const auto v : mesh.vertices())
      put(indices, v, static_cast<double>(v.idx()));
    return indices;
  };
  return {
    with([](auto& mesh, auto field, auto np) { compute_harmonic_field_between_far_apart_vertices(mesh, field, np); }),
    with([](auto& mesh, auto field, auto np) { compute_harmonic_field_between_borders(mesh, field, np); }),
    with([](auto& mesh, auto field, auto np) { compute_curvature_poisson_field(mesh, field, fix_vertex_0, np); }),
    with(
      [=](auto& mesh, auto field, auto np) { compute_poisson_field(mesh, field, indices_of(mesh), fix_vertex_0, np); }),
    with([=](auto& mesh, auto field, auto np) { compute_unit_gradient_field(mesh, indices_of(mesh), field, np); }),
    with([](auto& mesh, auto field, auto np) { compute_geodesic_field(mesh, field, source_0, np); }),
    with([](auto& mesh, auto field, auto np) { compute_mean_curvature(mesh, field, np); }),
    with([](auto& mesh, auto field, auto np) { compute_height_field(mesh, field, Vector_3(1, 2, 3), np); }),
    with([](auto& mesh, auto field, auto np) {
      const auto vectors = face_vector_map(mesh);
      for(const auto f : mesh.faces())
        put(vectors, f, Vector_3(0, 0, 0));
      compute_divergence(mesh, vectors, field, np);
    }),
    with([=](auto& mesh, auto, auto np) { compute_gradient(mesh, indices_of(mesh), face_vector_map(mesh), np); }),
    with([](auto& mesh, auto, auto np) {
      std::vector<std::pair<Surface_mesh::Vertex_index, Surface_mesh::Vertex_index>> pairs;
      find_far_apart_vertices(mesh, std::back_inserter(pairs), np);
    })};
}
} // namespace

BOOST_AUTO_TEST_CASE(computations_can_be_cancelled_at_each_step)
{
  Triangle_soup bad = small_surface();
  bad.points[bad.triangles[11][1]] = bad.points[bad.triangles[11][0]];
  for(const Surface_mesh& original : {small_mesh(), make_mesh<Surface_mesh>(bad)})
    for(const Cancellable_computation& compute : cancellable_computations())
    {
      std::vector<double> fractions;
      const auto compute_up_to = [&](Surface_mesh& mesh, Field_map field, std::size_t number_of_calls) {
        fractions.clear();
        compute(mesh, field, [&](double fraction) {
          fractions.push_back(fraction);
          return fractions.size() < number_of_calls;
        });
      };
      Surface_mesh mesh = original;
      const Field_map field_map = mesh.add_property_map<Surface_mesh::Vertex_index, double>("v:field", 0).first;
      compute_up_to(mesh, field_map, 1000);
      BOOST_TEST(fractions.size() > 2u);
      BOOST_TEST(fractions.front() == 0);
      BOOST_TEST(fractions.back() == 1);
      BOOST_TEST(std::is_sorted(fractions.begin(), fractions.end()));
      const std::size_t number_of_calls = fractions.size();
      // not any more when the field has been written
      BOOST_CHECK_NO_THROW(compute_up_to(mesh, field_map, number_of_calls));
      for(std::size_t i = 1; i < number_of_calls; ++i)
        check_throws<Cancelled_error>(
          original, [&](Surface_mesh& m, Field_map field) { compute_up_to(m, field, i); }, "cancelled");
    }
}

namespace {
struct Failing_solver : CGAL::Eigen_solver_traits<Eigen::SimplicialLDLT<CGAL::Eigen_sparse_matrix<double>::EigenType>>
{
  bool factor(const Matrix&, NT&) { return false; }
};
} // namespace

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
  const Triangle_soup needles = field_checks::stretched(small_surface(), 1, 1e-9, 1e-9);
  const Surface_mesh mesh = make_mesh<Surface_mesh>(needles);
  const auto field = vertex_map(mesh);
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

// The error counts as a part of the range, wherever the fixed value lies.
BOOST_AUTO_TEST_CASE(large_poisson_fields_are_those_that_factorization_finds)
{
  Surface_mesh mesh;
  mesh_builders::build(mesh, generated_surfaces::closed_surface(2, 6000));
  const Field_map field = mesh.add_property_map<Surface_mesh::Vertex_index, double>("v:field").first;
  const Field_map direct_field = mesh.add_property_map<Surface_mesh::Vertex_index, double>("v:direct").first;
  const auto np = CGAL::parameters::sparse_linear_solver(CGAL::Reeb_graph::internal::scalar_fields::Default_solver());
  for(const double source_value : {0., 1e4})
  {
    const std::vector<std::pair<Surface_mesh::Vertex_index, double>> source = {
      {Surface_mesh::Vertex_index(7), source_value}};
    const Field_report report = compute_curvature_poisson_field(mesh, field, source);
    BOOST_TEST(report.number_of_iterations > 0u);
    BOOST_TEST(compute_curvature_poisson_field(mesh, direct_field, source, np).number_of_iterations == 0u);
    double range = 0, difference = 0;
    for(const auto v : mesh.vertices())
    {
      range = (std::max)(range, std::abs(direct_field[v] - source_value));
      difference = (std::max)(difference, std::abs(field[v] - direct_field[v]));
    }
    BOOST_TEST(difference < 1e-9 * range);
  }
}

BOOST_AUTO_TEST_CASE(a_failing_solver_is_reported)
{
  const auto compute = [](Surface_mesh& mesh, Field_map field) {
    compute_harmonic_field_between_far_apart_vertices(mesh, field,
                                                      CGAL::parameters::sparse_linear_solver(Failing_solver()));
  };
  check_throws<Linear_solver_error>(small_mesh(), compute, "solver");
}

BOOST_AUTO_TEST_SUITE_END()
