// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#include <boost/test/unit_test.hpp>

#include "computed_graphs.h"
#include "generated_complexes.h"
#include "shuffle.h"
#include "throwing_traits.h"

#include <CGAL/Reeb_graph/Augmentation.h>
#include <CGAL/Reeb_graph/internal/base/Index.h>
#include <CGAL/Reeb_graph/internal/base/Threads.h>
#include <CGAL/Reeb_graph/internal/base/arrays.h>
#include <CGAL/Reeb_graph/internal/complex/Flat_mesh.h>
#include <CGAL/compute_reeb_graph_of_soup.h>

#include <boost/mpl/list.hpp>

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <cstddef>
#include <functional>
#include <iterator>
#include <limits>
#include <random>
#include <stdexcept>
#include <string>
#include <typeinfo>
#include <vector>

// The graph and the exceptions are the same for any number of threads and slabs. Meshes have to be large for this, as
// small ones are left to one thread: most here are collections of hundreds of small random meshes.

BOOST_AUTO_TEST_SUITE(test_parallel)

using namespace computed_graphs;
using mesh_builders::Polyhedron;
using mesh_builders::Surface_mesh;
typedef CGAL::Parallel_if_available_tag Parallel;

typedef boost::mpl::list<Surface_mesh, Polyhedron> Meshes;

