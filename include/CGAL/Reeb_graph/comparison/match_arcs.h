// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_COMPARISON_MATCH_ARCS_H
#define CGAL_REEB_GRAPH_COMPARISON_MATCH_ARCS_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/Augmentation.h>
#include <CGAL/Reeb_graph/arc_measures.h>
#include <CGAL/Reeb_graph/exceptions.h>
#include <CGAL/Reeb_graph/named_parameters.h>

#include <CGAL/boost/graph/iterator.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <limits>
#include <numeric>
#include <utility>
#include <vector>

namespace CGAL::Reeb_graph {

/// \ingroup PkgReebGraphExceptions
///
/// \brief thrown for a graph with more than 300 arcs by `match_arcs()`, whose time is cubic: `simplify()` it first.
class Too_many_arcs_error : public Error
{
public:
  /// constructs the exception for a graph with `number` arcs.
  explicit Too_many_arcs_error(std::size_t number)
    : Error(message("a graph has ", number, " arcs, and arcs are matched among 300 at most: simplify it first"))
  {}
};

namespace internal {

constexpr std::size_t most_matched_arcs = 300;

// An arc as another one is compared with it: nothing depends on the units of field and mesh.
struct Compared_arc
{
  bool is_lower_end_leaf, is_upper_end_leaf;
  double lower, upper; // the values of its ends, in parts of the range of the field
  double length;       // in parts of the lengths of all arcs
  double root_of_area; // of its part of the area of the surface

