// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#include <boost/test/unit_test.hpp>

#include "curve_samples.h"
#include "cut_mesh_checks.h"
#include "random_meshes.h"

#include <CGAL/Reeb_graph/curves/cut_to_disks.h>

#include <CGAL/Polygon_mesh_processing/measure.h>

#ifdef CGAL_EIGEN3_ENABLED
#include <CGAL/Surface_mesh_parameterization/Barycentric_mapping_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/Circular_border_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/parameterize.h>
#include <CGAL/boost/graph/Face_filtered_graph.h>
#include <CGAL/boost/graph/copy_face_graph.h>
#endif

#include <boost/mpl/list.hpp>
#include <boost/property_map/property_map.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <iterator>
#include <map>
#include <set>
#include <utility>
#include <vector>

// Surfaces of any genus with any borders, cut to disks.

BOOST_AUTO_TEST_SUITE(test_cut_to_disks)

using curve_samples::Sample;
using mesh_builders::Polyhedron;
using mesh_builders::Surface_mesh;
namespace parameters = CGAL::parameters;

typedef boost::mpl::list<Surface_mesh, Polyhedron> Meshes;

namespace {
// One to three components of genus up to 20, with up to 8 holes in all, and with isolated vertices.
generated_surfaces::Triangle_soup surface_of_seed(std::size_t seed)
{
  random_meshes::Random random(seed);
  random_meshes::Combinatorial_mesh mesh;
  for(std::size_t component = 0; component <= seed % 3; ++component)
  {
    const unsigned genus = static_cast<unsigned>(seed % 4 == 0 ? 0 : random.below(seed % 4 == 1 ? 21 : 4));
    const std::size_t size = random.below(60);
    mesh = random_meshes::disjoint_union(mesh, random_meshes::random_closed_surface(genus, size, random));
  }
  const std::size_t number_of_holes = seed % 5 == 0 ? 0 : random.below(9);
  if(seed % 2 == 0)
    random_meshes::remove_far_triangles(mesh, number_of_holes, random);
  else
    random_meshes::remove_random_triangles(mesh, number_of_holes, random);
  mesh.number_of_vertices += seed % 7 == 0 ? 2 : 0;
  random_meshes::relabel(mesh, random);
  generated_surfaces::Triangle_soup soup = {{}, mesh.triangles};
  for(std::size_t v = 0; v < mesh.number_of_vertices; ++v)
    soup.points.push_back({static_cast<double>(random.below(1000)), static_cast<double>(random.below(1000)),
                           static_cast<double>(random.below(1000))});
  return soup;
}

template <class Mesh>
struct Disks
{
  typedef typename boost::graph_traits<Mesh>::vertex_descriptor vertex_descriptor;
  typedef typename boost::graph_traits<Mesh>::halfedge_descriptor halfedge_descriptor;
  typedef typename boost::graph_traits<Mesh>::face_descriptor face_descriptor;

  explicit Disks(const generated_surfaces::Triangle_soup& soup)
    : mesh(curve_samples::make_mesh<Mesh>(soup)),
      given(vertices(mesh).first, vertices(mesh).second),
      given_faces(corners_of_faces()),
      components(cut_mesh_checks::pieces_of(mesh))
  {
    CGAL::Reeb_graph::cut_to_disks(mesh, std::back_inserter(curves),
                                   parameters::original_vertex_map(boost::make_assoc_property_map(originals))
                                     .edge_is_constrained_map(boost::make_assoc_property_map(is_constrained))
                                     .face_patch_map(boost::make_assoc_property_map(patches)));
  }

  std::map<face_descriptor, std::vector<vertex_descriptor>> corners_of_faces() const
  {
    std::map<face_descriptor, std::vector<vertex_descriptor>> corners;
    for(const auto f : faces(mesh))
      for(const auto v : vertices_around_face(halfedge(f, mesh), mesh))
        corners[f].push_back(originals.empty() ? v : originals.at(v));
    for(auto& item : corners)
      std::rotate(item.second.begin(), std::min_element(item.second.begin(), item.second.end()), item.second.end());
    return corners;
  }

  Mesh mesh;
  std::vector<vertex_descriptor> given;
  std::map<vertex_descriptor, vertex_descriptor> originals;
  std::map<face_descriptor, std::vector<vertex_descriptor>> given_faces;
  std::vector<cut_mesh_checks::Piece> components;
  std::vector<CGAL::Reeb_graph::Curve<halfedge_descriptor>> curves;
  std::map<typename boost::graph_traits<Mesh>::edge_descriptor, bool> is_constrained;
  std::map<face_descriptor, std::size_t> patches;
};
} // namespace

