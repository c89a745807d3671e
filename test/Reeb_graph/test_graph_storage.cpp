// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

// The graph type keeps its arcs in containers of its own. Whatever is done to a graph, one with the usual containers of
// Boost.Graph is its oracle.

#include "graph_checks.h"
#include "mesh_builders.h"
#include "random_meshes.h"

#include <CGAL/Reeb_graph/internal/base/arrays.h>

#include <boost/graph/copy.hpp>

#include <boost/test/unit_test.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <limits>
#include <list>
#include <memory>
#include <new>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

BOOST_AUTO_TEST_SUITE(test_graph_storage)

using mesh_builders::Surface_mesh;
using random_meshes::Random;

namespace {
typedef graph_checks::Graph_of<Surface_mesh> Graph;
struct Name
{
  std::size_t number = 0;
};
struct Value
{
  double number = 0;
};
typedef boost::adjacency_list<boost::vecS, boost::vecS, boost::bidirectionalS, Value, Name> Plain_graph;
typedef std::vector<std::tuple<std::size_t, std::size_t, std::size_t>> Arcs;

// What tells arcs apart: there is no chain of that length on the mesh, but none is needed.
class Names
{
public:
  Graph::edge_property_type arc(std::size_t name) const
  {
    Graph::edge_bundled result;
    result.chain = {storage_, 0, name};
    return {name, result};
  }

private:
  std::shared_ptr<const std::vector<CGAL::SM_Halfedge_index>> storage_ =
    std::make_shared<const std::vector<CGAL::SM_Halfedge_index>>(1000);
};

std::size_t name(const Graph& graph, Graph::edge_descriptor arc)
{
  BOOST_TEST(get(boost::edge_index, graph, arc) == graph[arc].chain.size());
  return graph[arc].chain.size();
}
std::size_t name(const Plain_graph& graph, Plain_graph::edge_descriptor arc) { return graph[arc].number; }
double value(const Graph& graph, std::size_t node) { return graph[node].value; }
double value(const Plain_graph& graph, std::size_t node) { return graph[node].number; }

template <class G, class Range>
Arcs list(const G& graph, const Range& range)
{
  Arcs arcs;
  for(const auto arc : CGAL::make_range(range))
    arcs.emplace_back(source(arc, graph), target(arc, graph), name(graph, arc));
  return arcs;
}

void check_same(const Graph& graph, const Plain_graph& expected)
{
  BOOST_TEST_REQUIRE(num_vertices(graph) == num_vertices(expected));
  BOOST_TEST_REQUIRE(num_edges(graph) == num_edges(expected));
  BOOST_TEST((list(graph, edges(graph)) == list(expected, edges(expected))));
  for(std::size_t node = 0; node < num_vertices(graph); ++node)
  {
    BOOST_TEST(value(graph, node) == value(expected, node));
    BOOST_TEST((list(graph, out_edges(node, graph)) == list(expected, out_edges(node, expected))));
    BOOST_TEST((list(graph, in_edges(node, graph)) == list(expected, in_edges(node, expected))));
  }
}

// Does the same to both graphs.
class Twins
{
public:
  explicit Twins(std::size_t seed) : random_(seed) {}

  void change()
  {
    const std::size_t size = num_vertices(plain_);
    const std::size_t action = random_.below(20);
    if(size < 2 || action < 2)
      add_node();
    else if(action < 14)
      add_arc(random_.below(size), random_.below(size));
    else if(action < 17 && num_edges(plain_) != 0)
      remove_arc(random_.below(num_edges(plain_)));
    else if(action == 17)
      for_both([node = random_.below(size)](auto& graph) { clear_vertex(node, graph); });
    else if(action == 18)
      for_both([node = random_.below(size)](auto& graph) {
        clear_vertex(node, graph);
        remove_vertex(node, graph);
      });
    else
      for_both([u = random_.below(size), v = random_.below(size)](auto& graph) { remove_edge(u, v, graph); });
  }

