// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#include <boost/test/unit_test.hpp>

#include "curve_samples.h"
#include "cut_mesh_checks.h"

#include <CGAL/Exact_rational.h>
#include <CGAL/Polygon_mesh_processing/repair.h>
#include <CGAL/Reeb_graph/curves/branch_curves.h>
#include <CGAL/Reeb_graph/curves/cutting_system.h>
#include <CGAL/Reeb_graph/curves/pants_decomposition.h>
#include <CGAL/Reeb_graph/scalar_maps.h>
#include <CGAL/boost/graph/generators.h>

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <numeric>
#include <vector>

// The named parameters that choose the curves, other orders and number types, and meshes with a history.

BOOST_AUTO_TEST_SUITE(test_curve_parameters)

using namespace cut_mesh_checks;
using curve_samples::Sample;
using mesh_builders::Polyhedron;
using mesh_builders::Surface_mesh;

namespace {
typedef std::vector<CGAL::Reeb_graph::Curve<Surface_mesh::Halfedge_index>> Curves;

template <class NamedParameters>
Curves pants_of(Surface_mesh& mesh, const std::vector<double>& values, const NamedParameters& np)
{
  Curves curves;
  CGAL::Reeb_graph::pants_decomposition(mesh, CGAL::Reeb_graph::make_scalar_map(mesh, values),
                                        std::back_inserter(curves), np);
  return curves;
}

template <class NamedParameters>
Curves pants_of(const Sample& sample, const NamedParameters& np)
{
  auto mesh = curve_samples::make_mesh<Surface_mesh>(sample.soup);
  return pants_of(mesh, sample.values, np);
}

template <class NamedParameters>
double length_of_cutting_system(const Sample& sample, const NamedParameters& np)
{
  auto mesh = curve_samples::make_mesh<Surface_mesh>(sample.soup);
  Curves curves;
  CGAL::Reeb_graph::cutting_system(mesh, CGAL::Reeb_graph::make_scalar_map(mesh, sample.values),
                                   std::back_inserter(curves), np);
  BOOST_TEST(curves.size() == 5u);
  return std::accumulate(curves.begin(), curves.end(), 0.,
                         [](double sum, const auto& curve) { return sum + curve.length; });
}

double total_length(const Curves& curves)
{
  return std::accumulate(curves.begin(), curves.end(), 0.,
                         [](double sum, const auto& curve) { return sum + curve.length; });
}

const auto negative_length = [](const CGAL::Reeb_graph::Candidate_curve& candidate) { return -candidate.length; };
} // namespace

BOOST_AUTO_TEST_CASE(the_cost_chooses_the_places)
{
  const Sample sample = curve_samples::smooth_sample(5, 3000, 0);
  const double shortest = total_length(pants_of(sample, CGAL::parameters::default_values()));
  const double longest = total_length(pants_of(sample, CGAL::parameters::curve_cost(negative_length)));
  const double single = total_length(pants_of(sample, CGAL::parameters::number_of_candidates(1)));
  const double many = total_length(pants_of(sample, CGAL::parameters::number_of_candidates(1000)));
  BOOST_TEST(longest > 1.05 * shortest);
  BOOST_TEST(single >= shortest);
  BOOST_TEST(many <= 1.001 * shortest);

  std::vector<double> positions, values;
  pants_of(sample, CGAL::parameters::curve_cost([&](const CGAL::Reeb_graph::Candidate_curve& candidate) {
             positions.push_back(candidate.position);
             values.push_back(candidate.value);
             return 0.;
           }));
  BOOST_TEST(positions.size() <= 12u * 16u);
  BOOST_TEST(*std::min_element(positions.begin(), positions.end()) > 0);
  BOOST_TEST(*std::max_element(positions.begin(), positions.end()) < 1);
  BOOST_TEST(*std::max_element(values.begin(), values.end())
             <= *std::max_element(sample.values.begin(), sample.values.end()));
}

