// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#include <boost/test/unit_test.hpp>

#include "computed_fields.h"
#include "mesh_builders.h"
#include "random_meshes.h"

#include <CGAL/Reeb_graph/fields/harmonic_field.h>
#include <CGAL/compute_reeb_graph.h>

#include <CGAL/Polygon_mesh_processing/border.h>

#include <boost/mpl/list.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <iterator>
#include <numeric>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

// Harmonic fields: no extremum but at fixed vertices, whatever the mesh, its type, its numbering and its scale.

BOOST_AUTO_TEST_SUITE(test_harmonic_field)

using namespace computed_fields;
using CGAL::Reeb_graph::compute_harmonic_field;
using CGAL::Reeb_graph::compute_harmonic_field_between;
using CGAL::Reeb_graph::compute_harmonic_field_between_far_apart_vertices;
using CGAL::Reeb_graph::Critical_vertex_counts;
using mesh_builders::Polyhedron;
using random_meshes::Mesh_class;

typedef boost::mpl::list<Surface_mesh, Polyhedron> Meshes;
typedef boost::mpl::list<double, float> Scalars;

namespace {
struct Counting_visitor : CGAL::Reeb_graph::Default_visitor
{
  Critical_vertex_counts counts;
  void critical_vertices(const Critical_vertex_counts& c) { counts = c; }
};

// One minimum, one maximum, saddles of total multiplicity 2 g; and the loops that this leaves.
template <class Scalar>
void check_two_poles(const Triangle_soup& soup,
                     const Fixed_values& poles,
                     std::size_t genus,
                     const std::vector<Scalar>& values)
{
  BOOST_TEST(fault_of_extrema(soup, poles, values) == "");
  BOOST_TEST(total_multiplicity(soup, values) == 2 * genus);
  Surface_mesh mesh;
  mesh_builders::build(mesh, soup);
  const auto scalar_map = CGAL::Reeb_graph::make_scalar_map(mesh, values);
  typename CGAL::Reeb_graph_traits<Surface_mesh, std::decay_t<decltype(scalar_map)>>::Graph graph;
  Counting_visitor visitor;
  const auto np = CGAL::parameters::keep_degree_two_nodes(true);
  CGAL::compute_reeb_graph(mesh, scalar_map, graph, np.visitor(std::ref(visitor)));
  BOOST_TEST(visitor.counts.minima == 1u);
  BOOST_TEST(visitor.counts.maxima == 1u);
  std::size_t number_of_leaves = 0, number_of_saddles = 0, total_multiplicity = 0;
  for(const auto& [multiplicity, number] : visitor.counts.saddles)
  {
    number_of_saddles += number;
    total_multiplicity += multiplicity * number;
  }
  for(const auto node : CGAL::make_range(vertices(graph)))
    number_of_leaves += in_degree(node, graph) + out_degree(node, graph) == 1 ? 1 : 0;
  BOOST_TEST(number_of_leaves == 2u);
  BOOST_TEST(num_vertices(graph) == 2 + number_of_saddles);
  BOOST_TEST(total_multiplicity == 2 * genus);
  const std::size_t number_of_loops = num_edges(graph) + 1 - num_vertices(graph);
  if(number_of_saddles == total_multiplicity)
    BOOST_TEST(number_of_loops == genus);
  else
    BOOST_TEST(number_of_loops <= genus);
}

struct Closed_surface
{
  std::string name;
  std::size_t genus;
  Triangle_soup soup;
};

std::vector<Closed_surface> closed_surfaces()
{
  Random random(1);
  std::vector<Closed_surface> surfaces = {
    {"tetrahedron", 0, with_random_points(random_meshes::tetrahedron(), random)},
    {"octahedron", 0, with_random_points(random_meshes::bipyramid(4), random)},
    {"hub", 0, with_random_points(random_meshes::bipyramid(500), random)},
    {"torus of 7 vertices", 1, with_random_points(random_meshes::seven_vertex_torus(), random)},
    {"tube", 0, tube(5, 1000)},
    {"wide tube", 0, tube(40, 200)},
    {"needles", 0, stretched(tube(10, 200), 1, 1e-9, 1e3)}};
  for(unsigned genus : {0u, 1u, 2u, 3u, 8u, 25u})
  {
    const std::string name = "genus " + std::to_string(genus);
    const Triangle_soup soup = generated_surfaces::closed_surface(genus, 1500);
    surfaces.push_back({name, genus, soup});
    surfaces.push_back({name + ", noisy", genus, with_noise(soup, 0.3, random)});
    surfaces.push_back({name + ", flat", genus, stretched(soup, 1, 1e-6, 1)});
    surfaces.push_back({name + ", in a plane", genus, stretched(soup, 1, 1, 1e-200)});
    surfaces.push_back({name + ", large", genus, stretched(soup, 1e200, 1e200, 1e200)});
    surfaces.push_back({name + ", small", genus, stretched(soup, 1e-200, 1e-200, 1e-200)});
  }
  return surfaces;
}

// Some vertices with some values, at least one in each component.
Fixed_values random_constraints(const Triangle_soup& soup, Random& random)
{
  const std::size_t stride = 1 + random.below(10), number_of_values = 1 + random.below(4);
  const auto value = [&] { return static_cast<double>(random.below(number_of_values)); };
  Fixed_values fixed;
  for(const auto& pair : far_apart_vertices(soup))
    fixed[pair.first] = value();
  for(std::size_t v = 0; v < soup.points.size(); ++v)
    if(random.below(stride) == 0)
      fixed[v] = value();
  return fixed;
}

template <class Test>
void for_each_closed_surface(const Test& test)
{
  for(const Closed_surface& surface : closed_surfaces())
    for(const Laplacian_weights weights : all_weights)
      BOOST_TEST_CONTEXT(surface.name << ", weights " << static_cast<int>(weights))
  test(surface, weights);
}
} // namespace