namespace {
constexpr std::size_t number_of_faces = 24000; // at least, in each mesh that is meant to be worked on in parallel

// Slabs and threads by which the graphs are compared, each of them often enough.
const std::vector<std::array<std::size_t, 2>> slabs_and_threads = {{0, 2}, {1, 1}, {1, 2},  {2, 2}, {3, 4},
                                                                   {8, 1}, {8, 4}, {64, 2}, {64, 4}};

// The graphs are compared in full, the files, which take most of the time, once for each method.
template <class Mesh>
void compare(const Mesh& mesh,
             const std::vector<double>& values,
             Settings settings,
             const std::vector<Method>& methods = {Method::CONTOUR_TREES, Method::CRITICAL_SETS})
{
  const Mesh_numbers<Mesh> numbers(mesh);
  const auto scalar_map = CGAL::Reeb_graph::make_scalar_map(mesh, values);
  const auto expected = compute<CGAL::Sequential_tag>(mesh, scalar_map, settings);
  const std::string expected_files = written(numbers, expected);
  for(const Method method : methods)
  {
    settings.method = method;
    graph_checks::Graph_of<Mesh> graph;
    for(const auto& [slabs, threads] : slabs_and_threads)
    {
      settings.number_of_slabs = slabs;
      settings.number_of_threads = threads;
      graph = compute<Parallel>(mesh, scalar_map, settings);
      if(!graph_checks::are_identical(graph, expected))
        BOOST_ERROR("another graph; " << settings);
    }
    if(written(numbers, graph) != expected_files)
      BOOST_ERROR("other files; " << settings);
  }
}

struct Collection
{
  Combinatorial_mesh mesh;
  std::vector<double> values;
};

// Random meshes of all classes side by side, until there are enough faces. Their values are moved against each other,
// so that at a level some are passed, and some are still to come.
Collection random_collection(std::size_t seed)
{
  constexpr std::size_t number_of_classes = static_cast<std::size_t>(Mesh_class::NUMBER_OF_CLASSES);
  constexpr std::size_t number_of_field_classes = static_cast<std::size_t>(Field_class::NUMBER_OF_CLASSES);
  Random random(400000 + seed);
  Collection collection;
  for(std::size_t i = 0; collection.mesh.triangles.size() < number_of_faces; ++i)
  {
    const auto mesh = random_meshes::random_mesh(static_cast<Mesh_class>(i % number_of_classes), random);
    const auto field_class = static_cast<Field_class>(i / number_of_classes % number_of_field_classes);
    const double shift = static_cast<double>(random.below(300));
    for(const double value : random_meshes::random_field(mesh, field_class, random))
      collection.values.push_back(value + shift);
    for(const auto& t : mesh.triangles)
      collection.mesh.triangles.push_back({t[0] + collection.mesh.number_of_vertices,
                                           t[1] + collection.mesh.number_of_vertices,
                                           t[2] + collection.mesh.number_of_vertices});
    collection.mesh.number_of_vertices += mesh.number_of_vertices;
  }
  return collection;
}

template <class Mesh>
void compare_on_collections(std::size_t first_seed, std::size_t end_seed)
{
  for(std::size_t seed = first_seed; seed < end_seed; ++seed)
  {
    const Collection collection = random_collection(seed);
    BOOST_TEST_CONTEXT("seed " << seed)
    compare(make_mesh<Mesh>(collection.mesh), collection.values, settings_of_seed(seed));
  }
}

std::vector<double> tilted_height(const generated_surfaces::Triangle_soup& soup)
{
  std::vector<double> values;
  for(const auto& p : soup.points)
    values.push_back(std::sin(3 * p[0]) + 0.9 * p[0] + 0.3 * p[1] + 0.2 * p[2]);
  return values;
}

std::vector<double> rounded(std::vector<double> values)
{
  for(double& value : values)
    value = std::round(20 * value);
  return values;
}

void compare_on_generated_surface(const generated_surfaces::Triangle_soup& soup)
{
  Random random(1);
  const Surface_mesh mesh = make_mesh<Surface_mesh>(soup);
  const std::vector<double> height = tilted_height(soup);
  compare(mesh, height, Settings());
  for(std::size_t seed : {0, 1})
    compare(mesh, rounded(height), settings_of_seed(seed));
  compare(mesh, random_meshes::random_permutation(soup.points.size(), random), Settings(), {Method::CONTOUR_TREES});
}

template <class Function>
std::string exception_of(const Function& function)
{
  try
  {
    function();
  }
  catch(const CGAL::Reeb_graph::Error& error)
  {
    return std::string(typeid(error).name()) + ": " + error.what();
  }
  return "no exception";
}

// Expects the exception that a sequential run gives, which names the place, and a graph that nothing has touched.
template <class Mesh>
void compare_exceptions(const Mesh& mesh, const std::vector<double>& values, const std::string& place)
{
  const auto scalar_map = CGAL::Reeb_graph::make_scalar_map(mesh, values);
  graph_checks::Graph_of<Mesh> graph(3);
  const std::string expected = exception_of([&] { CGAL::compute_reeb_graph(mesh, scalar_map, graph); });
  BOOST_TEST(expected.find(place) != std::string::npos, expected);
  Settings settings;
  for(const auto& [slabs, threads] : slabs_and_threads)
  {
    settings.number_of_slabs = slabs;
    settings.number_of_threads = threads;
    const std::string exception = exception_of([&] {
      run_with_threads(settings.number_of_threads, [&] {
        CGAL::compute_reeb_graph<Parallel>(mesh, scalar_map, graph, named_parameters(settings));
      });
    });
    BOOST_TEST_CONTEXT(settings)
    {
      BOOST_TEST(exception == expected);
      BOOST_TEST(num_vertices(graph) == 3u);
    }
  }
}

template <class Mesh>
Mesh two_cylinders()
{
  const auto cylinder = random_meshes::cylinder(100, 100);
  return make_mesh<Mesh>(disjoint_union(cylinder, cylinder));
}

template <class Mesh>
std::vector<double> some_values(const Mesh& mesh)
{
  Random random(2);
  return random_meshes::random_integers(vertices(mesh).size(), 1000, random);
}

template <class Range>
auto element(const Range& range, std::size_t position)
{
  return *std::next(range.begin(), static_cast<std::ptrdiff_t>(position));
}

template <class Mesh>
void make_degenerate(Mesh& mesh, std::size_t face)
{
  const auto h = halfedge(element(faces(mesh), face), mesh);
  set_target(h, source(h, mesh), mesh);
}

template <class Mesh>
void add_quadrilateral(Mesh& mesh)
{
  std::array<typename boost::graph_traits<Mesh>::vertex_descriptor, 4> corners;
  for(auto& corner : corners)
    corner = mesh_builders::add_point(mesh, {0, 0, 0});
  CGAL::Euler::add_face(corners, mesh);
}

// Lets all halfedges that end at the first one end at the second one.
template <class Mesh>
void merge_vertices(Mesh& mesh, std::size_t first, std::size_t second)
{
  const auto u = element(vertices(mesh), first), v = element(vertices(mesh), second);
  for(const auto h : halfedges(mesh))
    if(target(h, mesh) == u)
      set_target(h, v, mesh);
  remove_vertex(u, mesh);
}
} // namespace

