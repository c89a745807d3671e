// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors
#include <boost/test/unit_test.hpp>

#include "mesh_builders.h"
#include "shuffle.h"
#include "tube_samples.h"
#include "voxel_solids.h"

#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Polygon_mesh_processing/orientation.h>
#include <CGAL/Reeb_graph/skeleton/extract_curve_skeleton.h>
#include <CGAL/Reeb_graph/skeleton/find_branch_faces.h>
#include <CGAL/Reeb_graph/skeleton/measure_branch_faces.h>
#include <CGAL/Reeb_graph/skeleton/measure_branches.h>
#include <CGAL/Reeb_graph/skeleton/skeleton_paths.h>
#include <CGAL/Reeb_graph/skeleton/skeleton_trees.h>

#include <CGAL/boost/graph/helpers.h>
#include <CGAL/boost/graph/iterator.h>

#include <boost/graph/connected_components.hpp>
#include <boost/mpl/list.hpp>
#include <boost/property_map/function_property_map.hpp>

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

// Branches of curve skeletons: trees, numbers, and faces.

BOOST_AUTO_TEST_SUITE(test_skeleton_branches)

using CGAL::Reeb_graph::Curve_skeleton;
using CGAL::Reeb_graph::extract_curve_skeleton;
using CGAL::Reeb_graph::Skeleton_branch;
using CGAL::Reeb_graph::Skeleton_record;
using generated_surfaces::make_mesh;
using mesh_builders::Polyhedron;
using mesh_builders::Surface_mesh;
using tube_samples::Tubes;

typedef boost::mpl::list<Surface_mesh, Polyhedron> Meshes;

