// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#include <boost/test/unit_test.hpp>

#include "curve_samples.h"
#include "graph_checks.h"

#include <CGAL/Exact_rational.h>
#include <CGAL/Lazy_exact_nt.h>
#include <CGAL/Reeb_graph.h>
#include <CGAL/Reeb_graph/curves/cut_along_contours.h>
#include <CGAL/Reeb_graph/curves/cutting_system.h>
#include <CGAL/Reeb_graph/curves/segmentation.h>

#include <boost/mpl/list.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <limits>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

// All functions for graphs, on values in any order and of any type: what they give is the same as that of ascending
// numbers.

BOOST_AUTO_TEST_SUITE(test_orders)

namespace parameters = CGAL::parameters;
using CGAL::Reeb_graph::Embedding_manner;
using curve_samples::Sample;
using mesh_builders::Mesh_numbers;
using mesh_builders::Surface_mesh;

namespace {
template <class Scalar>
using Map_of = Surface_mesh::Property_map<Surface_mesh::Vertex_index, Scalar>;

// Numbers that ascend, that fall, or whose places are in a table.
class Traits_with_order : public CGAL::Reeb_graph_traits<Surface_mesh, Map_of<double>>
{
public:
  class Less_scalar
  {
  public:
    Less_scalar(double sign, const std::vector<double>* places) : sign_(sign), places_(places) {}
    bool operator()(double a, double b) const { return place(a) < place(b); }

  private:
    double place(double a) const { return places_ != nullptr ? places_->at(static_cast<std::size_t>(a)) : sign_ * a; }

    double sign_;
    const std::vector<double>* places_;
  };

