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
#include "cut_mesh_checks.h"
#include "random_graphs.h"

#include <CGAL/Reeb_graph/Augmentation.h>
#include <CGAL/Reeb_graph/IO.h>
#include <CGAL/Reeb_graph/curves/cut_along_contours.h>
#include <CGAL/Reeb_graph/graph_topology.h>
#include <CGAL/Reeb_graph/internal/io/text.h>
#include <CGAL/Reeb_graph/scalar_maps.h>

#include <CGAL/Exact_rational.h>
#include <CGAL/Polyhedron_3.h>

#include <boost/mpl/list.hpp>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <iterator>
#include <limits>
#include <numeric>
#include <set>
#include <sstream>
#include <string>
#include <system_error>
#include <vector>

// Loops, components and leaves of graphs, and graphs written and read back.

BOOST_AUTO_TEST_SUITE(test_graph_files)

using curve_samples::Sample;
using mesh_builders::Polyhedron;
using mesh_builders::Surface_mesh;
using random_graphs::Random;

typedef boost::mpl::list<Surface_mesh, Polyhedron> Meshes;

namespace {
typedef boost::graph_traits<random_graphs::Graph>::edge_descriptor Arc;

std::size_t components_by_labels(const random_graphs::Graph& graph)
{
  std::vector<std::size_t> labels(num_vertices(graph));
  std::iota(labels.begin(), labels.end(), std::size_t(0));
  for(std::size_t round = 0; round < labels.size(); ++round)
    for(const Arc arc : CGAL::make_range(edges(graph)))
      labels[source(arc, graph)] = labels[target(arc, graph)] =
        (std::min)(labels[source(arc, graph)], labels[target(arc, graph)]);
  return std::set<std::size_t>(labels.begin(), labels.end()).size();
}

// The arcs of a loop follow each other, from the upper node of the first one back to its lower node.
std::string fault_of_loop(const random_graphs::Graph& graph, const std::vector<Arc>& loop)
{
  std::size_t node = source(loop.front(), graph);
  std::set<const void*> different;
  for(const Arc arc : loop)
  {
    if(source(arc, graph) != node && target(arc, graph) != node)
      return "arcs do not follow each other";
    node = source(arc, graph) == node ? target(arc, graph) : source(arc, graph);
    different.insert(&graph[arc]);
  }
  return node != source(loop.front(), graph) ? "the loop is not closed"
       : different.size() != loop.size()     ? "an arc is passed twice"
                                             : "";
}
} // namespace

BOOST_AUTO_TEST_CASE(loops_components_and_leaves_of_graphs)
{
  std::size_t total = 0;
  for(std::size_t seed = 0; seed < 500; ++seed)
    BOOST_TEST_CONTEXT("seed " << seed)
    {
      Random random(seed);
      const auto graph = random_graphs::random_graph(random);
      const std::size_t components = components_by_labels(graph);
      BOOST_TEST(CGAL::Reeb_graph::number_of_components(graph) == components);
      std::vector<std::vector<Arc>> loops;
      CGAL::Reeb_graph::cycle_basis(graph, std::back_inserter(loops));
      BOOST_TEST(loops.size() == CGAL::Reeb_graph::number_of_loops(graph));
      BOOST_TEST(loops.size() + num_vertices(graph) == num_edges(graph) + components);
      for(std::size_t i = 0; i < loops.size(); ++i)
      {
        BOOST_TEST(fault_of_loop(graph, loops[i]) == "");
        for(std::size_t j = 0; j < loops.size(); ++j)
          BOOST_TEST((j == i || std::find(loops[j].begin(), loops[j].end(), loops[i].front()) == loops[j].end()));
      }
      std::vector<std::size_t> leaves;
      CGAL::Reeb_graph::leaves(graph, std::back_inserter(leaves));
      std::size_t number_of_leaves = 0;
      for(std::size_t node = 0; node < num_vertices(graph); ++node)
        number_of_leaves += in_degree(node, graph) + out_degree(node, graph) == 1 ? 1 : 0;
      BOOST_TEST(leaves.size() == number_of_leaves);
      total += loops.size();
    }
  BOOST_TEST(total > 1000u);
}

