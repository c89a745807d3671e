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

#include <CGAL/Reeb_graph/Augmentation.h>
#include <CGAL/Reeb_graph/arc_measures.h>
#include <CGAL/Reeb_graph/curves/Refinement_visitor.h>
#include <CGAL/Reeb_graph/embed.h>
#include <CGAL/Reeb_graph/simplification/simplify.h>

#include <CGAL/Exact_rational.h>
#include <CGAL/Simple_cartesian.h>

#include <boost/mpl/list.hpp>
#include <boost/property_map/function_property_map.hpp>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <fstream>
#include <ios>
#include <iterator>
#include <limits>
#include <locale>
#include <set>
#include <sstream>
#include <streambuf>
#include <string>
#include <system_error>
#include <type_traits>
#include <utility>
#include <vector>

// Graphs in space: where the polylines of arcs are, in each manner.

BOOST_AUTO_TEST_SUITE(test_embedding)

using namespace computed_graphs;
using CGAL::Reeb_graph::embed;
using CGAL::Reeb_graph::Embedding_manner;
using curve_samples::Sample;
using mesh_builders::Point;
using mesh_builders::Polyhedron;
using mesh_builders::Surface_mesh;

typedef boost::mpl::list<Surface_mesh, Polyhedron> Meshes;
typedef boost::mpl::list<int, float, CGAL::Exact_rational> Other_scalars;
typedef CGAL::Simple_cartesian<CGAL::Exact_rational> Exact_kernel;
typedef std::vector<Point> Polyline;

namespace {
// A mesh and its graph, simplified for some seeds.
template <class Mesh_>
struct Embedded_sample
{
  typedef Mesh_ Mesh;
  typedef graph_checks::Scalar_map_of<Mesh> Scalar_map;
  typedef graph_checks::Graph_of<Mesh> Graph;

  explicit Embedded_sample(const Sample& sample, std::size_t seed = 0)
    : settings(settings_of_seed(seed)),
      mesh(make_mesh<Mesh>(sample.soup)),
      scalar_map(CGAL::Reeb_graph::make_scalar_map(mesh, sample.values)),
      graph(compute_graph(seed)),
      augmentation(mesh, scalar_map, graph, named_parameters(settings))
  {}

  auto embedded(Embedding_manner manner) const
  {
    return embed(augmentation, CGAL::parameters::embedding_manner(manner));
  }

