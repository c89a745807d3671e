// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#include <boost/test/unit_test.hpp>

#include "augmentation_checks.h"
#include "known_meshes.h"
#include "mesh_builders.h"
#include "random_fields.h"
#include "random_meshes.h"

#include <CGAL/Reeb_graph/scalar_maps.h>

#include <boost/mpl/list.hpp>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <ctime>
#include <iterator>
#include <map>
#include <optional>
#include <string>
#include <thread>
#include <tuple>
#include <type_traits>
#include <vector>

// From the graph back to the mesh, with ties broken: contours, critical sets and vertex_places against the oracle.

BOOST_AUTO_TEST_SUITE(test_augmentation)

using namespace augmentation_checks;
using generated_surfaces::Triangle_soup;
using mesh_builders::make_mesh;
using mesh_builders::Polyhedron;
using mesh_builders::Surface_mesh;
using random_meshes::Combinatorial_mesh;
using random_meshes::Field_class;
using random_meshes::Mesh_class;
using random_meshes::Random;

typedef boost::mpl::list<Surface_mesh, Polyhedron> Meshes;
typedef boost::mpl::list<double, int> Scalars;

namespace {
constexpr std::size_t number_of_mesh_classes = static_cast<std::size_t>(Mesh_class::NUMBER_OF_CLASSES);
constexpr std::size_t number_of_field_classes = static_cast<std::size_t>(Field_class::NUMBER_OF_CLASSES);

struct Sample
{
  Triangle_soup soup;
  std::vector<double> values, other_values;
};

template <class Test>
void for_each_sample(std::size_t number_of_seeds, const Test& test)
{
  for(std::size_t seed = 0; seed < number_of_seeds; ++seed)
  {
    Random random(300000 + seed);
    const auto mesh = random_meshes::random_mesh(static_cast<Mesh_class>(seed % number_of_mesh_classes), random);
    const auto field_class = static_cast<Field_class>(seed / number_of_mesh_classes % number_of_field_classes);
    const auto values = random_meshes::random_field(mesh, field_class, random);
    const auto other_values = seed % 3 == 0 ? std::vector<double>(values.size(), 2)
                            : seed % 3 == 1 ? random_meshes::random_integers(values.size(), 3, random)
                                            : random_meshes::smooth_field(mesh, random);
    BOOST_TEST_CONTEXT("seed " << seed)
    test(Sample{mesh_builders::make_soup(mesh), values, other_values});
  }
}

template <class Mesh, class Scalar>
void check_all(const Mesh& mesh, const std::vector<Scalar>& values, const std::vector<double>& other_values)
{
  for(const bool keeps_degree_two_nodes : {false, true})
    BOOST_TEST_CONTEXT("degree two nodes kept: " << keeps_degree_two_nodes)
    {
      const Augmented_mesh<Mesh, Scalar> a(mesh, values, Ties::PERTURB, keeps_degree_two_nodes);
      const Oracle oracle = graph_checks::make_oracle(a.numbers, values, keeps_degree_two_nodes);
      const Oracle_contours contours(oracle);
      BOOST_TEST(fault_of_contours(a, contours, other_values) == "");
      BOOST_TEST(fault_of_level_sets(a, contours) == "");
      BOOST_TEST(fault_of_locations(a, oracle) == "");
      BOOST_TEST(fault_of_critical_sets(a, contours) == "");
    }
}

// All that an augmentation says, by numbers.
struct Plain_contour
{
  double value;
  bool is_closed;
  std::vector<std::size_t> vertices; // source and target of each halfedge

  friend bool operator==(const Plain_contour& a, const Plain_contour& b)
  {
    return std::tie(a.value, a.is_closed, a.vertices) == std::tie(b.value, b.is_closed, b.vertices);
  }
};

struct Plain_augmentation
{
  std::vector<Plain_contour> contours;
  std::vector<std::vector<std::size_t>> border_loops; // vertices
  std::vector<std::vector<std::size_t>> stars;        // faces
  std::vector<std::size_t> vertex_places;

