// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#include <boost/test/unit_test.hpp>

#include "computed_graphs.h"
#include "simplification_oracle.h"

#include <CGAL/Reeb_graph/Augmentation.h>
#include <CGAL/Reeb_graph/fields/make_borders_level.h>
#include <CGAL/Reeb_graph/simplification/simplify.h>
#include <CGAL/Reeb_graph/simplification/simplify_field.h>

#include <boost/mpl/list.hpp>
#include <boost/property_map/property_map.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <ctime>
#include <limits>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

// The Reeb graph of a simplified field, computed anew, is the simplified graph.

BOOST_AUTO_TEST_SUITE(test_simplify_field)

using namespace computed_graphs;
using mesh_builders::Polyhedron;
using mesh_builders::Surface_mesh;
using simplification_oracle::Simplification_oracle;
namespace parameters = CGAL::parameters;

typedef boost::mpl::list<Surface_mesh, Polyhedron> Meshes;

namespace {
typedef std::vector<std::pair<std::size_t, std::size_t>> Arcs;

struct Field_sample
{
  Field_sample(Mesh_class mesh_class, Field_class field_class, std::size_t seed)
  {
    Random random(seed);
    mesh = random_meshes::random_mesh(mesh_class, random);
    values = random_meshes::random_field(mesh, field_class, random);
    threshold = 0.5 + static_cast<double>(random.below(2 + mesh.number_of_vertices / 2));
  }