BOOST_AUTO_TEST_CASE_TEMPLATE(two_poles_give_two_extrema_and_no_spurious_saddle, Scalar, Scalars)
{
  for_each_closed_surface([](const Closed_surface& surface, Laplacian_weights weights) {
    const std::size_t n = surface.soup.points.size();
    Random random(n);
    const std::size_t neighbor = surface.soup.triangles[0][1];
    const std::size_t first = surface.soup.triangles[0][0], far = (first + n / 2) % n;
    for(const Fixed_values& poles :
        {Fixed_values{{first, 0}, {far == first ? neighbor : far, 1}}, Fixed_values{{first, 3}, {neighbor, -7}}})
      check_two_poles(surface.soup, poles, surface.genus, harmonic<Scalar>(surface.soup, poles, weights));
  });
}

BOOST_AUTO_TEST_CASE(poles_are_found)
{
  for_each_closed_surface([](const Closed_surface& surface, Laplacian_weights weights) {
    Surface_mesh mesh;
    mesh_builders::build(mesh, surface.soup);
    const auto pairs = far_apart_vertices(surface.soup);
    BOOST_TEST_REQUIRE(pairs.size() == 1u);
    auto field_map = mesh.add_property_map<Surface_mesh::Vertex_index, double>("v:field").first;
    compute_harmonic_field_between_far_apart_vertices(mesh, field_map, laplacian_weights(weights));
    const Fixed_values poles = {{pairs[0].first, 0}, {pairs[0].second, 1}};
    const auto values = values_of(mesh, field_map);
    check_two_poles(surface.soup, poles, surface.genus, values);
    const Surface_mesh::Vertex_index lowest(pairs[0].first), highest(pairs[0].second);
    compute_harmonic_field_between(mesh, field_map, lowest, highest, laplacian_weights(weights));
    BOOST_TEST((values_of(mesh, field_map) == values));
  });
}

BOOST_AUTO_TEST_CASE(far_apart_vertices_are_the_ends_of_a_tube)
{
  const Triangle_soup soup = tube(6, 50);
  const auto pairs = far_apart_vertices(soup);
  BOOST_TEST(soup.points[pairs[0].first][2] > 48);
  BOOST_TEST(soup.points[pairs[0].second][2] < 1);
}

// all classes of random meshes, borders and several components included, with any number of fixed vertices
BOOST_AUTO_TEST_CASE_TEMPLATE(only_fixed_vertices_are_extrema, Scalar, Scalars)
{
  for(std::size_t seed = 0; seed < 1500; ++seed)
    BOOST_TEST_CONTEXT("seed " << seed)
    {
      Random random(seed);
      const auto mesh_class = static_cast<Mesh_class>(seed % static_cast<int>(Mesh_class::NUMBER_OF_CLASSES));
      const Triangle_soup soup = with_random_points(random_meshes::random_mesh(mesh_class, random), random);
      const Fixed_values fixed = random_constraints(soup, random);
      const auto values = harmonic<Scalar>(soup, fixed, all_weights[seed / 6 % 3]);
      BOOST_TEST(fault_of_extrema(soup, fixed, values) == "");
    }
}

