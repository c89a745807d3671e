// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#include <boost/test/unit_test.hpp>

#include "graph_checks.h"
#include "known_meshes.h"
#include "mesh_builders.h"
#include "random_fields.h"
#include "random_meshes.h"
#include "shuffle.h"

#include <CGAL/Reeb_graph/internal/complex/Flat_mesh.h>
#include <CGAL/Reeb_graph/internal/complex/Regular_vertices.h>
#include <CGAL/Reeb_graph/internal/engine/find_arcs.h>

#include <boost/mpl/list.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <map>
#include <numeric>
#include <set>
#include <type_traits>
#include <utility>
#include <vector>

// The two methods against each other, and what the near-linear one costs.

BOOST_AUTO_TEST_SUITE(test_engines)

using CGAL::Reeb_graph::Method;
using CGAL::Reeb_graph::Ties;
using mesh_builders::make_mesh;
using mesh_builders::Surface_mesh;
using random_meshes::Combinatorial_mesh;
using random_meshes::Field_class;
using random_meshes::Mesh_class;
using random_meshes::Random;
using random_meshes::Vertex_triple;
namespace stages = CGAL::Reeb_graph::internal;

namespace {
typedef graph_checks::Graph_of<Surface_mesh> Graph;
typedef graph_checks::Scalar_map_of<Surface_mesh> Scalar_map;

Graph compute(const Surface_mesh& mesh,
              const Scalar_map& scalar_map,
              Method method,
              Ties ties,
              bool keeps_degree_two_nodes)
{
  namespace parameters = CGAL::parameters;
  Graph graph;
  CGAL::compute_reeb_graph(mesh, scalar_map, graph,
                           parameters::method(method).ties(ties).keep_degree_two_nodes(keeps_degree_two_nodes));
  return graph;
}

void compare_methods(const Surface_mesh& mesh, const std::vector<double>& values)
{
  const auto scalar_map = CGAL::Reeb_graph::make_scalar_map(mesh, values);
  for(const Ties ties : {Ties::PERTURB, Ties::CONTRACT})
    for(const bool keeps_degree_two_nodes : {false, true})
    {
      const Graph expected = compute(mesh, scalar_map, Method::CRITICAL_SETS, ties, keeps_degree_two_nodes);
      const Graph graph = compute(mesh, scalar_map, Method::CONTOUR_TREES, ties, keeps_degree_two_nodes);
      if(!graph_checks::are_identical(expected, graph))
        BOOST_ERROR("the methods differ; ties contracted: " << (ties == Ties::CONTRACT)
                                                            << ", degree two nodes kept: " << keeps_degree_two_nodes);
    }
}

template <class MeshFunction>
void compare_methods_on_random_meshes(std::size_t number_of_seeds,
                                      const MeshFunction& random_mesh,
                                      std::vector<Field_class> field_classes)
{
  for(std::size_t seed = 0; seed < number_of_seeds; ++seed)
  {
    Random random(seed);
    const Combinatorial_mesh mesh = random_mesh(random);
    const auto values = random_meshes::random_field(mesh, field_classes[seed % field_classes.size()], random);
    BOOST_TEST_CONTEXT("seed " << seed)
    compare_methods(make_mesh<Surface_mesh>(mesh), values);
  }
}

Combinatorial_mesh surface_of_high_genus(Random& random)
{
  const std::size_t number_of_splits = random.below(4);
  return random_meshes::random_closed_surface(static_cast<unsigned>(4 + random.below(9)), number_of_splits, random);
}

typedef CGAL::Reeb_graph_traits<Surface_mesh, Scalar_map> Traits;
typedef stages::Vertex_order Order;
typedef stages::Surface_mesh_complex<Surface_mesh::Point> Complex;
typedef boost::mpl::list<Surface_mesh, mesh_builders::Polyhedron> Meshes;

// Kinds of indices do not become each other, nor numbers, unless told so.
static_assert(!std::is_convertible_v<stages::Vertex_index, stages::Halfedge_index>);
static_assert(!std::is_constructible_v<stages::Vertex_index, stages::Halfedge_index>);
static_assert(!std::is_convertible_v<stages::Vertex_index, std::size_t>);
static_assert(!std::is_convertible_v<std::size_t, stages::Vertex_index>);
static_assert(std::is_trivial_v<stages::Vertex_index> && sizeof(stages::Vertex_index) == 4);

struct Surgery
{
  std::size_t number_of_cuts = 0;
  std::size_t number_of_traced_edges = 0;
  bool are_several_cuts_on_an_edge = false;
  std::size_t number_of_cuts_at_multi_saddles = 0;
  bool is_longest_contour_cut = false; // of a sublevel component at a vertex
  std::size_t number_of_correction_steps = 0;
  std::vector<stages::Tree_node> split_tree, classes;
};

// Follows each cut from an edge on which it is the lowest one, and looks whether another one is lower elsewhere.
bool are_several_cuts_on_an_edge(const Complex& complex,
                                 const Order& order,
                                 const stages::Swept_vertices& critical_vertices,
                                 const stages::Contour_cuts& cuts)
{
  std::set<stages::Cut_index> followed = {stages::no_index};
  bool are_several = false;
  for(std::size_t edge = 0; edge != complex.number_of_edges(); ++edge)
  {
    const stages::Halfedge_index halfedge = complex.halfedge_of_triangle(stages::Edge_index(edge));
    const stages::Cut_index cut = cuts.lowest_at_edge(halfedge);
    if(!followed.insert(cut).second)
      continue;
    const stages::Vertex_index vertex = critical_vertices.vertex(cuts.critical_vertex(cut));
    stages::trace_contour(
      complex, halfedge, [&](stages::Vertex_index u) { return order(u, vertex); },
      [&](stages::Halfedge_index crossed) { are_several |= cuts.lowest_at_edge(crossed) != cut; });
  }
  return are_several || followed.size() - 1 != cuts.size();
}

// Whether no other contour just below the vertex, in the same sublevel component, is as long as the one that is cut.
template <class Classes>
bool is_longest_lower_contour(const Complex& complex,
                              const Order& order,
                              const stages::Swept_vertices& critical_vertices,
                              stages::Swept_index critical,
                              const Classes& classes,
                              stages::Tree_node sublevel_class,
                              std::size_t length_of_cut)
{
  std::map<stages::Edge_index, std::size_t> lengths; // by the first edge of the contour
  for(const stages::Sector_index sector : critical_vertices.sectors(critical, stages::Side::LOWER))
  {
    if(classes[sector] != sublevel_class)
      continue;
    std::set<stages::Edge_index> edges;
    stages::trace_contour(
      complex, critical_vertices.sector(stages::Side::LOWER, sector).edge,
      [&](stages::Vertex_index u) { return order(u, critical_vertices.vertex(critical)); },
      [&](stages::Halfedge_index halfedge) { edges.insert(stages::edge_of(halfedge)); });
    lengths[*edges.begin()] = edges.size();
  }
  return std::count_if(lengths.begin(), lengths.end(),
                       [&](const auto& contour) { return contour.second >= length_of_cut; })
       < 2;
}

// runs the stages up to the cuts
Surgery cut_loops(const Surface_mesh& mesh, const std::vector<double>& values, bool are_paths_walked_first = true)
{
  const Traits traits;
  const auto scalar_map = CGAL::Reeb_graph::make_scalar_map(mesh, values);
  const auto surface = stages::flatten(stages::Threads(), mesh, scalar_map, traits, CGAL::parameters::default_values());
  const Order order(surface.field.keys());
  const auto critical_vertices = stages::classify_vertices(stages::Threads(), surface.mesh->complex, order);
  const auto& ascending = critical_vertices.ascending();
  const stages::Slab slab(surface.mesh->complex, critical_vertices);

  stages::Merge_tree_sweep<Complex, stages::Side::LOWER> upwards(slab, order);
  upwards.find_path_ends(stages::Threads());
  std::for_each(ascending.begin(), ascending.end(), [&](stages::Swept_index critical) { upwards.merge_at(critical); });

  stages::Cutting_sweep<Complex> downwards(slab, order);
  if(are_paths_walked_first)
    downwards.find_path_ends(stages::Threads());
  stages::Loop_surgery<Complex> surgery(slab, order, upwards.tree(), downwards.tree());
  std::size_t number_of_cuts_at_multi_saddles = 0;
  bool is_longest_contour_cut = false;
  const auto begin = std::make_reverse_iterator(ascending.end()), end = std::make_reverse_iterator(ascending.begin());
  std::for_each(begin, end, [&](stages::Swept_index critical) {
    downwards.merge_at(critical);
    if(surgery.can_close_loop(critical))
      surgery.visit_loop_contours(
        critical, [&](stages::Tree_node sublevel_class, const auto& crossed, bool has_border) {
          downwards.cut(critical, sublevel_class, crossed, has_border);
          number_of_cuts_at_multi_saddles += critical_vertices.number_of_lower_sectors(critical) > 2 ? 1 : 0;
          is_longest_contour_cut |= is_longest_lower_contour(surface.mesh->complex, order, critical_vertices, critical,
                                                             upwards.tree().classes, sublevel_class, crossed.size());
        });
  });
  stages::Contour_cuts cuts = downwards.take_cuts();
  cuts.register_edges();
  const stages::Merge_tree& tree = downwards.tree();
  return {cuts.size(),
          surgery.number_of_steps(),
          are_several_cuts_on_an_edge(surface.mesh->complex, order, critical_vertices, cuts),
          number_of_cuts_at_multi_saddles,
          is_longest_contour_cut,
          downwards.number_of_steps(),
          {tree.parents.begin(), tree.parents.end()},
          {tree.classes.begin(), tree.classes.end()}};
}

std::vector<double> noise(const Surface_mesh& mesh, std::size_t seed)
{
  Random random(seed);
  return random_meshes::random_permutation(mesh.number_of_vertices(), random);
}

// the mean over some fields, as that of a single one depends much on chance
double traced_edges_per_vertex(const Surface_mesh& mesh)
{
  constexpr std::size_t number_of_fields = 8;
  std::size_t sum = 0;
  for(std::size_t seed = 0; seed < number_of_fields; ++seed)
    sum += cut_loops(mesh, noise(mesh, seed)).number_of_traced_edges;
  return static_cast<double>(sum) / static_cast<double>(number_of_fields * mesh.number_of_vertices());
}
} // namespace

