// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#include <boost/test/unit_test.hpp>

#include "random_meshes.h"

#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Labeled_mesh_domain_3.h>
#include <CGAL/Linear_cell_complex_for_combinatorial_map.h>
#include <CGAL/Mesh_complex_3_in_triangulation_3.h>
#include <CGAL/Mesh_triangulation_3.h>
#include <CGAL/Reeb_graph/Complex_augmentation.h>
#include <CGAL/Reeb_graph/arc_measures.h>
#include <CGAL/Reeb_graph/embed.h>
#include <CGAL/Reeb_graph/tetrahedra.h>
#include <CGAL/compute_reeb_graph_of_soup.h>

#include <boost/property_map/function_property_map.hpp>

#include <array>
#include <cmath>
#include <cstddef>
#include <set>
#include <type_traits>
#include <vector>

// Tetrahedra of the data structures of CGAL: all of them, of vertices with their points and values.

BOOST_AUTO_TEST_SUITE(test_tetrahedra)

typedef CGAL::Exact_predicates_inexact_constructions_kernel Kernel;
typedef Kernel::Point_3 Point;
typedef CGAL::Delaunay_triangulation_3<Kernel> Triangulation;
typedef CGAL::Mesh_triangulation_3<CGAL::Labeled_mesh_domain_3<Kernel>>::type Mesh_triangulation;
typedef CGAL::Mesh_complex_3_in_triangulation_3<Mesh_triangulation> Mesh_complex;
typedef CGAL::Linear_cell_complex_for_combinatorial_map<3> Linear_cell_complex;

namespace {
std::vector<Point> random_points(std::size_t number, std::size_t seed)
{
  random_meshes::Random random(seed);
  std::vector<Point> points;
  for(std::size_t i = 0; i < number; ++i)
  {
    const std::size_t z = random.below(1000), y = random.below(1000), x = random.below(1000);
    points.emplace_back(x, y, z);
  }
  return points;
}

template <class P>
double sixfold_volume(const P& a, const P& b, const P& c, const P& d)
{
  return std::abs(CGAL::to_double(CGAL::determinant(b - a, c - a, d - a)));
}

template <class Tetrahedra>
double sixfold_volume(const Tetrahedra& tetrahedra)
{
  double sum = 0;
  for(const auto& t : tetrahedra.tetrahedra)
    sum += sixfold_volume(tetrahedra.points[t[0]], tetrahedra.points[t[1]], tetrahedra.points[t[2]],
                          tetrahedra.points[t[3]]);
  return sum;
}

// Each tetrahedron has four different vertices, no two are the same, and the values are those of the vertices.
template <class Tetrahedra, class PointFunction>
void check(const Tetrahedra& tetrahedra, const PointFunction& point)
{
  std::set<std::set<std::size_t>> all;
  for(const auto& t : tetrahedra.tetrahedra)
  {
    const std::set<std::size_t> vertices(t.begin(), t.end());
    BOOST_TEST(vertices.size() == 4u);
    BOOST_TEST(*vertices.rbegin() < tetrahedra.vertices.size());
    BOOST_TEST(all.insert(vertices).second);
  }
  typedef typename Tetrahedra::Vertex_handle Vertex_handle;
  const auto height = [&](const Vertex_handle& v) { return CGAL::to_double(point(v).z()); };
  const auto scalars = tetrahedra.scalars(boost::make_function_property_map<Vertex_handle>(height));
  BOOST_TEST_REQUIRE(scalars.size() == tetrahedra.points.size());
  for(std::size_t v = 0; v < scalars.size(); ++v)
  {
    BOOST_TEST((tetrahedra.points[v] == point(tetrahedra.vertices[v])));
    BOOST_TEST(scalars[v] == CGAL::to_double(tetrahedra.points[v].z()));
  }
}
} // namespace

BOOST_AUTO_TEST_CASE(tetrahedra_of_a_triangulation_are_its_finite_cells)
{
  for(std::size_t seed = 0; seed < 20; ++seed)
    BOOST_TEST_CONTEXT("seed " << seed)
    {
      const auto points = random_points(4 + 3 * seed, seed);
      const Triangulation triangulation(points.begin(), points.end());
      const auto tetrahedra = CGAL::Reeb_graph::tetrahedra_of_triangulation(triangulation);
      static_assert(std::is_same_v<std::decay_t<decltype(tetrahedra.points.front())>, Point>);
      check(tetrahedra, [](Triangulation::Vertex_handle v) { return v->point(); });
      BOOST_TEST(tetrahedra.vertices.size() == triangulation.number_of_vertices());
      BOOST_TEST(tetrahedra.tetrahedra.size() == triangulation.number_of_finite_cells());
      double sum = 0;
      for(auto cell = triangulation.finite_cells_begin(); cell != triangulation.finite_cells_end(); ++cell)
        sum += sixfold_volume(cell->vertex(0)->point(), cell->vertex(1)->point(), cell->vertex(2)->point(),
                              cell->vertex(3)->point());
      BOOST_TEST(sixfold_volume(tetrahedra) == sum);
    }
}

