// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_TEST_GROWTH_SURFACES_H
#define CGAL_REEB_GRAPH_TEST_GROWTH_SURFACES_H

#include "base/surface.h"
#include "generated_complexes.h"
#include "generated_surfaces.h"
#include "input/Polygon_soup.h"
#include "input/assemble_surface.h"

#include <CGAL/number_utils.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <stdexcept>
#include <string>
#include <unordered_set>
#include <vector>

// Surfaces on which a wrong step is quadratic: hubs, combs, many holes, many handles.
namespace growth {
using generated_surfaces::Triangle_soup;
using reeb_graph_program::Point;
typedef reeb_graph_program::Surface Mesh;
typedef reeb_graph_program::Scalar_map Scalar_map;

struct Input
{
  std::string name;
  Triangle_soup soup;
  std::vector<double> values;
};

// A square with holes_per_side^2 square holes.
inline Triangle_soup plate_with_holes(std::size_t holes_per_side)
{
  const std::size_t cells = 4 * holes_per_side + 2, none = static_cast<std::size_t>(-1);
  Triangle_soup soup;
  std::vector<std::size_t> numbers((cells + 1) * (cells + 1), none);
  const auto vertex = [&](std::size_t column, std::size_t row) {
    std::size_t& number = numbers[row * (cells + 1) + column];
    if(number == none)
    {
      number = soup.points.size();
      const double size = static_cast<double>(cells);
      const double x = static_cast<double>(column) / size, y = static_cast<double>(row) / size;
      soup.points.push_back({x + 0.1 * std::sin(3 * y) / size, y + 0.1 * std::sin(5 * x) / size, 0.5 / size});
    }
    return number;
  };
  for(std::size_t row = 0; row < cells; ++row)
    for(std::size_t column = 0; column < cells; ++column)
    {
      if(row % 4 >= 2 && column % 4 >= 2)
        continue;
      const std::size_t a = vertex(column, row), b = vertex(column + 1, row);
      const std::size_t c = vertex(column, row + 1), d = vertex(column + 1, row + 1);
      soup.triangles.push_back({a, b, d});
      soup.triangles.push_back({a, d, c});
    }
  return soup;
}

// The border of the plate that has the surface as its upper and, at -z, as its lower side.
inline Triangle_soup thickened(const Triangle_soup& upper)
{
  const std::size_t n = upper.points.size();
  Triangle_soup soup = upper;
  for(const auto& p : upper.points)
    soup.points.push_back({p[0], p[1], -p[2]});
  std::unordered_set<std::uint64_t> edges;
  const auto key = [&](std::size_t u, std::size_t v) { return static_cast<std::uint64_t>(u) * n + v; };
  for(const auto& t : upper.triangles)
    for(std::size_t i = 0; i < 3; ++i)
      edges.insert(key(t[i], t[(i + 1) % 3]));
  for(const auto& t : upper.triangles)
  {
    soup.triangles.push_back({t[2] + n, t[1] + n, t[0] + n});
    for(std::size_t i = 0; i < 3; ++i)
    {
      const std::size_t u = t[i], v = t[(i + 1) % 3];
      if(edges.count(key(v, u)) != 0)
        continue;
      soup.triangles.push_back({v, u, u + n});
      soup.triangles.push_back({v, u + n, v + n});
    }
  }
  return soup;
}

// Two vertices around which peaks and pits alternate: the one where the value is 0 is a saddle of all of them.
inline Input hub(std::size_t number_of_vertices)
{
  const std::size_t ring = number_of_vertices / 2 * 2;
  Input input = {"hub", {}, {}};
  const auto add = [&](double x, double y, double z) {
    input.soup.points.push_back({x, y, z});
    input.values.push_back(z);
  };
  add(0, 0, 0);
  add(0, 0, 0.5);
  for(std::size_t i = 0; i < ring; ++i)
  {
    const double part = static_cast<double>(i) / static_cast<double>(ring), angle = 6.28318530717958648 * part;
    add(std::cos(angle), std::sin(angle), (i % 2 == 0 ? 1 : -1) * (1 + 0.1 * part));
    const std::size_t a = 2 + i, b = 2 + (i + 1) % ring;
    input.soup.triangles.push_back({1, a, b});
    input.soup.triangles.push_back({0, b, a});
  }
  return input;
}

// Ridges side by side, each from its own pit to its own peak.
inline Input comb(std::size_t number_of_vertices)
{
  const auto ridges = static_cast<std::size_t>(std::sqrt(static_cast<double>(number_of_vertices) / 2));
  Input input = {"comb", {}, {}};
  input.soup = generated_surfaces::internal::grid(2 * ridges, ridges, false, false, [&](std::size_t i, std::size_t j) {
    const double x = static_cast<double>(i) / static_cast<double>(ridges);
    const double y = static_cast<double>(j) / static_cast<double>(ridges);
    return std::array<double, 3>{x, y, y + (i % 2 == 0 ? 0.5 : 0) + 1e-3 * x};
  });
  for(const auto& p : input.soup.points)
    input.values.push_back(p[2]);
  return input;
}

inline std::vector<double> tilted_height(const Triangle_soup& soup)
{
  std::vector<double> values;
  for(const auto& p : soup.points)
    values.push_back(p[0] + 0.37 * p[1] + 0.1 * p[2]);
  return values;
}

inline Input plate(std::size_t number_of_vertices, bool is_noise)
{
  const auto holes = static_cast<std::size_t>(std::sqrt(static_cast<double>(number_of_vertices) / 16));
  const Triangle_soup soup = plate_with_holes(holes);
  return {is_noise ? "k^2 holes, noise" : "k^2 holes, height", soup,
          is_noise ? generated_surfaces::noise_field(soup.points) : tilted_height(soup)};
}

inline Input many_handles(std::size_t number_of_vertices, bool is_noise)
{
  const auto handles = static_cast<std::size_t>(std::sqrt(static_cast<double>(number_of_vertices) / 32));
  const Triangle_soup soup = thickened(plate_with_holes(handles));
  return {is_noise ? "genus k^2, noise" : "genus k^2, height", soup,
          is_noise ? generated_surfaces::noise_field(soup.points) : tilted_height(soup)};
}

inline Input few_handles(std::size_t number_of_vertices, bool is_noise)
{
  const Triangle_soup soup = generated_surfaces::closed_surface(3, number_of_vertices);
  return {is_noise ? "genus 3, noise" : "genus 3, smooth", soup,
          is_noise ? generated_surfaces::noise_field(soup.points) : generated_surfaces::smooth_field(soup.points)};
}

// All of them, of about so many vertices.
inline std::vector<Input> all_inputs(std::size_t n)
{
  return {few_handles(n, false),
          few_handles(n, true),
          many_handles(n, false),
          many_handles(n, true),
          plate(n, false),
          plate(n, true),
          comb(n),
          hub(n)};
}

// The mesh with its field, as the program makes it: add_face() of CGAL is quadratic at a hub.
struct Surface_with_field
{
  explicit Surface_with_field(const Input& input)
  {
    reeb_graph_program::Polygon_soup polygons;
    for(const auto& p : input.soup.points)
      polygons.points.emplace_back(p[0], p[1], p[2]);
    for(const auto& t : input.soup.triangles)
    {
      for(const std::size_t v : t)
        polygons.polygons.add_corner(v);
      polygons.polygons.end_polygon();
    }
    if(!reeb_graph_program::assemble_surface(polygons, mesh))
      throw std::logic_error(input.name + " is no surface");
    field = mesh.add_property_map<Mesh::Vertex_index, double>("v:field").first;
    for(const Mesh::Vertex_index v : mesh.vertices())
      field[v] = input.values[v.idx()];
  }

  Surface_with_field(const Surface_with_field&) = delete;
  Surface_with_field& operator=(const Surface_with_field&) = delete;
  std::size_t size() const { return mesh.number_of_faces(); }

  Mesh mesh;
  Scalar_map field;
};

// The same surface at n, 2n and 4n.
template <class Subject, class MakeInput>
std::array<std::unique_ptr<const Subject>, 3> at_three_sizes(std::size_t n, const MakeInput& make_input)
{
  std::array<std::unique_ptr<const Subject>, 3> subjects;
  for(std::size_t i = 0; i < 3; ++i)
    subjects[i] = std::make_unique<const Subject>(make_input(n << i));
  return subjects;
}

} // namespace growth

#endif // CGAL_REEB_GRAPH_TEST_GROWTH_SURFACES_H