  const Graph& graph() const { return graph_; }
  const Plain_graph& plain() const { return plain_; }

private:
  template <class Function>
  void for_both(const Function& function)
  {
    function(graph_);
    function(plain_);
  }

  void add_node()
  {
    const double value = static_cast<double>(random_.below(1000));
    graph_[add_vertex(graph_)].value = value;
    plain_[add_vertex(plain_)].number = value;
  }

  void add_arc(std::size_t u, std::size_t v)
  {
    const std::size_t name = random_.below(1000);
    add_edge(u, v, names_.arc(name), graph_);
    add_edge(u, v, Name{name}, plain_);
  }

  void remove_arc(std::size_t position)
  {
    for_both([position](auto& graph) { remove_edge(*std::next(edges(graph).first, position), graph); });
  }

  Random random_;
  Names names_;
  Graph graph_;
  Plain_graph plain_;
};
} // namespace

BOOST_AUTO_TEST_CASE(a_graph_is_changed_like_any_other)
{
  for(std::size_t seed = 0; seed < 60; ++seed)
  {
    BOOST_TEST_CONTEXT("seed " << seed)
    {
      Twins twins(seed);
      for(std::size_t i = 0; i < 150; ++i)
      {
        twins.change();
        check_same(twins.graph(), twins.plain());
      }
    }
  }
}

BOOST_AUTO_TEST_CASE(copies_are_independent)
{
  Twins twins(1);
  for(std::size_t i = 0; i < 300; ++i)
    twins.change();
  const Plain_graph plain = twins.plain();
  Graph copy = twins.graph(), assigned(3);
  add_edge(0, 1, assigned);
  assigned = copy;
  {
    Graph moved = std::move(copy);
    check_same(moved, plain);
    swap(moved, assigned);
    check_same(moved, plain);
  }
  for(std::size_t i = 0; i < 300; ++i)
    twins.change();
  check_same(twins.graph(), twins.plain());
  check_same(assigned, plain);

  Graph by_boost;
  boost::copy_graph(assigned, by_boost);
  check_same(by_boost, plain);
  assigned.clear();
  BOOST_TEST(num_vertices(assigned) == 0u);
  BOOST_TEST(num_edges(assigned) == 0u);
  add_edge(add_vertex(assigned), add_vertex(assigned), assigned);
  BOOST_TEST(num_edges(assigned) == 1u);
  check_same(by_boost, plain);
}

// What the standard asks of an allocator: converted to that of another type and back, it is the same.
BOOST_AUTO_TEST_CASE(allocators_of_other_types_share_their_memory)
{
  typedef CGAL::Reeb_graph::internal::Block_allocator<double> Allocator;
  typedef std::allocator_traits<Allocator>::rebind_alloc<std::array<long, 7>> Other_allocator;
  Allocator allocator;
  Other_allocator other(allocator);
  BOOST_TEST((Allocator(other) == allocator));
  BOOST_TEST((other == allocator));
  BOOST_TEST((allocator == Allocator(allocator)));
  BOOST_TEST((allocator != Allocator()));
  BOOST_TEST((allocator != allocator.select_on_container_copy_construction()));

  double* const number = allocator.allocate(1);
  *number = 5;
  std::array<long, 7>* const numbers = other.allocate(1);
  numbers->fill(6);
  Other_allocator(allocator).deallocate(numbers, 1);
  BOOST_TEST(*number == 5);
  Allocator(other).deallocate(number, 1);

  std::list<double, Allocator> list(3, 1., allocator);
  BOOST_TEST((list.get_allocator() == allocator));
}