namespace {
// Each edge once, from a record that comes before, and the other ones of its vertex are its copies.
template <class Skeleton>
void check_trees(const Skeleton& skeleton, const std::vector<Skeleton_record>& trees)
{
  std::vector<std::size_t> components(num_vertices(skeleton));
  const auto number = static_cast<std::size_t>(boost::connected_components(skeleton, components.data()));
  std::multiset<std::multiset<std::size_t>> given, found;
  for(const auto e : CGAL::make_range(edges(skeleton)))
    given.insert({source(e, skeleton), target(e, skeleton), num_vertices(skeleton) + skeleton[e].arc});
  std::map<std::size_t, std::size_t> first_records;
  std::size_t number_of_roots = 0;
  for(std::size_t i = 0; i != trees.size(); ++i)
  {
    const Skeleton_record& record = trees[i];
    const auto [first, is_new] = first_records.emplace(record.vertex, i);
    BOOST_TEST(record.original == (is_new ? Skeleton_record::none : first->second));
    if(record.parent == Skeleton_record::none)
      ++number_of_roots;
    else
    {
      BOOST_REQUIRE(record.parent < i);
      BOOST_TEST(trees[record.parent].original == Skeleton_record::none);
      found.insert({trees[record.parent].vertex, record.vertex, num_vertices(skeleton) + record.arc});
    }
  }
  BOOST_TEST((given == found));
  BOOST_TEST(first_records.size() == num_vertices(skeleton));
  BOOST_TEST(number_of_roots == number);
}

// By definition.
std::size_t strahler_order(const std::vector<Skeleton_record>& trees, std::size_t record)
{
  std::vector<std::size_t> of_children;
  for(std::size_t i = 0; i != trees.size(); ++i)
    if(trees[i].parent == record)
      of_children.push_back(strahler_order(trees, i));
  std::sort(of_children.rbegin(), of_children.rend());
  if(of_children.empty())
    return 1;
  return of_children[0] + (of_children.size() > 1 && of_children[0] == of_children[1] ? 1 : 0);
}

void check_branches(const std::vector<Skeleton_record>& trees, const std::vector<Skeleton_branch>& branches)
{
  const std::vector<std::size_t> orders = strahler_orders(trees);
  for(std::size_t i = 0; i != trees.size(); ++i)
  {
    BOOST_TEST(orders[i] == strahler_order(trees, i));
    if(trees[i].arc == Skeleton_record::none)
      continue;
    BOOST_TEST(branches[trees[i].arc].order == orders[i]);
    const std::size_t before = trees[trees[i].parent].arc;
    if(before != trees[i].arc)
      BOOST_TEST(branches[trees[i].arc].parent == before);
  }
  for(const Skeleton_branch& branch : branches)
  {
    const bool is_root = branch.parent == Skeleton_branch::none;
    BOOST_TEST(branch.depth == (is_root ? 0 : branches[branch.parent].depth + 1));
    BOOST_TEST((is_root || branches[branch.parent].component == branch.component));
    BOOST_TEST(std::isnan(branch.tortuosity) == (branch.first == branch.last));
    BOOST_TEST(!(branch.tortuosity < 1 - 1e-9));
    BOOST_TEST(branch.radius >= branch.least_radius * (1 - 1e-9));
    BOOST_TEST(branch.radius <= branch.greatest_radius * (1 + 1e-9));
    BOOST_TEST(branch.length > 0);
  }
}

// Each face has an arc, and those of one are connected, and meet those of others in junctions only.
template <class Mesh, class Map, class Junction_map>
void check_faces(const Mesh& mesh, const Map& arc_map, const Junction_map& junction_map, std::size_t number_of_arcs)
{
  std::set<std::size_t> arcs;
  std::set<typename boost::graph_traits<Mesh>::face_descriptor> reached;
  std::size_t number_of_parts = 0;
  for(const auto first : faces(mesh))
  {
    arcs.insert(get(arc_map, first));
    if(!reached.insert(first).second)
      continue;
    ++number_of_parts;
    std::vector<typename boost::graph_traits<Mesh>::face_descriptor> part = {first};
    for(std::size_t i = 0; i != part.size(); ++i)
      for(const auto h : CGAL::halfedges_around_face(halfedge(part[i], mesh), mesh))
        if(!is_border(opposite(h, mesh), mesh))
        {
          const auto neighbor = face(opposite(h, mesh), mesh);
          if(get(arc_map, neighbor) != get(arc_map, part[i]))
            BOOST_TEST((get(junction_map, neighbor) && get(junction_map, part[i])));
          if(get(arc_map, neighbor) == get(arc_map, first) && reached.insert(neighbor).second)
            part.push_back(neighbor);
        }
  }
  BOOST_TEST(number_of_parts == arcs.size());
  BOOST_TEST((arcs.empty() || *arcs.rbegin() < number_of_arcs));
}

// Branches make the whole: the area, and the volume with borders filled, of what is closed.
template <class Mesh, class Map, class Junction_map>
void check_sizes(const Mesh& mesh,
                 const Map& arc_map,
                 const Junction_map& junction_map,
                 std::vector<Skeleton_branch>& branches)
{
  BOOST_TEST(measure_branch_faces(mesh, arc_map, junction_map, branches) == 0u);
  double area = 0, volume = 0;
  for(const Skeleton_branch& branch : branches)
  {
    BOOST_TEST((branch.area >= 0 && branch.junction_area >= 0 && branch.junction_area <= branch.area * (1 + 1e-9)));
    area += branch.area;
    volume += branch.volume;
  }
  const double expected = CGAL::to_double(CGAL::Polygon_mesh_processing::area(mesh));
  BOOST_TEST(area == expected, boost::test_tools::tolerance(1e-9));
  if(CGAL::is_closed(mesh))
    BOOST_TEST(volume == CGAL::to_double(CGAL::Polygon_mesh_processing::volume(mesh)),
               boost::test_tools::tolerance(1e-9));
}

// Paths are as long as the shortest ones, which Bellman and Ford find.
template <class Skeleton>
void check_paths(const Skeleton& skeleton)
{
  const auto length = [&](std::size_t v, std::size_t w) {
    return std::sqrt(CGAL::to_double(CGAL::squared_distance(skeleton[v].point, skeleton[w].point)));
  };
  const std::size_t from = num_vertices(skeleton) / 2;
  std::vector<double> least(num_vertices(skeleton), std::numeric_limits<double>::infinity());
  least[from] = 0;
  for(bool is_any_less = true; std::exchange(is_any_less, false);)
    for(const auto e : CGAL::make_range(edges(skeleton)))
      for(const auto& [v, w] :
          {std::pair(source(e, skeleton), target(e, skeleton)), std::pair(target(e, skeleton), source(e, skeleton))})
        if(const double way = least[v] + length(v, w); way < least[w])
        {
          least[w] = way;
          is_any_less = true;
        }
  const auto all = vertices(skeleton);
  const std::vector<std::size_t> to(all.first, all.second);
  const auto paths = skeleton_paths(skeleton, from, to);
  BOOST_REQUIRE(paths.size() == to.size());
  for(const std::size_t v : to)
  {
    const std::vector<std::size_t>& path = paths[v];
    BOOST_REQUIRE(path.empty() == std::isinf(least[v]));
    if(path.empty())
      continue;
    BOOST_TEST((path.front() == from && path.back() == v));
    double sum = 0;
    for(std::size_t i = 1; i != path.size(); ++i)
    {
      BOOST_TEST(edge(path[i - 1], path[i], skeleton).second);
      sum += length(path[i - 1], path[i]);
    }
    BOOST_TEST(std::abs(sum - least[v]) <= 1e-12 * (1 + sum));
  }
}

template <class Mesh>
std::vector<Skeleton_branch> check_all(const Mesh& mesh)
{
  Curve_skeleton<Mesh> skeleton;
  extract_curve_skeleton(mesh, skeleton);
  check_paths(skeleton);
  const std::vector<Skeleton_record> trees = skeleton_trees(skeleton);
  check_trees(skeleton, trees);
  const std::size_t last = num_vertices(skeleton) - 1;
  const std::vector<Skeleton_record> others = skeleton_trees(skeleton, {last});
  check_trees(skeleton, others);
  BOOST_TEST(others.front().vertex == last);
  std::vector<Skeleton_branch> branches = measure_branches(skeleton, trees);
  check_branches(trees, branches);
  const auto arc_map = get(CGAL::dynamic_face_property_t<std::size_t>(), mesh);
  const auto junction_map = get(CGAL::dynamic_face_property_t<bool>(), mesh);
  find_branch_faces(mesh, skeleton, arc_map, junction_map);
  check_faces(mesh, arc_map, junction_map, branches.size());
  check_sizes(mesh, arc_map, junction_map, branches);
  return branches;
}
} // namespace