BOOST_AUTO_TEST_CASE(sorting_on_any_number_of_threads)
{
  namespace internal = CGAL::Reeb_graph::internal;
  typedef internal::Vertex_order::Key<internal::Vertex_index> Key;
  const auto is_same = [](const Key& a, const Key& b) { return a.key == b.key && a.name == b.name; };
  for(unsigned int seed = 0; seed != 200; ++seed)
  {
    std::mt19937 random(seed);
    internal::Indexed_vector<internal::Vertex_index, double> values(random() % (seed < 160 ? 40 : 40000));
    for(double& value : values)
      value = random() % 50;
    const internal::Vertex_order order(values);
    std::vector<Key> keys;
    for(const internal::Vertex_index i : values.keys())
      keys.push_back(order.key(i, i));
    std::vector<Key> expected = keys;
    std::sort(expected.begin(), expected.end(), order);
    std::shuffle(keys.begin(), keys.end(), random);
    const std::size_t number_of_threads = std::size_t(1) << seed % 4;
    run_with_threads(number_of_threads,
                     [&] { internal::sort(internal::threads_of<Parallel>(), keys.begin(), keys.end(), order); });
    if(!std::equal(keys.begin(), keys.end(), expected.begin(), expected.end(), is_same))
      BOOST_ERROR("seed " << seed << ", " << number_of_threads << " threads");
  }
}

BOOST_AUTO_TEST_CASE(collections_as_surface_meshes) { compare_on_collections<Surface_mesh>(0, 8); }

BOOST_AUTO_TEST_CASE(collections_as_polyhedra) { compare_on_collections<Polyhedron>(8, 12); }

BOOST_AUTO_TEST_CASE(generated_surfaces_with_all_fields)
{
  for(const unsigned genus : {0, 3, 25})
    BOOST_TEST_CONTEXT("genus " << genus)
  compare_on_generated_surface(generated_surfaces::closed_surface(genus, 25000));
  BOOST_TEST_CONTEXT("terrain")
  compare_on_generated_surface(generated_surfaces::terrain(150, 150));
}

// Regular vertices of such a mesh are found by sweeps over its edges, if it is large.
BOOST_AUTO_TEST_CASE(a_mesh_in_bad_order)
{
  auto soup = generated_surfaces::closed_surface(3, 36000);
  Random random(2);
  generated_surfaces::shuffle(soup, random);
  const Surface_mesh mesh = make_mesh<Surface_mesh>(soup);
  compare(mesh, tilted_height(soup), Settings(), {Method::CONTOUR_TREES});
}

BOOST_AUTO_TEST_CASE(places_of_vertices_and_contours)
{
  const auto soup = generated_surfaces::closed_surface(3, 25000);
  const Surface_mesh mesh = make_mesh<Surface_mesh>(soup);
  const auto scalar_map = CGAL::Reeb_graph::make_scalar_map(mesh, tilted_height(soup));
  const auto graph = compute<CGAL::Sequential_tag>(mesh, scalar_map, Settings());
  const CGAL::Reeb_graph::Augmentation augmentation(mesh, scalar_map, graph);
  const auto expected_places = augmentation.locate_vertices();
  for(const std::size_t threads : {1, 2, 4})
    run_with_threads(threads, [&] {
      const auto places = augmentation.locate_vertices<Parallel>();
      BOOST_TEST(std::all_of(vertices(mesh).begin(), vertices(mesh).end(), [&](Surface_mesh::Vertex_index v) {
        return places.index(v) == expected_places.index(v);
      }));
      std::vector<std::size_t> places_with_graph(mesh.number_of_vertices());
      graph_checks::Graph_of<Surface_mesh> graph_with_places;
      CGAL::compute_reeb_graph<Parallel>(
        mesh, scalar_map, graph_with_places,
        CGAL::parameters::vertex_place_map(CGAL::make_property_map(places_with_graph)));
      BOOST_TEST(std::all_of(vertices(mesh).begin(), vertices(mesh).end(), [&](Surface_mesh::Vertex_index v) {
        return places_with_graph[v] == expected_places.index(v);
      }));
      for(const double value : {-0.5, 0., 0.01, 0.5})
      {
        const auto expected = augmentation.contours_at_value(value);
        const auto contours = augmentation.contours_at_value<Parallel>(value);
        BOOST_TEST(std::equal(contours.begin(), contours.end(), expected.begin(), expected.end(),
                              [](const auto& a, const auto& b) { return a.edges == b.edges; }));
      }
    });
}

