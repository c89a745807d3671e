// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of the CGAL-style package Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_SRC_POLYGON_SOUP_H
#define CGAL_REEB_GRAPH_SRC_POLYGON_SOUP_H

#include "base/surface.h"

#include <cstddef>
#include <vector>

namespace reeb_graph_program {
typedef std::vector<std::size_t> Polygon;

// Faces by the numbers of their vertices.
struct Polygon_soup
{
  std::vector<Point> points;
  std::vector<Polygon> polygons;
  std::vector<double> scalars; // the property of the points that was asked for; empty if none was
};

} // namespace reeb_graph_program

#endif // CGAL_REEB_GRAPH_SRC_POLYGON_SOUP_H
