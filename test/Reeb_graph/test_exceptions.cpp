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
#include "random_meshes.h"
#include "throwing_traits.h"

#include <CGAL/Reeb_graph/Augmentation.h>
#include <CGAL/Reeb_graph/curves/segmentation.h>

#include <boost/mpl/list.hpp>
#include <boost/property_map/function_property_map.hpp>

#include <algorithm>
#include <array>
#include <atomic>
#include <cstddef>
#include <iterator>
#include <limits>
#include <list>
#include <random>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <vector>

// Bad input gets an exception that names the place, whatever the build type, and leaves the graph as it was.

BOOST_AUTO_TEST_SUITE(test_exceptions)

using namespace CGAL::Reeb_graph;
using mesh_builders::make_mesh;
using mesh_builders::Polyhedron;
using mesh_builders::Surface_mesh;

typedef boost::mpl::list<Surface_mesh, Polyhedron> Meshes;

namespace {
constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();
constexpr double infinity = std::numeric_limits<double>::infinity();

std::vector<double> ascending_values(std::size_t size)
{
  std::vector<double> values(size);
  for(std::size_t i = 0; i < size; ++i)
    values[i] = static_cast<double>(i);
  return values;
}

template <class Range>
auto element(const Range& range, std::size_t position)
{
  return *std::next(range.begin(), position);
}

// Computes a graph, expects Exception, and that the graph has not been touched; is_right tests the exception.
template <class Exception, class Mesh, class Is_right, class NamedParameters>
void expect(const Mesh& mesh, const std::vector<double>& values, const Is_right& is_right, const NamedParameters& np)
{
  graph_checks::Graph_of<Mesh> graph;
  add_vertex(graph);
  add_vertex(graph);
  add_edge(0, 1, graph);
  graph[0].value = 17;
  const auto scalar_map = make_scalar_map(mesh, values);
  BOOST_CHECK_EXCEPTION(CGAL::compute_reeb_graph(mesh, scalar_map, graph, np), Exception, is_right);
  BOOST_TEST(num_vertices(graph) == 2u);
  BOOST_TEST(num_edges(graph) == 1u);
  BOOST_TEST(graph[0].value == 17);
}

template <class Exception, class Mesh, class Is_right>
void expect(const Mesh& mesh, const std::vector<double>& values, const Is_right& is_right)
{
  expect<Exception>(mesh, values, is_right, CGAL::parameters::default_values());
}

bool mentions(const Error& error, const std::string& text)
{
  return std::string(error.what()).find(text) != std::string::npos;
}

template <class Mesh, class ScalarMap>
std::size_t number_of_arcs(const Mesh& mesh, const ScalarMap& scalar_map)
{
  typename CGAL::Reeb_graph_traits<Mesh, ScalarMap>::Graph graph;
  CGAL::compute_reeb_graph(mesh, scalar_map, graph);
  return num_edges(graph);
}

// Lets all halfedges that end at u end at v. Where the two had a fan each, v has both, and its halfedge sees one.
template <class Mesh, class Vertex>
void merge_vertices(Mesh& mesh, Vertex u, Vertex v)
{
  for(const auto h : halfedges(mesh))
    if(target(h, mesh) == u)
      set_target(h, v, mesh);
  remove_vertex(u, mesh);
}
} // namespace

BOOST_AUTO_TEST_CASE(exceptions_can_be_caught_by_their_bases)
{
  BOOST_TEST((std::is_base_of_v<std::runtime_error, Error>));
  BOOST_TEST((std::is_base_of_v<Error, Vertex_error>));
  BOOST_TEST((std::is_base_of_v<Error, Face_error>));
  BOOST_TEST((std::is_base_of_v<Face_error, Non_triangular_face_error>));
  BOOST_TEST((std::is_base_of_v<Face_error, Degenerate_face_error>));
  BOOST_TEST((std::is_base_of_v<Error, Edge_without_face_error>));
  BOOST_TEST((std::is_base_of_v<Vertex_error, Non_manifold_vertex_error>));
  BOOST_TEST((std::is_base_of_v<Vertex_error, Unordered_scalar_error>));
  BOOST_TEST((std::is_base_of_v<Error, Invalid_index_map_error>));
  BOOST_TEST((std::is_base_of_v<Error, Scalar_count_error>));
  BOOST_TEST((std::is_base_of_v<Error, Mesh_size_error>));
  BOOST_TEST((std::is_base_of_v<Error, Graph_mismatch_error>));
  BOOST_TEST((std::is_base_of_v<Error, Parameter_error>));

  const auto mesh = make_mesh<Surface_mesh>({3, {{0, 1, 2}}});
  expect<Vertex_error>(mesh, {0, not_a_number, 1}, [](const Vertex_error& error) { return error.vertex() == 1; });
}

