// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#include <boost/test/unit_test.hpp>

#include "generated_surfaces/standing_figure.h"
#include "handle_samples.h"
#include "random_meshes.h"
#include "voxel_solids.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/self_intersections.h>
#include <CGAL/Reeb_graph/curves/Refinement_visitor.h>
#include <CGAL/Reeb_graph/handles/handle_and_tunnel_loops.h>
#include <CGAL/Reeb_graph/handles/remove_handles.h>
#include <CGAL/Reeb_graph/scalar_maps.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/copy_face_graph.h>
#include <CGAL/boost/graph/helpers.h>

#include <boost/mpl/list.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <set>
#include <utility>
#include <vector>

// Removal of handles: the genus falls by exactly as many, and nothing else changes.

BOOST_AUTO_TEST_SUITE(test_remove_handles)

using CGAL::Reeb_graph::Handle_removal;
using CGAL::Reeb_graph::Removal_result;
using CGAL::Reeb_graph::remove_handles;
using generated_surfaces::make_mesh;
using generated_surfaces::Triangle_soup;
using handle_samples::dot;
using handle_samples::sum;
using handle_samples::Vector;
using mesh_builders::Polyhedron;
using mesh_builders::Surface_mesh;
namespace parameters = CGAL::parameters;

typedef boost::mpl::list<Surface_mesh, Polyhedron> Meshes;

namespace {
const double infinity = std::numeric_limits<double>::infinity();

template <class Mesh>
long euler_characteristic(const Mesh& mesh)
{
  return static_cast<long>(vertices(mesh).size() + faces(mesh).size()) - static_cast<long>(edges(mesh).size());
}

template <class Mesh>
using Rows = std::vector<Handle_removal<typename boost::graph_traits<Mesh>::vertex_descriptor>>;

template <class Row>
std::size_t count(const std::vector<Row>& rows, Removal_result result)
{
  return std::count_if(rows.begin(), rows.end(), [&](const Row& row) { return row.result == result; });
}

template <class Mesh>
bool does_self_intersect(const Mesh& mesh)
{
  CGAL::Surface_mesh<CGAL::Exact_predicates_inexact_constructions_kernel::Point_3> exact;
  CGAL::copy_face_graph(mesh, exact);
  return CGAL::Polygon_mesh_processing::does_self_intersect(exact);
}

// How many edges join vertices that another one joins.
template <class Mesh>
std::size_t number_of_repeated_edges(const Mesh& mesh)
{
  std::size_t result = 0;
  for(const auto v : vertices(mesh))
  {
    std::set<typename boost::graph_traits<Mesh>::vertex_descriptor> neighbors;
    for(const auto h : halfedges_around_target(v, mesh))
      result += neighbors.insert(source(h, mesh)).second ? 0 : 1;
  }
  return result / 2;
}

// The surface of random cubes, moved a little, with edges collapsed at random until it has this many vertices, and with
// holes if they are asked for.
Surface_mesh coarse_surface(std::size_t seed, std::size_t size, bool has_holes)
{
  random_meshes::Random random(seed);
  Triangle_soup soup = Voxel_solid(5, seed).surface();
  for(auto& point : soup.points)
    for(double& coordinate : point)
      coordinate += static_cast<double>(random.below(201)) / 1000 - 0.1;
  Surface_mesh mesh = make_mesh<Surface_mesh>(soup);
  for(int failures = 0; mesh.number_of_vertices() > size && failures != 300;)
  {
    const std::vector<Surface_mesh::Edge_index> edges(mesh.edges().begin(), mesh.edges().end());
    const Surface_mesh::Edge_index edge = edges[random.below(edges.size())];
    const bool is_possible = CGAL::Euler::does_satisfy_link_condition(edge, mesh);
    failures = is_possible ? 0 : failures + 1;
    if(is_possible)
      CGAL::Euler::collapse_edge(edge, mesh);
  }
  for(int i = 0; has_holes && i != 2; ++i)
  {
    const std::vector<Surface_mesh::Face_index> faces(mesh.faces().begin(), mesh.faces().end());
    const auto h = mesh.halfedge(faces[random.below(faces.size())]);
    bool is_free = true;
    for(const auto v : vertices_around_face(h, mesh))
      is_free = is_free && !mesh.is_border(v);
    if(is_free)
      CGAL::Euler::remove_face(h, mesh);
  }
  mesh.collect_garbage();
  return mesh;
}

// Removes handles of a mesh that does not intersect itself, and checks what holds for each.
template <class Mesh, class NamedParameters>
Rows<Mesh> remove_and_check(Mesh& mesh, double size, const NamedParameters& np)
{
  auto point_map = get(CGAL::vertex_point, mesh);
  std::vector<std::pair<typename boost::graph_traits<Mesh>::vertex_descriptor, mesh_builders::Point>> before;
  for(const auto v : vertices(mesh))
    before.emplace_back(v, get(point_map, v));
  const long characteristic = euler_characteristic(mesh);
  const bool is_closed = CGAL::is_closed(mesh), did_self_intersect = does_self_intersect(mesh);
  const Rows<Mesh> rows = remove_handles(mesh, size, np);
  const std::size_t removed = count(rows, Removal_result::REMOVED);
  BOOST_TEST(euler_characteristic(mesh) == characteristic + 2 * static_cast<long>(removed));
  BOOST_TEST(CGAL::is_valid_polygon_mesh(mesh));
  BOOST_TEST(CGAL::is_triangle_mesh(mesh));
  BOOST_TEST(CGAL::is_closed(mesh) == is_closed);
  BOOST_TEST(number_of_repeated_edges(mesh) == 0u);
  BOOST_TEST((did_self_intersect || !does_self_intersect(mesh)));
  std::size_t moved = 0;
  for(const auto& [v, point] : before)
    moved += get(point_map, v) == point ? 0 : 1;
  BOOST_TEST(moved <= vertices(mesh).size() - before.size()); // those on loops, which have been doubled
  for(const auto& row : rows)
  {
    BOOST_TEST(row.length < size);
    BOOST_TEST(row.points.size() == row.vertices.size());
    double length = 0;
    for(std::size_t i = 0; i != row.points.size(); ++i)
    {
      const auto &p = row.points[i], &q = row.points[(i + 1) % row.points.size()];
      length += std::hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2]);
    }
    BOOST_TEST(std::abs(length - row.length) <= 1e-9 * length); // of the loop as it was
  }
  return rows;
}

