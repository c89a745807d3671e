// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#include <boost/test/unit_test.hpp>

#include "computed_graphs.h"
#include "generated_surfaces/standing_figure.h"
#include "random_graphs.h"

#include <CGAL/Reeb_graph/IO/svg.h>
#include <CGAL/Reeb_graph/plane_layout.h>

#include <CGAL/Exact_rational.h>

#include <boost/property_tree/ptree.hpp>
#include <boost/property_tree/xml_parser.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numeric>
#include <set>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

// Graphs laid out in the plane, and drawn.

BOOST_AUTO_TEST_SUITE(test_drawing)

using namespace computed_graphs;
using CGAL::Reeb_graph::Plane_layout;
using random_graphs::Graph;
namespace parameters = CGAL::parameters;

namespace {
typedef std::array<double, 2> Point;
typedef std::vector<Point> Polyline;
const double infinity = std::numeric_limits<double>::infinity();

template <class G>
std::vector<random_graphs::Arc> arcs_of(const G& graph)
{
  std::vector<random_graphs::Arc> arcs;
  for(auto range = edges(graph); range.first != range.second; ++range.first)
    arcs.emplace_back(source(*range.first, graph), target(*range.first, graph));
  return arcs;
}

// all properties that a layout has to have
template <class G>
void test_layout(const G& graph)
{
  const Plane_layout layout = CGAL::Reeb_graph::lay_out_in_plane(graph);
  const std::vector<random_graphs::Arc> arcs = arcs_of(graph);
  BOOST_REQUIRE(layout.node_positions.size() == num_vertices(graph));
  BOOST_REQUIRE(layout.arc_polylines.size() == arcs.size());
  double lowest = infinity, highest = -infinity;
  std::set<std::pair<double, double>> places;
  for(std::size_t node = 0; node < num_vertices(graph); ++node)
  {
    const double value = graph[node].value;
    if(std::isfinite(value))
    {
      lowest = (std::min)(lowest, value);
      highest = (std::max)(highest, value);
    }
    BOOST_TEST(layout.node_positions[node] > -0.5);
    BOOST_TEST(places.emplace(layout.node_positions[node], value).second, "node " << node << " lies on another one");
  }
  std::set<std::pair<double, double>> straight_parts; // of a column, their lower ends
  std::vector<std::pair<Point, Point>> verticals;
  for(std::size_t i = 0; i < arcs.size(); ++i)
  {
    const Polyline& polyline = layout.arc_polylines[i];
    BOOST_REQUIRE(polyline.size() >= 2);
    for(const std::size_t node : {arcs[i].first, arcs[i].second})
    {
      const Point& end = node == arcs[i].first ? polyline.front() : polyline.back();
      BOOST_TEST(end[0] == layout.node_positions[node]);
      if(std::isfinite(graph[node].value))
        BOOST_TEST(end[1] == graph[node].value);
      else
        BOOST_TEST((std::isfinite(end[1]) && (graph[node].value < 0 ? !(end[1] > lowest) : !(end[1] < highest))));
    }
    for(std::size_t k = 1; k < polyline.size(); ++k)
    {
      BOOST_TEST(polyline[k - 1][1] <= polyline[k][1]);
      if(polyline[k - 1][0] == polyline[k][0] && polyline[k - 1][1] < polyline[k][1])
        verticals.emplace_back(polyline[k - 1], polyline[k]);
    }
  }
  std::sort(verticals.begin(), verticals.end());
  for(std::size_t i = 1; i < verticals.size(); ++i)
    BOOST_TEST(
      (verticals[i - 1].first[0] < verticals[i].first[0] || verticals[i - 1].second[1] <= verticals[i].first[1]),
      "two arcs share a column at the value " << verticals[i].first[1]);
}

double turn(const Point& a, const Point& b, const Point& c)
{
  return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
}

// whether two line segments cross each other, neither at an end nor along a line
bool do_cross(const Point& a, const Point& b, const Point& c, const Point& d)
{
  return turn(a, b, c) * turn(a, b, d) < 0 && turn(c, d, a) * turn(c, d, b) < 0;
}

std::size_t number_of_crossings(const Plane_layout& layout)
{
  std::size_t crossings = 0;
  const auto& arcs = layout.arc_polylines;
  for(std::size_t i = 0; i < arcs.size(); ++i)
    for(std::size_t j = 0; j < i; ++j)
      for(std::size_t k = 1; k < arcs[i].size(); ++k)
        for(std::size_t l = 1; l < arcs[j].size(); ++l)
          crossings += do_cross(arcs[i][k - 1], arcs[i][k], arcs[j][l - 1], arcs[j][l]) ? 1 : 0;
  return crossings;
}

void set_random_values(Graph& graph, std::size_t least_step, Random& random)
{
  double value = -20;
  for(std::size_t node = 0; node < num_vertices(graph); ++node)
    graph[node].value = value += static_cast<double>(least_step + random.below(5));
}

Graph random_graph_with_values(std::size_t seed, Random& random)
{
  Graph graph;
  if(seed % 3 == 0)
    graph = random_graphs::random_graph(random);
  else
  {
    const std::size_t number_of_loops = random.below(6);
    graph = random_graphs::random_sparse_graph(1 + random.below(60), number_of_loops, random);
  }
  set_random_values(graph, seed % 2, random);
  if(seed % 7 == 0)
    for(std::size_t node = 0; node < num_vertices(graph); ++node)
      graph[node].value += node < 2 ? -infinity : node + 3 > num_vertices(graph) ? infinity : 0;
  return graph;
}

// A tree in which each node but the last has one arc above.
Graph random_merge_tree(std::size_t size, Random& random)
{
  std::vector<random_graphs::Arc> arcs;
  const std::size_t reach = 1 + random.below(size);
  for(std::size_t node = 0; node + 1 < size; ++node)
    arcs.emplace_back(node, node + 1 + random.below((std::min)(size - node - 1, reach)));
  return random_graphs::make_graph(size, arcs);
}

// A path of saddles, each with a leaf somewhere above or below.
Graph random_caterpillar(std::size_t number_of_saddles, Random& random)
{
  const std::size_t size = 2 * number_of_saddles + 2;
  std::vector<std::size_t> saddles(2 * number_of_saddles);
  std::iota(saddles.begin(), saddles.end(), std::size_t(1));
  random.shuffle(saddles);
  const std::vector<std::size_t> leaves(saddles.begin() + number_of_saddles, saddles.end());
  saddles.resize(number_of_saddles);
  std::sort(saddles.begin(), saddles.end());
  std::vector<random_graphs::Arc> arcs;
  std::size_t last = 0;
  for(std::size_t i = 0; i < number_of_saddles; ++i)
  {
    arcs.emplace_back(last, saddles[i]);
    arcs.emplace_back(std::minmax(saddles[i], leaves[i]));
    last = saddles[i];
  }
  arcs.emplace_back(last, size - 1);
  return random_graphs::make_graph(size, arcs);
}

// The elements of a drawing that are tested, in pixels.
struct Drawing
{
  std::vector<Point> nodes;
  std::vector<Polyline> arcs;
  std::vector<std::pair<std::string, Point>> ticks;

