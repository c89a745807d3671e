// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#include <boost/test/unit_test.hpp>

#include "complex_oracle.h"
#include "generated_complexes.h"
#include "mesh_builders.h"
#include "random_complexes.h"
#include "random_meshes.h"
#include "soup_augmentation_checks.h"
#include "soup_samples.h"

#include <CGAL/Reeb_graph/Augmentation.h>
#include <CGAL/Reeb_graph/Complex_augmentation.h>
#include <CGAL/Reeb_graph/IO/polylines.h>
#include <CGAL/Reeb_graph/scalar_maps.h>
#include <CGAL/compute_reeb_graph_of_soup.h>

#include <algorithm>
#include <cstddef>
#include <ctime>
#include <iterator>
#include <set>
#include <type_traits>
#include <utility>
#include <vector>

// Contours in complexes that are manifolds: curves of surfaces, and surfaces in solids.

BOOST_AUTO_TEST_SUITE(test_soup_contours)

using namespace soup_augmentation_checks;
using namespace soup_samples;
using CGAL::Reeb_graph::Soup_augmentation;
using CGAL::Reeb_graph::Tetrahedra_augmentation;
using CGAL::Reeb_graph::Ties;
using random_complexes::Complex;
using random_meshes::Random;

namespace {
// Whether the sequences are the same, forwards or backwards, and if they are closed, from another point on.
bool is_turned(std::vector<Point> a, const std::vector<Point>& b, bool is_closed)
{
  for(const bool is_reversed : {false, true})
  {
    for(std::size_t i = 0; i < (is_closed ? a.size() : 1); ++i)
    {
      if(a == b)
        return true;
      if(is_closed)
        std::rotate(a.begin(), a.begin() + 1, a.end());
    }
    if(!is_reversed)
      std::reverse(a.begin(), a.end());
  }
  return false;
}
} // namespace

// The fan around vertex 0 has a peak in each second sector. Looking at all its edges for each contour would take a
// many times as long as the graph.
BOOST_AUTO_TEST_CASE(contours_at_a_hub_take_linear_time)
{
  constexpr std::size_t number_of_peaks = 40000;
  const auto hub = random_meshes::bipyramid(2 * number_of_peaks);
  std::vector<double> values = {0, 0.1};
  for(std::size_t i = 0; i != 2 * number_of_peaks; ++i)
    values.push_back(i % 2 == 0 ? -1 : 1);
  CGAL::Reeb_graph_soup_traits<double>::Graph graph;
  const std::clock_t start = std::clock();
  CGAL::compute_reeb_graph_of_soup(values.size(), hub.triangles, values, graph);
  const Soup_augmentation augmentation(values.size(), hub.triangles, values, graph);
  const std::clock_t middle = std::clock();
  BOOST_TEST(augmentation.contours_at_value(0.5).size() == number_of_peaks);
  BOOST_TEST(std::clock() - middle < 3 * (middle - start));
}

// The same points in the same order, but for where a closed curve begins, and for the direction.
BOOST_AUTO_TEST_CASE(contours_of_a_surface_are_those_of_its_soup)
{
  typedef mesh_builders::Surface_mesh Mesh;
  for(std::size_t seed = 0; seed < 200; ++seed)
    BOOST_TEST_CONTEXT("seed " << seed)
    {
      Random random(seed);
      const auto mesh_class =
        static_cast<random_meshes::Mesh_class>(seed % static_cast<int>(random_meshes::Mesh_class::NUMBER_OF_CLASSES));
      const auto combinatorial_mesh = random_meshes::random_mesh(mesh_class, random);
      const auto soup = mesh_builders::make_soup(combinatorial_mesh);
      const auto points = make_points(soup.points);
      const auto values = random_complexes::random_values(points.size(), random);
      const auto np = CGAL::parameters::ties(random.below(2) == 0 ? Ties::PERTURB : Ties::CONTRACT);
      const Mesh mesh = mesh_builders::make_mesh<Mesh>(soup);
      const auto scalar_map = CGAL::Reeb_graph::make_scalar_map(mesh, values);
      CGAL::Reeb_graph_traits<Mesh, std::decay_t<decltype(scalar_map)>>::Graph graph;
      CGAL::compute_reeb_graph(mesh, scalar_map, graph, np);
      const CGAL::Reeb_graph::Augmentation augmentation(mesh, scalar_map, graph, np);
      Graph soup_graph;
      CGAL::compute_reeb_graph_of_soup(points, soup.triangles, values, soup_graph, np);
      const Soup_augmentation soup_augmentation(points, soup.triangles, values, soup_graph, np);
      BOOST_REQUIRE(num_edges(graph) == num_edges(soup_graph));
      auto soup_arc = edges(soup_graph).first;
      for(const auto arc : CGAL::make_range(edges(graph)))
      {
        for(const double t : {0.25, 0.5})
        {
          const auto contour = augmentation.contour(arc, t);
          const auto soup_contour = soup_augmentation.contour(*soup_arc, t);
          std::vector<Point> expected, found;
          augmentation.points_of_contour(contour, std::back_inserter(expected));
          soup_augmentation.points_of_contour(soup_contour, std::back_inserter(found), points);
          BOOST_TEST(soup_contour.value == contour.value);
          BOOST_TEST(soup_contour.branch_points.empty());
          const auto polylines = CGAL::Reeb_graph::polylines_of_contour(soup_augmentation, soup_contour, points);
          BOOST_REQUIRE(polylines.size() == 1);
          BOOST_TEST((soup_contour.polylines[0].front() == soup_contour.polylines[0].back()) == contour.is_closed());
          const std::vector<Point> ordered(polylines[0].begin() + (contour.is_closed() ? 1 : 0), polylines[0].end());
          BOOST_TEST(is_turned(ordered, expected, contour.is_closed()));
          std::sort(found.begin(), found.end());
          std::sort(expected.begin(), expected.end());
          BOOST_TEST((found == expected));
        }
        ++soup_arc;
      }
    }
}

