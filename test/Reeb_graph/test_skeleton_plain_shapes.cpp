// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#include <boost/test/unit_test.hpp>

#include "generated_surfaces.h"
#include "mesh_builders.h"
#include "random_meshes.h"
#include "shuffle.h"
#include "voxel_solids.h"

#include <CGAL/Reeb_graph/skeleton/extract_curve_skeleton.h>

#include <CGAL/Bbox_3.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

// Skeletons of shapes whose axes and radii are known, of random sizes, densities, directions and units.

BOOST_AUTO_TEST_SUITE(test_skeleton_plain_shapes)

using CGAL::Reeb_graph::Curve_skeleton;
using CGAL::Reeb_graph::extract_curve_skeleton;
using CGAL::Reeb_graph::Skeleton_certificate;
using generated_surfaces::Triangle_soup;
using mesh_builders::Surface_mesh;
namespace parameters = CGAL::parameters;

namespace {
typedef std::array<double, 2> Ring; // height and radius
typedef std::array<double, 3> Point;
const double pi = std::acos(-1.);

// A surface around the z-axis, closed by a fan around the axis at both ends.
Triangle_soup turned(const std::vector<Ring>& rings, std::size_t around, double bottom, double top)
{
  Triangle_soup soup;
  for(const auto& [height, radius] : rings)
    for(std::size_t i = 0; i != around; ++i)
    {
      const double turn = 2 * pi * static_cast<double>(i) / static_cast<double>(around);
      soup.points.push_back({radius * std::cos(turn), radius * std::sin(turn), height});
    }
  const std::size_t low = soup.points.size(), high = low + 1, last = low - around;
  soup.points.push_back({0, 0, bottom});
  soup.points.push_back({0, 0, top});
  for(std::size_t i = 0; i != around; ++i)
  {
    const std::size_t next = (i + 1) % around;
    soup.triangles.push_back({low, next, i});
    soup.triangles.push_back({high, last + i, last + next});
    for(std::size_t ring = 0; ring != last; ring += around)
    {
      soup.triangles.push_back({ring + i, ring + next, ring + around + next});
      soup.triangles.push_back({ring + i, ring + around + next, ring + around + i});
    }
  }
  return soup;
}

// Rings from one height to another one, of radii that change linearly.
void add_rings(const Ring& from, const Ring& to, std::size_t number, std::vector<Ring>& rings)
{
  for(std::size_t i = 0; i <= number; ++i)
  {
    const double t = static_cast<double>(i) / static_cast<double>(number);
    rings.push_back({(1 - t) * from[0] + t * to[0], (1 - t) * from[1] + t * to[1]});
  }
}

Triangle_soup closed_tube(double radius, double length, std::size_t around, std::size_t along, std::size_t in_caps)
{
  std::vector<Ring> rings;
  for(std::size_t i = 1; i <= in_caps; ++i)
    rings.push_back({0, radius * static_cast<double>(i) / static_cast<double>(in_caps + 1)});
  add_rings({0, radius}, {length, radius}, along, rings);
  for(std::size_t i = in_caps; i != 0; --i)
    rings.push_back({length, radius * static_cast<double>(i) / static_cast<double>(in_caps + 1)});
  return turned(rings, around, 0, length);
}

Triangle_soup capsule(double radius, double length, std::size_t around, std::size_t along)
{
  const std::size_t number = around / 4;
  std::vector<Ring> rings;
  const auto add_round = [&](std::size_t i, double height, double side) {
    const double turn = pi / 2 * static_cast<double>(i) / static_cast<double>(number);
    rings.push_back({height + side * radius * std::cos(turn), radius * std::sin(turn)});
  };
  for(std::size_t i = 1; i < number; ++i)
    add_round(i, 0, -1);
  add_rings({0, radius}, {length, radius}, along, rings);
  for(std::size_t i = number - 1; i != 0; --i)
    add_round(i, length, 1);
  return turned(rings, around, -radius, length + radius);
}

double in(double least, double most, random_meshes::Random& random)
{
  return least + (most - least) * static_cast<double>(random.below(1001)) / 1000;
}

// A tube around a part of a circle in the plane of x and z, with flat caps.
Triangle_soup bent_tube(double radius, double of_circle, double angle, std::size_t around, std::size_t along)
{
  std::vector<Ring> rings;
  add_rings({0, radius}, {angle, radius}, along, rings);
  Triangle_soup soup = turned(rings, around, 0, angle);
  for(Point& p : soup.points)
    p = {(of_circle + p[0]) * std::cos(p[2]), p[1], (of_circle + p[0]) * std::sin(p[2])};
  return soup;
}

// Divides a share of the triangles in three, at random.
Triangle_soup cut(Triangle_soup soup, double share, random_meshes::Random& random)
{
  for(std::size_t i = soup.triangles.size(); i-- != 0;)
  {
    if(in(0, 1, random) >= share)
      continue;
    const auto [a, b, c] = soup.triangles[i];
    std::array<double, 3> weights = {in(0.05, 1, random), in(0.05, 1, random), in(0.05, 1, random)};
    const double sum = weights[0] + weights[1] + weights[2];
    Point p;
    for(std::size_t k = 0; k != 3; ++k)
      p[k] = (weights[0] * soup.points[a][k] + weights[1] * soup.points[b][k] + weights[2] * soup.points[c][k]) / sum;
    const std::size_t added = soup.points.size();
    soup.points.push_back(p);
    soup.triangles[i] = {a, b, added};
    soup.triangles.push_back({b, c, added});
    soup.triangles.push_back({c, a, added});
  }
  return soup;
}

// Turned in space, in a unit, with shuffled vertices and faces.
Triangle_soup moved(Triangle_soup soup, random_meshes::Random& random, double unit)
{
  for(int turn = 0; turn != 3; ++turn)
  {
    const double angle = static_cast<double>(random.below(1000)), c = std::cos(angle), s = std::sin(angle);
    for(Point& p : soup.points)
      p = {p[1] * c - p[2] * s, p[1] * s + p[2] * c, p[0]};
  }
  for(Point& p : soup.points)
    for(double& x : p)
      x *= unit;
  std::vector<std::size_t> numbers(soup.points.size());
  for(std::size_t i = 0; i != numbers.size(); ++i)
    numbers[i] = i;
  random.shuffle(numbers);
  const std::vector<Point> points(soup.points.begin(), soup.points.end());
  for(std::size_t i = 0; i != numbers.size(); ++i)
    soup.points[numbers[i]] = points[i];
  for(auto& triangle : soup.triangles)
    for(std::size_t& v : triangle)
      v = numbers[v];
  random.shuffle(soup.triangles);
  return soup;
}

typedef Curve_skeleton<Surface_mesh> Skeleton;

double step_of(const Skeleton& skeleton, std::size_t a, std::size_t b)
{
  return std::sqrt(CGAL::squared_distance(skeleton[a].point, skeleton[b].point));
}

double length_of(const Skeleton& skeleton)
{
  double length = 0;
  for(const auto& arc : skeleton_arcs(skeleton))
    for(std::size_t i = 1; i != arc.size(); ++i)
      length += step_of(skeleton, arc[i - 1], arc[i]);
  return length;
}

// The mean along the lines.
template <class Value>
double mean_of(const Skeleton& skeleton, const Value& value)
{
  double sum = 0;
  for(const auto& arc : skeleton_arcs(skeleton))
    for(std::size_t i = 1; i != arc.size(); ++i)
      sum += step_of(skeleton, arc[i - 1], arc[i]) * (value(skeleton[arc[i - 1]]) + value(skeleton[arc[i]])) / 2;
  return sum / length_of(skeleton);
}

// Radii count at least as half a mean edge, or as a fiftieth of the size if that is less.
double least_radius(const Surface_mesh& mesh)
{
  double sum = 0;
  for(const auto e : mesh.edges())
    sum += std::sqrt(CGAL::squared_distance(mesh.point(mesh.vertex(e, 0)), mesh.point(mesh.vertex(e, 1))));
  const CGAL::Bbox_3 box = CGAL::bbox_3(mesh.points().begin(), mesh.points().end());
  const double size = std::hypot(box.xmax() - box.xmin(), box.ymax() - box.ymin(), box.zmax() - box.zmin());
  return std::min(sum / static_cast<double>(mesh.num_edges()) / 2, size / 50);
}

Skeleton check_steps(const Surface_mesh& mesh, double ratio)
{
  Skeleton skeleton;
  const Skeleton_certificate known = extract_curve_skeleton(mesh, skeleton, parameters::sampling_ratio(ratio));
  BOOST_TEST(known.is_inside());
  const double least = least_radius(mesh);
  for(const auto& arc : skeleton_arcs(skeleton))
    for(std::size_t i = 1; i != arc.size(); ++i)
    {
      const double radius = std::min(skeleton[arc[i - 1]].radius, skeleton[arc[i]].radius);
      BOOST_TEST(step_of(skeleton, arc[i - 1], arc[i]) <= 1.5001 * ratio * std::max(radius, least));
    }
  return skeleton;
}
} // namespace

