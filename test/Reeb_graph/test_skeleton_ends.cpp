// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#include <boost/test/unit_test.hpp>

#include "generated_surfaces.h"
#include "limbed_bodies.h"
#include "mesh_builders.h"
#include "random_meshes.h"
#include "tube_samples.h"
#include "voxel_solids.h"

#include <CGAL/Reeb_graph/fields/geodesic_field.h>
#include <CGAL/Reeb_graph/skeleton/extract_curve_skeleton.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <numeric>
#include <optional>
#include <tuple>
#include <utility>
#include <vector>

// Ends of skeletons are those that a person counts.

BOOST_AUTO_TEST_SUITE(test_skeleton_ends)

using limbed_bodies::Body;
using limbed_bodies::End;
using mesh_builders::Surface_mesh;
typedef std::array<double, 3> Point;

namespace {
// Of the skeleton by distances from a vertex, or by default.
std::vector<Point> found_ends(Surface_mesh& mesh, std::optional<Surface_mesh::Vertex_index> start)
{
  CGAL::Reeb_graph::Curve_skeleton<Surface_mesh> skeleton;
  if(start)
  {
    const auto field = mesh.add_property_map<Surface_mesh::Vertex_index, double>("v:distance", 0).first;
    CGAL::Reeb_graph::compute_geodesic_field(mesh, field, std::array<Surface_mesh::Vertex_index, 1>{*start});
    CGAL::Reeb_graph::extract_curve_skeleton(mesh, skeleton, CGAL::parameters::scalar_map(field));
  }
  else
    CGAL::Reeb_graph::extract_curve_skeleton(mesh, skeleton);
  std::vector<Point> result;
  for(const auto v : CGAL::make_range(vertices(skeleton)))
    if(out_degree(v, skeleton) == 1)
      result.push_back({skeleton[v].point.x(), skeleton[v].point.y(), skeleton[v].point.z()});
  return result;
}

// How many ends have no tip, each of which is taken for one end; tips that are none are left.
std::size_t number_missing(const std::vector<End>& ends, std::vector<Point>& tips)
{
  std::size_t missing = 0;
  for(const End& end : ends)
  {
    const auto distance = [&](const Point& p) { return tube_samples::distance(p, end.tip); };
    const auto nearest = std::min_element(tips.begin(), tips.end(),
                                          [&](const Point& p, const Point& q) { return distance(p) < distance(q); });
    if(nearest == tips.end() || distance(*nearest) > end.reach)
      ++missing;
    else
      tips.erase(nearest);
  }
  return missing;
}

// Of all these bodies: 1 percent of ends may be missing.
void check_bodies(const std::function<Body(std::size_t)>& make,
                  std::size_t number,
                  std::size_t most_false,
                  bool is_start_random = false)
{
  std::size_t ends = 0, missing = 0, number_false = 0;
  for(std::size_t seed = 0; seed != number; ++seed)
  {
    const Body body = make(seed);
    auto mesh = generated_surfaces::make_mesh<Surface_mesh>(surface(body, 0.01, seed));
    std::optional<Surface_mesh::Vertex_index> start;
    if(is_start_random)
      start = Surface_mesh::Vertex_index(static_cast<unsigned>(7919 * (seed + 1) % mesh.num_vertices()));
    std::vector<Point> tips = found_ends(mesh, start);
    ends += body.ends.size();
    missing += number_missing(body.ends, tips);
    number_missing(body.disputed, tips);
    number_false += tips.size();
  }
  BOOST_TEST(100 * missing <= ends);
  BOOST_TEST(number_false <= most_false);
}
// Turns points by random angles around two axes.
void turn(std::vector<Point>& points, random_meshes::Random& random)
{
  for(const std::size_t axis : {0, 2})
  {
    const double angle = 2 * std::acos(-1.) * static_cast<double>(random.below(1000)) / 1000;
    for(Point& p : points)
    {
      double &x = p[(axis + 1) % 3], &y = p[(axis + 2) % 3];
      std::tie(x, y) =
        std::make_pair(std::cos(angle) * x - std::sin(angle) * y, std::sin(angle) * x + std::cos(angle) * y);
    }
  }
}

typedef std::array<double, 2> Corner;

// Triangles of a simple polygon, counterclockwise: corners are cut off one by one.
std::vector<std::array<std::size_t, 3>> triangles_of(const std::vector<Corner>& polygon)
{
  const auto turn = [&](std::size_t a, std::size_t b, std::size_t c) {
    const Corner &p = polygon[a], &q = polygon[b], &r = polygon[c];
    return (q[0] - p[0]) * (r[1] - p[1]) - (q[1] - p[1]) * (r[0] - p[0]);
  };
  std::vector<std::size_t> left(polygon.size());
  std::iota(left.begin(), left.end(), std::size_t(0));
  std::vector<std::array<std::size_t, 3>> triangles;
  for(std::size_t i = 0; left.size() > 2; ++i)
  {
    const std::size_t size = left.size(), a = left[i % size], b = left[(i + 1) % size], c = left[(i + 2) % size];
    const auto is_inside = [&](std::size_t v) {
      return v != a && v != b && v != c && turn(a, b, v) >= 0 && turn(b, c, v) >= 0 && turn(c, a, v) >= 0;
    };
    if(!(turn(a, b, c) > 0) || std::any_of(left.begin(), left.end(), is_inside))
      continue;
    triangles.push_back({a, b, c});
    left.erase(left.begin() + static_cast<std::ptrdiff_t>((i + 1) % size));
  }
  return triangles;
}

// What is above a polygon, up to a height: as few triangles as there can be.
generated_surfaces::Triangle_soup extruded(const std::vector<Corner>& polygon, double height)
{
  generated_surfaces::Triangle_soup soup;
  const std::size_t n = polygon.size();
  for(const double z : {0., height})
    for(const Corner& p : polygon)
      soup.points.push_back({p[0], p[1], z});
  for(const auto& [a, b, c] : triangles_of(polygon))
  {
    soup.triangles.push_back({a, c, b});
    soup.triangles.push_back({n + a, n + b, n + c});
  }
  for(std::size_t i = 0; i != n; ++i)
  {
    const std::size_t next = (i + 1) % n;
    soup.triangles.push_back({i, next, n + next});
    soup.triangles.push_back({i, n + next, n + i});
  }
  return soup;
}
} // namespace