  friend bool operator==(const Plain_augmentation& a, const Plain_augmentation& b)
  {
    return std::tie(a.contours, a.border_loops, a.stars, a.vertex_places)
        == std::tie(b.contours, b.border_loops, b.stars, b.vertex_places);
  }
};

template <class A>
Plain_contour plain(const A& a, const typename A::Contour& contour)
{
  Plain_contour result = {contour.value, contour.is_closed(), {}};
  for(const auto h : contour.edges)
    result.vertices.insert(result.vertices.end(), {a.numbers.source_vertex(h), a.numbers.target_vertex(h)});
  return result;
}

template <class Mesh>
Plain_augmentation plain_augmentation(const Mesh& mesh, const Sample& sample, Ties ties)
{
  const Augmented_mesh<Mesh> a(mesh, sample.values, ties, false);
  const auto other_map = CGAL::Reeb_graph::make_scalar_map(mesh, sample.other_values);
  const auto vertex_places = a.augmentation.locate_vertices();
  std::map<typename boost::graph_traits<Mesh>::face_descriptor, std::size_t> face_numbers;
  for(const auto f : faces(mesh))
    face_numbers.emplace(f, face_numbers.size());

  Plain_augmentation result;
  for(const auto arc : a.arcs)
    for(const double t : {1e-9, 0.3, 0.8})
    {
      result.contours.push_back(plain(a, a.augmentation.contour(arc, t)));
      result.contours.push_back(plain(a, a.augmentation.contour(arc, t, other_map)));
    }
  for(const double value : sample.values)
    for(const auto& contour : a.augmentation.contours_at_value(value))
      result.contours.push_back(plain(a, contour));
  for(std::size_t node = 0; node < num_vertices(a.graph); ++node)
  {
    const auto set = a.augmentation.critical_set(node);
    for(const auto& contour : set.lower_contours)
      result.contours.push_back(plain(a, contour));
    for(const auto& contour : set.upper_contours)
      result.contours.push_back(plain(a, contour));
    result.border_loops.emplace_back();
    for(const auto h : set.border_loop)
      result.border_loops.back().push_back(a.numbers.target_vertex(h));
    result.stars.emplace_back();
    for(const auto f : set.star)
      result.stars.back().push_back(face_numbers.at(f));
  }
  for(const auto v : vertices(mesh))
    result.vertex_places.push_back(vertex_places.index(v));
  return result;
}

template <class Scalar>
std::vector<Scalar> converted(const std::vector<double>& values, Scalar offset)
{
  std::vector<Scalar> result;
  for(const double value : values)
    result.push_back(static_cast<Scalar>(value) + offset);
  return result;
}

std::vector<double> coordinate_field(const Triangle_soup& soup, double x, double y, double z)
{
  std::vector<double> values;
  for(const auto& p : soup.points)
    values.push_back(x * p[0] + y * p[1] + z * p[2]);
  return values;
}
// The arcs between critical vertices, and that of each vertex, by the order of the surface alone.
struct Arcs_of_vertices
{
  CGAL::Reeb_graph::internal::Swept_arcs arcs;
  CGAL::Reeb_graph::internal::Arc_of_vertex climbed, swept;
};

Arcs_of_vertices climb_and_sweep(const Surface_mesh& mesh, const std::vector<double>& values)
{
  namespace internal = CGAL::Reeb_graph::internal;
  const internal::Threads one_thread;
  const auto scalar_map = CGAL::Reeb_graph::make_scalar_map(mesh, values);
  const CGAL::Reeb_graph_traits<Surface_mesh, std::decay_t<decltype(scalar_map)>> traits;
  const auto surface = internal::flatten(one_thread, mesh, scalar_map, traits, CGAL::parameters::default_values());
  const internal::Vertex_order order(surface.field.keys());
  const auto critical_vertices = internal::classify_vertices(one_thread, surface.mesh->complex, order);
  const internal::Slab slab(surface.mesh->complex, critical_vertices);
  const internal::Contour_trees_engine engine(slab, order);
  Arcs_of_vertices result;
  internal::Locate_by_climbing climbing(surface.mesh->complex, order, critical_vertices);
  result.arcs = engine.find_arcs(one_thread, internal::No_progress(), climbing);
  result.climbed = climbing.take_arc_of_vertex();
  internal::Locate_by_sorting sweeping(surface.mesh->complex, order, critical_vertices);
  sweeping.sort(one_thread);
  engine.find_arcs(one_thread, internal::No_progress(), sweeping);
  result.swept = sweeping.take_arc_of_vertex();
  return result;
}
} // namespace

