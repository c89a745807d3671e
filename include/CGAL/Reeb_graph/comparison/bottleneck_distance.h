// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_COMPARISON_BOTTLENECK_DISTANCE_H
#define CGAL_REEB_GRAPH_COMPARISON_BOTTLENECK_DISTANCE_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/exceptions.h>
#include <CGAL/Reeb_graph/internal/base/Scalar_conversion.h>
#include <CGAL/Reeb_graph/internal/graph/graph_loops.h>
#include <CGAL/Reeb_graph/named_parameters.h>
#include <CGAL/Reeb_graph/simplification/persistence_pairs.h>

#include <boost/graph/graph_traits.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <iterator>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL::Reeb_graph {

/// \ingroup PkgReebGraphComparison
///
/// \brief the values of the two nodes of a persistence pair, and what it stands for.
struct Persistence_values
{
  double lower;               ///< the value of the lower node
  double upper;               ///< the value of the upper node
  Persistence_pair_kind kind; ///< what the pair stands for
};

namespace internal {

typedef std::vector<Persistence_values> Pairs_of_one_kind; // sorted by lower values

inline bool is_near(double x, double y, double distance) { return persistence(x, y) <= distance; }

inline std::size_t first_near(const Pairs_of_one_kind& pairs, double lower, double distance)
{
  return static_cast<std::size_t>(
    std::partition_point(pairs.begin(), pairs.end(),
                         [&](const auto& p) { return p.lower < lower && !is_near(p.lower, lower, distance); })
    - pairs.begin());
}

// Whether different pairs of `to` can be found for all pairs of `from` that are too far from the diagonal. Where that
// is so in both directions, one assignment covers the pairs of both sides: the theorem of Mendelsohn and Dulmage.
inline bool can_be_covered(const Pairs_of_one_kind& from, const Pairs_of_one_kind& to, double distance)
{
  const std::size_t none = from.size();
  std::vector<std::size_t> partner(to.size(), none), reached_by(to.size(), none), reached_from(to.size());
  std::vector<std::size_t> own(from.size(), to.size()), queue;
  for(std::size_t i = 0; i != from.size(); ++i)
  {
    if(persistence(from[i].lower, from[i].upper) / 2 <= distance)
      continue;
    std::size_t end = to.size(); // of a path on which partners change, if there is one
    queue.assign(1, i);
    for(std::size_t k = 0; k != queue.size() && end == to.size(); ++k)
    {
      const Persistence_values& pair = from[queue[k]];
      for(std::size_t j = first_near(to, pair.lower, distance);
          j != to.size() && end == to.size() && is_near(pair.lower, to[j].lower, distance); ++j)
        if(reached_by[j] != i && is_near(pair.upper, to[j].upper, distance))
        {
          reached_by[j] = i;
          reached_from[j] = queue[k];
          if(partner[j] == none)
            end = j;
          else
            queue.push_back(partner[j]);
        }
    }
    if(end == to.size())
      return false;
    while(end != to.size())
    {
      const std::size_t changed = partner[end] = reached_from[end];
      end = std::exchange(own[changed], end);
    }
  }
  return true;
}

// How far the values of the pairs of one kind of a graph have to move to be those of another one. A pair may also move to the diagonal,
// where its two values are the same, by half of its persistence. The bits of a number that is not negative are in its order: so the
// least one is found exactly. Everything can be covered from an infinite distance.
inline double distance_of_kind(const Pairs_of_one_kind& a, const Pairs_of_one_kind& b)
{
  double distance = std::numeric_limits<double>::infinity();
  std::uint64_t low = 0, high = 0;
  for(std::memcpy(&high, &distance, sizeof high); low < high;)
  {
    const std::uint64_t middle = low + (high - low) / 2;
    std::memcpy(&distance, &middle, sizeof distance);
    if(can_be_covered(a, b, distance) && can_be_covered(b, a, distance))
      high = middle;
    else
      low = middle + 1;
  }
  std::memcpy(&distance, &low, sizeof distance);
  return distance;
}

// The pairs of a kind. Those without persistence lie on the diagonal. Which value is the lower one makes no difference: it is that of
// a tip, if there is one, as pairs are looked for by it, and all of them can be of one saddle.
template <class PairRange>
Pairs_of_one_kind pairs_of_kind(const PairRange& pairs, Persistence_pair_kind kind)
{
  Pairs_of_one_kind result;
  for(const Persistence_values& pair : pairs)
  {
    if(std::isnan(pair.lower) || std::isnan(pair.upper))
      throw Parameter_error("a value of a persistence pair is NaN");
    if(pair.kind != kind || pair.lower == pair.upper)
      continue;
    result.push_back(pair);
    if(kind == Persistence_pair_kind::SADDLE_MAXIMUM)
      std::swap(result.back().lower, result.back().upper);
  }
  std::sort(result.begin(), result.end(), [](const auto& p, const auto& q) { return p.lower < q.lower; });
  return result;
}

} // namespace internal

