// Copyright (c) 2026  The Reeb_graph authors.  All rights reserved.
//
// This file is part of Reeb_graph, a package for CGAL (www.cgal.org).
//
// SPDX-License-Identifier: GPL-3.0-or-later OR LicenseRef-Commercial
//
// Author(s)     : The Reeb_graph authors
#ifndef CGAL_REEB_GRAPH_SKELETON_MEASURE_BRANCHES_H
#define CGAL_REEB_GRAPH_SKELETON_MEASURE_BRANCHES_H

#include <CGAL/license/Reeb_graph.h>

#include <CGAL/Reeb_graph/internal/base/lengths.h>
#include <CGAL/Reeb_graph/skeleton/Curve_skeleton.h>
#include <CGAL/Reeb_graph/skeleton/skeleton_trees.h>

#include <CGAL/boost/graph/iterator.h>
#include <CGAL/number_utils.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL::Reeb_graph {

/// \addtogroup PkgReebGraphSkeleton
/// @{

/// \brief what is measured of an arc of a curve skeleton, as a branch of a tree.
struct Skeleton_branch
{
  /// no branch
  static constexpr std::size_t none = Skeleton_record::none;

  std::size_t component = 0;       ///< the number of its tree
  std::size_t parent = none;       ///< the branch that leads to it, `none` at a root
  std::size_t depth = 0;           ///< how many branches lead to it
  std::size_t order = 0;           ///< the Strahler number
  std::size_t first = 0, last = 0; ///< the ends of the arc
  double length = 0;
  double tortuosity =
    std::numeric_limits<double>::quiet_NaN(); ///< the length over the distance of the ends, if these differ
  double radius = 0;                          ///< the mean by length
  double least_radius = 0, greatest_radius = 0;
  double inscribed_radius = 0;                            ///< the mean by length
  double volume = 0;                                      ///< that of the cones between circles of these radii
  double area = std::numeric_limits<double>::quiet_NaN(); ///< that of faces, for the user to set
};

/// @}

namespace internal::skeleton {

// Of each branch of the trees: the component, parent, depth, and Strahler number.
inline void place_branches(const std::vector<Skeleton_record>& records, std::vector<Skeleton_branch>& branches)
{
  constexpr std::size_t none = Skeleton_branch::none;
  std::vector<bool> is_placed(branches.size(), false);
  std::size_t number_of_components = 0;
  for(const Skeleton_record& record : records)
  {
    number_of_components += record.parent == none ? 1 : 0;
    if(record.arc == none || is_placed[record.arc])
      continue;
    is_placed[record.arc] = true;
    Skeleton_branch& branch = branches[record.arc];
    branch.component = number_of_components - 1;
    branch.parent = records[record.parent].arc;
    branch.depth = branch.parent == none ? 0 : branches[branch.parent].depth + 1;
  }
  const std::vector<std::size_t> orders = strahler_orders(records);
  for(std::size_t i = 0; i != records.size(); ++i)
    if(records[i].arc != none)
      branches[records[i].arc].order = (std::max)(branches[records[i].arc].order, orders[i]);
}

} // namespace internal::skeleton

/// \ingroup PkgReebGraphSkeleton
///
/// \brief measures each arc of a curve skeleton, as a branch of the trees that `skeleton_trees()` makes. It takes linear
/// time.
///
/// \param skeleton a curve skeleton, as it has been extracted
/// \param trees its trees
template <class CurveSkeleton>
std::vector<Skeleton_branch> measure_branches(const CurveSkeleton& skeleton, const std::vector<Skeleton_record>& trees)
{
  std::vector<Skeleton_branch> branches;
  for(const auto& arc : skeleton_arcs(skeleton))
  {
    Skeleton_branch branch;
    branch.first = arc.front();
    branch.last = arc.back();
    branch.least_radius = branch.greatest_radius = skeleton[arc.front()].radius;
    for(std::size_t i = 1; i != arc.size(); ++i)
    {
      const auto &a = skeleton[arc[i - 1]], &b = skeleton[arc[i]];
      const double length = internal::distance_between(a.point, b.point);
      branch.length += length;
      branch.radius += length * (a.radius + b.radius) / 2;
      branch.inscribed_radius += length * (a.inscribed_radius + b.inscribed_radius) / 2;
      branch.least_radius = (std::min)(branch.least_radius, b.radius);
      branch.greatest_radius = (std::max)(branch.greatest_radius, b.radius);
      branch.volume += length * std::acos(-1.) / 3 * (a.radius * a.radius + a.radius * b.radius + b.radius * b.radius);
    }
    if(branch.length > 0)
    {
      branch.radius /= branch.length;
      branch.inscribed_radius /= branch.length;
    }
    const double distance = internal::distance_between(skeleton[arc.front()].point, skeleton[arc.back()].point);
    if(distance > 0)
      branch.tortuosity = branch.length / distance;
    branches.push_back(branch);
  }
  internal::skeleton::place_branches(trees, branches);
  return branches;
}

} // namespace CGAL::Reeb_graph

#endif // CGAL_REEB_GRAPH_SKELETON_MEASURE_BRANCHES_H
