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

#include <CGAL/Reeb_graph/curves/branch_curves.h>
#include <CGAL/Reeb_graph/curves/cutting_system.h>
#include <CGAL/Reeb_graph/curves/pants_decomposition.h>
#include <CGAL/Reeb_graph/curves/unfold_multi_saddles.h>
#include <CGAL/Reeb_graph/scalar_maps.h>
#include <CGAL/Reeb_graph/simplification/simplify.h>

#include <boost/mpl/list.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <iterator>
#include <string>
#include <utility>
#include <vector>

// Cutting systems, pants decompositions and branch curves: their numbers, and the pieces between them.

BOOST_AUTO_TEST_SUITE(test_curves)

using namespace cut_mesh_checks;
using CGAL::Reeb_graph::Borders;
using curve_samples::number_of_samples;
using curve_samples::Sample;
using mesh_builders::Polyhedron;
using mesh_builders::Surface_mesh;

typedef boost::mpl::list<Surface_mesh, Polyhedron> Meshes;

namespace {
template <class Mesh>
using Curves_of = std::vector<CGAL::Reeb_graph::Curve<typename boost::graph_traits<Mesh>::halfedge_descriptor>>;

long genus_of(const Piece& component)
{
  return (2 - component.euler_characteristic - static_cast<long>(component.border_loops)) / 2;
}

// the pieces of cutting systems of all components, and the number of their curves
std::pair<std::vector<Piece>, long> expected_of_cutting_system(const std::vector<Piece>& components)
{
  std::pair<std::vector<Piece>, long> expected;
  for(Piece component : components)
  {
    const long genus = genus_of(component);
    component.euler_characteristic = 2 - 2 * genus - static_cast<long>(component.border_loops);
    component.border_loops += static_cast<std::size_t>(2 * genus);
    expected.first.push_back(component);
    expected.second += genus;
  }
  return expected;
}

std::pair<std::vector<Piece>, long> expected_of_pants_decomposition(const std::vector<Piece>& components)
{
  std::pair<std::vector<Piece>, long> expected;
  for(const Piece& component : components)
  {
    const long genus = genus_of(component), borders = static_cast<long>(component.border_loops);
    for(long i = 0; i < 2 * genus - 2 + borders; ++i)
      expected.first.push_back({-1, 3, 0});
    expected.second += 3 * genus - 3 + borders;
  }
  return expected;
}

template <class Mesh>
struct Cutting_system
{
  static auto expected(const std::vector<Piece>& components) { return expected_of_cutting_system(components); }

  template <class ScalarMap, class NamedParameters>
  static void compute(Mesh& mesh, ScalarMap scalar_map, Curves_of<Mesh>& curves, const NamedParameters& np)
  {
    CGAL::Reeb_graph::cutting_system(mesh, scalar_map, std::back_inserter(curves), np);
  }
};

template <class Mesh>
struct Pants_decomposition
{
  static auto expected(const std::vector<Piece>& components) { return expected_of_pants_decomposition(components); }

