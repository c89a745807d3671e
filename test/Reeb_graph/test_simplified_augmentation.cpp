// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#include <boost/test/unit_test.hpp>

#include "computed_graphs.h"
#include "curve_samples.h"
#include "simplification_oracle.h"

#include <CGAL/Reeb_graph/Augmentation.h>
#include <CGAL/Reeb_graph/arc_measures.h>
#include <CGAL/Reeb_graph/curves/segmentation.h>
#include <CGAL/Reeb_graph/simplification/simplify.h>

#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/boost/graph/iterator.h>

#include <boost/mpl/list.hpp>
#include <boost/property_map/function_property_map.hpp>
#include <boost/property_map/property_map.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <limits>
#include <map>
#include <numeric>
#include <set>
#include <utility>
#include <vector>

// The way from a simplified graph to the mesh.

BOOST_AUTO_TEST_SUITE(test_simplified_augmentation)

using namespace computed_graphs;
using curve_samples::Sample;
using mesh_builders::Polyhedron;
using mesh_builders::Surface_mesh;

typedef boost::mpl::list<Surface_mesh, Polyhedron> Meshes;

namespace {
template <class Mesh>
struct Simplified_sample
{
  Simplified_sample(const Sample& sample, std::size_t seed)
    : settings(settings_of_seed(seed)),
      mesh(make_mesh<Mesh>(sample.soup)),
      scalar_map(CGAL::Reeb_graph::make_scalar_map(mesh, sample.values)),
      graph(compute<CGAL::Sequential_tag>(mesh, scalar_map, settings)),
      threshold(static_cast<double>(seed % 13)),
      simplification(CGAL::Reeb_graph::simplify(graph, threshold, simplified))
  {}

  auto parameters_of_simplified() const { return named_parameters(settings).simplification(simplification); }

  typedef graph_checks::Graph_of<Mesh> Graph;
  typedef CGAL::Reeb_graph::Augmentation<Mesh, graph_checks::Scalar_map_of<Mesh>> Augmentation;

  Settings settings;
  Mesh mesh;
  graph_checks::Scalar_map_of<Mesh> scalar_map;
  Graph graph, simplified;
  double threshold;
  CGAL::Reeb_graph::Simplification<Graph> simplification;
};

// The weights of the values of each arc, by its definition: each triangle is cut into thirds, one for each corner. That
// of a node is cut once more, into a part for each arc there.
template <class Mesh, class Graph, class Places>
std::vector<std::vector<std::pair<double, double>>> values_of_arcs(const Mesh& mesh,
                                                                   const graph_checks::Scalar_map_of<Mesh>& scalar_map,
                                                                   const Graph& graph,
                                                                   const Places& places)
{
  std::vector<std::vector<std::pair<double, double>>> weighted_values(num_edges(graph));
  for(const auto f : CGAL::make_range(faces(mesh)))
    for(const auto v : CGAL::vertices_around_face(halfedge(f, mesh), mesh))
    {
      const double third = CGAL::Polygon_mesh_processing::face_area(f, mesh) / 3;
      const std::size_t place = places.index(v);
      std::vector<std::size_t> arcs;
      for(std::size_t i = 0; i < num_edges(graph); ++i)
      {
        const auto arc = *std::next(edges(graph).first, static_cast<std::ptrdiff_t>(i));
        if(place == num_vertices(graph) + i || place == source(arc, graph) || place == target(arc, graph))
          arcs.push_back(i);
      }
      for(const std::size_t arc : arcs)
        weighted_values[arc].emplace_back(get(scalar_map, v), third / static_cast<double>(arcs.size()));
    }
  return weighted_values;
}

template <class Mesh, class Graph, class Places>
void check_mean_values(const Mesh& mesh,
                       const graph_checks::Scalar_map_of<Mesh>& scalar_map,
                       const Graph& graph,
                       const Places& places)
{
  const auto means = CGAL::Reeb_graph::arc_mean_values(mesh, scalar_map, graph, places);
  const auto areas = CGAL::Reeb_graph::arc_areas(mesh, graph, places);
  const auto weighted_values = values_of_arcs(mesh, scalar_map, graph, places);
  BOOST_TEST_REQUIRE(means.size() == num_edges(graph));
  std::size_t i = 0;
  for(const auto arc : CGAL::make_range(edges(graph)))
  {
    const double low = graph[source(arc, graph)].value, high = graph[target(arc, graph)].value;
    double sum = 0, weight = 0, least = (std::numeric_limits<double>::max)(), greatest = -least;
    for(const auto& [value, its_weight] : weighted_values[i])
    {
      sum += value * its_weight;
      weight += its_weight;
      least = (std::min)(least, value);
      greatest = (std::max)(greatest, value);
    }
    const double mean = weight == 0 ? low + (high - low) / 2 : sum / weight;
    if(std::isnan(mean))
      BOOST_TEST((std::isnan(means[i]) || low == high)); // infinite values of both signs
    else if(weight == 0 || std::isinf(mean))
      BOOST_TEST(means[i] == mean);
    else
    {
      BOOST_TEST(std::abs(means[i] - mean) <= 1e-10 * (std::max)(std::abs(least), std::abs(greatest)));
      BOOST_TEST((least <= means[i] && means[i] <= greatest));
    }
    BOOST_TEST(std::abs(areas[i] - weight) <= 1e-10 * weight);
    ++i;
  }
}
} // namespace