BOOST_AUTO_TEST_CASE_TEMPLATE(small_meshes, Mesh, Meshes)
{
  for(std::size_t seed = 0; seed < 60; ++seed)
  {
    Random random(500000 + seed);
    const auto mesh = random_meshes::random_mesh(static_cast<Mesh_class>(seed % 6), random);
    const auto values = random_meshes::random_field(mesh, Field_class::INTEGERS, random);
    BOOST_TEST_CONTEXT("seed " << seed)
    compare(make_mesh<Mesh>(mesh), values, settings_of_seed(seed / 6));
  }
}

// To read such a value stores it in the map.
BOOST_AUTO_TEST_CASE(dynamic_property_maps_with_unset_values)
{
  const auto mesh = make_mesh<Polyhedron>(generated_surfaces::closed_surface(0, 25000));
  const auto make_scalar_map = [&] {
    const auto scalar_map = get(CGAL::dynamic_vertex_property_t<double>(), mesh);
    for(const std::size_t v : {0, 1000, 20000})
      put(scalar_map, *std::next(vertices(mesh).first, v), static_cast<double>(v) - 500);
    return scalar_map;
  };
  Settings settings;
  const auto expected = compute<CGAL::Sequential_tag>(mesh, make_scalar_map(), settings);
  settings.number_of_threads = 4;
  for(std::size_t repetition = 0; repetition != 5; ++repetition)
    BOOST_TEST(graph_checks::are_identical(compute<Parallel>(mesh, make_scalar_map(), settings), expected));
}

// Whenever the order throws, the graph is the old one or empty, but never half a new one: chains are walked while nodes
// and arcs are written.
BOOST_AUTO_TEST_CASE(an_order_that_throws_leaves_no_half_graph)
{
  const auto soup = generated_surfaces::closed_surface(2, 12000);
  const Surface_mesh mesh = make_mesh<Surface_mesh>(soup);
  Random random(1);
  const auto values = random_meshes::random_permutation(soup.points.size(), random);
  const auto scalar_map = CGAL::Reeb_graph::make_scalar_map(mesh, std::vector<double>(values.begin(), values.end()));
  const auto expected = compute<CGAL::Sequential_tag>(mesh, scalar_map, Settings());
  graph_checks::Graph_of<Surface_mesh> old_graph;
  add_vertex(old_graph);
  std::atomic<std::size_t> number_of_calls(0);
  Throwing_traits traits;
  traits.less = {&number_of_calls, std::numeric_limits<std::size_t>::max()};
  run_with_threads(4, [&] {
    auto graph = old_graph;
    CGAL::compute_reeb_graph<Parallel>(mesh, scalar_map, graph, CGAL::parameters::geom_traits(traits));
    BOOST_TEST(graph_checks::are_identical(graph, expected));
    const std::size_t number_of_all_calls = number_of_calls;
    for(std::size_t i = 0; i != 60; ++i)
    {
      graph = old_graph;
      number_of_calls = 0;
      traits.less.last_call = number_of_all_calls - 1 - i * number_of_all_calls / 400; // chains are walked at the end
      BOOST_CHECK_THROW(
        CGAL::compute_reeb_graph<Parallel>(mesh, scalar_map, graph, CGAL::parameters::geom_traits(traits)),
        std::runtime_error);
      BOOST_TEST((num_vertices(graph) == 0 || graph_checks::are_identical(graph, old_graph)));
    }
  });
}

