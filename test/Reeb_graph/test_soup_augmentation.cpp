// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of the CGAL-style package Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#include <boost/test/unit_test.hpp>

#include "complex_oracle.h"
#include "generated_surfaces/generated_complexes.h"
#include "generated_surfaces/mesh_builders.h"
#include "generated_surfaces/random_meshes.h"
#include "random_complexes.h"
#include "random_fields.h"
#include "soup_augmentation_checks.h"

#include <CGAL/Reeb_graph/Augmentation.h>
#include <CGAL/Reeb_graph/IO.h>
#include <CGAL/Reeb_graph/IO/svg.h>
#include <CGAL/Reeb_graph/Soup_augmentation.h>
#include <CGAL/Reeb_graph/Tetrahedra_augmentation.h>
#include <CGAL/Reeb_graph/embed.h>
#include <CGAL/Reeb_graph/embed_complex.h>
#include <CGAL/Reeb_graph/graph_topology.h>
#include <CGAL/Reeb_graph/scalar_maps.h>
#include <CGAL/Reeb_graph/simplification/persistence_pairs.h>
#include <CGAL/Reeb_graph/simplification/simplify.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/compute_reeb_graph_of_soup.h>

#include <boost/property_map/property_map.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <iterator>
#include <limits>
#include <memory>
#include <set>
#include <sstream>
#include <string>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

// From the graph of any complex back to it: contours, critical sets and locations against the oracle.

BOOST_AUTO_TEST_SUITE(test_soup_augmentation)

using namespace soup_augmentation_checks;
using CGAL::Reeb_graph::Soup_augmentation;
using CGAL::Reeb_graph::Tetrahedra_augmentation;
using CGAL::Reeb_graph::Ties;
using random_complexes::Complex;
using random_complexes::Complex_class;
using random_meshes::Random;

namespace {
typedef CGAL::Simple_cartesian<double> Kernel;
typedef Kernel::Point_3 Point;
typedef CGAL::Reeb_graph_soup_traits<double>::Graph Graph;
typedef boost::graph_traits<Graph>::edge_descriptor arc_descriptor;

std::vector<Point> make_points(const std::vector<std::array<double, 3>>& coordinates)
{
  std::vector<Point> points;
  for(const auto& p : coordinates)
    points.emplace_back(p[0], p[1], p[2]);
  return points;
}

// Whether the sequences are the same, forwards or backwards, and if they are closed, from another point on.
bool is_turned(std::vector<Point> a, const std::vector<Point>& b, bool is_closed)
{
  for(const bool is_reversed : {false, true})
  {
    for(std::size_t i = 0; i < (is_closed ? a.size() : 1); ++i)
    {
      if(a == b)
        return true;
      if(is_closed)
        std::rotate(a.begin(), a.begin() + 1, a.end());
    }
    if(!is_reversed)
      std::reverse(a.begin(), a.end());
  }
  return false;
}

// Whether a point is in a triangle or a tetrahedron, but for rounding.
bool is_in_a_simplex(const Point& point, const std::vector<Point>& points, const Complex& complex)
{
  for(const auto& t : complex.triangles)
    if(CGAL::squared_distance(point, Kernel::Triangle_3(points[t[0]], points[t[1]], points[t[2]])) < 1e-20)
      return true;
  for(const auto& t : complex.tetrahedra)
  {
    double volumes = 0;
    for(std::size_t i = 0; i < 4; ++i)
    {
      std::array<Point, 4> corners = {points[t[0]], points[t[1]], points[t[2]], points[t[3]]};
      corners[i] = point;
      volumes += std::abs(CGAL::volume(corners[0], corners[1], corners[2], corners[3]));
    }
    if(std::abs(volumes - std::abs(CGAL::volume(points[t[0]], points[t[1]], points[t[2]], points[t[3]]))) < 1e-14)
      return true;
  }
  return false;
}

struct Falling_traits : CGAL::Reeb_graph_soup_traits<int>
{
  typedef std::greater<int> Less_scalar;
  Less_scalar less_scalar_object() const { return Less_scalar(); }
};

template <class Contour>
std::string fault_of_shape(const Soup_augmentation<double>&, const Contour& contour, const Complex& complex)
{
  return fault_of_polylines(contour, different(complex.triangles));
}

template <class Contour>
std::string fault_of_shape(const Tetrahedra_augmentation<double>&, const Contour& contour, const Complex& complex)
{
  return fault_of_patch(contour, different(complex.tetrahedra));
}

// The vertices of each height.
std::vector<std::vector<std::size_t>> vertices_by_height(const Oracle& oracle)
{
  std::vector<std::vector<std::size_t>> result(oracle.number_of_heights());
  for(std::size_t v = 0; v < oracle.heights.size(); ++v)
    result[oracle.heights[v]].push_back(v);
  return result;
}

// The edges of the strip of an arc above a height.
std::vector<std::size_t> strip_of_arc(const Oracle& oracle, std::size_t height, std::size_t oracle_arc)
{
  for(std::size_t edge = 0; edge < oracle.edges.size(); ++edge)
  {
    const std::size_t strip = oracle.strip_of_edge(height, edge);
    if(strip != none && oracle.strips[strip].arc == oracle_arc)
      return oracle.strips[strip].edges;
  }
  return {};
}

template <class Augmentation>
class Augmentation_check
{
public:
  Augmentation_check(const Complex& c, const std::vector<double>& v, const Oracle& o, const Augmentation& a)
    : complex(c),
      values(v),
      oracle(o),
      augmentation(a),
      graph(a.graph()),
      vertices(vertices_by_height(o)),
      arcs(edges(graph).first, edges(graph).second)
  {}

