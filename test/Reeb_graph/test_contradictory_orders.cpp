// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

// Scalar types that hide NaN, and orders that are none. The contradiction is found, or there is some graph: nothing
// goes on without end, nor out of bounds, which the sanitizers see.

#include <boost/test/unit_test.hpp>

#include "computed_graphs.h"

#include <CGAL/Reeb_graph/Augmentation.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

BOOST_AUTO_TEST_SUITE(test_contradictory_orders)

using namespace computed_graphs;
using namespace CGAL::Reeb_graph;
using CGAL::Parallel_if_available_tag;
using mesh_builders::Surface_mesh;
using random_meshes::Mesh_class;

namespace {
constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();

enum class Kind
{
  LESS, // of NaN, too
  LESS_OR_EQUAL,
  ALWAYS,
  AROUND_A_CIRCLE,
  HAPHAZARD,
  MOSTLY_LESS,
  NUMBER_OF_KINDS
};

inline bool is_one_of(std::size_t number, double a, double b)
{
  const std::hash<double> hash;
  return ((1009 * std::uint64_t(hash(a)) + hash(b)) * 0x9e3779b97f4a7c15u >> 40) % number == 0;
}

// What looks like an order of the values.
struct Disorder
{
  Kind kind;
  bool operator()(double a, double b) const
  {
    switch(kind)
    {
    case Kind::LESS: return a < b;
    case Kind::LESS_OR_EQUAL: return a <= b;
    case Kind::ALWAYS: return true;
    case Kind::AROUND_A_CIRCLE: return a != b && std::fmod(b - a + 3000, 30) < 15;
    case Kind::HAPHAZARD: return is_one_of(2, a, b);
    default: return is_one_of(50, a, b) != (a < b);
    }
  }
};

template <class Mesh, class Less>
struct Traits : CGAL::Reeb_graph_traits<Mesh, graph_checks::Scalar_map_of<Mesh>>
{
  typedef Less Less_scalar;
  Less_scalar less_scalar_object() const { return less; }

  struct Is_ordered
  {
    bool operator()(double) const { return true; }
  };
  Is_ordered is_ordered_object() const { return Is_ordered(); }

  Less less;
};

struct Tally
{
  std::size_t graphs = 0;
  std::size_t refused = 0;
};

// Asks all that an Augmentation can tell. What is wrong may show now only.
template <class A, class Graph>
void use(const A& augmentation, const Graph& graph)
{
  try
  {
    augmentation.locate_vertices();
  }
  catch(const Error&)
  {}
  const std::size_t step = num_vertices(graph) / 50 + 1;
  for(std::size_t node = 0; node < num_vertices(graph); node += step)
  {
    try
    {
      augmentation.critical_set(node);
      augmentation.contours_at_value(graph[node].value);
    }
    catch(const Error&)
    {}
  }
}

template <class Tag, class Less, class Mesh>
void try_order(const Mesh& mesh,
               const std::vector<double>& values,
               const Less& less,
               const Settings& settings,
               Tally& tally)
{
  const auto scalar_map = make_scalar_map(mesh, values);
  Traits<Mesh, Less> traits;
  traits.less = less;
  const auto np = named_parameters(settings).geom_traits(traits);
  graph_checks::Graph_of<Mesh> graph;
  try
  {
    CGAL::compute_reeb_graph<Tag>(mesh, scalar_map, graph, np);
    ++tally.graphs;
    for(const auto arc : CGAL::make_range(edges(graph)))
      BOOST_TEST(source(arc, graph) < target(arc, graph));
    BOOST_TEST(num_vertices(graph) <= values.size());
  }
  catch(const Unordered_scalar_error& error)
  {
    BOOST_TEST(error.vertex() < values.size());
    ++tally.refused;
  }
  try
  {
    const Augmentation augmentation(mesh, scalar_map, graph, np);
    use(augmentation, graph);
  }
  catch(const Error&)
  {}
}

std::vector<double> values_of_seed(std::size_t size, random_meshes::Random& random)
{
  std::vector<double> values = random_meshes::random_integers(size, 1 + random.below(2 * size + 1), random);
  for(double& value : values)
    value = random.below(6) == 0 ? not_a_number : value;
  return values;
}

// A number of the user that can be NaN but does not say so.
struct Number
{
  double value = 0;
  friend bool operator<(const Number& a, const Number& b) { return a.value < b.value; }
};

template <class Scalar>
void check_is_refused(const std::function<Scalar(double)>& make_scalar)
{
  const auto mesh = make_mesh<Surface_mesh>(random_meshes::seven_vertex_torus());
  std::vector<Scalar> values;
  for(std::size_t v = 0; v != 7; ++v)
    values.push_back(make_scalar(static_cast<double>(v)));
  BOOST_CHECK_NO_THROW(graph_checks::compute(mesh, values));
  values[4] = make_scalar(not_a_number);
  for(const Method method : {Method::CONTOUR_TREES, Method::CRITICAL_SETS})
    BOOST_CHECK_EXCEPTION(graph_checks::compute(mesh, values, false, method), Unordered_scalar_error,
                          [](const Unordered_scalar_error& error) { return error.vertex() == 4; });
}
} // namespace

