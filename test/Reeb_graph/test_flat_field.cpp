// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#include <boost/test/unit_test.hpp>

#include "graph_checks.h"
#include "mesh_builders.h"
#include "random_fields.h"
#include "random_meshes.h"

#include <CGAL/Reeb_graph/Augmentation.h>
#include <CGAL/Reeb_graph/Flat_field.h>

#include <boost/mpl/list.hpp>

#include <cstddef>
#include <functional>
#include <iterator>
#include <limits>
#include <vector>

// A mesh that has been flattened once, for the second and the tenth field.

BOOST_AUTO_TEST_SUITE(test_flat_field)

namespace parameters = CGAL::parameters;
using CGAL::Reeb_graph::Flat_field;
using mesh_builders::make_mesh;
using mesh_builders::Polyhedron;
using mesh_builders::Surface_mesh;
using random_meshes::Field_class;
using random_meshes::Mesh_class;
using random_meshes::Random;

typedef boost::mpl::list<Surface_mesh, Polyhedron> Meshes;

namespace {
Mesh_class mesh_class(std::size_t seed)
{
  return static_cast<Mesh_class>(seed % static_cast<std::size_t>(Mesh_class::NUMBER_OF_CLASSES));
}

// Every other Surface_mesh has elements that have been removed.
template <class Mesh>
void build(Mesh& mesh, const random_meshes::Combinatorial_mesh& combinatorial_mesh, std::size_t)
{
  mesh = make_mesh<Mesh>(combinatorial_mesh);
}
void build(Surface_mesh& mesh, const random_meshes::Combinatorial_mesh& combinatorial_mesh, std::size_t seed)
{
  if(seed % 2 == 0)
    mesh = make_mesh<Surface_mesh>(combinatorial_mesh);
  else
    mesh_builders::build_with_garbage(mesh, mesh_builders::make_soup(combinatorial_mesh));
}

template <class Mesh>
auto constant_map(const Mesh& mesh, double value)
{
  const auto size = static_cast<std::size_t>(std::distance(vertices(mesh).first, vertices(mesh).second));
  return CGAL::Reeb_graph::make_scalar_map(mesh, std::vector<double>(size, value));
}
} // namespace

BOOST_AUTO_TEST_CASE_TEMPLATE(graphs_of_many_fields_on_one_flat_field_are_those_of_the_mesh, Mesh, Meshes)
{
  for(std::size_t seed = 0; seed < 240; ++seed)
  {
    Random random(seed);
    const auto combinatorial_mesh = random_meshes::random_mesh(mesh_class(seed), random);
    Mesh mesh;
    build(mesh, combinatorial_mesh, seed / 6);
    const auto ties = random.below(2) == 0 ? CGAL::Reeb_graph::Ties::PERTURB : CGAL::Reeb_graph::Ties::CONTRACT;
    Flat_field flat_field(mesh, constant_map(mesh, 0));
    for(std::size_t number = 0; number < 3; ++number)
    {
      const auto field_class =
        static_cast<Field_class>(random.below(static_cast<std::size_t>(Field_class::NUMBER_OF_CLASSES)));
      const auto scalar_map =
        CGAL::Reeb_graph::make_scalar_map(mesh, random_meshes::random_field(combinatorial_mesh, field_class, random));
      flat_field.set_values(scalar_map);
      graph_checks::Graph_of<Mesh> expected, graph;
      auto expected_places = get(CGAL::dynamic_vertex_property_t<std::size_t>(), mesh);
      auto places = get(CGAL::dynamic_vertex_property_t<std::size_t>(), mesh);
      CGAL::compute_reeb_graph(mesh, scalar_map, expected, parameters::ties(ties).vertex_place_map(expected_places));
      CGAL::compute_reeb_graph(mesh, flat_field, graph, parameters::ties(ties).vertex_place_map(places));
      BOOST_TEST_CONTEXT("seed " << seed << ", field " << number)
      {
        BOOST_TEST(graph_checks::are_identical(expected, graph));
        for(const auto v : vertices(mesh))
        {
          BOOST_TEST(get(places, v) == get(expected_places, v));
          BOOST_TEST(get(flat_field, v) == get(scalar_map, v));
        }
      }
    }
  }
}

BOOST_AUTO_TEST_CASE_TEMPLATE(copies_and_augmentations_keep_their_values, Mesh, Meshes)
{
  const Mesh mesh = make_mesh<Mesh>(random_meshes::seven_vertex_torus());
  const auto v = *vertices(mesh).first;
  const auto scalar_map = CGAL::Reeb_graph::make_scalar_map(mesh, std::vector<double>{0, 1, 2, 3, 4, 5, 6});
  Flat_field flat_field(mesh, scalar_map);
  const auto copy = flat_field;
  graph_checks::Graph_of<Mesh> graph;
  CGAL::compute_reeb_graph(mesh, flat_field, graph);
  const CGAL::Reeb_graph::Augmentation<Mesh, Flat_field<Mesh, double>, decltype(graph)> augmentation(mesh, flat_field,
                                                                                                     graph);
  flat_field.set_values(constant_map(mesh, 8));
  BOOST_TEST(get(flat_field, v) == 8);
  BOOST_TEST(get(copy, v) == 0);
  const auto arc = *edges(graph).first;
  const auto contour =
    CGAL::Reeb_graph::Augmentation<Mesh, graph_checks::Scalar_map_of<Mesh>, decltype(graph)>(mesh, scalar_map, graph)
      .contour(arc, 0.5);
  BOOST_TEST(augmentation.contour(arc, 0.5).edges == contour.edges);
  BOOST_TEST(&flat_field.mesh() == &mesh);
}