  explicit Traits_with_order(double sign, const std::vector<double>* places = nullptr) : sign_(sign), places_(places) {}
  Less_scalar less_scalar_object() const { return Less_scalar(sign_, places_); }

private:
  double sign_;
  const std::vector<double>* places_;
};

typedef std::pair<int, double> Pair;
typedef boost::mpl::list<signed char, std::int64_t, CGAL::Exact_rational> Numbers;

// Pairs that stand for numbers, in the order of these.
struct Traits_of_pairs : CGAL::Reeb_graph_traits<Surface_mesh, Map_of<Pair>>
{
  struct To_double
  {
    double operator()(const Pair& pair) const { return 16. * pair.first + pair.second; }
  };
  struct From_double
  {
    Pair operator()(double number) const
    {
      const int first = static_cast<int>(std::floor(number / 16));
      return {first, number - 16. * first};
    }
  };
  To_double scalar_to_double_object() const { return To_double(); }
  From_double scalar_from_double_object() const { return From_double(); }
};

// The field of a mesh or of a copy of it.
template <class Scalar>
Map_of<Scalar> values_of(Surface_mesh& mesh)
{
  return mesh.add_property_map<Surface_mesh::Vertex_index, Scalar>("v:value").first;
}

// What the functions give. Numbers have been multiplied by a sign where they are values.
struct Outcome
{
  std::vector<graph_checks::Plain_graph> graphs;
  std::vector<std::vector<double>> heights, values, numbers;
  std::vector<std::string> files;
};

template <class Write>
std::string written(const Write& write)
{
  std::ostringstream out;
  write(out);
  return out.str();
}

// How high the nodes of a drawing are, in pixels.
std::vector<double> heights_of_nodes(const std::string& svg)
{
  std::vector<double> heights;
  const std::size_t end = svg.find("</g>\n<g id=\"node_labels\"");
  for(std::size_t i = svg.find("<g id=\"nodes\""); (i = svg.find("translate(", i + 1)) < end;)
  {
    std::istringstream point(svg.substr(i + 10, 40));
    double x = 0, y = 0;
    BOOST_REQUIRE(point >> x >> y);
    heights.push_back(-y);
  }
  return heights;
}

template <class Graph, class NamedParameters>
void draw(const Graph& graph, const NamedParameters& np, double sign, Outcome& outcome)
{
  const auto layout = CGAL::Reeb_graph::lay_out_in_plane(graph, np);
  outcome.numbers.push_back(layout.node_positions);
  for(const auto& polyline : layout.arc_polylines)
  {
    std::vector<double> heights;
    for(const auto& point : polyline)
    {
      outcome.numbers.push_back({point[0]});
      heights.push_back(sign * point[1]);
    }
    BOOST_TEST(std::is_sorted(heights.begin(), heights.end()));
    outcome.values.push_back(heights);
  }
  outcome.files.push_back(written([&](std::ostream& out) { CGAL::Reeb_graph::write_svg(out, graph, np); }));
  outcome.heights.push_back(heights_of_nodes(outcome.files.back()));
  BOOST_TEST(outcome.heights.back().size() == num_vertices(graph));
  BOOST_TEST(std::is_sorted(outcome.heights.back().begin(), outcome.heights.back().end()));
}

// `simplify_np` asks for loops to be cancelled, too.
template <class Graph, class NamedParameters, class SimplifyParameters>
void simplify(const Surface_mesh& mesh,
              const Graph& graph,
              const NamedParameters& np,
              const SimplifyParameters& simplify_np,
              Outcome& outcome)
{
  outcome.values.push_back(CGAL::Reeb_graph::arc_persistences(graph, np));
  std::vector<CGAL::Reeb_graph::Persistence_pair<std::size_t>> pairs;
  CGAL::Reeb_graph::persistence_pairs(graph, std::back_inserter(pairs));
  for(const auto& pair : pairs)
  {
    outcome.numbers.push_back({double(pair.lower_node), double(pair.upper_node), double(pair.kind)});
    outcome.values.push_back({CGAL::Reeb_graph::persistence(graph, pair, np)});
  }
  const auto& persistences = outcome.values.front();
  const double threshold = persistences.empty() ? 1 : persistences[persistences.size() / 2];
  Graph simplified;
  CGAL::Reeb_graph::simplify(graph, threshold, simplified, simplify_np);
  outcome.graphs.push_back(graph_checks::plain(Mesh_numbers<Surface_mesh>(mesh), simplified));
}

template <class Graph, class NamedParameters>
void write(const Surface_mesh& mesh, const Graph& graph, const NamedParameters& np, Outcome& outcome)
{
  const auto indices = get(boost::vertex_index, mesh);
  const auto halfedge_indices = get(boost::halfedge_index, mesh);
  const auto add = [&](const auto& write) { outcome.files.push_back(written(write)); };
  add([&](std::ostream& out) { CGAL::Reeb_graph::write_graphviz(out, graph, indices, np); });
  add([&](std::ostream& out) { CGAL::Reeb_graph::write_graphml(out, graph, indices, np); });
  add([&](std::ostream& out) { CGAL::Reeb_graph::write_graphml(out, graph, indices, halfedge_indices, np); });
  std::istringstream in(outcome.files.back());
  Graph read;
  CGAL::Reeb_graph::read_graphml(in, mesh, read, np);
  BOOST_TEST(graph_checks::are_identical(read, graph));
}

template <class Augmentation>
void embed_and_write(const Augmentation& augmentation, double sign, Outcome& outcome)
{
  const auto& graph = augmentation.graph();
  const auto& mesh = augmentation.mesh();
  const auto indices = get(boost::vertex_index, mesh);
  for(const Embedding_manner manner : {Embedding_manner::CENTROIDS, Embedding_manner::ON_SURFACE})
  {
    const auto embedding = CGAL::Reeb_graph::embed(augmentation, parameters::embedding_manner(manner));
    for(const auto& polyline : embedding.arc_polylines)
      for(const auto& point : polyline)
        outcome.values.push_back({point.x(), point.y(), point.z()});
    for(const auto& values : embedding.arc_values)
      for(const double value : values)
        outcome.values.push_back({sign * value});
    const auto add = [&](const auto& write) { outcome.files.push_back(written(write)); };
    add([&](std::ostream& out) { CGAL::Reeb_graph::write_vtp(out, graph, embedding, indices); });
    add([&](std::ostream& out) { CGAL::Reeb_graph::write_json(out, mesh, graph, embedding, indices); });
    add([&](std::ostream& out) { CGAL::Reeb_graph::write_nodes_csv(out, graph, embedding, indices); });
    add([&](std::ostream& out) { CGAL::Reeb_graph::write_arcs_csv(out, graph, embedding); });
  }
}

// Cuts along contours of which several are between the same two vertices, and looks at the field there.
template <class Scalar, class Augmentation, class Traits>
void cut_along_contours(const Augmentation& augmentation, const Traits& traits, double sign, Outcome& outcome)
{
  Surface_mesh mesh(augmentation.mesh());
  const auto values = values_of<Scalar>(mesh);
  std::vector<typename Augmentation::Contour> contours;
  for(const auto arc : CGAL::make_range(edges(augmentation.graph())))
    for(const double t : {0.5003, 0.2501, 0.7502})
      contours.push_back(augmentation.contour(arc, t));
  std::vector<CGAL::Reeb_graph::Curve<Surface_mesh::Halfedge_index>> curves;
  const auto np = parameters::geom_traits(traits);
  CGAL::Reeb_graph::cut_along_contours(mesh, values, contours, std::back_inserter(curves), np);
  const CGAL::Reeb_graph::internal::Scalar_conversion<Traits> conversion(traits);
  for(const auto& curve : curves)
  {
    outcome.values.push_back({curve.length, sign * curve.value});
    for(const auto h : curve.halfedges)
      outcome.values.push_back({sign * conversion.to_double(get(values, target(h, mesh)))});
  }
  typename Traits::Graph graph;
  CGAL::compute_reeb_graph(mesh, values, graph, np);
  outcome.values.push_back({double(num_vertices(graph)), double(num_edges(graph))});
}

template <class Scalar, class Graph, class Traits>
void cut(const Surface_mesh& mesh, const Graph& graph, const Traits& traits, double sign, Outcome& outcome)
{
  const auto np = parameters::geom_traits(traits);
  Surface_mesh cut_mesh(mesh), segmented_mesh(mesh);
  std::vector<CGAL::Reeb_graph::Curve<Surface_mesh::Halfedge_index>> curves;
  CGAL::Reeb_graph::cutting_system(cut_mesh, values_of<Scalar>(cut_mesh), std::back_inserter(curves),
                                   parameters::borders(CGAL::Reeb_graph::Borders::MAKE_LEVEL).geom_traits(traits));
  outcome.numbers.push_back({double(curves.size())});
  for(const auto& curve : curves)
    outcome.values.push_back({curve.length, sign * curve.value});
  const auto patches = segmented_mesh.add_property_map<Surface_mesh::Face_index, std::size_t>("f:patch").first;
  outcome.numbers.push_back(
    {double(CGAL::Reeb_graph::segment_by_arcs(segmented_mesh, values_of<Scalar>(segmented_mesh), graph, patches, np)),
     double(segmented_mesh.number_of_faces())});
}

template <class Scalar, class Traits>
Outcome all_of(const Sample& sample, const std::vector<Scalar>& scalars, const Traits& traits, double sign)
{
  Outcome outcome;
  Surface_mesh mesh;
  mesh_builders::build(mesh, sample.soup);
  const Map_of<Scalar> map = values_of<Scalar>(mesh);
  for(const auto v : mesh.vertices())
    put(map, v, scalars[v]);
  typename Traits::Graph graph;
  const auto np = parameters::geom_traits(traits);
  CGAL::compute_reeb_graph(mesh, map, graph, np);
  outcome.graphs.push_back(graph_checks::plain(Mesh_numbers<Surface_mesh>(mesh), graph));
  simplify(mesh, graph, np, parameters::cancel_loops(true).geom_traits(traits), outcome);
  draw(graph, np, sign, outcome);
  write(mesh, graph, np, outcome);
  outcome.values.push_back(CGAL::Reeb_graph::arc_lengths(mesh, map, graph, np));
  const CGAL::Reeb_graph::Augmentation augmentation(mesh, map, graph, np);
  outcome.numbers.push_back(CGAL::Reeb_graph::arc_areas(mesh, graph, augmentation.locate_vertices()));
  embed_and_write(augmentation, sign, outcome);
  cut_along_contours<Scalar>(augmentation, traits, sign, outcome);
  cut<Scalar>(mesh, graph, traits, sign, outcome);
  return outcome;
}

// A graph with values of another type.
template <class Number>
auto copy_of_graph(const graph_checks::Graph_of<Surface_mesh>& graph)
{
  graph_checks::Graph_of<Surface_mesh, Number> other(num_vertices(graph));
  for(std::size_t node = 0; node != num_vertices(graph); ++node)
    other[node] = {static_cast<Number>(graph[node].value), graph[node].vertex, graph[node].kind};
  for(const auto arc : CGAL::make_range(edges(graph)))
    add_edge(source(arc, graph), target(arc, graph), other);
  return other;
}

// Functions that know the graph only.
template <class Number>
Outcome all_of_graph(const Surface_mesh& mesh, const graph_checks::Graph_of<Surface_mesh>& graph)
{
  const auto other = copy_of_graph<Number>(graph);
  Outcome outcome;
  simplify(mesh, other, parameters::default_values(), parameters::cancel_loops(true), outcome);
  draw(other, parameters::default_values(), 1, outcome);
  return outcome;
}
} // namespace

