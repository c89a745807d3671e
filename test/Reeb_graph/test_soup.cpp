// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of the CGAL-style package Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#include "complex_oracle.h"
#include "generated_surfaces/mesh_builders.h"
#include "generated_surfaces/random_meshes.h"
#include "random_complexes.h"
#include "random_fields.h"

#include <CGAL/Reeb_graph/internal/level_sets/Offline_connectivity.h>
#include <CGAL/compute_reeb_graph_of_soup.h>

#include <boost/test/unit_test.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <functional>
#include <string>
#include <utility>
#include <vector>

// Reeb graphs of soups and tetrahedra, against the oracle, and against those of the same surfaces as meshes.

BOOST_AUTO_TEST_SUITE(test_soup)

using CGAL::Reeb_graph::Method;
using CGAL::Reeb_graph::Ties;
using random_complexes::Complex;
using random_complexes::Complex_class;
using random_meshes::Combinatorial_mesh;
using random_meshes::Field_class;
using random_meshes::Mesh_class;
using random_meshes::Random;

namespace params = CGAL::parameters;
namespace rg = CGAL::Reeb_graph;

typedef CGAL::Reeb_graph_soup_traits<double> Traits;
typedef Traits::Graph Graph;

namespace {
template <class NamedParameters>
Graph graph_of(const Complex& complex, const std::vector<double>& values, const NamedParameters& np)
{
  Graph graph;
  const auto np_with_edges = params::edges(std::cref(complex.edges), np);
  if(complex.tetrahedra.empty())
    CGAL::compute_reeb_graph_of_soup(complex.number_of_vertices, complex.triangles, values, graph, np_with_edges);
  else
    CGAL::compute_reeb_graph_of_tetrahedra(complex.number_of_vertices, complex.tetrahedra, values, graph,
                                           np_with_edges);
  return graph;
}
} // namespace

BOOST_AUTO_TEST_CASE(graphs_of_random_complexes_are_those_of_the_oracle)
{
  for(std::size_t seed = 0; seed < 4000; ++seed)
    BOOST_TEST_CONTEXT("seed " << seed)
    {
      Random random(seed);
      const auto complex_class = static_cast<Complex_class>(seed % static_cast<int>(Complex_class::NUMBER_OF_CLASSES));
      const Complex complex = random_complexes::random_complex(complex_class, random);
      const auto values = random_complexes::random_values(complex.number_of_vertices, random);
      const Ties ties = random.below(2) == 0 ? Ties::PERTURB : Ties::CONTRACT;
      const bool keeps = random.below(2) == 0;
      const complex_oracle::Oracle oracle(complex.number_of_vertices, complex.simplices(), values, ties, keeps);
      const auto np = params::ties(ties, params::keep_degree_two_nodes(keeps));
      const Graph graph = graph_of(complex, values, np);
      BOOST_TEST(fault_of_graph(oracle, graph, values, ties) == "");
      const Graph other_graph = graph_of(complex, values, params::method(Method::CRITICAL_SETS, np));
      BOOST_TEST(fault_of_graph(oracle, other_graph, values, ties) == "");
      const Graph third = graph_of(complex, values, params::number_of_slabs(1 + random.below(5), np));
      BOOST_TEST(fault_of_graph(oracle, third, values, ties) == "");
    }
}

BOOST_AUTO_TEST_SUITE_END()
