// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#include <boost/test/unit_test.hpp>

#include "generated_complexes.h"
#include "mesh_builders.h"
#include "random_complexes.h"
#include "random_meshes.h"
#include "soup_samples.h"

#include <CGAL/Reeb_graph/Augmentation.h>
#include <CGAL/Reeb_graph/Complex_augmentation.h>
#include <CGAL/Reeb_graph/IO.h>
#include <CGAL/Reeb_graph/IO/svg.h>
#include <CGAL/Reeb_graph/arc_measures.h>
#include <CGAL/Reeb_graph/embed.h>
#include <CGAL/Reeb_graph/scalar_maps.h>
#include <CGAL/compute_reeb_graph_of_soup.h>

#include <boost/property_map/property_map.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <sstream>
#include <type_traits>
#include <vector>

// The graphs of soups and tetrahedra in space, and in files.

BOOST_AUTO_TEST_SUITE(test_soup_embedding)

using namespace soup_samples;
using CGAL::Reeb_graph::Soup_augmentation;
using CGAL::Reeb_graph::Tetrahedra_augmentation;
using random_complexes::Complex;
using random_meshes::Random;

namespace {
// Whether a point is in a triangle or a tetrahedron, but for rounding.
bool is_in_a_simplex(const Point& point, const std::vector<Point>& points, const Complex& complex)
{
  for(const auto& t : complex.triangles)
    if(CGAL::squared_distance(point, Kernel::Triangle_3(points[t[0]], points[t[1]], points[t[2]])) < 1e-20)
      return true;
  for(const auto& t : complex.tetrahedra)
  {
    double volumes = 0;
    for(std::size_t i = 0; i < 4; ++i)
    {
      std::array<Point, 4> corners = {points[t[0]], points[t[1]], points[t[2]], points[t[3]]};
      corners[i] = point;
      volumes += std::abs(CGAL::volume(corners[0], corners[1], corners[2], corners[3]));
    }
    if(std::abs(volumes - std::abs(CGAL::volume(points[t[0]], points[t[1]], points[t[2]], points[t[3]]))) < 1e-14)
      return true;
  }
  return false;
}

// On a field that is linear in space, each point of an embedding has its value.
template <class Augmentation>
void check_embeddings(const Augmentation& augmentation, const std::vector<Point>& points, const Complex& complex)
{
  using CGAL::Reeb_graph::Embedding_manner;
  const Graph& graph = augmentation.graph();
  for(const Embedding_manner manner :
      {Embedding_manner::CENTROIDS, Embedding_manner::ON_SURFACE, Embedding_manner::STRAIGHT})
  {
    const auto embedding = CGAL::Reeb_graph::embed(augmentation, points, CGAL::parameters::embedding_manner(manner));
    BOOST_TEST(embedding.node_points.size() == num_vertices(graph));
    BOOST_REQUIRE(embedding.arc_polylines.size() == num_edges(graph));
    std::size_t i = 0;
    for(const auto arc : CGAL::make_range(edges(graph)))
    {
      const auto& polyline = embedding.arc_polylines[i];
      BOOST_TEST((polyline.front() == embedding.node_points[source(arc, graph)]));
      BOOST_TEST((polyline.back() == embedding.node_points[target(arc, graph)]));
      BOOST_TEST(std::is_sorted(embedding.arc_values[i].begin(), embedding.arc_values[i].end()));
      BOOST_REQUIRE(polyline.size() == embedding.arc_values[i].size());
      for(std::size_t j = 0; j < polyline.size(); ++j)
        BOOST_TEST(std::abs(polyline[j].z() - embedding.arc_values[i][j]) < 1e-12);
      if(manner == Embedding_manner::ON_SURFACE)
        for(std::size_t j = 1; j < polyline.size(); ++j)
          BOOST_TEST(is_in_a_simplex(CGAL::midpoint(polyline[j - 1], polyline[j]), points, complex));
      ++i;
    }
  }
  BOOST_CHECK_THROW(CGAL::Reeb_graph::embed(augmentation, std::vector<Point>(points.size() + 1)),
                    CGAL::Reeb_graph::Attribute_count_error);
  BOOST_CHECK_THROW(
    CGAL::Reeb_graph::embed(augmentation, points, CGAL::parameters::callback([](double) { return false; })),
    CGAL::Reeb_graph::Cancelled_error);
}
} // namespace