BOOST_AUTO_TEST_CASE(random_meshes_of_all_classes)
{
  constexpr std::size_t number_of_classes = static_cast<std::size_t>(Mesh_class::NUMBER_OF_CLASSES);
  constexpr std::size_t number_of_field_classes = static_cast<std::size_t>(Field_class::NUMBER_OF_CLASSES);
  for(std::size_t seed = 0; seed < 4800; ++seed)
  {
    Random random(100000 + seed);
    const auto mesh = random_meshes::random_mesh(static_cast<Mesh_class>(seed % number_of_classes), random);
    const auto field_class = static_cast<Field_class>(seed / number_of_classes % number_of_field_classes);
    BOOST_TEST_CONTEXT("seed " << seed)
    compare_methods(make_mesh<Surface_mesh>(mesh), random_meshes::random_field(mesh, field_class, random));
  }
}

BOOST_AUTO_TEST_CASE(high_genus_on_few_vertices)
{
  compare_methods_on_random_meshes(1500, surface_of_high_genus,
                                   {Field_class::PERMUTATION, Field_class::FEW_VALUES, Field_class::HUB});
}

BOOST_AUTO_TEST_CASE(noise_on_surfaces_with_border)
{
  compare_methods_on_random_meshes(3000, random_meshes::random_bordered_surface,
                                   {Field_class::PERMUTATION, Field_class::INTEGERS, Field_class::BORDER_LEVELS});
}

