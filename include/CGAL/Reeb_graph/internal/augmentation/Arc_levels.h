// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of the CGAL-style package Reeb_graph.
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_INTERNAL_AUGMENTATION_ARC_LEVELS_H
#define CGAL_REEB_GRAPH_INTERNAL_AUGMENTATION_ARC_LEVELS_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/exceptions.h>
#include <CGAL/Reeb_graph/internal/base/crossing_fraction.h>
#include <CGAL/Reeb_graph/internal/mesh/mesh_indices.h>
#include <CGAL/Reeb_graph/internal/walks/Level.h>
#include <CGAL/Reeb_graph/options.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <type_traits>
#include <vector>

namespace CGAL {
namespace Reeb_graph {
namespace internal {

// The levels at which contours are asked for: those of values, next to nodes, and of parameters along arcs.
template <class GraphOnMesh>
class Arc_levels
{
  typedef typename GraphOnMesh::Scalar Scalar;
  typedef typename GraphOnMesh::Order Order;
  typedef typename GraphOnMesh::node_descriptor node_descriptor;
  typedef typename GraphOnMesh::arc_descriptor arc_descriptor;
  typedef internal::Level<Scalar, Order> Is_below;

public:
  // A level with its value.
  struct Level
  {
    Is_below is_below;
    double value;
  };

  Arc_levels(const GraphOnMesh& on_mesh, Ties ties)
    : on_mesh_(on_mesh),
      order_(on_mesh.order()),
      are_ties_contracted_(ties == Ties::CONTRACT)
  {}

  // Whether the level of the value crosses the arc.
  bool is_alive_at(arc_descriptor arc, const Scalar& value) const
  {
    return !order_.is_higher(on_mesh_.lower_vertex(arc), value) && order_.is_higher(on_mesh_.upper_vertex(arc), value);
  }

  // Whether the level crosses the arc.
  bool is_alive_at(arc_descriptor arc, const Level& level) const
  {
    const Is_below& is_below = level.is_below;
    return is_below(on_mesh_.lower_vertex(arc)) && !is_below(on_mesh_.upper_vertex(arc));
  }

  Level at_value(const Scalar& value) const
  {
    return {Is_below::above_value(order_, value), on_mesh_.conversion().to_double(value)};
  }

  Level below_node(node_descriptor node) const { return below_vertex(on_mesh_.node_vertex(node)); }

  Level below_vertex(Vertex_index v) const
  {
    return {are_ties_contracted_ ? Is_below::below_value(order_, on_mesh_.scalar(v))
                                 : Is_below::below_vertex(order_, v),
            on_mesh_.value(v)};
  }

  Level above_node(node_descriptor node) const { return above_vertex(on_mesh_.node_vertex(node)); }

  Level above_vertex(Vertex_index v) const
  {
    return {are_ties_contracted_ ? Is_below::above_value(order_, on_mesh_.scalar(v))
                                 : Is_below::above_vertex(order_, v),
            on_mesh_.value(v)};
  }

  // The level at the fraction t of the values along the arc.
  Level at_parameter(arc_descriptor arc, double t) const
  {
    const double lower = on_mesh_.value(on_mesh_.lower_vertex(arc)), upper = on_mesh_.value(on_mesh_.upper_vertex(arc));
    const auto& chain = on_mesh_.chain(arc);
    const std::size_t step = (std::min)(static_cast<std::size_t>(t * chain.size()), chain.size() - 1);
    return between(arc, value_at_fraction(lower, upper, t), on_mesh_.source_of(chain[step]));
  }

  // The level at the fraction t of the differences of another field, summed up along the chain.
  template <class ParametrizationMap>
  Level at_parameter(arc_descriptor arc, double t, const ParametrizationMap& parametrization) const
  {
    const auto& chain = on_mesh_.chain(arc);
    const double scale = 0.5 / static_cast<double>(chain.size()); // so that no sum is infinite
    const auto scaled_value = [&](Vertex_index v) {
      const double value = static_cast<double>(get(parametrization, on_mesh_.vertex(v)));
      if(!std::isfinite(value))
        throw Non_finite_scalar_error(on_mesh_.position(v));
      return scale * value;
    };
    std::vector<double> sums = {0};
    for(std::size_t i = 0; i != chain.size(); ++i)
    {
      const double difference = scaled_value(on_mesh_.target_of(chain[i])) - scaled_value(on_mesh_.source_of(chain[i]));
      sums.push_back(sums.back() + std::abs(difference) * used_fraction(arc, i));
    }
    const double sum = t * sums.back();
    if(!(sum > 0))
      return at_parameter(arc, t);
    const std::size_t step =
      (std::min)(std::size_t(std::lower_bound(sums.begin() + 1, sums.end(), sum) - sums.begin()), chain.size()) - 1;
    const double fraction = used_fraction(arc, step) * (sum - sums[step]) / (sums[step + 1] - sums[step]);
    const Vertex_index from = on_mesh_.source_of(chain[step]), to = on_mesh_.target_of(chain[step]);
    return between(arc, value_at_fraction(on_mesh_.value(from), on_mesh_.value(to), fraction), from);
  }

private:
  // The level of the value, if that is inside the arc. If it has been rounded up to the upper end, it is the last level
  // of lower values; if values do not tell, because they are tied or infinite, it is next to a vertex of the chain.
  // With another order than that of numbers, values can fall along an arc.
  Level between(arc_descriptor arc, double value, Vertex_index chain_vertex) const
  {
    const Vertex_index upper = on_mesh_.upper_vertex(arc);
    const double lower_end = on_mesh_.value(on_mesh_.lower_vertex(arc)), upper_end = on_mesh_.value(upper);
    const bool is_falling = upper_end < lower_end;
    const bool is_rounded_up = is_falling ? value <= upper_end : value >= upper_end;
    if(!is_rounded_up && (is_falling ? value <= lower_end : value >= lower_end))
    {
      // For integers, the vertices below 2.5 are those below 2.
      const auto scalar = on_mesh_.conversion().from_double(value, is_falling);
      if(scalar && is_alive_at(arc, *scalar))
        return {Is_below::above_value(order_, *scalar), value};
    }
    const Scalar& upper_value = on_mesh_.scalar(upper);
    const bool is_chain_vertex_lower = order_.is_lower(chain_vertex, upper_value);
    if(is_chain_vertex_lower ? is_rounded_up && std::isfinite(value) : are_ties_contracted_)
      return {Is_below::below_value(order_, upper_value), upper_end};
    return above_vertex(chain_vertex);
  }

  // The part of halfedge i of the chain that is used: that below the upper node, and below the next piece of the chain,
  // as the last halfedge of a piece overshoots.
  double used_fraction(arc_descriptor arc, std::size_t i) const
  {
    const auto& chain = on_mesh_.chain(arc);
    const Vertex_index end = i + 1 == chain.size() ? on_mesh_.upper_vertex(arc) : on_mesh_.source_of(chain[i + 1]);
    const bool is_all_used = end == on_mesh_.target_of(chain[i]);
    return is_all_used ? 1 : crossing_fraction(on_mesh_, chain[i], on_mesh_.value(end));
  }

  const GraphOnMesh& on_mesh_;
  const Order& order_;
  const bool are_ties_contracted_;
};

} // namespace internal
} // namespace Reeb_graph
} // namespace CGAL

#endif // CGAL_REEB_GRAPH_INTERNAL_AUGMENTATION_ARC_LEVELS_H