BOOST_AUTO_TEST_CASE_TEMPLATE(a_quadrilateral_is_refused, Mesh, Meshes)
{
  auto mesh = make_mesh<Mesh>({6, {{0, 1, 2}, {3, 4, 5}}});
  typedef typename boost::graph_traits<Mesh>::vertex_descriptor vertex_descriptor;
  const std::array<vertex_descriptor, 4> corners = {element(vertices(mesh), 1), element(vertices(mesh), 0),
                                                    element(vertices(mesh), 3), element(vertices(mesh), 5)};
  CGAL::Euler::add_face(corners, mesh);
  expect<Non_triangular_face_error>(mesh, ascending_values(6), [](const Non_triangular_face_error& error) {
    return error.face() == 2 && mentions(error, "face 2 ");
  });
}

BOOST_AUTO_TEST_CASE_TEMPLATE(a_triangle_with_a_vertex_twice_is_refused, Mesh, Meshes)
{
  auto mesh = make_mesh<Mesh>({9, {{0, 1, 2}, {3, 4, 5}, {6, 7, 8}}});
  set_target(halfedge(element(faces(mesh), 1), mesh), element(vertices(mesh), 3), mesh);
  set_target(next(halfedge(element(faces(mesh), 1), mesh), mesh), element(vertices(mesh), 3), mesh);
  expect<Degenerate_face_error>(mesh, ascending_values(9), [](const Degenerate_face_error& error) {
    return error.face() == 1 && mentions(error, "face 1 ");
  });
}

// Of each mesh, one vertex becomes another one, which then has several fans and is refused.
BOOST_AUTO_TEST_CASE_TEMPLATE(a_vertex_with_several_fans_is_refused, Mesh, Meshes)
{
  const random_meshes::Combinatorial_mesh triangle = {3, {{0, 1, 2}}}, closed = random_meshes::tetrahedron();
  struct Refusal
  {
    const char* name;
    random_meshes::Combinatorial_mesh mesh;
    std::size_t merged, vertex;
  };
  const std::vector<Refusal> refusals = {
    {"two surfaces that touch", disjoint_union(closed, closed), 7, 2},
    {"a surface that touches itself", random_meshes::bipyramid(5), 1, 0},
    {"two triangles that share only a vertex", disjoint_union(triangle, triangle), 5, 2},
    {"a border that touches a closed fan", disjoint_union(triangle, closed), 6, 1},
    {"a closed fan that touches a border", disjoint_union(closed, triangle), 6, 1}};
  for(const Refusal& refusal : refusals)
    BOOST_TEST_CONTEXT(refusal.name)
    {
      auto mesh = make_mesh<Mesh>(refusal.mesh);
      merge_vertices(mesh, element(vertices(mesh), refusal.merged), element(vertices(mesh), refusal.vertex));
      expect<Non_manifold_vertex_error>(
        mesh, ascending_values(refusal.mesh.number_of_vertices - 1), [&](const Non_manifold_vertex_error& error) {
          return error.vertex() == refusal.vertex && mentions(error, "vertex " + std::to_string(refusal.vertex) + " ");
        });
    }
}