  const Settings settings;
  const Mesh mesh;
  const Scalar_map scalar_map;
  const Graph graph;
  const CGAL::Reeb_graph::Augmentation<Mesh, Scalar_map> augmentation;

private:
  Graph compute_graph(std::size_t seed) const
  {
    Graph given = compute<CGAL::Sequential_tag>(mesh, scalar_map, settings), simplified;
    if(seed % 3 != 2)
      return given;
    const double threshold = static_cast<double>(seed % 13);
    if(seed % 2 == 0) // Loops are cancelled in graphs without zero steps only where ties are broken.
      CGAL::Reeb_graph::simplify(given, threshold, simplified, CGAL::parameters::cancel_loops(true));
    else
      CGAL::Reeb_graph::simplify(given, threshold, simplified);
    return simplified;
  }
};

template <class Mesh, class Test>
void for_each_sample(std::size_t number_of_seeds, const Test& test)
{
  for(std::size_t seed = 0; seed < number_of_seeds; ++seed)
    BOOST_TEST_CONTEXT("seed " << seed)
  test(Embedded_sample<Mesh>(curve_samples::any_sample(seed), seed));
}

// What holds in each manner: the ends of polylines, and values that do not fall.
template <class S, class Embedding>
std::string fault_of_ends_and_values(const S& s, const Embedding& embedding)
{
  if(embedding.node_points.size() != num_vertices(s.graph) || embedding.arc_polylines.size() != num_edges(s.graph)
     || embedding.arc_values.size() != num_edges(s.graph))
    return "the numbers are wrong";
  std::size_t i = 0;
  for(const auto arc : CGAL::make_range(edges(s.graph)))
  {
    const auto lower = source(arc, s.graph), upper = target(arc, s.graph);
    const auto& polyline = embedding.arc_polylines[i];
    const auto& values = embedding.arc_values[i++];
    if(polyline.size() < 2 || polyline.size() != values.size())
      return "a polyline has a wrong number of points";
    if(polyline.front() != embedding.node_points[lower] || polyline.back() != embedding.node_points[upper])
      return "a polyline does not end at its nodes";
    if(values.front() != s.graph[lower].value || values.back() != s.graph[upper].value)
      return "a polyline has not the values of its nodes";
    if(!std::is_sorted(values.begin(), values.end()))
      return "values fall";
    for(const auto& point : polyline)
      if(!std::isfinite(point.x()) || !std::isfinite(point.y()) || !std::isfinite(point.z()))
        return "a point is not finite";
  }
  return "";
}

double distance_of(const Point& a, const Point& b) { return std::sqrt(CGAL::squared_distance(a, b)); }

// The triangles that a point lies in the border of, as one with this value.
template <class S>
std::set<typename boost::graph_traits<typename S::Mesh>::face_descriptor> faces_at(const S& s,
                                                                                   const Point& point,
                                                                                   double value)
{
  std::set<typename boost::graph_traits<typename S::Mesh>::face_descriptor> result;
  const auto point_map = get(CGAL::vertex_point, s.mesh);
  for(const auto h : halfedges(s.mesh))
  {
    const auto u = source(h, s.mesh), v = target(h, s.mesh);
    const Point a = get(point_map, u), b = get(point_map, v);
    const double length = distance_of(a, b), t = distance_of(a, point) / length;
    const double value_there = (1 - t) * get(s.scalar_map, u) + t * get(s.scalar_map, v);
    const bool is_value_right = !std::isfinite(value_there) || std::abs(value_there - value) < 1e-6;
    if(t <= 1 + 1e-9 && distance_of(a + t * (b - a), point) < 1e-7 * length && is_value_right)
    {
      for(const auto side : {h, opposite(h, s.mesh)})
        if(!is_border(side, s.mesh))
          result.insert(face(side, s.mesh));
    }
  }
  return result;
}

template <class S, class Embedding>
std::string fault_on_surface(const S& s, const Embedding& embedding)
{
  for(std::size_t i = 0; i < embedding.arc_polylines.size(); ++i)
  {
    auto last = faces_at(s, embedding.arc_polylines[i][0], embedding.arc_values[i][0]);
    for(std::size_t j = 1; j < embedding.arc_polylines[i].size(); ++j)
    {
      const auto next = faces_at(s, embedding.arc_polylines[i][j], embedding.arc_values[i][j]);
      if(std::none_of(next.begin(), next.end(), [&](const auto f) { return last.count(f) != 0; }))
        return "polyline " + std::to_string(i) + " leaves the surface before point " + std::to_string(j);
      last = next;
    }
  }
  return "";
}

template <class Graph>
std::size_t number_of_equal_parallel_arcs(const Graph& graph, const std::vector<Polyline>& polylines)
{
  std::size_t result = 0;
  const std::vector<typename boost::graph_traits<Graph>::edge_descriptor> arcs(edges(graph).first, edges(graph).second);
  for(std::size_t i = 0; i < arcs.size(); ++i)
    for(std::size_t j = 0; j < i; ++j)
      if(source(arcs[i], graph) == source(arcs[j], graph) && target(arcs[i], graph) == target(arcs[j], graph))
        result += polylines[i] == polylines[j];
  return result;
}

// The sum of the squared turns of a polyline: what smoothing makes less.
double roughness(const Polyline& polyline)
{
  double result = 0;
  for(std::size_t i = 1; i + 1 < polyline.size(); ++i)
    result += ((polyline[i + 1] - polyline[i]) - (polyline[i] - polyline[i - 1])).squared_length();
  return result;
}

// A torus of which the circles around the axis z have heights: two round tubes, one inside of the other.
Sample upright_torus()
{
  constexpr std::size_t around = 24, along = 16;
  Sample sample;
  const auto number = [&](std::size_t i, std::size_t j) { return i % around * along + j % along; };
  for(std::size_t i = 0; i < around; ++i)
    for(std::size_t j = 0; j < along; ++j)
    {
      const double a = 2 * CGAL_PI * i / around, b = 2 * CGAL_PI * j / along, radius = 3 + std::cos(b);
      sample.soup.points.push_back({radius * std::cos(a), radius * std::sin(a), std::sin(b)});
      sample.values.push_back(std::sin(b));
      sample.soup.triangles.push_back({number(i, j), number(i + 1, j), number(i + 1, j + 1)});
      sample.soup.triangles.push_back({number(i, j), number(i + 1, j + 1), number(i, j + 1)});
    }
  return sample;
}

Sample with_heights_as_values(Sample sample)
{
  for(std::size_t v = 0; v < sample.values.size(); ++v)
    sample.values[v] = sample.soup.points[v][2];
  return sample;
}
} // namespace

BOOST_AUTO_TEST_CASE_TEMPLATE(polylines_end_at_the_nodes_and_values_do_not_fall, Mesh, Meshes)
{
  for_each_sample<Mesh>(600, [](const auto& s) {
    for(const auto manner : {Embedding_manner::CENTROIDS, Embedding_manner::ON_SURFACE, Embedding_manner::STRAIGHT})
      BOOST_TEST(fault_of_ends_and_values(s, s.embedded(manner)) == "");
  });
}

BOOST_AUTO_TEST_CASE_TEMPLATE(polylines_on_the_surface_stay_there, Mesh, Meshes)
{
  for_each_sample<Mesh>(300, [](const auto& s) {
    const auto embedding = s.embedded(Embedding_manner::ON_SURFACE);
    BOOST_TEST(fault_on_surface(s, embedding) == "");
    for(const auto node : CGAL::make_range(vertices(s.graph)))
      BOOST_TEST(embedding.node_points[node] == get(get(CGAL::vertex_point, s.mesh), s.graph[node].vertex));
  });
}

BOOST_AUTO_TEST_CASE_TEMPLATE(sides_of_a_loop_differ, Mesh, Meshes)
{
  for_each_sample<Mesh>(600, [](const auto& s) {
    for(const auto manner : {Embedding_manner::CENTROIDS, Embedding_manner::ON_SURFACE})
      BOOST_TEST(number_of_equal_parallel_arcs(s.graph, s.embedded(manner).arc_polylines) == 0u);
  });
}

BOOST_AUTO_TEST_CASE(a_tube_inside_of_another_one_has_a_line_of_its_own)
{
  const Embedded_sample<Surface_mesh> s(upright_torus(), 1);
  BOOST_TEST((s.settings.ties == Ties::CONTRACT));
  const auto embedding = s.embedded(Embedding_manner::CENTROIDS);
  BOOST_REQUIRE(embedding.arc_polylines.size() == 2u);
  const std::size_t middle = embedding.arc_polylines[0].size() / 2;
  BOOST_TEST(distance_of(embedding.arc_polylines[0][middle], embedding.arc_polylines[1][middle]) > 0.5);
}

