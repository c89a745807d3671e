// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#include <boost/test/unit_test.hpp>

#include "graph_checks.h"
#include "known_meshes.h"
#include "mesh_builders.h"
#include "random_fields.h"
#include "random_meshes.h"

#include <cstddef>
#include <string>
#include <vector>

// The package against the oracle: nodes, arcs and chains.

BOOST_AUTO_TEST_SUITE(test_oracle_comparison)

using graph_checks::fault_of_reeb_graph;
using mesh_builders::make_mesh;
using mesh_builders::Surface_mesh;
using random_meshes::Field_class;
using random_meshes::Mesh_class;
using random_meshes::Random;

namespace {
constexpr int number_of_mesh_classes = static_cast<int>(Mesh_class::NUMBER_OF_CLASSES);
constexpr int number_of_field_classes = static_cast<int>(Field_class::NUMBER_OF_CLASSES);

void compare_with_oracle(const Surface_mesh& mesh, const std::vector<double>& values)
{
  for(bool keeps_degree_two_nodes : {false, true})
    BOOST_TEST_CONTEXT("degree two nodes kept: " << keeps_degree_two_nodes)
  BOOST_TEST(fault_of_reeb_graph(mesh, values, keeps_degree_two_nodes) == "");
}

std::vector<double> coordinate_field(const Surface_mesh& mesh, double x, double y, double z)
{
  std::vector<double> values;
  for(const auto v : mesh.vertices())
    values.push_back(x * mesh.point(v).x() + y * mesh.point(v).y() + z * mesh.point(v).z());
  return values;
}

void compare_all_fields(const Surface_mesh& mesh, std::size_t seed)
{
  BOOST_TEST_CONTEXT("height")
  compare_with_oracle(mesh, coordinate_field(mesh, 0, 0, 1));
  BOOST_TEST_CONTEXT("tilted height")
  compare_with_oracle(mesh, coordinate_field(mesh, 0.9, 0.3, 0.2));
  BOOST_TEST_CONTEXT("seed " << seed)
  {
    Random random(seed);
    compare_with_oracle(mesh, random_meshes::random_permutation(mesh.number_of_vertices(), random));
    compare_with_oracle(mesh, random_meshes::random_integers(mesh.number_of_vertices(), 3, random));
  }
  BOOST_TEST_CONTEXT("constant")
  compare_with_oracle(mesh, std::vector<double>(mesh.number_of_vertices(), 1));
}
} // namespace

BOOST_AUTO_TEST_CASE(random_small_meshes)
{
  const std::size_t number_of_seeds = 5280;
  for(std::size_t seed = 0; seed < number_of_seeds; ++seed)
  {
    Random random(seed);
    const auto mesh_class = static_cast<Mesh_class>(seed % number_of_mesh_classes);
    const auto field_class = static_cast<Field_class>(seed / number_of_mesh_classes % number_of_field_classes);
    const auto mesh = random_meshes::random_mesh(mesh_class, random);
    const auto values = random_meshes::random_field(mesh, field_class, random);
    BOOST_TEST_CONTEXT("seed " << seed << ", mesh class " << int(mesh_class) << ", field class " << int(field_class))
    compare_with_oracle(make_mesh<Surface_mesh>(mesh), values);
  }
}

BOOST_AUTO_TEST_CASE(random_meshes_with_several_edges_between_two_vertices)
{
  for(std::size_t seed = 0; seed < 400; ++seed)
  {
    Random random(seed);
    const std::size_t number_of_splits = random.below(4);
    const auto combinatorial_mesh =
      random_meshes::random_closed_surface(static_cast<unsigned>(random.below(4)), number_of_splits, random);
    Surface_mesh mesh = make_mesh<Surface_mesh>(combinatorial_mesh);
    mesh_builders::flip_edges_carelessly(mesh, 100, random);
    const auto field_class = seed % 2 == 0 ? Field_class::PERMUTATION : Field_class::FEW_VALUES;
    const auto values = random_meshes::random_field(combinatorial_mesh, field_class, random);
    BOOST_TEST_CONTEXT("seed " << seed)
    compare_with_oracle(mesh, values);
  }
}

BOOST_AUTO_TEST_CASE(generated_closed_surfaces)
{
  for(unsigned genus = 0; genus <= 10; ++genus)
    BOOST_TEST_CONTEXT("genus " << genus)
  compare_all_fields(make_mesh<Surface_mesh>(generated_surfaces::closed_surface(genus, 500)), genus);
}

BOOST_AUTO_TEST_CASE(generated_surfaces_of_other_kinds)
{
  BOOST_TEST_CONTEXT("terrain")
  compare_all_fields(make_mesh<Surface_mesh>(generated_surfaces::terrain(25, 20)), 1);
  BOOST_TEST_CONTEXT("torus")
  compare_all_fields(make_mesh<Surface_mesh>(generated_surfaces::torus(12, 30)), 2);
}

BOOST_AUTO_TEST_CASE(vertices_of_degree_above_255)
{
  std::size_t seed = 0;
  for(const auto& mesh : {random_meshes::bipyramid(600), random_meshes::disk(600), random_meshes::half_disk(600)})
    for(const Field_class field_class : {Field_class::HUB, Field_class::PERMUTATION, Field_class::CONSTANT})
      BOOST_TEST_CONTEXT("seed " << seed)
      {
        Random random(seed++);
        compare_with_oracle(make_mesh<Surface_mesh>(mesh), random_meshes::random_field(mesh, field_class, random));
      }
}

BOOST_AUTO_TEST_CASE(a_multiplicity_that_wraps_around_in_eight_bits)
{
  // the hub is the middle vertex of all triangles around it: 258 is 2 modulo 256, as at a regular vertex
  Random random(0);
  const auto mesh = random_meshes::bipyramid(258);
  compare_with_oracle(make_mesh<Surface_mesh>(mesh), random_meshes::random_field(mesh, Field_class::HUB, random));
}

BOOST_AUTO_TEST_CASE(contours_that_share_a_lower_vertex)
{
  const Surface_mesh mesh = make_mesh<Surface_mesh>(known_meshes::nine_vertex_torus());
  const std::vector<double> values = {0, 1, 2, 3, 4, 5, 6, 7, 8};
  compare_with_oracle(mesh, values);

  std::vector<std::pair<std::size_t, std::size_t>> arcs;
  for(const auto& arc : graph_checks::compute_plain(mesh, values).arcs)
    arcs.emplace_back(arc.lower, arc.upper);
  const std::vector<std::pair<std::size_t, std::size_t>> expected = {{0, 3}, {3, 4}, {3, 4}, {4, 8}};
  BOOST_TEST((arcs == expected));
}

BOOST_AUTO_TEST_CASE(a_loop_closed_beside_a_border)
{
  compare_with_oracle(make_mesh<Surface_mesh>(known_meshes::seven_vertex_annulus()), {0, 1, 2, 3, 4, 5, 6});
}

BOOST_AUTO_TEST_SUITE_END()
