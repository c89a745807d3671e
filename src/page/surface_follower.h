// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors
#ifndef CGAL_REEB_GRAPH_SRC_SURFACE_FOLLOWER_H
#define CGAL_REEB_GRAPH_SRC_SURFACE_FOLLOWER_H

#include "base/surface.h"

#include <memory>

namespace reeb_graph_program {
// Keeps lines in a surface: what of them lies outside is moved to the nearest place on the surface. Outside is where
// normals point, turned around if they point into what the surface encloses. Beyond borders, nothing is outside.
class Surface_follower
{
public:
  explicit Surface_follower(const Surface& surface);
  ~Surface_follower();

  Point operator()(const Point& point) const;

  // With more points where the line has been moved.
  Polyline operator()(const Polyline& line) const;

private:
  class Sides;
  std::unique_ptr<Sides> sides_; // changes with each call
};

} // namespace reeb_graph_program

#endif // CGAL_REEB_GRAPH_SRC_SURFACE_FOLLOWER_H