BOOST_AUTO_TEST_CASE(capsules_have_points_all_along)
{
  for(std::size_t seed = 0; seed != 30; ++seed)
  {
    random_meshes::Random random(seed);
    const double radius = in(0.3, 3, random), length = in(4, 20, random) * radius,
                 unit = std::pow(10, in(-20, 20, random));
    const std::size_t around = 12 + 4 * random.below(4), along = 4 + random.below(30);
    BOOST_TEST_CONTEXT("seed " << seed)
    {
      const auto mesh =
        generated_surfaces::make_mesh<Surface_mesh>(moved(capsule(radius, length, around, along), random, unit));
      const Skeleton skeleton = check_steps(mesh, 0.5);
      BOOST_TEST(std::abs(length_of(skeleton) / unit - length - 2 * radius) < 0.1 * radius);
      const double inscribed = mean_of(skeleton, [](const auto& v) { return v.inscribed_radius; }) / unit;
      const double expected = radius * (length + radius) / (length + 2 * radius); // less what a polygon has not
      BOOST_TEST((inscribed < 1.001 * expected && inscribed > 0.94 * expected));
      BOOST_TEST(std::abs(mean_of(skeleton, [](const auto& v) { return v.radius; }) / unit / radius - 1) < 0.08);
    }
  }
}