// Of the other mesh, a sample in four: a skeleton is one of numbers once the mesh is read.
template <class Mesh>
constexpr std::size_t step = std::is_same_v<Mesh, Surface_mesh> ? 1 : 4;

BOOST_AUTO_TEST_CASE_TEMPLATE(branches_of_tubes, Mesh, Meshes)
{
  const std::vector<Tubes> samples = tube_samples::all();
  for(std::size_t s = 0; s < samples.size(); s += step<Mesh>)
    BOOST_TEST_CONTEXT(samples[s].name)
    {
      const Tubes& sample = samples[s];
      const std::vector<Skeleton_branch> branches = check_all(make_mesh<Mesh>(tube_samples::surface(sample, 0.05, 1)));
      double length = 0;
      std::size_t number_of_components = 0;
      for(const Skeleton_branch& branch : branches)
      {
        length += branch.length;
        number_of_components = (std::max)(number_of_components, branch.component + 1);
      }
      BOOST_TEST(std::abs(length - sample.length) <= 0.07 * sample.length);
      BOOST_TEST(number_of_components == sample.components);
    }
}

namespace {
// A branch of radius 2 on a tube of radius 10.
Tubes tube_with_branch(double lean)
{
  Tubes sample;
  sample.tubes = {{{0, 0, -45}, {0, 0, 45}, 10, 10}, {{0, 0, 0}, {40, 0, lean}, 2, 2}};
  sample.cell_size = 1;
  return sample;
}
} // namespace

