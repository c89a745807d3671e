// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#include "test_headers.h"

#include "generated_complexes.h"
#include "mesh_builders.h"
#include "random_complexes.h"
#include "random_meshes.h"
#include "soup_augmentation_checks.h"
#include "soup_samples.h"

#include <CGAL/Reeb_graph/Augmentation.h>
#include <CGAL/Reeb_graph/Complex_augmentation.h>
#include <CGAL/Reeb_graph/arc_measures.h>
#include <CGAL/Reeb_graph/embed.h>
#include <CGAL/Reeb_graph/scalar_maps.h>
#include <CGAL/compute_reeb_graph.h>
#include <CGAL/compute_reeb_graph_of_soup.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <set>
#include <type_traits>
#include <utility>
#include <vector>

// One function for surfaces, triangle soups and tetrahedra, compared with contours by definition: components of the
// crossed edges that are joined by cells, and the pieces of a level set inside of each cell.

BOOST_AUTO_TEST_SUITE(test_contour_access)

using namespace soup_samples;
using random_meshes::Random;

namespace {
//! [any_augmentation]
struct Numbers
{
  double length = 0, area = 0; // of a level set
  std::vector<double> arc_lengths, arc_means;
  CGAL::Reeb_graph::Embedding<Point> embedding;
};

template <class Augmentation, class Points>
Numbers numbers_of(const Augmentation& augmentation, const Points& points, double value)
{
  Numbers numbers;
  for(const auto& contour : augmentation.contours_at_value(value))
  {
    std::vector<Point> p;
    augmentation.points_of_contour(contour, std::back_inserter(p), points);
    contour.for_each_line([&](std::size_t i, std::size_t j) {
      numbers.length += std::sqrt(CGAL::squared_distance(p[i], p[j])); // none in tetrahedra
    });
    contour.for_each_triangle([&](std::size_t i, std::size_t j, std::size_t k) {
      numbers.area += std::sqrt(CGAL::squared_area(p[i], p[j], p[k]));
    });
  }
  numbers.arc_lengths = CGAL::Reeb_graph::arc_lengths(augmentation, points);
  numbers.arc_means = CGAL::Reeb_graph::arc_mean_values(augmentation, augmentation.locate_vertices(), points);
  numbers.embedding = CGAL::Reeb_graph::embed(augmentation, points);
  return numbers;
}
//! [any_augmentation]

typedef std::pair<std::size_t, std::size_t> Edge; // from the lower to the higher vertex
typedef std::set<std::set<Edge>> Components;

// What a level set is by definition.
struct Level_set
{
  Components components;
  double length = 0, area = 0;
};

std::size_t root(std::vector<std::size_t>& parents, std::size_t i)
{
  while(parents[i] != i)
    i = parents[i] = parents[parents[i]];
  return i;
}

template <class Cells>
Level_set level_set(const std::vector<Point>& points,
                    const Cells& cells,
                    const std::vector<double>& values,
                    double value)
{
  Level_set result;
  std::vector<Edge> edges;
  std::vector<std::size_t> parents;
  for(const auto& cell : cells)
  {
    std::vector<std::size_t> crossed;
    std::vector<Point> section;
    for(const std::size_t low : cell)
      for(const std::size_t high : cell)
      {
        if(values[low] > value || values[high] <= value)
          continue;
        const auto found = std::find(edges.begin(), edges.end(), Edge(low, high));
        crossed.push_back(static_cast<std::size_t>(found - edges.begin()));
        if(found == edges.end())
        {
          edges.push_back({low, high});
          parents.push_back(parents.size());
        }
        parents[root(parents, crossed[0])] = root(parents, crossed.back());
        const double t = (value - values[low]) / (values[high] - values[low]);
        section.push_back(points[low] + t * (points[high] - points[low]));
      }
    // Points come by their lower vertices, so that two triangles of a strip make a section of four.
    if(section.size() == 2)
      result.length += std::sqrt(CGAL::squared_distance(section[0], section[1]));
    for(std::size_t i = 2; i < section.size(); ++i)
      result.area += std::sqrt(CGAL::squared_area(section[i - 2], section[i - 1], section[i]));
  }
  std::vector<std::set<Edge>> components(edges.size());
  for(std::size_t i = 0; i < edges.size(); ++i)
    components[root(parents, i)].insert(edges[i]);
  for(const std::set<Edge>& component : components)
    if(!component.empty())
      result.components.insert(component);
  return result;
}

template <class Augmentation>
Components components_of(const Augmentation& augmentation, double value)
{
  Components components;
  for(const auto& contour : augmentation.contours_at_value(value))
  {
    std::set<Edge> component;
    for(std::size_t i = 0; i < contour.number_of_crossings(); ++i)
      component.insert({source(contour.edge(i), augmentation.mesh()), target(contour.edge(i), augmentation.mesh())});
    BOOST_TEST(component.size() == contour.number_of_crossings());
    components.insert(component);
  }
  return components;
}

// A closed contour has no end: no point of one line, and no side of one triangle.
template <class Augmentation>
void check_ends(const Augmentation& augmentation, double value)
{
  for(const auto& contour : augmentation.contours_at_value(value))
  {
    std::vector<std::size_t> numbers(contour.number_of_crossings(), 0); // of lines
    std::vector<std::size_t> in_polylines;
    std::multiset<std::pair<std::size_t, std::size_t>> sides;
    contour.for_each_line([&](std::size_t i, std::size_t j) {
      ++numbers[i];
      ++numbers[j];
      sides.insert(std::minmax(i, j));
    });
    contour.for_each_polyline([&](const std::vector<std::size_t>& line) {
      for(std::size_t i = 1; i < line.size(); ++i)
        BOOST_TEST(sides.erase(std::minmax({line[i - 1], line[i]})) == 1u);
    });
    BOOST_TEST(sides.empty());
    bool has_triangles = false;
    contour.for_each_triangle([&](std::size_t i, std::size_t j, std::size_t k) {
      has_triangles = true;
      sides.insert({std::minmax({i, j}), std::minmax({j, k}), std::minmax({k, i})});
    });
    const bool is_closed =
      has_triangles ? std::all_of(sides.begin(), sides.end(), [&](const auto& side) { return sides.count(side) > 1; })
                    : std::all_of(numbers.begin(), numbers.end(), [](std::size_t number) { return number == 2; });
    BOOST_TEST(contour.is_closed() == is_closed);
    for(std::size_t i = 0; i < contour.number_of_crossings(); ++i)
    {
      const double lower = augmentation.value(source(contour.edge(i), augmentation.mesh())),
                   upper = augmentation.value(target(contour.edge(i), augmentation.mesh()));
      BOOST_TEST(std::abs(lower + augmentation.fraction(contour, i) * (upper - lower) - contour.value)
                 <= 1e-12 * (1 + std::abs(lower) + std::abs(upper)));
    }
  }
}

template <class Augmentation, class Points, class Cells>
void check(const Augmentation& augmentation,
           const Points& map,
           const std::vector<Point>& points,
           const Cells& cells,
           const std::vector<double>& values)
{
  if(values.empty())
    return;
  const auto& graph = augmentation.graph();
  for(const double part : {0.2, 0.5, 0.8})
  {
    std::vector<double> sorted = values;
    std::sort(sorted.begin(), sorted.end());
    const double value = sorted[static_cast<std::size_t>(part * static_cast<double>(sorted.size()))];
    const Level_set expected = level_set(points, cells, values, value);
    const Numbers numbers = numbers_of(augmentation, map, value);
    BOOST_TEST((components_of(augmentation, value) == expected.components));
    BOOST_TEST(std::abs(numbers.length - expected.length) <= 1e-9 * (1 + expected.length));
    BOOST_TEST(std::abs(numbers.area - expected.area) <= 1e-9 * (1 + expected.area));
    check_ends(augmentation, value);
    std::size_t arc_number = 0;
    for(const auto arc : CGAL::make_range(edges(graph)))
    {
      const Point lower = numbers.embedding.node_points[source(arc, graph)];
      BOOST_TEST(numbers.embedding.arc_polylines[arc_number].front() == lower);
      BOOST_TEST(numbers.arc_lengths[arc_number] >= 0);
      BOOST_TEST(numbers.arc_means[arc_number] >= sorted.front());
      BOOST_TEST(numbers.arc_means[arc_number++] <= sorted.back());
    }
  }
}
} // namespace

