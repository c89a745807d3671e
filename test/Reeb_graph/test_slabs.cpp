// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#include <boost/test/unit_test.hpp>

#include "computed_graphs.h"
#include "known_meshes.h"

#include <CGAL/Reeb_graph/internal/complex/Flat_mesh.h>

#include <boost/mpl/list.hpp>

#include <algorithm>
#include <cstddef>
#include <string>
#include <vector>

// The graph is the same for any number of slabs, those without vertices and cylinders through a slab included.

BOOST_AUTO_TEST_SUITE(test_slabs)

using namespace computed_graphs;
using mesh_builders::Polyhedron;
using mesh_builders::Surface_mesh;

typedef boost::mpl::list<Surface_mesh, Polyhedron> Meshes;

namespace {
// Compares with the graph of one slab, which other tests compare with an oracle.
template <class Mesh>
void compare_slabs(const Mesh& mesh,
                   const std::vector<double>& values,
                   const std::vector<std::size_t>& slab_counts,
                   Settings settings)
{
  const Mesh_numbers<Mesh> numbers(mesh);
  const auto scalar_map = CGAL::Reeb_graph::make_scalar_map(mesh, values);
  settings.method = Method::CONTOUR_TREES;
  settings.number_of_slabs = 1;
  const auto expected = compute<CGAL::Sequential_tag>(mesh, scalar_map, settings);
  const std::string expected_files = written(numbers, expected);
  for(const Method method : {Method::CONTOUR_TREES, Method::CRITICAL_SETS})
    for(const std::size_t slabs : slab_counts)
    {
      settings.method = method;
      settings.number_of_slabs = slabs;
      const auto graph = compute<CGAL::Sequential_tag>(mesh, scalar_map, settings);
      if(!graph_checks::are_identical(graph, expected) || written(numbers, graph) != expected_files)
        BOOST_ERROR("another graph; " << settings);
    }
}

std::vector<std::size_t> slab_counts_beyond(std::size_t number_of_vertices)
{
  return {1, 2, 3, 8, 64, number_of_vertices + 1};
}

template <class Mesh, class Make>
void compare_on_random_meshes(std::size_t first_seed, std::size_t end_seed, const Make& make)
{
  constexpr std::size_t number_of_classes = static_cast<std::size_t>(Mesh_class::NUMBER_OF_CLASSES);
  constexpr std::size_t number_of_field_classes = static_cast<std::size_t>(Field_class::NUMBER_OF_CLASSES);
  for(std::size_t seed = first_seed; seed < end_seed; ++seed)
  {
    Random random(300000 + seed);
    const auto mesh = random_meshes::random_mesh(static_cast<Mesh_class>(seed % number_of_classes), random);
    const auto field_class = static_cast<Field_class>(seed / number_of_classes % number_of_field_classes);
    const auto values = random_meshes::random_field(mesh, field_class, random);
    const Settings settings = settings_of_seed(seed / number_of_classes / number_of_field_classes);
    BOOST_TEST_CONTEXT("seed " << seed)
    compare_slabs(make(mesh), values, slab_counts_beyond(mesh.number_of_vertices), settings);
  }
}

template <class Mesh>
void compare_on_random_meshes(std::size_t first_seed, std::size_t end_seed)
{
  compare_on_random_meshes<Mesh>(first_seed, end_seed,
                                 [](const Combinatorial_mesh& mesh) { return make_mesh<Mesh>(mesh); });
}
} // namespace

BOOST_AUTO_TEST_CASE(random_surface_meshes) { compare_on_random_meshes<Surface_mesh>(0, 2500); }

BOOST_AUTO_TEST_CASE(random_surface_meshes_with_garbage)
{
  compare_on_random_meshes<Surface_mesh>(3500, 4000, [](const Combinatorial_mesh& mesh) {
    Surface_mesh garbage;
    mesh_builders::build_with_garbage(garbage, mesh_builders::make_soup(mesh));
    return garbage;
  });
}

BOOST_AUTO_TEST_CASE(random_polyhedra) { compare_on_random_meshes<Polyhedron>(2500, 3500); }

