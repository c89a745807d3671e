// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of the CGAL-style package Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#include <boost/test/unit_test.hpp>

#include "computed_graphs.h"

#include <boost/mpl/list.hpp>

#include <algorithm>
#include <cstddef>
#include <functional>
#include <type_traits>
#include <vector>

// The named parameter callback: how far the work is, and how it is stopped.

using namespace computed_graphs;
using mesh_builders::Polyhedron;
using mesh_builders::Surface_mesh;

template <class Mesh_, class Tag>
struct Case
{
  typedef Mesh_ Mesh;
  typedef Tag Concurrency_tag;
};

typedef boost::mpl::list<Case<Surface_mesh, CGAL::Sequential_tag>,
                         Case<Surface_mesh, CGAL::Parallel_if_available_tag>,
                         Case<Polyhedron, CGAL::Parallel_if_available_tag>>
  Cases;

namespace {
// Tells which fractions it has been told, and wants no more at one of them.
class Listener
{
public:
  explicit Listener(std::size_t number_of_calls = 1000) : last_(number_of_calls) {}

  bool operator()(double fraction)
  {
    fractions_.push_back(fraction);
    return fractions_.size() != last_;
  }

  const std::vector<double>& fractions() const { return fractions_; }

private:
  std::size_t last_;
  std::vector<double> fractions_;
};

// a small one, and one that is worked on in parallel
std::vector<Combinatorial_mesh> meshes()
{
  return {Combinatorial_mesh(), random_meshes::tetrahedron(), random_meshes::cylinder(110, 110)};
}

template <class Case>
class Computation
{
  typedef typename Case::Mesh Mesh;

public:
  Computation(const Combinatorial_mesh& mesh, Method method, std::size_t number_of_slabs)
    : mesh_(make_mesh<Mesh>(mesh)),
      scalar_map_(CGAL::Reeb_graph::make_scalar_map(mesh_, std::vector<double>(mesh.number_of_vertices, 1)))
  {
    settings_.method = method;
    settings_.number_of_slabs = number_of_slabs;
  }

  void operator()(graph_checks::Graph_of<Mesh>& graph, Listener& listener) const
  {
    CGAL::compute_reeb_graph<typename Case::Concurrency_tag>(mesh_, scalar_map_, graph,
                                                             named_parameters(settings_).callback(std::ref(listener)));
  }

private:
  Mesh mesh_;
  graph_checks::Scalar_map_of<Mesh> scalar_map_;
  Settings settings_;
};
} // namespace

BOOST_AUTO_TEST_CASE_TEMPLATE(fractions_grow_to_one, C, Cases)
{
  for(const Combinatorial_mesh& mesh : meshes())
    for(const Method method : {Method::CONTOUR_TREES, Method::CRITICAL_SETS})
      for(const std::size_t number_of_slabs : {std::size_t(1), std::size_t(3)})
      {
        Listener listener;
        graph_checks::Graph_of<typename C::Mesh> graph;
        Computation<C>(mesh, method, number_of_slabs)(graph, listener);
        BOOST_TEST_REQUIRE(listener.fractions().size() > 2u);
        BOOST_TEST(listener.fractions().front() >= 0);
        BOOST_TEST(std::is_sorted(listener.fractions().begin(), listener.fractions().end()));
        BOOST_TEST(listener.fractions().back() == 1);
      }
}

BOOST_AUTO_TEST_CASE_TEMPLATE(work_can_be_stopped_at_each_call_but_the_last, C, Cases)
{
  for(const Combinatorial_mesh& mesh : meshes())
    for(const Method method : {Method::CONTOUR_TREES, Method::CRITICAL_SETS})
      for(const std::size_t number_of_slabs : {std::size_t(1), std::size_t(3)})
      {
        const Computation<C> compute(mesh, method, number_of_slabs);
        graph_checks::Graph_of<typename C::Mesh> expected, graph(2);
        add_edge(0, 1, graph);
        graph[1].value = 17;
        Listener undisturbed;
        compute(expected, undisturbed);
        const std::size_t last_call = undisturbed.fractions().size();
        for(std::size_t call = 1; call < last_call; ++call)
        {
          Listener listener(call);
          BOOST_CHECK_THROW(compute(graph, listener), CGAL::Reeb_graph::Cancelled_error);
          BOOST_TEST(listener.fractions().size() == call);
          BOOST_TEST(num_vertices(graph) == 2u);
          BOOST_TEST(num_edges(graph) == 1u);
          BOOST_TEST(graph[1].value == 17);
        }
        // There is nothing left to stop at the end.
        Listener listener(last_call);
        compute(graph, listener);
        BOOST_TEST(num_vertices(graph) == num_vertices(expected));
        BOOST_TEST(num_edges(graph) == num_edges(expected));
      }
}

// The slow parts of the work are several steps each.
BOOST_AUTO_TEST_CASE(arcs_are_found_in_steps)
{
  const auto number_of_calls_within = [](Method method, double begin, double end) {
    Listener listener;
    graph_checks::Graph_of<Surface_mesh> graph;
    const auto mesh = random_meshes::cylinder(110, 110);
    Computation<Case<Surface_mesh, CGAL::Sequential_tag>>(mesh, method, 1)(graph, listener);
    return std::count_if(listener.fractions().begin(), listener.fractions().end(),
                         [&](double fraction) { return fraction > begin && fraction < end; });
  };
  BOOST_TEST(number_of_calls_within(Method::CONTOUR_TREES, 0.3, 0.7) > 1);
  BOOST_TEST(number_of_calls_within(Method::CRITICAL_SETS, 0.3, 0.7) > 0);
}

BOOST_AUTO_TEST_CASE(being_stopped_is_an_error)
{
  BOOST_TEST((std::is_base_of_v<CGAL::Reeb_graph::Error, CGAL::Reeb_graph::Cancelled_error>));
}