  void run(Ties ties)
  {
    check_topology();
    check_locations(ties);
    for(std::size_t height = 0; height + 1 < oracle.number_of_heights(); ++height)
      check_level(height);
    for(std::size_t i = 0; i < arcs.size(); ++i)
      check_parameters(i);
    for(std::size_t node = 0; node < num_vertices(graph); ++node)
      check_critical_set(node);
  }

  void check_locations(Ties ties)
  {
    const auto fault = complex_oracle::fault_of_arcs(oracle, graph, ties);
    BOOST_REQUIRE(fault.first == "");
    oracle_arcs = fault.second;
    const auto locations = augmentation.locate_vertices();
    for(std::size_t v = 0; v < oracle.heights.size(); ++v)
    {
      const auto& point = oracle.points[oracle.point_of_vertex[v]];
      const auto location = locations[v];
      if(point.node != none)
        BOOST_TEST((location == typename Augmentation::Vertex_locations::Location(point.node)));
      else
      {
        BOOST_REQUIRE(std::holds_alternative<arc_descriptor>(location));
        BOOST_TEST(oracle_arcs[locations.index(v) - num_vertices(graph)] == point.arc);
        BOOST_TEST((std::get<arc_descriptor>(location) == arcs[locations.index(v) - num_vertices(graph)]));
      }
    }
    check_lists(locations);
  }

private:
  void check_topology() const
  {
    BOOST_TEST(CGAL::Reeb_graph::number_of_loops(graph) == oracle.number_of_loops());
    std::vector<typename Augmentation::Contour> contours;
    CGAL::Reeb_graph::loop_contours(graph, augmentation, std::back_inserter(contours));
    BOOST_TEST(contours.size() == oracle.number_of_loops());
    typedef CGAL::Reeb_graph::Persistence_pair<std::size_t> Pair;
    std::vector<Pair> pairs;
    CGAL::Reeb_graph::persistence_pairs(graph, std::back_inserter(pairs));
    const auto number_of_loops = std::count_if(pairs.begin(), pairs.end(), [](const Pair& pair) {
      return pair.kind == CGAL::Reeb_graph::Persistence_pair_kind::LOOP;
    });
    BOOST_TEST(static_cast<std::size_t>(number_of_loops) == oracle.number_of_loops());
  }

  // The contours of all arcs between a height and the next one, by each way to ask for them.
  void check_level(std::size_t height)
  {
    const std::size_t below = vertices[height].front(), above = vertices[height + 1].back();
    const bool is_value = values[below] < values[above];
    const auto all =
      is_value ? augmentation.contours_at_value(values[below]) : std::vector<typename Augmentation::Contour>();
    auto next = all.begin();
    for(std::size_t i = 0; i < arcs.size(); ++i)
    {
      const std::vector<std::size_t> expected = strip_of_arc(oracle, height, oracle_arcs[i]);
      if(expected.empty())
      {
        BOOST_CHECK_THROW(augmentation.contour_above(arcs[i], below), CGAL::Reeb_graph::Level_error);
        BOOST_CHECK_THROW(augmentation.contour_below(arcs[i], above), CGAL::Reeb_graph::Level_error);
        if(is_value)
          BOOST_CHECK_THROW(augmentation.contour_at_value(arcs[i], values[below]), CGAL::Reeb_graph::Level_error);
        continue;
      }
      const auto contour = augmentation.contour_above(arcs[i], below);
      check_contour(contour, i, expected);
      BOOST_TEST(edges_of(oracle, augmentation.contour_below(arcs[i], above)) == expected);
      if(is_value)
      {
        BOOST_TEST(edges_of(oracle, augmentation.contour_at_value(arcs[i], values[below])) == expected);
        BOOST_REQUIRE((next != all.end()));
        BOOST_TEST((next->arc == arcs[i]));
        BOOST_TEST(edges_of(oracle, *next++) == expected);
      }
    }
    BOOST_TEST((next == all.end()));
  }

  void check_contour(const typename Augmentation::Contour& contour,
                     std::size_t arc,
                     const std::vector<std::size_t>& expected)
  {
    BOOST_TEST((contour.arc == arcs[arc]));
    BOOST_TEST(edges_of(oracle, contour) == expected);
    const auto& chain = graph[arcs[arc]].chain;
    BOOST_TEST((std::find(chain.begin(), chain.end(), contour.edges.front()) != chain.end()));
    BOOST_TEST(fault_of_points(oracle, contour, values) == "");
    BOOST_TEST(fault_of_shape(augmentation, contour, complex) == "");
  }