// Twin tubes whose axes are nearly the same: their lines are told apart where they would be one in a picture.
BOOST_AUTO_TEST_CASE(lines_that_are_nearer_than_their_width_are_told_apart)
{
  Sample sample = upright_torus();
  for(auto& point : sample.soup.points)
    if(std::hypot(point[0], point[1]) > 3)
      point[0] += 0.02;
  const Embedded_sample<Surface_mesh> s(sample, 1);
  const auto embedding = s.embedded(Embedding_manner::CENTROIDS);
  BOOST_REQUIRE(embedding.arc_polylines.size() == 2u);
  const std::size_t middle = embedding.arc_polylines[0].size() / 2;
  BOOST_TEST(distance_of(embedding.arc_polylines[0][middle], embedding.arc_polylines[1][middle]) > 0.5);
}

// At equal steps, and beyond the outermost of these at quarters of a step.
BOOST_AUTO_TEST_CASE(contours_at_nodes_are_ever_nearer_to_them)
{
  const Embedded_sample<Surface_mesh> s(with_heights_as_values(curve_samples::smooth_sample(2, 600, 0)));
  const auto embedding =
    CGAL::Reeb_graph::embed(s.augmentation, CGAL::parameters::number_of_contours_at_nodes(2).number_of_contours(3));
  for(std::size_t arc = 0; arc != embedding.arc_values.size(); ++arc)
  {
    const std::vector<double>& values = embedding.arc_values[arc];
    BOOST_REQUIRE(values.size() == 9u);
    const std::size_t lower = source(*std::next(edges(s.graph).first, arc), s.graph);
    const std::size_t upper = target(*std::next(edges(s.graph).first, arc), s.graph);
    const double low = s.graph[lower].value, range = s.graph[upper].value - low;
    const std::array<double, 7> places = {1. / 64, 1. / 16, 0.25, 0.5, 0.75, 15. / 16, 63. / 64};
    for(std::size_t i = 0; i != places.size(); ++i)
      BOOST_TEST(std::abs(values[i + 1] - (low + places[i] * range)) < 1e-9);
  }
}

// The centroid of a contour is as high as the contour.
BOOST_AUTO_TEST_CASE_TEMPLATE(centroids_are_in_the_planes_of_contours, Mesh, Meshes)
{
  for(unsigned genus = 0; genus < 4; ++genus)
    BOOST_TEST_CONTEXT("genus " << genus)
    {
      const Embedded_sample<Mesh> s(with_heights_as_values(curve_samples::smooth_sample(genus, 600, 0)));
      const auto embedding = s.embedded(Embedding_manner::CENTROIDS);
      BOOST_TEST(fault_of_ends_and_values(s, embedding) == "");
      double error = 0;
      for(std::size_t i = 0; i < embedding.arc_polylines.size(); ++i)
        for(std::size_t j = 0; j < embedding.arc_polylines[i].size(); ++j)
          error = (std::max)(error, std::abs(embedding.arc_polylines[i][j].z() - embedding.arc_values[i][j]));
      BOOST_TEST(error < 1e-9);
    }
}

// A minimum or maximum is at its vertex unless another one is tied with it.
BOOST_AUTO_TEST_CASE_TEMPLATE(leaves_are_at_their_vertices, Mesh, Meshes)
{
  std::size_t number_of_leaves = 0;
  for_each_sample<Mesh>(120, [&](const auto& s) {
    const auto embedding = s.embedded(Embedding_manner::CENTROIDS);
    for(const auto node : CGAL::make_range(vertices(s.graph)))
    {
      if((in_degree(node, s.graph) == 0) == (out_degree(node, s.graph) == 0))
        continue;
      const auto v = s.graph[node].vertex;
      const auto around = CGAL::halfedges_around_target(halfedge(v, s.mesh), s.mesh);
      const auto is_tied = [&](const auto h) { return get(s.scalar_map, source(h, s.mesh)) == get(s.scalar_map, v); };
      if(std::any_of(around.begin(), around.end(), is_tied))
        continue;
      ++number_of_leaves;
      BOOST_TEST(embedding.node_points[node] == get(get(CGAL::vertex_point, s.mesh), v));
    }
  });
  BOOST_TEST(number_of_leaves > 100u);
}

// Triangles that are cut into smaller ones do not move a centroid.
BOOST_AUTO_TEST_CASE(centroids_are_those_of_the_lines)
{
  Sample sample;
  sample.soup.points = {{0, 0, 0}, {8, 0, 0}, {0, 8, 0}, {0, 0, 4}};
  sample.soup.triangles = {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}};
  for(const auto& p : sample.soup.points)
    sample.values.push_back(p[2]);
  Sample finer = sample; // One of the edges that contours cross has a triangle more on each of its sides.
  finer.soup.points.push_back({4, 0, 2});
  finer.values.push_back(2);
  finer.soup.triangles = {{0, 2, 1}, {0, 1, 4}, {0, 4, 3}, {1, 2, 4}, {4, 2, 3}, {2, 0, 3}};
  const auto polyline = [](const Sample& given) {
    const auto embedding = Embedded_sample<Surface_mesh>(given, 1).embedded(Embedding_manner::CENTROIDS);
    BOOST_REQUIRE(embedding.arc_polylines.size() == 1u);
    return embedding.arc_polylines[0];
  };
  const Polyline coarse = polyline(sample), fine = polyline(finer);
  BOOST_REQUIRE(coarse.size() == fine.size());
  for(std::size_t i = 1; i + 1 < coarse.size(); ++i)
    BOOST_TEST(distance_of(coarse[i], fine[i]) < 1e-12);
}