// A face can have all its corners at one place: then there is no length by which to choose steps.
BOOST_AUTO_TEST_CASE(a_component_that_is_one_point_has_an_arc_without_length)
{
  for(const Triangle_soup& soup :
      {Triangle_soup{{{1, 2, 3}, {1, 2, 3}, {1, 2, 3}}, {{0, 1, 2}}},
       Triangle_soup{{{1, 2, 3}, {1, 2, 3}, {1, 2, 3}, {1, 2, 3}}, {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}}}})
  {
    const auto mesh = generated_surfaces::make_mesh<Surface_mesh>(soup);
    for(const double smooth : {0, 1})
    {
      Curve_skeleton<Surface_mesh> skeleton;
      const Skeleton_certificate certificate =
        extract_curve_skeleton(mesh, skeleton, parameters::smooth(smooth).sampling_ratio(0.3));
      BOOST_TEST(num_vertices(skeleton) == 2);
      BOOST_TEST(certificate.number_of_ends == 2);
      BOOST_TEST(certificate.number_of_crossing_components == 1);
    }
  }
}

// Where all of a torus is at one point, or in a plane, its loop can become a point.
BOOST_AUTO_TEST_CASE(each_vertex_of_a_flattened_torus_has_an_arc)
{
  for(std::size_t flat = 0; flat < 4; ++flat)
    for(const std::size_t corners : {3, 4, 8})
      BOOST_TEST_CONTEXT("coordinate " << flat << ", corners " << corners)
      {
        Triangle_soup soup = generated_surfaces::torus(4 * corners, corners);
        for(auto& point : soup.points)
          for(std::size_t i = 0; i < 3; ++i)
            point[i] = i == flat || flat == 3 ? 1 : point[i];
        const auto mesh = generated_surfaces::make_mesh<Surface_mesh>(soup);
        Curve_skeleton<Surface_mesh> skeleton;
        extract_curve_skeleton(mesh, skeleton);
        BOOST_TEST(num_edges(skeleton) > 0);
        for(const auto v : CGAL::make_range(vertices(skeleton)))
          BOOST_TEST(out_degree(v, skeleton) > 0);
      }
}