// `add_edge()` joins an edge to nothing. An edge whose halfedges follow each other makes a mesh that is valid.
BOOST_AUTO_TEST_CASE_TEMPLATE(an_edge_without_a_face_is_refused, Mesh, Meshes)
{
  auto combinatorial_mesh = random_meshes::disk(5);
  combinatorial_mesh.number_of_vertices += 2;
  for(const bool is_joined : {false, true})
    for(const std::size_t first : {0, 1, 6}) // inside, on the border, isolated
    {
      auto mesh = make_mesh<Mesh>(combinatorial_mesh);
      const auto u = element(vertices(mesh), first), v = element(vertices(mesh), 7);
      const std::size_t number_of_edges = num_edges(mesh);
      BOOST_CHECK_NO_THROW(graph_checks::compute(mesh, ascending_values(8)));
      const auto h = halfedge(add_edge(mesh), mesh), g = opposite(h, mesh);
      set_target(h, v, mesh);
      set_target(g, u, mesh);
      if(is_joined)
      {
        set_next(h, g, mesh);
        set_next(g, h, mesh);
        set_halfedge(v, h, mesh);
        if(first == 6)
          set_halfedge(u, g, mesh);
      }
      const auto is_right = [&](const Edge_without_face_error& error) {
        return error.edge() == number_of_edges && mentions(error, "edge " + std::to_string(number_of_edges) + " ");
      };
      expect<Edge_without_face_error>(mesh, ascending_values(8), is_right);
      const auto scalar_map = make_scalar_map(mesh, ascending_values(8));
      const graph_checks::Graph_of<Mesh> graph;
      BOOST_CHECK_EXCEPTION(Augmentation(mesh, scalar_map, graph), Edge_without_face_error, is_right);
      BOOST_CHECK_EXCEPTION(pants_decomposition(mesh, scalar_map, CGAL::Emptyset_iterator()), Edge_without_face_error,
                            is_right);
    }
}

// The turn around the target of the halfedge ends there onwards, and must not go on for ever backwards. Of other
// meshes, the halfedges are read face by face.
BOOST_AUTO_TEST_CASE(a_halfedge_that_does_not_know_its_face_is_refused)
{
  for(std::size_t i = 0; i != 12; ++i)
  {
    auto mesh = make_mesh<Surface_mesh>(random_meshes::tetrahedron());
    const auto h = element(halfedges(mesh), i);
    mesh.set_face(h, Surface_mesh::null_face());
    expect<Non_manifold_vertex_error>(mesh, ascending_values(4), [&](const Non_manifold_vertex_error& error) {
      return element(vertices(mesh), error.vertex()) == mesh.target(h);
    });
  }
}

// A turn goes on over the next halfedges, and backwards, where it has begun between two border edges, over the previous
// ones.
BOOST_AUTO_TEST_CASE(a_wrong_previous_halfedge_is_refused_or_not_met)
{
  auto right_mesh = make_mesh<Surface_mesh>(random_meshes::half_disk(4));
  for(const auto h : halfedges(right_mesh))
    if(!right_mesh.is_border(h))
      right_mesh.set_halfedge(right_mesh.target(h), h);
  const auto values = ascending_values(num_vertices(right_mesh));
  const auto expected = graph_checks::compute(right_mesh, values);
  std::size_t refused = 0, not_met = 0;
  for(const auto h : halfedges(right_mesh))
    for(const auto previous : halfedges(right_mesh))
    {
      auto mesh = right_mesh;
      mesh.set_prev_only(h, previous);
      try
      {
        BOOST_TEST(graph_checks::are_identical(graph_checks::compute(mesh, values), expected),
                   "previous of " << h << ": " << previous);
        ++not_met;
      }
      catch(const Non_manifold_vertex_error&)
      {
        ++refused;
      }
    }
  BOOST_TEST(refused > 0u);
  BOOST_TEST(not_met >= num_halfedges(right_mesh));
}

BOOST_AUTO_TEST_CASE(an_edge_without_a_face_is_refused_among_removed_ones)
{
  Surface_mesh mesh;
  mesh_builders::build_with_garbage(mesh, mesh_builders::make_soup(random_meshes::tetrahedron()));
  BOOST_REQUIRE(mesh.number_of_removed_edges() != 0);
  BOOST_CHECK_NO_THROW(graph_checks::compute(mesh, ascending_values(4)));
  const auto edge = mesh.edge(mesh.add_edge(element(vertices(mesh), 0), element(vertices(mesh), 1)));
  const auto found = std::find(edges(mesh).begin(), edges(mesh).end(), edge);
  const std::size_t position = static_cast<std::size_t>(std::distance(edges(mesh).begin(), found));
  expect<Edge_without_face_error>(mesh, ascending_values(4),
                                  [&](const Edge_without_face_error& error) { return error.edge() == position; });
}