  void check_parameters(std::size_t i)
  {
    const double lower = values[graph[source(arcs[i], graph)].vertex],
                 upper = values[graph[target(arcs[i], graph)].vertex];
    const auto parametrization =
      boost::make_iterator_property_map(values.begin(), boost::typed_identity_property_map<std::size_t>());
    for(const double t : {0.01, 0.5, 0.99})
      for(const auto& contour : {augmentation.contour(arcs[i], t), augmentation.contour(arcs[i], t, parametrization)})
      {
        std::vector<std::size_t> expected;
        for(std::size_t height = 0; height + 1 < oracle.number_of_heights() && expected != edges_of(oracle, contour);
            ++height)
          expected = strip_of_arc(oracle, height, oracle_arcs[i]);
        check_contour(contour, i, expected);
        BOOST_TEST(contour.value >= lower);
        BOOST_TEST(contour.value <= upper);
      }
    for(const double t : {0., 1., -1., std::nan("")})
      BOOST_CHECK_THROW(augmentation.contour(arcs[i], t), CGAL::Reeb_graph::Parameter_error);
  }

  void check_critical_set(std::size_t node)
  {
    const auto set = augmentation.critical_set(node);
    const auto& point = oracle.points[oracle.nodes[node]];
    const auto check_contours = [&](const auto& contours, const std::vector<std::size_t>& strips) {
      std::set<std::vector<std::size_t>> found, expected;
      for(const auto& contour : contours)
        found.insert(edges_of(oracle, contour));
      for(const std::size_t strip : strips)
        expected.insert(oracle.strips[strip].edges);
      BOOST_TEST(contours.size() == strips.size());
      BOOST_TEST((found == expected));
    };
    check_contours(set.lower_contours, point.strips_below);
    check_contours(set.upper_contours, point.strips_above);
    std::vector<std::size_t> star;
    const auto add = [&](const auto& cells) {
      for(std::size_t i = 0; i < cells.size(); ++i)
        if(std::find(cells[i].begin(), cells[i].end(), graph[node].vertex) != cells[i].end())
          star.push_back(i);
    };
    add(complex.triangles);
    add(complex.tetrahedra);
    BOOST_TEST(set.star == star);
  }

  void check_lists(const typename Augmentation::Vertex_locations& locations)
  {
    std::size_t number_of_vertices = 0;
    for(std::size_t i = 0; i < arcs.size(); ++i)
      for(const std::size_t v : locations.vertices_of_arc(i))
      {
        BOOST_TEST(locations.index(v) == num_vertices(graph) + i);
        ++number_of_vertices;
      }
    for(std::size_t node = 0; node < num_vertices(graph); ++node)
      number_of_vertices += locations.vertices_of_node(node).size();
    BOOST_TEST(number_of_vertices == values.size());
    BOOST_CHECK_THROW(locations[values.size()], CGAL::Reeb_graph::Unknown_vertex_error);
  }

  const Complex& complex;
  const std::vector<double>& values;
  const Oracle& oracle;
  const Augmentation& augmentation;
  const Graph& graph;
  const std::vector<std::vector<std::size_t>> vertices; // by height
  const std::vector<arc_descriptor> arcs;
  std::vector<std::size_t> oracle_arcs;
};

void check_complex(const Complex& complex, const std::vector<double>& values, Ties ties, bool keeps_degree_two_nodes)
{
  namespace parameters = CGAL::parameters;
  const auto np =
    parameters::ties(ties, parameters::keep_degree_two_nodes(keeps_degree_two_nodes, parameters::edges(complex.edges)));
  const Oracle oracle(complex.number_of_vertices, complex.simplices(), values, ties, keeps_degree_two_nodes);
  Graph graph;
  if(complex.tetrahedra.empty())
  {
    CGAL::compute_reeb_graph_of_soup(complex.number_of_vertices, complex.triangles, values, graph, np);
    const Soup_augmentation augmentation(complex.number_of_vertices, complex.triangles, values, graph, np);
    Augmentation_check(complex, values, oracle, augmentation).run(ties);
  }
  else
  {
    CGAL::compute_reeb_graph_of_tetrahedra(complex.number_of_vertices, complex.tetrahedra, values, graph, np);
    const Tetrahedra_augmentation augmentation(complex.number_of_vertices, complex.tetrahedra, values, graph, np);
    Augmentation_check(complex, values, oracle, augmentation).run(ties);
  }
}
} // namespace

BOOST_AUTO_TEST_CASE(the_way_back_to_random_complexes_is_that_of_the_oracle)
{
  constexpr std::size_t number_of_classes = static_cast<std::size_t>(Complex_class::NUMBER_OF_CLASSES);
  for(std::size_t seed = 0; seed < 2000; ++seed)
    BOOST_TEST_CONTEXT("seed " << seed)
    {
      Random random(seed);
      const Complex complex =
        random_complexes::random_complex(static_cast<Complex_class>(seed % number_of_classes), random);
      const std::vector<double> values = random_complexes::random_values(complex.number_of_vertices, random);
      check_complex(complex, values, random.below(2) == 0 ? Ties::PERTURB : Ties::CONTRACT, random.below(2) == 0);
    }
}