// The regular vertices of smooth fields are not sorted.
BOOST_AUTO_TEST_CASE(climbing_gives_the_vertices_of_smooth_fields_the_arcs_that_sweeping_gives_them)
{
  for(const unsigned genus : {0, 3, 25})
    for(const double height : {0., 0.25, 2.})
    {
      const auto soup = generated_surfaces::closed_surface(genus, 20000);
      const auto mesh = make_mesh<Surface_mesh>(soup);
      const auto arcs = climb_and_sweep(mesh, coordinate_field(soup, 1, 0.5, height));
      BOOST_TEST(std::equal(arcs.climbed.begin(), arcs.climbed.end(), arcs.swept.begin(), arcs.swept.end()));
    }
}

// Small meshes with many critical vertices are swept. Climbing has to find the same arcs on them.
BOOST_AUTO_TEST_CASE(climbing_gives_the_arcs_that_sweeping_gives)
{
  for_each_sample(1000, [](const Sample& sample) {
    namespace internal = CGAL::Reeb_graph::internal;
    const auto mesh = make_mesh<Surface_mesh>(sample.soup);
    const Augmented_mesh<Surface_mesh> a(mesh, sample.values, Ties::PERTURB, true);
    const auto vertex_places = a.augmentation.locate_vertices();
    const auto [arcs, arc_of_vertex, swept] = climb_and_sweep(mesh, sample.values);
    BOOST_TEST(std::equal(arc_of_vertex.begin(), arc_of_vertex.end(), swept.begin(), swept.end()));
    for(const auto v : vertices(mesh))
    {
      const std::size_t place = vertex_places.index(v);
      const internal::Swept_arc_index arc = arc_of_vertex[internal::Vertex_index(v)];
      BOOST_TEST((arc == internal::no_index) == (place < num_vertices(a.graph)));
      if(arc == internal::no_index || place < num_vertices(a.graph))
        continue;
      const auto first_halfedge = a.graph[a.arcs[place - num_vertices(a.graph)]].chain.front();
      BOOST_TEST(internal::edge_of(arcs[arc].first_step.edge).number() == mesh.edge(first_halfedge).idx());
    }
  });
}

namespace {
// The graph with places is that without, and the places are those that are found afterwards.
template <class Mesh, class NamedParameters, class MethodParameters>
void check_place_map(const Mesh& mesh,
                     const std::vector<double>& values,
                     const NamedParameters& np,
                     const MethodParameters& method_np)
{
  const auto scalar_map = CGAL::Reeb_graph::make_scalar_map(mesh, values);
  graph_checks::Graph_of<Mesh> graph, graph_alone;
  std::map<typename boost::graph_traits<Mesh>::vertex_descriptor, int> places;
  CGAL::compute_reeb_graph(mesh, scalar_map, graph_alone, np);
  CGAL::compute_reeb_graph(mesh, scalar_map, graph, method_np.vertex_place_map(boost::make_assoc_property_map(places)));
  BOOST_TEST(graph_checks::are_identical(graph, graph_alone));
  const CGAL::Reeb_graph::Augmentation augmentation(mesh, scalar_map, graph, np);
  const auto vertex_places = augmentation.locate_vertices();
  BOOST_TEST(places.size() == values.size());
  const auto place_map = boost::make_assoc_property_map(places);
  const auto given_places = augmentation.locate_vertices(CGAL::parameters::vertex_place_map(place_map));
  for(const auto& [vertex, place] : places)
  {
    BOOST_TEST(static_cast<std::size_t>(place) == vertex_places.index(vertex));
    BOOST_TEST(static_cast<std::size_t>(place) == given_places.index(vertex));
  }
  if(places.empty())
    return;
  for(const int wrong : {-1, static_cast<int>(num_vertices(graph) + num_edges(graph))})
  {
    places.begin()->second = wrong;
    BOOST_CHECK_THROW(augmentation.locate_vertices(CGAL::parameters::vertex_place_map(place_map)),
                      CGAL::Reeb_graph::Graph_mismatch_error);
  }
}

auto graph_parameters(Ties ties, bool keeps_degree_two_nodes)
{
  return CGAL::parameters::ties(ties).keep_degree_two_nodes(keeps_degree_two_nodes);
}
} // namespace