// By rounding, a triangle and what fills its border have a volume.
BOOST_AUTO_TEST_CASE(flat_surfaces_are_told)
{
  random_meshes::Random random(5);
  for(int sample = 0; sample < 50; ++sample)
  {
    Triangle_soup soup = {{}, {{0, 1, 2}}};
    for(int i = 0; i < 3; ++i)
      soup.points.push_back({0.37 * static_cast<double>(random.below(1000)),
                             0.73 * static_cast<double>(random.below(1000)),
                             0.11 * static_cast<double>(random.below(1000))});
    const auto mesh = generated_surfaces::make_mesh<Surface_mesh>(soup);
    Curve_skeleton<Surface_mesh> skeleton;
    BOOST_TEST(extract_curve_skeleton(mesh, skeleton).number_of_crossing_components == 1);
  }
}

BOOST_AUTO_TEST_CASE(no_step_is_too_long_for_any_ratio)
{
  random_meshes::Random random(7);
  for(const double ratio : {0.1, 0.5, 2.})
    for(const Triangle_soup& soup :
        {capsule(1, 10, 12, 10), closed_tube(1, 10, 12, 1, 0), closed_tube(0.2, 10, 6, 40, 0),
         generated_surfaces::torus(8, 30), turned({{0, 2}}, 12, 0, 9)})
      check_steps(generated_surfaces::make_mesh<Surface_mesh>(moved(soup, random, 1)), ratio);
}

// Steps are equal but for the last one, whether lines have been moved or not.
BOOST_AUTO_TEST_CASE(steps_are_as_long_as_is_asked_for)
{
  random_meshes::Random random(11);
  for(const double smooth : {0., 1.})
    for(const double spacing : {0.03, 0.2, 0.7})
      for(const Triangle_soup& soup :
          {capsule(1, 10, 12, 10), closed_tube(1, 10, 12, 20, 1), generated_surfaces::torus(12, 40)})
      {
        const auto mesh = generated_surfaces::make_mesh<Surface_mesh>(moved(soup, random, 3));
        Skeleton skeleton;
        const auto np = parameters::spacing(3 * spacing).smooth(smooth);
        BOOST_TEST(extract_curve_skeleton(mesh, skeleton, np).is_inside());
        for(const auto& arc : skeleton_arcs(skeleton))
          for(std::size_t i = 1; i != arc.size(); ++i)
          {
            const double step = step_of(skeleton, arc[i - 1], arc[i]) / 3;
            BOOST_TEST((step < 1.01 * spacing && (i + 1 == arc.size() || step > 0.99 * spacing)));
          }
      }
  const auto mesh = generated_surfaces::make_mesh<Surface_mesh>(generated_surfaces::torus(12, 40));
  Skeleton skeleton;
  for(const double spacing : {-1., 1e-9, std::nan("")})
    BOOST_CHECK_THROW(extract_curve_skeleton(mesh, skeleton, parameters::spacing(spacing)),
                      CGAL::Reeb_graph::Parameter_error);
}

// The line of a tube leads from the middle of one cap to that of the other one.
BOOST_AUTO_TEST_CASE(tips_of_blunt_ends_are_in_the_middle)
{
  for(std::size_t seed = 0; seed != 30; ++seed)
  {
    random_meshes::Random random(seed);
    const double radius = in(0.5, 4, random), length = in(3.5, 15, random) * radius;
    const std::size_t around = 10 + random.below(40), along = 3 + random.below(30), in_caps = random.below(5);
    BOOST_TEST_CONTEXT("seed " << seed)
    {
      const auto mesh = generated_surfaces::make_mesh<Surface_mesh>(
        moved(closed_tube(radius, length, around, along, in_caps), random, 1));
      const Skeleton skeleton = check_steps(mesh, 0.5);
      BOOST_TEST(std::abs(length_of(skeleton) - length) < 0.1 * radius);
      double sum = 0;
      for(const auto v : CGAL::make_range(vertices(skeleton)))
        sum += out_degree(v, skeleton) == 1 ? skeleton[v].inscribed_radius : 0;
      BOOST_TEST(sum == 0);
      BOOST_TEST(std::abs(mean_of(skeleton, [](const auto& v) { return v.radius; }) / radius - 1) < 0.08);
    }
  }
}

