// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_TEST_SOUP_SAMPLES_H
#define CGAL_REEB_GRAPH_TEST_SOUP_SAMPLES_H

#include <CGAL/Reeb_graph_soup_traits.h>
#include <CGAL/Simple_cartesian.h>

#include <boost/graph/graph_traits.hpp>

#include <array>
#include <vector>

// The points and graphs of soups in the tests.
namespace soup_samples {
typedef CGAL::Simple_cartesian<double> Kernel;
typedef Kernel::Point_3 Point;
typedef CGAL::Reeb_graph_soup_traits<double>::Graph Graph;
typedef boost::graph_traits<Graph>::edge_descriptor arc_descriptor;

inline std::vector<Point> make_points(const std::vector<std::array<double, 3>>& coordinates)
{
  std::vector<Point> points;
  for(const auto& p : coordinates)
    points.emplace_back(p[0], p[1], p[2]);
  return points;
}

} // namespace soup_samples

#endif // CGAL_REEB_GRAPH_TEST_SOUP_SAMPLES_H