  struct Label
  {
    std::string text;
    double left, right, middle;
  };
  std::vector<Label> labels;
  std::vector<std::string> titles;
  double radius = 0; // of nodes

  explicit Drawing(const std::string& svg)
  {
    namespace pt = boost::property_tree;
    std::istringstream stream(svg);
    pt::ptree document;
    pt::read_xml(stream, document);
    for(const auto& [name, element] : document.get_child("svg"))
    {
      const std::string id = element.get("<xmlattr>.id", "");
      for(const auto& [inner_name, inner] : element)
        read(id, inner_name, inner);
    }
  }

private:
  void read(const std::string& id, const std::string& name, const boost::property_tree::ptree& element)
  {
    if(id == "nodes" && name == "g")
    {
      nodes.push_back(point(element.get<std::string>("<xmlattr>.transform").substr(10)));
      titles.push_back(element.get<std::string>("title"));
      radius = std::stod(element.get<std::string>("path.<xmlattr>.transform").substr(6));
    }
    else if(id == "arcs" && name == "path")
    {
      arcs.push_back(polyline(element.get<std::string>("<xmlattr>.d")));
      titles.push_back(element.get<std::string>("title"));
    }
    else if(name == "text")
    {
      const std::string text = element.get_value<std::string>(), anchor = element.get("<xmlattr>.text-anchor", "start");
      const double x = element.get<double>("<xmlattr>.x"), y = element.get<double>("<xmlattr>.y");
      if(id == "ticks")
        ticks.emplace_back(text, Point{x, y - 0.35 * 11});
      if(id != "node_labels" && id != "arc_labels")
        return;
      const double length = 0.56 * 11 * static_cast<double>(text.size()); // digits of Helvetica
      const double left = anchor == "start" ? x : anchor == "end" ? x - length : x - length / 2;
      labels.push_back({text, left, left + length, y - 0.35 * 11});
    }
  }