BOOST_AUTO_TEST_CASE(multiple_saddles)
{
  compare_methods_on_random_meshes(1500, random_meshes::random_hub, {Field_class::HUB});
  Random random(0);
  for(const auto& mesh : {random_meshes::bipyramid(600), random_meshes::disk(600), random_meshes::half_disk(600)})
    compare_methods(make_mesh<Surface_mesh>(mesh), random_meshes::random_field(mesh, Field_class::HUB, random));
}

BOOST_AUTO_TEST_CASE(all_orders_of_an_annulus)
{
  const Surface_mesh mesh = make_mesh<Surface_mesh>(known_meshes::seven_vertex_annulus());
  std::vector<double> values = {0, 1, 2, 3, 4, 5, 6};
  do
  {
    BOOST_TEST_CONTEXT("order " << values[0] << values[1] << values[2] << values[3] << values[4] << values[5])
    compare_methods(mesh, values);
  } while(std::next_permutation(values.begin(), values.end()));
}

BOOST_AUTO_TEST_CASE(several_edges_between_two_vertices)
{
  for(std::size_t seed = 0; seed < 1500; ++seed)
  {
    Random random(seed);
    const std::size_t number_of_splits = random.below(4);
    const auto combinatorial_mesh =
      random_meshes::random_closed_surface(static_cast<unsigned>(random.below(6)), number_of_splits, random);
    Surface_mesh mesh = make_mesh<Surface_mesh>(combinatorial_mesh);
    mesh_builders::flip_edges_carelessly(mesh, 200, random);
    const auto field_class = seed % 3 == 0 ? Field_class::FEW_VALUES : Field_class::PERMUTATION;
    BOOST_TEST_CONTEXT("seed " << seed)
    compare_methods(mesh, random_meshes::random_field(combinatorial_mesh, field_class, random));
  }
}

BOOST_AUTO_TEST_CASE(several_cuts_through_an_edge)
{
  std::size_t number_of_cases = 0;
  for(std::size_t seed = 0; seed < 1000; ++seed)
  {
    Random random(200000 + seed);
    const Surface_mesh mesh = make_mesh<Surface_mesh>(surface_of_high_genus(random));
    const auto values = noise(mesh, seed);
    if(!cut_loops(mesh, values).are_several_cuts_on_an_edge)
      continue;
    ++number_of_cases;
    BOOST_TEST_CONTEXT("seed " << seed)
    compare_methods(mesh, values);
  }
  BOOST_TEST_MESSAGE(number_of_cases << " cases");
  BOOST_TEST(number_of_cases > 100u);
}