template <class Mesh>
Rows<Mesh> remove_and_check(Mesh& mesh, double size)
{
  return remove_and_check(mesh, size, parameters::default_values());
}

template <class Function>
Triangle_soup implicit_surface(const Function& function, const Vector& half_size, double cell_size)
{
  return generated_surfaces::internal::Marching_tetrahedra(function, {-half_size[0], -half_size[1], -half_size[2]},
                                                           half_size, cell_size)
    .take_surface();
}

// A ring around a center, with its axis.
struct Ring
{
  Vector center, axis;
  double radius, thickness;

  double distance(const Vector& p) const
  {
    const Vector offset = sum(p, -1, center);
    const double along = dot(offset, axis), across = std::sqrt(std::max(0., dot(offset, offset) - along * along));
    return std::hypot(across - radius, along) - thickness;
  }
};

double fat_ring(const Vector& p) { return Ring{{0, 0, 0}, {0, 0, 1}, 1, 0.4}.distance(p); }

// Handles and tunnels of noise: half rings that stand on the fat ring, and half rings that are dug into it, at random
// places that are apart.
std::vector<Ring> noise(std::size_t number, std::size_t seed)
{
  const double pi = generated_surfaces::internal::pi;
  random_meshes::Random random(seed);
  const auto random_angle = [&] { return 2 * pi * static_cast<double>(random.below(100000)) / 100000; };
  std::vector<Ring> rings;
  while(rings.size() != number)
  {
    const double t = random_angle(), u = random_angle(), turn = random_angle(), across = 1 + 0.4 * std::cos(u);
    const Vector center = {across * std::cos(t), across * std::sin(t), 0.4 * std::sin(u)};
    const Vector around = {-std::sin(t), std::cos(t), 0};
    const Vector up = {-std::sin(u) * std::cos(t), -std::sin(u) * std::sin(t), std::cos(u)};
    const Vector axis = sum(sum({0, 0, 0}, std::cos(turn), around), std::sin(turn), up); // in the tangent plane
    const auto is_near = [&](const Ring& ring) {
      const Vector offset = sum(center, -1, ring.center);
      return dot(offset, offset) < 0.4 * 0.4;
    };
    if(std::none_of(rings.begin(), rings.end(), is_near))
      rings.push_back({center, axis, 0.12, 0.06});
  }
  return rings;
}

