// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of the CGAL-style package Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_INTERNAL_SCALAR_FIELDS_PROPER_TRIANGLES_H
#define CGAL_REEB_GRAPH_INTERNAL_SCALAR_FIELDS_PROPER_TRIANGLES_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/fields/Field_report.h>
#include <CGAL/Reeb_graph/fields/exceptions.h>
#include <CGAL/Reeb_graph/internal/scalar_fields/Indexed_surface.h>
#include <CGAL/Reeb_graph/internal/scalar_fields/triangle_geometry.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>

namespace CGAL {
namespace Reeb_graph {
namespace internal {
namespace scalar_fields {

// Makes all edges longer by the least length after which any two sides of a triangle are longer than the third one by a
// margin: intrinsic mollification. See Field_report.
inline void lengthen_edges(Indexed_surface& surface, Field_report& report)
{
  constexpr double margin_of_mean = 1e-6, margin_of_longest = 1e-12;
  double sum = 0, number_of_edges = 0, longest = 0;
  // The least of the sums of two sides of a triangle less the third one; it can be negative by rounding.
  double least_slack = std::numeric_limits<double>::infinity();
  for(const Indexed_triangle& t : surface.triangles())
  {
    std::array<double, 3> sides;
    for(int i = 0; i != 3; ++i)
    {
      sides[i] = length(surface.point(t.vertices[(i + 1) % 3]) - surface.point(t.vertices[i]));
      sum += t.is_on_border[i] ? sides[i] : sides[i] / 2;
      number_of_edges += t.is_on_border[i] ? 1 : 0.5;
    }
    std::sort(sides.begin(), sides.end());
    longest = (std::max)(longest, sides[2]);
    least_slack = (std::min)(least_slack, sides[0] - (sides[2] - sides[1]));
  }
  // If all points are the same, the unit is that of the coordinates.
  const double mean = sum > 0 ? sum / number_of_edges : 1;
  const double added_length = (std::max)(margin_of_mean * mean, margin_of_longest * longest) - least_slack;
  if(!(added_length > 0))
    return;
  surface.set_added_length(added_length);
  report.mean_length = sum > 0 ? mean * surface.scale() : 0;
  report.added_length = surface.added_length() * surface.scale();
}

// Makes the edges longer if there is a triangle that is not proper.
inline Field_report make_triangles_proper(Indexed_surface& surface)
{
  Field_report report;
  for(std::size_t t = 0; t != surface.triangles().size(); ++t)
    if(!geometry_of_points(surface, t).is_proper())
      ++report.number_of_bad_faces;
  if(report.number_of_bad_faces > 0)
    lengthen_edges(surface, report);
  return report;
}

// Calls solve(graph, fraction), with the fraction of the work that is done when its equations have been set up. If they
// have no finite solution, and the edges have their own lengths, it makes them longer, and calls it once more with the
// graph that make_graph() gives then.
template <class Graph, class Solve, class MakeGraph>
auto solve_or_lengthen_edges(Indexed_surface& surface,
                             Field_report& report,
                             const Graph& graph,
                             const Solve& solve,
                             const MakeGraph& make_graph)
{
  if(surface.added_length() > 0)
    return solve(graph, 0.2);
  try
  {
    return solve(graph, 0.2);
  }
  catch(const Linear_solver_error&)
  {}
  catch(const Non_finite_scalar_error&)
  {}
  lengthen_edges(surface, report);
  return solve(make_graph(), 0.6);
}

} // namespace scalar_fields
} // namespace internal
} // namespace Reeb_graph
} // namespace CGAL

#endif // CGAL_REEB_GRAPH_INTERNAL_SCALAR_FIELDS_PROPER_TRIANGLES_H