BOOST_AUTO_TEST_CASE_TEMPLATE(nan_is_refused_everywhere, Mesh, Meshes)
{
  auto combinatorial_mesh = random_meshes::tetrahedron();
  ++combinatorial_mesh.number_of_vertices; // an isolated one
  const auto mesh = make_mesh<Mesh>(combinatorial_mesh);
  for(std::size_t v = 0; v < 5; ++v)
  {
    auto values = ascending_values(5);
    values[v] = not_a_number;
    expect<Unordered_scalar_error>(mesh, values, [v](const Unordered_scalar_error& error) {
      return error.vertex() == v && mentions(error, "vertex " + std::to_string(v) + " ");
    });
  }
}

BOOST_AUTO_TEST_CASE(a_removed_vertex_that_has_faces_is_refused)
{
  auto mesh = make_mesh<Surface_mesh>(random_meshes::tetrahedron());
  const auto values = mesh.add_property_map<Surface_mesh::Vertex_index, double>("v:value", 0).first;
  mesh.remove_vertex(element(vertices(mesh), 2));
  BOOST_CHECK_EXCEPTION(number_of_arcs(mesh, values), Non_manifold_vertex_error,
                        [](const Non_manifold_vertex_error& error) { return error.vertex() == 2; });
}

BOOST_AUTO_TEST_CASE(vertices_with_the_halfedge_of_another_one_are_refused)
{
  const random_meshes::Combinatorial_mesh tetrahedron = random_meshes::tetrahedron();
  auto mesh = make_mesh<Surface_mesh>(disjoint_union(tetrahedron, tetrahedron));
  for(const auto v : vertices(mesh))
    set_halfedge(v, halfedge(element(vertices(mesh), 1), mesh), mesh);
  expect<Non_manifold_vertex_error>(mesh, ascending_values(8),
                                    [](const Non_manifold_vertex_error& error) { return error.vertex() == 0; });
}

// Errors name vertices by their positions among those that have not been removed, and nobody asks for the values and
// the halfedges of the other ones.
BOOST_AUTO_TEST_CASE(removed_vertices_do_not_count)
{
  const random_meshes::Combinatorial_mesh tetrahedron = random_meshes::tetrahedron();
  Surface_mesh mesh;
  mesh_builders::build_with_garbage(mesh, mesh_builders::make_soup(disjoint_union(tetrahedron, tetrahedron)));
  BOOST_REQUIRE(mesh.has_garbage());
  auto values = mesh.add_property_map<Surface_mesh::Vertex_index, double>("v:value", not_a_number).first;
  for(std::size_t v = 0; v < 8; ++v)
    values[element(vertices(mesh), v)] = static_cast<double>(v);
  BOOST_TEST(number_of_arcs(mesh, values) == 2u);
  for(std::size_t v = 0; v < 8; ++v)
  {
    values[element(vertices(mesh), v)] = not_a_number;
    BOOST_CHECK_EXCEPTION(number_of_arcs(mesh, values), Unordered_scalar_error,
                          [v](const Unordered_scalar_error& error) { return error.vertex() == v; });
    values[element(vertices(mesh), v)] = 0;
  }
  merge_vertices(mesh, element(vertices(mesh), 7), element(vertices(mesh), 2));
  BOOST_CHECK_EXCEPTION(number_of_arcs(mesh, values), Non_manifold_vertex_error,
                        [](const Non_manifold_vertex_error& error) { return error.vertex() == 2; });
}

BOOST_AUTO_TEST_CASE_TEMPLATE(infinities_are_accepted, Mesh, Meshes)
{
  const auto mesh = make_mesh<Mesh>(random_meshes::tetrahedron());
  const std::vector<double> values = {0, infinity, -infinity, infinity};
  const auto graph = graph_checks::compute_plain(mesh, values);
  BOOST_TEST(graph.arcs.size() == 1u);
  BOOST_TEST(graph.arcs.front().lower == 2u);
  BOOST_TEST(graph.arcs.front().upper == 3u);
}