std::array<long, 3> cube_of(const Vector& p, double size)
{
  return {std::lround(p[0] / size), std::lround(p[1] / size), std::lround(p[2] / size)};
}

// Whether the cube of a point, or one beside it, is among those.
bool is_near(const Vector& p, double size, const std::set<std::array<long, 3>>& cubes)
{
  const auto [x, y, z] = cube_of(p, size);
  for(long i = x - 1; i <= x + 1; ++i)
    for(long j = y - 1; j <= y + 1; ++j)
      for(long k = z - 1; k <= z + 1; ++k)
        if(cubes.count({i, j, k}) != 0)
          return true;
  return false;
}

// A ring whose hole is narrow, with what passes through it.
template <class Other>
double narrow_ring_with(const Vector& p, const Other& other)
{
  return std::min(Ring{{0, 0, 0}, {0, 0, 1}, 1, 0.7}.distance(p), other(p));
}

generated_surfaces::internal::Limb limb(const Vector& from, const Vector& to) { return {from, to, 0.12, 0.12}; }

} // namespace

BOOST_AUTO_TEST_CASE(noise_goes_and_the_handle_of_the_figure_stays)
{
  const std::size_t number = 50, seed = 20261124;
  BOOST_TEST_CONTEXT("seed " << seed)
  {
    const double cell = 0.04;
    const std::vector<Ring> rings = noise(number, seed);
    const auto function = [&](const Vector& p) {
      double value = fat_ring(p);
      if(std::abs(value) < 0.2)
        for(std::size_t i = 0; i != number; ++i)
          value = i % 2 == 0 ? std::min(value, rings[i].distance(p)) : std::max(value, -rings[i].distance(p));
      return value;
    };
    Surface_mesh mesh = make_mesh<Surface_mesh>(implicit_surface(function, {1.65, 1.65, 0.65}, cell));
    const long given_characteristic = euler_characteristic(mesh);
    BOOST_TEST(given_characteristic <= -2 * static_cast<long>(number)); // 1 is the genus of the figure
    const std::size_t given = mesh.number_of_vertices();
    const auto rows = remove_and_check(mesh, 1);
    BOOST_TEST(2 * static_cast<long>(rows.size()) == -given_characteristic);
    // Where noise is dense, some loops have no disc that meets nothing else: one or two of fifty, on most seeds.
    const auto number_of_refused = static_cast<long>(rows.size() - count(rows, Removal_result::REMOVED));
    BOOST_TEST(number_of_refused <= 2);
    BOOST_TEST(euler_characteristic(mesh) == -2 * number_of_refused);
    // Each point of one surface is near to the other one, and nothing has moved.
    const auto is_noise = [&](const Vector& p) {
      return std::any_of(rings.begin(), rings.end(), [&](const Ring& r) { return r.distance(p) < 3 * cell; });
    };
    std::set<std::array<long, 3>> passed; // cubes with vertices
    for(const auto v : mesh.vertices())
    {
      const Vector p = {mesh.point(v).x(), mesh.point(v).y(), mesh.point(v).z()};
      BOOST_TEST((is_noise(p) || (std::abs(fat_ring(p)) < 3 * cell && v.idx() < given)));
      passed.insert(cube_of(p, 0.85 * cell));
    }
    for(int i = 0; i != 200; ++i)
      for(int j = 0; j != 80; ++j)
      {
        const double pi = generated_surfaces::internal::pi, t = 2 * pi * i / 200, u = 2 * pi * j / 80;
        const double across = 1 + 0.4 * std::cos(u);
        const Vector p = {across * std::cos(t), across * std::sin(t), 0.4 * std::sin(u)};
        BOOST_TEST((is_noise(p) || is_near(p, 0.85 * cell, passed))); // less than three cells away
      }
  }
}