// The manual shows what is between marks.
BOOST_AUTO_TEST_CASE(a_triangulation_has_a_graph_in_space_and_volumes)
{
  Triangulation triangulation;
  for(const int corner : {0, 1, 2, 3, 4, 5, 6, 7})
    triangulation.insert(Point(corner & 1, corner & 2, (corner & 4) * 0.75));
  CGAL::Reeb_graph_soup_traits<double>::Graph graph;
  //! [tetrahedra_of_triangulation]
  const auto cells = CGAL::Reeb_graph::tetrahedra_of_triangulation(triangulation);
  std::vector<double> scalars;
  for(const auto& point : cells.points)
    scalars.push_back(point.z());
  CGAL::compute_reeb_graph_of_tetrahedra(cells.points, cells.tetrahedra, scalars, graph);
  //! [tetrahedra_of_triangulation]
  BOOST_TEST(num_edges(graph) == 1);

  const auto& points = cells.points;
  const CGAL::Reeb_graph::Tetrahedra_augmentation augmentation(points, cells.tetrahedra, scalars, graph);
  //! [embed_complex]
  const auto embedding = CGAL::Reeb_graph::embed(augmentation, points);
  const auto volumes = CGAL::Reeb_graph::arc_volumes(augmentation, augmentation.locate_vertices(), points);
  //! [embed_complex]
  BOOST_TEST(embedding.node_points.size() == 2);
  BOOST_TEST(volumes.at(0) == 6, boost::test_tools::tolerance(1e-12));
}

BOOST_AUTO_TEST_CASE(a_triangulation_in_a_plane_has_no_tetrahedra)
{
  for(const std::size_t size : {0, 1, 2, 4})
  {
    const std::array<Point, 4> points = {Point(0, 0, 0), Point(1, 0, 0), Point(0, 1, 0), Point(1, 1, 0)};
    const auto tetrahedra =
      CGAL::Reeb_graph::tetrahedra_of_triangulation(Triangulation(points.begin(), points.begin() + size));
    BOOST_TEST(tetrahedra.points.size() == size);
    BOOST_TEST(tetrahedra.tetrahedra.empty());
  }
}

BOOST_AUTO_TEST_CASE(tetrahedra_of_a_complex_in_a_triangulation_are_its_cells)
{
  Mesh_complex complex;
  BOOST_TEST(CGAL::Reeb_graph::tetrahedra_of_complex(complex).vertices.empty());
  for(const Point& point : random_points(30, 1))
    complex.triangulation().insert(Mesh_triangulation::Weighted_point(point, 0.5));
  const Mesh_triangulation& triangulation = complex.triangulation();
  std::set<Mesh_triangulation::Vertex_handle> vertices;
  std::size_t number = 0;
  for(auto cell = triangulation.finite_cells_begin(); cell != triangulation.finite_cells_end() && number < 8; ++cell)
    if(++number % 2 == 0)
    {
      complex.add_to_complex(cell, 1);
      for(int i = 0; i < 4; ++i)
        vertices.insert(cell->vertex(i));
    }
  const auto tetrahedra = CGAL::Reeb_graph::tetrahedra_of_complex(complex);
  static_assert(std::is_same_v<std::decay_t<decltype(tetrahedra.points.front())>, Point>);
  check(tetrahedra, [](Mesh_triangulation::Vertex_handle v) { return v->point().point(); });
  BOOST_TEST(tetrahedra.tetrahedra.size() == 4u);
  BOOST_TEST(tetrahedra.vertices.size() == vertices.size());
}

BOOST_AUTO_TEST_CASE(tetrahedra_of_a_linear_cell_complex_are_its_volumes)
{
  typedef Linear_cell_complex::Point P;
  Linear_cell_complex complex;
  const auto first = complex.make_tetrahedron(P(0, 0, 0), P(1, 0, 0), P(0, 1, 0), P(0, 0, 1));
  const auto second = complex.make_tetrahedron(P(0, 0, 0), P(0, 1, 0), P(1, 0, 0), P(0, 0, -1));
  complex.make_tetrahedron(P(5, 0, 0), P(6, 0, 0), P(5, 1, 0), P(5, 0, 1));
  complex.sew<3>(first, second);
  const auto tetrahedra = CGAL::Reeb_graph::tetrahedra_of_linear_cell_complex(complex);
  typedef std::decay_t<decltype(tetrahedra.vertices.front())> Vertex;
  check(tetrahedra, [&](const Vertex& v) { return complex.point_of_vertex_attribute(v); });
  BOOST_TEST(tetrahedra.vertices.size() == 9u);
  BOOST_TEST(tetrahedra.tetrahedra.size() == 3u);
  BOOST_TEST(sixfold_volume(tetrahedra) == 3);

  complex.make_hexahedron(P(0, 0, 0), P(1, 0, 0), P(1, 1, 0), P(0, 1, 0), P(0, 1, 1), P(0, 0, 1), P(1, 0, 1),
                          P(1, 1, 1));
  const auto is_of_fourth_cell = [](const CGAL::Reeb_graph::Non_tetrahedral_cell_error& error) {
    return error.cell() == 3;
  };
  BOOST_CHECK_EXCEPTION(CGAL::Reeb_graph::tetrahedra_of_linear_cell_complex(complex),
                        CGAL::Reeb_graph::Non_tetrahedral_cell_error, is_of_fourth_cell);
}

BOOST_AUTO_TEST_SUITE_END()