BOOST_AUTO_TEST_CASE_TEMPLATE(contours_are_at_equal_steps, Mesh, Meshes)
{
  for_each_sample<Mesh>(60, [](const auto& s) {
    std::vector<double> numbers(num_vertices(s.mesh));
    for(std::size_t v = 0; v < numbers.size(); ++v)
      numbers[v] = static_cast<double>(v * v % 7);
    const auto constant_map = CGAL::Reeb_graph::make_scalar_map(s.mesh, std::vector<double>(numbers.size(), 1));
    const auto other_map = CGAL::Reeb_graph::make_scalar_map(s.mesh, numbers);
    const auto np = CGAL::parameters::number_of_contours(3);
    const auto equal = embed(s.augmentation, np);
    const auto constant = embed(s.augmentation, np.parametrization_map(constant_map));
    const auto other = embed(s.augmentation, np.parametrization_map(other_map));
    BOOST_TEST((constant.arc_values == equal.arc_values));
    std::size_t i = 0;
    for(const auto arc : CGAL::make_range(edges(s.graph)))
    {
      BOOST_REQUIRE(equal.arc_values[i].size() == 5u);
      for(std::size_t j = 1; j <= 3; ++j)
      {
        const double t = static_cast<double>(j) / 4;
        BOOST_TEST(equal.arc_values[i][j] == s.augmentation.contour(arc, t).value);
        BOOST_TEST(other.arc_values[i][j] == s.augmentation.contour(arc, t, other_map).value);
      }
      ++i;
    }
  });
}

BOOST_AUTO_TEST_CASE_TEMPLATE(smoothing_leaves_ends_and_makes_lines_less_rough, Mesh, Meshes)
{
  const Embedded_sample<Mesh> s(curve_samples::smooth_sample(2, 1000, 0));
  const auto rough = s.embedded(Embedding_manner::CENTROIDS);
  const auto smooth = embed(s.augmentation, CGAL::parameters::number_of_smoothing_steps(5));
  BOOST_TEST(fault_of_ends_and_values(s, smooth) == "");
  for(std::size_t i = 0; i < rough.arc_polylines.size(); ++i)
    BOOST_TEST(roughness(smooth.arc_polylines[i]) < roughness(rough.arc_polylines[i]));
  const auto without_contours =
    embed(s.augmentation, CGAL::parameters::number_of_contours(0).number_of_smoothing_steps(1));
  for(const Polyline& polyline : without_contours.arc_polylines)
    BOOST_TEST(polyline.size() == 2u);
}

BOOST_AUTO_TEST_CASE(the_same_in_parallel)
{
  const Embedded_sample<Surface_mesh> s(curve_samples::smooth_sample(2, 3000, 1));
  for(const auto manner : {Embedding_manner::CENTROIDS, Embedding_manner::ON_SURFACE})
  {
    const auto np = CGAL::parameters::embedding_manner(manner);
    const auto parallel = embed<CGAL::Parallel_if_available_tag>(s.augmentation, np),
               sequential = embed(s.augmentation, np);
    BOOST_TEST((parallel.node_points == sequential.node_points));
    BOOST_TEST((parallel.arc_polylines == sequential.arc_polylines));
  }
}

// Values that are no doubles, and points other than those of the mesh.
BOOST_AUTO_TEST_CASE_TEMPLATE(other_scalars_and_points, Scalar, Other_scalars)
{
  const Sample sample = curve_samples::smooth_sample(1, 300, 1);
  const auto mesh = make_mesh<Surface_mesh>(sample.soup);
  const auto scalar_map =
    CGAL::Reeb_graph::make_scalar_map(mesh, std::vector<Scalar>(sample.values.begin(), sample.values.end()));
  typename CGAL::Reeb_graph_traits<Surface_mesh, std::remove_const_t<decltype(scalar_map)>>::Graph graph;
  CGAL::compute_reeb_graph(mesh, scalar_map, graph);
  const CGAL::Reeb_graph::Augmentation augmentation(mesh, scalar_map, graph);
  const auto point_map =
    boost::make_function_property_map<Surface_mesh::Vertex_index>([&](Surface_mesh::Vertex_index v) {
      const Point p = mesh.point(v);
      return Exact_kernel::Point_3(p.x() + 10, p.y(), p.z());
    });
  for(const auto manner : {Embedding_manner::CENTROIDS, Embedding_manner::ON_SURFACE, Embedding_manner::STRAIGHT})
  {
    const auto np = CGAL::parameters::embedding_manner(manner);
    const auto embedding = embed(augmentation, np);
    const auto moved = embed(augmentation, CGAL::parameters::embedding_manner(manner).vertex_point_map(point_map));
    BOOST_REQUIRE(embedding.arc_polylines.size() == num_edges(graph));
    std::size_t i = 0;
    for(const auto arc : CGAL::make_range(edges(graph)))
    {
      BOOST_TEST(embedding.arc_values[i].front() == CGAL::to_double(graph[source(arc, graph)].value));
      BOOST_TEST(std::is_sorted(embedding.arc_values[i].begin(), embedding.arc_values[i].end()));
      BOOST_REQUIRE(embedding.arc_polylines[i].size() == moved.arc_polylines[i].size());
      double error = 0;
      for(std::size_t j = 0; j < embedding.arc_polylines[i].size(); ++j)
      {
        const Point p = embedding.arc_polylines[i][j];
        const auto q = moved.arc_polylines[i][j];
        error = (std::max)({error, std::abs(p.x() + 10 - CGAL::to_double(q.x())),
                            std::abs(p.y() - CGAL::to_double(q.y())), std::abs(p.z() - CGAL::to_double(q.z()))});
      }
      BOOST_TEST(error < 1e-9);
      ++i;
    }
  }
}