// Each vertex is where the node or arc is that took up its own.
BOOST_AUTO_TEST_CASE_TEMPLATE(vertices_are_in_the_place_that_took_them_up, Mesh, Meshes)
{
  for(std::size_t seed = 0; seed < 400; ++seed)
    BOOST_TEST_CONTEXT("seed " << seed)
    {
      const Simplified_sample<Mesh> sample(curve_samples::any_sample(seed), seed);
      typedef typename Simplified_sample<Mesh>::Augmentation Augmentation;
      const Augmentation augmentation(sample.mesh, sample.scalar_map, sample.graph, named_parameters(sample.settings));
      const Augmentation simplified(sample.mesh, sample.scalar_map, sample.simplified,
                                    sample.parameters_of_simplified());
      const auto old_locations = augmentation.locate_vertices(), places = simplified.locate_vertices();
      const auto old_places = boost::make_function_property_map<typename Augmentation::vertex_descriptor>(
        [&](auto v) { return old_locations.index(v); });
      const auto given_locations = simplified.locate_vertices(CGAL::parameters::vertex_place_map(old_places));
      std::size_t number_of_faults = 0, number_of_vertices = 0;
      for(const auto v : vertices(sample.mesh))
      {
        const std::size_t old_place = old_locations.index(v), nodes = num_vertices(sample.graph);
        const std::size_t place = old_place < nodes ? sample.simplification.index_of_node(old_place)
                                                    : sample.simplification.index_of_arc(old_place - nodes);
        number_of_faults += places.index(v) == place && given_locations.index(v) == place ? 0 : 1;
      }
      for(const auto node : CGAL::make_range(vertices(sample.simplified)))
        number_of_vertices += places.vertices_of_node(node).size();
      for(std::size_t arc = 0; arc != num_edges(sample.simplified); ++arc)
        number_of_vertices += places.vertices_of_arc(arc).size();
      BOOST_TEST(number_of_faults == 0u);
      BOOST_TEST(number_of_vertices == num_vertices(sample.mesh));

      const auto counts = CGAL::Reeb_graph::vertex_counts_of_places(sample.mesh, sample.simplified, places);
      BOOST_TEST(std::accumulate(counts.begin(), counts.end(), 0.) == static_cast<double>(num_vertices(sample.mesh)));
      BOOST_TEST(graph_checks::are_arcs_numbered(sample.simplified));
      check_mean_values(sample.mesh, sample.scalar_map, sample.graph, old_locations);
      check_mean_values(sample.mesh, sample.scalar_map, sample.simplified, places);
    }
}