// The ends of bent tubes, too: the line meets the middle of each cap.
BOOST_AUTO_TEST_CASE(tips_of_bent_tubes_are_in_the_middle)
{
  for(std::size_t seed = 0; seed != 20; ++seed)
  {
    random_meshes::Random random(seed);
    const double of_circle = in(3, 8, random), radius = in(0.5, 1.2, random), angle = in(1.6, 5, random);
    const std::size_t around = 8 + random.below(24), along = 20 + random.below(80);
    BOOST_TEST_CONTEXT("seed " << seed)
    {
      const auto mesh = generated_surfaces::make_mesh<Surface_mesh>(
        moved(bent_tube(radius, of_circle, angle, around, along), random, 1));
      const Skeleton skeleton = check_steps(mesh, 0.5);
      BOOST_TEST(std::abs(length_of(skeleton) - of_circle * angle) < 0.03 * of_circle * angle + 0.15 * radius);
      for(const auto v : CGAL::make_range(vertices(skeleton)))
        if(out_degree(v, skeleton) == 1) // Rims are a radius away from the middle.
        {
          double nearest = 1e9;
          for(const auto& p : mesh.points())
            nearest = std::min(nearest, std::sqrt(CGAL::squared_distance(p, skeleton[v].point)));
          BOOST_TEST(nearest < 0.2 * radius);
        }
    }
  }
}

// What closes a limb may be cut or round at its rim, or have few corners, and what it ends may bend: its line goes on straight to it.
BOOST_AUTO_TEST_CASE(tips_are_where_limbs_go_on_straight)
{
  std::size_t number_off_axis = 0;
  for(std::size_t seed = 0; seed != 80; ++seed)
  {
    random_meshes::Random random(seed);
    const double cut = in(0.05, 0.25, random), length = in(6, 15, random), of_circle = in(3, 8, random);
    const std::size_t around = 6 + random.below(20), along = 10 + random.below(30);
    std::vector<Ring> rings = {{0, 1 - cut}};
    add_rings({cut, 1}, {length - cut, 1}, along, rings);
    rings.push_back({length, 1 - cut});
    const auto shape = [&]() -> Triangle_soup {
      switch(seed % 4)
      {
      case 0: return turned(rings, around, 0, length);
      case 1: return closed_tube(1, length, 3, along, 0);
      case 2:
      {
        Triangle_soup bar = closed_tube(std::sqrt(2.), length, 4, along, 0);
        for(Point& p : bar.points)
          p = {p[0] - p[1], 1.5 * (p[0] + p[1]), p[2]};
        return bar;
      }
      default:
        Triangle_soup bent = capsule(1, length, 4 * (around / 4 + 1), along);
        for(Point& p : bent.points)
        {
          const double place = std::clamp(p[2], 0., length), turn = place / of_circle, beyond = p[2] - place;
          p = {(of_circle + p[0]) * std::cos(turn) - beyond * std::sin(turn), p[1],
               (of_circle + p[0]) * std::sin(turn) + beyond * std::cos(turn)};
        }
        return bent;
      }
    };
    Triangle_soup soup = shape(), ends;
    const std::size_t number = soup.points.size(); // The last ones are in the middle of what closes limbs.
    ends.points = {soup.points[number - 2], soup.points[number - 1]};
    auto same = random;
    ends = moved(ends, same, 1);
    const auto mesh = generated_surfaces::make_mesh<Surface_mesh>(moved(soup, random, 1));
    const Skeleton skeleton = check_steps(mesh, 0.5);
    const auto at = [&](std::size_t i) {
      return Surface_mesh::Point(ends.points[i][0], ends.points[i][1], ends.points[i][2]);
    };
    const CGAL::Simple_cartesian<double>::Line_3 axis(at(0), at(1));
    const auto all = CGAL::make_range(vertices(skeleton));
    const auto is_off = [&](auto v) { return CGAL::squared_distance(axis, skeleton[v].point) > 0.5 * 0.5; };
    number_off_axis += seed % 4 != 3 && std::any_of(all.begin(), all.end(), is_off) ? 1 : 0;
    for(const auto v : CGAL::make_range(vertices(skeleton)))
      if(out_degree(v, skeleton) == 1)
      {
        double nearest = 1e9;
        for(const auto& [x, y, z] : ends.points)
          nearest =
            (std::min)(nearest, std::sqrt(CGAL::squared_distance(Surface_mesh::Point(x, y, z), skeleton[v].point)));
        BOOST_TEST(nearest < (seed % 4 == 3 ? 0.75 : 0.2), "seed " << seed << ": " << nearest);
      }
  }
  BOOST_TEST(number_off_axis < 6u); // of 60; 54 where lines come from corners
}