BOOST_AUTO_TEST_CASE_TEMPLATE(wrong_index_maps_are_refused, Mesh, Meshes)
{
  typedef typename boost::graph_traits<Mesh>::vertex_descriptor vertex_descriptor;
  typedef typename boost::graph_traits<Mesh>::face_descriptor face_descriptor;
  const auto mesh = make_mesh<Mesh>(random_meshes::tetrahedron());
  for(const long first_index : {-1, 3, 100})
  {
    // three of four indices are 1, 2 and 3
    const bool is_right = first_index == 100;
    const auto index = [first_index](const auto& range, const auto& element) {
      const auto found = std::find(range.begin(), range.end(), element);
      const long position = static_cast<long>(std::distance(range.begin(), found));
      return position == 0 ? first_index : position;
    };
    const auto vertex_index_map = boost::make_function_property_map<vertex_descriptor>(
      [&](vertex_descriptor v) { return index(vertices(mesh), v); });
    const auto face_index_map =
      boost::make_function_property_map<face_descriptor>([&](face_descriptor f) { return index(faces(mesh), f); });
    const auto values = ascending_values(4);
    const auto names = [](const std::string& name) {
      return [name](const Invalid_index_map_error& error) { return mentions(error, name); };
    };
    if(is_right)
    {
      graph_checks::Graph_of<Mesh> graph;
      CGAL::compute_reeb_graph(mesh, make_scalar_map(mesh, values), graph,
                               CGAL::parameters::vertex_index_map(vertex_index_map).face_index_map(face_index_map));
      BOOST_TEST(num_edges(graph) == 1u);
      continue;
    }
    expect<Invalid_index_map_error>(mesh, values, names("vertices"),
                                    CGAL::parameters::vertex_index_map(vertex_index_map));
    expect<Invalid_index_map_error>(mesh, values, names("faces"), CGAL::parameters::face_index_map(face_index_map));
  }
}

BOOST_AUTO_TEST_CASE_TEMPLATE(a_wrong_number_of_scalars_is_refused, Mesh, Meshes)
{
  const auto mesh = make_mesh<Mesh>(random_meshes::tetrahedron());
  const auto is_right = [](const Scalar_count_error& error) { return mentions(error, "4 vertices"); };
  for(std::size_t size : {0, 3, 5})
    BOOST_CHECK_EXCEPTION(make_scalar_map(mesh, ascending_values(size)), Scalar_count_error, is_right);
  BOOST_CHECK_NO_THROW(make_scalar_map(mesh, std::list<float>(4, 1.f)));
}

BOOST_AUTO_TEST_CASE_TEMPLATE(places_outside_of_an_arc_are_refused, Mesh, Meshes)
{
  const auto mesh = make_mesh<Mesh>(random_meshes::tetrahedron());
  const auto scalar_map = make_scalar_map(mesh, ascending_values(4));
  const auto graph = graph_checks::compute(mesh, ascending_values(4));
  const Augmentation augmentation(mesh, scalar_map, graph);
  const auto arc = *edges(graph).first;
  for(const double t : {0., 1., -1., 2., infinity, -infinity, not_a_number})
  {
    BOOST_CHECK_THROW(augmentation.contour(arc, t), Parameter_error);
    BOOST_CHECK_THROW(augmentation.contour(arc, t, scalar_map), Parameter_error);
  }
  BOOST_CHECK_EXCEPTION(augmentation.contour(arc, 2), Parameter_error,
                        [](const Parameter_error& error) { return mentions(error, "2.0"); });
}

BOOST_AUTO_TEST_CASE_TEMPLATE(levels_at_which_an_arc_has_no_contour_are_refused, Mesh, Meshes)
{
  const auto mesh = make_mesh<Mesh>(random_meshes::tetrahedron());
  const auto scalar_map = make_scalar_map(mesh, ascending_values(4));
  const auto graph = graph_checks::compute(mesh, ascending_values(4));
  const Augmentation augmentation(mesh, scalar_map, graph);
  const auto arc = *edges(graph).first;
  for(const double value : {-0.5, 3., 3.5, infinity, -infinity, not_a_number})
  {
    BOOST_CHECK_THROW(augmentation.contour_at_value(arc, value), Parameter_error);
    BOOST_TEST(augmentation.contours_at_value(value).empty());
  }
  for(const double value : {0., 0.5, 2.9})
    BOOST_CHECK_NO_THROW(augmentation.contour_at_value(arc, value));
}