// The means, by the areas, add up to the integral of the field; neither large nor infinite values break a sum.
BOOST_AUTO_TEST_CASE(mean_values_of_arcs)
{
  namespace Reeb_graph = CGAL::Reeb_graph;
  const auto tolerance = boost::test_tools::tolerance(1e-9);
  Sample sample = curve_samples::smooth_sample(2, 2000, 1);
  const auto mesh = make_mesh<Surface_mesh>(sample.soup);
  const auto means_of = [&](const std::vector<double>& values) {
    const auto scalar_map = Reeb_graph::make_scalar_map(mesh, values);
    const auto graph = compute<CGAL::Sequential_tag>(mesh, scalar_map, Settings());
    const auto places = Reeb_graph::Augmentation(mesh, scalar_map, graph).locate_vertices();
    return std::make_pair(Reeb_graph::arc_mean_values(mesh, scalar_map, graph, places),
                          Reeb_graph::arc_areas(mesh, graph, places));
  };
  const auto [means, areas] = means_of(sample.values);
  double integral = 0;
  for(const auto f : faces(mesh))
  {
    double sum = 0;
    for(const auto v : CGAL::vertices_around_face(halfedge(f, mesh), mesh))
      sum += sample.values[v];
    integral += CGAL::Polygon_mesh_processing::face_area(f, mesh) * sum / 3;
  }
  BOOST_TEST(std::inner_product(means.begin(), means.end(), areas.begin(), 0.) == integral, tolerance);

  const auto [least, greatest] = std::minmax_element(sample.values.begin(), sample.values.end());
  const double scale = std::ldexp(1, 1022 - std::ilogb((std::max)(std::abs(*least), std::abs(*greatest))));
  const auto highest = static_cast<std::size_t>(greatest - sample.values.begin());
  std::vector<double> large = sample.values;
  for(double& value : large)
    value *= scale;
  const auto means_of_large = means_of(large).first;
  for(std::size_t i = 0; i < means.size(); ++i)
    BOOST_TEST(means_of_large[i] / scale == means[i], tolerance);
  sample.values[highest] = std::numeric_limits<double>::infinity();
  const auto means_with_infinity = means_of(sample.values).first;
  BOOST_TEST(std::count(means_with_infinity.begin(), means_with_infinity.end(), sample.values[highest]) == 1);
}

// A contour of an arc is one of the arcs that it has been made of.
BOOST_AUTO_TEST_CASE_TEMPLATE(contours_are_those_of_the_branch_kept, Mesh, Meshes)
{
  for(std::size_t seed = 0; seed < 400; ++seed)
    BOOST_TEST_CONTEXT("seed " << seed)
    {
      const Simplified_sample<Mesh> sample(curve_samples::any_sample(seed), seed);
      typedef typename Simplified_sample<Mesh>::Augmentation Augmentation;
      const Augmentation augmentation(sample.mesh, sample.scalar_map, sample.graph, named_parameters(sample.settings));
      const Augmentation simplified(sample.mesh, sample.scalar_map, sample.simplified,
                                    sample.parameters_of_simplified());
      const simplification_oracle::Simplification_oracle oracle(sample.graph, sample.threshold);
      const auto old_arcs = edges(sample.graph);
      std::size_t number = 0;
      for(const auto arc : CGAL::make_range(edges(sample.simplified)))
      {
        const auto& pieces = oracle.arcs[number++].pieces;
        for(const double t : {0.01, 0.3, 0.7, 0.99})
        {
          const auto contour = simplified.contour(arc, t);
          std::size_t number_of_same = 0;
          for(const std::size_t piece : pieces)
          {
            const auto old_arc = *std::next(old_arcs.first, static_cast<std::ptrdiff_t>(piece));
            const auto lower = sample.graph[source(old_arc, sample.graph)].value;
            const auto upper = sample.graph[target(old_arc, sample.graph)].value;
            if(lower <= contour.value && contour.value < upper)
              number_of_same += augmentation.contour_at_value(old_arc, contour.value).edges == contour.edges;
          }
          const bool is_between_values = sample.simplified[source(arc, sample.simplified)].value <= contour.value
                                      && contour.value < sample.simplified[target(arc, sample.simplified)].value;
          const bool is_at_a_node = std::any_of(pieces.begin(), pieces.end(), [&](std::size_t piece) {
            const auto old_arc = *std::next(old_arcs.first, static_cast<std::ptrdiff_t>(piece));
            return sample.graph[source(old_arc, sample.graph)].value == contour.value;
          });
          if(is_between_values && !is_at_a_node)
            BOOST_TEST(number_of_same == 1u);
        }
      }
      for(const auto node : CGAL::make_range(vertices(sample.simplified)))
      {
        const auto critical_set = simplified.critical_set(node);
        BOOST_TEST(critical_set.lower_contours.size() == in_degree(node, sample.simplified));
        BOOST_TEST(critical_set.upper_contours.size() == out_degree(node, sample.simplified));
      }
    }
}

