// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors

#ifndef CGAL_REEB_GRAPH_SIMPLIFICATION_SIMPLIFY_H
#define CGAL_REEB_GRAPH_SIMPLIFICATION_SIMPLIFY_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/internal/base/graph_requirements.h>
#include <CGAL/Reeb_graph/internal/graph/Leaf_pruning.h>
#include <CGAL/Reeb_graph/named_parameters.h>
#include <CGAL/Reeb_graph/simplification/Simplification.h>
#include <CGAL/Reeb_graph/simplification/internal/prune_graph.h>
#include <CGAL/Reeb_graph/simplification/internal/write_simplified_graph.h>

#include <boost/graph/graph_traits.hpp>

#include <memory>

namespace CGAL::Reeb_graph {

/// \ingroup PkgReebGraphSimplification
///
/// \brief a leaf of a Reeb graph with its arc, as `simplify()` sees it: the arc that can be made of several ones, and
/// all that has been removed from it.
///
/// \tparam NodeDescriptor the type of the nodes of the graph
template <class NodeDescriptor>
struct Branch
{
  NodeDescriptor leaf;   ///< the extremum
  NodeDescriptor saddle; ///< the other end of the arc
  bool is_minimum;       ///< whether the leaf is the lower end
  double persistence;    ///< the largest absolute difference between the value at the saddle and one in the branch
  double weight;         ///< the sum of the `place_weights` of the branch, 0 if there are none
};

/// \ingroup PkgReebGraphSimplification
///
/// \brief removes what is small from a Reeb graph: arcs that end in a leaf, and on request loops.
///
/// The leaf arc of least measure is removed; of several, the one whose leaf has the lowest number. If one arc below its
/// saddle and one above are left, they become one, which can be a leaf arc of a larger measure. So it goes on until no
/// measure is below the threshold. A leaf arc that is the only one on its side of the saddle is not a branch, as what
/// is left would end there. So a branch with a loop stays as long as the loop does. See \cgalCite{csp-sfilgm-04}.
///
/// The measure of a leaf arc is its persistence by default: the largest difference between the value of the saddle and
/// one in what would be removed. `simplify_field()` has to move a value that far. It is the difference between
/// the ends of the arc, unless an extremum beyond the leaf has been removed from it before. What has been removed is
/// not in the simplified graph: where such an extremum has kept a leaf arc, simplifying that graph again removes the
/// arc. With the difference between the ends as `branch_measure`, simplifying again changes nothing, but values of the
/// simplified field can change by more than the threshold.
///
/// The simplified graph is one of the same type. Its nodes are nodes of `graph` in the same order, but those of degree
/// two are never among them. Its arcs are sorted by lower node, upper node, and the first arc of `graph` that they are
/// made of. The chain of an arc consists of the chains of these arcs, one after the other; so an `Augmentation` finds the
/// contours of the branch that has been kept. A larger threshold gives a graph with nodes of that of a smaller one, and
/// no more.
///
/// With \f$ n \f$ nodes and arcs, it takes \f$ O(n \log n) \f$ time, and the same again each time that cancelled loops
/// have made new leaf arcs.
///
/// \tparam ReebGraph the type `Graph` of the traits class
/// \tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"
///
/// \param graph a Reeb graph, computed with any named parameters
/// \param threshold what is smaller is removed, in units of the measure; infinity if only `number_of_leaves` counts
/// \param simplified the result; whatever it held before is cleared
/// \param np an optional sequence of \ref bgl_namedparameters "Named Parameters" among the ones listed below
///
/// \cgalNamedParamsBegin
///   \cgalParamNBegin{number_of_leaves}
///     \cgalParamDescription{no more arcs are removed when this many leaves are left, nodes with a single arc}
///     \cgalParamType{`std::size_t`}
///     \cgalParamDefault{0}
///     \cgalParamExtra{use the function `parameters::number_of_leaves()`}
///   \cgalParamNEnd
///   \cgalParamNBegin{cancel_loops}
///     \cgalParamDescription{whether loops of a persistence below the threshold are removed, too: of the two sides of a
///                           loop one takes up the other. A loop stays while arcs that stay leave both of its sides.
///                           The measure of a loop is always its persistence. A field on the mesh has those that the
///                           surface asks for, so that `simplify_field()` throws an exception if it is asked to.}
///     \cgalParamType{`bool`}
///     \cgalParamDefault{`false`}
///     \cgalParamExtra{use the function `parameters::cancel_loops()`}
///   \cgalParamNEnd
///   \cgalParamNBegin{place_weights}
///     \cgalParamDescription{a number for each node, and then for each arc in the order of `edges(graph)`; see
///                           `areas_of_places()` and `vertex_counts_of_places()`. They are added up over all that is
///                           removed.}
///     \cgalParamType{a range of numbers}
///     \cgalParamDefault{none}
///     \cgalParamExtra{use the function `parameters::place_weights()`}
///   \cgalParamNEnd
///   \cgalParamNBegin{branch_measure}
///     \cgalParamDescription{how large a branch is}
///     \cgalParamType{a function object that is called with a `Reeb_graph::Branch` and returns a `double`}
///     \cgalParamDefault{`Branch::weight` if there are `place_weights`, else `Branch::persistence`}
///     \cgalParamExtra{use the function `parameters::branch_measure()`}
///   \cgalParamNEnd
///   \cgalParamNBegin{geom_traits}
///     \cgalParamDescription{an instance of a traits class whose `scalar_to_double_object()` makes numbers of the
///                           values. Values that are numbers need none if the order sorts them up or down:
///                           persistence is an absolute difference.}
///     \cgalParamType{a model of `ReebGraphNumberTraits`}
///     \cgalParamDefault{none: `CGAL::to_double()` of the values}
///   \cgalParamNEnd
/// \cgalNamedParamsEnd
///
/// \pre The threshold is neither negative nor NaN, and arcs lead to nodes of higher number.
///
/// \reebGraphComplexity
///
/// \returns for each node and arc of `graph` the node or arc of `simplified` that has taken it up.
///
/// \exception Reeb_graph::Parameter_error if the threshold is negative or NaN, if a measure or the number of a value is
///            NaN, or if there is not one weight for each node and each arc
/// \exception Reeb_graph::Graph_mismatch_error if an arc does not lead to a node of higher number
///
/// When one of these is thrown, `simplified` is as it was before.
template <class ReebGraph, class NamedParameters = parameters::Default_named_parameters>
Simplification<ReebGraph> simplify(const ReebGraph& graph,
                                   double threshold,
                                   ReebGraph& simplified,
                                   const NamedParameters& np = parameters::default_values())
{
  if constexpr(internal::Graph_of_numbers<ReebGraph, NamedParameters>::value)
  {
    if(std::addressof(graph) == std::addressof(simplified))
    {
      // NOLINTNEXTLINE(performance-unnecessary-copy-initialization): `simplified` is the same graph
      const ReebGraph copy(graph);
      return simplify(copy, threshold, simplified, np);
    }
    typedef Branch<typename boost::graph_traits<ReebGraph>::vertex_descriptor> Branch;
    const internal::Leaf_pruning pruned = internal::prune_graph<Branch>(graph, threshold, np);
    return internal::write_simplified_graph(graph, pruned, simplified);
  }
  else
    return Simplification<ReebGraph>(0, 0, {}, {});
}

} // namespace CGAL::Reeb_graph

#endif // CGAL_REEB_GRAPH_SIMPLIFICATION_SIMPLIFY_H
