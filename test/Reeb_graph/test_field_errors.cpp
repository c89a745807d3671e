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
#include <CGAL/Reeb_graph/fields/height_field.h>
#include <CGAL/Reeb_graph/fields/poisson_field.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <iterator>
#include <limits>
#include <string>
#include <utility>
#include <vector>

// Bad input to scalar fields, solvers that fail, and cancelling: an exception, and the field as it was.

BOOST_AUTO_TEST_SUITE(test_field_errors)

using namespace CGAL::Reeb_graph;
using namespace field_samples;
using mesh_builders::make_mesh;

namespace {
constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();
constexpr double untouched = -77;

// A computation of a field of a mesh, with vertex 0 fixed if it needs that.
typedef std::function<void(Surface_mesh&, Field_map)> Computation;

const Constraints fix_vertex_0 = {{Surface_mesh::Vertex_index(0), 1}};
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
  check_throws<Parameter_error>(small_mesh(), compute_height_along(Vector_3(0, 0, 0)), "direction");
  check_throws<Parameter_error>(small_mesh(), compute_height_along(Vector_3(0, not_a_number, 1)), "direction");
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

BOOST_AUTO_TEST_CASE(a_failing_solver_is_reported)
{
  const auto compute = [](Surface_mesh& mesh, Field_map field) {
    compute_harmonic_field_between_far_apart_vertices(mesh, field,
                                                      CGAL::parameters::sparse_linear_solver(Failing_solver()));
  };
  check_throws<Linear_solver_error>(small_mesh(), compute, "solver");
}

BOOST_AUTO_TEST_SUITE_END()
