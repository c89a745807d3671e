// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#include <boost/test/unit_test.hpp>

#include "computed_graphs.h"
#include "handle_samples.h"

#include <CGAL/Reeb_graph/exceptions.h>
#include <CGAL/Reeb_graph/handles/handle_and_tunnel_loops.h>
#include <CGAL/Reeb_graph/handles/remove_handles.h>

#include <boost/mpl/list.hpp>

#include <cstddef>
#include <functional>
#include <limits>
#include <thread>
#include <vector>

// Loops are found by searches on many threads, and are the same for any number of these.

BOOST_AUTO_TEST_SUITE(test_handles_on_threads)

using CGAL::Reeb_graph::handle_and_tunnel_loops;
using CGAL::Reeb_graph::remove_handles;
using computed_graphs::run_with_threads;
using generated_surfaces::make_mesh;
using handle_samples::Sample;
using mesh_builders::Polyhedron;
using mesh_builders::Surface_mesh;
typedef CGAL::Parallel_if_available_tag Parallel;
namespace parameters = CGAL::parameters;

typedef boost::mpl::list<Surface_mesh, Polyhedron> Meshes;

namespace {
// Those whose components are many, whose genus is high, and that have a border or intersect themselves.
std::vector<Sample> samples()
{
  std::vector<Sample> result = handle_samples::closed_samples();
  result.push_back({"gyroid", handle_samples::gyroid(4, 0.4), {}});
  Sample crossed = {"crossed", handle_samples::knotted_torus(), {}};
  for(std::size_t k = 0; k != 3; ++k)
    crossed.soup.points[40 * k] = {0, 0, 0};
  result.push_back(crossed);
  Sample open = {"open", generated_surfaces::closed_surface(5, 2000), {}};
  open.soup.triangles.pop_back();
  result.push_back(open);
  return result;
}

template <class Mesh>
auto heights(const Mesh& mesh)
{
  std::vector<double> values;
  for(const auto v : vertices(mesh))
    values.push_back(get(CGAL::vertex_point, mesh, v).z());
  return CGAL::Reeb_graph::make_scalar_map(mesh, values);
}

template <class Loop>
bool is_same(const Loop& a, const Loop& b)
{
  return a.kind == b.kind && a.halfedges == b.halfedges && a.partner == b.partner && a.persistence == b.persistence
      && a.component == b.component;
}

// Notes who calls it, and when.
struct Listener
{
  std::size_t last_call;
  std::thread::id thread = std::this_thread::get_id();
  std::size_t number_of_calls = 0;
  double fraction = 0;
  bool is_called_in_order = true;

  bool operator()(double its_fraction)
  {
    is_called_in_order = is_called_in_order && std::this_thread::get_id() == thread && fraction <= its_fraction;
    fraction = its_fraction;
    return ++number_of_calls != last_call;
  }
};
} // namespace

BOOST_AUTO_TEST_CASE_TEMPLATE(loops_are_the_same, Mesh, Meshes)
{
  for(const Sample& sample : samples())
  {
    const Mesh mesh = make_mesh<Mesh>(sample.soup);
    const auto scalar_map = heights(mesh);
    for(const bool is_ignored : {false, true})
    {
      const auto np = parameters::ignore_self_intersections(is_ignored);
      const auto expected = handle_and_tunnel_loops(mesh, scalar_map, np);
      for(const std::size_t number_of_threads : {1, 2, 4})
        BOOST_TEST_CONTEXT(sample.name << ", " << number_of_threads << " threads")
      run_with_threads(number_of_threads, [&] {
        const auto found = handle_and_tunnel_loops<Parallel>(mesh, scalar_map, np);
        BOOST_TEST_REQUIRE(found.loops().size() == expected.loops().size());
        for(std::size_t i = 0; i != found.loops().size(); ++i)
          BOOST_TEST(is_same(found.loops()[i], expected.loops()[i]));
        BOOST_TEST(found.number_of_self_intersections(0) == expected.number_of_self_intersections(0));
      });
    }
  }
}

BOOST_AUTO_TEST_CASE_TEMPLATE(the_same_handles_are_removed, Mesh, Meshes)
{
  const double infinity = std::numeric_limits<double>::infinity();
  for(const Sample& sample : samples())
  {
    Mesh expected = make_mesh<Mesh>(sample.soup);
    const auto expected_rows = remove_handles(expected, infinity);
    for(const std::size_t number_of_threads : {2, 4})
      BOOST_TEST_CONTEXT(sample.name << ", " << number_of_threads << " threads")
    run_with_threads(number_of_threads, [&] {
      Mesh mesh = make_mesh<Mesh>(sample.soup);
      const auto rows = remove_handles<Parallel>(mesh, infinity);
      BOOST_TEST_REQUIRE(rows.size() == expected_rows.size());
      for(std::size_t i = 0; i != rows.size(); ++i)
        BOOST_TEST((rows[i].points == expected_rows[i].points && rows[i].result == expected_rows[i].result));
      BOOST_TEST(vertices(mesh).size() == vertices(expected).size());
      BOOST_TEST(faces(mesh).size() == faces(expected).size());
    });
  }
}

// The callback may be slow or need its thread, such as one that draws or asks Python.
BOOST_AUTO_TEST_CASE(one_thread_calls_the_callback_and_can_cancel)
{
  const Surface_mesh mesh = make_mesh<Surface_mesh>(handle_samples::gyroid(5, 0.4));
  const auto scalar_map = heights(mesh);
  run_with_threads(4, [&] {
    Listener listener{0};
    handle_and_tunnel_loops<Parallel>(mesh, scalar_map, parameters::callback(std::ref(listener)));
    BOOST_TEST(listener.is_called_in_order);
    BOOST_TEST(listener.fraction == 1);
    BOOST_TEST_REQUIRE(listener.number_of_calls > 20u);
    // How often it is called depends on what the other threads leave to this one.
    std::size_t number_cancelled = 0;
    for(std::size_t last_call = 1; last_call < listener.number_of_calls; last_call += 1 + last_call / 3)
    {
      Listener stopping{last_call};
      bool is_cancelled = false;
      try
      {
        handle_and_tunnel_loops<Parallel>(mesh, scalar_map, parameters::callback(std::ref(stopping)));
      }
      catch(const CGAL::Reeb_graph::Cancelled_error&)
      {
        is_cancelled = true;
      }
      BOOST_TEST(is_cancelled == (stopping.number_of_calls == last_call && stopping.fraction < 1));
      number_cancelled += is_cancelled ? 1 : 0;
    }
    BOOST_TEST(number_cancelled > 4u);
  });
}

BOOST_AUTO_TEST_SUITE_END()