BOOST_AUTO_TEST_CASE_TEMPLATE(thin_branches_of_wide_tubes, Mesh, Meshes)
{
  std::size_t number_of_sample = 0;
  for(const double lean : {0., 10., 20., 30.})
  {
    const Tubes sample = tube_with_branch(lean);
    const auto soup = tube_samples::surface(sample);
    for(const double noise : {0., 0.05, 0.1})
      BOOST_TEST_CONTEXT("lean " << lean << " noise " << noise)
      {
        if(number_of_sample++ % step<Mesh> != 0)
          continue;
        const auto mesh = make_mesh<Mesh>(tube_samples::with_noise(soup, sample, noise, 3));
        Curve_skeleton<Mesh> skeleton;
        extract_curve_skeleton(mesh, skeleton);
        const std::vector<Skeleton_branch> branches = measure_branches(skeleton, skeleton_trees(skeleton));
        BOOST_REQUIRE(branches.size() == 3u);
        const auto less = [](const Skeleton_branch& a, const Skeleton_branch& b) { return a.radius < b.radius; };
        const auto thin = std::min_element(branches.begin(), branches.end(), less);
        const auto number = static_cast<std::size_t>(thin - branches.begin());
        BOOST_TEST(std::abs(thin->radius - 2) <= 0.1);
        BOOST_TEST(thin->greatest_radius <= 2.2);
        for(std::size_t i = 0; i != 3; ++i)
          if(i != number)
            BOOST_TEST(std::abs(branches[i].radius - 10) <= 0.5);

        const auto point_map = get(CGAL::vertex_point, mesh);
        auto arc_map = get(CGAL::dynamic_face_property_t<std::size_t>(), mesh);
        auto junction_map = get(CGAL::dynamic_face_property_t<bool>(), mesh);
        find_branch_faces(mesh, skeleton, arc_map, junction_map);
        check_faces(mesh, arc_map, junction_map, branches.size());
        for(const auto f : faces(mesh))
        {
          tube_samples::Point center = {0, 0, 0};
          for(const auto v : CGAL::vertices_around_face(halfedge(f, mesh), mesh))
            for(int i = 0; i != 3; ++i)
              center[static_cast<std::size_t>(i)] += get(point_map, v)[i] / 3;
          const bool is_thin = sample.tubes[1].distance_to(center) < sample.tubes[0].distance_to(center);
          const auto& tube = sample.tubes[is_thin ? 1 : 0];
          const double height =
            tube_samples::distance(tube_samples::between(tube.from, tube.to, tube.place(center)), {0, 0, 0});
          // the truth is a ball of radius 10; the thin tube leaves the wide one where it is oblique
          const double slack = is_thin ? 2 : 10, leaving = is_thin ? 10 * std::hypot(1, lean / 40) : 10;
          if(get(junction_map, f))
            BOOST_TEST(height <= leaving + slack + 1.2);
          else
            BOOST_TEST(height >= 10 - slack - 1);
          if(height > leaving + slack + 1.2)
            BOOST_TEST((get(arc_map, f) == number) == is_thin);
        }
      }
  }
}

// Units that are powers of two change nothing but lengths, which are multiplied.
BOOST_AUTO_TEST_CASE(branches_in_all_units)
{
  const Tubes sample = tube_with_branch(20);
  const auto soup = tube_samples::surface(sample);
  const auto found_at = [&](int exponent) {
    auto mesh = make_mesh<Surface_mesh>(soup);
    for(const auto v : vertices(mesh))
    {
      const auto p = mesh.point(v);
      const auto scaled = [&](double x) { return std::scalbn(x, exponent); };
      mesh.point(v) = Surface_mesh::Point(scaled(p.x()), scaled(p.y()), scaled(p.z()));
    }
    Curve_skeleton<Surface_mesh> skeleton;
    extract_curve_skeleton(mesh, skeleton);
    std::vector<double> numbers;
    for(const Skeleton_branch& branch : measure_branches(skeleton, skeleton_trees(skeleton)))
      for(const double x : {branch.length, branch.radius, branch.least_radius, branch.greatest_radius,
                            branch.inscribed_radius, std::scalbn(branch.tortuosity, exponent)})
        numbers.push_back(std::scalbn(x, -exponent));
    const auto arc_map = get(CGAL::dynamic_face_property_t<std::size_t>(), mesh);
    const auto junction_map = get(CGAL::dynamic_face_property_t<bool>(), mesh);
    find_branch_faces(mesh, skeleton, arc_map, junction_map);
    for(const auto f : faces(mesh))
    {
      numbers.push_back(static_cast<double>(get(arc_map, f)));
      numbers.push_back(get(junction_map, f) ? 1 : 0);
    }
    return numbers;
  };
  const std::vector<double> numbers = found_at(0);
  for(const int exponent : {-660, -300, 300, 660})
    BOOST_TEST_CONTEXT("exponent " << exponent) { BOOST_TEST((found_at(exponent) == numbers)); }
}