// Vertices on what is flat or round are no ends, however many there are.
BOOST_AUTO_TEST_CASE(faces_cut_at_random_make_no_ends)
{
  for(std::size_t seed = 0; seed != 30; ++seed)
  {
    random_meshes::Random random(seed);
    const double radius = in(0.5, 4, random), length = in(3.5, 15, random) * radius, share = in(0.3, 1, random);
    const std::size_t around = 8 + 4 * random.below(10), along = 3 + random.below(40), in_caps = random.below(6);
    BOOST_TEST_CONTEXT("seed " << seed)
    {
      const Triangle_soup soup =
        seed % 3 == 0 ? capsule(radius, length, around, along) : closed_tube(radius, length, around, along, in_caps);
      Skeleton skeleton;
      const auto mesh = generated_surfaces::make_mesh<Surface_mesh>(moved(cut(soup, share, random), random, 1));
      BOOST_TEST(extract_curve_skeleton(mesh, skeleton).number_of_ends == 2u);
    }
  }
}

// Nor does a fat ring get any, whose fronts meet at its far side. Its line is in the middle, though the surface that is near the
// line on the way there has edges.
BOOST_AUTO_TEST_CASE(lines_of_tori_have_no_ends_and_are_in_the_middle)
{
  for(std::size_t seed = 0; seed != 60; ++seed)
  {
    random_meshes::Random random(seed);
    const double radius = in(0.2, 0.9, random), share = in(0, 1, random), pi = std::acos(-1.);
    const std::size_t around = 8 + random.below(24), along = around + 8 + random.below(40);
    BOOST_TEST_CONTEXT("seed " << seed << ", radius " << radius)
    {
      const Triangle_soup soup =
        generated_surfaces::internal::grid(around, along, true, true, [&](std::size_t column, std::size_t row) {
          const double t = 2 * pi * static_cast<double>(row) / static_cast<double>(along),
                       u = 2 * pi * static_cast<double>(column) / static_cast<double>(around),
                       rho = 1 + radius * std::cos(u);
          return Point{rho * std::cos(t), rho * std::sin(t), radius * std::sin(u)};
        });
      Skeleton skeleton;
      const auto mesh = generated_surfaces::make_mesh<Surface_mesh>(moved(cut(soup, share, random), random, 1));
      const auto known = extract_curve_skeleton(mesh, skeleton);
      BOOST_TEST(known.number_of_ends == 0u);
      BOOST_TEST(known.number_of_loops == 1u);
      BOOST_TEST(known.number_of_contractible_loops == 0u);
      const double length = length_of(skeleton) / (2 * pi); // of a line in the middle, which is a polygon
      BOOST_TEST(length > 0.92);
      BOOST_TEST(length < 1.02);
    }
  }
}

// Tips of what is round or pointed stay vertices of the surface.
BOOST_AUTO_TEST_CASE(tips_of_round_and_pointed_ends_stay)
{
  random_meshes::Random random(3);
  std::vector<Ring> cone, ball;
  add_rings({0.5, 0.05}, {10, 1}, 20, cone);
  for(int i = 1; i != 12; ++i)
    ball.push_back({-2 * std::cos(pi * i / 12), std::sin(pi * i / 12)});
  for(const auto& [soup, number_of_blunt] : {std::make_pair(capsule(1, 8, 24, 16), 0),
                                             {capsule(1, 8, 16, 30), 0},
                                             {turned(cone, 24, 0, 10), 1},
                                             {turned(ball, 24, -2, 2), 0}})
  {
    const auto mesh = generated_surfaces::make_mesh<Surface_mesh>(moved(soup, random, 1));
    const Skeleton skeleton = check_steps(mesh, 0.5);
    int number_of_others = 0;
    for(const auto v : CGAL::make_range(vertices(skeleton)))
      if(out_degree(v, skeleton) == 1)
        number_of_others += std::none_of(mesh.points().begin(), mesh.points().end(),
                                         [&](const auto& p) { return p == skeleton[v].point; })
                            ? 1
                            : 0;
    BOOST_TEST(number_of_others == number_of_blunt);
  }
}