// The same points in the same order, but for where a closed curve begins, and for the direction.
BOOST_AUTO_TEST_CASE(contours_of_a_surface_are_those_of_its_soup)
{
  typedef mesh_builders::Surface_mesh Mesh;
  for(std::size_t seed = 0; seed < 200; ++seed)
    BOOST_TEST_CONTEXT("seed " << seed)
    {
      Random random(seed);
      const auto mesh_class =
        static_cast<random_meshes::Mesh_class>(seed % static_cast<int>(random_meshes::Mesh_class::NUMBER_OF_CLASSES));
      const auto combinatorial_mesh = random_meshes::random_mesh(mesh_class, random);
      const auto soup = mesh_builders::make_soup(combinatorial_mesh);
      const auto points = make_points(soup.points);
      const auto values = random_complexes::random_values(points.size(), random);
      const auto np = CGAL::parameters::ties(random.below(2) == 0 ? Ties::PERTURB : Ties::CONTRACT);
      const Mesh mesh = mesh_builders::make_mesh<Mesh>(soup);
      const auto scalar_map = CGAL::Reeb_graph::make_scalar_map(mesh, values);
      CGAL::Reeb_graph_traits<Mesh, std::decay_t<decltype(scalar_map)>>::Graph graph;
      CGAL::compute_reeb_graph(mesh, scalar_map, graph, np);
      const CGAL::Reeb_graph::Augmentation augmentation(mesh, scalar_map, graph, np);
      Graph soup_graph;
      CGAL::compute_reeb_graph_of_soup(points, soup.triangles, values, soup_graph, np);
      const Soup_augmentation soup_augmentation(points, soup.triangles, values, soup_graph, np);
      BOOST_REQUIRE(num_edges(graph) == num_edges(soup_graph));
      auto soup_arc = edges(soup_graph).first;
      for(const auto arc : CGAL::make_range(edges(graph)))
      {
        for(const double t : {0.25, 0.5})
        {
          const auto contour = augmentation.contour(arc, t);
          const auto soup_contour = soup_augmentation.contour(*soup_arc, t);
          std::vector<Point> expected, found;
          augmentation.points_of_contour(contour, std::back_inserter(expected));
          soup_augmentation.points_of_contour(soup_contour, std::back_inserter(found), points);
          BOOST_TEST(soup_contour.value == contour.value);
          BOOST_TEST(soup_contour.branch_points.empty());
          const auto polylines = CGAL::Reeb_graph::polylines_of_contour(soup_contour, points);
          BOOST_REQUIRE(polylines.size() == 1);
          BOOST_TEST((soup_contour.polylines[0].front() == soup_contour.polylines[0].back()) == contour.is_closed);
          const std::vector<Point> ordered(polylines[0].begin() + (contour.is_closed ? 1 : 0), polylines[0].end());
          BOOST_TEST(is_turned(ordered, expected, contour.is_closed));
          std::sort(found.begin(), found.end());
          std::sort(expected.begin(), expected.end());
          BOOST_TEST((found == expected));
        }
        ++soup_arc;
      }
    }
}

// In a 3-manifold, each contour is an oriented 2-manifold, however the tetrahedra are listed; its triangles point
// upwards if there are points.
BOOST_AUTO_TEST_CASE(contours_in_a_solid_are_oriented_manifolds)
{
  for(std::size_t seed = 0; seed < 12; ++seed)
    BOOST_TEST_CONTEXT("seed " << seed)
    {
      Random random(seed);
      auto solid = generated_surfaces::solid(5, 1 + seed % 2);
      for(auto& tetrahedron : solid.tetrahedra)
        for(std::size_t i = 4; i > 1; --i)
          std::swap(tetrahedron[i - 1], tetrahedron[random.below(i)]);
      random.shuffle(solid.tetrahedra);
      const auto points = make_points(solid.points);
      const bool is_linear = seed % 3 == 0;
      const auto& field =
        seed % 3 == 2 ? generated_surfaces::noise_field(solid.points) : generated_surfaces::smooth_field(solid.points);
      std::vector<double> values;
      for(std::size_t v = 0; v < points.size(); ++v)
        values.push_back(is_linear ? points[v].x() + 2 * points[v].y() + 3 * points[v].z() : field[v]);
      Graph graph;
      CGAL::compute_reeb_graph_of_tetrahedra(points, solid.tetrahedra, values, graph);
      const Tetrahedra_augmentation augmentation(points, solid.tetrahedra, values, graph);
      const Tetrahedra_augmentation without_points(points.size(), solid.tetrahedra, values, graph);
      for(const auto arc : CGAL::make_range(edges(graph)))
      {
        const auto patch = augmentation.contour(arc, 0.3), other = without_points.contour(arc, 0.3);
        BOOST_TEST(is_oriented_manifold(patch));
        BOOST_TEST(is_oriented_manifold(other));
        BOOST_TEST(other.edges == patch.edges);
        std::vector<Point> patch_points;
        augmentation.points_of_contour(patch, std::back_inserter(patch_points), points);
        for(const auto& t : patch.triangles)
        {
          const auto normal = CGAL::normal(patch_points[t[0]], patch_points[t[1]], patch_points[t[2]]);
          BOOST_TEST((!is_linear || normal * Kernel::Vector_3(1, 2, 3) > 0));
        }
      }
    }
}