// One connected patch for each arc, and each face in one.
BOOST_AUTO_TEST_CASE_TEMPLATE(patches_of_a_simplified_graph, Mesh, Meshes)
{
  for(std::size_t seed = 0; seed < 400; ++seed)
    BOOST_TEST_CONTEXT("seed " << seed)
    {
      Simplified_sample<Mesh> sample(curve_samples::any_sample(seed), seed);
      std::map<typename boost::graph_traits<Mesh>::face_descriptor, std::size_t> patches;
      const std::size_t number_of_patches =
        CGAL::Reeb_graph::segment_by_arcs(sample.mesh, sample.scalar_map, sample.simplified,
                                          boost::make_assoc_property_map(patches), sample.parameters_of_simplified());
      std::size_t components_without_arc = 0;
      for(const auto node : CGAL::make_range(vertices(sample.simplified)))
        if(degree(node, sample.simplified) == 0
           && halfedge(sample.simplified[node].vertex, sample.mesh) != boost::graph_traits<Mesh>::null_halfedge())
          ++components_without_arc;
      BOOST_TEST(number_of_patches == num_edges(sample.simplified) + components_without_arc);
      BOOST_TEST(patches.size() == num_faces(sample.mesh));
      std::set<std::size_t> numbers;
      for(const auto& patch : patches)
        numbers.insert(patch.second);
      BOOST_TEST(numbers.size() == number_of_patches);
    }
}

BOOST_AUTO_TEST_CASE(simplification_by_area_and_by_number_of_vertices)
{
  const Sample sample = curve_samples::smooth_sample(2, 2000, 1);
  const auto mesh = make_mesh<Surface_mesh>(sample.soup);
  const auto scalar_map = CGAL::Reeb_graph::make_scalar_map(mesh, sample.values);
  const auto graph = compute<CGAL::Sequential_tag>(mesh, scalar_map, Settings());
  const CGAL::Reeb_graph::Augmentation augmentation(mesh, scalar_map, graph);
  const auto places = augmentation.locate_vertices();
  const auto counts = CGAL::Reeb_graph::vertex_counts_of_places(mesh, graph, places);
  const auto areas = CGAL::Reeb_graph::areas_of_places(mesh, graph, places);
  BOOST_TEST(std::accumulate(areas.begin(), areas.end(), 0.) == CGAL::Polygon_mesh_processing::area(mesh),
             boost::test_tools::tolerance(1e-9));
  const auto areas_of_arcs = CGAL::Reeb_graph::arc_areas(mesh, graph, places);
  BOOST_TEST(areas_of_arcs.size() == num_edges(graph));
  BOOST_TEST(std::accumulate(areas_of_arcs.begin(), areas_of_arcs.end(), 0.)
               == CGAL::Polygon_mesh_processing::area(mesh),
             boost::test_tools::tolerance(1e-9));
  const double area = std::accumulate(areas.begin(), areas.end(), 0.);
  std::decay_t<decltype(graph)> by_count, by_area;
  const auto map = CGAL::Reeb_graph::simplify(graph, 50, by_count, CGAL::parameters::place_weights(counts));
  CGAL::Reeb_graph::simplify(graph, area / 40, by_area, CGAL::parameters::place_weights(areas));
  for(const auto* simplified : {&by_count, &by_area})
  {
    BOOST_TEST(num_vertices(*simplified) < num_vertices(graph) / 4);
    BOOST_TEST(num_vertices(*simplified) > 4u);
    BOOST_TEST(num_edges(*simplified) == num_vertices(*simplified) + 1); // genus 2
  }
  // each leaf that is left and that could be removed has as many vertices
  const CGAL::Reeb_graph::Augmentation augmentation_by_count(mesh, scalar_map, by_count,
                                                             CGAL::parameters::simplification(map));
  const auto new_locations = augmentation_by_count.locate_vertices();
  std::size_t number = 0;
  for(const auto arc : CGAL::make_range(edges(by_count)))
  {
    const auto lower = source(arc, by_count), upper = target(arc, by_count);
    for(const auto leaf : {lower, upper})
      if(degree(leaf, by_count) == 1 && (leaf == lower ? in_degree(upper, by_count) : out_degree(lower, by_count)) > 1)
        BOOST_TEST(new_locations.vertices_of_arc(number).size() + new_locations.vertices_of_node(leaf).size() >= 50u);
    ++number;
  }
}