// A line that bends at a handle can look at a side of the bar: its end is in the middle of the cap all the same. On a fine mesh,
// the front comes to the inside of the cap last, not to a corner.
BOOST_AUTO_TEST_CASE(bars_with_a_handle_end_in_the_middle_of_their_caps)
{
  for(const int length : {14, 18})
    for(const int fine : {1, 2})
      for(int z = 5; z <= length - 8; ++z)
        BOOST_TEST_CONTEXT("length " << length << ", handle at " << z << ", cells cut " << fine << " times")
        {
          const auto is_solid = [&](const Voxel_solid::Cell& cell) {
            const int x = cell[0] / fine, y = cell[1] / fine, height = cell[2] / fine;
            const bool is_bar = x < 9 && y < 9 && height < length;
            const bool is_foot = x < 12 && (height == z || height == z + 2);
            return is_bar || (y == 2 && (is_foot || (x == 11 && height == z + 1)));
          };
          const auto mesh =
            generated_surfaces::make_mesh<Surface_mesh>(Voxel_solid::of_cells(20 * fine, is_solid).surface());
          Curve_skeleton<Surface_mesh> skeleton;
          BOOST_TEST(extract_curve_skeleton(mesh, skeleton).number_of_loops == 1u);
          std::size_t number_in_middle = 0;
          for(const auto v : CGAL::make_range(vertices(skeleton)))
            for(const int cap : {0, length})
              if(out_degree(v, skeleton) == 1
                 && squared_distance(skeleton[v].point, Surface_mesh::Point(4.5 * fine, 4.5 * fine, cap * fine))
                      < 0.01 * fine * fine)
                ++number_in_middle;
          BOOST_TEST(number_in_middle == 2u);
        }
}

// A front passes around the wall of a long pipe before it passes along: loops through centers of contours go down and up again.
BOOST_AUTO_TEST_CASE(loops_of_pipes_go_around_them)
{
  double sum = 0;
  std::size_t number = 0;
  for(const double inner : {0.5, 0.8, 0.9, 0.95})
    for(const std::size_t around : {6u, 12u})
      for(const std::size_t parts : {1u, 2u})
        BOOST_TEST_CONTEXT("inner radius " << inner << ", " << around << " around, sides in parts: " << parts)
        {
          const std::array<Ring, 4> section = {Ring{0, 1}, {10, 1}, {10, inner}, {0, inner}};
          const auto soup =
            generated_surfaces::internal::grid(around, 4 * parts, true, true, [&](std::size_t i, std::size_t k) {
              const Ring &from = section[k / parts], &to = section[(k / parts + 1) % 4];
              const double t = static_cast<double>(k % parts) / static_cast<double>(parts);
              const double turn = 2 * pi * static_cast<double>(i) / static_cast<double>(around);
              const double radius = (1 - t) * from[1] + t * to[1];
              return Point{radius * std::cos(turn), radius * std::sin(turn), (1 - t) * from[0] + t * to[0]};
            });
          const auto mesh = generated_surfaces::make_mesh<Surface_mesh>(soup);
          Curve_skeleton<Surface_mesh> skeleton;
          const Skeleton_certificate certificate = extract_curve_skeleton(mesh, skeleton);
          BOOST_TEST(certificate.number_of_loops == 1u);
          BOOST_TEST(certificate.number_of_contractible_loops == 0u);
          double length = 0;
          for(const auto e : CGAL::make_range(edges(skeleton)))
            length +=
              std::sqrt(squared_distance(skeleton[source(e, skeleton)].point, skeleton[target(e, skeleton)].point));
          sum += length / (pi * (1 + inner));
          ++number;
        }
  BOOST_TEST(sum / static_cast<double>(number)
             < 2.2); // 2.5 with ways along all chains, 4 with detours from lines as they are
}

BOOST_AUTO_TEST_SUITE_END()