BOOST_AUTO_TEST_CASE(generated_surfaces_with_noise_and_ties)
{
  using generated_surfaces::closed_surface;
  std::size_t seed = 0;
  for(const auto& soup : {closed_surface(3, 4000), closed_surface(10, 4000), closed_surface(25, 4000),
                          generated_surfaces::terrain(60, 60)})
    BOOST_TEST_CONTEXT("surface " << seed)
    {
      const Surface_mesh mesh = make_mesh<Surface_mesh>(soup);
      Random random(++seed);
      std::vector<double> tilted_height, noisy_height, half_noise;
      for(const auto& p : soup.points)
      {
        tilted_height.push_back(0.9 * p[0] + 0.3 * p[1] + 0.2 * p[2]);
        noisy_height.push_back(std::round(20 * tilted_height.back()) + static_cast<double>(random.below(3)));
        half_noise.push_back(p[0] < 0 ? tilted_height.back() : static_cast<double>(random.below(1000)) / 500 - 1);
      }
      compare_methods(mesh, tilted_height);
      compare_methods(mesh, noisy_height);
      compare_methods(mesh, half_noise);
      compare_methods(mesh, noise(mesh, seed));
      compare_methods(mesh, random_meshes::random_integers(soup.points.size(), 5, random));
      compare_methods(mesh, std::vector<double>(soup.points.size(), 1));
    }
}

// Spheres, disks and vertices alone have no loops. Beside other components, their Euler characteristics hide those of
// the others.
BOOST_AUTO_TEST_CASE(components_without_loops_beside_others)
{
  for(std::size_t seed = 0; seed < 400; ++seed)
  {
    Random random(300000 + seed);
    Combinatorial_mesh mesh;
    const auto add = [&](std::size_t number, const auto& random_component) {
      for(std::size_t i = 0; i != number; ++i)
        mesh = random_meshes::disjoint_union(mesh, random_component());
    };
    add(1 + random.below(3), [&] { return random_meshes::random_closed_surface(0, random.below(4), random); });
    add(random.below(3), [&] { return random_meshes::disk(3 + random.below(4)); });
    add(random.below(3), [&] { return random_meshes::random_closed_surface(1, random.below(4), random); });
    add(random.below(3), [&] { return random_meshes::cylinder(3 + random.below(4), 3); });
    mesh.number_of_vertices += random.below(3);
    BOOST_TEST_CONTEXT("seed " << seed)
    compare_methods(make_mesh<Surface_mesh>(mesh), random_meshes::random_field(mesh, Field_class::PERMUTATION, random));
  }
}

BOOST_AUTO_TEST_CASE(critical_vertices_tell_the_euler_characteristic)
{
  constexpr std::size_t number_of_classes = static_cast<std::size_t>(Mesh_class::NUMBER_OF_CLASSES);
  for(std::size_t seed = 0; seed < 1200; ++seed)
  {
    Random random(400000 + seed);
    const Surface_mesh mesh =
      make_mesh<Surface_mesh>(random_meshes::random_mesh(static_cast<Mesh_class>(seed % number_of_classes), random));
    const auto values = noise(mesh, seed);
    const auto surface = stages::flatten(stages::Threads(), mesh, CGAL::Reeb_graph::make_scalar_map(mesh, values),
                                         Traits(), CGAL::parameters::default_values());
    const Order order(surface.field.keys());
    const auto characteristic = static_cast<std::ptrdiff_t>(mesh.number_of_vertices() + mesh.number_of_faces())
                              - static_cast<std::ptrdiff_t>(mesh.number_of_edges());
    BOOST_TEST_CONTEXT("seed " << seed)
    BOOST_TEST(stages::euler_characteristic(stages::classify_vertices(stages::Threads(), surface.mesh->complex, order))
               == characteristic);
  }
}