BOOST_AUTO_TEST_CASE(the_weight_chooses_the_tree)
{
  const Sample sample = curve_samples::smooth_sample(5, 3000, 0);
  const double shortest = length_of_cutting_system(sample, CGAL::parameters::default_values());
  const double other_tree = length_of_cutting_system(sample, CGAL::parameters::arc_weight(negative_length));
  const double longest =
    length_of_cutting_system(sample, CGAL::parameters::arc_weight(negative_length).curve_cost(negative_length));
  BOOST_TEST(shortest < other_tree);
  BOOST_TEST(other_tree < longest);
}

BOOST_AUTO_TEST_CASE(the_order_of_the_traits_class)
{
  typedef CGAL::dynamic_vertex_property_t<double> Property;
  typedef boost::property_map<Surface_mesh, Property>::const_type Scalar_map;
  struct Descending : CGAL::Reeb_graph_traits<Surface_mesh, Scalar_map>
  {
    struct Less_scalar
    {
      bool operator()(double a, double b) const { return a > b; }
    };
    Less_scalar less_scalar_object() const { return Less_scalar(); }
  };
  for(std::size_t seed = 0; seed < 30; ++seed)
    BOOST_TEST_CONTEXT("seed " << seed)
    {
      Sample sample = curve_samples::random_sample(seed, false, 1, 2);
      const Curves curves = pants_of(sample, CGAL::parameters::geom_traits(Descending()));
      for(double& value : sample.values)
        value = -value;
      const Curves expected = pants_of(sample, CGAL::parameters::default_values());
      BOOST_REQUIRE(curves.size() == expected.size());
      for(std::size_t i = 0; i < curves.size(); ++i)
      {
        BOOST_TEST((curves[i].halfedges == expected[i].halfedges));
        BOOST_TEST(curves[i].value == -expected[i].value);
      }
    }
}

BOOST_AUTO_TEST_CASE(exact_numbers_that_no_double_tells_apart)
{
  for(std::size_t seed = 0; seed < 30; ++seed)
    BOOST_TEST_CONTEXT("seed " << seed)
    {
      const Sample sample = curve_samples::random_sample(8 * seed, false, 1, 2); // permutations
      const CGAL::Exact_rational tiny = CGAL::Exact_rational(1) / CGAL::Exact_rational(1e300);
      std::vector<CGAL::Exact_rational> values;
      for(const double value : sample.values)
        values.push_back(1 + tiny * CGAL::Exact_rational(value));
      auto mesh = curve_samples::make_mesh<Surface_mesh>(sample.soup);
      Face_history<Surface_mesh> history(mesh);
      Curves curves;
      CGAL::Reeb_graph::pants_decomposition(mesh, CGAL::Reeb_graph::make_scalar_map(mesh, values),
                                            std::back_inserter(curves), CGAL::parameters::visitor(history.visitor()));
      BOOST_TEST(curves.size() == pants_of(sample, CGAL::parameters::default_values()).size());
      BOOST_TEST(history.fault() == "");
      BOOST_TEST(is_valid_mesh(mesh));
    }
}

BOOST_AUTO_TEST_CASE(a_vertex_point_map_of_the_user)
{
  const Sample sample = curve_samples::smooth_sample(2, 1000, 0);
  auto mesh = curve_samples::make_mesh<Surface_mesh>(sample.soup);
  typedef mesh_builders::Point Point;
  const auto other_points = mesh.add_property_map<Surface_mesh::Vertex_index, Point>("v:other").first;
  for(const auto v : vertices(mesh))
    other_points[v] = mesh.point(v) + CGAL::Vector_3<mesh_builders::Kernel>(5, 0, 0);
  const Curves curves = pants_of(mesh, sample.values, CGAL::parameters::vertex_point_map(other_points));
  BOOST_REQUIRE(curves.size() == 3u);
  for(const auto& curve : curves)
    for(const auto h : curve.halfedges)
      BOOST_TEST(other_points[target(h, mesh)].x() > 2);
}