// std::vector is its oracle.
BOOST_AUTO_TEST_CASE(a_plain_vector_does_what_a_vector_does)
{
  typedef std::array<std::uint32_t, 3> Element;
  typedef CGAL::Reeb_graph::internal::Plain_vector<Element> Plain_vector;
  for(unsigned seed = 0; seed != 40; ++seed)
  {
    BOOST_TEST_INFO_SCOPE("seed " << seed);
    Random random(seed);
    Plain_vector plain;
    std::vector<Element> oracle;
    for(std::size_t step = 0; step != 200; ++step)
    {
      const std::uint32_t name = static_cast<std::uint32_t>(step);
      const Element element =
        oracle.empty() || random.below(2) == 0 ? Element{name, name + 1, name + 2} : oracle.back();
      const std::size_t size = random.below(step % 20 == 0 ? 2000 : 20), operation = random.below(8);
      if(operation <= 1)
      {
        for(std::size_t i = 0; i != size; ++i)
        {
          plain.push_back(i == 0 || plain.empty() ? element : plain.front());
          oracle.push_back(i == 0 || oracle.empty() ? element : oracle.front());
        }
      }
      else if(operation == 2)
        plain.resize(size, element), oracle.resize(size, element);
      else if(operation == 3)
        plain.assign(size, element), oracle.assign(size, element);
      else if(operation == 4)
        plain.resize(plain.size() + size), oracle.resize(oracle.size() + size);
      else if(operation == 5)
      {
        const Plain_vector copy(plain);
        plain.append(copy.begin(), copy.end());
        const std::vector<Element> copy_of_oracle(oracle);
        oracle.insert(oracle.end(), copy_of_oracle.begin(), copy_of_oracle.end());
        if(plain.size() > 4000)
          plain = Plain_vector(size), oracle = std::vector<Element>(size);
      }
      else if(operation == 6)
      {
        const std::ptrdiff_t begin = static_cast<std::ptrdiff_t>(random.below(oracle.size() + 1));
        const std::ptrdiff_t end =
          begin + static_cast<std::ptrdiff_t>(random.below(oracle.size() + 1 - std::size_t(begin)));
        plain.erase(plain.begin() + begin, plain.begin() + end);
        oracle.erase(oracle.begin() + begin, oracle.begin() + end);
      }
      else
      {
        Plain_vector moved(std::move(plain));
        BOOST_TEST(plain.empty());
        plain = Plain_vector(moved.begin(), moved.end());
        plain.reserve(size);
        BOOST_TEST(plain.capacity() >= size);
      }
      BOOST_TEST(plain.empty() == oracle.empty());
      BOOST_REQUIRE(std::equal(plain.begin(), plain.end(), oracle.begin(), oracle.end()));
    }
  }
}

// Those that need a place of their own kind, or more than a copy of their bytes.
BOOST_AUTO_TEST_CASE(a_plain_vector_is_taken_only_for_elements_that_allow_it)
{
  using CGAL::Reeb_graph::internal::Vector_of;
  struct alignas(64) Aligned_number
  {
    double number;
  };
  BOOST_TEST((std::is_same_v<Vector_of<double>, CGAL::Reeb_graph::internal::Plain_vector<double>>));
  BOOST_TEST((std::is_same_v<Vector_of<Aligned_number>, std::vector<Aligned_number>>));
  BOOST_TEST((std::is_same_v<Vector_of<std::vector<double>>, std::vector<std::vector<double>>>));
}

BOOST_AUTO_TEST_CASE(a_plain_vector_that_memory_cannot_hold_is_refused)
{
  typedef CGAL::Reeb_graph::internal::Plain_vector<double> Plain_vector;
  BOOST_CHECK_THROW(Plain_vector(std::numeric_limits<std::size_t>::max() / 2), std::bad_alloc);
  Plain_vector numbers(3, 1.5);
  BOOST_CHECK_THROW(numbers.reserve(std::numeric_limits<std::size_t>::max() / sizeof(double) + 2), std::bad_alloc);
  BOOST_TEST(std::vector<double>(numbers.begin(), numbers.end()) == std::vector<double>(3, 1.5),
             boost::test_tools::per_element());
}

BOOST_AUTO_TEST_SUITE_END()