BOOST_AUTO_TEST_CASE(nan_is_found_inside_of_pairs_tuples_and_arrays)
{
  typedef std::array<double, 2> Array;
  typedef std::tuple<int, float, long> Tuple;
  typedef std::pair<int, std::array<std::tuple<double>, 3>> Nested;
  check_is_refused<std::pair<double, int>>([](double x) { return std::make_pair(x, 1); });
  check_is_refused<std::pair<int, double>>([](double x) { return std::make_pair(1, x); });
  check_is_refused<Array>([](double x) { return Array{1., x}; });
  check_is_refused<Tuple>([](double x) { return Tuple(1, static_cast<float>(x), 1l); });
  check_is_refused<Nested>([](double x) {
    return Nested{1, {std::make_tuple(1.), std::make_tuple(x), std::make_tuple(x)}};
  });
  check_is_refused<std::pair<float, std::string>>([](double x) { return std::make_pair(static_cast<float>(x), "a"); });
}

BOOST_AUTO_TEST_CASE(nan_that_the_traits_accept_is_found_if_they_have_the_usual_order)
{
  Tally tally;
  const auto mesh = make_mesh<Surface_mesh>(random_meshes::seven_vertex_torus());
  try_order<CGAL::Sequential_tag>(mesh, {0, 1, 2, not_a_number, 4, 5, 6}, std::less<double>(), Settings(), tally);
  BOOST_TEST(tally.refused == 1u);
}

BOOST_AUTO_TEST_CASE(orders_that_are_none_end)
{
  for(int kind = 0; kind != static_cast<int>(Kind::NUMBER_OF_KINDS); ++kind)
  {
    Tally tally;
    for(std::size_t seed = 0; seed < 1200; ++seed)
    {
      BOOST_TEST_CONTEXT("kind " << kind << ", seed " << seed)
      {
        Random random(seed);
        const auto mesh_class =
          static_cast<Mesh_class>(random.below(static_cast<std::size_t>(Mesh_class::NUMBER_OF_CLASSES)));
        const auto mesh = random_meshes::random_mesh(mesh_class, random);
        const auto values = values_of_seed(mesh.number_of_vertices, random);
        Settings settings = settings_of_seed(seed);
        settings.method = seed / 4 % 2 == 0 ? Method::CONTOUR_TREES : Method::CRITICAL_SETS;
        settings.number_of_slabs = seed / 8 % 3 == 0 ? 4 : 1;
        const Disorder disorder = {static_cast<Kind>(kind)};
        try_order<CGAL::Sequential_tag>(make_mesh<Surface_mesh>(mesh), values, disorder, settings, tally);
      }
    }
    BOOST_TEST_MESSAGE("kind " << kind << ": " << tally.graphs << " graphs, " << tally.refused << " refused");
    BOOST_TEST(tally.refused > 0u);
  }
}

BOOST_AUTO_TEST_CASE(orders_that_are_none_end_on_several_threads)
{
  for(int kind = 0; kind != static_cast<int>(Kind::NUMBER_OF_KINDS); ++kind)
  {
    Tally tally;
    for(std::size_t seed = 0; seed < 8; ++seed)
    {
      BOOST_TEST_CONTEXT("kind " << kind << ", seed " << seed)
      {
        Random random(seed);
        const auto mesh = random_meshes::random_closed_surface(seed % 3, 10200, random);
        const auto values = values_of_seed(mesh.number_of_vertices, random);
        Settings settings = settings_of_seed(seed);
        settings.method = seed / 4 % 2 == 0 ? Method::CONTOUR_TREES : Method::CRITICAL_SETS;
        settings.number_of_slabs = seed % 2 == 0 ? 1 : 8;
        const Disorder disorder = {static_cast<Kind>(kind)};
        const auto surface = make_mesh<Surface_mesh>(mesh);
        run_with_threads(4, [&] { try_order<Parallel_if_available_tag>(surface, values, disorder, settings, tally); });
      }
    }
    BOOST_TEST(tally.refused > 0u);
  }
}

BOOST_AUTO_TEST_CASE(nan_that_a_type_hides_ends)
{
  std::size_t number_of_refused = 0;
  for(std::size_t seed = 0; seed < 300; ++seed)
  {
    BOOST_TEST_CONTEXT("seed " << seed)
    {
      Random random(seed);
      const auto mesh = random_meshes::random_closed_surface(seed % 4, 5 + seed, random);
      std::vector<Number> values;
      for(const double value : values_of_seed(mesh.number_of_vertices, random))
        values.push_back({value});
      try
      {
        graph_checks::compute(make_mesh<Surface_mesh>(mesh), values, seed % 2 == 0,
                              seed % 4 < 2 ? Method::CONTOUR_TREES : Method::CRITICAL_SETS);
      }
      catch(const Unordered_scalar_error&)
      {
        ++number_of_refused;
      }
    }
  }
  BOOST_TEST(number_of_refused > 0u);
}

BOOST_AUTO_TEST_SUITE_END()