// The same numbers for a surface and for its soup.
BOOST_AUTO_TEST_CASE(contours_of_surfaces_and_of_soups_by_definition)
{
  typedef mesh_builders::Surface_mesh Mesh;
  for(std::size_t seed = 0; seed < 60; ++seed)
    BOOST_TEST_CONTEXT("seed " << seed)
    {
      Random random(seed);
      const auto mesh_class =
        static_cast<random_meshes::Mesh_class>(seed % static_cast<int>(random_meshes::Mesh_class::NUMBER_OF_CLASSES));
      const auto soup = mesh_builders::make_soup(random_meshes::random_mesh(mesh_class, random));
      const auto points = make_points(soup.points);
      const auto values = random_complexes::random_values(points.size(), random);
      const Mesh mesh = mesh_builders::make_mesh<Mesh>(soup);
      const auto scalar_map = CGAL::Reeb_graph::make_scalar_map(mesh, values);
      CGAL::Reeb_graph_traits<Mesh, std::decay_t<decltype(scalar_map)>>::Graph graph;
      CGAL::compute_reeb_graph(mesh, scalar_map, graph);
      const CGAL::Reeb_graph::Augmentation augmentation(mesh, scalar_map, graph);
      check(augmentation, mesh.points(), points, soup.triangles, values);
      Graph soup_graph;
      CGAL::compute_reeb_graph_of_soup(points, soup.triangles, values, soup_graph);
      const CGAL::Reeb_graph::Soup_augmentation soup_augmentation(points, soup.triangles, values, soup_graph);
      check(soup_augmentation, points, points, soup.triangles, values);

      const auto places = augmentation.locate_vertices();
      BOOST_TEST(
        (CGAL::Reeb_graph::arc_lengths(augmentation) == CGAL::Reeb_graph::arc_lengths(mesh, scalar_map, graph)));
      BOOST_TEST(
        (CGAL::Reeb_graph::arc_areas(augmentation, places) == CGAL::Reeb_graph::arc_areas(mesh, graph, places)));
      BOOST_TEST((CGAL::Reeb_graph::arc_mean_values(augmentation, places)
                  == CGAL::Reeb_graph::arc_mean_values(mesh, scalar_map, graph, places)));
      BOOST_CHECK_THROW(CGAL::Reeb_graph::embed(soup_augmentation, std::vector<Point>(points.size() + 1)),
                        CGAL::Reeb_graph::Attribute_count_error);
    }
}