// Cut along them, each component stays in one piece.
BOOST_AUTO_TEST_CASE(contours_of_loops_part_nothing)
{
  std::size_t total = 0;
  for(std::size_t seed = 0; seed < 100; ++seed)
    BOOST_TEST_CONTEXT("seed " << seed)
    {
      const Sample sample = curve_samples::random_sample(seed, false, 1 + seed % 2, 1);
      auto mesh = curve_samples::make_mesh<Surface_mesh>(sample.soup);
      const auto scalar_map = CGAL::Reeb_graph::make_scalar_map(mesh, sample.values);
      graph_checks::Graph_of<Surface_mesh> graph;
      CGAL::compute_reeb_graph(mesh, scalar_map, graph);
      const CGAL::Reeb_graph::Augmentation augmentation(mesh, scalar_map, graph);
      std::vector<decltype(augmentation)::Contour> contours;
      CGAL::Reeb_graph::loop_contours(graph, augmentation, std::back_inserter(contours));
      BOOST_TEST(contours.size() == CGAL::Reeb_graph::number_of_loops(graph));
      const std::size_t number_of_pieces = cut_mesh_checks::pieces_of(mesh).size();
      auto cut_mesh = mesh;
      std::vector<CGAL::Reeb_graph::Curve<Surface_mesh::Halfedge_index>> curves;
      CGAL::Reeb_graph::cut_along_contours(cut_mesh, scalar_map, contours, std::back_inserter(curves),
                                           CGAL::parameters::cut_open(true));
      BOOST_TEST(cut_mesh_checks::pieces_of(cut_mesh).size() == number_of_pieces);

      std::vector<std::vector<mesh_builders::Point>> polylines;
      for(const auto& contour : contours)
        polylines.push_back(CGAL::Reeb_graph::polylines_of_contour(augmentation, contour).front());
      for(std::size_t i = 0; i < curves.size(); ++i)
      {
        const auto polyline = CGAL::Reeb_graph::polyline_of_curve(cut_mesh, curves[i]);
        BOOST_TEST(polyline.size() == polylines[i].size());
        BOOST_TEST((polyline.front() == polyline.back() || !cut_mesh.is_border(curves[i].halfedges.front())));
        BOOST_TEST((polylines[i].front() == polylines[i].back()));
      }
      std::ostringstream written;
      CGAL::Reeb_graph::write_polylines(written, polylines);
      std::istringstream lines(written.str());
      for(const auto& polyline : polylines)
      {
        std::size_t size = 0;
        lines >> size;
        BOOST_TEST(size == polyline.size());
        for(mesh_builders::Point point; size != 0; --size)
        {
          lines >> point;
          BOOST_TEST((point == polyline[polyline.size() - size]));
        }
      }
      total += contours.size();
    }
  BOOST_TEST(total > 100u);
}

namespace {
template <class Mesh, class Scalar>
void test_round_trip(const Mesh& mesh, const std::vector<Scalar>& values)
{
  const auto scalar_map = CGAL::Reeb_graph::make_scalar_map(mesh, values);
  graph_checks::Graph_of<Mesh, Scalar> graph, read(3);
  CGAL::compute_reeb_graph(mesh, scalar_map, graph);
  std::stringstream file;
  CGAL::Reeb_graph::write_graphml(file, graph, CGAL::Reeb_graph::make_vertex_index_map(mesh),
                                  CGAL::Reeb_graph::make_halfedge_index_map(mesh));
  CGAL::Reeb_graph::read_graphml(file, mesh, read);
  BOOST_TEST(graph_checks::are_identical(graph, read));
  BOOST_TEST(graph_checks::are_arcs_numbered(read));
}
} // namespace