/// \addtogroup PkgReebGraphComparison
/// @{

/// \brief finds the pairs of the extended persistence of a Reeb graph, as `persistence_pairs()` does, with their values.
///
/// \tparam ReebGraph the type `Graph` of the traits class, or another graph that `persistence_pairs()` takes
/// \tparam OutputIterator a model of `OutputIterator` for `Persistence_values`
///
/// \param graph a Reeb graph that has not been simplified
/// \param values the output, in the order of `persistence_pairs()`
/// \param np an optional sequence of \ref bgl_namedparameters "Named Parameters": `geom_traits`, as for `simplify()`
///
/// \reebGraphComplexity
///
/// \returns the output iterator behind the last pair.
///
/// \exception Reeb_graph::Graph_mismatch_error if an arc does not lead to a node of higher number
template <class ReebGraph, class OutputIterator, class NamedParameters = parameters::Default_named_parameters>
OutputIterator persistence_values(const ReebGraph& graph,
                                  OutputIterator values,
                                  const NamedParameters& np = parameters::default_values())
{
  static_assert(internal::are_met<internal::Nodes_have_numbers<ReebGraph, NamedParameters>>);
  std::vector<Persistence_pair<typename boost::graph_traits<ReebGraph>::vertex_descriptor>> pairs;
  persistence_pairs(graph, std::back_inserter(pairs));
  const auto conversion = internal::choose_conversion_of_nodes<ReebGraph>(np);
  const auto value = [&](const auto node) { return conversion.to_double(graph[node].value); };
  return std::transform(pairs.begin(), pairs.end(), values, [&](const auto& pair) {
    return Persistence_values{value(pair.lower_node), value(pair.upper_node), pair.kind};
  });
}

/// \brief returns how far two shapes are from each other, seen by a field on each: the bottleneck distance of the pairs
/// of their extended persistence.
///
/// Pairs of one kind are assigned to pairs of that kind, one to one, or to nothing. What a value has to move is the price
/// of an assignment, and half of the persistence is the price of none. The result is the least price such that no pair
/// has a greater one, over all assignments and kinds, in the unit of the fields.
///
/// It is a pseudometric: symmetric, with the triangle inequality, and 0 for the same graph. For two fields on one mesh it
/// is at most the greatest difference of their values at a vertex \cgalCite{ceh-spd-07}. So it is as stable as the
/// fields are. Shapes that differ can have the distance 0, as the pairs do not say what hangs on what.
///
/// With \f$ n \f$ pairs, it takes \f$ O(n \log n) \f$ time if few others are as near as the distance, as where smooth fields
/// have some noise; about quadratic time, seconds for 30,000 pairs, for fields of noise alone; and \f$ O(n^3) \f$ at worst.
///
/// \tparam PairRangeA, PairRangeB models of `Range` whose values are `Persistence_values`
///
/// \param pairs_a the pairs of a graph that has not been simplified; see `persistence_values()`
/// \param pairs_b those of another one
///
/// \exception Reeb_graph::Parameter_error if a value is NaN
template <class PairRangeA, class PairRangeB>
double bottleneck_distance(const PairRangeA& pairs_a, const PairRangeB& pairs_b)
{
  double distance = 0;
  for(const Persistence_pair_kind kind : {Persistence_pair_kind::MINIMUM_SADDLE, Persistence_pair_kind::SADDLE_MAXIMUM,
                                          Persistence_pair_kind::MINIMUM_MAXIMUM, Persistence_pair_kind::LOOP})
    distance = (std::max)(distance, internal::distance_of_kind(internal::pairs_of_kind(pairs_a, kind),
                                                               internal::pairs_of_kind(pairs_b, kind)));
  return distance;
}

/// @}

} // namespace CGAL::Reeb_graph

#endif // CGAL_REEB_GRAPH_COMPARISON_BOTTLENECK_DISTANCE_H
