// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#include <boost/test/unit_test.hpp>

#include "graph_checks.h"
#include "random_meshes.h"

#include <CGAL/Exact_rational.h>
#include <CGAL/Reeb_graph/Augmentation.h>
#include <CGAL/Reeb_graph/Flat_field.h>

#include <boost/mpl/list.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

// The stages know doubles only: values of any type and in any order give what these doubles do.

BOOST_AUTO_TEST_SUITE(test_keys)

namespace internal = CGAL::Reeb_graph::internal;
namespace parameters = CGAL::parameters;
using CGAL::Reeb_graph::Augmentation;
using CGAL::Reeb_graph::Ties;
using mesh_builders::make_mesh;
using mesh_builders::Surface_mesh;
using random_meshes::Random;

namespace {
template <class Scalar, class Less>
struct Traits : CGAL::Reeb_graph_traits<Surface_mesh, graph_checks::Scalar_map_of<Surface_mesh, Scalar>>
{
  typedef Less Less_scalar;
  Less_scalar less_scalar_object() const { return Less(); }
};

// The first parts only, so that values which differ are tied.
typedef std::pair<int, std::string> Pair;
struct Less_first
{
  bool operator()(const Pair& a, const Pair& b) const { return a.first < b.first; }
};

template <class Scalar>
Scalar make_scalar(int number, std::size_t)
{
  return static_cast<Scalar>(number);
}
template <>
Pair make_scalar<Pair>(int number, std::size_t vertex)
{
  return {number, std::to_string(vertex)};
}

// A type, its order, and the sign that makes it that of numbers; the step between the values that doubles have as 1.
template <class Scalar_, class Less_ = std::less<Scalar_>, int sign_ = 1, std::int64_t shift_ = 0>
struct Field
{
  typedef Scalar_ Scalar;
  typedef Less_ Less;
  static constexpr int sign = sign_;
  static constexpr std::int64_t shift = shift_;
};
constexpr std::int64_t beyond_doubles = std::int64_t(1) << 60;

typedef boost::mpl::list<Field<float>,
                         Field<signed char>,
                         Field<int, std::greater<int>, -1>,
                         Field<double, std::greater<>, -1>,
                         Field<std::int64_t, std::less<std::int64_t>, 1, beyond_doubles>,
                         Field<std::int64_t, std::greater<std::int64_t>, -1, -beyond_doubles>,
                         Field<std::uint64_t, std::less<>, 1, beyond_doubles>,
                         Field<CGAL::Exact_rational>,
                         Field<Pair, Less_first>>
  Fields;

// What is asked of a field: the graph, the places of the vertices, and at each value and beside it, the lengths of the
// contours.
struct Findings
{
  graph_checks::Plain_graph graph;
  std::vector<std::size_t> places;
  std::vector<std::vector<std::size_t>> lengths;
};

template <class Scalar, class Less>
Findings find(const Surface_mesh& mesh,
              const std::vector<Scalar>& values,
              const std::vector<Scalar>& levels,
              const Traits<Scalar, Less>& traits,
              Ties ties)
{
  const auto np = parameters::ties(ties).geom_traits(traits);
  const auto scalar_map = CGAL::Reeb_graph::make_scalar_map(mesh, values);
  graph_checks::Graph_of<Surface_mesh, Scalar> graph;
  CGAL::compute_reeb_graph(mesh, scalar_map, graph, np);
  Findings findings = {graph_checks::plain(graph_checks::Mesh_numbers<Surface_mesh>(mesh), graph), {}, {}};
  for(std::size_t node = 0; node != num_vertices(graph); ++node)
    BOOST_TEST((graph[node].value == values[findings.graph.nodes[node].first]));
  const Augmentation<Surface_mesh, decltype(scalar_map), decltype(graph), Traits<Scalar, Less>> augmentation(
    mesh, scalar_map, graph, np);
  const auto places = augmentation.locate_vertices();
  for(const auto v : vertices(mesh))
    findings.places.push_back(places.index(v));
  for(const Scalar& level : levels)
  {
    findings.lengths.emplace_back();
    for(const auto& contour : augmentation.contours_at_value(level))
      findings.lengths.back().push_back(contour.edges.size());
  }
  return findings;
}
} // namespace

BOOST_AUTO_TEST_CASE_TEMPLATE(fields_of_all_types_give_what_doubles_do, F, Fields)
{
  typedef typename F::Scalar Scalar;
  for(std::size_t seed = 0; seed != 60; ++seed)
    BOOST_TEST_CONTEXT("seed " << seed)
    {
      Random random(seed);
      const auto combinatorial_mesh = random_meshes::random_closed_surface(seed % 3, 4 + random.below(30), random);
      const Surface_mesh mesh = make_mesh<Surface_mesh>(combinatorial_mesh);
      std::vector<double> numbers;
      std::vector<Scalar> values;
      // Even ones, so that odd ones lie between them.
      for(std::size_t v = 0; v != mesh.number_of_vertices(); ++v)
      {
        const int number = 2 * static_cast<int>(random.below(seed % 2 == 0 ? 6 : 40)) - 10;
        numbers.push_back(number);
        values.push_back(make_scalar<Scalar>(F::sign * number, v));
      }
      std::vector<double> levels;
      std::vector<Scalar> scalar_levels;
      for(int number = -12; number < 12; ++number)
      {
        levels.push_back(number);
        scalar_levels.push_back(make_scalar<Scalar>(F::sign * number, 0));
      }
      if constexpr(F::shift != 0)
        for(std::vector<Scalar>* shifted : {&values, &scalar_levels})
          for(Scalar& value : *shifted)
            value += static_cast<Scalar>(F::shift);
      for(const Ties ties : {Ties::PERTURB, Ties::CONTRACT})
      {
        const Findings expected = find(mesh, numbers, levels, Traits<double, std::less<double>>(), ties);
        const Findings findings = find(mesh, values, scalar_levels, Traits<Scalar, typename F::Less>(), ties);
        BOOST_TEST((findings.graph == expected.graph));
        BOOST_TEST(findings.places == expected.places);
        BOOST_TEST((findings.lengths == expected.lengths));
      }
    }
}

