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
#include "mesh_builders.h"

#include <CGAL/Reeb_graph/curves/branch_curves.h>
#include <CGAL/Reeb_graph/curves/cutting_system.h>
#include <CGAL/Reeb_graph/curves/pants_decomposition.h>
#include <CGAL/Reeb_graph/scalar_maps.h>

#include <cstddef>
#include <iterator>
#include <limits>
#include <numeric>
#include <string>
#include <vector>

// Surfaces and fields that have no such curves are refused, and the mesh stays as it is.

BOOST_AUTO_TEST_SUITE(test_curve_errors)

using CGAL::Reeb_graph::Border_level_error;
using CGAL::Reeb_graph::No_pants_decomposition_error;
using mesh_builders::Surface_mesh;
using random_meshes::Combinatorial_mesh;
using random_meshes::Random;

namespace {
typedef std::vector<CGAL::Reeb_graph::Curve<Surface_mesh::Halfedge_index>> Curves;

enum class Kind
{
  CUTTING_SYSTEM,
  PANTS,
  BRANCHES
};

// Returns the number of curves. If an exception is thrown, nothing must have changed.
std::size_t number_of_curves(Kind kind, Surface_mesh& mesh, const std::vector<double>& values)
{
  const std::size_t number_of_vertices = num_vertices(mesh), number_of_faces = num_faces(mesh);
  Curves curves;
  try
  {
    const auto scalar_map = CGAL::Reeb_graph::make_scalar_map(mesh, values);
    if(kind == Kind::CUTTING_SYSTEM)
      CGAL::Reeb_graph::cutting_system(mesh, scalar_map, std::back_inserter(curves));
    else if(kind == Kind::PANTS)
      CGAL::Reeb_graph::pants_decomposition(mesh, scalar_map, std::back_inserter(curves));
    else
      CGAL::Reeb_graph::branch_curves(mesh, scalar_map, std::back_inserter(curves));
  }
  catch(...)
  {
    BOOST_TEST(curves.empty());
    BOOST_TEST(num_vertices(mesh) == number_of_vertices);
    BOOST_TEST(num_faces(mesh) == number_of_faces);
    BOOST_TEST(!mesh.has_garbage());
    throw;
  }
  return curves.size();
}

std::size_t number_of_curves(Kind kind, const Combinatorial_mesh& combinatorial_mesh, const std::vector<double>& values)
{
  Surface_mesh mesh;
  mesh_builders::build(mesh, mesh_builders::make_soup(combinatorial_mesh));
  return number_of_curves(kind, mesh, values);
}

std::vector<double> rising_values(std::size_t size)
{
  std::vector<double> values(size);
  std::iota(values.begin(), values.end(), 0.);
  return values;
}

// a cylinder with an extremal border at each end
std::vector<double> cylinder_values(std::size_t around, std::size_t along)
{
  std::vector<double> values;
  for(std::size_t v = 0; v < around * along; ++v)
    values.push_back(static_cast<double>(v / around));
  return values;
}

void check_no_pants(const Combinatorial_mesh& mesh,
                    const std::vector<double>& values,
                    std::size_t face,
                    long euler_characteristic,
                    const std::string& name)
{
  BOOST_CHECK_EXCEPTION(number_of_curves(Kind::PANTS, mesh, values), No_pants_decomposition_error,
                        [&](const No_pants_decomposition_error& error) {
                          return error.face() == face && error.euler_characteristic() == euler_characteristic
                              && std::string(error.what()).find(name) != std::string::npos;
                        });
}

const std::vector<Kind> all_kinds = {Kind::CUTTING_SYSTEM, Kind::PANTS, Kind::BRANCHES};
} // namespace

BOOST_AUTO_TEST_CASE(surfaces_without_a_pants_decomposition)
{
  check_no_pants(random_meshes::tetrahedron(), rising_values(4), 0, 2, "sphere");
  check_no_pants(random_meshes::seven_vertex_torus(), rising_values(7), 0, 0, "torus");
  check_no_pants(random_meshes::cylinder(4, 3), cylinder_values(4, 3), 0, 0, "annulus");
  check_no_pants(random_meshes::disk(5), {5, 1, 1, 1, 1, 1}, 0, 1, "disk");

  Random random(1);
  const Combinatorial_mesh first = random_meshes::random_closed_surface(2, 0, random);
  const Combinatorial_mesh both = random_meshes::disjoint_union(first, random_meshes::tetrahedron());
  check_no_pants(both, rising_values(both.number_of_vertices), first.triangles.size(), 2, "sphere");
}

