// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#include <boost/test/unit_test.hpp>

#include "graph_checks.h"
#include "mesh_builders.h"
#include "random_fields.h"
#include "random_meshes.h"

#include <CGAL/Polygon_mesh_processing/border.h>

#include <boost/graph/connected_components.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <iterator>

#include <set>
#include <tuple>
#include <vector>

// What holds for every Reeb graph, whatever it is.

BOOST_AUTO_TEST_SUITE(test_properties)

using CGAL::Reeb_graph::Critical_vertex_counts;
using CGAL::Reeb_graph::Node_kind;
using generated_surfaces::Triangle_soup;
using graph_checks::compute_plain;
using graph_checks::Plain_arc;
using graph_checks::Plain_graph;
using mesh_builders::make_mesh;
using mesh_builders::Polyhedron;
using mesh_builders::Polyhedron_with_id;
using mesh_builders::Surface_mesh;
using random_meshes::Field_class;
using random_meshes::Mesh_class;
using random_meshes::Random;

namespace {
struct Sample
{
  Triangle_soup soup;
  std::vector<double> values;
};

Sample random_sample(std::size_t seed)
{
  Random random(seed);
  const auto mesh_class = static_cast<Mesh_class>(seed % static_cast<int>(Mesh_class::NUMBER_OF_CLASSES));
  const auto field_class = static_cast<Field_class>(random.below(static_cast<int>(Field_class::NUMBER_OF_CLASSES)));
  const auto mesh = random_meshes::random_mesh(mesh_class, random);
  return {mesh_builders::make_soup(mesh), random_meshes::random_field(mesh, field_class, random)};
}

// small meshes of all classes, and one of genus 3
template <class Test>
void for_each_sample(std::size_t number_of_seeds, const Test& test)
{
  for(std::size_t seed = 0; seed < number_of_seeds; ++seed)
    BOOST_TEST_CONTEXT("seed " << seed)
  test(random_sample(seed));
  const Triangle_soup soup = generated_surfaces::closed_surface(3, 1000);
  std::vector<double> tilted_height;
  for(const auto& p : soup.points)
    tilted_height.push_back(p[0] + 0.3 * p[1] + 0.2 * p[2]);
  BOOST_TEST_CONTEXT("genus 3")
  test(Sample{soup, tilted_height});
}

Plain_graph surface_mesh_graph(const Sample& sample, bool keeps_degree_two_nodes = false)
{
  return compute_plain(make_mesh<Surface_mesh>(sample.soup), sample.values, keeps_degree_two_nodes);
}

Plain_graph contracted_graph(const Sample& sample)
{
  const auto mesh = make_mesh<Surface_mesh>(sample.soup);
  graph_checks::Graph_of<Surface_mesh> graph;
  CGAL::compute_reeb_graph(mesh, CGAL::Reeb_graph::make_scalar_map(mesh, sample.values), graph,
                           CGAL::parameters::ties(CGAL::Reeb_graph::Ties::CONTRACT));
  return graph_checks::plain(mesh_builders::Mesh_numbers<Surface_mesh>(mesh), graph);
}

typedef std::multiset<std::pair<std::size_t, std::size_t>> Ends_of_arcs;

Ends_of_arcs ends_of_arcs(const Plain_graph& graph)
{
  Ends_of_arcs ends;
  for(const Plain_arc& arc : graph.arcs)
    ends.emplace(arc.lower, arc.upper);
  return ends;
}

Node_kind upside_down(Node_kind kind)
{
  return kind == Node_kind::MINIMUM ? Node_kind::MAXIMUM : kind == Node_kind::MAXIMUM ? Node_kind::MINIMUM : kind;
}

// with vertex v of n as vertex n - 1 - v
Plain_graph upside_down(const Plain_graph& graph, std::size_t n)
{
  Plain_graph result;
  for(auto node = graph.nodes.rbegin(); node != graph.nodes.rend(); ++node)
    result.nodes.emplace_back(n - 1 - node->first, upside_down(node->second));
  for(const Plain_arc& arc : graph.arcs)
    result.arcs.push_back({n - 1 - arc.upper, n - 1 - arc.lower, {}});
  return result;
}

// reverses the order of the vertices, and so the ties, and the field
Sample reverse(Sample sample)
{
  for(auto& t : sample.soup.triangles)
    for(std::size_t& v : t)
      v = sample.values.size() - 1 - v;
  std::reverse(sample.soup.points.begin(), sample.soup.points.end());
  std::reverse(sample.values.begin(), sample.values.end());
  for(double& value : sample.values)
    value = -value;
  return sample;
}

std::size_t number_of_loops(const Plain_graph& graph, std::size_t number_of_components)
{
  return graph.arcs.size() + number_of_components - graph.nodes.size();
}

struct Counting_visitor : CGAL::Reeb_graph::Default_visitor
{
  Critical_vertex_counts* counts;
  void critical_vertices(const Critical_vertex_counts& c) { *counts = c; }
};

Critical_vertex_counts critical_vertex_counts(const Surface_mesh& mesh, const std::vector<double>& values)
{
  Critical_vertex_counts counts;
  Counting_visitor visitor;
  visitor.counts = &counts;
  graph_checks::Graph_of<Surface_mesh> graph;
  CGAL::compute_reeb_graph(mesh, CGAL::Reeb_graph::make_scalar_map(mesh, values), graph,
                           CGAL::parameters::visitor(std::ref(visitor)));
  return counts;
}

struct Property_names
{
  std::vector<std::string> vertices, halfedges, edges, faces;