  Combinatorial_mesh mesh;
  std::vector<double> values;
  double threshold;
};

template <class Mesh>
std::vector<double> values_of(const Mesh& mesh, const graph_checks::Scalar_map_of<Mesh>& map)
{
  std::vector<double> values;
  for(const auto v : vertices(mesh))
    values.push_back(get(map, v));
  return values;
}

template <class Graph>
std::size_t number_of_leaves(const Graph& graph)
{
  std::size_t leaves = 0;
  for(std::size_t node = 0; node < num_vertices(graph); ++node)
    leaves += degree(node, graph) == 1 ? 1 : 0;
  return leaves;
}

template <class Graph>
std::vector<double> sorted_values(const Graph& graph)
{
  std::vector<double> values;
  for(std::size_t node = 0; node < num_vertices(graph); ++node)
    values.push_back(graph[node].value);
  std::sort(values.begin(), values.end());
  return values;
}

template <class Graph>
std::vector<std::size_t> sorted_degrees(const Graph& graph)
{
  std::vector<std::size_t> degrees;
  for(std::size_t node = 0; node < num_vertices(graph); ++node)
    degrees.push_back(1000 * in_degree(node, graph) + out_degree(node, graph));
  std::sort(degrees.begin(), degrees.end());
  return degrees;
}

// What arcs and nodes consist of that are still there, by number of the place in the graph before.
template <class Graph>
std::set<std::size_t> places_that_stay(const Graph& graph, const Simplification_oracle& oracle)
{
  std::set<std::size_t> places;
  const Arcs arcs = persistence_oracle::arcs_of(graph);
  for(const auto& node : oracle.nodes)
    places.insert(node.first);
  for(const auto& arc : oracle.arcs)
    for(const std::size_t piece : arc.pieces)
      places.insert({arcs[piece].first, arcs[piece].second, num_vertices(graph) + piece});
  return places;
}

// Whether the nodes of a graph at the same place of the simplified graph are a tree, and all other arcs are its arcs.
template <class Mesh, class Graph, class PlaceOfVertex>
bool is_expanded(const Graph& graph, const Graph& simplified, const PlaceOfVertex& place_of_vertex)
{
  std::vector<std::size_t> places, trees;
  std::set<std::size_t> found;
  for(std::size_t node = 0; node < num_vertices(graph); ++node)
  {
    places.push_back(place_of_vertex(graph[node].vertex));
    trees.push_back(node);
    found.insert(places.back());
  }
  Arcs arcs;
  for(const auto& [lower, upper] : persistence_oracle::arcs_of(graph))
  {
    if(places[lower] != places[upper])
    {
      arcs.emplace_back(places[lower], places[upper]);
      continue;
    }
    if(trees[lower] == trees[upper])
      return false;
    std::replace(trees.begin(), trees.end(), std::size_t(trees[lower]), std::size_t(trees[upper]));
  }
  std::sort(arcs.begin(), arcs.end());
  const std::size_t number_of_trees = std::set<std::size_t>(trees.begin(), trees.end()).size();
  return arcs == persistence_oracle::arcs_of(simplified) && number_of_trees == num_vertices(simplified)
      && found.size() == num_vertices(simplified);
}

bool names_the_way_out(const CGAL::Reeb_graph::Perturbed_ties_error& error)
{
  return std::string(error.what()).find("Ties::CONTRACT") != std::string::npos;
}

// The field that is computed with a given graph is the same one. Without ties, a graph with perturbed ones serves for
// contracted ones.
template <class Mesh>
void test_given_graph(const Field_sample& sample, Ties ties_of_graph, Ties ties)
{
  const Mesh mesh = make_mesh<Mesh>(sample.mesh);
  const auto scalar_map = CGAL::Reeb_graph::make_scalar_map(mesh, sample.values);
  const auto expected_map = CGAL::Reeb_graph::make_scalar_map(mesh, sample.values);
  const auto result_map = CGAL::Reeb_graph::make_scalar_map(mesh, sample.values);
  std::map<typename boost::graph_traits<Mesh>::vertex_descriptor, std::size_t> places;
  const auto place_map = boost::make_assoc_property_map(places);
  graph_checks::Graph_of<Mesh> graph;
  CGAL::compute_reeb_graph(mesh, scalar_map, graph, parameters::vertex_place_map(place_map).ties(ties_of_graph));
  const auto np = parameters::vertex_place_map(place_map).ties(ties);
  const double expected =
    CGAL::Reeb_graph::simplify_field(mesh, scalar_map, sample.threshold, expected_map, parameters::ties(ties));
  BOOST_TEST(CGAL::Reeb_graph::simplify_field(mesh, scalar_map, graph, sample.threshold, result_map, np) == expected);
  BOOST_TEST(values_of(mesh, result_map) == values_of(mesh, expected_map), boost::test_tools::per_element());
  for(auto& place : places)
    place.second = num_vertices(graph) + num_edges(graph);
  if(!places.empty())
    BOOST_CHECK_THROW(CGAL::Reeb_graph::simplify_field(mesh, scalar_map, graph, sample.threshold, result_map, np),
                      CGAL::Reeb_graph::Graph_mismatch_error);
}

// Tests a field; returns `false` if there is none, which the caller has to justify. Then there is one with contracted
// ties.
template <class Mesh>
bool test_field(const Field_sample& sample, Ties ties)
{
  const Mesh mesh = make_mesh<Mesh>(sample.mesh);
  const auto scalar_map = CGAL::Reeb_graph::make_scalar_map(mesh, sample.values);
  const auto result_map = CGAL::Reeb_graph::make_scalar_map(mesh, sample.values);
  Settings settings;
  settings.ties = ties;
  const auto graph = compute<CGAL::Sequential_tag>(mesh, scalar_map, settings);
  graph_checks::Graph_of<Mesh> simplified;
  const auto simplification = CGAL::Reeb_graph::simplify(graph, sample.threshold, simplified);
  double largest_change = 0;
  try
  {
    largest_change =
      CGAL::Reeb_graph::simplify_field(mesh, scalar_map, sample.threshold, result_map, parameters::ties(ties));
  }
  catch(const CGAL::Reeb_graph::Perturbed_ties_error& error)
  {
    BOOST_TEST(names_the_way_out(error));
    BOOST_TEST((ties == Ties::PERTURB && test_field<Mesh>(sample, Ties::CONTRACT)));
    BOOST_TEST(values_of(mesh, result_map) == sample.values, boost::test_tools::per_element());
    if(std::set<double>(sample.values.begin(), sample.values.end()).size() == sample.values.size())
      test_given_graph<Mesh>(sample, Ties::PERTURB, Ties::CONTRACT);
    return false;
  }
  const auto result = compute<CGAL::Sequential_tag>(mesh, result_map, settings);
  BOOST_TEST(number_of_leaves(result) == number_of_leaves(simplified));
  BOOST_TEST(num_edges(result) - num_vertices(result) == num_edges(simplified) - num_vertices(simplified));
  if(ties == Ties::CONTRACT)
  {
    BOOST_TEST(sorted_values(result) == sorted_values(simplified), boost::test_tools::per_element());
    BOOST_TEST(num_edges(result) == num_edges(simplified));
  }
  else if(num_vertices(result) == num_vertices(simplified))
    BOOST_TEST(sorted_degrees(result) == sorted_degrees(simplified), boost::test_tools::per_element());

  const CGAL::Reeb_graph::Augmentation<Mesh, graph_checks::Scalar_map_of<Mesh>> augmentation(mesh, scalar_map, graph,
                                                                                             parameters::ties(ties));
  const auto places = augmentation.locate_vertices();
  const auto place_of_vertex = [&](const auto& v) {
    const std::size_t place = places.index(v);
    return place < num_vertices(graph) ? simplification.index_of_node(place)
                                       : simplification.index_of_arc(place - num_vertices(graph));
  };
  BOOST_TEST((is_expanded<Mesh>(result, simplified, place_of_vertex)));
  const auto staying = places_that_stay(graph, Simplification_oracle(graph, sample.threshold));
  double change = 0;
  for(const auto v : vertices(mesh))
  {
    const double difference = get(result_map, v) == get(scalar_map, v) // also of infinities
                              ? 0
                              : std::abs(get(result_map, v) - get(scalar_map, v));
    change = (std::max)(change, difference);
    const bool is_tied = std::count(sample.values.begin(), sample.values.end(), get(scalar_map, v)) > 1;
    if(staying.count(places.index(v)) != 0)
      BOOST_TEST(difference <= (is_tied ? sample.threshold / 1024 : 0));
  }
  BOOST_TEST(change == largest_change);
  BOOST_TEST((change == 0 || change < sample.threshold));
  test_given_graph<Mesh>(sample, ties, ties);
  return true;
}

// A landscape with slits of three squares.
generated_surfaces::Triangle_soup terrain_with_holes(std::size_t side)
{
  auto soup = generated_surfaces::terrain(side, side);
  const auto triangles = std::move(soup.triangles);
  soup.triangles.clear();
  for(std::size_t i = 0; i < triangles.size(); ++i)
  {
    const std::size_t column = i / 2 % (side - 1), row = i / 2 / (side - 1);
    if(row % 5 != 2 || column % 5 == 0 || column % 5 == 4)
      soup.triangles.push_back(triangles[i]);
  }
  return soup;
}

template <class Work>
double cpu_seconds(const Work& work)
{
  const auto begin = std::clock();
  for(int i = 0; i < 5; ++i)
    work();
  return static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC;
}

// The arcs as pairs of numbers of nodes.
Arcs shape(const Surface_mesh& mesh, const std::vector<double>& values)
{
  return persistence_oracle::arcs_of(graph_checks::compute(mesh, values));
}
} // namespace

