// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#include <boost/test/unit_test.hpp>

#include "curve_samples.h"
#include "cut_mesh_checks.h"

#include <CGAL/Curves_on_surface_topology.h>
#include <CGAL/Path_on_surface.h>
#include <CGAL/Reeb_graph/curves/branch_curves.h>
#include <CGAL/Reeb_graph/curves/pants_decomposition.h>
#include <CGAL/Reeb_graph/scalar_maps.h>

#include <cstddef>
#include <iterator>
#include <vector>

// The curves of a pants decomposition are not contractible, and no two are homotopic; branch curves are contractible.
// CGAL's package Surface_mesh_topology is the judge.

BOOST_AUTO_TEST_SUITE(test_curve_homotopy)

using curve_samples::Sample;
using mesh_builders::Surface_mesh;

namespace {
typedef CGAL::Surface_mesh_topology::Path_on_surface<Surface_mesh> Path;
typedef CGAL::Surface_mesh_topology::Curves_on_surface_topology<Surface_mesh> Topology;
typedef std::vector<CGAL::Reeb_graph::Curve<Surface_mesh::Halfedge_index>> Curves;

std::vector<Path> make_paths(const Surface_mesh& mesh, const Curves& curves)
{
  std::vector<Path> paths;
  for(const auto& curve : curves)
  {
    Path path(mesh);
    for(const Surface_mesh::Halfedge_index h : curve.halfedges)
      path.push_back(h);
    paths.push_back(path);
  }
  return paths;
}

void test_pants(const Sample& sample)
{
  auto mesh = curve_samples::make_mesh<Surface_mesh>(sample.soup);
  Curves curves;
  CGAL::Reeb_graph::pants_decomposition(mesh, CGAL::Reeb_graph::make_scalar_map(mesh, sample.values),
                                        std::back_inserter(curves));
  const std::vector<Path> paths = make_paths(mesh, curves);
  const Topology topology(mesh);
  for(std::size_t i = 0; i < paths.size(); ++i)
  {
    BOOST_TEST(!topology.is_contractible(paths[i]));
    Path reversed = paths[i];
    reversed.reverse();
    for(std::size_t j = 0; j < i; ++j)
    {
      BOOST_TEST(!topology.are_freely_homotopic(paths[i], paths[j]));
      BOOST_TEST(!topology.are_freely_homotopic(reversed, paths[j]));
    }
  }
}
} // namespace

BOOST_AUTO_TEST_CASE(pants_curves_of_random_fields)
{
  for(std::size_t seed = 0; seed < 40; ++seed)
    BOOST_TEST_CONTEXT("seed " << seed)
  test_pants(curve_samples::random_sample(seed, false, 1, 2));
}

BOOST_AUTO_TEST_CASE(pants_curves_of_smooth_surfaces)
{
  for(const unsigned genus : {2u, 5u})
    for(std::size_t kind = 0; kind < 4; ++kind)
      BOOST_TEST_CONTEXT("genus " << genus << ", field " << kind)
  test_pants(curve_samples::smooth_sample(genus, 800, kind));
}

BOOST_AUTO_TEST_CASE(branch_curves_are_contractible)
{
  for(std::size_t seed = 0; seed < 40; ++seed)
    BOOST_TEST_CONTEXT("seed " << seed)
    {
      const Sample sample = curve_samples::random_sample(seed, false, 1, 1);
      auto mesh = curve_samples::make_mesh<Surface_mesh>(sample.soup);
      Curves curves;
      CGAL::Reeb_graph::branch_curves(mesh, CGAL::Reeb_graph::make_scalar_map(mesh, sample.values),
                                      std::back_inserter(curves));
      const Topology topology(mesh);
      for(const Path& path : make_paths(mesh, curves))
        BOOST_TEST(topology.is_contractible(path));
    }
}

BOOST_AUTO_TEST_SUITE_END()