BOOST_AUTO_TEST_CASE_TEMPLATE(a_graph_that_is_read_is_the_one_that_was_written, Mesh, Meshes)
{
  for(std::size_t seed = 0; seed < 100; ++seed)
    BOOST_TEST_CONTEXT("seed " << seed)
    {
      const Sample sample = curve_samples::any_sample(seed);
      const auto mesh = curve_samples::make_mesh<Mesh>(sample.soup);
      std::vector<double> values = sample.values;
      for(std::size_t i = 0; i < values.size(); ++i)
        values[i] = std::isfinite(values[i]) ? std::sin(values[i]) / 3 * (i % 5 == 0 ? 1e-300 : 1) : values[i];
      if(seed % 10 == 0 && !values.empty())
        values.front() = std::numeric_limits<double>::infinity();
      test_round_trip(mesh, values);
      std::vector<float> floats(values.begin(), values.end());
      test_round_trip(mesh, floats);
      std::vector<signed char> bytes;
      for(const double value : sample.values)
        bytes.push_back(static_cast<signed char>(std::isfinite(value) ? std::fmod(value, 100) : 0));
      test_round_trip(mesh, bytes);
      std::vector<CGAL::Exact_rational> rationals;
      for(const signed char byte : bytes)
        rationals.push_back(CGAL::Exact_rational(byte) / 7);
      test_round_trip(mesh, rationals);
    }
}

BOOST_AUTO_TEST_CASE(a_polyhedron_without_indices)
{
  typedef CGAL::Polyhedron_3<mesh_builders::Kernel> Plain_polyhedron;
  const Sample sample = curve_samples::smooth_sample(1, 200, 0);
  const auto mesh = curve_samples::make_mesh<Plain_polyhedron>(sample.soup);
  test_round_trip(mesh, sample.values);
  const auto index_map = CGAL::Reeb_graph::make_vertex_index_map(mesh);
  std::size_t number = 0;
  for(const auto v : vertices(mesh))
    BOOST_TEST(get(index_map, v) == number++);
}

BOOST_AUTO_TEST_CASE(files_that_are_written_and_read)
{
  const Sample sample = curve_samples::smooth_sample(1, 200, 0);
  const auto mesh = curve_samples::make_mesh<Surface_mesh>(sample.soup);
  const auto scalar_map = CGAL::Reeb_graph::make_scalar_map(mesh, sample.values);
  graph_checks::Graph_of<Surface_mesh> graph, read(3);
  CGAL::compute_reeb_graph(mesh, scalar_map, graph);
  const auto vertex_map = CGAL::Reeb_graph::make_vertex_index_map(mesh);
  const auto halfedge_map = CGAL::Reeb_graph::make_halfedge_index_map(mesh);
  const std::string name = "test_graph_files.graphml";
  CGAL::Reeb_graph::write_graphml(name, graph, vertex_map, halfedge_map);
  CGAL::Reeb_graph::read_graphml(name, mesh, read);
  BOOST_TEST(graph_checks::are_identical(graph, read));
  CGAL::Reeb_graph::write_graphviz(name, graph, vertex_map);

  using CGAL::Reeb_graph::File_error;
  const auto says = [](const std::string& text) {
    return [text](const File_error& error) { return std::string(error.what()).find(text) != std::string::npos; };
  };
  BOOST_CHECK_EXCEPTION(CGAL::Reeb_graph::read_graphml(name, mesh, read), File_error,
                        says(name + ": this is not GraphML: line 1: "));
  CGAL::Reeb_graph::write_graphml(name, graph, vertex_map);
  BOOST_CHECK_EXCEPTION(CGAL::Reeb_graph::read_graphml(name, mesh, read), File_error,
                        says("no data chain: write_graphml() writes chains if"));
  std::remove(name.c_str());
  BOOST_CHECK_THROW(CGAL::Reeb_graph::read_graphml(name, mesh, read), File_error);
  BOOST_CHECK_THROW(CGAL::Reeb_graph::write_graphml("no/such/folder/x.graphml", graph, vertex_map), File_error);
  std::stringstream file;
  CGAL::Reeb_graph::write_graphml(file, graph, vertex_map, halfedge_map);
  BOOST_CHECK_THROW(CGAL::Reeb_graph::read_graphml(file, Surface_mesh(), read), File_error); // another mesh
  for(const std::string& text :
      {std::string(), std::string("<graphml/>"), std::string("<graphml><graph><node/></graph></graphml>"),
       file.str().substr(0, file.str().size() / 2)})
  {
    std::istringstream wrong(text);
    BOOST_CHECK_THROW(CGAL::Reeb_graph::read_graphml(wrong, mesh, read), File_error);
  }
  BOOST_TEST(graph_checks::are_identical(graph, read));
}

