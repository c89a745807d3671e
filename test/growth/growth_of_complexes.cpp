// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors
#include "Table.h"
#include "generated_complexes.h"

#include <CGAL/Reeb_graph/Complex_augmentation.h>
#include <CGAL/Reeb_graph/arc_measures.h>
#include <CGAL/Reeb_graph/embed.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/compute_reeb_graph_of_soup.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <memory>
#include <string>
#include <utility>
#include <vector>

// Complexes that are no surfaces: books, stars, foams, and tetrahedra.
namespace growth {
namespace {
using namespace CGAL::Reeb_graph;
using generated_surfaces::Triangle_soup;
typedef CGAL::Simple_cartesian<double>::Point_3 Point;
typedef CGAL::Reeb_graph_soup_traits<double>::Graph Graph;

struct Soup
{
  typedef CGAL::Reeb_graph::Soup_augmentation<double> Augmentation;
  static void compute(std::size_t n,
                      const std::vector<std::array<std::size_t, 3>>& cells,
                      const std::vector<double>& values,
                      Graph& graph)
  {
    CGAL::compute_reeb_graph_of_soup(n, cells, values, graph);
  }
  static const auto& cells(const Triangle_soup& soup) { return soup.triangles; }
  template <class VertexPlaces>
  static std::size_t measure(const Augmentation& augmentation,
                             const std::vector<Point>& points,
                             const VertexPlaces& vertex_places)
  {
    return 0
         * (arc_areas(augmentation, vertex_places, points).size()
            + arc_mean_values(augmentation, vertex_places, points).size());
  }
};

struct Solid
{
  typedef CGAL::Reeb_graph::Tetrahedra_augmentation<double> Augmentation;
  static void compute(std::size_t n,
                      const std::vector<std::array<std::size_t, 4>>& cells,
                      const std::vector<double>& values,
                      Graph& graph)
  {
    CGAL::compute_reeb_graph_of_tetrahedra(n, cells, values, graph);
  }
  static const auto& cells(const generated_surfaces::Tetrahedron_soup& soup) { return soup.tetrahedra; }
  template <class VertexPlaces>
  static std::size_t measure(const Augmentation& augmentation,
                             const std::vector<Point>& points,
                             const VertexPlaces& vertex_places)
  {
    return 0
         * (arc_volumes(augmentation, vertex_places, points).size()
            + arc_mean_values(augmentation, vertex_places, points).size());
  }
};

template <class Kind, class Cells>
struct Complex
{
  Complex(Cells given, bool is_noise)
    : complex(std::move(given)),
      values(is_noise ? generated_surfaces::noise_field(complex.points)
                      : generated_surfaces::smooth_field(complex.points))
  {
    compute(graph);
    augmentation = make_augmentation();
    for(const auto& p : complex.points)
      points.emplace_back(p[0], p[1], p[2]);
  }
  std::size_t size() const { return Kind::cells(complex).size(); }
  void compute(Graph& result) const { Kind::compute(values.size(), Kind::cells(complex), values, result); }
  std::unique_ptr<const typename Kind::Augmentation> make_augmentation() const
  {
    return std::make_unique<const typename Kind::Augmentation>(values.size(), Kind::cells(complex), values, graph);
  }

  std::size_t measure() const { return Kind::measure(*augmentation, points, augmentation->locate_vertices()); }

  Cells complex;
  std::vector<double> values;
  std::vector<Point> points;
  Graph graph;
  std::unique_ptr<const typename Kind::Augmentation> augmentation;
};

// A triangle to each second corner of a fan around vertex 0: as many leaves, no two of which share an edge.
Triangle_soup star(std::size_t triangles)
{
  Triangle_soup soup = {{{0, 0, 0}}, {}};
  for(std::size_t i = 0; i < triangles; ++i)
  {
    const double angle = 6.28318530717958648 * static_cast<double>(i) / static_cast<double>(triangles);
    soup.points.push_back({std::cos(angle), std::sin(angle), 1});
    soup.points.push_back({std::cos(angle), std::sin(angle), -1});
    soup.triangles.push_back({0, 2 * i + 1, 2 * i + 2});
  }
  return soup;
}

std::size_t root(double number, double degree) { return static_cast<std::size_t>(std::pow(number, 1 / degree)); }

template <class Subject>
std::vector<Function<Subject>> functions()
{
  return {
    {"compute_reeb_graph_of_...",
     [](const Subject& s) {
       Graph graph;
       s.compute(graph);
       return std::size_t(0);
     }},
    {"..._augmentation",
     [](const Subject& s) {
       s.make_augmentation();
       return std::size_t(0);
     }},
    {"locate_vertices",
     [](const Subject& s) {
       s.augmentation->locate_vertices();
       return std::size_t(0);
     }},
    {"locate_vertices, arc_areas or arc_volumes, arc_mean_values", [](const Subject& s) { return s.measure(); }},
    {"arc_lengths",
     [](const Subject& s) {
       std::size_t sum = 0;
       for(const auto arc : CGAL::make_range(edges(s.graph)))
         sum += s.graph[arc].chain.size();
       return sum + 0 * arc_lengths(*s.augmentation, s.points).size();
     }},
    {"contours_at_value",
     [](const Subject& s) {
       std::size_t sum = 0;
       for(const auto& contour : s.augmentation->contours_at_value(s.graph[num_vertices(s.graph) / 2].value))
         sum += contour.edges.size();
       return sum;
     }},
    {"embed",
     [](const Subject& s) {
       CGAL::Reeb_graph::embed(*s.augmentation, s.points);
       return std::size_t(0);
     }},
  };
}

template <class Subject, class MakeCells>
void measure(Table& table, const std::string& name, const MakeCells& make_cells)
{
  for(const bool is_noise : {false, true})
  {
    std::array<std::unique_ptr<const Subject>, 3> subjects;
    for(std::size_t i = 0; i < 3; ++i)
      subjects[i] = std::make_unique<const Subject>(make_cells(40000. * (1 << i)), is_noise);
    for(const Function<Subject>& function : functions<Subject>())
      table.measure(name + (is_noise ? ", noise" : ", smooth"), subjects, function);
  }
}
} // namespace

void measure_complexes(Table& table)
{
  namespace surfaces = generated_surfaces;
  typedef Complex<Soup, Triangle_soup> Triangles;
  typedef Complex<Solid, surfaces::Tetrahedron_soup> Tetrahedra;
  measure<Triangles>(table, "star", [](double size) { return star(static_cast<std::size_t>(size)); });
  measure<Triangles>(table, "book of many pages",
                     [](double size) { return surfaces::book(static_cast<std::size_t>(size / 32), 4); });
  measure<Triangles>(table, "book of large pages", [](double size) { return surfaces::book(8, root(size / 16, 2)); });
  measure<Triangles>(table, "foam", [](double size) {
    const std::size_t cells = root(size / 100, 3); // of 100 triangles each
    return surfaces::foam(cells, cells, cells, 1);
  });
  measure<Triangles>(table, "foam with k^3 holes", [](double size) {
    const std::size_t cells = root(size / 100, 3);
    return surfaces::with_holes(surfaces::foam(cells, cells, cells, 1), 1000);
  });
  measure<Tetrahedra>(table, "solid", [](double size) { return surfaces::solid(root(size / 6, 3)); });
  measure<Tetrahedra>(table, "solid with k^2 tunnels", [](double size) {
    const std::size_t cubes = root(size / 4, 3);
    return surfaces::solid(cubes, (cubes - 1) / 4);
  });
}
} // namespace growth