  explicit Property_names(const Surface_mesh& mesh)
    : vertices(mesh.properties<Surface_mesh::Vertex_index>()),
      halfedges(mesh.properties<Surface_mesh::Halfedge_index>()),
      edges(mesh.properties<Surface_mesh::Edge_index>()),
      faces(mesh.properties<Surface_mesh::Face_index>())
  {}

  friend bool operator==(const Property_names& a, const Property_names& b)
  {
    return std::tie(a.vertices, a.halfedges, a.edges, a.faces) == std::tie(b.vertices, b.halfedges, b.edges, b.faces);
  }
};
} // namespace

BOOST_AUTO_TEST_CASE(the_negative_field_has_the_graph_upside_down)
{
  for_each_sample(400, [](const Sample& sample) {
    for(bool keeps_degree_two_nodes : {false, true})
    {
      const std::size_t n = sample.values.size();
      const Plain_graph expected = upside_down(surface_mesh_graph(sample, keeps_degree_two_nodes), n);
      const Plain_graph graph = surface_mesh_graph(reverse(sample), keeps_degree_two_nodes);
      BOOST_TEST((graph.nodes == expected.nodes));
      BOOST_TEST((ends_of_arcs(graph) == ends_of_arcs(expected)));
    }
  });
}

BOOST_AUTO_TEST_CASE(a_monotone_transformation_changes_nothing)
{
  for_each_sample(400, [](const Sample& sample) {
    const Surface_mesh mesh = make_mesh<Surface_mesh>(sample.soup);
    const Plain_graph expected = compute_plain(mesh, sample.values);

    const std::set<double> levels(sample.values.begin(), sample.values.end());
    std::vector<int> ranks;
    std::vector<double> cubes; // of integers, so that rounding makes no ties
    for(double value : sample.values)
    {
      ranks.push_back(static_cast<int>(std::distance(levels.begin(), levels.find(value))) - 5);
      cubes.push_back(std::pow(ranks.back(), 3));
    }
    BOOST_TEST((compute_plain(mesh, ranks) == expected));
    BOOST_TEST((compute_plain(mesh, cubes) == expected));
  });
}

BOOST_AUTO_TEST_CASE(the_order_of_the_faces_changes_nothing)
{
  std::size_t seed = 0;
  for_each_sample(400, [&](const Sample& sample) {
    Random random(seed++);
    Sample shuffled = sample;
    random.shuffle(shuffled.soup.triangles);
    for(auto& t : shuffled.soup.triangles)
      std::rotate(t.begin(), t.begin() + random.below(3), t.end());
    BOOST_TEST((surface_mesh_graph(shuffled) == surface_mesh_graph(sample)));
    BOOST_TEST((contracted_graph(shuffled) == contracted_graph(sample)));
  });
}