BOOST_AUTO_TEST_CASE(places_come_with_the_graph)
{
  for_each_sample(240, [](const Sample& sample) {
    for(const Ties ties : {Ties::PERTURB, Ties::CONTRACT})
    {
      const auto np = graph_parameters(ties, sample.values.size() % 2 == 0);
      check_place_map(make_mesh<Surface_mesh>(sample.soup), sample.values, np, np);
      check_place_map(make_mesh<Polyhedron>(sample.soup), sample.values, np, np);
    }
  });
}

// Arcs of a smooth field are spread, those of noise are swept, by whatever method they are found.
BOOST_AUTO_TEST_CASE(places_come_with_the_graph_by_any_method)
{
  const auto soup = generated_surfaces::closed_surface(3, 2000);
  const auto mesh = make_mesh<Surface_mesh>(soup);
  Random random(1);
  for(const auto& values :
      {coordinate_field(soup, 1, 0.5, 0.25), random_meshes::random_integers(mesh.number_of_vertices(), 5000, random)})
    for(const auto method : {CGAL::Reeb_graph::Method::CONTOUR_TREES, CGAL::Reeb_graph::Method::CRITICAL_SETS})
      for(const std::size_t number_of_slabs : {1, 5})
      {
        const auto np = graph_parameters(Ties::CONTRACT, false);
        check_place_map(mesh, values, np, np.method(method).number_of_slabs(number_of_slabs));
      }
}

BOOST_AUTO_TEST_CASE(random_small_meshes)
{
  for_each_sample(960, [](const Sample& sample) {
    check_all(make_mesh<Surface_mesh>(sample.soup), sample.values, sample.other_values);
  });
}

BOOST_AUTO_TEST_CASE(other_types_of_meshes)
{
  for_each_sample(144, [](const Sample& sample) {
    check_all(make_mesh<Polyhedron>(sample.soup), sample.values, sample.other_values);
    Surface_mesh with_garbage;
    mesh_builders::build_with_garbage(with_garbage, sample.soup);
    check_all(with_garbage, sample.values, sample.other_values);
  });
}

BOOST_AUTO_TEST_CASE(all_types_of_meshes_give_the_same)
{
  for_each_sample(480, [](const Sample& sample) {
    for(const Ties ties : {Ties::PERTURB, Ties::CONTRACT})
    {
      const auto expected = plain_augmentation(make_mesh<Surface_mesh>(sample.soup), sample, ties);
      BOOST_TEST((plain_augmentation(make_mesh<Polyhedron>(sample.soup), sample, ties) == expected));
      Surface_mesh with_garbage;
      mesh_builders::build_with_garbage(with_garbage, sample.soup);
      BOOST_TEST((plain_augmentation(with_garbage, sample, ties) == expected));
    }
  });
}