// Each tip on the rim of a lid has edges as long as a limb would be.
BOOST_AUTO_TEST_CASE(lids_around_a_corner_have_no_limbs)
{
  const std::size_t sides = 3000, rings = 3;
  auto soup = generated_surfaces::internal::grid(sides, rings, true, false, [&](std::size_t i, std::size_t k) {
    const double turn = 2 * std::acos(-1.) * static_cast<double>(i) / static_cast<double>(sides);
    return Point{std::cos(turn), std::sin(turn), 2 * static_cast<double>(k)};
  });
  for(std::size_t i = 1; i + 1 != sides; ++i)
  {
    const std::size_t top = (rings - 1) * sides;
    soup.triangles.push_back({0, i + 1, i});
    soup.triangles.push_back({top, top + i, top + i + 1});
  }
  auto mesh = generated_surfaces::make_mesh<Surface_mesh>(soup);
  BOOST_TEST(found_ends(mesh, std::nullopt).size() == 2);
}

// Those of crosses and of T, whose bars are two cubes wide, turned any way: sections near the middle can be those of the arm itself.
BOOST_AUTO_TEST_CASE(arms_of_crosses_are_there)
{
  const int width = 2, arm = 4, size = 2 * arm + width;
  for(std::size_t seed = 0; seed != 120; ++seed)
  {
    BOOST_TEST_INFO_SCOPE("seed " << seed);
    random_meshes::Random random(seed);
    const int lower_arm = seed % 2 == 0 ? arm : 0;
    const auto is_in_middle = [&](int k) { return arm <= k && k < arm + width; };
    auto soup =
      Voxel_solid::of_cells(size, [&](const Voxel_solid::Cell& cell) {
        return cell[2] < width && ((is_in_middle(cell[0]) && cell[1] >= arm - lower_arm) || is_in_middle(cell[1]));
      }).surface();
    for(std::size_t i = 0; i + 1 < soup.triangles.size(); i += 2)
      if(auto& a = soup.triangles[i], &b = soup.triangles[i + 1]; random.below(2) == 0)
      {
        a[2] = b[2]; // the other diagonal
        b[0] = a[1];
      }
    turn(soup.points, random);
    auto mesh = generated_surfaces::make_mesh<Surface_mesh>(soup);
    BOOST_TEST(found_ends(mesh, std::nullopt).size() == (lower_arm > 0 ? 4 : 3));
  }
}

// Edges as long as the arms do not see where these fork.
BOOST_AUTO_TEST_CASE(arms_of_solids_of_few_triangles_are_there)
{
  for(std::size_t seed = 0; seed != 40; ++seed)
  {
    BOOST_TEST_INFO_SCOPE("seed " << seed);
    random_meshes::Random random(seed);
    const auto arm = [&] { return 3 + static_cast<double>(random.below(600)) / 100; };
    const double a = -arm(), b = arm(), c = -arm(), d = arm(), e = 4 + arm();
    const std::vector<Corner> letter_t = {{a, 0}, {b, 0}, {b, 1}, {1, 1}, {1, d}, {0, d}, {0, 1}, {a, 1}};
    const std::vector<Corner> plus = {{0, 0}, {0, c}, {1, c}, {1, 0}, {b, 0}, {b, 1},
                                      {1, 1}, {1, d}, {0, d}, {0, 1}, {a, 1}, {a, 0}};
    const std::vector<Corner> letter_h = {{0, 0}, {0, c},     {1, c},     {1, 0}, {e - 1, 0}, {e - 1, c}, {e, c},
                                          {e, d}, {e - 1, d}, {e - 1, 1}, {1, 1}, {1, d},     {0, d}};
    for(const auto& [polygon, number] : {std::pair(letter_t, 3u), {plus, 4u}, {letter_h, 4u}})
    {
      auto soup = extruded(polygon, 1);
      turn(soup.points, random);
      auto mesh = generated_surfaces::make_mesh<Surface_mesh>(soup);
      BOOST_TEST(found_ends(mesh, std::nullopt).size() == number);
    }
  }
}

BOOST_AUTO_TEST_CASE(quadrupeds_have_their_ends) { check_bodies(limbed_bodies::quadruped, 20, 0); }

BOOST_AUTO_TEST_CASE(short_legs_have_their_ends) { check_bodies(limbed_bodies::short_legged, 40, 1); }

BOOST_AUTO_TEST_CASE(trunks_of_thin_branches_have_their_ends) { check_bodies(limbed_bodies::thin_branched, 90, 0); }

BOOST_AUTO_TEST_CASE(ends_are_there_from_any_start) { check_bodies(limbed_bodies::short_legged, 40, 2, true); }

BOOST_AUTO_TEST_SUITE_END()
