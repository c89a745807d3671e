// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_BENCHMARK_COMPLEX_TABLE_H
#define CGAL_REEB_GRAPH_BENCHMARK_COMPLEX_TABLE_H

#include "Table.h"
#include "generated_complexes.h"
#include "inputs.h"
#include "measurements.h"
#include "tables.h"

#include <CGAL/compute_reeb_graph_of_soup.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

// Soups and tetrahedra with one thread: from the list of simplices to the graph, the complex included. The unit is the
// time of sorting as many pairs of a value and an index as there are triangles.
namespace benchmark {
typedef CGAL::Reeb_graph_soup_traits<double>::Graph Soup_graph;

// Triangles or tetrahedra.
struct Complex
{
  std::vector<std::array<double, 3>> points;
  std::vector<std::array<std::size_t, 3>> triangles;
  std::vector<std::array<std::size_t, 4>> tetrahedra;

  // in a grid of tetrahedra, there are about twice as many triangles
  std::size_t number_of_triangles() const { return triangles.size() + 2 * tetrahedra.size(); }
};

inline const std::vector<std::string>& complex_names()
{
  static const std::vector<std::string> names = {"genus-3", "terrain", "foam",   "holed foam",
                                                 "book",    "solid",   "tunnels"};
  return names;
}

inline Complex make_complex(const std::string& name, std::size_t number_of_triangles)
{
  const double n = static_cast<double>(number_of_triangles);
  const auto of_triangles = [](generated_surfaces::Triangle_soup soup) {
    return Complex{std::move(soup.points), std::move(soup.triangles), {}};
  };
  if(name == "solid" || name == "tunnels") // six tetrahedra in a cube
  {
    const bool has_tunnels = name == "tunnels";
    const auto cubes = static_cast<std::size_t>(std::cbrt(n / (has_tunnels ? 9.8 : 12)));
    auto soup = generated_surfaces::solid(std::max<std::size_t>(cubes, 7), has_tunnels ? 3 : 0);
    return {std::move(soup.points), {}, std::move(soup.tetrahedra)};
  }
  if(name == "foam" || name == "holed foam") // a hundred cells
  {
    const auto quarter = static_cast<std::size_t>(std::lround(std::sqrt(n / 11680)));
    auto soup = generated_surfaces::foam(5, 5, 4, std::max<std::size_t>(quarter, 1));
    return of_triangles(name == "foam" ? std::move(soup) : generated_surfaces::with_holes(std::move(soup), 5000));
  }
  if(name == "book")
    return of_triangles(generated_surfaces::book(20, static_cast<std::size_t>(std::sqrt(n / 40))));
  return of_triangles(make_surface(name, number_of_triangles / 2));
}

inline double time_soup(const Complex& complex, const std::vector<double>& values)
{
  Soup_graph graph;
  return milliseconds([&] {
    if(complex.tetrahedra.empty())
      CGAL::compute_reeb_graph_of_soup(complex.points, complex.triangles, values, graph);
    else
      CGAL::compute_reeb_graph_of_tetrahedra(complex.points, complex.tetrahedra, values, graph);
  });
}

// The time of the same surface as a mesh, if the soup is one.
inline std::optional<double> time_mesh(const std::string& name,
                                       const Complex& complex,
                                       const std::vector<double>& values)
{
  if(name != "genus-3" && name != "terrain")
    return std::nullopt;
  Mesh mesh;
  generated_surfaces::build(mesh, generated_surfaces::Triangle_soup{complex.points, complex.triangles});
  auto map = mesh.add_property_map<Mesh::Vertex_index, double>("v:scalar").first;
  for(const Mesh::Vertex_index v : mesh.vertices())
    map[v] = values[v];
  CGAL::Reeb_graph_traits<Mesh, Scalar_map>::Graph graph;
  CGAL::compute_reeb_graph(mesh, map, graph); // the first run takes longer
  return milliseconds([&] { CGAL::compute_reeb_graph(mesh, map, graph); });
}

inline double time_unit(std::size_t number_of_triangles)
{
  std::mt19937 random(1);
  std::vector<std::pair<double, std::uint32_t>> pairs(number_of_triangles);
  for(std::size_t i = 0; i != pairs.size(); ++i)
    pairs[i] = {static_cast<double>(random()), static_cast<std::uint32_t>(i)};
  return milliseconds([&] { std::sort(pairs.begin(), pairs.end()); });
}

inline void print_complexes(const Options& options)
{
  const std::vector<std::string> fields = {"smooth", "noise"};
  const Table table("Soups and tetrahedra, one thread; a unit sorts as many pairs as there are triangles",
                    {{"complex", "", 10},
                     {"field", "", 6},
                     {"triangles", "", 9},
                     {"nodes", "", 8},
                     {"graph", "ms", 8},
                     {"graph", "units", 6},
                     {"of mesh", "times", 7},
                     {"memory", "B/triangle", 10}});
  std::map<std::pair<std::string, std::string>, std::vector<std::pair<double, double>>> times;
  for(const std::string& name : complex_names())
    for(const std::size_t size : options.numbers_of_triangles)
    {
      const Complex complex = make_complex(name, size);
      const std::size_t n = complex.number_of_triangles();
      for(const std::string& field : fields)
      {
        const auto values = field == "noise" ? generated_surfaces::noise_field(complex.points)
                                             : generated_surfaces::smooth_field(complex.points);
        Sample graph_times, mesh_times, units;
        std::optional<double> memory;
        for(std::size_t repetition = 0; repetition != options.number_of_repetitions; ++repetition)
        {
          const Memory_gauge gauge;
          graph_times.add(time_soup(complex, values));
          memory = gauge.extra_peak_bytes();
          if(const auto time = time_mesh(name, complex, values))
            mesh_times.add(*time);
          units.add(time_unit(n));
        }
        Soup_graph graph;
        if(complex.tetrahedra.empty())
          CGAL::compute_reeb_graph_of_soup(complex.points, complex.triangles, values, graph);
        else
          CGAL::compute_reeb_graph_of_tetrahedra(complex.points, complex.tetrahedra, values, graph);
        times[{name, field}].emplace_back(static_cast<double>(n), *graph_times.median());
        table.print_row({name, field, cell(n), cell(num_vertices(graph)), cell(graph_times.median(), 1),
                         cell(ratio(graph_times.median(), units.median()), 2),
                         cell(ratio(graph_times.median(), mesh_times.median()), 2),
                         cell(memory ? std::optional<double>(*memory / static_cast<double>(n)) : std::nullopt, 0)});
      }
    }
  if(options.numbers_of_triangles.size() < 2)
    return;
  const Table exponents("Growth of these times with the number of triangles, exponents",
                        {{"complex", "", 10}, {"smooth", "", 7}, {"noise", "", 7}});
  for(const std::string& name : complex_names())
    exponents.print_row(
      {name, cell(growth_exponent(times[{name, "smooth"}]), 3), cell(growth_exponent(times[{name, "noise"}]), 3)});
}

} // namespace benchmark

#endif // CGAL_REEB_GRAPH_BENCHMARK_COMPLEX_TABLE_H
