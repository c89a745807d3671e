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

#include <CGAL/Reeb_graph/Augmentation.h>
#include <CGAL/Reeb_graph/curves/segmentation.h>
#include <CGAL/Reeb_graph/scalar_maps.h>
#include <CGAL/compute_reeb_graph.h>

#include <boost/mpl/list.hpp>

#include <cstddef>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

// Segmentations of the faces: by arcs of any graph, by pairs of pants, by branches.

BOOST_AUTO_TEST_SUITE(test_segmentation)

using namespace cut_mesh_checks;
using curve_samples::Sample;
using mesh_builders::Polyhedron;
using mesh_builders::Surface_mesh;

typedef boost::mpl::list<Surface_mesh, Polyhedron> Meshes;

namespace {
template <class Mesh>
using Patches_of = std::map<typename boost::graph_traits<Mesh>::face_descriptor, std::size_t>;

// The patches as pieces of the surface, in the order of their numbers; empty if one of them is not connected.
template <class Mesh>
std::vector<Piece> pieces_of_patches(const Mesh& mesh, const Patches_of<Mesh>& patches)
{
  const auto is_cut = [&](typename boost::graph_traits<Mesh>::halfedge_descriptor h) {
    const auto g = opposite(h, mesh);
    return !is_border(h, mesh) && !is_border(g, mesh) && patches.at(face(h, mesh)) != patches.at(face(g, mesh));
  };
  const auto pieces = Flat_mesh(mesh, is_cut).pieces();
  std::map<std::size_t, std::size_t> piece_of_patch;
  std::size_t triangle = 0;
  for(const auto f : faces(mesh))
  {
    const std::size_t piece = pieces.second[triangle++];
    if(piece_of_patch.emplace(patches.at(f), piece).first->second != piece)
      return {};
  }
  std::vector<Piece> result;
  for(const auto& item : piece_of_patch)
    result.push_back(pieces.first[item.second]);
  return piece_of_patch.size() == pieces.first.size() ? result : std::vector<Piece>();
}

template <class Mesh, class NamedParameters>
void test_arcs(const Sample& sample, const NamedParameters& np)
{
  Mesh mesh = curve_samples::make_mesh<Mesh>(sample.soup);
  const auto scalar_map = CGAL::Reeb_graph::make_scalar_map(mesh, sample.values);
  typename CGAL::Reeb_graph_traits<Mesh, std::decay_t<decltype(scalar_map)>>::Graph graph;
  CGAL::compute_reeb_graph(mesh, scalar_map, graph, np);
  typedef CGAL::Reeb_graph::Augmentation<Mesh, std::decay_t<decltype(scalar_map)>> Augmentation;
  std::map<typename boost::graph_traits<Mesh>::vertex_descriptor, std::size_t> places;
  {
    const Augmentation augmentation(mesh, scalar_map, graph, np);
    const auto vertex_places = augmentation.locate_vertices();
    for(const auto v : vertices(mesh))
      places[v] = vertex_places.index(v);
  }
  Patches_of<Mesh> patches;
  const std::size_t number_of_patches =
    CGAL::Reeb_graph::segment_by_arcs(mesh, scalar_map, graph, boost::make_assoc_property_map(patches), np);

  BOOST_TEST(is_valid_mesh(mesh));
  std::size_t number_of_components_without_arc = 0;
  for(const auto node : CGAL::make_range(vertices(graph)))
    if(degree(node, graph) == 0 && halfedge(graph[node].vertex, mesh) != boost::graph_traits<Mesh>::null_halfedge())
      ++number_of_components_without_arc;
  BOOST_TEST(number_of_patches == num_edges(graph) + number_of_components_without_arc);
  BOOST_TEST(pieces_of_patches(mesh, patches).size() == number_of_patches);
  for(const auto& patch : patches)
    BOOST_TEST(patch.second < number_of_patches);
  std::size_t number_of_faults = 0;
  for(const auto& [v, place] : places)
  {
    if(halfedge(v, mesh) == boost::graph_traits<Mesh>::null_halfedge())
      continue;
    std::set<std::size_t> patches_of_vertex;
    for(const auto f : faces_around_target(halfedge(v, mesh), mesh))
      if(f != boost::graph_traits<Mesh>::null_face())
        patches_of_vertex.insert(patches.at(f));
    const bool is_on_arc = place >= num_vertices(graph);
    if(patches_of_vertex.size() != 1 || (is_on_arc && *patches_of_vertex.begin() != place - num_vertices(graph)))
      ++number_of_faults;
  }
  BOOST_TEST(number_of_faults == 0u);
}
} // namespace