BOOST_AUTO_TEST_CASE(places_of_vertices_do_not_need_the_mesh)
{
  Random random(1);
  const auto combinatorial_mesh = random_meshes::random_closed_surface(1, 20, random);
  const auto values = random_meshes::random_field(combinatorial_mesh, Field_class::PERMUTATION, random);
  auto mesh = make_mesh<Surface_mesh>(mesh_builders::make_soup(combinatorial_mesh));
  const auto scalar_map = CGAL::Reeb_graph::make_scalar_map(mesh, values);
  const auto graph = graph_checks::compute(mesh, values);
  const auto vertex_places = CGAL::Reeb_graph::Augmentation(mesh, scalar_map, graph).locate_vertices();
  const std::vector<Surface_mesh::Vertex_index> vertices(mesh.vertices().begin(), mesh.vertices().end());
  std::vector<std::size_t> places;
  for(const auto v : vertices)
    places.push_back(vertex_places.index(v));
  mesh.clear();
  for(std::size_t i = 0; i != vertices.size(); ++i)
    BOOST_TEST(vertex_places.index(vertices[i]) == places[i]);
}

template <class Mesh>
void check_that_unknown_vertices_have_no_place(Mesh mesh, const std::vector<double>& values)
{
  remove_vertex(add_vertex(mesh), mesh);
  const auto scalar_map = CGAL::Reeb_graph::make_scalar_map(mesh, values);
  const auto graph = graph_checks::compute(mesh, values);
  const auto vertex_places = CGAL::Reeb_graph::Augmentation(mesh, scalar_map, graph).locate_vertices();
  for(const auto v : CGAL::make_range(vertices(mesh)))
    BOOST_CHECK_NO_THROW(vertex_places[v]);
  BOOST_CHECK_THROW(vertex_places.index(add_vertex(mesh)), CGAL::Reeb_graph::Unknown_vertex_error);
}

BOOST_AUTO_TEST_CASE(unknown_vertices_have_no_place)
{
  const auto soup = generated_surfaces::torus(4, 5);
  const auto values = coordinate_field(soup, 1, 0.5, 0.25);
  check_that_unknown_vertices_have_no_place(make_mesh<Surface_mesh>(soup), values);
  check_that_unknown_vertices_have_no_place(make_mesh<Polyhedron>(soup), values);
}

// Asks for vertices of a mesh and of another one, from several threads.
template <class Graph, class NamedParameters>
void ask_for_known_and_unknown_vertices(const Polyhedron& mesh,
                                        const std::vector<double>& values,
                                        const Graph& graph,
                                        const Polyhedron& other_mesh,
                                        const NamedParameters& np)
{
  const auto scalar_map = CGAL::Reeb_graph::make_scalar_map(mesh, values);
  const CGAL::Reeb_graph::Augmentation augmentation(mesh, scalar_map, graph, np);
  const auto vertex_places = augmentation.locate_vertices();
  std::atomic<std::size_t> number_of_mistakes = 0;
  const auto ask = [&](const Polyhedron& asked_mesh) {
    for(const auto v : CGAL::make_range(vertices(asked_mesh)))
    {
      std::size_t number_of_answers = 0;
      try
      {
        number_of_answers += augmentation.value(v) == get(scalar_map, v) ? 1 : 2;
        number_of_answers += vertex_places.index(v) < num_vertices(graph) + num_edges(graph) ? 1 : 2;
      }
      catch(const CGAL::Reeb_graph::Unknown_vertex_error&)
      {}
      number_of_mistakes += number_of_answers == (&asked_mesh == &mesh ? 2 : 0) ? 0 : 1;
    }
  };
  std::vector<std::thread> threads;
  for(const Polyhedron* asked_mesh : {&mesh, &other_mesh, &mesh, &other_mesh})
    threads.emplace_back([=] { ask(*asked_mesh); });
  for(std::thread& thread : threads)
    thread.join();
  BOOST_TEST(number_of_mistakes == 0);
}