// The contours next to the vertices of nodes are those of critical sets.
BOOST_AUTO_TEST_CASE_TEMPLATE(contours_next_to_vertices, Mesh, Meshes)
{
  for_each_sample<Mesh>(120, [](const auto& s) {
    for(const auto node : CGAL::make_range(vertices(s.graph)))
    {
      const auto vertex = s.graph[node].vertex;
      const auto critical_set = s.augmentation.critical_set(node);
      for(const auto& expected : critical_set.lower_contours)
      {
        BOOST_TEST((s.augmentation.contour_below(expected.arc, vertex).edges == expected.edges));
        BOOST_TEST(s.augmentation.contour_below(expected.arc, vertex).value == s.augmentation.value(vertex));
        BOOST_CHECK_THROW(s.augmentation.contour_above(expected.arc, vertex), CGAL::Reeb_graph::Parameter_error);
      }
      for(const auto& expected : critical_set.upper_contours)
      {
        BOOST_TEST((s.augmentation.contour_above(expected.arc, vertex).edges == expected.edges));
        BOOST_TEST(s.augmentation.contour_above(expected.arc, vertex).value == s.augmentation.value(vertex));
        BOOST_CHECK_THROW(s.augmentation.contour_below(expected.arc, vertex), CGAL::Reeb_graph::Parameter_error);
      }
    }
  });
}

// A tube whose ends are levels is its axis, from the middle of one border to that of the other one.
BOOST_AUTO_TEST_CASE(a_tube_is_its_axis)
{
  constexpr std::size_t around = 20, along = 5;
  Sample sample;
  const auto number = [&](std::size_t i, std::size_t j) { return j * around + i % around; };
  for(std::size_t j = 0; j < along; ++j)
    for(std::size_t i = 0; i < around; ++i)
    {
      const double angle = 2 * CGAL_PI * static_cast<double>(i) / around;
      sample.soup.points.push_back({std::cos(angle), std::sin(angle), static_cast<double>(j)});
      sample.values.push_back(static_cast<double>(j));
      if(j + 1 == along)
        continue;
      sample.soup.triangles.push_back({number(i, j), number(i + 1, j), number(i + 1, j + 1)});
      sample.soup.triangles.push_back({number(i, j), number(i + 1, j + 1), number(i, j + 1)});
    }
  const Embedded_sample<Surface_mesh> s(sample, 1);
  const auto embedding = s.embedded(Embedding_manner::CENTROIDS);
  BOOST_REQUIRE(embedding.arc_polylines.size() == 1u);
  for(const Point& point : embedding.arc_polylines[0])
    BOOST_TEST(std::hypot(point.x(), point.y()) < 1e-9);
  BOOST_TEST(embedding.node_points[1].z() == along - 1, boost::test_tools::tolerance(1e-9));
}

// The field with all values in units of this power of two: near the greatest numbers, so that differences are infinite.
constexpr int largest_exponent = 1024;

std::vector<double> in_large_units(std::vector<double> values)
{
  for(double& value : values)
    value = std::ldexp(value, largest_exponent);
  return values;
}

double distance_of_lines(const Polyline& a, const Polyline& b)
{
  double distance = a.size() == b.size() ? 0 : std::numeric_limits<double>::infinity();
  for(std::size_t i = 0; i < (std::min)(a.size(), b.size()); ++i)
    distance = (std::max)(distance, CGAL::squared_distance(a[i], b[i]));
  return distance;
}

BOOST_AUTO_TEST_CASE(differences_of_values_can_be_infinite)
{
  for(std::size_t kind = 0; kind != 3; ++kind)
  {
    Sample sample = curve_samples::smooth_sample(1, 200, kind);
    const auto [lowest, highest] = std::minmax_element(sample.values.begin(), sample.values.end());
    const double low = *lowest, range = *highest - low;
    for(double& value : sample.values)
      value = 1.9 * ((value - low) / range) - 0.95;
    const Embedded_sample<Surface_mesh> s(sample);
    sample.values = in_large_units(sample.values);
    const Embedded_sample<Surface_mesh> large(sample);
    double distance = 0;
    auto large_arc = edges(large.graph).first;
    for(const auto arc : CGAL::make_range(edges(s.graph)))
    {
      for(const double t : {0.11, 0.53, 0.87})
      {
        const auto contours = {s.augmentation.contour(arc, t), s.augmentation.contour(arc, t, s.scalar_map)};
        const auto large_contours = {large.augmentation.contour(*large_arc, t),
                                     large.augmentation.contour(*large_arc, t, large.scalar_map)};
        for(auto a = contours.begin(), b = large_contours.begin(); a != contours.end(); ++a, ++b)
        {
          Polyline points, large_points;
          s.augmentation.points_of_contour(*a, std::back_inserter(points));
          large.augmentation.points_of_contour(*b, std::back_inserter(large_points));
          distance = (std::max)(distance, distance_of_lines(points, large_points));
        }
      }
      ++large_arc;
    }
    for(const auto manner : {Embedding_manner::CENTROIDS, Embedding_manner::ON_SURFACE})
    {
      const auto embedding = s.embedded(manner), large_embedding = large.embedded(manner);
      for(std::size_t i = 0; i != embedding.arc_polylines.size(); ++i)
      {
        distance =
          (std::max)(distance, distance_of_lines(embedding.arc_polylines[i], large_embedding.arc_polylines[i]));
        const auto values = in_large_units(embedding.arc_values[i]);
        for(std::size_t j = 0; j != values.size(); ++j)
          BOOST_TEST(std::abs(values[j] / 2 - large_embedding.arc_values[i][j] / 2) < std::ldexp(1, 980));
      }
    }
    BOOST_TEST(distance < 1e-16);
  }
  const CGAL::Reeb_graph::Linear_interpolation interpolation;
  BOOST_TEST(interpolation(-1.5e308, 1.6e308, 0.5) == 0.05e308, boost::test_tools::tolerance(1e-12));
}