BOOST_AUTO_TEST_CASE_TEMPLATE(vertices_that_a_sweep_sees_to_be_regular_are, Mesh, Meshes)
{
  constexpr std::size_t number_of_classes = static_cast<std::size_t>(Mesh_class::NUMBER_OF_CLASSES);
  std::size_t number_of_regular_vertices = 0;
  for(std::size_t seed = 0; seed < 1200; ++seed)
  {
    Random random(410000 + seed);
    const auto combinatorial_mesh =
      random_meshes::random_mesh(static_cast<Mesh_class>(seed % number_of_classes), random);
    const Mesh mesh = make_mesh<Mesh>(combinatorial_mesh);
    const auto values = random_meshes::random_field(combinatorial_mesh, Field_class::PERMUTATION, random);
    const CGAL::Reeb_graph_traits<Mesh, graph_checks::Scalar_map_of<Mesh>> traits;
    const auto surface = stages::flatten(stages::Threads(), mesh, CGAL::Reeb_graph::make_scalar_map(mesh, values),
                                         traits, CGAL::parameters::default_values());
    const stages::Vertex_order order(surface.field.keys());
    const stages::Regular_vertices regular_vertices(stages::Threads(), surface.mesh->complex, order);
    for(const stages::Vertex_index v : surface.mesh->complex.vertices())
    {
      if(regular_vertices.number_of_corners(v) == 0)
        continue;
      ++number_of_regular_vertices;
      std::size_t number_of_corners = 0;
      surface.mesh->complex.for_each_halfedge_around(v, [&](stages::Halfedge_index) { ++number_of_corners; });
      BOOST_TEST_CONTEXT("seed " << seed)
      {
        BOOST_TEST(regular_vertices.number_of_corners(v) == number_of_corners);
        BOOST_TEST((surface.mesh->complex.target(surface.mesh->complex.kept_halfedge(v)) == v));
        BOOST_TEST(!surface.mesh->complex.is_on_border(v));
        BOOST_TEST(stages::find_link(surface.mesh->complex, order, v).summary.number_of_sectors == 2u);
      }
    }
  }
  BOOST_TEST(number_of_regular_vertices > 1000u);
}

// A vertex with a second fan looks regular by the first one alone.
BOOST_AUTO_TEST_CASE_TEMPLATE(a_sweep_does_not_see_vertices_with_two_fans_to_be_regular, Mesh, Meshes)
{
  std::size_t number_of_regular_fans = 0;
  for(std::size_t seed = 0; seed < 600; ++seed)
  {
    Random random(420000 + seed);
    const auto first = random_meshes::random_closed_surface(seed % 3, 10, random);
    const auto combinatorial_mesh = disjoint_union(first, random_meshes::random_closed_surface(0, 3, random));
    Mesh mesh = make_mesh<Mesh>(combinatorial_mesh);
    const auto values = random_meshes::random_field(combinatorial_mesh, Field_class::PERMUTATION, random);
    const auto scalar_map = CGAL::Reeb_graph::make_scalar_map(mesh, values);
    const std::size_t kept = random.below(first.number_of_vertices);
    const std::size_t other =
      first.number_of_vertices + random.below(combinatorial_mesh.number_of_vertices - first.number_of_vertices);
    const CGAL::Reeb_graph_traits<Mesh, graph_checks::Scalar_map_of<Mesh>> traits;
    const auto is_seen_to_be_regular = [&] {
      const auto surface =
        stages::flatten_unchecked(stages::Threads(), mesh, scalar_map, traits, CGAL::parameters::default_values());
      const stages::Vertex_order order(surface.field.keys());
      return stages::Regular_vertices(stages::Threads(), surface.complex.at_set_fans(), order)
               .number_of_corners(stages::Vertex_index(kept))
          != 0;
    };
    number_of_regular_fans += is_seen_to_be_regular() ? 1 : 0;
    const auto v = *std::next(vertices(mesh).begin(), static_cast<std::ptrdiff_t>(kept));
    const auto u = *std::next(vertices(mesh).begin(), static_cast<std::ptrdiff_t>(other));
    for(const auto h : halfedges(mesh))
      if(target(h, mesh) == u)
        set_target(h, v, mesh);
    BOOST_TEST_CONTEXT("seed " << seed)
    BOOST_TEST(!is_seen_to_be_regular());
  }
  BOOST_TEST(number_of_regular_fans > 50u);
}

