// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#include "mpi/generated_input.h"

#include "input/text_input.h"
#include "mpi/local_input.h"

#include <cmath>
#include <stdexcept>
#include <string_view>
#include <type_traits>
#include <variant>

namespace reeb_graph_program {
namespace {
// A number between 0 and 1 that depends on the index (the generator splitmix64).
double noise(std::uint64_t index)
{
  std::uint64_t z = (index + 1) * 0x9e3779b97f4a7c15U;
  z = (z ^ (z >> 30U)) * 0xbf58476d1ce4e5b9U;
  z = (z ^ (z >> 27U)) * 0x94d049bb133111ebU;
  return static_cast<double>((z ^ (z >> 31U)) >> 11U) * 0x1p-53;
}

double smooth(const Point& p) { return std::sin(2 * p.x()) + 0.5 * std::sin(3 * p.y() + p.x()) + 0.1 * p.z(); }

} // namespace

Formula_surface make_surface(const Generation_options& options)
{
  constexpr std::string_view prefix = "genus-";
  constexpr unsigned most_holes = 1000;
  constexpr std::uint64_t most_triangles = std::uint64_t(1) << 40;
  const std::string_view name = options.surface;
  unsigned genus = 0;
  if(name.substr(0, prefix.size()) != prefix || parse_number(name.substr(prefix.size()), genus) != std::errc()
     || genus > most_holes)
    throw std::runtime_error("there is no surface " + quote(name) + ": those that are generated are genus-0 to genus-"
                             + std::to_string(most_holes));
  if(options.number_of_triangles > most_triangles)
    throw std::runtime_error("a generated surface has at most " + std::to_string(most_triangles) + " triangles");
  return Formula_surface(genus, options.number_of_triangles);
}

std::function<double(std::uint64_t, const Point&)> generated_field(const Input_options& options)
{
  if(options.field == "noise")
    return [](std::uint64_t v, const Point&) { return noise(v); };
  if(options.field == "smooth")
    return [](std::uint64_t, const Point& point) { return smooth(point); };
  const Field_of_point of_point = field_of_point(options);
  if(!of_point)
    throw std::runtime_error("the field of a generated surface is x, y, z, height, smooth, or noise");
  return [of_point](std::uint64_t, const Point& point) { return of_point(point); };
}

Local_mesh make_local_mesh(const Communicator& communicator,
                           const Generation_options& generation,
                           const Input_options& options)
{
  const Formula_surface surface = make_surface(generation);
  const auto field = generated_field(options);
  Local_mesh mesh;
  mesh.number_of_vertices = surface.number_of_vertices();
  mesh.number_of_triangles = surface.number_of_triangles();
  mesh.triangles = make_triangles(mesh.number_of_vertices);
  const Part vertices = part_of_rank(communicator, mesh.number_of_vertices);
  const Part cells = part_of_rank(communicator, surface.number_of_cells());
  mesh.first_vertex = vertices.first;
  run_together(communicator, [&] {
    mesh.scalars.reserve(vertices.size());
    surface.for_each_point(vertices.first, vertices.last, [&](const Formula_surface::Point_of_formula& p) {
      mesh.scalars.push_back(field(mesh.first_vertex + mesh.scalars.size(), Point(p[0], p[1], p[2])));
    });
    std::visit(
      [&](auto& list) {
        typename std::decay_t<decltype(list)>::value_type triangle;
        list.reserve(4 * cells.size());
        surface.for_each_triangle(cells.first, cells.last, [&](const Formula_surface::Triangle& corners) {
          std::copy(corners.begin(), corners.end(), triangle.begin());
          list.push_back(triangle);
        });
      },
      mesh.triangles);
  });
  mesh.point = [surface](std::uint64_t v) {
    Point point;
    surface.for_each_point(v, v + 1, [&](const Formula_surface::Point_of_formula& p) { point = {p[0], p[1], p[2]}; });
    return point;
  };
  return mesh;
}

} // namespace reeb_graph_program