BOOST_AUTO_TEST_CASE_TEMPLATE(arcs_and_nodes_of_another_graph_are_refused, Mesh, Meshes)
{
  const auto mesh = make_mesh<Mesh>(random_meshes::tetrahedron());
  const auto scalar_map = make_scalar_map(mesh, ascending_values(4));
  const auto graph = graph_checks::compute(mesh, ascending_values(4)), copy = graph;
  const Augmentation augmentation(mesh, scalar_map, graph);
  const auto foreign_arc = *edges(copy).first;
  BOOST_CHECK_THROW(augmentation.contour(foreign_arc, 0.5), Graph_mismatch_error);
  BOOST_CHECK_THROW(augmentation.contour(foreign_arc, 0.5, scalar_map), Graph_mismatch_error);
  BOOST_CHECK_THROW(augmentation.contour_at_value(foreign_arc, 0.5), Graph_mismatch_error);

  const auto larger_mesh = make_mesh<Mesh>(disjoint_union(random_meshes::tetrahedron(), random_meshes::tetrahedron()));
  const auto larger_graph = graph_checks::compute(larger_mesh, ascending_values(8));
  for(const auto arc : CGAL::make_range(edges(larger_graph)))
    BOOST_CHECK_THROW(augmentation.contour(arc, 0.5), Graph_mismatch_error);
  BOOST_CHECK_THROW(augmentation.critical_set(2), Graph_mismatch_error);
  BOOST_CHECK_NO_THROW(augmentation.critical_set(1));
}

BOOST_AUTO_TEST_CASE_TEMPLATE(graphs_of_other_fields_and_meshes_are_refused, Mesh, Meshes)
{
  typedef graph_checks::Scalar_map_of<Mesh> Scalar_map;
  typedef Augmentation<Mesh, Scalar_map> Augmentation_of_mesh;
  const auto mesh = make_mesh<Mesh>(random_meshes::seven_vertex_torus());
  const auto values = ascending_values(7);
  auto other_values = values;
  std::reverse(other_values.begin(), other_values.end());
  const auto scalar_map = make_scalar_map(mesh, values);
  auto graph = graph_checks::compute(mesh, values);
  const auto graph_of_other_field = graph_checks::compute(mesh, other_values);
  BOOST_CHECK_THROW(Augmentation_of_mesh(mesh, scalar_map, graph_of_other_field), Graph_mismatch_error);

  const auto other_mesh = make_mesh<Mesh>(disjoint_union(random_meshes::tetrahedron(), random_meshes::tetrahedron()));
  const auto other_graph = graph_checks::compute(other_mesh, ascending_values(8));
  BOOST_CHECK_THROW(Augmentation_of_mesh(mesh, scalar_map, other_graph), Graph_mismatch_error);

  const graph_checks::Graph_of<Mesh> empty_graph;
  BOOST_CHECK_THROW(Augmentation_of_mesh(mesh, scalar_map, empty_graph), Graph_mismatch_error);
  const auto with_another_arc = [&](std::size_t lower, std::size_t upper) {
    auto changed = graph;
    changed[add_edge(lower, upper, changed).first].chain = changed[*edges(changed).first].chain;
    return changed;
  };
  const auto with_parallel_arc = with_another_arc(0, target(*edges(graph).first, graph));
  const Augmentation_of_mesh augmentation(mesh, scalar_map, with_parallel_arc);
  BOOST_CHECK_THROW(augmentation.locate_vertices(), Graph_mismatch_error);
  const auto with_descending_arc = with_another_arc(1, 0);
  BOOST_CHECK_THROW(Augmentation_of_mesh(mesh, scalar_map, with_descending_arc), Graph_mismatch_error);
  add_edge(0, 1, graph); // without a chain
  BOOST_CHECK_THROW(Augmentation_of_mesh(mesh, scalar_map, graph), Graph_mismatch_error);
}