// Whatever a mesh tells of one face that does not agree, or of one edge that has no second one, is seen.
BOOST_AUTO_TEST_CASE(a_sweep_sees_nothing_on_faces_that_are_not_right)
{
  typedef Surface_mesh::Halfedge_index H;
  typedef Surface_mesh::Face_index F;
  typedef Surface_mesh::Vertex_index V;
  const auto soup = generated_surfaces::closed_surface(1, 200);
  const auto values = noise(make_mesh<Surface_mesh>(soup), 1);
  const stages::Indexed_vector<stages::Vertex_index, double> indexed_values(values.begin(), values.end());
  const Order order(indexed_values);
  const auto after = [&](const auto& change) {
    auto mesh = make_mesh<Surface_mesh>(soup);
    change(mesh, halfedge(F(37), mesh), H(0), F(37));
    const stages::Regular_vertices regular_vertices(stages::Threads(), Complex(mesh), order);
    std::size_t number = 0;
    for(const auto v : vertices(mesh))
      number += regular_vertices.number_of_corners(stages::Vertex_index(v)) != 0 ? 1 : 0;
    return number;
  };
  const std::size_t all = after([](Surface_mesh&, H, H, F) {});
  BOOST_TEST(all > 20u);
  BOOST_TEST(after([](Surface_mesh& m, H h, H other, F) { m.set_next_only(h, other); }) == 0u);
  BOOST_TEST(after([](Surface_mesh& m, H h, H, F) { m.set_next_only(h, H(1000000)); }) == 0u);
  BOOST_TEST(after([](Surface_mesh& m, H h, H, F) { m.set_next_only(next(h, m), next(h, m)); }) == 0u);
  BOOST_TEST(after([](Surface_mesh& m, H h, H other, F) { m.set_prev_only(h, other); }) == 0u);
  BOOST_TEST(after([](Surface_mesh& m, H h, H, F) { m.set_prev_only(h, H(1000000)); }) == 0u);
  BOOST_TEST(after([](Surface_mesh& m, H h, H, F) { m.set_target(h, source(h, m)); }) == 0u);
  BOOST_TEST(after([](Surface_mesh& m, H h, H, F) { m.set_target(h, V(5000)); }) == 0u);
  BOOST_TEST(after([](Surface_mesh& m, H h, H, F) { m.set_face(next(h, m), F(5)); }) == 0u);
  BOOST_TEST(after([](Surface_mesh& m, H, H other, F f) { m.set_halfedge(f, other); }) == 0u);
  BOOST_TEST(after([](Surface_mesh& m, H, H, F f) { m.set_halfedge(f, H()); }) == 0u);
  BOOST_TEST(after([](Surface_mesh& m, H h, H, F) { m.remove_edge(m.edge(h)); }) == 0u);
  // Without a face, edges are on the border, and their ends are not seen.
  const std::size_t without_face =
    after([](Surface_mesh& m, H, H, F f) { CGAL::Euler::remove_face(halfedge(f, m), m); });
  BOOST_TEST((without_face > 20u && without_face < all + 1));
  // A vertex whose halfedge ends elsewhere is not seen.
  std::size_t number_of_unseen = 0;
  for(std::size_t v = 0; v < values.size(); v += 10)
    for(const H wrong : {H(), H(1000000), H(0)})
      number_of_unseen += all - after([&](Surface_mesh& m, H, H, F) {
                            m.set_halfedge(V(v), wrong == H(0) ? opposite(halfedge(V(v), m), m) : wrong);
                          });
  BOOST_TEST(number_of_unseen > all / 10);
  BOOST_TEST(number_of_unseen % 3 == 0u);
}

// A vertex with more corners than fit into the bits of a count: nothing is seen then.
BOOST_AUTO_TEST_CASE(a_sweep_sees_nothing_beside_a_hub)
{
  for(const std::size_t degree : {1000u, 40000u})
  {
    Combinatorial_mesh wheel = {degree + 2, {}};
    for(std::size_t i = 0; i != degree; ++i)
      for(const bool is_upper : {false, true})
        wheel.triangles.push_back(is_upper ? Vertex_triple{degree, i, (i + 1) % degree}
                                           : Vertex_triple{degree + 1, (i + 1) % degree, i});
    const Surface_mesh mesh = make_mesh<Surface_mesh>(wheel);
    stages::Indexed_vector<stages::Vertex_index, double> values;
    for(std::size_t v = 0; v != degree + 2; ++v)
      values.push_back(v == degree ? 1e9 : v > degree ? -1. : static_cast<double>(v < degree / 2 ? v : 2 * degree - v));
    const Order order(values);
    const stages::Regular_vertices regular_vertices(stages::Threads(), Complex(mesh), order);
    std::size_t number = 0;
    for(std::size_t v = 0; v != degree + 2; ++v)
      number += regular_vertices.number_of_corners(stages::Vertex_index(v)) != 0 ? 1 : 0;
    BOOST_TEST((degree == 1000u ? number > 900u : number == 0u), degree << " " << number);
  }
}

namespace {
std::vector<double> smooth_field(const Surface_mesh& mesh)
{
  std::vector<double> values;
  for(const auto v : vertices(mesh))
    values.push_back(std::sin(3 * mesh.point(v).x()) + std::sin(2 * mesh.point(v).y()) + mesh.point(v).z());
  return values;
}

typedef stages::Way_of_turning Way;

Way fastest_way(const Surface_mesh& mesh, const std::vector<double>& values)
{
  const stages::Indexed_vector<stages::Vertex_index, double> indexed_values(values.begin(), values.end());
  return stages::fastest_way(Complex(mesh), Order(indexed_values));
}

std::multiset<std::pair<double, double>> values_of_arcs(const Surface_mesh& mesh, const std::vector<double>& values)
{
  const auto graph = graph_checks::compute(mesh, values);
  std::multiset<std::pair<double, double>> arcs;
  for(const auto arc : CGAL::make_range(edges(graph)))
    arcs.emplace(graph[source(arc, graph)].value, graph[target(arc, graph)].value);
  return arcs;
}
} // namespace