BOOST_AUTO_TEST_CASE(all_functions_in_any_order)
{
  for(std::size_t seed = 0; seed != 30; ++seed)
    BOOST_TEST_CONTEXT("seed " << seed)
    {
      Sample sample = curve_samples::random_sample(8 * seed, seed % 2 == 1, 1, 1);
      random_meshes::Random random(seed);
      random.shuffle(sample.values); // so that borders are no levels
      for(double& value : sample.values)
        value = std::floor(value);
      const Outcome expected = all_of(sample, sample.values, Traits_with_order(1), 1);

      std::vector<double> falling, identifiers;
      std::vector<Pair> pairs;
      for(const double value : sample.values)
      {
        falling.push_back(-value);
        identifiers.push_back(static_cast<double>(identifiers.size()));
        pairs.push_back(Traits_of_pairs::From_double()(value));
      }
      const Outcome fallen = all_of(sample, falling, Traits_with_order(-1), -1);
      BOOST_TEST((fallen.graphs == expected.graphs));
      BOOST_TEST((fallen.heights == expected.heights));
      BOOST_TEST((fallen.numbers == expected.numbers));
      BOOST_TEST((fallen.values == expected.values));

      const Outcome paired = all_of(sample, pairs, Traits_of_pairs(), 1);
      BOOST_TEST((paired.graphs == expected.graphs));
      BOOST_TEST((paired.values == expected.values));
      BOOST_TEST((paired.numbers == expected.numbers));
      BOOST_TEST((paired.files == expected.files));

      const Outcome tabled = all_of(sample, identifiers, Traits_with_order(1, &sample.values), 1);
      BOOST_TEST((tabled.graphs.front() == expected.graphs.front()));
    }
}