BOOST_AUTO_TEST_CASE(a_figure_loses_the_loop_of_its_arm)
{
  Surface_mesh mesh = make_mesh<Surface_mesh>(generated_surfaces::standing_figure(12000));
  BOOST_TEST(!does_self_intersect(mesh));
  const auto rows = remove_and_check(mesh, infinity);
  BOOST_TEST(rows.size() == 1u);
  BOOST_TEST(euler_characteristic(mesh) == 2);
}

BOOST_AUTO_TEST_CASE_TEMPLATE(all_handles_or_some_or_none, Mesh, Meshes)
{
  const Triangle_soup soup = generated_surfaces::closed_surface(3, 800);
  Mesh all = make_mesh<Mesh>(soup), some = make_mesh<Mesh>(soup), none = make_mesh<Mesh>(soup);
  const auto rows = remove_and_check(all, infinity);
  BOOST_TEST(rows.size() == 3u);
  BOOST_TEST(euler_characteristic(all) == 2);
  const auto first = remove_and_check(some, infinity, parameters::number_of_handles(2));
  BOOST_TEST(first.size() == 2u);
  BOOST_TEST(first[0].length <= first[1].length);
  BOOST_TEST(euler_characteristic(some) == 0);
  BOOST_TEST(remove_handles(none, 0.96 * rows[0].length).empty()); // not smaller: lengths are found to within 4 percent
  BOOST_TEST(vertices(none).size() == soup.points.size());
  std::size_t i = 0;
  for(const auto v : vertices(none))
  {
    const auto point = get(CGAL::vertex_point, none, v);
    BOOST_TEST((Vector{point.x(), point.y(), point.z()} == soup.points[i++]));
  }
  i = 0;
  for(const auto f : faces(none))
  {
    std::set<mesh_builders::Point> corners, expected;
    for(const auto v : vertices_around_face(halfedge(f, none), none))
      corners.insert(get(CGAL::vertex_point, none, v));
    for(const std::size_t v : soup.triangles[i++])
      expected.insert(mesh_builders::Point(soup.points[v][0], soup.points[v][1], soup.points[v][2]));
    BOOST_TEST((corners == expected));
  }
}

// What is found as the shortest loop without a size is found with one that is hardly larger, too.
BOOST_AUTO_TEST_CASE(sizes_of_the_list_are_those_of_removal)
{
  std::size_t missed = 0;
  for(std::size_t seed = 0; seed != 60; ++seed)
  {
    random_meshes::Random random(seed);
    Triangle_soup torus = generated_surfaces::torus(3 + random.below(7), 3 + random.below(10));
    for(auto& point : torus.points)
      for(double& x : point)
        x += 0.05 * (static_cast<double>(random.below(1000)) / 500 - 1);
    Surface_mesh mesh = make_mesh<Surface_mesh>(torus);
    const auto height =
      CGAL::Reeb_graph::make_scalar_map_from_function(mesh, [&](auto v) { return mesh.point(v).z(); });
    double shortest = infinity;
    const auto found = CGAL::Reeb_graph::handle_and_tunnel_loops(mesh, height);
    for(const auto& loop : found.loops())
      shortest = (std::min)(shortest, loop.length);
    missed += remove_handles(mesh, 1.0001 * shortest).empty() ? 1 : 0;
  }
  BOOST_TEST(missed <= 1u); // of 60; 11 with searches for loops of just that length
}

BOOST_AUTO_TEST_CASE(samples_lose_all_their_handles)
{
  for(const auto& sample : handle_samples::closed_samples())
  {
    BOOST_TEST_CONTEXT(sample.name)
    {
      Surface_mesh mesh = make_mesh<Surface_mesh>(sample.soup);
      const auto rows = remove_and_check(mesh, infinity);
      std::size_t genus = 0;
      for(const std::size_t g : sample.genera)
        genus += g;
      BOOST_TEST(count(rows, Removal_result::REMOVED)
                 == genus); // in nested tori, the outer one where the inner one is cut
      BOOST_TEST(rows.size() == genus);
    }
  }
}