// Lengths times coordinates, and areas, are beyond the range of numbers.
BOOST_AUTO_TEST_CASE(places_and_means_are_the_same_in_any_unit)
{
  for(const int exponent : {-660, -340, 340, 660})
    BOOST_TEST_CONTEXT("unit 2^" << exponent)
    {
      Sample sample = curve_samples::smooth_sample(1, 200, 0);
      const Embedded_sample<Surface_mesh> s(sample);
      for(auto& point : sample.soup.points)
        for(double& coordinate : point)
          coordinate = std::scalbn(coordinate, exponent);
      const Embedded_sample<Surface_mesh> scaled(sample);
      const auto lines = s.embedded(Embedding_manner::CENTROIDS).arc_polylines,
                 scaled_lines = scaled.embedded(Embedding_manner::CENTROIDS).arc_polylines;
      BOOST_REQUIRE(lines.size() == scaled_lines.size());
      double distance = 0;
      for(std::size_t i = 0; i != lines.size(); ++i)
      {
        Polyline line;
        for(const Point& p : scaled_lines[i])
          line.emplace_back(std::scalbn(p.x(), -exponent), std::scalbn(p.y(), -exponent),
                            std::scalbn(p.z(), -exponent));
        distance = (std::max)(distance, distance_of_lines(lines[i], line));
      }
      BOOST_TEST(distance < 1e-14);
      const auto means = [](const auto& sample_) {
        return CGAL::Reeb_graph::arc_mean_values(sample_.augmentation, sample_.augmentation.locate_vertices());
      };
      BOOST_TEST((means(scaled) == means(s)));
    }
}

// Long contours make lines straight, unless centroids are asked for.
BOOST_AUTO_TEST_CASE(the_default_manner_is_chosen_by_cost)
{
  for(const std::size_t kind : {0, 1})
  {
    const Embedded_sample<Surface_mesh> s(curve_samples::smooth_sample(1, 6000, kind));
    const auto embedding = embed(s.augmentation);
    const Embedding_manner manner = kind == 0 ? Embedding_manner::CENTROIDS : Embedding_manner::STRAIGHT;
    BOOST_TEST((embedding.manner == manner));
    BOOST_TEST((embedding.arc_polylines == s.embedded(manner).arc_polylines));
    BOOST_TEST((embedding.node_points == s.embedded(manner).node_points));
    BOOST_TEST((embed<CGAL::Parallel_if_available_tag>(s.augmentation).manner == manner));
    BOOST_TEST((s.embedded(Embedding_manner::CENTROIDS).manner == Embedding_manner::CENTROIDS));
  }
}

BOOST_AUTO_TEST_CASE(progress_is_told_and_work_is_cancelled)
{
  const Embedded_sample<Surface_mesh> s(curve_samples::smooth_sample(2, 600, 1));
  for(const auto manner : {Embedding_manner::CENTROIDS, Embedding_manner::ON_SURFACE, Embedding_manner::STRAIGHT})
  {
    const auto np = CGAL::parameters::embedding_manner(manner);
    std::vector<double> fractions;
    const auto note = [&](double fraction) {
      fractions.push_back(fraction);
      return true;
    };
    embed(s.augmentation, np.callback(note));
    BOOST_TEST(std::is_sorted(fractions.begin(), fractions.end()));
    BOOST_TEST(fractions.back() == 1);
    if(manner == Embedding_manner::STRAIGHT)
      continue;
    BOOST_TEST(fractions.size() > 20u);
    std::size_t count = 0;
    BOOST_CHECK_THROW(embed(s.augmentation, np.callback([&](double) { return ++count < 5; })),
                      CGAL::Reeb_graph::Cancelled_error);
  }
}

// What the writers write is read by others in the tests of the program.
BOOST_AUTO_TEST_CASE(attributes_are_written)
{
  const Embedded_sample<Polyhedron> s(curve_samples::smooth_sample(1, 100, 0));
  const auto embedding = s.embedded(Embedding_manner::STRAIGHT);
  const auto vertex_index_map = CGAL::Reeb_graph::make_vertex_index_map(s.mesh);
  const std::vector<double> numbers(num_edges(s.graph), 0.25);
  const std::vector<std::int64_t> whole_numbers(num_edges(s.graph), -7);
  const auto np = CGAL::parameters::arc_attributes({{"a \"b\", <c>", numbers}, {"whole", whole_numbers}});
  std::ostringstream json, csv, vtp;
  CGAL::Reeb_graph::write_json(json, s.mesh, s.graph, embedding, vertex_index_map, np);
  CGAL::Reeb_graph::write_arcs_csv(csv, s.graph, embedding, np);
  CGAL::Reeb_graph::write_vtp(vtp, s.graph, embedding, vertex_index_map, np);
  BOOST_TEST(json.str().find("\"a \\\"b\\\", <c>\": 0.25, \"whole\": -7") != std::string::npos);
  BOOST_TEST(csv.str().find(",\"a \"\"b\"\", <c>\",whole\n") != std::string::npos);
  BOOST_TEST(csv.str().find(",0.25,-7\n") != std::string::npos);
  BOOST_TEST(vtp.str().find("Name=\"a &quot;b&quot;, &lt;c&gt;\"") != std::string::npos);
}