// A height grows no faster than the way on the surface, and the chain ends at most one edge above the arc.
BOOST_AUTO_TEST_CASE(lengths_of_arcs_are_those_of_their_chains)
{
  const Sample sample = curve_samples::smooth_sample(2, 1000, 1);
  const auto mesh = make_mesh<Surface_mesh>(sample.soup);
  const auto scalar_map =
    CGAL::Reeb_graph::make_scalar_map_from_function(mesh, [&mesh](auto v) { return mesh.point(v).x(); });
  CGAL::Reeb_graph_traits<Surface_mesh, std::decay_t<decltype(scalar_map)>>::Graph graph;
  CGAL::compute_reeb_graph(mesh, scalar_map, graph);
  const auto lengths = CGAL::Reeb_graph::arc_lengths(mesh, scalar_map, graph);
  BOOST_TEST_REQUIRE(lengths.size() == num_edges(graph));
  std::size_t number_of_clipped_chains = 0;
  for(const auto arc : CGAL::make_range(edges(graph)))
  {
    const auto& chain = graph[arc].chain;
    const double upper_value = graph[target(arc, graph)].value;
    const double length = lengths[get(boost::edge_index, graph, arc)];
    double chain_length = 0;
    for(const auto h : chain)
      chain_length += CGAL::Polygon_mesh_processing::edge_length(h, mesh);
    const double last = CGAL::Polygon_mesh_processing::edge_length(chain.back(), mesh);
    const double lower_end = get(scalar_map, source(chain.back(), mesh));
    const double upper_end = get(scalar_map, target(chain.back(), mesh));
    BOOST_TEST(length >= upper_value - graph[source(arc, graph)].value - 1e-12);
    BOOST_TEST(chain_length - length == last * (upper_end - upper_value) / (upper_end - lower_end),
               boost::test_tools::tolerance(1e-6));
    number_of_clipped_chains += upper_end > upper_value ? 1 : 0;
  }
  BOOST_TEST(number_of_clipped_chains > 3u);
}

BOOST_AUTO_TEST_CASE(simplifications_of_other_graphs)
{
  const Simplified_sample<Surface_mesh> sample(curve_samples::any_sample(6), 8);
  const Simplified_sample<Surface_mesh> other(curve_samples::any_sample(12), 8);
  typedef Simplified_sample<Surface_mesh>::Augmentation Augmentation;
  BOOST_REQUIRE(num_vertices(sample.simplified) < num_vertices(sample.graph));
  const Augmentation without(sample.mesh, sample.scalar_map, sample.simplified, named_parameters(sample.settings));
  BOOST_CHECK_THROW(without.locate_vertices(), CGAL::Reeb_graph::Graph_mismatch_error);
  const Augmentation with_other(sample.mesh, sample.scalar_map, sample.simplified,
                                CGAL::parameters::simplification(other.simplification));
  BOOST_CHECK_THROW(with_other.locate_vertices(), CGAL::Reeb_graph::Graph_mismatch_error);
}

// Squares of lengths can be too large, or too small.
BOOST_AUTO_TEST_CASE(lengths_and_areas_in_any_unit)
{
  const Sample sample = curve_samples::smooth_sample(2, 300, 1);
  const auto measures = [&](int exponent) {
    auto soup = sample.soup;
    for(auto& point : soup.points)
      for(double& coordinate : point)
        coordinate = std::scalbn(coordinate, exponent);
    const auto mesh = make_mesh<Surface_mesh>(soup);
    const auto scalar_map = CGAL::Reeb_graph::make_scalar_map(mesh, sample.values);
    graph_checks::Graph_of<Surface_mesh> graph;
    CGAL::compute_reeb_graph(mesh, scalar_map, graph);
    const CGAL::Reeb_graph::Augmentation augmentation(mesh, scalar_map, graph);
    auto result = CGAL::Reeb_graph::arc_lengths(mesh, scalar_map, graph);
    for(double& length : result)
      length = std::scalbn(length, -exponent);
    for(const double area : CGAL::Reeb_graph::arc_areas(mesh, graph, augmentation.locate_vertices()))
      result.push_back(std::scalbn(area, -2 * exponent));
    return result;
  };
  const auto expected = measures(0);
  for(const int exponent : {-500, -300, 300, 500})
  {
    const auto found = measures(exponent);
    BOOST_REQUIRE(found.size() == expected.size());
    for(std::size_t i = 0; i != found.size(); ++i)
      BOOST_TEST(std::abs(found[i] - expected[i]) <= 1e-12 * expected[i]);
  }
  for(const int exponent : {-900, 900})
  {
    const auto found = measures(exponent);
    for(std::size_t i = 0; i != found.size() / 2; ++i) // lengths alone: areas are out of range
      BOOST_TEST(std::abs(found[i] - expected[i]) <= 1e-12 * expected[i]);
  }
}

BOOST_AUTO_TEST_SUITE_END()