BOOST_AUTO_TEST_CASE(thresholds_that_are_no_thresholds)
{
  Surface_mesh mesh;
  mesh_builders::build(mesh, mesh_builders::make_soup(random_meshes::seven_vertex_torus()));
  const auto scalar_map = CGAL::Reeb_graph::make_scalar_map(mesh, rising_values(7));
  const auto number_of_branches = [&](const auto& np) {
    Curves curves;
    CGAL::Reeb_graph::branch_curves(mesh, scalar_map, std::back_inserter(curves), np);
    return curves.size();
  };
  for(const double threshold : {-1., std::numeric_limits<double>::quiet_NaN()})
  {
    BOOST_CHECK_THROW(number_of_branches(CGAL::parameters::persistence_threshold(threshold)),
                      CGAL::Reeb_graph::Parameter_error);
    BOOST_CHECK_THROW(number_of_branches(CGAL::parameters::area_threshold(threshold)),
                      CGAL::Reeb_graph::Parameter_error);
    BOOST_CHECK_THROW(number_of_branches(CGAL::parameters::measure_threshold(threshold).branch_measure(
                        [](const auto& b) { return b.weight; })),
                      CGAL::Reeb_graph::Parameter_error);
  }
  BOOST_TEST(num_vertices(mesh) == 7u);
  BOOST_TEST(number_of_branches(CGAL::parameters::persistence_threshold(1e9)) == 0u);
}

BOOST_AUTO_TEST_CASE(surfaces_without_curves)
{
  BOOST_TEST(number_of_curves(Kind::CUTTING_SYSTEM, random_meshes::tetrahedron(), rising_values(4)) == 0u);
  BOOST_TEST(number_of_curves(Kind::CUTTING_SYSTEM, random_meshes::cylinder(4, 3), cylinder_values(4, 3)) == 0u);
  BOOST_TEST(number_of_curves(Kind::CUTTING_SYSTEM, random_meshes::seven_vertex_torus(), rising_values(7)) == 1u);
  BOOST_TEST(number_of_curves(Kind::BRANCHES, random_meshes::cylinder(4, 3), cylinder_values(4, 3)) == 0u);
  for(const Kind kind : all_kinds)
  {
    BOOST_TEST(number_of_curves(kind, Combinatorial_mesh(), {}) == 0u);
    BOOST_TEST(number_of_curves(kind, Combinatorial_mesh{3, {}}, {1, 2, 3}) == 0u);
  }
}

BOOST_AUTO_TEST_CASE(borders_that_are_no_extremal_levels)
{
  Random random(2);
  Combinatorial_mesh mesh = random_meshes::random_closed_surface(2, 30, random);
  mesh.triangles.pop_back();
  const auto loop = random_meshes::border_loops(mesh).front();
  const std::size_t first = *std::min_element(loop.begin(), loop.end());
  const auto check = [&](const std::vector<double>& values, Border_level_error::Reason reason) {
    for(const Kind kind : all_kinds)
      BOOST_CHECK_EXCEPTION(
        number_of_curves(kind, mesh, values), Border_level_error,
        [&](const Border_level_error& error) { return error.vertex() == first && error.reason() == reason; });
  };
  std::vector<double> values = rising_values(mesh.number_of_vertices);
  check(values, Border_level_error::Reason::SEVERAL_VALUES);
  for(const std::size_t v : loop)
    values[v] = static_cast<double>(mesh.number_of_vertices) / 2;
  check(values, Border_level_error::Reason::NOT_EXTREMAL);
  for(const std::size_t v : loop)
    values[v] = -1;
  BOOST_TEST(number_of_curves(Kind::PANTS, mesh, values) == 4u);
}

BOOST_AUTO_TEST_CASE(input_that_has_no_reeb_graph)
{
  Random random(3);
  const Combinatorial_mesh mesh = random_meshes::random_closed_surface(2, 5, random);
  std::vector<double> values = rising_values(mesh.number_of_vertices);
  values[2] = std::numeric_limits<double>::quiet_NaN();
  for(const Kind kind : all_kinds)
    BOOST_CHECK_THROW(number_of_curves(kind, mesh, values), CGAL::Reeb_graph::Unordered_scalar_error);

  for(const Kind kind : all_kinds)
  {
    Surface_mesh quad;
    std::vector<Surface_mesh::Vertex_index> corners;
    for(int i = 0; i < 4; ++i)
      corners.push_back(mesh_builders::add_point(quad, {i < 2 ? 0. : 1., i % 3 == 0 ? 0. : 1., 0.}));
    quad.add_face(corners);
    BOOST_CHECK_THROW(number_of_curves(kind, quad, rising_values(4)), CGAL::Reeb_graph::Non_triangular_face_error);
  }
}

BOOST_AUTO_TEST_SUITE_END()
