// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_TEST_FIELD_CHECKS_H
#define CGAL_REEB_GRAPH_TEST_FIELD_CHECKS_H

#include "mesh_builders.h"
#include "random_meshes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

// What the tests of scalar fields share. They see a mesh as index triples, and a field as a vector.
namespace field_checks {
using generated_surfaces::Triangle_soup;
using random_meshes::Random;

constexpr double pi = 3.14159265358979323846;

inline double random_unit(Random& random) { return static_cast<double>(random.below(1000001)) / 1e6; }

// the points moved by up to `distance` in each coordinate
inline Triangle_soup with_noise(Triangle_soup soup, double distance, Random& random)
{
  for(auto& p : soup.points)
    for(double& coordinate : p)
      coordinate += distance * (2 * random_unit(random) - 1);
  return soup;
}

inline Triangle_soup stretched(Triangle_soup soup, double x, double y, double z)
{
  for(auto& p : soup.points)
    p = {x * p[0], y * p[1], z * p[2]};
  return soup;
}

// with points in the unit cube
inline Triangle_soup with_random_points(const random_meshes::Combinatorial_mesh& mesh, Random& random)
{
  Triangle_soup soup = {{}, mesh.triangles};
  for(std::size_t v = 0; v < mesh.number_of_vertices; ++v)
    soup.points.push_back({random_unit(random), random_unit(random), random_unit(random)});
  return soup;
}

// A closed tube along the z-axis, of `along` rings of `around` vertices, and a vertex at each end: the first two are at
// the lower end and in the lowest ring. From there, any field that is harmonic is flat in the rest of the tube.
inline Triangle_soup tube(std::size_t around, std::size_t along)
{
  Triangle_soup soup;
  soup.points.push_back({0, 0, -0.5});
  for(std::size_t ring = 0; ring < along; ++ring)
    for(std::size_t i = 0; i < around; ++i)
    {
      const double angle = 2 * pi * (static_cast<double>(i) + 0.25 * static_cast<double>(ring)) / around;
      soup.points.push_back({std::cos(angle), std::sin(angle), static_cast<double>(ring)});
    }
  const std::size_t top = soup.points.size();
  soup.points.push_back({0, 0, static_cast<double>(along) - 0.5});
  for(const auto& t : random_meshes::cylinder(around, along).triangles)
    soup.triangles.push_back({t[0] + 1, t[1] + 1, t[2] + 1});
  for(std::size_t i = 0; i < around; ++i)
  {
    const std::size_t last = top - around;
    soup.triangles.push_back({0, 1 + (i + 1) % around, 1 + i});
    soup.triangles.push_back({top, last + i, last + (i + 1) % around});
  }
  return soup;
}

// A band of `along` + 1 rows of `around` vertices each. `point(angle, t)` is on the border that has the value 0 if t is
// 0, and on the other one, which has the value 1, if it is 1. Each row is turned by half a step. Vertices are moved by
// up to `randomness` steps.
template <class Point_function>
Triangle_soup band(std::size_t around, std::size_t along, double randomness, const Point_function& point)
{
  Random random(around);
  return generated_surfaces::internal::grid(around, along + 1, true, false, [&](std::size_t column, std::size_t row) {
    const bool is_inside = row > 0 && row < along;
    const double dx = randomness * (2 * field_checks::random_unit(random) - 1);
    const double dy = is_inside ? randomness * (2 * field_checks::random_unit(random) - 1) : 0;
    const double x = static_cast<double>(column) - static_cast<double>(row) / 2 + dx;
    const double y = static_cast<double>(row) + dy;
    return point(2 * pi * x / static_cast<double>(around), y / static_cast<double>(along));
  });
}

// Bands on surfaces of revolution. The parameter from -half_length to half_length is conformal: with a grid as above,
// all triangles of a fine band are about equilateral.
const double half_length = std::sqrt(3.) / 4 * pi;

inline double conformal(double t) { return (2 * t - 1) * half_length; }

inline std::array<double, 3> cylinder_point(double angle, double t)
{
  return {std::cos(angle), std::sin(angle), conformal(t)};
}

// on the unit sphere
inline std::array<double, 3> sphere_point(double angle, double t)
{
  const double theta = 2 * std::atan(std::exp(conformal(t)));
  return {std::sin(theta) * std::cos(angle), std::sin(theta) * std::sin(angle), std::cos(theta)};
}

// on the torus of radii 2 and 1
inline std::array<double, 3> torus_point(double angle, double t)
{
  const double along = 2 * std::atan(std::sqrt(3.) * std::tan(std::sqrt(3.) / 2 * conformal(t)));
  const double radius = 2 + std::cos(along);
  return {radius * std::cos(angle), radius * std::sin(angle), std::sin(along)};
}

inline std::vector<std::set<std::size_t>> neighbors(const Triangle_soup& soup)
{
  std::vector<std::set<std::size_t>> result(soup.points.size());
  for(const auto& t : soup.triangles)
    for(std::size_t u : t)
      for(std::size_t v : t)
        if(u != v)
          result[u].insert(v);
  return result;
}

typedef std::map<std::size_t, double> Fixed_values; // by vertex

// The vertices that are not fixed, and that reach fixed ones of one value only without passing any: there the field can
// be nothing but constant.
inline std::vector<bool> constant_vertices(const Triangle_soup& soup, const Fixed_values& fixed)
{
  const auto adjacent = neighbors(soup);
  std::vector<bool> is_seen(soup.points.size(), false), is_constant(soup.points.size(), false);
  for(std::size_t first = 0; first < soup.points.size(); ++first)
  {
    if(is_seen[first] || fixed.count(first) > 0)
      continue;
    std::vector<std::size_t> part = {first};
    std::set<double> values;
    is_seen[first] = true;
    for(std::size_t i = 0; i < part.size(); ++i)
      for(std::size_t v : adjacent[part[i]])
        if(fixed.count(v) > 0)
          values.insert(fixed.at(v));
        else if(!is_seen[v])
        {
          is_seen[v] = true;
          part.push_back(v);
        }
    for(std::size_t v : part)
      is_constant[v] = values.size() < 2;
  }
  return is_constant;
}

// Empty if fixed values are kept, the others have a strictly lower and a strictly higher neighbor, and those that must
// be constant have the value of a fixed one.
template <class Scalar>
std::string fault_of_extrema(const Triangle_soup& soup, const Fixed_values& fixed, const std::vector<Scalar>& values)
{
  const auto adjacent = neighbors(soup);
  const std::vector<bool> is_constant = constant_vertices(soup, fixed);
  for(std::size_t v = 0; v < values.size(); ++v)
  {
    const std::string name = "vertex " + std::to_string(v) + " ";
    const auto has_neighbor = [&](const auto& predicate) {
      return std::any_of(adjacent[v].begin(), adjacent[v].end(), [&](std::size_t u) { return predicate(values[u]); });
    };
    if(fixed.count(v) > 0)
    {
      if(values[v] != static_cast<Scalar>(fixed.at(v)))
        return name + "has lost its value";
    }
    else if(is_constant[v])
    {
      if(!has_neighbor([&](Scalar value) { return value == values[v]; })
         || has_neighbor([&](Scalar value) { return value != values[v]; }))
        return name + "is not constant";
    }
    else if(!has_neighbor([&](Scalar value) { return value < values[v]; }))
      return name + "has no lower neighbor";
    else if(!has_neighbor([&](Scalar value) { return value > values[v]; }))
      return name + "has no higher neighbor";
  }
  return "";
}

// The sum of the multiplicities of the saddles of a closed surface, from the number of triangles of which a vertex is
// the middle one. Vertices of equal value are ordered by their numbers.
template <class Scalar>
std::size_t total_multiplicity(const Triangle_soup& soup, const std::vector<Scalar>& values)
{
  std::vector<std::size_t> middle_corners(values.size(), 0);
  for(auto t : soup.triangles)
  {
    std::sort(t.begin(), t.end(), [&](std::size_t u, std::size_t v) {
      return std::make_pair(values[u], u) < std::make_pair(values[v], v);
    });
    ++middle_corners[t[1]];
  }
  std::size_t sum = 0;
  for(const std::size_t count : middle_corners)
    sum += count > 2 ? (count - 2) / 2 : 0;
  return sum;
}

template <class Mesh>
std::vector<typename boost::graph_traits<Mesh>::vertex_descriptor> vertex_vector(const Mesh& mesh)
{
  return {vertices(mesh).first, vertices(mesh).second};
}

template <class Mesh, class Map>
auto values_of(const Mesh& mesh, const Map& map)
{
  std::vector<typename boost::property_traits<Map>::value_type> values;
  for(const auto v : vertices(mesh))
    values.push_back(get(map, v));
  return values;
}

template <class Mesh>
auto constraints_of(const Mesh& mesh, const Fixed_values& fixed)
{
  const auto handles = vertex_vector(mesh);
  std::vector<std::pair<typename boost::graph_traits<Mesh>::vertex_descriptor, double>> constraints;
  for(const auto& pair : fixed)
    constraints.emplace_back(handles[pair.first], pair.second);
  return constraints;
}

// The largest distance of two fields.
template <class Scalar>
double distance(const std::vector<Scalar>& a, const std::vector<Scalar>& b)
{
  double largest = 0;
  for(std::size_t i = 0; i < a.size(); ++i)
    largest = (std::max)(largest, std::abs(static_cast<double>(a[i]) - static_cast<double>(b[i])));
  return largest;
}

} // namespace field_checks

#endif // CGAL_REEB_GRAPH_TEST_FIELD_CHECKS_H