  template <class ScalarMap, class NamedParameters>
  static void compute(Mesh& mesh, ScalarMap scalar_map, Curves_of<Mesh>& curves, const NamedParameters& np)
  {
    CGAL::Reeb_graph::pants_decomposition(mesh, scalar_map, std::back_inserter(curves), np);
  }
};

template <class Mesh, class Decomposition>
std::string fault_of_decomposition(const Sample& sample, Borders borders)
{
  Mesh mesh = curve_samples::make_mesh<Mesh>(sample.soup);
  const auto expected = Decomposition::expected(pieces_of(mesh));
  Face_history<Mesh> history(mesh);
  auto visitor = history.visitor();
  Curves_of<Mesh> curves;
  Decomposition::compute(mesh, CGAL::Reeb_graph::make_scalar_map(mesh, sample.values), curves,
                         CGAL::parameters::borders(borders).visitor(std::ref(visitor)));
  if(static_cast<long>(curves.size()) != expected.second)
    return std::to_string(curves.size()) + " curves, expected " + std::to_string(expected.second);
  for(const auto& curve : curves)
    if(!curve.is_closed)
      return "a curve is not closed";
  const std::string fault = fault_of_cut_mesh(mesh, curves, expected.first);
  return fault.empty() ? history.fault() : fault;
}

bool has_pants_decomposition(const std::vector<Piece>& components)
{
  return std::all_of(components.begin(), components.end(),
                     [](const Piece& component) { return component.euler_characteristic < 0; });
}

template <class Mesh>
void test_random_sample(const Sample& sample, Borders borders = Borders::LEVEL)
{
  BOOST_TEST((fault_of_decomposition<Mesh, Cutting_system<Mesh>>(sample, borders)) == "");
  if(has_pants_decomposition(pieces_of(curve_samples::make_mesh<Mesh>(sample.soup))))
    BOOST_TEST((fault_of_decomposition<Mesh, Pants_decomposition<Mesh>>(sample, borders)) == "");
}

// Branch curves cut off as many disks. A component that is a disk is none any more if it is cut.
template <class Mesh>
void test_branches(const Sample& sample, Borders borders)
{
  Mesh mesh = curve_samples::make_mesh<Mesh>(sample.soup);
  const auto components = pieces_of(mesh);
  Curves_of<Mesh> curves;
  CGAL::Reeb_graph::branch_curves(mesh, CGAL::Reeb_graph::make_scalar_map(mesh, sample.values),
                                  std::back_inserter(curves), CGAL::parameters::borders(borders));
  const auto pieces = pieces_between(mesh, curves);
  BOOST_TEST(pieces.size() == components.size() + curves.size());
  const auto is_disk = [](const Piece& piece) { return piece.euler_characteristic == 1 && piece.border_loops == 1; };
  const auto number_of_disks = static_cast<std::size_t>(std::count_if(pieces.begin(), pieces.end(), is_disk));
  BOOST_TEST(number_of_disks >= curves.size());
  BOOST_TEST(number_of_disks <= curves.size() + std::count_if(components.begin(), components.end(), is_disk));
  BOOST_TEST(fault_of_cut_mesh(mesh, curves, pieces) == "");
}
} // namespace

// Each oriented manifold mesh, with any borders and any field, in the exact numbers.
BOOST_AUTO_TEST_CASE_TEMPLATE(any_meshes_and_fields, Mesh, Meshes)
{
  std::size_t number_with_pants = 0;
  const std::size_t number = number_of_samples<Mesh>(700);
  for(std::size_t seed = 0; seed < number; ++seed)
    BOOST_TEST_CONTEXT("seed " << seed)
    {
      const Sample sample = curve_samples::any_sample(seed);
      test_random_sample<Mesh>(sample, Borders::MAKE_LEVEL);
      test_branches<Mesh>(sample, Borders::MAKE_LEVEL);
      number_with_pants += has_pants_decomposition(pieces_of(curve_samples::make_mesh<Mesh>(sample.soup))) ? 1 : 0;
    }
  BOOST_TEST(7 * number_with_pants > 3 * number);
}

BOOST_AUTO_TEST_CASE_TEMPLATE(closed_surfaces_and_random_fields, Mesh, Meshes)
{
  for(std::size_t seed = 0; seed < number_of_samples<Mesh>(400); ++seed)
    BOOST_TEST_CONTEXT("seed " << seed)
  test_random_sample<Mesh>(curve_samples::random_sample(seed, false, 1 + seed % 2, seed % 3 == 0 ? 0 : 2));
}

BOOST_AUTO_TEST_CASE_TEMPLATE(bordered_surfaces_and_random_fields, Mesh, Meshes)
{
  std::size_t number_of_tested = 0;
  const std::size_t number = number_of_samples<Mesh>(800);
  for(std::size_t seed = 1000; seed < 1000 + number; ++seed)
    BOOST_TEST_CONTEXT("seed " << seed)
    {
      const Sample sample = curve_samples::random_sample(seed, true, 1 + seed % 2, seed % 3);
      if(!curve_samples::are_borders_extremal(sample))
        continue;
      ++number_of_tested;
      test_random_sample<Mesh>(sample);
    }
  BOOST_TEST(8 * number_of_tested > 3 * number);
}