BOOST_AUTO_TEST_CASE(numbers_of_attributes_are_counted)
{
  using CGAL::Reeb_graph::Attribute_count_error;
  const Embedded_sample<Surface_mesh> s(curve_samples::smooth_sample(1, 100, 0));
  const auto embedding = s.embedded(Embedding_manner::STRAIGHT);
  const auto vertex_index_map = get(boost::vertex_index, s.mesh);
  const std::vector<double> numbers(num_edges(s.graph) + 1, 0);
  const auto np = CGAL::parameters::arc_attributes({{"too many", numbers}});
  std::ostringstream out;
  BOOST_CHECK_THROW(CGAL::Reeb_graph::write_vtp(out, s.graph, embedding, vertex_index_map, np), Attribute_count_error);
  BOOST_CHECK_THROW(CGAL::Reeb_graph::write_json(out, s.mesh, s.graph, embedding, vertex_index_map, np),
                    Attribute_count_error);
  BOOST_CHECK_THROW(CGAL::Reeb_graph::write_arcs_csv(out, s.graph, embedding, np), Attribute_count_error);
  BOOST_CHECK_THROW(
    CGAL::Reeb_graph::write_mesh_vtp(out, s.mesh, CGAL::parameters::vertex_attributes({{"too few", numbers}})),
    Attribute_count_error);
  BOOST_CHECK_THROW(
    CGAL::Reeb_graph::write_mesh_vtp(out, s.mesh, CGAL::parameters::face_attributes({{"too few", numbers}})),
    Attribute_count_error);
  BOOST_TEST(out.str().empty());
  BOOST_CHECK_THROW(CGAL::Reeb_graph::write_obj("missing/graph.obj", s.graph, embedding), CGAL::Reeb_graph::File_error);

  // a file that is there stays as it is
  const std::string name = "test_embedding_attributes";
  std::ofstream(name) << "kept";
  BOOST_CHECK_THROW(CGAL::Reeb_graph::write_vtp(name, s.graph, embedding, vertex_index_map, np), Attribute_count_error);
  BOOST_CHECK_THROW(CGAL::Reeb_graph::write_csv(name, name, s.graph, embedding, vertex_index_map, np),
                    Attribute_count_error);
  BOOST_CHECK_THROW(
    CGAL::Reeb_graph::write_mesh_vtp(name, s.mesh, CGAL::parameters::vertex_attributes({{"too few", numbers}})),
    Attribute_count_error);
  std::string text;
  std::ifstream(name) >> text;
  BOOST_TEST(text == "kept");
  std::remove(name.c_str());
}

// Writes numbers as in German: 1.234,5.
struct German_numbers : std::numpunct<char>
{
  char do_decimal_point() const override { return ','; }
  char do_thousands_sep() const override { return '.'; }
  std::string do_grouping() const override { return "\3"; }
};

BOOST_AUTO_TEST_CASE(files_are_the_same_in_each_locale)
{
  const Embedded_sample<Surface_mesh> s(curve_samples::smooth_sample(1, 2000, 0));
  const auto embedding = s.embedded(Embedding_manner::CENTROIDS);
  const auto vertex_index_map = get(boost::vertex_index, s.mesh);
  const auto text_of_all = [&](std::ostringstream out) {
    CGAL::Reeb_graph::write_obj(out, s.graph, embedding);
    CGAL::Reeb_graph::write_json(out, s.mesh, s.graph, embedding, vertex_index_map);
    CGAL::Reeb_graph::write_nodes_csv(out, s.graph, embedding, vertex_index_map);
    CGAL::Reeb_graph::write_arcs_csv(out, s.graph, embedding);
    CGAL::Reeb_graph::write_vtp(out, s.graph, embedding, vertex_index_map);
    CGAL::Reeb_graph::write_mesh_vtp(out, s.mesh);
    CGAL::Reeb_graph::write_polylines(out, embedding.arc_polylines);
    CGAL::Reeb_graph::write_graphml(out, s.graph, vertex_index_map);
    return out.str();
  };
  std::ostringstream german;
  german.imbue(std::locale(std::locale::classic(), new German_numbers));
  BOOST_TEST((text_of_all(std::ostringstream()) == text_of_all(std::move(german))));
}

