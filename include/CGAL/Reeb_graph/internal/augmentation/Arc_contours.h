// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of the CGAL-style package Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_INTERNAL_AUGMENTATION_ARC_CONTOURS_H
#define CGAL_REEB_GRAPH_INTERNAL_AUGMENTATION_ARC_CONTOURS_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/exceptions.h>
#include <CGAL/Reeb_graph/internal/augmentation/Arc_levels.h>
#include <CGAL/Reeb_graph/internal/augmentation/check_graph.h>
#include <CGAL/Reeb_graph/internal/base/parallel.h>
#include <CGAL/Reeb_graph/options.h>

#include <CGAL/boost/graph/iterator.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Reeb_graph {
namespace internal {

// A halfedge of the chain of an arc that crosses a level. Chains can overlap where a piece ends; then the later one is
// inside the arc. It throws Graph_mismatch_error if there is none.
template <class GraphOnComplex, class IsBelow>
auto find_crossing(const GraphOnComplex& on_complex,
                   typename GraphOnComplex::arc_descriptor arc,
                   const IsBelow& is_below)
{
  const auto& chain = on_complex.chain(arc);
  const auto is_source_below = [&](const auto& h) { return is_below(on_complex.checked_source(h)); };
  const auto h = std::partition_point(chain.begin() + 1, chain.end(), is_source_below)[-1];
  if(!is_source_below(h) || is_below(on_complex.checked_target(h)))
    throw Graph_mismatch_error();
  return h;
}

// The contours of arcs at levels that cross their chains, and whether they do: what an augmentation is asked for.
template <class GraphOnComplex>
class Arc_contours
{
  typedef typename GraphOnComplex::Scalar Scalar;
  typedef typename GraphOnComplex::vertex_descriptor vertex_descriptor;
  typedef typename GraphOnComplex::node_descriptor node_descriptor;
  typedef typename GraphOnComplex::arc_descriptor arc_descriptor;
  typedef Arc_levels<GraphOnComplex> Levels;
  typedef typename Levels::Level Level;

public:
  typedef typename GraphOnComplex::Contour Contour;

  Arc_contours(const GraphOnComplex& on_complex, Ties ties) : on_complex_(on_complex), levels_(on_complex, ties) {}

  // The contour at a fraction of the values, or of the differences of another field, along the arc.
  template <class... ParametrizationMap>
  Contour at_parameter(arc_descriptor arc, double t, const ParametrizationMap&... parametrization) const
  {
    check_is_arc(on_complex_.graph(), arc);
    if(!(t > 0 && t < 1))
      throw Parameter_error(t);
    return trace(arc, levels_.at_parameter(arc, t, parametrization...));
  }

  Contour at_value(arc_descriptor arc, const Scalar& value) const
  {
    check_is_arc(on_complex_.graph(), arc);
    if(!levels_.is_alive_at(arc, value))
      throw Level_error();
    return trace(arc, levels_.at_value(value));
  }

  Contour below_vertex(arc_descriptor arc, vertex_descriptor v) const
  {
    return at_level(arc, levels_.below_vertex(checked_number(on_complex_, v)));
  }

  Contour above_vertex(arc_descriptor arc, vertex_descriptor v) const
  {
    return at_level(arc, levels_.above_vertex(checked_number(on_complex_, v)));
  }

  // The contours of all arcs at the level of the value.
  template <class ConcurrencyTag>
  std::vector<Contour> all_at_value(const Scalar& value) const
  {
    const Level level = levels_.at_value(value);
    std::vector<arc_descriptor> arcs;
    std::vector<decltype(find_start(arcs[0], level))> starts;
    for(const arc_descriptor arc : on_complex_.arcs())
    {
      if(levels_.is_alive_at(arc, value))
      {
        arcs.push_back(arc);
        starts.push_back(find_start(arc, level));
      }
    }
    std::vector<Contour> contours(arcs.size());
    for_each_index<ConcurrencyTag>(arcs.size(),
                                   [&](std::size_t i) { contours[i] = on_complex_.trace(arcs[i], starts[i], level); });
    return contours;
  }

  // The contours of all arcs below a node, or above it, next to the node, which has been checked.
  std::vector<Contour> all_below_node(node_descriptor node) const
  {
    return all_at_level(in_edges(node, on_complex_.graph()), levels_.below_node(node));
  }

  std::vector<Contour> all_above_node(node_descriptor node) const
  {
    return all_at_level(out_edges(node, on_complex_.graph()), levels_.above_node(node));
  }

private:
  auto find_start(arc_descriptor arc, const Level& level) const
  {
    return on_complex_.find_start(find_crossing(on_complex_, arc, level.is_below));
  }

  Contour trace(arc_descriptor arc, const Level& level) const
  {
    return on_complex_.trace(arc, find_start(arc, level), level);
  }

  Contour at_level(arc_descriptor arc, const Level& level) const
  {
    check_is_arc(on_complex_.graph(), arc);
    if(!levels_.is_alive_at(arc, level))
      throw Level_error();
    return trace(arc, level);
  }

  template <class ArcIteratorPair>
  std::vector<Contour> all_at_level(const ArcIteratorPair& arcs, const Level& level) const
  {
    std::vector<Contour> contours;
    for(const arc_descriptor arc : CGAL::make_range(arcs))
      contours.push_back(trace(arc, level));
    return contours;
  }

  const GraphOnComplex& on_complex_;
  const Levels levels_;
};

} // namespace internal
} // namespace Reeb_graph
} // namespace CGAL

#endif // CGAL_REEB_GRAPH_INTERNAL_AUGMENTATION_ARC_CONTOURS_H