// Stars are fetched ahead where neighbors are far from each other in memory, which takes a large mesh.
BOOST_AUTO_TEST_CASE(a_mesh_in_bad_order_has_the_graph_of_the_ordered_one)
{
  auto soup = generated_surfaces::closed_surface(3, 36000);
  const auto ordered_mesh = make_mesh<Surface_mesh>(soup);
  Random random(430000);
  generated_surfaces::shuffle(soup, random);
  auto mesh = make_mesh<Surface_mesh>(soup);
  const auto ordered_values = smooth_field(ordered_mesh), values = smooth_field(mesh);
  BOOST_TEST((fastest_way(ordered_mesh, ordered_values) == Way::ONE_BY_ONE));
  BOOST_TEST((fastest_way(mesh, values) == Way::STARS_AHEAD));
  BOOST_TEST((fastest_way(mesh, noise(mesh, 1)) == Way::STARS_AHEAD));
  const auto arcs = values_of_arcs(ordered_mesh, ordered_values);
  BOOST_TEST(arcs.size() > 10u);
  BOOST_TEST((values_of_arcs(mesh, values) == arcs));

  // All is refused that is refused elsewhere.
  const Surface_mesh::Vertex_index u(1000), v(17);
  for(const auto h : halfedges(mesh))
    if(target(h, mesh) == u)
      set_target(h, v, mesh);
  BOOST_CHECK_EXCEPTION(graph_checks::compute(mesh, values), CGAL::Reeb_graph::Non_manifold_vertex_error,
                        [](const CGAL::Reeb_graph::Non_manifold_vertex_error& error) {
                          return error.vertex() == 17 || error.vertex() == 1000;
                        });
  mesh = make_mesh<Surface_mesh>(soup);
  CGAL::Euler::join_face(halfedge(Surface_mesh::Face_index(777), mesh), mesh);
  BOOST_CHECK_THROW(graph_checks::compute(mesh, values), CGAL::Reeb_graph::Non_triangular_face_error);
}

// Neighbors are near each other in memory, but vertices in a row are not, as where they have been sorted. There, the sweep
// is made on smooth fields.
BOOST_AUTO_TEST_CASE(a_mesh_with_vertices_and_faces_in_two_orders_has_the_graph_of_the_ordered_one)
{
  auto soup = generated_surfaces::closed_surface(3, 36000);
  const auto ordered_mesh = make_mesh<Surface_mesh>(soup);
  Random random(431000);
  std::vector<std::size_t> new_numbers;
  for(std::size_t first = 0; first < soup.points.size(); first = new_numbers.size())
  {
    std::vector<std::size_t> numbers((std::min)(soup.points.size() - first, std::size_t(1500)));
    std::iota(numbers.begin(), numbers.end(), first);
    random.shuffle(numbers);
    new_numbers.insert(new_numbers.end(), numbers.begin(), numbers.end());
  }
  generated_surfaces::renumber(soup, new_numbers);
  const auto mesh = make_mesh<Surface_mesh>(soup);
  const auto values = smooth_field(mesh);
  BOOST_TEST((fastest_way(mesh, values) == Way::BEHIND_SWEEP));
  BOOST_TEST((fastest_way(mesh, noise(mesh, 1)) == Way::STARS_AHEAD));
  BOOST_TEST((values_of_arcs(mesh, values) == values_of_arcs(ordered_mesh, smooth_field(ordered_mesh))));
}

BOOST_AUTO_TEST_CASE(there_are_as_many_cuts_as_loops_but_none_along_the_longest_contour)
{
  std::size_t number_of_cuts_at_multi_saddles = 0;
  for(unsigned genus = 0; genus <= 10; ++genus)
    BOOST_TEST_CONTEXT("genus " << genus)
    {
      const Surface_mesh mesh = make_mesh<Surface_mesh>(generated_surfaces::closed_surface(genus, 1000));
      const auto values = noise(mesh, genus);
      const Graph graph = graph_checks::compute(mesh, values);
      const Surgery surgery = cut_loops(mesh, values);
      BOOST_TEST(surgery.number_of_cuts == num_edges(graph) + 1 - num_vertices(graph));
      BOOST_TEST(!surgery.is_longest_contour_cut);
      number_of_cuts_at_multi_saddles += surgery.number_of_cuts_at_multi_saddles;
    }
  BOOST_TEST(number_of_cuts_at_multi_saddles > 5u);
}

