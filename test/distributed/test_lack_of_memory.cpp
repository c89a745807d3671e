// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

// Whatever array a rank has no memory for, all ranks say so, and none waits for another one.

#include "failing_allocations.h"
#include "ranks.h"

#include <CGAL/Reeb_graph/distributed/compute_reeb_graph_distributed.h>

#include <boost/mpi/collectives.hpp>
#include <boost/test/unit_test.hpp>

#include <cstddef>
#include <functional>
#include <new>
#include <vector>

BOOST_AUTO_TEST_SUITE(test_lack_of_memory)

using namespace ranks;
namespace params = CGAL::parameters;
namespace rg = CGAL::Reeb_graph;

namespace {
// Calls compute(), where the first allocation fails on one rank, then the second, and so on. If a rank throws, all do.
template <class Compute>
void check_allocations(std::size_t number_of_allocations, const Compute& compute)
{
  int has_thrown_anywhere = 1;
  for(std::size_t allocation = 0; allocation < number_of_allocations && has_thrown_anywhere != 0; ++allocation)
    BOOST_TEST_CONTEXT("allocation " << allocation)
    {
      if(rank() == allocation % number_of_ranks())
        failing_allocations::allocations_left = allocation;
      int has_thrown = 0;
      try
      {
        compute();
      }
      catch(const std::bad_alloc&)
      {
        has_thrown = 1;
      }
      failing_allocations::allocations_left = failing_allocations::never;
      has_thrown_anywhere = boost::mpi::all_reduce(world(), has_thrown, boost::mpi::maximum<int>());
      BOOST_TEST(has_thrown == has_thrown_anywhere);
    }
}
} // namespace

BOOST_AUTO_TEST_CASE(any_lack_of_memory_is_told_by_all)
{
  Surface<double> surface = {random_meshes::cylinder(20, 20), {}};
  for(std::size_t v = 0; v < surface.mesh.number_of_vertices; ++v)
    surface.values.push_back(static_cast<double>(v * 7 % 100 + v / 2));
  const auto input = part_in_order(surface);
  check_allocations(failing_allocations::never, [&] {
    rg::Distributed_slab<double> slab;
    slab.is_surface_kept = true;
    graph_on_ranks(input, params::slab(std::ref(slab)));
  });
  check_allocations(failing_allocations::never, [&] {
    Graph<double> graph;
    CGAL::compute_reeb_graph_of_soup_distributed(world(), input.vertices, input.triangles, input.scalars, graph,
                                                 params::gather_chains(false).ties(rg::Ties::CONTRACT));
  });
}

// One of the first arrays has an element for each page of all vertices.
BOOST_AUTO_TEST_CASE(lack_of_memory_for_many_vertices_is_told_by_all)
{
  Surface<double> surface = {random_meshes::cylinder(400, 500), {}};
  surface.values.assign(surface.mesh.number_of_vertices, 0);
  const auto input = part_in_order(surface);
  check_allocations(4, [&] { graph_on_ranks(input, params::default_values()); });
}

BOOST_AUTO_TEST_SUITE_END()