BOOST_AUTO_TEST_CASE(what_passes_through_is_in_the_way)
{
  // another component, and the surface itself
  const auto stick = [](const Vector& p) { return limb({0, 0, -1.5}, {0, 0, 1.5}).distance(p); };
  const auto finger = [](const Vector& p) {
    return std::min({limb({1, 0, 0.6}, {1, 0, 1.2}).distance(p), limb({1, 0, 1.2}, {0, 0, 1.2}).distance(p),
                     limb({0, 0, 1.2}, {0, 0, -1.2}).distance(p)});
  };
  for(const bool is_finger : {false, true})
  {
    const auto function = [&](const Vector& p) {
      return is_finger ? narrow_ring_with(p, finger) : narrow_ring_with(p, stick);
    };
    Surface_mesh mesh = make_mesh<Surface_mesh>(implicit_surface(function, {1.9, 1.9, 1.9}, 0.08));
    const auto rows = remove_and_check(mesh, 3);
    BOOST_TEST(rows.size() == 1u);
    BOOST_TEST((rows[0].kind == CGAL::Reeb_graph::Loop_kind::TUNNEL));
    BOOST_TEST((rows[0].result == (is_finger ? Removal_result::NO_DISC : Removal_result::OTHER_COMPONENT)));
  }
}

BOOST_AUTO_TEST_CASE(what_pierces_the_faces_beside_a_cut_is_in_the_way)
{
  // a torus whose tube is narrow at one place, and opposite a spike that reaches into the faces there, but not into the disc
  const std::size_t around = 16, along = 60;
  const double pi = generated_surfaces::internal::pi;
  auto soup = generated_surfaces::internal::grid(around, along, true, true, [&](std::size_t column, std::size_t row) {
    const double t = 2 * pi * row / along, u = 2 * pi * column / around, radius = 0.35 - 0.2 * std::cos(t);
    const double across = 1 + radius * std::cos(u);
    return Vector{across * std::cos(t), across * std::sin(t), radius * std::sin(u)};
  });
  soup.points[along / 2 * around + around / 2] = {0.87, 0.05, 0.01};
  Surface_mesh mesh = make_mesh<Surface_mesh>(soup);
  const auto rows = remove_and_check(mesh, 1);
  BOOST_TEST(rows.size() == 1u);
  BOOST_TEST((rows[0].result == Removal_result::INTERSECTS));
}

BOOST_AUTO_TEST_CASE(loops_that_pass_a_vertex_twice_are_refused)
{
  // many handles and few vertices at random places
  std::size_t number_of_crossed = 0;
  for(const std::size_t seed : {1, 2, 15, 32})
  {
    random_meshes::Random random(seed);
    auto sum = random_meshes::seven_vertex_torus();
    for(int i = 1; i != 24; ++i)
      sum = random_meshes::connected_sum(sum, random_meshes::seven_vertex_torus(), random);
    Triangle_soup soup;
    const auto coordinate = [&] { return static_cast<double>(random.below(1000)); };
    for(std::size_t v = 0; v != sum.number_of_vertices; ++v)
      soup.points.push_back({coordinate(), coordinate(), coordinate()});
    for(const auto& t : sum.triangles)
      soup.triangles.push_back({t[0], t[1], t[2]});
    Surface_mesh mesh = make_mesh<Surface_mesh>(soup);
    number_of_crossed += count(remove_and_check(mesh, infinity), Removal_result::CROSSES_ITSELF);
  }
  BOOST_TEST(number_of_crossed > 0u);
}

// They have edges that join vertices of a loop beside it, which the discs must not have once more.
BOOST_AUTO_TEST_CASE_TEMPLATE(coarse_surfaces_stay_surfaces, Mesh, Meshes)
{
  std::size_t number_of_removed = 0;
  for(std::size_t seed = 0; seed != 600; ++seed)
    BOOST_TEST_CONTEXT("seed " << seed)
    {
      const Surface_mesh coarse = coarse_surface(seed, 60 + seed % 60, seed % 2 == 0);
      Mesh mesh;
      CGAL::copy_face_graph(coarse, mesh);
      const auto rows = remove_and_check(mesh, infinity, parameters::ignore_self_intersections(seed % 4 < 2));
      number_of_removed += count(rows, Removal_result::REMOVED);
    }
  BOOST_TEST(number_of_removed > 100u);
}