BOOST_AUTO_TEST_CASE_TEMPLATE(each_component_is_a_disk_of_the_same_faces, Mesh, Meshes)
{
  for(std::size_t seed = 0; seed < 400; ++seed)
    BOOST_TEST_CONTEXT("seed " << seed)
    {
      const generated_surfaces::Triangle_soup soup =
        seed < 200 ? surface_of_seed(seed) : curve_samples::any_sample(seed).soup;
      Disks<Mesh> disks(soup);
      BOOST_TEST(cut_mesh_checks::is_valid_mesh(disks.mesh));
      const auto pieces = cut_mesh_checks::pieces_of(disks.mesh);
      BOOST_REQUIRE(pieces.size() == disks.components.size());
      std::set<std::size_t> patches;
      for(const auto& item : disks.patches)
        patches.insert(item.second);
      BOOST_TEST(patches.size() == pieces.size());
      bool are_all_disks = true;
      for(std::size_t i = 0; i < pieces.size(); ++i)
      {
        BOOST_TEST(pieces[i].euler_characteristic == 1);
        BOOST_TEST(pieces[i].border_loops == 1u);
        BOOST_TEST(pieces[i].faces == disks.components[i].faces);
        are_all_disks = are_all_disks && disks.components[i].euler_characteristic == 1;
      }
      BOOST_TEST(disks.curves.empty() == are_all_disks);
      // The faces and the points are those that were there.
      BOOST_TEST((disks.corners_of_faces() == disks.given_faces));
      BOOST_TEST(disks.originals.size() == vertices(disks.mesh).size());
      for(const auto v : disks.given)
        BOOST_TEST((disks.originals.at(v) == v));
      const auto point_map = get(CGAL::vertex_point, disks.mesh);
      for(const auto& [copy, original] : disks.originals)
        BOOST_TEST(get(point_map, copy) == get(point_map, original));
      std::set<std::pair<typename Disks<Mesh>::vertex_descriptor, typename Disks<Mesh>::vertex_descriptor>> ends;
      for(const auto h : halfedges(disks.mesh))
        BOOST_TEST(ends.emplace(source(h, disks.mesh), target(h, disks.mesh)).second);
      for(const auto& curve : disks.curves)
        for(const auto* halfedges : {&curve.halfedges, &curve.lower_halfedges})
          for(const auto h : *halfedges)
            BOOST_TEST((is_border(edge(h, disks.mesh), disks.mesh) && disks.is_constrained.at(edge(h, disks.mesh))));
    }
}

BOOST_AUTO_TEST_CASE_TEMPLATE(a_sphere_is_cut_along_its_two_shortest_edges_at_a_vertex, Mesh, Meshes)
{
  for(std::size_t seed = 0; seed < 50; ++seed)
    BOOST_TEST_CONTEXT("seed " << seed)
    {
      const Sample sample = curve_samples::smooth_sample(0, 50 + 10 * seed, 0);
      Disks<Mesh> disks(sample.soup);
      BOOST_REQUIRE(disks.curves.size() == 1u);
      BOOST_TEST(disks.curves.front().halfedges.size() == 2u);
      BOOST_TEST(!disks.curves.front().is_closed);
      BOOST_TEST(vertices(disks.mesh).size() == sample.soup.points.size() + 1);
      double least = std::numeric_limits<double>::infinity();
      const auto mesh = curve_samples::make_mesh<Mesh>(sample.soup);
      for(const auto v : vertices(mesh))
      {
        std::vector<double> lengths;
        for(const auto h : halfedges_around_target(v, mesh))
          lengths.push_back(CGAL::Polygon_mesh_processing::edge_length(h, mesh));
        std::sort(lengths.begin(), lengths.end());
        least = (std::min)(least, lengths[0] + lengths[1]);
      }
      BOOST_TEST(disks.curves.front().length == least, boost::test_tools::tolerance(1e-12));
    }
}

// A torus of radii 1 and 0.4 is not cut much longer than around its tube and around its hole.
BOOST_AUTO_TEST_CASE(cuts_are_short)
{
  const double pi = std::acos(-1.);
  Disks<Surface_mesh> disks(generated_surfaces::torus(90, 45));
  double length = 0;
  for(const auto& curve : disks.curves)
    length += curve.length;
  BOOST_TEST(length > 1.9 * pi);
  BOOST_TEST(length < 3 * pi);
}