BOOST_AUTO_TEST_CASE(all_orders_of_an_annulus)
{
  const Surface_mesh mesh = make_mesh<Surface_mesh>(known_meshes::seven_vertex_annulus());
  std::vector<double> values = {0, 1, 2, 3, 4, 5, 6};
  do
  {
    BOOST_TEST_CONTEXT("order " << values[0] << values[1] << values[2] << values[3] << values[4] << values[5])
    compare_slabs(mesh, values, {2, 4, 8}, Settings());
  } while(std::next_permutation(values.begin(), values.end()));
}

BOOST_AUTO_TEST_CASE(surfaces_of_high_genus_on_few_vertices)
{
  for(std::size_t seed = 0; seed < 300; ++seed)
  {
    Random random(seed);
    const auto genus = static_cast<unsigned>(4 + random.below(9));
    const auto mesh = random_meshes::random_closed_surface(genus, random.below(4), random);
    const auto values = random_meshes::random_field(mesh, Field_class::PERMUTATION, random);
    BOOST_TEST_CONTEXT("seed " << seed)
    compare_slabs(make_mesh<Surface_mesh>(mesh), values, slab_counts_beyond(mesh.number_of_vertices), Settings());
  }
}

BOOST_AUTO_TEST_CASE(hubs_of_high_degree)
{
  Random random(0);
  for(const auto& mesh : {random_meshes::bipyramid(600), random_meshes::disk(600), random_meshes::half_disk(600)})
    for(const Field_class field_class : {Field_class::HUB, Field_class::PERMUTATION})
      compare_slabs(make_mesh<Surface_mesh>(mesh), random_meshes::random_field(mesh, field_class, random),
                    slab_counts_beyond(mesh.number_of_vertices), Settings());
}

// Two rings of vertices each at the ends of a long cylinder: most slabs between them hold no vertex of it, but those
// of another component that is in between.
BOOST_AUTO_TEST_CASE_TEMPLATE(cylinders_through_slabs_without_vertices, Mesh, Meshes)
{
  const auto mesh = disjoint_union(random_meshes::cylinder(5, 2), random_meshes::tetrahedron());
  const std::vector<double> values = {0, 0, 0, 0, 0, 9, 9, 9, 9, 9, 4, 5, 6, 7};
  for(std::size_t seed = 0; seed < 4; ++seed)
    compare_slabs(make_mesh<Mesh>(mesh), values, {1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 64}, settings_of_seed(seed));
}

// Fewer slabs are made than asked for where their levels would take more memory than the mesh.
BOOST_AUTO_TEST_CASE(as_many_slabs_as_vertices_of_noise)
{
  namespace stages = CGAL::Reeb_graph::internal;
  typedef CGAL::Reeb_graph_traits<Surface_mesh, graph_checks::Scalar_map_of<Surface_mesh>> Traits;
  const auto soup = generated_surfaces::closed_surface(2, 12000);
  const Surface_mesh mesh = make_mesh<Surface_mesh>(soup);
  Random random(1);
  const auto values = random_meshes::random_permutation(soup.points.size(), random);
  const std::vector<double> noise(values.begin(), values.end());
  compare_slabs(mesh, noise, {soup.points.size()}, Settings());

  const auto surface = stages::flatten(stages::Threads(), mesh, CGAL::Reeb_graph::make_scalar_map(mesh, noise),
                                       Traits(), CGAL::parameters::default_values());
  const stages::Vertex_order order(surface.field.keys());
  const auto critical_vertices = stages::classify_vertices(stages::Threads(), surface.mesh->complex, order);
  const auto number_of_slabs = [&](std::size_t wanted) {
    return stages::Slicing(stages::Threads(), surface.mesh->complex, order, critical_vertices,
                           static_cast<stages::Index>(wanted))
      .number_of_slabs();
  };
  for(const std::size_t few : {2, 3, 8, 64})
    BOOST_TEST(number_of_slabs(few) == few);
  BOOST_TEST(number_of_slabs(critical_vertices.size()) > 8u);
  BOOST_TEST(number_of_slabs(critical_vertices.size()) < 1000u);
}

BOOST_AUTO_TEST_CASE_TEMPLATE(meshes_without_faces, Mesh, Meshes)
{
  for(std::size_t number_of_vertices : {0, 1, 2, 5})
    compare_slabs(make_mesh<Mesh>(Combinatorial_mesh{number_of_vertices, {}}),
                  std::vector<double>(number_of_vertices, 1), {1, 2, 3, 8, 64}, Settings());
}

BOOST_AUTO_TEST_SUITE_END()