// The projective plane times an interval is a 3-manifold that has no orientation, nor have its level sets; triangles
// are there all the same.
BOOST_AUTO_TEST_CASE(contours_without_orientation)
{
  const Complex plane = random_complexes::projective_plane();
  Complex complex = {12};
  std::vector<double> values;
  for(std::size_t v = 0; v < 12; ++v)
    values.push_back(v < 6 ? 0. : 1.);
  for(auto t : plane.triangles)
  {
    std::sort(t.begin(), t.end());
    complex.tetrahedra.push_back({t[0], t[1], t[2], t[2] + 6});
    complex.tetrahedra.push_back({t[0], t[1], t[1] + 6, t[2] + 6});
    complex.tetrahedra.push_back({t[0], t[0] + 6, t[1] + 6, t[2] + 6});
  }
  Graph graph;
  const auto np = CGAL::parameters::ties(Ties::CONTRACT);
  CGAL::compute_reeb_graph_of_tetrahedra(12, complex.tetrahedra, values, graph, np);
  BOOST_REQUIRE(num_edges(graph) == 1);
  const Tetrahedra_augmentation augmentation(12, complex.tetrahedra, values, graph, np);
  const auto patch = augmentation.contour(*edges(graph).first, 0.5);
  BOOST_TEST(fault_of_patch(patch, different(complex.tetrahedra)) == "");
  std::set<Edge> sides;
  for(const auto& t : patch.triangles)
    for(std::size_t i = 0; i < 3; ++i)
      sides.insert(complex_oracle::make_edge(t[i], t[(i + 1) % 3]));
  BOOST_TEST(patch.edges.size() + patch.triangles.size() == sides.size() + 1);
  BOOST_TEST(2 * sides.size() == 3 * patch.triangles.size());
  BOOST_TEST(!is_oriented_manifold(patch));
}

BOOST_AUTO_TEST_CASE(graphs_and_arguments_that_do_not_fit)
{
  using namespace CGAL::Reeb_graph;
  namespace parameters = CGAL::parameters;
  const Complex complex = random_complexes::sphere_with_wall();
  const std::vector<double> values = {0, 1, 2, 3, 4};
  Graph graph, other_graph;
  CGAL::compute_reeb_graph_of_soup(5, complex.triangles, values, graph);
  const auto augment = [&](std::size_t size, const auto& triangles, const std::vector<double>& scalars, const Graph& of,
                           const auto& np) {
    const Soup_augmentation augmentation(size, triangles, scalars, of, np);
    return augmentation.locate_vertices();
  };
  const auto np = parameters::default_values();
  augment(5, complex.triangles, values, graph, np);

  // another number of vertices, other values, another soup
  BOOST_CHECK_THROW(augment(6, complex.triangles, values, graph, np), Scalar_count_error);
  BOOST_CHECK_THROW(augment(5, complex.triangles, {0, 1, 2, 3, 5}, graph, np), Graph_mismatch_error);
  BOOST_CHECK_THROW(augment(5, random_complexes::book(2, 3).triangles, values, graph, np), Graph_mismatch_error);
  BOOST_CHECK_THROW(augment(5, complex.triangles, values, Graph(), np), Graph_mismatch_error);
  BOOST_CHECK_THROW(augment(5, complex.triangles, {0, 1, 2, std::nan(""), 4}, graph, np), Unordered_scalar_error);
  BOOST_CHECK_THROW(augment(5, std::vector<std::vector<int>>{{0, 1, 2, 3}}, values, graph, np),
                    Non_triangular_face_error);
  BOOST_CHECK_THROW(augment(5, std::vector<std::vector<int>>{{0, 1, 5}}, values, graph, np), Vertex_out_of_range_error);
  BOOST_CHECK_THROW(augment(5, std::vector<std::vector<int>>{{0, 1, -1}}, values, graph, np),
                    Vertex_out_of_range_error);
  BOOST_CHECK_THROW(augment(5, std::vector<std::vector<int>>{{0, 1, 0}}, values, graph, np), Degenerate_face_error);
  BOOST_CHECK_THROW(Tetrahedra_augmentation(5, complex.triangles, values, graph), Non_tetrahedral_cell_error);
  for(const std::vector<int>& edge : {std::vector<int>{2}, std::vector<int>{0, 1, 2}, std::vector<int>{2, 2}})
  {
    const std::vector<std::vector<int>> edges = {{0, 1}, edge};
    BOOST_CHECK_EXCEPTION(augment(5, complex.triangles, values, graph, parameters::edges(edges)), Degenerate_edge_error,
                          [](const auto& error) {
                            return error.edge() == 1
                                && std::string(error.what()).find("edge 1 has not two different vertices")
                                     != std::string::npos;
                          });
  }

  // the ties of another graph
  const std::vector<double> tied_values = {1, 1, 1, 1, 1};
  CGAL::compute_reeb_graph_of_soup(5, complex.triangles, tied_values, other_graph);
  BOOST_CHECK_THROW(augment(5, complex.triangles, tied_values, other_graph, parameters::ties(Ties::CONTRACT)),
                    Graph_mismatch_error);

  // a chain of another soup, and the end of one that is no vertex
  Graph broken = graph;
  const Soup_augmentation augmentation(5, complex.triangles, values, graph),
    of_broken(5, complex.triangles, values, broken);
  const arc_descriptor arc = *edges(graph).first, broken_arc = *edges(broken).first;
  for(const Edge& edge : {Edge(0, 4), Edge(0, 9), Edge(9, 4)})
  {
    broken[broken_arc].chain = {std::make_shared<const std::vector<Edge>>(1, edge), 0, 1};
    BOOST_CHECK_THROW(of_broken.contour(broken_arc, 0.5), Graph_mismatch_error);
  }

  // what the graph and the soup do not have
  BOOST_CHECK_THROW(augmentation.contour(broken_arc, 0.5), Unknown_arc_error);
  BOOST_CHECK_THROW(augmentation.contour_above(arc, 5), Unknown_vertex_error);
  BOOST_CHECK_THROW(augmentation.contour_below(arc, std::size_t(1) << 32), Unknown_vertex_error);
  BOOST_CHECK_THROW(augmentation.value(5), Unknown_vertex_error);
  BOOST_CHECK_THROW(augmentation.critical_set(num_vertices(graph)), Unknown_node_error);
  BOOST_CHECK_THROW(augmentation.contour_at_value(arc, -1), Level_error);
  BOOST_CHECK_THROW(augmentation.contour_at_value(arc, 4), Level_error);
  const std::vector<double> infinite(5, std::numeric_limits<double>::infinity());
  BOOST_CHECK_THROW(
    augmentation.contour(
      arc, 0.5, boost::make_iterator_property_map(infinite.begin(), boost::typed_identity_property_map<std::size_t>())),
    Non_finite_scalar_error);
  static_assert(!std::is_constructible_v<Soup_augmentation<double>, int, std::vector<std::array<int, 3>>,
                                         std::vector<double>, Graph&&>,
                "The graph is not copied.");
}

