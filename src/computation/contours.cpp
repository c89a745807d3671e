// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of the CGAL-style package Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#include "computation/contours.h"

#include "computation/augmentation.h"
#include "computation/choose_contours.h"
#include "computation/nearest_place.h"

#include <CGAL/Reeb_graph/IO/polylines.h>

#include <array>
#include <cstddef>

namespace reeb_graph_program {
namespace {
class Surface_drawer
{
public:
  Surface_drawer(const Surface& surface, const Augmentation& augmentation)
    : surface_(surface),
      augmentation_(augmentation)
  {}

  void add(const Augmentation::Contour& contour, Contours& contours) const
  {
    add_line(CGAL::Reeb_graph::polyline_of_contour(surface_, augmentation_, contour),
             get(boost::edge_index, augmentation_.graph(), contour.arc), contour.value, contour.is_closed, contours);
    ++contours.number;
  }

private:
  const Surface& surface_;
  const Augmentation& augmentation_;
};

Nearest_place nearest_place(const Surface& surface, Scalar_map scalar_map, const Point& point)
{
  Nearest_place place(point);
  for(const Surface::Face_index f : surface.faces())
  {
    std::array<Point, 3> points;
    std::array<double, 3> values;
    std::size_t i = 0;
    for(const Surface::Vertex_index v : surface.vertices_around_face(surface.halfedge(f)))
    {
      points[i] = surface.point(v);
      values[i++] = scalar_map[v];
    }
    place.add_triangle(points, values);
  }
  return place;
}

} // namespace

Contours find_contours(const Surface& surface, Scalar_map scalar_map, const Contour_choice& choice)
{
  const Graph given = compute_graph(surface, scalar_map, choice.graph);
  const Simplified_graph graph(given, choice.simplification,
                               threshold_in_units(choice.simplification, surface, scalar_map));
  const Augmentation augmentation = graph.augmentation(surface, scalar_map, choice.graph);
  return choose_contours(augmentation, Surface_drawer(surface, augmentation), scalar_map, choice,
                         [&](const Point& point) { return nearest_place(surface, scalar_map, point); });
}

} // namespace reeb_graph_program