BOOST_AUTO_TEST_CASE_TEMPLATE(fields_with_contracted_ties, Mesh, Meshes)
{
  for(std::size_t seed = 0; seed < 1000; ++seed)
    BOOST_TEST_CONTEXT("seed " << seed)
    {
      const Field_sample sample(static_cast<Mesh_class>(seed % 6), static_cast<Field_class>(seed / 6 % 8), seed);
      BOOST_TEST(test_field<Mesh>(sample, Ties::CONTRACT));
    }
}

// A handle that a multi-saddle hides in a removed piece is all that can be in the way.
BOOST_AUTO_TEST_CASE_TEMPLATE(fields_of_closed_surfaces, Mesh, Meshes)
{
  std::size_t number_of_failures = 0;
  for(std::size_t seed = 0; seed < 1000; ++seed)
    BOOST_TEST_CONTEXT("seed " << seed)
    {
      const Field_sample sample(Mesh_class::CLOSED, Field_class::PERMUTATION, seed);
      const bool is_sphere = sample.mesh.triangles.size() == 2 * (sample.mesh.number_of_vertices - 2);
      const bool is_found = test_field<Mesh>(sample, Ties::PERTURB);
      BOOST_TEST((is_found || !is_sphere));
      number_of_failures += is_found ? 0 : 1;
    }
  BOOST_TEST(number_of_failures < 10u);
}