BOOST_AUTO_TEST_CASE(a_mesh_with_garbage)
{
  const Sample sample = curve_samples::smooth_sample(3, 1000, 0);
  Surface_mesh mesh;
  mesh_builders::build_with_garbage(mesh, sample.soup);
  const Curves curves = pants_of(mesh, sample.values, CGAL::parameters::default_values());
  BOOST_TEST(fault_of_cut_mesh(mesh, curves, std::vector<Piece>(4, Piece{-1, 3, 0})) == "");
  const Curves expected = pants_of(sample, CGAL::parameters::default_values());
  BOOST_REQUIRE(curves.size() == expected.size());
  for(std::size_t i = 0; i < curves.size(); ++i)
  {
    BOOST_TEST(curves[i].halfedges.size() == expected[i].halfedges.size());
    BOOST_TEST(curves[i].value == expected[i].value);
  }
}

BOOST_AUTO_TEST_CASE(the_same_curves_on_all_types_of_meshes)
{
  for(std::size_t seed = 0; seed < 60; ++seed)
    BOOST_TEST_CONTEXT("seed " << seed)
    {
      const Sample sample = curve_samples::random_sample(seed, false, 1, 2);
      const Curves expected = pants_of(sample, CGAL::parameters::default_values());
      auto polyhedron = curve_samples::make_mesh<Polyhedron>(sample.soup);
      std::vector<CGAL::Reeb_graph::Curve<boost::graph_traits<Polyhedron>::halfedge_descriptor>> curves;
      CGAL::Reeb_graph::pants_decomposition(polyhedron, CGAL::Reeb_graph::make_scalar_map(polyhedron, sample.values),
                                            std::back_inserter(curves));
      BOOST_REQUIRE(curves.size() == expected.size());
      for(std::size_t i = 0; i < curves.size(); ++i)
      {
        BOOST_TEST(curves[i].halfedges.size() == expected[i].halfedges.size());
        BOOST_TEST(curves[i].value == expected[i].value);
      }
    }
}

// Numbers of any type are stored as the type that the parameter has.
BOOST_AUTO_TEST_CASE(named_parameters_of_any_arithmetic_type)
{
  namespace parameters = CGAL::parameters;
  namespace tags = CGAL::Reeb_graph::internal;
  const auto check = [](const auto& value) {
    const auto np =
      parameters::persistence_threshold(value).measure_threshold(value).solver_tolerance(value).number_of_candidates(
        value);
    BOOST_TEST(parameters::get_parameter(np, tags::persistence_threshold) == 3.);
    BOOST_TEST(parameters::get_parameter(np, tags::measure_threshold) == 3.);
    BOOST_TEST(parameters::get_parameter(np, tags::solver_tolerance) == 3.);
    BOOST_TEST(parameters::get_parameter(np, tags::number_of_candidates) == 3u);
    const tags::Branch_thresholds thresholds(parameters::persistence_threshold(value).area_threshold(value));
    BOOST_TEST(thresholds.persistence == 3.);
    BOOST_TEST(thresholds.area == 3.);
    BOOST_TEST(tags::Branch_thresholds(parameters::area_threshold(value)).area == 3.);
    BOOST_TEST(tags::Branch_thresholds(parameters::verbose(true).area_threshold(value)).area == 3.);
  };
  check(3.);
  check(3.F);
  check(3);
  check(3L);
  check(3U);
  check(static_cast<short>(3));
  check(3.L);
}

// A parameter of ours with the name of one of CGAL's would take its place.
BOOST_AUTO_TEST_CASE(functions_of_cgal_keep_their_parameters)
{
  Surface_mesh mesh;
  for(const double size : {1., 2., 100.})
  {
    CGAL::make_tetrahedron(mesh_builders::Point(5 * size, 0, 0), mesh_builders::Point(6 * size, 0, 0),
                           mesh_builders::Point(5 * size, size, 0), mesh_builders::Point(5 * size, 0, size), mesh);
  }
  Surface_mesh other = mesh;
  namespace processing = CGAL::Polygon_mesh_processing;
  BOOST_TEST(processing::remove_connected_components_of_negligible_size(mesh, CGAL::parameters::area_threshold(1000.))
             == 2u);
  BOOST_TEST(processing::remove_connected_components_of_negligible_size(other, CGAL::parameters::area_threshold(1000))
             == 2u);
}

BOOST_AUTO_TEST_SUITE_END()