BOOST_AUTO_TEST_CASE(smooth_surfaces_of_genus_up_to_25)
{
  for(const unsigned genus : {0u, 1u, 2u, 3u, 7u, 16u, 25u})
    for(std::size_t kind = 0; kind < 4; ++kind)
      BOOST_TEST_CONTEXT("genus " << genus << ", field " << kind)
  test_random_sample<Surface_mesh>(curve_samples::smooth_sample(genus, 3000, kind));
}

BOOST_AUTO_TEST_CASE(unfolding_leaves_a_loop_for_each_handle)
{
  for(std::size_t seed = 0; seed < 200; ++seed)
    BOOST_TEST_CONTEXT("seed " << seed)
    {
      const Sample sample = curve_samples::random_sample(seed, false, 1, 1);
      auto mesh = curve_samples::make_mesh<Surface_mesh>(sample.soup);
      const long genus = genus_of(pieces_of(mesh).front());
      const auto rank_map = mesh.add_property_map<Surface_mesh::Vertex_index, std::uint64_t>("v:rank").first;
      CGAL::Reeb_graph::unfold_multi_saddles(mesh, CGAL::Reeb_graph::make_scalar_map(mesh, sample.values), rank_map);
      typedef CGAL::Reeb_graph_traits<Surface_mesh, decltype(rank_map)> Traits;
      struct Visitor : CGAL::Reeb_graph::Default_visitor
      {
        CGAL::Reeb_graph::Critical_vertex_counts counts;
        void critical_vertices(const CGAL::Reeb_graph::Critical_vertex_counts& c) { counts = c; }
      } visitor;
      typename Traits::Graph graph;
      CGAL::compute_reeb_graph(mesh, rank_map, graph, CGAL::parameters::visitor(std::ref(visitor)));
      BOOST_TEST(static_cast<long>(num_edges(graph)) - static_cast<long>(num_vertices(graph)) + 1 == genus);
      BOOST_TEST((visitor.counts.saddles.empty() || visitor.counts.saddles.rbegin()->first == 1));
      BOOST_TEST(CGAL::is_valid_polygon_mesh(mesh));
    }
}

BOOST_AUTO_TEST_CASE_TEMPLATE(branches_are_disks, Mesh, Meshes)
{
  for(std::size_t seed = 0; seed < number_of_samples<Mesh>(200); ++seed)
    BOOST_TEST_CONTEXT("seed " << seed)
  test_branches<Mesh>(curve_samples::random_sample(seed, false, 1 + seed % 2, 0), Borders::LEVEL);
}

namespace {
// The leaf arcs of a simplified graph that reach the threshold, with all that they have taken up.
template <class Graph>
std::size_t number_of_large_leaf_arcs(const Graph& graph, double threshold)
{
  Graph simplified;
  const auto simplification = CGAL::Reeb_graph::simplify(graph, threshold, simplified);
  std::size_t number = 0, arc_index = num_vertices(simplified);
  for(const auto arc : CGAL::make_range(edges(simplified)))
  {
    for(const auto& [leaf, saddle] : {std::make_pair(source(arc, simplified), target(arc, simplified)),
                                      std::make_pair(target(arc, simplified), source(arc, simplified))})
    {
      double persistence = 0;
      for(const auto node : CGAL::make_range(vertices(graph)))
      {
        const std::size_t index = simplification.index_of_node(node);
        if(index == leaf || index == arc_index)
          persistence = (std::max)(persistence, std::abs(simplified[saddle].value - graph[node].value));
      }
      const bool is_branch = degree(leaf, simplified) == 1 && degree(saddle, simplified) != 1;
      number += is_branch && persistence >= threshold ? 1 : 0;
    }
    ++arc_index;
  }
  return number;
}
} // namespace