  static Point point(const std::string& text)
  {
    std::istringstream stream(text);
    Point point;
    BOOST_REQUIRE(stream >> point[0] >> point[1]);
    return point;
  }

  static Polyline polyline(std::string text)
  {
    std::replace_if(
      text.begin(), text.end(), [](char c) { return c == 'M' || c == 'L'; }, ' ');
    std::istringstream stream(text);
    Polyline points;
    for(Point point; stream >> point[0] >> point[1];)
      points.push_back(point);
    return points;
  }
};

template <class G>
std::string drawn(const G& graph)
{
  std::ostringstream stream;
  CGAL::Reeb_graph::write_svg(stream, graph);
  return stream.str();
}

// The height of a value by the axis, told from two of its ticks; of no number if there is one tick only.
double height_by_axis(const Drawing& drawing, double value)
{
  std::vector<std::pair<double, double>> ticks;
  for(const auto& tick : drawing.ticks)
    if(tick.first.find_first_of("0123456789") != std::string::npos)
      ticks.emplace_back(std::stod(tick.first), tick.second[1]);
  if(ticks.size() < 2)
    return std::numeric_limits<double>::quiet_NaN();
  const auto [first, last] = std::make_pair(ticks.front(), ticks.back());
  // halves, as the range can be too large for a number
  return first.second
       + (last.second - first.second) * ((value / 2 - first.first / 2) / (last.first / 2 - first.first / 2));
}

// whether a line meets the box of a label
bool is_crossed(const Drawing::Label& label, double half_height, const Polyline& line)
{
  for(std::size_t k = 1; k < line.size(); ++k)
  {
    // the part of the segment, from 0 to 1, within the sides, and then within the heights of the box
    double begin = 0, end = 1;
    const std::array<double, 2> lowest = {label.left, label.middle - half_height};
    const std::array<double, 2> highest = {label.right, label.middle + half_height};
    for(int i : {0, 1})
    {
      const double from = line[k - 1][i], step = line[k][i] - from;
      if(step == 0)
      {
        if(from <= lowest[i] || from >= highest[i])
          end = -1;
        continue;
      }
      const auto [first, last] = std::minmax({(lowest[i] - from) / step, (highest[i] - from) / step});
      begin = (std::max)(begin, first);
      end = (std::min)(end, last);
    }
    if(begin < end)
      return true;
  }
  return false;
}

// Nodes of nearly one height are beside each other.
void test_distances(const Drawing& drawing)
{
  const double diameter = 2.4 * drawing.radius - 0.1; // rounded
  for(std::size_t i = 0; i < drawing.nodes.size(); ++i)
    for(std::size_t j = 0; j < i; ++j)
    {
      const Point &p = drawing.nodes[i], &q = drawing.nodes[j];
      BOOST_TEST((std::abs(p[1] - q[1]) > diameter || std::abs(p[0] - q[0]) > diameter),
                 "the nodes " << j << " and " << i << " lie on each other");
    }
}

template <class G>
void test_drawing(const G& graph)
{
  const Drawing drawing(drawn(graph));
  BOOST_REQUIRE(drawing.nodes.size() == num_vertices(graph));
  BOOST_REQUIRE(drawing.arcs.size() == num_edges(graph));
  for(std::size_t node = 0; node < num_vertices(graph); ++node)
    if(std::isfinite(graph[node].value))
      BOOST_TEST(!(std::abs(drawing.nodes[node][1] - height_by_axis(drawing, graph[node].value)) > 0.1));
  const std::vector<random_graphs::Arc> arcs = arcs_of(graph);
  for(std::size_t i = 0; i < arcs.size(); ++i)
  {
    BOOST_TEST((drawing.arcs[i].front() == drawing.nodes[arcs[i].first]));
    BOOST_TEST((drawing.arcs[i].back() == drawing.nodes[arcs[i].second]));
    for(std::size_t k = 1; k < drawing.arcs[i].size(); ++k)
      BOOST_TEST(drawing.arcs[i][k][1] <= drawing.arcs[i][k - 1][1]);
  }
  test_distances(drawing);
  const double half_height = 5, radius = 3;
  for(std::size_t i = 0; i < drawing.labels.size(); ++i)
  {
    const auto& a = drawing.labels[i];
    for(std::size_t j = 0; j < i; ++j)
    {
      const auto& b = drawing.labels[j];
      BOOST_TEST(!(a.left < b.right && b.left < a.right && std::abs(a.middle - b.middle) < 2 * half_height),
                 "the label " << a.text << " lies on " << b.text);
    }
    for(const Point& node : drawing.nodes)
      BOOST_TEST(!(a.left < node[0] + radius && node[0] - radius < a.right
                   && std::abs(a.middle - node[1]) < half_height + radius),
                 "the label " << a.text << " lies on a node");
    for(const Polyline& arc : drawing.arcs)
      BOOST_TEST(!is_crossed(a, half_height, arc), "the label " << a.text << " lies on an arc");
  }
}
} // namespace

