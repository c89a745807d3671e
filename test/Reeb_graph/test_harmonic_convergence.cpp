// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#include <boost/test/unit_test.hpp>

#include "computed_fields.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

// Harmonic fields are close to the functions that they stand for.

BOOST_AUTO_TEST_SUITE(test_harmonic_convergence)

using namespace computed_fields;

namespace {
// The largest error of the harmonic field on a band.
template <class Point_function, class Solution>
double error_on_band(std::size_t size,
                     double randomness,
                     Laplacian_weights weights,
                     const Point_function& point,
                     const Solution& solution)
{
  const Triangle_soup soup = band(2 * size, size, randomness, point);
  Fixed_values fixed;
  for(std::size_t i = 0; i < 2 * size; ++i)
  {
    fixed[i] = 0;
    fixed[soup.points.size() - 1 - i] = 1;
  }
  const std::vector<double> values = harmonic<double>(soup, fixed, weights);
  double error = 0;
  for(std::size_t v = 0; v < values.size(); ++v)
    error = (std::max)(error, std::abs(values[v] - solution(soup.points[v])));
  return error;
}

// The mean order at which the error vanishes while the edges are halved twice.
template <class Point_function, class Solution>
double order_on_band(double randomness,
                     Laplacian_weights weights,
                     const Point_function& point,
                     const Solution& solution)
{
  return std::log2(error_on_band(12, randomness, weights, point, solution)
                   / error_on_band(48, randomness, weights, point, solution))
       / 2;
}

double linear_solution(double parameter) { return (1 + parameter / half_length) / 2; }

double cylinder_solution(const std::array<double, 3>& p) { return linear_solution(p[2]); }

double sphere_solution(const std::array<double, 3>& p)
{
  return linear_solution(std::log(std::tan(std::acos(p[2]) / 2)));
}

double torus_solution(const std::array<double, 3>& p)
{
  const double along = std::atan2(p[2], std::hypot(p[0], p[1]) - 2);
  return linear_solution(2 / std::sqrt(3.) * std::atan(std::tan(along / 2) / std::sqrt(3.)));
}

// The same bands, but with rows that are not in proportion.
template <class Point_function>
auto graded(const Point_function& point)
{
  return [point](double angle, double t) { return point(angle, (t + t * t) / 2); };
}
} // namespace

BOOST_AUTO_TEST_CASE(harmonic_fields_are_exact_on_cylinders)
{
  for(const Laplacian_weights weights : all_weights)
    BOOST_TEST(error_on_band(10, 0, weights, cylinder_point, cylinder_solution) < 1e-12);
}

BOOST_AUTO_TEST_CASE(harmonic_fields_converge_with_the_second_order)
{
  for(const Laplacian_weights weights : {Laplacian_weights::MEAN_VALUE, Laplacian_weights::COTANGENT})
  {
    BOOST_TEST(order_on_band(0, weights, sphere_point, sphere_solution) > 1.8);
    BOOST_TEST(order_on_band(0, weights, torus_point, torus_solution) > 1.8);
  }
  BOOST_TEST(error_on_band(10, 0, Laplacian_weights::UNIFORM, sphere_point, sphere_solution) < 1e-12);
  BOOST_TEST(order_on_band(0, Laplacian_weights::COTANGENT, graded(sphere_point), sphere_solution) > 1.8);
  BOOST_TEST(order_on_band(0, Laplacian_weights::COTANGENT, graded(torus_point), torus_solution) > 1.8);
}

BOOST_AUTO_TEST_CASE(harmonic_fields_are_close_on_irregular_meshes)
{
  BOOST_TEST(order_on_band(0.3, Laplacian_weights::COTANGENT, graded(sphere_point), sphere_solution) > 0.8);
  BOOST_TEST(order_on_band(0.3, Laplacian_weights::COTANGENT, graded(torus_point), torus_solution) > 0.8);
  // mean values and uniform weights do not converge there
  BOOST_TEST(error_on_band(48, 0.3, Laplacian_weights::MEAN_VALUE, sphere_point, sphere_solution) < 0.02);
  BOOST_TEST(error_on_band(48, 0.3, Laplacian_weights::MEAN_VALUE, torus_point, torus_solution) < 0.02);
}

BOOST_AUTO_TEST_SUITE_END()