// The graph of the user's order, upside down, has the same contours.
BOOST_AUTO_TEST_CASE(the_order_of_the_traits_class)
{
  for(std::size_t seed = 0; seed < 100; ++seed)
    BOOST_TEST_CONTEXT("seed " << seed)
    {
      Random random(seed);
      const Complex complex =
        random_complexes::random_complex(seed % 2 == 0 ? Complex_class::BOOK : Complex_class::WALLED, random);
      const auto permutation = random_meshes::random_permutation(complex.number_of_vertices, random);
      std::vector<int> values, negative_values;
      for(const double value : permutation)
      {
        values.push_back(static_cast<int>(value));
        negative_values.push_back(-values.back());
      }
      typedef CGAL::Reeb_graph_soup_traits<int>::Graph Integer_graph;
      Integer_graph falling, rising;
      const auto np = CGAL::parameters::geom_traits(Falling_traits());
      CGAL::compute_reeb_graph_of_soup(values.size(), complex.triangles, values, falling, np);
      CGAL::compute_reeb_graph_of_soup(values.size(), complex.triangles, negative_values, rising);
      const Soup_augmentation of_falling(values.size(), complex.triangles, values, falling, np);
      const Soup_augmentation of_rising(values.size(), complex.triangles, negative_values, rising);
      static_assert(std::is_same_v<decltype(of_falling), const Soup_augmentation<int, Integer_graph, Falling_traits>>);
      BOOST_REQUIRE(num_edges(falling) == num_edges(rising));
      auto arc = edges(rising).first;
      for(const auto falling_arc : CGAL::make_range(edges(falling)))
      {
        BOOST_TEST(of_falling.contour_above(falling_arc, falling[source(falling_arc, falling)].vertex).edges
                   == of_rising.contour_above(*arc, rising[source(*arc, rising)].vertex).edges);
        ++arc;
      }
    }
}

// Each vertex is where the node or arc is that took up its own.
BOOST_AUTO_TEST_CASE(the_way_back_from_a_simplified_graph)
{
  for(std::size_t seed = 0; seed < 200; ++seed)
    BOOST_TEST_CONTEXT("seed " << seed)
    {
      Random random(seed);
      const Complex complex = random_complexes::random_complex(Complex_class::RANDOM_TRIANGLES, random);
      const auto values = random_meshes::random_permutation(complex.number_of_vertices, random);
      const auto np = CGAL::parameters::edges(complex.edges);
      Graph graph, simplified;
      CGAL::compute_reeb_graph_of_soup(values.size(), complex.triangles, values, graph, np);
      const auto simplification = CGAL::Reeb_graph::simplify(graph, 2, simplified);
      const Soup_augmentation augmentation(values.size(), complex.triangles, values, graph, np);
      const Soup_augmentation of_simplified(values.size(), complex.triangles, values, simplified,
                                            CGAL::parameters::simplification(simplification, np));
      const auto locations = augmentation.locate_vertices(), new_locations = of_simplified.locate_vertices();
      for(std::size_t v = 0; v < values.size(); ++v)
      {
        const std::size_t place = locations.index(v);
        const std::size_t expected = place < num_vertices(graph)
                                     ? simplification.index_of_node(place)
                                     : simplification.index_of_arc(place - num_vertices(graph));
        BOOST_TEST(new_locations.index(v) == expected);
      }
      for(const auto arc : CGAL::make_range(edges(simplified)))
        BOOST_TEST(fault_of_polylines(of_simplified.contour(arc, 0.5), different(complex.triangles)) == "");
      if(num_edges(simplified) != num_edges(graph))
        BOOST_CHECK_THROW(Soup_augmentation(values.size(), complex.triangles, values, simplified, np).locate_vertices(),
                          CGAL::Reeb_graph::Graph_mismatch_error);
    }
}