BOOST_AUTO_TEST_CASE(several_threads_ask_for_vertices_of_other_meshes)
{
  const auto soup = generated_surfaces::torus(60, 50);
  const auto values = coordinate_field(soup, 1, 0.5, 0.25);
  const auto mesh = make_mesh<Polyhedron>(soup), other_mesh = make_mesh<Polyhedron>(generated_surfaces::torus(60, 55));
  const auto graph = graph_checks::compute(mesh, values);
  ask_for_known_and_unknown_vertices(mesh, values, graph, other_mesh, CGAL::parameters::default_values());
  const auto index_map = CGAL::Reeb_graph::make_vertex_index_map(mesh);
  ask_for_known_and_unknown_vertices(mesh, values, graph, other_mesh, CGAL::parameters::vertex_index_map(index_map));
  const auto dynamic_map = get(CGAL::dynamic_vertex_property_t<std::size_t>(), mesh);
  for(const auto v : CGAL::make_range(vertices(mesh)))
    put(dynamic_map, v, get(index_map, v));
  ask_for_known_and_unknown_vertices(mesh, values, graph, other_mesh, CGAL::parameters::vertex_index_map(dynamic_map));
  BOOST_TEST(dynamic_map.map_->size() == num_vertices(mesh)); // Nothing has been inserted.
}

template <class Function>
double cpu_seconds(const Function& function)
{
  const std::clock_t start = std::clock();
  function();
  return static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
}

// Of all ways, looking for the halfedges around the hub is the slowest: it would take fifty times as long as the graph.
BOOST_AUTO_TEST_CASE_TEMPLATE(contours_at_a_hub_take_linear_time, Mesh, Meshes)
{
  constexpr std::size_t number_of_peaks = 5000;
  const auto hub = random_meshes::bipyramid(2 * number_of_peaks);
  std::vector<double> values = {0, 0.1};
  for(std::size_t i = 0; i != 2 * number_of_peaks; ++i)
    values.push_back(i % 2 == 0 ? -1 : 1 + 1e-6 * static_cast<double>(i));
  const Mesh mesh = make_mesh<Mesh>(mesh_builders::make_soup(hub));
  const auto scalar_map = CGAL::Reeb_graph::make_scalar_map(mesh, values);
  graph_checks::Graph_of<Mesh> graph;
  std::optional<CGAL::Reeb_graph::Augmentation<Mesh, graph_checks::Scalar_map_of<Mesh>>> augmentation;
  const double seconds = cpu_seconds([&] {
    graph = graph_checks::compute(mesh, values);
    augmentation.emplace(mesh, scalar_map, graph);
  });
  std::size_t number_of_contours = 0;
  const double seconds_of_contours = cpu_seconds([&] {
    number_of_contours += augmentation->contours_at_value(0.5).size();
    for(const auto arc : CGAL::make_range(edges(graph)))
      number_of_contours += augmentation->contour(arc, 0.5).edges.empty() ? 0 : 1;
  });
  BOOST_TEST(number_of_contours == number_of_peaks + num_edges(graph));
  BOOST_TEST(seconds_of_contours < 10 * seconds);
}

BOOST_AUTO_TEST_CASE(several_edges_between_two_vertices)
{
  for(std::size_t seed = 0; seed < 150; ++seed)
  {
    Random random(seed);
    const std::size_t number_of_splits = random.below(4);
    const auto combinatorial_mesh =
      random_meshes::random_closed_surface(static_cast<unsigned>(random.below(4)), number_of_splits, random);
    auto mesh = make_mesh<Surface_mesh>(mesh_builders::make_soup(combinatorial_mesh));
    mesh_builders::flip_edges_carelessly(mesh, 100, random);
    const auto field_class = seed % 2 == 0 ? Field_class::PERMUTATION : Field_class::FEW_VALUES;
    const auto values = random_meshes::random_field(combinatorial_mesh, field_class, random);
    BOOST_TEST_CONTEXT("seed " << seed)
    check_all(mesh, values, random_meshes::random_permutation(values.size(), random));
  }
}

