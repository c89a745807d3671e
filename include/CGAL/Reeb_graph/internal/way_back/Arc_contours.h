// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_INTERNAL_WAY_BACK_ARC_CONTOURS_H
#define CGAL_REEB_GRAPH_INTERNAL_WAY_BACK_ARC_CONTOURS_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/exceptions.h>
#include <CGAL/Reeb_graph/internal/base/Index.h>
#include <CGAL/Reeb_graph/internal/base/parallel.h>
#include <CGAL/Reeb_graph/internal/base/scalars.h>
#include <CGAL/Reeb_graph/internal/complex/Vertex_order.h>
#include <CGAL/Reeb_graph/internal/way_back/locate_vertices.h>
#include <CGAL/Reeb_graph/options.h>

#include <CGAL/boost/graph/iterator.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

namespace CGAL::Reeb_graph::internal {

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

// The contours of arcs at levels that cross their chains, and whether they do: what an augmentation is asked for. Levels
// are those of values, those next to nodes and vertices, and those of parameters along arcs.
template <class GraphOnComplex>
class Arc_contours
{
  typedef typename GraphOnComplex::Scalar Scalar;
  typedef typename GraphOnComplex::Order Order;
  typedef typename GraphOnComplex::vertex_descriptor vertex_descriptor;
  typedef typename GraphOnComplex::node_descriptor node_descriptor;
  typedef typename GraphOnComplex::arc_descriptor arc_descriptor;
  typedef internal::Level<Scalar, Order> Is_below;

public:
  typedef typename GraphOnComplex::Contour Contour;

  Arc_contours(const GraphOnComplex& on_complex, Ties ties)
    : on_complex_(on_complex),
      order_(on_complex.order()),
      are_ties_contracted_(ties == Ties::CONTRACT)
  {}

  // The contour at a fraction of the values, or of the differences of another field, along the arc.
  template <class... ParametrizationMap>
  Contour at_parameter(arc_descriptor arc, double t, const ParametrizationMap&... parametrization) const
  {
    check_is_arc(on_complex_.graph(), arc);
    if(!(t > 0 && t < 1))
      throw Parameter_error("the place on an arc must be greater than 0 and less than 1, not " + std::to_string(t));
    return trace(arc, level_at_parameter(arc, t, parametrization...));
  }

  Contour at_value(arc_descriptor arc, const Scalar& value) const
  {
    check_is_arc(on_complex_.graph(), arc);
    if(!is_alive_at(arc, value))
      throw Parameter_error("the arc has no contour at this level");
    return trace(arc, level_at_value(value));
  }

  // Just below the vertex, or just above it.
  Contour beside_vertex(Side side, arc_descriptor arc, vertex_descriptor v) const
  {
    const Level level = level_beside(side, checked_number(on_complex_, v));
    check_is_arc(on_complex_.graph(), arc);
    if(!level.is_below(on_complex_.lower_vertex(arc)) || level.is_below(on_complex_.upper_vertex(arc)))
      throw Parameter_error("the arc has no contour at this level");
    return trace(arc, level);
  }