BOOST_AUTO_TEST_CASE(nodes_lie_at_their_values_and_arcs_ascend_in_columns_of_their_own)
{
  for(std::size_t seed = 0; seed < 2000; ++seed)
    BOOST_TEST_CONTEXT("seed " << seed)
    {
      Random random(seed);
      test_layout(random_graph_with_values(seed, random));
    }
}

BOOST_AUTO_TEST_CASE(trees_whose_branches_go_one_way_or_are_at_one_trunk_have_no_crossings)
{
  for(std::size_t seed = 0; seed < 600; ++seed)
    BOOST_TEST_CONTEXT("seed " << seed)
    {
      Random random(seed);
      Graph tree = seed % 3 == 0 ? random_caterpillar(1 + random.below(25), random)
                                 : random_merge_tree(1 + random.below(60), random);
      if(seed % 3 == 1)
        tree = random_graphs::upside_down(tree);
      set_random_values(tree, 1, random);
      test_layout(tree);
      BOOST_TEST(number_of_crossings(CGAL::Reeb_graph::lay_out_in_plane(tree)) == 0u);
    }
}

BOOST_AUTO_TEST_CASE(drawings_of_graphs_tell_what_they_show)
{
  for(std::size_t seed = 0; seed < 300; ++seed)
    BOOST_TEST_CONTEXT("seed " << seed)
    {
      Random random(seed);
      test_drawing(random_graph_with_values(seed, random));
    }
}

BOOST_AUTO_TEST_CASE(graphs_of_meshes_are_drawn)
{
  for(std::size_t seed = 0; seed < 80; ++seed)
    BOOST_TEST_CONTEXT("seed " << seed)
    {
      Random random(seed);
      const auto classes = static_cast<std::size_t>(Mesh_class::NUMBER_OF_CLASSES);
      const auto field_classes = static_cast<std::size_t>(Field_class::NUMBER_OF_CLASSES);
      const Combinatorial_mesh mesh = random_meshes::random_mesh(static_cast<Mesh_class>(seed % classes), random);
      const auto field = static_cast<Field_class>(seed / classes % field_classes);
      const auto surface = make_mesh<mesh_builders::Surface_mesh>(mesh);
      const auto graph = graph_checks::compute(surface, random_meshes::random_field(mesh, field, random));
      test_layout(graph);
      test_drawing(graph);
    }
}

BOOST_AUTO_TEST_CASE(large_graphs_are_laid_out_in_little_time)
{
  Random random(7);
  const Graph graph = random_graphs::random_sparse_graph(60000, 2000, random);
  BOOST_TEST(CGAL::Reeb_graph::lay_out_in_plane(graph).arc_polylines.size() == num_edges(graph));

  // components with a loop and a leaf each
  std::vector<random_graphs::Arc> arcs;
  const std::size_t size = 60000;
  for(std::size_t node = 0; node < size; node += 5)
  {
    const std::vector<random_graphs::Arc> component = {{0, 1}, {1, 2}, {1, 3}, {2, 3}, {2, 4}, {3, 4}};
    for(const random_graphs::Arc& arc : component)
      arcs.emplace_back(node + arc.first, node + arc.second);
  }
  const Graph components = random_graphs::make_graph(size, arcs);
  BOOST_TEST(CGAL::Reeb_graph::lay_out_in_plane(components).arc_polylines.size() == arcs.size());
}

BOOST_AUTO_TEST_CASE(the_axis_names_the_field_and_its_unit)
{
  Graph graph = random_graphs::make_graph(4, {{0, 1}, {1, 2}, {1, 2}, {2, 3}});
  std::ostringstream stream;
  CGAL::Reeb_graph::write_svg(stream, graph,
                              parameters::field_name("<p> & \"q\"")
                                .field_unit("\xc2\xb5m")
                                .vertex_index_map(boost::typed_identity_property_map<std::size_t>()));
  const std::string svg = stream.str();
  const Drawing drawing(svg);
  BOOST_TEST(svg.find("&lt;p&gt; &amp; &quot;q&quot; [\xc2\xb5m]</text>") != std::string::npos);
  BOOST_TEST(svg.find("<script") == std::string::npos);
  BOOST_TEST(drawing.titles[5] == "node 1: saddle\n<p> & \"q\" 1 \xc2\xb5m\nvertex 1");
  BOOST_TEST(drawing.labels.size() == 8u);
  BOOST_TEST(svg.find("4 nodes, 4 arcs, 1 loop, 1 component") != std::string::npos);
  BOOST_TEST(drawn(graph) == drawn(Graph(graph)));
}