BOOST_AUTO_TEST_CASE(known_surfaces)
{
  for(const auto& mesh : {known_meshes::nine_vertex_torus(), known_meshes::seven_vertex_annulus()})
  {
    std::vector<double> values;
    for(std::size_t v = 0; v < mesh.number_of_vertices; ++v)
      values.push_back(static_cast<double>(v));
    check_all(make_mesh<Surface_mesh>(mesh_builders::make_soup(mesh)), values, values);
  }
}

BOOST_AUTO_TEST_CASE(integer_scalars)
{
  for(std::size_t seed = 0; seed < 200; ++seed)
  {
    Random random(400000 + seed);
    const auto mesh = random_meshes::random_mesh(static_cast<Mesh_class>(seed % number_of_mesh_classes), random);
    const auto values = random_meshes::random_integers(mesh.number_of_vertices, 30, random);
    const auto surface_mesh = make_mesh<Surface_mesh>(mesh_builders::make_soup(mesh));
    BOOST_TEST_CONTEXT("seed " << seed)
    {
      check_all(surface_mesh, converted<int>(values, -15), values);
      // differences that double cannot tell
      check_all(surface_mesh, converted<std::int64_t>(values, std::int64_t(1) << 60), values);
    }
  }
}

BOOST_AUTO_TEST_CASE(some_generated_surfaces)
{
  for(const auto& soup : {generated_surfaces::closed_surface(3, 400), generated_surfaces::terrain(15, 12),
                          generated_surfaces::torus(8, 20)})
    check_all(make_mesh<Surface_mesh>(soup), coordinate_field(soup, 0.9, 0.3, 0.2), coordinate_field(soup, 0, 0, 1));
}

BOOST_AUTO_TEST_CASE(the_field_as_second_field_changes_nothing)
{
  std::size_t number_of_contours = 0;
  for_each_sample(480, [&](const Sample& sample) {
    const auto mesh = make_mesh<Surface_mesh>(sample.soup);
    for(const Ties ties : {Ties::PERTURB, Ties::CONTRACT})
    {
      const Augmented_mesh<Surface_mesh> a(mesh, sample.values, ties, false);
      for(const auto arc : a.arcs)
      {
        const double length = a.values[a.upper(arc)] - a.values[a.lower(arc)];
        if(!std::isfinite(length) || length == 0)
          continue;
        const auto& chain = a.graph[arc].chain;
        if(!std::all_of(chain.begin(), chain.end(),
                        [&](const auto h) { return std::isfinite(get(a.scalar_map, target(h, mesh))); }))
        {
          BOOST_CHECK_THROW(a.augmentation.contour(arc, 0.5, a.scalar_map), CGAL::Reeb_graph::Non_finite_scalar_error);
          continue;
        }
        for(const double t : {0.01, 0.123, 0.5, 0.789, 0.99})
        {
          const double expected = a.augmentation.contour(arc, t).value;
          const double value = a.augmentation.contour(arc, t, a.scalar_map).value;
          BOOST_REQUIRE_SMALL(value - expected, 1e-9 * (1 + length));
          BOOST_REQUIRE_SMALL(expected - (a.values[a.lower(arc)] + t * length), 1e-9 * (1 + length));
          ++number_of_contours;
        }
      }
    }
  });
  BOOST_TEST(number_of_contours > 1000u);
}