BOOST_AUTO_TEST_CASE_TEMPLATE(wrong_values_leave_a_flat_field_as_it_was, Mesh, Meshes)
{
  const Mesh mesh = make_mesh<Mesh>(random_meshes::seven_vertex_torus());
  Flat_field flat_field(mesh, constant_map(mesh, 1));
  const double nan = std::numeric_limits<double>::quiet_NaN();
  BOOST_CHECK_THROW(flat_field.set_values(constant_map(mesh, nan)), CGAL::Reeb_graph::Unordered_scalar_error);
  BOOST_TEST(get(flat_field, *vertices(mesh).first) == 1);
  BOOST_CHECK_THROW(Flat_field(mesh, constant_map(mesh, nan)), CGAL::Reeb_graph::Unordered_scalar_error);
}

// The first edit removes a face, the second one a vertex.
BOOST_AUTO_TEST_CASE_TEMPLATE(edits_that_change_the_numbers_of_elements_are_noticed, Mesh, Meshes)
{
  auto combinatorial_mesh = random_meshes::tetrahedron();
  ++combinatorial_mesh.number_of_vertices;
  Mesh mesh = make_mesh<Mesh>(combinatorial_mesh);
  const Mesh other = mesh;
  graph_checks::Graph_of<Mesh> graph;
  Flat_field flat_field(mesh, constant_map(mesh, 1));
  BOOST_CHECK_THROW(CGAL::compute_reeb_graph(other, flat_field, graph), CGAL::Reeb_graph::Graph_mismatch_error);
  CGAL::compute_reeb_graph(mesh, flat_field, graph);
  BOOST_TEST(num_vertices(graph) == 3u);
  CGAL::Euler::remove_face(halfedge(*faces(mesh).first, mesh), mesh);
  BOOST_CHECK_THROW(CGAL::compute_reeb_graph(mesh, flat_field, graph), CGAL::Reeb_graph::Graph_mismatch_error);
  BOOST_CHECK_THROW(flat_field.set_values(constant_map(mesh, 2)), CGAL::Reeb_graph::Graph_mismatch_error);
  flat_field = Flat_field(mesh, constant_map(mesh, 1));
  CGAL::compute_reeb_graph(mesh, flat_field, graph);
  remove_vertex(*std::prev(vertices(mesh).end()), mesh);
  BOOST_CHECK_THROW(CGAL::compute_reeb_graph(mesh, flat_field, graph), CGAL::Reeb_graph::Graph_mismatch_error);
}

BOOST_AUTO_TEST_CASE(collecting_garbage_is_noticed)
{
  Surface_mesh mesh;
  mesh_builders::build_with_garbage(mesh, mesh_builders::make_soup(random_meshes::seven_vertex_torus()));
  const Flat_field flat_field(mesh, constant_map(mesh, 1));
  mesh.collect_garbage();
  graph_checks::Graph_of<Surface_mesh> graph;
  BOOST_CHECK_THROW(CGAL::compute_reeb_graph(mesh, flat_field, graph), CGAL::Reeb_graph::Graph_mismatch_error);
}

namespace {
struct Descending_traits : CGAL::Reeb_graph_traits<Surface_mesh, graph_checks::Scalar_map_of<Surface_mesh>>
{
  typedef std::greater<double> Less_scalar;
  Less_scalar less_scalar_object() const { return {}; }
};
} // namespace

BOOST_AUTO_TEST_CASE(an_order_of_the_user_is_that_of_the_functions)
{
  const Surface_mesh mesh = make_mesh<Surface_mesh>(random_meshes::seven_vertex_torus());
  const auto scalar_map = CGAL::Reeb_graph::make_scalar_map(mesh, std::vector<double>{3, 1, 2, 6, 4, 5, 0});
  const auto np = parameters::geom_traits(Descending_traits());
  const Flat_field flat_field(mesh, scalar_map, np);
  graph_checks::Graph_of<Surface_mesh> expected, graph;
  CGAL::compute_reeb_graph(mesh, scalar_map, expected, np);
  CGAL::compute_reeb_graph(mesh, flat_field, graph, np);
  BOOST_TEST(graph_checks::are_identical(expected, graph));
  BOOST_TEST(graph[0].value == 6);
}

BOOST_AUTO_TEST_SUITE_END()