#ifdef __cpp_lib_to_chars
// What stands in where a standard library reads no floating-point numbers reads the same.
BOOST_AUTO_TEST_CASE(numbers_are_read_as_by_the_standard_library)
{
  const std::string characters = "0123456789.eE+-infaty00112x";
  random_meshes::Random random(4);
  std::size_t number_of_read = 0;
  for(int i = 0; i != 300000; ++i)
  {
    std::string text(i % 13 == 0 ? "-" : "");
    for(std::size_t size = random.below(9); size != 0; --size)
      text += characters[random.below(characters.size())];
    text += i % 7 == 0  ? "e-32" + std::to_string(random.below(10))
          : i % 11 == 0 ? "inf"
          : i % 17 == 0 ? "infinity"
                        : "";
    double expected = 7, number = 7;
    const char *const begin = text.data(), *const end = begin + text.size();
    const auto expected_end = std::from_chars(begin, end, expected);
    const auto read_end = CGAL::Reeb_graph::internal::read_floating_number(begin, end, number);
    const bool is_same = read_end.ptr == expected_end.ptr && read_end.ec == expected_end.ec
                      && (number == expected || (std::isnan(number) && std::isnan(expected)));
    BOOST_TEST(is_same, "'" << text << "' is read in another way");
    number_of_read += expected_end.ec == std::errc() ? 1 : 0;
  }
  BOOST_TEST(number_of_read > 100000u);
}
#endif

// Text is written in pieces, in which a stream has no part, with all digits of numbers.
BOOST_AUTO_TEST_CASE(text_is_written_as_by_a_stream)
{
  typedef std::numeric_limits<double> Limits;
  std::vector<double> numbers = {0.,
                                 Limits::infinity(),
                                 Limits::quiet_NaN(),
                                 Limits::denorm_min(),
                                 (Limits::min)(),
                                 0.1,
                                 (Limits::max)(),
                                 1e-4,
                                 1e-5,
                                 1. / 3,
                                 1e7,
                                 99999999999999984.,
                                 1e17,
                                 123456789012345680.};
  for(int exponent = -300; exponent <= 300; ++exponent)
    numbers.push_back(std::pow(7., exponent));
  std::ostringstream expected, written;
  expected.precision(Limits::max_digits10);
  CGAL::Reeb_graph::internal::Text_output text(written);
  const auto write = [&](const auto& part) {
    expected << part << ' ';
    text << part << ' ';
  };
  for(int round = 0; round < 5; ++round) // more than a piece
  {
    for(const double number : numbers)
    {
      write(number);
      write(-number);
    }
    write((std::numeric_limits<long long>::min)());
    write((std::numeric_limits<unsigned long long>::max)());
    write(std::string(round * 50000, 'x'));
  }
  text.flush();
  BOOST_TEST((written.str() == expected.str()));
}

BOOST_AUTO_TEST_CASE(kinds_of_nodes_are_written)
{
  std::ostringstream text;
  text << CGAL::Reeb_graph::Node_kind::SADDLE << ' ' << CGAL::Reeb_graph::Node_kind::DEGREE_TWO;
  BOOST_TEST(text.str() == "saddle degree-two");
}

BOOST_AUTO_TEST_SUITE_END()