BOOST_AUTO_TEST_CASE_TEMPLATE(the_order_of_the_traits_class, Scalar, Scalars)
{
  namespace parameters = CGAL::parameters;
  using CGAL::Reeb_graph::Augmentation;
  typedef graph_checks::Scalar_map_of<Surface_mesh, Scalar> Scalar_map;
  struct Descending : CGAL::Reeb_graph_traits<Surface_mesh, Scalar_map>
  {
    struct Less_scalar
    {
      bool operator()(Scalar a, Scalar b) const { return a > b; }
    };
    Less_scalar less_scalar_object() const { return Less_scalar(); }
  };
  for_each_sample(240, [](const Sample& sample) {
    const auto mesh = make_mesh<Surface_mesh>(sample.soup);
    std::vector<Scalar> values, negative_values;
    for(const double value : sample.values)
      values.push_back(static_cast<Scalar>((std::max)((std::min)(value, 1e6), -1e6)));
    for(const Scalar value : values)
      negative_values.push_back(-value);
    const auto scalar_map = CGAL::Reeb_graph::make_scalar_map(mesh, values);
    const auto negative_map = CGAL::Reeb_graph::make_scalar_map(mesh, negative_values);
    for(const Ties ties : {Ties::PERTURB, Ties::CONTRACT})
    {
      const auto np = parameters::ties(ties);
      const auto np_descending = np.geom_traits(Descending());
      graph_checks::Graph_of<Surface_mesh, Scalar> graph, negative_graph;
      CGAL::compute_reeb_graph(mesh, scalar_map, graph, np_descending);
      CGAL::compute_reeb_graph(mesh, negative_map, negative_graph, np);
      const Augmentation descending(mesh, scalar_map, graph, np_descending);
      const Augmentation ascending(mesh, negative_map, negative_graph, np);
      const auto check_same = [](const auto& contour, const auto& expected) {
        BOOST_TEST(contour.value == -expected.value);
        BOOST_TEST((contour.edges == expected.edges));
      };
      BOOST_TEST_REQUIRE(num_edges(graph) == num_edges(negative_graph));
      auto expected_arc = edges(negative_graph).first;
      for(const auto arc : CGAL::make_range(edges(graph)))
      {
        for(const double t : {0.01, 0.25, 0.5, 0.99})
        {
          check_same(descending.contour(arc, t), ascending.contour(*expected_arc, t));
          check_same(descending.contour(arc, t, negative_map), ascending.contour(*expected_arc, t, negative_map));
        }
        ++expected_arc;
      }
      const auto vertex_places = descending.locate_vertices(), expected_locations = ascending.locate_vertices();
      for(const auto v : mesh.vertices())
        BOOST_TEST(vertex_places.index(v) == expected_locations.index(v));
    }
  });
}

BOOST_AUTO_TEST_CASE_TEMPLATE(points_of_contours_lie_on_their_edges, Mesh, Meshes)
{
  const auto soup = generated_surfaces::closed_surface(3, 400);
  const auto mesh = make_mesh<Mesh>(soup);
  const Augmented_mesh<Mesh> a(mesh, coordinate_field(soup, 0.9, 0.3, 0.2), Ties::PERTURB, false);
  const auto points_of_vertices = get(CGAL::vertex_point, mesh);
  for(const auto arc : a.arcs)
    for(const double t : {0.001, 0.5, 0.9})
    {
      const auto contour = a.augmentation.contour(arc, t);
      std::vector<mesh_builders::Point> points, same_points;
      a.augmentation.points_of_contour(contour, std::back_inserter(points));
      a.augmentation.points_of_contour(contour, std::back_inserter(same_points),
                                       CGAL::parameters::vertex_point_map(points_of_vertices));
      BOOST_TEST((points == same_points));
      BOOST_TEST_REQUIRE(points.size() == contour.edges.size());
      for(std::size_t i = 0; i < points.size(); ++i)
      {
        const auto& p = points[i];
        const auto lower = get(points_of_vertices, source(contour.edges[i], mesh));
        const auto upper = get(points_of_vertices, target(contour.edges[i], mesh));
        BOOST_TEST(std::abs(0.9 * p.x() + 0.3 * p.y() + 0.2 * p.z() - contour.value) < 1e-9);
        const double detour = std::sqrt(CGAL::squared_distance(lower, p)) + std::sqrt(CGAL::squared_distance(p, upper))
                            - std::sqrt(CGAL::squared_distance(lower, upper));
        BOOST_TEST(std::abs(detour) < 1e-9);
      }
    }
}

BOOST_AUTO_TEST_SUITE_END()