BOOST_AUTO_TEST_CASE_TEMPLATE(other_named_parameters_than_those_of_the_graph_are_refused, Mesh, Meshes)
{
  namespace parameters = CGAL::parameters;
  const auto mesh = make_mesh<Mesh>(random_meshes::seven_vertex_torus());
  const auto is_refused = [&](const std::vector<double>& values, const auto& np, const auto& other_np) {
    const auto scalar_map = make_scalar_map(mesh, values);
    graph_checks::Graph_of<Mesh> graph, other_graph;
    CGAL::compute_reeb_graph(mesh, scalar_map, graph, np);
    CGAL::compute_reeb_graph(mesh, scalar_map, other_graph, other_np);
    BOOST_TEST_REQUIRE(num_vertices(graph) != num_vertices(other_graph));
    BOOST_CHECK_NO_THROW(Augmentation(mesh, scalar_map, graph, np).locate_vertices());
    BOOST_CHECK_THROW(Augmentation(mesh, scalar_map, graph, other_np).locate_vertices(), Graph_mismatch_error);
  };
  const std::vector<double> constant(7, 1);
  is_refused(constant, parameters::ties(Ties::PERTURB), parameters::ties(Ties::CONTRACT));
  is_refused(constant, parameters::ties(Ties::CONTRACT), parameters::ties(Ties::PERTURB));
  // three lower sectors at vertex 0, but one contour just below it and one just above
  const std::vector<double> with_multiple_saddle = {3, 0, 1, 4, 2, 6, 5};
  is_refused(with_multiple_saddle, parameters::keep_degree_two_nodes(true), parameters::keep_degree_two_nodes(false));
  is_refused(with_multiple_saddle, parameters::keep_degree_two_nodes(false), parameters::keep_degree_two_nodes(true));
}

// The levels next to its nodes could miss an arc.
BOOST_AUTO_TEST_CASE_TEMPLATE(other_ties_than_those_of_the_graph_are_refused_at_once, Mesh, Meshes)
{
  namespace parameters = CGAL::parameters;
  const auto mesh = make_mesh<Mesh>(random_meshes::seven_vertex_torus());
  std::size_t number_of_refused = 0;
  for(unsigned seed = 0; seed != 200; ++seed)
  {
    BOOST_TEST_CONTEXT("seed " << seed)
    {
      std::mt19937 random(seed);
      std::vector<double> values(7);
      for(double& value : values)
        value = random() % 3;
      const auto scalar_map = make_scalar_map(mesh, values);
      graph_checks::Graph_of<Mesh> perturbed, contracted;
      CGAL::compute_reeb_graph(mesh, scalar_map, perturbed);
      CGAL::compute_reeb_graph(mesh, scalar_map, contracted, parameters::ties(Ties::CONTRACT));
      const auto arcs = edges(perturbed);
      const bool has_flat_arc = std::any_of(arcs.first, arcs.second, [&](const auto& arc) {
        return perturbed[source(arc, perturbed)].value == perturbed[target(arc, perturbed)].value;
      });
      const auto use = [&](const auto& graph, Ties ties) {
        const Augmentation augmentation(mesh, scalar_map, graph, parameters::ties(ties));
        for(const auto node : CGAL::make_range(vertices(graph)))
          for(const auto& contour : augmentation.critical_set(node).upper_contours)
            for(const auto h : contour.edges)
              BOOST_TEST(get(scalar_map, source(h, mesh)) <= get(scalar_map, target(h, mesh)));
      };
      if(has_flat_arc)
        BOOST_CHECK_THROW(use(perturbed, Ties::CONTRACT), Graph_mismatch_error);
      try
      {
        use(contracted, Ties::PERTURB);
      }
      catch(const Graph_mismatch_error&)
      {
        ++number_of_refused;
      }
    }
  }
  BOOST_TEST(number_of_refused > 0u);

  // The contracted node of vertices 0 and 2 is named 0, but its arcs leave from 2.
  const auto scalar_map = make_scalar_map(mesh, std::vector<double>{0, 0, 0, 3, 4, 5, 6});
  graph_checks::Graph_of<Mesh> graph;
  CGAL::compute_reeb_graph(mesh, scalar_map, graph, parameters::ties(Ties::CONTRACT));
  BOOST_CHECK_THROW(Augmentation(mesh, scalar_map, graph), Graph_mismatch_error);
  Mesh copy = mesh;
  const auto patch_map = get(CGAL::dynamic_face_property_t<std::size_t>(), copy);
  const auto map_of_copy = make_scalar_map(copy, std::vector<double>{0, 0, 0, 3, 4, 5, 6});
  const graph_checks::Graph_of<Mesh> empty_graph;
  BOOST_CHECK_THROW(segment_by_arcs(copy, map_of_copy, empty_graph, patch_map), Graph_mismatch_error);
  CGAL::compute_reeb_graph(copy, map_of_copy, graph, parameters::ties(Ties::CONTRACT));
  BOOST_CHECK_THROW(segment_by_arcs(copy, map_of_copy, graph, patch_map), Graph_mismatch_error);
  BOOST_TEST(num_faces(copy) == num_faces(mesh));
}

