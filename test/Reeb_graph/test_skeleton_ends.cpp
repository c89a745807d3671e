// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors
#include <boost/test/unit_test.hpp>

#include "mesh_builders.h"
#include "quadruped_samples.h"

#include <CGAL/Reeb_graph/skeleton/extract_curve_skeleton.h>

#include <CGAL/boost/graph/iterator.h>

#include <algorithm>
#include <cstddef>
#include <vector>

// The ends of skeletons that a person counts.

BOOST_AUTO_TEST_SUITE(test_skeleton_ends)

using mesh_builders::Surface_mesh;
using tube_samples::Point;

// Each tip of a leg, a snout, a horn, an ear and a tail is near an end of its own, and there is no other end.
BOOST_AUTO_TEST_CASE(ends_of_quadrupeds)
{
  for(std::size_t seed = 0; seed != 10; ++seed)
    BOOST_TEST_CONTEXT("seed " << seed)
    {
      auto animal = quadruped_samples::quadruped(seed);
      const auto mesh = generated_surfaces::make_mesh<Surface_mesh>(quadruped_samples::surface(animal, seed));
      CGAL::Reeb_graph::Curve_skeleton<Surface_mesh> skeleton;
      extract_curve_skeleton(mesh, skeleton);
      std::vector<Point> ends;
      for(const auto v : CGAL::make_range(vertices(skeleton)))
        if(out_degree(v, skeleton) == 1)
          ends.push_back({skeleton[v].point.x(), skeleton[v].point.y(), skeleton[v].point.z()});
      BOOST_TEST(ends.size() == animal.tips.size());
      for(const Point& tip : animal.tips)
      {
        const auto is_near = [&](const Point& end) { return tube_samples::distance(tip, end) < 0.3; };
        BOOST_TEST(std::count_if(ends.begin(), ends.end(), is_near) == 1);
      }
    }
}

BOOST_AUTO_TEST_SUITE_END()