BOOST_AUTO_TEST_CASE_TEMPLATE(graphs_with_values_of_any_type_of_number, Number, Numbers)
{
  for(std::size_t seed = 0; seed != 20; ++seed)
    BOOST_TEST_CONTEXT("seed " << seed)
    {
      const Sample sample = curve_samples::random_sample(8 * seed, false, 1, 1); // permutations
      const auto mesh = mesh_builders::make_mesh<Surface_mesh>(sample.soup);
      const auto graph = graph_checks::compute(mesh, sample.values);
      const Outcome outcome = all_of_graph<Number>(mesh, graph), expected = all_of_graph<double>(mesh, graph);
      BOOST_TEST((outcome.graphs == expected.graphs));
      BOOST_TEST((outcome.numbers == expected.numbers));
      BOOST_TEST((outcome.values == expected.values));
      BOOST_TEST((outcome.files == expected.files));
    }
}

// Each lazy number is rounded by the width of its own interval, so that some come out of order.
BOOST_AUTO_TEST_CASE(exact_values_whose_rounding_errors_differ)
{
  typedef CGAL::Lazy_exact_nt<CGAL::Exact_rational> Lazy;
  const double step = std::ldexp(1, -16), width = std::ldexp(1, 40);
  random_meshes::Random random(1);
  std::size_t number_of_disordered = 0;
  for(std::size_t seed = 0; seed != 20; ++seed)
    BOOST_TEST_CONTEXT("seed " << seed)
    {
      const Sample sample = curve_samples::random_sample(8 * seed, false, 1, 1); // permutations
      const auto mesh = mesh_builders::make_mesh<Surface_mesh>(sample.soup);
      const auto graph = graph_checks::compute(mesh, sample.values);
      const double sign = seed % 2 == 0 ? 1 : -1;
      graph_checks::Graph_of<Surface_mesh, Lazy> lazy = copy_of_graph<Lazy>(graph);
      bool is_ordered = true;
      for(std::size_t node = 0; node != num_vertices(graph); ++node)
      {
        const Lazy value = Lazy(1000) + Lazy(sign * step * graph[node].value);
        lazy[node].value = random.below(2) == 0 ? value : (value + Lazy(width)) - Lazy(width);
        is_ordered =
          is_ordered
          && (node == 0 || sign * CGAL::to_double(lazy[node - 1].value) <= sign * CGAL::to_double(lazy[node].value));
      }
      number_of_disordered += is_ordered ? 0 : 1;
      Outcome outcome;
      draw(lazy, parameters::default_values(), sign, outcome);
      for(const std::vector<double>& heights : outcome.values)
        for(const double height : heights)
          BOOST_TEST(std::abs(sign * height - 1000) < 0.1);
    }
  BOOST_TEST(number_of_disordered > 10u);
}

BOOST_AUTO_TEST_SUITE_END()