BOOST_AUTO_TEST_CASE(cuts_do_not_depend_on_when_paths_are_walked)
{
  constexpr std::size_t number_of_classes = static_cast<std::size_t>(Mesh_class::NUMBER_OF_CLASSES);
  std::size_t number_of_cuts = 0;
  for(std::size_t seed = 0; seed < 1200; ++seed)
  {
    Random random(500000 + seed);
    const Surface_mesh mesh =
      make_mesh<Surface_mesh>(random_meshes::random_mesh(static_cast<Mesh_class>(seed % number_of_classes), random));
    const auto values = noise(mesh, seed);
    const Surgery early = cut_loops(mesh, values, true), late = cut_loops(mesh, values, false);
    number_of_cuts += early.number_of_cuts;
    BOOST_TEST_CONTEXT("seed " << seed)
    {
      BOOST_TEST(late.number_of_cuts == early.number_of_cuts);
      BOOST_TEST(late.split_tree == early.split_tree, "other split trees");
      BOOST_TEST(late.classes == early.classes, "other classes");
    }
  }
  BOOST_TEST(number_of_cuts > 1000u);
}

// A sphere around whose hub, vertex 0, peaks and vertices below it alternate. A tube joins each second peak to the next
// one, so that a cut crosses an edge at the hub.
namespace {
Combinatorial_mesh hub_with_tubes(std::size_t number_of_tubes)
{
  const std::size_t number_of_peaks = 2 * number_of_tubes;
  Combinatorial_mesh mesh = {2 + 5 * number_of_peaks, {}};
  const auto add_belt = [&](const Vertex_triple& outer, const Vertex_triple& inner) {
    for(std::size_t i = 0; i < 3; ++i)
    {
      const std::size_t next = (i + 1) % 3;
      mesh.triangles.push_back({outer[i], outer[next], inner[i]});
      mesh.triangles.push_back({outer[next], inner[next], inner[i]});
    }
  };
  for(std::size_t i = 0; i < number_of_peaks; ++i)
  {
    const std::size_t peak = 2 + 5 * i, low = peak + 1, next_peak = 2 + 5 * ((i + 1) % number_of_peaks);
    mesh.triangles.push_back({0, peak, low});
    mesh.triangles.push_back({0, low, next_peak});
    mesh.triangles.push_back({1, next_peak, low});
    add_belt({1, low, peak}, {peak + 2, peak + 3, peak + 4});
    if(i % 2 == 0)
      add_belt({peak + 2, peak + 3, peak + 4}, {next_peak + 2, next_peak + 4, next_peak + 3});
  }
  return mesh;
}

std::vector<double> field_of_hub(std::size_t number_of_vertices, Random& random)
{
  std::vector<double> values = {0, -2};
  while(values.size() < number_of_vertices)
  {
    values.insert(values.end(), {2000, -1});
    for(int i = 0; i < 3; ++i)
      values.push_back(static_cast<double>(1 + random.below(1000)));
  }
  return values;
}
} // namespace

BOOST_AUTO_TEST_CASE(the_corrections_of_cuts_around_a_hub_grow_linearly)
{
  std::vector<std::size_t> steps;
  for(const std::size_t number_of_tubes : {10, 250, 1000})
  {
    Random random(number_of_tubes);
    const Surface_mesh mesh = make_mesh<Surface_mesh>(hub_with_tubes(number_of_tubes));
    const auto values = field_of_hub(mesh.number_of_vertices(), random);
    const Surgery surgery = cut_loops(mesh, values);
    BOOST_TEST(surgery.number_of_cuts == number_of_tubes);
    steps.push_back(surgery.number_of_correction_steps);
    if(number_of_tubes == 10)
      compare_methods(mesh, values);
  }
  BOOST_TEST_MESSAGE(steps[0] << ", " << steps[1] << " and " << steps[2] << " steps");
  BOOST_TEST(steps[0] > 0u);
  BOOST_TEST(steps[2] < 6 * steps[1]); // 16 times as many if each cut looked at all sectors of the hub
}

BOOST_AUTO_TEST_CASE(the_traced_edges_of_noise_grow_linearly)
{
  // Without the rules that exclude loops, it is at least half as much again.
  const auto compare_sizes = [](const Surface_mesh& small, const Surface_mesh& large, double bound) {
    const double before = traced_edges_per_vertex(small), after = traced_edges_per_vertex(large);
    BOOST_TEST_MESSAGE(before << " and " << after << " traced edges per vertex");
    BOOST_TEST(before < bound);
    BOOST_TEST(after < bound);
    BOOST_TEST(after < 2 * before + 0.5);
  };
  BOOST_TEST_CONTEXT("terrain")
  compare_sizes(make_mesh<Surface_mesh>(generated_surfaces::terrain(50, 50)),
                make_mesh<Surface_mesh>(generated_surfaces::terrain(200, 200)), 0.12);
  BOOST_TEST_CONTEXT("genus 3")
  compare_sizes(make_mesh<Surface_mesh>(generated_surfaces::closed_surface(3, 2500)),
                make_mesh<Surface_mesh>(generated_surfaces::closed_surface(3, 40000)), 0.65);
}

BOOST_AUTO_TEST_SUITE_END()