BOOST_AUTO_TEST_CASE(fields_of_surfaces_with_border)
{
  std::size_t number_of_failures = 0;
  for(std::size_t seed = 0; seed < 1000; ++seed)
    BOOST_TEST_CONTEXT("seed " << seed)
  number_of_failures +=
    test_field<Surface_mesh>(Field_sample(static_cast<Mesh_class>(1 + seed % 5), Field_class::PERMUTATION, seed),
                             Ties::PERTURB)
      ? 0
      : 1;
  BOOST_TEST(number_of_failures < 40u);
}

// Where vertices are tied with a saddle, there is no number between them before they are told apart.
BOOST_AUTO_TEST_CASE(tied_saddles)
{
  for(std::size_t seed = 0; seed < 600; ++seed)
    BOOST_TEST_CONTEXT("seed " << seed)
    {
      const Field_sample sample(Mesh_class::CLOSED, Field_class::FEW_VALUES, seed);
      const bool is_sphere = sample.mesh.triangles.size() == 2 * (sample.mesh.number_of_vertices - 2);
      const bool is_found = test_field<Surface_mesh>(sample, Ties::PERTURB);
      BOOST_TEST((is_found || !is_sphere));
    }
}

// All neighbors of the vertex 4 have the value 3. So it is an extremum, whatever its value is, unless one of theirs
// changes.
BOOST_AUTO_TEST_CASE(ties_that_have_to_be_spread)
{
  const Combinatorial_mesh combinatorial_mesh = {
    6, {{0, 5, 3}, {1, 4, 2}, {4, 1, 3}, {3, 2, 4}, {2, 3, 5}, {1, 2, 5}, {3, 1, 0}, {5, 0, 1}}};
  const auto mesh = make_mesh<Surface_mesh>(combinatorial_mesh);
  const std::vector<double> values = {0, 3, 3, 3, 1, 4};
  for(const double value : {-1., 0., 0.5, 1., 2., 3., 3.5, 4., 5.})
    BOOST_TEST((shape(mesh, {0, 3, 3, 3, value, 4}) != Arcs{{0, 1}}));
  const auto result_map = CGAL::Reeb_graph::make_scalar_map(mesh, values);
  CGAL::Reeb_graph::simplify_field(mesh, CGAL::Reeb_graph::make_scalar_map(mesh, values), 2.5, result_map);
  const std::vector<double> result = values_of(mesh, result_map);
  BOOST_TEST((shape(mesh, result) == Arcs{{0, 1}}));
  BOOST_TEST(result[0] == 0);
  BOOST_TEST(result[1] == 3); // the saddle: only those behind it change
  BOOST_TEST((3 < result[2] && result[2] == result[3] && result[3] < 3 + 2.5 / 1024));
  BOOST_TEST(result[5] == 4);

  // and if there is no room for that
  const std::vector<double> close_values = {0, 3, 3, 3, 1, std::nextafter(3., 4.)};
  const auto close_map = CGAL::Reeb_graph::make_scalar_map(mesh, close_values);
  BOOST_CHECK_EXCEPTION(CGAL::Reeb_graph::simplify_field(mesh, close_map, 2.5, result_map),
                        CGAL::Reeb_graph::Perturbed_ties_error, names_the_way_out);
  const auto contracted = parameters::ties(Ties::CONTRACT);
  BOOST_TEST(CGAL::Reeb_graph::simplify_field(mesh, close_map, 2.5, result_map, contracted) == 2);
}

