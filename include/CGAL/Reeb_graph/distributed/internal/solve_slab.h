// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of the CGAL-style package Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_DISTRIBUTED_INTERNAL_SOLVE_SLAB_H
#define CGAL_REEB_GRAPH_DISTRIBUTED_INTERNAL_SOLVE_SLAB_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/distributed/internal/Slab_complex.h>
#include <CGAL/Reeb_graph/distributed/internal/Slab_surface.h>
#include <CGAL/Reeb_graph/distributed/internal/link_triangles.h>
#include <CGAL/Reeb_graph/internal/base/Index.h>
#include <CGAL/Reeb_graph/internal/base/parallel.h>
#include <CGAL/Reeb_graph/internal/complex/Simplicial_complex.h>
#include <CGAL/Reeb_graph/internal/complex/Unchecked_complex.h>
#include <CGAL/Reeb_graph/internal/engine/Slab.h>
#include <CGAL/Reeb_graph/internal/engine/Swept_vertices.h>
#include <CGAL/Reeb_graph/internal/engine/classify_complex.h>
#include <CGAL/Reeb_graph/internal/engine/classify_vertices.h>
#include <CGAL/Reeb_graph/internal/engine/find_arcs.h>

#include <array>
#include <optional>
#include <utility>

namespace CGAL {
namespace Reeb_graph {
namespace internal {

// The levels between the slab of a rank and those of its neighbors, as far as there are any.
class Levels_of_rank
{
public:
  template <class Complex, class Scalar>
  Levels_of_rank(const Complex& complex, const Slab_surface<Scalar>& surface)
  {
    if(surface.has_slab() && !surface.is_lowest())
      levels_[Side::LOWER].emplace(complex.number_of_edges());
    if(surface.has_slab() && !surface.is_highest())
      levels_[Side::UPPER].emplace(complex.number_of_edges());
    const auto& slabs = surface.slabs_of_vertices;
    for(const Edge_index edge : Index_range<Edge_index>(complex.number_of_edges()))
    {
      const Slab_index a = slabs[complex.source(even_halfedge(edge))], b = slabs[complex.target(even_halfedge(edge))];
      if(a == b)
        continue;
      if(levels_[Side::LOWER] && (a == surface.below() || b == surface.below()))
        levels_[Side::LOWER]->add_crossed_edge(edge);
      if(levels_[Side::UPPER] && (a == surface.above() || b == surface.above()))
        levels_[Side::UPPER]->add_crossed_edge(edge);
    }
    if(levels_[Side::LOWER])
      levels_[Side::LOWER]->find_contours(complex, [&](Vertex_index u) { return slabs[u] == surface.below(); });
    if(levels_[Side::UPPER])
      levels_[Side::UPPER]->find_contours(complex, [&](Vertex_index u) { return slabs[u] != surface.above(); });
  }

  const Bounding_level* level(Side side) const { return levels_[side] ? &*levels_[side] : nullptr; }
  Number number_of_contours(Side side) const { return levels_[side] ? levels_[side]->number_of_contours() : 0; }

private:
  By_side<std::optional<Bounding_level>> levels_;
};

// Checks the surface at the vertices of the rank's slab, and finds the critical ones. Takes the triangles, and leaves
// the other arrays of the surface, to which the result refers.
template <class Scalar, class Order>
Classified_complex<Slab_complex> link_and_classify(Slab_surface<Scalar>& surface, const Order& order)
{
  Halfedge_arrays arrays = Triangle_linking(std::move(surface.triangles), surface.global_vertices)();
  surface.triangles = {};
  return check_and_classify_vertices<Sequential_tag>(
    Unchecked_complex(Slab_complex(std::move(arrays), surface.global_vertices, surface.slabs_of_vertices)), order);
}

// Lists the triangles of the rank as a complex, and finds the critical vertices in the same way.
template <class Scalar, class Order>
Classified_complex<Simplicial_complex> list_and_classify(Slab_surface<Scalar>& surface, const Order& order)
{
  const auto for_each_triangle = [&](const auto& visit) {
    for(const std::array<Vertex_index, 3>& t : surface.triangles)
      visit(t[0], t[1], t[2]);
  };
  Simplicial_complex complex(surface.global_vertices.size(), for_each_triangle, [](const auto&) {});
  surface.triangles = {};
  Swept_vertices critical_vertices =
    find_vertices_of_complex<Sequential_tag>(complex, order, [&](Vertex_index v, const By_side<Number>& numbers) {
      return surface.slabs_of_vertices[v] == surface.inside() && has_critical_numbers_of_sectors(numbers);
    });
  return {std::move(complex), std::move(critical_vertices)};
}

// The arcs between the nodes of a Slab. Contours of a level are numbered by their first edges, and edges by their
// vertices, so the two ranks at a level know each of its contours by the same number.
struct Arcs_of_slab
{
  Slab_arcs arcs;
  By_side<Number> numbers_of_contours = {0, 0};
};

// Finds the arcs between the critical vertices of the rank's slab and the contours of its bounding levels. Calls
// report(fraction) now and then.
template <class Scalar, class Complex, class Order, class ChosenMethod, class Report>
Arcs_of_slab solve_slab(const Slab_surface<Scalar>& surface,
                        const Classified_complex<Complex>& classified,
                        const Order& order,
                        ChosenMethod method,
                        const Report& report)
{
  const auto& [complex, critical_vertices] = classified;
  const Levels_of_rank levels(complex, surface);
  const Slab<Complex> slab = surface.number_of_slabs == 1
                             ? Slab<Complex>(complex, critical_vertices)
                             : Slab<Complex>(complex, critical_vertices, surface.slabs_of_vertices, surface.inside(),
                                             {levels.level(Side::LOWER), levels.level(Side::UPPER)});
  return {find_arcs_of_slab<Sequential_tag>(slab, order, method, report),
          {levels.number_of_contours(Side::LOWER), levels.number_of_contours(Side::UPPER)}};
}

} // namespace internal
} // namespace Reeb_graph
} // namespace CGAL

#endif // CGAL_REEB_GRAPH_DISTRIBUTED_INTERNAL_SOLVE_SLAB_H