  // The contours of all arcs at the level of the value.
  template <class ConcurrencyTag>
  std::vector<Contour> all_at_value(const Scalar& value) const
  {
    const Level level = level_at_value(value);
    std::vector<arc_descriptor> arcs;
    std::vector<decltype(find_start(arcs[0], level))> starts;
    for(const arc_descriptor arc : on_complex_.arcs())
    {
      if(is_alive_at(arc, value))
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

  // The contours of some arcs next to their node, just below or just above it.
  template <class ArcIteratorPair>
  std::vector<Contour> all_beside_node(Side side, node_descriptor node, const ArcIteratorPair& arcs) const
  {
    const Level level = level_beside(side, on_complex_.node_vertex(node));
    std::vector<Contour> contours;
    for(const arc_descriptor arc : CGAL::make_range(arcs))
      contours.push_back(trace(arc, level));
    return contours;
  }

private:
  // A level with its value.
  struct Level
  {
    Is_below is_below;
    double value;
  };

  auto find_start(arc_descriptor arc, const Level& level) const
  {
    return on_complex_.find_start(find_crossing(on_complex_, arc, level.is_below));
  }

  Contour trace(arc_descriptor arc, const Level& level) const
  {
    return on_complex_.trace(arc, find_start(arc, level), level);
  }

  // Whether the level of the value crosses the arc.
  bool is_alive_at(arc_descriptor arc, const Scalar& value) const
  {
    return !order_.is_higher(on_complex_.lower_vertex(arc), value)
        && order_.is_higher(on_complex_.upper_vertex(arc), value);
  }

  Level level_at_value(const Scalar& value) const
  {
    return {Is_below(order_, Side::UPPER, value), on_complex_.conversion().to_double(value)};
  }

  Level level_beside(Side side, Vertex_index v) const
  {
    return {are_ties_contracted_ ? Is_below(order_, side, on_complex_.scalar(v)) : Is_below(order_, side, v),
            on_complex_.value(v)};
  }

  // The level at the fraction t of the values along the arc.
  Level level_at_parameter(arc_descriptor arc, double t) const
  {
    const double lower = on_complex_.value(on_complex_.lower_vertex(arc)),
                 upper = on_complex_.value(on_complex_.upper_vertex(arc));
    const auto& chain = on_complex_.chain(arc);
    const std::size_t step =
      (std::min)(static_cast<std::size_t>(t * static_cast<double>(chain.size())), chain.size() - 1);
    return between(arc, value_at_fraction(lower, upper, t), on_complex_.source_of(chain[step]));
  }

  // The level at the fraction t of the differences of another field, summed up along the chain.
  template <class ParametrizationMap>
  Level level_at_parameter(arc_descriptor arc, double t, const ParametrizationMap& parametrization) const
  {
    const auto& chain = on_complex_.chain(arc);
    const double scale = 0.5 / static_cast<double>(chain.size()); // so that no sum is infinite
    const auto scaled_value = [&](Vertex_index v) {
      const double value = static_cast<double>(get(parametrization, on_complex_.vertex(v)));
      if(!std::isfinite(value))
        throw Non_finite_scalar_error(on_complex_.position(v));
      return scale * value;
    };
    std::vector<double> sums = {0};
    for(std::size_t i = 0; i != chain.size(); ++i)
    {
      const double difference =
        scaled_value(on_complex_.target_of(chain[i])) - scaled_value(on_complex_.source_of(chain[i]));
      sums.push_back(sums.back() + std::abs(difference) * used_fraction(arc, i));
    }
    const double sum = t * sums.back();
    if(!(sum > 0))
      return level_at_parameter(arc, t);
    const std::size_t step =
      (std::min)(std::size_t(std::lower_bound(sums.begin() + 1, sums.end(), sum) - sums.begin()), chain.size()) - 1;
    const double fraction = used_fraction(arc, step) * (sum - sums[step]) / (sums[step + 1] - sums[step]);
    const Vertex_index from = on_complex_.source_of(chain[step]), to = on_complex_.target_of(chain[step]);
    return between(arc, value_at_fraction(on_complex_.value(from), on_complex_.value(to), fraction), from);
  }

  // The level of the value, if that is inside the arc. If it has been rounded up to the upper end, it is the last level
  // of lower values; if values do not tell, because they are tied or infinite, it is next to a vertex of the chain.
  // With another order than that of numbers, values can fall along an arc.
  Level between(arc_descriptor arc, double value, Vertex_index chain_vertex) const
  {
    const Vertex_index upper = on_complex_.upper_vertex(arc);
    const double lower_end = on_complex_.value(on_complex_.lower_vertex(arc)), upper_end = on_complex_.value(upper);
    const bool is_falling = upper_end < lower_end;
    const bool is_rounded_up = is_falling ? value <= upper_end : value >= upper_end;
    if(!is_rounded_up && (is_falling ? value <= lower_end : value >= lower_end))
    {
      // For integers, the vertices below 2.5 are those below 2.
      const auto scalar = on_complex_.conversion().from_double(value, is_falling);
      if(scalar && is_alive_at(arc, *scalar))
        return {Is_below(order_, Side::UPPER, *scalar), value};
    }
    const Scalar& upper_value = on_complex_.scalar(upper);
    const bool is_chain_vertex_lower = order_.is_lower(chain_vertex, upper_value);
    if(is_chain_vertex_lower ? is_rounded_up && std::isfinite(value) : are_ties_contracted_)
      return {Is_below(order_, Side::LOWER, upper_value), upper_end};
    return level_beside(Side::UPPER, chain_vertex);
  }

  // The part of halfedge i of the chain that is used: that below the upper node, and below the next piece of the chain,
  // as the last halfedge of a piece overshoots.
  double used_fraction(arc_descriptor arc, std::size_t i) const
  {
    const auto& chain = on_complex_.chain(arc);
    const Vertex_index end =
      i + 1 == chain.size() ? on_complex_.upper_vertex(arc) : on_complex_.source_of(chain[i + 1]);
    const bool is_all_used = end == on_complex_.target_of(chain[i]);
    return is_all_used ? 1 : crossing_fraction(on_complex_, chain[i], on_complex_.value(end));
  }

  const GraphOnComplex& on_complex_;
  const Order& order_;
  const bool are_ties_contracted_;
};

} // namespace CGAL::Reeb_graph::internal

#endif // CGAL_REEB_GRAPH_INTERNAL_WAY_BACK_ARC_CONTOURS_H