// Heights that are rounded, as those of scans are.
BOOST_AUTO_TEST_CASE(rounded_heights)
{
  for(const int digits : {1, 2, 3})
    BOOST_TEST_CONTEXT("digits " << digits)
    {
      Random random(static_cast<std::size_t>(digits));
      const auto soup = generated_surfaces::closed_surface(2, 20000);
      const auto mesh = make_mesh<Surface_mesh>(soup);
      const double unit = std::pow(10., -digits);
      std::vector<double> values;
      for(const auto& p : soup.points)
        values.push_back(unit * std::round((p[2] + 0.1 * static_cast<double>(random.below(1000)) / 1000) / unit));
      const auto graph = graph_checks::compute(mesh, values);
      graph_checks::Graph_of<Surface_mesh> simplified;
      CGAL::Reeb_graph::simplify(graph, 0.15, simplified);
      const auto scalar_map = CGAL::Reeb_graph::make_scalar_map(mesh, values);
      BOOST_TEST(CGAL::Reeb_graph::simplify_field(mesh, scalar_map, 0.15, scalar_map) < 0.15);
      BOOST_TEST(number_of_leaves(graph_checks::compute(mesh, values_of(mesh, scalar_map)))
                 == number_of_leaves(simplified));
    }
}

// Heights of a landscape with holes that are levels: where many of them are in one removed piece, moving it next to its
// saddle mostly makes loops. That is told in near-linear time, and contracted ties have a field.
BOOST_AUTO_TEST_CASE(many_holes_in_one_piece)
{
  for(const std::size_t side : {40, 80, 160})
    BOOST_TEST_CONTEXT("side " << side)
    {
      const auto mesh = make_mesh<Surface_mesh>(terrain_with_holes(side));
      std::vector<double> values;
      for(const auto v : vertices(mesh))
        values.push_back(mesh.point(v)[2]);
      const auto scalar_map = CGAL::Reeb_graph::make_scalar_map(mesh, values);
      CGAL::Reeb_graph::make_borders_level(mesh, scalar_map);
      std::vector<double> result = values;
      const auto result_map = CGAL::Reeb_graph::make_scalar_map(mesh, result);
      Settings settings;
      settings.ties = Ties::CONTRACT;
      const double threshold = 0.09;

      const double graph_seconds = cpu_seconds([&] { compute<CGAL::Sequential_tag>(mesh, scalar_map, settings); });
      const double perturbed_seconds = cpu_seconds([&] {
        BOOST_CHECK_EXCEPTION(CGAL::Reeb_graph::simplify_field(mesh, scalar_map, threshold, result_map),
                              CGAL::Reeb_graph::Perturbed_ties_error, names_the_way_out);
      });
      BOOST_TEST(result == values, boost::test_tools::per_element());
      const double contracted_seconds = cpu_seconds([&] {
        const auto contracted = parameters::ties(Ties::CONTRACT);
        BOOST_TEST(CGAL::Reeb_graph::simplify_field(mesh, scalar_map, threshold, result_map, contracted) < threshold);
      });
      BOOST_TEST(perturbed_seconds < 100 * graph_seconds);
      BOOST_TEST(contracted_seconds < 100 * graph_seconds);

      graph_checks::Graph_of<Surface_mesh> simplified;
      CGAL::Reeb_graph::simplify(compute<CGAL::Sequential_tag>(mesh, scalar_map, settings), threshold, simplified);
      const auto graph = compute<CGAL::Sequential_tag>(mesh, result_map, settings);
      BOOST_TEST((persistence_oracle::arcs_of(graph) == persistence_oracle::arcs_of(simplified)));
      BOOST_TEST(sorted_values(graph) == sorted_values(simplified), boost::test_tools::per_element());
    }
}