// Of several faults of a kind the first one is named.
BOOST_AUTO_TEST_CASE_TEMPLATE(vertices_without_value, Mesh, Meshes)
{
  const auto mesh = two_cylinders<Mesh>();
  auto values = some_values(mesh);
  for(std::size_t v : {19000, 12000, 601, 600})
  {
    values[v] = std::numeric_limits<double>::quiet_NaN();
    compare_exceptions(mesh, values, "vertex " + std::to_string(v) + " ");
  }
}

BOOST_AUTO_TEST_CASE_TEMPLATE(faces_that_are_no_triangles, Mesh, Meshes)
{
  auto mesh = two_cylinders<Mesh>();
  const std::size_t number_of_triangles = num_faces(mesh);
  for(int i = 0; i < 3; ++i)
    add_quadrilateral(mesh);
  const auto cylinder = mesh_builders::make_soup(random_meshes::cylinder(100, 100));
  mesh_builders::build(mesh, cylinder);
  add_quadrilateral(mesh);
  compare_exceptions(mesh, some_values(mesh), "face " + std::to_string(number_of_triangles) + " ");
}

BOOST_AUTO_TEST_CASE_TEMPLATE(degenerate_faces, Mesh, Meshes)
{
  auto mesh = two_cylinders<Mesh>();
  for(std::size_t face : {30000, 20000, 20001, 77})
    make_degenerate(mesh, face);
  compare_exceptions(mesh, some_values(mesh), "face 77 ");
}

BOOST_AUTO_TEST_CASE_TEMPLATE(vertices_with_several_fans, Mesh, Meshes)
{
  auto mesh = two_cylinders<Mesh>();
  for(std::size_t i = 0; i < 4; ++i)
    merge_vertices(mesh, 19000 - 1000 * i, 9000 - 2000 * i);
  compare_exceptions(mesh, some_values(mesh), "vertex 3000 ");
}

BOOST_AUTO_TEST_CASE_TEMPLATE(faults_of_all_kinds, Mesh, Meshes)
{
  auto mesh = two_cylinders<Mesh>();
  merge_vertices(mesh, 15000, 20);
  make_degenerate(mesh, 300);
  auto values = some_values(mesh);
  values[7] = values[14000] = std::numeric_limits<double>::quiet_NaN();
  compare_exceptions(mesh, values, " ");
  add_quadrilateral(mesh);
  compare_exceptions(mesh, some_values(mesh), " ");
}

// Soups of which some components have loops, and others have none.
BOOST_AUTO_TEST_CASE(graphs_of_soups_do_not_depend_on_threads)
{
  auto soup = generated_surfaces::with_holes(generated_surfaces::foam(2, 2, 2, 4), 500);
  const auto book = generated_surfaces::book(4, 40);
  const std::size_t first = soup.points.size();
  soup.points.insert(soup.points.end(), book.points.begin(), book.points.end());
  for(const auto& t : book.triangles)
    soup.triangles.push_back({first + t[0], first + t[1], first + t[2]});
  typedef CGAL::Reeb_graph_soup_traits<double>::Graph Graph;
  for(const auto& values :
      {generated_surfaces::smooth_field(soup.points), generated_surfaces::noise_field(soup.points)})
  {
    Graph expected, graph;
    CGAL::compute_reeb_graph_of_soup(soup.points, soup.triangles, values, expected);
    BOOST_TEST(num_edges(expected) > num_vertices(expected)); // there are loops
    for(const std::size_t threads : {1, 2, 4})
    {
      run_with_threads(threads,
                       [&] { CGAL::compute_reeb_graph_of_soup<Parallel>(soup.points, soup.triangles, values, graph); });
      BOOST_TEST(graph_checks::are_identical(graph, expected));
    }
  }
}

BOOST_AUTO_TEST_SUITE_END()