BOOST_AUTO_TEST_CASE(branches_of_solids_of_cubes)
{
  for(std::size_t seed = 0; seed != 40; ++seed)
    BOOST_TEST_CONTEXT("seed " << seed)
    {
      check_all(make_mesh<Surface_mesh>(Voxel_solid(3 + static_cast<int>(seed % 3), seed).surface()));
    }
}

namespace {
typedef std::array<tube_samples::Point, 3> Corners;

struct Sizes
{
  std::map<Corners, std::pair<std::size_t, bool>> faces; // the branch of each, and whether it is in a junction
  std::vector<Skeleton_branch> branches;
  std::size_t number_inside_out;
};

Sizes sizes_of(const generated_surfaces::Triangle_soup& soup)
{
  const auto mesh = make_mesh<Surface_mesh>(soup);
  Curve_skeleton<Surface_mesh> skeleton;
  extract_curve_skeleton(mesh, skeleton);
  const auto arc_map = get(CGAL::dynamic_face_property_t<std::size_t>(), mesh);
  const auto junction_map = get(CGAL::dynamic_face_property_t<bool>(), mesh);
  find_branch_faces(mesh, skeleton, arc_map, junction_map);
  Sizes sizes = {{}, measure_branches(skeleton, skeleton_trees(skeleton)), 0};
  sizes.number_inside_out = measure_branch_faces(mesh, arc_map, junction_map, sizes.branches);
  for(const auto f : mesh.faces())
  {
    Corners corners;
    auto next = corners.begin();
    for(const auto v : CGAL::vertices_around_face(mesh.halfedge(f), mesh))
      *next++ = {mesh.point(v).x(), mesh.point(v).y(), mesh.point(v).z()};
    std::sort(corners.begin(), corners.end());
    sizes.faces[corners] = {get(arc_map, f), get(junction_map, f)};
  }
  return sizes;
}

bool are_near(double a, double b) { return std::abs(a - b) <= 1e-9 * (std::abs(a) + 1); }
} // namespace

// The order of vertices and faces, and the corner that a face begins with, change neither the branches of faces nor their sizes.
BOOST_AUTO_TEST_CASE(branches_in_any_order)
{
  std::vector<generated_surfaces::Triangle_soup> soups;
  for(const Tubes& sample : {tube_samples::tree(true), tube_samples::ladder(3), tube_samples::two_components()})
    soups.push_back(tube_samples::surface(sample, 0.1, 5));
  for(std::size_t seed = 0; seed != 12; ++seed)
    soups.push_back(Voxel_solid(3 + static_cast<int>(seed % 3), seed).surface());
  random_meshes::Random random(77);
  for(std::size_t i = 0; i != soups.size(); ++i)
    BOOST_TEST_CONTEXT("surface " << i)
    {
      const Sizes sizes = sizes_of(soups[i]);
      for(const Skeleton_branch& branch : sizes.branches)
        BOOST_TEST((branch.junction_volume >= 0 && branch.volume >= branch.junction_volume));
      generated_surfaces::shuffle(soups[i], random);
      for(auto& triangle : soups[i].triangles)
        std::rotate(triangle.begin(), triangle.begin() + static_cast<std::ptrdiff_t>(random.below(3)), triangle.end());
      const Sizes others = sizes_of(soups[i]);
      BOOST_TEST((others.faces == sizes.faces));
      BOOST_REQUIRE(others.branches.size() == sizes.branches.size());
      for(std::size_t branch = 0; branch != sizes.branches.size(); ++branch)
        for(const auto member : {&Skeleton_branch::area, &Skeleton_branch::volume, &Skeleton_branch::junction_area,
                                 &Skeleton_branch::junction_volume})
          BOOST_TEST(are_near(others.branches[branch].*member, sizes.branches[branch].*member));
    }
}