BOOST_AUTO_TEST_CASE(an_order_that_throws_leaves_the_graph_as_it_was)
{
  const auto mesh = make_mesh<Surface_mesh>(random_meshes::seven_vertex_torus());
  const auto scalar_map = make_scalar_map(mesh, ascending_values(7));
  const auto old_mesh = make_mesh<Surface_mesh>(random_meshes::tetrahedron());
  const auto old_graph = graph_checks::compute(old_mesh, ascending_values(4));
  const auto new_graph = graph_checks::compute(mesh, ascending_values(7));
  bool is_thrown = true;
  for(std::size_t last_call = 0; is_thrown; ++last_call)
  {
    std::atomic<std::size_t> number_of_calls(0);
    Throwing_traits traits;
    traits.less = {&number_of_calls, last_call};
    auto graph = old_graph;
    is_thrown = false;
    try
    {
      CGAL::compute_reeb_graph(mesh, scalar_map, graph, CGAL::parameters::geom_traits(traits));
    }
    catch(const std::runtime_error&)
    {
      is_thrown = true;
    }
    BOOST_TEST(graph_checks::are_identical(graph, is_thrown ? old_graph : new_graph));
  }
}

// To sort NaN can lead anywhere. The order throws when it is asked.
BOOST_AUTO_TEST_CASE(values_are_checked_before_they_are_compared)
{
  auto mesh = make_mesh<Surface_mesh>(random_meshes::seven_vertex_torus());
  auto values = ascending_values(7);
  const auto graph = graph_checks::compute(mesh, values);
  std::atomic<std::size_t> number_of_calls(0);
  Throwing_traits traits;
  traits.less = {&number_of_calls, 0};
  const auto np = CGAL::parameters::geom_traits(traits);
  BOOST_CHECK_NO_THROW(internal::check_input(mesh, make_scalar_map(mesh, values), np));
  values[3] = not_a_number;
  const auto scalar_map = make_scalar_map(mesh, values);
  const auto patch_map = get(CGAL::dynamic_face_property_t<std::size_t>(), mesh);
  BOOST_CHECK_THROW(internal::check_input(mesh, scalar_map, np), Unordered_scalar_error);
  BOOST_CHECK_THROW(segment_by_arcs(mesh, scalar_map, graph, patch_map, np), Unordered_scalar_error);
  BOOST_CHECK_THROW(pants_decomposition(mesh, scalar_map, CGAL::Emptyset_iterator(), np), Unordered_scalar_error);
  BOOST_TEST(number_of_calls == 0u);
}

// The same points and values, and halfedges that the mesh does not have.
BOOST_AUTO_TEST_CASE(graphs_of_larger_meshes_with_the_same_values_are_refused)
{
  const auto torus = random_meshes::seven_vertex_torus();
  random_meshes::Combinatorial_mesh part = {7, {}};
  std::copy_if(torus.triangles.begin(), torus.triangles.end(), std::back_inserter(part.triangles),
               [](const auto& t) { return std::count(t.begin(), t.end(), 6u) == 0; });
  const auto mesh = make_mesh<Surface_mesh>(torus), smaller_mesh = make_mesh<Surface_mesh>(part);
  for(const Ties ties : {Ties::PERTURB, Ties::CONTRACT})
  {
    graph_checks::Graph_of<Surface_mesh> graph;
    CGAL::compute_reeb_graph(mesh, make_scalar_map(mesh, ascending_values(7)), graph, CGAL::parameters::ties(ties));
    const auto scalar_map = make_scalar_map(smaller_mesh, ascending_values(7));
    BOOST_CHECK_THROW(Augmentation(smaller_mesh, scalar_map, graph, CGAL::parameters::ties(ties)).locate_vertices(),
                      Graph_mismatch_error);
  }
}

BOOST_AUTO_TEST_CASE(more_vertices_than_32_bit_indices_are_refused)
{
  // the mesh would be too large for a test: only the check that every count goes through
  BOOST_CHECK_THROW(internal::checked_index(std::size_t(1) << 32), Mesh_size_error);
  BOOST_CHECK_THROW(internal::checked_index((std::size_t(1) << 32) - 1), Mesh_size_error);
  BOOST_TEST(internal::checked_index((std::size_t(1) << 32) - 2) == 4294967294u);
}

BOOST_AUTO_TEST_SUITE_END()