BOOST_AUTO_TEST_CASE(branches_are_the_leaf_arcs_of_the_simplified_graph)
{
  std::size_t number_of_branches = 0;
  for(std::size_t seed = 0; seed < 150; ++seed)
    BOOST_TEST_CONTEXT("seed " << seed)
    {
      const Sample sample = curve_samples::random_sample(seed, false, 1 + seed % 2, seed % 3);
      auto mesh = curve_samples::make_mesh<Surface_mesh>(sample.soup);
      const auto values = mesh.add_property_map<Surface_mesh::Vertex_index, double>("v:value").first;
      CGAL::Reeb_graph::unfold_multi_saddles(mesh, CGAL::Reeb_graph::make_scalar_map(mesh, sample.values), values);
      CGAL::Reeb_graph_traits<Surface_mesh, decltype(values)>::Graph graph;
      CGAL::compute_reeb_graph(mesh, values, graph);
      const double range = *std::max_element(values.begin(), values.end());
      for(const double share : {0., 0.05, 0.2, 0.5, 0.9})
      {
        auto cut_mesh = mesh;
        const auto cut_values =
          cut_mesh.add_property_map<Surface_mesh::Vertex_index, double>("v:value").first; // the one that is there
        Curves_of<Surface_mesh> curves;
        CGAL::Reeb_graph::branch_curves(cut_mesh, cut_values, std::back_inserter(curves),
                                        CGAL::parameters::persistence_threshold(share * range));
        BOOST_TEST(curves.size() == number_of_large_leaf_arcs(graph, share * range));
        number_of_branches += share > 0.1 ? curves.size() : 0;
      }
    }
  BOOST_TEST(number_of_branches > 100u);
}

namespace {
std::size_t number_of_branches(const Sample& sample, double persistence, double area)
{
  auto mesh = curve_samples::make_mesh<Surface_mesh>(sample.soup);
  Curves_of<Surface_mesh> curves;
  CGAL::Reeb_graph::branch_curves(mesh, CGAL::Reeb_graph::make_scalar_map(mesh, sample.values),
                                  std::back_inserter(curves),
                                  CGAL::parameters::persistence_threshold(persistence).area_threshold(area));
  BOOST_TEST(CGAL::is_valid_polygon_mesh(mesh));
  return curves.size();
}

// a height field with a little noise
Sample noisy_sample(unsigned genus)
{
  Sample sample = curve_samples::smooth_sample(genus, 4000, 0);
  curve_samples::Random random(7);
  for(double& value : sample.values)
    value += 0.05 * static_cast<double>(random.below(1000)) / 1000;
  return sample;
}
} // namespace

namespace {
// How many curves there are on a mesh whose saddles are simple.
template <class NamedParameters>
std::size_t number_of_curves(Surface_mesh mesh, const NamedParameters& np)
{
  const auto values = mesh.add_property_map<Surface_mesh::Vertex_index, double>("v:value").first; // that is there
  Curves_of<Surface_mesh> curves;
  CGAL::Reeb_graph::branch_curves(mesh, values, std::back_inserter(curves), np);
  return curves.size();
}

// The leaf arcs of the graph simplified by numbers of vertices that reach the threshold.
template <class Mesh, class ScalarMap, class Graph>
std::size_t number_of_leaf_arcs_of_many_vertices(const Mesh& mesh,
                                                 const ScalarMap& values,
                                                 const Graph& graph,
                                                 std::size_t threshold)
{
  Graph simplified;
  const auto counts = CGAL::Reeb_graph::vertex_counts_of_places(
    mesh, graph, CGAL::Reeb_graph::Augmentation<Mesh, ScalarMap>(mesh, values, graph).locate_vertices());
  const auto simplification = CGAL::Reeb_graph::simplify(graph, static_cast<double>(threshold), simplified,
                                                         CGAL::parameters::place_weights(counts));
  std::vector<double> new_counts(num_vertices(simplified) + num_edges(simplified), 0);
  for(std::size_t place = 0; place < counts.size(); ++place)
    new_counts[place < num_vertices(graph) ? simplification.index_of_node(place)
                                           : simplification.index_of_arc(place - num_vertices(graph))] += counts[place];
  std::size_t number = 0, arc_index = num_vertices(simplified);
  for(const auto arc : CGAL::make_range(edges(simplified)))
  {
    const auto lower = source(arc, simplified), upper = target(arc, simplified);
    if((degree(lower, simplified) == 1) != (degree(upper, simplified) == 1))
    {
      const auto leaf = degree(lower, simplified) == 1 ? lower : upper;
      number += new_counts[leaf] + new_counts[arc_index] >= static_cast<double>(threshold) ? 1 : 0;
    }
    ++arc_index;
  }
  return number;
}
} // namespace