// Two arcs between the same nodes, whose chains end at the same vertex: only where they begin can tell them apart.
BOOST_AUTO_TEST_CASE(the_order_of_the_faces_changes_nothing_at_plateaus)
{
  for(std::size_t seed = 0; seed < 200; ++seed)
  {
    Random random(seed);
    Sample sample = {generated_surfaces::torus(3 + random.below(2), 4), {}};
    for(std::size_t v = 0; v != sample.soup.points.size(); ++v)
      sample.values.push_back(static_cast<double>(random.below(2)));
    Sample shuffled = sample;
    random.shuffle(shuffled.soup.triangles);
    BOOST_TEST_CONTEXT("seed " << seed)
    BOOST_TEST((contracted_graph(shuffled) == contracted_graph(sample)));
  }
}

BOOST_AUTO_TEST_CASE(chains_that_have_been_moved_from_are_empty)
{
  auto graph = graph_checks::compute(make_mesh<Surface_mesh>(generated_surfaces::torus(4, 4)),
                                     std::vector<double>{0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15});
  auto& chain = graph[*edges(graph).first].chain;
  const auto copy = chain;
  BOOST_TEST_REQUIRE(!copy.empty());
  const auto moved = std::move(chain);
  BOOST_TEST((moved == copy));
  BOOST_TEST(chain.empty());
  BOOST_TEST((chain.begin() == chain.end()));
}

BOOST_AUTO_TEST_CASE(the_orientation_changes_nothing)
{
  for_each_sample(400, [](const Sample& sample) {
    Sample mirrored = sample;
    for(auto& t : mirrored.soup.triangles)
      std::swap(t[0], t[1]);
    BOOST_TEST((surface_mesh_graph(mirrored) == surface_mesh_graph(sample)));
  });
}

BOOST_AUTO_TEST_CASE(names_of_vertices_change_nothing_where_there_are_no_ties)
{
  for(std::size_t seed = 0; seed < 300; ++seed)
    BOOST_TEST_CONTEXT("seed " << seed)
    {
      Random random(seed);
      auto mesh = random_meshes::random_mesh(static_cast<Mesh_class>(seed % 6), random);
      const auto values = random_meshes::random_permutation(mesh.number_of_vertices, random);
      // vertices in the order of the field
      auto sorted_mesh = mesh;
      auto sorted_values = values;
      std::sort(sorted_values.begin(), sorted_values.end());
      for(auto& t : sorted_mesh.triangles)
        for(std::size_t& v : t)
          v = static_cast<std::size_t>(values[v]);

      Plain_graph graph = surface_mesh_graph({mesh_builders::make_soup(mesh), values});
      for(auto& node : graph.nodes)
        node.first = static_cast<std::size_t>(values[node.first]);
      for(Plain_arc& arc : graph.arcs)
      {
        arc.lower = static_cast<std::size_t>(values[arc.lower]);
        arc.upper = static_cast<std::size_t>(values[arc.upper]);
        for(std::size_t& v : arc.chain_vertices)
          v = static_cast<std::size_t>(values[v]);
      }
      BOOST_TEST((surface_mesh_graph({mesh_builders::make_soup(sorted_mesh), sorted_values}) == graph));
    }
}

BOOST_AUTO_TEST_CASE(the_type_of_the_mesh_changes_nothing)
{
  for_each_sample(400, [](const Sample& sample) {
    for(bool keeps_degree_two_nodes : {false, true})
    {
      const Plain_graph expected = surface_mesh_graph(sample, keeps_degree_two_nodes);

      const auto polyhedron = make_mesh<Polyhedron>(sample.soup);
      BOOST_REQUIRE(num_vertices(polyhedron) == sample.soup.points.size());
      BOOST_REQUIRE(num_faces(polyhedron) == sample.soup.triangles.size());
      BOOST_TEST((compute_plain(polyhedron, sample.values, keeps_degree_two_nodes) == expected));

      Surface_mesh garbage;
      mesh_builders::build_with_garbage(garbage, sample.soup);
      BOOST_REQUIRE(garbage.has_garbage());
      BOOST_REQUIRE(garbage.number_of_vertices() == sample.soup.points.size());
      BOOST_REQUIRE(garbage.number_of_faces() == sample.soup.triangles.size());
      BOOST_TEST((compute_plain(garbage, sample.values, keeps_degree_two_nodes) == expected));
    }
  });
}