// In a 3-manifold, each contour is an oriented 2-manifold, however the tetrahedra are listed; its triangles point
// upwards if there are points.
BOOST_AUTO_TEST_CASE(contours_in_a_solid_are_oriented_manifolds)
{
  for(std::size_t seed = 0; seed < 12; ++seed)
    BOOST_TEST_CONTEXT("seed " << seed)
    {
      Random random(seed);
      auto solid = generated_surfaces::solid(5, 1 + seed % 2);
      for(auto& tetrahedron : solid.tetrahedra)
        for(std::size_t i = 4; i > 1; --i)
          std::swap(tetrahedron[i - 1], tetrahedron[random.below(i)]);
      random.shuffle(solid.tetrahedra);
      const auto points = make_points(solid.points);
      const bool is_linear = seed % 3 == 0;
      const auto& field =
        seed % 3 == 2 ? generated_surfaces::noise_field(solid.points) : generated_surfaces::smooth_field(solid.points);
      std::vector<double> values;
      for(std::size_t v = 0; v < points.size(); ++v)
        values.push_back(is_linear ? points[v].x() + 2 * points[v].y() + 3 * points[v].z() : field[v]);
      Graph graph;
      CGAL::compute_reeb_graph_of_tetrahedra(points, solid.tetrahedra, values, graph);
      const Tetrahedra_augmentation augmentation(points, solid.tetrahedra, values, graph);
      const Tetrahedra_augmentation without_points(points.size(), solid.tetrahedra, values, graph);
      for(const auto arc : CGAL::make_range(edges(graph)))
      {
        const auto patch = augmentation.contour(arc, 0.3), other = without_points.contour(arc, 0.3);
        BOOST_TEST(is_oriented_manifold(patch));
        BOOST_TEST(is_oriented_manifold(other));
        BOOST_TEST(other.edges == patch.edges);
        std::vector<Point> patch_points;
        augmentation.points_of_contour(patch, std::back_inserter(patch_points), points);
        for(const auto& t : patch.triangles)
        {
          const auto normal = CGAL::normal(patch_points[t[0]], patch_points[t[1]], patch_points[t[2]]);
          BOOST_TEST((!is_linear || normal * Kernel::Vector_3(1, 2, 3) > 0));
        }
      }
    }
}

// The projective plane times an interval is a 3-manifold that has no orientation, nor have its level sets; triangles
// are there all the same.
BOOST_AUTO_TEST_CASE(contours_without_orientation)
{
  const Complex plane = random_complexes::projective_plane();
  Complex complex = {12};
  std::vector<double> values;
  for(std::size_t v = 0; v < 12; ++v)
    values.push_back(v < 6 ? 0. : 1.);
  for(auto t : plane.triangles)
  {
    std::sort(t.begin(), t.end());
    complex.tetrahedra.push_back({t[0], t[1], t[2], t[2] + 6});
    complex.tetrahedra.push_back({t[0], t[1], t[1] + 6, t[2] + 6});
    complex.tetrahedra.push_back({t[0], t[0] + 6, t[1] + 6, t[2] + 6});
  }
  Graph graph;
  const auto np = CGAL::parameters::ties(Ties::CONTRACT);
  CGAL::compute_reeb_graph_of_tetrahedra(12, complex.tetrahedra, values, graph, np);
  BOOST_REQUIRE(num_edges(graph) == 1);
  const Tetrahedra_augmentation augmentation(12, complex.tetrahedra, values, graph, np);
  const auto patch = augmentation.contour(*edges(graph).first, 0.5);
  BOOST_TEST(fault_of_patch(patch, different(complex.tetrahedra)) == "");
  std::set<Edge> sides;
  for(const auto& t : patch.triangles)
    for(std::size_t i = 0; i < 3; ++i)
      sides.insert(complex_oracle::make_edge(t[i], t[(i + 1) % 3]));
  BOOST_TEST(patch.edges.size() + patch.triangles.size() == sides.size() + 1);
  BOOST_TEST(2 * sides.size() == 3 * patch.triangles.size());
  BOOST_TEST(!is_oriented_manifold(patch));
}

BOOST_AUTO_TEST_SUITE_END()