BOOST_AUTO_TEST_CASE(measures_of_branches)
{
  namespace parameters = CGAL::parameters;
  std::size_t number_of_branches = 0;
  for(std::size_t seed = 0; seed < 60; ++seed)
    BOOST_TEST_CONTEXT("seed " << seed)
    {
      const Sample sample = curve_samples::random_sample(seed, false, 1 + seed % 2, seed % 3);
      auto mesh = curve_samples::make_mesh<Surface_mesh>(sample.soup);
      const auto values = mesh.add_property_map<Surface_mesh::Vertex_index, double>("v:value").first;
      CGAL::Reeb_graph::unfold_multi_saddles(mesh, CGAL::Reeb_graph::make_scalar_map(mesh, sample.values), values);
      CGAL::Reeb_graph_traits<Surface_mesh, decltype(values)>::Graph graph;
      CGAL::compute_reeb_graph(mesh, values, graph);
      for(const std::size_t count : {1, 2, 3, 5, 8, 20})
      {
        const std::size_t number = number_of_curves(mesh, parameters::vertex_count_threshold(count));
        BOOST_TEST(number == number_of_leaf_arcs_of_many_vertices(mesh, values, graph, count));
        number_of_branches += count > 1 ? number : 0;
      }
      const double range = *std::max_element(values.begin(), values.end());
      const auto persistence = [](const auto& branch) { return branch.persistence; };
      const auto area = [](const auto& branch) { return branch.weight; };
      const auto difference = [&](const auto& branch) { return std::abs(values[branch.leaf] - values[branch.saddle]); };
      for(const double share : {0.05, 0.2, 0.5})
      {
        const auto threshold = parameters::measure_threshold(share * range);
        const std::size_t number = number_of_curves(mesh, parameters::persistence_threshold(share * range));
        BOOST_TEST(number_of_curves(mesh, threshold.branch_measure(persistence)) == number);
        BOOST_TEST(number_of_curves(mesh, threshold.branch_measure(difference)) <= number);
        BOOST_TEST(number_of_curves(mesh, parameters::branch_measure(area).measure_threshold(share))
                   == number_of_curves(mesh, parameters::area_threshold(share)));
      }
      BOOST_CHECK_THROW(number_of_curves(mesh, parameters::branch_measure([](const auto&) {
                                                 return std::nan("");
                                               }).measure_threshold(1)),
                        CGAL::Reeb_graph::Parameter_error);
    }
  BOOST_TEST(number_of_branches > 100u);
}

BOOST_AUTO_TEST_CASE(thresholds_of_branches_remove_noise)
{
  const Sample smooth = curve_samples::smooth_sample(2, 4000, 0), noisy = noisy_sample(2);
  const std::size_t without_noise = number_of_branches(smooth, 0, 0);
  BOOST_TEST(number_of_branches(smooth, 0.06, 0) == without_noise);
  BOOST_TEST(number_of_branches(noisy, 0, 0) > 20 * without_noise);
  BOOST_TEST(number_of_branches(noisy, 0.06, 0) == without_noise);
  BOOST_TEST(number_of_branches(noisy, 0, 0.1) <= 2 * without_noise);
  BOOST_TEST(number_of_branches(noisy, 1000, 0) == 0u);
  BOOST_TEST(number_of_branches(noisy, 0, 1000) == 0u);
}

BOOST_AUTO_TEST_SUITE_END()