BOOST_AUTO_TEST_CASE(contours_in_triangles_by_definition)
{
  for(std::size_t seed = 0; seed < 60; ++seed)
    BOOST_TEST_CONTEXT("seed " << seed)
    {
      Random random(seed);
      const auto complex_class = static_cast<random_complexes::Complex_class>(
        seed % static_cast<int>(random_complexes::Complex_class::NUMBER_OF_CLASSES));
      const auto complex = random_complexes::random_complex(complex_class, random);
      std::vector<Point> points;
      for(std::size_t v = 0; v < complex.number_of_vertices; ++v)
        points.emplace_back(double(random.below(1000)), double(random.below(1000)), double(random.below(1000)));
      const auto values = random_complexes::random_values(points.size(), random);
      if(complex.triangles.empty())
        continue;
      Graph graph;
      CGAL::compute_reeb_graph_of_soup(points, complex.triangles, values, graph);
      check(CGAL::Reeb_graph::Soup_augmentation(points, complex.triangles, values, graph), points, points,
            soup_augmentation_checks::different(complex.triangles), values);
    }
}

BOOST_AUTO_TEST_CASE(contours_in_tetrahedra_by_definition)
{
  for(std::size_t seed = 0; seed < 8; ++seed)
    BOOST_TEST_CONTEXT("seed " << seed)
    {
      const auto solid = generated_surfaces::solid(4, 1 + seed % 2);
      const auto points = make_points(solid.points);
      const auto values =
        seed % 4 < 2 ? generated_surfaces::noise_field(solid.points) : generated_surfaces::smooth_field(solid.points);
      Graph graph;
      CGAL::compute_reeb_graph_of_tetrahedra(points, solid.tetrahedra, values, graph);
      check(CGAL::Reeb_graph::Tetrahedra_augmentation(points, solid.tetrahedra, values, graph), points, points,
            solid.tetrahedra, values);
    }
}

BOOST_AUTO_TEST_SUITE_END()