BOOST_AUTO_TEST_CASE(loops_and_critical_vertices_of_closed_surfaces)
{
  std::size_t number_of_simple_fields = 0;
  for(std::size_t seed = 0; seed < 400; ++seed)
    BOOST_TEST_CONTEXT("seed " << seed)
    {
      Random random(seed);
      const std::size_t genus = seed % 6;
      const auto combinatorial_mesh =
        random_meshes::random_closed_surface(static_cast<unsigned>(genus), random.below(30), random);
      const auto field_class = static_cast<Field_class>(seed % 5);
      const Sample sample = {mesh_builders::make_soup(combinatorial_mesh),
                             random_meshes::random_field(combinatorial_mesh, field_class, random)};
      const auto mesh = make_mesh<Surface_mesh>(sample.soup);
      const Critical_vertex_counts counts = critical_vertex_counts(mesh, sample.values);

      long characteristic = static_cast<long>(counts.minima + counts.maxima);
      bool is_simple = true;
      for(const auto& saddles : counts.saddles)
      {
        characteristic -= static_cast<long>(saddles.first * saddles.second);
        is_simple = is_simple && saddles.first == 1;
      }
      BOOST_TEST(characteristic == 2 - 2 * static_cast<long>(genus));
      BOOST_TEST(counts.isolated == 0);
      BOOST_TEST(counts.border_saddles == 0);

      const std::size_t loops = number_of_loops(compute_plain(mesh, sample.values), 1);
      BOOST_TEST(loops <= genus);
      if(is_simple)
        BOOST_TEST(loops == genus);
      number_of_simple_fields += is_simple ? 1 : 0;
    }
  BOOST_TEST(number_of_simple_fields > 20);
}

BOOST_AUTO_TEST_CASE(loops_of_generated_surfaces)
{
  for(unsigned genus = 0; genus <= 10; ++genus)
    BOOST_TEST_CONTEXT("genus " << genus)
    {
      Sample sample = {generated_surfaces::closed_surface(genus, 3000), {}};
      for(const auto& p : sample.soup.points)
        sample.values.push_back(p[0] + 0.37 * p[1] + 0.21 * p[2]);
      BOOST_TEST(number_of_loops(surface_mesh_graph(sample), 1) == genus);
    }
}

BOOST_AUTO_TEST_CASE(loops_of_bordered_surfaces)
{
  for(std::size_t seed = 0; seed < 400; ++seed)
    BOOST_TEST_CONTEXT("seed " << seed)
    {
      Random random(seed);
      const std::size_t genus = 1 + seed % 3;
      auto combinatorial_mesh = random_meshes::random_closed_surface(static_cast<unsigned>(genus), 20, random);
      random_meshes::remove_random_triangles(combinatorial_mesh, 1 + random.below(5), random);
      auto mesh = make_mesh<Surface_mesh>(mesh_builders::make_soup(combinatorial_mesh));
      std::vector<Surface_mesh::Halfedge_index> border_loops;
      CGAL::Polygon_mesh_processing::extract_boundary_cycles(mesh, std::back_inserter(border_loops));
      const auto values = random_meshes::random_permutation(combinatorial_mesh.number_of_vertices, random);
      const auto graph = graph_checks::compute(mesh, values);
      BOOST_TEST(num_edges(graph) + 1 <= num_vertices(graph) + 2 * genus + border_loops.size() - 1);
    }
}

BOOST_AUTO_TEST_CASE(the_graph_has_as_many_components_as_the_mesh)
{
  for_each_sample(300, [](const Sample& sample) {
    const auto mesh = make_mesh<Surface_mesh>(sample.soup);
    const auto graph = graph_checks::compute(mesh, sample.values);
    boost::adjacency_list<boost::vecS, boost::vecS, boost::undirectedS> reeb(num_vertices(graph)),
      surface(sample.soup.points.size());
    for(const auto& t : sample.soup.triangles)
      for(int i = 0; i < 3; ++i)
        add_edge(t[i], t[(i + 1) % 3], surface);
    BGL_FORALL_EDGES_T(arc, graph, graph_checks::Graph_of<Surface_mesh>)
    add_edge(source(arc, graph), target(arc, graph), reeb);
    std::vector<std::size_t> components((std::max)(num_vertices(reeb), num_vertices(surface)) + 1);
    const auto map_of = [&](const auto& g) {
      return boost::make_iterator_property_map(components.begin(), get(boost::vertex_index, g));
    };
    BOOST_TEST(boost::connected_components(reeb, map_of(reeb))
               == boost::connected_components(surface, map_of(surface)));
  });
}

