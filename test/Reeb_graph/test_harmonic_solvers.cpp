// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#include <boost/test/unit_test.hpp>

#include "computed_fields.h"
#include "mesh_builders.h"
#include "random_meshes.h"

#include <CGAL/Reeb_graph/fields/harmonic_field.h>
#include <CGAL/Reeb_graph/fields/internal/Dirichlet_problem.h>
#include <CGAL/Reeb_graph/fields/internal/solve.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

// The equations of harmonic fields: solvers of the user, multigrid, and factorization where that fails.

BOOST_AUTO_TEST_SUITE(test_harmonic_solvers)

using namespace computed_fields;
using CGAL::Reeb_graph::compute_harmonic_field_between;
using CGAL::Reeb_graph::compute_harmonic_field_between_far_apart_vertices;

BOOST_AUTO_TEST_CASE(any_solver_can_be_used)
{
  typedef CGAL::Eigen_sparse_matrix<double>::EigenType Eigen_matrix;
  typedef CGAL::Eigen_solver_traits<Eigen::SimplicialLLT<Eigen_matrix>> Solver;
  typedef CGAL::Eigen_solver_traits<
    Eigen::ConjugateGradient<CGAL::Eigen_sparse_symmetric_matrix<double>::EigenType, Eigen::Lower | Eigen::Upper>>
    Iterative_solver;
  Surface_mesh mesh;
  mesh_builders::build(mesh, generated_surfaces::closed_surface(1, 500));
  const Surface_mesh::Vertex_index lowest(0), highest(300);
  for(const Laplacian_weights weights : all_weights)
  {
    auto expected = get(CGAL::dynamic_vertex_property_t<double>(), mesh);
    auto found = get(CGAL::dynamic_vertex_property_t<double>(), mesh);
    auto found_iteratively = get(CGAL::dynamic_vertex_property_t<double>(), mesh);
    const auto np = laplacian_weights(weights);
    compute_harmonic_field_between(mesh, expected, lowest, highest, np);
    compute_harmonic_field_between(mesh, found, lowest, highest, np.sparse_linear_solver(Solver()));
    compute_harmonic_field_between(mesh, found_iteratively, lowest, highest,
                                   np.sparse_linear_solver(Iterative_solver()));
    for(const auto v : mesh.vertices())
    {
      BOOST_TEST(std::abs(get(expected, v) - get(found, v)) < 1e-10);
      BOOST_TEST(std::abs(get(expected, v) - get(found_iteratively, v)) < 1e-6);
    }
  }
}

namespace {
typedef CGAL::Eigen_sparse_matrix<double>::EigenType Eigen_matrix;

// Solves for the diagonal alone: far from a solution, and too far for the iteration that starts from it.
class Diagonal_solver : public CGAL::Eigen_solver_traits<Eigen::SimplicialLDLT<Eigen_matrix>>
{
public:
  bool factor(const Matrix& matrix, NT& denominator)
  {
    denominator = 1;
    diagonal_ = matrix.eigen_object().diagonal();
    return true;
  }

  bool linear_solver(const Vector& b, Vector& x)
  {
    x = b.cwiseQuotient(diagonal_);
    return true;
  }

private:
  Eigen::VectorXd diagonal_;
};
} // namespace

BOOST_AUTO_TEST_CASE(where_iteration_fails_the_unsymmetric_equations_are_solved)
{
  Surface_mesh mesh;
  mesh_builders::build(mesh, generated_surfaces::closed_surface(1, 5000));
  const Surface_mesh::Vertex_index lowest(0), highest(300);
  auto expected = get(CGAL::dynamic_vertex_property_t<double>(), mesh);
  auto found = get(CGAL::dynamic_vertex_property_t<double>(), mesh);
  compute_harmonic_field_between(mesh, expected, lowest, highest);
  compute_harmonic_field_between(mesh, found, lowest, highest,
                                 CGAL::parameters::sparse_linear_solver(Diagonal_solver()));
  for(const auto v : mesh.vertices())
    BOOST_TEST(std::abs(get(expected, v) - get(found, v)) < 1e-10);
}

namespace {
typedef CGAL::Reeb_graph::Field_report Field_report;

// The poles are the two vertices that are farthest apart, in each component.
struct Large_field
{
  Field_report report;
  std::vector<double> values;

  template <class NamedParameters>
  Large_field(const Surface_mesh& mesh, const NamedParameters& np)
  {
    auto field_map = get(CGAL::dynamic_vertex_property_t<double>(), mesh);
    report = compute_harmonic_field_between_far_apart_vertices(mesh, field_map, np);
    values = values_of(mesh, field_map);
  }
};

auto factorizing(Laplacian_weights weights)
{
  return laplacian_weights(weights).sparse_linear_solver(CGAL::Reeb_graph::internal::scalar_fields::Default_solver());
}

// Large enough for multigrid.
std::vector<std::pair<std::string, Triangle_soup>> large_surfaces()
{
  Random random(5);
  const Triangle_soup soup = generated_surfaces::closed_surface(3, 6000);
  Triangle_soup two_components = band(120, 60, 0.5, sphere_point);
  for(const auto& t : soup.triangles)
    two_components.triangles.push_back(
      {t[0] + two_components.points.size(), t[1] + two_components.points.size(), t[2] + two_components.points.size()});
  two_components.points.insert(two_components.points.end(), soup.points.begin(), soup.points.end());
  return {{"genus 3", soup},
          {"noisy", with_noise(soup, 0.3, random)},
          {"flat", stretched(soup, 1, 0.1, 1)},
          {"tube", tube(6, 2000)},
          {"band", band(120, 60, 0.5, sphere_point)},
          {"two components", two_components},
          {"hub", with_random_points(random_meshes::bipyramid(6000), random)}};
}
} // namespace