namespace {
// The keys of values by vertex.
template <class Scalar, class Less = std::less<Scalar>>
std::vector<double> keys_of(const std::vector<Scalar>& values)
{
  Surface_mesh mesh;
  for(std::size_t v = 0; v != values.size(); ++v)
    mesh.add_vertex(Surface_mesh::Point(0, 0, 0));
  const auto field = internal::read_field(internal::Threads(), internal::Vertex_list<Surface_mesh>(mesh),
                                          CGAL::Reeb_graph::make_scalar_map(mesh, values), Traits<Scalar, Less>());
  for(const internal::Vertex_index v : field.keys().keys())
  {
    BOOST_TEST((field.value(v) == values[v.number()]));
    BOOST_TEST(field.key_of(values[v.number()], Less()) == field.keys()[v]);
  }
  return {field.keys().begin(), field.keys().end()};
}
} // namespace

BOOST_AUTO_TEST_CASE(keys_are_values_or_ranks)
{
  typedef std::numeric_limits<double> Doubles;
  typedef std::vector<double> Keys;
  const double infinity = Doubles::infinity();
  BOOST_TEST((keys_of<double>({0., -0., infinity, Doubles::denorm_min()}) == Keys{0, 0, infinity, 5e-324}));
  BOOST_TEST(
    (keys_of<double, std::greater<double>>({-infinity, 7., 0., infinity}) == Keys{infinity, -7, 0, -infinity}));
  BOOST_TEST((keys_of<float>({0.1f, -3.f}) == Keys{double(0.1f), -3}));
  BOOST_TEST((keys_of<int>({std::numeric_limits<int>::min(), 5}) == Keys{-2147483648., 5}));
  BOOST_TEST((keys_of<unsigned, std::greater<>>({0, 4294967295}) == Keys{0, -4294967295.}));
  const std::int64_t large = std::int64_t(1) << 53, least = std::numeric_limits<std::int64_t>::min();
  BOOST_TEST((keys_of<std::int64_t>({large + 1, large, least, large + 1, -5}) == Keys{3, 2, 0, 3, 1}));
  const std::uint64_t most = std::numeric_limits<std::uint64_t>::max();
  BOOST_TEST((keys_of<std::uint64_t>({most, most - 1, 0, most}) == Keys{2, 1, 0, 2}));
  BOOST_TEST((keys_of<long double>({1 + 1e-18L, 1, 1 + 1e-18L}) == Keys{1, 0, 1}));
  BOOST_TEST((keys_of<Pair, Less_first>({{2, "a"}, {1, "b"}, {2, "c"}}) == Keys{1, 0, 1}));
}

BOOST_AUTO_TEST_CASE(removed_vertices_have_no_rank)
{
  Surface_mesh mesh;
  mesh_builders::build_with_garbage(mesh, mesh_builders::make_soup(random_meshes::seven_vertex_torus()));
  const auto map = mesh.add_property_map<Surface_mesh::Vertex_index, std::int64_t>("v:value", -1).first;
  std::int64_t number = 100;
  for(const auto v : vertices(mesh))
    map[v] = number++;
  const CGAL::Reeb_graph_traits<Surface_mesh, decltype(map)> traits;
  const auto field = internal::read_field(internal::Threads(), internal::Vertex_list<Surface_mesh>(mesh), map, traits);
  double rank = 0;
  for(const auto v : vertices(mesh))
    BOOST_TEST(field.keys()[internal::Vertex_index(v)] == rank++);
}

BOOST_AUTO_TEST_CASE(a_flat_field_in_another_order_is_refused)
{
  const Surface_mesh mesh = make_mesh<Surface_mesh>(random_meshes::seven_vertex_torus());
  const auto scalar_map = CGAL::Reeb_graph::make_scalar_map(mesh, std::vector<double>{3, 1, 2, 6, 4, 5, 0});
  const CGAL::Reeb_graph::Flat_field flat_field(mesh, scalar_map);
  graph_checks::Graph_of<Surface_mesh> graph;
  const auto np = parameters::geom_traits(Traits<double, std::greater<double>>());
  BOOST_CHECK_THROW(CGAL::compute_reeb_graph(mesh, flat_field, graph, np), CGAL::Reeb_graph::Graph_mismatch_error);
}

BOOST_AUTO_TEST_SUITE_END()