BOOST_AUTO_TEST_CASE(a_surface_mesh_is_left_unchanged)
{
  for_each_sample(50, [](const Sample& sample) {
    const auto mesh = make_mesh<Surface_mesh>(sample.soup);
    const Property_names before(mesh);
    {
      const auto scalar_map = CGAL::Reeb_graph::make_scalar_map(mesh, sample.values);
      const Property_names with_scalar_map(mesh);
      graph_checks::Graph_of<Surface_mesh> graph;
      CGAL::compute_reeb_graph(mesh, scalar_map, graph);
      BOOST_TEST((Property_names(mesh) == with_scalar_map));
    }
    BOOST_TEST((Property_names(mesh) == before));
  });
}

BOOST_AUTO_TEST_CASE(the_ids_of_a_polyhedron_are_neither_used_nor_changed)
{
  for_each_sample(50, [](const Sample& sample) {
    auto polyhedron = make_mesh<Polyhedron_with_id>(sample.soup);
    for(const auto v : vertices(polyhedron))
      v->id() = 7;
    for(const auto f : faces(polyhedron))
      f->id() = 7;
    for(const auto h : halfedges(polyhedron))
      h->id() = 7;
    BOOST_TEST((compute_plain(polyhedron, sample.values) == surface_mesh_graph(sample)));
    for(const auto v : vertices(polyhedron))
      BOOST_TEST(v->id() == 7u);
    for(const auto f : faces(polyhedron))
      BOOST_TEST(f->id() == 7u);
    for(const auto h : halfedges(polyhedron))
      BOOST_TEST(h->id() == 7u);
  });
}

BOOST_AUTO_TEST_CASE(an_old_content_of_the_graph_is_replaced)
{
  const Sample sample = random_sample(0);
  const auto mesh = make_mesh<Surface_mesh>(sample.soup);
  const auto scalar_map = CGAL::Reeb_graph::make_scalar_map(mesh, sample.values);
  graph_checks::Graph_of<Surface_mesh> graph;
  CGAL::compute_reeb_graph(mesh, scalar_map, graph);
  CGAL::compute_reeb_graph(mesh, scalar_map, graph);
  const mesh_builders::Mesh_numbers<Surface_mesh> numbers(mesh);
  BOOST_TEST((graph_checks::plain(numbers, graph) == surface_mesh_graph(sample)));
}

BOOST_AUTO_TEST_CASE(chains_are_a_property_map_and_outlive_their_graph)
{
  typedef graph_checks::Graph_of<Surface_mesh> Graph;
  typedef boost::edge_bundle_type<Graph>::type Arc;
  const Sample sample = random_sample(0);
  const auto mesh = make_mesh<Surface_mesh>(sample.soup);
  const mesh_builders::Mesh_numbers<Surface_mesh> numbers(mesh);
  decltype(Arc::chain) kept_chain;
  {
    const Graph graph = graph_checks::compute(mesh, sample.values);
    const auto chain_map = get(&Arc::chain, graph);
    BGL_FORALL_EDGES_T(arc, graph, Graph)
    {
      const auto& chain = get(chain_map, arc);
      BOOST_TEST((chain == graph[arc].chain));
      BOOST_TEST(static_cast<std::size_t>(std::distance(chain.begin(), chain.end())) == chain.size());
      BOOST_TEST((chain[chain.size() - 1] == chain.back()));
      BOOST_TEST(numbers.source_vertex(chain.front()) == numbers.vertex(graph[source(arc, graph)].vertex));
      kept_chain = chain;
    }
  }
  BOOST_TEST(kept_chain.size() > 0);
  BOOST_TEST((compute_plain(mesh, sample.values).arcs.back().chain_vertices.back())
             == numbers.target_vertex(kept_chain.back()));
}

BOOST_AUTO_TEST_SUITE_END()
