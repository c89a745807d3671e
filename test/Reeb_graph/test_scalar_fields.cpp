// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#include <boost/test/unit_test.hpp>

#include "field_samples.h"

#include <CGAL/Reeb_graph/fields/gradient_and_divergence.h>
#include <CGAL/Reeb_graph/fields/harmonic_field.h>
#include <CGAL/Reeb_graph/fields/height_field.h>
#include <CGAL/Reeb_graph/fields/internal/solve.h>
#include <CGAL/Reeb_graph/fields/poisson_field.h>

#include <CGAL/Exact_rational.h>

#include <boost/mpl/list.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

// Gradient, divergence, and the fields that are made of them; heights.

BOOST_AUTO_TEST_SUITE(test_scalar_fields)

using namespace CGAL::Reeb_graph;
using namespace field_samples;
using mesh_builders::make_mesh;
using mesh_builders::Polyhedron;

typedef boost::mpl::list<Surface_mesh, Polyhedron> Meshes;

namespace {
template <class Mesh>
Vector_3 normal_of(typename boost::graph_traits<Mesh>::face_descriptor f, const Mesh& mesh)
{
  const auto points = get(CGAL::vertex_point, mesh);
  const auto h = halfedge(f, mesh);
  return CGAL::cross_product(get(points, target(h, mesh)) - get(points, source(h, mesh)),
                             get(points, target(next(h, mesh), mesh)) - get(points, source(h, mesh)));
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
    const Mesh mesh = make_mesh<Mesh>(stretched(noisy_surface(), scale, scale, scale));
    Random random(6);
    const auto field = vertex_map(mesh), divergence = vertex_map(mesh);
    for(const auto v : vertices(mesh))
      put(field, v, random_unit(random));
    const auto vectors = face_vector_map(mesh), gradient = face_vector_map(mesh);
    for(const auto f : faces(mesh))
      put(vectors, f, Vector_3(random_unit(random), random_unit(random), 0.5));
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
    const Mesh mesh = make_mesh<Mesh>(stretched(sphere(30), radius, radius, radius));
    const auto curvature = vertex_map(mesh);
    compute_mean_curvature(mesh, curvature);
    for(const auto v : vertices(mesh))
      BOOST_TEST(std::abs(get(curvature, v) * radius - 1) < 0.05);
  }
}

BOOST_AUTO_TEST_CASE(the_mean_curvature_of_tori_converges)
{
  const double order = mean_order([](std::size_t size) {
    const Surface_mesh mesh = make_mesh<Surface_mesh>(band(2 * size, size, 0, torus_point));
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
    const Constraints constraints = {{fixed, mesh.point(fixed).z()}};
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
    const Mesh mesh = make_mesh<Mesh>(stretched(noisy_surface(), scale, scale, scale));
    const auto curvature = vertex_map(mesh), field = vertex_map(mesh), expected = vertex_map(mesh);
    const auto constraints = constraints_of(mesh, {{3, 4.5}});
    compute_mean_curvature(mesh, curvature);
    compute_poisson_field(mesh, expected, curvature, constraints);
    compute_curvature_poisson_field(mesh, field, constraints);
    const auto values = values_of(mesh, field);
    BOOST_TEST(distance(values, values_of(mesh, expected)) < 1e-8 * scale);
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

// It does not depend on the unit of the field, even where differences of values are infinite.
BOOST_AUTO_TEST_CASE(the_unit_gradient_field_of_the_largest_and_of_the_smallest_values)
{
  const Surface_mesh mesh = make_mesh<Surface_mesh>(square(20, 0));
  const auto field = vertex_map(mesh), unit_field = vertex_map(mesh), expected = vertex_map(mesh);
  const auto compute = [&](int exponent, const auto& result) {
    for(const auto v : vertices(mesh))
      put(field, v, std::scalbn(std::sin(7 * mesh.point(v).x() + 4 * mesh.point(v).y()), exponent));
    compute_unit_gradient_field(mesh, field, result);
  };
  compute(0, expected);
  for(const int exponent : {1023, -900})
  {
    compute(exponent, unit_field);
    for(const auto v : vertices(mesh))
      BOOST_TEST(get(unit_field, v) == get(expected, v));
  }
}

BOOST_AUTO_TEST_CASE_TEMPLATE(the_gradient_of_the_unit_gradient_field_is_about_one, Mesh, Meshes)
{
  const Mesh mesh = make_mesh<Mesh>(tube(30, 60));
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

BOOST_AUTO_TEST_CASE(differences_of_fixed_values_can_be_infinite)
{
  const double unit = std::ldexp(1, 1023);
  const Surface_mesh mesh = make_mesh<Surface_mesh>(noisy_surface());
  const auto field = vertex_map(mesh), large_field = vertex_map(mesh);
  const Surface_mesh::Vertex_index low(0), high(400);
  compute_harmonic_field(mesh, field, Constraints{{low, -1.5}, {high, 1.75}});
  compute_harmonic_field(mesh, large_field, Constraints{{low, -1.5 * unit}, {high, 1.75 * unit}});
  for(const auto v : vertices(mesh))
    BOOST_TEST(std::abs(get(large_field, v) / unit - get(field, v)) < 1e-12);
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

BOOST_AUTO_TEST_SUITE_END()