// Squares of lengths are infinite or 0 in some of these units.
BOOST_AUTO_TEST_CASE(cuts_are_the_same_in_any_unit)
{
  for(std::size_t seed = 0; seed < 20; ++seed)
    for(const double unit : {std::ldexp(1., 660), std::ldexp(1., -660)})
      BOOST_TEST_CONTEXT("seed " << seed << ", unit " << unit)
      {
        generated_surfaces::Triangle_soup soup = surface_of_seed(seed);
        const Disks<Surface_mesh> disks(soup);
        for(auto& point : soup.points)
          for(double& coordinate : point)
            coordinate *= unit;
        const Disks<Surface_mesh> others(soup);
        BOOST_REQUIRE(disks.curves.size() == others.curves.size());
        for(std::size_t i = 0; i < disks.curves.size(); ++i)
          BOOST_TEST((disks.curves[i].halfedges == others.curves[i].halfedges));
      }
}

BOOST_AUTO_TEST_CASE(work_that_is_cancelled_changes_nothing)
{
  for(const double last : {0., 0.2, 0.5})
  {
    const Sample sample = curve_samples::smooth_sample(3, 500, 0);
    auto mesh = curve_samples::make_mesh<Surface_mesh>(sample.soup);
    std::vector<CGAL::Reeb_graph::Curve<Surface_mesh::Halfedge_index>> curves;
    BOOST_CHECK_THROW(CGAL::Reeb_graph::cut_to_disks(mesh, std::back_inserter(curves),
                                                     parameters::callback([last](double t) { return t <= last; })),
                      CGAL::Reeb_graph::Cancelled_error);
    BOOST_TEST(curves.empty());
    BOOST_TEST(CGAL::is_closed(mesh));
    BOOST_TEST(mesh.number_of_vertices() == sample.soup.points.size());
  }
}

BOOST_AUTO_TEST_CASE(what_is_no_surface_is_refused)
{
  // Two triangles that share a corner only.
  Surface_mesh mesh = curve_samples::make_mesh<Surface_mesh>(
    {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {2, 2, 0}, {2, 1, 0}}, {{0, 1, 2}, {0, 3, 4}}});
  std::vector<CGAL::Reeb_graph::Curve<Surface_mesh::Halfedge_index>> curves;
  BOOST_CHECK_THROW(CGAL::Reeb_graph::cut_to_disks(mesh, std::back_inserter(curves)),
                    CGAL::Reeb_graph::Non_manifold_vertex_error);
}

#ifdef CGAL_EIGEN3_ENABLED
namespace {
// The least area, with its sign, of the triangles of a disk that is flattened to a circle, each vertex in the middle of
// its neighbors, as a multiple of the mean area.
double least_area(Surface_mesh& disk)
{
  namespace SMP = CGAL::Surface_mesh_parameterization;
  typedef SMP::Circular_border_uniform_parameterizer_3<Surface_mesh> Border;
  const auto map =
    disk.add_property_map<Surface_mesh::Vertex_index, CGAL::Point_2<mesh_builders::Kernel>>("v:uv").first;
  const auto h = CGAL::Polygon_mesh_processing::longest_border(disk).first;
  const auto error = SMP::parameterize(disk, SMP::Barycentric_mapping_parameterizer_3<Surface_mesh, Border>(), h, map);
  BOOST_REQUIRE(error == SMP::OK);
  double least = std::numeric_limits<double>::infinity(), sum = 0;
  for(const auto f : disk.faces())
  {
    const auto g = disk.halfedge(f);
    const double area = CGAL::area(map[disk.source(g)], map[disk.target(g)], map[disk.target(disk.next(g))]);
    least = (std::min)(least, area);
    sum += area;
  }
  return least / (sum / static_cast<double>(disk.number_of_faces()));
}
} // namespace

// By the theorem of Tutte, that turns no triangle of a disk over.
BOOST_AUTO_TEST_CASE(disks_can_be_flattened)
{
  for(std::size_t seed = 0; seed < 20; ++seed)
    BOOST_TEST_CONTEXT("seed " << seed)
    {
      Disks<Surface_mesh> disks(surface_of_seed(3 * seed));
      const std::size_t number = cut_mesh_checks::pieces_of(disks.mesh).size();
      for(std::size_t piece = 0; piece < number; ++piece)
      {
        const CGAL::Face_filtered_graph<Surface_mesh> part(disks.mesh, piece,
                                                           boost::make_assoc_property_map(disks.patches));
        Surface_mesh disk;
        CGAL::copy_face_graph(part, disk);
        BOOST_TEST(least_area(disk) > 0);
      }
    }
}
#endif

BOOST_AUTO_TEST_SUITE_END()