BOOST_AUTO_TEST_CASE(graphs_of_soups_and_tetrahedra_in_space)
{
  const auto foam = generated_surfaces::foam(2, 1, 1, 1);
  const auto solid = generated_surfaces::solid(4, 1);
  const auto heights = [](const std::vector<Point>& points) {
    std::vector<double> result;
    for(const Point& point : points)
      result.push_back(point.z());
    return result;
  };
  const auto points = make_points(foam.points), points_of_solid = make_points(solid.points);
  Graph graph, graph_of_solid;
  CGAL::compute_reeb_graph_of_soup(points, foam.triangles, heights(points), graph);
  CGAL::compute_reeb_graph_of_tetrahedra(points_of_solid, solid.tetrahedra, heights(points_of_solid), graph_of_solid);
  check_embeddings(Soup_augmentation(points, foam.triangles, heights(points), graph), points,
                   {points.size(), foam.triangles});
  check_embeddings(Tetrahedra_augmentation(points_of_solid, solid.tetrahedra, heights(points_of_solid), graph_of_solid),
                   points_of_solid, {points_of_solid.size(), {}, {}, solid.tetrahedra});
}

// What is measured of the arcs of a surface is the same of the soup of its triangles, and the volumes of arcs are those of
// the tetrahedra, each of which counts once.
BOOST_AUTO_TEST_CASE(arcs_of_soups_and_tetrahedra_are_measured)
{
  typedef mesh_builders::Surface_mesh Mesh;
  namespace Reeb_graph = CGAL::Reeb_graph;
  const auto tolerance = boost::test_tools::tolerance(1e-12);
  Random random(8);
  for(int round = 0; round < 20; ++round)
  {
    auto soup = mesh_builders::make_soup(random_meshes::random_closed_surface(round % 3, 9, random));
    const auto points = make_points(soup.points);
    const auto values = random_meshes::random_permutation(points.size(), random);
    const Mesh mesh = mesh_builders::make_mesh<Mesh>(soup);
    const auto scalar_map = Reeb_graph::make_scalar_map(mesh, values);
    CGAL::Reeb_graph_traits<Mesh, std::decay_t<decltype(scalar_map)>>::Graph graph;
    CGAL::compute_reeb_graph(mesh, scalar_map, graph);
    soup.triangles.push_back(soup.triangles.front());
    Graph soup_graph;
    CGAL::compute_reeb_graph_of_soup(points, soup.triangles, values, soup_graph);
    const Reeb_graph::Augmentation augmentation(mesh, scalar_map, graph);
    const Soup_augmentation soup_augmentation(points, soup.triangles, values, soup_graph);
    const auto lengths = Reeb_graph::arc_lengths(mesh, scalar_map, graph);
    const auto areas = Reeb_graph::arc_areas(mesh, graph, augmentation.locate_vertices());
    const auto soup_lengths = Reeb_graph::arc_lengths(soup_augmentation, points);
    const auto soup_areas = Reeb_graph::arc_areas(soup_augmentation, soup_augmentation.locate_vertices(), points);
    BOOST_REQUIRE(soup_lengths.size() == lengths.size());
    const auto means = Reeb_graph::arc_mean_values(mesh, scalar_map, graph, augmentation.locate_vertices());
    const auto soup_means = Reeb_graph::arc_mean_values(soup_augmentation, soup_augmentation.locate_vertices(), points);
    BOOST_REQUIRE(soup_areas.size() == areas.size());
    BOOST_REQUIRE(soup_means.size() == areas.size());
    for(std::size_t arc = 0; arc < lengths.size(); ++arc)
    {
      BOOST_TEST(soup_lengths[arc] == lengths[arc], tolerance);
      BOOST_TEST(soup_areas[arc] == areas[arc], tolerance);
      BOOST_TEST(soup_means[arc] == means[arc], tolerance);
    }
    BOOST_CHECK_THROW(Reeb_graph::arc_lengths(soup_augmentation, std::vector<Point>(points.size() - 1)),
                      Reeb_graph::Attribute_count_error);
  }

  auto solid = generated_surfaces::solid(3, 2);
  const auto points = make_points(solid.points);
  const auto values = random_meshes::random_permutation(points.size(), random);
  double volume = 0, integral = 0;
  for(const auto& t : solid.tetrahedra)
  {
    const double its_volume = std::abs(CGAL::volume(points[t[0]], points[t[1]], points[t[2]], points[t[3]]));
    volume += its_volume;
    integral += its_volume * (values[t[0]] + values[t[1]] + values[t[2]] + values[t[3]]) / 4;
  }
  solid.tetrahedra.push_back(solid.tetrahedra.front());
  Graph graph;
  CGAL::compute_reeb_graph_of_tetrahedra(points, solid.tetrahedra, values, graph);
  const Tetrahedra_augmentation augmentation(points, solid.tetrahedra, values, graph);
  const auto volumes = Reeb_graph::arc_volumes(augmentation, augmentation.locate_vertices(), points);
  BOOST_TEST(volumes.size() == num_edges(graph));
  BOOST_TEST(std::accumulate(volumes.begin(), volumes.end(), 0.) == volume, tolerance);
  BOOST_TEST(Reeb_graph::arc_lengths(augmentation, points).size() == num_edges(graph));
  const auto means = Reeb_graph::arc_mean_values(augmentation, augmentation.locate_vertices(), points);
  BOOST_TEST(std::inner_product(means.begin(), means.end(), volumes.begin(), 0.) == integral, tolerance);
}