BOOST_AUTO_TEST_CASE(infinite_values_that_are_tied)
{
  const auto mesh = make_mesh<Surface_mesh>(Field_sample(Mesh_class::CLOSED, Field_class::PERMUTATION, 1).mesh);
  const double infinity = std::numeric_limits<double>::infinity();
  for(std::size_t seed = 0; seed < 200; ++seed)
    BOOST_TEST_CONTEXT("seed " << seed)
    {
      Random random(seed);
      std::vector<double> values;
      for(std::size_t i = 0; i < num_vertices(mesh); ++i)
        values.push_back(random.below(2) == 0 ? -infinity : infinity);
      const auto scalar_map = CGAL::Reeb_graph::make_scalar_map(mesh, values);
      try
      {
        CGAL::Reeb_graph::simplify_field(mesh, scalar_map, 1, scalar_map);
        for(const double value : values_of(mesh, scalar_map))
          BOOST_TEST(!std::isnan(value));
      }
      catch(const CGAL::Reeb_graph::Error&)
      {
        BOOST_TEST(values_of(mesh, scalar_map) == values, boost::test_tools::per_element());
      }
    }
}

// Noise of 5 percent of the range and a threshold of 11 percent: the graph is that of the field without noise. The mesh
// is so fine that noise does not exchange the saddles of neighboring loops.
BOOST_AUTO_TEST_CASE(noise_is_removed)
{
  for(unsigned genus = 0; genus <= 10; ++genus)
    for(const std::size_t seed : {1, 2})
      BOOST_TEST_CONTEXT("genus " << genus << ", seed " << seed)
      {
        Random random(seed);
        const auto soup = generated_surfaces::closed_surface(genus, 30000);
        const auto mesh = make_mesh<Surface_mesh>(soup);
        std::vector<double> smooth, noisy;
        for(const auto& p : soup.points)
          smooth.push_back(0.9 * p[0] + 0.4 * p[1] + 0.15 * p[2]);
        const auto range = std::minmax_element(smooth.begin(), smooth.end());
        const double noise = 0.05 * (*range.second - *range.first);
        for(const double value : smooth)
          noisy.push_back(value + noise * (static_cast<double>(random.below(2000001)) / 1000000 - 1));
        const auto noisy_range = std::minmax_element(noisy.begin(), noisy.end());
        const double threshold = 0.11 * (*noisy_range.second - *noisy_range.first);

        const auto graph = graph_checks::compute(mesh, noisy);
        graph_checks::Graph_of<Surface_mesh> simplified;
        CGAL::Reeb_graph::simplify(graph, threshold, simplified);
        BOOST_TEST(num_vertices(graph) > 20 * num_vertices(simplified));
        BOOST_TEST((persistence_oracle::arcs_of(simplified) == shape(mesh, smooth)));

        const auto result_map = CGAL::Reeb_graph::make_scalar_map(mesh, noisy);
        const double change =
          CGAL::Reeb_graph::simplify_field(mesh, CGAL::Reeb_graph::make_scalar_map(mesh, noisy), threshold, result_map);
        BOOST_TEST(change < threshold);
        BOOST_TEST((shape(mesh, values_of(mesh, result_map)) == shape(mesh, smooth)));
      }
}