BOOST_AUTO_TEST_CASE(the_steps_of_multigrid_hardly_grow_with_the_mesh)
{
  for(const Laplacian_weights weights : all_weights)
    BOOST_TEST_CONTEXT("weights " << static_cast<int>(weights))
    {
      std::vector<std::size_t> numbers_of_steps;
      for(const std::size_t size : {6000, 24000, 96000})
      {
        Surface_mesh mesh;
        mesh_builders::build(mesh, generated_surfaces::closed_surface(3, size));
        numbers_of_steps.push_back(Large_field(mesh, laplacian_weights(weights)).report.number_of_iterations);
      }
      BOOST_TEST(numbers_of_steps.front() > 0u);
      BOOST_TEST(numbers_of_steps.back() <= 18u);
      BOOST_TEST(numbers_of_steps.back() <= numbers_of_steps.front() + 5);
    }
}

BOOST_AUTO_TEST_CASE(multigrid_finds_the_field_that_factorization_finds)
{
  for(const auto& [name, soup] : large_surfaces())
    for(const Laplacian_weights weights : all_weights)
      BOOST_TEST_CONTEXT(name << ", weights " << static_cast<int>(weights))
      {
        Surface_mesh mesh;
        mesh_builders::build(mesh, soup);
        const Large_field field(mesh, laplacian_weights(weights)), direct_field(mesh, factorizing(weights));
        BOOST_TEST(direct_field.report.number_of_iterations == 0u);
        if(name != "hub") // all depends on it in the same way, so that the matrix hardly gets smaller
          BOOST_TEST(field.report.number_of_iterations > 0u);
        BOOST_TEST(distance(field.values, direct_field.values) < 1e-9);
        BOOST_TEST((Large_field(mesh, laplacian_weights(weights)).values == field.values));
        Fixed_values poles;
        for(const auto& pair : far_apart_vertices(soup))
        {
          poles[pair.first] = 0;
          poles[pair.second] = 1;
        }
        BOOST_TEST(fault_of_extrema(soup, poles, field.values) == "");
      }
}

BOOST_AUTO_TEST_CASE(a_solution_after_half_a_step_is_kept)
{
  typedef std::vector<double> Values;
  // x / 4 = b without a preconditioner: after the first half of a step, the residual is exactly zero.
  struct System
  {
    void multiply(const Values& x, Values& product) const
    {
      std::transform(x.begin(), x.end(), product.begin(), [](double value) { return value / 4; });
    }

    void compute_residual(const Values& x, Values& residual) const
    {
      multiply(x, residual);
      std::transform(residual.begin(), residual.end(), right_side.begin(), residual.begin(),
                     [](double product, double value) { return value - product; });
    }

    void precondition(const Values& residual, Values& correction) const { correction = residual; }

    Values right_side;
  };
  System system = {{1, -2, 3}};
  namespace internal = CGAL::Reeb_graph::internal;
  const auto solution =
    internal::scalar_fields::solve_iteratively(system, system.right_side, {1e-12, 0}, 10, internal::No_progress());
  BOOST_TEST(solution.is_accurate);
  BOOST_TEST(solution.number_of_steps == 1);
  BOOST_TEST(solution.values == Values({4, -8, 12}), boost::test_tools::per_element());
}

BOOST_AUTO_TEST_CASE(where_multigrid_fails_a_matrix_is_factorized)
{
  Surface_mesh mesh;
  mesh_builders::build(mesh, stretched(tube(10, 1000), 1, 1e-9, 1e3));
  for(const Laplacian_weights weights : {Laplacian_weights::MEAN_VALUE, Laplacian_weights::COTANGENT})
  {
    const Large_field field(mesh, laplacian_weights(weights));
    BOOST_TEST(field.report.number_of_iterations == 0u);
    BOOST_TEST((field.values == Large_field(mesh, factorizing(weights)).values));
  }
}

BOOST_AUTO_TEST_CASE(a_large_mesh_with_all_values_given_has_nothing_to_solve)
{
  const Triangle_soup soup = generated_surfaces::closed_surface(0, 6000);
  Fixed_values fixed;
  for(std::size_t v = 0; v < soup.points.size(); ++v)
    fixed[v] = static_cast<double>(v % 7);
  const std::vector<double> values = harmonic<double>(soup, fixed);
  for(const auto& [v, value] : fixed)
    BOOST_TEST(values[v] == value);
}

BOOST_AUTO_TEST_CASE(a_larger_tolerance_takes_fewer_steps)
{
  Surface_mesh mesh;
  mesh_builders::build(mesh, generated_surfaces::closed_surface(3, 6000));
  for(const Laplacian_weights weights : all_weights)
  {
    const Large_field field(mesh, laplacian_weights(weights));
    const auto with_tolerance = [&](double tolerance) {
      return Large_field(mesh, laplacian_weights(weights).solver_tolerance(tolerance));
    };
    const Large_field rough_field = with_tolerance(1e-4);
    BOOST_TEST(rough_field.report.number_of_iterations < field.report.number_of_iterations);
    BOOST_TEST(distance(field.values, rough_field.values) < 1e-3);
    BOOST_TEST((rough_field.values != field.values));
    BOOST_TEST((with_tolerance(1e-12).values == field.values));
    for(const double tolerance : {0., -1e-12, std::nan(""), HUGE_VAL})
      BOOST_CHECK_THROW(with_tolerance(tolerance), CGAL::Reeb_graph::Solver_tolerance_error);
  }
}

BOOST_AUTO_TEST_SUITE_END()