// Small complexes with many critical vertices are swept. Spreading has to find the same arcs on them.
BOOST_AUTO_TEST_CASE(arcs_spread_to_the_vertices_of_complexes_that_sweeping_gives_them)
{
  for(std::size_t seed = 0; seed < 1000; ++seed)
    BOOST_TEST_CONTEXT("seed " << seed)
    {
      namespace internal = CGAL::Reeb_graph::internal;
      typedef CGAL::Sequential_tag Tag;
      Random random(seed);
      const auto complex_class = static_cast<Complex_class>(seed % static_cast<int>(Complex_class::NUMBER_OF_CLASSES));
      const Complex complex = random_complexes::skeleton(random_complexes::random_complex(complex_class, random));
      const std::size_t size = complex.number_of_vertices;
      const auto values = random_complexes::random_values(size, random);
      const auto np = CGAL::parameters::keep_degree_two_nodes(true, CGAL::parameters::edges(complex.edges));
      Graph graph;
      CGAL::compute_reeb_graph_of_soup(size, complex.triangles, values, graph, np);
      const auto locations = Soup_augmentation(size, complex.triangles, values, graph, np).locate_vertices();

      const CGAL::Reeb_graph_soup_traits<double> traits;
      const auto soup = internal::flatten_triangles(size, complex.triangles, values, traits, np);
      const internal::Vertex_order order(soup.values, traits.less_scalar_object());
      const auto critical_vertices = internal::classify_vertices<Tag>(soup.complex, order);
      const auto arcs = internal::find_arcs<Tag>(soup.complex, order, critical_vertices,
                                                 CGAL::Reeb_graph::Method::CONTOUR_TREES, 1, internal::No_progress());
      internal::Arc_spreading spreading(soup.complex, order, critical_vertices, arcs);
      typename decltype(spreading)::Arc_of_vertex arc_of_vertex;
      BOOST_TEST_REQUIRE(spreading.template find_arcs_of_vertices<Tag>(arc_of_vertex, 1000.));
      const std::vector<arc_descriptor> graph_arcs(edges(graph).first, edges(graph).second);
      for(std::size_t v = 0; v < size; ++v)
      {
        const std::size_t place = locations.index(v);
        const internal::Slab_arc_index arc = arc_of_vertex[internal::Vertex_index(v)];
        BOOST_TEST((arc == internal::no_index) == (place < num_vertices(graph)));
        if(arc == internal::no_index || place < num_vertices(graph))
          continue;
        const Edge first = graph[graph_arcs[place - num_vertices(graph)]].chain.front();
        const auto found = internal::edge_of(arcs[arc].first_step.edge);
        BOOST_TEST((complex_oracle::make_edge(first.first, first.second)
                    == Edge(soup.complex.lower_end(found).number(), soup.complex.higher_end(found).number())));
      }
    }
}

// On large complexes most places are found by spreading the arcs, some along contours.
BOOST_AUTO_TEST_CASE(places_of_vertices_in_large_complexes)
{
  for(std::size_t seed = 0; seed < 9; ++seed)
    BOOST_TEST_CONTEXT("seed " << seed)
    {
      Random random(seed);
      Complex complex;
      std::vector<std::array<double, 3>> points;
      const auto set = [&](const auto& soup) {
        points = soup.points;
        complex.number_of_vertices = points.size();
      };
      if(seed % 3 == 0)
      {
        const auto soup = generated_surfaces::foam(2, 1, 1, 1);
        set(soup);
        complex.triangles = soup.triangles;
      }
      else if(seed % 3 == 1)
      {
        const auto soup = generated_surfaces::book(6, 8);
        set(soup);
        complex.triangles = soup.triangles;
      }
      else
      {
        const auto soup = generated_surfaces::solid(6, 1);
        set(soup);
        complex.tetrahedra = soup.tetrahedra;
      }
      std::vector<double> values = generated_surfaces::smooth_field(points);
      const double noise = 0.002 * static_cast<double>(random.below(30));
      for(double& value : values)
        value += noise * static_cast<double>(random.below(1000)) / 1000;
      const Oracle oracle(complex.number_of_vertices, complex.simplices(), values);
      Graph graph;
      if(complex.tetrahedra.empty())
      {
        CGAL::compute_reeb_graph_of_soup(points.size(), complex.triangles, values, graph);
        const Soup_augmentation augmentation(points.size(), complex.triangles, values, graph);
        Augmentation_check(complex, values, oracle, augmentation).check_locations(Ties::PERTURB);
      }
      else
      {
        CGAL::compute_reeb_graph_of_tetrahedra(points.size(), complex.tetrahedra, values, graph);
        const Tetrahedra_augmentation augmentation(points.size(), complex.tetrahedra, values, graph);
        Augmentation_check(complex, values, oracle, augmentation).check_locations(Ties::PERTURB);
      }
    }
}

// On a field that is linear in space, each point of an embedding has its value.
template <class Augmentation>
void check_embeddings(const Augmentation& augmentation, const std::vector<Point>& points, const Complex& complex)
{
  using CGAL::Reeb_graph::Embedding_manner;
  const Graph& graph = augmentation.graph();
  for(const Embedding_manner manner :
      {Embedding_manner::CENTROIDS, Embedding_manner::ON_SURFACE, Embedding_manner::STRAIGHT})
  {
    const auto embedding = CGAL::Reeb_graph::embed(augmentation, points, CGAL::parameters::embedding_manner(manner));
    BOOST_TEST(embedding.node_points.size() == num_vertices(graph));
    BOOST_REQUIRE(embedding.arc_polylines.size() == num_edges(graph));
    std::size_t i = 0;
    for(const auto arc : CGAL::make_range(edges(graph)))
    {
      const auto& polyline = embedding.arc_polylines[i];
      BOOST_TEST((polyline.front() == embedding.node_points[source(arc, graph)]));
      BOOST_TEST((polyline.back() == embedding.node_points[target(arc, graph)]));
      BOOST_TEST(std::is_sorted(embedding.arc_values[i].begin(), embedding.arc_values[i].end()));
      BOOST_REQUIRE(polyline.size() == embedding.arc_values[i].size());
      for(std::size_t j = 0; j < polyline.size(); ++j)
        BOOST_TEST(std::abs(polyline[j].z() - embedding.arc_values[i][j]) < 1e-12);
      if(manner == Embedding_manner::ON_SURFACE)
        for(std::size_t j = 1; j < polyline.size(); ++j)
          BOOST_TEST(is_in_a_simplex(CGAL::midpoint(polyline[j - 1], polyline[j]), points, complex));
      ++i;
    }
  }
  BOOST_CHECK_THROW(CGAL::Reeb_graph::embed(augmentation, std::vector<Point>(points.size() + 1)),
                    CGAL::Reeb_graph::Attribute_count_error);
  BOOST_CHECK_THROW(
    CGAL::Reeb_graph::embed(augmentation, points, CGAL::parameters::callback([](double) { return false; })),
    CGAL::Reeb_graph::Cancelled_error);
}