// An edge beside a triangle: the one arc has the area of the triangle, and the other one none.
BOOST_AUTO_TEST_CASE(means_of_edges_are_in_the_middle)
{
  const std::vector<Point> points = {Point(0, 0, 0), Point(1, 0, 0), Point(0, 1, 0), Point(2, 0, 0), Point(3, 0, 0)};
  const std::vector<std::array<std::size_t, 3>> triangles = {{0, 1, 2}};
  const std::vector<std::array<std::size_t, 2>> edges = {{3, 4}};
  const std::vector<double> values = {0, 1, 5, 7, 10};
  Graph graph;
  CGAL::compute_reeb_graph_of_soup(points, triangles, values, graph, CGAL::parameters::edges(edges));
  const Soup_augmentation augmentation(points, triangles, values, graph, CGAL::parameters::edges(edges));
  const auto means = CGAL::Reeb_graph::arc_mean_values(augmentation, augmentation.locate_vertices(), points);
  BOOST_TEST(means == (std::vector<double>{2, 8.5}), boost::test_tools::per_element());
}

// All writers write of a soup's graph what they write of the graph of the surface.
BOOST_AUTO_TEST_CASE(graphs_of_soups_are_written)
{
  typedef mesh_builders::Surface_mesh Mesh;
  namespace Reeb_graph = CGAL::Reeb_graph;
  Random random(5);
  const auto soup = mesh_builders::make_soup(random_meshes::random_closed_surface(2, 9, random));
  const auto points = make_points(soup.points);
  const auto values = random_meshes::random_permutation(points.size(), random);
  const Mesh mesh = mesh_builders::make_mesh<Mesh>(soup);
  const auto scalar_map = Reeb_graph::make_scalar_map(mesh, values);
  CGAL::Reeb_graph_traits<Mesh, std::decay_t<decltype(scalar_map)>>::Graph graph;
  CGAL::compute_reeb_graph(mesh, scalar_map, graph);
  Graph soup_graph;
  CGAL::compute_reeb_graph_of_soup(points, soup.triangles, values, soup_graph);
  const auto np = CGAL::parameters::embedding_manner(Reeb_graph::Embedding_manner::STRAIGHT);
  const auto embedding = Reeb_graph::embed(Reeb_graph::Augmentation(mesh, scalar_map, graph), np);
  const auto soup_embedding =
    Reeb_graph::embed(Soup_augmentation(points, soup.triangles, values, soup_graph), points, np);

  const auto vertex_index_map = get(boost::vertex_index, mesh);
  const boost::typed_identity_property_map<std::size_t> identity;
  const auto write = [&](const auto& write_one) {
    std::ostringstream out, soup_out;
    write_one(out, graph, embedding, vertex_index_map);
    write_one(soup_out, soup_graph, soup_embedding, identity);
    BOOST_TEST(out.str() == soup_out.str());
    BOOST_TEST(out.str().size() > 100u);
  };
  write([](auto& out, const auto& g, const auto&, const auto& map) { Reeb_graph::write_graphml(out, g, map); });
  write([](auto& out, const auto& g, const auto&, const auto& map) { Reeb_graph::write_graphviz(out, g, map); });
  write([](auto& out, const auto& g, const auto& e, const auto& map) { Reeb_graph::write_nodes_csv(out, g, e, map); });
  write([](auto& out, const auto& g, const auto& e, const auto&) { Reeb_graph::write_arcs_csv(out, g, e); });
  write([](auto& out, const auto& g, const auto& e, const auto& map) { Reeb_graph::write_vtp(out, g, e, map); });
  write([](auto& out, const auto& g, const auto& e, const auto&) { Reeb_graph::write_obj(out, g, e); });
  write([](auto& out, const auto& g, const auto&, const auto& map) {
    Reeb_graph::write_svg(out, g, CGAL::parameters::vertex_index_map(map));
  });
  std::ostringstream json, soup_json;
  Reeb_graph::write_json(json, mesh, graph, embedding, vertex_index_map);
  Reeb_graph::write_json(soup_json, soup_graph, soup_embedding);
  BOOST_TEST(json.str() == soup_json.str());
}

BOOST_AUTO_TEST_SUITE_END()