BOOST_AUTO_TEST_CASE_TEMPLATE(each_arc_has_one_patch, Mesh, Meshes)
{
  for(std::size_t seed = 0; seed < 400; ++seed)
    BOOST_TEST_CONTEXT("seed " << seed)
  test_arcs<Mesh>(curve_samples::any_sample(seed), CGAL::parameters::default_values());
}

BOOST_AUTO_TEST_CASE(each_arc_has_one_patch_with_other_parameters)
{
  using CGAL::Reeb_graph::Ties;
  for(std::size_t seed = 0; seed < 400; ++seed)
    BOOST_TEST_CONTEXT("seed " << seed)
  test_arcs<Surface_mesh>(
    curve_samples::any_sample(seed),
    CGAL::parameters::ties(seed % 3 == 0 ? Ties::PERTURB : Ties::CONTRACT).keep_degree_two_nodes(seed % 2 == 0));
}

BOOST_AUTO_TEST_CASE_TEMPLATE(patches_of_pants, Mesh, Meshes)
{
  for(const unsigned genus : {2u, 4u})
    for(std::size_t kind = 0; kind < 4; ++kind)
      BOOST_TEST_CONTEXT("genus " << genus << ", field " << kind)
      {
        const Sample sample = curve_samples::smooth_sample(genus, 1000, kind);
        Mesh mesh = curve_samples::make_mesh<Mesh>(sample.soup);
        Patches_of<Mesh> patches;
        const std::size_t number_of_patches = CGAL::Reeb_graph::segment_by_pants(
          mesh, CGAL::Reeb_graph::make_scalar_map(mesh, sample.values), boost::make_assoc_property_map(patches));
        BOOST_TEST(number_of_patches == 2 * genus - 2);
        BOOST_TEST(pieces_of(mesh).size() == 1u);
        std::set<std::size_t> numbers;
        for(const auto& item : patches)
          numbers.insert(item.second);
        BOOST_TEST(numbers.size() == number_of_patches);
        BOOST_TEST(*numbers.rbegin() == number_of_patches - 1);
      }
}

BOOST_AUTO_TEST_CASE_TEMPLATE(patches_of_branches, Mesh, Meshes)
{
  const Sample sample = curve_samples::four_armed_sphere();
  Mesh mesh = curve_samples::make_mesh<Mesh>(sample.soup);
  Patches_of<Mesh> patches;
  const std::size_t number_of_patches = CGAL::Reeb_graph::segment_by_branches(
    mesh, CGAL::Reeb_graph::make_scalar_map(mesh, sample.values), boost::make_assoc_property_map(patches),
    CGAL::parameters::cut_open(true).persistence_threshold(0.3));
  BOOST_TEST(number_of_patches == 5u);
  BOOST_TEST(pieces_of(mesh).size() == 5u);
  std::vector<Piece> pieces = pieces_of_patches(mesh, patches);
  BOOST_REQUIRE(pieces.size() == 5u);
  std::sort(pieces.begin(), pieces.end());
  BOOST_TEST(pieces[0].euler_characteristic == -2);
  BOOST_TEST(pieces[0].border_loops == 4u);
  for(std::size_t i = 1; i < 5; ++i)
    BOOST_TEST(pieces[i].euler_characteristic == 1);
}

BOOST_AUTO_TEST_SUITE_END()
