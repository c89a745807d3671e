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
#include "tube_samples.h"
#include "voxel_solids.h"

#include <CGAL/Reeb_graph/internal/space/Self_intersections.h>
#include <CGAL/Reeb_graph/scalar_maps.h>
#include <CGAL/Reeb_graph/skeleton/extract_curve_skeleton.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/self_intersections.h>
#include <CGAL/boost/graph/Euler_operations.h>

#include <boost/graph/connected_components.hpp>
#include <boost/mpl/list.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <map>
#include <set>
#include <type_traits>
#include <utility>
#include <vector>

// Curve skeletons: ends and loops, where they are, radii, and what certifies them.

BOOST_AUTO_TEST_SUITE(test_skeleton)

using CGAL::Reeb_graph::Curve_skeleton;
using CGAL::Reeb_graph::extract_curve_skeleton;
using CGAL::Reeb_graph::Skeleton_certificate;
using generated_surfaces::make_mesh;
using mesh_builders::Polyhedron;
using mesh_builders::Surface_mesh;
using tube_samples::Tubes;
namespace parameters = CGAL::parameters;

typedef boost::mpl::list<Surface_mesh, Polyhedron> Meshes;

namespace {
template <class Skeleton>
std::size_t number_of_parts(const Skeleton& skeleton)
{
  std::vector<std::size_t> numbers(num_vertices(skeleton));
  return num_vertices(skeleton) == 0 ? 0
                                     : static_cast<std::size_t>(boost::connected_components(skeleton, numbers.data()));
}

template <class Skeleton>
std::size_t number_of_cycles(const Skeleton& skeleton)
{
  return num_edges(skeleton) + number_of_parts(skeleton) - num_vertices(skeleton);
}

template <class Arc, class Skeleton>
double length_of_arc(const Arc& arc, const Skeleton& skeleton)
{
  double sum = 0;
  for(std::size_t i = 1; i != arc.size(); ++i)
    sum += std::sqrt(CGAL::squared_distance(skeleton[arc[i - 1]].point, skeleton[arc[i]].point));
  return sum;
}

template <class Skeleton>
std::size_t number_of_ends(const Skeleton& skeleton)
{
  const auto range = vertices(skeleton);
  return static_cast<std::size_t>(
    std::count_if(range.first, range.second, [&](auto v) { return out_degree(v, skeleton) == 1; }));
}

// What holds of any skeleton of any mesh.
template <class Mesh, class Skeleton>
void check(const Mesh& mesh, const Skeleton& skeleton, const Skeleton_certificate& known)
{
  BOOST_TEST(number_of_parts(skeleton) == known.number_of_components);
  BOOST_TEST(number_of_cycles(skeleton) == known.number_of_loops);
  BOOST_TEST(number_of_ends(skeleton) == known.number_of_ends);
  BOOST_TEST(known.number_of_loops + known.number_of_hidden_handles == known.genus);
  std::set<typename boost::graph_traits<Mesh>::vertex_descriptor> mapped;
  std::size_t number_mapped = 0;
  for(const auto v : CGAL::make_range(vertices(skeleton)))
  {
    number_mapped += skeleton[v].vertices.size();
    mapped.insert(skeleton[v].vertices.begin(), skeleton[v].vertices.end());
    BOOST_TEST(std::isfinite(skeleton[v].point.x() + skeleton[v].point.y() + skeleton[v].point.z()));
    BOOST_TEST((skeleton[v].inscribed_radius >= 0 && skeleton[v].radius >= skeleton[v].inscribed_radius));
  }
  BOOST_TEST(number_mapped == mapped.size());
  for(const auto e : CGAL::make_range(edges(skeleton)))
    BOOST_TEST(skeleton[source(e, skeleton)].point != skeleton[target(e, skeleton)].point);
  // Junctions nearer to each other than the surface are one, but where the line between them leaves the balls around them.
  for(const auto& arc : skeleton_arcs(skeleton))
  {
    const auto &a = skeleton[arc.front()], &b = skeleton[arc.back()];
    if(known.number_of_crossing_edges == 0 && arc.front() != arc.back() && out_degree(arc.front(), skeleton) > 1
       && out_degree(arc.back(), skeleton) > 1)
      BOOST_TEST(
        (std::sqrt(CGAL::squared_distance(a.point, b.point)) >= 0.999 * std::min(a.inscribed_radius, b.inscribed_radius)
         || length_of_arc(arc, skeleton) >= 0.8 * (a.inscribed_radius + b.inscribed_radius)));
  }
  std::size_t number_with_faces = 0;
  for(const auto v : vertices(mesh))
    number_with_faces += halfedge(v, mesh) != boost::graph_traits<Mesh>::null_halfedge() ? 1 : 0;
  BOOST_TEST(mapped.size() == number_with_faces);
  const auto arcs = skeleton_arcs(skeleton);
  BOOST_TEST(arcs.size() == known.number_of_arcs);
  for(std::size_t arc = 0; arc != arcs.size(); ++arc)
  {
    BOOST_TEST(skeleton[arcs[arc].front()].arc == std::size_t(-1));
    BOOST_TEST(skeleton[arcs[arc].back()].arc == std::size_t(-1));
    for(std::size_t i = 1; i + 1 < arcs[arc].size(); ++i)
    {
      BOOST_TEST(skeleton[arcs[arc][i]].arc == arc);
      BOOST_TEST(skeleton[arcs[arc][i]].place >= skeleton[arcs[arc][i - 1]].place);
    }
  }
  if(known.number_of_crossing_components == 0)
  {
    BOOST_TEST(known.number_of_vertices_outside == 0u);
    BOOST_TEST(known.number_of_crossing_edges == 0u);
    BOOST_TEST(known.number_of_contractible_loops == 0u);
    for(const auto v : CGAL::make_range(vertices(skeleton)))
      BOOST_TEST((out_degree(v, skeleton) == 1 || skeleton[v].inscribed_radius > 0));
  }
}

struct Errors
{
  double mean_deviation = 0, high_deviation = 0, radius = 0, length = 0;
};

// Ends are at the surface, and have no deviation, and neither has what is near them, on the way there. Where a ball inside is larger than a tube, as where that leaves a larger one,
// the radius is that of the ball.
template <class Skeleton>
Errors errors_of(const Skeleton& skeleton, const Tubes& sample)
{
  Errors errors;
  std::vector<double> deviations;
  const auto range = vertices(skeleton);
  for(const auto v : CGAL::make_range(range))
  {
    const auto& p = skeleton[v].point;
    const auto [deviation, radius] = sample.deviation({p.x(), p.y(), p.z()});
    // Inside of the ball of a junction, a line has no radius of its own.
    if(std::any_of(range.first, range.second, [&](auto u) {
         const double near = out_degree(u, skeleton) == 1 ? 1.5 * radius
                           : out_degree(u, skeleton) > 2  ? skeleton[u].inscribed_radius
                                                          : 0;
         return CGAL::squared_distance(skeleton[u].point, p) < near * near;
       }))
      continue;
    deviations.push_back(deviation);
    errors.radius += std::abs(skeleton[v].radius / std::max(radius, skeleton[v].inscribed_radius) - 1);
  }
  const double size = static_cast<double>(deviations.size());
  errors.radius /= size;
  for(const double deviation : deviations)
    errors.mean_deviation += deviation / size;
  std::sort(deviations.begin(), deviations.end());
  errors.high_deviation = deviations[deviations.size() * 95 / 100];
  for(const auto e : CGAL::make_range(edges(skeleton)))
    errors.length +=
      std::sqrt(CGAL::squared_distance(skeleton[source(e, skeleton)].point, skeleton[target(e, skeleton)].point));
  errors.length = std::abs(errors.length / sample.length - 1);
  return errors;
}

// An octahedron, subdivided, whose corners have been moved out, or in, up to 50 times as far: none of these intersects itself.
generated_surfaces::Triangle_soup spiky_sphere(int steps, random_meshes::Random& random)
{
  generated_surfaces::Triangle_soup soup;
  soup.points = {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
  soup.triangles = {{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4}, {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}};
  for(int step = 0; step != steps; ++step)
  {
    std::map<std::pair<std::size_t, std::size_t>, std::size_t> middles;
    const auto middle = [&](std::size_t a, std::size_t b) {
      const auto [place, is_new] = middles.insert({std::minmax(a, b), soup.points.size()});
      if(is_new)
        soup.points.push_back(tube_samples::between(soup.points[a], soup.points[b], 0.5));
      return place->second;
    };
    for(const auto& [a, b, c] : std::exchange(soup.triangles, {}))
    {
      const std::size_t ab = middle(a, b), bc = middle(b, c), ca = middle(c, a);
      soup.triangles.insert(soup.triangles.end(), {{a, ab, ca}, {ab, b, bc}, {ca, bc, c}, {ab, bc, ca}});
    }
  }
  const double spread = static_cast<double>(random.below(401)) / 100;
  for(auto& point : soup.points)
  {
    const double factor = std::exp(spread * (static_cast<double>(random.below(1001)) / 500 - 1));
    for(double& coordinate : point)
      coordinate *= factor;
  }
  return soup;
}

// A surface of few faces that are sharp: cubes, or a torus, whose corners have been moved far, or a spiky sphere.
generated_surfaces::Triangle_soup coarse_surface(std::size_t seed)
{
  random_meshes::Random random(seed);
  if(seed % 5 == 4)
    return spiky_sphere(1 + static_cast<int>(random.below(2)), random);
  auto soup = seed % 4 != 0 ? Voxel_solid(2 + static_cast<int>(seed % 3), seed).surface()
                            : generated_surfaces::torus(3 + random.below(3), 3 + random.below(5));
  const double distance = static_cast<double>(random.below(60)) / 100;
  for(auto& point : soup.points)
    for(double& coordinate : point)
      coordinate += distance * (static_cast<double>(random.below(1001)) / 500 - 1);
  return soup;
}

// Of each edge with each face, by exact predicates. What has a corner in an end of the skeleton may be met there only: it
// does not contain the direction of the edge.
template <class Skeleton>
std::size_t number_of_crossings(const Surface_mesh& mesh, const Skeleton& skeleton)
{
  typedef CGAL::Exact_predicates_inexact_constructions_kernel Kernel;
  typedef Kernel::Point_3 Point;
  const auto converted = [](const auto& p) { return Point(p.x(), p.y(), p.z()); };
  std::size_t number = 0;
  for(const auto e : CGAL::make_range(edges(skeleton)))
  {
    const auto s = source(e, skeleton), t = target(e, skeleton);
    const Point p = converted(skeleton[s].point), q = converted(skeleton[t].point);
    for(const auto f : faces(mesh))
    {
      const auto h = halfedge(f, mesh);
      const Point a = converted(mesh.point(source(h, mesh))), b = converted(mesh.point(target(h, mesh))),
                  c = converted(mesh.point(target(next(h, mesh), mesh)));
      const Kernel::Triangle_3 face(a, b, c);
      const auto is_end = [&](auto v, const Point& x) { // in a corner, or, but for rounding, in the middle
        return out_degree(v, skeleton) == 1
            && CGAL::squared_distance(face, x) <= 1e-26 * (x - CGAL::ORIGIN).squared_length();
      };
      const bool is_from = is_end(s, p), is_to = is_end(t, q);
      const bool is_met = is_from != is_to ? CGAL::coplanar(a, b, c, is_from ? q : p)
                        : p == q           ? face.has_on(p)
                                           : CGAL::do_intersect(face, Kernel::Segment_3(p, q));
      number += is_met ? 1 : 0;
    }
  }
  return number;
}

} // namespace

BOOST_AUTO_TEST_CASE(lines_stay_inside_of_coarse_surfaces)
{
  std::size_t number = 0;
  for(std::size_t seed = 0; seed != 360; ++seed)
  {
    BOOST_TEST_CONTEXT("seed " << seed)
    {
      const auto mesh = make_mesh<Surface_mesh>(coarse_surface(seed));
      Curve_skeleton<Surface_mesh> skeleton;
      const Skeleton_certificate known = extract_curve_skeleton(mesh, skeleton);
      check(mesh, skeleton, known);
      if(known.number_of_crossing_components != 0 || known.number_of_components != 1)
        continue;
      BOOST_TEST(number_of_crossings(mesh, skeleton) == 0u);
      ++number;
    }
  }
  BOOST_TEST(number >= 72u);
}

BOOST_AUTO_TEST_CASE(tubes_have_their_ends_loops_and_centerlines)
{
  for(const Tubes& sample : tube_samples::all())
  {
    const auto soup = tube_samples::surface(sample);
    for(const double noise : {0., 0.05, 0.1})
    {
      BOOST_TEST_CONTEXT(sample.name << " with noise " << noise)
      {
        const auto mesh = make_mesh<Surface_mesh>(tube_samples::with_noise(soup, sample, noise, 7));
        Curve_skeleton<Surface_mesh> skeleton;
        const Skeleton_certificate known = extract_curve_skeleton(mesh, skeleton);
        check(mesh, skeleton, known);
        BOOST_TEST(known.number_of_components == sample.components);
        BOOST_TEST(known.number_of_ends == sample.ends);
        BOOST_TEST(known.number_of_border_ends == sample.border_ends);
        BOOST_TEST(known.number_of_loops == sample.loops);
        const Errors errors = errors_of(skeleton, sample);
        BOOST_TEST(errors.mean_deviation <= (noise == 0.1 ? 0.07 : 0.05));
        BOOST_TEST(errors.high_deviation <= (noise == 0.1 ? 0.3 : 0.25));
        BOOST_TEST(errors.radius <= (noise == 0.1 ? 0.07 : 0.05));
        BOOST_TEST(errors.length <= 0.07);
      }
    }
  }
}

// How often the loop of a skeleton winds around the third axis: its only one, with ends on it.
template <class Skeleton>
double winding_number(const Skeleton& skeleton)
{
  auto arcs = skeleton_arcs(skeleton);
  arcs.erase(std::remove_if(arcs.begin(), arcs.end(),
                            [&](const auto& arc) {
                              return out_degree(arc.front(), skeleton) == 1 || out_degree(arc.back(), skeleton) == 1;
                            }),
             arcs.end());
  double sum = 0;
  for(auto node = arcs.front().front(); !arcs.empty();)
  {
    const auto next = std::find_if(arcs.begin(), arcs.end(),
                                   [&](const auto& arc) { return arc.front() == node || arc.back() == node; });
    BOOST_REQUIRE(next != arcs.end());
    if(next->front() != node)
      std::reverse(next->begin(), next->end());
    for(std::size_t i = 1; i != next->size(); ++i)
    {
      const auto &p = skeleton[(*next)[i - 1]].point, &q = skeleton[(*next)[i]].point;
      sum += std::atan2(p.x() * q.y() - p.y() * q.x(), p.x() * q.x() + p.y() * q.y());
    }
    node = next->back();
    arcs.erase(next);
  }
  return std::abs(sum) / 6.283185307179586;
}

// Tori, and pipes with thick walls, which fronts pass around before they pass along.
BOOST_AUTO_TEST_CASE(loops_of_tori_and_pipes_wind)
{
  for(int i = -5; i != 20; ++i)
  {
    BOOST_TEST_CONTEXT("shape " << i)
    {
      auto soup = generated_surfaces::torus(40, 80);
      for(std::size_t v = 0; v != soup.points.size() && i != 0; ++v) // The tube has the radius 0.4.
      {
        auto& p = soup.points[v];
        const double rho = std::hypot(p[0], p[1]), angle = std::atan2(p[2], rho - 1);
        double new_rho = 1 + 0.05 * i / 0.4 * (rho - 1), height = 0.05 * i / 0.4 * p[2];
        if(i < 0)
        {
          new_rho = std::abs(angle) < 1.6 ? 1.1 : 0.9;
          height = -2 * i * std::sin(angle) / (std::abs(std::cos(angle)) + std::abs(std::sin(angle)));
        }
        p = {new_rho / rho * p[0], new_rho / rho * p[1], height};
      }
      const auto mesh = make_mesh<Surface_mesh>(soup);
      Curve_skeleton<Surface_mesh> skeleton;
      check(mesh, skeleton, extract_curve_skeleton(mesh, skeleton));
      BOOST_TEST(std::abs(winding_number(skeleton) - 1) < 1e-6);
    }
  }
}

namespace {
// A tube of radius 1 around the z-axis, open at both ends, whose first and last columns are the same points, or vertices.
generated_surfaces::Triangle_soup open_tube(std::size_t around, std::size_t along, double length, bool is_slit)
{
  generated_surfaces::Triangle_soup soup;
  const std::size_t columns = is_slit ? around + 1 : around;
  for(std::size_t row = 0; row <= along; ++row)
    for(std::size_t column = 0; column != columns; ++column)
    {
      const double angle = 6.283185307179586 * static_cast<double>(column % around) / static_cast<double>(around);
      soup.points.push_back(
        {std::cos(angle), std::sin(angle), length * static_cast<double>(row) / static_cast<double>(along)});
    }
  for(std::size_t row = 0; row != along; ++row)
    for(std::size_t column = 0; column != around; ++column)
    {
      const std::size_t a = row * columns + column, b = row * columns + (column + 1) % columns;
      soup.triangles.push_back({a, b, b + columns});
      soup.triangles.push_back({a, b + columns, a + columns});
    }
  return soup;
}

template <class Skeleton>
double length_of(const Skeleton& skeleton)
{
  double length = 0;
  for(const auto e : CGAL::make_range(edges(skeleton)))
    length +=
      std::sqrt(CGAL::squared_distance(skeleton[source(e, skeleton)].point, skeleton[target(e, skeleton)].point));
  return length;
}
} // namespace

// Moved lines are nearer to the axes than those through the centers of contours, all along, with the same ends and loops.
BOOST_AUTO_TEST_CASE(lines_are_moved_to_the_middle)
{
  for(const Tubes& sample : tube_samples::all())
    for(const double noise : {0., 0.1})
    {
      BOOST_TEST_CONTEXT(sample.name << " with noise " << noise)
      {
        const auto mesh = make_mesh<Surface_mesh>(tube_samples::surface(sample, noise, 5));
        Curve_skeleton<Surface_mesh> moved, unmoved;
        const Skeleton_certificate known = extract_curve_skeleton(mesh, moved);
        const Skeleton_certificate before = extract_curve_skeleton(mesh, unmoved, parameters::smooth(0));
        BOOST_TEST(known.number_of_ends == before.number_of_ends);
        BOOST_TEST(known.number_of_loops == before.number_of_loops);
        const auto mean_deviation = [&](const auto& skeleton) {
          double sum = 0;
          for(const auto e : CGAL::make_range(edges(skeleton)))
          {
            const auto &p = skeleton[source(e, skeleton)].point, &q = skeleton[target(e, skeleton)].point;
            for(double t = 0.05; t < 1; t += 0.1)
            {
              const auto r = p + t * (q - p);
              sum += std::sqrt(CGAL::squared_distance(p, q)) / 10 * sample.deviation({r.x(), r.y(), r.z()}).first;
            }
          }
          return sum / length_of(skeleton);
        };
        BOOST_TEST(mean_deviation(moved) < 0.9 * mean_deviation(unmoved));
      }
    }
}

// A slit along the tube is closed: the line is that of the tube without.
BOOST_AUTO_TEST_CASE(open_tubes_have_their_radius_and_length_with_and_without_a_slit)
{
  for(const bool is_slit : {false, true})
    for(const std::size_t along : {7u, 20u, 33u})
    {
      const auto mesh = make_mesh<Surface_mesh>(open_tube(16, along, 10, is_slit));
      Curve_skeleton<Surface_mesh> skeleton;
      const Skeleton_certificate known = extract_curve_skeleton(mesh, skeleton);
      BOOST_TEST(known.number_of_arcs == 1u);
      BOOST_TEST(known.number_of_border_ends == 2u);
      BOOST_TEST(std::abs(length_of(skeleton) - 10) < 1e-6);
      for(const auto v : CGAL::make_range(vertices(skeleton)))
        BOOST_TEST(std::abs(skeleton[v].inscribed_radius - std::cos(3.141592653589793 / 16)) < 0.01);
      for(const auto& arc : skeleton_arcs(skeleton))
        for(std::size_t i = 2; i < arc.size(); ++i)
        {
          const auto size = [&](std::size_t k) {
            return std::sqrt(CGAL::squared_distance(skeleton[arc[k - 1]].point, skeleton[arc[k]].point));
          };
          BOOST_TEST((std::min)(size(i - 1), size(i)) >= 0.1 * (std::max)(size(i - 1), size(i)));
        }
    }
}

// Surfaces with slits, doubled points, faces without area, and handles, in units in which products are infinite, or 0.
BOOST_AUTO_TEST_CASE(units_change_nothing)
{
  std::vector<generated_surfaces::Triangle_soup> soups = {open_tube(5, 7, 10, false), open_tube(8, 5, 3, true),
                                                          generated_surfaces::torus(6, 12), coarse_surface(3)};
  soups.push_back({{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {0, 3, 2}}});
  soups.push_back(open_tube(8, 5, 3, false));
  soups.back().points[9] = soups.back().points[8]; // Two faces have no area.
  soups.push_back(
    {{{-1, 0, 0}, {1, 0, 0}, {0, -1, 0}, {0, 1, 0}, {0, 0, 0}, {0, 0, 0}}, // Two sheets that are pressed together.
     {{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4}, {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}}});
  for(const auto& soup : soups)
  {
    const auto mesh = make_mesh<Surface_mesh>(soup);
    Curve_skeleton<Surface_mesh> skeleton;
    const Skeleton_certificate known = extract_curve_skeleton(mesh, skeleton);
    for(const int exponent : {-900, -720, -358, -30, 1, 40, 53, 66, 342, 500, 720, 990})
    {
      auto scaled = mesh;
      for(const auto v : scaled.vertices())
      {
        const auto& p = mesh.point(v);
        scaled.point(v) = {std::scalbn(p.x(), exponent), std::scalbn(p.y(), exponent), std::scalbn(p.z(), exponent)};
      }
      Curve_skeleton<Surface_mesh> other;
      const Skeleton_certificate found = extract_curve_skeleton(scaled, other);
      BOOST_TEST(found.number_of_crossing_components == known.number_of_crossing_components);
      BOOST_TEST(found.number_of_vertices_outside == known.number_of_vertices_outside);
      BOOST_TEST(num_vertices(other) == num_vertices(skeleton));
      for(std::size_t v = 0; v != (std::min)(num_vertices(skeleton), num_vertices(other)); ++v)
      {
        for(int i = 0; i != 3; ++i)
          BOOST_TEST(other[v].point[i] == std::scalbn(skeleton[v].point[i], exponent));
        BOOST_TEST(other[v].radius == std::scalbn(skeleton[v].radius, exponent));
        BOOST_TEST(other[v].inscribed_radius == std::scalbn(skeleton[v].inscribed_radius, exponent));
      }
    }
  }
}

BOOST_AUTO_TEST_CASE_TEMPLATE(order_of_vertices_changes_nothing, Mesh, Meshes)
{
  const std::size_t number_of_seeds = std::is_same_v<Mesh, Surface_mesh> ? 24 : 6; // The mesh is only read.
  for(std::size_t seed = 0; seed != number_of_seeds; ++seed)
    BOOST_TEST_CONTEXT("seed " << seed)
    {
      random_meshes::Random random(seed);
      auto soup = seed % 3 == 0 ? coarse_surface(seed)
                : seed % 3 == 1 ? tube_samples::surface(tube_samples::fat_ring(seed), 0.1, seed)
                                : tube_samples::surface(tube_samples::pierced_tube(0.4), 0.1, seed);
      const auto mesh = make_mesh<Mesh>(soup);
      generated_surfaces::shuffle(soup, random);
      const auto shuffled = make_mesh<Mesh>(soup);
      Curve_skeleton<Mesh> skeleton, other;
      const Skeleton_certificate known = extract_curve_skeleton(mesh, skeleton),
                                 found = extract_curve_skeleton(shuffled, other);
      BOOST_TEST(found.number_of_ends == known.number_of_ends);
      BOOST_TEST(found.number_of_loops == known.number_of_loops);
      if(known.number_of_components != 1)
        continue; // Components are in the order of their first vertices.
      BOOST_TEST(num_vertices(other) == num_vertices(skeleton));
      for(std::size_t v = 0; v != (std::min)(num_vertices(skeleton), num_vertices(other)); ++v)
        BOOST_TEST(other[v].point == skeleton[v].point);
    }
}

BOOST_AUTO_TEST_CASE(fronts_that_meet_in_fat_rings_make_no_end)
{
  for(std::size_t seed = 0; seed != 60; ++seed)
  {
    BOOST_TEST_CONTEXT("seed " << seed)
    {
      const auto mesh = make_mesh<Surface_mesh>(tube_samples::surface(tube_samples::fat_ring(seed), 0, 1));
      Curve_skeleton<Surface_mesh> skeleton;
      const Skeleton_certificate known = extract_curve_skeleton(mesh, skeleton);
      check(mesh, skeleton, known);
      BOOST_TEST(known.number_of_loops == 1u);
      BOOST_TEST(known.number_of_ends == 0u);
    }
  }
}

BOOST_AUTO_TEST_CASE(holes_in_a_wall_make_no_cycle)
{
  for(const double radius : {0.25, 0.4, 0.6, 0.8})
  {
    const auto mesh = make_mesh<Surface_mesh>(tube_samples::surface(tube_samples::pierced_tube(radius), 0, 1));
    Curve_skeleton<Surface_mesh> skeleton;
    const Skeleton_certificate known = extract_curve_skeleton(mesh, skeleton);
    check(mesh, skeleton, known);
    BOOST_TEST(known.number_of_loops == 0u);
    BOOST_TEST(known.number_of_ends == 4u);
    BOOST_TEST(known.number_of_border_ends == 2u);
    check(mesh, skeleton, extract_curve_skeleton(mesh, skeleton, parameters::pruning_ratio(0)));
    check(mesh, skeleton, extract_curve_skeleton(mesh, skeleton, parameters::ends_at_borders(false)));
    BOOST_TEST(number_of_ends(skeleton) == 2u);
  }
}

BOOST_AUTO_TEST_CASE(filled_holes_leave_the_centerline)
{
  const Tubes sample = tube_samples::pierced_tube(0.4);
  for(const double noise : {0., 0.05, 0.1})
  {
    const auto mesh = make_mesh<Surface_mesh>(tube_samples::surface(sample, noise, 7));
    Curve_skeleton<Surface_mesh> skeleton;
    check(mesh, skeleton, extract_curve_skeleton(mesh, skeleton, parameters::ends_at_borders(false)));
    BOOST_TEST(number_of_ends(skeleton) == sample.ends);
    const Errors errors = errors_of(skeleton, sample);
    BOOST_TEST(errors.mean_deviation <= 0.05);
    BOOST_TEST(errors.high_deviation <= 0.25);
    BOOST_TEST(errors.length <= 0.07);
  }
}

// Holes of one triangle each, at any ratio.
BOOST_AUTO_TEST_CASE_TEMPLATE(each_border_is_an_end, Mesh, Meshes)
{
  for(std::size_t seed = 0; seed != 20; ++seed)
  {
    BOOST_TEST_CONTEXT("seed " << seed)
    {
      auto soup = generated_surfaces::torus(10, 30);
      std::size_t number_of_holes = 0;
      for(std::size_t i = 20 * (seed % 3) + seed; i < soup.triangles.size(); i += 100, ++number_of_holes)
        soup.triangles.erase(soup.triangles.begin() + static_cast<std::ptrdiff_t>(i));
      const auto mesh = make_mesh<Mesh>(soup);
      Curve_skeleton<Mesh> skeleton;
      for(const double ratio : {0., 0.5, 100.})
      {
        const Skeleton_certificate known = extract_curve_skeleton(mesh, skeleton, parameters::pruning_ratio(ratio));
        check(mesh, skeleton, known);
        BOOST_TEST(known.number_of_border_ends == number_of_holes);
        BOOST_TEST(known.number_of_loops + known.number_of_hidden_handles == 1u);
      }
      check(mesh, skeleton, extract_curve_skeleton(mesh, skeleton, parameters::ends_at_borders(false)));
    }
  }
}

// The end of an open tube is in the middle of its border.
BOOST_AUTO_TEST_CASE(ends_are_at_the_centers_of_borders)
{
  const Tubes sample = tube_samples::tree(true);
  const auto mesh = make_mesh<Surface_mesh>(tube_samples::surface(sample, 0, 1));
  Curve_skeleton<Surface_mesh> skeleton;
  BOOST_TEST(extract_curve_skeleton(mesh, skeleton, parameters::ends_at_borders(false)).number_of_border_ends == 0u);
  BOOST_TEST(number_of_ends(skeleton) == sample.ends);
  BOOST_TEST(extract_curve_skeleton(mesh, skeleton).number_of_border_ends == sample.holes.size());
  for(const auto& hole : sample.holes)
  {
    double least = std::numeric_limits<double>::infinity();
    for(const auto v : CGAL::make_range(vertices(skeleton)))
    {
      const auto& p = skeleton[v].point;
      if(out_degree(v, skeleton) == 1)
        least = (std::min)(least, tube_samples::distance(hole.center, {p.x(), p.y(), p.z()}));
    }
    BOOST_TEST(least <= 0.45 * hole.radius);
  }
}

// 200 surfaces that are random, half of them of each type, and one of each genus from 4 to 20.
BOOST_AUTO_TEST_CASE_TEMPLATE(loops_and_hidden_handles_are_the_genus, Mesh, Meshes)
{
  const std::size_t type = std::is_same<Mesh, Surface_mesh>::value ? 0 : 1;
  for(std::size_t seed = type; seed < 200; seed += 2)
  {
    BOOST_TEST_CONTEXT("seed " << seed)
    {
      const auto mesh = make_mesh<Mesh>(Voxel_solid(3 + static_cast<int>(seed / 2 % 3), seed).surface());
      Curve_skeleton<Mesh> skeleton;
      check(mesh, skeleton, extract_curve_skeleton(mesh, skeleton));
    }
  }
  for(unsigned genus = 4 + static_cast<unsigned>(type); genus <= 20; genus += 2)
  {
    const auto mesh = make_mesh<Mesh>(generated_surfaces::closed_surface(genus, 1500));
    Curve_skeleton<Mesh> skeleton;
    const Skeleton_certificate known = extract_curve_skeleton(mesh, skeleton);
    check(mesh, skeleton, known);
    BOOST_TEST(known.genus == genus);
  }
}

BOOST_AUTO_TEST_CASE_TEMPLATE(fields_of_the_user_give_lines, Mesh, Meshes)
{
  const Tubes sample = tube_samples::ladder(1);
  const auto mesh = make_mesh<Mesh>(tube_samples::surface(sample, 0, 1));
  const auto height = CGAL::Reeb_graph::make_scalar_map_from_function(mesh, [&](auto v) {
    const auto& p = get(CGAL::vertex_point, mesh, v);
    return static_cast<float>(p.z() + p.x() / 8);
  });
  Curve_skeleton<Mesh> skeleton;
  const Skeleton_certificate known = extract_curve_skeleton(mesh, skeleton, parameters::scalar_map(height));
  check(mesh, skeleton, known);
  BOOST_TEST(known.number_of_loops == 1u);
  BOOST_TEST(known.number_of_ends == 4u);
  const auto infinite =
    CGAL::Reeb_graph::make_scalar_map_from_function(mesh, [](auto) { return std::numeric_limits<double>::infinity(); });
  const std::size_t size = num_vertices(skeleton);
  BOOST_CHECK_THROW(extract_curve_skeleton(mesh, skeleton, parameters::scalar_map(infinite)),
                    CGAL::Reeb_graph::Non_finite_scalar_error);
  BOOST_TEST(num_vertices(skeleton) == size);
}

BOOST_AUTO_TEST_CASE(random_values_and_small_meshes_give_skeletons)
{
  for(std::size_t seed = 0; seed != 60; ++seed)
  {
    BOOST_TEST_CONTEXT("seed " << seed)
    {
      random_meshes::Random random(seed);
      const auto mesh = make_mesh<Surface_mesh>(Voxel_solid(3, seed).surface());
      std::vector<double> values(num_vertices(mesh));
      for(double& value : values)
        value = static_cast<double>(random.below(seed % 2 == 0 ? 5 : 1000));
      const auto map = CGAL::Reeb_graph::make_scalar_map(mesh, values);
      Curve_skeleton<Surface_mesh> skeleton;
      for(const double ratio : {0., 0.5, 100.})
        check(mesh, skeleton, extract_curve_skeleton(mesh, skeleton, parameters::pruning_ratio(ratio).scalar_map(map)));
    }
  }
  Surface_mesh empty;
  Curve_skeleton<Surface_mesh> skeleton(3);
  BOOST_TEST(extract_curve_skeleton(empty, skeleton).number_of_components == 0u);
  BOOST_TEST(num_vertices(skeleton) == 0u);
}

// Those that protrude by less than their radius are bumps.
BOOST_AUTO_TEST_CASE(spikes_are_ends)
{
  const std::vector<std::array<double, 2>> spikes = {{0.2, 0.25}, {0.35, 0.75}, {0.35, 3}, {0.2, 5}, {0.35, 5}};
  for(const bool is_ball : {false, true})
    for(const auto& [radius, height] : spikes)
      for(const double noise : {0., 0.01, 0.03})
        BOOST_TEST_CONTEXT((is_ball ? "ball" : "tube")
                           << ", radius " << radius << ", height " << height << ", noise " << noise)
        {
          if(is_ball && height < 1) // has no axis
            continue;
          const Tubes sample = tube_samples::spiked(is_ball, radius, height);
          const auto mesh = make_mesh<Surface_mesh>(tube_samples::surface(sample, noise, 7));
          Curve_skeleton<Surface_mesh> skeleton;
          const Skeleton_certificate known = extract_curve_skeleton(mesh, skeleton);
          check(mesh, skeleton, known);
          BOOST_TEST(known.number_of_ends == sample.ends);
        }
}

// A long spike near the end of a tube hides the contours of this. An end that the fronts reach late may be missing.
BOOST_AUTO_TEST_CASE(ends_beside_long_spikes_stay)
{
  for(const double radius : {0.35, 0.4})
  {
    const Tubes sample = tube_samples::spiked(false, radius, 7);
    const auto mesh = make_mesh<Surface_mesh>(tube_samples::surface(sample));
    Curve_skeleton<Surface_mesh> skeleton;
    const Skeleton_certificate known = extract_curve_skeleton(mesh, skeleton);
    check(mesh, skeleton, known);
    BOOST_TEST(known.number_of_ends + 1 >= sample.ends, radius);
  }
}

namespace {
typedef CGAL::Surface_mesh<CGAL::Exact_predicates_inexact_constructions_kernel::Point_3> Exact_mesh;

// A sphere or a torus, with vertices that are moved, some onto others or to few places, and edges that are flipped, some
// so that two of them join the same vertices.
Exact_mesh crumpled_mesh(random_meshes::Random& random)
{
  const std::size_t around = 5 + random.below(10);
  auto mesh = make_mesh<Exact_mesh>(random.below(3) == 0
                                      ? generated_surfaces::torus(around, 20 - around)
                                      : generated_surfaces::closed_surface(0, around * (3 + random.below(15))));
  for(std::size_t i = random.below(2) * random.below(40); i != 0; --i)
  {
    const auto h = mesh.halfedge(Exact_mesh::Edge_index(static_cast<unsigned>(random.below(mesh.num_edges()))));
    const auto u = mesh.target(mesh.next(h)), v = mesh.target(mesh.next(mesh.opposite(h)));
    if(u != v && mesh.degree(mesh.source(h)) > 3 && mesh.degree(mesh.target(h)) > 3)
      CGAL::Euler::flip_edge(h, mesh);
  }
  const bool are_all_moved = random.below(2) == 0;
  const std::size_t steps = random.below(3) == 0 ? 3 : 1000;
  const double noise = (random.below(2) == 0 ? 0.05 : 0.5) * static_cast<double>(random.below(100)) / 100;
  const auto any_vertex = [&] {
    return Exact_mesh::Vertex_index(static_cast<unsigned>(random.below(mesh.num_vertices())));
  };
  for(std::size_t i = are_all_moved ? mesh.num_vertices() : random.below(5); i != 0; --i)
  {
    auto& p = mesh.point(are_all_moved ? Exact_mesh::Vertex_index(static_cast<unsigned>(i - 1)) : any_vertex());
    const auto step = [&] { return noise * static_cast<double>(random.below(steps)) / static_cast<double>(steps); };
    const double x = p.x() + step(), y = p.y() + step();
    p = {x, y, p.z() + step()};
  }
  for(std::size_t i = random.below(4) / 2; i != 0; --i)
    mesh.point(any_vertex()) = mesh.point(*mesh.vertices().begin());
  return mesh;
}

std::size_t number_of_self_intersections(const Exact_mesh& mesh, bool are_counted)
{
  const auto triangles = CGAL::Reeb_graph::internal::closed_triangles(mesh);
  CGAL::Reeb_graph::internal::Self_intersections intersections(
    triangles, std::vector<CGAL::Reeb_graph::internal::Index>(mesh.num_vertices(), 0), 1, are_counted);
  return intersections(CGAL::Reeb_graph::internal::No_progress())[0];
}
} // namespace

// Pairs are counted too, where triangles are flat and not looked at, and in units in which products are infinite, or 0.
BOOST_AUTO_TEST_CASE(self_intersections_are_those_that_cgal_finds)
{
  std::size_t number_of_crossed = 0;
  const std::size_t number_of_seeds = 200;
  for(std::size_t seed = 0; seed != number_of_seeds; ++seed)
    BOOST_TEST_CONTEXT("seed " << seed)
    {
      random_meshes::Random random(seed);
      auto mesh = crumpled_mesh(random);
      const bool is_crossed = CGAL::Polygon_mesh_processing::does_self_intersect(mesh);
      Curve_skeleton<Exact_mesh> skeleton;
      BOOST_TEST(extract_curve_skeleton(mesh, skeleton).number_of_crossing_components == (is_crossed ? 1u : 0u));
      for(const double unit : {1., 1e80, 1e-170})
      {
        for(const auto v : mesh.vertices())
          mesh.point(v) = CGAL::ORIGIN + unit * (mesh.point(v) - CGAL::ORIGIN);
        std::vector<std::pair<Exact_mesh::Face_index, Exact_mesh::Face_index>> pairs;
        CGAL::Polygon_mesh_processing::self_intersections(mesh, std::back_inserter(pairs));
        BOOST_TEST(number_of_self_intersections(mesh, true) == pairs.size());
        BOOST_TEST((number_of_self_intersections(mesh, false) != 0) == !pairs.empty());
      }
      number_of_crossed += is_crossed ? 1 : 0;
    }
  BOOST_TEST(number_of_crossed > number_of_seeds / 5);
  BOOST_TEST(number_of_crossed < number_of_seeds * 4 / 5);
}

// Surfaces that intersect themselves, and those that are flat: two sheets on each other, without volume.
BOOST_AUTO_TEST_CASE(moving_lines_makes_no_certificate_worse)
{
  std::size_t number_of_mended = 0; // edges that crossed the surface
  for(std::size_t seed = 0; seed != 100; ++seed)
    for(const bool is_flat : {false, true})
      BOOST_TEST_CONTEXT("seed " << seed << (is_flat ? ", flat" : ""))
      {
        random_meshes::Random random(seed);
        auto mesh = crumpled_mesh(random);
        for(const auto v : mesh.vertices())
          if(is_flat)
            mesh.point(v) = {mesh.point(v).x(), mesh.point(v).y(), 0};
        Curve_skeleton<Exact_mesh> skeleton;
        const Skeleton_certificate known = extract_curve_skeleton(mesh, skeleton);
        const Skeleton_certificate before = extract_curve_skeleton(mesh, skeleton, parameters::smooth(0));
        BOOST_TEST(known.number_of_vertices_outside <= before.number_of_vertices_outside);
        BOOST_TEST(known.number_of_crossing_edges <= before.number_of_crossing_edges);
        BOOST_TEST(known.number_of_contractible_loops <= before.number_of_contractible_loops);
        number_of_mended += before.number_of_crossing_edges - known.number_of_crossing_edges;
      }
  BOOST_TEST(number_of_mended > 0u);
}

// Those of thousands of points are moved as others. A fin draws the centers of contours out of the middle.
BOOST_AUTO_TEST_CASE(long_lines_are_moved)
{
  auto soup = generated_surfaces::torus(8, 1600);
  for(auto& p : soup.points)
  {
    const double rho = std::hypot(p[0], p[1]), share = 0.002 * (rho > 1.39 ? 3 : 1) / std::hypot(rho - 1, p[2]);
    const double scale = (1 + share * (rho - 1)) / rho;
    p = {scale * p[0], scale * p[1], share * p[2]};
  }
  const auto mesh = make_mesh<Surface_mesh>(soup);
  std::array<double, 2> depths = {}; // the means of lines that are not moved, and of others
  for(const std::size_t smooth : {0, 1})
  {
    Curve_skeleton<Surface_mesh> skeleton;
    const Skeleton_certificate known = extract_curve_skeleton(mesh, skeleton, parameters::smooth(double(smooth)));
    check(mesh, skeleton, known);
    BOOST_TEST(known.number_of_loops == 1u);
    BOOST_TEST(known.number_of_contractible_loops == 0u);
    BOOST_TEST((smooth == 1 || num_vertices(skeleton) > 5000));
    for(const auto v : CGAL::make_range(vertices(skeleton)))
      depths[smooth] += skeleton[v].inscribed_radius / static_cast<double>(num_vertices(skeleton));
  }
  BOOST_TEST(depths[1] > depths[0]);
}

BOOST_AUTO_TEST_CASE(progress_ascends_and_can_be_cancelled)
{
  const auto mesh = make_mesh<Surface_mesh>(Voxel_solid(5, 1).surface());
  Curve_skeleton<Surface_mesh> skeleton;
  std::vector<double> told;
  extract_curve_skeleton(mesh, skeleton, parameters::callback([&](double fraction) {
                           told.push_back(fraction);
                           return true;
                         }));
  BOOST_TEST(std::is_sorted(told.begin(), told.end()));
  BOOST_TEST(told.front() == 0);
  BOOST_TEST(told.back() == 1);
  for(const double limit : {0., 0.08, 0.2, 0.4, 0.7, 0.95})
    BOOST_CHECK_THROW(
      extract_curve_skeleton(mesh, skeleton, parameters::callback([&](double fraction) { return fraction < limit; })),
      CGAL::Reeb_graph::Cancelled_error);
}

BOOST_AUTO_TEST_CASE(wrong_ratios_and_points_are_refused)
{
  auto mesh = make_mesh<Surface_mesh>(generated_surfaces::torus(8, 12));
  Curve_skeleton<Surface_mesh> skeleton;
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for(const double ratio : {-1., nan})
    BOOST_CHECK_THROW(extract_curve_skeleton(mesh, skeleton, parameters::pruning_ratio(ratio)),
                      CGAL::Reeb_graph::Parameter_error);
  for(const double ratio : {0., -1., 1e9, nan})
    BOOST_CHECK_THROW(extract_curve_skeleton(mesh, skeleton, parameters::sampling_ratio(ratio)),
                      CGAL::Reeb_graph::Parameter_error);
  for(const double smooth : {-1., 101., nan})
    BOOST_CHECK_THROW(extract_curve_skeleton(mesh, skeleton, parameters::smooth(smooth)),
                      CGAL::Reeb_graph::Parameter_error);
  BOOST_CHECK_THROW(extract_curve_skeleton(mesh, skeleton, parameters::callback([](double) { return false; })),
                    CGAL::Reeb_graph::Cancelled_error);
  mesh.point(*mesh.vertices().begin()) = Surface_mesh::Point(nan, 0, 0);
  BOOST_CHECK_THROW(extract_curve_skeleton(mesh, skeleton), CGAL::Reeb_graph::Non_finite_point_error);
}

BOOST_AUTO_TEST_SUITE_END()