BOOST_AUTO_TEST_CASE(holes_stay)
{
  auto soup = generated_surfaces::closed_surface(2, 600);
  soup.triangles.erase(soup.triangles.begin());
  Surface_mesh mesh = make_mesh<Surface_mesh>(soup);
  const auto rows = remove_and_check(mesh, infinity);
  BOOST_TEST(rows.size() >= 1u);
  for(const auto& row : rows)
    BOOST_TEST((row.kind == CGAL::Reeb_graph::Loop_kind::LOOP));
  // a torus with a strip of holes, which each ring around its tube passes
  auto torus = generated_surfaces::torus(3, 24);
  Surface_mesh pierced = make_mesh<Surface_mesh>(torus);
  std::vector<Surface_mesh::Face_index> removed;
  std::set<Surface_mesh::Vertex_index> passed;
  for(const auto f : pierced.faces())
  {
    bool is_free = true;
    for(const auto v : vertices_around_face(pierced.halfedge(f), pierced))
      is_free = is_free && passed.count(v) == 0;
    if(!is_free)
      continue;
    for(const auto v : vertices_around_face(pierced.halfedge(f), pierced))
      passed.insert(v);
    removed.push_back(f);
  }
  for(const auto f : removed)
    CGAL::Euler::remove_face(pierced.halfedge(f), pierced);
  const auto refused = remove_and_check(pierced, infinity);
  BOOST_TEST(count(refused, Removal_result::PASSES_HOLE) == 1u);
}

BOOST_AUTO_TEST_CASE_TEMPLATE(properties_are_carried_over, Mesh, Meshes)
{
  Mesh mesh = make_mesh<Mesh>(generated_surfaces::torus(9, 24));
  const auto x_map = get(CGAL::dynamic_vertex_property_t<double>(), mesh);
  const auto side_map = get(CGAL::dynamic_face_property_t<int>(), mesh);
  for(const auto v : vertices(mesh))
    put(x_map, v, get(CGAL::vertex_point, mesh, v).x());
  for(const auto f : faces(mesh))
    put(side_map, f, 7);
  CGAL::Reeb_graph::Interpolating_visitor<Mesh> visitor;
  visitor.add_vertex_map(x_map).add_face_map(side_map);
  const auto rows = remove_and_check(mesh, infinity, parameters::visitor(std::ref(visitor)));
  BOOST_TEST(rows.size() == 1u);
  for(const auto v : vertices(mesh))
    BOOST_TEST(std::abs(get(x_map, v) - get(CGAL::vertex_point, mesh, v).x()) < 0.2);
  for(const auto f : faces(mesh))
    BOOST_TEST(get(side_map, f) == 7);
}

BOOST_AUTO_TEST_CASE(bad_sizes_and_points_are_refused_and_it_can_be_cancelled)
{
  Surface_mesh mesh = make_mesh<Surface_mesh>(generated_surfaces::torus(9, 12));
  BOOST_CHECK_THROW(remove_handles(mesh, -1), CGAL::Reeb_graph::Parameter_error);
  BOOST_CHECK_THROW(remove_handles(mesh, std::numeric_limits<double>::quiet_NaN()), CGAL::Reeb_graph::Parameter_error);
  double last = 0;
  Surface_mesh copy = mesh;
  remove_handles(copy, infinity, parameters::callback([&](double fraction) {
                   BOOST_TEST(fraction >= last);
                   last = fraction;
                   return true;
                 }));
  BOOST_TEST(last == 1);
  copy = mesh;
  BOOST_CHECK_THROW(
    remove_handles(copy, infinity, parameters::callback([](double fraction) { return fraction < 0.1; })),
    CGAL::Reeb_graph::Cancelled_error);
  BOOST_TEST(copy.number_of_faces() == mesh.number_of_faces());
  Surface_mesh empty;
  BOOST_TEST(remove_handles(empty, infinity).empty());
  mesh.point(Surface_mesh::Vertex_index(5)) = mesh_builders::Point(0, infinity, 0);
  BOOST_CHECK_THROW(remove_handles(mesh, 1), CGAL::Reeb_graph::Non_finite_point_error);
}

BOOST_AUTO_TEST_SUITE_END()