  // The price of being partners. Sums of differences are often the same whoever is whose partner: squares tell them apart.
  static double price(const Compared_arc& a, const Compared_arc& b)
  {
    const int ends = int(a.is_lower_end_leaf != b.is_lower_end_leaf) + int(a.is_upper_end_leaf != b.is_upper_end_leaf);
    const auto difference = [](double x, double y) { return std::abs(x - y) + 1e-6 * (x - y) * (x - y); };
    return 0.5 * ends + difference(a.lower, b.lower) + difference(a.upper, b.upper)
         + 0.5 * (difference(a.length, b.length) + difference(a.root_of_area, b.root_of_area));
  }
};

// The part of a number in a sum, which may be 0.
inline double part_of(double number, double sum) { return sum > 0 ? number / sum : 0; }

// The arcs of a graph in their order.
template <class GraphOnMesh>
std::vector<Compared_arc> compared_arcs(const typename GraphOnMesh::Graph& graph,
                                        const Basic_augmentation<GraphOnMesh>& augmentation)
{
  if(num_edges(graph) > most_matched_arcs)
    throw Too_many_arcs_error(num_edges(graph));
  const std::vector<double> lengths = arc_lengths(augmentation),
                            areas = shares_of_arcs(augmentation, augmentation.locate_vertices());
  const double length = std::accumulate(lengths.begin(), lengths.end(), 0.),
               area = std::accumulate(areas.begin(), areas.end(), 0.);
  std::vector<Compared_arc> arcs;
  if(num_edges(graph) == 0)
    return arcs;
  const auto value = [&](const auto node) { return augmentation.value(graph[node].vertex); };
  const auto [lowest, highest] = std::minmax_element(vertices(graph).first, vertices(graph).second,
                                                     [&](auto a, auto b) { return value(a) < value(b); });
  const double least = value(*lowest), range = value(*highest) - least;
  if(!std::isfinite(range))
    throw Parameter_error("the range of the field is not finite");
  for(const auto arc : CGAL::make_range(edges(graph)))
  {
    const auto lower = source(arc, graph), upper = target(arc, graph);
    const std::size_t i = arcs.size();
    arcs.push_back({degree(lower, graph) == 1, degree(upper, graph) == 1, part_of(value(lower) - least, range),
                    part_of(value(upper) - least, range), part_of(lengths[i], length),
                    std::sqrt(part_of(areas[i], area))});
  }
  return arcs;
}

// For each row of a square matrix of prices a column, such that the sum of the prices is least: the Hungarian method
// (H. W. Kuhn 1955), by shortest augmenting paths. `price` is called with a row and a column.
template <class Price>
std::vector<std::size_t> assign(std::size_t size, const Price& price)
{
  // numbered from 1, so that 0 is none, and the column 0 is where each path begins
  std::vector<double> row_potential(size + 1, 0), column_potential(size + 1, 0);
  std::vector<std::size_t> row_of(size + 1, 0), before(size + 1);
  for(std::size_t row = 1; row <= size; ++row)
  {
    std::vector<double> distance(size + 1, std::numeric_limits<double>::infinity());
    std::vector<std::size_t> reached, others(size);
    std::iota(others.begin(), others.end(), std::size_t(1));
    std::size_t column = 0;
    distance[0] = 0;
    for(row_of[0] = row; row_of[column] != 0;)
    {
      reached.push_back(column);
      for(const std::size_t j : others)
      {
        const double reduced = price(row_of[column] - 1, j - 1) - row_potential[row_of[column]] - column_potential[j];
        if(distance[column] + reduced < distance[j])
        {
          distance[j] = distance[column] + reduced;
          before[j] = column;
        }
      }
      const auto nearest = std::min_element(others.begin(), others.end(),
                                            [&](std::size_t i, std::size_t j) { return distance[i] < distance[j]; });
      column = *nearest;
      others.erase(nearest);
    }
    for(const std::size_t j : reached)
    {
      row_potential[row_of[j]] += distance[column] - distance[j];
      column_potential[j] -= distance[column] - distance[j];
    }
    for(; column != 0; column = before[column])
      row_of[column] = row_of[before[column]];
  }
  std::vector<std::size_t> result(size);
  for(std::size_t j = 1; j <= size; ++j)
    result[row_of[j] - 1] = j - 1;
  return result;
}

struct Matched_arcs
{
  std::vector<std::size_t> partners; // by arc of the one, its partner among those of the other, or their number
  double price;                      // of all
};

// Each arc may stay alone for a price. One that is more than partners cost in all tells no more than that, but is rounded.
inline Matched_arcs match(const std::vector<Compared_arc>& a, const std::vector<Compared_arc>& b, double price_alone)
{
  price_alone = (std::min)(price_alone, 4. * most_matched_arcs);
  const auto price = [&](std::size_t i, std::size_t j) {
    if(i < a.size() && j < b.size())
      return Compared_arc::price(a[i], b[j]);
    return i < a.size() || j < b.size() ? price_alone : 0.;
  };
  Matched_arcs result = {assign(a.size() + b.size(), price), 0};
  for(std::size_t i = 0; i != result.partners.size(); ++i)
    result.price += price(i, result.partners[i]);
  result.partners.resize(a.size());
  for(std::size_t& partner : result.partners)
    partner = (std::min)(partner, b.size());
  return result;
}

} // namespace internal

/// \ingroup PkgReebGraphComparison
///
/// \brief finds which arcs of two simplified graphs stand for the same part of two shapes, as the limbs of two bodies.
///
/// Arcs are assigned to each other one to one, or to none, so that the sum of prices is least. The price of two arcs adds
/// up how they differ:
///
/// - one half for each end that is a leaf in one of them only,
/// - the differences of their lower and of their upper values, in parts of the range of the field,
/// - half of the difference of their lengths, in parts of the lengths of all arcs,
/// - half of the difference of the roots of their areas, in parts of the whole area,
/// - and a millionth of the squares of these differences, with the same weights, as sums of differences are often equal.
///
/// So nothing depends on units, or on the order of vertices. An arc that stays alone has the price `price_alone`, so arcs
/// are no partners that differ by more than twice of it.
///
/// A field has to mean the same on both shapes, as geodesic distances from the same place do. Then prices say which limbs
/// are alike, but not which one of two equal arms is the left one.
///
/// With \f$ n \f$ arcs of both graphs, it takes \f$ O(n^3) \f$ time, and that of locating vertices.
///
/// \tparam GraphOnMeshA, GraphOnMeshB what the augmentations are of; those of tetrahedra have volumes, and are none
/// \tparam OutputIterator a model of `OutputIterator` for pairs of an arc of `graph_a` and one of `graph_b`
///
/// \param graph_a a Reeb graph, mostly a simplified one
/// \param augmentation_a the augmentation of this graph; for a simplified one, with `simplification`
/// \param graph_b another graph
/// \param augmentation_b its augmentation
/// \param partners the output: the arcs that are partners, in the order of those of `graph_a`
/// \param np an optional sequence of \ref bgl_namedparameters "Named Parameters" among the ones listed below
///
/// \cgalNamedParamsBegin
///   \cgalParamNBegin{price_alone}
///     \cgalParamDescription{the price of an arc that has no partner}
///     \cgalParamType{`double`, not negative; with infinity, as many arcs as can be have partners}
///     \cgalParamDefault{1}
///     \cgalParamExtra{use the function `parameters::price_alone()`}
///   \cgalParamNEnd
/// \cgalNamedParamsEnd
///
/// \returns the output iterator behind the last pair.
///
/// \exception Reeb_graph::Too_many_arcs_error if a graph has more than 300 arcs
/// \exception Reeb_graph::Parameter_error if `price_alone` is negative or NaN, or if the range of a field is not finite
template <class GraphOnMeshA,
          class GraphOnMeshB,
          class OutputIterator,
          class NamedParameters = parameters::Default_named_parameters>
OutputIterator match_arcs(const typename GraphOnMeshA::Graph& graph_a,
                          const Basic_augmentation<GraphOnMeshA>& augmentation_a,
                          const typename GraphOnMeshB::Graph& graph_b,
                          const Basic_augmentation<GraphOnMeshB>& augmentation_b,
                          OutputIterator partners,
                          const NamedParameters& np = parameters::default_values())
{
  const double price_alone = internal::parameter_or(np, internal::price_alone, 1.);
  if(!(price_alone >= 0))
    throw Parameter_error("price_alone is not a number from 0");
  const std::vector<std::size_t> found = internal::match(internal::compared_arcs(graph_a, augmentation_a),
                                                         internal::compared_arcs(graph_b, augmentation_b), price_alone)
                                           .partners;
  std::size_t i = 0;
  for(const auto arc : CGAL::make_range(edges(graph_a)))
    if(const std::size_t partner = found[i++]; partner != num_edges(graph_b))
      *partners++ = std::make_pair(arc, *std::next(edges(graph_b).first, static_cast<std::ptrdiff_t>(partner)));
  return partners;
}

} // namespace CGAL::Reeb_graph

#endif // CGAL_REEB_GRAPH_COMPARISON_MATCH_ARCS_H