// Names in files of XML and JSON are UTF-8, whatever they are.
BOOST_AUTO_TEST_CASE(names_that_are_no_utf8_are_made_so)
{
  const std::string none = "\xEF\xBF\xBD";
  const std::vector<std::pair<std::string, std::string>> names = {
    {"\xC2\xB5m \xE2\x82\xAC \xF0\x9F\x98\x80", "\xC2\xB5m \xE2\x82\xAC \xF0\x9F\x98\x80"}, // two, three, four bytes
    {"\xF4\x8F\xBF\xBD \xED\x9F\xBF", "\xF4\x8F\xBF\xBD \xED\x9F\xBF"},                     // the last ones
    {"\xB5m", none + "m"},                                                                  // Latin 1
    {"a\xC2", "a" + none},                                                                  // cut off
    {"a\xE2\x82z", "a" + none + none + "z"},
    {"\xC0\xAF", none + none}, // too long
    {"\xE0\x80\x80", none + none + none},
    {"\xF0\x8F\xBF\xBF", none + none + none + none},
    {"\xED\xA0\x80", none + none + none},            // a surrogate
    {"\xF4\x90\x80\x80", none + none + none + none}, // beyond the last one
    {"\xEF\xBF\xBF", none + none + none},            // no character
    {"\xFF", none}};
  const Embedded_sample<Surface_mesh> s(curve_samples::smooth_sample(1, 100, 0));
  const auto embedding = s.embedded(Embedding_manner::STRAIGHT);
  const auto vertex_index_map = get(boost::vertex_index, s.mesh);
  for(const auto& [name, shown] : names)
  {
    const std::vector<double> numbers(num_edges(s.graph)), numbers_of_mesh(num_vertices(s.mesh));
    const auto np = CGAL::parameters::arc_attributes({{name, numbers}});
    std::ostringstream json, vtp, mesh_vtp;
    CGAL::Reeb_graph::write_json(json, s.mesh, s.graph, embedding, vertex_index_map, np);
    CGAL::Reeb_graph::write_vtp(vtp, s.graph, embedding, vertex_index_map, np);
    CGAL::Reeb_graph::write_mesh_vtp(mesh_vtp, s.mesh, CGAL::parameters::vertex_attributes({{name, numbers_of_mesh}}));
    BOOST_TEST(json.str().find('"' + shown + "\": 0") != std::string::npos);
    BOOST_TEST(vtp.str().find("Name=\"" + shown + '"') != std::string::npos);
    BOOST_TEST(mesh_vtp.str().find("Scalars=\"" + shown + '"') != std::string::npos);
  }
}

// The buffer of a file throws exceptions where a locale is set after it could not write.
BOOST_AUTO_TEST_CASE(a_full_disk_is_told_with_the_name_and_the_reason)
{
  const std::string full = "/dev/full";
  if(!std::ofstream(full))
    return; // It is there in Linux.
  const Embedded_sample<Surface_mesh> s(curve_samples::smooth_sample(1, 2000, 0));
  const auto embedding = s.embedded(Embedding_manner::STRAIGHT);
  const auto vertex_index_map = get(boost::vertex_index, s.mesh);
  const auto write_everywhere = [&](const auto& write) { // `write` takes a stream or a name
    const std::string reason = std::generic_category().message(ENOSPC);
    BOOST_CHECK_EXCEPTION(write(full), CGAL::Reeb_graph::File_error, [&](const CGAL::Reeb_graph::File_error& error) {
      return error.what() == full + " cannot be written: " + reason;
    });
    std::ofstream stream(full);
    BOOST_CHECK_NO_THROW(write(stream); stream.close());
    BOOST_TEST(stream.fail());
  };
  write_everywhere([&](auto& out) { CGAL::Reeb_graph::write_obj(out, s.graph, embedding); });
  write_everywhere([&](auto& out) { CGAL::Reeb_graph::write_json(out, s.mesh, s.graph, embedding, vertex_index_map); });
  write_everywhere([&](auto& out) { CGAL::Reeb_graph::write_vtp(out, s.graph, embedding, vertex_index_map); });
  write_everywhere([&](auto& out) { CGAL::Reeb_graph::write_mesh_vtp(out, s.mesh); });
  write_everywhere([&](auto& out) { CGAL::Reeb_graph::write_polylines(out, embedding.arc_polylines); });
  write_everywhere([&](auto& out) { CGAL::Reeb_graph::write_graphml(out, s.graph, vertex_index_map); });
}

// A disk that is full.
struct Full_buffer : std::streambuf
{
};

BOOST_AUTO_TEST_CASE(exceptions_of_streams_arrive)
{
  const Embedded_sample<Surface_mesh> s(curve_samples::smooth_sample(1, 100, 0));
  const auto embedding = s.embedded(Embedding_manner::STRAIGHT);
  Full_buffer buffer;
  std::ostream out(&buffer);
  out.exceptions(std::ios::badbit);
  BOOST_CHECK_THROW(CGAL::Reeb_graph::write_vtp(out, s.graph, embedding, get(boost::vertex_index, s.mesh)),
                    std::ios::failure);
  out.clear();
  BOOST_CHECK_THROW(CGAL::Reeb_graph::write_mesh_vtp(out, s.mesh), std::ios::failure);
}

BOOST_AUTO_TEST_CASE(errors)
{
  const Embedded_sample<Surface_mesh> s(curve_samples::smooth_sample(0, 100, 0));
  const auto arc = *edges(s.graph).first;
  const Surface_mesh::Vertex_index unknown(100000);
  BOOST_CHECK_THROW(s.augmentation.value(unknown), CGAL::Reeb_graph::Unknown_vertex_error);
  BOOST_CHECK_THROW(s.augmentation.contour_below(arc, unknown), CGAL::Reeb_graph::Unknown_vertex_error);
  const auto infinite_map = CGAL::Reeb_graph::make_scalar_map(
    s.mesh, std::vector<double>(num_vertices(s.mesh), std::numeric_limits<double>::infinity()));
  BOOST_CHECK_THROW(embed(s.augmentation, CGAL::parameters::parametrization_map(infinite_map)),
                    CGAL::Reeb_graph::Non_finite_scalar_error);
}

BOOST_AUTO_TEST_SUITE_END()