// Faces that look at what belongs to others: those of a pit in a cube have no volume, whichever way the surface is turned.
BOOST_AUTO_TEST_CASE(no_volume_is_negative)
{
  generated_surfaces::Triangle_soup soup;
  soup.points = {{0, 0, 0}, {3, 0, 0}, {3, 3, 0}, {0, 3, 0}, {0, 0, 3}, {3, 0, 3}, {3, 3, 3}, {0, 3, 3}, {1.5, 1.5, 2}};
  soup.triangles = {{0, 2, 1}, {0, 3, 2}, {0, 1, 5}, {0, 5, 4}, {1, 2, 6}, {1, 6, 5}, {2, 3, 7},
                    {2, 7, 6}, {3, 0, 4}, {3, 4, 7}, {4, 5, 8}, {5, 6, 8}, {6, 7, 8}, {7, 4, 8}};
  for(const bool is_turned : {false, true})
  {
    const auto mesh = generated_surfaces::make_mesh<Surface_mesh>(soup);
    std::vector<Skeleton_branch> branches(2);
    const auto branch_of = boost::make_function_property_map<Surface_mesh::Face_index>(
      [](auto f) { return std::size_t(f.idx() < 10 ? 0 : 1); });
    const auto no_junction = boost::make_function_property_map<Surface_mesh::Face_index>([](auto) { return false; });
    BOOST_TEST(measure_branch_faces(mesh, branch_of, no_junction, branches) == (is_turned ? 1u : 0u));
    BOOST_TEST(branches[0].volume == 24, boost::test_tools::tolerance(1e-12));
    BOOST_TEST(branches[1].volume == 0);
    BOOST_TEST(branches[1].area == 3 * std::sqrt(13.), boost::test_tools::tolerance(1e-12));
    for(auto& triangle : soup.triangles)
      std::swap(triangle[0], triangle[1]);
  }
}

// A tube of radius 1, one with a branch, and what is open: the volumes that a person knows, and the same inside out.
BOOST_AUTO_TEST_CASE(volumes_of_branches)
{
  for(const bool is_open : {false, true})
  {
    Tubes tube;
    tube.tubes = {{{0, 0, 0}, {0, 0, 12}, 1, 1}};
    if(is_open)
      tube.holes = {{{0, 0, -1}, 1.02}, {{0, 0, 13}, 1.02}};
    auto soup = tube_samples::surface(tube);
    const Sizes sizes = sizes_of(soup);
    BOOST_REQUIRE(sizes.branches.size() == 1u);
    const double volume = sizes.branches.front().volume, pi = 3.141592653589793;
    BOOST_TEST(volume == pi * (12 + (is_open ? 0.8 : 4. / 3)), boost::test_tools::tolerance(0.02));
    BOOST_TEST(sizes.branches.front().junction_volume == 0);
    BOOST_TEST(sizes.number_inside_out == 0u);
    for(auto& triangle : soup.triangles)
      std::swap(triangle[0], triangle[1]);
    const Sizes turned = sizes_of(soup);
    BOOST_TEST(turned.number_inside_out == 1u);
    BOOST_TEST(are_near(turned.branches.front().volume, volume));
  }
  const Sizes sizes = sizes_of(tube_samples::surface(tube_with_branch(0)));
  BOOST_REQUIRE(sizes.branches.size() == 3u);
  double junctions = 0, volume = 0;
  for(const Skeleton_branch& branch : sizes.branches)
  {
    BOOST_TEST((branch.volume > 0 && branch.junction_volume > 0 && branch.junction_volume < branch.volume));
    junctions += branch.junction_volume;
    volume += branch.volume;
    if(branch.radius < 5) // which leaves the wide one, of radius 10, where the cone over its border begins
      BOOST_TEST(branch.volume - branch.junction_volume == 3.1416 * 4 * 30, boost::test_tools::tolerance(0.15));
  }
  BOOST_TEST(junctions == 3.1416 * 100 * 20,
             boost::test_tools::tolerance(0.25)); // the ball there is as wide as that tube
  BOOST_TEST(volume == 3.1416 * (100 * 90 + 4000. / 3 + 4 * 30), boost::test_tools::tolerance(0.02));
}

BOOST_AUTO_TEST_SUITE_END()