// fields that are no solution of anything: what removes extrema has to do all of the work
BOOST_AUTO_TEST_CASE_TEMPLATE(extrema_are_removed_from_any_field, Scalar, Scalars)
{
  namespace fields = CGAL::Reeb_graph::internal::scalar_fields;
  for(std::size_t seed = 0; seed < 3000; ++seed)
    BOOST_TEST_CONTEXT("seed " << seed)
    {
      Random random(seed);
      const auto mesh_class = static_cast<Mesh_class>(seed % static_cast<int>(Mesh_class::NUMBER_OF_CLASSES));
      const Triangle_soup soup = with_random_points(random_meshes::random_mesh(mesh_class, random), random);
      Surface_mesh mesh;
      mesh_builders::build(mesh, soup);
      if(mesh_class == Mesh_class::CLOSED && seed % 8 == 0)
        mesh_builders::flip_edges_carelessly(mesh, 20, random);
      Triangle_soup flipped = {soup.points, {}};
      for(const auto f : mesh.faces())
      {
        const auto h = mesh.halfedge(f);
        flipped.triangles.push_back({mesh.source(h), mesh.target(h), mesh.target(mesh.next(h))});
      }
      const fields::Indexed_mesh<Surface_mesh> surface(mesh, CGAL::parameters::default_values());
      const auto graph = fields::laplacian_graph(surface, Laplacian_weights::UNIFORM);
      const Fixed_values fixed = random_constraints(soup, random);
      const std::size_t number_of_values = 1 + random.below(20);
      std::vector<bool> is_fixed(soup.points.size(), false);
      std::vector<Scalar> values;
      for(std::size_t v = 0; v < soup.points.size(); ++v)
      {
        is_fixed[v] = fixed.count(v) > 0;
        values.push_back(static_cast<Scalar>(is_fixed[v] ? fixed.at(v) : random.below(number_of_values)));
      }
      fields::remove_extrema(graph, is_fixed, values);
      BOOST_TEST(fault_of_extrema(flipped, fixed, values) == "");
      const std::vector<Scalar> once = values;
      fields::remove_extrema(graph, is_fixed, values);
      BOOST_TEST((values == once));
    }
}

BOOST_AUTO_TEST_CASE(values_are_moved_no_more_than_it_takes)
{
  namespace fields = CGAL::Reeb_graph::internal::scalar_fields;
  // a disk around a vertex, whose value has to come down from 5 to those of its neighbors, between 0 and 4
  Surface_mesh mesh;
  mesh_builders::build(mesh, mesh_builders::make_soup(random_meshes::disk(5)));
  const fields::Indexed_mesh<Surface_mesh> surface(mesh, CGAL::parameters::default_values());
  const auto graph = fields::laplacian_graph(surface, Laplacian_weights::UNIFORM);
  std::vector<double> values = {5, 0, 1, 2, 3, 4};
  fields::remove_extrema(graph, {false, true, true, true, true, true}, values);
  BOOST_TEST(values[0] == std::nextafter(4., 0.));
}

BOOST_AUTO_TEST_CASE_TEMPLATE(all_mesh_types_give_the_same_field, Mesh, Meshes)
{
  const Triangle_soup soup = generated_surfaces::closed_surface(2, 1000);
  const Fixed_values poles = {{0, 0}, {500, 1}};
  Surface_mesh garbage;
  mesh_builders::build_with_garbage(garbage, soup);
  auto field_map = garbage.add_property_map<Surface_mesh::Vertex_index, double>("v:field", 7).first;
  compute_harmonic_field(garbage, field_map, constraints_of(garbage, poles));
  BOOST_TEST((harmonic<double, Mesh>(soup, poles) == values_of(garbage, field_map)));
}

