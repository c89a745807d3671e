// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_FIELDS_INTERNAL_LAPLACIAN_GRAPH_H
#define CGAL_REEB_GRAPH_FIELDS_INTERNAL_LAPLACIAN_GRAPH_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/fields/Field_report.h>
#include <CGAL/Reeb_graph/fields/exceptions.h>
#include <CGAL/Reeb_graph/fields/internal/Indexed_surface.h>
#include <CGAL/Reeb_graph/fields/internal/Triangle_geometry.h>
#include <CGAL/Reeb_graph/internal/complex/Weighted_graph.h>
#include <CGAL/Reeb_graph/options.h>

#include <cstddef>

namespace CGAL::Reeb_graph::internal::scalar_fields {

// The weights of the Laplacian.
inline Weighted_graph laplacian_graph(const Indexed_surface& surface, Laplacian_weights weights)
{
  return Weighted_graph(surface.number_of_vertices(), [&](const auto& visit) {
    const auto visit_both = [&](Index u, Index v, double weight) {
      visit(Weighted_graph::Contribution{u, v, weight});
      visit(Weighted_graph::Contribution{v, u, weight});
    };
    for(std::size_t t = 0; t != surface.triangles().size(); ++t)
    {
      const auto& [v, is_on_border] = surface.triangles()[t];
      const bool has_geometry = weights != Laplacian_weights::UNIFORM;
      const Triangle_geometry geometry = has_geometry ? triangle_geometry(surface, t) : Triangle_geometry();
      for(int i = 0; i != 3; ++i)
      {
        const int next = (i + 1) % 3, previous = (i + 2) % 3;
        if(weights == Laplacian_weights::UNIFORM) // w_ij = 1
          visit_both(v[i], v[next], is_on_border[i] ? 1 : 0.5);
        else if(weights == Laplacian_weights::COTANGENT) // the mean of the cotangents of the angles that face the edge
          visit_both(v[next], v[previous], geometry.cotangent(i) / 2);
        else // the tangents of half the angles at v_i on both sides of the edge, divided by its length
        {
          const double half_tangent = geometry.half_tangent(i);
          visit(Weighted_graph::Contribution{v[i], v[next], half_tangent / length(geometry.edges[i])});
          visit(Weighted_graph::Contribution{v[i], v[previous], half_tangent / length(geometry.edges[previous])});
        }
      }
    }
  });
}

// Calls solve(graph, begin, end), with the fractions of the work that are done before and after it. If its equations
// have no finite solution, and the edges have their own lengths, it makes them longer, and calls it once more.
template <class Solve>
auto solve_or_lengthen_edges(Indexed_surface& surface,
                             const Weighted_graph& graph,
                             Laplacian_weights weights,
                             Field_report& report,
                             const Solve& solve)
{
  if(weights == Laplacian_weights::UNIFORM || surface.added_length() > 0)
    return solve(graph, 0.2, 0.9);
  try
  {
    return solve(graph, 0.2, 0.8);
  }
  catch(const Linear_solver_error&)
  {}
  catch(const Non_finite_scalar_error&)
  {}
  lengthen_edges(surface, report);
  return solve(laplacian_graph(surface, weights), 0.8, 0.9);
}

} // namespace CGAL::Reeb_graph::internal::scalar_fields

#endif // CGAL_REEB_GRAPH_FIELDS_INTERNAL_LAPLACIAN_GRAPH_H