// On a coarser mesh, noise exchanges saddles of neighboring loops. Removing leaves changes no loop: so the graph
// without noise is found exactly if both graphs are the same when all leaves have been removed that can be.
BOOST_AUTO_TEST_CASE(noise_that_exchanges_loops)
{
  std::size_t number_of_other_graphs = 0;
  const auto soup = generated_surfaces::closed_surface(8, 8000);
  const auto mesh = make_mesh<Surface_mesh>(soup);
  std::vector<double> smooth;
  for(const auto& p : soup.points)
    smooth.push_back(0.9 * p[0] + 0.4 * p[1] + 0.15 * p[2]);
  const auto range = std::minmax_element(smooth.begin(), smooth.end());
  const double noise = 0.05 * (*range.second - *range.first);
  const auto arcs_of_simplified = [](const auto& graph, double threshold) {
    graph_checks::Graph_of<Surface_mesh> simplified;
    CGAL::Reeb_graph::simplify(graph, threshold, simplified);
    return persistence_oracle::arcs_of(simplified);
  };
  const auto smooth_graph = graph_checks::compute(mesh, smooth);
  for(std::size_t seed = 1; seed <= 10; ++seed)
    BOOST_TEST_CONTEXT("seed " << seed)
    {
      Random random(seed);
      std::vector<double> noisy;
      for(const double value : smooth)
        noisy.push_back(value + noise * (static_cast<double>(random.below(2000001)) / 1000000 - 1));
      const auto graph = graph_checks::compute(mesh, noisy);
      const double infinity = std::numeric_limits<double>::infinity();
      const bool is_found = arcs_of_simplified(graph, 2.2 * noise) == persistence_oracle::arcs_of(smooth_graph);
      BOOST_TEST(is_found == (arcs_of_simplified(graph, infinity) == arcs_of_simplified(smooth_graph, infinity)));
      number_of_other_graphs += is_found ? 0 : 1;
    }
  BOOST_TEST(number_of_other_graphs > 0u);
  BOOST_TEST(number_of_other_graphs < 6u);
}

// Where most of the noise stays, the saddle that is left in a piece must not pass the nodes nearby.
BOOST_AUTO_TEST_CASE(noise_is_removed_in_part)
{
  for(std::size_t seed = 0; seed < 24; ++seed)
    BOOST_TEST_CONTEXT("seed " << seed)
    {
      Random random(seed);
      const auto soup = generated_surfaces::closed_surface(3, 20000);
      const auto mesh = make_mesh<Surface_mesh>(soup);
      std::vector<double> values;
      for(const auto& p : soup.points)
        values.push_back(p[0] + 0.2 * (static_cast<double>(random.below(2000001)) / 1000000 - 1));
      const auto scalar_map = CGAL::Reeb_graph::make_scalar_map(mesh, values);
      const double threshold = 0.1 + 0.05 * static_cast<double>(seed % 5);
      BOOST_TEST(CGAL::Reeb_graph::simplify_field(mesh, scalar_map, threshold, scalar_map) < threshold);
    }
}

BOOST_AUTO_TEST_CASE(bad_input)
{
  using namespace CGAL::Reeb_graph;
  const Field_sample sample(Mesh_class::CLOSED, Field_class::PERMUTATION, 1);
  const auto mesh = make_mesh<Surface_mesh>(sample.mesh);
  auto values = sample.values;
  const auto scalar_map = make_scalar_map(mesh, values);
  BOOST_CHECK_THROW(simplify_field(mesh, scalar_map, -1, scalar_map), Parameter_error);
  BOOST_CHECK_THROW(simplify_field(mesh, scalar_map, std::nan(""), scalar_map), Parameter_error);
  BOOST_CHECK_THROW(simplify_field(mesh, scalar_map, 1, scalar_map, parameters::cancel_loops(true)), Parameter_error);
  BOOST_TEST(values == sample.values, boost::test_tools::per_element());
  BOOST_TEST(simplify_field(mesh, scalar_map, 0, scalar_map, parameters::cancel_loops(false)) == 0);
  values[0] = std::nan("");
  BOOST_CHECK_THROW(simplify_field(mesh, make_scalar_map(mesh, values), 1, scalar_map), Unordered_scalar_error);
  BOOST_TEST(simplify_field(mesh, scalar_map, 0, scalar_map) == 0);
}

BOOST_AUTO_TEST_SUITE_END()