BOOST_AUTO_TEST_CASE(a_border_can_be_a_level_set)
{
  Surface_mesh mesh;
  mesh_builders::build(mesh, band(12, 20, 0.5, sphere_point));
  std::vector<Surface_mesh::Halfedge_index> cycles;
  CGAL::Polygon_mesh_processing::extract_boundary_cycles(mesh, std::back_inserter(cycles));
  BOOST_TEST_REQUIRE(cycles.size() == 2u);
  std::vector<std::pair<Surface_mesh::Vertex_index, double>> constraints;
  CGAL::Reeb_graph::fix_border_cycle(cycles[0], mesh, -1, std::back_inserter(constraints));
  CGAL::Reeb_graph::fix_border_cycle(cycles[1], mesh, 2, std::back_inserter(constraints));
  BOOST_TEST(constraints.size() == 24u);
  BOOST_CHECK_THROW(
    CGAL::Reeb_graph::fix_border_cycle(opposite(cycles[0], mesh), mesh, -1, std::back_inserter(constraints)),
    CGAL::Reeb_graph::Not_on_border_error);
  BOOST_TEST(constraints.size() == 24u);
  auto field_map = mesh.add_property_map<Surface_mesh::Vertex_index, double>("v:field").first;
  compute_harmonic_field(mesh, field_map, constraints);
  for(const auto v : mesh.vertices())
  {
    const auto same_vertex = [&](const auto& constraint) { return constraint.first == v; };
    const auto constraint = std::find_if(constraints.begin(), constraints.end(), same_vertex);
    BOOST_TEST((constraint != constraints.end()) == mesh.is_border(v));
    if(mesh.is_border(v))
      BOOST_TEST(field_map[v] == constraint->second);
    else
      BOOST_TEST((field_map[v] > -1 && field_map[v] < 2));
  }
  typedef CGAL::Reeb_graph_traits<Surface_mesh, decltype(field_map)>::Graph Graph;
  Graph graph;
  const auto np = CGAL::parameters::ties(CGAL::Reeb_graph::Ties::CONTRACT);
  CGAL::compute_reeb_graph(mesh, field_map, graph, np);
  BOOST_TEST(num_vertices(graph) == 2u);
  BOOST_TEST(num_edges(graph) == 1u);

  // with nothing but one value given, the field is constant
  for(auto& constraint : constraints)
    constraint.second = 0.1;
  compute_harmonic_field(mesh, field_map, constraints);
  for(const auto v : mesh.vertices())
    BOOST_TEST(field_map[v] == 0.1);
}

BOOST_AUTO_TEST_CASE(mirror_images_have_mirrored_fields)
{
  Random random(3);
  const Triangle_soup soup = with_noise(generated_surfaces::closed_surface(2, 1000), 0.02, random);
  Triangle_soup mirrored = stretched(soup, 1, 1, -1);
  for(auto& t : mirrored.triangles)
    std::swap(t[0], t[1]);
  const Fixed_values poles = {{10, 0}, {700, 1}}, reversed = {{10, 1}, {700, 0}};
  for(const Laplacian_weights weights : all_weights)
  {
    const auto values = harmonic<double>(soup, poles, weights);
    BOOST_TEST(distance(values, harmonic<double>(mirrored, poles, weights)) < 1e-10);
    auto negative = harmonic<double>(soup, reversed, weights);
    for(double& value : negative)
      value = 1 - value;
    BOOST_TEST(distance(values, negative) < 1e-10);
  }
}

BOOST_AUTO_TEST_CASE(the_numbering_of_faces_and_vertices_plays_no_role)
{
  Random random(4);
  const Triangle_soup soup = with_noise(generated_surfaces::closed_surface(2, 1000), 0.02, random);
  Triangle_soup shuffled = soup;
  random.shuffle(shuffled.triangles);
  for(auto& t : shuffled.triangles)
    std::rotate(t.begin(), t.begin() + random.below(3), t.end());
  std::vector<std::size_t> names(soup.points.size());
  std::iota(names.begin(), names.end(), 0);
  random.shuffle(names);
  Triangle_soup renamed = shuffled;
  for(std::size_t v = 0; v < names.size(); ++v)
    renamed.points[names[v]] = soup.points[v];
  for(auto& t : renamed.triangles)
    for(std::size_t& v : t)
      v = names[v];
  for(const Laplacian_weights weights : all_weights)
  {
    const auto values = harmonic<double>(soup, {{10, 0}, {700, 1}}, weights);
    BOOST_TEST(distance(values, harmonic<double>(shuffled, {{10, 0}, {700, 1}}, weights)) < 1e-10);
    const auto renamed_values = harmonic<double>(renamed, {{names[10], 0}, {names[700], 1}}, weights);
    for(std::size_t v = 0; v < names.size(); ++v)
      BOOST_TEST(std::abs(renamed_values[names[v]] - values[v]) < 1e-10);
  }
}

BOOST_AUTO_TEST_CASE(scale_plays_no_role)
{
  const Triangle_soup soup = generated_surfaces::closed_surface(1, 500);
  const Fixed_values poles = {{0, 0}, {300, 1}};
  const auto values = harmonic<double>(soup, poles);
  for(const double factor : {1e-150, 1e150, 1e-300, 1e300})
    BOOST_TEST(distance(values, harmonic<double>(stretched(soup, factor, factor, factor), poles)) < 1e-10);
  const auto scaled = harmonic<double>(soup, {{0, -3e100}, {300, 5e100}});
  for(std::size_t v = 0; v < values.size(); ++v)
    BOOST_TEST(std::abs((scaled[v] + 3e100) / 8e100 - values[v]) < 1e-10);
}

BOOST_AUTO_TEST_SUITE_END()