BOOST_AUTO_TEST_CASE(any_values_are_drawn)
{
  for(const std::vector<double>& values : {std::vector<double>{-1.7e308, 0, 1, 1.7e308},
                                           {0, 0, 0, 0},
                                           {-infinity, -infinity, infinity, infinity},
                                           {1e15, 1e15 + 1, 1e15 + 2, 1e15 + 3},
                                           {0, 1e-300, 2e-300, infinity}})
  {
    Graph graph = random_graphs::make_graph(4, {{0, 1}, {1, 2}, {1, 2}, {2, 3}});
    for(std::size_t node = 0; node < 4; ++node)
      graph[node].value = values[node];
    test_layout(graph);
    const std::string svg = drawn(graph);
    BOOST_TEST(svg.find("nan") == std::string::npos);
    test_drawing(graph);
  }
  BOOST_TEST(Drawing(drawn(Graph())).nodes.empty());
}

BOOST_AUTO_TEST_CASE(exact_values_are_drawn)
{
  const auto surface = make_mesh<mesh_builders::Surface_mesh>(random_meshes::seven_vertex_torus());
  std::vector<CGAL::Exact_rational> values;
  for(int i = 0; i < 7; ++i)
    values.emplace_back(i, 3);
  const auto graph = graph_checks::compute<mesh_builders::Surface_mesh, CGAL::Exact_rational>(surface, values);
  const Drawing drawing(drawn(graph));
  BOOST_TEST(drawing.nodes.size() == num_vertices(graph));
  BOOST_TEST((CGAL::Reeb_graph::lay_out_in_plane(graph).arc_polylines.front().front()[1] == 0));
}

BOOST_AUTO_TEST_CASE(arcs_that_do_not_ascend_cannot_be_drawn)
{
  Graph graph(2);
  add_edge(1, 0, graph);
  BOOST_CHECK_THROW(CGAL::Reeb_graph::lay_out_in_plane(graph), CGAL::Reeb_graph::Graph_mismatch_error);
  std::ostringstream stream;
  BOOST_CHECK_THROW(CGAL::Reeb_graph::write_svg(stream, graph), CGAL::Reeb_graph::Graph_mismatch_error);
  BOOST_CHECK_THROW(CGAL::Reeb_graph::write_svg("missing/graph.svg", Graph(1)), CGAL::Reeb_graph::File_error);
}

BOOST_AUTO_TEST_CASE(the_figure_of_the_demo_has_limbs_and_a_handle)
{
  const auto surface = make_mesh<mesh_builders::Surface_mesh>(generated_surfaces::standing_figure(10000));
  BOOST_TEST(CGAL::is_closed(surface));
  BOOST_TEST(CGAL::is_valid_polygon_mesh(surface));
  BOOST_TEST(surface.number_of_vertices() + surface.number_of_faces() == surface.number_of_edges()); // genus 1
  BOOST_TEST(surface.number_of_vertices() > 9000u);
  BOOST_TEST(surface.number_of_vertices() < 11000u);
  std::vector<double> heights;
  for(const auto v : surface.vertices())
    heights.push_back(surface.point(v).z());
  const auto graph = graph_checks::compute(surface, heights);
  BOOST_TEST(CGAL::Reeb_graph::number_of_components(graph) == 1u);
  BOOST_TEST(CGAL::Reeb_graph::number_of_loops(graph) == 1u);
  std::size_t minima = 0, maxima = 0;
  for(std::size_t node = 0; node < num_vertices(graph); ++node)
  {
    minima += in_degree(node, graph) == 0 ? 1 : 0;
    maxima += out_degree(node, graph) == 0 ? 1 : 0;
  }
  BOOST_TEST(minima == 2u); // the feet
  BOOST_TEST(maxima == 3u); // the head, the hand, and the bird
  test_layout(graph);
  BOOST_TEST(number_of_crossings(CGAL::Reeb_graph::lay_out_in_plane(graph)) == 0u);
  test_drawing(graph);
}

BOOST_AUTO_TEST_SUITE_END()