BOOST_AUTO_TEST_CASE(graphs_of_soups_and_tetrahedra_in_space)
{
  const auto foam = generated_surfaces::foam(2, 1, 1, 1);
  const auto solid = generated_surfaces::solid(4, 1);
  const auto heights = [](const std::vector<Point>& points) {
    std::vector<double> result;
    for(const Point& point : points)
      result.push_back(point.z());
    return result;
  };
  const auto points = make_points(foam.points), points_of_solid = make_points(solid.points);
  Graph graph, graph_of_solid;
  CGAL::compute_reeb_graph_of_soup(points, foam.triangles, heights(points), graph);
  CGAL::compute_reeb_graph_of_tetrahedra(points_of_solid, solid.tetrahedra, heights(points_of_solid), graph_of_solid);
  check_embeddings(Soup_augmentation(points, foam.triangles, heights(points), graph), points,
                   {points.size(), foam.triangles});
  check_embeddings(Tetrahedra_augmentation(points_of_solid, solid.tetrahedra, heights(points_of_solid), graph_of_solid),
                   points_of_solid, {points_of_solid.size(), {}, {}, solid.tetrahedra});
}

// All writers write of a soup's graph what they write of the graph of the surface.
BOOST_AUTO_TEST_CASE(graphs_of_soups_are_written)
{
  typedef mesh_builders::Surface_mesh Mesh;
  namespace Reeb_graph = CGAL::Reeb_graph;
  Random random(5);
  const auto soup = mesh_builders::make_soup(random_meshes::random_closed_surface(2, 9, random));
  const auto points = make_points(soup.points);
  const auto values = random_meshes::random_permutation(points.size(), random);
  const Mesh mesh = mesh_builders::make_mesh<Mesh>(soup);
  const auto scalar_map = Reeb_graph::make_scalar_map(mesh, values);
  CGAL::Reeb_graph_traits<Mesh, std::decay_t<decltype(scalar_map)>>::Graph graph;
  CGAL::compute_reeb_graph(mesh, scalar_map, graph);
  Graph soup_graph;
  CGAL::compute_reeb_graph_of_soup(points, soup.triangles, values, soup_graph);
  const auto np = CGAL::parameters::embedding_manner(Reeb_graph::Embedding_manner::STRAIGHT);
  const auto embedding = Reeb_graph::embed(Reeb_graph::Augmentation(mesh, scalar_map, graph), np);
  const auto soup_embedding =
    Reeb_graph::embed(Soup_augmentation(points, soup.triangles, values, soup_graph), points, np);

  const auto vertex_index_map = get(boost::vertex_index, mesh);
  const boost::typed_identity_property_map<std::size_t> identity;
  const auto write = [&](const auto& write_one) {
    std::ostringstream out, soup_out;
    write_one(out, graph, embedding, vertex_index_map);
    write_one(soup_out, soup_graph, soup_embedding, identity);
    BOOST_TEST(out.str() == soup_out.str());
    BOOST_TEST(out.str().size() > 100u);
  };
  write([](auto& out, const auto& g, const auto&, const auto& map) { Reeb_graph::write_graphml(out, g, map); });
  write([](auto& out, const auto& g, const auto&, const auto& map) { Reeb_graph::write_graphviz(out, g, map); });
  write([](auto& out, const auto& g, const auto& e, const auto& map) { Reeb_graph::write_nodes_csv(out, g, e, map); });
  write([](auto& out, const auto& g, const auto& e, const auto&) { Reeb_graph::write_arcs_csv(out, g, e); });
  write([](auto& out, const auto& g, const auto& e, const auto& map) { Reeb_graph::write_vtp(out, g, e, map); });
  write([](auto& out, const auto& g, const auto& e, const auto&) { Reeb_graph::write_obj(out, g, e); });
  write([](auto& out, const auto& g, const auto&, const auto& map) {
    Reeb_graph::write_svg(out, g, CGAL::parameters::vertex_index_map(map));
  });
  std::ostringstream json, soup_json;
  Reeb_graph::write_json(json, mesh, graph, embedding, vertex_index_map);
  Reeb_graph::write_json(soup_json, soup_graph, soup_embedding);
  BOOST_TEST(json.str() == soup_json.str());
}

BOOST_AUTO_TEST_SUITE_END()
