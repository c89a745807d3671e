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

#include <CGAL/Reeb_graph/curves/harmonic_pants_decomposition.h>
#include <CGAL/Reeb_graph/fields/harmonic_field.h>
#include <CGAL/Reeb_graph/fields/make_borders_level.h>
#include <CGAL/Reeb_graph/scalar_maps.h>
#include <CGAL/iterator.h>

#include <boost/mpl/list.hpp>

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <optional>
#include <vector>

// Pants decompositions without a field of the user, with any number of borders.

BOOST_AUTO_TEST_SUITE(test_harmonic_pants)

using namespace cut_mesh_checks;
using mesh_builders::Polyhedron;
using mesh_builders::Surface_mesh;

typedef boost::mpl::list<Surface_mesh, Polyhedron> Meshes;

namespace {
// The numbers of curves and pieces are right, for a mesh all of whose components have negative Euler characteristic.
// Returns the number of borders of such a mesh, nothing for another one.
template <class Mesh>
std::optional<std::size_t> test_harmonic_pants(const generated_surfaces::Triangle_soup& soup)
{
  Mesh mesh = curve_samples::make_mesh<Mesh>(soup);
  std::vector<Piece> expected;
  std::size_t number_of_curves = 0, number_of_borders = 0;
  for(const Piece& component : pieces_of(mesh))
  {
    if(component.euler_characteristic >= 0)
      return std::nullopt;
    number_of_borders += component.border_loops;
    expected.insert(expected.end(), static_cast<std::size_t>(-component.euler_characteristic), {-1, 3, 0});
    number_of_curves += (3 * static_cast<std::size_t>(-component.euler_characteristic) - component.border_loops) / 2;
  }
  std::vector<CGAL::Reeb_graph::Curve<typename boost::graph_traits<Mesh>::halfedge_descriptor>> curves;
  CGAL::Reeb_graph::harmonic_pants_decomposition(mesh, std::back_inserter(curves));
  BOOST_TEST(curves.size() == number_of_curves);
  BOOST_TEST(fault_of_cut_mesh(mesh, curves, expected) == "");
  return number_of_borders;
}
} // namespace

BOOST_AUTO_TEST_CASE_TEMPLATE(random_surfaces, Mesh, Meshes)
{
  std::size_t number_of_closed = 0, number_of_bordered = 0;
  for(std::size_t seed = 0; seed < 150; ++seed)
    BOOST_TEST_CONTEXT("seed " << seed)
    {
      const auto sample = curve_samples::random_sample(seed, seed % 3 != 0, 1 + seed % 2, seed % 3 == 0 ? 2 : seed % 2);
      const auto number_of_borders = test_harmonic_pants<Mesh>(sample.soup);
      number_of_closed += number_of_borders == std::size_t(0) ? 1 : 0;
      number_of_bordered += number_of_borders.value_or(0) > 0 ? 1 : 0;
    }
  BOOST_TEST(number_of_closed > 20u);
  BOOST_TEST(number_of_bordered > 20u);
}

BOOST_AUTO_TEST_CASE_TEMPLATE(borders_are_the_extrema_of_the_field, Mesh, Meshes)
{
  std::size_t number_of_bordered = 0;
  for(std::size_t seed = 0; seed < 300; ++seed)
    BOOST_TEST_CONTEXT("seed " << seed)
    {
      const auto sample = curve_samples::any_sample(seed);
      const Mesh mesh = curve_samples::make_mesh<Mesh>(sample.soup);
      auto values = CGAL::Reeb_graph::make_scalar_map(mesh, sample.values);
      CGAL::Reeb_graph::compute_harmonic_field_between_borders(
        mesh, values, CGAL::parameters::laplacian_weights(CGAL::Reeb_graph::Laplacian_weights::UNIFORM));
      curve_samples::Sample result = {sample.soup, {}};
      for(const auto v : vertices(mesh))
        result.values.push_back(get(values, v));
      BOOST_TEST(curve_samples::are_borders_extremal(result));
      const auto changes = CGAL::Reeb_graph::make_borders_level(mesh, values);
      BOOST_TEST(changes.number_of_changed_vertices == 0u);
      number_of_bordered += changes.number_of_borders > 0 ? 1 : 0;
      BOOST_TEST(std::all_of(result.values.begin(), result.values.end(), [](double v) { return v >= 0 && v <= 1; }));
    }
  BOOST_TEST(number_of_bordered > 150u);
}

BOOST_AUTO_TEST_CASE(smooth_surfaces_with_and_without_holes)
{
  for(const unsigned genus : {2u, 3u, 9u})
    for(std::size_t number_of_holes = 0; number_of_holes < 4; ++number_of_holes)
      BOOST_TEST_CONTEXT("genus " << genus << ", " << number_of_holes << " holes")
      {
        auto soup = generated_surfaces::closed_surface(genus, 2500);
        random_meshes::Combinatorial_mesh mesh = {soup.points.size(), soup.triangles};
        curve_samples::Random random(genus);
        random_meshes::remove_far_triangles(mesh, number_of_holes, random);
        soup.triangles = mesh.triangles;
        BOOST_TEST((test_harmonic_pants<Surface_mesh>(soup) == number_of_holes));
      }
}

BOOST_AUTO_TEST_CASE_TEMPLATE(an_edge_without_a_face_is_refused, Mesh, Meshes)
{
  auto mesh = curve_samples::make_mesh<Mesh>(generated_surfaces::closed_surface(2, 500));
  const auto h = halfedge(add_edge(mesh), mesh), g = opposite(h, mesh);
  set_target(h, *vertices(mesh).first, mesh);
  set_target(g, *std::next(vertices(mesh).first), mesh);
  BOOST_CHECK_THROW(CGAL::Reeb_graph::harmonic_pants_decomposition(mesh, CGAL::Emptyset_iterator()),
                    CGAL::Reeb_graph::Edge_without_face_error);
}

BOOST_AUTO_TEST_CASE(a_torus_is_refused)
{
  auto mesh = curve_samples::make_mesh<Surface_mesh>(generated_surfaces::torus(8, 12));
  std::vector<CGAL::Reeb_graph::Curve<Surface_mesh::Halfedge_index>> curves;
  BOOST_CHECK_THROW(
    CGAL::Reeb_graph::harmonic_pants_decomposition(mesh, std::back_inserter(curves), CGAL::parameters::cut_open(true)),
    CGAL::Reeb_graph::No_pants_decomposition_error);
  BOOST_TEST(num_vertices(mesh) == 96u);
}

BOOST_AUTO_TEST_SUITE_END()
